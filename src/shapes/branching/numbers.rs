//! The numbers of a tree, as they stand in a file.

use super::Ramification;
use crate::shapes::ShapeError;
use crate::shapes::leaf::LeafNumbers;
use crate::shapes::read::read;
use crate::shapes::wrong::within;
use serde::{Deserialize, Serialize};
use std::ops::RangeInclusive;

/// Lengths and widths of all laws, in centimetres.
const CM: RangeInclusive<f64> = 0.001..=1000.0;

/// A tree in numbers. What is left out of a file is as in `TreeNumbers::default`.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct TreeNumbers {
    pub matrix: Matrix,
    /// Of the root: 1 to 12, and at most that of the matrix' last row.
    pub order: u32,
    /// Between each branch of a fork and the way so far; 0 to 90.
    pub fork_deg: f64,
    /// What a side branch turns away where it is of order 1; 0 to 120. One of order i that leaves a branch of
    /// order k turns `side_deg (k - i) / (k - 1)`.
    pub side_deg: f64,
    /// What a branch turns away from a side branch of the next lower order; 0 to 90. From one of order i a
    /// branch of order k turns `main_deg i / (k - 1)`.
    pub main_deg: f64,
    /// What the plane of branching turns about the way from node to node; 0 (a flat tree) to 360.
    pub turn_deg: f64,
    /// Share by which each of these angles differs by chance, up or down; 0 to 1.
    pub angle_spread: f64,
    /// Of the edge below a node of each order, in centimetres.
    pub length: Law,
    /// Share by which each length differs by chance; 0 to 0.9.
    pub length_spread: f64,
    pub width: Width,
    /// How much each edge turns upward (or, under 0, down), as a share of its own length; -0.5 to 0.5.
    pub rise: f64,
    /// Corners around the thicker branches; 3 to 16. Those of orders 1 and 2 have two thirds of them.
    pub sides: u32,
    /// What ends bear in the place of their twigs, if they bear leaves; its triangles, underside and fine veins are
    /// left out.
    pub leaf: Option<LeafNumbers>,
    /// How many times as large as its numbers a leaf is; 0.05 to 10.
    pub leaf_size: f64,
    /// The share of the ends that bear one; 0 to 1.
    pub leaf_ends: f64,
    /// The share of the leaves, those farthest behind, that are spots of four corners; 0 to 1.
    pub leaf_spots: f64,
    /// How much leaves hang; under 0 they rise; -1 to 2.
    pub leaf_hang: f64,
}

/// A matrix by its name or by its rows.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(try_from = "serde_json::Value", untagged)]
pub enum Matrix {
    Named(String),
    Rows(Vec<Vec<f64>>),
}

/// A length by the order k.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Law {
    /// `first_cm + more_cm (k - 1)`, `more_cm` 0 to 1000.
    Linear { first_cm: f64, more_cm: f64 },
    /// `first_cm k^exponent`, exponent 0 to 4.
    Power { first_cm: f64, exponent: f64 },
    /// `first_cm factor^(k - 1)`, factor 1 to 4.
    Exponential { first_cm: f64, factor: f64 },
}

/// How thick branches are.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Width {
    ByOrder(Law),
    /// Leaves have `tip_cm`; below a node `w^exponent` is the sum of that of its children (Murray 1926:
    /// exponent 3; 2 keeps the area of all cross-sections together), 1 to 5.
    Murray {
        tip_cm: f64,
        exponent: f64,
    },
}

impl Default for TreeNumbers {
    fn default() -> TreeNumbers {
        TreeNumbers {
            matrix: Matrix::Named("increasing".into()),
            order: 7,
            // The source likes 30, 30 and 10; wider side branches make a wider crown.
            fork_deg: 30.0,
            side_deg: 45.0,
            main_deg: 10.0,
            turn_deg: 137.5,
            angle_spread: 0.2,
            length: Law::Exponential { first_cm: 2.0, factor: 1.15 },
            length_spread: 0.2,
            width: Width::Murray { tip_cm: 0.15, exponent: 2.2 },
            rise: 0.05,
            sides: 8,
            leaf: None,
            leaf_size: 0.5,
            leaf_ends: 1.0,
            leaf_spots: 0.5,
            leaf_hang: 0.4,
        }
    }
}

impl TreeNumbers {
    /// Reads numbers from a JSON object, and checks them.
    ///
    /// # Errors
    /// A text that is none, a name that is unknown, and what `check` refuses.
    pub fn from_json(text: &str) -> Result<TreeNumbers, ShapeError> {
        let numbers: TreeNumbers = read(text)?;
        numbers.check()?;
        Ok(numbers)
    }

    /// Says which number is out of its range.
    pub fn check(&self) -> Result<(), ShapeError> {
        if !(1..=super::ramification::MOST_ORDER).contains(&self.order) {
            return Err(ShapeError(format!("order is {}: it must be from 1 to 12", self.order)));
        }
        within("fork_deg", self.fork_deg, &(0.0..=90.0))?;
        within("side_deg", self.side_deg, &(0.0..=120.0))?;
        within("main_deg", self.main_deg, &(0.0..=90.0))?;
        within("turn_deg", self.turn_deg, &(0.0..=360.0))?;
        within("angle_spread", self.angle_spread, &(0.0..=1.0))?;
        within("length_spread", self.length_spread, &(0.0..=0.9))?;
        within("rise", self.rise, &(-0.5..=0.5))?;
        within("sides", f64::from(self.sides), &(3.0..=16.0))?;
        within("leaf_size", self.leaf_size, &(0.05..=10.0))?;
        within("leaf_ends", self.leaf_ends, &(0.0..=1.0))?;
        within("leaf_spots", self.leaf_spots, &(0.0..=1.0))?;
        within("leaf_hang", self.leaf_hang, &(-1.0..=2.0))?;
        if let Some(leaf) = &self.leaf {
            leaf.check().map_err(|ShapeError(why)| ShapeError(format!("leaf.{why}")))?;
        }
        self.length.check("length")?;
        match self.width {
            Width::ByOrder(law) => law.check("width.by_order"),
            Width::Murray { tip_cm, exponent } => {
                within("width.murray.tip_cm", tip_cm, &CM)?;
                within("width.murray.exponent", exponent, &(1.0..=5.0))
            }
        }
    }
}

