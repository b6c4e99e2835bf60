//! A golden lily: one flower on a leafy stem.

use super::bloom::{bloom, days, finished, lance};
use super::sketch::on_circle;
use crate::shapes::flower::{FlowerNumbers, RodNumbers};
use crate::surface::PolygonMesh;
use glam::Vec3;

const LEAVES: u32 = 4;

pub fn grow() -> PolygonMesh {
    let mut numbers = FlowerNumbers { pedicel_cm: 11.0, ..FlowerNumbers::default() };
    // As few corners as will do: each moves on every day.
    numbers.petals.rows = 9;
    if let Some(stamens) = &mut numbers.stamens {
        (stamens.sides, stamens.rings) = (3, 3);
    }
    numbers.pistil =
        Some(RodNumbers { radii_cm: vec![0.2, 0.12, 0.11, 0.15, 0.36], ..RodNumbers::default() });
    finished(bloom(&numbers, Vec3::ZERO, &days(10.0, 20.0, 8, 0.6), |sketch| {
        sketch.group("leaves", "bare:leaf");
        for leaf in 0..LEAVES {
            let height_cm = 1.6 + 1.3 * leaf as f32;
            let out = on_circle(0.12 + 0.382 * leaf as f32, 1.0, 0.0);
            let along = (out + Vec3::Y * 0.8).normalize();
            let foot = out * 0.2 + Vec3::Y * height_cm;
            lance(sketch, foot, along, 8.5 - 0.6 * leaf as f32, 1.5);
        }
    }))
}
