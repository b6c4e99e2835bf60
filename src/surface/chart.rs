//! The triangles around a triangle, unfolded into its plane (Turk91).

use super::lengths::{distance, length, normalized};
use super::{Mesh, NO_TWIN};
use glam::Vec2;
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use wide::f32x4;

/// A triangle unfolded into the plane of another, the chart's home.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Image {
    pub triangle: u32,
    /// In a chart: the image is no nearer to the home triangle than this, in centimetres.
    pub distance: f32,
    /// Corner 0 in the home frame, and the edges from it to corners 1 and 2.
    pub origin: Vec2,
    pub edge1: Vec2,
    pub edge2: Vec2,
}

impl Image {
    /// Four places of the triangle, given by their `b1` and `b2`, as points of the home plane.
    #[inline]
    pub fn points(&self, b1: f32x4, b2: f32x4) -> (f32x4, f32x4) {
        let at = |origin: f32, edge1: f32, edge2: f32| {
            f32x4::splat(origin) + b1 * f32x4::splat(edge1) + b2 * f32x4::splat(edge2)
        };
        (
            at(self.origin.x, self.edge1.x, self.edge2.x),
            at(self.origin.y, self.edge1.y, self.edge2.y),
        )
    }

    pub fn corners(&self) -> [Vec2; 3] {
        [self.origin, self.origin + self.edge1, self.origin + self.edge2]
    }

    pub fn centroid(&self) -> Vec2 {
        self.origin + (self.edge1 + self.edge2) / 3.0
    }

    /// What a vector of the home plane is to be multiplied with for its changes of `b1` and `b2`.
    pub fn to_barycentric(&self) -> [Vec2; 2] {
        let per_area = 1.0 / self.edge1.perp_dot(self.edge2);
        [Vec2::new(self.edge2.y, -self.edge2.x), Vec2::new(-self.edge1.y, self.edge1.x)]
            .map(|v| v * per_area)
    }
}

