//! OBJ text, statement by statement.

use super::{Face, Group, Line, Moment, ObjError, PolygonMesh, Shortest, decimal, holds, quoted};
use glam::{DVec3, Vec2, Vec3};
use std::collections::HashMap;

/// The positions of a text, and a mesh without them: what `PolygonMesh::parse` says.
pub(super) fn read(text: &str) -> Result<(Vec<DVec3>, PolygonMesh), ObjError> {
    let mut reader = Reader::default();
    let mut statement = String::new();
    let mut first_line = 1;
    // Lines end in \n, \r\n or, from old programs, \r.
    let lines = text
        .trim_start_matches('\u{feff}')
        .split('\n')
        .flat_map(|line| line.strip_suffix('\r').unwrap_or(line).split('\r'));
    for (index, line) in lines.enumerate() {
        if statement.is_empty() {
            first_line = index + 1;
        }
        let start = statement.len();
        statement.push_str(line);
        // Names and comments may end in a backslash, and names may hold a `#`.
        if takes_numbers(&statement) {
            // Some programs write `1.#QNAN` for numbers that are none.
            let comment = (start..statement.len())
                .find(|&at| statement.as_bytes()[at] == b'#' && !statement[..at].ends_with("1."));
            statement.truncate(comment.unwrap_or(statement.len()));
            if let Some(continued) = statement.trim_end().strip_suffix('\\') {
                statement.truncate(continued.len());
                statement.push(' ');
                continue;
            }
        }
        reader.read(&statement, first_line)?;
        statement.clear();
    }
    reader.read(&statement, first_line)?;
    reader.finish()
}

/// What has been read so far.
#[derive(Default)]
struct Reader {
    positions: Vec<DVec3>,
    mesh: PolygonMesh,
    uvs: Vec<Vec2>,
    /// Position and texture coordinate of every corner that names both.
    corner_uvs: Vec<(u32, u32)>,
    part: String,
    material: String,
    group_numbers: HashMap<(String, String), u32>,
    /// The largest position that a face has named, and its line: a face may stand before its vertices.
    farthest: (u32, usize),
    /// The line of the last moment.
    last_moment: usize,
}

impl Reader {
    fn read(&mut self, statement: &str, line: usize) -> Result<(), ObjError> {
        let read = self.read_words(statement, line);
        read.map_err(|what| ObjError::Line { line, what })
    }

    fn read_words(&mut self, statement: &str, line: usize) -> Result<(), String> {
        let mut words = statement.split_whitespace();
        match words.next() {
            Some("v") => {
                let mut next = || number(words.next());
                self.positions.push(DVec3::new(next()?, next()?, next()?));
            }
            Some("vt") => {
                let value = |word: &str| decimal(word).map_or(f32::NAN, |number| number as f32);
                let x = words.next().map_or(f32::NAN, value);
                self.uvs.push(Vec2::new(x, words.next().map_or(0.0, value)));
            }
            Some("f" | "fo") => self.read_face(words, line)?,
            Some("l") => self.read_vein(words, line)?,
            Some("g" | "o") => self.part = name(statement),
            Some("usemtl") => self.material = name(statement),
            // Other programs' comments may begin alike.
            Some("#moment") => {
                if let Some(day) = words.next().and_then(decimal) {
                    self.mesh.moments.push(Moment { day: day as f32, positions: Vec::new() });
                    self.last_moment = line;
                }
            }
            // Without a moment it is a comment like any other.
            Some("#v") => {
                if let Some(moment) = self.mesh.moments.last_mut() {
                    let mut next = || number(words.next()).map(|number| number as f32);
                    moment.positions.push(Vec3::new(next()?, next()?, next()?));
                }
            }
            _ => {}
        }
        Ok(())
    }

