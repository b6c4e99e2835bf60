//! What is said about numbers that no body can be made of.

use std::ops::RangeInclusive;

/// Why numbers make no body, in plain words and on one line.
#[derive(Clone, Debug, thiserror::Error, PartialEq, Eq)]
#[error("{0}")]
pub struct ShapeError(pub(super) String);

/// Refuses a number that lies outside its range, both ends of which are allowed.
pub(super) fn within(
    name: &str,
    value: f64,
    range: &RangeInclusive<f64>,
) -> Result<(), ShapeError> {
    if range.contains(&value) {
        return Ok(());
    }
    let (least, most) = (range.start(), range.end());
    Err(ShapeError(format!("{name} is {value}: it must be from {least} to {most}")))
}
