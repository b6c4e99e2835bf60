//! The numbers of petals.

use super::template::nearest;
use crate::shapes::ShapeError;
use crate::shapes::wrong::within;
use serde::{Deserialize, Serialize};

/// Points of a line that is drawn by hand, in centimetres; 2 to 12 of them. It is smoothed.
pub type Drawn = Vec<[f64; 2]>;

/// Petals in numbers.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct PetalNumbers {
    pub arrangement: Arrangement,
    /// Where the first one stands, seen from above the flower; -360 to 360.
    pub first_deg: f64,
    /// Of the flat petal, from its foot to its tip: left edge, primary vein and right edge, to the right and up.
    pub left_cm: Drawn,
    pub vein_cm: Drawn,
    pub right_cm: Drawn,
    /// What is lifted off the table. At foot and tip nothing is, where no stroke says so.
    pub cross: Vec<CrossStroke>,
    /// Height of the waves of the rim; 0 to 3.
    pub wave_cm: f64,
    /// How many there are from foot to tip; 0 to 4.
    pub waves: f64,
    /// The primary vein in the bud, outwards from the flower's axis and up along it.
    pub bud_cm: Drawn,
    /// The same of the open flower; only the form counts: it is made as long as the flat petal's vein.
    pub open_cm: Drawn,
    /// How far round the bud each half of a petal reaches; 1 to 175.
    pub bud_deg: f64,
    /// Up to which share of its length an open petal is bent round the axis as in the bud; 0 to 1.
    pub throat: f64,
    /// How much farther out the right rim lies than the left one, as a share of the bud: each petal covers its
    /// neighbour (a contorted bud); -0.3 to 0.3.
    pub lean: f64,
    /// How much smaller the bud of the innermost petals is; 0 to 0.9.
    pub nest: f64,
    /// Width and length of the innermost petals, as shares of those of the outermost; 0.1 to 5.
    pub inner_width: f64,
    pub inner_length: f64,
    /// How much farther out than the innermost the outermost ones lean in the open flower; -180 to 180.
    pub outer_turn_deg: f64,
    /// How much later the innermost open, as a share of the opening; 0 to 0.9.
    pub inner_lag: f64,
    /// How much later the tip of each opens than its foot; 0 to 0.9.
    pub tip_lag: f64,
    /// Quads across where a petal is the widest, in each half, and along; 1 to 40 and 2 to 200.
    pub columns: u32,
    pub rows: u32,
}

/// Where petals stand, the outermost first.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Arrangement {
    /// So many in each circle, even, and each circle in the gaps of the last; 60 together at most.
    Whorls(Vec<u32>),
    /// Each so many degrees from the last, 1 to 359; 137.507764 is the golden angle. 1 to 60 of them.
    Spiral { count: u32, divergence_deg: f64 },
}

/// A line across a petal that lifts its nearest row.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct CrossStroke {
    /// How far along the petal, 0 to 1.
    pub at: f64,
    /// From the left rim, -1, over the vein, 0, to the right one, 1: how high, in centimetres, up from the inner side.
    pub lift_cm: Drawn,
}

impl Default for PetalNumbers {
    /// A golden lily's.
    fn default() -> PetalNumbers {
        let edge = [
            [0.28, 0.0],
            [0.36, 1.6],
            [0.9, 4.0],
            [1.8, 6.6],
            [1.6, 9.2],
            [0.6, 10.6],
            [0.0, 11.2],
        ];
        let to_vein = [[-1.0, 0.35], [-0.5, 0.3], [0.0, 0.0], [0.5, 0.3], [1.0, 0.35]];
        PetalNumbers {
            arrangement: Arrangement::Whorls(vec![3, 3]),
            first_deg: 30.0,
            left_cm: edge.map(|[x, y]| [-x, y]).to_vec(),
            vein_cm: vec![[0.0, 0.0], [0.0, 11.2]],
            right_cm: edge.to_vec(),
            cross: vec![CrossStroke { at: 0.5, lift_cm: to_vein.to_vec() }],
            wave_cm: 0.25,
            waves: 2.0,
            bud_cm: vec![[0.6, 0.0], [0.7, 1.6], [0.95, 3.8], [0.9, 5.8], [0.55, 7.6], [0.05, 8.6]],
            open_cm: vec![
                [0.6, 0.0],
                [0.7, 1.6],
                [1.5, 4.0],
                [3.4, 6.2],
                [5.8, 6.9],
                [7.6, 6.0],
                [8.0, 4.5],
            ],
            bud_deg: 61.0,
            throat: 0.35,
            lean: 0.06,
            nest: 0.25,
            inner_width: 1.15,
            inner_length: 0.97,
            outer_turn_deg: 10.0,
            inner_lag: 0.1,
            tip_lag: 0.2,
            columns: 2,
            rows: 10,
        }
    }
}

