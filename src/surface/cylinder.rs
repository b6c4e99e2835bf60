//! Cylinders around a body and the control images on them (Thesis 3.2.2, 3.2.3; Paper Fig. 4).

use super::{AlongVeins, Mesh, Place, Shortest, limited};
use glam::Vec3;
use serde::{Deserialize, Serialize};

/// A cylinder around a body: a point of the body is looked up by its angle and height.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cylinder {
    /// Centre of the bottom disc.
    pub base: Vec3,
    /// Unit vector from the bottom to the top.
    pub axis: Vec3,
    /// Unit vector, across the axis, where the angle is 0.
    pub zero: Vec3,
    /// Distance from the bottom to the top, in centimetres.
    #[serde(rename = "height_cm")]
    pub height: f32,
}

/// A grey image wrapped once around a cylinder: columns are angles, rows heights from the bottom.
#[derive(Clone, Debug, PartialEq)]
pub struct ControlImage {
    pub width: u32,
    pub height: u32,
    /// Row by row from the bottom, 0 black to 255 white.
    pub grey: Vec<u8>,
}

/// How a control image lies on a body.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Wrap {
    Cylinder(Cylinder),
    /// Spread over every leaf by its leaf coordinates, from rim to rim and from base to tip. (The
    /// thesis wraps each leaf in a cylinder; leaf coordinates follow blades that bend.)
    Leaf,
    /// By the distance from the veins of the body: across the image from midrib to rim by leaf
    /// coordinates, if there are some, and upwards away from the veins.
    Veins(AlongVeins),
}

impl Wrap {
    /// Where in the image a place looks: turns, `0..1`, and height, 0 at the bottom of the image
    /// and 1 at its top. Across a leaf half a turn is the midrib, and its rims lie as far inside the
    /// seam as the centres of the image's outermost columns.
    ///
    /// # Panics
    /// For `Wrap::Leaf` on a mesh without leaf coordinates.
    pub fn coordinates(&self, image: &ControlImage, mesh: &Mesh, place: Place) -> (f32, f32) {
        match self {
            Wrap::Cylinder(cylinder) => cylinder.coordinates(mesh.point(place)),
            Wrap::Leaf => {
                let leaf = mesh.uv(place);
                (within(image, 0.5 * (leaf.x + 1.0)), leaf.y)
            }
            Wrap::Veins(AlongVeins { order, reach_cm }) => {
                let across = if mesh.uvs.is_empty() { 0.0 } else { mesh.uv(place).x.abs() };
                let distance_cm = mesh.veins.distance_cm(mesh, place, *order);
                (within(image, across), distance_cm / reach_cm)
            }
        }
    }
}

/// Turns as far inside the seam as the centres of an image's outermost columns.
fn within(image: &ControlImage, turns: f32) -> f32 {
    let outermost = 0.5 / image.width as f32;
    limited(turns, outermost, 1.0 - outermost)
}

impl Cylinder {
    /// Whether axis and zero are unit vectors across each other and the height is over 0; else what is
    /// wrong, in words.
    pub fn check(&self) -> Result<(), String> {
        // Of vectors that were written with four digits.
        const ROUNDING: f32 = 1e-3;
        let is_unit = |v: Vec3| (v.length() - 1.0).abs() < ROUNDING;
        if !(is_unit(self.axis) && is_unit(self.zero) && self.axis.dot(self.zero).abs() < ROUNDING)
        {
            return Err(
                "axis and zero of a cylinder must be of length 1 and at a right angle".into()
            );
        }
        if !self.base.to_array().iter().all(|x| x.abs() <= 10_000.0) {
            return Err(format!(
                "the base of a cylinder is [{}]: it must be within 10,000 cm",
                self.base.to_array().map(f32::shortest).join(", ")
            ));
        }
        match self.height {
            0.01..=10_000.0 => Ok(()),
            height => {
                let height = height.shortest();
                Err(format!("height_cm is {height}: it must be from 0.01 to 10,000"))
            }
        }
    }

    /// Angle in turns, `0..1`, and height, 0 at the bottom and 1 at the top, of a point.
    pub fn coordinates(&self, point: Vec3) -> (f32, f32) {
        let from_base = point - self.base;
        let height = from_base.dot(self.axis) / self.height;
        let across = from_base - self.axis * from_base.dot(self.axis);
        let side = self.axis.cross(self.zero);
        let angle_rad = libm::atan2f(across.dot(side), across.dot(self.zero));
        let turns = angle_rad / std::f32::consts::TAU;
        (if turns < 0.0 { turns + 1.0 } else { turns }, height)
    }
}

impl ControlImage {
    /// Paints an image from a rule: `rule(turns, height)` with both in `0..1`, at pixel centres;
    /// true is white.
    pub fn paint(width: u32, height: u32, rule: impl Fn(f32, f32) -> bool) -> ControlImage {
        let grey = |turns: f32, height: f32| f32::from(u8::from(rule(turns, height)));
        ControlImage::shade(width, height, &grey)
    }

