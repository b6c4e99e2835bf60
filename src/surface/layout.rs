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
    /// Those that lead out of the patch, as long as its own triangles are unfolded.
    outwards: Vec<Reverse<Waiting>>,
    is_within: bool,
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
            outwards: Vec::new(),
            is_within: true,
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
        self.outwards.clear();
        self.is_within = true;
        self.is_torn = false;
        let corners = self.mesh.frames[home as usize].corners();
        self.centre = (corners[0] + corners[1] + corners[2]) / 3.0;
        self.place(home, corners);
        for k in 0..3 {
            self.push(3 * home + k as u32, &corners, 0.0);
        }
        while let Some(Reverse(waiting)) = self.waiting.pop() {
            self.enter(self.portals[waiting.portal()], |_, _| true);
        }
    }

    /// Unfolds the triangles within reach of the outline, or until they are found torn.
    fn unfold_around(&mut self, until_torn: bool) {
        self.is_within = false;
        self.waiting.extend(self.outwards.drain(..));
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
                let way = if self.is_within || self.longest_way == f32::INFINITY {
                    0.0
                } else {
                    portal.way + distance(portal.middle(), 0.5 * (edge[0] + edge[1]))
                };
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
        let waiting = Reverse(Waiting::new(distance_squared, self.portals.len()));
        if self.is_within && !self.is_own[twin as usize / 3] {
            self.outwards.push(waiting);
        } else {
            self.waiting.push(waiting);
        }
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
mod tests;
