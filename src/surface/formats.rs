//! What a file of a visitor's own is, by its first bytes.

use super::BroughtError;
use std::borrow::Cow;

/// How files begin that are often taken for bodies, and what they are.
const KNOWN: [(&[u8], BroughtError); 11] = [
    (b"\x1f\x8b", BroughtError::Packed("gzip")),
    (b"PK\x03\x04", BroughtError::Packed("zip")),
    (b"7z\xbc\xaf", BroughtError::Packed("7-Zip")),
    (b"\x28\xb5\x2f\xfd", BroughtError::Packed("Zstandard")),
    (b"\xff\xfe", BroughtError::Utf16),
    (b"\xfe\xff", BroughtError::Utf16),
    (b"{", BroughtError::Other("a JSON file, as glTF is")),
    (b"<", BroughtError::Other("an XML or HTML file")),
    (b"OFF\n", BroughtError::Other("an OFF file")),
    (b"Kaydara FBX", BroughtError::Other("an FBX file")),
    (b"BLENDER", BroughtError::Other("a Blender file")),
];

/// Bytes of the beginning in which no text has a zero.
const BEGINNING: usize = 1000;

/// A file that may hold a body.
#[derive(Debug, PartialEq)]
pub enum Format<'a> {
    /// The text of an OBJ file. Bytes that are not UTF-8 became `�`: they stand in comments and names, as programs
    /// wrote them in the encoding of their place and time.
    Obj(Cow<'a, str>),
    Ply,
    Glb,
}

/// # Errors
/// Bytes that are certainly no body that can be read, with what they are.
pub fn format_of(bytes: &[u8]) -> Result<Format<'_>, BroughtError> {
    match bytes {
        [b'p', b'l', b'y', b'\n' | b'\r', ..] => return Ok(Format::Ply),
        [b'g', b'l', b'T', b'F', ..] => return Ok(Format::Glb),
        _ => {}
    }
    if let Some((_, what)) = KNOWN.iter().find(|(start, _)| bytes.starts_with(start)) {
        return Err(what.clone());
    }
    if is_stl(bytes) {
        return Err(BroughtError::Other("an STL file"));
    }
    match bytes.iter().take(BEGINNING).position(|&byte| byte == 0) {
        // A letter in two bytes, one of them zero.
        Some(0 | 1) if bytes.len() > 1 && (bytes[0] | bytes[1]).is_ascii() => {
            Err(BroughtError::Utf16)
        }
        Some(_) => Err(BroughtError::Other("a binary file")),
        None => Ok(Format::Obj(String::from_utf8_lossy(bytes))),
    }
}

/// In text an STL file begins with `solid` and goes on with facets; in bytes it has 80 of any kind, the
/// number of its triangles, and 50 for each of them.
fn is_stl(bytes: &[u8]) -> bool {
    let beginning = &bytes[..bytes.len().min(BEGINNING)];
    let in_text = bytes.starts_with(b"solid") && beginning.windows(5).any(|word| word == b"facet");
    let in_bytes = || {
        let count = bytes.get(80..84)?.try_into().ok().map(u32::from_le_bytes)?;
        Some(bytes.len() as u64 == 84 + 50 * u64::from(count))
    };
    in_text || in_bytes() == Some(true)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refusal(bytes: &[u8]) -> String {
        format_of(bytes).unwrap_err().to_string()
    }

    #[test]
    fn what_is_no_body_is_told_by_its_name() {
        let stl = [&[b'x'; 80][..], &2u32.to_le_bytes(), &[0; 100]].concat();
        let utf_16: Vec<u8> = "v 0 0 0".encode_utf16().flat_map(u16::to_le_bytes).collect();
        let utf_16_other: Vec<u8> = "v 0 0 0".encode_utf16().flat_map(u16::to_be_bytes).collect();
        for (bytes, word) in [
            (&b"\x1f\x8b\x08\x00\x00"[..], "gzip"),
            (b"PK\x03\x04\x14", "zip"),
            (b"solid a\n facet normal 0 0 1\n", "STL"),
            (&stl, "STL"),
            (b"{\"asset\":{}}", "glTF"),
            (&utf_16, "UTF-16"),
            (&utf_16_other, "UTF-16"),
            (b"\xff\xfev\x00", "UTF-16"),
            (b"\xfe\xff\x00v", "UTF-16"),
            (b"\x89abc\x00\x01\x02", "binary"),
        ] {
            let told = refusal(bytes);
            assert!(told.contains(word) && told.lines().count() == 1, "{told}");
        }
    }

    #[test]
    fn text_is_text_whatever_it_is_encoded_in() {
        let obj = |text: &str| Ok(Format::Obj(text.to_string().into()));
        assert_eq!(format_of(b"# Andr\xe9\nv 0 0 0"), obj("# Andr\u{fffd}\nv 0 0 0"));
        for text in ["", "v", "solid ground", "# a facet", "g plyers"] {
            assert_eq!(format_of(text.as_bytes()), obj(text));
        }
    }
}
