//! The mosaic as OBJ with its materials beside it (Wavefront, Advanced Visualizer, appendices B1 and B5):
//! one material a type, for slicers and programs that want few colours.

use super::specimen::Specimen;
use crate::plants::srgb;
use crate::tissue::CellType;
use std::io::{self, Write};

/// Writes the geometry: an object for each part of the surface and for each bare material. `materials` is the
/// name of the file that `write_mtl` fills.
///
/// # Errors
/// What `out` says.
pub fn write_obj(specimen: &Specimen, materials: &str, out: &mut impl Write) -> io::Result<()> {
    let points = &specimen.tiling.points;
    writeln!(out, "# Clonal Mosaic {}\n# centimetres, y is up\nmtllib {materials}", specimen.link)?;
    let skin = points.iter().map(|point| (point.position, point.normal));
    let bare = specimen.bare.iter().flat_map(|bare| bare.positions.iter().zip(&bare.normals));
    let all = || skin.clone().chain(bare.clone().map(|(&position, &normal)| (position, normal)));
    for (position, _) in all() {
        writeln!(out, "v {} {} {}", position.x, position.y, position.z)?;
    }
    for (_, normal) in all() {
        writeln!(out, "vn {} {} {}", normal.x, normal.y, normal.z)?;
    }
    let facets = &specimen.tiling.facets;
    let place = |facet: u32| {
        let facet = &facets[facet as usize];
        (specimen.mesh.parts[facet.triangle as usize], specimen.kind(facet))
    };
    let mut order: Vec<u32> = (0..facets.len() as u32).collect();
    order.sort_by_key(|&facet| place(facet));
    let mut last = None;
    for facet in order {
        let (part, kind) = place(facet);
        if last.is_none_or(|(other, _)| other != part) {
            writeln!(out, "o part_{part}")?;
        }
        if last != Some((part, kind)) {
            writeln!(out, "usemtl {}", kind.letter())?;
        }
        last = Some((part, kind));
        face(out, facets[facet as usize].corners, 0)?;
    }
    let mut first = points.len() as u32;
    for bare in &specimen.bare {
        writeln!(out, "o {}\nusemtl {}", bare.material, bare.material)?;
        for &corners in &bare.triangles {
            face(out, corners, first)?;
        }
        first += bare.positions.len() as u32;
    }
    Ok(())
}

/// Writes the materials: `F`, `B` and `M`, and the bare ones by their names. Colours are sRGB numbers, as
/// slicers and most viewers take them.
///
/// # Errors
/// What `out` says.
pub fn write_mtl(specimen: &Specimen, out: &mut impl Write) -> io::Result<()> {
    let types =
        CellType::ALL.map(|kind| (kind.letter().to_string(), specimen.type_colours[kind as usize]));
    let bare = specimen.bare.iter().map(|bare| (bare.material.clone(), srgb(bare.colour)));
    for (name, [red, green, blue]) in types.into_iter().chain(bare) {
        writeln!(out, "newmtl {name}\nKd {red:.4} {green:.4} {blue:.4}\nillum 1\n")?;
    }
    Ok(())
}

/// A triangle whose first point has the number `first` in the file, from 0.
fn face(out: &mut impl Write, corners: [u32; 3], first: u32) -> io::Result<()> {
    let [a, b, c] = corners.map(|corner| corner + first + 1);
    writeln!(out, "f {a}//{a} {b}//{b} {c}//{c}")
}
