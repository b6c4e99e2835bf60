//! Plants of the visitor's own: made by the workshop, held in the page, and kept on this machine if that is wished.

use super::files::{begin, tell};
use super::subject::{self, link_of};
use super::wish::{ANEW, OWN};
use super::with;
use super::work::{Said, refusal};
use crate::browser::address::wanted;
use crate::browser::dom::{find, window};
use crate::browser::files;
use crate::import::Painted;
use crate::plants::{self, Plant};
use crate::play::{FIRST_INDIVIDUAL, Scene, link, origin};
use js_sys::{Array, Uint8Array};
use wasm_bindgen::JsValue;
use wasm_bindgen_futures::spawn_local;
use web_sys::{HtmlInputElement, Storage};

/// Under these names the last plant is kept: its file, its name, and the link of what stood there before.
const KEPT: [&str; 3] = ["mosaic-own-file", "mosaic-own-name", "mosaic-own-link"];

/// With what a kept file begins that is no text: a character for each byte follows.
const IN_BYTES: char = '\0';

/// Makes a plant of a file, and shows it.
pub fn make(name: &str, bytes: &Uint8Array) {
    let link = link_of(&subject::address()).to_string();
    if find::<HtmlInputElement>("keep-own").checked() {
        keep(name, bytes, &link);
    }
    make_on(link, name.to_string(), bytes.clone(), None);
}

/// Keys of plants whose files come with the playground, as only figures show them, begin so.
const OF_FIGURES: &str = "own-figure-";

/// Fetches the plants of figures that a link shows, and opens it with them; false where it shows none.
pub fn fetch_of_figures(asked: &str) -> bool {
    let is_of_key = |c: char| c.is_ascii_alphanumeric() || c == '-';
    let words = asked.split(|c| !is_of_key(c)).filter(|word| word.starts_with(OF_FIGURES));
    let keys: Vec<String> = words.map(str::to_string).collect();
    if keys.is_empty() {
        return false;
    }
    let link = format!("{}{}", asked.trim_start_matches('#'), wanted());
    spawn_local(async move {
        for key in &keys {
            match files::read_mesh(key).await {
                Ok(text) => drop(put(key, &text)),
                Err(why) => return tell(&format!("The plant of this link did not come: {why}.")),
            }
        }
        subject::go_to(&link);
    });
    true
}

/// Makes the plant that was kept, and shows it if it is the one that a link asks for.
pub fn make_what_was_kept(asked: String) {
    let Some(storage) = storage() else { return };
    let [file, name, link] = KEPT.map(|key| storage.get_item(key).ok().flatten());
    if let (Some(file), Some(name), Some(link)) = (file, name, link) {
        let bytes = match file.strip_prefix(IN_BYTES) {
            Some(bytes) => bytes.chars().map(|c| c as u8).collect(),
            None => file.into_bytes(),
        };
        make_on(link, name, Uint8Array::from(&bytes[..]), Some(asked));
    }
}

/// Forgets what was kept.
pub fn forget() {
    if let Some(storage) = storage() {
        KEPT.iter().for_each(|key| drop(storage.remove_item(key)));
    }
}

/// Makes a plant on top of the scene of a link, and shows it as its preset is, or as the link says that asks for it.
fn make_on(base: String, name: String, bytes: Uint8Array, asked: Option<String>) {
    spawn_local(async move {
        let text = String::from_utf8_lossy(&bytes.to_vec()).into_owned();
        let mesh = mesh_named_in(&name, &text).await;
        let named = name.clone();
        let hear = move |said: Said| match said {
            Said::Day(_) => {}
            Said::Refused(why) => tell(&refusal(&why, format!("{named}: {why}."))),
            Said::Done(answer) => {
                let [key, text, told] =
                    [0, 1, 2].map(|k| answer.get(k).as_string().unwrap_or_default());
                match &asked {
                    Some(link) if !link.contains(&key) => {}
                    asked => {
                        if asked.is_none() && !told.is_empty() {
                            let told = format!("{named}: {told}.");
                            with(|studio| studio.to_tell = Some(told));
                        }
                        show(&key, &text, asked.as_deref());
                    }
                }
            }
        };
        let file = Array::of2(&name.into(), &bytes);
        match mesh {
            Ok(mesh) => begin([OWN, &base, &mesh], JsValue::from(file), hear),
            Err(why) => tell(&format!("The body that the document names did not come: {why}.")),
        }
    });
}

