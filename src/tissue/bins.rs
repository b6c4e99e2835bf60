//! Bins: the triangles of a mesh, each cut into equal ones where many cells share it.

use super::lanes::{integers, whole};
use crate::surface::{Frame, Mesh, Place, distance};
use std::ops::Range;
use wide::{f32x4, u32x4};

/// Cuts along an edge at most: their square is the bins of a triangle.
const MAX_CUTS: usize = 32;

/// How the triangles of a mesh are cut into bins: all alike, each into `cuts * cuts` triangles of
/// its own shape.
#[derive(Clone, Debug, Default)]
pub struct Bins {
    pub cuts: usize,
    /// For each triangle the farthest that a point of a bin lies from the bin's centroid, in
    /// centimetres.
    pub sizes: Vec<f32>,
    /// Barycentric coordinates of the bins' centroids, with spare rows for whole lanes.
    centroid_b1: Vec<f32>,
    centroid_b2: Vec<f32>,
}

impl Bins {
    /// Cuts the triangles so that a bin holds about `cells_per_bin` of a population.
    pub fn new(mesh: &Mesh, cells: usize, cells_per_bin: f32) -> Bins {
        let per_triangle = cells as f32 / mesh.triangles.len() as f32;
        let cuts = ((per_triangle / cells_per_bin).sqrt().round() as usize).clamp(1, MAX_CUTS);
        let share = 1.0 / cuts as f32;
        let sizes = mesh.frames.iter().map(|frame| share * size(frame)).collect();
        let mut bins = Bins { cuts, sizes, centroid_b1: Vec::new(), centroid_b2: Vec::new() };
        for i in 0..cuts {
            for column in 0..2 * (cuts - i) - 1 {
                let third = if column % 2 == 0 { 1.0 / 3.0 } else { 2.0 / 3.0 };
                bins.centroid_b1.push((i as f32 + third) * share);
                bins.centroid_b2.push(((column / 2) as f32 + third) * share);
            }
        }
        bins.centroid_b1.resize(cuts * cuts + 4, 0.0);
        bins.centroid_b2.resize(cuts * cuts + 4, 0.0);
        bins
    }

    pub fn in_triangle(&self) -> usize {
        self.cuts * self.cuts
    }

    /// The bins of a triangle.
    pub fn of(&self, triangle: usize) -> Range<usize> {
        triangle * self.in_triangle()..(triangle + 1) * self.in_triangle()
    }

    /// The triangle of a bin, and the bin's number within it.
    pub(super) fn triangle_of(&self, bin: u32) -> (usize, usize) {
        (bin as usize / self.in_triangle(), bin as usize % self.in_triangle())
    }

    /// The bin that a place lies in, where triangles stand in the order of their numbers.
    #[inline]
    pub fn bin(&self, place: Place) -> u32 {
        place.triangle * self.in_triangle() as u32 + self.within(place.b1, place.b2)
    }

    /// The bin within a triangle. Bins are numbered in strips of equal `b1`, those that point up and
    /// down in turn.
    #[inline]
    pub fn within(&self, b1: f32, b2: f32) -> u32 {
        if self.cuts == 1 {
            return 0;
        }
        let cuts = self.cuts as i32;
        let (x, y) = (b1 * cuts as f32, b2 * cuts as f32);
        let i = (x as i32).min(cuts - 1);
        let j = (y as i32).min(cuts - 1 - i);
        let points_down = (x - i as f32) + (y - j as f32) > 1.0 && i + j + 1 < cuts;
        (i * (2 * cuts - i) + 2 * j + i32::from(points_down)) as u32
    }

    /// As `within`, for four places.
    #[inline]
    pub(super) fn four_within(&self, b1: f32x4, b2: f32x4) -> u32x4 {
        if self.cuts == 1 {
            return u32x4::ZERO;
        }
        let (cuts, one) = (f32x4::splat(self.cuts as f32), f32x4::ONE);
        let (x, y) = (b1 * cuts, b2 * cuts);
        let i = whole(x).fast_min(cuts - one);
        let j = whole(y).fast_min(cuts - one - i);
        let points_down = ((x - i) + (y - j)).simd_gt(one) & (i + j + one).simd_lt(cuts) & one;
        // Whole numbers up to `MAX_CUTS` squared are exact as floats.
        integers(i * (cuts + cuts - i) + j + j + points_down)
    }

    /// The centroid of a bin of a triangle, as `b1` and `b2`.
    pub fn centroid(&self, bin: usize) -> (f32, f32) {
        (self.centroid_b1[bin], self.centroid_b2[bin])
    }

    /// The centroids of four bins of a triangle, from the `first` on, as `b1` and `b2`.
    #[inline]
    pub fn centroids(&self, first: usize) -> (f32x4, f32x4) {
        let four = |column: &[f32]| {
            let lanes: [f32; 4] = column[first..first + 4].try_into().expect("four lanes");
            f32x4::new(lanes)
        };
        (four(&self.centroid_b1), four(&self.centroid_b2))
    }
}

