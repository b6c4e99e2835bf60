//! A triangle mesh with half-edges, and a flat frame on each of its triangles.

use super::lengths::normalized;
use super::{Motion, SurfaceError, Veins};
use glam::{Vec2, Vec3};

/// Marks a half-edge on the rim of an open surface.
pub const NO_TWIN: u32 = u32::MAX;

/// A point on a mesh: a triangle and two of its barycentric coordinates, those of corners 1 and 2
/// (the third is `1 - b1 - b2`). All three lie in `0..=1`.
#[derive(Clone, Copy, Debug, PartialEq, Default, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct Place {
    pub triangle: u32,
    pub b1: f32,
    pub b2: f32,
}

/// A triangle in its own plane: corner 0 at the origin, corner 1 at `(length, 0)`, corner 2 at
/// `apex` with `apex.y > 0`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    pub length: f32,
    pub apex: Vec2,
}

/// An oriented triangle mesh, open or closed, of one part or several.
///
/// Half-edge `3 * t + k` is the edge of triangle `t` opposite its corner `k`; it is where the
/// barycentric coordinate `k` is 0.
#[derive(Clone, Debug)]
pub struct Mesh {
    pub positions: Vec<Vec3>,
    /// Smooth unit normals, one per position.
    pub normals: Vec<Vec3>,
    /// Texture coordinates, one per position, or none.
    pub uvs: Vec<Vec2>,
    pub triangles: Vec<[u32; 3]>,
    /// For each half-edge the half-edge on its other side, or `NO_TWIN`.
    pub twins: Vec<u32>,
    /// Connected part of each triangle, from 0.
    pub parts: Vec<u32>,
    pub frames: Vec<Frame>,
    /// For each half-edge the rotation `(cos, sin)` that takes a direction from this triangle's
    /// frame to its neighbour's.
    pub turns: Vec<Vec2>,
    /// Areas of the triangles, and their sum.
    pub areas: Vec<f32>,
    pub area: f32,
    /// Those that a body has on it.
    pub veins: Veins,
    /// The ways of its corners, if it moves: then it stands here as it was made, which is what images, veins
    /// and fields lie on.
    pub motion: Motion,
}

impl Mesh {
    /// Joins triangles to a mesh. Triangles without area are left out; edges that more than two
    /// triangles share, or that two share without a common orientation, count as rims.
    ///
    /// # Errors
    /// Triangles without any area, or with so much that an f32 cannot hold its square. Bodies from 0.0001
    /// to 1,000,000 cm across are far from both.
    pub fn new(
        positions: Vec<Vec3>,
        uvs: Vec<Vec2>,
        triangles: Vec<[u32; 3]>,
    ) -> Result<Mesh, SurfaceError> {
        let mut triangles: Vec<[u32; 3]> =
            triangles.into_iter().filter(|t| has_area(&positions, t)).collect();
        if triangles.is_empty() {
            return Err(SurfaceError::NoArea);
        }
        let mut partners = partners(&triangles);
        let parts = orient(&mut triangles, &mut partners);
        let twins = twins(&triangles, partners);
        let mut mesh = Mesh {
            positions,
            normals: Vec::new(),
            uvs,
            triangles,
            twins,
            parts,
            frames: Vec::new(),
            turns: Vec::new(),
            areas: Vec::new(),
            area: 0.0,
            veins: Veins::default(),
            motion: Motion::default(),
        };
        mesh.measure();
        if !(mesh.area * mesh.area).is_finite() {
            return Err(SurfaceError::TooLarge);
        }
        Ok(mesh)
    }

    /// Takes frames, turns, areas and normals from the positions.
    pub(super) fn measure(&mut self) {
        let Mesh { positions, triangles, twins, frames, .. } = self;
        *frames = triangles.iter().map(|t| frame(corners(positions, t))).collect();
        self.turns = (0..twins.len()).map(|h| turn(frames, twins, h)).collect();
        self.areas = frames.iter().map(|f| 0.5 * f.length * f.apex.y).collect();
        self.area = self.areas.iter().map(|&a| f64::from(a)).sum::<f64>() as f32;
        self.normals = vertex_normals(positions, triangles);
    }

    /// The corners of a triangle in space.
    pub fn corners(&self, triangle: u32) -> [Vec3; 3] {
        corners(&self.positions, &self.triangles[triangle as usize])
    }

    /// A place as a point in space.
    pub fn point(&self, place: Place) -> Vec3 {
        let [a, b, c] = self.corners(place.triangle);
        a + (b - a) * place.b1 + (c - a) * place.b2
    }

    /// The texture coordinates of a place; the mesh must have some.
    pub fn uv(&self, place: Place) -> Vec2 {
        let [a, b, c] = self.triangles[place.triangle as usize].map(|v| self.uvs[v as usize]);
        a + (b - a) * place.b1 + (c - a) * place.b2
    }

    /// The centre of a triangle in space.
    pub fn centroid(&self, triangle: u32) -> Vec3 {
        let [a, b, c] = self.corners(triangle);
        (a + b + c) / 3.0
    }

