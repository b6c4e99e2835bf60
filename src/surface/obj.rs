//! Polygon meshes as they stand in Wavefront OBJ files: read and written.

use glam::{Vec2, Vec3};
use std::collections::HashMap;
use std::fmt::Write;

/// Polygons of any number of corners, with the names of the parts that they belong to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PolygonMesh {
    /// Vertex positions, in centimetres for our own plants.
    pub positions: Vec<Vec3>,
    /// One texture coordinate per position, or none at all. On a leaf: `x` from -1 (left rim) over
    /// 0 (midrib) to 1 (right rim), `y` from 0 (petiole) to 1 (tip).
    pub uvs: Vec<Vec2>,
    pub faces: Vec<Face>,
    pub groups: Vec<Group>,
}

/// One polygon: its corners counter-clockwise seen from outside (or from above, on a leaf).
#[derive(Clone, Debug, PartialEq)]
pub struct Face {
    pub vertices: Vec<u32>,
    /// Index into `PolygonMesh::groups`.
    pub group: u16,
}

/// A run of faces under one `g` name and one `usemtl` name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Group {
    pub part: String,
    /// `bare:NAME` marks a part that carries no cells (petiole, spines, soil) and names what it is
    /// made of; every other material, or none, is patterned.
    pub material: String,
}

/// Why a text is not a mesh that we can use.
#[derive(Debug, thiserror::Error, PartialEq, Eq)]
pub enum ObjError {
    #[error("line {line} of the OBJ file: {what}")]
    Line { line: usize, what: String },
    #[error("the OBJ file has no faces")]
    NoFaces,
}

impl PolygonMesh {
    /// Reads an OBJ text: `v`, `vt`, `f` (any polygon, `v`, `v/vt`, `v//vn`, `v/vt/vn`, negative
    /// indices), `g`/`o`, `usemtl`, lines continued by a backslash; everything else is passed over
    /// (normals, vertex colours, the weight `w`, lines, smoothing groups).
    ///
    /// Texture coordinates are kept if no position has two of them; a position without any has
    /// `(0, 0)` then.
    ///
    /// # Errors
    /// The first line that is not well formed, or a text without faces.
    pub fn parse(text: &str) -> Result<PolygonMesh, ObjError> {
        let mut reader = Reader::default();
        let mut statement = String::new();
        let mut first_line = 1;
        for (index, line) in text.trim_start_matches('\u{feff}').lines().enumerate() {
            if statement.is_empty() {
                first_line = index + 1;
            }
            match line.trim_end().strip_suffix('\\') {
                Some(continued) => {
                    statement.push_str(continued);
                    statement.push(' ');
                }
                None => {
                    statement.push_str(line);
                    let read = reader.read(without_comment(&statement), first_line);
                    read.map_err(|what| ObjError::Line { line: first_line, what })?;
                    statement.clear();
                }
            }
        }
        let read = reader.read(without_comment(&statement), first_line);
        read.map_err(|what| ObjError::Line { line: first_line, what })?;
        reader.finish()
    }

    /// The mesh as an OBJ text that `parse` reads back unchanged, given that the groups stand in
    /// the order in which the faces use them. Numbers are written with the digits that they need,
    /// equal texture coordinates once.
    pub fn to_obj(&self) -> String {
        let mut text = String::new();
        for p in &self.positions {
            // `{}` prints the shortest decimal that reads back as the same f32.
            let _ = writeln!(text, "v {} {} {}", p.x, p.y, p.z);
        }
        let mut numbers = HashMap::new();
        let mut uv_number = Vec::with_capacity(self.uvs.len());
        for uv in &self.uvs {
            let next = numbers.len() + 1;
            let number = *numbers.entry((uv.x.to_bits(), uv.y.to_bits())).or_insert(next);
            if number == next {
                let _ = writeln!(text, "vt {} {}", uv.x, uv.y);
            }
            uv_number.push(number);
        }
        let unnamed = Group { part: String::new(), material: String::new() };
        let mut current = &unnamed;
        for face in &self.faces {
            let group = self.groups.get(face.group as usize).unwrap_or(&unnamed);
            if group.part != current.part {
                let _ = writeln!(text, "{}", format!("g {}", group.part).trim_end());
            }
            if group.material != current.material {
                let _ = writeln!(text, "{}", format!("usemtl {}", group.material).trim_end());
            }
            current = group;
            text.push('f');
            // What is not said is (0, 0): bare parts need no texture coordinates.
            let has_uv = face
                .vertices
                .iter()
                .any(|&v| self.uvs.get(v as usize).is_some_and(|&uv| uv != Vec2::ZERO));
            for &v in &face.vertices {
                let _ = if has_uv {
                    write!(text, " {}/{}", v + 1, uv_number[v as usize])
                } else {
                    write!(text, " {}", v + 1)
                };
            }
            text.push('\n');
        }
        text
    }
}

