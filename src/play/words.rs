//! What the page says of a picture, in words.

use super::figures;
use super::page::ShownDay;
use super::parameters::{PARAMETERS, widen};
use super::run::{DayFacts, Run};
use super::scene::Scene;
use crate::plants::{Plant, Show};
use crate::surface::Shortest;
use crate::tissue::{DayCount, Recipe};
use std::fmt::Write;

/// `Croton, individual 7, day 12: 31,402 cells, 38% yellow, of the area 32% yellow`; then whether the
/// colours are noise, and what is seen in place of the cells: `, Perlin noise. Control images`.
pub fn describe(scene: &Scene, individual: u32, day: &ShownDay, show: Show) -> String {
    let Scene { plant, noise, .. } = scene;
    let count = day.facts.count;
    format!(
        "{}, individual {individual}, day {}: {} {}, {}, of the area {}{}{}",
        plant.name,
        day.day,
        grouped(count.cells),
        if count.cells == 1 { "cell" } else { "cells" },
        shares(plant, count),
        area_shares(plant, &day.facts),
        if *noise { ", Perlin noise" } else { "" },
        if show == Show::Cells { String::new() } else { format!(". {}", show.name()) }
    )
}

/// The whole of `DayFacts::areas`.
const WHOLE_AREA: u32 = 10_000;

/// How many cells are of the colours that the others stand before: `38% yellow`, or where there is a
/// third, `38% yellow, 5% red`.
pub fn shares(plant: &Plant, count: DayCount) -> String {
    parts(plant, count.by_type, count.cells)
}

/// The same of the area, which says something else where cells are of unlike size.
pub fn area_shares(plant: &Plant, facts: &DayFacts) -> String {
    parts(plant, facts.areas, WHOLE_AREA)
}

fn parts(plant: &Plant, by_type: [u32; 3], whole: u32) -> String {
    let [f, _, m] = plant.colour_names;
    let part = |kind: usize, name| format!("{} {name}", share(by_type[kind], whole));
    if m.is_empty() { part(0, f) } else { format!("{}, {}", part(0, f), part(2, m)) }
}

/// A share in percent, never rounded to none or all when it is not: `38%`, `under 1%`.
pub fn share(part: u32, whole: u32) -> String {
    let percent = (f64::from(part) / f64::from(whole.max(1)) * 100.0).round() as u32;
    match percent {
        0 if part > 0 => "under 1%".to_string(),
        100 if part < whole => "over 99%".to_string(),
        _ => format!("{percent}%"),
    }
}

