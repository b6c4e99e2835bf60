//! Patches: the surface cut into pieces small and flat enough to be unfolded as a whole, each with
//! the triangles around it (Turk91, for many cells at once).

use super::chart::Image;
use super::layout::{Fit, Layout};
use super::mirrors::{add_mirrored, nearest_rims};
use super::outline::Outline;
use super::{Mesh, NO_TWIN};
use std::ops::Range;

/// Patches are not cut to less than this share of the reach in width for the sake of flatness.
const SMALLEST_WIDTH: f32 = 0.5;

/// What is around a patch at an open rim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rims {
    /// Nothing behind it.
    End,
    /// Behind it, what lies before it in its mirror image.
    Mirror,
}

/// Some connected triangles, laid down in one plane.
#[derive(Clone, Copy, Debug)]
pub struct Patch<'a> {
    /// Its triangles in their order, and then those around it, mirrored ones last.
    pub images: &'a [Image],
    /// How many are its own.
    pub own: usize,
    /// What its own triangles cover.
    pub outline: &'a Outline,
}

/// Cuts a mesh into patches of at most `area` (square centimetres) or one triangle, unfolds around
/// each all triangles within `reach` (centimetres), and hands them to `take` one by one as long as that
/// is true, so that nobody has to hold all of them. Every triangle is in one patch. Returns whether all
/// were taken.
///
/// Where the reach leads around the body, or over bumps far smaller than it is, no patch lies flat with
/// all that is around it. Such ones are cut down to single triangles, or, which costs less and is less
/// exact, to squares of `torn_width` (in reaches).
pub fn cut_into_patches(
    mesh: &Mesh,
    area: f32,
    reach: f32,
    (torn_width, rims): (f32, Rims),
    take: impl FnMut(Patch) -> bool,
) -> bool {
    let count = mesh.triangles.len();
    let (order, ends) = by_parts(mesh);
    let mut cutter = Cutter {
        mesh,
        area,
        narrow_area: square(SMALLEST_WIDTH * reach),
        torn_area: square(torn_width * reach),
        reach,
        nearest_rims: (rims == Rims::Mirror).then(|| nearest_rims(mesh)),
        layout: Layout::new(mesh, reach, torn_width > 0.0),
        piece_of: vec![0; count],
        pieces: 0,
        found: Vec::with_capacity(count),
        order,
        take,
    };
    let mut start = 0;
    for end in ends {
        if cutter.cut(start..end).is_none() {
            return false;
        }
        start = end;
    }
    true
}

/// All triangles part by part, and where each part ends: none is looked for in another part, so that bodies
/// of very many parts are cut as quickly.
fn by_parts(mesh: &Mesh) -> (Vec<u32>, Vec<usize>) {
    let mut ends = vec![0; mesh.part_count()];
    for &part in &mesh.parts {
        ends[part as usize] += 1;
    }
    let mut sum = 0;
    for end in &mut ends {
        // First it is where the part starts, and moves on with each of its triangles.
        (*end, sum) = (sum, sum + *end);
    }
    let mut order = vec![0; mesh.triangles.len()];
    for (triangle, &part) in mesh.parts.iter().enumerate() {
        let end = &mut ends[part as usize];
        order[*end] = triangle as u32;
        *end += 1;
    }
    (order, ends)
}

fn square(length: f32) -> f32 {
    length * length
}

/// Cuts pieces in two until each is a patch. Only lengths and neighbours count, never how the mesh
/// stands in space: a folded sheet is cut like a flat one.
struct Cutter<'a, Take> {
    mesh: &'a Mesh,
    /// Of a patch at most, in square centimetres.
    area: f32,
    /// Pieces of no more than these are patches though they are bent, or torn.
    narrow_area: f32,
    torn_area: f32,
    reach: f32,
    /// Where rims are mirrors.
    nearest_rims: Option<Vec<u32>>,
    layout: Layout<'a>,
    /// For each triangle the number of the last piece that it was looked for in, as long as it has
    /// not been found.
    piece_of: Vec<u32>,
    pieces: u32,
    found: Vec<u32>,
    order: Vec<u32>,
    take: Take,
}

