//! The table of all parameters.

use super::{Needs, Parameter, Scale, colour};
use crate::play::Scene;
use crate::tissue::CellType::{self, Background as B, Foreground as F, Middle as M};
use crate::tissue::Clock;

/// What most parameters have in common: numbers without a unit that every plant has, and a change
/// grows the plant again.
pub(super) const NUMBER: Parameter = Parameter {
    key: "",
    label: "",
    symbol: "",
    unit: "",
    range: [0.0, 1.0],
    step: 1.0,
    scale: Scale::Even,
    names: &[],
    is_colour: false,
    effect: "",
    needs: Needs::Nothing,
    regrows: true,
    get: |_| 0.0,
    set: |_, _| {},
};

/// All parameters in the order of the panel.
pub const PARAMETERS: &[Parameter] = &[
    Parameter {
        key: "n",
        label: "First cells",
        unit: "cells",
        range: [1.0, 20_000.0],
        step: 100.0,
        effect: "How many cells are sown on the bare surface.",
        get: |s| f64::from(s.recipe.initial_cells),
        set: |s, x| s.recipe.initial_cells = x as u32,
        ..NUMBER
    },
    Parameter {
        key: "pf",
        label: "First cells that are {F}",
        symbol: "p_F",
        unit: "share",
        range: [0.0, 1.0],
        step: 0.001,
        effect: "The chance that a first cell is {F}; the others are {B}.",
        get: |s| s.recipe.initial_probability[F as usize],
        set: |s, x| {
            let middle = beside(x, s.recipe.initial_probability[M as usize]);
            s.recipe.initial_probability = [x, (1.0 - x - middle).max(0.0), middle];
        },
        ..NUMBER
    },
    Parameter {
        key: "pm",
        label: "First cells that are {M}",
        symbol: "p_M",
        unit: "share",
        range: [0.0, 1.0],
        step: 0.005,
        effect: "The chance that a first cell is {M}.",
        needs: Needs::Middle,
        get: |s| s.recipe.initial_probability[M as usize],
        set: |s, x| {
            let foreground = beside(x, s.recipe.initial_probability[F as usize]);
            s.recipe.initial_probability = [foreground, (1.0 - foreground - x).max(0.0), x];
        },
        ..NUMBER
    },
    Parameter {
        key: "df",
        label: "Days between divisions, {F}",
        symbol: "D_F",
        unit: "days",
        range: [1.5, 200.0],
        step: 0.5,
        scale: Scale::Ratio,
        effect: "Fewer days: {F} cells multiply faster and take over.",
        get: |s| s.recipe.division_days[F as usize],
        set: |s, x| s.recipe.division_days[F as usize] = x,
        ..NUMBER
    },
    Parameter {
        key: "db",
        label: "Days between divisions, {B}",
        symbol: "D_B",
        unit: "days",
        range: [1.5, 200.0],
        step: 0.5,
        scale: Scale::Ratio,
        effect: "Fewer days: {B} cells multiply faster and take over.",
        get: |s| s.recipe.division_days[B as usize],
        set: |s, x| s.recipe.division_days[B as usize] = x,
        ..NUMBER
    },
    Parameter {
        key: "dm",
        label: "Days between divisions, {M}",
        symbol: "D_M",
        unit: "days",
        range: [1.5, 200.0],
        step: 0.5,
        scale: Scale::Ratio,
        effect: "Fewer days: {M} cells multiply faster and take over.",
        needs: Needs::Middle,
        get: |s| s.recipe.division_days[M as usize],
        set: |s, x| s.recipe.division_days[M as usize] = x,
        ..NUMBER
    },
    Parameter {
        key: "ck",
        label: "Time between divisions",
        range: [0.0, 1.0],
        step: 1.0,
        names: &["in whole days (Poisson)", "at any time (exponential)"],
        effect: "How chance spreads it: around its mean, or without any memory.",
        get: |s| f64::from(u8::from(s.recipe.clock == Clock::Exponential)),
        set: |s, x| s.recipe.clock = if x == 0.0 { Clock::Poisson } else { Clock::Exponential },
        ..NUMBER
    },
    Parameter {
        key: "ff",
        label: "Adhesion among {F} cells",
        symbol: "α_FF",
        range: [0.0, 1.0],
        step: 0.05,
        effect: "0: they push each other away in full; 1: not at all, and they huddle.",
        get: |s| adhesion(s, F, F),
        set: |s, x| set_adhesion(s, F, F, x),
        ..NUMBER
    },
    Parameter {
        key: "bb",
        label: "Adhesion among {B} cells",
        symbol: "α_BB",
        range: [0.0, 1.0],
        step: 0.05,
        effect: "0: they push each other away in full; 1: not at all, and they huddle.",
        get: |s| adhesion(s, B, B),
        set: |s, x| set_adhesion(s, B, B, x),
        ..NUMBER
    },
    Parameter {
        key: "fb",
        label: "Adhesion between {F} and {B}",
        symbol: "α_FB",
        range: [0.0, 1.0],
        step: 0.05,
        effect: "0: the colours part into clear patches; 1: they mix.",
        get: |s| adhesion(s, F, B),
        set: |s, x| set_adhesion(s, F, B, x),
        ..NUMBER
    },
    Parameter {
        key: "mm",
        label: "Adhesion among {M} cells",
        symbol: "α_MM",
        range: [0.0, 1.0],
        step: 0.05,
        effect: "0: they push each other away in full; 1: not at all, and they huddle.",
        needs: Needs::Middle,
        get: |s| adhesion(s, M, M),
        set: |s, x| set_adhesion(s, M, M, x),
        ..NUMBER
    },
    Parameter {
        key: "fm",
        label: "Adhesion between {F} and {M}",
        symbol: "α_FM",
        range: [0.0, 1.0],
        step: 0.05,
        effect: "0: the colours part into clear patches; 1: they mix.",
        needs: Needs::Middle,
        get: |s| adhesion(s, F, M),
        set: |s, x| set_adhesion(s, F, M, x),
        ..NUMBER
    },
    Parameter {
        key: "bm",
        label: "Adhesion between {B} and {M}",
        symbol: "α_BM",
        range: [0.0, 1.0],
        step: 0.05,
        effect: "0: the colours part into clear patches; 1: they mix.",
        needs: Needs::Middle,
        get: |s| adhesion(s, B, M),
        set: |s, x| set_adhesion(s, B, M, x),
        ..NUMBER
    },
    Parameter {
        key: "mfb",
        label: "Children of {F} that turn {B}",
        unit: "share",
        range: [0.0, 1.0],
        step: 0.005,
        effect: "Mutation: the chance that a {F} cell's child is {B}.",
        get: |s| s.recipe.mutation[F as usize][B as usize],
        set: |s, x| set_mutation(s, F, B, x),
        ..NUMBER
    },
    Parameter {
        key: "mbf",
        label: "Children of {B} that turn {F}",
        unit: "share",
        range: [0.0, 1.0],
        step: 0.005,
        effect: "Mutation: the chance that a {B} cell's child is {F}.",
        get: |s| s.recipe.mutation[B as usize][F as usize],
        set: |s, x| set_mutation(s, B, F, x),
        ..NUMBER
    },
    Parameter {
        key: "mfm",
        label: "Children of {F} that turn {M}",
        unit: "share",
        range: [0.0, 1.0],
        step: 0.005,
        effect: "Mutation: the chance that a {F} cell's child is {M}.",
        needs: Needs::Middle,
        get: |s| s.recipe.mutation[F as usize][M as usize],
        set: |s, x| set_mutation(s, F, M, x),
        ..NUMBER
    },
    Parameter {
        key: "mbm",
        label: "Children of {B} that turn {M}",
        unit: "share",
        range: [0.0, 1.0],
        step: 0.005,
        effect: "Mutation: the chance that a {B} cell's child is {M}.",
        needs: Needs::Middle,
        get: |s| s.recipe.mutation[B as usize][M as usize],
        set: |s, x| set_mutation(s, B, M, x),
        ..NUMBER
    },
    Parameter {
        key: "mmf",
        label: "Children of {M} that turn {F}",
        unit: "share",
        range: [0.0, 1.0],
        step: 0.005,
        effect: "Mutation: the chance that a {M} cell's child is {F}.",
        needs: Needs::Middle,
        get: |s| s.recipe.mutation[M as usize][F as usize],
        set: |s, x| set_mutation(s, M, F, x),
        ..NUMBER
    },
    Parameter {
        key: "mmb",
        label: "Children of {M} that turn {B}",
        unit: "share",
        range: [0.0, 1.0],
        step: 0.005,
        effect: "Mutation: the chance that a {M} cell's child is {B}.",
        needs: Needs::Middle,
        get: |s| s.recipe.mutation[M as usize][B as usize],
        set: |s, x| set_mutation(s, M, B, x),
        ..NUMBER
    },
    Parameter {
        key: "rs",
        label: "Reach of the push",
        symbol: "ω_r",
        unit: "× spacing",
        range: [0.1, 6.0],
        step: 0.1,
        effect: "How far cells feel each other: a wider reach makes larger, rounder patches.",
        get: |s| widen(s.recipe.radius_scale),
        set: |s, x| s.recipe.radius_scale = x as f32,
        ..NUMBER
    },
    Parameter {
        key: "rep",
        label: "Strength of the push",
        range: [0.0, 1.0],
        step: 0.005,
        effect: "How far one event moves a cell; too strong and the cells never rest.",
        get: |s| widen(s.recipe.repulsion),
        set: |s, x| s.recipe.repulsion = x as f32,
        ..NUMBER
    },
    Parameter {
        key: "an",
        label: "Pull of the direction field",
        range: [0.0, 1.0],
        step: 0.05,
        effect: "0: cells go where they are pushed; 1: along the field, as fast.",
        needs: Needs::Field,
        get: |s| widen(s.recipe.anisotropy),
        set: |s, x| s.recipe.anisotropy = x as f32,
        ..NUMBER
    },
    Parameter {
        key: "ri",
        label: "Events before day 0",
        unit: "events",
        range: [0.0, 200.0],
        step: 1.0,
        effect: "More events spread the first cells more evenly.",
        get: |s| f64::from(s.recipe.initial_relaxations),
        set: |s, x| s.recipe.initial_relaxations = x as u32,
        ..NUMBER
    },
    Parameter {
        key: "rd",
        label: "Events in a day",
        unit: "events",
        range: [0.0, 60.0],
        step: 1.0,
        effect: "More events give the cells more time to part between divisions.",
        get: |s| f64::from(s.recipe.relaxations_per_day),
        set: |s, x| s.recipe.relaxations_per_day = x as u32,
        ..NUMBER
    },
    Parameter {
        key: "days",
        label: "Days to grow",
        unit: "days",
        range: [1.0, 60.0],
        step: 1.0,
        effect: "The last day of the time line. Growth ends before it at {most} cells, this plant's limit.",
        get: |s| f64::from(s.recipe.days),
        set: |s, x| s.recipe.days = x as u32,
        ..NUMBER
    },
    Parameter {
        key: "bo",
        label: "Cell borders",
        range: [0.0, 1.0],
        step: 0.02,
        effect: "How much darker the borders are than the cells.",
        regrows: false,
        get: |s| widen(s.look.border),
        set: |s, x| s.look.border = x as f32,
        ..NUMBER
    },
    Parameter {
        key: "va",
        label: "Variation of the colours",
        range: [0.0, 1.0],
        step: 0.02,
        effect: "How much the lightness of cells of one colour varies.",
        regrows: false,
        get: |s| widen(s.look.variation),
        set: |s, x| s.look.variation = x as f32,
        ..NUMBER
    },
    colour::OF_F,
    colour::OF_B,
    colour::OF_M,
];

