//! Cylinders around a body and the control images on them (Thesis 3.2.2, 3.2.3; Paper Fig. 4).

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

/// A control image on its cylinder: where it is black, first cells of type F become B.
#[derive(Clone, Debug, PartialEq)]
pub struct Control {
    pub cylinder: Cylinder,
    pub image: ControlImage,
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
    /// true is white.
    pub fn paint(width: u32, height: u32, rule: impl Fn(f32, f32) -> bool) -> ControlImage {
        let centre = |k: u32, n: u32| (k as f32 + 0.5) / n as f32;
        let grey = (0..height)
            .flat_map(|y| (0..width).map(move |x| (x, y)))
            .map(|(x, y)| if rule(centre(x, width), centre(y, height)) { 255 } else { 0 })
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
    /// Whether a first cell at this point may be of type F.
    pub fn allows_foreground(&self, point: Vec3) -> bool {
        let (turns, height) = self.cylinder.coordinates(point);
        self.image.at(turns, height) >= 128
    }
}