/// What has been read so far.
#[derive(Default)]
struct Reader {
    mesh: PolygonMesh,
    uvs: Vec<Vec2>,
    /// Position and texture coordinate of every corner that names both.
    corner_uvs: Vec<(u32, u32)>,
    part: String,
    material: String,
    group_numbers: HashMap<(String, String), u16>,
    /// The largest position and texture coordinate that a face has named, and its line: a face may
    /// stand before its vertices.
    farthest: [(u32, usize); 2],
}

impl Reader {
    fn read(&mut self, statement: &str, line: usize) -> Result<(), String> {
        let mut words = statement.split_whitespace();
        match words.next() {
            Some("v") => {
                let [x, y, z] =
                    [number(words.next())?, number(words.next())?, number(words.next())?];
                self.mesh.positions.push(Vec3::new(x, y, z));
            }
            Some("vt") => {
                let x = number(words.next())?;
                let y = words.next().map_or(Ok(0.0), |word| number(Some(word)))?;
                self.uvs.push(Vec2::new(x, y));
            }
            Some("f") => self.read_face(words, line)?,
            Some("g" | "o") => self.part = words.collect::<Vec<_>>().join(" "),
            Some("usemtl") => self.material = words.collect::<Vec<_>>().join(" "),
            _ => {}
        }
        Ok(())
    }

    fn read_face<'a>(
        &mut self,
        words: impl Iterator<Item = &'a str>,
        line: usize,
    ) -> Result<(), String> {
        let mut vertices = Vec::with_capacity(4);
        for word in words {
            let mut indices = word.split('/');
            let vertex = index(indices.next(), self.mesh.positions.len(), "vertex", word)?;
            self.farthest[0] = self.farthest[0].max((vertex, line));
            if let Some(text) = indices.next().filter(|text| !text.is_empty()) {
                let uv = index(Some(text), self.uvs.len(), "texture coordinate", word)?;
                self.farthest[1] = self.farthest[1].max((uv, line));
                self.corner_uvs.push((vertex, uv));
            }
            vertices.push(vertex);
        }
        if vertices.len() < 3 {
            return Err(format!(
                "a face needs at least 3 corners, this one has {}",
                vertices.len()
            ));
        }
        let group = self.group()?;
        self.mesh.faces.push(Face { vertices, group });
        Ok(())
    }

    /// The number of the group under the present names.
    fn group(&mut self) -> Result<u16, String> {
        let names = (self.part.clone(), self.material.clone());
        if let Some(&number) = self.group_numbers.get(&names) {
            return Ok(number);
        }
        let number = u16::try_from(self.mesh.groups.len())
            .map_err(|_| "more than 65,536 groups and materials".to_string())?;
        let (part, material) = names.clone();
        self.mesh.groups.push(Group { part, material });
        self.group_numbers.insert(names, number);
        Ok(number)
    }

    fn finish(self) -> Result<PolygonMesh, ObjError> {
        let Reader { mut mesh, uvs, corner_uvs, farthest, .. } = self;
        if mesh.faces.is_empty() {
            return Err(ObjError::NoFaces);
        }
        let counts = [(mesh.positions.len(), "vertex"), (uvs.len(), "texture coordinate")];
        for ((largest, line), (count, kind)) in farthest.into_iter().zip(counts) {
            // Line 0: no face has named any.
            if line > 0 && largest as usize >= count {
                let what = format!("{kind} {} is named, but there are {count}", largest + 1);
                return Err(ObjError::Line { line, what });
            }
        }
        mesh.uvs = uvs_of_positions(mesh.positions.len(), &uvs, &corner_uvs).unwrap_or_default();
        Ok(mesh)
    }
}