    /// The unit vectors in space that are `x` and `y` of a triangle's frame.
    pub fn axes(&self, triangle: u32) -> [Vec3; 2] {
        let [a, b, c] = self.corners(triangle);
        let x = (b - a).normalize();
        [x, ((c - a) - x * (c - a).dot(x)).normalize()]
    }

    /// Number of connected parts.
    pub fn part_count(&self) -> usize {
        self.parts.iter().max().map_or(0, |&p| p as usize + 1)
    }

    /// Makes one of two edges of the rim that only lie in two places, as the sides of a square do that is a
    /// flat torus.
    pub(super) fn glue(&mut self, half_edge: u32, other: u32) {
        self.twins[half_edge as usize] = other;
        self.twins[other as usize] = half_edge;
        for h in [half_edge as usize, other as usize] {
            self.turns[h] = turn(&self.frames, &self.twins, h);
        }
    }

    /// Makes a half-edge and its twin, which must be there, two edges of the rim.
    pub fn part(&mut self, half_edge: u32) {
        let twin = std::mem::replace(&mut self.twins[half_edge as usize], NO_TWIN);
        self.twins[twin as usize] = NO_TWIN;
    }

    /// Whether two half-edges run against each other, shifted in space.
    fn is_glued(&self, half_edge: usize, twin: u32) -> bool {
        let along = |h: usize| {
            let (from, to) = edge(&self.triangles, h);
            self.positions[to as usize] - self.positions[from as usize]
        };
        let (here, there) = (along(half_edge), along(twin as usize));
        (here + there).length() <= 1e-5 * here.length()
    }

    /// Says what is wrong with the mesh, if anything: twins that do not point at each other, joined
    /// edges of unlike length or orientation, frames without area.
    pub fn check(&self) -> Result<(), String> {
        for (h, &twin) in self.twins.iter().enumerate() {
            if twin == NO_TWIN {
                continue;
            }
            if self.twins[twin as usize] as usize != h {
                return Err(format!("half-edge {h} and its twin {twin} disagree"));
            }
            let (from, to) = edge(&self.triangles, h);
            if edge(&self.triangles, twin as usize) != (to, from) && !self.is_glued(h, twin) {
                return Err(format!("half-edge {h} and its twin {twin} join other vertices"));
            }
            if self.parts[h / 3] != self.parts[twin as usize / 3] {
                return Err(format!("half-edge {h} joins two parts"));
            }
        }
        if let Some(t) = self.frames.iter().position(|f| !(f.length > 0.0 && f.apex.y > 0.0)) {
            return Err(format!("triangle {t} has no area"));
        }
        Ok(())
    }
}

impl Frame {
    /// Barycentric coordinates `(b1, b2)` to a point in the plane.
    pub fn point(&self, b1: f32, b2: f32) -> Vec2 {
        Vec2::new(b1 * self.length + b2 * self.apex.x, b2 * self.apex.y)
    }

    /// A direction in the plane to changes of `(b1, b2)`.
    pub fn barycentric(&self, direction: Vec2) -> Vec2 {
        let b2 = direction.y / self.apex.y;
        Vec2::new((direction.x - b2 * self.apex.x) / self.length, b2)
    }

    /// The corners in the plane.
    pub fn corners(&self) -> [Vec2; 3] {
        [Vec2::ZERO, Vec2::new(self.length, 0.0), self.apex]
    }
}

/// Unit normals at the vertices: the mean of the triangles around, weighted by area.
pub(super) fn vertex_normals(positions: &[Vec3], triangles: &[[u32; 3]]) -> Vec<Vec3> {
    let mut normals = vec![Vec3::ZERO; positions.len()];
    for t in triangles {
        let [a, b, c] = corners(positions, t);
        let weighted = (b - a).cross(c - a);
        for &v in t {
            normals[v as usize] += weighted;
        }
    }
    normals.into_iter().map(|n| n.normalize_or(Vec3::Y)).collect()
}

fn corners(positions: &[Vec3], t: &[u32; 3]) -> [Vec3; 3] {
    t.map(|v| positions[v as usize])
}

pub(super) fn has_area(positions: &[Vec3], t: &[u32; 3]) -> bool {
    let [a, b, c] = corners(positions, t);
    let longest = (b - a).length_squared().max((c - a).length_squared());
    // Below a ten-millionth of the edge's square the direction of the apex is rounding noise.
    (b - a).cross(c - a).length() > 1e-7 * longest && longest > 0.0
}

pub(super) fn frame([a, b, c]: [Vec3; 3]) -> Frame {
    let length = (b - a).length();
    let along = (b - a) / length;
    let x = (c - a).dot(along);
    let y = ((c - a) - along * x).length();
    Frame { length, apex: Vec2::new(x, y) }
}

/// The vertices from which and to which a half-edge runs.
fn edge(triangles: &[[u32; 3]], half_edge: usize) -> (u32, u32) {
    let (t, k) = (&triangles[half_edge / 3], half_edge % 3);
    (t[(k + 1) % 3], t[(k + 2) % 3])
}

