//! Perlin noise in the place of clones, to compare (Thesis, Figs. 4.5 to 4.7): the same cells on the
//! same days, and as many of each type, but their types are read off noise in space and time.

use super::{CellType, Day, Diary};
use crate::surface::Mesh;
use noise::{NoiseFn, Perlin};

/// A pattern of noise on one mesh.
pub struct Noise {
    perlin: Perlin,
    /// Waves of the noise in a centimetre.
    per_cm: f64,
}

/// Waves along the side of a square as large as the surface: blotches come out as wide as the clones
/// of the thesis' plants.
const WAVES: f64 = 26.0;

/// Waves in a day: neighbouring days look alike, and after a week nothing is left of a blotch. Slower,
/// and the noise seems to grow; faster, and it flickers.
const WAVES_PER_DAY: f64 = 0.12;

impl Noise {
    pub fn new(mesh: &Mesh, seed: u32) -> Noise {
        Noise { perlin: Perlin::new(seed), per_cm: WAVES / f64::from(mesh.area).sqrt() }
    }

    /// A diary in which the cells of a day have the types of the noise. Of the days before it only
    /// the last one has its places.
    pub fn paint(&self, mesh: &Mesh, diary: &Diary, day: usize) -> Diary {
        let places = &diary.days[day].places;
        let time = day as f64 * WAVES_PER_DAY;
        let value = |cell: u32| {
            let [x, y, z] =
                mesh.point(places[cell as usize]).to_array().map(|x| f64::from(x) * self.per_cm);
            self.perlin.get([x, y, z, time])
        };
        let mut cells: Vec<(f64, u32)> = (0..places.len() as u32).map(|c| (value(c), c)).collect();
        // Cells of equal noise in the order of their birth: the same on every machine.
        cells.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let mut lineage = diary.lineage[..places.len()].to_vec();
        let by_type = diary.count(day).by_type;
        let kinds = CellType::ALL
            .into_iter()
            .flat_map(|kind| std::iter::repeat_n(kind, by_type[kind as usize] as usize));
        for ((_, cell), kind) in cells.into_iter().zip(kinds) {
            lineage[cell as usize].kind = kind;
        }
        let days = diary.days[..=day].iter().enumerate().map(|(d, written)| match written {
            written if d + 1 >= day => written.clone(),
            Day { repulsive_radius, .. } => {
                Day { places: Vec::new(), repulsive_radius: *repulsive_radius }
            }
        });
        Diary { days: days.collect(), lineage }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::icosphere;
    use crate::tissue::{Growth, Progress, Recipe};
    use std::sync::Arc;

    #[test]
    fn noise_has_the_cells_and_the_shares_of_the_day_and_is_coherent_in_space() {
        let mesh = Arc::new(icosphere(3, 10.0));
        let recipe = Recipe { days: 12, division_days: [4.0, 12.0, 12.0], ..Recipe::default() };
        let mut growth = Growth::new(mesh.clone(), recipe, &[], 1).unwrap();
        while growth.step() != Progress::Done {}
        let diary = growth.diary;
        let noise = Noise::new(&mesh, 5);
        let foreground = |painted: &Diary, day: usize| -> Vec<bool> {
            let cells = &painted.lineage[..diary.days[day].places.len()];
            cells.iter().map(|cell| cell.kind == CellType::Foreground).collect()
        };
        let mut kept = Vec::new();
        for day in 0..=12 {
            let painted = noise.paint(&mesh, &diary, day);
            assert_eq!(painted.days[day], diary.days[day]);
            assert_eq!(painted.count(day), diary.count(day));
            assert_eq!(painted.days.len(), day + 1);
            // How many of the first cells have the type that they had on day 0.
            let (first, now) = (noise.paint(&mesh, &diary, 0), foreground(&painted, day));
            let alike = foreground(&first, 0).into_iter().zip(now).filter(|(a, b)| a == b).count();
            kept.push(alike as f64 / diary.days[0].places.len() as f64);
        }
        assert_eq!(kept[0], 1.0);
        // Cells keep their types for life in a tissue; in noise they forget them.
        assert!(kept[1] > 0.8 && kept[12] < 0.7, "{kept:?}");
        assert_ne!(noise.paint(&mesh, &diary, 3), Noise::new(&mesh, 6).paint(&mesh, &diary, 3));
    }
}
