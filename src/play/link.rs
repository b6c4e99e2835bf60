//! Links: a scene written as the fragment of an address, `croton?v=1&s=17&d=12&df=6`, and read back.
//!
//! First the plant, then the version of its rules, the individual and the day, and then only what differs
//! from the preset that the plant has in that version. The presets of a version are frozen: to change one, make
//! new rules and keep the old plant for the links of the old ones.

use super::camera::Orbit;
use super::parameters::{PARAMETERS, Parameter};
use super::scene::{FIRST_INDIVIDUAL, Scene};
use super::typed;
use crate::plants::{OWN, Plant, Show, brought};
use crate::surface::{Shortest, quoted};
use glam::Vec2;
use std::fmt::Write;

/// The word for the version of the rules.
const VERSION: &str = "v";

/// The word for the language of the page, which is no part of what a link shows.
const LANGUAGE: &str = "lang";

/// The word for the number of the individual.
pub const INDIVIDUAL: &str = "s";

/// The word for the wished day.
pub const DAY: &str = "d";

/// The word for the number of the cell whose clone is in hand. That of a first cell is its whole clan.
pub const CELL: &str = "cell";

/// A link that was read: what could be loaded, and in plain words what was left out and why.
#[derive(Clone, Debug)]
pub struct Opened {
    pub scene: Scene,
    pub left_out: Vec<String>,
}

/// Writes a scene, without the `#`.
pub fn write(scene: &Scene) -> String {
    let Scene { plant, individual, day, .. } = scene;
    let version = plant.rules as u32;
    let mut link = format!("{}?v={version}&{INDIVIDUAL}={individual}&d={day}", plant.key);
    let preset = Scene::preset(plant, *individual);
    for parameter in PARAMETERS {
        let value = parameter.get(scene);
        if value != parameter.get(&preset) {
            let _ = write!(link, "&{}={}", parameter.key, parameter.written(value));
        }
    }
    if scene.noise {
        link.push_str("&noise=1");
    }
    if scene.show != preset.show {
        let _ = write!(link, "&show={}", scene.show.key());
    }
    if let Some(cell) = scene.cell {
        let _ = write!(link, "&{CELL}={cell}");
    }
    let orbit = scene.orbit.rounded();
    if orbit != preset.orbit.rounded() {
        let Orbit { azimuth_deg, elevation_deg, zoom, pan } = orbit;
        let view = [azimuth_deg, elevation_deg, zoom].map(f32::shortest);
        let _ = write!(link, "&view={}", view.join(","));
        if pan != Vec2::ZERO {
            let _ = write!(link, ",{},{}", pan.x.shortest(), pan.y.shortest());
        }
    }
    link
}

/// Reads a link with or without its `#`: what is unknown or cannot be is left out and told, the rest
/// is loaded, and the order of its words does not matter. `plants` is the catalogue, its first plant
/// the one that stands in.
pub fn read(text: &str, plants: &'static [Plant]) -> Opened {
    let text = decode(text.trim().trim_start_matches('#'));
    // What stands behind is what a page does with the plant.
    let text = text.split('~').next().unwrap_or_default();
    let text = text.trim_end_matches(hangs_on);
    let (name, query) = text.split_once('?').unwrap_or((text, ""));
    let mut left_out = Vec::new();
    let known = plants.iter().find(|p| p.key == name).or_else(|| brought(name));
    let plant = known.unwrap_or_else(|| {
        if name.starts_with(OWN) {
            left_out.push(format!(
                "{} is a plant of somebody's own, and its file is not here: the {} stands in its place.",
                shown(name),
                plants[0].name.to_ascii_lowercase()
            ));
        } else if !name.is_empty() {
            left_out.push(format!(
                "There is no plant called {} here: the {} stands in its place.",
                shown(name),
                plants[0].name.to_ascii_lowercase()
            ));
        }
        &plants[0]
    });
    let words = known_words(query, &mut left_out);
    let plant = of_version(plant, &words, &mut left_out);
    let mut scene = Scene::preset(plant, FIRST_INDIVIDUAL);
    let wished_day = read_words(&mut scene, &words, &mut left_out);
    read_parameters(&mut scene, &words, &mut left_out);
    // How many days there are may have been said after the wished one.
    if let Some(day) = wished_day {
        scene.day = day.min(scene.recipe.days);
        if day > scene.recipe.days {
            left_out.push(format!(
                "Day {day} is past the last one: day {} is shown in its place.",
                scene.day
            ));
        }
    }
    Opened { scene, left_out }
}

