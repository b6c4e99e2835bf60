//! Large pictures: how large, what stands where, and the tiles in which they are drawn.

use glam::{Mat4, UVec2, Vec2Swizzles, Vec3, Vec4};

/// How large a picture is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SheetSize {
    /// So many pixels for each pixel of CSS on the screen, 1 to 4.
    Screen(u32),
    /// 210 x 297 mm with 300 dots to an inch; `wide`: the other way round.
    A4 { wide: bool },
}

/// A picture with what may stand under it, in pixels from the top left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sheet {
    /// The picture of the plant, at the top.
    pub picture_px: UVec2,
    /// The height of the band under it, which has the caption on the left and the QR code on the right; 0 without
    /// them.
    pub band_px: u32,
    /// A hundredth of the shorter side of the sheet: all in the band is measured by it.
    pub unit_px: f64,
    pub code: Option<CodePlace>,
    /// Pixels of a metre, where it is printed as large as it is meant.
    pub per_metre: u32,
}

/// Where a QR code stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CodePlace {
    pub corner_px: UVec2,
    /// The side of one of its squares.
    pub square_px: u32,
    /// Along a side, with the light rim.
    pub squares: u32,
}

const A4_PX: UVec2 = UVec2::new(2480, 3508);
const A4_PER_METRE: u32 = 11_811;
/// A pixel of CSS is a 96th of an inch.
const SCREEN_PER_METRE: f64 = 96.0 / 0.0254;
/// Of the band, in units: its height, and what is left free at its rims.
const BAND: f64 = 12.0;
const RIM: f64 = 2.0;
/// The least side of a square of a QR code in pixels, so that it is read off a screen, and off paper, where that is
/// 0.4 mm.
const LEAST_SQUARE_PX: u32 = 3;
const LEAST_SQUARE_ON_PAPER_PX: u32 = 5;

/// Side of a tile in pixels: four samples of each, with their depths, take 34 MB.
pub const TILE_PX: u32 = 1024;

impl Sheet {
    /// `screen_px`: of the stage, in pixels of CSS. `code_squares`: along a side of the QR code with the light rim
    /// that it needs, if there is to be one. On paper the band takes its room from the picture, on the screen's
    /// sizes it comes below.
    pub fn new(
        size: SheetSize,
        screen_px: UVec2,
        has_caption: bool,
        code_squares: Option<u32>,
    ) -> Sheet {
        let (whole, per_metre) = match size {
            SheetSize::Screen(times) => {
                (screen_px * times, (SCREEN_PER_METRE * f64::from(times)).round() as u32)
            }
            SheetSize::A4 { wide: false } => (A4_PX, A4_PER_METRE),
            SheetSize::A4 { wide: true } => (A4_PX.yx(), A4_PER_METRE),
        };
        let unit_px = f64::from(whole.min_element()) / 100.0;
        let inner_px = ((BAND - 2.0 * RIM) * unit_px).floor();
        let least_px = match size {
            SheetSize::Screen(_) => LEAST_SQUARE_PX,
            SheetSize::A4 { .. } => LEAST_SQUARE_ON_PAPER_PX,
        };
        let square_px = |squares: u32| (inner_px as u32 / squares).max(least_px);
        let code_px = code_squares.map_or(0, |squares| square_px(squares) * squares);
        let rim_px = (RIM * unit_px).round() as u32;
        let band_px = match has_caption || code_squares.is_some() {
            true => code_px.max(inner_px as u32) + 2 * rim_px,
            false => 0,
        };
        let height = match size {
            SheetSize::Screen(_) => whole.y,
            SheetSize::A4 { .. } => whole.y - band_px,
        };
        let picture_px = UVec2::new(whole.x, height);
        let code = code_squares.map(|squares| {
            let down = (band_px - code_px) / 2;
            let corner_px = UVec2::new(whole.x - rim_px - code_px, height + down);
            CodePlace { corner_px, square_px: square_px(squares), squares }
        });
        Sheet { picture_px, band_px, unit_px, code, per_metre }
    }

