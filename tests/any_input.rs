//! Whatever a visitor brings is read, or refused in words: random files and random small meshes.

use clonal_mosaic::surface::{Brought, PolygonMesh};
use clonal_mosaic::tissue::{Growth, Progress, Recipe};
use proptest::collection::vec;
use proptest::prelude::*;
use std::fmt::Write;
use std::sync::Arc;

/// A short line of an OBJ file, nearly right.
fn line() -> impl Strategy<Value = String> {
    let keyword =
        prop::sample::select(vec!["v", "v", "vt", "f", "f", "fo", "g", "usemtl", "l", "#", ""]);
    let word = prop::sample::select(vec![
        "0",
        "1",
        "2",
        "3",
        "-1",
        "-2",
        "1/1",
        "2//",
        "3/9/1",
        "1.5",
        "1e9",
        "-1e-9",
        "nan",
        "inf",
        "1,5",
        "bare:a",
        "#",
        "\\",
        "\\\n",
        "\r",
        "\u{feff}",
        "99999999999999999999",
        "é",
    ]);
    (keyword, vec(word, 0..6))
        .prop_map(|(keyword, words)| format!("{keyword} {}\n", words.join(" ")))
}

/// Corners on a small grid, so that many fall together and many are on a line, and faces of any of them.
fn small_mesh() -> impl Strategy<Value = String> {
    let coordinate = prop_oneof![
        8 => (-2..=2i32).prop_map(f64::from),
        1 => -1.0..1.0f64,
        1 => prop::sample::select(vec![1e-5, 1e-9, 1.00000001, 1e3]),
    ];
    let vertices = vec([coordinate.clone(), coordinate.clone(), coordinate], 3..12);
    let faces = vec(vec(0..1000usize, 3..7), 1..16);
    (vertices, faces, any::<bool>()).prop_map(|(vertices, faces, is_far)| {
        let mut text = String::new();
        let far = if is_far { 1e6 } else { 0.0 };
        for [x, y, z] in &vertices {
            let _ = writeln!(text, "v {} {y} {z}", x + far);
        }
        for face in faces {
            let corners = face.iter().map(|corner| (corner % vertices.len() + 1).to_string());
            let _ = writeln!(text, "f {}", corners.collect::<Vec<_>>().join(" "));
        }
        text
    })
}

/// Grows a few cells for two days if the bytes are a body.
fn grow_on(bytes: &[u8]) {
    let brought = match Brought::read(bytes) {
        Ok(brought) => brought,
        Err(error) => {
            let told = error.to_string();
            assert!(told.len() < 300 && !told.contains(char::is_control), "{told:?}");
            return;
        }
    };
    let mesh = brought.body.surface;
    mesh.check().unwrap();
    assert!(mesh.area.is_normal());
    let recipe = r#"{"initial_cells":12, "days":2, "division_days":{"F":1.5,"B":2}, "relaxations_per_day":3}"#;
    let recipe = Recipe::from_json(recipe).unwrap();
    let mut growth = Growth::new(Arc::new(mesh), recipe, &[], 1).unwrap();
    while !matches!(growth.step(), Progress::Done | Progress::Full) {}
    for place in &growth.diary.days[2].places {
        let third = 1.0 - place.b1 - place.b2;
        assert!([place.b1, place.b2].iter().all(|b| (0.0..=1.0).contains(b)) && third >= -1e-6);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_bytes_are_a_body_or_an_error(bytes in vec(any::<u8>(), 0..400)) {
        grow_on(&bytes);
    }

    #[test]
    fn any_lines_are_a_body_or_an_error(lines in vec(line(), 0..40)) {
        grow_on(lines.concat().as_bytes());
        let _ = PolygonMesh::parse(&lines.concat());
    }

    #[test]
    fn any_small_mesh_grows(text in small_mesh()) {
        grow_on(text.as_bytes());
    }
}
