//! The charts of a growth: how its numbers go with the days, and how large its clans are on one of them.

use super::chart::{Band, Chart, Line};
use super::days::DayNumbers;
use crate::plants::{Look, Plant};
use crate::tissue::{CLAN_STEPS, CellType};

/// Standard deviations to each side of the mean that hold 95 of 100 growths.
pub(super) const DEVIATIONS: f64 = 1.96;

/// The charts over the days of a growth of a plant, in the colours of a look: its cells against the exact
/// expectation, the shares of its types by number and by area, its patches, and the largest of them.
pub fn the_course(plant: &Plant, look: &Look, days: &[DayNumbers]) -> Vec<Chart> {
    let places: Vec<String> = days.iter().map(|day| day.day.to_string()).collect();
    let chart = |title: String, lines: Vec<Line>, is_share: bool| Chart {
        title,
        along: "day",
        places: places.clone(),
        lines,
        band: None,
        is_share,
        foot: 0.0,
    };
    let told: Vec<CellType> = [CellType::Foreground, CellType::Middle]
        .into_iter()
        .filter(|&kind| !plant.colour_names[kind as usize].is_empty())
        .collect();
    let line =
        |kind: CellType, how: &str, is_dashed: bool, value: &dyn Fn(&DayNumbers) -> f64| Line {
            name: [plant.colour_names[kind as usize], how].join(" ").trim_end().to_string(),
            colour: colour(look, kind),
            is_dashed,
            is_dots: false,
            values: days.iter().map(value).collect(),
        };
    let of_each = |how: &str, value: &dyn Fn(&DayNumbers, usize) -> f64| -> Vec<Line> {
        told.iter().map(|&kind| line(kind, how, false, &|day| value(day, kind as usize))).collect()
    };

    let shares = told.iter().flat_map(|&kind| {
        let k = kind as usize;
        [
            line(kind, "by number", false, &|day| day.pattern.count_shares()[k]),
            line(kind, "by area", true, &|day| day.pattern.area_shares[k]),
        ]
    });
    let largest = |day: &DayNumbers, k: usize| {
        let Some(cells) = day.pattern.count.by_type.get(k).filter(|&&cells| cells > 0) else {
            return f64::NAN;
        };
        f64::from(day.pattern.largest_patches[k]) / f64::from(*cells)
    };
    vec![
        Chart { band: band(days), ..chart("Cells".into(), cells(days), false) },
        chart("Shares of the colours".into(), shares.collect(), true),
        chart("Patches".into(), of_each("", &|day, k| f64::from(day.pattern.patches[k])), false),
        chart("The largest patch, of all cells of its colour".into(), of_each("", &largest), true),
    ]
}

/// The chart of one day's clans by their sizes, against the exact law where it is known.
pub fn sizes_of_clans(day: &DayNumbers) -> Chart {
    let places = (0..CLAN_STEPS).map(|step| match step {
        0 => "1".into(),
        1 => "2".into(),
        _ if step == CLAN_STEPS - 1 => format!("over {}", 1 << (step - 1)),
        _ => format!("{}–{}", (1 << (step - 1)) + 1, 1 << step),
    });
    let clans: u32 = day.clans.iter().sum();
    let share = |clans_of_step: f64| clans_of_step / f64::from(clans.max(1));
    let mut lines = vec![Line {
        name: "of all clans".into(),
        colour: "currentColor".into(),
        is_dashed: false,
        is_dots: false,
        values: day.clans.map(|clans| share(f64::from(clans))).to_vec(),
    }];
    if let Some(expected) = day.expected_clans {
        let values = expected.map(share).to_vec();
        lines.push(Line {
            name: "exact law".into(),
            colour: EXPECTED.into(),
            is_dashed: true,
            is_dots: false,
            values,
        });
    }
    Chart {
        title: format!("Sizes of the clans on day {}", day.day),
        along: "cells",
        places: places.collect(),
        lines,
        band: None,
        is_share: true,
        foot: 0.0,
    }
}

/// The colour of what is to be expected.
pub(super) const EXPECTED: &str = "#b4530f";

fn cells(days: &[DayNumbers]) -> Vec<Line> {
    let all = days.iter().map(|day| f64::from(day.pattern.count.cells));
    let mut lines = vec![Line {
        name: "all".into(),
        colour: "currentColor".into(),
        is_dashed: false,
        is_dots: false,
        values: all.collect(),
    }];
    let expected: Vec<f64> =
        days.iter().map(|day| day.expected.map_or(f64::NAN, |expected| expected.mean)).collect();
    if expected.iter().any(|value| value.is_finite()) {
        lines.push(Line {
            name: "expected".into(),
            colour: EXPECTED.into(),
            is_dashed: true,
            is_dots: false,
            values: expected,
        });
    }
    lines
}

/// Where 95 of 100 growths end.
fn band(days: &[DayNumbers]) -> Option<Band> {
    let ends: Vec<[f64; 2]> = days
        .iter()
        .map(|day| match day.expected {
            Some(expected) => {
                let off = DEVIATIONS * expected.variance.sqrt();
                [expected.mean - off, expected.mean + off]
            }
            None => [f64::NAN; 2],
        })
        .collect();
    let is_known = ends.iter().any(|ends| ends[0].is_finite());
    is_known.then(|| Band { name: "95 in 100 individuals".into(), ends })
}

pub(super) fn colour(look: &Look, kind: CellType) -> String {
    let [r, g, b] = look.cells[kind as usize].map(|part| (part * 255.0).round() as u8);
    format!("#{r:02x}{g:02x}{b:02x}")
}
