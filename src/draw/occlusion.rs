//! How much of the sky, and of the key light, points of a scene see: depth maps from many
//! directions, splatted on the processor in a few milliseconds.

use glam::{Vec2, Vec3};

/// Cells along a side of a depth map: fine enough for a stalk, coarse enough that the samples of
/// the surface leave no holes.
const SIDE: usize = 64;

/// Axes for the light of the sky; each serves for two directions.
const SKY_AXES: usize = 20;

/// Directions in the cone of the key light, and the sine of its half angle: a lamp as wide as a
/// window.
const KEY_DIRECTIONS: usize = 24;
const KEY_CONE: f32 = 0.20;

/// What casts and catches shade.
pub struct Shade<'a> {
    /// Points on all surfaces that take light away, dense as `sample_spacing` asks.
    pub casters: &'a [Vec3],
    pub centre: Vec3,
    /// Radius of a sphere around the casters.
    pub radius: f32,
}

/// Length of the triangles whose centroids leave no holes in the depth maps that would be seen: two
/// cells, a cell or less of area. Half of it makes no picture better and takes four times as long.
pub fn sample_spacing(radius: f32) -> f32 {
    4.0 * radius / SIDE as f32
}

impl Shade<'_> {
    /// For each point with its unit normal the share of the sky that it sees, weighted by the
    /// cosine, 0 to 1.
    pub fn sky(&self, points: &[(Vec3, Vec3)]) -> Vec<f32> {
        let mut seen = vec![Vec2::ZERO; points.len()];
        for axis in sphere(SKY_AXES) {
            let map = DepthMap::new(self, axis);
            for (&(point, normal), sum) in points.iter().zip(&mut seen) {
                let cosine = normal.dot(axis);
                *sum += Vec2::new(cosine.abs() * map.visibility(point, cosine < 0.0), cosine.abs());
            }
        }
        seen.into_iter().map(|s| if s.y > 0.0 { s.x / s.y } else { 1.0 }).collect()
    }

    /// For each point the share of a wide lamp in the direction `key` that it sees, 0 to 1.
    pub fn lamp(&self, key: Vec3, points: &[Vec3]) -> Vec<f32> {
        let mut seen = vec![0.0; points.len()];
        let (side, up) = key.any_orthonormal_pair();
        for k in 0..KEY_DIRECTIONS {
            let (disc_x, disc_y) = disc(k, KEY_DIRECTIONS);
            let map =
                DepthMap::new(self, (key + (side * disc_x + up * disc_y) * KEY_CONE).normalize());
            for (&point, sum) in points.iter().zip(&mut seen) {
                *sum += map.visibility(point, false) / KEY_DIRECTIONS as f32;
            }
        }
        seen
    }
}

/// The highest and the lowest caster over each cell of a plane across a direction.
struct DepthMap {
    axis: Vec3,
    right: Vec3,
    up: Vec3,
    centre: Vec3,
    per_cell: f32,
    bias: f32,
    highest: Vec<f32>,
    lowest: Vec<f32>,
}

impl DepthMap {
    fn new(shade: &Shade, axis: Vec3) -> DepthMap {
        let (right, up) = axis.any_orthonormal_pair();
        let per_cell = SIDE as f32 / (2.0 * shade.radius);
        let mut map = DepthMap {
            axis,
            right,
            up,
            centre: shade.centre,
            per_cell,
            // Nearer than two cells a surface cannot be told from its own samples.
            bias: 2.0 / per_cell,
            highest: vec![f32::NEG_INFINITY; SIDE * SIDE],
            lowest: vec![f32::INFINITY; SIDE * SIDE],
        };
        for &caster in shade.casters {
            let (across, depth) = map.project(caster);
            if let Some(cell) = cell(across.x as i32, across.y as i32) {
                map.highest[cell] = map.highest[cell].max(depth);
                map.lowest[cell] = map.lowest[cell].min(depth);
            }
        }
        map
    }

