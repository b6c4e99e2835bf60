//! The triangles around a triangle, unfolded into its plane (Turk91).

use super::{Mesh, NO_TWIN};
use glam::Vec2;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// A triangle unfolded into the plane of another, the chart's home.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Image {
    pub triangle: u32,
    /// Least distance to the home triangle, in centimetres.
    pub distance: f32,
    /// Corner 0 in the home frame, and the edges from it to corners 1 and 2.
    pub origin: Vec2,
    pub edge1: Vec2,
    pub edge2: Vec2,
}

/// Which images of a triangle a chart keeps where several ways around a curved vertex lead to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Images {
    /// The one over the nearest edges: each neighbour counts once, as the forces need it.
    Nearest,
    /// All that can be seen from home in a straight line: the shortest way differs from point to
    /// point, as the mosaic needs it.
    Visible,
}

/// Charts of the triangles of one mesh, built when first asked for.
#[derive(Debug)]
pub struct Charts {
    kept: Images,
    spans: Vec<Span>,
    images: Vec<Image>,
    builder: Builder,
}

#[derive(Clone, Copy, Debug)]
struct Span {
    first: u32,
    count: u32,
    radius: f32,
}

const UNBUILT: Span = Span { first: 0, count: 0, radius: -1.0 };

/// Images held at most (32 bytes each): meshes far finer than the spacing of the cells would need
/// more, and have charts built again and again instead.
const MAX_IMAGES: usize = 4_000_000;

/// Images of one triangle in one chart at most. Two lie around one curved vertex; more are seen
/// only across several vertices at once.
const MAX_COPIES: usize = 4;

impl Charts {
    pub fn new(mesh: &Mesh, kept: Images) -> Charts {
        Charts {
            kept,
            spans: vec![UNBUILT; mesh.triangles.len()],
            images: Vec::new(),
            builder: Builder::default(),
        }
    }

    /// The images of all triangles within `radius` (centimetres) of a triangle, itself first, then
    /// by distance. More may follow: stop at the first whose `distance` is over the radius.
    pub fn around(&mut self, mesh: &Mesh, home: u32, radius: f32) -> &[Image] {
        if self.spans[home as usize].radius < radius {
            if self.images.len() > MAX_IMAGES {
                self.images.clear();
                self.spans.fill(UNBUILT);
            }
            let first = self.images.len();
            self.builder.build(mesh, home, radius, self.kept, &mut self.images);
            let count = (self.images.len() - first) as u32;
            self.spans[home as usize] = Span { first: first as u32, count, radius };
        }
        let span = self.spans[home as usize];
        &self.images[span.first as usize..(span.first + span.count) as usize]
    }
}

/// One way out of a chart: an edge of an image, and the edges crossed to come there.
#[derive(Clone, Copy, Debug)]
struct Portal {
    /// The half-edge as seen from the image it leads out of.
    half_edge: u32,
    left: Vec2,
    right: Vec2,
    /// The portal through which that image was entered.
    before: Option<u32>,
}

#[derive(Default, Debug)]
struct Builder {
    portals: Vec<Portal>,
    /// Waiting portals by (distance, crossings, number).
    waiting: BinaryHeap<Reverse<(u32, u32, u32)>>,
}

impl Builder {
    fn build(
        &mut self,
        mesh: &Mesh,
        home: u32,
        radius: f32,
        kept: Images,
        images: &mut Vec<Image>,
    ) {
        let first = images.len();
        let corners = mesh.frames[home as usize].corners();
        self.portals.clear();
        self.waiting.clear();
        images.push(image(home, 0.0, corners));
        self.push_edges(home, &corners, 3, None, 0, &corners, radius);
        while let Some(Reverse((_, crossings, number))) = self.waiting.pop() {
            let portal = self.portals[number as usize];
            let twin = mesh.twins[portal.half_edge as usize];
            if twin == NO_TWIN {
                continue;
            }
            let (triangle, entered) = (twin / 3, twin as usize % 3);
            let unfolded = unfold(mesh, twin as usize, portal.left, portal.right);
            let known = images[first..].iter().filter(|i| i.triangle == triangle);
            let copies = known.clone().count();
            if copies > 0 {
                let same = |i: &Image| same_image(i, &unfolded, &mesh.frames[triangle as usize]);
                if kept == Images::Nearest
                    || copies >= MAX_COPIES
                    || triangle == home
                    || known.clone().any(same)
                    || !self.sees_through(number)
                {
                    continue;
                }
            }
            let distance = triangle_distance(&unfolded, &corners);
            images.push(image(triangle, distance, unfolded));
            let way = (entered, Some(number), crossings + 1);
            self.push_edges(triangle, &unfolded, way.0, way.1, way.2, &corners, radius);
        }
        images[first..].sort_by(|a, b| a.distance.total_cmp(&b.distance));
        // Home has distance 0 as its neighbours have, and the sort is stable: it stays first.
    }

