//! Patches: the surface cut into pieces small and flat enough to be unfolded as a whole, each with
//! the triangles around it (Turk91, for many cells at once).

use super::chart::Image;
use super::layout::{Fit, Layout};
use super::outline::Outline;
use super::{Mesh, NO_TWIN};
use std::ops::Range;

/// Patches are not cut to less than this share of the reach in width for the sake of flatness.
const SMALLEST_WIDTH: f32 = 0.5;

/// Every triangle of a mesh in one patch.
#[derive(Clone, Debug, Default)]
pub struct Patches {
    /// All triangles, patch by patch.
    pub order: Vec<u32>,
    pub patches: Vec<Patch>,
    /// The images of all patches.
    pub images: Vec<Image>,
}

/// Some connected triangles, laid down in one plane.
#[derive(Clone, Debug)]
pub struct Patch {
    /// Its triangles, as a range of `order`.
    pub own: Range<usize>,
    /// Its triangles in the same order, and then those around it, as a range of `images`.
    pub images: Range<usize>,
    /// What its own triangles cover.
    pub outline: Outline,
}

impl Patches {
    /// Cuts a mesh into patches of at most `area` (square centimetres) or one triangle, and unfolds
    /// around each all triangles within `reach` (centimetres).
    pub fn new(mesh: &Mesh, area: f32, reach: f32) -> Patches {
        let count = mesh.triangles.len();
        let mut cutter = Cutter {
            mesh,
            area,
            reach,
            layout: Layout::new(mesh, reach),
            piece_of: vec![0; count],
            pieces: 0,
            found: Vec::with_capacity(count),
            result: Patches {
                order: (0..count as u32).collect(),
                patches: Vec::new(),
                images: Vec::new(),
            },
        };
        cutter.cut(0..count);
        cutter.result
    }
}

/// Cuts pieces in two until each is a patch. Only lengths and neighbours count, never how the mesh
/// stands in space: a folded sheet is cut like a flat one.
struct Cutter<'a> {
    mesh: &'a Mesh,
    area: f32,
    reach: f32,
    layout: Layout<'a>,
    /// For each triangle the number of the last piece that it was looked for in, as long as it has
    /// not been found.
    piece_of: Vec<u32>,
    pieces: u32,
    found: Vec<u32>,
    result: Patches,
}

impl Cutter<'_> {
    fn cut(&mut self, piece: Range<usize>) {
        let middle = piece.start + self.sort_by_steps(piece.clone());
        self.cut_sorted(piece.start..middle);
        if middle < piece.end {
            self.cut(middle..piece.end);
        }
    }

    /// Cuts a piece that is connected and sorted by steps.
    fn cut_sorted(&mut self, piece: Range<usize>) {
        let own = &self.result.order[piece.clone()];
        let area: f32 = own.iter().map(|&t| self.mesh.areas[t as usize]).sum();
        if own.len() == 1 || area <= self.area {
            let narrow = SMALLEST_WIDTH * self.reach;
            let is_patch = match self.layout.lay_out(own) {
                Fit::Flat => true,
                // It is the reach that is bent then: a smaller patch would see the same.
                Fit::Bent => area <= narrow * narrow,
                Fit::Torn => false,
            };
            if is_patch || own.len() == 1 {
                self.add(piece);
                return;
            }
        }
        // From the triangle that is farthest from the first, so that the cut is a short one.
        self.result.order[piece.clone()].reverse();
        self.sort_by_steps(piece.clone());
        let mut rest = 0.5 * area;
        let own = &self.result.order[piece.clone()];
        let before_half = own.iter().take_while(|&&t| {
            rest -= self.mesh.areas[t as usize];
            rest >= 0.0
        });
        let middle = piece.start + before_half.count().clamp(1, piece.len() - 1);
        // As far as the middle they stay as they are.
        self.cut_sorted(piece.start..middle);
        self.cut(middle..piece.end);
    }

    /// Makes a patch of the piece that was laid down last.
    fn add(&mut self, piece: Range<usize>) {
        let first = self.result.images.len();
        self.result.images.extend_from_slice(&self.layout.images);
        self.result.patches.push(Patch {
            own: piece,
            images: first..self.result.images.len(),
            outline: std::mem::take(&mut self.layout.outline),
        });
    }

    /// Sorts the triangles of a piece by the number of edges to be crossed from its first one; those
    /// that cannot be reached within the piece come last. Returns how many can.
    fn sort_by_steps(&mut self, piece: Range<usize>) -> usize {
        self.pieces += 1;
        let number = self.pieces;
        let order = &mut self.result.order[piece];
        for &t in order.iter() {
            self.piece_of[t as usize] = number;
        }
        let found = &mut self.found;
        found.clear();
        found.push(order[0]);
        self.piece_of[order[0] as usize] = 0;
        let mut next = 0;
        while next < found.len() {
            let t = found[next] as usize;
            next += 1;
            for &twin in &self.mesh.twins[3 * t..3 * t + 3] {
                if twin != NO_TWIN && self.piece_of[twin as usize / 3] == number {
                    self.piece_of[twin as usize / 3] = 0;
                    found.push(twin / 3);
                }
            }
        }
        let connected = found.len();
        found.extend(order.iter().filter(|&&t| self.piece_of[t as usize] == number));
        order.copy_from_slice(found);
        connected
    }
}