/// What a sentence may have hung on the last number: a full stop, a bracket, a quotation mark.
fn hangs_on(c: char) -> bool {
    (c.is_ascii_punctuation() && c != '=') || matches!(c, ' ' | '”' | '’' | '»' | '…')
}

/// A word of a link and its value, and both as they stand there.
type Said<'a> = (&'a str, &'a str, &'a str);

/// What a link says, each word once.
fn known_words<'a>(query: &'a str, left_out: &mut Vec<String>) -> Vec<Said<'a>> {
    let mut known: Vec<Said> = Vec::new();
    let (mut unknown, mut again) = (Vec::new(), Vec::new());
    for pair in query.split('&').map(without_amp).filter(|p| !p.is_empty()) {
        let (word, value) = pair.split_once('=').unwrap_or((pair, ""));
        if word == LANGUAGE {
            continue;
        }
        if !WORDS.contains(&word) && Parameter::of_key(word).is_none() {
            unknown.push(pair);
        } else if known.iter().any(|said| said.0 == word) {
            again.push(pair);
        } else {
            known.push((word, value, pair));
        }
    }
    leave_out(left_out, &unknown, "unknown to this playground");
    leave_out(left_out, &again, "of each word the first counts");
    known
}

/// A word without what HTML makes of the `&` before it.
fn without_amp(mut word: &str) -> &str {
    while let Some(rest) = word.strip_prefix("amp;") {
        word = rest;
    }
    word
}

/// The words that are no parameters.
const WORDS: [&str; 7] = [VERSION, INDIVIDUAL, DAY, "noise", "show", CELL, "view"];

/// Reads the words that are no parameters, and returns the day that is wished.
fn read_words(scene: &mut Scene, words: &[Said], left_out: &mut Vec<String>) -> Option<u32> {
    let mut wished_day = None;
    for &(word, value, pair) in words {
        let result = match word {
            INDIVIDUAL => whole(value).map(|n| scene.individual = n),
            DAY => day(value).map(|n| wished_day = Some(n)),
            "noise" => switch(value).map(|on| scene.noise = on),
            "show" => read_show(scene.plant, value).map(|show| scene.show = show),
            CELL => whole(value).map(|cell| scene.cell = Some(cell)),
            "view" => read_orbit(value).map(|orbit| {
                scene.orbit = orbit.above(Orbit::lowest_deg(scene.plant));
            }),
            _ => Ok(()),
        };
        if let Err(why) = result {
            leave_out(left_out, &[pair], &why);
        }
    }
    wished_day
}

/// Sets the parameters in the order of their table, whatever that of the link. Shares make room for
/// each other: where two that are named are more than 1 together, the second counts.
fn read_parameters(scene: &mut Scene, words: &[Said], left_out: &mut Vec<String>) {
    let mut named: Vec<(&Parameter, f64, &str)> = Vec::new();
    for parameter in PARAMETERS {
        let Some(&(_, value, pair)) = words.iter().find(|said| said.0 == parameter.key) else {
            continue;
        };
        if let Err(why) = parameter.read(value).and_then(|x| parameter.set(scene, x)) {
            leave_out(left_out, &[pair], &why);
            continue;
        }
        for &(other, was, pair) in &named {
            // By more than the rounding of shares.
            if (other.get(scene) - was).abs() > 1e-6 {
                let why = format!("with {} it is more than 1", parameter.key);
                leave_out(left_out, &[pair], &why);
            }
        }
        named.push((parameter, parameter.get(scene), pair));
    }
}

