//! Shoots that bloom: a flower by the rule of `shapes::flower`, what stands around it, and where all of it is from
//! day to day.

use super::sketch::Sketch;
use crate::shapes::flower::{Flower, FlowerNumbers};
use crate::surface::{Moment, PolygonMesh};
use glam::{Vec2, Vec3};

/// A day of a shoot.
pub struct Day {
    pub day: f32,
    /// How far the flower has opened, 0 to 1.
    pub time: f64,
    /// How tall the shoot is, as a share.
    pub size: f32,
}

/// From a young bud, which grows up to the day `bud`, to the flower that is open on the day `open`, in so many steps.
pub fn days(bud: f32, open: f32, steps: u32, young: f32) -> Vec<Day> {
    let opening = (0..=steps).map(|k| {
        // Closer in the middle, where petals move the fastest.
        let share = f64::from(k) / f64::from(steps);
        let time = share + 0.07 * libm::sin(std::f64::consts::TAU * share);
        Day { day: bud + (open - bud) * time as f32, time, size: 1.0 }
    });
    [Day { day: 0.0, time: 0.0, size: young }].into_iter().chain(opening).collect()
}

/// A flower whose pedicel stands at a foot, and what `around` adds to the shoot.
pub fn bloom(
    numbers: &FlowerNumbers,
    foot: Vec3,
    days: &[Day],
    around: impl Fn(&mut Sketch),
) -> Sketch {
    let flower = Flower::new(numbers, 1).expect("our own numbers are in their ranges");
    let rule = flower.mesh();
    let mut sketch = Sketch { mesh: rule.clone() };
    around(&mut sketch);
    let others = sketch.mesh.positions.split_off(rule.positions.len());
    let at = |day: &Day| -> Vec<Vec3> {
        let whole = PolygonMesh { positions: flower.at(day.time), ..rule.clone() };
        let shoot = before_refinement(&whole).into_iter().map(|p| p + foot);
        let grown = shoot.chain(others.iter().copied());
        grown.map(|p| rounded(foot + (p - foot) * day.size)).collect()
    };
    sketch.mesh.moments =
        days.iter().map(|day| Moment { day: day.day, positions: at(day) }).collect();
    sketch.mesh.positions = at(&days[days.len() - 1]);
    let short = |uv: &Vec2| (*uv * 100.0).round() / 100.0;
    sketch.mesh.uvs = sketch.mesh.uvs.iter().map(short).collect();
    sketch
}

/// The mesh of a shoot with what was added to it since, which stays where it is.
pub fn finished(mut sketch: Sketch) -> PolygonMesh {
    let mesh = &mut sketch.mesh;
    mesh.uvs.resize(mesh.positions.len(), Vec2::ZERO);
    for moment in &mut mesh.moments {
        moment.positions.extend(&mesh.positions[moment.positions.len()..]);
    }
    sketch.mesh
}

/// Places for the vertices of which refinement makes those that they have: a refined body does not reach its
/// control points. Filaments, which are too thin for that, stay.
fn before_refinement(mesh: &PolygonMesh) -> Vec<Vec3> {
    let mut is_thin = vec![false; mesh.positions.len()];
    for face in &mesh.faces {
        let thin = mesh.groups[face.group as usize].material == "bare:filament";
        face.vertices.iter().for_each(|&v| is_thin[v as usize] = thin);
    }
    let mut control = mesh.clone();
    for _ in 0..3 {
        let refined = control.refined(3).positions;
        for (k, wanted) in mesh.positions.iter().enumerate().filter(|(k, _)| !is_thin[*k]) {
            control.positions[k] += *wanted - refined[k];
        }
    }
    control.positions
}

/// On the grid of a sketch.
fn rounded(p: Vec3) -> Vec3 {
    (p * 100.0).round() / 100.0 + Vec3::ZERO
}

/// A lance-shaped leaf that leaves a stem at a point in a direction and bends down; bare.
pub fn lance(sketch: &mut Sketch, foot: Vec3, along: Vec3, length_cm: f32, width_cm: f32) {
    let side = along.cross(Vec3::Y).normalize() * (width_cm / 2.0);
    let mut below = Vec::new();
    for (share, width) in [(0.0, 0.35), (0.3, 1.1), (0.65, 0.9), (1.0, 0.0)] {
        let middle =
            foot + along * (length_cm * share) - Vec3::Y * (0.3 * length_cm * share * share);
        let above: Vec<u32> = match width {
            0.0 => vec![sketch.vertex(middle)],
            // Folded a little along the midrib.
            _ => [-1.0, 0.0, 1.0_f32]
                .map(|x| middle + side * (x * width) + Vec3::Y * (0.15 * width_cm * x.abs()))
                .map(|p| sketch.vertex(p))
                .to_vec(),
        };
        if !below.is_empty() {
            sketch.strip(&below, &above, false);
        }
        below = above;
    }
}
