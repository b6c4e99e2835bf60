//! The brushes that a plant has, and the one that is chosen on the card.

use super::subject;
use crate::browser::dom::{set_flag, set_text, within};
use crate::import::{Brush, MOST_RADIUS, Stroke, Way};
use crate::plants::Plant;
use crate::tissue::{CellType, Scaled};
use web_sys::{Element, HtmlInputElement, HtmlSelectElement};

/// Steps of the slider for the radius in the size of the plant, squared: small brushes are set finely.
const RADIUS_STEPS: f32 = 80.0;

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

/// The colour in which a brush draws: that of its type, or ink.
pub fn colour_of(brush: Brush) -> String {
    let [r, g, b] = match brush {
        Brush::Put(kind) | Brush::Only(kind) => subject::wished().look.cells[kind as usize],
        Brush::Erase | Brush::Never(_) => [1.0; 3],
        Brush::Lead => [0.1, 0.1, 0.35],
        _ => [0.75, 0.3, 0.2],
    }
    .map(|part| (part * 255.0) as u8);
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// Shows on the card what the chosen brush needs, for a plant of a size.
pub fn agree(card: &Element, size_cm: f32) {
    let (word, way) = (choice(card, ".brush"), choice(card, ".way"));
    let is_scale = matches!(&*word, "r" | "p" | "df" | "db" | "dm");
    set_flag(&within::<Element>(card, ".how-much"), "hidden", !is_scale);
    set_flag(&within::<Element>(card, ".of-radius"), "hidden", way == "p");
    if size_cm > 0.0 {
        let told = format!("{} cm", f64::from(radius(card, size_cm)) / 1000.0);
        set_text(&within::<Element>(card, ".radius-told"), &told);
    }
}

/// A stroke of the chosen brush, without points yet, and whether it is to be a straight line; none if it is not said
/// how much.
pub fn chosen(card: &Element, size_cm: f32) -> Option<(Stroke, bool)> {
    let input = |selector| within::<HtmlInputElement>(card, selector);
    let (word, way) = (choice(card, ".brush"), choice(card, ".way"));
    let with_percent = format!("{word}{}", input(".percent").value());
    let stroke = Stroke {
        brush: Brush::of_word(&word).or_else(|| Brush::of_word(&with_percent))?,
        radius: radius(card, size_cm),
        way: match &*way {
            "r" => Way::Around,
            "a" => Way::Along,
            "p" => Way::Part,
            _ => Way::Free,
        },
        is_mirrored: input(".mirror").checked(),
        points: Vec::new(),
    };
    Some((stroke, way == "l"))
}

/// In thousandths of a centimetre, by the size of the plant.
fn radius(card: &Element, size_cm: f32) -> u32 {
    let step = within::<HtmlInputElement>(card, ".radius").value_as_number() as f32 / RADIUS_STEPS;
    // In steps that are read well.
    let hundredths = (step * step * size_cm * 100.0).round().max(2.0);
    let fine = if hundredths < 20.0 { 1.0 } else { 5.0 };
    ((hundredths / fine).round() * fine * 10.0).min(MOST_RADIUS as f32) as u32
}

fn choice(card: &Element, selector: &str) -> String {
    within::<HtmlSelectElement>(card, selector).value()
}
