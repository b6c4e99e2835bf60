//! The diary of a growth: who was born of whom, and where everybody stood on each day.

use super::{CellType, name_of};
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
        let cells = self.days[day].places.iter().zip(&self.lineage);
        name_of(cells.flat_map(|(place, cell)| {
            [
                u64::from(place.triangle) << 8 | cell.kind as u64,
                u64::from(place.b1.to_bits()) << 32 | u64::from(place.b2.to_bits()),
            ]
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cells_of_a_day_are_counted_by_their_types() {
        let cell = |kind| Lineage { parent: 0, founder: 0, born_day: 0, kind };
        let kinds = [CellType::Middle, CellType::Background, CellType::Middle];
        let day = |cells| Day { places: vec![Place::default(); cells], repulsive_radius: 1.0 };
        let diary = Diary { lineage: kinds.map(cell).to_vec(), days: vec![day(2), day(3)] };
        assert_eq!(diary.count(0), DayCount { cells: 2, by_type: [0, 1, 1] });
        assert_eq!(diary.count(1), DayCount { cells: 3, by_type: [0, 1, 2] });
    }

    #[test]
    fn a_fingerprint_is_made_of_all_bits_of_all_cells_of_its_day() {
        let places = [
            Place { triangle: 5, b1: 0.125, b2: 0.75 },
            Place { triangle: 700_000, b1: -0.0, b2: f32::MIN_POSITIVE },
        ];
        let cell = |parent, kind| Lineage { parent, founder: 0, born_day: parent, kind };
        let lineage = vec![cell(0, CellType::Background), cell(0, CellType::Middle)];
        let day = |places: &[Place]| Day { places: places.to_vec(), repulsive_radius: 1.0 };
        let diary = Diary { lineage, days: vec![day(&places[..1]), day(&places)] };
        // Written down a second time: the words as numbers, and what SplitMix64 makes of them.
        let words: [u128; 4] = [
            5 * 256 + CellType::Background as u128,
            0x3e00_0000 * (1 << 32) + 0x3f40_0000,
            700_000 * 256 + CellType::Middle as u128,
            0x8000_0000 * (1 << 32) + 0x0080_0000,
        ];
        let splitmix = |state: u128| {
            let mut z = (state as u64).wrapping_add(0x9e37_79b9_7f4a_7c15);
            z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            u128::from(z ^ (z >> 31))
        };
        let expected = |words: &[u128]| {
            let turned = |hash: u128| hash * 32 % (1 << 64) + hash * 32 / (1 << 64);
            let hash = splitmix(words.iter().fold(0, |hash, word| splitmix(turned(hash) ^ word)));
            let digits: Vec<char> = "0123456789abcdefghjkmnpqrstvwxyz".chars().collect();
            let places = [59, 54, 49, 44, 39, 34].map(|shift| hash / (1 << shift) % 32);
            places.iter().map(|&digit| digits[digit as usize]).collect::<String>()
        };
        assert_eq!(diary.fingerprint(0), expected(&words[..2]));
        assert_eq!(diary.fingerprint(1), expected(&words));
    }
}
