//! The direction field: a unit vector in the plane of each triangle, led by a few control vectors
//! through radial basis functions (Thesis 3.2.4).

use super::{Frame, Mesh, Place, Shortest};
use glam::{DVec3, Vec2, Vec3};

/// A control vector on a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Guide {
    pub triangle: u32,
    /// In space, of any length; what counts is its part in the triangle's plane.
    pub direction: Vec3,
}

/// Why control vectors do not make a field.
#[derive(Clone, Debug, thiserror::Error, PartialEq)]
pub enum FieldError {
    #[error("epsilon is {} per cm: it must be over 0", .0.shortest())]
    Epsilon(f64),
    #[error("a control vector stands on triangle {triangle}, but there are only {count}")]
    NoSuchTriangle { triangle: u32, count: usize },
    #[error("the control vector on triangle {0} has no direction in the triangle's plane")]
    Upright(u32),
    #[error("the control vector on triangle {0} is too near to others for its epsilon")]
    Crowded(u32),
}

/// A direction on each triangle of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct DirectionField {
    /// In the triangles' own frames, of length 1, or 0 where there is no direction.
    directions: Vec<Vec2>,
}

/// Projections shorter than this have no direction: control vectors are of length 1, and where they
/// cancel out the rounding of the centroids alone leaves up to a few ten-millionths.
const SHORTEST: f64 = 1e-6;

/// The least pivot of the solution. Below it the interpolation returns the control vectors with
/// fewer digits than an f32 has; above it vectors on neighbouring triangles would be refused.
const LEAST_PIVOT: f64 = 1e-10;

impl DirectionField {
    /// Leads the control vectors, projected and normalised, over their parts of the mesh with the
    /// inverse multiquadric `1 / sqrt(1 + (epsilon rho)^2)`, where `rho` is the straight distance
    /// of two centroids in cm. A vector leads its own part alone. Parts without control vectors
    /// have no direction, nor have triangles in whose plane the control vectors cancel out.
    pub fn new(
        mesh: &Mesh,
        guides: &[Guide],
        epsilon_per_cm: f64,
    ) -> Result<DirectionField, FieldError> {
        if !(epsilon_per_cm > 0.0 && epsilon_per_cm.is_finite()) {
            return Err(FieldError::Epsilon(epsilon_per_cm));
        }
        let count = mesh.triangles.len();
        if let Some(&Guide { triangle, .. }) = guides.iter().find(|g| g.triangle as usize >= count)
        {
            return Err(FieldError::NoSuchTriangle { triangle, count });
        }
        let mut leads = Vec::new();
        for part in 0..mesh.part_count() as u32 {
            let on_part = |guide: &&Guide| mesh.parts[guide.triangle as usize] == part;
            let guides: Vec<Guide> = guides.iter().filter(on_part).copied().collect();
            leads.push(Lead::new(mesh, &guides, epsilon_per_cm)?);
        }
        let direction = |triangle: u32| {
            let lead = &leads[mesh.parts[triangle as usize] as usize];
            in_plane(mesh, triangle, lead.at(mesh.centroid(triangle).as_dvec3()))
        };
        let directions = (0..count as u32).map(|t| direction(t).unwrap_or(Vec2::ZERO)).collect();
        Ok(DirectionField { directions })
    }

    /// Each triangle goes the way of the vein up to an order that is nearest to its centre, as that goes from its
    /// foot. None where there is no such vein.
    pub fn along_veins(mesh: &Mesh, order: u32) -> Option<DirectionField> {
        if !mesh.veins.any(order) {
            return None;
        }
        let direction = |triangle| {
            let centre = Place { triangle, b1: 1.0 / 3.0, b2: 1.0 / 3.0 };
            let way = mesh.veins.way(mesh, centre, order)?.as_dvec3().normalize_or_zero();
            in_plane(mesh, triangle, way)
        };
        let triangles = 0..mesh.triangles.len() as u32;
        let directions = triangles.map(|triangle| direction(triangle).unwrap_or(Vec2::ZERO));
        Some(DirectionField { directions: directions.collect() })
    }

