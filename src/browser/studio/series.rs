//! Several plants side by side: a dialog that asks for them, and under their pictures, which the page grows, what
//! they come to.

use super::charts::table_of;
use super::files::save;
use super::{pictures, subject, with};
use crate::browser::dom::{Listener, document, find, offer, on, set_flag, set_text, within};
use crate::export::{Chart, Grown, nursery, steps};
use crate::plants;
use crate::play::atlas::{Axis, rounded, values_between};
use crate::play::parameters::{PARAMETERS, Parameter};
use crate::play::series::MOST_PICTURES;
use crate::play::typed::plain;
use crate::play::{Scene, link};
use crate::tissue::DayCount;
use js_sys::Uint8Array;
use wasm_bindgen::prelude::*;
use web_sys::{Element, Event, HtmlDialogElement, HtmlInputElement, HtmlSelectElement};

/// Where the fields of the one number and of the other are.
const AXES: [&str; 2] = ["", ".and "];

pub struct Series {
    dialog: HtmlDialogElement,
    /// What is told under the pictures, if something is.
    chart: Option<Chart>,
    _listeners: Vec<Listener>,
}

impl Series {
    pub fn new() -> Series {
        let dialog: HtmlDialogElement = find("series-dialog");
        let mut listeners = vec![on(&dialog, "click", |event: Event| {
            if let Some(view) = attribute_of_target(&event, "data-grow") {
                with(|studio| studio.series.grow(&view));
            }
        })];
        listeners.extend(AXES.map(|of| {
            let number: HtmlSelectElement = within(&dialog, &format!("{of}.number"));
            on(&number, "change", move |_: Event| with(|studio| studio.series.propose(of)))
        }));
        let sources: Element = within(&dialog, ".sources");
        listeners
            .push(on(&sources, "click", |_: Event| with(|studio| studio.series.dialog.close())));
        listen_to_pictures();
        Series { dialog, chart: None, _listeners: listeners }
    }

    /// Opens the dialog on what the page shows.
    pub fn open(&self) {
        let scene = subject::scene();
        let plant = scene.plant;
        let told = format!("{}, individual {}, day {}", plant.name, scene.individual, scene.day);
        set_text(&within(&self.dialog, ".subject"), &told);
        for of in AXES {
            let number: HtmlSelectElement = within(&self.dialog, &format!("{of}.number"));
            number.set_text_content(None);
            if !of.is_empty() {
                offer(&number, "", "no other one");
            }
            for parameter in PARAMETERS.iter().filter(|p| p.is_for(plant) && p.is_number()) {
                offer(&number, parameter.key, &parameter.label(plant));
            }
            self.propose(of);
        }
        self.say("");
        if !self.dialog.open() {
            let _ = self.dialog.show_modal();
        }
    }

    /// Proposes steps from half of a number to its double, as far as its range goes.
    fn propose(&self, of: &str) {
        let number = Parameter::of_key(&self.chosen(&format!("{of}.number")));
        if !of.is_empty() {
            set_flag(&within(&self.dialog, ".and .ends"), "hidden", number.is_none());
            set_text(
                &within(&self.dialog, "[data-grow=steps]"),
                if number.is_some() { "Grow the map" } else { "Grow the steps" },
            );
        }
        let Some(parameter) = number else { return };
        let now = parameter.get(&subject::scene());
        let [least, greatest] = parameter.range;
        let ends = if now > 0.0 { [0.5 * now, 2.0 * now] } else { parameter.range };
        for (end, value) in [".from", ".to"].into_iter().zip(ends) {
            let value = rounded(parameter, value.clamp(least, greatest));
            let field: HtmlInputElement = within(&self.dialog, &format!("{of}{end}"));
            field.set_value(&value.to_string());
        }
    }

    /// Asks the page for a view of what the dialog says.
    fn grow(&self, view: &str) {
        let scene = subject::scene();
        let asked = match view {
            "nursery" => {
                let count: u32 = self.chosen(".how-many").parse().unwrap_or(12);
                Ok(individuals(&scene, count))
            }
            "steps" => self.steps_of(&scene),
            _ => self.other_than(&scene).map(|other| {
                let links = [&scene, &other].map(link::write);
                links.join("/")
            }),
        };
        match asked {
            Ok(asked) => {
                self.dialog.close();
                subject::go_to(&format!("{view}/{asked}"));
            }
            Err(why) => self.say(&why),
        }
    }

