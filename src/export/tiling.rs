//! The mosaic of a day as triangles: the Voronoi polygons of all cells, whose corners are one where they
//! meet.

use super::convex::Cutter;
use super::joints::Joints;
use crate::mosaic::polygons;
use crate::surface::{Charts, Mesh, Place};
use glam::{Vec2, Vec3};

/// A surface cut up along the borders of its cells. A corner that lies on the edge of another triangle of
/// the mesh is a corner of the polygons there, too: where the mesh is closed, so is this.
#[derive(Clone, Debug, Default)]
pub struct Tiling {
    pub points: Vec<Point>,
    pub facets: Vec<Facet>,
}

/// A point of the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// In centimetres.
    pub position: Vec3,
    /// The smooth unit normal.
    pub normal: Vec3,
}

/// A triangle within the polygon of one cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Facet {
    /// Numbers of points, counter-clockwise seen from outside.
    pub corners: [u32; 3],
    /// The triangle of the mesh that it is cut from.
    pub triangle: u32,
    /// Nobody on a part without cells.
    pub cell: Option<u32>,
}

impl Tiling {
    /// The mosaic of cells at these places. It takes about ten microseconds for each of their polygons.
    pub fn new(mesh: &Mesh, places: &[Place]) -> Tiling {
        let pieces = polygons(mesh, &mut Charts::new(mesh), places);
        let spacing = (mesh.area / places.len().max(1) as f32).sqrt();
        let joints = Joints::new(mesh, &pieces, spacing);
        let mut facets = Vec::new();
        let (mut cutter, mut cut) = (Cutter::default(), Vec::new());
        let (mut flat, mut numbers) = (Vec::new(), Vec::new());
        let mut has_pieces = vec![false; mesh.triangles.len()];
        for (k, piece) in pieces.iter().enumerate() {
            has_pieces[piece.triangle as usize] = true;
            joints.outline(mesh, piece, k, &mut numbers, &mut flat);
            cutter.cut(&flat, &mut cut);
            for corners in cut.iter().map(|t| t.map(|k| numbers[k])) {
                let [a, b, c] = corners;
                if a != b && b != c && c != a {
                    let cell = Some(piece.cell);
                    facets.push(Facet { corners, triangle: piece.triangle, cell });
                }
            }
        }
        for (triangle, &corners) in mesh.triangles.iter().enumerate() {
            if !has_pieces[triangle] {
                facets.push(Facet { corners, triangle: triangle as u32, cell: None });
            }
        }
        Tiling { points: joints.points, facets }
    }

    /// The corners of a facet in space.
    pub fn corners(&self, facet: &Facet) -> [Vec3; 3] {
        facet.corners.map(|point| self.points[point as usize].position)
    }

    /// The area of a facet in square centimetres.
    pub fn area(&self, facet: &Facet) -> f64 {
        let [a, b, c] = self.corners(facet).map(Vec3::as_dvec3);
        0.5 * (b - a).cross(c - a).length()
    }
}

impl Point {
    /// Between the corners of a triangle, where its barycentric coordinates are `b1` and `b2`.
    pub(super) fn within(mesh: &Mesh, triangle: u32, b: Vec2) -> Point {
        let between = |[a, b1, b2]: [Vec3; 3]| a + (b1 - a) * b.x + (b2 - a) * b.y;
        let normals = mesh.triangles[triangle as usize].map(|v| mesh.normals[v as usize]);
        let normal = between(normals).normalize_or(normals[0]);
        Point { position: between(mesh.corners(triangle)), normal }
    }

    /// On the way between two vertices.
    pub(super) fn between(mesh: &Mesh, [from, to]: [u32; 2], share: f32) -> Point {
        let [from, to] = [from, to].map(|v| Point::at(mesh, v));
        Point {
            position: from.position.lerp(to.position, share),
            normal: from.normal.lerp(to.normal, share).normalize_or(from.normal),
        }
    }

    pub(super) fn at(mesh: &Mesh, vertex: u32) -> Point {
        Point { position: mesh.positions[vertex as usize], normal: mesh.normals[vertex as usize] }
    }
}