    /// Cell coordinates and depth along the axis.
    fn project(&self, point: Vec3) -> (Vec2, f32) {
        let from_centre = point - self.centre;
        let across = Vec2::new(from_centre.dot(self.right), from_centre.dot(self.up));
        (across * self.per_cell + SIDE as f32 / 2.0, from_centre.dot(self.axis))
    }

    /// How free the way from a point is along the axis, or (`down`) against it: 0 to 1, a blend of
    /// the four cells around.
    fn visibility(&self, point: Vec3, down: bool) -> f32 {
        let (across, depth) = self.project(point);
        let corner = (across - 0.5).floor();
        let part = across - 0.5 - corner;
        let free = |dx: i32, dy: i32| {
            let Some(cell) = cell(corner.x as i32 + dx, corner.y as i32 + dy) else { return 1.0 };
            let above = if down { depth - self.lowest[cell] } else { self.highest[cell] - depth };
            1.0 - ((above - self.bias) / self.bias).clamp(0.0, 1.0)
        };
        let low = free(0, 0) * (1.0 - part.x) + free(1, 0) * part.x;
        let high = free(0, 1) * (1.0 - part.x) + free(1, 1) * part.x;
        low * (1.0 - part.y) + high * part.y
    }
}

fn cell(x: i32, y: i32) -> Option<usize> {
    let inside = |v: i32| (0..SIDE as i32).contains(&v);
    (inside(x) && inside(y)).then(|| y as usize * SIDE + x as usize)
}

/// Evenly spread unit vectors on the upper half sphere (a Fibonacci spiral).
fn sphere(count: usize) -> impl Iterator<Item = Vec3> {
    (0..count).map(move |k| {
        let y = (k as f32 + 0.5) / count as f32;
        let (sin, cos) = libm::sincosf(k as f32 * GOLDEN_ANGLE_RAD);
        let across = (1.0 - y * y).sqrt();
        Vec3::new(cos * across, y, sin * across)
    })
}

/// Evenly spread points of the unit disc (Vogel's sunflower).
fn disc(k: usize, count: usize) -> (f32, f32) {
    let radius = ((k as f32 + 0.5) / count as f32).sqrt();
    let (sin, cos) = libm::sincosf(k as f32 * GOLDEN_ANGLE_RAD);
    (cos * radius, sin * radius)
}

const GOLDEN_ANGLE_RAD: f32 = 2.399_963_2;

#[cfg(test)]
mod tests {
    use super::*;

    /// A plate of 2 by 2 at a height over the ground.
    fn plate(height: f32) -> Vec<Vec3> {
        let at = |k: i32| k as f32 / 40.0;
        (-40..=40).flat_map(|x| (-40..=40).map(move |z| Vec3::new(at(x), height, at(z)))).collect()
    }

    #[test]
    fn a_plate_darkens_what_is_below_it_and_nothing_far_away() {
        let casters = plate(0.3);
        let shade = Shade { casters: &casters, centre: Vec3::new(0.0, 0.3, 0.0), radius: 1.5 };
        let sky = shade.sky(&[(Vec3::ZERO, Vec3::Y), (Vec3::new(9.0, 0.0, 0.0), Vec3::Y)]);
        assert!(sky[0] < 0.35, "under the plate {}", sky[0]);
        assert!(sky[1] > 0.95, "far away {}", sky[1]);
        let lamp = shade.lamp(Vec3::Y, &[Vec3::ZERO, Vec3::new(2.0, 0.0, 0.0)]);
        assert!(lamp[0] < 0.01 && lamp[1] > 0.99, "{lamp:?}");
    }

    #[test]
    fn a_lone_plate_does_not_darken_itself() {
        let casters = plate(0.0);
        let shade = Shade { casters: &casters, centre: Vec3::ZERO, radius: 1.5 };
        let sky = shade.sky(&[(Vec3::ZERO, Vec3::Y), (Vec3::ZERO, Vec3::NEG_Y)]);
        assert!(sky.iter().all(|&s| s > 0.9), "{sky:?}");
    }
}
