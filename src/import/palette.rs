//! The colours of a photograph of a plant, and how large their patches are.

use crate::plants::{linear, srgb};
use glam::Vec3;
use std::collections::BTreeMap;

/// A photograph's pixels, four bytes each in sRGB, row by row from the top.
#[derive(Clone, Copy, Debug)]
pub struct Photo<'a> {
    pub width_px: usize,
    pub pixels: &'a [u8],
}

/// The colours of a photograph, those of most of it first.
#[derive(Clone, Debug, PartialEq)]
pub struct Palette {
    pub colours: Vec<Part>,
    /// Cells of a random mosaic with as many borders between the first colour and the others.
    pub cells: f64,
}

/// One of the colours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    /// sRGB, 0 to 1.
    pub colour: [f32; 3],
    /// Its share of the plant, 0 to 1.
    pub share: f64,
}

/// Levels of each part of sRGB that are told apart: shades within one are noise of the camera.
const LEVELS: u8 = 32;
/// Shadows differ in lightness alone, so that it counts less than hue.
const LIGHTNESS: f32 = 0.6;
/// Distances in OKLab: of shades that are one to the eye in a plain background, and of two colours.
const ALIKE: f32 = 0.08;
const APART: f32 = 0.05;
/// The share of the border that is plain where there is a background.
const PLAIN: f64 = 0.7;
/// The least share of the plant that a colour begins with: fewer pixels are dust and glints.
const LEAST_SHARE: f64 = 0.004;
const ROUNDS: usize = 20;

/// Finds colours, 2 or 3, by k-means in OKLab. A plain background around the plant, and what is transparent, is
/// left out.
///
/// # Errors
/// In plain words, why there are not so many.
pub fn palette(photo: Photo, count: usize) -> Result<Palette, &'static str> {
    let labs: Vec<Option<Vec3>> = photo.pixels.chunks_exact(4).map(lab_of).collect();
    let subject = without_background(&labs, photo.width_px);
    let shades = shades(&labs, &subject, photo.pixels);
    let pixels: f64 = shades.iter().map(|shade| shade.weight).sum();
    let mut means = first_means(&shades, count, LEAST_SHARE * pixels).ok_or(
        "It has too few colours: choose a picture in which the patches can be told apart.",
    )?;
    for _ in 0..ROUNDS {
        let mut sums = vec![(Vec3::ZERO, 0.0); count];
        for shade in &shades {
            let (sum, weight) = &mut sums[nearest(&means, shade.lab)];
            *sum += shade.lab * shade.weight as f32;
            *weight += shade.weight;
        }
        for (mean, (sum, weight)) in means.iter_mut().zip(sums) {
            if weight > 0.0 {
                *mean = sum / weight as f32;
            }
        }
    }
    let mut labels: Vec<Option<usize>> = labs
        .iter()
        .zip(&subject)
        .map(|(lab, is)| lab.filter(|_| *is).map(|lab| nearest(&means, lab)))
        .collect();
    let share = |k| labels.iter().flatten().filter(|&&label| label == k).count() as f64 / pixels;
    let mut order: Vec<(usize, f64)> = (0..count).map(|k| (k, share(k))).collect();
    order.sort_by(|a, b| b.1.total_cmp(&a.1));
    let colours =
        order.iter().map(|&(k, share)| Part { colour: colour_of(means[k]), share }).collect();
    smooth(&mut labels, photo.width_px);
    Ok(Palette { colours, cells: cells(&labels, photo.width_px, order[0].0) })
}

/// A colour in OKLab (Ottosson, A perceptual color space for image processing, 2020).
pub fn oklab(colour: [f32; 3]) -> Vec3 {
    let rgb = linear(colour);
    let lms = Vec3::new(
        rgb.dot(Vec3::new(0.412_221_46, 0.536_332_55, 0.051_445_995)),
        rgb.dot(Vec3::new(0.211_903_5, 0.680_699_5, 0.107_396_96)),
        rgb.dot(Vec3::new(0.088_302_46, 0.281_718_85, 0.629_978_7)),
    );
    let root = Vec3::from(lms.to_array().map(libm::cbrtf));
    Vec3::new(
        root.dot(Vec3::new(0.210_454_26, 0.793_617_8, -0.004_072_047)),
        root.dot(Vec3::new(1.977_998_5, -2.428_592_2, 0.450_593_7)),
        root.dot(Vec3::new(0.025_904_037, 0.782_771_77, -0.808_675_8)),
    )
}

