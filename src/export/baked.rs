//! The mosaic of a day as the texture of its body.

use super::packing::GAP_PX;
use super::unwrapped::{Unwound, Unwrapped};
use crate::mosaic::{Site, SiteLists};
use crate::plants::{Look, srgb};
use crate::surface::Mesh;
use crate::tissue::CellType;
use glam::{Vec2, Vec3};
use wide::f32x4;

/// Pixels side by side that look for their cells together.
const LANES: usize = 4;
/// Steps from no light to all of it, each with its byte in sRGB.
const LIGHT_STEPS: usize = 1 << 12;
/// Triangles are drawn so much larger that no pixel between two is left out.
const SEAM_PX: f32 = 0.01;

/// Draws the mosaic into the square of an unwrapped body: three bytes a pixel, in sRGB, row by row from the top. A pixel
/// through which a border goes is mixed from the cells on both of its sides.
///
/// `mesh`: as it stands on the day of the lists.
pub(super) fn bake(
    mesh: &Mesh,
    lists: &SiteLists,
    look: &Look,
    unwrapped: &Unwrapped,
    side_px: u32,
) -> Vec<u8> {
    let side = side_px as usize;
    let baker = Baker { mesh, lists, unwrapped, side, colours: Colours::new(look) };
    let mut pixels = vec![0; 3 * side * side];
    let hands = hands();
    let rows = side.div_ceil(hands);
    let bands = pixels.chunks_mut(3 * side * rows).enumerate();
    let draw = |(band, pixels): (usize, &mut [u8])| baker.draw(band * rows, pixels);
    if hands == 1 {
        bands.for_each(draw);
    } else {
        std::thread::scope(|scope| bands.for_each(|band| drop(scope.spawn(move || draw(band)))));
    }
    pixels
}

/// How many work side by side, each on a band of rows.
fn hands() -> usize {
    match cfg!(target_arch = "wasm32") {
        true => 1,
        false => std::thread::available_parallelism().map_or(1, usize::from),
    }
}

struct Baker<'a> {
    mesh: &'a Mesh,
    lists: &'a SiteLists,
    unwrapped: &'a Unwrapped,
    side: usize,
    colours: Colours,
}

/// The colours of cells, by what their sites' tags say.
struct Colours {
    /// By type, tint and lightness, in linear light.
    of_tags: Vec<Vec3>,
    of_nobody: Vec3,
    bytes: Vec<u8>,
}

/// A site in the plane of a triangle, from its centroid, in centimetres.
#[derive(Clone, Copy)]
struct Seen {
    at: Vec2,
    colour: Vec3,
    bytes: [u8; 3],
}

impl Baker<'_> {
    /// Draws some rows, from a first one on.
    fn draw(&self, first_row: usize, pixels: &mut [u8]) {
        let ground = self.colours.bytes_of(self.colours.of_nobody);
        pixels.as_chunks_mut::<3>().0.fill(ground);
        let mut sites = Vec::new();
        let triangles = &self.unwrapped.triangles;
        // Around each piece its rim goes on, which then lies under what is really there.
        let rims = triangles.iter().filter(|own| own.is_rim).map(|own| (own, GAP_PX as f32));
        for (own, margin_px) in rims.chain(triangles.iter().map(|own| (own, SEAM_PX))) {
            self.draw_triangle(own, margin_px, first_row, pixels, &mut sites);
        }
    }

    fn draw_triangle(
        &self,
        own: &Unwound,
        margin_px: f32,
        first_row: usize,
        pixels: &mut [u8],
        sites: &mut Vec<Seen>,
    ) {
        let [a, b, c] = own.corners.map(|k| self.unwrapped.corners[k as usize].1);
        let double = (b - a).perp_dot(c - a);
        let (low, high) = (a.min(b).min(c) - margin_px, a.max(b).max(c) + margin_px);
        let end_row = first_row + pixels.len() / (3 * self.side);
        let top = ((low.y - 0.5).ceil().max(0.0) as usize).max(first_row);
        let bottom = ((high.y + 0.5).floor().max(0.0) as usize).min(end_row);
        if double == 0.0 || top >= bottom {
            return;
        }
        let edges = [(a, b), (b, c), (c, a)].map(|(from, to)| {
            let inwards = (to - from).perp().normalize_or_zero() * double.signum();
            (inwards, inwards.dot(from) - margin_px)
        });
        let triangle = own.triangle as usize;
        let head = &self.lists.heads[triangle];
        sites.clear();
        sites.extend(
            self.lists.of(triangle).iter().map(|site| self.colours.seen(site, site.now(head))),
        );
        if sites.is_empty() {
            let (at, colour) = (Vec2::ZERO, self.colours.of_nobody);
            sites.push(Seen { at, colour, bytes: self.colours.bytes_of(colour) });
        }
        // From pixels to the plane of the triangle.
        let frame = self.mesh.frames[triangle].corners();
        let centroid = (frame[0] + frame[1] + frame[2]) / 3.0;
        let (to_b, to_c) = (frame[1] - frame[0], frame[2] - frame[0]);
        let along_x = (to_b * (c - a).y - to_c * (b - a).y) / double;
        let along_y = (to_c * (b - a).x - to_b * (c - a).x) / double;
        let px_per_cm = 1.0 / along_x.perp_dot(along_y).abs().sqrt();
        for row in top..bottom {
            let y = row as f32 + 0.5;
            let (mut from, mut to) = (low.x, high.x);
            for (inwards, least) in edges {
                let rest = least - inwards.y * y;
                if inwards.x > 0.0 {
                    from = from.max(rest / inwards.x);
                } else if inwards.x < 0.0 {
                    to = to.min(rest / inwards.x);
                } else if rest > 0.0 {
                    to = f32::NEG_INFINITY;
                }
            }
            let first = (from - 0.5).ceil().max(0.0) as usize;
            let end = ((to + 0.5).floor().max(0.0) as usize).min(self.side);
            let start = 3 * (row - first_row) * self.side;
            let row = &mut pixels[start..start + 3 * self.side];
            let begin = frame[0] - centroid + along_y * (y - a.y);
            for first in (first..end).step_by(LANES) {
                let at = begin + along_x * (first as f32 + 0.5 - a.x);
                let found = nearest_two(sites, at, along_x);
                for (k, [one, other]) in found.into_iter().enumerate().take(end - first) {
                    let bytes = self.mixed(sites, one, other, px_per_cm);
                    row[3 * (first + k)..3 * (first + k) + 3].copy_from_slice(&bytes);
                }
            }
        }
    }

    /// The colour of a pixel between its two nearest sites, given with the squares of their distances.
    fn mixed(
        &self,
        sites: &[Seen],
        one: (f32, usize),
        other: (f32, usize),
        px_per_cm: f32,
    ) -> [u8; 3] {
        let (near, far) = (&sites[one.1], &sites[other.1]);
        if near.bytes == far.bytes {
            return near.bytes;
        }
        let from_border_px = 0.5 * (other.0 - one.0) / near.at.distance(far.at) * px_per_cm;
        if from_border_px >= 0.5 {
            return near.bytes;
        }
        self.colours.bytes_of(far.colour.lerp(near.colour, 0.5 + from_border_px))
    }
}

