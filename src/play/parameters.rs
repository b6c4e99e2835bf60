//! The numbers that a visitor can change: one table, from which the panel, the links and the help
//! are made.

use super::Scene;
use crate::plants::Plant;
use crate::tissue::CellType::{self, Background as B, Foreground as F, Middle as M};

/// One number that a visitor can change.
pub struct Parameter {
    /// Its word in links. Never given to another number, or old links would lie.
    pub key: &'static str,
    /// May name the colours of the plant as `{F}` and `{B}`.
    label: &'static str,
    pub unit: &'static str,
    /// Least and greatest value, both allowed.
    pub range: [f64; 2],
    /// Step of the slider; links may lie between.
    pub step: f64,
    /// One line on what it does; may name the colours too.
    effect: &'static str,
    /// Whether a change grows the plant again from day 0; if not, it is seen at once.
    pub regrows: bool,
    get: fn(&Scene) -> f64,
    set: fn(&mut Scene, f64),
}

/// All parameters in the order of the panel.
pub const PARAMETERS: &[Parameter] = &[
    Parameter {
        key: "n",
        label: "First cells",
        unit: "cells",
        range: [1.0, 20_000.0],
        step: 100.0,
        effect: "How many cells are sown on the bare surface.",
        regrows: true,
        get: |s| f64::from(s.recipe.initial_cells),
        set: |s, x| s.recipe.initial_cells = x as u32,
    },
    Parameter {
        key: "pf",
        label: "First cells that are {F}",
        unit: "share",
        range: [0.0, 1.0],
        step: 0.001,
        effect: "The chance that a first cell is {F}; the others are {B}.",
        regrows: true,
        get: |s| s.recipe.initial_probability[F as usize],
        set: |s, x| {
            let middle = s.recipe.initial_probability[M as usize].min(1.0 - x);
            s.recipe.initial_probability = [x, (1.0 - x - middle).max(0.0), middle];
        },
    },
    Parameter {
        key: "df",
        label: "Days between divisions, {F}",
        unit: "days",
        range: [1.5, 200.0],
        step: 0.5,
        effect: "Fewer days: {F} cells multiply faster and take over.",
        regrows: true,
        get: |s| s.recipe.division_days[F as usize],
        set: |s, x| s.recipe.division_days[F as usize] = x,
    },
    Parameter {
        key: "db",
        label: "Days between divisions, {B}",
        unit: "days",
        range: [1.5, 200.0],
        step: 0.5,
        effect: "Fewer days: {B} cells multiply faster and take over.",
        regrows: true,
        get: |s| s.recipe.division_days[B as usize],
        set: |s, x| s.recipe.division_days[B as usize] = x,
    },
    Parameter {
        key: "ff",
        label: "Adhesion among {F} cells",
        unit: "",
        range: [0.0, 1.0],
        step: 0.05,
        effect: "0: they push each other away in full; 1: not at all, and they huddle.",
        regrows: true,
        get: |s| adhesion(s, F, F),
        set: |s, x| set_adhesion(s, F, F, x),
    },
    Parameter {
        key: "bb",
        label: "Adhesion among {B} cells",
        unit: "",
        range: [0.0, 1.0],
        step: 0.05,
        effect: "0: they push each other away in full; 1: not at all, and they huddle.",
        regrows: true,
        get: |s| adhesion(s, B, B),
        set: |s, x| set_adhesion(s, B, B, x),
    },
    Parameter {
        key: "fb",
        label: "Adhesion between {F} and {B}",
        unit: "",
        range: [0.0, 1.0],
        step: 0.05,
        effect: "0: the colours part into clear patches; 1: they mix.",
        regrows: true,
        get: |s| adhesion(s, F, B),
        set: |s, x| set_adhesion(s, F, B, x),
    },
    Parameter {
        key: "mfb",
        label: "Children of {F} that turn {B}",
        unit: "share",
        range: [0.0, 1.0],
        step: 0.005,
        effect: "Mutation: the chance that a {F} cell's child is {B}.",
        regrows: true,
        get: |s| s.recipe.mutation[F as usize][B as usize],
        set: |s, x| set_mutation(s, F, B, x),
    },
    Parameter {
        key: "mbf",
        label: "Children of {B} that turn {F}",
        unit: "share",
        range: [0.0, 1.0],
        step: 0.005,
        effect: "Mutation: the chance that a {B} cell's child is {F}.",
        regrows: true,
        get: |s| s.recipe.mutation[B as usize][F as usize],
        set: |s, x| set_mutation(s, B, F, x),
    },
    Parameter {
        key: "rs",
        label: "Reach of the push",
        unit: "× spacing",
        range: [0.1, 6.0],
        step: 0.1,
        effect: "How far cells feel each other: a wider reach makes larger, rounder patches.",
        regrows: true,
        get: |s| widen(s.recipe.radius_scale),
        set: |s, x| s.recipe.radius_scale = x as f32,
    },
    Parameter {
        key: "rep",
        label: "Strength of the push",
        unit: "",
        range: [0.0, 1.0],
        step: 0.005,
        effect: "How far one event moves a cell; too strong and the cells never rest.",
        regrows: true,
        get: |s| widen(s.recipe.repulsion),
        set: |s, x| s.recipe.repulsion = x as f32,
    },
    Parameter {
        key: "ri",
        label: "Events before day 0",
        unit: "events",
        range: [0.0, 200.0],
        step: 1.0,
        effect: "More events spread the first cells more evenly.",
        regrows: true,
        get: |s| f64::from(s.recipe.initial_relaxations),
        set: |s, x| s.recipe.initial_relaxations = x as u32,
    },
    Parameter {
        key: "rd",
        label: "Events in a day",
        unit: "events",
        range: [0.0, 60.0],
        step: 1.0,
        effect: "More events give the cells more time to part between divisions.",
        regrows: true,
        get: |s| f64::from(s.recipe.relaxations_per_day),
        set: |s, x| s.recipe.relaxations_per_day = x as u32,
    },
    Parameter {
        key: "days",
        label: "Days to grow",
        unit: "days",
        range: [1.0, 60.0],
        step: 1.0,
        effect: "The last day of the time line.",
        regrows: true,
        get: |s| f64::from(s.recipe.days),
        set: |s, x| s.recipe.days = x as u32,
    },
    Parameter {
        key: "bo",
        label: "Cell borders",
        unit: "",
        range: [0.0, 1.0],
        step: 0.02,
        effect: "How much darker the borders are than the cells.",
        regrows: false,
        get: |s| widen(s.look.border),
        set: |s, x| s.look.border = x as f32,
    },
    Parameter {
        key: "va",
        label: "Variation of the colours",
        unit: "",
        range: [0.0, 1.0],
        step: 0.02,
        effect: "How much the lightness of cells of one colour varies.",
        regrows: false,
        get: |s| widen(s.look.variation),
        set: |s, x| s.look.variation = x as f32,
    },
];

