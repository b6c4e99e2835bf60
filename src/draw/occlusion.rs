//! How much of the sky, and of the key light, points of a scene see: depth maps from many
//! directions, splatted on the processor in a few milliseconds.

use glam::{Vec2, Vec3};
use wide::f32x4;

/// Cells along a side of a depth map: fine enough for a stalk, coarse enough that the samples of
/// the surface leave no holes.
const SIDE: usize = 64;

/// Axes for the light of the sky; each serves for two directions.
const SKY_AXES: usize = 20;

/// Directions in the cone of the key light, and the sine of its half angle: a lamp as wide as a
/// window.
const KEY_DIRECTIONS: usize = 24;
const KEY_CONE: f32 = 0.20;

/// What takes light away.
pub struct Shade {
    /// x, y and z of four points from the centre.
    casters: Vec<[f32x4; 3]>,
    centre: Vec3,
    /// Cells of a depth map in a unit of length.
    per_cell: f32,
}

/// Length of the triangles whose centroids leave no holes in the depth maps that would be seen: two
/// cells, a cell or less of area. Half of it makes no picture better and takes four times as long.
pub fn sample_spacing(radius: f32) -> f32 {
    4.0 * radius / SIDE as f32
}

impl Shade {
    /// Shade of surfaces by points on all of them, dense as `sample_spacing` asks, within a sphere. Of
    /// points in one cube half as wide as a cell of the depth maps, one is enough.
    pub fn new(points: impl Iterator<Item = Vec3>, centre: Vec3, radius: f32) -> Shade {
        const CUBES: usize = 2 * SIDE;
        let mut is_taken = vec![0u64; CUBES * CUBES * CUBES / 64];
        let mut casters = Vec::new();
        for from_centre in points.map(|point| point - centre) {
            let cube = from_centre * (CUBES as f32 / (2.0 * radius)) + CUBES as f32 / 2.0;
            let [x, y, z] = cube.to_array().map(|v| (v as usize).min(CUBES - 1));
            let cube = (z * CUBES + y) * CUBES + x;
            let (taken, bit) = (&mut is_taken[cube / 64], 1 << (cube % 64));
            if *taken & bit == 0 {
                *taken |= bit;
                casters.push(from_centre);
            }
        }
        let fours = casters.chunks(4).map(|points| {
            // The last one fills the last four up: to see it again makes no shade.
            let point = |k: usize| points[k.min(points.len() - 1)].to_array();
            std::array::from_fn(|axis| f32x4::new(std::array::from_fn(|k| point(k)[axis])))
        });
        Shade { casters: fours.collect(), centre, per_cell: SIDE as f32 / (2.0 * radius) }
    }

    /// Of the sky.
    pub fn sky(&self) -> Sky {
        Sky { maps: sphere(SKY_AXES).map(|axis| DepthMap::new(self, axis)).collect() }
    }

    /// For each point the share of a wide lamp in the direction `key` that it sees, 0 to 1, and how near
    /// what hides the lamp is: from 1 at the point to 0 at so many centimetres and beyond.
    pub fn lamp(&self, key: Vec3, points: &[Vec3], far_cm: f32) -> Vec<Vec2> {
        let mut sums = vec![Vec2::ZERO; points.len()];
        let (side, up) = key.any_orthonormal_pair();
        for k in 0..KEY_DIRECTIONS {
            let (disc_x, disc_y) = disc(k, KEY_DIRECTIONS);
            let map =
                DepthMap::new(self, (key + (side * disc_x + up * disc_y) * KEY_CONE).normalize());
            for (&point, sum) in points.iter().zip(&mut sums) {
                let hidden = 1.0 - map.visibility(point)[0];
                let near = 1.0 - (map.lowest_above(point) / far_cm).clamp(0.0, 1.0);
                *sum += hidden * Vec2::new(1.0, near);
            }
        }
        let share = |sum: Vec2| {
            Vec2::new(1.0 - sum.x / KEY_DIRECTIONS as f32, sum.y / sum.x.max(f32::MIN_POSITIVE))
        };
        sums.into_iter().map(share).collect()
    }
}

/// The sky over and under what takes its light away.
pub struct Sky {
    maps: Vec<DepthMap>,
}

/// The sky as a point of a surface sees it.
#[derive(Clone, Copy)]
pub struct Skylight {
    /// The shares of the sky that both sides see, weighted by the cosine, 0 to 1.
    pub front: f32,
    pub back: f32,
    /// The mean direction of what the front sees; of unit length.
    pub bent: Vec3,
}

impl Sky {
    /// The sky at a point with this unit normal.
    pub fn light(&self, point: Vec3, normal: Vec3) -> Skylight {
        let (mut front, mut back, mut whole, mut bent) = (0.0, 0.0, 0.0, Vec3::ZERO);
        for map in &self.maps {
            let cosine = normal.dot(map.axis);
            let [mut before, mut behind] = map.visibility(point);
            if cosine < 0.0 {
                (before, behind) = (behind, before);
            }
            front += cosine.abs() * before;
            back += cosine.abs() * behind;
            whole += cosine.abs();
            bent += map.axis * (cosine * before);
        }
        let share = |seen: f32| if whole > 0.0 { seen / whole } else { 1.0 };
        Skylight { front: share(front), back: share(back), bent: bent.normalize_or(normal) }
    }
}

/// The highest and the lowest caster over each cell of a plane across a direction.
struct DepthMap {
    axis: Vec3,
    right: Vec3,
    up: Vec3,
    centre: Vec3,
    per_cell: f32,
    highest: Vec<f32>,
    lowest: Vec<f32>,
}

