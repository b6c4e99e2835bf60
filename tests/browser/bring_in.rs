//! What is brought in: the colours of a photograph, bodies and documents.

use crate::engines::Graphics;
use crate::page::Page;
use clonal_mosaic::plants;
use clonal_mosaic::play::{Scene, link};
use clonal_mosaic::surface::{Brought, PolygonMesh};
use clonal_mosaic::tissue::{Growth, Progress, Recipe};
use std::sync::Arc;

/// A photograph, drawn by hand: stripes of two colours on white, three of ten pixels of the first.
fn photograph([first, second]: [[u8; 3]; 2]) -> Vec<u8> {
    const SIDE: u32 = 200;
    let mut pixels = Vec::new();
    for k in 0..SIDE * SIDE {
        let [x, y] = [k % SIDE, k / SIDE];
        let is_leaf = (20..180).contains(&x) && (20..180).contains(&y);
        pixels.extend(match (is_leaf, (x - x.min(20)) % 40) {
            (false, _) => [252, 252, 250],
            (true, 0..12) => first,
            (true, _) => second,
        });
    }
    let mut png = Vec::new();
    let mut encoder = png::Encoder::new(&mut png, SIDE, SIDE);
    encoder.set_color(png::ColorType::Rgb);
    encoder.write_header().unwrap().write_image_data(&pixels).unwrap();
    png
}

fn open_dialog(page: &Page) {
    page.click("bring-in");
    let is_open = "const d = document.getElementById('bring-in-dialog'); return !!(d && d.open)";
    page.wait_for("the dialog", is_open);
}

#[test]
fn a_plant_takes_the_colours_of_a_photograph_and_gives_them_back() {
    let before = "croton?v=1&s=2&d=1";
    let Some(page) = Page::open(Graphics::WebGpu, &format!("#{before}")) else { return };
    page.on_day(1);
    open_dialog(&page);
    page.drop("leaf.png", "image/png", &photograph([[230, 120, 200], [30, 60, 120]]));
    let found = "return [...document.querySelectorAll('#bring-in-dialog .colours li')].length === 2
                     && !document.querySelector('#bring-in-dialog .found').hidden";
    page.wait_for("the colours of the photograph", found);
    let told = page.run("return document.querySelector('#bring-in-dialog .colours').innerText");
    assert!(told.as_str().unwrap().contains("70%") && told.as_str().unwrap().contains("30%"));
    let proposed =
        page.run("return document.querySelector('#bring-in-dialog .proposed').innerText");
    assert!(proposed.as_str().unwrap().starts_with("First cells: "), "{proposed}");

    // Only the colours, the other way around than they are proposed.
    page.run(
        "const dialog = document.getElementById('bring-in-dialog');
         dialog.querySelector('.with-numbers').click();
         const select = dialog.querySelector('.colours select');
         select.selectedIndex = 1 - select.selectedIndex;
         select.dispatchEvent(new Event('change', {bubbles: true}));
         dialog.querySelector('.give').click()",
    );
    page.wait_for("its colours", "return location.hash.includes('cf=')");
    let taken = link::read(&page.link(), plants::all());
    assert_eq!(taken.left_out, [""; 0]);
    let [f, b, _] = taken.scene.look.cells.map(|colour| colour.map(|c| (255.0 * c).round()));
    let near = |a: [f32; 3], b: [f32; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 4.0);
    assert!(near(f, [30.0, 60.0, 120.0]) && near(b, [230.0, 120.0, 200.0]), "{f:?} {b:?}");
    assert_eq!(taken.scene.recipe, taken.scene.plant.recipe);
    let shown = "return document.getElementById('parameter-cf').value";
    assert_eq!(page.run(shown), format!("#{:02x}{:02x}{:02x}", f[0] as u8, f[1] as u8, f[2] as u8));
    page.click("undo");
    page.wait_for("what was before", &format!("return location.hash === '#{before}'"));
    assert_eq!(page.complaints(), [""; 0]);
}

#[test]
fn a_colour_is_picked_in_the_panel() {
    let Some(page) = Page::open(Graphics::WebGpu, "#croton?v=1&s=2&d=1") else { return };
    let fingerprint = page.on_day(1).fingerprint;
    page.run(
        "document.querySelector('.recipe').open = true;
         const colour = document.getElementById('parameter-cb');
         colour.value = '#0000ff';
         colour.dispatchEvent(new Event('input', {bubbles: true}))",
    );
    page.wait_for("the link", "return location.hash === '#croton?v=1&s=2&d=1&cb=0000ff'");
    let state = page.on_day(1);
    assert_eq!(state.fingerprint, fingerprint, "the same cells in another colour");
    page.sharp();
    let picture = page.picture();
    let blue = picture.rgb.iter().filter(|[r, g, b]| *b > 100 && b / 2 > *r.max(g));
    assert!(blue.count() > 2000, "blue cells are seen");
}

/// The fingerprint of the last day.
fn fingerprint(mut growth: Growth) -> String {
    while !matches!(growth.step(), Progress::Done | Progress::Full) {}
    growth.diary.fingerprint(growth.diary.days.len() - 1)
}