/// A whole number in groups of three: `31,402`.
pub fn grouped(number: u32) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (k, digit) in digits.chars().enumerate() {
        if k > 0 && (digits.len() - k).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// The numbers of some recipes of a plant, by name and with the symbols of the thesis (Table 4.1); where
/// they differ, all values.
pub fn numbers(plant: &Plant, recipes: &[Recipe]) -> String {
    let values = |value: &dyn Fn(&Recipe) -> f64| values(recipes, value);
    let [f, b, _] = plant.colour_names;
    format!(
        "First cells {}, share of {f} among them p_F {} · days between divisions D_F {} ({f}), D_B {} \
         ({b}) · adhesion α_FF {} ({f}), α_BB {} ({b}) · reach of the push ω_r {}",
        values(&|r| f64::from(r.initial_cells)),
        values(&|r| r.initial_probability[0]),
        values(&|r| r.division_days[0]),
        values(&|r| r.division_days[1]),
        values(&|r| widen(r.adhesion[0][0])),
        values(&|r| widen(r.adhesion[1][1])),
        values(&|r| widen(r.radius_scale)),
    )
}

/// A number of several recipes, each value once: `6 / 8 / 20`.
fn values(recipes: &[Recipe], value: &dyn Fn(&Recipe) -> f64) -> String {
    let mut text = String::new();
    let mut last = f64::NAN;
    for now in recipes.iter().map(value) {
        if now != last {
            let gap = if text.is_empty() { "" } else { " / " };
            let _ = write!(text, "{gap}{}", now.shortest());
        }
        last = now;
    }
    text
}

/// Where the recipe of a scene comes from: `Thesis, Fig. 4.15`, or `after Fig. 4.15, 1 change` where
/// numbers of it are not those of the preset, nor of any picture of the thesis.
pub fn source(scene: &Scene) -> String {
    let own = scene.plant.source;
    let preset = Scene::preset(scene.plant, scene.individual);
    let changed = PARAMETERS.iter().filter(|p| p.get(scene) != p.get(&preset)).count();
    match changed + usize::from(scene.noise) {
        0 => own.to_string(),
        changes => match figures::showing(scene) {
            Some(figure) => format!("Thesis, Fig. {figure}"),
            None => {
                let own = own.strip_prefix("after ").unwrap_or(own);
                let figure = own.strip_prefix("Thesis, ").filter(|f| f.starts_with("Fig."));
                let changes = if changes == 1 { "1 change" } else { &format!("{changes} changes") };
                format!("after {}, {changes}", figure.unwrap_or(own))
            }
        },
    }
}

/// Why no clone is in hand.
pub fn no_such_cell(cells: u32) -> String {
    format!(
        "The cell of the link is not born here: there are {} cells, and no clone is in hand.",
        grouped(cells)
    )
}

/// Why there is no plant to see.
pub fn no_mesh(plant: &Plant, why: &str) -> String {
    let name = plant.name.to_ascii_lowercase();
    format!("The shape of the {name} could not be loaded ({why}). Choose a day to try again.")
}

/// Why there are no plants in a row of figures.
pub fn no_plants(why: &str) -> String {
    format!("The plants of this row could not be loaded ({why}). Choose a day to try again.")
}

/// Why something does not grow. That memory ran out is the likeliest reason for which a worker ends.
pub const TOO_LARGE: &str = "This seems to need more memory than this browser gives.";

/// The same, where something else is shown than was wished.
pub const TOO_LARGE_SO_BACK: &str = "That seems to need more memory than this browser gives: back to \
                                     what there was room for.";

/// Why a growth ended early.
pub fn full(run: &Run) -> String {
    format!(
        "Growth ended on day {}: one day more would bring more than {} cells. Each plant has a limit of \
         its own, above what its preset needs, so that no change fills the memory.",
        run.last_day(),
        grouped(run.scene.recipe.max_cells)
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants;
    use crate::play::link;

    #[test]
    fn numbers_read_well() {
        let grouped = [0, 999, 1000, 31_402, 2_000_000].map(grouped);
        assert_eq!(grouped, ["0", "999", "1,000", "31,402", "2,000,000"]);
        let shares = [(0, 10), (1, 1000), (38, 100), (999, 1000), (5, 5)].map(|(a, b)| share(a, b));
        assert_eq!(shares, ["0%", "under 1%", "38%", "over 99%", "100%"]);
    }

    fn scene(link: &str) -> Scene {
        link::read(link, plants::all()).scene
    }

    #[test]
    fn a_changed_recipe_is_only_after_its_figure() {
        for (link, expected) in [
            ("mushroom?v=1&s=9&d=3", "Thesis, Fig. 4.15"),
            ("mushroom?v=1&s=1&d=20&df=7", "after Fig. 4.15, 1 change"),
            ("mushroom?v=1&s=1&d=20&df=7&bo=0.5", "after Fig. 4.15, 2 changes"),
            // Other pictures of the thesis are what they are, on any day and from any side.
            ("mushroom?v=1&s=1&d=3&df=20&view=9,9,1", "Thesis, Fig. 4.15"),
            ("cactus?v=1&s=1&d=25&ff=0.7", "Thesis, Fig. 4.9"),
            ("croton?v=1&s=1&d=30&noise=1", "Thesis, Fig. 4.5"),
            ("cactus?v=1&s=1&d=25&noise=1", "after Fig. 4.8, 1 change"),
            ("red-croton?v=1&s=1&d=30&pf=0.5", "after Thesis, 3.2.1.2, 1 change"),
        ] {
            assert_eq!(source(&scene(link)), expected, "{link}");
        }
    }

    #[test]
    fn numbers_of_a_row_are_those_of_all_its_pictures() {
        let figure = figures::find("4.15").unwrap();
        let scenes = figure.pictures.iter().map(|picture| scene(picture.link));
        let recipes: Vec<Recipe> = scenes.map(|scene| scene.recipe).collect();
        let numbers = numbers(plants::find("mushroom").unwrap(), &recipes);
        for part in
            ["First cells 6000,", "p_F 0.9 ·", "D_F 6 / 8 / 20 (red), D_B 8 (white)", "ω_r 3"]
        {
            assert!(numbers.contains(part), "{part}: {numbers}");
        }
    }
}
