//! Parts of a surface laid flat as rigidly as can be (L. Liu, L. Zhang, Y. Xu, C. Gotsman, S. J. Gortler, A
//! Local/Global Approach to Mesh Parameterization, Computer Graphics Forum 27(5), 2008, "ARAP").

use crate::surface::{Mesh, NO_TWIN};
use glam::{DVec2, Vec3};

/// A part of a mesh in the plane.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// The place of each vertex of the mesh, in centimetres; zero where it is of another part.
    pub places: Vec<DVec2>,
    /// How much lengths are longer or shorter than on the surface: the mean over its area, 0 for none.
    pub stretch: f64,
}

/// Why a part is not laid flat.
#[derive(Clone, Debug, thiserror::Error, PartialEq)]
pub enum NotFlat {
    #[error("it is closed or has a hole")]
    NoDisc,
    #[error("it would be stretched by {0} % in the mean")]
    Stretched(u32),
}

/// More than this, and the pattern looks like another one.
const MOST_STRETCH: f64 = 0.08;

/// Turns of triangles and of all vertices in turn. Blades need a dozen.
const ROUNDS: usize = 60;

/// Weights of edges are at least this, so that the sums to solve stay positive where triangles are obtuse.
const LEAST_WEIGHT: f64 = 0.05;

/// Conjugate gradients end when the error has shrunk to this, or after so many steps in a round.
const SMALL: f64 = 1e-18;
const MOST_STEPS: usize = 120;

/// Lays a part flat, seen from outside, with its leaf coordinates upright if it has some.
///
/// # Errors
/// A part that is no disc, and one that would be stretched too much.
pub fn lay_flat(mesh: &Mesh, part: u32) -> Result<Sheet, NotFlat> {
    let triangles: Vec<usize> =
        (0..mesh.triangles.len()).filter(|&t| mesh.parts[t] == part).collect();
    if !is_disc(mesh, &triangles) {
        return Err(NotFlat::NoDisc);
    }
    let mut laying = Laying::new(mesh, &triangles);
    for _ in 0..ROUNDS {
        laying.turn_triangles();
        laying.move_vertices();
    }
    let stretch = laying.stretch();
    if stretch > MOST_STRETCH || stretch.is_nan() {
        return Err(NotFlat::Stretched((100.0 * stretch + 0.5) as u32));
    }
    Ok(Sheet { places: laying.places, stretch })
}

/// Whether triangles that hang together have one rim: V - E + F is 1.
fn is_disc(mesh: &Mesh, triangles: &[usize]) -> bool {
    let mut vertices: Vec<u32> = triangles.iter().flat_map(|&t| mesh.triangles[t]).collect();
    vertices.sort_unstable();
    vertices.dedup();
    let half_edges = triangles.iter().flat_map(|&t| [3 * t, 3 * t + 1, 3 * t + 2]);
    let edges = half_edges.filter(|&h| mesh.twins[h] == NO_TWIN || mesh.twins[h] as usize > h);
    vertices.len() + triangles.len() == edges.count() + 1
}

/// A part on its way into the plane.
struct Laying {
    corners: Vec<[usize; 3]>,
    /// Of each triangle in its own frame, the edges opposite its corners, and their weights.
    edges: Vec<[(DVec2, f64); 3]>,
    areas: Vec<f64>,
    /// How each triangle is turned from its frame into the plane, as `(cos, sin)`.
    turns: Vec<DVec2>,
    places: Vec<DVec2>,
}

impl Laying {
    fn new(mesh: &Mesh, triangles: &[usize]) -> Laying {
        let corners: Vec<[usize; 3]> =
            triangles.iter().map(|&t| mesh.triangles[t].map(|v| v as usize)).collect();
        let edges: Vec<[(DVec2, f64); 3]> = triangles.iter().map(|&t| weighted(mesh, t)).collect();
        Laying {
            turns: vec![DVec2::X; corners.len()],
            areas: triangles.iter().map(|&t| f64::from(mesh.areas[t])).collect(),
            places: first_places(mesh, triangles),
            corners,
            edges,
        }
    }

    /// Turns each triangle as it lies now.
    fn turn_triangles(&mut self) {
        for (t, corners) in self.corners.iter().enumerate() {
            let mut sum = DVec2::ZERO;
            for k in 0..3 {
                let now = self.places[corners[(k + 2) % 3]] - self.places[corners[(k + 1) % 3]];
                let (edge, weight) = self.edges[t][k];
                sum += weight * DVec2::new(edge.dot(now), edge.perp_dot(now));
            }
            self.turns[t] = sum.normalize_or(DVec2::X);
        }
    }