impl PetalNumbers {
    pub(super) fn check(&self, of: &str) -> Result<(), ShapeError> {
        self.arrangement.check(of)?;
        for (name, value, range) in [
            ("first_deg", self.first_deg, -360.0..=360.0),
            ("wave_cm", self.wave_cm, 0.0..=3.0),
            ("waves", self.waves, 0.0..=4.0),
            ("bud_deg", self.bud_deg, 1.0..=175.0),
            ("throat", self.throat, 0.0..=1.0),
            ("lean", self.lean, -0.3..=0.3),
            ("nest", self.nest, 0.0..=0.9),
            ("inner_width", self.inner_width, 0.1..=5.0),
            ("inner_length", self.inner_length, 0.1..=5.0),
            ("outer_turn_deg", self.outer_turn_deg, -180.0..=180.0),
            ("inner_lag", self.inner_lag, 0.0..=0.9),
            ("tip_lag", self.tip_lag, 0.0..=0.9),
            ("columns", f64::from(self.columns), 1.0..=40.0),
            ("rows", f64::from(self.rows), 2.0..=200.0),
        ] {
            within(&format!("{of}.{name}"), value, &range)?;
        }
        for (name, line) in [
            ("left_cm", &self.left_cm),
            ("vein_cm", &self.vein_cm),
            ("right_cm", &self.right_cm),
            ("bud_cm", &self.bud_cm),
            ("open_cm", &self.open_cm),
        ] {
            check_line(&format!("{of}.{name}"), line)?;
        }
        for (name, line) in [("bud_cm", &self.bud_cm), ("open_cm", &self.open_cm)] {
            if line.iter().any(|point| point[0] < 0.0) {
                return Err(ShapeError(format!(
                    "{of}.{name} has a point beyond the axis of the flower: its first numbers must be 0 or more"
                )));
            }
        }
        if self.vein_cm[self.vein_cm.len() - 1][1] < 0.1 {
            return Err(ShapeError(format!(
                "{of}.vein_cm must end at least 0.1 cm above the foot"
            )));
        }
        for (k, stroke) in self.cross.iter().enumerate() {
            if self.cross[..k].iter().any(|other| nearest(other.at) == nearest(stroke.at)) {
                return Err(ShapeError(format!(
                    "{of}.cross has two strokes at {}: they must be further apart",
                    stroke.at
                )));
            }
            within(&format!("{of}.cross.at"), stroke.at, &(0.0..=1.0))?;
            check_line(&format!("{of}.cross.lift_cm"), &stroke.lift_cm)?;
            if stroke.lift_cm.windows(2).any(|pair| pair[0][0] >= pair[1][0]) {
                return Err(ShapeError(format!("{of}.cross.lift_cm must go from left to right")));
            }
        }
        Ok(())
    }
}

/// Refuses lines of too few or too many points, points far away, and lines without length.
pub(super) fn check_line(name: &str, line: &[[f64; 2]]) -> Result<(), ShapeError> {
    if !(2..=12).contains(&line.len()) {
        let count = line.len();
        return Err(ShapeError(format!("{name} has {count} points: it must have from 2 to 12")));
    }
    for &number in line.iter().flatten() {
        within(&format!("a number in {name}"), number, &(-100.0..=100.0))?;
    }
    if line.iter().all(|&point| point == line[0]) {
        return Err(ShapeError(format!("{name} goes nowhere: its points are all one")));
    }
    Ok(())
}