/// And back, in sRGB.
fn colour_of(lab: Vec3) -> [f32; 3] {
    let root = Vec3::new(
        lab.dot(Vec3::new(1.0, 0.396_337_78, 0.215_803_76)),
        lab.dot(Vec3::new(1.0, -0.105_561_346, -0.063_854_17)),
        lab.dot(Vec3::new(1.0, -0.089_484_18, -1.291_485_5)),
    );
    let lms = root * root * root;
    srgb(Vec3::new(
        lms.dot(Vec3::new(4.076_741_7, -3.307_711_6, 0.230_969_94)),
        lms.dot(Vec3::new(-1.268_438, 2.609_757_4, -0.341_319_4)),
        lms.dot(Vec3::new(-0.004_196_086_3, -0.703_418_6, 1.707_614_7)),
    ))
}

fn lab_of(pixel: &[u8]) -> Option<Vec3> {
    let [colour @ .., alpha] = [pixel[0], pixel[1], pixel[2], pixel[3]];
    (alpha >= 128).then(|| oklab(colour.map(|part| f32::from(part) / 255.0)))
}

fn distance(a: Vec3, b: Vec3) -> f32 {
    ((a - b) * Vec3::new(LIGHTNESS, 1.0, 1.0)).length()
}

fn nearest(means: &[Vec3], lab: Vec3) -> usize {
    let of = |k: usize| distance(means[k], lab);
    (0..means.len()).min_by(|&a, &b| of(a).total_cmp(&of(b))).unwrap_or(0)
}

/// Which pixels are of the plant: all but those that hang together with a border which is plain.
fn without_background(labs: &[Option<Vec3>], width: usize) -> Vec<bool> {
    let mut subject: Vec<bool> = labs.iter().map(Option::is_some).collect();
    let height = labs.len() / width.max(1);
    let is_border = |k: &usize| {
        let (x, y) = (k % width, k / width);
        x == 0 || y == 0 || x + 1 == width || y + 1 == height
    };
    let border: Vec<usize> = (0..labs.len()).filter(is_border).collect();
    let shades: Vec<Vec3> = border.iter().filter_map(|&k| labs[k]).collect();
    let Some(&plain) = shades.iter().max_by_key(|&&shade| alike(&shades, shade)) else {
        return subject;
    };
    if (alike(&shades, plain) as f64) < PLAIN * border.len() as f64 {
        return subject;
    }
    let mut open = border;
    while let Some(k) = open.pop() {
        let is_plain = labs[k].is_some_and(|lab| (lab - plain).length() < ALIKE);
        if is_plain && std::mem::take(&mut subject[k]) {
            let (x, y) = (k % width, k / width);
            let beside = [(x > 0, k.wrapping_sub(1)), (x + 1 < width, k + 1)];
            let above = [(y > 0, k.wrapping_sub(width)), (y + 1 < height, k + width)];
            open.extend(beside.into_iter().chain(above).filter(|(is, _)| *is).map(|(_, k)| k));
        }
    }
    subject
}

/// How many of some shades are one with another.
fn alike(shades: &[Vec3], with: Vec3) -> usize {
    shades.iter().filter(|shade| (**shade - with).length() < ALIKE).count()
}

/// Pixels of about one colour.
struct Shade {
    lab: Vec3,
    weight: f64,
}

fn shades(labs: &[Option<Vec3>], subject: &[bool], pixels: &[u8]) -> Vec<Shade> {
    let mut sums: BTreeMap<[u8; 3], (Vec3, f64)> = BTreeMap::new();
    for ((lab, _), pixel) in
        labs.iter().zip(subject).zip(pixels.chunks_exact(4)).filter(|((_, is), _)| **is)
    {
        let key = [pixel[0], pixel[1], pixel[2]].map(|part| part / (255 / LEVELS + 1));
        let (sum, weight) = sums.entry(key).or_default();
        *sum += lab.unwrap_or_default();
        *weight += 1.0;
    }
    sums.into_values().map(|(sum, weight)| Shade { lab: sum / weight as f32, weight }).collect()
}

