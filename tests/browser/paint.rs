//! A plant is painted on: strokes by mouse and keyboard, what grows under them against native fingerprints, and links
//! that open again.

use crate::class::read_code;
use crate::engines::Graphics;
use crate::page::{Page, State, keys};
use crate::studio::{downloads, take};
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

/// Sends the brush a pointer in the middle of the stage, so many pixels to the right.
fn send(page: &Page, kind: &str, x: i32) {
    page.run(&format!(
        "const sheet = document.querySelector('.painting'), box = sheet.getBoundingClientRect();
         const event = new PointerEvent('{kind}', {{
             clientX: box.left + box.width / 2 + {x}, clientY: box.top + box.height / 2,
             button: 0, isPrimary: true, pointerId: 1, bubbles: true, cancelable: true}});
         // After what waits already: a hand that is given back to the page.
         return new Promise(done => setTimeout(() => done(sheet.dispatchEvent(event))))"
    ));
}

/// Waits until all is known of what was drawn; whether a stroke is seen.
fn is_seen(page: &Page) -> bool {
    let sheet = "const sheet = document.querySelector('.painting')";
    page.wait_for("the workshop", &format!("{sheet}; return !sheet.hasAttribute('data-busy')"));
    page.run(&format!("{sheet}; return sheet.querySelectorAll('polyline').length > 0")) == true
}

/// Draws across the middle of the stage, up to so many pixels to each side, from where the plant begins; whether it is
/// seen before the hand is lifted.
fn draw(page: &Page, half_px: i32) -> bool {
    let turned = page.link();
    let begins = (-half_px..=half_px).step_by(8).find(|&x| {
        send(page, "pointerdown", x);
        is_seen(page) || {
            // There it has turned the plant, had it moved.
            send(page, "pointercancel", x);
            false
        }
    });
    let begins = begins.expect("a plant in the middle");
    assert_eq!(page.link(), turned);
    (begins..=half_px).step_by(8).for_each(|x| send(page, "pointermove", x));
    let seen = is_seen(page);
    send(page, "pointerup", half_px);
    seen
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

#[test]
fn a_hand_beside_the_plant_turns_it() {
    let Some(page) = Page::open(Graphics::WebGpu, "#watermelon?v=2&s=1&d=1&n=3000") else { return };
    let before = page.on_day(1).plant;
    page.click("paint");
    page.wait_for(
        "the brushes",
        "return document.querySelectorAll('#paint-card .brush option').length > 5",
    );
    let link = page.link();
    let half = page.run("return document.querySelector('.painting').clientWidth / 2").as_f64();
    let rim = half.unwrap() as i32 - 4;
    send(&page, "pointerdown", rim);
    assert!(!is_seen(&page));
    [rim - 20, rim - 60, rim - 90].into_iter().for_each(|x| send(&page, "pointermove", x));
    send(&page, "pointerup", rim - 90);
    page.wait_for("another side", &format!("return location.hash !== '#{link}'"));
    assert!(!page.link().contains('~'), "{}", page.link());
    assert_eq!(page.state().plant, before);
}

#[test]
fn what_is_taken_away_of_a_painted_plant_opens_anywhere() {
    let base = "croton?v=2&s=1&d=1&n=3000";
    let Some(page) = Page::open(Graphics::WebGpu, &format!("#{base}")) else { return };
    page.on_day(1);
    let folder = downloads(&page, "painted");
    page.click("paint");
    page.wait_for(
        "the brushes",
        "return document.querySelectorAll('#paint-card .brush option').length > 5",
    );
    choose(&page, "brush", "f");
    draw(&page, 60);
    let painted = own(&page, "");
    page.run("document.querySelector('#paint-card .done').click()");
    let address = page.link();
    page.click("take-away");
    let link = "return document.querySelector('#take-away-dialog .link').value";
    page.wait_for("the dialog", "return !!document.querySelector('#take-away-dialog[open]')");
    let said = page.run(link);
    assert!(said.as_str().unwrap().ends_with(&format!("#{address}")), "{said} of {address}");
    // As large as a phone sees it that is held before the screen.
    page.run(
        "document.querySelector('#take-away-dialog .qr').style =
             'position: fixed; inset: 0; z-index: 9; width: 600px; height: 600px; max-width: none'",
    );
    assert!(read_code(&page, "#take-away-dialog .qr").ends_with(&format!("#{address}")));
    page.run("document.querySelector('#take-away-dialog .qr').style = ''");
    let file = take(&page, "ply", &folder.join(format!("{}-1-day-1.ply", painted.plant)));
    let has = |text: &str| file.windows(text.len()).any(|window| window == text.as_bytes());
    let strokes = address.split_once('~').unwrap().1;
    assert!(has(strokes), "{strokes}");

    // The presenter's code says so, too.
    page.run("document.getElementById('take-away-dialog').close()");
    page.run(&format!("location.hash = '#{address}~present'"));
    page.wait_for("the presenter", "return document.documentElement.dataset.view === 'presenter'");
    assert!(read_code(&page, ".presenter .qr").ends_with(&format!("#{address}")));
    page.press(&[keys::ESCAPE]);
    page.wait_for("its link", &format!("return location.hash === '#{address}'"));

    // The file opens where nobody has seen the plant.
    page.visit("#watermelon?v=2&s=2&d=0");
    page.on_day(0);
    page.drop("a.ply", "application/octet-stream", &file);
    let opened = own(&page, "");
    assert_eq!((opened.plant, opened.fingerprint), (painted.plant, painted.fingerprint));
    assert_eq!(page.link(), address);
    assert_eq!(page.complaints(), [""; 0]);

    // With very many strokes there is no code, and it is said why.
    let many = vec![strokes.rsplit('/').next().unwrap(); 120].join("-");
    let key = {
        let link = format!("own-a?v=2~painted/croton/2/{many}");
        let painted = painted_of_link(&link).unwrap().unwrap();
        painted.make(painted.base.body.mesh.text).unwrap().key
    };
    page.visit(&format!("#{key}?v=2&s=1&d=0&n=3000~painted/croton/2/{many}"));
    page.wait("many strokes", |s| s.plant == key && s.state == "ready");
    page.click("take-away");
    let why = "return document.querySelector('#take-away-dialog .no-code')?.textContent";
    page.wait_for(
        "why there is no code",
        &format!("{why} === 'The link is too long for a QR code.'"),
    );
    assert!(
        page.run("return document.querySelector('#take-away-dialog .qr').hasAttribute('hidden')")
            == true
    );
}
