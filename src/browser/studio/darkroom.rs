//! Films and large pictures: what the visitor has chosen, and how it is told to the darkroom.

use super::picture;
use super::subject;
use super::wish::{FILM, SHEET};
use crate::browser::dom::{document, find, set_flag, set_text, window, within};
use crate::export::{Act, Film, FilmFormat, Sheet, SheetSize};
use crate::play::{Scene, words};
use glam::UVec2;
use js_sys::{Array, Function, Object, Promise, Reflect};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::JsFuture;
use web_sys::{
    CanvasRenderingContext2d, Element, HtmlCanvasElement, HtmlImageElement, HtmlInputElement,
    HtmlOptionElement, HtmlSelectElement, ImageData,
};

/// What the darkroom is asked for.
pub struct Print {
    /// What its file is called.
    pub file: String,
    /// What it is called while it is made.
    pub what: &'static str,
    /// Days that grow first.
    pub days: u32,
    /// Frames or tiles.
    pub steps: u32,
    more: Wish,
}

enum Wish {
    Film(Film),
    Sheet { words: String, is_staged: bool, caption: String, code: Option<(String, u32)> },
}

impl Print {
    /// What is chosen in the dialog.
    pub fn chosen(wanted: &str, dialog: &Element, scene: &Scene, address: &str) -> Print {
        let key = scene.plant.key;
        let name = format!("{key}-{}", scene.individual);
        if wanted == FILM {
            let film = film(dialog);
            let (what, days) = match film.act {
                Act::Growth => ("growth".to_string(), scene.recipe.days),
                Act::Turn => (format!("day-{}-turn", scene.day), scene.day),
            };
            let end = if film.format == FilmFormat::Gif { "gif" } else { "mp4" };
            let file = format!("{name}-{what}.{end}");
            let steps = film.frames;
            return Print { file, what: "the film", days, steps, more: Wish::Film(film) };
        }
        let (sheet, size, code) = chosen_sheet(dialog, address);
        let stage = stage_px();
        let caption = is_checked(dialog, ".sheet-caption").then(|| {
            let fingerprint = subject::fingerprint();
            format!(
                "{}\n{}\nIndividual {}, day {} of {}, fingerprint {fingerprint}\n{address}",
                scene.plant.name, scene.plant.latin, scene.individual, scene.day, scene.recipe.days
            )
        });
        Print {
            file: format!("{name}-day-{}-{size}.png", scene.day),
            what: "the picture",
            days: scene.day,
            steps: sheet.tiles().len() as u32,
            more: Wish::Sheet {
                words: format!("{size} {} {}", stage.x, stage.y),
                is_staged: chosen(dialog, ".sheet-ground") == "stage",
                caption: caption.unwrap_or_default(),
                code,
            },
        }
    }

    /// What stands after the word, the link and the mesh: see `wish`.
    ///
    /// # Errors
    /// In plain words, why it cannot be.
    pub async fn wish(self) -> Result<Array, String> {
        let (light, dark) = stage_light().await.ok_or("The stage cannot be painted.")?;
        Ok(match self.more {
            Wish::Film(mut film) => {
                if film.format != FilmFormat::Gif {
                    film.format = codec(&film).await.ok_or(NO_ENCODER)?;
                }
                Array::of3(&film.written().into(), &light, &dark.into())
            }
            Wish::Sheet { words, is_staged, caption, code } => {
                let light = if is_staged { light.into() } else { JsValue::NULL };
                let (path, squares) = code.unwrap_or_default();
                let dark = dark && is_staged;
                let array =
                    Array::of5(&words.into(), &light, &dark.into(), &caption.into(), &path.into());
                array.push(&squares.into());
                array.push(&style(is_staged).into());
                array
            }
        })
    }
}

const NO_ENCODER: &str =
    "This browser encodes no film of that size: choose a smaller one, or a GIF.";

/// Says of both how large they will be.
pub fn tell(dialog: &Element, address: &str) {
    let film = film(dialog);
    let seconds = film.frames / film.frames_per_s();
    let [width, height] = film.size_px;
    let megabytes = u64::from(film.bits_per_s()) * u64::from(seconds) / 8_000_000;
    let size = match film.format {
        FilmFormat::Gif => String::new(),
        FilmFormat::Mp4 { .. } => format!(", up to {} MB", megabytes.max(1)),
    };
    let frames = words::grouped(film.frames);
    set_text(
        &within(dialog, ".film-told"),
        &format!("{frames} frames, {seconds} s, {width} × {height} pixels{size}"),
    );
    let (sheet, _, code) = chosen_sheet(dialog, address);
    let size = sheet.size_px();
    let lacks_code = is_checked(dialog, ".sheet-code") && code.is_none();
    let mut told = format!("{} × {} pixels", size.x, size.y);
    if lacks_code {
        told += ". ";
        told += picture::TOO_LONG;
    }
    set_text(&within(dialog, ".sheet-told"), &told);
}

/// Takes MP4 from the choices where the browser encodes none.
pub async fn offer_mp4(dialog: Element) {
    let mp4 = FilmFormat::Mp4 { codec: String::new() };
    let usual = Film { act: Act::Turn, frames: 2, size_px: [1280, 720], format: mp4 };
    let found = codec(&usual).await;
    let option: HtmlOptionElement = within(&dialog, ".film-format [value=mp4]");
    set_flag(&option, "disabled", found.is_none());
    let text = match &found {
        Some(FilmFormat::Mp4 { codec }) if codec.starts_with("avc1") => "MP4 (H.264)",
        Some(_) => "MP4 (VP9)",
        None => "MP4: not in this browser",
    };
    set_text(&option, text);
    let select: HtmlSelectElement = within(&dialog, ".film-format");
    if found.is_none() && select.value() == "mp4" {
        select.set_value("gif");
    }
}