    /// Width and height with the band.
    pub fn size_px(&self) -> UVec2 {
        self.picture_px + UVec2::new(0, self.band_px)
    }

    /// The left top corners of the tiles that cover the picture, all as large as `TILE_PX`.
    pub fn tiles(&self) -> Vec<UVec2> {
        let starts = |length: u32| (0..length).step_by(TILE_PX as usize);
        let rows = starts(self.picture_px.y);
        rows.flat_map(|y| starts(self.picture_px.x).map(move |x| UVec2::new(x, y))).collect()
    }

    /// From the clip space of the picture to that of the tile with this corner.
    pub fn onto_tile(&self, corner: UVec2) -> Mat4 {
        let (whole, tile) = (self.picture_px.as_vec2(), TILE_PX as f32);
        let scale = whole / tile;
        let corner = corner.as_vec2();
        // x goes to the right in both; y goes down in pixels and up in clip space.
        let right = (whole.x - 2.0 * corner.x) / tile - 1.0;
        let up = 1.0 - (whole.y - 2.0 * corner.y) / tile;
        Mat4::from_cols(
            Vec4::X * scale.x,
            Vec4::Y * scale.y,
            Vec4::Z,
            Vec3::new(right, up, 0.0).extend(1.0),
        )
    }
}

impl SheetSize {
    /// `1x`, `2x`, `4x`, `a4`, `a4-wide`.
    pub fn of_word(word: &str) -> Option<SheetSize> {
        Some(match word {
            "1x" => SheetSize::Screen(1),
            "2x" => SheetSize::Screen(2),
            "4x" => SheetSize::Screen(4),
            "a4" => SheetSize::A4 { wide: false },
            "a4-wide" => SheetSize::A4 { wide: true },
            _ => return None,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec2;

    const SCREEN: UVec2 = UVec2::new(880, 520);

    #[test]
    fn sizes_are_what_they_are_called() {
        let size = |word, caption, code| {
            Sheet::new(SheetSize::of_word(word).unwrap(), SCREEN, caption, code).size_px()
        };
        assert_eq!(size("1x", false, None), SCREEN);
        assert_eq!(size("4x", false, None), SCREEN * 4);
        for (caption, code) in [(false, None), (true, None), (true, Some(61)), (false, Some(177))] {
            assert_eq!(size("a4", caption, code), UVec2::new(2480, 3508));
            assert_eq!(size("a4-wide", caption, code), UVec2::new(3508, 2480));
        }
        let below = Sheet::new(SheetSize::Screen(2), SCREEN, true, Some(61));
        assert_eq!(below.picture_px, SCREEN * 2, "the view of the screen stays");
        let code = below.code.unwrap();
        assert!(code.square_px >= LEAST_SQUARE_PX);
        let end = code.corner_px + code.square_px * code.squares;
        assert!(end.cmple(below.size_px()).all() && code.corner_px.y > SCREEN.y * 2);
    }

    #[test]
    fn a_place_is_seen_at_the_same_pixel_of_a_tile_and_of_the_whole() {
        let sheet = Sheet::new(SheetSize::A4 { wide: false }, SCREEN, true, None);
        let at_px = |clip: Vec3, size: Vec2| (Vec2::new(clip.x, -clip.y) + 1.0) / 2.0 * size;
        let corners = sheet.tiles();
        assert_eq!(corners.len(), 12, "3 across and 4 down");
        for corner in corners {
            for place in [Vec3::new(-1.0, 1.0, 0.3), Vec3::new(0.4, -0.7, 0.9)] {
                let whole = at_px(place, sheet.picture_px.as_vec2());
                let tile = sheet.onto_tile(corner).project_point3(place);
                assert_eq!(tile.z, place.z);
                let seen = at_px(tile, Vec2::splat(TILE_PX as f32)) + corner.as_vec2();
                assert!(seen.distance(whole) < 0.01, "{seen} and {whole}");
            }
        }
    }
}
