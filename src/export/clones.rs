//! The clones of a day as a table.

use crate::mosaic::polygons;
use crate::surface::{Charts, Mesh};
use crate::tissue::Diary;
use std::io::{self, Write};

/// Writes the clones of a day as CSV, one row per clone in the order of their founders; returns how many.
///
/// A clone is a first cell, the founder, and all that descend from it. `founder` is that cell's number,
/// `type` its type and `born_day` its day; `cells` are the living cells of the clone, and `F`, `B` and `M` those of
/// each type; `area_cm2` is the area of their Voronoi polygons and `part` the part of the surface where they all
/// live, as no cell leaves its own.
///
/// # Errors
/// What `out` says.
pub fn write_clones(
    mesh: &Mesh,
    diary: &Diary,
    day: usize,
    out: &mut impl Write,
) -> io::Result<usize> {
    let places = &diary.days[day].places;
    let lineage = &diary.lineage[..places.len()];
    let mut clones = vec![Members::default(); places.len()];
    for cell in lineage {
        clones[cell.founder as usize].by_type[cell.kind as usize] += 1;
    }
    for piece in polygons(mesh, &mut Charts::new(mesh), places) {
        let founder = lineage[piece.cell as usize].founder;
        clones[founder as usize].area_cm2 += f64::from(piece.area());
    }
    writeln!(out, "founder,type,born_day,cells,F,B,M,area_cm2,part")?;
    let mut count = 0;
    for (id, clone) in clones.iter().enumerate() {
        let [f, b, m] = clone.by_type;
        let cells = f + b + m;
        if cells == 0 {
            continue;
        }
        let (founder, part) = (&lineage[id], mesh.parts[places[id].triangle as usize]);
        writeln!(
            out,
            "{id},{},{},{cells},{f},{b},{m},{},{part}",
            founder.kind.letter(),
            founder.born_day,
            clone.area_cm2 as f32
        )?;
        count += 1;
    }
    Ok(count)
}

#[derive(Clone, Copy, Default)]
struct Members {
    by_type: [u32; 3],
    area_cm2: f64,
}
