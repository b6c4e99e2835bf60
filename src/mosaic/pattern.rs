//! What a day's pattern looks like, in a few numbers.

use super::{Piece, polygons};
use crate::surface::{Charts, Mesh};
use crate::tissue::{CellType, DayCount, Diary};
use std::borrow::Cow;

/// A day's pattern in numbers. Arrays are indexed by `CellType`.
#[derive(Clone, Debug, PartialEq)]
pub struct Pattern {
    pub count: DayCount,
    /// Share of the whole surface that is in the polygons of each type, 0 to 1. A part without
    /// cells belongs to none.
    pub area_shares: [f64; 3],
    /// Patches of each type: sets of its cells that hang together by neighbours.
    pub patches: [u32; 3],
    /// Cells of the largest patch of each type.
    pub largest_patches: [u32; 3],
    /// Share of the whole surface of the patch of each type that covers most, 0 to 1.
    pub largest_areas: [f64; 3],
    /// Share of the pairs of neighbours that are of unlike type, 0 to 1; 0 where nobody has one.
    pub mixed_edges: f64,
}

impl Pattern {
    /// The pattern of a day that stands in the diary of a growth on `mesh`, whose charts these are; if it
    /// moves, that is as it was made, and other charts are made of the day's.
    pub fn of(mesh: &Mesh, charts: &mut Charts, diary: &Diary, day: usize) -> Pattern {
        let places = &diary.days[day].places;
        let mesh = mesh.on(day as u32);
        let pieces = match &mesh {
            Cow::Borrowed(still) => polygons(still, charts, places),
            Cow::Owned(moved) => polygons(moved, &mut Charts::new(moved), places),
        };
        let kind = |cell: u32| diary.lineage[cell as usize].kind;
        let pairs = neighbours(&pieces);
        let mixed = pairs.iter().filter(|&&[a, b]| kind(a) != kind(b)).count();
        let areas = areas(&pieces, places.len());
        let whole = f64::from(mesh.area);
        let patches = patches(&pairs, &areas, kind);
        Pattern {
            count: diary.count(day),
            area_shares: area_shares(&mesh, &pieces, kind),
            patches: patches.map(|patches| patches.count),
            largest_patches: patches.map(|patches| patches.most_cells),
            largest_areas: patches.map(|patches| patches.largest_area / whole),
            mixed_edges: mixed as f64 / pairs.len().max(1) as f64,
        }
    }

    /// Share of the cells that are of each type, 0 to 1.
    pub fn count_shares(&self) -> [f64; 3] {
        self.count.by_type.map(|cells| f64::from(cells) / f64::from(self.count.cells))
    }
}

/// The pairs of cells whose polygons share a border somewhere on the surface, the lower number
/// first, each pair once and in order: the edges of the Delaunay graph of the cells.
pub fn neighbours(pieces: &[Piece]) -> Vec<[u32; 2]> {
    let borders = pieces
        .iter()
        .flat_map(|piece| piece.across.iter().filter_map(|side| Some((piece.cell, side.cell()?))));
    let mut pairs: Vec<[u32; 2]> =
        // Where the surface bends much a cell may meet itself.
        borders.filter(|(a, b)| a != b).map(|(a, b)| [a.min(b), a.max(b)]).collect();
    pairs.sort_unstable();
    pairs.dedup();
    pairs
}

fn area_shares(mesh: &Mesh, pieces: &[Piece], kind: impl Fn(u32) -> CellType) -> [f64; 3] {
    let mut areas = [0.0; 3];
    for piece in pieces {
        areas[kind(piece.cell) as usize] += f64::from(piece.area());
    }
    areas.map(|area| area / f64::from(mesh.area))
}

/// The area of each cell's polygons.
fn areas(pieces: &[Piece], cells: usize) -> Vec<f64> {
    let mut areas = vec![0.0; cells];
    for piece in pieces {
        areas[piece.cell as usize] += f64::from(piece.area());
    }
    areas
}

/// The patches of a type: how many, the cells of that with most, and the area of that which covers most.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Patches {
    count: u32,
    most_cells: u32,
    largest_area: f64,
}

/// Joins neighbours of like type until only patches are left. There are as many cells as areas.
fn patches(pairs: &[[u32; 2]], areas: &[f64], kind: impl Fn(u32) -> CellType) -> [Patches; 3] {
    // Each cell points to one of its patch, at last to the one that stands for it.
    let mut towards: Vec<u32> = (0..areas.len() as u32).collect();
    for &[a, b] in pairs.iter().filter(|&&[a, b]| kind(a) == kind(b)) {
        let [a, b] = [a, b].map(|cell| follow(&mut towards, cell));
        towards[a.max(b) as usize] = a.min(b);
    }
    let mut of_types = [Patches::default(); 3];
    let mut members = vec![(0, 0.0); areas.len()];
    for cell in 0..areas.len() as u32 {
        let stands = follow(&mut towards, cell);
        let patches = &mut of_types[kind(cell) as usize];
        let (cells, area) = &mut members[stands as usize];
        *cells += 1;
        *area += areas[cell as usize];
        patches.count += u32::from(stands == cell);
        patches.most_cells = patches.most_cells.max(*cells);
        patches.largest_area = patches.largest_area.max(*area);
    }
    of_types
}

/// The cell that stands for a cell's patch; ways that were gone are shortened by half.
fn follow(towards: &mut [u32], mut cell: u32) -> u32 {
    while towards[cell as usize] != cell {
        let next = towards[cell as usize] as usize;
        towards[cell as usize] = towards[next];
        cell = towards[cell as usize];
    }
    cell
}
