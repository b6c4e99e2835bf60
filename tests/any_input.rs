//! Whatever a visitor brings is read, or refused in words: random files, random small meshes, random lessons.

use clonal_mosaic::play::lesson;
use clonal_mosaic::surface::{Brought, PolygonMesh};
use clonal_mosaic::tissue::{Growth, Progress, Recipe};
use proptest::collection::vec;
use proptest::prelude::*;
use std::fmt::Write;
use std::path::PathBuf;
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

/// A PLY or GLB file with a few other bytes in it, and perhaps without its end.
fn nearly_right_file() -> impl Strategy<Value = Vec<u8>> {
    let files =
        ["text.ply", "binary_little_endian.ply", "binary_big_endian.ply", "tetrahedron.glb"];
    let seeds = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("fuzz/seeds/body");
    let files = files.map(|name| std::fs::read(seeds.join(name)).unwrap()).to_vec();
    let byte = prop_oneof![
        any::<u8>(),
        prop::sample::select(b"0123456789-.,:{}[]\"\n ".to_vec()),
        prop::sample::select(vec![0, 1, 2, 3, 4, 127, 128, 255]),
    ];
    let changes = vec((any::<prop::sample::Index>(), byte), 0..6);
    let end = prop::option::weighted(0.1, any::<prop::sample::Index>());
    (prop::sample::select(files), changes, end).prop_map(|(mut file, changes, end)| {
        for (at, byte) in changes {
            let at = at.index(file.len());
            file[at] = byte;
        }
        let length = file.len();
        file.truncate(end.map_or(length, |end| end.index(length)));
        file
    })
}

/// A line of a lesson, nearly right.
fn line_of_lesson() -> impl Strategy<Value = String> {
    let begin = prop::sample::select(vec![
        "[look]",
        "[play]",
        "[predict]",
        "[grow]",
        "[explain]",
        "[",
        "title:",
        "age:",
        "minutes:",
        "link:",
        "ask:",
        "choice:",
        "right:",
        "bar:",
        "number:",
        "measure:",
        "individuals:",
        "expected:",
        "student:",
        "reply:",
        "  ",
        "\t",
        "",
        "#",
        "é:",
    ]);
    let end = prop::sample::select(vec![
        "A title",
        "croton?v=1&d=3",
        "#~",
        "rose",
        "12",
        "-1",
        "share F",
        "spots",
        "",
        "\r",
        "]",
        "\u{feff}",
        "\u{202e}",
        "99999999999999999999",
    ]);
    (begin, end).prop_map(|(begin, end)| format!("{begin} {end}\n"))
}

/// Reads a lesson, and goes once through what its view does with it.
fn go_through(text: &str) {
    match lesson::read(text) {
        Ok(lesson) => {
            assert!(!lesson.steps.is_empty());
            let mut answers = lesson::Answers::default();
            for step in 0..lesson.steps.len() {
                answers.say(step, lesson::Said::Choice(9));
                answers.grow(step, lesson::Grown { values: vec![f64::NAN, -1.0], usual: None });
                let _ = answers.beside(&lesson, step);
                let _ = lesson::Answers::measured(&lesson, step);
            }
            let _ = (answers.to_text(&lesson), answers.to_csv(&lesson));
            let _ = clonal_mosaic::export::worksheet(&lesson, &answers, "");
        }
        Err(error) => {
            let told = error.to_string();
            assert!(told.len() < 400 && !told.contains(char::is_control), "{told:?}");
            assert!(error.line <= text.lines().count().max(1), "{told}");
        }
    }
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

    #[test]
    fn any_file_with_wrong_bytes_is_a_body_or_an_error(bytes in nearly_right_file()) {
        grow_on(&bytes);
    }

    #[test]
    fn any_text_is_a_lesson_or_an_error(text in "\\PC*|[\\s\\[\\]:a-z]{0,200}") {
        go_through(&text);
        go_through(&format!("title: T\n[look] A\n{text}"));
    }

    #[test]
    fn any_lines_are_a_lesson_or_an_error(lines in vec(line_of_lesson(), 0..30)) {
        go_through(&lines.concat());
        go_through(&format!("title: T\n{}", lines.concat()));
    }
}
