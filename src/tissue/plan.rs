//! The plan of a relaxation: which cells each patch has to look at. It holds for all events of some
//! days, until the repulsive radius has become much smaller.

use super::bins::Bins;
use crate::surface::{Image, Mesh, Outline, Patches, Place};
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
    pub(super) runs: Vec<Run>,
    radius: f32,
    cells: usize,
}

/// A patch and all that its cells may feel.
#[derive(Clone, Debug)]
pub(super) struct Neighbourhood {
    /// Its triangles, in the order of the bins.
    pub(super) own: Range<usize>,
    /// The runs around it.
    pub(super) around: Range<usize>,
    /// The part of the plane in which all of this lies.
    pub(super) low: Vec2,
    pub(super) high: Vec2,
}

/// A triangle of a patch, laid down in its plane.
#[derive(Clone, Copy, Debug)]
pub(super) struct Own {
    pub(super) image: Image,
    /// What a vector of the plane is to be multiplied with for its changes of `b1` and `b2`.
    pub(super) to_barycentric: [Vec2; 2],
}

/// Bins of one triangle that follow each other.
#[derive(Clone, Copy, Debug)]
pub(super) struct Run {
    pub(super) first_bin: u32,
    pub(super) end_bin: u32,
    pub(super) image: Image,
}

impl Plan {
    /// Makes the plan anew if it does not serve any more.
    pub(super) fn renew(&mut self, mesh: &Mesh, cells: usize, radius: f32) {
        let serves = (SMALLEST_RADIUS * self.radius..=self.radius).contains(&radius)
            && cells as f32 * SMALLEST_RADIUS * SMALLEST_RADIUS <= self.cells as f32;
        if !serves {
            *self = Plan::new(mesh, cells, radius);
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
        let bins = Bins::new(mesh, cells, CELLS_PER_BIN);
        let area_per_cell = mesh.area / cells as f32;
        let width = PATCH_WIDTH_RADII * radius;
        let area = (CELLS_PER_PATCH * area_per_cell).max(width * width);
        let Patches { order, patches, images } = Patches::new(mesh, area, radius);
        let mut slot_of = vec![0; order.len()];
        for (slot, &triangle) in order.iter().enumerate() {
            slot_of[triangle as usize] = slot as u32;
        }
        let mut plan = Plan {
            own: Vec::with_capacity(order.len()),
            patches: Vec::with_capacity(patches.len()),
            runs: Vec::new(),
            bins,
            order,
            slot_of,
            radius,
            cells,
        };
        for patch in patches {
            let (own, around) = images[patch.images].split_at(patch.own.len());
            plan.own.extend(
                own.iter()
                    .map(|image| Own { image: *image, to_barycentric: image.to_barycentric() }),
            );
            // Room for a box more than `look_cm` around, and for rounding.
            let margin = Vec2::splat(1.5 * look_cm(mesh, cells, radius));
            let (mut low, mut high) = (patch.outline.low - margin, patch.outline.high + margin);
            let first = plan.runs.len();
            for image in around {
                plan.add_runs(image, &patch.outline, radius);
            }
            for run in &plan.runs[first..] {
                let first_in_triangle = run.first_bin as usize % plan.bins.in_triangle();
                let size = Vec2::splat(plan.bins.sizes[run.image.triangle as usize]);
                for k in 0..(run.end_bin - run.first_bin) as usize {
                    let (b1, b2) = plan.bins.centroid(first_in_triangle + k);
                    let centroid = run.image.origin + run.image.edge1 * b1 + run.image.edge2 * b2;
                    (low, high) = (low.min(centroid - size), high.max(centroid + size));
                }
            }
            plan.patches.push(Neighbourhood {
                own: patch.own,
                around: first..plan.runs.len(),
                low,
                high,
            });
        }
        plan
    }

    /// Adds the bins of a triangle that come within the radius of a patch.
    fn add_runs(&mut self, image: &Image, outline: &Outline, radius: f32) {
        let of = self.bins.of(self.slot_of[image.triangle as usize] as usize);
        let reach = radius + self.bins.sizes[image.triangle as usize];
        let mut last_bin = None;
        for bin in of.clone() {
            let (b1, b2) = self.bins.centroid(bin - of.start);
            let centroid = image.origin + image.edge1 * b1 + image.edge2 * b2;
            if self.bins.cuts > 1 && !outline.is_within(reach, &[centroid]) {
                continue;
            }
            if last_bin == Some(bin) {
                self.runs.last_mut().expect("a run has begun").end_bin += 1;
            } else {
                let (first_bin, end_bin) = (bin as u32, bin as u32 + 1);
                self.runs.push(Run { first_bin, end_bin, image: *image });
            }
            last_bin = Some(bin + 1);
        }
    }
}

/// How far cells look around: what the boxes are made for, in centimetres.
pub(super) fn look_cm(mesh: &Mesh, cells: usize, radius: f32) -> f32 {
    radius.max(BOX_SPACINGS * (mesh.area / cells as f32).sqrt())
}
