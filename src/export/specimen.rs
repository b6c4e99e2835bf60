//! A plant on one day as it is taken away: its mosaic as triangles, their colours, and its bare parts.

use super::tiling::{Facet, Tiling};
use crate::mosaic::{lightness, tints};
use crate::plants::{Look, linear};
use crate::surface::{Mesh, Ornament};
use crate::tissue::{CellType, Control, Diary};
use glam::Vec3;

pub struct Specimen<'a> {
    /// The link that shows it in the playground.
    pub link: String,
    pub mesh: &'a Mesh,
    pub tiling: Tiling,
    /// The type of each cell, and its colour in linear light.
    cells: Vec<(CellType, Vec3)>,
    /// The colour of a part without cells.
    of_nobody: Vec3,
    /// 0 matt to 1 waxy, of the patterned surface: the mean of its types.
    pub gloss: f32,
    /// By their names.
    pub bare: Vec<Bare>,
    /// The colours of F, B and M, in sRGB.
    pub type_colours: [[f32; 3]; 3],
}

/// All bare parts of one material.
pub struct Bare {
    pub material: String,
    /// In linear light.
    pub colour: Vec3,
    pub gloss: f32,
    pub positions: Vec<Vec3>,
    pub normals: Vec<Vec3>,
    pub triangles: Vec<[u32; 3]>,
}

/// Corners of the mosaic, each of one colour: where cells meet, each of them has its own.
pub struct Coloured {
    /// The point of each corner, and its colour in linear light.
    pub corners: Vec<(u32, Vec3)>,
    pub triangles: Vec<[u32; 3]>,
}

impl<'a> Specimen<'a> {
    /// A day that stands in the diary of a growth on `rest`, which stands as `mesh` on that day, in the colours of
    /// a look and of the plant's control images.
    pub fn new(
        (rest, mesh, ornaments): (&Mesh, &'a Mesh, &[Ornament]),
        look: &Look,
        controls: &[Control],
        (diary, day): (&Diary, usize),
        link: String,
    ) -> Specimen<'a> {
        let shades = tints(rest, controls, diary, day).zip(0..);
        let cells = shades.zip(&diary.lineage).map(|((tint, cell), lineage)| {
            (lineage.kind, look.of_cell(lineage.kind, tint, lightness(cell)))
        });
        Specimen {
            link,
            mesh,
            tiling: Tiling::new(mesh, &diary.days[day].places),
            cells: cells.collect(),
            of_nobody: look.of_nobody(),
            gloss: look.gloss * look.skin.gloss.iter().sum::<f32>() / 3.0,
            bare: bare(ornaments, look),
            type_colours: look.cells,
        }
    }

    pub fn cell_count(&self) -> usize {
        self.cells.len()
    }

    /// Triangles of the mosaic and of the bare parts.
    pub fn triangle_count(&self) -> usize {
        let bare: usize = self.bare.iter().map(|bare| bare.triangles.len()).sum();
        self.tiling.facets.len() + bare
    }

    /// The type of cell that a facet belongs to; a part without cells looks like B.
    pub fn kind(&self, facet: &Facet) -> CellType {
        facet.cell.map_or(CellType::Background, |cell| self.cells[cell as usize].0)
    }

    /// The colour of a facet in linear light.
    pub fn colour(&self, facet: &Facet) -> Vec3 {
        facet.cell.map_or(self.of_nobody, |cell| self.cells[cell as usize].1)
    }

    /// The mosaic with corners that have one colour each.
    pub fn coloured(&self) -> Coloured {
        // A cell's corners stand side by side; nobody comes last.
        let key = |facet: &Facet, point: u32| {
            u64::from(facet.cell.unwrap_or(u32::MAX)) << 32 | u64::from(point)
        };
        let facets = &self.tiling.facets;
        let of = |facet: &Facet| facet.corners.map(|point| key(facet, point));
        let mut keys: Vec<u64> = facets.iter().flat_map(of).collect();
        keys.sort_unstable();
        keys.dedup();
        let number = |key: u64| keys.partition_point(|&other| other < key) as u32;
        let triangles = facets.iter().map(|facet| of(facet).map(number)).collect();
        let colour = |key: u64| {
            self.cells.get((key >> 32) as usize).map_or(self.of_nobody, |&(_, colour)| colour)
        };
        let corners = keys.iter().map(|&key| (key as u32, colour(key))).collect();
        Coloured { corners, triangles }
    }
}

/// The bare parts, those of one material together.
fn bare(ornaments: &[Ornament], look: &Look) -> Vec<Bare> {
    let mut sorted: Vec<&Ornament> = ornaments.iter().collect();
    sorted.sort_by(|a, b| a.material.cmp(&b.material));
    let of_one = sorted.chunk_by(|a, b| a.material == b.material);
    let joined = of_one.map(|parts| {
        let (colour, gloss) = look.of_bare(&parts[0].material);
        let material = parts[0].material.clone();
        let (positions, normals, triangles) = (Vec::new(), Vec::new(), Vec::new());
        let colour = linear(colour);
        let mut bare = Bare { material, colour, gloss, positions, normals, triangles };
        for part in parts {
            let first = bare.positions.len() as u32;
            bare.positions.extend(&part.positions);
            bare.normals.extend(&part.normals);
            bare.triangles.extend(part.triangles.iter().map(|t| t.map(|v| v + first)));
        }
        bare
    });
    joined.collect()
}
