//! The light of the pictures: leaves pass it, colours keep what they are, and what rests gets better.

use crate::engines::Graphics;
use crate::page::{Page, Picture, keys};
use crate::rays::Rays;
use clonal_mosaic::plants;
use clonal_mosaic::play::link;
use glam::{Vec2, Vec3};
use serde_json::json;

/// Towards the key light, as `draw/scene.rs` has it.
const KEY: Vec3 = Vec3::new(-0.50, 0.78, 0.46);

#[test]
fn leaves_are_seen_against_the_light() {
    let Some(page) = Page::start(Graphics::WebGpu) else { return };
    for (plant, day, elevation) in [("croton", 8, 24), ("philodendron", 20, 12)] {
        let [front, behind] = [0, 180].map(|azimuth| {
            let link = format!("{plant}?v=1&s=1&d={day}&view={azimuth},{elevation},1");
            let mut blades = blades(&page, &link);
            blades.sort_by(|a, b| luminance(*a).total_cmp(&luminance(*b)));
            blades
        });
        let quarter = |blades: &[Vec3]| luminance(blades[blades.len() / 4]);
        let share = quarter(&behind) / quarter(&front);
        assert!(share >= 0.65, "{plant}: {share} of the light that comes from the front");
        let around = &behind[behind.len() / 5..behind.len() * 3 / 10];
        let [red, green, blue] = (around.iter().sum::<Vec3>() / around.len() as f32).to_array();
        // Pure yellow has as much red as green, pure green none; leaves without light are grey.
        assert!((0.2..0.9).contains(&(red / green)), "{plant}: red {red}, green {green}");
        assert!(blue < 0.25 * green, "{plant}: blue {blue}, green {green}");
    }
}

#[test]
fn a_matt_cell_in_full_light_has_its_colour() {
    let Some(page) = Page::start(Graphics::WebGpu) else { return };
    // Takes gloss, wax and unevenness from the numbers of each frame.
    page.before_pages(
        "const write = GPUQueue.prototype.writeBuffer;
         GPUQueue.prototype.writeBuffer = function (buffer, at, data, from = 0, size) {
             const frame = new Float32Array(data.slice(from, from + (size ?? data.length)).buffer);
             if (frame.length !== 184) return write.call(this, buffer, at, data, from, size);
             for (const place of [66, 84, 85]) frame[place] = 0;
             window.matt = true;
             write.call(this, buffer, at, frame)
         }",
    );
    let link = "watermelon?v=1&s=1&d=10&va=0&bo=0";
    page.visit(&format!("#{link}"));
    page.ready();
    let picture = page.picture();
    assert_eq!(page.run("return window.matt"), true, "the numbers of a frame were found");
    let scene = link::read(link, plants::all()).scene;
    let rays = Rays::of(&scene, &picture);
    let mut agree = [0; 2];
    let mut others = Vec::new();
    for (x, y) in grid(&picture, 2) {
        let Some(place) = rays.surface_at(Vec2::new(x as f32 + 0.5, y as f32 + 0.5)) else {
            continue;
        };
        let mesh = &rays.body.surface;
        let [a, b, c] = mesh.triangles[place.triangle as usize].map(|v| mesh.normals[v as usize]);
        let normal = a + (b - a) * place.b1 + (c - a) * place.b2;
        if normal.normalize().dot(KEY.normalize()) < 0.99 {
            continue;
        }
        let rgb = picture.rgb[y * picture.width + x];
        let is = |colour: [f32; 3]| {
            rgb.iter().zip(colour).all(|(&p, c)| (f32::from(p) - 255.0 * c).abs() <= 3.0)
        };
        match [0, 1].into_iter().find(|&kind| is(scene.look.cells[kind])) {
            Some(kind) => agree[kind] += 1,
            None => others.push(rgb),
        }
    }
    let [dark, light] = agree;
    assert!(
        dark > 30 && light > 30,
        "{agree:?} of both, others {:?}",
        &others[..others.len().min(40)]
    );
    // Where the two meet they are mixed.
    assert!(others.len() < dark + light, "{agree:?} and {} others", others.len());
}

