//! The Voronoi polygons of the cells on the surface, cut at the triangles: by Delaunay
//! triangulation (spade) in the plane of each triangle. Slower than the site lists, and what they
//! are tested against; also what statistics and files are made from.

use crate::surface::{Charts, Frame, Mesh, Place};
use glam::Vec2;
use spade::{DelaunayTriangulation, HasPosition, Point2, Triangulation};

/// The part of a cell's Voronoi polygon that lies in one triangle.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    pub triangle: u32,
    pub cell: u32,
    /// Corners of a convex polygon in the triangle's frame, counter-clockwise, in centimetres.
    pub corners: Vec<Vec2>,
    /// For each side, from its corner to the next one, what is on its other side.
    pub across: Vec<Across>,
}

/// What is on the other side of a side of a piece.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Across {
    Cell(u32),
    /// The triangle ends, at its edge opposite this corner.
    Edge(u8),
}

impl Across {
    /// The cell, if it is one.
    pub fn cell(self) -> Option<u32> {
        match self {
            Across::Cell(cell) => Some(cell),
            Across::Edge(_) => None,
        }
    }
}

impl Piece {
    /// Area in square centimetres.
    pub fn area(&self) -> f32 {
        let fan = self.corners.windows(2).skip(1);
        fan.map(|pair| 0.5 * (pair[0] - self.corners[0]).perp_dot(pair[1] - self.corners[0])).sum()
    }
}

/// A site unfolded into the plane of a triangle.
#[derive(Clone, Copy, Debug)]
struct Site {
    point: Vec2,
    cell: u32,
}

impl HasPosition for Site {
    type Scalar = f64;

    fn position(&self) -> Point2<f64> {
        Point2::new(f64::from(self.point.x), f64::from(self.point.y))
    }
}

/// How far from a triangle sites are looked for at first, in mean spacings. Doubled until no polygon
/// can be cut by a site that was not found.
const FIRST_REACH: f32 = 2.0;

/// The polygons of all cells, triangle by triangle.
/// Triangles of a part without cells have none.
pub fn polygons(mesh: &Mesh, charts: &mut Charts, places: &[Place]) -> Vec<Piece> {
    let mut cells_of = vec![Vec::new(); mesh.triangles.len()];
    for (cell, place) in places.iter().enumerate() {
        cells_of[place.triangle as usize].push(cell as u32);
    }
    let mut populated = vec![false; mesh.part_count()];
    for place in places {
        populated[mesh.parts[place.triangle as usize] as usize] = true;
    }
    let spacing = (mesh.area / places.len() as f32).sqrt();
    let mut pieces = Vec::new();
    for triangle in 0..mesh.triangles.len() as u32 {
        if !populated[mesh.parts[triangle as usize] as usize] {
            continue;
        }
        let frame = &mesh.frames[triangle as usize];
        let mut reach = FIRST_REACH * spacing;
        loop {
            let sites = sites_within(charts, mesh, &cells_of, places, triangle, reach);
            let found = cut(frame, triangle, &sites);
            if is_complete(&found, &sites, reach) {
                pieces.extend(found);
                break;
            }
            reach *= 2.0;
        }
    }
    pieces
}

/// All sites in the triangles that come within `reach` of a triangle.
fn sites_within(
    charts: &mut Charts,
    mesh: &Mesh,
    cells_of: &[Vec<u32>],
    places: &[Place],
    triangle: u32,
    reach: f32,
) -> Vec<Site> {
    let images = charts.around(mesh, triangle, reach);
    let within = images.iter().take_while(|image| image.distance <= reach);
    within
        .flat_map(|image| {
            cells_of[image.triangle as usize].iter().map(|&cell| {
                let place = places[cell as usize];
                let point = image.laid.point(place.b1, place.b2);
                Site { point, cell }
            })
        })
        .collect()
}

/// Cuts a triangle along the bisectors of Delaunay neighbours.
fn cut(frame: &Frame, triangle: u32, sites: &[Site]) -> Vec<Piece> {
    let Ok(delaunay) = DelaunayTriangulation::<Site>::bulk_load(sites.to_vec()) else {
        return Vec::new();
    };
    delaunay
        .vertices()
        .filter_map(|vertex| {
            let own = vertex.data().point;
            let [a, b, c] = frame.corners();
            let edge = Across::Edge;
            let mut sides = vec![(a, edge(2)), (b, edge(0)), (c, edge(1))];
            for edge in vertex.out_edges() {
                sides = nearer(&sides, own, edge.to().data());
                if sides.is_empty() {
                    return None;
                }
            }
            let (corners, across) = sides.into_iter().unzip();
            Some(Piece { triangle, cell: vertex.data().cell, corners, across })
        })
        .collect()
}

/// The corner that a side of a polygon leaves, and what is across that side.
type Side = (Vec2, Across);

/// The part of a convex polygon that is nearer to `own` than to `other` (Sutherland-Hodgman).
fn nearer(sides: &[Side], own: Vec2, other: &Site) -> Vec<Side> {
    let middle = 0.5 * (own + other.point);
    let depth = |p: Vec2| (own - other.point).dot(p - middle);
    let mut kept = Vec::with_capacity(sides.len() + 1);
    for (k, &(from, across)) in sides.iter().enumerate() {
        let to = sides[(k + 1) % sides.len()].0;
        let (before, after) = (depth(from), depth(to));
        let crossing = || from + (to - from) * (before / (before - after));
        if before >= 0.0 {
            kept.push((from, across));
            if after < 0.0 {
                kept.push((crossing(), Across::Cell(other.cell)));
            }
        } else if after >= 0.0 {
            kept.push((crossing(), across));
        }
    }
    kept
}

/// Whether no site beyond the reach can change the pieces: each corner is nearer to its own site
/// than to the edge of what was looked at.
fn is_complete(pieces: &[Piece], sites: &[Site], reach: f32) -> bool {
    !pieces.is_empty()
        && pieces.iter().all(|piece| {
            let own = sites.iter().filter(|site| site.cell == piece.cell);
            piece.corners.iter().all(|&corner| {
                own.clone().map(|site| site.point.distance(corner)).fold(f32::INFINITY, f32::min)
                    <= reach
            })
        })
}
