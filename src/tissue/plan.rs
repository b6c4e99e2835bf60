//! The plan of a relaxation: which cells each patch has to look at. It holds for all events of some
//! days, until the repulsive radius has become much smaller.

use super::bins::Bins;
use crate::surface::{Image, Laid, Mesh, Outline, Patch, Place, cut_into_patches};
use glam::Vec2;
use std::ops::Range;

/// Cells that a bin should hold. Fewer, and most of the work is looking into bins; more, and it is
/// looking at cells that are too far away.
const CELLS_PER_BIN: f32 = 3.0;

/// Cells of a patch, and its width in repulsive radii, whichever is more. Smaller, and more is
/// unfolded around the patches than in them; larger, and they are too bent to be laid flat.
const CELLS_PER_PATCH: f32 = 192.0;
const PATCH_WIDTH_RADII: f32 = 4.0;

/// Boxes are made for the repulsive radius or so many mean spacings, whichever is more: far smaller,
/// and there are many more boxes than cells.
const BOX_SPACINGS: f32 = 0.8;

/// All patches have at most so many images, a third of a gigabyte. Where cells are few and the body is fine
/// or rough, those of single triangles would have more, each of every other triangle. Cutting is given up
/// early, where it has taken a twentieth and four times more than even shares come to until then.
const MOST_IMAGES: Budget = Budget { images: 11e6, early_times: 4.0 };

/// Then the body is smoothed for the layout, and torn patches get as wide as it takes, in reaches: wider,
/// and for more cells the way around the body would be another than the shortest.
const TORN_WIDTHS: [f32; 3] = [0.25, 0.5, 1.0];
const MOST_TORN_IMAGES: Budget = Budget { images: 6e6, early_times: 1.0 };

/// A reach whose square is so many times the area of the body sees all of it, but for the far ends of long
/// bodies: nothing lies flat then, and to try it would take seconds.
const SPAN: f32 = 1.05;

/// What the images of all patches may come to.
#[derive(Clone, Copy, Debug)]
struct Budget {
    images: f32,
    early_times: f32,
}

impl Budget {
    const EARLY_SHARE: f32 = 0.05;

    /// Whether to go on with so many images, after a share of all triangles.
    fn lasts(&self, images: f32, done: f32) -> bool {
        images <= self.images * (Budget::EARLY_SHARE + self.early_times * done).min(1.0)
    }
}

/// A plan serves until the radius is this share of what it was made for.
const SMALLEST_RADIUS: f32 = 0.7;

#[derive(Clone, Debug, Default)]
pub(super) struct Plan {
    pub(super) bins: Bins,
    /// The triangles in the order of the bins: patch by patch.
    pub(super) order: Vec<u32>,
    /// The place of each triangle in `order`.
    pub(super) slot_of: Vec<u32>,
    pub(super) patches: Vec<Neighbourhood>,
    /// The triangles of the patches, in the order of the bins.
    pub(super) own: Vec<Own>,
    /// Whether torn patches may be wide, and the body is smoothed: then what is around them is in the order of
    /// the bins, where one is found quickly.
    pub(super) is_wide: bool,
    radius: f32,
    cells: usize,
}

/// A patch and all that its cells may feel.
#[derive(Clone, Debug)]
pub(super) struct Neighbourhood {
    /// Its triangles, in the order of the bins.
    pub(super) own: Range<usize>,
    /// What is around it.
    pub(super) around: Box<[Run]>,
    /// The part of the plane in which all of this lies.
    pub(super) low: Vec2,
    pub(super) high: Vec2,
}

/// A triangle of a patch, laid down in its plane.
#[derive(Clone, Copy, Debug)]
pub(super) struct Own {
    pub(super) laid: Laid,
    /// What a vector of the plane is to be multiplied with for its changes of `b1` and `b2`.
    pub(super) to_barycentric: [Vec2; 2],
}

/// Bins of one triangle that follow each other.
#[derive(Clone, Copy, Debug)]
pub(super) struct Run {
    pub(super) first_bin: u32,
    pub(super) end_bin: u32,
    pub(super) laid: Laid,
}

impl Plan {
    /// Makes the plan anew if it does not serve any more.
    pub(super) fn renew(&mut self, mesh: &Mesh, cells: usize, radius: f32) {
        let serves = (SMALLEST_RADIUS * self.radius..=self.radius).contains(&radius)
            && cells as f32 * SMALLEST_RADIUS * SMALLEST_RADIUS <= self.cells as f32;
        if !serves {
            // Before the next one takes room, too.
            *self = Plan::default();
            *self = Plan::new(mesh, cells, radius);
        }
    }