#[test]
fn webgpu_mixes_what_rests_and_then_draws_nothing() {
    pictures_at_rest(Graphics::WebGpu);
}

#[test]
fn webgl2_mixes_what_rests_and_then_draws_nothing() {
    pictures_at_rest(Graphics::WebGl2);
}

fn pictures_at_rest(graphics: Graphics) {
    const LINK: &str = "#sansevieria?v=1&s=1&d=3";
    let Some(page) = Page::start(graphics) else { return };
    page.count_frames();
    page.visit(LINK);
    page.ready();
    page.rest();
    let plain = page.picture();
    page.pretend_card();
    page.visit(LINK);
    page.ready();
    let frames = page.rest();
    let mixed = page.picture();
    assert!(frames > 16, "{frames} frames");
    let difference = mixed.difference(&plain);
    assert!((0.02..1.5).contains(&difference), "smoother and else the same: {difference}");

    page.press(&[keys::TAB]);
    page.run("document.getElementById('stage').focus()");
    page.press(&[keys::LEFT]);
    let turned = page.rest() - frames;
    assert!(turned >= 16, "what was turned is mixed anew: {turned} frames");
    page.devtools(
        "Emulation.setEmulatedMedia",
        json!({ "features": [{ "name": "prefers-reduced-motion", "value": "reduce" }] }),
    );
    let before = page.rest();
    page.press(&[keys::LEFT]);
    let calm = page.rest() - before;
    assert!((1..16).contains(&calm), "nothing is mixed where less motion is asked for: {calm}");
}

#[test]
fn nothing_floats() {
    let Some(page) = Page::start(Graphics::WebGpu) else { return };
    for elevation in [-8, 0, 4, 30] {
        let link = format!("long-watermelon?v=1&s=1&d=2&view=0,{elevation},0.8");
        page.visit(&format!("#{link}"));
        page.ready();
        let picture = page.picture();
        let rays = Rays::of(&link::read(&link, plants::all()).scene, &picture);
        let hits = grid(&picture, 4)
            .filter(|&(x, y)| rays.surface_at(Vec2::new(x as f32 + 0.5, y as f32 + 0.5)).is_some());
        let (x, foot) = hits.max_by_key(|&(_, y)| y).expect("the melon is seen");
        let row = |x: usize, y: usize| luminance(linear(picture.rgb[y * picture.width + x]));
        // Somewhere in the 5 % of the picture around its lowest place there is a shadow.
        let rows = foot - picture.height / 40..foot + picture.height / 20;
        let darkest = rows.map(|y| row(x, y) / row(8, y)).fold(1.0, f32::min);
        assert!(darkest < 0.75, "at {elevation} degrees: {darkest} of the light beside it");
    }
}

/// The linear light of the pixels that show the patterned surface of a link's plant.
fn blades(page: &Page, link: &str) -> Vec<Vec3> {
    page.visit(&format!("#{link}"));
    page.ready();
    let picture = page.picture();
    let rays = Rays::of(&link::read(link, plants::all()).scene, &picture);
    let shown = grid(&picture, 6)
        .filter(|&(x, y)| rays.surface_at(Vec2::new(x as f32 + 0.5, y as f32 + 0.5)).is_some());
    let light: Vec<Vec3> = shown.map(|(x, y)| linear(picture.rgb[y * picture.width + x])).collect();
    assert!(light.len() > 500, "{link}: {} pixels lie on the blades", light.len());
    light
}

/// Every so manieth pixel of the middle of a picture: buttons float over its corners.
fn grid(picture: &Picture, step: usize) -> impl Iterator<Item = (usize, usize)> + use<> {
    let (width, height) = (picture.width, picture.height);
    (height / 10..height * 19 / 20)
        .step_by(step)
        .flat_map(move |y| (width / 8..width * 7 / 8).step_by(step).map(move |x| (x, y)))
}

fn linear(rgb: [u8; 3]) -> Vec3 {
    Vec3::from(rgb.map(|byte| {
        let c = f32::from(byte) / 255.0;
        if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
    }))
}

fn luminance(light: Vec3) -> f32 {
    light.dot(Vec3::new(0.2126, 0.7152, 0.0722))
}
