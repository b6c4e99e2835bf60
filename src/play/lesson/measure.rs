//! What is measured of a plant that has grown, and what is to be expected of it.

use crate::mosaic::Pattern;
use crate::plants::Plant;
use crate::play::Scene;
use crate::play::words::grouped;
use crate::tissue::{CellType, Clock, Diary, Lineage, clans};

/// A number of a day. Shares are told in 100.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Measure {
    /// All cells.
    Cells,
    /// Cells of a type.
    Count(CellType),
    /// The same, of all cells.
    Share(CellType),
    /// The area of a type, of the whole.
    Area(CellType),
    /// Sets of cells of a type that hang together.
    Patches(CellType),
    /// Cells of the largest patch of a type, of all of that type.
    Largest(CellType),
    /// Pairs of neighbours that are of unlike type, of all pairs.
    Mixed,
    /// Clones that began with a child of another type than its mother.
    Spots,
    /// Those of one cell, of all of them.
    SingleSpots,
    /// Clans, each of them all that descends from one first cell.
    Clans,
    /// Cells of the largest clan, of all cells.
    LargestClan,
}

/// Where a growth is to end, as 95 in 100 do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Usual {
    pub mean: f64,
    pub ends: [f64; 2],
}

/// Standard deviations to each side of the mean that hold 95 of 100 growths.
const DEVIATIONS: f64 = 1.96;

impl Measure {
    /// What may stand behind `measure:`.
    pub const KNOWN: &str = "there are cells, count F, share F, area F, patches F, largest F (and the same of B \
                             and M), mixed, spots, single spots, clans and largest clan";

    pub fn of_words(words: &str) -> Option<Measure> {
        let kind = |rest: &str| match rest {
            "F" => Some(CellType::Foreground),
            "B" => Some(CellType::Background),
            "M" => Some(CellType::Middle),
            _ => None,
        };
        match words {
            "cells" => Some(Measure::Cells),
            "mixed" => Some(Measure::Mixed),
            "spots" => Some(Measure::Spots),
            "single spots" => Some(Measure::SingleSpots),
            "clans" => Some(Measure::Clans),
            "largest clan" => Some(Measure::LargestClan),
            _ => match words.split_once(' ')? {
                ("count", rest) => kind(rest).map(Measure::Count),
                ("share", rest) => kind(rest).map(Measure::Share),
                ("area", rest) => kind(rest).map(Measure::Area),
                ("patches", rest) => kind(rest).map(Measure::Patches),
                ("largest", rest) => kind(rest).map(Measure::Largest),
                _ => None,
            },
        }
    }

    /// The words of `of_words`.
    pub fn words(self) -> String {
        let letter = |kind: CellType| ["F", "B", "M"][kind as usize];
        match self {
            Measure::Cells => "cells".into(),
            Measure::Count(kind) => format!("count {}", letter(kind)),
            Measure::Share(kind) => format!("share {}", letter(kind)),
            Measure::Area(kind) => format!("area {}", letter(kind)),
            Measure::Patches(kind) => format!("patches {}", letter(kind)),
            Measure::Largest(kind) => format!("largest {}", letter(kind)),
            Measure::Mixed => "mixed".into(),
            Measure::Spots => "spots".into(),
            Measure::SingleSpots => "single spots".into(),
            Measure::Clans => "clans".into(),
            Measure::LargestClan => "largest clan".into(),
        }
    }

    /// What it is called on a plant.
    pub fn name(self, plant: &Plant) -> String {
        let colour = |kind: CellType| plant.colour_names[kind as usize];
        match self {
            Measure::Cells => "all cells".into(),
            Measure::Count(kind) => format!("{} cells", colour(kind)),
            Measure::Share(kind) => format!("{} cells, of 100 cells", colour(kind)),
            Measure::Area(kind) => format!("{} area, of 100 parts of it", colour(kind)),
            Measure::Patches(kind) => format!("{} patches", colour(kind)),
            Measure::Largest(kind) => {
                format!("cells of the largest {0} patch, of 100 {0} cells", colour(kind))
            }
            Measure::Mixed => "unlike neighbours, of 100 pairs".into(),
            Measure::Spots => "spots that began with one changed cell".into(),
            Measure::SingleSpots => "spots of one cell, of 100 spots".into(),
            Measure::Clans => "families".into(),
            Measure::LargestClan => "cells of the largest family, of 100 cells".into(),
        }
    }

    /// Whether it goes from 0 to 100.
    pub fn is_share(self) -> bool {
        !matches!(
            self,
            Measure::Cells
                | Measure::Count(_)
                | Measure::Patches(_)
                | Measure::Spots
                | Measure::Clans
        )
    }

    /// A value in words: `48 in 100` or `17,831`.
    pub fn told(self, value: f64) -> String {
        match self.is_share() {
            true => format!("{} in 100", rounded(value)),
            false => rounded(value),
        }
    }

    /// Whether the lineage of the cells decides it on a plant, wherever they lie: it can be had without moving any.
    pub fn is_of_lineage(self, scene: &Scene) -> bool {
        let is_of_places = matches!(
            self,
            Measure::Area(_) | Measure::Patches(_) | Measure::Largest(_) | Measure::Mixed
        );
        !is_of_places && scene.plant.paint.is_empty()
    }

