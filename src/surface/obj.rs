//! Polygon meshes as they stand in Wavefront OBJ files: read and written.

use super::Moment;
use super::obj_reader::read;
use glam::{DVec3, Vec2, Vec3};
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
    /// Veins.
    pub lines: Vec<Line>,
    /// Where the vertices are on some days, if they move.
    pub moments: Vec<Moment>,
}

/// One polygon: its corners counter-clockwise seen from outside (or from above, on a leaf).
#[derive(Clone, Debug, PartialEq)]
pub struct Face {
    pub vertices: Vec<u32>,
    /// Index into `PolygonMesh::groups`.
    pub group: u32,
}

/// A vein as a line from vertex to vertex, which no face needs to have.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Line {
    pub vertices: Vec<u32>,
    /// That of the vein: 2 under the material `vein:2`.
    pub order: u32,
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
#[derive(Clone, Debug, thiserror::Error, PartialEq, Eq)]
pub enum ObjError {
    #[error("line {line} of the OBJ file: {what}")]
    Line { line: usize, what: String },
    #[error("the OBJ file has no faces")]
    NoFaces,
}

impl PolygonMesh {
    /// Reads an OBJ text: `v`, `vt`, `f` or its old name `fo` (any polygon, `v`, `v/vt`, `v//vn`,
    /// `v/vt/vn`, negative indices), `g`/`o`, `usemtl`, `l` under a material `vein:ORDER`, numbers that a
    /// backslash continues on the next line; everything else is passed over (normals, vertex colours, the
    /// weight `w`, other lines, smoothing groups, faces of fewer than three corners). For other programs the moments
    /// of a mesh are comments: after `#moment DAY` follow the vertices of that day in their order, each as
    /// `#v x y z`; without any, the vertices are those of the mesh itself.
    ///
    /// Positions are rounded to f32 and may be infinite or NaN. Texture coordinates are kept if no
    /// position has two of them; a position without any has `(0, 0)` then. Those that are no finite
    /// numbers or not there count as none.
    ///
    /// # Errors
    /// The first line that is not well formed, or a text without faces.
    pub fn parse(text: &str) -> Result<PolygonMesh, ObjError> {
        let (positions, mesh) = read(text)?;
        Ok(PolygonMesh { positions: positions.iter().map(|p| p.as_vec3()).collect(), ..mesh })
    }

    /// What a group is made of if it carries no cells.
    pub(super) fn bare_name(&self, group: usize) -> Option<&str> {
        self.groups.get(group)?.material.strip_prefix("bare:")
    }

    /// As `parse`, with the positions apart and as exact as they stand in the text.
    pub(super) fn parse_exactly(text: &str) -> Result<(Vec<DVec3>, PolygonMesh), ObjError> {
        read(text)
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
        for lines in self.lines.chunk_by(|a, b| a.order == b.order) {
            let _ = writeln!(text, "usemtl vein:{}", lines[0].order);
            for line in lines {
                text.push('l');
                for &v in &line.vertices {
                    let _ = write!(text, " {}", v + 1);
                }
                text.push('\n');
            }
        }
        for Moment { day, positions } in &self.moments {
            let _ = writeln!(text, "#moment {day}");
            for p in positions.iter().filter(|_| *positions != self.positions) {
                let _ = writeln!(text, "#v {} {} {}", p.x, p.y, p.z);
            }
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read_back_unchanged() {
        let parse = |text: &str| PolygonMesh::parse(text).unwrap();
        let mesh = parse(
            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.1 -2.5e-7 3e5\nvt 0 0\nvt -1 0.3\nvt 1 0.3\ng a\nusemtl x\nf 1/1 2/2 3/3\n\
             usemtl bare:y\nf 4 5 1\nusemtl x\nf 3/3 4/1 1/1 2/2\nusemtl vein:1\nl 1 2 3\nl 5 4\nusemtl vein:12\nl 2 5\n\
             #moment 0\n#v 0 0 1\n#v 1 0 1\n#v 1 1 1\n#v 0 1 1\n#v 0 0 0.5\n#moment 2.5\n",
        );
        assert_eq!((mesh.uvs.len(), mesh.lines.len()), (5, 3));
        assert_eq!(mesh.moments.iter().map(|moment| moment.day).collect::<Vec<_>>(), [0.0, 2.5]);
        assert_eq!(mesh.moments[0].positions[4], Vec3::new(0.0, 0.0, 0.5));
        assert_eq!(mesh.moments[1].positions, mesh.positions);
        assert_eq!(parse(&mesh.to_obj()), mesh);
    }
}
