//! Files in a ZIP, stored as they are (PKWARE, APPNOTE.TXT, 4.3).

use std::io::{self, Write};

/// The header of an extra field that is padding (APPNOTE.TXT, 4.5.1; this number is for nothing else).
const PADDING: u16 = 0x1986;

/// Writes a ZIP of named files, the content of each at a whole multiple of `aligned` bytes, up to 64.
///
/// # Errors
/// What `out` says, and more than 4 GB, which the plain format cannot hold.
pub fn write_zip(files: &[(&str, &[u8])], aligned: usize, out: &mut impl Write) -> io::Result<()> {
    let mut at = 0;
    let mut directory = Vec::new();
    for &(name, bytes) in files {
        let long = [crc32(bytes), size(bytes.len())?, size(bytes.len())?];
        // Version 2.0, no flags, stored, and midnight of 1980-01-01.
        let mut facts: Vec<u8> =
            [20u16, 0, 0, 0, 33].into_iter().flat_map(u16::to_le_bytes).collect();
        facts.extend(long.into_iter().flat_map(u32::to_le_bytes));
        facts.extend((name.len() as u16).to_le_bytes());
        // The length of the extra field stands before the name.
        let padding = padding(at + 4 + facts.len() + 2 + name.len(), aligned);
        let length = (padding.len() as u16).to_le_bytes();
        for part in [&b"PK\x03\x04"[..], &facts, &length, name.as_bytes(), &padding, bytes] {
            out.write_all(part)?;
        }
        directory.extend(b"PK\x01\x02\x14\x00");
        directory.extend(&facts);
        // No extra field here, no comment, disc 0, plain attributes.
        directory.extend([0; 12]);
        directory.extend(size(at)?.to_le_bytes());
        directory.extend(name.as_bytes());
        at += 4 + facts.len() + 2 + name.len() + padding.len() + bytes.len();
    }
    out.write_all(&directory)?;
    out.write_all(b"PK\x05\x06\0\0\0\0")?;
    let count = (files.len() as u16).to_le_bytes();
    out.write_all(&[count, count].concat())?;
    out.write_all(&size(directory.len())?.to_le_bytes())?;
    out.write_all(&size(at)?.to_le_bytes())?;
    out.write_all(&[0; 2])
}

/// An extra field after which a file's content is aligned; none where it is without one.
fn padding(at: usize, aligned: usize) -> Vec<u8> {
    let missing = at.next_multiple_of(aligned) - at;
    if missing == 0 {
        return Vec::new();
    }
    // Number and length of the field have two bytes each.
    let whole = if missing < 4 { missing + aligned } else { missing };
    let mut field = [PADDING, whole as u16 - 4].map(u16::to_le_bytes).concat();
    field.resize(whole, 0);
    field
}

fn size(bytes: usize) -> io::Result<u32> {
    u32::try_from(bytes).map_err(|_| io::Error::other("such a file cannot hold more than 4 GB"))
}

/// The check of ISO 3309, a byte at a time.
pub(super) fn crc32(bytes: &[u8]) -> u32 {
    let table: [u32; 256] = std::array::from_fn(|k| {
        (0..8).fold(k as u32, |c, _| if c & 1 == 1 { 0xedb8_8320 ^ c >> 1 } else { c >> 1 })
    });
    !bytes.iter().fold(!0, |crc, &byte| table[(crc as u8 ^ byte) as usize] ^ crc >> 8)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_check_is_that_of_the_standard() {
        assert_eq!(crc32(b"123456789"), 0xcbf4_3926);
    }
}