    /// The plan of the same mesh that is so many times larger: by a power of two, the same to the last bit.
    pub(super) fn scale(&mut self, scale: f32) {
        self.radius *= scale;
        self.bins.sizes.iter_mut().for_each(|size| *size *= scale);
        for own in &mut self.own {
            own.laid = own.laid.scaled(scale);
            own.to_barycentric = own.to_barycentric.map(|per_cm| per_cm / scale);
        }
        for patch in &mut self.patches {
            (patch.low, patch.high) = (patch.low * scale, patch.high * scale);
            for run in &mut patch.around {
                run.laid = run.laid.scaled(scale);
            }
        }
    }

    /// The number of bins on the whole mesh.
    pub(super) fn bins_in_all(&self) -> usize {
        self.order.len() * self.bins.in_triangle()
    }

    /// The bins of triangles that follow each other in `order`.
    pub(super) fn bins_of(&self, slots: &Range<usize>) -> Range<usize> {
        slots.start * self.bins.in_triangle()..slots.end * self.bins.in_triangle()
    }

    /// The bin that a place lies in.
    #[inline]
    pub(super) fn bin(&self, place: Place) -> u32 {
        let slot = self.slot_of[place.triangle as usize];
        slot * self.bins.in_triangle() as u32 + self.bins.within(place.b1, place.b2)
    }

    fn new(mesh: &Mesh, cells: usize, radius: f32) -> Plan {
        let spans_the_body = radius * radius > SPAN * mesh.area;
        let fine = |()| Plan::of_patches(mesh, cells, radius, 0.0, MOST_IMAGES);
        (!spans_the_body).then_some(()).and_then(fine).unwrap_or_else(|| {
            let smooth = mesh.smoothed(radius);
            let [widths @ .., widest] = TORN_WIDTHS;
            let cut = |width, budget| Plan::of_patches(&smooth, cells, radius, width, budget);
            let mut plans = widths.into_iter().filter_map(|width| cut(width, MOST_TORN_IMAGES));
            let boundless = Budget { images: f32::INFINITY, early_times: 1.0 };
            let plan = plans.next().or_else(|| cut(widest, boundless));
            plan.expect("as many images as it takes")
        })
    }

    /// The plan with torn patches so wide, in reaches, unless they have more images in all.
    fn of_patches(
        mesh: &Mesh,
        cells: usize,
        radius: f32,
        torn_width: f32,
        budget: Budget,
    ) -> Option<Plan> {
        let area_per_cell = mesh.area / cells as f32;
        let width = PATCH_WIDTH_RADII * radius;
        let area = (CELLS_PER_PATCH * area_per_cell).max(width * width);
        let count = mesh.triangles.len();
        let mut plan = Plan {
            bins: Bins::new(mesh, cells, CELLS_PER_BIN),
            order: Vec::with_capacity(count),
            slot_of: vec![0; count],
            patches: Vec::new(),
            own: Vec::with_capacity(count),
            is_wide: torn_width > 0.0,
            radius,
            cells,
        };
        let mut images = 0.0;
        let is_whole = cut_into_patches(mesh, area, radius, torn_width, |patch| {
            plan.add(mesh, patch);
            images += patch.images.len() as f32;
            budget.lasts(images, plan.order.len() as f32 / count as f32)
        });

        is_whole.then(|| plan.in_order())
    }

    /// Adds a patch. Triangles have no order yet: the runs around it are of the bins that those would
    /// have in the order of the mesh.
    fn add(&mut self, mesh: &Mesh, patch: Patch) {
        let first = self.order.len();
        let (own, images_around) = patch.images.split_at(patch.own);
        for image in own {
            self.slot_of[image.triangle as usize] = self.order.len() as u32;
            self.order.push(image.triangle);
            let laid = image.laid;
            self.own.push(Own { laid, to_barycentric: laid.to_barycentric() });
        }
        let mut around = Vec::new();
        for image in images_around {
            self.add_runs(image, patch.outline, &mut around);
        }
        // Room for a box more than `look_cm` around, and for rounding.
        let margin = Vec2::splat(1.5 * look_cm(mesh, self.cells, self.radius));
        let (mut low, mut high) = (patch.outline.low - margin, patch.outline.high + margin);
        for Run { first_bin, end_bin, laid } in &around {
            let (triangle, first_in_triangle) = self.bins.triangle_of(*first_bin);
            let size = Vec2::splat(self.bins.sizes[triangle]);
            for k in 0..(end_bin - first_bin) as usize {
                let (b1, b2) = self.bins.centroid(first_in_triangle + k);
                let centroid = laid.point(b1, b2);
                (low, high) = (low.min(centroid - size), high.max(centroid + size));
            }
        }
        let (own, around) = (first..self.order.len(), around.into_boxed_slice());
        self.patches.push(Neighbourhood { own, around, low, high });
    }