/// The film that is chosen; which codec is not known yet.
fn film(dialog: &Element) -> Film {
    let size = chosen(dialog, ".film-size");
    let mut lengths = size.split(' ').filter_map(|length| length.parse().ok());
    let mut length = || lengths.next().unwrap_or(640);
    let act = if chosen(dialog, ".film-act") == "turn" { Act::Turn } else { Act::Growth };
    let format = match &*chosen(dialog, ".film-format") {
        "gif" => FilmFormat::Gif,
        _ => FilmFormat::Mp4 { codec: String::new() },
    };
    let film = Film { act, frames: 2, size_px: [length(), length()], format };
    let seconds: u32 = chosen(dialog, ".film-seconds").parse().unwrap_or(4);
    Film { frames: seconds * film.frames_per_s(), ..film }
}

/// The picture that is chosen, the word of its size, and its QR code with the squares along a side.
fn chosen_sheet(dialog: &Element, address: &str) -> (Sheet, String, Option<(String, u32)>) {
    let word = chosen(dialog, ".sheet-size");
    let size = SheetSize::of_word(&word).unwrap_or(SheetSize::Screen(1));
    let code = is_checked(dialog, ".sheet-code").then(|| picture::qr(address)).flatten();
    let code = code.map(|(view_box, path)| {
        let side = view_box.rsplit(' ').next().and_then(|side| side.parse().ok());
        (path, side.unwrap_or(0))
    });
    let squares = code.as_ref().map(|(_, squares)| *squares);
    let has_caption = is_checked(dialog, ".sheet-caption");
    (Sheet::new(size, stage_px(), has_caption, squares), word, code)
}

fn stage_px() -> UVec2 {
    let stage: Element = find("stage");
    let [width, height] = [stage.client_width(), stage.client_height()];
    UVec2::new(width.max(1) as u32, height.max(1) as u32)
}

fn chosen(dialog: &Element, select: &str) -> String {
    within::<HtmlSelectElement>(dialog, select).value()
}

fn is_checked(dialog: &Element, input: &str) -> bool {
    within::<HtmlInputElement>(dialog, input).checked()
}

/// The best way in which the browser encodes a film: H.264, which every program of slides shows, or else VP9.
async fn codec(film: &Film) -> Option<FilmFormat> {
    let encoder = Reflect::get(&window(), &"VideoEncoder".into()).ok()?;
    let ask = Reflect::get(&encoder, &"isConfigSupported".into()).ok()?;
    let ask: Function = ask.dyn_into().ok()?;
    for codec in ["avc1.640028", "avc1.4d0028", "avc1.42e028", "vp09.00.40.08"] {
        let config = Object::new();
        let [width, height] = film.size_px;
        let numbers = [
            ("width", width),
            ("height", height),
            ("framerate", film.frames_per_s()),
            ("bitrate", film.bits_per_s()),
        ];
        let _ = Reflect::set(&config, &"codec".into(), &codec.into());
        for (name, number) in numbers {
            let _ = Reflect::set(&config, &name.into(), &number.into());
        }
        let asked = ask.call1(&encoder, &config).ok().and_then(|p| p.dyn_into::<Promise>().ok());
        if let Some(asked) = asked {
            let answer = JsFuture::from(asked).await.unwrap_or_default();
            if Reflect::get(&answer, &"supported".into()).is_ok_and(|yes| yes.is_truthy()) {
                return Some(FilmFormat::Mp4 { codec: codec.to_string() });
            }
        }
    }
    None
}

/// The light behind the plant, a few pixels wide and high, and whether the stage is dark.
async fn stage_light() -> Option<(ImageData, bool)> {
    let style = window().get_computed_style(&find::<Element>("stage")).ok()??;
    let light = style.get_property_value("background-image").ok()?;
    let address = light.strip_prefix("url(")?.strip_suffix(')')?.trim_matches('"');
    let dark = value_of("--stage-dark").contains(address);
    let image = HtmlImageElement::new().ok()?;
    image.set_src(address);
    JsFuture::from(image.decode()).await.ok()?;
    let canvas: HtmlCanvasElement = document().create_element("canvas").ok()?.unchecked_into();
    canvas.set_width(image.natural_width());
    canvas.set_height(image.natural_height());
    let pen: CanvasRenderingContext2d = canvas.get_context("2d").ok()??.unchecked_into();
    pen.draw_image_with_html_image_element(&image, 0.0, 0.0).ok()?;
    let (width, height) = (canvas.width().into(), canvas.height().into());
    Some((pen.get_image_data(0.0, 0.0, width, height).ok()?, dark))
}

/// Colours of band, ink and faint ink, and the fonts: those of the page, or on nothing those of paper.
fn style(is_staged: bool) -> String {
    let colours = match is_staged {
        true => ["--card", "--ink", "--muted"].map(value_of),
        false => ["", "#23281c", "#565a4b"].map(String::from),
    };
    [&colours[..], &["--serif", "--sans"].map(value_of)].concat().join("\n")
}

fn value_of(property: &str) -> String {
    let root = document().document_element().expect("a document has a root");
    let style = window().get_computed_style(&root).ok().flatten();
    let value = style.and_then(|style| style.get_property_value(property).ok());
    value.unwrap_or_default().trim().to_string()
}

/// Whether a word of the dialog is for the darkroom.
pub fn is_for(wanted: &str) -> bool {
    wanted == FILM || wanted == SHEET
}
