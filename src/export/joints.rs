//! Where polygons meet: corners that are the same but for rounding become one point.
//!
//! Polygons are found triangle by triangle, each in its own plane, so those on both sides of an edge of the
//! mesh know nothing of each other. Corners on an edge are sorted along it and belong to both sides.

use super::tiling::Point;
use crate::mosaic::{Across, Piece};
use crate::surface::Mesh;
use glam::Vec2;

/// Corners this near to each other are one, in mean spacings of the cells: a fiftieth of a drawn border.
const SAME_SPACINGS: f32 = 6e-4;

/// The points of a mesh and the polygons on it.
pub struct Joints {
    /// First those of the mesh, by their numbers there.
    pub points: Vec<Point>,
    /// The point of each corner, polygon by polygon.
    numbers: Vec<u32>,
    /// Where the corners of each polygon begin there, and the end of the last.
    starts: Vec<usize>,
    /// For each edge of the mesh, by the lower of its half-edges, the points on it in their order.
    edges: Vec<Vec<OnEdge>>,
}

#[derive(Clone, Copy)]
struct OnEdge {
    /// Share of the way along the edge, over 0 and under 1.
    share: f32,
    point: u32,
}

/// A corner on an edge.
struct Mark {
    edge: u32,
    share: f32,
    /// Among all corners.
    corner: usize,
}

impl Joints {
    /// `spacing`: the mean one of the cells, in centimetres. The pieces stand triangle by triangle.
    pub fn new(mesh: &Mesh, pieces: &[Piece], spacing: f32) -> Joints {
        let mut starts = vec![0];
        for piece in pieces {
            starts.push(starts[starts.len() - 1] + piece.corners.len());
        }
        let vertices = 0..mesh.positions.len() as u32;
        let mut joints = Joints {
            points: vertices.map(|v| Point::at(mesh, v)).collect(),
            numbers: vec![NOBODY; starts[pieces.len()]],
            starts,
            edges: vec![Vec::new(); mesh.twins.len()],
        };
        let same = SAME_SPACINGS * spacing;
        joints.join_on_edges(mesh, pieces, same);
        let mut first = 0;
        for of_one in pieces.chunk_by(|a, b| a.triangle == b.triangle) {
            joints.join_within(mesh, of_one, first, same);
            first += of_one.len();
        }
        joints
    }

    /// The outline of a piece, the `k`-th: its points and where they lie in the triangle's plane, with those on
    /// its sides that other polygons brought there. Points that became one are named once.
    pub fn outline(
        &self,
        mesh: &Mesh,
        piece: &Piece,
        k: usize,
        numbers: &mut Vec<u32>,
        flat: &mut Vec<Vec2>,
    ) {
        numbers.clear();
        flat.clear();
        let own = &self.numbers[self.starts[k]..self.starts[k + 1]];
        for (side, (&corner, &number)) in piece.corners.iter().zip(own).enumerate() {
            numbers.push(number);
            flat.push(corner);
            if let Across::Edge(edge) = piece.across[side] {
                let to = own[(side + 1) % own.len()];
                self.add_between(mesh, piece.triangle, edge, [number, to], numbers, flat);
            }
        }
        let mut kept = 0;
        for k in 0..numbers.len() {
            if kept == 0 || numbers[k] != numbers[kept - 1] {
                (numbers[kept], flat[kept]) = (numbers[k], flat[k]);
                kept += 1;
            }
        }
        if kept > 1 && numbers[kept - 1] == numbers[0] {
            kept -= 1;
        }
        numbers.truncate(kept);
        flat.truncate(kept);
    }

    /// The points on an edge of a triangle that lie between two others.
    fn add_between(
        &self,
        mesh: &Mesh,
        triangle: u32,
        edge: u8,
        ends: [u32; 2],
        numbers: &mut Vec<u32>,
        flat: &mut Vec<Vec2>,
    ) {
        let (canonical, turned) = canonical(mesh, triangle, edge);
        let on_edge = &self.edges[canonical as usize];
        // From 0, the vertex where the edge begins, to one behind the last point, where it ends.
        let [first, last] = vertices(mesh, canonical);
        let at = |number: u32| match on_edge.iter().position(|other| other.point == number) {
            Some(k) => Some(k + 1),
            None if number == first => Some(0),
            None if number == last => Some(on_edge.len() + 1),
            None => None,
        };
        let [Some(from), Some(to)] = ends.map(at) else { return };
        let [a, b] = ends_in_plane(mesh, triangle, edge);
        let mut add = |k: usize| {
            let share = if turned { 1.0 - on_edge[k].share } else { on_edge[k].share };
            numbers.push(on_edge[k].point);
            flat.push(a.lerp(b, share));
        };
        // Points are numbered from 1 here, and both ends are left out.
        if turned {
            (to..from.saturating_sub(1)).rev().for_each(&mut add);
        } else {
            (from..to.saturating_sub(1)).for_each(&mut add);
        }
    }

