//! Bodies that visitors bring: OBJ, PLY and GLB files as other programs write them, mended where it is certain
//! what is meant.
//!
//! The meshes of the catalogue do not come this way. They are right, and some of their parts touch and
//! are apart all the same.

use super::formats::{Format, format_of};
use super::{Body, Face, ObjError, PolygonMesh, SurfaceError};
use super::{cut, glb_reader, ply_reader, stitch};
use glam::DVec3;

/// A body from a file, and what was done to it.
#[derive(Clone, Debug)]
pub struct Brought {
    pub body: Body,
    /// The polygons that it is made of.
    pub mesh: PolygonMesh,
    /// Where in the file's coordinates the body's origin lies: zero, except for bodies that are farther
    /// from their origin than they are large, which f32 would round coarsely there.
    pub origin: DVec3,
    /// What a unit of the file is: 100 in GLB files, which are in metres, else 1.
    pub unit_cm: f64,
    /// Pairs of rim edges that became one.
    pub joined_edges: usize,
    /// Triangles of the patterned surface that have no area or stand twice.
    pub left_out_triangles: usize,
}

/// Why a file is not a body that cells can grow on.
#[derive(Clone, Debug, thiserror::Error, PartialEq)]
pub enum BroughtError {
    #[error("the file is packed with {0}: unpack it first")]
    Packed(&'static str),
    #[error("the file is text in UTF-16: save it as UTF-8")]
    Utf16,
    #[error("this is {0}: save the body as OBJ, PLY or GLB")]
    Other(&'static str),
    #[error(transparent)]
    Obj(#[from] ObjError),
    #[error("the PLY file: {0}")]
    Ply(String),
    #[error("the GLB file: {0}")]
    Glb(String),
    #[error(transparent)]
    Surface(#[from] SurfaceError),
    #[error("the body is {0:e} cm large: scale it to between {SMALLEST_CM} and {LARGEST_CM} cm")]
    Size(f64),
}

/// Sizes at which areas of triangles and their squares are far from the ends of f32, with room for
/// millions of triangles.
const SMALLEST_CM: f64 = 1e-4;
const LARGEST_CM: f64 = 1e6;

impl Brought {
    /// Reads an OBJ or PLY file in centimetres, or a GLB file in metres.
    ///
    /// Moments stay. Corners at exactly the same place, at all moments, that follow each other are one, faces that stand twice are
    /// taken once, rim edges are joined where exactly two have the same ends, and polygons that are not
    /// convex are cut along their inside. Of the parts without cells nothing is joined or left out.
    ///
    /// # Errors
    /// Another format, a file that is not well formed, a size (the longest side of the box around the
    /// body) outside of 0.0001 to 1,000,000 cm, or no patterned surface.
    pub fn read(bytes: &[u8]) -> Result<Brought, BroughtError> {
        let format = format_of(bytes)?;
        let unit_cm = if format == Format::Glb { glb_reader::UNIT_CM } else { 1.0 };
        let (places, mut mesh) = match format {
            Format::Obj(text) => PolygonMesh::parse_exactly(&text)?,
            Format::Ply => ply_reader::read(bytes).map_err(BroughtError::Ply)?,
            Format::Glb => glb_reader::read(bytes).map_err(BroughtError::Glb)?,
        };
        let origin = origin(&places, &mesh.faces)?;
        mesh.positions = places.iter().map(|&place| (place - origin).as_vec3()).collect();
        for moment in &mut mesh.moments {
            for place in &mut moment.positions {
                *place = (place.as_dvec3() - origin).as_vec3();
            }
        }

        let faces = std::mem::take(&mut mesh.faces);
        let (bare, patterned): (Vec<Face>, Vec<Face>) =
            faces.into_iter().partition(|face| mesh.bare_name(face.group as usize).is_some());
        let named = triangles(&patterned);
        let same = stitch::same_places(&places, &mesh.moments);
        mesh.faces = stitch::once(patterned, &same);
        let joined_edges = stitch::join_rims(&mut mesh, &same);
        mesh.faces.extend(bare);
        // As a file that is read has them.
        mesh.faces.sort_by_key(|face| face.group);
        cut::cut_hollow(&mut mesh);

        let body = Body::new(&mesh)?;
        let left_out_triangles = named.saturating_sub(body.surface.triangles.len());
        Ok(Brought { body, mesh, origin, unit_cm, joined_edges, left_out_triangles })
    }
}

/// Triangles into which faces are cut.
fn triangles(faces: &[Face]) -> usize {
    faces.iter().map(|face| face.vertices.len() - 2).sum()
}

/// Where the body's origin is laid, in whole centimetres.
fn origin(places: &[DVec3], faces: &[Face]) -> Result<DVec3, BroughtError> {
    let (mut least, mut most) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for &vertex in faces.iter().flat_map(|face| &face.vertices) {
        let place = places[vertex as usize];
        if !place.is_finite() {
            return Err(SurfaceError::NotFinite { vertex }.into());
        }
        (least, most) = (least.min(place), most.max(place));
    }
    let size_cm = (most - least).max_element();
    if size_cm > 0.0 && !(SMALLEST_CM..=LARGEST_CM).contains(&size_cm) {
        return Err(BroughtError::Size(size_cm));
    }
    let centre = least + (most - least) * 0.5;
    let is_far = centre.length() > (most - least).length();
    Ok(if is_far { centre.round() } else { DVec3::ZERO })
}

#[cfg(test)]
mod tests;