    /// Moves all vertices to where their edges are most like those of the turned triangles: weighted least
    /// squares by conjugate gradients (M. R. Hestenes, E. Stiefel, 1952).
    fn move_vertices(&mut self) {
        let mut error: Vec<DVec2> = self.pulls(&self.places, true);
        for e in &mut error {
            *e = -*e;
        }
        let whole = dot(&error, &error);
        let mut way = error.clone();
        let mut before = whole;
        for _ in 0..MOST_STEPS {
            if before <= SMALL * (1.0 + whole) {
                return;
            }
            let pulled = self.pulls(&way, false);
            let step = before / dot(&way, &pulled);
            for v in 0..way.len() {
                self.places[v] += step * way[v];
                error[v] -= step * pulled[v];
            }
            let now = dot(&error, &error);
            for (way, error) in way.iter_mut().zip(&error) {
                *way = *error + (now / before) * *way;
            }
            before = now;
        }
    }

    /// The weighted sums of the edges at each vertex, less those of the turned triangles if asked for.
    fn pulls(&self, places: &[DVec2], less_turned: bool) -> Vec<DVec2> {
        let mut pulls = vec![DVec2::ZERO; places.len()];
        for (t, corners) in self.corners.iter().enumerate() {
            for k in 0..3 {
                let (from, to) = (corners[(k + 1) % 3], corners[(k + 2) % 3]);
                let (edge, weight) = self.edges[t][k];
                let wished = if less_turned { self.turns[t].rotate(edge) } else { DVec2::ZERO };
                let pull = weight * (places[to] - places[from] - wished);
                pulls[to] += pull;
                pulls[from] -= pull;
            }
        }
        pulls
    }

    /// The mean over the area of how far the two stretches of each triangle are from 1.
    fn stretch(&self) -> f64 {
        let (mut sum, mut area) = (0.0, 0.0);
        for (t, corners) in self.corners.iter().enumerate() {
            let [p, q, r] = corners.map(|v| self.places[v]);
            // The edges that leave corner 0, in the frame and in the plane.
            let (x1, x2) = (self.edges[t][2].0, -self.edges[t][1].0);
            let (y1, y2) = (q - p, r - p);
            let per_area = 1.0 / x1.perp_dot(x2);
            let of_x = (y1 * x2.y - y2 * x1.y) * per_area;
            let of_y = (y2 * x1.x - y1 * x2.x) * per_area;
            let even = 0.5 * DVec2::new(of_x.x + of_y.y, of_x.y - of_y.x).length();
            let uneven = 0.5 * DVec2::new(of_x.x - of_y.y, of_x.y + of_y.x).length();
            let stretches = [even + uneven, even - uneven];
            sum += self.areas[t] * stretches.map(|s| (s - 1.0).abs()).iter().sum::<f64>() / 2.0;
            area += self.areas[t];
        }
        sum / area
    }
}

/// The edges of a triangle in its frame, opposite its corners, and half the cotangents of the angles there.
fn weighted(mesh: &Mesh, triangle: usize) -> [(DVec2, f64); 3] {
    let corners = mesh.frames[triangle].corners().map(|corner| corner.as_dvec2());
    [0, 1, 2].map(|k| {
        let [own, from, to] = [k, (k + 1) % 3, (k + 2) % 3].map(|k| corners[k]);
        let (a, b) = (from - own, to - own);
        (to - from, (0.5 * a.dot(b) / a.perp_dot(b)).max(LEAST_WEIGHT))
    })
}