/// A depth map has a rim of two cells around it in which nothing stands.
const RIM: usize = 2;
const STRIDE: usize = SIDE + 2 * RIM;

impl DepthMap {
    fn new(shade: &Shade, axis: Vec3) -> DepthMap {
        let (right, up) = axis.any_orthonormal_pair();
        let mut map = DepthMap {
            axis,
            right,
            up,
            centre: shade.centre,
            per_cell: shade.per_cell,
            highest: vec![f32::NEG_INFINITY; STRIDE * STRIDE],
            lowest: vec![f32::INFINITY; STRIDE * STRIDE],
        };
        let (low, high) = (f32x4::splat(RIM as f32), f32x4::splat((RIM + SIDE - 1) as f32));
        for &[x, y, z] in &shade.casters {
            let along = |axis: Vec3| x * axis.x + y * axis.y + z * axis.z;
            let [column, row] = [right, up].map(|axis| {
                let across = along(axis) * map.per_cell + STRIDE as f32 / 2.0;
                across.fast_max(low).fast_min(high).fast_trunc_int()
            });
            let cells = (row * STRIDE as i32 + column).to_array();
            for (cell, depth) in cells.into_iter().zip(along(axis).to_array()) {
                let (highest, lowest) =
                    (&mut map.highest[cell as usize], &mut map.lowest[cell as usize]);
                *highest = highest.max(depth);
                *lowest = lowest.min(depth);
            }
        }
        map
    }

    /// Cell coordinates and depth along the axis.
    fn project(&self, point: Vec3) -> (Vec2, f32) {
        let from_centre = point - self.centre;
        let across = Vec2::new(from_centre.dot(self.right), from_centre.dot(self.up));
        (across * self.per_cell + STRIDE as f32 / 2.0, from_centre.dot(self.axis))
    }

    /// How free the ways from a point are along the axis and against it: 0 to 1, a blend of the four
    /// cells around.
    fn visibility(&self, point: Vec3) -> [f32; 2] {
        let (across, depth) = self.project(point);
        // Whoever stands beside the map looks from its rim.
        let across = (across - 0.5).clamp(Vec2::ZERO, Vec2::splat((STRIDE - 2) as f32));
        let (column, row) = (across.x as usize, across.y as usize);
        let (part_x, part_y) = (across.x - column as f32, across.y - row as f32);
        let cell = row * STRIDE + column;
        [(&self.highest, 1.0), (&self.lowest, -1.0)].map(|(map, sign)| {
            let four = [map[cell], map[cell + 1], map[cell + STRIDE], map[cell + STRIDE + 1]];
            let above = (f32x4::new(four) - f32x4::splat(depth)) * f32x4::splat(sign);
            // Nearer than two cells a surface cannot be told from its own samples.
            let dark = above * f32x4::splat(0.5 * self.per_cell) - f32x4::ONE;
            let free = f32x4::ONE - dark.fast_max(f32x4::ZERO).fast_min(f32x4::ONE);
            let [a, b, c, d] = free.to_array();
            let low = a + (b - a) * part_x;
            let high = c + (d - c) * part_x;
            low + (high - low) * part_y
        })
    }

    /// How far above a point, along the axis, the lowest caster lies, to a cell.
    fn lowest_above(&self, point: Vec3) -> f32 {
        let (across, depth) = self.project(point);
        let across = across.clamp(Vec2::ZERO, Vec2::splat((STRIDE - 1) as f32));
        self.lowest[across.y as usize * STRIDE + across.x as usize] - depth
    }
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
        let shade = Shade::new(casters.into_iter(), Vec3::new(0.0, 0.3, 0.0), 1.5);
        let sky = shade.sky();
        let sky =
            [Vec3::ZERO, Vec3::new(9.0, 0.0, 0.0)].map(|point| sky.light(point, Vec3::Y).front);
        assert!(sky[0] < 0.35, "under the plate {}", sky[0]);
        assert!(sky[1] > 0.95, "far away {}", sky[1]);
        let lamp = shade.lamp(Vec3::Y, &[Vec3::ZERO, Vec3::new(2.0, 0.0, 0.0)], 0.6);
        assert!(lamp[0].x < 0.01 && lamp[1].x > 0.99, "{lamp:?}");
        assert!(
            (lamp[0].y - 0.5).abs() < 0.05,
            "half as high as where shadows have no edge: {lamp:?}"
        );
    }

    #[test]
    fn light_comes_from_where_the_sky_is_open() {
        let wall: Vec<Vec3> = plate(0.0).iter().map(|p| Vec3::new(0.3, p.x, p.z)).collect();
        let light = Shade::new(wall.into_iter(), Vec3::ZERO, 1.6).sky().light(Vec3::ZERO, Vec3::Y);
        assert!(light.bent.x < -0.2 && light.bent.y > 0.5, "away from the wall: {}", light.bent);
        assert!((0.4..0.8).contains(&light.front), "{}", light.front);
        let apart = light.front - light.back;
        assert!(apart.abs() < 0.08, "the wall stands on both sides alike: {apart}");
    }

    #[test]
    fn a_lone_plate_does_not_darken_itself() {
        let casters = plate(0.0);
        let sky = Shade::new(casters.into_iter(), Vec3::ZERO, 1.5).sky();
        let light = sky.light(Vec3::ZERO, Vec3::Y);
        assert!(light.front > 0.9 && light.back > 0.9, "{} {}", light.front, light.back);
    }
}
