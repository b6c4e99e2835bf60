//! A tiger lily: one flower that nods from a leafy stem.

use super::bloom::{bloom, days, finished, lance};
use super::sketch::on_circle;
use crate::shapes::flower::FlowerNumbers;
use crate::surface::PolygonMesh;
use glam::Vec3;

const NUMBERS: &str = include_str!("../../../examples/flowers/tiger_lily.json");
const LEAVES: u32 = 4;

pub fn grow() -> PolygonMesh {
    let mut numbers = FlowerNumbers::from_json(NUMBERS).expect("our own numbers");
    // As few corners as will do: each moves on every day.
    numbers.petals.rows = 9;
    numbers.pedicel_cm = 15.0;
    if let Some(stamens) = &mut numbers.stamens {
        (stamens.sides, stamens.rings) = (3, 3);
    }
    if let Some(pistil) = &mut numbers.pistil {
        pistil.radii_cm = vec![0.18, 0.11, 0.1, 0.13, 0.3];
    }
    finished(bloom(&numbers, Vec3::ZERO, &days(10.0, 20.0, 8, 0.6), |sketch| {
        sketch.group("leaves", "bare:leaf");
        for leaf in 0..LEAVES {
            let height_cm = 1.2 + 1.4 * leaf as f32;
            let out = on_circle(0.1 + 0.382 * leaf as f32, 1.0, 0.0);
            let along = (out + Vec3::Y * 0.8).normalize();
            lance(sketch, out * 0.2 + Vec3::Y * height_cm, along, 7.0 - 0.5 * leaf as f32, 1.1);
        }
    }))
}
