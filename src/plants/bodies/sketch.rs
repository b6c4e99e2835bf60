//! A pencil for control meshes: vertices on a grid of a tenth of a millimetre, and the shapes that
//! several plants have in common.

use crate::surface::{Face, Group, PolygonMesh};
use glam::{Vec2, Vec3};
use std::collections::HashMap;
use std::f32::consts::{FRAC_PI_4, TAU};

/// A control mesh in the making. Sizes in centimetres, `y` up.
#[derive(Default)]
pub struct Sketch {
    pub mesh: PolygonMesh,
}

impl Sketch {
    /// The faces that follow belong to this part and material.
    pub fn group(&mut self, part: &str, material: &str) {
        self.mesh.groups.push(Group { part: part.to_string(), material: material.to_string() });
    }

    pub fn vertex(&mut self, p: Vec3) -> u32 {
        // A tenth of a millimetre is finer than the eye and keeps the files short.
        self.mesh.positions.push((p * 100.0).round() / 100.0 + Vec3::ZERO);
        self.mesh.positions.len() as u32 - 1
    }

    /// A vertex of a leaf blade with its leaf coordinates; a sketch with any of these has texture
    /// coordinates everywhere, `(0, 0)` off the blades.
    pub fn blade_vertex(&mut self, p: Vec3, leaf: Vec2) -> u32 {
        let vertex = self.vertex(p);
        self.mesh.uvs.resize(vertex as usize, Vec2::ZERO);
        self.mesh.uvs.push((leaf * 100.0).round() / 100.0);
        vertex
    }

    /// A polygon in the last group, counter-clockwise from outside.
    pub fn face(&mut self, vertices: &[u32]) {
        let group = self.mesh.groups.len() as u32 - 1;
        self.mesh.faces.push(Face { vertices: vertices.to_vec(), group });
    }

    /// A row of quads between two closed rings of equally many vertices, the second ring above the
    /// first when both run counter-clockwise seen from above.
    pub fn band(&mut self, below: &[u32], above: &[u32]) {
        let n = below.len();
        for k in 0..n {
            let next = (k + 1) % n;
            self.face(&[below[k], above[k], above[next], below[next]]);
        }
    }

    /// A row of polygons between two lines of vertices, of which the first may have a single one and the
    /// second, too: as many as the shorter one has steps. Both lines run to the right, seen from outside with
    /// the first one below, or to the left if it is mirrored.
    pub fn strip(&mut self, below: &[u32], above: &[u32], is_mirrored: bool) {
        let steps = (below.len() - 1).min(above.len() - 1).max(1);
        // Where a step of the shorter line begins in the other one.
        let start = |line: &[u32], step: usize| {
            let count = line.len() - 1;
            (2 * step * count + steps) / (2 * steps)
        };
        for step in 0..steps {
            let piece = |line: &[u32]| line[start(line, step)..=start(line, step + 1)].to_vec();
            let mut face = piece(below);
            face.extend(piece(above).into_iter().rev());
            if is_mirrored {
                face.reverse();
            }
            self.face(&face);
        }
    }

    /// A closed ring of vertices from its points.
    pub fn ring(&mut self, points: impl IntoIterator<Item = Vec3>) -> Vec<u32> {
        points.into_iter().map(|p| self.vertex(p)).collect()
    }

    /// A surface of revolution around the y axis through rings of `(radius, height)`, open at both
    /// ends; outside is to the right of the way along the profile, seen with the axis on the left.
    pub fn turned(&mut self, sides: usize, profile: &[(f32, f32)], place: impl Fn(Vec3) -> Vec3) {
        let ring = |&(radius, height): &(f32, f32)| -> Vec<Vec3> {
            (0..sides).map(|k| place(on_circle(k as f32 / sides as f32, radius, height))).collect()
        };
        let rings: Vec<Vec<u32>> = profile.iter().map(|at| self.ring(ring(at))).collect();
        for pair in rings.windows(2) {
            self.band(&pair[0], &pair[1]);
        }
    }

    /// A tube along a path of `(centre, radius)`, closed by a polygon at its far end.
    pub fn tube(&mut self, sides: usize, path: &[(Vec3, f32)]) {
        let mut across = Vec3::ZERO;
        let mut last: Vec<u32> = Vec::new();
        for (k, &(centre, radius)) in path.iter().enumerate() {
            let along = path[(k + 1).min(path.len() - 1)].0 - path[k.saturating_sub(1)].0;
            let along = along.normalize_or(Vec3::Y);
            // The same side all along, so that the tube does not twist.
            across = (across - along * across.dot(along))
                .try_normalize()
                .unwrap_or_else(|| along.any_orthonormal_vector());
            let other = along.cross(across);
            let ring = self.ring((0..sides).map(|k| {
                let (sin, cos) = sin_cos(k as f32 / sides as f32);
                centre + (across * cos + other * -sin) * radius
            }));
            if !last.is_empty() {
                self.band(&last, &ring);
            }
            last = ring;
        }
        last.reverse();
        self.face(&last);
    }