/// For each of four points in a row, a step apart, the numbers of the two nearest sites, and the squares of how far
/// they are; twice the same where there is but one.
#[inline]
fn nearest_two(sites: &[Seen], at: Vec2, step: Vec2) -> [[(f32, usize); 2]; LANES] {
    let steps = f32x4::new([0.0, 1.0, 2.0, 3.0]);
    let x = f32x4::splat(at.x) + steps * f32x4::splat(step.x);
    let y = f32x4::splat(at.y) + steps * f32x4::splat(step.y);
    let (mut near, mut far) = (f32x4::splat(f32::INFINITY), f32x4::splat(f32::INFINITY));
    let (mut nearest, mut second) = (f32x4::ZERO, f32x4::ZERO);
    for (k, site) in sites.iter().enumerate() {
        let (dx, dy) = (x - f32x4::splat(site.at.x), y - f32x4::splat(site.at.y));
        let (squared, number) = (dx * dx + dy * dy, f32x4::splat(k as f32));
        let is_nearest = squared.simd_lt(near);
        let other = is_nearest.select(near, squared);
        let other_number = is_nearest.select(nearest, number);
        let is_second = other.simd_lt(far);
        far = is_second.select(other, far);
        second = is_second.select(other_number, second);
        near = is_nearest.select(squared, near);
        nearest = is_nearest.select(number, nearest);
    }
    let [near, far] = [near, far].map(f32x4::to_array);
    let [nearest, second] = [nearest, second].map(f32x4::to_array);
    std::array::from_fn(|k| [(near[k], nearest[k] as usize), (far[k], second[k] as usize)])
}

impl Colours {
    fn new(look: &Look) -> Colours {
        let of_tag = |tag: usize| {
            let kind = CellType::ALL[tag >> 7];
            look.of_cell(kind, tag as u32 >> 4 & 7, tag as u32 & 15)
        };
        let byte = |step: usize| {
            let light = Vec3::splat((step as f32 + 0.5) / LIGHT_STEPS as f32);
            (255.0 * srgb(light)[0] + 0.5) as u8
        };
        Colours {
            of_tags: (0..CellType::ALL.len() << 7).map(of_tag).collect(),
            of_nobody: look.of_nobody(),
            bytes: (0..LIGHT_STEPS).map(byte).collect(),
        }
    }

    fn seen(&self, site: &Site, at: Vec2) -> Seen {
        let tag = site.tag();
        let colour = self.of_tags[(tag.kind << 7 | tag.tint << 4 | tag.lightness) as usize];
        Seen { at, colour, bytes: self.bytes_of(colour) }
    }

    fn bytes_of(&self, linear: Vec3) -> [u8; 3] {
        let step = |light: f32| ((light * LIGHT_STEPS as f32) as usize).min(LIGHT_STEPS - 1);
        linear.to_array().map(|light| self.bytes[step(light)])
    }
}
