//! A lotus over its floating leaf.

use super::bloom::{bloom, days, finished};
use super::sketch::{jitter_at, on_circle};
use crate::shapes::flower::FlowerNumbers;
use crate::surface::PolygonMesh;
use glam::Vec3;

const NUMBERS: &str = include_str!("../../../examples/flowers/lotus.json");

pub fn grow() -> PolygonMesh {
    let mut numbers = FlowerNumbers::from_json(NUMBERS).expect("our own numbers");
    // As few corners as will do: each moves on every day.
    (numbers.petals.columns, numbers.petals.rows) = (1, 5);
    numbers.pedicel_cm = 9.0;
    let mut sketch = bloom(&numbers, Vec3::ZERO, &days(10.0, 20.0, 5, 0.6), |_| {});
    sketch.group("floating leaf", "bare:leaf");
    sketch.disc(2, 1, |turns, rho| {
        // A shallow dish with a waved rim, behind the stalk.
        let up = 0.1 + 0.5 * rho * rho + 0.2 * rho * jitter_at(turns, rho, 3);
        on_circle(turns, 7.0 * rho, up) + Vec3::new(4.5, 0.0, -6.0)
    });
    finished(sketch)
}
