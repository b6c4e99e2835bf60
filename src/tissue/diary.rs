//! The diary of a growth: who was born of whom, and where everybody stood on each day.

use super::CellType;
use crate::surface::Place;

/// What never changes about a cell. Cells are numbered in the order of their birth, so the cells
/// of a day are the first ones of the list.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Lineage {
    /// The cell that it was born of; a first cell is its own parent.
    pub parent: u32,
    /// The first cell that it descends from.
    pub founder: u32,
    /// Day on which it was first there.
    pub born_day: u32,
    pub kind: CellType,
}

/// One day: the place of each cell, by its number, and the repulsive radius.
#[derive(Clone, Debug, PartialEq)]
pub struct Day {
    pub places: Vec<Place>,
    /// Repulsive radius at the end of the day, in centimetres.
    pub repulsive_radius: f32,
}

/// All days that have grown so far; day 0 is the state after the initial relaxations.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Diary {
    pub lineage: Vec<Lineage>,
    pub days: Vec<Day>,
}

/// How many cells of each type a day has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DayCount {
    pub cells: u32,
    /// By `CellType`.
    pub by_type: [u32; 3],
}

impl Diary {
    /// Population of a day that has grown.
    pub fn count(&self, day: usize) -> DayCount {
        let cells = self.days[day].places.len();
        let mut by_type = [0; 3];
        for cell in &self.lineage[..cells] {
            by_type[cell.kind as usize] += 1;
        }
        DayCount { cells: cells as u32, by_type }
    }

    /// Six letters and digits that two pictures share only if their cells are the same, bit for
    /// bit: 30 bits of a hash over type and place of every cell, in Crockford's base 32.
    pub fn fingerprint(&self, day: usize) -> String {
        let mut hash = super::chance::Hash::new();
        for (place, cell) in self.days[day].places.iter().zip(&self.lineage) {
            hash.add(u64::from(place.triangle) << 8 | cell.kind as u64);
            hash.add(u64::from(place.b1.to_bits()) << 32 | u64::from(place.b2.to_bits()));
        }
        let bits = hash.finish();
        const DIGITS: &[u8; 32] = b"0123456789abcdefghjkmnpqrstvwxyz";
        (0..6).map(|k| DIGITS[(bits >> (59 - 5 * k)) as usize & 31] as char).collect()
    }
}
