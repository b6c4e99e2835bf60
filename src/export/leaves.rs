//! The leaves of some individuals as a set of pictures for other programs: laid flat side by side, their colours,
//! where they are, how they are bent, and their veins.

use super::flats::{Flat, Flats};
use super::picture::{Channels, write_square};
use super::specimen::Specimen;
use super::zip::write_zip;
use crate::plants::srgb;
use crate::surface::Place;
use glam::{DVec2, Vec2, Vec3};
use serde_json::{Value, json};
use std::io::{self, Write};

/// The side of the pictures for one individual; for more of them the square is larger.
const SIDE_PX: u32 = 2048;
/// Around each leaf, filled with its rim, so that smaller copies of the pictures have no seam.
const GAP_PX: usize = 8;
/// Points along each side of a pixel.
const SAMPLES: usize = 2;
/// From the middle of a midrib to its side; veins of order 2 have half of it, and so on up to the last that is drawn.
const MIDRIB_CM: f32 = 0.06;
const LAST_ORDER: u32 = 4;
/// Steps of the search for the scale.
const STEPS: usize = 30;

/// Pictures in which leaves have their places.
pub struct LeafSet {
    individuals: u32,
    side_px: u32,
    px_per_mm: f64,
    /// The upper left corner of each leaf, one individual after the other.
    corners: Vec<[usize; 2]>,
    colour: Vec<[u8; 3]>,
    alpha: Vec<u8>,
    normal: Vec<[u8; 3]>,
    /// Where the body has some.
    veins: Option<Vec<u8>>,
    told: Vec<Value>,
}

/// What has been seen of a pixel: the sums over its points on the leaf, and how many those are.
#[derive(Clone, Copy, Default)]
struct Pixel {
    light: Vec3,
    normal: Vec3,
    vein: f32,
    count: f32,
}

impl LeafSet {
    /// Gives so many individuals with these flats their places, as large as they fit.
    pub fn new(flats: &Flats, individuals: u32, has_veins: bool) -> LeafSet {
        let side = (1..).find(|side| side * side >= individuals).unwrap_or(1);
        let side_px = SIDE_PX * side;
        let sizes: Vec<DVec2> =
            (0..individuals).flat_map(|_| flats.pieces.iter().map(|flat| flat.size)).collect();
        let largest = sizes.iter().map(|size| size.max_element()).fold(f64::MIN_POSITIVE, f64::max);
        let (mut fits, mut too_large) = (0.0, f64::from(side_px) / largest);
        let mut corners = vec![[GAP_PX; 2]; sizes.len()];
        for _ in 0..STEPS {
            let scale = 0.5 * (fits + too_large);
            match places(&sizes, scale, side_px as usize) {
                Some(found) => (fits, corners) = (scale, found),
                None => too_large = scale,
            }
        }
        let pixels = (side_px as usize).pow(2);
        LeafSet {
            individuals,
            side_px,
            px_per_mm: fits,
            corners,
            colour: vec![[0; 3]; pixels],
            alpha: vec![0; pixels],
            normal: vec![[128, 128, 255]; pixels],
            veins: has_veins.then(|| vec![0; pixels]),
            told: Vec::new(),
        }
    }

    /// Draws the leaves of an individual, the `k`-th, whose number is given, too.
    pub fn draw(&mut self, k: usize, individual: u32, specimen: &Specimen, flats: &Flats) {
        for (piece, flat) in flats.pieces.iter().enumerate() {
            let corner = self.corners[k * flats.pieces.len() + piece];
            let size_px = (flat.size * self.px_per_mm).to_array().map(|x| x.ceil() as usize);
            self.draw_leaf(corner, size_px, specimen, flat);
            self.told.push(json!({
                "individual": individual, "part": flat.part, "corner_px": corner, "size_px": size_px,
            }));
        }
    }

