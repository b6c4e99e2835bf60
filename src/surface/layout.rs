//! Lays patches down in the plane: unfolds their triangles and those around, and closes the gaps that
//! curvature leaves between them.

use super::chart::{Image, image};
use super::fitting::Fitting;
use super::lengths::{distance, normalized};
use super::outline::Outline;
use super::{Mesh, NO_TWIN};
use glam::Vec2;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// How well a patch lies in the plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Fit {
    /// Neighbours lie far apart: each triangle is where the shortest way to it leads.
    Torn,
    /// Neighbours lie edge to edge, and edges are stretched more than `FLAT` allows.
    Bent,
    Flat,
}

/// What laying a patch flat may stretch or shrink its edges by, in the mean and at most. More, and the
/// rims of patches show as lines of narrower cells; less, and curved bodies fall into patches of a few
/// triangles, which cost several times as much.
pub(super) const FLAT: Stretch = Stretch { mean: 0.02, most: 0.12 };

/// Changes of lengths, as shares of the lengths.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stretch {
    pub(super) mean: f32,
    pub(super) most: f32,
}

/// Neighbours that lie farther apart than this share of the reach are no neighbours in the plane: the
/// patch reaches around a narrow body, or over a sharp tip.
const WIDEST_GAP: f32 = 0.3;

/// Where torn patches may be wide, no way leads farther around them than so many reaches: on a crumpled body
/// even the farthest triangle may come to lie near.
const LONGEST_WAY: f32 = 2.0;

/// A triangle that would keep less than this share of its area is not laid down.
const LEAST_AREA: f32 = 0.3;

/// An edge to go on over.
#[derive(Clone, Copy, Debug)]
struct Portal {
    /// The half-edge on the far side.
    twin: u32,
    left: Vec2,
    right: Vec2,
    /// How long the way was to its middle, from middle to middle, since it led out of the patch.
    way: f32,
}

impl Portal {
    fn middle(&self) -> Vec2 {
        0.5 * (self.left + self.right)
    }
}

/// A portal by its squared distance from the centre and its number, in one integer, which is the
/// quickest to compare: distances are not negative, so their bits order as they do.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Waiting(u64);

impl Waiting {
    fn new(distance_squared: f32, portal: usize) -> Waiting {
        Waiting(u64::from(distance_squared.to_bits()) << 32 | portal as u64)
    }

    fn portal(self) -> usize {
        self.0 as u32 as usize
    }
}

/// No image of a triangle.
const NONE: u32 = u32::MAX;

/// Lays patches down in the plane, one after the other.
pub(super) struct Layout<'a> {
    mesh: &'a Mesh,
    reach: f32,
    longest_way: f32,
    /// Of the patch laid down last, its own triangles first.
    pub(super) images: Vec<Image>,
    pub(super) outline: Outline,
    /// For each triangle its index in `images`, or `NONE`.
    image_of: Vec<u32>,
    is_own: Vec<bool>,
    fitting: Fitting,
    centre: Vec2,
    portals: Vec<Portal>,
    /// Waiting portals, the nearest to the centre first.
    waiting: BinaryHeap<Reverse<Waiting>>,
    /// Whether neighbours have been found that lie far apart.
    is_torn: bool,
}

