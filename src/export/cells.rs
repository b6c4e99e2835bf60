//! The cells of a day as a table.

use crate::surface::Mesh;
use crate::tissue::Diary;
use glam::DVec3;
use std::io::{self, Write};

/// Writes the cells of a day as CSV, one row per cell in the order of birth.
///
/// `id`, `parent` and `founder` are cell numbers (a first cell is its own parent), `type` is `F`,
/// `B` or `M`, `part` and `triangle` are numbers of the mesh, `x`, `y`, `z` are the
/// place in its units plus `origin`, and `born_day` is the day on which the cell was first there. Numbers are written with as many digits as it takes to read the same bits back.
pub fn write_cells(
    mesh: &Mesh,
    origin: DVec3,
    diary: &Diary,
    day: usize,
    out: &mut impl Write,
) -> io::Result<()> {
    writeln!(out, "id,parent,founder,type,part,triangle,x,y,z,born_day")?;
    for (id, (place, cell)) in diary.days[day].places.iter().zip(&diary.lineage).enumerate() {
        let point = mesh.point(*place);
        writeln!(
            out,
            "{id},{},{},{},{},{},{},{},{},{}",
            cell.parent,
            cell.founder,
            cell.kind.letter(),
            mesh.parts[place.triangle as usize],
            place.triangle,
            moved(point.x, origin.x),
            moved(point.y, origin.y),
            moved(point.z, origin.z),
            cell.born_day
        )?;
    }
    Ok(())
}

/// In the digits of an f32 where it stays one.
fn moved(x: f32, by: f64) -> String {
    if by == 0.0 { x.to_string() } else { (f64::from(x) + by).to_string() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::Place;
    use crate::tissue::{CellType, Day, Lineage};
    use glam::Vec3;

    #[test]
    fn a_day_has_a_row_for_each_of_its_cells() {
        let square = vec![Vec3::ZERO, Vec3::X, Vec3::new(1.0, 1.0, 0.0), Vec3::Y];
        let mesh = Mesh::new(square, Vec::new(), vec![[0, 1, 2], [0, 2, 3]]).unwrap();
        let cell = |parent, founder, born_day, kind| Lineage { parent, founder, born_day, kind };
        let lineage =
            vec![cell(0, 0, 0, CellType::Background), cell(0, 0, 1, CellType::Foreground)];
        let day = |places| Day { places, repulsive_radius: 1.0 };
        let first = Place { triangle: 0, b1: 0.25, b2: 0.5 };
        let second = Place { triangle: 1, b1: 0.0, b2: 1.0 };
        let diary = Diary { lineage, days: vec![day(vec![first]), day(vec![first, second])] };

        let mut table = Vec::new();
        write_cells(&mesh, DVec3::ZERO, &diary, 1, &mut table).unwrap();
        assert_eq!(
            String::from_utf8(table).unwrap(),
            "id,parent,founder,type,part,triangle,x,y,z,born_day\n\
             0,0,0,B,0,0,0.75,0.5,0,0\n\
             1,0,0,F,0,1,0,1,0,1\n"
        );

        let mut table = Vec::new();
        write_cells(&mesh, DVec3::new(0.0, 5e6, -1.0), &diary, 0, &mut table).unwrap();
        let table = String::from_utf8(table).unwrap();
        assert_eq!(table.lines().skip(1).collect::<Vec<_>>(), ["0,0,0,B,0,0,0.75,5000000.5,-1,0"]);
    }
}
