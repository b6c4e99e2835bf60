//! What the page says of a picture, in words.

use super::page::ShownDay;
use super::run::Run;
use super::scene::Scene;
use crate::plants::{Plant, Show};
use crate::tissue::{DayCount, Recipe};

/// `Croton, individual 7, day 12: 31,402 cells, 38% yellow`; then whether the colours are noise, and
/// what is seen in place of the cells: `, Perlin noise. Control images`.
pub fn describe(scene: &Scene, individual: u32, day: &ShownDay, show: Show) -> String {
    let Scene { plant, noise, .. } = scene;
    let count = day.facts.count;
    format!(
        "{}, individual {individual}, day {}: {} {}, {}{}{}",
        plant.name,
        day.day,
        grouped(count.cells),
        if count.cells == 1 { "cell" } else { "cells" },
        shares(plant, count),
        if *noise { ", Perlin noise" } else { "" },
        if show == Show::Cells { String::new() } else { format!(". {}", show.name()) }
    )
}

/// How many cells are of the colours that the others stand before: `38% yellow`, or where there is a
/// third, `38% yellow, 5% red`.
pub fn shares(plant: &Plant, count: DayCount) -> String {
    let [f, _, m] = plant.colour_names;
    let part = |kind: usize, name| format!("{} {name}", share(count.by_type[kind], count.cells));
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

/// The numbers of a recipe in the symbols of the thesis (Table 4.1).
pub fn numbers(recipe: &Recipe) -> String {
    let [df, db, _] = recipe.division_days;
    let [ff, bb] = [0, 1].map(|kind| recipe.adhesion[kind][kind]);
    format!(
        "{} first cells · D_F {df}, D_B {db} days · α_FF {ff}, α_BB {bb} · ω_r {}",
        grouped(recipe.initial_cells),
        recipe.radius_scale
    )
}

/// Why there is no plant to see.
pub fn no_mesh(plant: &Plant, why: &str) -> String {
    let name = plant.name.to_ascii_lowercase();
    format!("The shape of the {name} could not be loaded ({why}). Choose a day to try again.")
}

/// Why something does not grow. That memory ran out is the likeliest reason for which a worker ends.
pub const TOO_LARGE: &str = "This seems to need more memory than this browser gives.";

/// The same, where something else is shown than was wished.
pub const TOO_LARGE_SO_BACK: &str = "That seems to need more memory than this browser gives: back to \
                                     what there was room for.";

/// Why a growth ended early.
pub fn full(run: &Run) -> String {
    format!(
        "Growth ended on day {}: one day more would bring more than {} cells.",
        run.last_day(),
        grouped(run.scene.recipe.max_cells)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_well() {
        let grouped = [0, 999, 1000, 31_402, 2_000_000].map(grouped);
        assert_eq!(grouped, ["0", "999", "1,000", "31,402", "2,000,000"]);
        let shares = [(0, 10), (1, 1000), (38, 100), (999, 1000), (5, 5)].map(|(a, b)| share(a, b));
        assert_eq!(shares, ["0%", "under 1%", "38%", "over 99%", "100%"]);
    }
}
