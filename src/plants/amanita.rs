//! Ragged fly agaric: red spreads between the remains of the veil (Thesis, Fig. 4.14).

use super::{Plant, mushroom, scatter};
use crate::surface::{ControlImage, Cylinder, Wrap};
use crate::tissue::{Control, Recipe};
use glam::Vec3;

pub const PLANT: Plant = Plant {
    key: "amanita",
    name: "Ragged fly agaric",
    source: "Thesis, Fig. 4.14",
    recipe: Recipe {
        initial_cells: 3_000,
        // Open in the thesis. One cell in ten between the warts of `veil` makes small flecks; with
        // half of them white the cap is dusty and the warts are lost.
        initial_probability: [0.9, 0.1, 0.0],
        division_days: [5.0, 30.0, 30.0],
        radius_scale: 1.0,
        // Open in the thesis. Red cells multiply sixty-fold, white ones hardly: with 0.4 and ten
        // events a day they crush the white from a third to a tenth of the caps; with less than 0.05
        // hardly anything moves.
        repulsion: 0.05,
        // Open in the thesis: as above.
        relaxations_per_day: 4,
        days: 30,
        // Individuals have from 117,000 to 127,000 cells.
        max_cells: 150_000,
        ..mushroom::PLANT.recipe
    },
    first_day: 30,
    controls: Some(veil),
    ..mushroom::PLANT
};

/// A cap and its veil, in centimetres.
struct Cap {
    /// Middle of the rim's plane.
    rim: Vec3,
    radius: f32,
    height: f32,
    warts: u32,
    /// Of the largest, at the top.
    wart_radius: f32,
}

/// The caps of `meshes/mushroom.obj`. Smaller warts are crushed, larger ones run together at the top:
/// these leave a fifth of the last day white.
const CAPS: [Cap; 2] = [
    Cap { rim: Vec3::new(1.8, 12.4, 0.0), radius: 6.3, height: 3.7, warts: 66, wart_radius: 0.72 },
    Cap { rim: Vec3::new(-4.6, 4.1, 2.2), radius: 2.55, height: 2.7, warts: 18, wart_radius: 0.46 },
];

/// Each cap has warts where the veil is thick: no first cell is red there; and its orange rim.
fn veil() -> Vec<Control> {
    let [grown, button] = &CAPS;
    vec![grown.control(), button.control(), mushroom::orange_rims()]
}

impl Cap {
    fn control(&self) -> Control {
        let warts: Vec<(Vec3, f32)> = (0..self.warts).map(|k| self.wart(k)).collect();
        // Lowest and uppermost row are white: they are repeated over all that lies below and above,
        // the other cap too.
        const ROWS: u32 = 128;
        let image = ControlImage::paint(256, ROWS, |turns, height| {
            let is_end = height * ROWS as f32 <= 1.0 || (1.0 - height) * ROWS as f32 <= 1.0;
            let p = self.point(turns, height);
            is_end || warts.iter().all(|&(centre, radius)| centre.distance(p) > radius)
        });
        let (base, height) = (self.rim, self.height);
        let cylinder = Cylinder { base, axis: Vec3::Y, zero: Vec3::X, height };
        Control::foreground(Wrap::Cylinder(cylinder), image)
    }

    /// A point of the dome: angle in turns; height 0 at the rim, 1 at the top.
    fn point(&self, turns: f32, height: f32) -> Vec3 {
        let angle_rad = turns * std::f32::consts::TAU;
        let out = self.radius * libm::sqrtf((1.0 - height * height).max(0.0));
        Vec3::new(out * libm::cosf(angle_rad), height * self.height, out * libm::sinf(angle_rad))
    }

    /// Centre and radius of a wart: each at the golden angle from the last, the first at the top.
    fn wart(&self, k: u32) -> (Vec3, f32) {
        let shaken = |purpose| scatter(k, purpose) - 0.5;
        let down = (k as f32 + 0.5) / self.warts as f32;
        let turns = 0.382 * k as f32 + 0.05 * shaken(1);
        let radius = self.wart_radius * (1.0 - 0.4 * down + 0.35 * shaken(2));
        (self.point(turns, 1.0 - down), radius)
    }
}
