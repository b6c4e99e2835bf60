//! The triangles around a triangle, unfolded into its plane (Turk91).

use super::lengths::{distance, length};
use super::sight::is_in_sight;
use super::{Mesh, NO_TWIN};
use glam::Vec2;
use wide::f32x4;

/// A triangle unfolded into the plane of another, the chart's home.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Image {
    pub triangle: u32,
    /// In a chart: the image is no nearer to the home triangle than this, in centimetres.
    pub distance: f32,
    pub laid: Laid,
}

/// Where a triangle lies in a plane: its corner 0, and the edges from there to corners 1 and 2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Laid {
    pub origin: Vec2,
    pub edge1: Vec2,
    pub edge2: Vec2,
}

impl Laid {
    /// With its corners at these points.
    pub fn at([a, b, c]: [Vec2; 3]) -> Laid {
        Laid { origin: a, edge1: b - a, edge2: c - a }
    }

    /// In a plane that is so many times larger.
    pub fn scaled(self, scale: f32) -> Laid {
        let Laid { origin, edge1, edge2 } = self;
        Laid { origin: origin * scale, edge1: edge1 * scale, edge2: edge2 * scale }
    }

    /// A place of the triangle, given by its `b1` and `b2`, as a point of the plane.
    pub fn point(&self, b1: f32, b2: f32) -> Vec2 {
        self.origin + self.edge1 * b1 + self.edge2 * b2
    }

    /// The same for four places.
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

