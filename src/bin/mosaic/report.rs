//! What is told about a run: a line for each day, or one JSON object.

use clonal_mosaic::tissue::{CellType, Diary};
use serde::Serialize;
use std::fmt;

/// A whole run as `--json` prints it.
#[derive(Serialize)]
pub struct Report {
    /// The plant's word in links, or nothing for a recipe on a mesh of the caller's own.
    plant: Option<&'static str>,
    individual: u32,
    /// Growing alone, without reading and writing.
    pub seconds: f64,
    pub days: Vec<DayLine>,
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
    pub fn new(plant: Option<&'static str>, individual: u32) -> Report {
        Report { plant, individual, seconds: 0.0, days: Vec::new() }
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