/// The mesh of the catalogue that a document names; none in any other file, and the plant that is there.
async fn mesh_named_in(name: &str, text: &str) -> Result<String, String> {
    let is_named = |mesh: &str| text.contains(&format!("\"{mesh}\""));
    let named = plants::all().iter().find(|plant| is_named(plant.body.mesh.name));
    match named.filter(|_| name.ends_with(".json")) {
        Some(plant) => files::read_mesh(plant.body.mesh.name).await,
        None => Ok(subject::own()),
    }
}

/// Puts a plant into the page, which reads it when its link is opened.
fn show(key: &str, text: &str, asked: Option<&str>) {
    let Some(plant) = put(key, text) else { return };
    match asked {
        Some(link) => subject::show(link.trim_start_matches('#')),
        None => show_preset(plant),
    }
}

/// Makes the plant that a link asks for of the words beside it, a body by rule or strokes, and shows it as the link says.
pub fn make_anew(asked: String, words: String) {
    subject::is_coming(true);
    spawn_local(async move {
        // Of strokes the plant below them.
        let mesh = match Painted::read(&words) {
            Some(Ok(Painted { base, .. })) => files::read_mesh(base.body.mesh.name).await,
            _ => Ok(String::new()),
        };
        let made_of = words.clone();
        let hear = move |said: Said| {
            subject::is_coming(false);
            match said {
                Said::Day(_) => {}
                Said::Refused(why) => {
                    tell(&refusal(&why, format!("The plant of this link cannot be made: {why}.")))
                }
                Said::Done(answer) => {
                    let Some(plant) = put_made(&answer, &made_of) else { return };
                    // Another build may call it otherwise.
                    match asked.split_once('?') {
                        Some((_, query)) => subject::show(&format!("{}?{query}", plant.key)),
                        None => show_preset(plant),
                    }
                }
            }
        };
        match mesh {
            Ok(mesh) => begin([ANEW, &words, &mesh], JsValue::NULL, hear),
            Err(why) => hear(Said::Refused(why)),
        }
    });
}

/// Puts a plant into the page that the workshop has made of words.
pub fn put_made(answer: &Array, words: &str) -> Option<&'static Plant> {
    let [key, text] = [0, 1].map(|k| answer.get(k).as_string().unwrap_or_default());
    origin::know(&key, words);
    put(&key, &text)
}

/// Shows a plant as its preset is.
pub fn show_preset(plant: &'static Plant) {
    subject::show(&link::write(&Scene::preset(plant, FIRST_INDIVIDUAL)));
}

/// Puts a plant into the page.
fn put(key: &str, text: &str) -> Option<&'static Plant> {
    let plant = plants::bring(text)?;
    hold(key, text);
    Some(plant)
}

/// Puts the text of a plant where the page looks for it.
pub fn hold(key: &str, text: &str) {
    files::hold(&files::mesh(key), text);
}

fn keep(name: &str, bytes: &Uint8Array, link: &str) {
    let text = String::from_utf8(bytes.to_vec()).unwrap_or_else(|file| {
        let bytes = file.as_bytes().iter().map(|&byte| char::from(byte));
        [IN_BYTES].into_iter().chain(bytes).collect()
    });
    let kept = storage().is_some_and(|storage| {
        let mut pairs = KEPT.into_iter().zip([&*text, name, link]);
        pairs.all(|(key, value)| storage.set_item(key, value).is_ok())
    });
    if !kept {
        forget();
        tell(
            "This browser has no room to keep it: its link opens here only while the page is open.",
        );
    }
}

fn storage() -> Option<Storage> {
    window().local_storage().ok().flatten()
}
