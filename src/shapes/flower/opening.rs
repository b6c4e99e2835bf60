//! From one sheet to another, cell by cell: what a cell of the control mesh is turned by is passed at an even
//! angle, what it is stretched by in a straight line, and the cells are joined again as well as they fit
//! (least squares) above their foot.

use super::solve::Cholesky;
use super::template::{COLUMNS, ROWS};
use glam::{DMat3, DQuat, DVec3};

/// The way of a sheet from the bud to the open flower.
#[derive(Clone, Debug)]
pub struct Opening {
    pub bud: Vec<DVec3>,
    pub open: Vec<DVec3>,
    cells: Vec<Cell>,
}

/// A quad of the control mesh: what it looks like to itself at both ends, and how it turns between them.
#[derive(Clone, Debug)]
struct Cell {
    /// From its own directions in the bud to those of space.
    frame: DQuat,
    pub axis: DVec3,
    pub angle: f64,
    /// Its four edges, in its own directions.
    bud: [DVec3; 4],
    open: [DVec3; 4],
}

/// The corners of a cell and the edges between them, by their places.
const CORNERS: [usize; 4] = [0, 1, COLUMNS, COLUMNS + 1];
const EDGES: [[usize; 2]; 4] = [[0, 1], [2, 3], [0, 2], [1, 3]];

fn cells() -> impl Iterator<Item = [usize; 4]> {
    let first = (0..ROWS - 1).flat_map(|row| (0..COLUMNS - 1).map(move |c| row * COLUMNS + c));
    first.map(|first| CORNERS.map(|corner| first + corner))
}

/// The factors of the sums of squares of all sheets: they are joined in the same way.
pub fn joints() -> Cholesky {
    let free = (ROWS - 1) * COLUMNS;
    let mut sums = vec![0.0; free * free];
    for corners in cells() {
        for edge in EDGES {
            let ends = edge.map(|end| corners[end].checked_sub(COLUMNS));
            for (a, b) in [(0, 1), (1, 0)] {
                let Some(row) = ends[a] else { continue };
                sums[row * free + row] += 1.0;
                if let Some(column) = ends[b] {
                    sums[row * free + column] -= 1.0;
                }
            }
        }
    }
    Cholesky::new(free, sums)
}

impl Opening {
    pub fn new(bud: Vec<DVec3>, open: Vec<DVec3>) -> Opening {
        let mut all: Vec<Cell> = Vec::new();
        let mut turns: Vec<DQuat> = Vec::new();
        for (k, corners) in cells().enumerate() {
            let below = k.checked_sub(COLUMNS - 1);
            let before = below.or(k.checked_sub(1)).map_or(DQuat::IDENTITY, |cell| turns[cell]);
            let last = all.last().map_or(DQuat::IDENTITY, |cell| cell.frame);
            let from = frame(&bud, corners).unwrap_or(last);
            let to = frame(&open, corners).unwrap_or(before * from);
            // A turn and one full circle less are the same: a cell goes the way of the one below.
            let mut turn = to * from.inverse();
            if turn.dot(before) < 0.0 {
                turn = -turn;
            }
            let (axis, angle) = turn.to_axis_angle();
            let edges = |sheet: &[DVec3], frame: DQuat| {
                EDGES.map(|[a, b]| frame.inverse() * (sheet[corners[b]] - sheet[corners[a]]))
            };
            all.push(Cell {
                frame: from,
                axis,
                angle,
                bud: edges(&bud, from),
                open: edges(&open, to),
            });
            turns.push(turn);
        }
        Opening { bud, open, cells: all }
    }

    /// The sheet where its rows, from foot to tip, have opened by these shares: 0 is the bud, 1 the open sheet.
    pub fn at(&self, joints: &Cholesky, opened: &[f64; ROWS]) -> Vec<DVec3> {
        if opened.iter().all(|&share| share == 0.0) {
            return self.bud.clone();
        }
        if opened.iter().all(|&share| share == 1.0) {
            return self.open.clone();
        }
        let mut sheet: Vec<DVec3> =
            (0..COLUMNS).map(|k| self.bud[k].lerp(self.open[k], opened[0])).collect();
        let mut sums = vec![DVec3::ZERO; (ROWS - 1) * COLUMNS];
        for (k, (cell, corners)) in self.cells.iter().zip(cells()).enumerate() {
            let row = k / (COLUMNS - 1);
            let share = (opened[row] + opened[row + 1]) / 2.0;
            let frame = DQuat::from_axis_angle(cell.axis, cell.angle * share) * cell.frame;
            for (edge, [a, b]) in EDGES.into_iter().enumerate() {
                let way = frame * cell.bud[edge].lerp(cell.open[edge], share);
                for (end, other, way) in [(a, b, -way), (b, a, way)] {
                    let Some(place) = corners[end].checked_sub(COLUMNS) else { continue };
                    sums[place] += way;
                    if corners[other] < COLUMNS {
                        sums[place] += sheet[corners[other]];
                    }
                }
            }
        }
        joints.solve(&mut sums);
        sheet.extend(sums);
        sheet
    }

    /// Radians that a cell turns by from the bud to the open sheet, from the foot on.
    #[cfg(test)]
    pub fn angles(&self) -> impl Iterator<Item = f64> {
        self.cells.iter().map(|cell| cell.angle)
    }
}

/// The directions of a cell: along its mean edge to the tip, and across; none if it has no area.
fn frame(sheet: &[DVec3], corners: [usize; 4]) -> Option<DQuat> {
    let [a, b, c, d] = corners.map(|corner| sheet[corner]);
    let along = (c - a + d - b).try_normalize()?;
    let normal = (b - a + d - c).cross(along).try_normalize()?;
    Some(DQuat::from_mat3(&DMat3::from_cols(along.cross(normal), along, normal)))
}