#[cfg(test)]
mod tests {
    use super::super::layout::FLAT;
    use super::*;
    use glam::{Vec2, Vec3};

    /// A cap of a sphere of radius 10 cm over the north pole: rings of triangles around it.
    fn cap(rings: u32, rim_rad: f32) -> Mesh {
        let ring_of = |k: u32| if k == 0 { 1 } else { 6 * k };
        let mut positions = Vec::new();
        for k in 0..=rings {
            let (sin, cos) = libm::sincosf(rim_rad * k as f32 / rings as f32);
            for i in 0..ring_of(k) {
                let (y, x) = libm::sincosf(std::f32::consts::TAU * i as f32 / ring_of(k) as f32);
                positions.push(10.0 * Vec3::new(sin * x, sin * y, cos));
            }
        }
        let first = |k: u32| if k == 0 { 0 } else { 1 + 3 * k * (k - 1) };
        let mut triangles = Vec::new();
        for k in 0..rings {
            let at = |ring: u32, i: u32| first(ring) + i % ring_of(ring);
            for side in 0..6 {
                for i in 0..=k {
                    triangles.push([
                        at(k, side * k + i),
                        at(k + 1, side * (k + 1) + i),
                        at(k + 1, side * (k + 1) + i + 1),
                    ]);
                    if i < k {
                        triangles.push([
                            at(k, side * k + i),
                            at(k + 1, side * (k + 1) + i + 1),
                            at(k, side * k + i + 1),
                        ]);
                    }
                }
            }
        }
        Mesh::new(positions, Vec::new(), triangles).unwrap()
    }

    /// A triangle's centroid in its patch and in space.
    fn centroids(mesh: &Mesh, image: &Image) -> (Vec2, Vec3) {
        (image.centroid(), mesh.corners(image.triangle).iter().sum::<Vec3>() / 3.0)
    }

    #[test]
    fn every_triangle_is_in_one_patch() {
        let mesh = cap(12, 1.0);
        for (area, reach) in [(2.0, 0.5), (20.0, 1.0), (1e9, 3.0)] {
            let found = Patches::new(&mesh, area, reach);
            let mut order = found.order.clone();
            order.sort_unstable();
            assert!(order.iter().copied().eq(0..mesh.triangles.len() as u32));
            let mut next = 0;
            for patch in &found.patches {
                assert_eq!(patch.own.start, next);
                next = patch.own.end;
                let images = &found.images[patch.images.clone()];
                let own = images.iter().take(patch.own.len()).map(|image| image.triangle);
                assert!(own.eq(found.order[patch.own.clone()].iter().copied()));
                let sum: f32 =
                    found.order[patch.own.clone()].iter().map(|&t| mesh.areas[t as usize]).sum();
                assert!(patch.own.len() == 1 || sum <= area);
            }
            assert_eq!(next, mesh.triangles.len());
        }
    }

    #[test]
    fn distances_in_a_patch_are_those_on_the_sphere() {
        let mesh = cap(24, 1.2);
        let reach = 1.5;
        let found = Patches::new(&mesh, 12.0, reach);
        assert!(found.patches.len() * 4 < mesh.triangles.len(), "patches of several triangles");
        let (mut seen, mut error, mut worst) = (0, 0.0f32, 0.0f32);
        for patch in &found.patches {
            let images = &found.images[patch.images.clone()];
            for own in &images[..patch.own.len()] {
                let (at, point) = centroids(&mesh, own);
                for t in 0..mesh.triangles.len() as u32 {
                    let other = mesh.corners(t).iter().sum::<Vec3>() / 3.0;
                    // Along the great circle.
                    let way = 20.0 * libm::asinf(0.05 * point.distance(other));
                    if t == own.triangle || way > reach {
                        continue;
                    }
                    let image = images.iter().find(|image| image.triangle == t);
                    let image = image.expect("all within reach are in the patch");
                    let stretch = (at.distance(image.centroid()) / way - 1.0).abs();
                    (seen, error, worst) = (seen + 1, error + stretch, worst.max(stretch));
                }
            }
        }
        let mean = error / seen as f32;
        assert!(
            mean < FLAT.mean && worst < FLAT.most,
            "stretched by {mean} in the mean, {worst} at most"
        );
    }

    #[test]
    fn around_a_sharp_corner_patches_are_single_triangles() {
        // Five triangles around a steep tip.
        let positions: Vec<Vec3> = (0..5)
            .map(|k| {
                let (y, x) = libm::sincosf(std::f32::consts::TAU * k as f32 / 5.0);
                Vec3::new(x, y, 0.0)
            })
            .chain([Vec3::Z * 2.0])
            .collect();
        let triangles = (0..5).map(|k| [k, (k + 1) % 5, 5]).collect();
        let mesh = Mesh::new(positions, Vec::new(), triangles).unwrap();
        let found = Patches::new(&mesh, 1e9, 0.3);
        assert_eq!(found.patches.len(), 5);
        assert!(found.patches.iter().all(|patch| patch.images.len() >= 3), "with those beside it");
    }
}
