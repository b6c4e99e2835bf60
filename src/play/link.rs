//! Links: a scene written as the fragment of an address, `croton?v=1&s=17&d=12&df=6`, and read back.
//!
//! First the plant, then the version, the individual and the day, and then only what differs from the
//! preset that the plant had in that version.

use super::camera::Orbit;
use super::parameters::{PARAMETERS, Parameter};
use super::scene::{FIRST_INDIVIDUAL, Scene};
use crate::plants::{Plant, Show};
use glam::Vec2;
use std::fmt::Write;

/// The version that is written. A version's presets are frozen: to change one, raise this number and
/// keep the old preset for the links of the old version.
pub const VERSION: u32 = 1;

/// The word for the number of the individual.
pub const INDIVIDUAL: &str = "s";

/// A link that was read: what could be loaded, and in plain words what was left out and why.
#[derive(Clone, Debug)]
pub struct Opened {
    pub scene: Scene,
    pub left_out: Vec<String>,
}

/// Writes a scene, without the `#`.
pub fn write(scene: &Scene) -> String {
    let Scene { plant, individual, day, .. } = scene;
    let mut link = format!("{}?v={VERSION}&{INDIVIDUAL}={individual}&d={day}", plant.key);
    let preset = Scene::preset(plant, *individual);
    for parameter in PARAMETERS {
        let value = parameter.get(scene);
        if value != parameter.get(&preset) {
            let _ = write!(link, "&{}={value}", parameter.key);
        }
    }
    if scene.noise {
        link.push_str("&noise=1");
    }
    if scene.show != preset.show {
        let _ = write!(link, "&show={}", scene.show.key());
    }
    let orbit = scene.orbit.rounded();
    if orbit != preset.orbit.rounded() {
        let Orbit { azimuth_deg, elevation_deg, zoom, pan } = orbit;
        let _ = write!(link, "&view={azimuth_deg},{elevation_deg},{zoom}");
        if pan != Vec2::ZERO {
            let _ = write!(link, ",{},{}", pan.x, pan.y);
        }
    }
    link
}

/// Reads a link with or without its `#`: what is unknown or cannot be is left out and told, the rest
/// is loaded. `plants` is the catalogue, its first plant the one that stands in.
pub fn read(text: &str, plants: &'static [Plant]) -> Opened {
    let text = decode(text.trim().trim_start_matches('#'));
    let (name, query) = text.split_once('?').unwrap_or((&text, ""));
    let mut left_out = Vec::new();
    let plant = plants.iter().find(|p| p.key == name).unwrap_or_else(|| {
        if !name.is_empty() {
            left_out.push(format!(
                "There is no plant called “{}” here: the {} stands in its place.",
                shortened(name),
                plants[0].name.to_ascii_lowercase()
            ));
        }
        &plants[0]
    });
    let mut scene = Scene::preset(plant, FIRST_INDIVIDUAL);
    let mut wished_day = None;
    let mut seen: Vec<&str> = Vec::new();
    for pair in query.split('&').map(|p| p.trim_start_matches("amp;")).filter(|p| !p.is_empty()) {
        let (key, value) = pair.split_once('=').unwrap_or((pair, ""));
        let result = if seen.contains(&key) {
            Err("it stands twice, and the first counts".to_string())
        } else {
            match key {
                "v" => check_version(value),
                INDIVIDUAL => whole(value).map(|n| scene.individual = n),
                "d" => day(value).map(|n| wished_day = Some(n)),
                "noise" => switch(value).map(|on| scene.noise = on),
                "show" => read_show(plant, value).map(|show| scene.show = show),
                "view" => read_orbit(value).map(|orbit| scene.orbit = orbit),
                _ => read_parameter(&mut scene, key, value),
            }
        };
        seen.push(key);
        if let Err(why) = result {
            left_out.push(format!("“{}” was left out: {why}.", shortened(pair)));
        }
    }
    // The last day may have come after the wished one.
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

fn check_version(value: &str) -> Result<(), String> {
    let version = whole(value)?;
    match version == VERSION {
        true => Ok(()),
        false => Err(format!("this playground reads links of version {VERSION}")),
    }
}

fn read_parameter(scene: &mut Scene, key: &str, value: &str) -> Result<(), String> {
    let Some(parameter) = Parameter::of_key(key) else {
        return Err("this playground does not know it".to_string());
    };
    parameter.set(scene, number(value)?)
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

fn number(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(x) if x.is_finite() => Ok(x),
        _ => Err(format!("“{}” is not a number", shortened(text))),
    }
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
    is_whole.then_some(number as u32).ok_or_else(not_whole)
}

fn day(text: &str) -> Result<u32, String> {
    text.parse().map_err(|_| "it must be a whole number of days".to_string())
}

fn whole(text: &str) -> Result<u32, String> {
    text.parse().map_err(|_| not_whole())
}

fn not_whole() -> String {
    format!("it must be a whole number from 0 to {}", u32::MAX)
}

/// Foreign text in our messages is kept to a glance.
fn shortened(text: &str) -> String {
    match text.char_indices().nth(40) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_string(),
    }
}