    fn draw_leaf(
        &mut self,
        corner: [usize; 2],
        size_px: [usize; 2],
        specimen: &Specimen,
        flat: &Flat,
    ) {
        let [width, height] = size_px.map(|px| px + 2 * GAP_PX);
        let mut pixels = self.seen(specimen, flat, width, height);
        let alpha: Vec<u8> = pixels
            .iter()
            .map(|pixel| (255.0 * pixel.count / (SAMPLES * SAMPLES) as f32).min(255.0) as u8)
            .collect();
        (0..GAP_PX).for_each(|_| spread(&mut pixels, width));
        let byte = |part: f32| (255.0 * part.clamp(0.0, 1.0) + 0.5) as u8;
        for (k, pixel) in pixels.iter().enumerate().filter(|(_, pixel)| pixel.count > 0.0) {
            let [x, y] = [corner[0] + k % width - GAP_PX, corner[1] + k / width - GAP_PX];
            let at = y * self.side_px as usize + x;
            self.colour[at] = srgb(pixel.light / pixel.count).map(byte);
            self.alpha[at] = alpha[k];
            let normal = pixel.normal.normalize_or(Vec3::Z);
            self.normal[at] = normal.to_array().map(|x| byte(0.5 + 0.5 * x));
            if let Some(veins) = &mut self.veins {
                veins[at] = byte(pixel.vein / pixel.count);
            }
        }
    }

    /// Looks at the points of all pixels of a leaf, which has a gap around it.
    fn seen(&self, specimen: &Specimen, flat: &Flat, width: usize, height: usize) -> Vec<Pixel> {
        let mesh = specimen.mesh;
        let frame = frame(specimen, flat);
        let mut pixels = vec![Pixel::default(); width * height];
        let facets = &specimen.tiling.facets;
        for facet in facets.iter().filter(|f| mesh.parts[f.triangle as usize] == flat.part) {
            let points = facet.corners.map(|point| specimen.tiling.points[point as usize]);
            // In points of pixels, whose own are in the middle of squares.
            let per_mm = self.px_per_mm * SAMPLES as f64;
            let gap = DVec2::splat((GAP_PX * SAMPLES) as f64 - 0.5);
            let [a, b, c] = facet.corners.map(|k| flat.places[k as usize] * per_mm + gap);
            let double = (b - a).perp_dot(c - a);
            if double == 0.0 {
                continue;
            }
            let colour = specimen.colour(facet);
            let normals =
                points.map(|point| Vec3::from_array(frame.map(|axis| axis.dot(point.normal))));
            let corners = points.map(|point| {
                let arm = point.position - mesh.corners(facet.triangle)[0];
                let plane = Vec2::from(mesh.axes(facet.triangle).map(|axis| axis.dot(arm)));
                mesh.frames[facet.triangle as usize].barycentric(plane)
            });
            let (low, high) = (a.min(b).min(c).ceil(), a.max(b).max(c).floor());
            for y in low.y as usize..=high.y.max(0.0) as usize {
                for x in low.x as usize..=high.x.max(0.0) as usize {
                    let at = DVec2::new(x as f64, y as f64);
                    let of_b = (at - a).perp_dot(c - a) / double;
                    let of_c = (b - a).perp_dot(at - a) / double;
                    if of_b < 0.0 || of_c < 0.0 || of_b + of_c > 1.0 {
                        continue;
                    }
                    let [b, c] = [of_b as f32, of_c as f32];
                    let pixel = &mut pixels[y / SAMPLES * width + x / SAMPLES];
                    pixel.light += colour;
                    pixel.normal += normals[0] * (1.0 - b - c) + normals[1] * b + normals[2] * c;
                    pixel.count += 1.0;
                    if self.veins.is_some() {
                        let at = corners[0] * (1.0 - b - c) + corners[1] * b + corners[2] * c;
                        let place = Place { triangle: facet.triangle, b1: at.x, b2: at.y };
                        pixel.vein += self.vein(specimen, place);
                    }
                }
            }
        }
        pixels
    }

    /// How much of the surface around a place is a vein, 0 to 1.
    fn vein(&self, specimen: &Specimen, place: Place) -> f32 {
        let px_per_cm = 10.0 * self.px_per_mm as f32;
        let of_order = |order: u32| {
            let distance = specimen.mesh.veins.distance_cm(specimen.mesh, place, order);
            0.5 + px_per_cm * (MIDRIB_CM / order as f32 - distance)
        };
        (1..=LAST_ORDER).map(of_order).fold(0.0, f32::max).min(1.0)
    }

