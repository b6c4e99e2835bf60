//! How the bodies of the catalogue are made: rules that grow the control meshes under `meshes/`.
//!
//! The program itself only reads those files. After a change of a rule,
//! `cargo test rewrite_meshes -- --ignored` writes them anew.

mod begonia;
mod blade;
mod bloom;
mod cactus;
mod coleus;
mod croton;
mod ficus;
mod fittonia;
mod goeppertia;
mod lily;
mod lotus;
mod lungwort;
mod mushroom;
mod palmate;
mod philodendron;
mod sansevieria;
mod sketch;
mod square_watermelon;
mod tiger_lily;
mod watermelon;
mod winter_squash;

use crate::shapes::branching::{Census, Tree};
use crate::shapes::crossing::pierces;
use crate::shapes::flower::cut::cut_share;
use crate::surface::{Mesh, PolygonMesh};
use glam::Vec3;
use std::collections::BTreeSet;

type Rule = fn() -> PolygonMesh;

/// The name of each file under `meshes/` and the rule that makes it.
const RULES: [(&str, Rule); 19] = [
    ("croton", croton::grow),
    ("cactus", cactus::grow),
    ("watermelon", watermelon::grow),
    ("mushroom", mushroom::grow),
    ("philodendron", philodendron::grow),
    ("square_watermelon", square_watermelon::grow),
    ("long_watermelon", watermelon::grow_long),
    ("sansevieria", sansevieria::grow),
    ("begonia", begonia::grow),
    ("fittonia", fittonia::grow),
    ("palmate", palmate::grow),
    ("lungwort", lungwort::grow),
    ("goeppertia", goeppertia::grow),
    ("winter_squash", winter_squash::grow),
    ("coleus", coleus::grow),
    ("lily", lily::grow),
    ("lotus", lotus::grow),
    ("tiger_lily", tiger_lily::grow),
    ("ficus", ficus::grow),
];

fn path(name: &str) -> std::path::PathBuf {
    std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("meshes").join(format!("{name}.obj"))
}

fn text(name: &str, mesh: &PolygonMesh) -> String {
    format!("# {name}: control mesh in cm, grown by src/plants/bodies/{name}.rs\n{}", mesh.to_obj())
}

#[test]
fn committed_meshes_are_what_the_rules_make() {
    for (name, grow) in RULES {
        let committed = std::fs::read_to_string(path(name)).unwrap();
        let grown = text(name, &grow());
        assert!(committed == grown, "{name}.obj: run `cargo test rewrite_meshes -- --ignored`");
        assert!(committed.len() < 90_000, "{name}.obj has {} bytes", committed.len());
    }
}

#[test]
#[ignore = "writes meshes/*.obj"]
fn rewrite_meshes() {
    for (name, grow) in RULES {
        std::fs::write(path(name), text(name, &grow())).unwrap();
    }
}

#[test]
fn leaves_do_not_cut_through_each_other() {
    let leafy = ["croton", "philodendron", "sansevieria", "begonia", "fittonia", "palmate"];
    let mut wrong = Vec::new();
    for key in leafy.into_iter().chain(["lungwort", "goeppertia", "coleus"]) {
        let cuts = cuts(&crate::plants::find(key).unwrap().embedded_body().surface);
        if !cuts.is_empty() {
            wrong.push(format!("{key}, pairs of leaves: {cuts:?}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_weeping_fig_has_a_leaf_at_each_end_of_the_tree_of_its_matrix() {
    let tree = ficus::tree();
    tree.check().unwrap();
    let leaves = Census::new(&tree).leaves as usize;
    let surface = crate::plants::find("ficus").unwrap().embedded_body().surface;
    assert_eq!(surface.part_count(), leaves);
    assert!((200..2000).contains(&leaves), "{leaves}");
    // Of five hundred such trees the matrix is the one that it was drawn from.
    let numbers = ficus::numbers();
    let matrix = numbers.matrix.ramification().unwrap();
    let mut census = Census::default();
    (0..500).for_each(|seed| census.add(&Tree::draw(&matrix, numbers.order, seed).unwrap()));
    for (k, found) in (2..).zip(census.matrix()) {
        for (found, exact) in found.iter().zip(matrix.row(k)) {
            assert!((found - exact).abs() < 0.05, "order {k}: {found}, not {exact}");
        }
    }
    // Leaves of one fork touch at its foot, and hardly elsewhere.
    let triangles = 0..surface.triangles.len() as u32;
    let of_leaf = |t: u32| (surface.corners(t), surface.parts[t as usize]);
    let share = cut_share(triangles.map(of_leaf).collect());
    assert!(share < 0.09, "{share} of the area is cut");
}

/// The pairs of parts, from 1, that go through each other.
fn cuts(mesh: &Mesh) -> BTreeSet<(u32, u32)> {
    let boxes: Vec<(Vec3, Vec3)> = (0..mesh.triangles.len() as u32)
        .map(|t| {
            let [a, b, c] = mesh.corners(t);
            (a.min(b).min(c), a.max(b).max(c))
        })
        .collect();
    let apart = |s: usize, t: usize| {
        boxes[s].0.cmpgt(boxes[t].1).any() || boxes[t].0.cmpgt(boxes[s].1).any()
    };
    let mut cuts = BTreeSet::new();
    for s in 0..boxes.len() {
        for t in 0..boxes.len() {
            if mesh.parts[s] == mesh.parts[t] || apart(s, t) {
                continue;
            }
            let (of_s, of_t) = (mesh.corners(s as u32), mesh.corners(t as u32));
            if (0..3).any(|k| pierces(of_s[k], of_s[(k + 1) % 3], of_t)) {
                cuts.insert((mesh.parts[s] + 1, mesh.parts[t] + 1));
            }
        }
    }
    cuts
}

#[test]
fn petals_do_not_cut_through_each_other_on_any_day() {
    let mut wrong = Vec::new();
    for key in ["lily", "lotus", "tiger-lily"] {
        let plant = crate::plants::find(key).unwrap();
        let rest = plant.embedded_body().surface;
        for day in 0..=plant.recipe.days {
            let mesh = rest.on(day);
            let triangles = (0..mesh.triangles.len() as u32)
                .map(|t| (mesh.corners(t), mesh.parts[t as usize]))
                .collect();
            let cut = cut_share(triangles);
            if cut >= 0.005 {
                wrong.push(format!("{key}, day {day}: {:.2} %", 100.0 * cut));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
