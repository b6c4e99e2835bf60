//! The numbers that a visitor can change: one table, from which the panel, the links and the help
//! are made.

mod colour;
mod slider;
mod table;

use super::{Scene, link, words};
use crate::plants::Plant;
use crate::surface::{Shortest, filled};
pub use colour::number_of;
use slider::Scale;
pub use table::{PARAMETERS, widen};

/// One number that a visitor can change.
pub struct Parameter {
    /// Its word in links. Never given to another number, or old links would lie.
    pub key: &'static str,
    /// May name the colours of the plant as `{F}`, `{B}` and `{M}`.
    label: &'static str,
    /// Its symbol in the thesis (Table 4.1), if it has one.
    pub symbol: &'static str,
    pub unit: &'static str,
    /// Least and greatest value, both allowed.
    pub range: [f64; 2],
    /// Step of the slider; links may lie between, but for whole numbers, whose step is whole.
    pub step: f64,
    scale: Scale,
    /// What is chosen by the numbers 0, 1 and so on, and only by these; of plain numbers nothing.
    pub names: &'static [&'static str],
    /// Whether it is a colour, a number of eight bits for each part of sRGB.
    pub is_colour: bool,
    /// One line on what it does; may name the colours too.
    effect: &'static str,
    needs: Needs,
    /// Whether a change grows the plant again from day 0; if not, it is seen at once.
    pub regrows: bool,
    get: fn(&Scene) -> f64,
    set: fn(&mut Scene, f64),
}

/// What a plant must have for a parameter to mean anything.
#[derive(Clone, Copy)]
enum Needs {
    Nothing,
    /// M cells.
    Middle,
    /// A direction field.
    Field,
}

impl Parameter {
    /// The parameter of a link's word.
    pub fn of_key(key: &str) -> Option<&'static Parameter> {
        PARAMETERS.iter().find(|p| p.key == key)
    }

    /// What it is called for a plant.
    pub fn label(&self, plant: &Plant) -> String {
        with_colours(self.label, plant)
    }

    /// One line on what it does; where a control image has the last word, that, too.
    pub fn effect(&self, plant: &Plant) -> String {
        let effect = with_colours(self.effect, plant);
        match self.key == "pf" && !plant.paint.is_empty() {
            true => effect + &with_colours(CONTROLLED, plant),
            false => effect,
        }
    }

    /// Whether it means anything for a plant.
    pub fn is_for(&self, plant: &Plant) -> bool {
        match self.needs {
            Needs::Nothing => true,
            Needs::Middle => !plant.colour_names[2].is_empty(),
            Needs::Field => plant.guides.is_some(),
        }
    }

    /// Whether it has whole values only.
    pub fn is_whole(&self) -> bool {
        self.step.fract() == 0.0
    }

    /// Whether it is a plain number, neither a choice nor a colour.
    pub fn is_number(&self) -> bool {
        self.names.is_empty() && !self.is_colour
    }

    /// A value as links say it.
    pub fn written(&self, value: f64) -> String {
        if self.is_colour { colour::written(value) } else { value.shortest() }
    }

    /// Reads a value as links say it; in an error, why it is none.
    pub fn read(&self, text: &str) -> Result<f64, String> {
        if self.is_colour { colour::read(text) } else { link::number(text) }
    }

    /// A value as people read it: its name, its colour, or with its unit.
    pub fn said(&self, value: f64) -> String {
        match self.names.get(value as usize) {
            Some(name) => (*name).to_string(),
            None if self.is_colour => format!("#{}", self.written(value)),
            None if self.unit.is_empty() => value.shortest(),
            None => format!("{} {}", value.shortest(), self.unit),
        }
    }

    /// Its value in a scene.
    pub fn get(&self, scene: &Scene) -> f64 {
        (self.get)(scene)
    }

    /// The value of the plant's preset.
    pub fn preset(&self, plant: &'static Plant) -> f64 {
        (self.get)(&Scene::preset(plant, 0))
    }

    /// Changes it in a scene; the scene stays as it was if that cannot be grown, and the error says
    /// why in words that follow its name.
    pub fn set(&self, scene: &mut Scene, value: f64) -> Result<(), String> {
        if !self.is_for(scene.plant) {
            return Err("this plant has no use for it".to_string());
        }
        let [least, greatest] = self.range;
        if !(least..=greatest).contains(&value) {
            let unit = if self.unit.is_empty() { String::new() } else { format!(" {}", self.unit) };
            let [least, greatest] = self.range.map(f64::shortest);
            return Err(format!("it must be from {least} to {greatest}{unit}"));
        }
        if self.is_whole() && value.fract() != 0.0 {
            return Err("it must be a whole number".to_string());
        }
        let mut changed = scene.clone();
        // No -0.0, which a link does not tell from 0.0.
        (self.set)(&mut changed, value + 0.0);
        // As a link will say it, which has fewer digits than an f32: the link must grow the same cells.
        let said = self.get(&changed);
        (self.set)(&mut changed, said);
        changed.recipe.check().map_err(|e| e.to_string())?;
        changed.day = changed.day.min(changed.recipe.days);
        *scene = changed;
        Ok(())
    }
}

