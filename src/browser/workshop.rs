//! The studio's workshop: a worker that grows a scene and answers with files, or with its days in numbers, and
//! opens files that come back. It is a bundle of its own: what reads and writes files weighs more than all that
//! the studio shows.

mod brush;

use super::studio::wish;
use crate::export::{
    Fit, Kind, Order, SketchView, Want, grown, measured, sketch, told_of, write_picture, write_zip,
};
use crate::import::{
    Made, Own, Part, Photo, Skin, link_of_file, made_of_words, of_document, of_mesh, palette, types,
};
use crate::plants::{self, Plant};
use crate::play::lesson::Measure;
use crate::play::{Scene, link, origin};
use crate::surface::{Charts, unpack};
use crate::tissue::{Growth, Progress};
use js_sys::{Array, Float64Array, Uint8Array, Uint8ClampedArray};
use wasm_bindgen::prelude::*;
use web_sys::{DedicatedWorkerGlobalScope, ImageData, MessageEvent};

/// Listens for its wish, and for the next one when it has answered, which `studio/wish.rs` describes with its answers, and says hello before.
pub fn listen() {
    let mut skin: Option<Skin> = None;
    let hear = Closure::<dyn FnMut(MessageEvent)>::new(move |message: MessageEvent| {
        let wish: Array = message.data().unchecked_into();
        let word = |k| wish.get(k).as_string().unwrap_or_default();
        let [wanted, link, mesh, name] = [word(0), word(1), word(2), word(3)];
        // The mesh of a plant of the visitor's own says it, and its link what it is made of.
        plants::bring(&mesh);
        origin::learn(&link);
        let bytes = || wish.get(3).unchecked_into::<Uint8Array>().to_vec();
        let answer = match Kind::of_word(&wanted) {
            Some(kind) => take(kind, &link, &mesh, &name),
            None => match &*wanted {
                wish::DOCUMENT => Ok(file("", document(&link).as_bytes())),
                wish::PICTURE => picture(&link, &wish.get(3).unchecked_into()),
                wish::PHOTO => photo(&link, &mesh, &wish.get(3).unchecked_into()),
                wish::OPEN => link_of_file(&bytes(), &scene_of(&link)).map(|link| array(&link)),
                wish::OWN => own(&link, &mesh, &wish.get(3).unchecked_into()),
                wish::FIT => fit(&link, &mesh, &name),
                wish::MEASURE => measure(&link, &mesh, &name),
                wish::SHAPE => shape(&link, &wish.get(3).unchecked_into()),
                wish::SHAPE_NUMBERS => {
                    Made::of_words(&link).map(|made| file("", made.to_json().as_bytes()))
                }
                wish::ANEW => made_of_words(&link, &unpack(&mesh)).map(of_own),
                wish::SKIN => brush::hold(&mut skin, &link, &unpack(&mesh)),
                wish::STROKE => {
                    brush::stroke(&skin, &scene_of(&link), &wish.get(3).unchecked_into())
                }
                _ => number(&link, &mesh, &name),
            },
        };
        match answer {
            Ok(answer) => post(&answer),
            Err(why) => post(&why.into()),
        }
    });
    scope().set_onmessage(Some(hear.as_ref().unchecked_ref()));
    hear.forget();
    post(&JsValue::NULL);
}

fn scene_of(link: &str) -> Scene {
    link::read(link, plants::all()).scene
}

fn order(kind: Kind, link: &str, mesh: &str) -> Result<(Order, Growth), String> {
    let scene = scene_of(link);
    let body = scene.plant.grow_body(&unpack(mesh)).map_err(|e| e.to_string())?;
    Order::new(kind, &scene, body)
}

/// Grows and writes a kind of file; an OBJ and its materials are packed into one.
fn take(kind: Kind, link: &str, mesh: &str, name: &str) -> Result<JsValue, String> {
    let (order, mut growth) = order(kind, link, mesh)?;
    loop {
        match growth.step() {
            Progress::Event => {}
            Progress::Day(day) => post(&day.into()),
            Progress::Done | Progress::Full => break,
        }
    }
    let materials = format!("{name}.mtl");
    let written = order.write(growth.diary, &materials)?;
    match &written.files[..] {
        [obj, mtl] => {
            let mut zip = Vec::new();
            let files = [(&*format!("{name}.obj"), &obj[..]), (&*materials, &mtl[..])];
            write_zip(&files, 1, &mut zip).map_err(|e| e.to_string())?;
            Ok(file(&written.told, &zip))
        }
        files => Ok(file(&written.told, &files.concat())),
    }
}

/// The plant with the numbers and the colours of a scene.
fn document(link: &str) -> String {
    let Scene { plant, recipe, look, .. } = scene_of(link);
    Plant { recipe, look, ..plant.as_written() }.to_json()
}

fn own(link: &str, mesh: &str, file: &Array) -> Result<JsValue, String> {
    let name = file.get(0).as_string().unwrap_or_default();
    let bytes = file.get(1).unchecked_into::<Uint8Array>().to_vec();
    let made = match std::str::from_utf8(&bytes) {
        Ok(json) if name.ends_with(".json") => of_document(json, &unpack(mesh)),
        _ => {
            of_mesh(&bytes, name.rsplit_once('.').map_or(&*name, |(name, _)| name), &scene_of(link))
        }
    };
    made.map(of_own)
}

fn of_own(Own { key, text, told }: Own) -> JsValue {
    Array::of3(&key.into(), &text.into(), &told.join("; ").into()).into()
}