/// Charts of the triangles of one mesh, built when first asked for. A chart holds all images of a
/// triangle that can be seen from home in a straight line: around a curved vertex the shortest way
/// differs from point to point.
#[derive(Debug)]
pub struct Charts {
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

/// Images of one triangle in one chart at most: the two that lie around one curved vertex. More are
/// seen only across several vertices at once, and each brings copies of all that lies behind it.
const MAX_COPIES: usize = 2;

impl Charts {
    pub fn new(mesh: &Mesh) -> Charts {
        Charts {
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
            self.builder.build(mesh, home, radius, &mut self.images);
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

/// Where a triangle stands in a chart.
#[derive(Clone, Copy, Debug, Default)]
struct Seen {
    chart: u32,
    copies: [u32; MAX_COPIES],
    count: u32,
}

#[derive(Default, Debug)]
struct Builder {
    portals: Vec<Portal>,
    /// Waiting portals by distance, then number, in one word.
    waiting: BinaryHeap<Reverse<u64>>,
    /// The number of the chart under way.
    chart: u32,
    /// For each triangle the last chart in which it stood, and its images there.
    seen: Vec<Seen>,
    /// The ends of the portals that lead to one of them.
    chain: Vec<(Vec2, Vec2)>,
}

impl Builder {
    fn build(&mut self, mesh: &Mesh, home: u32, radius: f32, images: &mut Vec<Image>) {
        let corners = mesh.frames[home as usize].corners();
        let disc = Disc::around(corners);
        self.portals.clear();
        self.waiting.clear();
        self.chart += 1;
        self.seen.resize(mesh.triangles.len(), Seen::default());
        images.push(image(home, 0.0, corners));
        for k in 0..3 {
            self.push_edge(3 * home + k as u32, &corners, 0.0, None);
        }
        while let Some(Reverse(waiting)) = self.waiting.pop() {
            let (distance, number) = (f32::from_bits((waiting >> 32) as u32), waiting as u32);
            let portal = self.portals[number as usize];
            let twin = mesh.twins[portal.half_edge as usize];
            if twin == NO_TWIN {
                continue;
            }
            let (triangle, entered) = (twin / 3, twin as usize % 3);
            let mut seen = self.seen[triangle as usize];
            if seen.chart != self.chart {
                seen = Seen { chart: self.chart, ..Seen::default() };
            }
            if triangle == home || seen.count as usize == MAX_COPIES {
                continue;
            }
            if seen.count > 0 {
                let known = images[seen.copies[0] as usize].corners();
                let frame = &mesh.frames[triangle as usize];
                let near = SAME * frame.length.max(frame.apex.y);
                if same_edge(known, entered, &portal, near) || !self.sees_through(number) {
                    continue;
                }
            }
            let unfolded = unfold(mesh, twin as usize, portal.left, portal.right);
            seen.copies[seen.count as usize] = images.len() as u32;
            seen.count += 1;
            self.seen[triangle as usize] = seen;
            // Who comes straight from home comes through the portal: nothing of the image is nearer.
            images.push(image(triangle, distance, unfolded));
            for k in [(entered + 1) % 3, (entered + 2) % 3] {
                let farther = disc.distance(unfolded[(k + 1) % 3], unfolded[(k + 2) % 3]);
                let farther = farther.max(distance);
                if farther <= radius {
                    self.push_edge(3 * triangle + k as u32, &unfolded, farther, Some(number));
                }
            }
        }
        // Popped in the order of their distances: home first, then outwards.
    }

    fn push_edge(
        &mut self,
        half_edge: u32,
        unfolded: &[Vec2; 3],
        distance: f32,
        before: Option<u32>,
    ) {
        // Seen from inside, the edge's first corner is on the right hand of who walks out.
        let k = half_edge as usize % 3;
        let (right, left) = (unfolded[(k + 1) % 3], unfolded[(k + 2) % 3]);
        let number = self.portals.len() as u32;
        self.portals.push(Portal { half_edge, left, right, before });
        // Distances are not negative, so their bits order as they do.
        self.waiting.push(Reverse(u64::from(distance.to_bits()) << 32 | u64::from(number)));
    }

    /// Whether some straight line passes through a portal and all portals before it: such a line
    /// exists if one of those through a left and a right end does.
    fn sees_through(&mut self, number: u32) -> bool {
        let chain = &mut self.chain;
        chain.clear();
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

pub(super) fn image(triangle: u32, distance: f32, [a, b, c]: [Vec2; 3]) -> Image {
    Image { triangle, distance, origin: a, edge1: b - a, edge2: c - a }
}

/// The corners of the triangle behind half-edge `twin`, laid down at the portal `left`, `right`
/// through which it is entered.
pub(super) fn unfold(mesh: &Mesh, twin: usize, left: Vec2, right: Vec2) -> [Vec2; 3] {
    let corners = mesh.frames[twin / 3].corners();
    let k = twin % 3;
    // The twin runs the other way: its first corner is the left end.
    let (from, to, apex) = (corners[(k + 1) % 3], corners[(k + 2) % 3], corners[k]);
    let (here, there) = (normalized(to - from), normalized(right - left));
    let turn = Vec2::new(here.dot(there), here.perp_dot(there));
    let arm = apex - from;
    let mut unfolded = [Vec2::ZERO; 3];
    unfolded[(k + 1) % 3] = left;
    unfolded[(k + 2) % 3] = right;
    unfolded[k] =
        left + Vec2::new(turn.x * arm.x - turn.y * arm.y, turn.y * arm.x + turn.x * arm.y);
    unfolded
}

/// Two images of a triangle that lie this near to each other, as a share of its size, count as one.
/// Smaller, and each is there twice on every gentle curve; larger, and polygons show steps where
/// they pass from one triangle to the next.
const SAME: f32 = 0.01;

/// Whether the portal through which a triangle is entered lies on the same edge of an image of it
/// that is there already: then a second one would lie on the first, as on a nearly flat surface.
fn same_edge(known: [Vec2; 3], entered: usize, portal: &Portal, near: f32) -> bool {
    // The edge runs the other way seen from this side.
    known[(entered + 1) % 3].distance_squared(portal.left) < near * near
        && known[(entered + 2) % 3].distance_squared(portal.right) < near * near
}

/// The disc around a chart's home, from which distances are taken: never more than from the triangle
/// itself, and found in a third of the time.
struct Disc {
    centre: Vec2,
    radius: f32,
}

impl Disc {
    fn around(corners: [Vec2; 3]) -> Disc {
        let centre = (corners[0] + corners[1] + corners[2]) / 3.0;
        let radius = corners.iter().map(|&c| distance(c, centre)).fold(0.0, f32::max);
        Disc { centre, radius }
    }

    /// Distance of a line segment.
    fn distance(&self, from: Vec2, to: Vec2) -> f32 {
        let (edge, arm) = (to - from, self.centre - from);
        let along = (arm.dot(edge) / edge.length_squared()).clamp(0.0, 1.0);
        (length(arm - edge * along) - self.radius).max(0.0)
    }
}