impl Parameter {
    /// The parameter of a link's word.
    pub fn of_key(key: &str) -> Option<&'static Parameter> {
        PARAMETERS.iter().find(|p| p.key == key)
    }

    /// What it is called for a plant.
    pub fn label(&self, plant: &Plant) -> String {
        with_colours(self.label, plant)
    }

    /// One line on what it does.
    pub fn effect(&self, plant: &Plant) -> String {
        with_colours(self.effect, plant)
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
        let [least, greatest] = self.range;
        if !(least..=greatest).contains(&value) {
            let unit = if self.unit.is_empty() { String::new() } else { format!(" {}", self.unit) };
            return Err(format!("it must be from {least} to {greatest}{unit}"));
        }
        let mut changed = scene.clone();
        (self.set)(&mut changed, value);
        changed.recipe.check().map_err(|e| e.to_string())?;
        changed.day = changed.day.min(changed.recipe.days);
        *scene = changed;
        Ok(())
    }
}

fn with_colours(text: &str, plant: &Plant) -> String {
    let [f, b, _] = plant.colour_names;
    text.replace("{F}", f).replace("{B}", b)
}

/// An f32 as the short decimal that it was written as.
fn widen(x: f32) -> f64 {
    (f64::from(x) * 1e6).round() / 1e6
}

fn adhesion(scene: &Scene, a: CellType, b: CellType) -> f64 {
    widen(scene.recipe.adhesion[a as usize][b as usize])
}

fn set_adhesion(scene: &mut Scene, a: CellType, b: CellType, value: f64) {
    scene.recipe.adhesion[a as usize][b as usize] = value as f32;
    scene.recipe.adhesion[b as usize][a as usize] = value as f32;
}

/// The parent's own type takes what the others leave.
fn set_mutation(scene: &mut Scene, parent: CellType, child: CellType, share: f64) {
    let row = &mut scene.recipe.mutation[parent as usize];
    row[M as usize] = row[M as usize].min(1.0 - share);
    row[child as usize] = share;
    row[parent as usize] = (1.0 - share - row[M as usize]).max(0.0);
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
        }
    }

    #[test]
    fn labels_name_the_colours_of_the_plant() {
        let label = Parameter::of_key("df").unwrap().label(&PLANTS[0]);
        assert_eq!(label, "Days between divisions, yellow");
    }
}
