//! The mosaic of parts that can be laid flat as SVG (W3C, Scalable Vector Graphics 1.1): one path for each type
//! on each part.

use super::flats::Flats;
use super::outlines::outlines;
use super::ply::bytes;
use super::specimen::Specimen;
use super::tiling::Facet;
use crate::plants::linear;
use crate::tissue::CellType;
use glam::DVec2;
use std::fmt::Write as _;
use std::io::{self, Write};

/// Millimetres between sheets.
const GAP_MM: f64 = 5.0;

/// Writes the sheets in rows, true to scale.
///
/// # Errors
/// What `out` says.
pub fn write_svg(specimen: &Specimen, sheets: &Flats, out: &mut impl Write) -> io::Result<()> {
    let (corners, size) = rows(sheets);
    let link = specimen.link.replace('&', "&amp;").replace('<', "&lt;");
    writeln!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.2}mm\" height=\"{1:.2}mm\" \
         viewBox=\"0 0 {0:.2} {1:.2}\">\n<desc>Clonal Mosaic {link}</desc>",
        size.x, size.y
    )?;
    for (flat, corner) in sheets.pieces.iter().zip(corners) {
        writeln!(out, "<g id=\"part_{}\">", flat.part)?;
        for kind in CellType::ALL {
            let of_kind = |facet: &&Facet| {
                let part = specimen.mesh.parts[facet.triangle as usize];
                part == flat.part && specimen.kind(facet) == kind
            };
            let facets = specimen.tiling.facets.iter().filter(of_kind);
            let mut path = String::new();
            for outline in outlines(facets.map(|facet| facet.corners)) {
                for (k, &point) in outline.iter().enumerate() {
                    let DVec2 { x, y } = flat.places[point as usize] + corner;
                    let _ = write!(path, "{}{x:.3} {y:.3}", if k == 0 { 'M' } else { 'L' });
                }
                path.push('Z');
            }
            if !path.is_empty() {
                let [r, g, b] = bytes(linear(specimen.type_colours[kind as usize]));
                writeln!(
                    out,
                    "<path id=\"part_{}_{}\" fill=\"#{r:02x}{g:02x}{b:02x}\" \
                     fill-rule=\"evenodd\" d=\"{path}\"/>",
                    flat.part,
                    kind.letter()
                )?;
            }
        }
        writeln!(out, "</g>")?;
    }
    writeln!(out, "</svg>")
}

/// Where each sheet has its upper left corner, and the size of it all.
fn rows(sheets: &Flats) -> (Vec<DVec2>, DVec2) {
    let area: f64 = sheets.pieces.iter().map(|flat| flat.size.x * flat.size.y).sum();
    let widest = sheets.pieces.iter().map(|flat| flat.size.x).fold(0.0, f64::max);
    let width = widest.max(1.3 * area.sqrt()) + 2.0 * GAP_MM;
    let (mut next, mut row) = (DVec2::splat(GAP_MM), 0.0f64);
    let mut corners = Vec::new();
    for flat in &sheets.pieces {
        if next.x > GAP_MM && next.x + flat.size.x + GAP_MM > width {
            next = DVec2::new(GAP_MM, next.y + row + GAP_MM);
            row = 0.0;
        }
        corners.push(next);
        next.x += flat.size.x + GAP_MM;
        row = row.max(flat.size.y);
    }
    (corners, DVec2::new(width, next.y + row + GAP_MM))
}