/// Undoes the percent signs that messengers put into addresses.
fn decode(text: &str) -> String {
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
mod tests {
    use super::*;
    use crate::play::testing::PLANTS;
    use crate::tissue::Clock;

    fn open(text: &str) -> Opened {
        read(text, PLANTS)
    }

    #[test]
    fn an_empty_link_is_the_first_plant() {
        for text in ["", "#", "#leaf", "#leaf?"] {
            let opened = open(text);
            assert!(opened.left_out.is_empty());
            assert_eq!(write(&opened.scene), "leaf?v=1&s=1&d=3");
        }
    }

    #[test]
    fn a_link_holds_what_differs_and_nothing_else() {
        let link = "leaf?v=1&s=0&d=2&df=6&ff=0.35&noise=1&view=30,20,1.5";
        let opened = open(link);
        assert_eq!(opened.left_out, [""; 0]);
        assert_eq!(opened.scene.individual, 0);
        assert_eq!(opened.scene.recipe.division_days[0], 6.0);
        assert_eq!(opened.scene.recipe.adhesion[0][0], 0.35);
        assert!(opened.scene.noise);
        assert_eq!(write(&opened.scene), link);
    }

    #[test]
    fn every_parameter_comes_back() {
        for parameter in PARAMETERS {
            let mut scene = Scene::preset(&PLANTS[0], 9);
            let [least, greatest] = parameter.range;
            let value = match parameter.names {
                [] => least + 0.25 * (greatest - least),
                _ => greatest,
            };
            parameter.set(&mut scene, value).expect(parameter.key);
            let opened = open(&write(&scene));
            assert_eq!(opened.left_out, [""; 0], "{}", parameter.key);
            assert!(opened.scene == scene, "{}", write(&scene));
            assert_eq!(opened.scene.recipe, scene.recipe);
        }
    }

    #[test]
    fn three_types_come_back_together() {
        let link = "leaf?v=1&s=3&d=3&pf=0.3&pm=0.6&dm=7&ck=1&fm=0.4&mfb=0.1&mfm=0.2&mmf=0.05&mmb=0.95\
                    &an=0.5";
        let opened = open(link);
        assert_eq!(opened.left_out, [""; 0]);
        assert_eq!(write(&opened.scene), link);
        let recipe = &opened.scene.recipe;
        assert_eq!((recipe.clock, recipe.anisotropy), (Clock::Exponential, 0.5));
        assert_eq!(recipe.adhesion[2][0], 0.4);
        assert_eq!(recipe.mutation[0][1..], [0.1, 0.2]);
        assert_eq!(recipe.mutation[2][..2], [0.05, 0.95]);
        assert_eq!(recipe.initial_probability[2], 0.6);
        let told = open("fruit?v=1&pm=0.2&an=0.5&ck=0.5").left_out;
        assert_eq!(
            told,
            [
                "“pm=0.2” was left out: this plant has no use for it.",
                "“an=0.5” was left out: this plant has no use for it.",
                "“ck=0.5” was left out: it must be a whole number.",
            ]
        );
    }

    #[test]
    fn what_is_shown_comes_back_where_the_plant_has_it() {
        for plant in crate::plants::all() {
            for show in Show::offered(plant) {
                let scene = Scene { show, ..Scene::preset(plant, 2) };
                let link = write(&scene);
                assert_eq!(link.contains("show="), show != Show::Cells, "{link}");
                let opened = read(&link, crate::plants::all());
                assert_eq!((opened.scene.show, opened.left_out), (show, Vec::new()), "{link}");
            }
        }
        for pair in ["show=field-x", "show=bones", "show="] {
            let opened = read(&format!("croton?v=1&{pair}"), crate::plants::all());
            assert_eq!(opened.scene.show, Show::Cells);
            let told = "was left out: this plant has nothing of that name to show.";
            assert_eq!(opened.left_out, [format!("“{pair}” {told}")]);
        }
    }

    #[test]
    fn bad_links_load_what_they_can() {
        let opened = open("#leaf?v=1&s=17&d=99&df=0.2&zz=3&db=abc&bb=0.9&s=4&view=1,2");
        assert_eq!(opened.scene.individual, 17);
        assert_eq!(opened.scene.day, opened.scene.recipe.days);
        assert_eq!(opened.scene.recipe.adhesion[1][1], 0.9);
        let told = opened.left_out.join("\n");
        for part in [
            "“df=0.2” was left out: it must be from 1.5 to 200 days.",
            "“zz=3” was left out: this playground does not know it.",
            "“db=abc” was left out: “abc” is not a number.",
            "“s=4” was left out: it stands twice",
            "“view=1,2” was left out: a view has three or five numbers.",
            "Day 99 is past the last one: day 6 is shown in its place.",
        ] {
            assert!(told.contains(part), "{part} is not in\n{told}");
        }
        assert_eq!(opened.left_out.len(), 6);
    }

    #[test]
    fn foreign_links_are_told_and_replaced() {
        let opened = open("#section-2?utm=x");
        assert_eq!(opened.scene.plant.key, "leaf");
        assert_eq!(opened.left_out.len(), 2);
        assert!(opened.left_out[0].contains("the leaf stands in"));
        assert_eq!(open("#leaf?v=7").left_out.len(), 1);
        // Never a panic, whatever comes.
        for text in ["#%", "#%zz?%f", "#?&&==&", "#leaf?s=-1&d=1e9&n=NaN&view=,,", "#…?…=…"] {
            open(text);
        }
    }

    #[test]
    fn messengers_may_mangle() {
        let opened = open("#leaf%3Fv=1&amp;s=5&view=30%2C20%2C2");
        assert_eq!(opened.left_out, [""; 0]);
        assert_eq!(opened.scene.individual, 5);
        assert_eq!(opened.scene.orbit.zoom, 2.0);
    }

    #[test]
    fn preset_individual_and_day_stay_short() {
        for plant in PLANTS.iter().chain(crate::plants::all()) {
            assert!(write(&Scene::preset(plant, u32::MAX)).len() < 100);
        }
    }
}