/// One texture coordinate per position; none if no corner has any, or if two corners disagree.
fn uvs_of_positions(count: usize, uvs: &[Vec2], corners: &[(u32, u32)]) -> Option<Vec<Vec2>> {
    let mut found = vec![None; count];
    for &(position, uv) in corners {
        let uv = uvs[uv as usize];
        if *found[position as usize].get_or_insert(uv) != uv {
            return None;
        }
    }
    let any = !corners.is_empty();
    any.then(|| found.into_iter().map(|uv| uv.unwrap_or(Vec2::ZERO)).collect())
}

/// A comment starts at a `#` that starts a word: names may hold one inside.
fn without_comment(statement: &str) -> &str {
    let starts_word = |&(at, _): &(usize, &str)| {
        statement[..at].chars().next_back().is_none_or(char::is_whitespace)
    };
    let comment = statement.match_indices('#').find(starts_word);
    comment.map_or(statement, |(at, _)| &statement[..at])
}

fn number(word: Option<&str>) -> Result<f32, String> {
    let word = word.ok_or("a number is missing")?;
    match word.parse::<f32>() {
        Ok(number) if number.is_finite() => Ok(number),
        _ => Err(format!("\"{word}\" is not a number")),
    }
}

/// An index of a face, from 1 or, if negative, from the last that was read; returned from 0.
fn index(text: Option<&str>, count: usize, kind: &str, word: &str) -> Result<u32, String> {
    let text = text.unwrap_or_default();
    let number: i64 = text.parse().map_err(|_| format!("\"{word}\" is not a corner of a face"))?;
    let index = if number > 0 { number - 1 } else { number + count as i64 };
    match u32::try_from(index) {
        Ok(index) if number != 0 && index < u32::MAX => Ok(index),
        _ => Err(format!("there is no {kind} {number}: {count} have been read so far")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
        for face in
            ["f 1//1 2//1 3//1 4//1", "f -4 -3 -2 -1", "f\t1  2 3 \\\n 4", "f 1 2 3 4 # quad"]
        {
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
    fn what_is_written_is_read_back_unchanged() {
        let mesh = parse(&format!(
            "{CORNERS}v 0.1 -2.5e-7 3e5\nvt 0 0\nvt -1 0.3\nvt 1 0.3\ng a\nusemtl x\nf 1/1 2/2 3/3\n\
             usemtl bare:y\nf 4 5 1\nusemtl x\nf 3/3 4/1 1/1 2/2\n"
        ));
        assert_eq!(mesh.uvs.len(), 5);
        assert_eq!(parse(&mesh.to_obj()), mesh);
    }

    #[test]
    fn texture_coordinates_with_a_seam_are_dropped() {
        let mesh = parse(&format!("{CORNERS}vt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf 1/2 3/2 4/2"));
        assert!(mesh.uvs.is_empty());
    }

    #[test]
    fn errors_name_the_line() {
        assert_eq!(error("v 0 0\nf 1 1 1"), "line 1 of the OBJ file: a number is missing");
        assert_eq!(error("\nv 0 x 0"), "line 2 of the OBJ file: \"x\" is not a number");
        assert_eq!(error("v 0 nan 0"), "line 1 of the OBJ file: \"nan\" is not a number");
        assert_eq!(
            error("v 0 \\\n 0 \\\n 1e99"),
            "line 1 of the OBJ file: \"1e99\" is not a number"
        );
        let line_5 = |face: &str| error(&format!("{CORNERS}{face}"));
        let head = "line 5 of the OBJ file: ";
        assert_eq!(line_5("f 1 2 9"), format!("{head}vertex 9 is named, but there are 4"));
        assert_eq!(
            line_5("f 1 2 0"),
            format!("{head}there is no vertex 0: 4 have been read so far")
        );
        assert_eq!(
            line_5("f 1 2 -5"),
            format!("{head}there is no vertex -5: 4 have been read so far")
        );
        assert_eq!(
            line_5("f 1 2"),
            format!("{head}a face needs at least 3 corners, this one has 2")
        );
        assert_eq!(line_5("f 1 2 b"), format!("{head}\"b\" is not a corner of a face"));
        let no_uv = format!("{head}texture coordinate 1 is named, but there are 0");
        assert_eq!(line_5("f 1/1 2/1 3/1"), no_uv);
        assert_eq!(error(CORNERS), "the OBJ file has no faces");
        assert_eq!(error(""), "the OBJ file has no faces");
    }
}
