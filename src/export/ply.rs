//! The mosaic as PLY, the Stanford polygon format (G. Turk, The PLY Polygon File Format, 1994): binary,
//! little-endian, with a colour at each corner.

use super::specimen::Specimen;
use crate::plants::srgb;
use glam::Vec3;
use std::io::{self, Write};

/// Writes corners with place (cm), unit normal and sRGB colour, and triangles: first those of the mosaic, then
/// those of the bare parts.
///
/// # Errors
/// What `out` says.
pub fn write_ply(specimen: &Specimen, out: &mut impl Write) -> io::Result<()> {
    let mosaic = specimen.coloured();
    let bare: usize = specimen.bare.iter().map(|bare| bare.positions.len()).sum();
    write!(
        out,
        "ply\nformat binary_little_endian 1.0\ncomment Clonal Mosaic {}\ncomment centimetres, y is up\n\
         element vertex {}\nproperty float x\nproperty float y\nproperty float z\n\
         property float nx\nproperty float ny\nproperty float nz\n\
         property uchar red\nproperty uchar green\nproperty uchar blue\n\
         element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
        specimen.link,
        mosaic.corners.len() + bare,
        specimen.triangle_count()
    )?;
    for &(point, colour) in &mosaic.corners {
        let point = specimen.tiling.points[point as usize];
        vertex(out, point.position, point.normal, colour)?;
    }
    for bare in &specimen.bare {
        for (&position, &normal) in bare.positions.iter().zip(&bare.normals) {
            vertex(out, position, normal, bare.colour)?;
        }
    }
    let mut first = 0;
    let bare = specimen.bare.iter().map(|bare| (&bare.triangles, bare.positions.len()));
    for (triangles, vertices) in
        std::iter::once((&mosaic.triangles, mosaic.corners.len())).chain(bare)
    {
        for triangle in triangles {
            out.write_all(&[3])?;
            for corner in triangle {
                out.write_all(&(first + corner).to_le_bytes())?;
            }
        }
        first += vertices as u32;
    }
    Ok(())
}

fn vertex(out: &mut impl Write, position: Vec3, normal: Vec3, colour: Vec3) -> io::Result<()> {
    for x in position.to_array().into_iter().chain(normal.to_array()) {
        out.write_all(&x.to_le_bytes())?;
    }
    out.write_all(&bytes(colour))
}

/// A colour in linear light as sRGB bytes.
pub(super) fn bytes(linear: Vec3) -> [u8; 3] {
    srgb(linear).map(|c| (c * 255.0 + 0.5) as u8)
}