    /// The same field on a mesh of the same triangles whose corners have moved: a line along it that is drawn
    /// on the skin goes with the skin.
    pub fn carried(&self, rest: &Mesh, moved: &Mesh) -> DirectionField {
        let carry = |direction: Vec2, from: &Frame, to: &Frame| {
            let [b1, b2] = from.barycentric(direction).to_array();
            let [x, y] = to.point(b1, b2).to_array();
            let length = (x * x + y * y).sqrt();
            if length > 0.0 { Vec2::new(x / length, y / length) } else { Vec2::ZERO }
        };
        let frames = rest.frames.iter().zip(&moved.frames);
        let carried = self.directions.iter().zip(frames).map(|(&d, (from, to))| carry(d, from, to));
        DirectionField { directions: carried.collect() }
    }

    /// The unit vector of a triangle in its own frame, or zero where there is no direction.
    #[inline]
    pub fn at(&self, triangle: u32) -> Vec2 {
        self.directions[triangle as usize]
    }
}

/// The vector field in space that the control vectors of one part span; zero without any.
struct Lead {
    epsilon_per_cm: f64,
    centres: Vec<DVec3>,
    weights: Vec<DVec3>,
}

impl Lead {
    fn new(mesh: &Mesh, guides: &[Guide], epsilon_per_cm: f64) -> Result<Lead, FieldError> {
        let centres: Vec<DVec3> =
            guides.iter().map(|g| mesh.centroid(g.triangle).as_dvec3()).collect();
        let mut controls = Vec::new();
        for guide in guides {
            let direction = guide.direction.as_dvec3().normalize_or_zero();
            let flat = in_plane(mesh, guide.triangle, direction);
            let flat = flat.ok_or(FieldError::Upright(guide.triangle))?;
            let [x, y] = mesh.axes(guide.triangle);
            controls.push((x * flat.x + y * flat.y).as_dvec3());
        }
        let mut lead = Lead { epsilon_per_cm, centres, weights: Vec::new() };
        let matrix = |i: usize, j: usize| lead.basis(lead.centres[i], lead.centres[j]);
        let solved = solve(matrix, controls);
        lead.weights = solved.map_err(|row| FieldError::Crowded(guides[row].triangle))?;
        Ok(lead)
    }

    fn at(&self, point: DVec3) -> DVec3 {
        self.centres.iter().zip(&self.weights).map(|(&c, &w)| w * self.basis(point, c)).sum()
    }

    fn basis(&self, a: DVec3, b: DVec3) -> f64 {
        let squared = (a - b).length_squared() * self.epsilon_per_cm * self.epsilon_per_cm;
        1.0 / (1.0 + squared).sqrt()
    }
}

/// The direction of a vector's part in a triangle's plane, in its frame, if it has one.
fn in_plane(mesh: &Mesh, triangle: u32, vector: DVec3) -> Option<Vec2> {
    let [x, y] = mesh.axes(triangle).map(|axis| vector.dot(axis.as_dvec3()));
    let length = (x * x + y * y).sqrt();
    (length > SHORTEST).then(|| Vec2::new((x / length) as f32, (y / length) as f32))
}

/// Solves `A x = b` by Cholesky's method for a symmetric matrix, given by its entries, that is
/// positive definite, as that of an inverse multiquadric at different points is (Micchelli 1986).
/// The error is the first row that says hardly more than the rows before it.
fn solve(entry: impl Fn(usize, usize) -> f64, mut b: Vec<DVec3>) -> Result<Vec<DVec3>, usize> {
    let n = b.len();
    let mut lower = vec![vec![0.0; n]; n];
    for i in 0..n {
        for j in 0..=i {
            let known: f64 = (0..j).map(|k| lower[i][k] * lower[j][k]).sum();
            let rest = entry(i, j) - known;
            if i == j && rest < LEAST_PIVOT {
                return Err(i);
            }
            lower[i][j] = if i == j { rest.sqrt() } else { rest / lower[j][j] };
        }
    }
    for i in 0..n {
        let known: DVec3 = (0..i).map(|k| b[k] * lower[i][k]).sum();
        b[i] = (b[i] - known) / lower[i][i];
    }
    for i in (0..n).rev() {
        let known: DVec3 = (i + 1..n).map(|k| b[k] * lower[k][i]).sum();
        b[i] = (b[i] - known) / lower[i][i];
    }
    Ok(b)
}
