//! How the bodies of the catalogue are made: rules that grow the control meshes under `meshes/`.
//!
//! The program itself only reads those files. After a change of a rule,
//! `cargo test rewrite_meshes -- --ignored` writes them anew.

mod cactus;
mod croton;
mod mushroom;
mod sketch;
mod watermelon;

use crate::surface::PolygonMesh;

type Rule = fn() -> PolygonMesh;

/// The name of each file under `meshes/` and the rule that makes it.
const RULES: [(&str, Rule); 4] = [
    ("croton", croton::grow),
    ("cactus", cactus::grow),
    ("watermelon", watermelon::grow),
    ("mushroom", mushroom::grow),
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
        assert!(committed.len() < 60_000, "{name}.obj has {} bytes", committed.len());
    }
}

#[test]
#[ignore = "writes meshes/*.obj"]
fn rewrite_meshes() {
    for (name, grow) in RULES {
        std::fs::write(path(name), text(name, &grow())).unwrap();
    }
}
