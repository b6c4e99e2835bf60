//! Polygon meshes as they stand in Wavefront OBJ files: read and written.

use glam::{Vec2, Vec3};

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
    /// indices), `g`/`o`, `usemtl`; everything else is passed over.
    pub fn parse(_text: &str) -> Result<PolygonMesh, ObjError> {
        todo!()
    }

    /// The mesh as an OBJ text that `parse` reads back unchanged.
    pub fn to_obj(&self) -> String {
        todo!()
    }
}
