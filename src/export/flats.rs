//! Parts of a plant that can be laid flat, side by side.

use super::flat::{Sheet, lay_flat};
use super::specimen::Specimen;
use glam::{DVec2, Vec2};

/// Millimetres in a centimetre.
const MM: f64 = 10.0;

/// The parts of a plant that lie flat.
pub struct Flats {
    pub pieces: Vec<Flat>,
    /// The parts that are not there, and why.
    pub left_out: Vec<(u32, String)>,
    /// The mean over the pieces of how much they are stretched.
    pub stretch: f64,
}

/// A part in the plane, in millimetres: its place, y down, of each point of the tiling, by their numbers, NaN where
/// it is of another part, and its size.
pub struct Flat {
    pub part: u32,
    pub places: Vec<DVec2>,
    pub size: DVec2,
}

impl Flats {
    /// Lays flat what can be.
    ///
    /// # Errors
    /// In plain words, why nothing of it can be.
    pub fn new(specimen: &Specimen) -> Result<Flats, String> {
        let mut sheets = Flats { pieces: Vec::new(), left_out: Vec::new(), stretch: 0.0 };
        for part in 0..specimen.mesh.part_count() as u32 {
            match lay_flat(specimen.mesh, part) {
                Ok(sheet) => {
                    sheets.stretch += sheet.stretch;
                    sheets.pieces.push(Flat::new(specimen, part, &sheet));
                }
                Err(why) => sheets.left_out.push((part, why.to_string())),
            }
        }
        if sheets.pieces.is_empty() {
            return Err(format!("nothing of this plant can be laid flat: {}", sheets.why()));
        }
        sheets.stretch /= sheets.pieces.len() as f64;
        Ok(sheets)
    }

    /// How many lie flat and how much they are stretched, and what is left out, in a few words.
    pub fn told(&self) -> String {
        let (pieces, stretch) = (self.pieces.len(), 100.0 * self.stretch);
        let left_out = match self.left_out.len() {
            0 => String::new(),
            parts => format!(", without {parts} that cannot be laid flat ({})", self.why()),
        };
        let word = if pieces == 1 { "part" } else { "parts" };
        format!("{pieces} {word}, stretched by {stretch:.1} %{left_out}")
    }

    fn why(&self) -> String {
        let mut why: Vec<&str> = self.left_out.iter().map(|(_, why)| why.as_str()).collect();
        why.dedup();
        why.join("; ")
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