impl<Take: FnMut(Patch) -> bool> Cutter<'_, Take> {
    /// Cuts a piece, as all here until nobody wants more.
    fn cut(&mut self, mut piece: Range<usize>) -> Option<()> {
        while !piece.is_empty() {
            let middle = piece.start + self.sort_by_steps(piece.clone());
            self.cut_sorted(piece.start..middle)?;
            piece.start = middle;
        }
        Some(())
    }

    /// Cuts a piece that is connected and sorted by steps.
    fn cut_sorted(&mut self, piece: Range<usize>) -> Option<()> {
        let own = &self.order[piece.clone()];
        let area: f32 = own.iter().map(|&t| self.mesh.areas[t as usize]).sum();
        if own.len() == 1 || area <= self.area {
            let may_be_torn = own.len() == 1 || area <= self.torn_area;
            let is_patch = match self.layout.lay_out(own, may_be_torn) {
                Fit::Flat => true,
                // It is the reach that is bent then: a smaller patch would see the same.
                Fit::Bent => area <= self.narrow_area,
                Fit::Torn => may_be_torn,
            };
            if is_patch || own.len() == 1 {
                return self.hand_over(own.len());
            }
        }
        // From the triangle that is farthest from the first, so that the cut is a short one.
        self.order[piece.clone()].reverse();
        self.sort_by_steps(piece.clone());
        let mut rest = 0.5 * area;
        let own = &self.order[piece.clone()];
        let before_half = own.iter().take_while(|&&t| {
            rest -= self.mesh.areas[t as usize];
            rest >= 0.0
        });
        let middle = piece.start + before_half.count().clamp(1, piece.len() - 1);
        // As far as the middle they stay as they are.
        self.cut_sorted(piece.start..middle)?;
        self.cut(middle..piece.end)
    }

    /// Hands over what was laid down last.
    fn hand_over(&mut self, own: usize) -> Option<()> {
        if let Some(nearest_rims) = &self.nearest_rims {
            let Layout { images, image_of, outline, .. } = &mut self.layout;
            add_mirrored(nearest_rims, images, image_of, outline, self.reach);
        }
        let Layout { images, outline, .. } = &self.layout;
        (self.take)(Patch { images, own, outline }).then_some(())
    }

    /// Sorts the triangles of a piece by the number of edges to be crossed from its first one; those
    /// that cannot be reached within the piece come last. Returns how many can.
    fn sort_by_steps(&mut self, piece: Range<usize>) -> usize {
        self.pieces += 1;
        let number = self.pieces;
        let order = &mut self.order[piece];
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
        (image.laid.centroid(), mesh.corners(image.triangle).iter().sum::<Vec3>() / 3.0)
    }

    /// A patch that is kept.
    struct Kept {
        images: Vec<Image>,
        own: usize,
    }

    fn patches(mesh: &Mesh, area: f32, reach: f32, torn_width: f32) -> Vec<Kept> {
        let mut all = Vec::new();
        let keep = |patch: Patch| {
            all.push(Kept { images: patch.images.to_vec(), own: patch.own });
            true
        };
        assert!(cut_into_patches(mesh, area, reach, (torn_width, Rims::End), keep));
        all
    }

    #[test]
    fn every_triangle_is_in_one_patch() {
        let mesh = cap(12, 1.0);
        for (area, reach, torn_width) in [
            (1e-3, 0.5, 0.0),
            (2.0, 0.5, 0.0),
            (20.0, 1.0, 0.0),
            (1e9, 3.0, 0.0),
            (1e9, 40.0, 0.25),
        ] {
            let mut all = Vec::new();
            for patch in patches(&mesh, area, reach, torn_width) {
                let own = patch.images.iter().take(patch.own).map(|image| image.triangle);
                let sum: f32 = own.clone().map(|t| mesh.areas[t as usize]).sum();
                assert!(patch.own == 1 || sum <= area);
                all.extend(own);
            }
            all.sort_unstable();
            assert!(all.into_iter().eq(0..mesh.triangles.len() as u32));
        }
    }

    #[test]
    fn distances_in_a_patch_are_those_on_the_sphere() {
        let mesh = cap(24, 1.2);
        let reach = 1.5;
        let found = patches(&mesh, 12.0, reach, 0.0);
        assert!(found.len() * 4 < mesh.triangles.len(), "patches of several triangles");
        let (mut seen, mut error, mut worst) = (0, 0.0f32, 0.0f32);
        for Kept { images, own } in &found {
            for own in &images[..*own] {
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
                    let stretch = (at.distance(image.laid.centroid()) / way - 1.0).abs();
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
        let found = patches(&mesh, 1e9, 0.3, 0.0);
        assert_eq!(found.len(), 5);
        assert!(found.iter().all(|patch| patch.images.len() >= 3), "with those beside it");
    }

    #[test]
    fn where_the_reach_leads_around_the_body_torn_patches_are_few_and_see_all() {
        let mesh = crate::surface::icosphere(3, 5.0);
        let reach = mesh.area.sqrt();
        let cut = |torn_width| patches(&mesh, 1e9, reach, torn_width);
        assert_eq!(cut(0.0).len(), mesh.triangles.len(), "single triangles");
        let few = cut(0.25);
        assert!(few.len() < 64, "{}", few.len());
        assert!(few.iter().all(|patch| patch.images.len() == mesh.triangles.len()));
    }

    #[test]
    fn it_ends_when_no_more_patches_are_wanted() {
        let mesh = cap(12, 1.0);
        let mut taken = 0;
        let all = cut_into_patches(&mesh, 2.0, 0.5, (0.0, Rims::End), |_| {
            taken += 1;
            taken < 3
        });
        assert!(!all && taken == 3);
    }

    #[test]
    fn only_narrow_patches_are_bent() {
        let mesh = cap(12, 1.0);
        let (mut wide, mut bent) = (0, 0);
        for reach in [3.0, 8.0] {
            let mut layout = Layout::new(&mesh, reach, false);
            for patch in patches(&mesh, 1e9, reach, 0.0) {
                let own: Vec<u32> = patch.images[..patch.own].iter().map(|i| i.triangle).collect();
                let fit = layout.lay_out(&own, false);
                // Half the reach wide at most.
                if own.iter().map(|&t| mesh.areas[t as usize]).sum::<f32>() <= 0.25 * reach * reach
                {
                    bent += u32::from(own.len() > 1 && fit == Fit::Bent);
                } else {
                    assert_eq!(fit, Fit::Flat);
                    wide += 1;
                }
            }
        }
        assert!(wide > 0 && bent > 0, "{wide} wide, {bent} bent");
    }
}
