//! A plant is painted on: strokes by mouse and keyboard, what grows under them against native fingerprints, and links
//! that open again.

use crate::engines::Graphics;
use crate::page::{Page, State, keys};
use clonal_mosaic::import::painted_of_link;
use clonal_mosaic::plants;
use clonal_mosaic::play::link;
use clonal_mosaic::tissue::Progress;
use std::sync::Arc;

/// The fingerprint of the cells that a link of a painted plant has natively.
fn natively(address: &str) -> String {
    let painted = painted_of_link(address).expect("strokes").expect("sound ones");
    let own = painted.make(painted.base.body.mesh.text).expect("a plant");
    let plant = plants::bring(&own.text).expect("words of ours");
    let opened = link::read(address, plants::all());
    assert_eq!((opened.scene.plant.key, opened.left_out), (plant.key, vec![]));
    let mut scene = opened.scene;
    scene.recipe.days = scene.day;
    let (mut growth, _) = scene.sow(Arc::new(plant.embedded_body().surface)).unwrap();
    while !matches!(growth.step(), Progress::Done | Progress::Full) {}
    growth.diary.fingerprint(scene.day as usize)
}

/// Draws across the middle of the stage, up to so many pixels to each side, from where the plant begins; whether it is
/// seen before the hand is lifted.
fn draw(page: &Page, half_px: i32) -> bool {
    let seen = page.run(&format!(
        "const sheet = document.querySelector('.painting'), box = sheet.getBoundingClientRect();
         const send = (kind, x) => sheet.dispatchEvent(new PointerEvent(kind, {{
             clientX: box.left + box.width / 2 + x, clientY: box.top + box.height / 2,
             button: 0, isPrimary: true, pointerId: 1, bubbles: true, cancelable: true}}));
         let x = -{half_px};
         for (; x <= {half_px}; x += 8) {{
             send('pointerdown', x);
             if (sheet.querySelector('polyline')) break;
             send('pointercancel', x);
         }}
         for (; x <= {half_px}; x += 8) send('pointermove', x);
         const seen = sheet.querySelectorAll('polyline').length > 0;
         send('pointerup', {half_px});
         return seen"
    ));
    seen == true
}

fn choose(page: &Page, class: &str, value: &str) {
    page.run(&format!(
        "const e = document.querySelector('#paint-card .{class}');
         e.value = '{value}';
         e.dispatchEvent(new Event('input', {{bubbles: true}}))"
    ));
}

fn own(page: &Page, before: &str) -> State {
    page.wait("a painted plant", |s| {
        s.plant.starts_with("own-") && s.plant != before && s.state == "ready"
    })
}

#[test]
fn strokes_are_seen_grown_undone_and_travel_in_the_link() {
    let Some(page) = Page::open(Graphics::WebGpu, "#watermelon?v=2&s=1&d=1&n=3000") else { return };
    for base in ["watermelon?v=2&s=1&d=1&n=3000", "croton?v=2&s=1&d=1&n=3000"] {
        page.visit(&format!("#{base}"));
        let unpainted = page.on_day(1).fingerprint;
        page.click("paint");
        let is_there = "return document.querySelectorAll('#paint-card .brush option').length > 5";
        page.wait_for("the brushes", is_there);

        choose(&page, "brush", "f");
        assert!(draw(&page, 60), "{base}: a stroke is seen while it is drawn");
        let first = own(&page, "");
        let address = page.link();
        assert!(address.contains("~painted/") && address.contains("&n=3000"), "{address}");
        assert_eq!(first.fingerprint, natively(&address), "{address}");
        assert_ne!(first.fingerprint, unpainted);

        // By the keyboard, on a number of the recipe.
        choose(&page, "brush", "r");
        page.run("document.getElementById('stage').focus()");
        page.press(&[keys::ENTER]);
        let second = own(&page, &first.plant);
        assert_eq!(second.fingerprint, natively(&page.link()), "{}", page.link());

        // What leads the cells is shown.
        choose(&page, "brush", "l");
        draw(&page, 60);
        let third = own(&page, &second.plant);
        assert!(page.link().contains("show=field-arrows"), "{}", page.link());

        let undo = "document.querySelector('#paint-card .undo').click()";
        page.run(undo);
        assert_eq!(own(&page, &third.plant).plant, second.plant);
        page.run(undo);
        let again = own(&page, &second.plant);
        assert_eq!(
            (again.plant, again.fingerprint),
            (first.plant.clone(), first.fingerprint.clone())
        );
        assert_eq!(page.link(), address);
        page.run(undo);
        page.wait("the plant as it was", |s| s.state == "ready" && base.starts_with(&s.plant));
        assert_eq!(page.link(), base);

        // As on a machine that has never seen it.
        page.visit(&format!("#{address}"));
        let opened = own(&page, "");
        assert_eq!((opened.plant, opened.fingerprint), (first.plant, first.fingerprint));
        assert_eq!(page.link(), address);
        assert_eq!(page.complaints(), [""; 0]);
    }
}
