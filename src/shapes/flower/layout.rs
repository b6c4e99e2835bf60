//! The quads of a petal: in rows from foot to tip, so many in each as it is wide there.

use super::bspline::Weights;
use super::template::{COLUMNS, ROWS};
use glam::{DVec2, DVec3};

/// Where the corners of a petal's quads lie on its sheet.
#[derive(Clone, Debug)]
pub struct Layout {
    /// Leaf coordinates: -1 to 1 across, 0 to 1 from foot to tip.
    pub corners: Vec<DVec2>,
    /// Counter-clockwise seen from the inner side.
    pub faces: Vec<Vec<u32>>,
    weights: Vec<[Weights; 2]>,
}

impl Layout {
    /// `rows` of quads, and two triangles that meet in the tip. `slenderness` is the width of the petal, in lengths, at a share of its length; `columns` are those of a half
    /// where it is the widest.
    pub fn new(rows: u32, columns: u32, slenderness: impl Fn(f64) -> f64) -> Layout {
        let mut layout = Layout { corners: Vec::new(), faces: Vec::new(), weights: Vec::new() };
        let places = row_places(rows, &slenderness);
        // Of both halves the row before, from the vein to the rim.
        let mut below: [Vec<u32>; 2] = Default::default();
        for (row, &along) in places.iter().enumerate() {
            let is_tip = row + 1 == places.len();
            let step = (places[(row + 1).min(places.len() - 1)] - places[row.saturating_sub(1)])
                / if row == 0 || is_tip { 1.0 } else { 2.0 };
            let quads = slenderness(along) / 2.0 / step;
            let count = ((quads - 0.1).ceil() as u32).clamp(1, columns) * u32::from(!is_tip);
            let vein = layout.corner(0.0, along);
            for (half, side) in [-1.0, 1.0].into_iter().enumerate() {
                let outward = (1..=count).map(|c| side * f64::from(c) / f64::from(count));
                let above: Vec<u32> =
                    [vein].into_iter().chain(outward.map(|x| layout.corner(x, along))).collect();
                if row > 0 {
                    layout.strip(&below[half], &above, half == 0);
                }
                below[half] = above;
            }
        }
        layout
    }

    fn corner(&mut self, x: f64, along: f64) -> u32 {
        self.corners.push(DVec2::new(x, along));
        self.weights.push([Weights::at(COLUMNS, (x + 1.0) / 2.0), Weights::at(ROWS, along)]);
        self.corners.len() as u32 - 1
    }

    /// Polygons between two lines that run outwards from the vein: as many as the shorter one has steps.
    fn strip(&mut self, below: &[u32], above: &[u32], is_left: bool) {
        let steps = (below.len() - 1).min(above.len() - 1).max(1);
        let piece = |line: &[u32], step: usize| {
            let start = |step: usize| (2 * step * (line.len() - 1) + steps) / (2 * steps);
            line[start(step)..=start(step + 1)].to_vec()
        };
        for step in 0..steps {
            let mut face = piece(below, step);
            face.extend(piece(above, step).into_iter().rev());
            if is_left {
                face.reverse();
            }
            self.faces.push(face);
        }
    }

    /// The corners on a sheet by its control points.
    pub fn on(&self, sheet: Vec<DVec3>) -> impl Iterator<Item = DVec3> {
        self.weights.iter().map(move |[across, along]| {
            along.sum(|row| across.sum(|column| sheet[row * COLUMNS + column]))
        })
    }
}

/// Where rows begin, from the foot, 0, to the tip, 1: closer where the petal is narrow, so that quads are nearly as long as
/// wide.
fn row_places(rows: u32, slenderness: impl Fn(f64) -> f64) -> Vec<f64> {
    const STEPS: u32 = 256;
    let middle = |step: u32| (f64::from(step) + 0.5) / f64::from(STEPS);
    let mean = (0..STEPS).map(|step| slenderness(middle(step))).sum::<f64>() / f64::from(STEPS);
    let dense = |step: u32| 1.0 / (slenderness(middle(step)) + 2.0 * mean);
    let all: f64 = (0..STEPS).map(dense).sum();
    // The last row is nearly as long as the others.
    let row = all / (f64::from(rows) + 0.9);
    let mut places = vec![0.0];
    let mut sum = 0.0;
    for step in 0..STEPS {
        let missing = row * places.len() as f64 - sum;
        if missing <= dense(step) && places.len() <= rows as usize {
            places.push((f64::from(step) + missing / dense(step)) / f64::from(STEPS));
        }
        sum += dense(step);
    }
    places.push(1.0);
    places
}