/// Tells, on one line, that something was left out.
fn leave_out(left_out: &mut Vec<String>, pairs: &[&str], why: &str) {
    let Some(first) = pairs.first() else { return };
    let what = match pairs.len() - 1 {
        0 => "was".to_string(),
        more => format!("and {more} more were"),
    };
    left_out.push(format!("{} {what} left out: {why}.", shown(first)));
}

/// The plant as it was in the version that a link says; the newest one, if it says none that is known.
fn of_version(plant: &'static Plant, words: &[Said], left_out: &mut Vec<String>) -> &'static Plant {
    let Some(&(_, value, pair)) = words.iter().find(|said| said.0 == VERSION) else {
        return plant;
    };
    let newest = plant.rules as u32;
    let unknown = || format!("this plant has links up to version {newest}");
    let known = whole(value).and_then(|version| plant.under(version).ok_or_else(unknown));
    known.unwrap_or_else(|why| {
        leave_out(left_out, &[pair], &why);
        plant
    })
}

fn read_show(plant: &Plant, value: &str) -> Result<Show, String> {
    let show = Show::of_key(value).filter(|show| show.is_of(plant));
    show.ok_or_else(|| "this plant has nothing of that name to show".to_string())
}

fn read_orbit(value: &str) -> Result<Orbit, String> {
    let numbers = value.split(',').map(|n| number(n).map(|n| n as f32));
    let (azimuth_deg, elevation_deg, zoom, pan) = match numbers.collect::<Result<Vec<_>, _>>()?[..]
    {
        [azimuth, elevation, zoom] => (azimuth, elevation, zoom, Vec2::ZERO),
        [azimuth, elevation, zoom, x, y] => (azimuth, elevation, zoom, Vec2::new(x, y)),
        _ => return Err("a view has three or five numbers".to_string()),
    };
    Ok(Orbit { azimuth_deg, elevation_deg, zoom, pan }.limited())
}

/// Reads a number; in an error, why it is none.
pub fn number(text: &str) -> Result<f64, String> {
    typed::plain(text).ok_or_else(|| format!("{} is not a number", shown(text)))
}

fn switch(text: &str) -> Result<bool, String> {
    match text {
        "0" => Ok(false),
        "1" => Ok(true),
        _ => Err("it must be 0 or 1".to_string()),
    }
}

/// The number of an individual; in an error, what it must be.
pub fn individual(number: f64) -> Result<u32, String> {
    let is_whole = number.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(&number);
    is_whole.then_some(number as u32).ok_or_else(|| not_whole(f64::from(u32::MAX)))
}

fn day(text: &str) -> Result<u32, String> {
    text.parse().map_err(|_| "it must be a whole number of days".to_string())
}

fn whole(text: &str) -> Result<u32, String> {
    text.parse().map_err(|_| not_whole(f64::from(u32::MAX)))
}

/// Why something is not a whole number up to a greatest one.
pub fn not_whole(greatest: f64) -> String {
    format!("it must be a whole number from 0 to {}", greatest.shortest())
}

/// Foreign text as the page quotes it.
fn shown(text: &str) -> String {
    let quoted = quoted(text);
    format!("“{}”", quoted.get(1..quoted.len() - 1).unwrap_or_default())
}

/// Undoes the percent signs that messengers put into addresses.
pub fn decode(text: &str) -> String {
    let bytes = text.as_bytes();
    let mut plain = Vec::with_capacity(bytes.len());
    let mut k = 0;
    while k < bytes.len() {
        let digits = bytes.get(k + 1..k + 3).and_then(|d| std::str::from_utf8(d).ok());
        match digits.and_then(|d| u8::from_str_radix(d, 16).ok()) {
            Some(byte) if bytes[k] == b'%' => {
                plain.push(byte);
                k += 3;
            }
            _ => {
                plain.push(bytes[k]);
                k += 1;
            }
        }
    }
    String::from_utf8_lossy(&plain).into_owned()
}

#[cfg(test)]
mod tests;