    #[allow(clippy::too_many_arguments)]
    fn push_edges(
        &mut self,
        triangle: u32,
        unfolded: &[Vec2; 3],
        entered: usize,
        before: Option<u32>,
        crossings: u32,
        home: &[Vec2; 3],
        radius: f32,
    ) {
        for k in (0..3).filter(|&k| k != entered) {
            // Seen from inside, the edge's first corner is on the right hand of who walks out.
            let (right, left) = (unfolded[(k + 1) % 3], unfolded[(k + 2) % 3]);
            let distance = if before.is_none() { 0.0 } else { segment_distance(left, right, home) };
            if distance > radius {
                continue;
            }
            let number = self.portals.len() as u32;
            self.portals.push(Portal { half_edge: 3 * triangle + k as u32, left, right, before });
            // Distances are not negative, so their bits order as they do.
            self.waiting.push(Reverse((distance.to_bits(), crossings, number)));
        }
    }

    /// Whether some straight line passes through a portal and all portals before it: such a line
    /// exists if one of those through a left and a right end does.
    fn sees_through(&self, number: u32) -> bool {
        let mut chain = Vec::with_capacity(8);
        let mut next = Some(number);
        while let Some(n) = next {
            let portal = &self.portals[n as usize];
            chain.push((portal.left, portal.right));
            next = portal.before;
        }
        let separates = |left: Vec2, right: Vec2, outwards: Vec2| {
            let slack = 1e-5 * outwards.length_squared();
            chain.iter().all(|&(l, r)| {
                outwards.perp_dot(l - left) >= -slack && outwards.perp_dot(r - right) <= slack
            })
        };
        // The chain runs from the outermost portal to home.
        chain.len() == 1
            || chain.iter().enumerate().any(|(i, &(left, _))| {
                chain.iter().enumerate().any(|(j, &(_, right))| {
                    let outwards = if i < j { left - right } else { right - left };
                    i != j && separates(left, right, outwards)
                })
            })
    }
}

fn image(triangle: u32, distance: f32, [a, b, c]: [Vec2; 3]) -> Image {
    Image { triangle, distance, origin: a, edge1: b - a, edge2: c - a }
}

/// The corners of the triangle behind half-edge `twin`, laid down at the portal `left`, `right`
/// through which it is entered.
fn unfold(mesh: &Mesh, twin: usize, left: Vec2, right: Vec2) -> [Vec2; 3] {
    let corners = mesh.frames[twin / 3].corners();
    let k = twin % 3;
    // The twin runs the other way: its first corner is the left end.
    let (from, to, apex) = (corners[(k + 1) % 3], corners[(k + 2) % 3], corners[k]);
    let (here, there) = ((to - from).normalize(), (right - left).normalize());
    let turn = Vec2::new(here.dot(there), here.perp_dot(there));
    let arm = apex - from;
    let mut unfolded = [Vec2::ZERO; 3];
    unfolded[(k + 1) % 3] = left;
    unfolded[(k + 2) % 3] = right;
    unfolded[k] =
        left + Vec2::new(turn.x * arm.x - turn.y * arm.y, turn.y * arm.x + turn.x * arm.y);
    unfolded
}

/// Whether two images of one triangle lie together, as on a flat surface: within a thousandth of
/// its size.
fn same_image(image: &Image, unfolded: &[Vec2; 3], frame: &super::mesh::Frame) -> bool {
    let near = 1e-3 * frame.length.max(frame.apex.y);
    image.origin.distance(unfolded[0]) < near
        && (image.origin + image.edge1).distance(unfolded[1]) < near
        && (image.origin + image.edge2).distance(unfolded[2]) < near
}

fn triangle_distance(a: &[Vec2; 3], b: &[Vec2; 3]) -> f32 {
    (0..3).map(|k| segment_distance(a[k], a[(k + 1) % 3], b)).fold(f32::INFINITY, f32::min)
}

/// Least distance between a segment and a triangle that it does not cross.
fn segment_distance(a: Vec2, b: Vec2, triangle: &[Vec2; 3]) -> f32 {
    let squared = (0..3)
        .map(|k| {
            let (p, q) = (triangle[k], triangle[(k + 1) % 3]);
            point_segment(p, a, b).min(point_segment(a, p, q)).min(point_segment(b, p, q))
        })
        .fold(f32::INFINITY, f32::min);
    squared.sqrt()
}

/// Squared distance between a point and a segment.
fn point_segment(p: Vec2, a: Vec2, b: Vec2) -> f32 {
    let along = ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
    p.distance_squared(a + (b - a) * along)
}
