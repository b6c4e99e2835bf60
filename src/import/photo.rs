//! What the colours of a photograph make of a plant.

use super::palette::{Part, oklab};
use crate::play::Scene;
use crate::play::parameters::{Parameter, number_of};
use crate::tissue::{CellType, Clock, Recipe, expected_cells};

/// The types of a plant's cells.
pub fn types(scene: &Scene) -> impl Iterator<Item = CellType> {
    let names = scene.plant.colour_names;
    CellType::ALL.into_iter().filter(move |&kind| !names[kind as usize].is_empty())
}

/// Which type each colour is like: of all ways to give them out the one that changes the plant least.
pub fn matched(scene: &Scene, colours: &[Part]) -> Vec<CellType> {
    let types: Vec<CellType> = types(scene).collect();
    let own = |kind: CellType| oklab(scene.look.cells[kind as usize]);
    let far = |order: &Vec<CellType>| -> f32 {
        order
            .iter()
            .zip(colours)
            .map(|(&kind, part)| (own(kind) - oklab(part.colour)).length())
            .sum()
    };
    let orders = orders(&types);
    orders.into_iter().min_by(|a, b| far(a).total_cmp(&far(b))).unwrap_or(types)
}

/// All orders of a few types.
fn orders(types: &[CellType]) -> Vec<Vec<CellType>> {
    if types.len() < 2 {
        return vec![types.to_vec()];
    }
    let first = |k: usize| {
        let mut rest = types.to_vec();
        let first = rest.remove(k);
        orders(&rest).into_iter().map(move |rest| [vec![first], rest].concat())
    };
    (0..types.len()).flat_map(first).collect()
}

/// The plant in these colours, each of the type at its place.
pub fn coloured(scene: &Scene, colours: &[Part], kinds: &[CellType]) -> Scene {
    let mut made = scene.clone();
    for (part, kind) in colours.iter().zip(kinds) {
        set(&mut made, ["cf", "cb", "cm"][*kind as usize], number_of(part.colour));
    }
    made
}

/// The plant with as much of each colour on its day, and so many first cells, each the beginning of a patch.
pub fn patterned(scene: &Scene, colours: &[Part], kinds: &[CellType], first_cells: f64) -> Scene {
    let mut made = scene.clone();
    // A cell that divides more often comes to more of them: so much less there has to be at first.
    let mut first = [0.0; 3];
    for (part, &kind) in colours.iter().zip(kinds) {
        first[kind as usize] = part.share / clan(&scene.recipe, kind, scene.day);
    }
    let sum: f64 = first.iter().sum();
    for (key, kind) in [("pf", CellType::Foreground), ("pm", CellType::Middle)] {
        set(&mut made, key, (1000.0 * first[kind as usize] / sum).round() / 1000.0);
    }
    let tens = (first_cells / 10.0).round() * 10.0;
    set(&mut made, "n", tens.clamp(10.0, 20_000.0));
    made
}

/// The mean clan of a cell of a type on a day, as if no child turned and all clocks were Poisson's.
fn clan(recipe: &Recipe, kind: CellType, day: u32) -> f64 {
    let [f, b, m] = [0, 1, 2].map(|of| std::array::from_fn(|to| f64::from(u8::from(of == to))));
    let plain = Recipe { mutation: [f, b, m], clock: Clock::Poisson, ..recipe.clone() };
    let mut first = [0; 3];
    first[kind as usize] = 1;
    expected_cells(&plain, &[], first, day as usize).map_or(1.0, |expected| expected.mean)
}

/// Sets a number that the plant has.
fn set(scene: &mut Scene, key: &str, value: f64) {
    if let Some(parameter) = Parameter::of_key(key).filter(|p| p.is_for(scene.plant)) {
        let _ = parameter.set(scene, value);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants;
    use crate::play::link;
    use CellType::{Background as B, Foreground as F};

    fn scene(text: &str) -> Scene {
        link::read(text, plants::all()).scene
    }

    #[test]
    fn colours_go_to_the_types_that_they_are_like() {
        let croton = scene("croton?v=1&s=1&d=20");
        let part = |colour, share| Part { colour, share };
        let colours = [part([0.1, 0.3, 0.15], 0.8), part([0.9, 0.85, 0.5], 0.2)];
        let kinds = matched(&croton, &colours);
        assert_eq!(kinds, [B, F]);
        let made = coloured(&croton, &colours, &kinds);
        assert!(link::write(&made).ends_with("&cf=e6d980&cb=1a4d26"), "{}", link::write(&made));
        let turned = coloured(&croton, &colours, &[F, B]);
        assert!(link::write(&turned).ends_with("&cf=1a4d26&cb=e6d980"), "{}", link::write(&turned));
    }

    #[test]
    fn there_is_as_much_of_a_colour_on_the_day_as_in_the_photograph() {
        let shrub = scene("croton-shrub?v=1&s=1&d=12&df=4&db=9");
        let part = |share| Part { colour: [0.5; 3], share };
        let made = patterned(&shrub, &[part(0.7), part(0.3)], &[B, F], 358.0);
        assert_eq!(made.recipe.initial_cells, 360);
        let first = made.recipe.initial_probability[0];
        assert!(first < 0.3, "yellow divides more often: {first}");
        let of = |kind, p: f64| p * clan(&made.recipe, kind, 12);
        let share = of(F, first) / (of(F, first) + of(B, 1.0 - first));
        assert!((share - 0.3).abs() < 0.01, "{share}");
        assert_eq!(link::read(&link::write(&made), plants::all()).left_out, [""; 0]);
    }
}