impl<'a> Layout<'a> {
    pub(super) fn new(mesh: &'a Mesh, reach: f32, has_wide_torn: bool) -> Layout<'a> {
        Layout {
            mesh,
            // Room for what fitting shifts.
            reach: (1.0 + FLAT.most) * reach,
            longest_way: if has_wide_torn { LONGEST_WAY * reach } else { f32::INFINITY },
            images: Vec::new(),
            outline: Outline::default(),
            image_of: vec![NONE; mesh.triangles.len()],
            is_own: vec![false; mesh.triangles.len()],
            fitting: Fitting::new(mesh),
            centre: Vec2::ZERO,
            portals: Vec::new(),
            waiting: BinaryHeap::new(),
            is_torn: false,
        }
    }

    /// Lays down connected triangles and those around them: not all of those, if they are found `Torn` and
    /// that is not what they `may_be`.
    pub(super) fn lay_out(&mut self, own: &[u32], may_be_torn: bool) -> Fit {
        for &t in own {
            self.is_own[t as usize] = true;
        }
        // Once to find the middle, and then from there: what is far from the start is bent most.
        let mut home = own[own.len() / 2];
        if own.len() > 2 {
            self.unfold_own(home);
            let all: Vec2 = self.images.iter().map(|image| image.laid.centroid()).sum();
            let middle = all / self.images.len() as f32;
            let from_middle = |image: &Image| image.laid.centroid().distance_squared(middle);
            let nearest =
                self.images.iter().min_by(|a, b| from_middle(a).total_cmp(&from_middle(b)));
            home = nearest.map_or(home, |image| image.triangle);
        }
        self.unfold_own(home);
        self.images =
            own.iter().map(|&t| self.images[self.image_of[t as usize] as usize]).collect();
        for (k, &t) in own.iter().enumerate() {
            self.image_of[t as usize] = k as u32;
        }
        self.outline = self.outline_of(own.len());
        self.unfold_around(!may_be_torn);
        let mut fit = Fit::Torn;
        if !self.is_torn {
            let unfitted = self.images.clone();
            self.fitting.fit_together(self.mesh, &mut self.images);
            if self.all_face_up() {
                self.outline = self.outline_of(own.len());
                fit = if self.is_flat(own.len()) { Fit::Flat } else { Fit::Bent };
            } else {
                self.images = unfitted;
            }
        }
        for &t in own {
            self.is_own[t as usize] = false;
        }
        fit
    }

    fn outline_of(&self, own: usize) -> Outline {
        Outline::around(self.images[..own].iter().flat_map(|image| image.laid.corners()))
    }

    /// Unfolds the own triangles from `home` on, and leaves the portals that lead out of them.
    fn unfold_own(&mut self, home: u32) {
        for image in self.images.drain(..) {
            self.image_of[image.triangle as usize] = NONE;
        }
        self.portals.clear();
        self.waiting.clear();
        self.is_torn = false;
        let corners = self.mesh.frames[home as usize].corners();
        self.centre = (corners[0] + corners[1] + corners[2]) / 3.0;
        self.place(home, corners);
        for k in 0..3 {
            self.push(3 * home + k as u32, &corners, 0.0);
        }
        let mut outwards = Vec::new();
        while let Some(Reverse(waiting)) = self.waiting.pop() {
            let portal = self.portals[waiting.portal()];
            if self.is_own[portal.twin as usize / 3] {
                self.enter(portal, |_, _| true);
            } else {
                self.portals[waiting.portal()].way = 0.0;
                outwards.push(Reverse(waiting));
            }
        }
        self.waiting.extend(outwards);
    }

    /// Unfolds the triangles within reach of the outline, or until they are found torn.
    fn unfold_around(&mut self, until_torn: bool) {
        while let Some(Reverse(waiting)) = self.waiting.pop()
            && !(until_torn && self.is_torn)
        {
            let portal = self.portals[waiting.portal()];
            if portal.way <= self.longest_way {
                self.enter(portal, |layout, edge| layout.outline.is_within(layout.reach, edge));
            }
        }
    }

    /// Unfolds the triangle behind a portal, if it is not there already.
    fn enter(&mut self, portal: Portal, goes_on: impl Fn(&Self, &[Vec2; 2]) -> bool) {
        if self.meets_known(&portal) {
            return;
        }
        let (triangle, entered) = (portal.twin / 3, portal.twin as usize % 3);
        let corners = unfold(self.mesh, portal.twin as usize, portal.left, portal.right);
        self.place(triangle, corners);
        for k in [(entered + 1) % 3, (entered + 2) % 3] {
            let edge = [corners[(k + 1) % 3], corners[(k + 2) % 3]];
            if goes_on(self, &edge) {
                let way = portal.way + distance(portal.middle(), 0.5 * (edge[0] + edge[1]));
                self.push(3 * triangle + k as u32, &corners, way);
            }
        }
    }

    /// Whether the triangle behind a portal is there already; then also finds out whether it lies far
    /// from the portal.
    fn meets_known(&mut self, portal: &Portal) -> bool {
        let (triangle, entered) = (portal.twin / 3, portal.twin as usize % 3);
        let Some(known) = self.images.get(self.image_of[triangle as usize] as usize) else {
            return false;
        };
        // The edge runs the other way seen from this side.
        let (corners, widest) = (known.laid.corners(), WIDEST_GAP * self.reach);
        let gaps = [
            corners[(entered + 1) % 3].distance_squared(portal.left),
            corners[(entered + 2) % 3].distance_squared(portal.right),
        ];
        self.is_torn |= gaps.iter().any(|&gap| gap > widest * widest);
        true
    }

    fn place(&mut self, triangle: u32, corners: [Vec2; 3]) {
        self.image_of[triangle as usize] = self.images.len() as u32;
        self.images.push(image(triangle, 0.0, corners));
    }

    fn push(&mut self, half_edge: u32, corners: &[Vec2; 3], way: f32) {
        let twin = self.mesh.twins[half_edge as usize];
        if twin == NO_TWIN {
            return;
        }
        let k = half_edge as usize % 3;
        let portal = Portal { twin, left: corners[(k + 2) % 3], right: corners[(k + 1) % 3], way };
        if self.meets_known(&portal) {
            return;
        }
        let distance_squared = self.centre.distance_squared(portal.middle());
        self.waiting.push(Reverse(Waiting::new(distance_squared, self.portals.len())));
        self.portals.push(portal);
    }

    /// Whether no triangle lies on its back or nearly on edge.
    fn all_face_up(&self) -> bool {
        self.images.iter().all(|image| {
            let area = 0.5 * image.laid.edge1.perp_dot(image.laid.edge2);
            area > LEAST_AREA * self.mesh.areas[image.triangle as usize]
        })
    }

    /// Whether the edges within reach have nearly kept their lengths, those of the first `own` images
    /// among them.
    fn is_flat(&self, own: usize) -> bool {
        let (mut sum, mut count) = (0.0, 0.0);
        for (number, image) in self.images.iter().enumerate() {
            let corners = image.laid.corners();
            let shape = self.mesh.frames[image.triangle as usize].corners();
            for k in 0..3 {
                let (from, to) = (corners[(k + 1) % 3], corners[(k + 2) % 3]);
                if number >= own && !self.outline.is_within(self.reach, &[from, to]) {
                    continue;
                }
                let length = distance(shape[(k + 1) % 3], shape[(k + 2) % 3]);
                let stretch = (distance(from, to) / length - 1.0).abs();
                if stretch > FLAT.most {
                    return false;
                }
                sum += stretch;
                count += 1.0;
            }
        }
        sum <= FLAT.mean * count
    }
}

/// The corners of the triangle behind half-edge `twin`, laid down at the portal `left`, `right`
/// through which it is entered.
fn unfold(mesh: &Mesh, twin: usize, left: Vec2, right: Vec2) -> [Vec2; 3] {
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

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    #[test]
    fn a_patch_is_flat_as_long_as_its_edges_and_those_within_reach_keep_their_lengths() {
        const REACH: f32 = 1.5;
        let mesh = crate::surface::icosphere(4, 10.0);
        let mut layout = Layout::new(&mesh, REACH, false);
        let (mut flat, mut bent) = (0, 0);
        for rim_rad in (30..75).map(|k| 0.01 * k as f32) {
            let is_own = |&t: &u32| {
                let centroid = mesh.corners(t).iter().sum::<Vec3>() / 3.0;
                centroid.z > 10.0 * libm::cosf(rim_rad)
            };
            let own: Vec<u32> = (0..mesh.triangles.len() as u32).filter(is_own).collect();
            let fit = layout.lay_out(&own, false);
            let mut stretches = Vec::new();
            for (number, image) in layout.images.iter().enumerate() {
                let (laid, shape) = (image.laid.corners(), mesh.corners(image.triangle));
                for (from, to) in [(0, 1), (1, 2), (2, 0)] {
                    // As far as fitting may have shifted what is within reach.
                    let reach = REACH * (1.0 + FLAT.most);
                    if number < own.len()
                        || layout.outline.is_within(reach, &[laid[from], laid[to]])
                    {
                        let was = f64::from(shape[from].distance(shape[to]));
                        stretches
                            .push((f64::from(laid[from].distance(laid[to])) / was - 1.0).abs());
                    }
                }
            }
            let mean = stretches.iter().sum::<f64>() / stretches.len() as f64;
            let most = stretches.iter().copied().fold(0.0, f64::max);
            let is_flat = mean <= f64::from(FLAT.mean) && most <= f64::from(FLAT.most);
            let expected = if is_flat { Fit::Flat } else { Fit::Bent };
            assert_eq!(fit, expected, "{rim_rad}: stretched by {mean} in the mean, {most} at most");
            (flat, bent) = (flat + u32::from(is_flat), bent + u32::from(!is_flat));
        }
        assert!(flat > 5 && bent > 5, "{flat} flat, {bent} bent");
    }

    #[test]
    fn triangles_that_would_fold_are_left_as_they_were_unfolded() {
        // A closed surface cannot be laid flat, and in so wide a reach no gap is too wide.
        let mesh = crate::surface::icosphere(1, 1.0);
        let all: Vec<u32> = (0..mesh.triangles.len() as u32).collect();
        let mut layout = Layout::new(&mesh, 100.0, false);
        assert_eq!((layout.lay_out(&all, true), layout.is_torn), (Fit::Torn, false));
        for image in &layout.images {
            let (laid, shape) = (image.laid.corners(), mesh.corners(image.triangle));
            for (a, b) in [(0, 1), (1, 2), (2, 0)] {
                assert!((laid[a].distance(laid[b]) - shape[a].distance(shape[b])).abs() < 1e-4);
            }
        }
    }

    #[test]
    fn a_triangle_may_keep_three_tenths_of_its_area_and_lie_three_tenths_of_the_reach_apart() {
        let mesh = crate::surface::icosphere(0, 1.0);
        let mut layout = Layout::new(&mesh, 5.0, true);
        assert_eq!(layout.longest_way, 10.0);
        let corners = mesh.frames[0].corners();
        for (share, is_up) in [(1.0, true), (0.32, true), (0.28, false), (-1.0, false)] {
            layout.images = vec![image(0, 0.0, corners.map(|c| c * Vec2::new(1.0, share)))];
            assert_eq!(layout.all_face_up(), is_up, "{share}");
        }
        layout.images.clear();
        layout.place(0, corners);
        for (gap, is_torn) in [(0.29, false), (0.31, true)] {
            let shift = Vec2::X * gap * layout.reach;
            for (left, right) in [(shift, Vec2::ZERO), (Vec2::ZERO, shift)] {
                layout.is_torn = false;
                let (left, right) = (corners[1] + left, corners[2] + right);
                assert!(layout.meets_known(&Portal { twin: 0, left, right, way: 0.0 }));
                assert_eq!(layout.is_torn, is_torn, "{gap}");
            }
        }
    }

    #[test]
    fn an_edge_that_is_a_twentieth_longer_is_a_sixtieth_in_the_mean() {
        let mesh = crate::surface::icosphere(0, 1.0);
        let mut layout = Layout::new(&mesh, 1.0, false);
        let (sin, cos) = libm::sincosf(2.0 * libm::asinf(0.525));
        let [a, b, _] = mesh.frames[0].corners();
        layout.images = vec![image(0, 0.0, [a, b, b.x * Vec2::new(cos, sin)])];
        assert!(layout.is_flat(1));
    }
}
