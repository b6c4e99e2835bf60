//! `./playground posters`: the stills of all plants and figures, or of those that are named, drawn by the page itself. They are
//! left as PNG files in `target/posters`; the script makes AVIF of them.

use crate::base64;
use crate::engines::Graphics;
use crate::page::Page;
use crate::start::preset_link;
use clonal_mosaic::plants;
use clonal_mosaic::play::figures;
use serde_json::json;
use std::collections::BTreeSet;
use std::path::Path;
use std::time::Duration;

/// Widths and heights of the stills on the stage and in the chooser: that of the stage is as large as it is
/// shown in a window of 1280 by 800, as more pixels in as many bytes are no sharper. Those of the figures are
/// as large as the live pictures there.
const STAGE_PX: usize = 576;
const CHOOSER_PX: usize = 144;

/// How far the shadows fade out at the rim of a still on the stage, where the live picture's go on; a
/// share of its width.
const FADE: f32 = 0.15;

#[test]
#[ignore = "draws the posters, which takes minutes: ./playground posters"]
fn posters() {
    let Some(page) = Page::start(Graphics::WebGpu) else { return };
    page.pretend_card();
    page.count_frames();
    // The plant is put into a square by a style of our own.
    page.devtools("Page.setBypassCSP", json!({ "enabled": true }));
    let clear = json!({ "color": { "r": 0, "g": 0, "b": 0, "a": 0 } });
    page.devtools("Emulation.setDefaultBackgroundColorOverride", clear);
    let large = json!({ "width": 1280, "height": 800, "deviceScaleFactor": 1, "mobile": false });
    page.devtools("Emulation.setDeviceMetricsOverride", large);
    let only = std::env::var("POSTERS").unwrap_or_default();
    let is_wanted = |name: &str| only.is_empty() || only.split_whitespace().any(|one| one == name);
    for plant in plants::all().iter().filter(|plant| is_wanted(plant.key)) {
        page.visit(&preset_link(plant));
        page.run(&format!(
            "const style = document.createElement('style');
             style.textContent = `:root, body, .stage {{ background: none !important }}
                 body > :not(main), main > :not(.plate), .plate > :not(.stage), .poster {{
                     display: none !important }}
                 .stage {{ position: fixed !important; inset: 0 auto auto 0; width: {STAGE_PX}px;
                     height: {STAGE_PX}px }}`;
             document.head.append(style)"
        ));
        page.ready();
        page.wait_for(
            "the plant alone in a square",
            &format!("return document.getElementById('canvas').width === {STAGE_PX}"),
        );
        // The picture fades in.
        std::thread::sleep(Duration::from_secs(1));
        page.rest();
        let still = Still::decode(&page.png("#stage"));
        still.with_shadows(fade_at_the_rim).save(plant.key);
        let small = still.with_shadows(|_, _| 0.0).smaller(STAGE_PX / CHOOSER_PX);
        small.save(&format!("{}-small", plant.key));
    }
    for figure in figures::all().iter().filter(|figure| is_wanted(figure.number)) {
        page.visit(&format!("#figures/{}", figure.number));
        page.ready();
        for k in 0..figure.pictures.len() {
            let data = page.run(&format!(
                "const row = document.getElementById('figure-{}');
                 return row.querySelectorAll('canvas')[{k}].toDataURL().split(',')[1]",
                figure.number
            ));
            Still::decode(&base64::read(data.as_str().expect("a picture"))).save(&figure.poster(k));
        }
    }
}

#[test]
fn every_plant_and_picture_has_its_stills_and_there_are_no_others() {
    let of_plants =
        plants::all().iter().flat_map(|p| [p.key.to_string(), format!("{}-small", p.key)]);
    let of_figures = figures::all().iter().flat_map(|f| (0..f.pictures.len()).map(|k| f.poster(k)));
    let expected: BTreeSet<String> =
        of_plants.chain(of_figures).map(|name| format!("{name}.avif")).collect();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("www/posters");
    let there = std::fs::read_dir(folder).expect("a folder of posters");
    let name = |file: std::fs::DirEntry| file.file_name().to_string_lossy().into_owned();
    assert_eq!(there.map(|file| name(file.expect("a file"))).collect::<BTreeSet<_>>(), expected);
}

/// How much is left of a shadow at this place, 0 to 1 from left and top.
fn fade_at_the_rim(x: f32, y: f32) -> f32 {
    // A product has no creases in the corners.
    let left = |from_rim: f32| {
        let share = (from_rim / FADE).clamp(0.0, 1.0);
        share * share * (3.0 - 2.0 * share)
    };
    left(x) * left(1.0 - x) * left(y) * left(1.0 - y)
}

/// A square picture: rows of red, green, blue and alpha from the top.
#[derive(Clone)]
struct Still {
    width: usize,
    rgba: Vec<[u8; 4]>,
}

impl Still {
    fn decode(bytes: &[u8]) -> Still {
        let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().expect("a PNG");
        let mut data = vec![0; reader.output_buffer_size().expect("a small picture")];
        let info = reader.next_frame(&mut data).expect("a whole PNG");
        assert_eq!(info.width, info.height, "a square");
        assert_eq!(info.color_type, png::ColorType::Rgba, "a picture on nothing");
        let rgba = data[..info.buffer_size()].as_chunks().0.to_vec();
        Still { width: info.width as usize, rgba }
    }

    /// With so much of the shadows, which are a dark brown and not opaque.
    fn with_shadows(&self, left: impl Fn(f32, f32) -> f32) -> Still {
        let mut still = self.clone();
        for (k, [r, g, b, a]) in still.rgba.iter_mut().enumerate() {
            // Where little is left of them, their colour is rounded.
            let (brightest, opacity) = (u32::from(*r.max(g).max(b)), u32::from(*a));
            if brightest * opacity < 44 * opacity + 510 && opacity < 255 {
                let at = |k: usize| (k as f32 + 0.5) / self.width as f32;
                *a = (f32::from(*a) * left(at(k % self.width), at(k / self.width))).round() as u8;
            }
        }
        still
    }

    /// The means of squares of `side` pixels.
    fn smaller(&self, side: usize) -> Still {
        let width = self.width / side;
        let mean = |k: usize| {
            let (x, y) = (k % width * side, k / width * side);
            let mut sums = [0; 4];
            for at in (0..side * side).map(|s| (y + s / side) * self.width + x + s % side) {
                let [r, g, b, a] = self.rgba[at].map(u32::from);
                for (sum, part) in sums.iter_mut().zip([r * a, g * a, b * a, a]) {
                    *sum += part;
                }
            }
            let [r, g, b, a] = sums;
            [r / a.max(1), g / a.max(1), b / a.max(1), a / (side * side) as u32].map(|x| x as u8)
        };
        Still { width, rgba: (0..width * width).map(mean).collect() }
    }

    fn save(&self, name: &str) {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("target/posters");
        std::fs::create_dir_all(&folder).expect("a folder for the posters");
        let file = std::fs::File::create(folder.join(format!("{name}.png"))).expect("a file");
        let mut encoder = png::Encoder::new(file, self.width as u32, self.width as u32);
        encoder.set_color(png::ColorType::Rgba);
        let mut writer = encoder.write_header().expect("a PNG");
        writer.write_image_data(self.rgba.as_flattened()).expect("a whole PNG");
    }
}
