//! A picture of a flat torus, which can be laid side by side without a seam.

use crate::mosaic::lightness;
use crate::plants::{Look, srgb};
use crate::surface::Mesh;
use crate::tissue::Diary;
use glam::{DVec2, Vec3};

/// The cells of a day on a flat torus.
pub struct Tile {
    side_cm: f64,
    /// Each with its colour in linear light.
    cells: Vec<(DVec2, Vec3)>,
    /// Numbers of cells, by the squares of a grid that they lie in.
    by_square: Vec<Vec<u32>>,
    squares: usize,
}

/// Points along each side of a pixel whose colours are averaged.
const SAMPLES: u32 = 2;

impl Tile {
    /// A day that stands in the diary of a growth on `flat_torus(side_cm, _)`, in the colours of a look.
    pub fn new(torus: &Mesh, side_cm: f32, look: &Look, diary: &Diary, day: usize) -> Tile {
        let places = diary.days[day].places.iter().zip(&diary.lineage).zip(0..);
        let cells = places.map(|((&place, cell), number)| {
            let point = torus.point(place).as_dvec3().truncate();
            (point, look.of_cell(cell.kind, 0, lightness(number)))
        });
        Tile::of(side_cm.into(), cells.collect())
    }

    /// There must be a cell.
    fn of(side_cm: f64, mut cells: Vec<(DVec2, Vec3)>) -> Tile {
        let squares = (cells.len() as f64).sqrt() as usize;
        let mut by_square = vec![Vec::new(); squares * squares];
        for (number, (point, _)) in (0..).zip(&mut cells) {
            *point = DVec2::new(point.x.rem_euclid(side_cm), point.y.rem_euclid(side_cm));
            let [column, row] = square_of(*point, side_cm, squares);
            by_square[row * squares + column].push(number);
        }
        Tile { side_cm, cells, by_square, squares }
    }

    /// The picture, so many pixels wide and high: three bytes for each, in sRGB, row by row from the top.
    pub fn pixels(&self, side_px: u32) -> Vec<u8> {
        let sample_cm = self.side_cm / f64::from(side_px * SAMPLES);
        let mut pixels = Vec::with_capacity(3 * (side_px as usize).pow(2));
        for row in (0..side_px).rev() {
            for column in 0..side_px {
                let mut light = Vec3::ZERO;
                for k in 0..SAMPLES * SAMPLES {
                    let [x, y] = [column * SAMPLES + k % SAMPLES, row * SAMPLES + k / SAMPLES];
                    let point = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5) * sample_cm;
                    light += self.cells[self.nearest(point)].1;
                }
                let colour = srgb(light / (SAMPLES * SAMPLES) as f32);
                pixels.extend(colour.map(|part| (255.0 * part + 0.5) as u8));
            }
        }
        pixels
    }

    /// The cell that is nearest to a point, whichever way around; of several the one born first.
    fn nearest(&self, point: DVec2) -> usize {
        let [column, row] = square_of(point, self.side_cm, self.squares).map(|k| k as i64);
        let square_cm = self.side_cm / self.squares as f64;
        let mut nearest = (f64::INFINITY, 0);
        for ring in 0..=self.squares as i64 {
            // All that is farther out is at least so far away.
            let beyond_cm = (ring - 1).max(0) as f64 * square_cm;
            if nearest.0 < beyond_cm * beyond_cm {
                break;
            }
            for dy in -ring..=ring {
                let step = if dy.abs() == ring { 1 } else { (2 * ring).max(1) };
                for dx in (-ring..=ring).step_by(step as usize) {
                    for &number in &self.by_square[self.index(column + dx, row + dy)] {
                        let apart = self.cells[number as usize].0 - point;
                        let apart = apart - (apart / self.side_cm).round() * self.side_cm;
                        let found = (apart.length_squared(), number as usize);
                        if found < nearest {
                            nearest = found;
                        }
                    }
                }
            }
        }
        nearest.1
    }

    fn index(&self, column: i64, row: i64) -> usize {
        let around = |k: i64| k.rem_euclid(self.squares as i64) as usize;
        around(row) * self.squares + around(column)
    }
}

/// Column and row of the square that a point lies in.
fn square_of(point: DVec2, side_cm: f64, squares: usize) -> [usize; 2] {
    [point.x, point.y].map(|x| ((x / side_cm * squares as f64) as usize).min(squares - 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Points without any order, on the 64ths of a square of 8 cm, in colours of their own.
    fn scattered(count: u32) -> Vec<(DVec2, Vec3)> {
        let scatter =
            |k: u32| k.wrapping_mul(0x9e37_79b9).rotate_left(13).wrapping_mul(0x85eb_ca6b);
        let at = |k: u32| f64::from(scatter(k) % 512) / 64.0;
        let grey = |k: u32| (scatter(k) % 97) as f32 / 97.0;
        (0..count).map(|k| (DVec2::new(at(k), at(k + 9000)), Vec3::splat(grey(k)))).collect()
    }

    #[test]
    fn every_point_has_the_colour_of_the_nearest_cell_around_the_torus() {
        let cells = scattered(150);
        let tile = Tile::of(8.0, cells.clone());
        for k in 0..2000 {
            let point = scattered(2001)[k].0 + DVec2::splat(0.0071);
            let apart = |(cell, _): &(DVec2, Vec3)| {
                let copies =
                    (0..9).map(|c| DVec2::new((c % 3 - 1) as f64, (c / 3 - 1) as f64) * 8.0);
                copies.map(|by| (*cell + by).distance_squared(point)).fold(f64::INFINITY, f64::min)
            };
            let nearest = cells.iter().map(apart).fold(f64::INFINITY, f64::min);
            let found = apart(&cells[tile.nearest(point)]);
            assert!((found - nearest).abs() < 1e-9, "{found} for {nearest}");
        }
    }

    #[test]
    fn there_is_no_seam() {
        // Cells that are all moved by so many pixels give the picture that is rolled by as many, byte for
        // byte: the border lies nowhere.
        let (side_px, by) = (64, [23, 50]);
        let before = Tile::of(8.0, scattered(300)).pixels(side_px);
        let shift = DVec2::new(f64::from(by[0]), f64::from(by[1])) * (8.0 / 64.0);
        let moved = scattered(300).into_iter().map(|(point, colour)| (point + shift, colour));
        let after = Tile::of(8.0, moved.collect()).pixels(side_px);
        let at = |pixels: &[u8], x: u32, y: u32| {
            let k = 3 * ((side_px - 1 - y) * side_px + x) as usize;
            [pixels[k], pixels[k + 1], pixels[k + 2]]
        };
        for (x, y) in (0..side_px).flat_map(|x| (0..side_px).map(move |y| (x, y))) {
            let there = [(x + by[0]) % side_px, (y + by[1]) % side_px];
            assert_eq!(at(&before, x, y), at(&after, there[0], there[1]), "{x}, {y}");
        }
    }
}
