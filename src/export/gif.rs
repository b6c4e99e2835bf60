//! Frames as a GIF that plays on for ever (GIF89a).

use color_quant::NeuQuant;
use gif::{AnyExtension, DisposalMethod, Encoder, EncodingError, Extension, Frame, Repeat};

/// Colours of a film; one more is kept for what stays as it was.
const COLOURS: usize = 255;
const SAME: u8 = COLOURS as u8;
/// How far colours are moved from pixel to pixel, so that fine shades are not seen as steps, in levels of 256.
const DITHER: i32 = 10;
/// The finest of colours that are told apart, as a power of two.
const STEP_BITS: u32 = 2;

/// A GIF that is being written. All frames have one palette, and dithering stays where it is: what rests is at rest.
pub struct Gif {
    encoder: Encoder<Vec<u8>>,
    size_px: [u16; 2],
    delay_cs: u16,
    palette: NeuQuant,
    /// The number of the nearest colour, from 1 on; 0 where it was not looked for.
    nearest: Vec<u8>,
    before: Vec<u8>,
}

impl Gif {
    /// Begins a film in whose frames colours like those of `sample` are seen, pixels of four bytes in sRGB.
    /// `delay_cs`: how long each is shown, in hundredths of a second. The link of what it shows stands in it as a
    /// comment.
    ///
    /// # Errors
    /// What the encoder says, for a size of nothing.
    pub fn new(
        size_px: [u16; 2],
        delay_cs: u16,
        sample: &[u8],
        link: &str,
    ) -> Result<Gif, EncodingError> {
        let palette = NeuQuant::new(1, COLOURS, sample);
        let mut colours = palette.color_map_rgb();
        colours.resize(3 * (COLOURS + 1), 0);
        let mut encoder = Encoder::new(Vec::new(), size_px[0], size_px[1], &colours)?;
        encoder.set_repeat(Repeat::Infinite)?;
        // The encoder cuts it into blocks of 255 bytes.
        let comment = AnyExtension(Extension::Comment as u8);
        encoder.write_raw_extension(comment, &[link.as_bytes()])?;
        let nearest = vec![0; 1 << (3 * (8 - STEP_BITS))];
        Ok(Gif { encoder, size_px, delay_cs, palette, nearest, before: Vec::new() })
    }

    /// Adds a frame of pixels of four bytes in sRGB, row by row from the top, all of them opaque.
    ///
    /// # Errors
    /// What the encoder says.
    pub fn add(&mut self, pixels: &[u8]) -> Result<(), EncodingError> {
        let width = usize::from(self.size_px[0]);
        let numbers: Vec<u8> = pixels
            .chunks_exact(4)
            .enumerate()
            .map(|(k, pixel)| self.number(pixel, k % width, k / width))
            .collect();
        let mut frame =
            Frame { delay: self.delay_cs, dispose: DisposalMethod::Keep, ..Frame::default() };
        match changed(&self.before, &numbers, width) {
            None => {
                (frame.width, frame.height, frame.buffer) =
                    (width as u16, self.size_px[1], numbers.clone().into())
            }
            Some([left, top, right, bottom]) => {
                (frame.left, frame.top) = (left as u16, top as u16);
                (frame.width, frame.height) = ((right - left) as u16, (bottom - top) as u16);
                frame.transparent = Some(SAME);
                let rows = (top..bottom).map(|y| y * width + left..y * width + right);
                let same = |k: usize| if self.before[k] == numbers[k] { SAME } else { numbers[k] };
                frame.buffer = rows.flatten().map(same).collect::<Vec<_>>().into();
            }
        }
        self.encoder.write_frame(&frame)?;
        self.before = numbers;
        Ok(())
    }

    /// The file.
    ///
    /// # Errors
    /// What the encoder says.
    pub fn finish(self) -> Result<Vec<u8>, EncodingError> {
        self.encoder.into_inner()
    }