/// An f32 as the short decimal that it was written as.
pub fn widen(x: f32) -> f64 {
    short(f64::from(x))
}

/// A number without the last digits, which come from rounding: links stay short.
fn short(x: f64) -> f64 {
    (x * 1e6).round() / 1e6
}

fn adhesion(scene: &Scene, a: CellType, b: CellType) -> f64 {
    widen(scene.recipe.adhesion[a as usize][b as usize])
}

fn set_adhesion(scene: &mut Scene, a: CellType, b: CellType, value: f64) {
    scene.recipe.adhesion[a as usize][b as usize] = value as f32;
    scene.recipe.adhesion[b as usize][a as usize] = value as f32;
}

/// The third type keeps what it can, and the parent's own takes what the others leave.
fn set_mutation(scene: &mut Scene, parent: CellType, child: CellType, share: f64) {
    let row = &mut scene.recipe.mutation[parent as usize];
    let third = 3 - parent as usize - child as usize;
    row[third] = beside(share, row[third]);
    row[child as usize] = share;
    // In the order of the types, so that it is the same to the last bit whichever was set last.
    row[parent as usize] = 0.0;
    row[parent as usize] = row.iter().fold(1.0, |left, share| left - share).max(0.0);
}

/// Another share beside one that is set: less if both are more than 1 together, by more than what `short`
/// may have left too much.
fn beside(share: f64, other: f64) -> f64 {
    if share + other < 1.0 + 6e-7 { other } else { short(1.0 - share) }
}