    /// A disc of quads without a pole: a square of `k` by `k` quads that turns round towards its
    /// rim, and `rings` rings of `4 k` quads around it. `place` takes an angle in turns and a
    /// distance from the centre, 0 to 1, to a point; the disc is seen from above, where angles run
    /// like those of `on_circle`. Returns the ring of rim vertices.
    pub fn disc(&mut self, k: usize, rings: usize, place: impl Fn(f32, f32) -> Vec3) -> Vec<u32> {
        let half = k as f32 / 2.0;
        let outermost = half + rings as f32;
        let mut put = |x: f32, z: f32, from_centre: f32| {
            // `x` and `z` on a square; the farther out, the rounder.
            let roundness = (from_centre / (half + 1.0)).min(1.0);
            let square = x.abs().max(z.abs()).max(1e-6);
            let round = libm::sqrtf(x * x + z * z).max(1e-6);
            let rho = from_centre * (roundness + (1.0 - roundness) * round / square);
            let turns = libm::atan2f(z, x) / TAU;
            self.vertex(place(turns, rho / outermost))
        };
        // Equal angles along a side of the square seen from the centre (equiangular cube sphere).
        let even = |c: f32, of: f32| if of == 0.0 { 0.0 } else { libm::tanf(c / of * FRAC_PI_4) };
        let mut grid = vec![vec![0; k + 1]; k + 1];
        for (i, row) in grid.iter_mut().enumerate() {
            for (j, vertex) in row.iter_mut().enumerate() {
                let (x, z) = (i as f32 - half, j as f32 - half);
                let m = x.abs().max(z.abs());
                *vertex = put(even(x, m), even(z, m), m);
            }
        }
        let mut rim: Vec<u32> = perimeter(k).map(|(i, j)| grid[i][j]).collect();
        let mut bands = Vec::new();
        for ring in 1..=rings {
            let outer: Vec<u32> = perimeter(k)
                .map(|(i, j)| {
                    let (x, z) = (i as f32 - half, j as f32 - half);
                    put(even(x, half), even(z, half), half + ring as f32)
                })
                .collect();
            bands.push((std::mem::replace(&mut rim, outer.clone()), outer));
        }
        for i in 0..k {
            for j in 0..k {
                self.face(&[grid[i][j], grid[i][j + 1], grid[i + 1][j + 1], grid[i + 1][j]]);
            }
        }
        for (inner, outer) in bands {
            self.band(&outer, &inner);
        }
        rim
    }

    /// A cube of `n` by `n` quads a face, blown up: `place` takes whole numbers from `-n / 2` to
    /// `n / 2` to a point. There are no poles, and for an even `n` the middles of the faces are
    /// vertices.
    pub fn cube(&mut self, n: i32, place: impl Fn([i32; 3]) -> Vec3) {
        let mut vertices = HashMap::new();
        let corner = |axis: usize, end: i32, i: i32, j: i32| {
            let mut at = [0; 3];
            at[axis] = end * n / 2;
            at[(axis + 1) % 3] = i - n / 2;
            at[(axis + 2) % 3] = j - n / 2;
            at
        };
        for (axis, end) in (0..3).flat_map(|axis| [(axis, -1), (axis, 1)]) {
            for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
                let mut around = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)];
                if end < 0 {
                    around.reverse();
                }
                let face = around.map(|(i, j)| {
                    let at = corner(axis, end, i, j);
                    *vertices.entry(at).or_insert_with(|| self.vertex(place(at)))
                });
                self.face(&face);
            }
        }
    }

    /// A pebble: a cube with shaken corners that refinement makes round.
    pub fn pebble(&mut self, centre: Vec3, half_size: Vec3, seed: u32) {
        let corners: Vec<u32> = (0..8)
            .map(|k: u32| {
                let sign = |axis: u32| if k >> axis & 1 == 1 { 1.0 } else { -1.0 };
                let shaken = |axis| sign(axis) * (1.0 + 0.25 * jitter(8 * seed + k, axis));
                self.vertex(centre + half_size * Vec3::new(shaken(0), shaken(1), shaken(2)))
            })
            .collect();
        for f in
            [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
        {
            self.face(&f.map(|c| corners[c]));
        }
    }
}

/// The corners around a grid of `k` by `k` squares, once around in the order of growing angle.
fn perimeter(k: usize) -> impl Iterator<Item = (usize, usize)> {
    let sides = [(k, 0, 0, 1), (k, k, -1, 0), (0, k, 0, -1), (0, 0, 1, 0_isize)];
    sides.into_iter().flat_map(move |(i, j, di, dj): (usize, usize, isize, isize)| {
        (0..k as isize)
            .map(move |s| ((i as isize + s * di) as usize, (j as isize + s * dj) as usize))
    })
}

/// A point on a circle around the y axis; the angle, in turns, runs from x to z.
pub fn on_circle(turns: f32, radius: f32, height: f32) -> Vec3 {
    let (sin, cos) = sin_cos(turns);
    Vec3::new(radius * cos, height, radius * sin)
}

/// Sine and cosine of an angle in turns.
pub fn sin_cos(turns: f32) -> (f32, f32) {
    (libm::sinf(turns * TAU), libm::cosf(turns * TAU))
}

/// A number from -1 to 1 that is always the same for the same place: nature's irregularity.
pub fn jitter(item: u32, purpose: u32) -> f32 {
    crate::plants::Chance::PLANT.shaken(item, purpose)
}

/// As `jitter`, for a vertex of a disc.
pub fn jitter_at(turns: f32, rho: f32, purpose: u32) -> f32 {
    let angle = libm::roundf((turns + 1.0) * 360.0) as u32;
    jitter(angle % 360 + 360 * libm::roundf(rho * 64.0) as u32, purpose)
}
