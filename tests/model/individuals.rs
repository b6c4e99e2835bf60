//! Individuals have control images of their own under the second rules.

use clonal_mosaic::plants::{self, Plant, Rules};
use clonal_mosaic::surface::{Mesh, Place};
use clonal_mosaic::tissue::CellType::{self, Foreground, Middle};
use clonal_mosaic::tissue::{Growth, Progress, Recipe};
use std::sync::Arc;

/// What the images of an individual leave at some places of a cell that is drawn as F.
fn types(plant: &Plant, individual: u32, mesh: &Mesh, places: &[Place]) -> Vec<CellType> {
    let controls = plant.controls(individual);
    let first_type = |&place: &Place| {
        controls.iter().fold(Foreground, |kind, control| control.first_type(mesh, place, kind))
    };
    places.iter().map(first_type).collect()
}

/// By how much two patterns differ, as a share of what two without anything in common would with as much of
/// the type: `p (1 - q) + q (1 - p)`.
fn difference(one: &[CellType], other: &[CellType], of: CellType) -> f64 {
    let count = one.len() as f64;
    let share =
        |types: &[CellType]| types.iter().filter(|&&kind| kind == of).count() as f64 / count;
    let (p, q) = (share(one), share(other));
    let unlike = one.iter().zip(other).filter(|(a, b)| (**a == of) != (**b == of)).count() as f64;
    unlike / count / (p * (1.0 - q) + q * (1.0 - p))
}

/// The places of the first cells of an individual, as they were sown.
fn sown(plant: &Plant, mesh: &Arc<Mesh>) -> Vec<Place> {
    let recipe =
        Recipe { initial_relaxations: 0, days: 0, initial_cells: 5_000, ..plant.recipe.clone() };
    let mut growth = Growth::new(mesh.clone(), recipe, &[], 1).unwrap();
    while growth.step() != Progress::Done {}
    growth.diary.days[0].places.clone()
}

#[test]
fn images_of_two_individuals_differ_nearly_as_much_as_if_they_had_nothing_in_common() {
    let mut alike = Vec::new();
    for key in [
        "watermelon",
        "square-watermelon",
        "long-watermelon",
        "banded-cactus",
        "sansevieria",
        "philodendron",
        "philodendron-shoot",
    ] {
        let plant = plants::find(key).unwrap();
        let mesh = Arc::new(plant.embedded_body().surface);
        let mut places = sown(plant, &mesh);
        let of = if key == "sansevieria" { Middle } else { Foreground };
        if of == Middle {
            // The margins are where they are.
            let kinds = types(plant, 1, &mesh, &places);
            let mut kinds = kinds.iter();
            places.retain(|_| *kinds.next().unwrap() != Foreground);
        }
        let all: Vec<_> = (1..=6).map(|n| types(plant, n, &mesh, &places)).collect();
        let mut pairs = Vec::new();
        for (k, one) in all.iter().enumerate() {
            pairs.extend(all[..k].iter().map(|other| difference(one, other, of)));
        }
        let mean = pairs.iter().sum::<f64>() / pairs.len() as f64;
        let near = pairs.iter().filter(|&&d| d < 2.0 / 3.0).count();
        let said = format!("{key}: {mean:.2} in the mean, {near} of {} pairs alike", pairs.len());
        println!("{said}");
        // Where an image is of a few large things, the same chance may put two of them in like places.
        if mean < 0.85 || near > 3 {
            alike.push(said);
        }
        // Under the first rules all have the same.
        let first = plant.under(Rules::First as u32).unwrap();
        assert_eq!(types(first, 1, &mesh, &places), types(first, 2, &mesh, &places), "{key}");
    }
    assert_eq!(alike, [""; 0]);
}
