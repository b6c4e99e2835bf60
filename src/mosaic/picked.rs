//! Which of the sites near a triangle are in its list.

use super::near::{Near, NearSite};
use crate::surface::{Frame, distance};
use crate::tissue::{LANES, Rim};
use wide::f32x4;

/// The triangle whose list is made.
pub struct Home<'a> {
    pub frame: &'a Frame,
    pub rim: Rim,
    /// The farthest that a corner lies from the centroid, in centimetres.
    pub size: f32,
}

/// The sites of one list.
#[derive(Clone, Debug, Default)]
pub struct Picked {
    sites: Vec<NearSite>,
    ways: Vec<FourWays>,
    /// Of the middles of those ways from one point.
    distances: Vec<f32x4>,
    keep: Vec<u32>,
    /// Of a grid, each with the number of a site in its low bits.
    squares: Vec<u64>,
}

/// How four sites go from the day before to now: the middle of each way, and half its length.
#[derive(Clone, Copy, Debug)]
struct FourWays {
    middle_x: f32x4,
    middle_y: f32x4,
    half: f32x4,
}

/// Far from everything.
const NO_WAYS: FourWays =
    FourWays { middle_x: f32x4::splat(1e9), middle_y: f32x4::splat(1e9), half: f32x4::ZERO };

/// Parts that a triangle is looked at in are this large, in mean spacings. Larger, and lists get
/// longer; smaller, and looking takes longer than what is saved.
const PART_SPACINGS: f32 = 0.4;
const MAX_PART_CUTS: usize = 10;

/// Lists of more sites than this are long: those of their sites that lie within so many mean spacings of
/// each other, half the width of a drawn border, are one.
const LONG: usize = 255;
const SAME_SPACINGS: f32 = 0.03;

/// More sites than these the shader cannot tell apart: in a list of more, those are one that lie farther
/// from each other, too.
const MOST_SITES: usize = 1023;

/// Of a site's number when clumps are merged; more sites than that stay as they are.
const NUMBER_BITS: u32 = 16;

impl Picked {
    /// The sites whose polygons may reach into the triangle.
    pub fn sites(&self) -> impl Iterator<Item = &NearSite> {
        self.sites
            .iter()
            .enumerate()
            .filter_map(|(k, site)| (self.keep[k / LANES] & 1 << (k % LANES) != 0).then_some(site))
    }

    /// Picks the sites whose polygons may reach into the triangle at some moment: first
    /// those that come within `bound` of it, and of these the ones that are not much farther from some
    /// part of the triangle than its nearest one. `room` is added to what the polygons need.
    pub fn pick(&mut self, near: &Near, home: &Home, bound: f32, room: f32, spacing: f32) {
        self.sites.clear();
        self.ways.clear();
        for first in (0..near.len).step_by(LANES) {
            let [now, before] = near.four(first);
            let within_now = home.rim.sides(now.0, now.1, bound);
            let within_before = home.rim.sides(before.0, before.1, bound);
            let mut keep = ((within_now[0] | within_before[0])
                & (within_now[1] | within_before[1])
                & (within_now[2] | within_before[2]))
                .to_bitmask()
                & ((1 << (near.len - first).min(LANES)) - 1);
            while keep != 0 {
                self.add(near, first + keep.trailing_zeros() as usize);
                keep &= keep - 1;
            }
        }
        self.thin_out(home, room, spacing);
    }

    /// Where more cells crowd together than anybody can see, the youngest stands for those that lie beside it,
    /// now and the day before. `step_cm`: nearer than this none can be told apart.
    pub fn merge_clumps(&mut self, step_cm: f32, spacing: f32) {
        let mut step_cm = step_cm;
        loop {
            let count = self.sites().count();
            let is_long = count > LONG && step_cm < SAME_SPACINGS * spacing;
            if !is_long && count <= MOST_SITES {
                return;
            }
            self.merge(step_cm);
            step_cm *= 2.0;
        }
    }

    /// Keeps the youngest of the sites in each square of a grid, now and the day before. Coordinates have twelve
    /// bits, as in the lists.
    fn merge(&mut self, step_cm: f32) {
        let step = |x: f32| (x / step_cm) as i32 as u64 & 0xfff;
        let square = |site: &NearSite| {
            step(site.now.x)
                | step(site.now.y) << 12
                | step(site.before.x) << 24
                | step(site.before.y) << 36
        };
        self.squares.clear();
        for (k, site) in self.sites.iter().enumerate().take(1 << NUMBER_BITS) {
            if self.keep[k / LANES] & 1 << (k % LANES) != 0 {
                self.squares.push(square(site) << NUMBER_BITS | k as u64);
            }
        }
        self.squares.sort_unstable();
        let mut last = (u64::MAX, 0);
        for &key in &self.squares {
            let (square, k) = (key >> NUMBER_BITS, key as usize & ((1 << NUMBER_BITS) - 1));
            if square != last.0 {
                last = (square, k);
                continue;
            }
            let older = if self.sites[k].cell < self.sites[last.1].cell { k } else { last.1 };
            last.1 = k + last.1 - older;
            self.keep[older / LANES] &= !(1 << (older % LANES));
        }
    }

    fn add(&mut self, near: &Near, k: usize) {
        let site = near.site(k);
        let middle = 0.5 * (site.now + site.before);
        let lane = self.sites.len() % LANES;
        if lane == 0 {
            self.ways.push(NO_WAYS);
        }
        if let Some(four) = self.ways.last_mut() {
            four.middle_x.as_mut_array()[lane] = middle.x;
            four.middle_y.as_mut_array()[lane] = middle.y;
            four.half.as_mut_array()[lane] = 0.5 * distance(site.now, site.before);
        }
        self.sites.push(site);
    }

    /// Keeps the sites that are nearest to a point of the triangle at some moment, or nearly so.
    fn thin_out(&mut self, home: &Home, room: f32, spacing: f32) {
        self.keep.clear();
        self.keep.resize(self.ways.len(), 0);
        self.distances.resize(self.ways.len(), f32x4::ZERO);
        let cuts = ((home.size / (PART_SPACINGS * spacing)) as usize + 1).min(MAX_PART_CUTS);
        let share = 1.0 / cuts as f32;
        let slack = 2.0 * home.size * share + room;
        for i in 0..cuts {
            for column in 0..2 * (cuts - i) - 1 {
                let third = if column % 2 == 0 { 1.0 / 3.0 } else { 2.0 / 3.0 };
                let (b1, b2) = (i as f32 + third, (column / 2) as f32 + third);
                let centre = home.frame.point(b1 * share, b2 * share);
                let (x, y) = (f32x4::splat(centre.x), f32x4::splat(centre.y));
                let mut nearest = f32x4::splat(f32::INFINITY);
                for (four, distance) in self.ways.iter().zip(&mut self.distances) {
                    let (dx, dy) = (four.middle_x - x, four.middle_y - y);
                    *distance = (dx * dx + dy * dy).sqrt();
                    nearest = nearest.fast_min(*distance + four.half);
                }
                let nearest = nearest.to_array().into_iter().fold(f32::INFINITY, f32::min);
                let reach = f32x4::splat(nearest + slack);
                let looked_at = self.ways.iter().zip(&self.distances);
                for (keep, (four, distance)) in self.keep.iter_mut().zip(looked_at) {
                    *keep |= (*distance - four.half).simd_le(reach).to_bitmask();
                }
            }
        }
    }
}
