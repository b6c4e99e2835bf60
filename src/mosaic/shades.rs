//! What tells the colour of a cell from that of others of its type.

use super::sites::MOST_TINT;
use crate::surface::Mesh;
use crate::tissue::{Control, Diary};

/// The tint of each cell of a day under control images, from 0, the own colour of its type, to `MOST_TINT`,
/// the tinted one.
pub fn tints(
    mesh: &Mesh,
    controls: &[Control],
    diary: &Diary,
    day: usize,
) -> impl Iterator<Item = u32> {
    diary.days[day].places.iter().enumerate().map(move |(cell, &place)| {
        let kind = diary.lineage[cell].kind;
        let asked = controls.iter().map(|control| control.tint(mesh, place, kind));
        tint(cell as u32, asked.fold(0.0, f32::max))
    })
}

/// The lightness of a cell among its like, from 0 to 15: always the same.
pub fn lightness(cell: u32) -> u32 {
    scatter(cell) >> 28
}

/// The tint of a cell where so much is asked for, 0 to 1: one of the two steps around it, each so often
/// that they mean what is asked for. Steps all at one place would be seen as a line.
fn tint(cell: u32, asked: f32) -> u32 {
    let chance = (scatter(cell) & 0xffff) as f32 / 65_536.0;
    (asked * MOST_TINT as f32 + chance) as u32
}

/// A number that belongs to the cell (the finaliser of MurmurHash3, Appleby 2011).
fn scatter(cell: u32) -> u32 {
    let mut bits = cell.wrapping_mul(0x9e37_79b1).wrapping_add(0x7f4a_7c15);
    bits = (bits ^ (bits >> 16)).wrapping_mul(0x85eb_ca6b);
    bits = (bits ^ (bits >> 13)).wrapping_mul(0xc2b2_ae35);
    bits ^ (bits >> 16)
}