/// The farthest that a triangle's corner lies from its centroid.
fn size(frame: &Frame) -> f32 {
    let corners = frame.corners();
    let centroid = (corners[1] + corners[2]) / 3.0;
    corners.iter().map(|&c| distance(c, centroid)).fold(0.0, f32::max)
}

/// The lines through the edges of a triangle, to tell which points lie near it.
pub struct Rim {
    per_apex: f32x4,
    per_length: f32x4,
    apex_x: f32x4,
    /// The barycentric coordinates of one centimetre across each edge.
    per_cm: [f32; 3],
}

impl Rim {
    pub fn new(frame: &Frame) -> Rim {
        let [a, b, c] = frame.corners();
        let area = frame.length * frame.apex.y;
        Rim {
            per_apex: f32x4::splat(1.0 / frame.apex.y),
            per_length: f32x4::splat(1.0 / frame.length),
            apex_x: f32x4::splat(frame.apex.x),
            per_cm: [distance(c, b) / area, distance(c, a) / area, frame.length / area],
        }
    }

    /// The lanes in which a point lies no farther than `reach` outside each of the edges' lines:
    /// all that are within reach of the triangle, and some beyond its corners.
    #[inline]
    pub fn within(&self, x: f32x4, y: f32x4, reach: f32) -> u32 {
        let [h0, h1, h2] = self.sides(x, y, reach);
        (h0 & h1 & h2).to_bitmask()
    }

    /// The same for each edge by itself, as masks.
    #[inline]
    pub fn sides(&self, x: f32x4, y: f32x4, reach: f32) -> [f32x4; 3] {
        let lowest = self.per_cm.map(|per_cm| f32x4::splat(-reach * per_cm));
        let h2 = y * self.per_apex;
        let h1 = (x - h2 * self.apex_x) * self.per_length;
        let h0 = f32x4::ONE - h1 - h2;
        [h0.simd_ge(lowest[0]), h1.simd_ge(lowest[1]), h2.simd_ge(lowest[2])]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    /// A triangle and so many cells in it that it is cut as often as is asked for.
    fn cut(cuts: usize) -> Bins {
        let mesh = Mesh::new(vec![Vec3::ZERO, Vec3::X, Vec3::Y], Vec::new(), vec![[0, 1, 2]]);
        let bins = Bins::new(&mesh.unwrap(), 3 * cuts * cuts, 3.0);
        assert_eq!(bins.cuts, cuts);
        bins
    }

    #[test]
    fn bins_are_numbered_strip_by_strip_and_their_points_lie_in_them() {
        for cuts in [1, 2, 3, 7, MAX_CUTS] {
            let bins = cut(cuts);
            assert_eq!(
                (bins.in_triangle(), bins.of(5)),
                (cuts * cuts, 5 * cuts * cuts..6 * cuts * cuts)
            );
            let mut number = 0;
            for i in 0..cuts {
                for j in 0..cuts - i {
                    let share = 1.0 / cuts as f32;
                    let (low_1, low_2) = (i as f32 * share, j as f32 * share);
                    // One that points up, and beside it one that points down, but at the end of its strip.
                    let points_down = usize::from(i + j + 1 < cuts);
                    for (bin, at) in (number..=number + points_down).zip([0.0, 1.0]) {
                        let third = share * (1.0 + at) / 3.0;
                        let (b1, b2) = bins.centroid(bin);
                        assert!((b1 - low_1 - third).abs() < 1e-6, "{bin} of {cuts}");
                        assert!((b2 - low_2 - third).abs() < 1e-6, "{bin} of {cuts}");
                        // Near each corner, too.
                        for (c1, c2) in [(at, at), (1.0, 0.0), (0.0, 1.0)] {
                            let near = |b: f32, low: f32, c: f32| b + 0.98 * (low + share * c - b);
                            let (b1, b2) = (near(b1, low_1, c1), near(b2, low_2, c2));
                            assert_eq!(bins.within(b1, b2), bin as u32, "{b1}, {b2} of {cuts}");
                            let place = Place { triangle: 3, b1, b2 };
                            assert_eq!(bins.bin(place) as usize, bins.of(3).start + bin);
                            assert_eq!(bins.triangle_of(bins.bin(place)), (3, bin));
                        }
                    }
                    number += 1 + points_down;
                }
            }
            assert_eq!(number, cuts * cuts);
        }
    }

    #[test]
    fn four_places_have_the_bins_of_each_on_borders_too() {
        for cuts in [1, 2, 3, 7, 16, MAX_CUTS] {
            let bins = cut(cuts);
            for a in 0..=96 {
                for b in 0..=96 - a {
                    let (b1, b2) = (a as f32 / 96.0, b as f32 / 96.0);
                    let four = bins.four_within(f32x4::splat(b1), f32x4::splat(b2));
                    assert_eq!(four.to_array(), [bins.within(b1, b2); 4], "{b1}, {b2} of {cuts}");
                }
            }
        }
    }
}