    /// The link of the scene with a number in steps, or with two of them.
    fn steps_of(&self, scene: &Scene) -> Result<String, String> {
        let mut varied = vec![self.axis(scene, "")?];
        if !self.chosen(".and .number").is_empty() {
            varied.push(self.axis(scene, ".and ")?);
        }
        let each: u32 = self.chosen(".each").parse().unwrap_or(1);
        let pictures =
            varied.iter().map(|axis| axis.values.len()).product::<usize>() * each as usize;
        if pictures > MOST_PICTURES {
            return Err(format!(
                "These are {pictures} pictures, and {MOST_PICTURES} can be grown: take fewer."
            ));
        }
        let link = individuals(scene, each);
        let (plant, query) = link.split_once('?').unwrap_or((&link, ""));
        let is_varied = |word: &str| {
            let key = word.split('=').next().unwrap_or_default();
            varied.iter().any(|axis| axis.number.key == key)
        };
        let kept: Vec<&str> = query.split('&').filter(|word| !is_varied(word)).collect();
        let mut words = kept.join("&");
        // The pictures stand in the order of the steps, and the individuals of each beside each other.
        for Axis { number, values } in &varied {
            let values: Vec<String> = values.iter().map(f64::to_string).collect();
            words += &format!("&{}={}", number.key, values.join(","));
        }
        Ok(format!("{plant}?{words}"))
    }

    /// What the fields for a number say.
    fn axis(&self, scene: &Scene, of: &str) -> Result<Axis, String> {
        let number = Parameter::of_key(&self.chosen(&format!("{of}.number")));
        let number = number.ok_or("No number is chosen.")?;
        let name = number.label(scene.plant);
        let end = |part: &str| {
            let typed = within::<HtmlInputElement>(&self.dialog, &format!("{of}{part}")).value();
            plain(&typed.trim().replace(',', ".")).ok_or_else(|| {
                format!("{name}: “{}” is no number.", typed.chars().take(20).collect::<String>())
            })
        };
        let [from, to] = [end(".from")?, end(".to")?];
        let count = self.chosen(&format!("{of}.count")).parse().unwrap_or(5);
        let values = values_between(number, from, to, count);
        for &value in &values {
            let mut changed = scene.clone();
            number.set(&mut changed, value).map_err(|why| format!("{name} {value}: {why}."))?;
        }
        if values.len() < 2 {
            return Err(format!("{name}: there is nothing between {from} and {to}."));
        }
        Ok(Axis { number, values })
    }

    /// The scene to compare with.
    fn other_than(&self, scene: &Scene) -> Result<Scene, String> {
        let mut other = scene.clone();
        match &*self.chosen(".other") {
            "preset" => {
                let preset = Scene::preset(scene.plant, scene.individual);
                other =
                    Scene { day: scene.day.min(preset.recipe.days), orbit: scene.orbit, ..preset };
                if other == *scene {
                    return Err("This plant is its preset: change a number first.".to_string());
                }
            }
            "before" => {
                let before = subject::before();
                other = before.ok_or("Nothing was changed yet: change a number first.")?;
            }
            "individual" => other.individual = scene.individual.wrapping_add(1),
            "noise" => other.noise = !scene.noise,
            _ => {
                let typed = within::<HtmlInputElement>(&self.dialog, ".link").value();
                let fragment = typed.split_once('#').map_or(&*typed, |(_, link)| link);
                let opened = link::read(fragment, plants::all());
                if fragment.trim().is_empty() || !opened.left_out.is_empty() {
                    let why = opened.left_out.join(" ");
                    return Err(format!("That is no link of the playground. {why}"));
                }
                other = opened.scene;
            }
        }
        Ok(other)
    }

    fn chosen(&self, select: &str) -> String {
        within::<HtmlSelectElement>(&self.dialog, select).value()
    }

    fn say(&self, text: &str) {
        set_text(&within(&self.dialog, ".refusal"), text);
    }

