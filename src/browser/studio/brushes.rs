//! The brushes that a plant has.

use crate::import::Brush;
use crate::plants::Plant;
use crate::tissue::{CellType, Scaled};

/// What can be painted on a plant: the words of brushes, those that scale without how much, and what they do.
pub fn brushes_of(plant: &Plant) -> Vec<(String, String)> {
    let named = |kind: &CellType| !plant.colour_names[*kind as usize].is_empty();
    let types: Vec<CellType> = CellType::ALL.into_iter().filter(named).collect();
    let name = |kind: CellType| plant.colour_names[kind as usize];
    let mut all = Vec::new();
    let puts =
        types.iter().map(|&kind| (Brush::Put(kind), format!("First cells: {} here", name(kind))));
    let first = types.iter().filter(|kind| **kind != CellType::Background);
    let others = first.flat_map(|&kind| {
        [
            (Brush::Only(kind), format!("First cells: {} here alone", name(kind))),
            (Brush::Never(kind), format!("First cells: no {} here", name(kind))),
        ]
    });
    all.extend(puts.chain(others).map(|(brush, told)| (brush.word(), told)));
    let scale = |number| Brush::Scale(number, 0).word().trim_end_matches('0').to_string();
    all.push((scale(Scaled::RadiusScale), "Reach of repulsion".to_string()));
    all.push((scale(Scaled::Repulsion), "Strength of repulsion".to_string()));
    for &kind in &types {
        let told = format!("Days between divisions: {}", name(kind));
        all.push((scale(Scaled::DivisionDays(kind)), told));
    }
    all.extend(
        [
            (Brush::Lead, "Lead the cells this way"),
            (Brush::Bare, "No pattern"),
            (Brush::Erase, "Erase strokes"),
        ]
        .map(|(brush, told)| (brush.word(), told.to_string())),
    );
    all
}