    /// The same in greys: the rule gives 0 for black to 1 for white, and what lies beyond is cut off.
    /// (One loop for the rules of all images, so that they are less to download.)
    pub fn shade(width: u32, height: u32, rule: &dyn Fn(f32, f32) -> f32) -> ControlImage {
        let centre = |k: u32, n: u32| (k as f32 + 0.5) / n as f32;
        let grey = (0..height)
            .flat_map(|y| (0..width).map(move |x| (x, y)))
            .map(|(x, y)| (255.0 * rule(centre(x, width), centre(y, height)) + 0.5) as u8)
            .collect();
        ControlImage { width, height, grey }
    }

    /// Whether the pixel at an angle (in turns, wraps around) and a height (ends are repeated) is
    /// white: for uses that have a sharp border.
    pub fn is_white(&self, turns: f32, height: f32) -> bool {
        self.nearest(turns, height) >= 128
    }

    /// The pixel there, 0 black to 255 white.
    pub fn nearest(&self, turns: f32, height: f32) -> u8 {
        let column = ((turns * self.width as f32) as u32) % self.width;
        let row = ((height * self.height as f32).max(0.0) as u32).min(self.height - 1);
        self.pixel(column, row)
    }

    /// The grey value there, 0 black to 1 white, bilinear between pixel centres: for uses that
    /// scale something. The last column passes into the first without a seam.
    pub fn grey(&self, turns: f32, height: f32) -> f32 {
        let between = |at: f32| (libm::floorf(at) as i32, at - libm::floorf(at));
        let (column, right) = between(turns * self.width as f32 - 0.5);
        let (row, up) = between(height.clamp(0.0, 1.0) * self.height as f32 - 0.5);
        let pixel = |dx: i32, dy: i32| {
            let x = (column + dx).rem_euclid(self.width as i32);
            let y = (row + dy).clamp(0, self.height as i32 - 1);
            f32::from(self.pixel(x as u32, y as u32)) / 255.0
        };
        let mix = |a: f32, b: f32, t: f32| a * (1.0 - t) + b * t;
        mix(mix(pixel(0, 0), pixel(1, 0), right), mix(pixel(0, 1), pixel(1, 1), right), up)
    }

    fn pixel(&self, column: u32, row: u32) -> u8 {
        self.grey[(row * self.width + column) as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pixels without any order.
    fn noise(width: u32, height: u32) -> ControlImage {
        let grey = (0..width * height).map(|k| (k * k * 89 + k * 57) as u8).collect();
        ControlImage { width, height, grey }
    }

    #[test]
    fn greys_are_those_of_the_pixels_at_their_centres_and_lie_between_them_elsewhere() {
        let image = noise(7, 5);
        for (x, y) in (0..7).flat_map(|x| (0..5).map(move |y| (x, y))) {
            let (turns, height) = ((x as f32 + 0.5) / 7.0, (y as f32 + 0.5) / 5.0);
            let grey = f32::from(image.pixel(x, y)) / 255.0;
            assert!((image.grey(turns, height) - grey).abs() < 1e-5);
            let next = f32::from(image.pixel((x + 1) % 7, y)) / 255.0;
            let half_way = image.grey(turns + 0.5 / 7.0, height);
            assert!((half_way - 0.5 * (grey + next)).abs() < 1e-5, "column {x}");
        }
        assert_eq!(image.grey(0.3, -4.0), image.grey(0.3, 0.0));
        assert_eq!(image.grey(0.3, 9.0), image.grey(0.3, 1.0));
    }

    #[test]
    fn there_is_no_seam_around_the_angle() {
        // An image that is turned by some columns looks the same at angles turned as far.
        let (image, by) = (noise(16, 4), 5);
        let mut turned = image.clone();
        for row in turned.grey.chunks_mut(16) {
            row.rotate_right(by);
        }
        for k in 0..=640 {
            let (turns, height) = (k as f32 / 640.0, (k % 13) as f32 / 12.0);
            let to = turns + by as f32 / 16.0;
            let to = if to > 1.0 { to - 1.0 } else { to };
            let (before, after) = (image.grey(turns, height), turned.grey(to, height));
            assert!((before - after).abs() < 1e-4, "{turns}: {before} and {after}");
        }
        assert!((image.grey(1.0, 0.4) - image.grey(0.0, 0.4)).abs() < 1e-5);
    }

    #[test]
    fn angles_run_once_around_the_axis() {
        let cylinder = Cylinder { base: Vec3::ZERO, axis: Vec3::Y, zero: Vec3::X, height: 2.0 };
        for (point, turns) in [(Vec3::X, 0.0), (-Vec3::Z, 0.25), (-Vec3::X, 0.5), (Vec3::Z, 0.75)] {
            let at = cylinder.coordinates(3.0 * point + Vec3::Y);
            assert!((at.0 - turns).abs() < 1e-6 && (at.1 - 0.5).abs() < 1e-6, "{point}: {at:?}");
        }
    }

    #[test]
    fn angles_are_the_same_at_all_heights_from_the_foot_on() {
        let base = Vec3::new(1.0, 2.0, 3.0);
        let cylinder = Cylinder { base, axis: Vec3::Z, zero: Vec3::X, height: 4.0 };
        for height in [0.0, 0.25, 0.5, 1.0] {
            for (turns, across) in
                [(0.0, Vec3::X), (0.25, Vec3::Y), (0.5, -Vec3::X), (0.75, -Vec3::Y)]
            {
                let point = base + 2.0 * across + Vec3::Z * (4.0 * height);
                assert_eq!(cylinder.coordinates(point), (turns, height));
            }
        }
    }
}
