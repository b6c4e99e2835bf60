//! A picture of the screen as PNG (W3C, Portable Network Graphics), with the link of what it shows inside.

use super::zip::crc32;
use std::io;

/// Dots of a metre at 250 to an inch.
const PER_METRE: u32 = 9843;

/// The PNG of pixels, four bytes each in sRGB, row by row from the top. The link stands in it as text (`iTXt`,
/// `Link`), not packed, so that it is found again.
///
/// # Errors
/// Pixels that are not as many as the size says.
pub fn write_picture(size_px: [u32; 2], pixels: &[u8], link: &str) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, size_px[0], size_px[1]);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    encoder.set_pixel_dims(Some(png::PixelDimensions {
        xppu: PER_METRE,
        yppu: PER_METRE,
        unit: png::Unit::Meter,
    }));
    let text = |keyword: &str, text: &str| (keyword.to_string(), text.to_string());
    for (keyword, text) in [text("Link", link), text("Software", "Clonal Mosaic")] {
        encoder.add_itxt_chunk(keyword, text).map_err(io::Error::other)?;
    }
    let mut png = encoder.write_header().map_err(io::Error::other)?;
    png.write_image_data(pixels).map_err(io::Error::other)?;
    png.finish().map_err(io::Error::other)?;
    Ok(bytes)
}

/// A PNG that a browser has made, with a link in it, as `write_picture` puts it there, and the pixels of a metre at
/// which it is as large as it is meant. None for what is no PNG.
pub fn with_link(png: &[u8], link: &str, per_metre: u32) -> Option<Vec<u8>> {
    /// The signature, and the header, which comes first.
    const BEGINNING: usize = 8 + 4 + 4 + 13 + 4;
    let (beginning, rest) = png.split_at_checked(BEGINNING)?;
    let _ = beginning.strip_prefix(b"\x89PNG\r\n\x1a\n")?;
    let text = |keyword: &str, text: &str| {
        [b"iTXt", keyword.as_bytes(), &[0; 5], text.as_bytes()].concat()
    };
    // Dots of a metre, across and down.
    let size = [b"pHYs", &per_metre.to_be_bytes()[..], &per_metre.to_be_bytes(), &[1]].concat();
    let mut bytes = beginning.to_vec();
    for chunk in [size, text("Link", link), text("Software", "Clonal Mosaic")] {
        bytes.extend((chunk.len() as u32 - 4).to_be_bytes());
        bytes.extend(&chunk);
        bytes.extend(crc32(&chunk).to_be_bytes());
    }
    bytes.extend(rest);
    Some(bytes)
}

/// What a pixel says, a byte for each part.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Channels {
    /// Three parts, in sRGB.
    Colour,
    /// Three parts, -1 to 1.
    Direction,
    /// One, 0 to 1.
    Number,
}

/// The PNG of a square of pixels, row by row from the top.
///
/// # Errors
/// Pixels that are not as many as the side says.
pub(super) fn write_square(side_px: u32, channels: Channels, pixels: &[u8]) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, side_px, side_px);
    encoder.set_color(match channels {
        Channels::Number => png::ColorType::Grayscale,
        _ => png::ColorType::Rgb,
    });
    encoder.set_depth(png::BitDepth::Eight);
    if channels == Channels::Colour {
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    }
    let mut png = encoder.write_header().map_err(io::Error::other)?;
    png.write_image_data(pixels).map_err(io::Error::other)?;
    png.finish().map_err(io::Error::other)?;
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_is_read_back_with_its_link() {
        let (link, pixels) = ("croton?v=1&s=2&d=3", [7, 8, 9, 255, 0, 0, 0, 0]);
        let bytes = write_picture([2, 1], &pixels, link).unwrap();
        let mut reader = png::Decoder::new(io::Cursor::new(&bytes)).read_info().unwrap();
        let mut read = [0; 8];
        reader.next_frame(&mut read).unwrap();
        assert_eq!(read, pixels);
        let text = &reader.info().utf8_text[0];
        assert_eq!((&*text.keyword, &*text.get_text().unwrap()), ("Link", link));
        assert!(bytes.windows(link.len()).any(|window| window == link.as_bytes()));
        assert!(write_picture([2, 2], &pixels, link).is_err());
    }

    #[test]
    fn a_link_is_put_into_a_picture_of_a_browser() {
        let link = "cactus?v=1&s=2&d=3";
        let plain = write_square(1, Channels::Colour, &[7, 8, 9]).unwrap();
        let bytes = with_link(&plain, link, 11_811).unwrap();
        let mut reader = png::Decoder::new(io::Cursor::new(&bytes)).read_info().unwrap();
        let mut read = [0; 3];
        reader.next_frame(&mut read).unwrap();
        assert_eq!(read, [7, 8, 9]);
        let info = reader.info();
        let text = &info.utf8_text[0];
        assert_eq!((&*text.keyword, &*text.get_text().unwrap()), ("Link", link));
        let size = info.pixel_dims.unwrap();
        assert_eq!((size.xppu, size.yppu, size.unit), (11_811, 11_811, png::Unit::Meter));
        assert_eq!(with_link(b"GIF89a", link, 1), None);
        assert_eq!(with_link(&[0; 40], link, 1), None);
    }
}