/// The shade of most pixels, and those that are farthest from all before; none where they are not apart.
fn first_means(shades: &[Shade], count: usize, least: f64) -> Option<Vec<Vec3>> {
    let most = shades.iter().max_by(|a, b| a.weight.total_cmp(&b.weight))?;
    let mut means = vec![most.lab];
    while means.len() < count {
        let gap = |lab: Vec3| distance(means[nearest(&means, lab)], lab);
        let candidates = shades.iter().filter(|shade| shade.weight >= least);
        let farthest = candidates.max_by(|a, b| gap(a.lab).total_cmp(&gap(b.lab)))?;
        if gap(farthest.lab) < APART {
            return None;
        }
        means.push(farthest.lab);
    }
    Some(means)
}

/// Gives each pixel the colour that most of the nine around it have: what is smaller is noise.
fn smooth(labels: &mut [Option<usize>], width: usize) {
    let before = labels.to_vec();
    for (k, label) in labels.iter_mut().enumerate().filter(|(_, label)| label.is_some()) {
        let mut counts = [0; 4];
        for row in [k.wrapping_sub(width), k, k + width] {
            for at in [row.wrapping_sub(1), row, row.wrapping_add(1)] {
                if let Some(Some(other)) = before.get(at) {
                    counts[*other] += 1;
                }
            }
        }
        *label = (0..counts.len()).max_by_key(|&of| counts[of]);
    }
}