    /// The number of a colour at a place.
    fn number(&mut self, pixel: &[u8], x: usize, y: usize) -> u8 {
        let by = (2 * bayer(x, y) - 63) * DITHER / 128;
        let part = |k: usize| (i32::from(pixel[k]) + by).clamp(0, 255) as usize >> STEP_BITS;
        let at = (0..3).fold(0, |at, k| at << (8 - STEP_BITS) | part(k));
        if self.nearest[at] == 0 {
            let middle = |k: usize| (part(k) << STEP_BITS | 1 << (STEP_BITS - 1)) as u8;
            let colour = [middle(0), middle(1), middle(2), 255];
            self.nearest[at] = self.palette.index_of(&colour) as u8 + 1;
        }
        self.nearest[at] - 1
    }
}

/// The rectangle of pixels that have changed, left, top, right and bottom; of a frame that is as the one before
/// one pixel, as no frame may be empty. None for the first frame.
fn changed(before: &[u8], now: &[u8], width: usize) -> Option<[usize; 4]> {
    if before.is_empty() {
        return None;
    }
    let differ = |k: &usize| before[*k] != now[*k];
    let places = (0..now.len()).filter(differ).map(|k| (k % width, k / width));
    let within =
        places.fold([usize::MAX, usize::MAX, 0, 0], |[left, top, right, bottom], (x, y)| {
            [left.min(x), top.min(y), right.max(x + 1), bottom.max(y + 1)]
        });
    Some(if within[0] == usize::MAX { [0, 0, 1, 1] } else { within })
}

/// The threshold of a place, 0 to 63, as Bayer (1973) has it.
fn bayer(x: usize, y: usize) -> i32 {
    (0..3).fold(0, |sum, bit| {
        let (x, y) = (x >> bit & 1, y >> bit & 1);
        sum << 2 | ((x ^ y) << 1 | y) as i32
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const LINK: &str = "croton?v=1&s=2&d=3";

    /// A disc on a slope of greens, moved by some pixels.
    fn picture(by: i32) -> Vec<u8> {
        let pixel = |k: i32| {
            let (x, y) = (k % 64, k / 64);
            match (x - 20 - by).pow(2) + (y - 24).pow(2) < 100 {
                true => [200, 40, 60, 255],
                false => [40 + x as u8, 120 + y as u8, 50, 255],
            }
        };
        (0..64 * 48).flat_map(pixel).collect()
    }

    #[test]
    fn frames_are_read_back_in_their_colours() {
        let pictures = [picture(0), picture(0), picture(9)];
        let mut film =
            Gif::new([64, 48], 5, &[&pictures[0][..], &pictures[2]].concat(), LINK).unwrap();
        pictures.iter().for_each(|picture| film.add(picture).unwrap());
        let bytes = film.finish().unwrap();
        assert!(bytes.windows(LINK.len()).any(|window| window == LINK.as_bytes()));
        let mut options = gif::DecodeOptions::new();
        options.set_color_output(gif::ColorOutput::RGBA);
        let mut reader = options.read_info(&bytes[..]).unwrap();
        assert_eq!((reader.width(), reader.height()), (64, 48));
        let mut screen = vec![0; 64 * 48 * 4];
        for picture in &pictures {
            let frame = reader.read_next_frame().unwrap().unwrap();
            assert_eq!(frame.delay, 5);
            for (k, pixel) in frame.buffer.chunks_exact(4).enumerate().filter(|(_, p)| p[3] > 0) {
                let (left, top) = (usize::from(frame.left), usize::from(frame.top));
                let (x, y) = (k % usize::from(frame.width), k / usize::from(frame.width));
                let at = 4 * ((top + y) * 64 + left + x);
                screen[at..at + 4].copy_from_slice(pixel);
            }
            let off: Vec<i32> = screen
                .iter()
                .zip(picture)
                .map(|(a, b)| (i32::from(*a) - i32::from(*b)).abs())
                .collect();
            let mean = f64::from(off.iter().sum::<i32>()) / off.len() as f64;
            assert!(mean < 4.0, "{mean} levels in the mean");
        }
        assert!(reader.read_next_frame().unwrap().is_none());
    }

    #[test]
    fn every_threshold_is_there_once() {
        let mut all: Vec<i32> = (0..64).map(|k| bayer(k % 8, k / 8)).collect();
        assert_eq!(all[..4], [0, 32, 8, 40]);
        all.sort_unstable();
        assert_eq!(all, (0..64).collect::<Vec<_>>());
    }
}
