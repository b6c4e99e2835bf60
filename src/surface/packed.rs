//! Meshes as they are downloaded: OBJ texts in which the numbers of a `v`, `vt`, `f`, `l` or `#v` line are differences
//! from those in the line of the same kind before, coordinates in hundredths. `meshes/pack.awk` writes them,
//! when the page is built: they compress to two fifths of what the OBJ files do. A vertex of a moment (`#v`) is
//! told by its way since the moment before, and that by the difference from the way of the vertex before.

/// The kinds of lines that are packed, and what their numbers are whole parts of. The name of a vertex of a moment
/// is left away.
const KINDS: [(&str, i32); 5] = [("v", 100), ("vt", 100), ("f", 1), ("l", 1), ("", 100)];

/// How a text begins that is not packed.
pub const PLAIN: &str = "# plain ";

/// The OBJ text that was packed. Lines that are none of ours are left as they are, for whoever reads the
/// text to refuse.
pub fn unpack(packed: &str) -> String {
    if packed.starts_with(PLAIN) {
        return packed.to_string();
    }
    let mut text = String::with_capacity(2 * packed.len());
    let mut before: [Vec<i32>; KINDS.len()] = Default::default();
    // Where the vertices were at the last moment, and the number of the next one of this.
    let (mut vertices, mut next) = (Vec::<[i32; 3]>::new(), 0);
    for line in packed.lines() {
        let is_of = |(name, _): &(&str, _)| {
            line.strip_prefix(name).is_some_and(|rest| rest.starts_with(' '))
        };
        match KINDS.iter().position(is_of) {
            Some(kind) => {
                let (name, parts) = KINDS[kind];
                if name.is_empty() {
                    text.push_str("#v");
                }
                // Where it was; of all but a vertex that moves, nowhere.
                let mut at =
                    vertices.get(next).filter(|_| name.is_empty()).copied().unwrap_or([0; 3]);
                unpack_line(line, parts, &mut before[kind], &mut at, &mut text);
                match name {
                    "v" => vertices.push(at),
                    "" if next < vertices.len() => {
                        vertices[next] = at;
                        next += 1;
                    }
                    _ => {}
                }
            }
            None => {
                text.push_str(line);
                if line.starts_with("#moment") {
                    before[KINDS.len() - 1].clear();
                    next = 0;
                }
            }
        }
        text.push('\n');
    }
    text
}

/// Digits and signs are differences; all else stays. The first three numbers are told from those of `from`,
/// where they are written as well.
fn unpack_line(
    line: &str,
    parts: i32,
    before: &mut Vec<i32>,
    from: &mut [i32; 3],
    text: &mut String,
) {
    let (mut place, mut sign, mut difference) = (0, 1, None);
    for c in line.chars().chain([' ']) {
        if let Some(digit) = c.to_digit(10) {
            difference =
                Some(difference.unwrap_or(0_i32).wrapping_mul(10).wrapping_add(digit as i32));
            continue;
        }
        if let Some(size) = difference.take() {
            if before.len() == place {
                before.push(0);
            }
            before[place] = before[place].wrapping_add(size.wrapping_mul(sign));
            let mut number = before[place];
            if let Some(from) = from.get_mut(place) {
                *from = from.wrapping_add(number);
                number = *from;
            }
            push_number(number, parts, text);
            (place, sign) = (place + 1, 1);
        }
        if c == '-' {
            sign = -1;
        } else {
            text.push(c);
        }
    }
    text.pop();
}

/// Writes a number of hundredths, or of wholes, as a decimal.
fn push_number(number: i32, parts: i32, text: &mut String) {
    if number < 0 {
        text.push('-');
    }
    let mut rest = number.unsigned_abs();
    let mut digits = [b'0'; 10];
    let mut first = digits.len() - if parts > 1 { 3 } else { 1 };
    for k in (0..digits.len()).rev() {
        digits[k] += (rest % 10) as u8;
        rest /= 10;
        if digits[k] > b'0' {
            first = first.min(k);
        }
    }
    for (k, &digit) in digits.iter().enumerate().skip(first) {
        if parts > 1 && k == digits.len() - 2 {
            text.push('.');
        }
        text.push(char::from(digit));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::PolygonMesh;
    use std::path::Path;
    use std::process::Command;

    #[test]
    fn every_mesh_is_read_the_same_after_it_was_packed() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("meshes");
        let files = std::fs::read_dir(&folder).unwrap().map(|file| file.unwrap().path());
        let mut meshes = 0;
        for file in files.filter(|file| file.extension().is_some_and(|end| end == "obj")) {
            let packed =
                Command::new("awk").arg("-f").arg(folder.join("pack.awk")).arg(&file).output();
            let packed = packed.unwrap();
            assert!(packed.status.success(), "{}", String::from_utf8_lossy(&packed.stderr));
            let packed = String::from_utf8(packed.stdout).unwrap();
            let text = std::fs::read_to_string(&file).unwrap();
            assert_ne!(packed, text);
            assert_eq!(PolygonMesh::parse(&unpack(&packed)), PolygonMesh::parse(&text));
            meshes += 1;
        }
        assert!(meshes >= 8);
    }

    #[test]
    fn differences_add_up() {
        let packed = "# 1 2\nv 100 -5 0\nv -101 5 99999\nf 1/1 2 3//4\nf 1/2 1 1//-1\ng leaf 7\n";
        let text =
            "# 1 2\nv 1.00 -0.05 0.00\nv -0.01 0.00 999.99\nf 1/1 2 3//4\nf 2/3 3 4//3\ng leaf 7\n";
        assert_eq!(unpack(packed), text);
    }

    #[test]
    fn what_was_not_packed_is_left_to_be_refused() {
        let text = "v one two\nvn 1 2\n<html>\n";
        assert_eq!(unpack(text), text);
    }
}
