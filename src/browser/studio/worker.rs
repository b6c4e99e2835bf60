//! The studio's worker: grows a scene and answers with files, or with its days in numbers.

use crate::export::{Kind, Order, measured};
use crate::plants;
use crate::play::lesson::Measure;
use crate::play::{Scene, link};
use crate::surface::{Charts, unpack};
use crate::tissue::{Growth, Progress};
use js_sys::{Array, Uint8Array};
use wasm_bindgen::prelude::*;
use web_sys::{DedicatedWorkerGlobalScope, MessageEvent};

/// The word for days in numbers, where else the word of a kind of file stands.
pub const NUMBERS: &str = "numbers";

/// The word for one number of some individuals, or of some days of one; the name of the file is then how many or
/// which days, and what: `12 share F`, `0,10,20 share F`.
pub const MEASURE: &str = "measure";

/// Listens for its one wish, an array of what is wanted, the link, the packed mesh of its plant and the name of the
/// file, and says hello before. Answers: a number, how many days have grown; a text, why it cannot be; an array, what
/// was wanted: a text and the files, or, for numbers, the JSON of a day, and at last nothing; for measures a number of an individual, and at last nothing.
pub fn start_worker() {
    let hear = Closure::<dyn FnMut(MessageEvent)>::new(|message: MessageEvent| {
        let wish: Array = message.data().unchecked_into();
        let words: Vec<String> = wish.iter().filter_map(|word| word.as_string()).collect();
        let [wanted, link, mesh, name] = &words[..] else { return };
        let answer = match Kind::of_word(wanted) {
            Some(kind) => take(kind, link, mesh, name),
            None if wanted == MEASURE => measure(link, mesh, name),
            None => number(link, mesh),
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

fn order(kind: Kind, link: &str, mesh: &str) -> Result<(Order, Growth), String> {
    let scene = link::read(link, plants::all()).scene;
    let body = scene.plant.grow_body(&unpack(mesh)).map_err(|e| e.to_string())?;
    Order::new(kind, &scene, body)
}

/// Grows and writes a kind of file.
fn take(kind: Kind, link: &str, mesh: &str, name: &str) -> Result<JsValue, String> {
    let (order, mut growth) = order(kind, link, mesh)?;
    loop {
        match growth.step() {
            Progress::Event => {}
            Progress::Day(day) => post(&day.into()),
            Progress::Done | Progress::Full => break,
        }
    }
    let written = order.write(growth.diary, name)?;
    let answer = Array::of1(&written.told.into());
    for file in written.files {
        answer.push(&Uint8Array::from(&file[..]));
    }
    Ok(answer.into())
}

/// Grows and tells each day in numbers as it is done.
fn number(link: &str, mesh: &str) -> Result<JsValue, String> {
    let (order, mut growth) = order(Kind::Days, link, mesh)?;
    let mut charts = Charts::new(order.mesh());
    let mut told = 0;
    loop {
        let progress = growth.step();
        while told < growth.diary.days.len() && !matches!(progress, Progress::Event) {
            let numbers = order.numbers(&mut charts, &growth.diary, told);
            let json = serde_json::to_string(&numbers).expect("numbers can be written");
            post(&Array::of1(&json.into()).into());
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
    let scene = link::read(link, plants::all()).scene;
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

fn post(answer: &JsValue) {
    scope().post_message(answer).expect("texts and bytes can be sent");
}

fn scope() -> DedicatedWorkerGlobalScope {
    js_sys::global().unchecked_into()
}
