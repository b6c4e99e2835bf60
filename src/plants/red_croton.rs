//! Red croton: yellow breaks out in green, and red in yellow (mutation: Thesis 3.2.1.2).

use super::{Look, Plant, Rules, croton};
use crate::tissue::Recipe;

/// As links of the first rules have it.
pub(super) const FIRST: Plant = Plant {
    key: "red-croton",
    name: "Red croton",
    source: "Thesis, 3.2.1.2",
    colour_names: ["yellow", "green", "red"],
    recipe: Recipe {
        initial_cells: 4_000,
        // A few yellow cells to begin with: all flecks that are born of green ones later are smaller.
        initial_probability: [0.04, 0.96, 0.0],
        // Yellow and red keep pace with each other, so that red stays within its yellow fleck, and both
        // outrun green.
        division_days: [5.0, 9.0, 5.0],
        // Some children of green cells are yellow, some of yellow ones red, and none goes back: no
        // red fleck without a yellow one around it or beside it.
        mutation: [[0.85, 0.0, 0.15], [0.04, 0.96, 0.0], [0.0, 0.0, 1.0]],
        // Yellow and red part from green alike, and not from each other.
        adhesion: [[0.5, 0.0, 0.5], [0.0, 0.8, 0.0], [0.5, 0.0, 0.5]],
        // Individuals have about 44,000 cells.
        max_cells: 100_000,
        ..croton::FIRST.recipe
    },
    first_day: 30,
    look: Look {
        cells: [[0.93, 0.76, 0.2], [0.122, 0.353, 0.165], [0.72, 0.16, 0.14]],
        ..croton::FIRST.look
    },
    paint: &[],
    ..croton::FIRST
};

pub const PLANT: Plant = Plant {
    rules: Rules::Second,
    source: "after Thesis, 3.2.1.2",
    recipe: Recipe {
        // Fewer and larger flecks, with a few clumps of red within the yellow.
        initial_cells: 2_500,
        mutation: [[0.95, 0.0, 0.05], [0.04, 0.96, 0.0], [0.0, 0.0, 1.0]],
        adhesion: [[0.5, 0.0, 0.1], [0.0, 0.8, 0.0], [0.1, 0.0, 0.5]],
        ..FIRST.recipe
    },
    look: Look {
        cells: [[0.93, 0.76, 0.2], [0.12, 0.22, 0.12], [0.6, 0.13, 0.11]],
        ..croton::LOOK
    },
    ..FIRST
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tissue::Progress;
    use std::sync::Arc;

    #[test]
    fn red_is_born_of_yellow_and_yellow_of_green() {
        let mesh = Arc::new(PLANT.embedded_body().surface);
        let recipe = Recipe { days: 24, ..PLANT.recipe };
        let mut growth = PLANT.sow(mesh, recipe, 1).unwrap();
        while growth.step() != Progress::Done {}
        let diary = &growth.diary;
        assert_eq!(diary.count(0).by_type[2], 0, "no first cell is red");
        let mut born_of = [[0; 3]; 3];
        for cell in diary.lineage.iter().filter(|cell| cell.born_day > 0) {
            born_of[diary.lineage[cell.parent as usize].kind as usize][cell.kind as usize] += 1;
        }
        let [[_, fb, fm], [bf, _, bm], [mf, mb, mm]] = born_of;
        assert_eq!([fb, bm, mf, mb], [0; 4], "{born_of:?}");
        assert!(fm > 100 && bf > 300 && mm > 150, "{born_of:?}");
    }
}