/// Draws a body by rule.
fn shape(words: &str, view: &Float64Array) -> Result<JsValue, String> {
    let made = Made::of_words(words)?;
    let mesh = made.seen()?;
    let view = view.to_vec();
    let number = |k: usize| view.get(k).copied().unwrap_or_default() as f32;
    let view = SketchView {
        size_px: [0, 1].map(|k| number(k) as usize),
        azimuth_deg: number(2),
        elevation_deg: number(3),
        time: number(4),
    };
    let pixels = sketch(&mesh, &made.plant(), view);
    Ok(Array::of2(&told_of(&mesh).into(), &Uint8ClampedArray::from(&pixels[..])).into())
}

fn picture(link: &str, picture: &ImageData) -> Result<JsValue, String> {
    let size_px = [picture.width(), picture.height()];
    let png = write_picture(size_px, &picture.data(), link).map_err(|e| e.to_string())?;
    Ok(file("", &png))
}

fn photo(link: &str, mesh: &str, photo: &ImageData) -> Result<JsValue, String> {
    let scene = scene_of(link);
    let body = scene.plant.grow_body(&unpack(mesh)).map_err(|e| e.to_string())?.surface;
    let photo = Photo { width_px: photo.width() as usize, pixels: &photo.data() };
    let palette = palette(photo, types(&scene).count())?;
    // A leaf is seen whole, and of a fruit or a stem one side.
    let views = if body.uvs.is_empty() { 2.0 } else { body.part_count() as f64 };
    let mut row = vec![palette.cells * views];
    for Part { colour, share } in palette.colours {
        row.extend(colour.map(f64::from));
        row.push(share);
    }
    Ok(Array::of1(&Float64Array::from(&row[..])).into())
}

/// Grows and tells each day in numbers as it is done, or the last so many alone.
fn number(link: &str, mesh: &str, last: &str) -> Result<JsValue, String> {
    let day = scene_of(link).day as usize;
    let (order, mut growth) = order(Kind::Days, link, mesh)?;
    let mut charts = Charts::new(order.mesh());
    let mut told = last.parse().map_or(0, |last: usize| (day + 1).saturating_sub(last));
    loop {
        let progress = growth.step();
        while told < growth.diary.days.len() && !matches!(progress, Progress::Event) {
            let row = order.numbers(&mut charts, &growth.diary, told).to_row();
            let fingerprint = order.fingerprint(&growth.diary, told);
            let row = Float64Array::from(&row[..]);
            post(&Array::of3(&row, &fingerprint.into(), &order.leaves().into()).into());
            told += 1;
        }
        if matches!(progress, Progress::Done | Progress::Full) {
            return Ok(Array::new().into());
        }
    }
}

/// Grows as many individuals as are wished, and tells each one's number as it is done.
fn measure(link: &str, mesh: &str, wish: &str) -> Result<JsValue, String> {
    let (which, measure) = wish.split_once(' ').unwrap_or_default();
    let measure = Measure::of_words(measure).ok_or("There is no such measure.")?;
    let scene = scene_of(link);
    let body = scene.plant.grow_body(&unpack(mesh)).map_err(|e| e.to_string())?;
    let grow = |scene: Scene| {
        post(&Array::of1(&measured(&scene, measure, body.clone())?.into()).into());
        Ok::<(), String>(())
    };
    match which.parse::<u32>() {
        Ok(individuals) => {
            for k in 0..individuals {
                grow(Scene { individual: scene.individual.wrapping_add(k), ..scene.clone() })?;
            }
        }
        Err(_) => {
            for day in which.split(',').filter_map(|day| day.parse().ok()) {
                grow(Scene { day, ..scene.clone() })?;
            }
        }
    }
    Ok(Array::new().into())
}

/// Looks for the numbers of the individual that is there.
fn fit(link: &str, mesh: &str, wish: &str) -> Result<JsValue, String> {
    let scene = scene_of(link);
    let wants = Want::read(wish, &scene)?;
    let body = scene.plant.body.grow(&unpack(mesh)).map_err(|e| e.to_string())?;
    let mut fit = Fit::new(scene.clone(), wants.clone(), Fit::numbers_of(&wants, &scene));
    while let Some(scene) = fit.next_scene().filter(|_| fit.tries() <= wish::MOST_TRIES) {
        post(&(fit.tries() as u32).into());
        let values = match grown(&scene, &wants, body.clone()) {
            Err(why) if fit.tries() == 1 => return Err(why),
            values => values.ok(),
        };
        let link = link::write(&scene);
        if let (true, Some(values)) = (fit.tell(scene, values.as_deref()), &values) {
            let told = wants.iter().zip(values).map(|(want, &value)| want.measure.told(value));
            let told = told.collect::<Vec<_>>().join(", ");
            post(&Array::of2(&told.into(), &link.into()).into());
        }
    }
    Ok(Array::new().into())
}

/// A file, and what it is in a few words.
fn file(told: &str, bytes: &[u8]) -> JsValue {
    Array::of2(&told.into(), &Uint8Array::from(bytes)).into()
}

fn array(text: &str) -> JsValue {
    Array::of1(&text.into()).into()
}

fn post(answer: &JsValue) {
    scope().post_message(answer).expect("texts and bytes can be sent");
}

fn scope() -> DedicatedWorkerGlobalScope {
    js_sys::global().unchecked_into()
}
