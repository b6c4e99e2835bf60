//! What is told about a run: a line for each day, or one JSON object.

use super::subject::Subject;
use clonal_mosaic::surface::NO_TWIN;
use clonal_mosaic::tissue::{CellType, Diary};
use serde::Serialize;
use std::fmt;

/// A whole run as `--json` prints it.
#[derive(Serialize)]
pub struct Report {
    /// The plant's word in links, or nothing for a recipe on a mesh of the caller's own.
    plant: Option<&'static str>,
    individual: u32,
    pub body: BodyLine,
    /// Growing alone, without reading and writing.
    pub seconds: f64,
    pub days: Vec<DayLine>,
}

/// The surface that the cells grow on, and how it was read.
#[derive(Serialize)]
pub struct BodyLine {
    triangles: usize,
    /// Parts that no edge joins.
    parts: usize,
    /// Edges with a triangle on one side alone.
    rim_edges: usize,
    area_cm2: f32,
    /// What a unit of the file is: 100 for GLB, which is in metres, else 1.
    unit_cm: f64,
    /// Pairs of rim edges that were made one because their ends are alike; 0 for the catalogue's meshes.
    joined_edges: usize,
    /// Triangles without area or that stand twice; 0 for the catalogue's meshes.
    left_out_triangles: usize,
    /// Steps of cells that were cut short among slivers.
    pub caught_walks: u64,
}

/// One day of a run.
#[derive(Serialize)]
pub struct DayLine {
    day: u32,
    cells: u32,
    #[serde(rename = "F")]
    foreground: u32,
    #[serde(rename = "B")]
    background: u32,
    #[serde(rename = "M")]
    middle: u32,
    /// Repulsive radius, in the units of the mesh.
    r: f32,
    fingerprint: String,
}

impl Report {
    pub fn new(subject: &Subject) -> Report {
        let plant = subject.plant.map(|plant| plant.key);
        let (body, individual) = (BodyLine::of(subject), subject.individual);
        Report { plant, individual, body, seconds: 0.0, days: Vec::new() }
    }

    /// The run as one JSON object on one line.
    pub fn to_json(&self) -> String {
        serde_json::to_string(self).expect("a report holds plain numbers and words") + "\n"
    }

    /// The last line of a run that is told day by day.
    pub fn summary(&self) -> String {
        let plant = self.plant.unwrap_or("the recipe");
        format!("{plant}, individual {}: {:.3} s of growing\n", self.individual, self.seconds)
    }
}

impl BodyLine {
    fn of(subject: &Subject) -> BodyLine {
        let mesh = &subject.mesh;
        BodyLine {
            triangles: mesh.triangles.len(),
            parts: mesh.part_count(),
            rim_edges: mesh.twins.iter().filter(|&&twin| twin == NO_TWIN).count(),
            area_cm2: mesh.area,
            unit_cm: subject.reading.map_or(1.0, |reading| reading.unit_cm),
            joined_edges: subject.reading.map_or(0, |reading| reading.joined_edges),
            left_out_triangles: subject.reading.map_or(0, |reading| reading.left_out_triangles),
            caught_walks: 0,
        }
    }

    /// What a caller should know who takes the file to be right.
    pub fn warnings(&self) -> impl Iterator<Item = String> {
        let told = [
            (
                self.joined_edges,
                "pair of rim edges was joined: its ends are the same",
                "pairs of rim edges were joined: the ends of each are the same",
            ),
            (
                self.left_out_triangles,
                "triangle was left out: it has no area or stands twice",
                "triangles were left out: they have no area or stand twice",
            ),
        ];
        let told = told.into_iter().filter(|(count, ..)| *count > 0);
        told.map(|(count, one, many)| number(count, one, many))
    }

    /// The same after growing.
    pub fn warning_of_growth(&self) -> Option<String> {
        let count = self.caught_walks;
        let what = "steps of cells were cut short among slivers of the mesh";
        (count > 0).then(|| format!("{count} {what}"))
    }
}

impl fmt::Display for BodyLine {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let rims = match self.rim_edges {
            0 => "closed".to_string(),
            count => number(count, "rim edge", "rim edges"),
        };
        let unit = if self.unit_cm == 1.0 { "" } else { ", read as metres" };
        writeln!(
            f,
            "body: {} in {}, {rims}, {} cm2{unit}",
            number(self.triangles, "triangle", "triangles"),
            number(self.parts, "part", "parts"),
            self.area_cm2
        )
    }
}

impl DayLine {
    /// A day that stands in the diary.
    pub fn of(diary: &Diary, day: u32) -> DayLine {
        let count = diary.count(day as usize);
        let of_type = |kind: CellType| count.by_type[kind as usize];
        DayLine {
            day,
            cells: count.cells,
            foreground: of_type(CellType::Foreground),
            background: of_type(CellType::Background),
            middle: of_type(CellType::Middle),
            r: diary.days[day as usize].repulsive_radius,
            fingerprint: diary.fingerprint(day as usize),
        }
    }
}

impl fmt::Display for DayLine {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        writeln!(
            f,
            "day {:3}  {:8} cells  F {:8}  B {:8}  M {:8}  r {:.5}  {}",
            self.day,
            self.cells,
            self.foreground,
            self.background,
            self.middle,
            self.r,
            self.fingerprint
        )
    }
}

fn number(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}