/// Why day 0 has fewer F cells than the recipe says.
const CONTROLLED: &str =
    " The plant's control image lets them be so in places only: day 0 has fewer.";

fn with_colours(text: &str, plant: &Plant) -> String {
    let [f, b, m] = plant.colour_names;
    let most = words::grouped(plant.recipe.max_cells);
    filled(text, &[("F", f), ("B", b), ("M", m), ("most", &most)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::play::testing::PLANTS;

    #[test]
    fn what_is_set_is_got_and_can_be_grown() {
        for (k, parameter) in PARAMETERS.iter().enumerate() {
            assert!(PARAMETERS[..k].iter().all(|p| p.key != parameter.key), "{}", parameter.key);
            let [least, greatest] = parameter.range;
            let mut scene = Scene::preset(&PLANTS[0], 1);
            for value in [least, greatest, least + parameter.step] {
                parameter.set(&mut scene, value).expect(parameter.key);
                assert!((parameter.get(&scene) - value).abs() < 1e-9, "{}", parameter.key);
                assert_eq!(scene.recipe.check(), Ok(()));
            }
            assert!(parameter.set(&mut scene, greatest + 1.0).is_err());
            assert!(parameter.set(&mut scene, f64::NAN).is_err());
            if !parameter.names.is_empty() {
                assert_eq!(parameter.range, [0.0, (parameter.names.len() - 1) as f64]);
                assert!(parameter.set(&mut scene, least + 0.5).is_err());
            }
        }
    }

    #[test]
    fn what_a_plant_lacks_cannot_be_set() {
        for key in ["pm", "an"] {
            let parameter = Parameter::of_key(key).unwrap();
            let [mut leaf, mut fruit] = [&PLANTS[0], &PLANTS[1]].map(|p| Scene::preset(p, 1));
            assert_eq!(parameter.set(&mut leaf, 0.1), Ok(()));
            let refused = parameter.set(&mut fruit, 0.1).unwrap_err();
            assert_eq!(refused, "this plant has no use for it");
            assert!(parameter.is_for(leaf.plant) && !parameter.is_for(fruit.plant));
            assert!(fruit == Scene::preset(&PLANTS[1], 1));
        }
    }

    #[test]
    fn shares_of_a_row_make_room_for_each_other() {
        let mut scene = Scene::preset(&PLANTS[0], 1);
        let mut set = |key, value| {
            Parameter::of_key(key).unwrap().set(&mut scene, value).unwrap();
            (scene.recipe.initial_probability, scene.recipe.mutation)
        };
        let close = |row: [f64; 3], expected: [f64; 3]| {
            assert!(row.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9), "{row:?}");
        };
        close(set("pm", 0.2).0, [0.5, 0.3, 0.2]);
        close(set("pm", 0.7).0, [0.3, 0.0, 0.7]);
        close(set("pf", 0.4).0, [0.4, 0.0, 0.6]);
        close(set("mbf", 0.25).1[1], [0.25, 0.75, 0.0]);
        close(set("mbm", 0.5).1[1], [0.25, 0.25, 0.5]);
        close(set("mbm", 0.9).1[1], [0.1, 0.0, 0.9]);
        close(set("mmf", 0.1).1[2], [0.1, 0.0, 0.9]);
        close(set("mmb", 0.3).1[2], [0.1, 0.3, 0.6]);
        close(set("mfm", 1.0).1[0], [0.0, 0.0, 1.0]);
        close(scene.recipe.mutation[1], [0.1, 0.0, 0.9]);
    }

    #[test]
    fn labels_name_the_colours_of_the_plant() {
        let label = Parameter::of_key("df").unwrap().label(&PLANTS[0]);
        assert_eq!(label, "Days between divisions, yellow");
        let effect = Parameter::of_key("mfm").unwrap().effect(&PLANTS[0]);
        assert_eq!(effect, "Mutation: the chance that a yellow cell's child is red.");
    }

    #[test]
    fn what_the_numbers_do_not_say_is_told() {
        let effect = |key, plant| {
            Parameter::of_key(key).unwrap().effect(crate::plants::find(plant).unwrap())
        };
        assert!(effect("pf", "croton").ends_with("in places only: day 0 has fewer."));
        assert!(!effect("pf", "croton-shrub").contains("control image"));
        assert!(effect("days", "watermelon").contains("100,000 cells"));
        assert!(effect("days", "croton").contains("160,000 cells"));
    }
}