/// By the leaf coordinates, as wide and as long as the surface is in the mean; without them as it is seen
/// along its mean normal.
fn first_places(mesh: &Mesh, triangles: &[usize]) -> Vec<DVec2> {
    let mut places = vec![DVec2::ZERO; mesh.positions.len()];
    let vertices = triangles.iter().flat_map(|&t| mesh.triangles[t]);
    if mesh.uvs.is_empty() {
        let mean: Vec3 = triangles
            .iter()
            .map(|&t| {
                let [x, y] = mesh.axes(t as u32);
                x.cross(y) * mesh.areas[t]
            })
            .sum();
        let (x, y) = mean.normalize_or(Vec3::Y).any_orthonormal_pair();
        for v in vertices {
            let point = mesh.positions[v as usize];
            places[v as usize] = DVec2::new(point.dot(x).into(), point.dot(y).into());
        }
        return places;
    }
    // Squares of lengths across and along, and of the leaf coordinates that they are of.
    let (mut lengths, mut coordinates) = (DVec2::ZERO, DVec2::ZERO);
    for &t in triangles {
        let corners = mesh.triangles[t].map(|v| v as usize);
        for k in 0..3 {
            let (from, to) = (corners[k], corners[(k + 1) % 3]);
            let by = (mesh.uvs[to] - mesh.uvs[from]).as_dvec2();
            let squared = f64::from(mesh.positions[from].distance_squared(mesh.positions[to]));
            // An edge counts for the coordinate that it follows.
            let share = by * by / by.length_squared().max(1e-12);
            lengths += share * squared;
            coordinates += share * by * by;
        }
    }
    let [across, along] = [0, 1].map(|k| (lengths[k] / coordinates[k].max(1e-12)).sqrt());
    for v in vertices {
        places[v as usize] = mesh.uvs[v as usize].as_dvec2() * DVec2::new(across, along);
    }
    places
}

fn dot(a: &[DVec2], b: &[DVec2]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.dot(*b)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::icosphere;
    use glam::Vec2;

    /// A grid of so many squares a side, bent by `bend`, with leaf coordinates or without.
    fn grid(side: usize, has_uvs: bool, bend: impl Fn(f32, f32) -> Vec3) -> Mesh {
        let at = |k: usize| k as f32 / side as f32;
        let corners = (0..=side).flat_map(|j| (0..=side).map(move |i| (at(i), at(j))));
        let positions = corners.clone().map(|(u, v)| bend(u, v)).collect();
        let uvs = corners.map(|(u, v)| Vec2::new(2.0 * u - 1.0, v)).filter(|_| has_uvs).collect();
        let n = side as u32 + 1;
        let squares = (0..n - 1).flat_map(|j| (0..n - 1).map(move |i| j * n + i));
        let triangles = squares.flat_map(|a| [[a, a + 1, a + n + 1], [a, a + n + 1, a + n]]);
        Mesh::new(positions, uvs, triangles.collect()).unwrap()
    }

    #[test]
    fn half_a_tube_becomes_a_rectangle() {
        for has_uvs in [true, false] {
            let mesh = grid(24, has_uvs, |u, v| {
                let (sin, cos) = libm::sincosf(std::f32::consts::PI * (0.9 * u + 0.05));
                Vec3::new(-3.0 * cos, 3.0 * sin, -5.0 * v)
            });
            let sheet = lay_flat(&mesh, 0).unwrap();
            assert!(sheet.stretch < 1e-4, "{}", sheet.stretch);
            let [a, b, c] = [0, 24, 624].map(|v: usize| sheet.places[v]);
            // 24 chords of 3 cm of radius, and 5 cm.
            let chord = 6.0 * libm::sin(std::f64::consts::PI * 0.9 / 48.0);
            assert!((a.distance(b) / (24.0 * chord) - 1.0).abs() < 1e-3, "{}", a.distance(b));
            assert!((b.distance(c) / 5.0 - 1.0).abs() < 1e-3, "{}", b.distance(c));
            assert!((b - a).perp_dot(c - a) > 0.0, "seen from outside");
        }
    }

    #[test]
    fn a_ball_is_not_laid_flat_nor_most_of_one() {
        assert_eq!(lay_flat(&icosphere(2, 5.0), 0).unwrap_err(), NotFlat::NoDisc);
        let bowl = grid(20, false, |u, v| Vec3::new(2.0 * u - 1.0, 1.0, 1.0 - 2.0 * v).normalize());
        assert!(
            lay_flat(&bowl, 0).unwrap().stretch > 0.01,
            "a sixth of a ball is stretched a little"
        );
        let most = grid(20, false, |u, v| {
            let (turn, down) = (libm::sincosf(6.0 * u), libm::sincosf(0.2 + 2.6 * v));
            Vec3::new(down.0 * turn.1, down.1, down.0 * turn.0)
        });
        assert!(matches!(lay_flat(&most, 0), Err(NotFlat::Stretched(_))));
    }
}
