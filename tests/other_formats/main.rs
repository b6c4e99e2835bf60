//! Bodies in PLY and GLB files: the cells are those of the same body as OBJ, whoever wrote the file.

mod glb;
mod ply;

use clonal_mosaic::plants;
use clonal_mosaic::surface::{Brought, Face, Mesh, NO_TWIN, PolygonMesh};
use clonal_mosaic::tissue::{Growth, Progress, Recipe};
use serde_json::Value;
use std::path::PathBuf;
use std::process::Command;
use std::sync::Arc;

/// A ball of triangles.
fn ball() -> PolygonMesh {
    let corner =
        "v 4 4 4\nv 4.1 -4 -4\nv -4 4.3 -4\nv -4 -4 4.7\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n";
    let mut mesh = PolygonMesh::parse(corner).unwrap().refined(3);
    mesh.faces = mesh.faces.iter().flat_map(triangles).collect();
    mesh
}

/// The triangles of a polygon that is convex.
fn triangles(face: &Face) -> Vec<Face> {
    let corners = face.vertices[1..].array_windows();
    let triangle = |[b, c]: &[u32; 2]| vec![face.vertices[0], *b, *c];
    corners.map(|pair| Face { vertices: triangle(pair), group: face.group }).collect()
}

fn read(bytes: &[u8]) -> Brought {
    let brought = Brought::read(bytes).unwrap();
    brought.body.surface.check().unwrap();
    brought
}

fn refusal(bytes: &[u8]) -> String {
    Brought::read(bytes).map(drop).unwrap_err().to_string()
}

fn fingerprint(bytes: &[u8]) -> String {
    let recipe = r#"{"initial_cells":90, "days":2, "division_days":{"F":2,"B":3}}"#;
    let mesh = Arc::new(read(bytes).body.surface);
    let mut growth = Growth::new(mesh, Recipe::from_json(recipe).unwrap(), &[], 1).unwrap();
    while !matches!(growth.step(), Progress::Done | Progress::Full) {}
    growth.diary.fingerprint(2)
}

fn rim_edges(mesh: &Mesh) -> usize {
    mesh.twins.iter().filter(|&&twin| twin == NO_TWIN).count()
}

fn mosaic(arguments: &[&str]) -> Value {
    let output = Command::new(env!("CARGO_BIN_EXE_mosaic")).args(arguments).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap_or_default()
}

#[test]
fn what_was_taken_away_is_a_body_again() {
    let path = |name: &str| {
        PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name).to_str().unwrap().to_string()
    };
    let plant = plants::find("watermelon").unwrap();
    let body = plant.embedded_body();
    // Its bare parts are bodies, too.
    let mut bare = PolygonMesh::default();
    for ornament in &body.ornaments {
        let first = bare.positions.len() as u32;
        bare.positions.extend(&ornament.positions);
        let face = |t: &[u32; 3]| Face { vertices: t.map(|v| v + first).to_vec(), group: 0 };
        bare.faces.extend(ornament.triangles.iter().map(face));
    }
    let bare = read(bare.to_obj().as_bytes()).body.surface;
    let [skin, bare] = [&body.surface, &bare];
    let parts = skin.part_count() + bare.part_count();

    for (option, file, unit_cm) in [("--glb", "again.glb", 100.0), ("--ply", "again.ply", 1.0)] {
        let file = path(file);
        mosaic(&["export", "--preset", "watermelon", "--day", "1", option, &file]);
        let recipe = path("again.json");
        std::fs::write(&recipe, r#"{"initial_cells":60, "days":1}"#).unwrap();
        let grown = mosaic(&["grow", "--json", "--recipe", &recipe, "--mesh", &file]);
        let again = &grown["body"];
        assert_eq!(again["parts"], parts, "{option}");
        assert_eq!(again["rim_edges"], rim_edges(skin) + rim_edges(bare), "{option}");
        let area = again["area_cm2"].as_f64().unwrap() / f64::from(skin.area + bare.area);
        assert!((area - 1.0).abs() < 1e-4, "{area}");
        assert_eq!(again["unit_cm"], unit_cm);
        assert!(again["joined_edges"].as_u64() > Some(100), "borders of cells are one again");
    }
}