    /// Writes the pictures and what stands where, in a ZIP.
    ///
    /// # Errors
    /// What `out` says, and more than 4 GB.
    pub fn write(&self, link: &str, out: &mut impl Write) -> io::Result<()> {
        let facts = json!({
            "link": link,
            "individuals": self.individuals,
            "side_px": self.side_px,
            "px_per_cm": 10.0 * self.px_per_mm,
            "leaves": self.told,
        });
        let facts = serde_json::to_vec_pretty(&facts).map_err(io::Error::other)?;
        let square = |channels, bytes| write_square(self.side_px, channels, bytes);
        let colour = square(Channels::Colour, self.colour.as_flattened())?;
        let alpha = square(Channels::Number, &self.alpha)?;
        let normal = square(Channels::Direction, self.normal.as_flattened())?;
        let veins =
            self.veins.as_deref().map(|veins| square(Channels::Number, veins)).transpose()?;
        let mut files = vec![
            ("colour.png", &colour[..]),
            ("alpha.png", &alpha),
            ("normal.png", &normal),
            ("leaves.json", &facts),
        ];
        files.extend(veins.as_deref().map(|veins| ("veins.png", veins)));
        write_zip(&files, 1, out)
    }

    /// What it is in a few words.
    pub fn told(&self) -> String {
        let individuals = match self.individuals {
            1 => String::new(),
            many => format!("{many} individuals, "),
        };
        format!("{individuals}{} pixels wide", self.side_px)
    }
}

/// The upper left corners of leaves of some sizes in rows, the longest first; None if they do not fit.
fn places(sizes: &[DVec2], px_per_mm: f64, side_px: usize) -> Option<Vec<[usize; 2]>> {
    let size_px =
        |k: usize| (sizes[k] * px_per_mm).to_array().map(|x| x.ceil() as usize + 2 * GAP_PX);
    let mut order: Vec<usize> = (0..sizes.len()).collect();
    order.sort_by_key(|&k| std::cmp::Reverse(size_px(k)[1]));
    let mut corners = vec![[0; 2]; sizes.len()];
    let (mut next, mut row_px) = ([0, 0], 0);
    for k in order {
        let [width, height] = size_px(k);
        if next[0] + width > side_px {
            next = [0, next[1] + row_px];
            row_px = 0;
        }
        row_px = row_px.max(height);
        if next[0] + width > side_px || next[1] + row_px > side_px {
            return None;
        }
        corners[k] = next.map(|px| px + GAP_PX);
        next[0] += width;
    }
    Some(corners)
}

/// The axes of a leaf in space: to the right and up as it lies flat, and out of it, in the mean over its area.
fn frame(specimen: &Specimen, flat: &Flat) -> [Vec3; 3] {
    let (mut right, mut out) = (Vec3::ZERO, Vec3::ZERO);
    let parts = &specimen.mesh.parts;
    let facets = specimen.tiling.facets.iter();
    for facet in facets.filter(|facet| parts[facet.triangle as usize] == flat.part) {
        let [a, b, c] = specimen.tiling.corners(facet);
        let flat = facet.corners.map(|point| flat.places[point as usize].as_vec2());
        // y runs down.
        right += (c - a) * (flat[1].y - flat[0].y) - (b - a) * (flat[2].y - flat[0].y);
        out += (b - a).cross(c - a);
    }
    let out = out.normalize_or(Vec3::Z);
    let right = (right - out * right.dot(out)).normalize_or(out.any_orthonormal_vector());
    [right, out.cross(right), out]
}

/// Gives pixels beside the leaf the mean of their neighbours on it.
fn spread(pixels: &mut [Pixel], width: usize) {
    let before = pixels.to_vec();
    for (k, pixel) in pixels.iter_mut().enumerate().filter(|(_, pixel)| pixel.count == 0.0) {
        let x = k % width;
        let beside = [(x > 0).then(|| k - 1), (x + 1 < width).then_some(k + 1)];
        let above = [k.checked_sub(width), Some(k + width)];
        let seen = beside.into_iter().chain(above).flatten().filter_map(|k| before.get(k));
        for other in seen.filter(|other| other.count > 0.0) {
            pixel.light += other.light / other.count;
            pixel.normal += other.normal / other.count;
            pixel.count += 1.0;
        }
    }
}

#[cfg(test)]
mod tests;