impl Matrix {
    /// # Errors
    /// An unknown name, and rows that are no stochastic lower triangle.
    pub fn ramification(&self) -> Result<Ramification, ShapeError> {
        match self {
            Matrix::Named(name) => Ramification::named(name),
            Matrix::Rows(rows) => Ramification::new(rows.clone()),
        }
    }
}

impl TryFrom<serde_json::Value> for Matrix {
    type Error = &'static str;

    fn try_from(value: serde_json::Value) -> Result<Matrix, &'static str> {
        match value {
            serde_json::Value::String(name) => Ok(Matrix::Named(name)),
            rows => serde_json::from_value(rows)
                .map(Matrix::Rows)
                .map_err(|_| "matrix must be a name or a list of rows of numbers"),
        }
    }
}

impl Law {
    /// Of an edge of this order, from 1.
    pub fn of(&self, order: u32) -> f64 {
        match *self {
            Law::Linear { first_cm, more_cm } => first_cm + more_cm * f64::from(order - 1),
            Law::Power { first_cm, exponent } => first_cm * libm::pow(f64::from(order), exponent),
            Law::Exponential { first_cm, factor } => {
                first_cm * libm::pow(factor, f64::from(order - 1))
            }
        }
    }

    fn check(&self, name: &str) -> Result<(), ShapeError> {
        let (law, first, more, value, range) = match *self {
            Law::Linear { first_cm, more_cm } => {
                ("linear", first_cm, "more_cm", more_cm, 0.0..=1000.0)
            }
            Law::Power { first_cm, exponent } => {
                ("power", first_cm, "exponent", exponent, 0.0..=4.0)
            }
            Law::Exponential { first_cm, factor } => {
                ("exponential", first_cm, "factor", factor, 1.0..=4.0)
            }
        };
        within(&format!("{name}.{law}.first_cm"), first, &CM)?;
        within(&format!("{name}.{law}.{more}"), value, &range)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_back_as_they_were_written() {
        let mut numbers = TreeNumbers::default();
        for matrix in [Matrix::Named("fern".into()), Matrix::Rows(vec![vec![0.25, 0.75]])] {
            for length in [
                Law::Linear { first_cm: 0.1, more_cm: 3.0 },
                Law::Power { first_cm: 0.3, exponent: 1.7 },
            ] {
                numbers = TreeNumbers {
                    matrix: matrix.clone(),
                    length,
                    width: Width::ByOrder(length),
                    ..numbers
                };
                let text = serde_json::to_string(&numbers).unwrap();
                assert_eq!(TreeNumbers::from_json(&text).unwrap(), numbers, "{text}");
            }
        }
        assert_eq!(TreeNumbers::from_json("{}").unwrap(), TreeNumbers::default());
    }

    #[test]
    fn wrong_numbers_are_named() {
        for (text, words) in [
            ("{\"order\": 0}", "order is 0: it must be from 1 to 12"),
            ("{\"order\": 2.5}", "order is 2.5: it must be a whole number"),
            ("{\"forks_deg\": 2}", "no number \"forks_deg\": the nearest one is \"fork_deg\""),
            ("{\"fork_deg\": 91}", "fork_deg is 91: it must be from 0 to 90"),
            ("{\"rise\": -0.6}", "rise is -0.6"),
            ("{\"sides\": 2}", "sides is 2"),
            (
                "{\"length\": {\"linear\": {\"first_cm\": 0, \"more_cm\": 1}}}",
                "length.linear.first_cm",
            ),
            (
                "{\"length\": {\"power\": {\"first_cm\": 1, \"exponent\": 9}}}",
                "length.power.exponent",
            ),
            (
                "{\"length\": {\"cubic\": {\"first_cm\": 1}}}",
                "length is \"cubic\": it must be one of linear",
            ),
            ("{\"width\": {\"murray\": {\"tip_cm\": 1}}}", "width.murray.exponent is missing"),
            (
                "{\"width\": {\"murray\": {\"tip_cm\": 1, \"exponent\": 0}}}",
                "width.murray.exponent",
            ),
            ("{\"leaf\": {\"lobes\": 4}}", "leaf.lobes is 4: it must be an odd number"),
            ("{\"leaf\": {\"lobe\": 3}}", "the nearest one is \"leaf.lobes\""),
            ("{\"leaf_ends\": 2}", "leaf_ends is 2: it must be from 0 to 1"),
            ("{\"matrix\": 3}", "matrix must be a name or a list of rows"),
            ("{\"fork_deg\": 1e999}", "it is no JSON"),
            ("7", "the whole is 7: it must be numbers with names"),
        ] {
            let wrong = TreeNumbers::from_json(text).unwrap_err().to_string();
            assert!(wrong.contains(words) && wrong.lines().count() == 1, "{text}: {wrong}");
        }
    }
}