    fn read_face<'a>(
        &mut self,
        words: impl Iterator<Item = &'a str> + Clone,
        line: usize,
    ) -> Result<(), String> {
        if words.clone().nth(2).is_none() {
            return Ok(());
        }
        let mut vertices = Vec::with_capacity(4);
        for word in words {
            let mut indices = word.split('/');
            let vertex = index(indices.next(), self.positions.len(), word)?;
            self.farthest = self.farthest.max((vertex, line));
            let named = indices.next().filter(|text| !text.is_empty());
            if named.is_some()
                && let Ok(uv) = index(named, self.uvs.len(), word)
            {
                self.corner_uvs.push((vertex, uv));
            }
            vertices.push(vertex);
        }
        let group = self.group();
        self.mesh.faces.push(Face { vertices, group });
        Ok(())
    }

    /// Lines of other materials are none of ours.
    fn read_vein<'a>(
        &mut self,
        words: impl Iterator<Item = &'a str>,
        line: usize,
    ) -> Result<(), String> {
        let order = self.material.strip_prefix("vein:").and_then(|order| order.parse().ok());
        let Some(order) = order else { return Ok(()) };
        let mut vertices = Vec::new();
        for word in words {
            let vertex = index(word.split('/').next(), self.positions.len(), word)?;
            self.farthest = self.farthest.max((vertex, line));
            vertices.push(vertex);
        }
        self.mesh.lines.push(Line { vertices, order });
        Ok(())
    }

    /// The number of the group under the present names.
    fn group(&mut self) -> u32 {
        let names = (self.part.clone(), self.material.clone());
        let groups = &mut self.mesh.groups;
        *self.group_numbers.entry(names).or_insert_with_key(|(part, material)| {
            groups.push(Group { part: part.clone(), material: material.clone() });
            groups.len() as u32 - 1
        })
    }

    fn finish(self) -> Result<(Vec<DVec3>, PolygonMesh), ObjError> {
        let Reader { positions, mut mesh, uvs, corner_uvs, farthest, last_moment, .. } = self;
        let (largest, line) = farthest;
        if mesh.faces.is_empty() {
            return Err(ObjError::NoFaces);
        }
        let count = positions.len();
        if largest as usize >= count {
            let what = format!("vertex {} is named, but there are {count}", largest + 1);
            return Err(ObjError::Line { line, what });
        }
        mesh.uvs = uvs_of_positions(count, &uvs, &corner_uvs).unwrap_or_default();
        for Moment { day, positions: then } in &mut mesh.moments {
            if then.is_empty() {
                *then = positions.iter().map(|p| p.as_vec3()).collect();
            }
            if then.len() != count {
                let (line, then, day) = (last_moment, then.len(), day.shortest());
                let what = format!("there are {count} vertices, but {then} on day {day}");
                return Err(ObjError::Line { line, what });
            }
        }
        Ok((positions, mesh))
    }
}

/// One texture coordinate per position; none if no corner has any, or if two corners disagree.
fn uvs_of_positions(count: usize, uvs: &[Vec2], corners: &[(u32, u32)]) -> Option<Vec<Vec2>> {
    let mut found = vec![None; count];
    let mut any = false;
    for &(position, uv) in corners {
        let Some(&uv) = uvs.get(uv as usize).filter(|uv| uv.is_finite()) else { continue };
        any = true;
        if *found[position as usize].get_or_insert(uv) != uv {
            return None;
        }
    }
    any.then(|| found.into_iter().map(|uv| uv.unwrap_or(Vec2::ZERO)).collect())
}

/// Whether numbers stand in a statement, and no names.
fn takes_numbers(statement: &str) -> bool {
    let keyword = statement.split_whitespace().next().unwrap_or_default();
    matches!(keyword.trim_end_matches('\\'), "v" | "vt" | "f" | "fo" | "l")
}

/// The words after the first, without a comment. It starts at a `#` that starts a word: names may hold
/// one inside.
pub(super) fn name(statement: &str) -> String {
    let words = statement.split_whitespace().skip(1).take_while(|word| !word.starts_with('#'));
    words.collect::<Vec<_>>().join(" ")
}

