//! The picture in words, for who hears the page: all of it, and after each act what that has changed. How much is
//! told when is as in PhET's core descriptions ("Screen summary" and "Context responses" there).

use super::page::ShownDay;
use super::parameters::PARAMETERS;
use super::words::{area_shares, describe, grouped, share, shares};
use super::{Run, Scene};
use crate::plants::Plant;
use crate::surface::Shortest;
use crate::tissue::DayCount;

/// So many changed numbers are named one by one.
const NAMED: usize = 2;

/// A picture at rest.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    pub scene: Scene,
    pub day: ShownDay,
    /// What is told of the clone in hand; empty without one.
    pub clone: String,
}

/// All that is to be told of a picture of a growth: `Croton, individual 7, day 12: 31,402 cells, 38% yellow, of the
/// area 32% yellow. More yellow than on day 11 (36%). 2,000 families, the largest of 61 cells.`
pub fn summary(run: &Run, now: &Moment) -> String {
    let Moment { scene, day, clone } = now;
    let mut told = describe(scene, scene.individual, day, scene.show) + ".";
    let before = day.day.checked_sub(1).and_then(|before| Some((before, run.facts(before)?)));
    if let Some((number, before)) = before {
        let than = format!("on day {number}");
        let compared = compared(scene.plant, before.count, day.facts.count, &than);
        told += &format!(" {}.", sentence(compared));
    }
    if !scene.noise {
        told += &families(run, day.facts.count.cells);
    }
    if !clone.is_empty() {
        told += &format!(" {clone}");
    }
    told
}

/// What an act has changed in the picture: `Day 12: 31,402 cells, 38% yellow, of the area 32% yellow; more yellow than
/// on day 11 (36%).`
pub fn change(before: &Moment, now: &Moment) -> String {
    let (was, is) = (&before.scene, &now.scene);
    let plant = is.plant;
    let mut acts = Vec::new();
    if is.individual != was.individual {
        acts.push(format!("individual {}", is.individual));
    }
    if is.noise != was.noise {
        let kinds = ["clones in the place of Perlin noise", "Perlin noise in the place of clones"];
        acts.push(kinds[usize::from(is.noise)].to_string());
    }
    let changed: Vec<_> = PARAMETERS.iter().filter(|p| p.get(was) != p.get(is)).collect();
    match changed.len() {
        0..=NAMED => acts.extend(changed.iter().map(|p| {
            let [from, to] = [was, is].map(|scene| p.said(p.get(scene)));
            format!("{} from {from} to {to}", p.label(plant))
        })),
        many => acts.push(format!("{many} numbers changed")),
    }
    let mut sentences = Vec::new();
    if now.day == before.day {
        sentences.extend((!acts.is_empty()).then(|| sentence(acts.join(", "))));
    } else {
        acts.push(format!("day {}", now.day.day));
        let than = match is.grows_like(was) {
            true => format!("on day {}", before.day.day),
            false => "before".to_string(),
        };
        let facts = &now.day.facts;
        sentences.push(format!(
            "{}: {} {}, {}, of the area {}; {}",
            sentence(acts.join(", ")),
            grouped(facts.count.cells),
            if facts.count.cells == 1 { "cell" } else { "cells" },
            shares(plant, facts.count),
            area_shares(plant, facts),
            compared(plant, before.day.facts.count, facts.count, &than)
        ));
    }
    if is.show != was.show {
        sentences.push(format!("Seen now: {}", is.show.name()));
    }
    if now.clone != before.clone {
        let told = now.clone.trim_end_matches('.');
        sentences.push(if told.is_empty() { "No clone in hand" } else { told }.to_string());
    }
    if sentences.is_empty() {
        let orbit = is.orbit.rounded();
        sentences.push(format!(
            "Seen from {} degrees around and {} above, zoom {}",
            orbit.azimuth_deg.shortest(),
            orbit.elevation_deg.shortest(),
            orbit.zoom.shortest()
        ));
    }
    sentences.join(". ") + "."
}

