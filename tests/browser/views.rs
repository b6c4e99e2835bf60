//! What may be seen on the body in place of its cells: each pixel shows what the model says of the
//! place that the ray through it meets.

use crate::engines::{Engine, Graphics};
use crate::page::{Page, Picture};
use crate::rays::Rays;
use clonal_mosaic::plants;
use clonal_mosaic::play::link;
use clonal_mosaic::surface::Place;
use clonal_mosaic::tissue::CellType;
use glam::Vec2;

const LINK: &str = "philodendron?v=1&s=1&d=1";

const AROUND: [Vec2; 4] = [Vec2::X, Vec2::Y, Vec2::NEG_X, Vec2::NEG_Y];

#[test]
fn webgpu_draws_what_leads_the_cells() {
    views_agree(Graphics::WebGpu);
}

#[test]
fn webgl2_draws_what_leads_the_cells() {
    views_agree(Graphics::WebGl2);
}

pub fn views_agree(engine: impl Into<Engine>) {
    let engine = engine.into();
    let Some(page) = Page::open(engine, &format!("#{LINK}")) else { return };
    let state = page.ready();
    let cells = page.picture();
    let scene = link::read(LINK, plants::all()).scene;
    let rays = Rays::of(&scene, &cells);
    let field = scene.plant.field(&rays.body.surface).unwrap().expect("a plant with a field");
    let controls = scene.plant.controls(scene.individual);
    let samples = samples(&rays, &cells);
    assert!(samples.len() > 300, "{} pixels lie on the leaves", samples.len());

    let picture = show(&page, "field-x", &cells);
    let differences = samples.iter().map(|&(x, y, place)| {
        let [along, across] = rays.body.surface.axes(place.triangle);
        let flat = field.at(place.triangle);
        let angle_deg = (along * flat.x + across * flat.y).x.acos().to_degrees();
        (hue_deg(picture.rgb[y * picture.width + x]) - angle_deg).abs()
    });
    assert_mostly("the hue is that of the angle", differences.map(|degrees| degrees < 12.0));

    let picture = show(&page, "controls", &picture);
    let first_type = |place| {
        let types = controls.iter();
        types.fold(CellType::Foreground, |kind, c| c.first_type(&rays.body.surface, place, kind))
    };
    let agree = samples.iter().filter_map(|&(x, y, place)| {
        let kind = first_type(place);
        // The grain of the image is about as fine as the pixels: here all around is of one type.
        let around = AROUND.into_iter().chain(AROUND.map(|v| 0.4 * (v + v.perp())));
        let whole = around.into_iter().all(|v| {
            let at = Vec2::new(x as f32 + 0.5, y as f32 + 0.5) + 2.0 * v;
            rays.surface_at(at).is_some_and(|place| first_type(place) == kind)
        });
        let white = picture.rgb[y * picture.width + x][1] > 100;
        whole.then_some(white == (kind == CellType::Foreground))
    });
    assert_mostly("white is where first cells may be F", agree);

    let picture = show(&page, "field-arrows", &picture);
    let dark = samples.iter().filter(|&&(x, y, _)| picture.rgb[y * picture.width + x][1] < 90);
    let share = dark.count() as f64 / samples.len() as f64;
    assert!((0.03..0.4).contains(&share), "{share} of the leaves is ink");

    // In words, and back.
    assert!(page.link().ends_with("&show=field-arrows"), "{}", page.link());
    assert!(
        page.text("live").ends_with("Seen now: Direction field: arrows."),
        "{}",
        page.text("live")
    );
    page.click("undo");
    page.click("undo");
    page.click("undo");
    page.wait_for("the cells", "return !location.hash.includes('show')");
    let again = shown_after(&page, &picture);
    // WebKit does not tell that it draws in software: there a picture gets smoother while it rests.
    let most = if engine == Engine::WebKit { 1.0 } else { 0.1 };
    assert!(again.difference(&cells) < most, "{}", again.difference(&cells));
    assert_eq!(page.ready(), state, "nothing grew");
    assert_eq!(page.complaints(), [""; 0]);
    page.choose("cactus");
    let offered = "return [...document.getElementById('show').options].map(o => o.value).join()";
    page.wait_for("nothing that leads", &format!("{offered} === 'cells,clans'"));
}

/// Chooses something to be shown, as a visitor does; the picture of it.
fn show(page: &Page, key: &str, before: &Picture) -> Picture {
    page.run(&format!(
        "const e = document.getElementById('show'); e.value = '{key}';
         e.dispatchEvent(new Event('change', {{bubbles: true}}))"
    ));
    page.wait_for("the link", &format!("return location.hash.includes('show={key}')"));
    shown_after(page, before)
}

/// The picture that follows on another one, once it stands: its first frames may have fewer pixels, and a
/// browser may show one of them for a while after the page has drawn the next.
fn shown_after(page: &Page, before: &Picture) -> Picture {
    let mut last = page.picture();
    for _ in 0..100 {
        std::thread::sleep(std::time::Duration::from_millis(50));
        let picture = page.picture();
        if picture.difference(before) > 1.0 && picture.difference(&last) < 0.02 {
            return picture;
        }
        last = picture;
    }
    panic!("the picture stays as it was, or never stands");
}

/// Pixels that lie on leaves, with all around them, and the places that are seen there.
fn samples(rays: &Rays, picture: &Picture) -> Vec<(usize, usize, Place)> {
    const STEP_PX: usize = 9;
    const MARGIN_PX: f32 = 3.0;
    let mut samples = Vec::new();
    for y in (picture.height / 5..picture.height).step_by(STEP_PX) {
        for x in (0..4 * picture.width / 5).step_by(STEP_PX) {
            let at = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
            let inside = || AROUND.iter().all(|&v| rays.surface_at(at + v * MARGIN_PX).is_some());
            samples.extend(rays.surface_at(at).filter(|_| inside()).map(|place| (x, y, place)));
        }
    }
    samples
}

/// Hue in HSV, in degrees.
fn hue_deg([red, green, blue]: [u8; 3]) -> f32 {
    let [r, g, b] = [red, green, blue].map(f32::from);
    let (most, least) = (r.max(g).max(b), r.min(g).min(b));
    let sixth = match most {
        m if m == r => (g - b) / (m - least),
        m if m == g => 2.0 + (b - r) / (m - least),
        m => 4.0 + (r - g) / (m - least),
    };
    60.0 * sixth
}

fn assert_mostly(what: &str, agree: impl Iterator<Item = bool>) {
    let agree: Vec<bool> = agree.collect();
    let count = agree.iter().filter(|&&is| is).count();
    assert!(agree.len() > 100, "{what}: {} samples", agree.len());
    assert!(count * 100 > agree.len() * 95, "{what}: {count} of {}", agree.len());
}