/// For each half-edge the only other one between the same two vertices, or `NO_TWIN`.
fn partners(triangles: &[[u32; 3]]) -> Vec<u32> {
    let ends = |h: usize| {
        let (a, b) = edge(triangles, h);
        (a.min(b), a.max(b))
    };
    let mut half_edges: Vec<_> = (0..3 * triangles.len()).map(|h| (ends(h), h as u32)).collect();
    half_edges.sort_unstable();
    let mut partners = vec![NO_TWIN; half_edges.len()];
    for alike in half_edges.chunk_by(|a, b| a.0 == b.0) {
        if let &[(_, one), (_, other)] = alike {
            partners[one as usize] = other;
            partners[other as usize] = one;
        }
    }
    partners
}

/// Turns triangles around so that neighbours agree on their outside, part by part, starting from
/// the first triangle of each; returns the part of each triangle.
fn orient(triangles: &mut [[u32; 3]], partners: &mut [u32]) -> Vec<u32> {
    let mut parts = vec![u32::MAX; triangles.len()];
    let mut part = 0;
    for first in 0..triangles.len() {
        if parts[first] != u32::MAX {
            continue;
        }
        parts[first] = part;
        let mut waiting = vec![first];
        while let Some(t) = waiting.pop() {
            for h in 3 * t..3 * t + 3 {
                let partner = partners[h];
                let other = partner as usize / 3;
                if partner == NO_TWIN || parts[other] != u32::MAX {
                    continue;
                }
                parts[other] = part;
                if edge(triangles, partner as usize) == edge(triangles, h) {
                    turn_around(triangles, partners, other);
                }
                waiting.push(other);
            }
        }
        part += 1;
    }
    parts
}

/// Swaps two corners of a triangle, and with them the edges opposite.
fn turn_around(triangles: &mut [[u32; 3]], partners: &mut [u32], triangle: usize) {
    triangles[triangle].swap(1, 2);
    partners.swap(3 * triangle + 1, 3 * triangle + 2);
    for h in 3 * triangle + 1..3 * triangle + 3 {
        if partners[h] != NO_TWIN {
            partners[partners[h] as usize] = h as u32;
        }
    }
}

/// Partners that run the other way, as those of oriented neighbours do.
fn twins(triangles: &[[u32; 3]], mut partners: Vec<u32>) -> Vec<u32> {
    for h in 0..partners.len() {
        let partner = partners[h] as usize;
        if partners[h] != NO_TWIN && edge(triangles, partner) == edge(triangles, h) {
            partners[h] = NO_TWIN;
            partners[partner] = NO_TWIN;
        }
    }
    partners
}

fn turn(frames: &[Frame], twins: &[u32], h: usize) -> Vec2 {
    if twins[h] == NO_TWIN {
        return Vec2::X;
    }
    let twin = twins[h] as usize;
    let direction = |h: usize| {
        let c = frames[h / 3].corners();
        normalized(c[(h % 3 + 2) % 3] - c[(h % 3 + 1) % 3])
    };
    let (here, there) = (direction(h), -direction(twin));
    // The rotation from `here` to `there` as a complex number, there / here.
    normalized(Vec2::new(here.dot(there), here.perp_dot(there)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_triangle_that_has_lost_its_area_is_told() {
        let square = vec![Vec3::ZERO, Vec3::X, Vec3::new(1.0, 1.0, 0.0), Vec3::Y];
        let mesh = Mesh::new(square, Vec::new(), vec![[0, 1, 2], [0, 2, 3]]).unwrap();
        mesh.check().unwrap();
        let flattened: [fn(&mut Frame); 4] = [
            |frame| frame.length = 0.0,
            |frame| frame.length = f32::NAN,
            |frame| frame.apex.y = 0.0,
            |frame| frame.apex.y = -1.0,
        ];
        for flatten in flattened {
            let mut mesh = mesh.clone();
            flatten(&mut mesh.frames[1]);
            assert_eq!(mesh.check().unwrap_err(), "triangle 1 has no area");
        }
    }

    #[test]
    fn areas_that_an_f32_cannot_hold_are_refused() {
        let tetrahedron = |size: f32| {
            let corners =
                [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
            let positions = corners.map(|corner| Vec3::from(corner) * size).to_vec();
            Mesh::new(positions, Vec::new(), vec![[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]])
        };
        for power in -4..=6 {
            let size = 10f64.powi(power);
            let mesh = tetrahedron(size as f32).unwrap();
            mesh.check().unwrap();
            assert!((f64::from(mesh.area) / (8.0 * 3f64.sqrt() * size * size) - 1.0).abs() < 1e-6);
            assert!(mesh.turns.iter().all(|turn| (turn.length() - 1.0).abs() < 1e-5));
        }
        for size in [3e18, 1e20, f32::INFINITY, f32::NAN, 1e-12, 0.0] {
            let wrong = tetrahedron(size).unwrap_err();
            assert!(
                matches!(wrong, SurfaceError::TooLarge | SurfaceError::NoArea),
                "{size}: {wrong}"
            );
        }
    }
}
