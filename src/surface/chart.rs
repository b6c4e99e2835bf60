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

    /// Whether some straight line passes through a portal and all portals before it.
    ///
    /// Seen along the way out, such a line `y = a + b x` runs below every left end and above every
    /// right end. For a slope `b` the room left for `a` is the least height over the left ends minus
    /// the greatest over the right ends: a concave function of `b`, whose greatest value is looked
    /// for by cutting planes (Kelley 1960).
    fn sees_through(&mut self, number: u32) -> bool {
        /// More slopes than are ever needed, but for rounding; then the image is kept.
        const MOST_SLOPES: usize = 12;
        let chain = &mut self.chain;
        chain.clear();
        let mut next = Some(number);
        while let Some(n) = next {
            let portal = &self.portals[n as usize];
            chain.push((portal.left, portal.right));
            next = portal.before;
        }
        let middle = |(left, right): (Vec2, Vec2)| 0.5 * (left + right);
        let (outermost, first) = (chain[0], chain[chain.len() - 1]);
        let along = middle(outermost) - middle(first);
        let length = length(along);
        if length == 0.0 {
            return true;
        }
        let (origin, x_axis) = (middle(first), along / length);
        for (left, right) in chain.iter_mut() {
            *left = turned_back(*left - origin, x_axis);
            *right = turned_back(*right - origin, x_axis);
        }
        let slack = 1e-5 * length;
        let (mut slope, mut low, mut high) = (0.0f32, f32::NEG_INFINITY, f32::INFINITY);
        for _ in 0..MOST_SLOPES {
            let (mut roof, mut floor) = (f32::INFINITY, f32::NEG_INFINITY);
            let (mut roof_x, mut floor_x) = (0.0, 0.0);
            for (left, right) in chain.iter() {
                let (over, under) = (left.y - slope * left.x, right.y - slope * right.x);
                if over < roof {
                    (roof, roof_x) = (over, left.x);
                }
                if under > floor {
                    (floor, floor_x) = (under, right.x);
                }
            }
            let room = roof - floor;
            if room >= -slack {
                return true;
            }
            // The room grows at most so quickly with the slope.
            let growth = floor_x - roof_x;
            if growth == 0.0 {
                return false;
            }
            let needed = slope - room / growth;
            if growth > 0.0 {
                low = low.max(needed)
            } else {
                high = high.min(needed)
            }
            if low > high {
                return false;
            }
            slope = needed;
        }
        true
    }
}

/// A vector in the frame whose x axis is a unit vector.
fn turned_back(v: Vec2, x_axis: Vec2) -> Vec2 {
    Vec2::new(x_axis.dot(v), x_axis.perp_dot(v))
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether a line through a left and a right end passes between all ends with this much room.
    fn passes(ends: &[(Vec2, Vec2)], room: f32) -> bool {
        let lines = ends.iter().flat_map(|&(l, _)| ends.iter().map(move |&(_, r)| (l, r)));
        lines.into_iter().any(|(l, r)| {
            // Outwards is up in these tests.
            let along = if l.y > r.y { l - r } else { r - l }.normalize_or_zero();
            ends.iter().all(|&(left, right)| {
                along.perp_dot(left - l) >= room && along.perp_dot(right - r) <= -room
            })
        })
    }

    #[test]
    fn a_portal_is_seen_through_if_a_line_through_two_ends_passes_all() {
        let mut state = 7u32;
        let mut chance = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) as f32 / (1 << 24) as f32
        };
        let mut seen = [0; 2];
        for _ in 0..20_000 {
            let count = 2 + (chance() * 9.0) as usize;
            let lean = chance() - 0.5;
            let ends: Vec<(Vec2, Vec2)> = (0..count)
                .map(|k| {
                    let (y, middle) = (k as f32 + 0.6 * chance(), lean * k as f32 + chance());
                    let half = 0.1 + 0.5 * chance();
                    let (left, right) = (middle - half, middle + half);
                    (Vec2::new(left, y), Vec2::new(right, y + 0.3 * chance()))
                })
                .collect();
            let mut builder = Builder::default();
            for (k, &(left, right)) in ends.iter().enumerate() {
                let before = k.checked_sub(1).map(|k| k as u32);
                builder.portals.push(Portal { half_edge: 0, left, right, before });
            }
            let [surely, perhaps] = [1e-3, -1e-3].map(|room| passes_with(&ends, room));
            let sees = builder.sees_through(count as u32 - 1);
            if surely == perhaps {
                assert_eq!(sees, surely, "{ends:?}");
                seen[usize::from(sees)] += 1;
            }
        }
        assert!(seen[0] > 2_000 && seen[1] > 2_000, "{seen:?}");
    }

    /// The same with the ends moved apart (or together) by so much.
    fn passes_with(ends: &[(Vec2, Vec2)], room: f32) -> bool {
        let narrow = Vec2::new(room, 0.0);
        let moved: Vec<_> = ends.iter().map(|&(l, r)| (l + narrow, r - narrow)).collect();
        passes(&moved, -1e-6)
    }
}