    /// Its value on a day of a diary, whose `pattern` is worked out only where it is needed.
    pub fn value(self, diary: &Diary, day: usize, pattern: impl FnOnce() -> Pattern) -> f64 {
        let count = diary.count(day);
        let living = &diary.lineage[..count.cells as usize];
        let share = |part: u32, whole: u32| 100.0 * f64::from(part) / f64::from(whole.max(1));
        match self {
            Measure::Cells => f64::from(count.cells),
            Measure::Count(kind) => f64::from(count.by_type[kind as usize]),
            Measure::Share(kind) => share(count.by_type[kind as usize], count.cells),
            Measure::Area(kind) => 100.0 * pattern().area_shares[kind as usize],
            Measure::Patches(kind) => f64::from(pattern().patches[kind as usize]),
            Measure::Largest(kind) => {
                let largest = pattern().largest_patches[kind as usize];
                share(largest, count.by_type[kind as usize])
            }
            Measure::Mixed => 100.0 * pattern().mixed_edges,
            Measure::Spots => spots(living).len() as f64,
            Measure::SingleSpots => {
                let spots = spots(living);
                let single = spots.iter().filter(|&&cells| cells == 1).count();
                share(single as u32, spots.len() as u32)
            }
            Measure::Clans => clan_cells(living).filter(|&cells| cells > 0).count() as f64,
            Measure::LargestClan => share(clan_cells(living).max().unwrap_or(0), count.cells),
        }
    }

    /// Where growths of a scene end over all its individuals, by the exact laws of its clocks; None where no law is
    /// known here, as with mutation, or where control images lie on the plant.
    pub fn usual(self, scene: &Scene) -> Option<Usual> {
        let recipe = &scene.recipe;
        let keeps = CellType::ALL.iter().all(|&t| recipe.mutation[t as usize][t as usize] == 1.0);
        if !keeps || !scene.plant.paint.is_empty() || !scene.plant.motion.unfolding_days.is_empty()
        {
            return None;
        }
        // Of each type the chance of a first cell to be of it, and its clan's mean and mean square.
        let of_types = CellType::ALL.map(|kind| {
            let days = recipe.division_days[kind as usize];
            let [mean, square] = clan(recipe.clock, days, scene.day);
            [recipe.initial_probability[kind as usize], mean, square]
        });
        let mean: f64 = of_types.iter().map(|[chance, mean, _]| chance * mean).sum();
        let first = f64::from(recipe.initial_cells);
        match self {
            Measure::Cells => {
                let square: f64 = of_types.iter().map(|[chance, _, square]| chance * square).sum();
                Some(usual(first * mean, first * (square - mean * mean)))
            }
            Measure::Count(kind) => {
                let [chance, mean, square] = of_types[kind as usize];
                let mean = chance * mean;
                Some(usual(first * mean, first * (chance * square - mean * mean)))
            }
            Measure::Share(kind) => {
                let [chance, of_kind, _] = of_types[kind as usize];
                let share = chance * of_kind / mean;
                // To the first order in what each first cell adds to the share.
                let square: f64 = CellType::ALL
                    .iter()
                    .map(|&other| {
                        let [chance, _, square] = of_types[other as usize];
                        let weight = f64::from(u8::from(other == kind)) - share;
                        chance * weight * weight * square
                    })
                    .sum();
                let variance = square / (first * mean * mean);
                let mut usual = usual(100.0 * share, 10_000.0 * variance);
                usual.ends = usual.ends.map(|end| end.clamp(0.0, 100.0));
                Some(usual)
            }
            _ => None,
        }
    }
}

fn usual(mean: f64, variance: f64) -> Usual {
    let off = DEVIATIONS * variance.sqrt();
    Usual { mean, ends: [(mean - off).max(0.0), mean + off] }
}

/// Mean and mean square of the clan of a first cell on a day.
fn clan(clock: Clock, division_days: f64, day: u32) -> [f64; 2] {
    if day == 0 {
        return [1.0, 1.0];
    }
    match clock {
        Clock::Poisson => {
            let clan = clans(division_days, day as usize - 1)[day as usize - 1];
            [clan.mean, clan.variance + clan.mean * clan.mean]
        }
        // Geometric.
        Clock::Exponential => {
            let mean = libm::exp(f64::from(day) / division_days);
            [mean, 2.0 * mean * mean - mean]
        }
    }
}

/// The cells of each clan, by the number of its first cell.
fn clan_cells(living: &[Lineage]) -> impl Iterator<Item = u32> {
    let mut clans = vec![0; living.len()];
    living.iter().for_each(|cell| clans[cell.founder as usize] += 1);
    clans.into_iter()
}

/// The cells of each spot: of what descends, without another change, from a cell of another type than its mother.
fn spots(living: &[Lineage]) -> Vec<u32> {
    const NONE: u32 = u32::MAX;
    let mut spots = Vec::new();
    let mut spot_of: Vec<u32> = Vec::with_capacity(living.len());
    for (k, cell) in living.iter().enumerate() {
        // Mothers stand before their children, and first cells have none.
        let mother = (cell.parent as usize) < k;
        let is_new = mother && living[cell.parent as usize].kind != cell.kind;
        let spot = match (mother, is_new) {
            (false, _) => NONE,
            (true, true) => {
                spots.push(0);
                spots.len() as u32 - 1
            }
            (true, false) => spot_of[cell.parent as usize],
        };
        if spot != NONE {
            spots[spot as usize] += 1;
        }
        spot_of.push(spot);
    }
    spots
}

/// In as many digits as anybody would predict.
pub(super) fn rounded(value: f64) -> String {
    let value = value.max(0.0);
    match value {
        _ if value < 9.95 && (value - value.round()).abs() > 0.049 => format!("{value:.1}"),
        _ => grouped(value.round().min(f64::from(u32::MAX)) as u32),
    }
}