#[test]
fn a_body_of_ones_own_grows_as_in_a_shell_and_is_kept() {
    let base = "croton-shrub?v=1&s=3&d=1&n=400&days=2";
    let Some(page) = Page::open(Graphics::WebGpu, &format!("#{base}")) else { return };
    page.on_day(1);
    open_dialog(&page);
    page.run("document.getElementById('keep-own').click()");
    let corner = "v 4 4 4\nv 4 -4 -4\nv -4 4 -4\nv -4 -4 4\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n";
    let ball = PolygonMesh::parse(corner).unwrap().refined(4).to_obj();
    page.drop("ball.obj", "", ball.as_bytes());
    let own =
        page.wait("a plant of one's own", |s| s.plant.starts_with("own-") && s.state == "ready");
    let (link, day): (String, u32) = (page.link(), own.day.parse().unwrap());
    let recipe = link::read(base, plants::all()).scene.recipe;
    let mesh = Arc::new(Brought::read(ball.as_bytes()).unwrap().body.surface);
    let triangles = mesh.triangles.len();
    let growth = Growth::new(mesh, Recipe { days: day, ..recipe }, &[], 1).unwrap();
    assert_eq!(own.fingerprint, fingerprint(growth));
    let told = format!("ball.obj: {triangles} triangles");
    assert!(page.messages().contains(&told), "{}", page.messages());
    assert_eq!(page.text("name"), "ball");

    // It opens again by its link, as it was to be kept.
    page.run("location.reload()");
    let again = page.wait("the kept plant", |s| s.plant == own.plant && s.state == "ready");
    assert_eq!((again.fingerprint, page.link()), (own.fingerprint, link));
    assert_eq!(page.complaints(), [""; 0]);
}

/// A file of a small body.
fn seed(name: &str) -> Vec<u8> {
    let seeds = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/seeds/body");
    std::fs::read(seeds.join(name)).unwrap()
}

#[test]
fn what_is_dropped_before_the_studio_is_there_waits_for_it_and_bytes_are_kept_too() {
    let base = "croton-shrub?v=1&s=3&d=1&n=400&days=2";
    let Some(page) = Page::open(Graphics::WebGpu, &format!("#{base}")) else { return };
    page.on_day(1);
    let recipe = link::read(base, plants::all()).scene.recipe;
    let natively = |file: &[u8], day: u32| {
        let mesh = Arc::new(Brought::read(file).unwrap().body.surface);
        fingerprint(Growth::new(mesh, Recipe { days: day, ..recipe.clone() }, &[], 1).unwrap())
    };
    let own = |before: &str| {
        page.wait("a plant of one's own", |s| {
            s.plant.starts_with("own-") && s.plant != before && s.state == "ready"
        })
    };
    assert_eq!(page.run("return document.documentElement.hasAttribute('data-studio')"), false);
    let glb = seed("tetrahedron.glb");
    page.drop("corner.glb", "model/gltf-binary", &glb);
    let state = own("");
    assert_eq!(state.fingerprint, natively(&glb, state.day.parse().unwrap()));
    let told = "corner.glb: 4 triangles; in metres, as GLB files are";
    assert!(page.messages().contains(told), "{}", page.messages());

    // Bytes that are no text are kept, too.
    page.run(&format!("location.hash = '#{base}'"));
    page.on_day(1);
    open_dialog(&page);
    page.run("document.getElementById('keep-own').click()");
    let ply = seed("binary_big_endian.ply");
    page.drop("other.ply", "", &ply);
    let kept = own(&state.plant);
    assert_eq!(kept.fingerprint, natively(&ply, kept.day.parse().unwrap()));
    page.run("location.reload()");
    let again = page.wait("the kept plant", |s| s.plant == kept.plant && s.state == "ready");
    assert_eq!(again.fingerprint, kept.fingerprint);
    assert_eq!(page.complaints(), [""; 0]);
}

#[test]
fn a_document_of_ones_own_grows_and_what_cannot_is_told() {
    let Some(page) = Page::open(Graphics::WebGpu, "#croton?v=1&s=1&d=1") else { return };
    page.on_day(1);
    open_dialog(&page);
    let leaf = plants::find("begonia").unwrap();
    let document = leaf.to_json().replace("\"name\": \"", "\"name\": \"My ");
    page.drop("mine.mosaic.json", "application/json", document.as_bytes());
    let own =
        page.wait("a plant of one's own", |s| s.plant.starts_with("own-") && s.state == "ready");
    let day = own.day.parse().unwrap();
    let preset = Scene::preset(leaf, 1);
    let surface = Arc::new(leaf.embedded_body().surface);
    let growth = leaf.sow(surface, Recipe { days: day, ..preset.recipe.clone() }, 1).unwrap();
    assert_eq!((own.fingerprint, preset.day), (fingerprint(growth), day));

    for (name, content, why) in [
        ("a.glb", &b"glTF\x02\0\0\0"[..], "the GLB file: it ends before"),
        ("b.json", b"{\"mosaic_plant\": 1}", "missing field"),
        ("c.obj", b"v 0 0 0\n", "the OBJ file has no faces"),
    ] {
        page.drop(name, "", content);
        let told =
            format!("return document.getElementById('messages').innerText.includes('{name}: ')");
        page.wait_for(name, &told);
        assert!(page.messages().contains(why), "{}", page.messages());
    }
    assert_eq!(page.state().plant, own.plant);
    assert_eq!(page.complaints(), [""; 0]);
}
