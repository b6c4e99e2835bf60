//! Watermelon 'Moon and Stars': yellow spots of all sizes on a dark rind, by mutation alone. The word is of the
//! fruit: spots under 2 cm are its stars, patches of 6 to 15 cm its moons.

use super::{Look, Plant, Rules, Shape, watermelon};
use crate::tissue::{Clock, Recipe};

pub const PLANT: Plant = Plant {
    rules: Rules::First,
    key: "moon-and-stars",
    name: "Moon and Stars",
    source: "",
    colour_names: ["yellow", "dark green", ""],
    recipe: Recipe {
        // So few that a child of theirs that is yellow becomes a moon.
        initial_cells: 30,
        initial_probability: [0.0, 1.0, 0.0],
        // At any time, so that spots are of all sizes and not of powers of two. Of equals, one spot in n has
        // n cells or more; yellow is a little faster, for moons among fewer stars.
        clock: Clock::Exponential,
        division_days: [3.0, 3.4, 3.4],
        mutation: [[1.0, 0.0, 0.0], [0.012, 0.988, 0.0], [0.0, 0.0, 1.0]],
        adhesion: [[0.8, 0.0, 0.0], [0.0, 0.9, 0.0], [0.0, 0.0, 0.0]],
        radius_scale: 1.5,
        repulsion: 0.16,
        days: 22,
        max_cells: 60_000,
        ..watermelon::PLANT.recipe
    },
    first_day: 22,
    look: Look {
        cells: [[0.93, 0.79, 0.22], [0.086, 0.2, 0.11], [0.5, 0.5, 0.2]],
        ..watermelon::PLANT.look
    },
    // Where there are few cells, each one pushes far: on the body of the watermelon, which is cut twice as
    // finely, these days take seven times as long.
    body: Shape { levels: 1, ..watermelon::PLANT.body },
    paint: &[],
    ..watermelon::PLANT
};