    /// What a vector of the plane is to be multiplied with for its changes of `b1` and `b2`.
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
            builder: Builder::new(mesh),
        }
    }

    /// Forgets all charts.
    pub fn clear(&mut self) {
        self.images.clear();
        self.spans.fill(UNBUILT);
    }

    /// The images of all triangles within `radius` (centimetres) of a triangle, itself first, then
    /// by distance. More may follow: stop at the first whose `distance` is over the radius.
    pub fn around(&mut self, mesh: &Mesh, home: u32, radius: f32) -> &[Image] {
        if self.spans[home as usize].radius < radius {
            if self.images.len() > MAX_IMAGES {
                self.clear();
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
    /// The half-edge on the far side.
    twin: u32,
    left: Vec2,
    right: Vec2,
    /// The portal through which that image was entered, or `NONE`.
    before: u32,
    /// The next one that waits at the same step of distance, or `NONE`.
    next: u32,
}

const NONE: u32 = u32::MAX;

/// Distances up to the radius of a chart are told apart in so many steps.
const STEPS: usize = 64;

/// Where a triangle stands in a chart.
#[derive(Clone, Copy, Debug, Default)]
struct Seen {
    chart: u32,
    copies: [u32; MAX_COPIES],
    count: u32,
}

#[derive(Debug)]
struct Builder {
    portals: Vec<Portal>,
    /// For each step of distance the first and the last of the portals that wait there, if any does.
    waiting: [[u32; 2]; STEPS],
    /// The steps where some wait, as bits.
    steps: u64,
    /// The number of the chart under way.
    chart: u32,
    /// For each triangle the last chart in which it stood, and its images there.
    seen: Vec<Seen>,
    /// The ends of the portals that lead to one of them.
    chain: Vec<(Vec2, Vec2)>,
    /// For each half-edge the corner opposite to it, as shares of the edge along and across it.
    apexes: Vec<Vec2>,
}

impl Builder {
    fn new(mesh: &Mesh) -> Builder {
        let apexes = mesh.frames.iter().flat_map(|frame| {
            let corners = frame.corners();
            std::array::from_fn::<Vec2, 3, _>(|k| {
                let [from, to, apex] = [(k + 1) % 3, (k + 2) % 3, k].map(|k| corners[k]);
                let (edge, arm) = (to - from, apex - from);
                Vec2::new(edge.dot(arm), edge.perp_dot(arm)) / edge.length_squared()
            })
        });
        Builder {
            portals: Vec::new(),
            waiting: [[NONE; 2]; STEPS],
            steps: 0,
            chart: 0,
            seen: vec![Seen::default(); mesh.triangles.len()],
            chain: Vec::new(),
            apexes: apexes.collect(),
        }
    }

    fn build(&mut self, mesh: &Mesh, home: u32, radius: f32, images: &mut Vec<Image>) {
        let corners = mesh.frames[home as usize].corners();
        let disc = Disc::around(corners);
        let steps_per_cm = STEPS as f32 / radius;
        self.portals.clear();
        self.chart += 1;
        images.push(image(home, 0.0, corners));
        for k in 0..3 {
            // Seen from inside, an edge's first corner is on the right hand of who walks out.
            let (right, left) = (corners[(k + 1) % 3], corners[(k + 2) % 3]);
            self.push(mesh.twins[3 * home as usize + k], left, right, 0, NONE);
        }
        while let Some((step, number)) = self.pop() {
            let portal = self.portals[number as usize];
            let (triangle, entered) = (portal.twin / 3, portal.twin as usize % 3);
            let mut seen = self.seen[triangle as usize];
            if seen.chart != self.chart {
                seen = Seen { chart: self.chart, ..Seen::default() };
            }
            if triangle == home || seen.count as usize == MAX_COPIES {
                continue;
            }
            if seen.count > 0 {
                let known = images[seen.copies[0] as usize].laid.corners();
                let frame = &mesh.frames[triangle as usize];
                let near = SAME * frame.length.max(frame.apex.y);
                if same_edge(known, entered, &portal, near) || !self.sees_through(number) {
                    continue;
                }
            }
            let Portal { left, right, .. } = portal;
            let (edge, share) = (right - left, self.apexes[portal.twin as usize]);
            let apex = left + edge * share.x + edge.perp() * share.y;
            seen.copies[seen.count as usize] = images.len() as u32;
            seen.count += 1;
            self.seen[triangle as usize] = seen;
            // Who comes straight from home comes through the portal: nothing of the image is nearer.
            let turned = [apex, left, right, apex, left, right];
            let corners = std::array::from_fn(|k| turned[(3 - entered) % 3 + k]);
            images.push(image(triangle, step as f32 / steps_per_cm, corners));
            for (k, left, right) in [(1, apex, right), (2, left, apex)] {
                let farther = disc.distance(left, right);
                if farther <= radius {
                    let step = ((farther * steps_per_cm) as usize).clamp(step, STEPS - 1);
                    let half_edge = 3 * triangle as usize + (entered + k) % 3;
                    self.push(mesh.twins[half_edge], left, right, step, number);
                }
            }
        }
        // They came in the order of their distances: home first, then outwards.
    }

    fn push(&mut self, twin: u32, left: Vec2, right: Vec2, step: usize, before: u32) {
        if twin == NO_TWIN {
            return;
        }
        let number = self.portals.len() as u32;
        self.portals.push(Portal { twin, left, right, before, next: NONE });
        let [first, last] = &mut self.waiting[step];
        if self.steps & 1 << step == 0 {
            *first = number;
        } else {
            self.portals[*last as usize].next = number;
        }
        *last = number;
        self.steps |= 1 << step;
    }

    /// Takes the first of the nearest portals that wait: its step of distance and its number.
    fn pop(&mut self) -> Option<(usize, u32)> {
        let step = self.steps.trailing_zeros() as usize;
        let [first, _] = self.waiting.get_mut(step)?;
        let number = *first;
        *first = self.portals[number as usize].next;
        if *first == NONE {
            self.steps &= !(1 << step);
        }
        Some((step, number))
    }

    /// Whether some straight line passes through a portal and all portals before it.
    fn sees_through(&mut self, number: u32) -> bool {
        self.chain.clear();
        let mut next = number;
        while next != NONE {
            let portal = &self.portals[next as usize];
            self.chain.push((portal.left, portal.right));
            next = portal.before;
        }
        is_in_sight(&mut self.chain)
    }
}

pub(super) fn image(triangle: u32, distance: f32, corners: [Vec2; 3]) -> Image {
    Image { triangle, distance, laid: Laid::at(corners) }
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

    #[test]
    fn however_far_a_chart_reaches_around_a_body_it_has_two_images_of_a_triangle_at_most() {
        let mesh = crate::surface::icosphere(1, 1.0);
        let mut charts = Charts::new(&mesh);
        let mut most = 0;
        for home in 0..mesh.triangles.len() as u32 {
            let images = charts.around(&mesh, home, 12.0);
            let mut counts = vec![0; mesh.triangles.len()];
            images.iter().for_each(|image| counts[image.triangle as usize] += 1);
            assert_eq!((images[0].triangle, counts[home as usize]), (home, 1));
            assert!(counts.iter().all(|&count| count > 0), "all are within reach");
            most = most.max(*counts.iter().max().unwrap());
        }
        assert_eq!(most, 2);
    }

    #[test]
    fn portals_lie_on_the_same_edge_if_both_ends_are_near() {
        let known = [Vec2::ZERO, Vec2::X, Vec2::Y];
        for entered in 0..3 {
            let ends = [known[(entered + 1) % 3], known[(entered + 2) % 3]];
            for (shifts, is_same) in [
                ([0.0, 0.0], true),
                ([0.09, 0.09], true),
                ([0.11, 0.0], false),
                ([0.0, 0.11], false),
            ] {
                let [left, right] = [0, 1].map(|k| ends[k] + Vec2::X * shifts[k]);
                let portal = Portal { twin: 0, left, right, before: NONE, next: NONE };
                assert_eq!(same_edge(known, entered, &portal, 0.1), is_same, "{shifts:?}");
            }
        }
    }
}