    /// Adds the bins of a triangle that come within the radius of a patch.
    fn add_runs(&self, image: &Image, outline: &Outline, runs: &mut Vec<Run>) {
        let laid = image.laid;
        let of = self.bins.of(image.triangle as usize);
        let reach = self.radius + self.bins.sizes[image.triangle as usize];
        let mut last_bin = None;
        for bin in of.clone() {
            let (b1, b2) = self.bins.centroid(bin - of.start);
            if self.bins.cuts > 1 && !outline.is_within(reach, &[laid.point(b1, b2)]) {
                continue;
            }
            match runs.last_mut() {
                Some(run) if last_bin == Some(bin) => run.end_bin += 1,
                _ => runs.push(Run { first_bin: bin as u32, end_bin: bin as u32 + 1, laid }),
            }
            last_bin = Some(bin + 1);
        }
    }

    /// Gives the runs the bins of their triangles as these stand in the plan's order.
    fn in_order(mut self) -> Plan {
        for run in self.patches.iter_mut().flat_map(|patch| &mut patch.around) {
            let (triangle, first_in_triangle) = self.bins.triangle_of(run.first_bin);
            let first_bin = self.bins.of(self.slot_of[triangle] as usize).start + first_in_triangle;
            run.end_bin = first_bin as u32 + (run.end_bin - run.first_bin);
            run.first_bin = first_bin as u32;
        }
        if self.is_wide {
            for patch in &mut self.patches {
                // As integers, which are sorted elsewhere, too: a sort of its own is two kilobytes to download.
                let key = |(k, run): (usize, &Run)| u64::from(run.first_bin) << 32 | k as u64;
                let mut keys: Vec<u64> = patch.around.iter().enumerate().map(key).collect();
                keys.sort_unstable();
                patch.around = keys.iter().map(|&key| patch.around[key as u32 as usize]).collect();
            }
        }
        self
    }
}

impl Neighbourhood {
    /// The run around it that holds a bin; the plan must be wide.
    pub(super) fn run_of(&self, bin: u32) -> Option<&Run> {
        let after = self.around.partition_point(|run| run.first_bin <= bin);
        after.checked_sub(1).map(|k| &self.around[k]).filter(|run| bin < run.end_bin)
    }
}

/// How far cells look around: what the boxes are made for, in centimetres.
pub(super) fn look_cm(mesh: &Mesh, cells: usize, radius: f32) -> f32 {
    radius.max(BOX_SPACINGS * (mesh.area / cells as f32).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    #[test]
    fn budgets_grow_with_what_is_done_as_far_as_their_images() {
        let budget = Budget { images: 100.0, early_times: 4.0 };
        for (done, most) in [(0.0, 5.0), (0.125, 55.0), (0.5, 100.0), (1.0, 100.0)] {
            assert!(budget.lasts(most - 0.1, done) && !budget.lasts(most + 0.1, done), "{done}");
        }
    }

    #[test]
    fn patches_of_many_cells_are_four_repulsive_radii_wide() {
        // A flat square of 32 cm in 512 triangles of 2 square centimetres.
        let n = 16;
        let at = |k: u32| Vec3::new((k % (n + 1)) as f32, (k / (n + 1)) as f32, 0.0) * 2.0;
        let square = |k: u32| {
            let v = k % n + (n + 1) * (k / n);
            [[v, v + 1, v + n + 2], [v, v + n + 2, v + n + 1]]
        };
        let positions = (0..(n + 1) * (n + 1)).map(at).collect();
        let mesh = Mesh::new(positions, Vec::new(), (0..n * n).flat_map(square).collect()).unwrap();
        // 192 cells of these have 20 square centimetres.
        let plan = Plan::new(&mesh, 10_000, 2.0);
        let most = plan.patches.iter().map(|patch| patch.own.len()).max();
        assert!((17..=32).contains(&most.unwrap()), "{most:?} triangles, of (4 * 2 cm)^2 or half");
    }

    #[test]
    fn a_bin_is_found_in_the_run_that_holds_it_alone() {
        let laid = Laid::at([Vec2::ZERO, Vec2::X, Vec2::Y]);
        let run = |first_bin, end_bin| Run { first_bin, end_bin, laid };
        let around = [run(2, 4), run(4, 5), run(8, 9)].into();
        let patch = Neighbourhood { own: 0..0, around, low: Vec2::ZERO, high: Vec2::ZERO };
        let found = [1, 2, 3, 4, 5, 7, 8, 9].map(|bin| patch.run_of(bin).map(|run| run.first_bin));
        assert_eq!(found, [None, Some(2), Some(2), Some(4), None, None, Some(8), None]);
    }
}