/// Whether there is more of the colour of F cells than there was: `more yellow than on day 11 (36%)`.
fn compared(plant: &Plant, before: DayCount, now: DayCount, than: &str) -> String {
    let colour = plant.colour_names[0];
    let [was, is] = [before, now].map(|count| share(count.by_type[0], count.cells));
    let [was_part, is_part] =
        [before, now].map(|c| f64::from(c.by_type[0]) / f64::from(c.cells.max(1)));
    match () {
        () if was == is => format!("as much {colour} as {than}"),
        () if is_part > was_part => format!("more {colour} than {than} ({was})"),
        () => format!("less {colour} than {than} ({was})"),
    }
}

/// How many clans the cells are of, and how large the largest one is.
fn families(run: &Run, cells: u32) -> String {
    let founders = run.pedigree.founders();
    let mut sizes = vec![0; run.pedigree.clans() as usize];
    for &founder in founders.iter().take(cells as usize) {
        sizes[founder as usize] += 1;
    }
    match sizes.iter().max() {
        Some(&1) => " Each is a first cell.".to_string(),
        Some(&largest) => {
            let clans = grouped(run.pedigree.clans());
            format!(" {clans} families, the largest of {} cells.", grouped(largest))
        }
        None => String::new(),
    }
}

/// With a large first letter.
fn sentence(mut text: String) -> String {
    if let Some(first) = text.get_mut(..1) {
        first.make_ascii_uppercase();
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants;
    use crate::play::{DayFacts, link};

    fn moment(link: &str, cells: u32, yellow: u32) -> Moment {
        let scene = link::read(link, plants::all()).scene;
        let count = DayCount { cells, by_type: [yellow, cells - yellow, 0] };
        let facts = DayFacts { count, areas: [3200, 6800, 0], fingerprint: String::new() };
        let day = ShownDay { day: scene.day, moment: 1.0, facts };
        Moment { scene, day, clone: String::new() }
    }

    #[test]
    fn an_act_is_told_by_what_it_changed() {
        let before = moment("croton?v=1&s=7&d=11", 1000, 360);
        for (link, cells, yellow, told) in [
            (
                "croton?v=1&s=7&d=12",
                1200,
                456,
                "Day 12: 1,200 cells, 38% yellow, of the area 32% yellow; more yellow than on day 11 (36%).",
            ),
            (
                "croton?v=1&s=8&d=11",
                1001,
                300,
                "Individual 8, day 11: 1,001 cells, 30% yellow, of the area 32% yellow; less yellow than before (36%).",
            ),
            (
                "croton?v=1&s=7&d=11&pf=0.4",
                1001,
                361,
                "First cells that are yellow from 0.19 share to 0.4 share, day 11: 1,001 cells, 36% yellow, of the area 32% \
                 yellow; as much yellow as before.",
            ),
            (
                "croton?v=1&s=7&d=11&pf=0.4&df=9&db=9",
                1,
                1,
                "3 numbers changed, day 11: 1 cell, 100% yellow, of the area 32% yellow; more yellow than before \
                 (36%).",
            ),
            ("croton?v=1&s=7&d=11&show=clans", 1000, 360, "Seen now: Family map."),
            (
                "croton?v=1&s=7&d=11&view=40,12,1.5",
                1000,
                360,
                "Seen from 40 degrees around and 12 above, zoom 1.5.",
            ),
        ] {
            assert_eq!(change(&before, &moment(link, cells, yellow)), told);
        }
    }

    #[test]
    fn a_clone_is_told_when_it_is_taken_and_when_it_is_let_go() {
        let bare = moment("croton?v=1&s=7&d=11", 1000, 360);
        let held = Moment { clone: "Clone of cell 8. Yellow.".to_string(), ..bare.clone() };
        assert_eq!(change(&bare, &held), "Clone of cell 8. Yellow.");
        assert_eq!(change(&held, &bare), "No clone in hand.");
    }
}
