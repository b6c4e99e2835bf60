//! The mosaic of parts that can be laid flat as SVG (W3C, Scalable Vector Graphics 1.1): one path for each type
//! on each part.

use super::flat::{Sheet, lay_flat};
use super::outlines::outlines;
use super::ply::bytes;
use super::specimen::Specimen;
use super::tiling::Facet;
use crate::plants::linear;
use crate::tissue::CellType;
use glam::{DVec2, Vec2};
use std::fmt::Write as _;
use std::io::{self, Write};

/// Millimetres in a centimetre, and between sheets.
const MM: f64 = 10.0;
const GAP_MM: f64 = 5.0;

/// The sheets of a plant, ready to be written.
pub struct Pattern {
    pieces: Vec<Flat>,
    /// The parts that are not there, and why.
    pub left_out: Vec<(u32, String)>,
    /// The mean over the sheets of how much they are stretched.
    pub stretch: f64,
}

/// A part in the plane, in millimetres: its place, y down, of each point, by their numbers, and its size.
struct Flat {
    part: u32,
    places: Vec<DVec2>,
    size: DVec2,
}

impl Pattern {
    /// Lays flat what can be.
    pub fn new(specimen: &Specimen) -> Pattern {
        let mut pattern = Pattern { pieces: Vec::new(), left_out: Vec::new(), stretch: 0.0 };
        for part in 0..specimen.mesh.part_count() as u32 {
            match lay_flat(specimen.mesh, part) {
                Ok(sheet) => {
                    pattern.stretch += sheet.stretch;
                    pattern.pieces.push(Flat::new(specimen, part, &sheet));
                }
                Err(why) => pattern.left_out.push((part, why.to_string())),
            }
        }
        pattern.stretch /= pattern.pieces.len().max(1) as f64;
        pattern
    }

    /// How many parts lie flat.
    pub fn count(&self) -> usize {
        self.pieces.len()
    }

    /// Writes the sheets in rows, true to scale.
    ///
    /// # Errors
    /// What `out` says.
    pub fn write(&self, specimen: &Specimen, out: &mut impl Write) -> io::Result<()> {
        let (corners, size) = self.rows();
        let link = specimen.link.replace('&', "&amp;").replace('<', "&lt;");
        writeln!(
            out,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.2}mm\" height=\"{1:.2}mm\" \
             viewBox=\"0 0 {0:.2} {1:.2}\">\n<desc>Clonal Mosaic {link}</desc>",
            size.x, size.y
        )?;
        for (flat, corner) in self.pieces.iter().zip(corners) {
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
    fn rows(&self) -> (Vec<DVec2>, DVec2) {
        let area: f64 = self.pieces.iter().map(|flat| flat.size.x * flat.size.y).sum();
        let widest = self.pieces.iter().map(|flat| flat.size.x).fold(0.0, f64::max);
        let width = widest.max(1.3 * area.sqrt()) + 2.0 * GAP_MM;
        let (mut next, mut row) = (DVec2::splat(GAP_MM), 0.0f64);
        let mut corners = Vec::new();
        for flat in &self.pieces {
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
}

impl Flat {
    fn new(specimen: &Specimen, part: u32, sheet: &Sheet) -> Flat {
        let (mesh, tiling) = (specimen.mesh, &specimen.tiling);
        let mut places = vec![DVec2::NAN; tiling.points.len()];
        let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        for facet in &tiling.facets {
            if mesh.parts[facet.triangle as usize] != part {
                continue;
            }
            let [a, b, c] = mesh.triangles[facet.triangle as usize].map(|v| v as usize);
            for point in facet.corners.map(|point| point as usize) {
                if !places[point].is_nan() {
                    continue;
                }
                let place = if point < mesh.positions.len() {
                    sheet.places[point]
                } else {
                    let arm = tiling.points[point].position - mesh.positions[a];
                    let [x, y] = mesh.axes(facet.triangle);
                    let plane = Vec2::new(arm.dot(x), arm.dot(y));
                    let share = mesh.frames[facet.triangle as usize].barycentric(plane).as_dvec2();
                    let [a, b, c] = [a, b, c].map(|v| sheet.places[v]);
                    a + (b - a) * share.x + (c - a) * share.y
                };
                // y is down in SVG.
                places[point] = DVec2::new(place.x, -place.y) * MM;
                low = low.min(places[point]);
                high = high.max(places[point]);
            }
        }
        for place in &mut places {
            *place -= low;
        }
        Flat { part, places, size: high - low }
    }
}