    /// Tells what the pictures of a nursery or of steps come to.
    pub fn sum_up(&mut self) {
        let root = document().document_element().expect("a document has a root");
        let view = root.get_attribute("data-view").unwrap_or_default();
        if ["nursery", "steps", "compare"].contains(&&*view) {
            pictures::dress(&view);
        }
        let sum = match &*view {
            "nursery" => nursery,
            "steps" => steps,
            _ => return,
        };
        let list: Element = find("figure-list");
        let grown: Vec<Grown> = pictures().into_iter().map(|(grown, _)| grown).collect();
        // Those that have not come so far will.
        let newest = grown.iter().map(|grown| grown.scene.day).max();
        let grown: Vec<Grown> =
            grown.into_iter().filter(|grown| Some(grown.scene.day) == newest).collect();
        let Some((chart, told)) = sum(&grown) else { return };
        let summary = list.query_selector(".summary").ok().flatten().unwrap_or_else(|| {
            let html = "<figure class=\"chart summary\"><p class=told role=status></p><div class=plot></div>\
                        <div class=row><button type=button data-end=csv>CSV</button>\
                        <button type=button data-end=svg>SVG</button>\
                        <details><summary>Table</summary><table></table></details></div></figure>";
            let row: Element = within(&list, ".days");
            let _ = row.insert_adjacent_html("afterend", html);
            let summary: Element = within(&list, ".summary");
            std::mem::forget(on(&summary, "click", |event: Event| {
                if let Some(end) = attribute_of_target(&event, "data-end") {
                    with(|studio| studio.series.save(&end));
                }
            }));
            summary
        });
        set_text(&within(&summary, ".told"), &told);
        within::<Element>(&summary, ".plot").set_inner_html(&chart.to_svg(None));
        within::<Element>(&summary, "table").set_inner_html(&table_of(&chart));
        self.chart = Some(chart);
    }

    fn save(&self, end: &str) {
        if let Some(chart) = &self.chart {
            let content = if end == "csv" { chart.to_csv() } else { chart.to_svg(None) };
            save(&format!("{}.{end}", chart.title), &Uint8Array::from(content.as_bytes()));
        }
    }
}

/// The link of so many individuals of a scene, from its own on.
fn individuals(scene: &Scene, count: u32) -> String {
    let first = scene.individual.min(u32::MAX - (count - 1));
    let link = link::write(&Scene { individual: first, cell: None, ..scene.clone() });
    let last = first + count - 1;
    let range = if last > first { format!("s={first}..{last}") } else { format!("s={first}") };
    link.replacen(&format!("s={first}"), &range, 1)
}

/// What the pictures of the page show, each with its label.
pub fn pictures() -> Vec<(Grown, String)> {
    let all = find::<Element>("figure-list").query_selector_all(".picture[data-count]").ok();
    let all = all.into_iter().flat_map(|all| (0..all.length()).map(move |k| all.item(k)));
    let pictures = all.flatten().filter_map(|picture| {
        let picture: Element = picture.unchecked_into();
        let label = within::<Element>(&picture, ".label").text_content().unwrap_or_default();
        Some((grown(&picture)?, label))
    });
    pictures.collect()
}

/// What a picture of the page shows, by its link and its counts.
fn grown(picture: &Element) -> Option<Grown> {
    let address = picture.get_attribute("href")?;
    let count = picture.get_attribute("data-count")?;
    let counts: Vec<u32> = count.split(' ').filter_map(|n| n.parse().ok()).collect();
    let [day, cells, f, b, m] = counts[..] else { return None };
    let mut scene = link::read(subject::link_of(&address), plants::all()).scene;
    scene.day = day;
    Some(Grown { scene, count: DayCount { cells, by_type: [f, b, m] } })
}

/// Sums up again whenever a picture shows another day.
fn listen_to_pictures() {
    let list: Element = find("figure-list");
    subject::on_attribute(&list, "data-count", || with(|studio| studio.series.sum_up()));
}

fn attribute_of_target(event: &Event, name: &str) -> Option<String> {
    let target = event.target()?.dyn_into::<Element>().ok()?;
    target.get_attribute(name)
}
