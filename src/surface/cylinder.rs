//! Cylinders around a body and the control images on them (Thesis 3.2.2, 3.2.3; Paper Fig. 4).

use super::{Mesh, Place};
use glam::Vec3;

/// A cylinder around a body: a point of the body is looked up by its angle and height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder {
    /// Centre of the bottom disc.
    pub base: Vec3,
    /// Unit vector from the bottom to the top.
    pub axis: Vec3,
    /// Unit vector, across the axis, where the angle is 0.
    pub zero: Vec3,
    /// Distance from the bottom to the top, in centimetres.
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
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Wrap {
    Cylinder(Cylinder),
    /// Spread over the leaves by their leaf coordinates, from rim to rim and from base to tip. (The
    /// thesis wraps each leaf in a cylinder; leaf coordinates follow blades that bend.)
    Leaf,
}

/// A control image on a body: where it is black, first cells of type F become B, and where it is
/// grey, M.
#[derive(Clone, Debug, PartialEq)]
pub struct Control {
    pub wrap: Wrap,
    pub image: ControlImage,
}

/// What a control image says of a place: a third of the greys each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tone {
    Black,
    Grey,
    White,
}

impl From<bool> for Tone {
    fn from(is_white: bool) -> Tone {
        if is_white { Tone::White } else { Tone::Black }
    }
}

impl Wrap {
    /// Where in the image a place looks: turns, `0..=1`, and height, 0 at the bottom of the image
    /// and 1 at its top. Half a turn is the midrib of a leaf.
    ///
    /// # Panics
    /// For `Wrap::Leaf` on a mesh without leaf coordinates.
    pub fn coordinates(&self, mesh: &Mesh, place: Place) -> (f32, f32) {
        match self {
            Wrap::Cylinder(cylinder) => cylinder.coordinates(mesh.point(place)),
            Wrap::Leaf => {
                let leaf = mesh.uv(place);
                (0.5 * (leaf.x + 1.0), leaf.y)
            }
        }
    }
}

impl Cylinder {
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
    /// it gives a tone, or true for white and false for black.
    pub fn paint<T: Into<Tone>>(
        width: u32,
        height: u32,
        rule: impl Fn(f32, f32) -> T,
    ) -> ControlImage {
        let centre = |k: u32, n: u32| (k as f32 + 0.5) / n as f32;
        let grey = (0..height)
            .flat_map(|y| (0..width).map(move |x| (x, y)))
            .map(|(x, y)| match rule(centre(x, width), centre(y, height)).into() {
                Tone::Black => 0,
                Tone::Grey => 128,
                Tone::White => 255,
            })
            .collect();
        ControlImage { width, height, grey }
    }

    /// The grey value at an angle (in turns, wraps around) and a height (ends are repeated).
    pub fn at(&self, turns: f32, height: f32) -> u8 {
        let column = ((turns * self.width as f32) as u32) % self.width;
        let row = ((height * self.height as f32).max(0.0) as u32).min(self.height - 1);
        self.grey[(row * self.width + column) as usize]
    }
}

impl Control {
    /// What the image says of a place.
    pub fn tone(&self, mesh: &Mesh, place: Place) -> Tone {
        let (turns, height) = self.wrap.coordinates(mesh, place);
        match self.image.at(turns, height) {
            0..=84 => Tone::Black,
            85..=169 => Tone::Grey,
            170..=255 => Tone::White,
        }
    }
}
