//! Strokes that lead: vectors along them, which the plant's direction field follows.

use super::layers::Layer;
use super::stroke::Brush;
use super::ways::On;
use crate::plants::{GuideVector, Guides, Plant};
use crate::surface::Mesh;
use glam::Vec3;

/// How sharply the field of a plant without one of its own turns: over so many times the size of the body.
const TURNS: f32 = 6.0;
/// Vectors stand no nearer to each other than this, times the length over which the field turns.
const GAP: f32 = 0.15;
/// Weight of the field in a plant that had none: that of the philodendron.
const ANISOTROPY: f32 = 0.6;
/// Of its own vectors and those of strokes a plant has at most so many.
const MOST: usize = 400;

/// A vector of a stroke.
#[derive(Clone, Copy)]
struct Led {
    triangle: u32,
    direction: Vec3,
}

/// Has the strokes that lead lead a plant, beside the vectors that it has.
pub fn lead(plant: &mut Plant, layers: &[Layer], mesh: &Mesh) -> Result<(), String> {
    let of_brush = layers.iter().filter(|layer| layer.brush == Brush::Lead);
    let lines = of_brush.flat_map(|layer| &layer.lines);
    let mut all: Vec<Led> = lines.flat_map(|line| vectors(&line.on)).collect();
    // The newest come first: where two are too near to each other, it counts.
    all.reverse();
    if all.is_empty() {
        return Ok(());
    }
    let own = plant.guides.filter(|guides| {
        !guides.vectors.iter().any(|of| matches!(of, GuideVector::AlongVeins { .. }))
    });
    let (low, high) = (mesh.positions.iter())
        .fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |ends, &p| (ends.0.min(p), ends.1.max(p)));
    let usual = f64::from(TURNS / (high - low).max_element());
    let epsilon_per_cm = own.map_or(usual, |guides| guides.epsilon_per_cm).clamp(0.001, 1000.0);
    if plant.recipe.anisotropy == 0.0 {
        plant.recipe.anisotropy = ANISOTROPY;
    }
    let own = own.map_or(&[][..], |guides| guides.vectors);
    let mut why = String::new();
    // Its own vectors go where strokes lie too near to them.
    for own in [own, &[]] {
        let mut gap_cm = GAP / epsilon_per_cm as f32;
        for _ in 0..8 {
            let kept = apart(&all, mesh, gap_cm);
            gap_cm *= 1.5;
            if kept.len() + own.len() > MOST {
                continue;
            }
            let near = kept.iter().map(|led| GuideVector::Near {
                point_cm: mesh.centroid(led.triangle),
                direction: led.direction,
            });
            let vectors: Vec<GuideVector> = own.iter().copied().chain(near).collect();
            let guides = Guides { epsilon_per_cm, vectors: vectors.leak() };
            match guides.lead(mesh) {
                Ok(_) => {
                    plant.guides = Some(guides);
                    return Ok(());
                }
                Err(reason) => why = reason,
            }
        }
    }
    Err(why)
}

/// A vector on each triangle of a line, as it goes there.
fn vectors(on: &[On]) -> Vec<Led> {
    let ways = on.windows(2).flat_map(|ends| {
        let direction = (ends[1].at - ends[0].at).normalize_or_zero();
        [
            Led { triangle: ends[0].triangle, direction },
            Led { triangle: ends[1].triangle, direction },
        ]
    });
    ways.filter(|led| led.direction != Vec3::ZERO).collect()
}

/// Those of some that are no nearer to each other than a length on their part, the first ones first.
fn apart(all: &[Led], mesh: &Mesh, gap_cm: f32) -> Vec<Led> {
    let mut kept: Vec<Led> = Vec::new();
    for led in all {
        let is_near = |other: &Led| {
            let [here, there] = [led.triangle, other.triangle];
            mesh.parts[here as usize] == mesh.parts[there as usize]
                && mesh.centroid(here).distance(mesh.centroid(there)) < gap_cm
        };
        // A vector that stands on its triangle has no part in its plane.
        let [x, y] = mesh.axes(led.triangle);
        let is_flat = led.direction.dot(x).abs() + led.direction.dot(y).abs() > 0.1;
        if is_flat && !kept.iter().any(is_near) {
            kept.push(*led);
        }
    }
    kept
}