    /// Numbers all corners that lie at vertices and on edges.
    fn join_on_edges(&mut self, mesh: &Mesh, pieces: &[Piece], same: f32) {
        let mut marks = Vec::new();
        for (k, piece) in pieces.iter().enumerate() {
            let corners = mesh.frames[piece.triangle as usize].corners();
            for (c, &corner) in piece.corners.iter().enumerate() {
                let number = self.starts[k] + c;
                if let Some(v) = corners.iter().position(|&vertex| vertex == corner) {
                    self.numbers[number] = mesh.triangles[piece.triangle as usize][v];
                    continue;
                }
                let before = (c + piece.corners.len() - 1) % piece.corners.len();
                let sides = [piece.across[c], piece.across[before]];
                let edge = sides.into_iter().find_map(|side| match side {
                    Across::Edge(edge) => Some(edge),
                    Across::Cell(_) => None,
                });
                let Some(edge) = edge else { continue };
                let (canonical, turned) = canonical(mesh, piece.triangle, edge);
                let [a, b] = ends_in_plane(mesh, piece.triangle, edge);
                let share = (corner - a).dot(b - a) / (b - a).length_squared();
                let share = if turned { 1.0 - share } else { share };
                marks.push(Mark { edge: canonical, share, corner: number });
            }
        }
        marks.sort_unstable_by(|a, b| {
            a.edge.cmp(&b.edge).then(a.share.total_cmp(&b.share)).then(a.corner.cmp(&b.corner))
        });
        for of_edge in marks.chunk_by(|a, b| a.edge == b.edge) {
            let edge = of_edge[0].edge;
            let ends = vertices(mesh, edge);
            let [a, b] = ends.map(|v| mesh.positions[v as usize]);
            let near = same / a.distance(b);
            for mark in of_edge {
                let known = self.edges[edge as usize].last();
                let number = match known {
                    _ if mark.share <= near => ends[0],
                    _ if mark.share >= 1.0 - near => ends[1],
                    Some(last) if mark.share - last.share <= near => last.point,
                    _ => {
                        let point = self.points.len() as u32;
                        self.points.push(Point::between(mesh, ends, mark.share));
                        self.edges[edge as usize].push(OnEdge { share: mark.share, point });
                        point
                    }
                };
                self.numbers[mark.corner] = number;
            }
        }
    }

    /// Numbers the corners inside a triangle, whose pieces these are; `first` of all.
    fn join_within(&mut self, mesh: &Mesh, pieces: &[Piece], first: usize, same: f32) {
        let triangle = pieces[0].triangle;
        let mut known: Vec<(Vec2, u32)> = Vec::new();
        // On the rim of the triangle corners have their points already.
        let mut inside: Vec<(Vec2, usize)> = Vec::new();
        for (k, piece) in pieces.iter().enumerate() {
            for (c, &corner) in piece.corners.iter().enumerate() {
                let number = self.starts[first + k] + c;
                match self.numbers[number] {
                    NOBODY => inside.push((corner, number)),
                    point => known.push((corner, point)),
                }
            }
        }
        let by_x = |a: &Vec2, b: &Vec2| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y));
        known.sort_unstable_by(|a, b| by_x(&a.0, &b.0).then(a.1.cmp(&b.1)));
        inside.sort_unstable_by(|a, b| by_x(&a.0, &b.0).then(a.1.cmp(&b.1)));
        let mut fresh: Vec<(Vec2, u32)> = Vec::new();
        for (corner, number) in inside {
            let is_near = |other: &&(Vec2, u32)| other.0.distance_squared(corner) <= same * same;
            let from = known.partition_point(|other| other.0.x < corner.x - same);
            let on_rim = known[from..].iter().take_while(|other| other.0.x <= corner.x + same);
            let before = fresh.iter().rev().take_while(|other| other.0.x >= corner.x - same);
            let met = on_rim.chain(before).find(is_near).map(|other| other.1);
            self.numbers[number] = met.unwrap_or_else(|| {
                let point = self.points.len() as u32;
                let b = mesh.frames[triangle as usize].barycentric(corner);
                self.points.push(Point::within(mesh, triangle, b));
                fresh.push((corner, point));
                point
            });
        }
    }
}

/// The number of a corner that has no point yet.
const NOBODY: u32 = u32::MAX;

/// The half-edge that stands for an edge of a triangle, and whether it runs the other way.
fn canonical(mesh: &Mesh, triangle: u32, edge: u8) -> (u32, bool) {
    let half_edge = 3 * triangle + u32::from(edge);
    let twin = mesh.twins[half_edge as usize];
    if twin < half_edge { (twin, true) } else { (half_edge, false) }
}

/// The vertices from which and to which a half-edge runs.
fn vertices(mesh: &Mesh, half_edge: u32) -> [u32; 2] {
    let (t, k) = (mesh.triangles[half_edge as usize / 3], half_edge as usize % 3);
    [t[(k + 1) % 3], t[(k + 2) % 3]]
}

/// The same in the plane of the triangle.
fn ends_in_plane(mesh: &Mesh, triangle: u32, edge: u8) -> [Vec2; 2] {
    let corners = mesh.frames[triangle as usize].corners();
    [1, 2].map(|k| corners[(edge as usize + k) % 3])
}
