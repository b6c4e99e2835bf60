//! An image of one's own, pixel by pixel.

use crate::plants::{List, Text, kept_texts};
use crate::surface::{ControlImage, quoted};
use serde::{Deserialize, Serialize};

/// Grey pixels as they are seen, the top row first: a digit for each, from 0, black, to f, white.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Pixels {
    #[serde(deserialize_with = "kept_texts")]
    pub rows: List<Text>,
}

impl Pixels {
    pub(super) fn paint(&self, width: u32, height: u32) -> ControlImage {
        let digits = self.rows.iter().rev().flat_map(|row| row.chars());
        let grey = digits.map(|digit| 17 * digit.to_digit(16).unwrap_or(0) as u8).collect();
        ControlImage { width, height, grey }
    }

    pub(super) fn check(&self, width: u32, height: u32) -> Result<(), String> {
        if self.rows.len() != height as usize {
            return Err(format!("rows has {} rows: height says {height}", self.rows.len()));
        }
        for (row, digits) in self.rows.iter().enumerate() {
            if digits.chars().count() != width as usize {
                let count = digits.chars().count();
                return Err(format!(
                    "row {} of rows has {count} pixels: width says {width}",
                    row + 1
                ));
            }
            if let Some(other) = digits.chars().find(|digit| !digit.is_ascii_hexdigit()) {
                return Err(format!(
                    "row {} of rows has {}: a pixel is a digit from 0 to 9 or a to f",
                    row + 1,
                    quoted(&other.to_string())
                ));
            }
        }
        Ok(())
    }
}
