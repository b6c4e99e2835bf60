//! Large pictures, tile by tile.

use super::easel::{Easel, Shot};
use super::paper::Paper;
use super::{a_moment, tell, text};
use crate::export::{CodePlace, Sheet, SheetSize, TILE_PX, with_link};
use crate::play::{Scene, origin};
use glam::UVec2;
use js_sys::{Array, Uint8Array};
use wasm_bindgen::JsCast;
use wasm_bindgen_futures::JsFuture;
use web_sys::{Blob, ImageData, ImageEncodeOptions, Path2d};

/// Draws and writes a large picture: `more` is an array of
/// 0. the word of its size, and the width and height of the page's stage in pixels of CSS;
/// 1. the light of its stage as a small picture, or nothing, and 2. whether that is dark;
/// 3. the lines of its caption: name, Latin name, numbers and address; empty without one;
/// 4. its QR code as a path of squares with a side of 1, empty without one, and 5. how many stand along a side;
/// 6. the lines of its style: the colours of band, ink and faint ink, the fonts of names and of the rest.
pub async fn sheet(scene: &Scene, mesh: &str, more: &Array) -> Result<Vec<u8>, String> {
    let unknown = "There is no such picture.";
    let words = text(more, 0);
    let words: Vec<&str> = words.split(' ').collect();
    let [size, width, height] = words[..] else { return Err(unknown.to_string()) };
    let size = SheetSize::of_word(size).ok_or(unknown)?;
    let screen_px = width.parse().ok().zip(height.parse().ok());
    let screen_px = screen_px.map(|(width, height)| UVec2::new(width, height)).ok_or(unknown)?;
    let light: Option<ImageData> = more.get(1).dyn_into().ok();
    let (caption, code) = (text(more, 3), text(more, 4));
    let squares = more.get(5).as_f64().filter(|_| !code.is_empty()).map(|side| side as u32);
    let sheet = Sheet::new(size, screen_px, !caption.is_empty(), squares);

    let mut easel = Easel::new(scene, mesh, scene.day).await?;
    let day = scene.day.min(easel.last_day());
    let whole = sheet.size_px();
    let paper = Paper::new(whole.x, whole.y, false)?;
    let picture = sheet.picture_px.as_dvec2();
    if let Some(light) = &light {
        paper.paint(light, picture.x, picture.y)?;
    }
    for (step, corner) in (scene.day + 1..).zip(sheet.tiles()) {
        easel.draw(&Shot {
            day,
            moment: 1.0,
            orbit: scene.orbit,
            show: scene.show,
            dark: more.get(2).is_truthy(),
            size_px: sheet.picture_px,
            part: Some((sheet.onto_tile(corner), UVec2::splat(TILE_PX))),
        })?;
        paper.lay(&easel.canvas, f64::from(corner.x), f64::from(corner.y))?;
        tell(step);
        a_moment().await;
    }
    // The last tiles reach over the picture's rim.
    paper.pen.clear_rect(0.0, picture.y, picture.x, f64::from(sheet.band_px));
    let style = text(more, 6);
    band(&paper, &sheet, light.is_some(), &caption, &code, &style)?;

    let kind = ImageEncodeOptions::new();
    kind.set_type("image/png");
    let unwritten = "This browser cannot write a picture that large: choose a smaller one.";
    let blob = paper.canvas.convert_to_blob_with_options(&kind).map_err(|_| unwritten)?;
    let blob: Blob = JsFuture::from(blob).await.map_err(|_| unwritten)?.unchecked_into();
    let png = JsFuture::from(blob.array_buffer()).await.map_err(|_| unwritten)?;
    let png = Uint8Array::new(&png).to_vec();
    Ok(with_link(&png, &origin::whole_link(scene), sheet.per_metre).ok_or(unwritten)?)
}

/// Writes the caption and draws the code under the picture.
fn band(
    paper: &Paper,
    sheet: &Sheet,
    is_staged: bool,
    caption: &str,
    code: &str,
    style: &str,
) -> Result<(), String> {
    let [card, ink, faint, names, rest] =
        std::array::from_fn(|k| style.lines().nth(k).unwrap_or_default());
    let (pen, unit) = (&paper.pen, sheet.unit_px);
    let (whole, top) = (sheet.size_px().as_dvec2(), f64::from(sheet.picture_px.y));
    if is_staged {
        pen.set_fill_style_str(card);
        pen.fill_rect(0.0, top, whole.x, f64::from(sheet.band_px));
    }
    let left = 3.0 * unit;
    let right = sheet.code.map_or(whole.x, |code| f64::from(code.corner_px.x)) - left;
    let lines: Vec<&str> = caption.lines().collect();
    if let [name, latin, numbers, address] = lines[..] {
        // The three lines stand in the middle of the band, whatever its height.
        let base = top + f64::from(sheet.band_px) / 2.0;
        let write = |text: &str, font: &str, size: f64, colour: &str, x: f64, y: f64| {
            let set = |size: f64| {
                pen.set_font(&font.replace("SIZE", &format!("{size:.1}px")));
                pen.measure_text(text).map_or(0.0, |measure| measure.width())
            };
            let (wide, room) = (set(size), right - x);
            let wide = if wide > room { set(size * room / wide) } else { wide };
            pen.set_fill_style_str(colour);
            // Fails for no text.
            let _ = pen.fill_text(text, x, y);
            x + wide
        };
        let end = write(name, &format!("500 SIZE {names}"), 3.6 * unit, ink, left, base - unit);
        let latin_font = format!("italic 400 SIZE {names}");
        write(latin, &latin_font, 2.7 * unit, faint, end + 1.2 * unit, base - unit);
        let font = format!("400 SIZE {rest}");
        write(numbers, &font, 1.9 * unit, ink, left, base + 1.8 * unit);
        write(address, &font, 1.5 * unit, faint, left, base + 4.2 * unit);
    }
    if let Some(CodePlace { corner_px, square_px, squares }) = sheet.code {
        let bad = "The QR code cannot be drawn.";
        let path = Path2d::new_with_path_string(code).map_err(|_| bad)?;
        let (side, corner) = (f64::from(square_px), corner_px.as_dvec2());
        pen.translate(corner.x, corner.y).map_err(|_| bad)?;
        pen.scale(side, side).map_err(|_| bad)?;
        pen.set_fill_style_str("#fff");
        pen.fill_rect(0.0, 0.0, squares.into(), squares.into());
        pen.set_fill_style_str("#000");
        pen.fill_with_path_2d(&path);
        pen.reset_transform().map_err(|_| bad)?;
    }
    Ok(())
}