/// Cells of a mosaic in which each has a colour by chance. In a Poisson-Voronoi mosaic of `c` cells to the area a
/// line meets `4 sqrt(c) / pi` borders to the length (Okabe, Boots, Sugihara and Chiu, Spatial Tessellations, 5.5),
/// and with a share `p` of a colour it changes at `2 p (1 - p)` of them from this one or to it.
fn cells(labels: &[Option<usize>], width: usize, of: usize) -> f64 {
    let at = |x: usize, y: usize| labels[y * width + x];
    let height = labels.len() / width.max(1);
    let (mut length, mut changes) = (0.0, 0.0);
    let mut pair = |pair: [Option<usize>; 2]| {
        if let [Some(a), Some(b)] = pair {
            length += 1.0;
            changes += f64::from(u8::from((a == of) != (b == of)));
        }
    };
    for y in 0..height {
        for x in 0..width {
            if x + 1 < width {
                pair([at(x, y), at(x + 1, y)]);
            }
            if y + 1 < height {
                pair([at(x, y), at(x, y + 1)]);
            }
        }
    }
    let pixels = labels.iter().flatten().count() as f64;
    let share = labels.iter().flatten().filter(|&&label| label == of).count() as f64 / pixels;
    let borders = changes / length / (2.0 * share * (1.0 - share));
    let root = borders * std::f64::consts::PI / 4.0;
    if root.is_finite() { root * root * pixels } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIDE: usize = 256;
    const YELLOW: [u8; 3] = [226, 200, 62];
    const GREEN: [u8; 3] = [48, 96, 40];
    const RED: [u8; 3] = [178, 36, 52];

    /// Chance without a library: the upper bits of a linear congruential sequence.
    fn chance(state: &mut u64) -> f64 {
        *state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*state >> 40) as f64 / f64::from(1 << 24)
    }

    /// A disc of Voronoi cells of chance colours, in light that fades to the right, with a camera's noise.
    fn leaf(cells: usize, shares: &[([u8; 3], f64)], around: [u8; 3]) -> Vec<u8> {
        let mut state = 7;
        let side = SIDE as f64;
        let sites: Vec<([f64; 2], [u8; 3])> = (0..cells)
            .map(|_| {
                let at = [side * chance(&mut state), side * chance(&mut state)];
                let mut draw = chance(&mut state);
                let colour = shares.iter().find(|(_, share)| {
                    draw -= share;
                    draw < 0.0
                });
                (at, colour.unwrap_or(&shares[0]).0)
            })
            .collect();
        let mut pixels = Vec::new();
        for k in 0..SIDE * SIDE {
            let [x, y] = [(k % SIDE) as f64, (k / SIDE) as f64];
            let far = |[a, b]: [f64; 2]| (a - x) * (a - x) + (b - y) * (b - y);
            let is_leaf = far([side / 2.0; 2]) < 0.23 * side * side;
            let site = sites.iter().min_by(|a, b| far(a.0).total_cmp(&far(b.0))).unwrap();
            let light = if is_leaf { 1.05 - 0.25 * x / side } else { 1.0 };
            let noise = 6.0 * (chance(&mut state) - 0.5);
            let colour = if is_leaf { site.1 } else { around };
            pixels.extend(colour.map(|c| (f64::from(c) * light + noise).clamp(0.0, 255.0) as u8));
            pixels.push(255);
        }
        pixels
    }

    fn found(pixels: &[u8], count: usize) -> Palette {
        palette(Photo { width_px: SIDE, pixels }, count).unwrap()
    }

    fn near(part: &Part, colour: [u8; 3]) -> bool {
        distance(oklab(part.colour), oklab(colour.map(|c| f32::from(c) / 255.0))) < 0.05
    }

    #[test]
    fn oklab_is_that_of_its_author() {
        // The examples of the article: white, and red.
        let [white, red] = [[1.0; 3], [1.0, 0.0, 0.0]].map(oklab);
        assert!((white - Vec3::new(1.0, 0.0, 0.0)).length() < 1e-3, "{white}");
        assert!((red - Vec3::new(0.628, 0.2249, 0.1258)).length() < 1e-3, "{red}");
        for colour in [[0.2, 0.4, 0.1], [0.9, 0.8, 0.2], [0.0, 0.0, 0.0]] {
            let back = colour_of(oklab(colour));
            assert!(back.iter().zip(colour).all(|(a, b)| (a - b).abs() < 2e-3), "{back:?}");
        }
    }

    #[test]
    fn two_colours_on_white_are_found_with_their_shares() {
        let leaf = leaf(900, &[(YELLOW, 0.3), (GREEN, 0.7)], [250, 250, 248]);
        let found = found(&leaf, 2);
        let [green, yellow] = &found.colours[..] else { panic!("two colours") };
        assert!(near(green, GREEN) && near(yellow, YELLOW), "{found:?}");
        assert!(
            (yellow.share - 0.3).abs() < 0.05 && (green.share + yellow.share - 1.0).abs() < 1e-9
        );
        // The disc is 0.23 pi of the picture, and smoothing takes a few of the smallest.
        let expected = 900.0 * 0.23 * std::f64::consts::PI;
        assert!((found.cells / expected - 1.0).abs() < 0.25, "{} for {expected}", found.cells);
    }

    #[test]
    fn three_colours_that_fill_the_picture_are_found() {
        let shares = [(GREEN, 0.5), (YELLOW, 0.3), (RED, 0.2)];
        for around in [[30, 30, 34], [120, 160, 220]] {
            let found = found(&leaf(400, &shares, around), 3);
            for (colour, share) in shares {
                let part = found.colours.iter().find(|part| near(part, colour));
                let part = part.unwrap_or_else(|| panic!("no {colour:?}: {found:?}"));
                assert!((part.share - share).abs() < 0.07, "{part:?} for {share}");
            }
        }
    }

    #[test]
    fn the_finer_the_patches_the_more_cells() {
        let cells = [100, 400, 1600]
            .map(|cells| found(&leaf(cells, &[(YELLOW, 0.4), (GREEN, 0.6)], [0, 0, 0]), 2).cells);
        assert!(cells[0] * 2.5 < cells[1] && cells[1] * 2.5 < cells[2], "{cells:?}");
    }

    #[test]
    fn a_picture_of_one_colour_is_refused_in_words() {
        for pixels in [[90, 120, 60, 255].repeat(SIDE * SIDE), vec![0; 4 * SIDE * SIDE], vec![]] {
            let why = palette(Photo { width_px: SIDE, pixels: &pixels }, 2).unwrap_err();
            assert!(why.contains("too few colours"), "{why}");
        }
    }
}
