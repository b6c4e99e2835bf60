//! Meshes as they are downloaded: OBJ texts in which all `v`, `vt` or `#v` lines that follow each other are one, with
//! their first numbers, then their second ones and so on as letters: each the difference from the one before it, in
//! hundredths. A vertex of a moment (`#v`, whose name is left away) is told by its way since the moment before. The
//! numbers of an `f` or `l` line are differences from those of the line of the same kind before. `meshes/pack.awk`
//! writes them, when the page is built: they compress to a third of what the OBJ files do.

/// Vertices by the name of their lines, and how many numbers they have; last those of moments.
const VERTICES: [(&str, usize); 3] = [("v ", 3), ("vt ", 2), (" ", 3)];

/// The kinds of lines with whole numbers.
const KINDS: [&str; 2] = ["f", "l"];

/// How a text begins that is not packed.
pub const PLAIN: &str = "# plain ";

/// The OBJ text that was packed. Lines that are none of ours are left as they are, for whoever reads the
/// text to refuse.
pub fn unpack(packed: &str) -> String {
    if packed.starts_with(PLAIN) {
        return packed.to_string();
    }
    let mut text = String::with_capacity(3 * packed.len());
    let mut before: [Vec<i32>; KINDS.len()] = Default::default();
    // Where the vertices are at the last moment.
    let mut last: Vec<i32> = Vec::new();
    for line in packed.lines() {
        let vertices = VERTICES.iter().find_map(|&(name, places)| {
            let numbers = numbers(line.strip_prefix(name)?)?;
            numbers.len().is_multiple_of(places).then_some((name, places, numbers))
        });
        if let Some((name, places, mut numbers)) = vertices {
            let rows = numbers.len() / places;
            for column in numbers.chunks_mut(rows.max(1)) {
                column.iter_mut().fold(0, |before: i32, number| {
                    *number = number.wrapping_add(before);
                    *number
                });
            }
            if name == " " {
                numbers.iter_mut().zip(&last).for_each(|(at, last)| *at = at.wrapping_add(*last));
            }
            for row in 0..rows {
                text.push_str(if name == " " { "#v" } else { name.trim_end() });
                for &number in numbers.iter().skip(row).step_by(rows) {
                    text.push(' ');
                    push_number(number, 100, &mut text);
                }
                text.push('\n');
            }
            if places == 3 {
                last = numbers;
            }
            continue;
        }
        let is_of =
            |name: &&str| line.strip_prefix(*name).is_some_and(|rest| rest.starts_with(' '));
        match KINDS.iter().position(is_of) {
            Some(kind) => unpack_line(line, &mut before[kind], &mut text),
            None => text.push_str(line),
        }
        text.push('\n');
    }
    text
}

/// The numbers that letters say; None where others are among them. A letter says how far a number is from 0 and on
/// which side; far ones take two, and the farthest are in digits, between `~` and a space.
fn numbers(letters: &str) -> Option<Vec<i32>> {
    const SINGLES: i32 = 60;
    // `<` is left out.
    const LETTERS: i32 = 92;
    let value = |letter: u8| match letter {
        b'!'..=b';' => Some(i32::from(letter - b'!')),
        b'='..=b'}' => Some(i32::from(letter - b'!') - 1),
        _ => None,
    };
    let mut numbers = Vec::new();
    let mut rest = letters.bytes();
    while let Some(letter) = rest.next() {
        if letter == b'~' {
            let digits: Vec<u8> = rest.by_ref().take_while(|&digit| digit != b' ').collect();
            numbers.push(std::str::from_utf8(&digits).ok()?.parse().ok()?);
            continue;
        }
        let mut size = value(letter)?;
        if size >= SINGLES {
            size = SINGLES + (size - SINGLES) * LETTERS + value(rest.next()?)?;
        }
        numbers.push(if size % 2 == 0 { size / 2 } else { -(size + 1) / 2 });
    }
    Some(numbers)
}

/// Digits and signs are differences; all else stays.
fn unpack_line(line: &str, before: &mut Vec<i32>, text: &mut String) {
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
            push_number(before[place], 1, text);
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
        let packed =
            "# 1 2\nv 1#~99999 ^!#!\nf 1/1 2 3//4\nf 1/2 1 1//-1\ng leaf 7\nvt !!\n $\"#!!!\n";
        let text = "# 1 2\nv 0.08 999.99 0.01\nv 0.09 1000.29 0.01\nf 1/1 2 3//4\nf 2/3 3 4//3\ng leaf 7\nvt 0.00 \
                    0.00\n#v 0.06 1000.00 0.01\n#v 0.06 1000.30 0.01\n";
        assert_eq!(unpack(packed), text);
    }

    #[test]
    fn what_was_not_packed_is_left_to_be_refused() {
        let text = "v one two\nv 1.5 2 3\nv <\nv ^\nv !!!!\nvn 1 2\n<html>\n";
        assert_eq!(unpack(text), text);
    }
}