/// Whatever programs write for numbers that are none (`-nan(ind)`) is NaN.
pub(super) fn number(word: Option<&str>) -> Result<f64, String> {
    let word = word.ok_or("a number is missing")?;
    let not_one = word.trim_start_matches(['-', '+']).starts_with("nan") || holds(word, ".#");
    decimal(if not_one { "nan" } else { word }).ok_or_else(|| {
        let comma = if word.contains(',') { ": decimals need a point" } else { "" };
        format!("{} is not a number{comma}", quoted(word))
    })
}

/// An index of a face, from 1 or, if negative, from the last that was read; returned from 0.
fn index(text: Option<&str>, count: usize, word: &str) -> Result<u32, String> {
    let number = text.and_then(|text| text.parse::<i64>().ok());
    let number = number.ok_or_else(|| format!("{} is not a corner of a face", quoted(word)))?;
    let index = if number > 0 { number - 1 } else { number.saturating_add(count as i64) };
    match u32::try_from(index) {
        Ok(index) if number != 0 && index < u32::MAX => Ok(index),
        _ => Err(format!("there is no vertex {number}: {count} have been read so far")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    fn parse(text: &str) -> PolygonMesh {
        PolygonMesh::parse(text).unwrap()
    }

    fn error(text: &str) -> String {
        PolygonMesh::parse(text).unwrap_err().to_string()
    }

    const CORNERS: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

    #[test]
    fn every_form_of_a_face_is_read() {
        let uvs = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n";
        let plain = parse(&format!("{CORNERS}f 1 2 3 4"));
        for face in [
            "f 1//1 2//1 3//1 4//1",
            "f 1// 2// 3// 4//",
            "f 1/ 2/ 3/ 4/",
            "f -4 -3 -2 -1",
            "f\t1  2 3 \\\n 4",
            "f\\\n1 2\\\r\n 3 4",
            "f 1 2 3 4 # quad",
            "f 1 2 3 4#quad",
            "fo 1 2 3 4",
            "f\nf 1 2\nf 1 2 3 4\nf 3\n",
        ] {
            assert_eq!(parse(&format!("{CORNERS}{uvs}{face}")), plain, "{face}");
        }
        assert_eq!(parse(&format!("{CORNERS}f 1 2 3 4").replace('\n', "\r\n")), plain);
        assert_eq!(parse(&format!("f 1 2 3 4\n{CORNERS}")), plain);
        for face in ["f 1/1 2/2 3/3 4/4", "f 1/1/1 2/2/1 3/3/1 4/4/1", "f -4/-4 -3/-3 -2/-2 -1/-1"]
        {
            let mesh = parse(&format!("{CORNERS}{uvs}{face}"));
            assert_eq!(mesh.uvs, [Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y], "{face}");
            assert_eq!(mesh.faces, plain.faces);
        }
    }

    #[test]
    fn colours_and_weights_after_a_vertex_are_passed_over() {
        let mesh = parse("v 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 0 1e0 0\nl 1 2\ns off\nf 1 2 3\n");
        assert_eq!(mesh.positions, [Vec3::ZERO, Vec3::X, Vec3::Y]);
    }

    #[test]
    fn groups_and_materials_follow_the_faces() {
        let mesh = parse(&format!(
            "{CORNERS}f 1 2 3\no leaf one\nf 1 2 4\nusemtl bare:petiole#2\nf 1 3 4\ng\nusemtl\nf 2 3 4"
        ));
        let names: Vec<_> = mesh.groups.iter().map(|g| (&*g.part, &*g.material)).collect();
        assert_eq!(names, [("", ""), ("leaf one", ""), ("leaf one", "bare:petiole#2")]);
        assert_eq!(mesh.faces.iter().map(|f| f.group).collect::<Vec<_>>(), [0, 1, 2, 0]);
    }

    #[test]
    fn texture_coordinates_with_a_seam_are_dropped() {
        let mesh = parse(&format!("{CORNERS}vt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf 1/2 3/2 4/2"));
        assert!(mesh.uvs.is_empty());
    }

    #[test]
    fn texture_coordinates_that_are_none_or_not_there_are_passed_over() {
        let plain = parse(&format!("{CORNERS}f 1 2 3 4"));
        for uvs in [
            "vt nan nan",
            "vt 1e99 0",
            "vt x y",
            "vt",
            "vt -nan(ind) 0",
            "vt 1.#QNAN -1.#IND",
            "#",
            "vt 0 z",
        ] {
            let mesh = parse(&format!("{CORNERS}{uvs}\nf 1/1/1 2/2/2 3/-9/3 4/x/4"));
            assert_eq!(mesh, plain, "{uvs}");
        }
        let some = parse(&format!("{CORNERS}vt 1 1\nvt nan 0\nf 1/1 2/2 3/3 4/1"));
        assert_eq!(some.uvs, [Vec2::ONE, Vec2::ZERO, Vec2::ZERO, Vec2::ONE]);
    }

    #[test]
    fn lines_end_in_every_way_and_names_in_backslashes() {
        let text = format!("{CORNERS}f 1 2 3 4\n");
        let plain = parse(&text);
        for ends in ["\r", "\r\n", "\n\r\n", "\n\n", " \n", "\t\r\n"] {
            assert_eq!(parse(&text.replace('\n', ends)), plain, "{ends:?}");
        }
        assert_eq!(
            parse(&format!("\u{feff}# C:\\m\\\n{}", text.replace(" 0\n", " 0 # C:\\\n"))),
            plain
        );
        let named = parse(&text.replace("f 1", "g C:\\m\\\nusemtl a b\\\nmtllib c\\\nf 1"));
        assert_eq!(named.faces, plain.faces);
        assert_eq!((&*named.groups[0].part, &*named.groups[0].material), ("C:\\m\\", "a b\\"));
        assert_eq!(parse(&text.replace(" 4\n", " 4 \\\n# more\n")), plain, "a line that goes on");
        let third_line = "line 3 of the OBJ file: a number is missing";
        for ends in ["\r", "\r\n", "\n"] {
            assert_eq!(error(&["v 0 0 0", "# b", "v 1"].join(ends)), third_line, "{ends:?}");
        }
    }

    #[test]
    fn a_name_for_each_of_100_000_faces_is_read() {
        let faces: String = (0..100_000).map(|n| format!("g {n}\nf 1 2 3\n")).collect();
        let mesh = parse(&format!("{CORNERS}{faces}"));
        assert_eq!((mesh.faces.len(), mesh.groups.len()), (100_000, 100_000));
        assert_eq!(mesh.groups[mesh.faces[70_000].group as usize].part, "70000");
    }

    #[test]
    fn errors_name_the_line() {
        assert_eq!(error("v 0 0\nf 1 1 1"), "line 1 of the OBJ file: a number is missing");
        assert_eq!(error("\nv 0 x 0"), "line 2 of the OBJ file: \"x\" is not a number");
        assert_eq!(error("v 0 \\\n 0 \\\n 1x"), "line 1 of the OBJ file: \"1x\" is not a number");
        assert_eq!(
            error("v 1,5 2,5 0"),
            "line 1 of the OBJ file: \"1,5\" is not a number: decimals need a point"
        );
        assert_eq!(
            error("v 0 0 \x1b[31mred"),
            "line 1 of the OBJ file: \"\u{fffd}[31mred\" is not a number"
        );
        assert!(
            error(&format!("{CORNERS}f 1 2 {}", "3/".repeat(500_000) + "\nf x y z")).len() < 120
        );
        let line_5 = |face: &str| error(&format!("{CORNERS}{face}"));
        let head = "line 5 of the OBJ file: ";
        assert_eq!(line_5("f 1 2 9"), format!("{head}vertex 9 is named, but there are 4"));
        for wrong in [0, -5, i64::MIN, i64::MAX] {
            let none = format!("{head}there is no vertex {wrong}: 4 have been read so far");
            assert_eq!(line_5(&format!("f 1 2 {wrong}")), none);
        }
        assert_eq!(line_5("f 1 2 b"), format!("{head}\"b\" is not a corner of a face"));
        for nothing in [CORNERS, "", "f 1 2", "# f 1 2 3"] {
            assert_eq!(error(nothing), "the OBJ file has no faces");
        }
    }
}
