//! The command line with a mesh of the caller's own: what was read is told, and what was mended.

use serde_json::Value;
use std::path::PathBuf;
use std::process::Command;

const SMALL: &str = r#"{"initial_cells":60, "days":2, "division_days":{"F":4,"B":6}}"#;

/// A tetrahedron of side 2 times the square root of 2, in the place of its corner at 1, 1, 1.
fn tetrahedron(first: &str) -> String {
    format!("v {first}\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n")
}

/// Two halves of a square that share no vertices, the first of them twice.
const HALVES: &str =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 4 5 6\nf 3 2 1\n";

fn path(name: &str) -> String {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    path.to_str().unwrap().to_string()
}

/// Exit status, standard output and standard error of growing on a mesh of these bytes.
fn grow(name: &str, mesh: &[u8], more: &[&str]) -> (Option<i32>, String, String) {
    let (recipe, file) = (path(&format!("{name}.json")), path(&format!("{name}.obj")));
    std::fs::write(&recipe, SMALL).unwrap();
    std::fs::write(&file, mesh).unwrap();
    let arguments = ["grow", "--recipe", &recipe, "--mesh", &file];
    let output = Command::new(env!("CARGO_BIN_EXE_mosaic"))
        .args([&arguments[..], more].concat())
        .output()
        .unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code(), text(output.stdout), text(output.stderr))
}

#[test]
fn what_was_read_is_told_in_words() {
    let (code, out, complaint) = grow("closed", tetrahedron("1 1 1").as_bytes(), &[]);
    assert_eq!((code, &*complaint), (Some(0), ""));
    assert_eq!(out.lines().next(), Some("body: 4 triangles in 1 part, closed, 13.856407 cm2"));
    assert!(out.lines().nth(1).unwrap().starts_with("day   0"), "{out}");

    let (code, out, complaint) = grow("halves", HALVES.as_bytes(), &[]);
    assert_eq!(code, Some(0));
    assert_eq!(out.lines().next(), Some("body: 2 triangles in 1 part, 4 rim edges, 1 cm2"));
    assert_eq!(
        complaint,
        "mosaic: 1 pair of rim edges was joined: its ends are the same\n\
         mosaic: 1 triangle was left out: it has no area or stands twice\n"
    );
}

#[test]
fn what_was_read_is_told_in_json() {
    let (_, out, complaint) = grow("json-halves", HALVES.as_bytes(), &["--json"]);
    assert_eq!(complaint.lines().count(), 2, "{complaint}");
    let body = &serde_json::from_str::<Value>(&out).unwrap()["body"];
    for (key, number) in [
        ("triangles", 2.0),
        ("parts", 1.0),
        ("rim_edges", 4.0),
        ("area_cm2", 1.0),
        ("joined_edges", 1.0),
        ("left_out_triangles", 1.0),
        ("caught_walks", 0.0),
    ] {
        assert_eq!(body[key].as_f64(), Some(number), "{key}");
    }
}

#[test]
fn cells_of_a_body_far_from_its_origin_lie_on_it() {
    let far = "v 1000001 5000001 1\nv 1000001 4999999 -1\nv 999999 5000001 -1\nv 999999 4999999 1\n\
               f 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n";
    let cells = |name: &str, mesh: &str| {
        let table = path(&format!("{name}.csv"));
        let (code, ..) = grow(name, mesh.as_bytes(), &["--cells", &table]);
        assert_eq!(code, Some(0));
        let text = std::fs::read_to_string(table).unwrap();
        let place = |row: &str| -> Vec<f64> {
            row.split(',').skip(6).take(3).map(|x| x.parse().unwrap()).collect()
        };
        text.lines().skip(1).map(place).collect::<Vec<_>>()
    };
    let (near, far) = (cells("near", &tetrahedron("1 1 1")), cells("far", far));
    assert!(near.len() >= 60 && near.len() == far.len());
    for (near, far) in near.iter().zip(&far) {
        let moved = [near[0] + 1e6, near[1] + 5e6, near[2]];
        assert!(moved.iter().zip(far).all(|(a, b)| (a - b).abs() < 1e-6), "{moved:?} and {far:?}");
    }
}

#[test]
fn what_is_not_needed_may_be_wrong() {
    let tetrahedron = tetrahedron("1 1 1 # a\u{301}");
    let odd =
        [b"\xef\xbb\xbf# Andr\xe9 \\\n", tetrahedron.as_bytes(), b"vt nan\nf 1 2\nv nan nan nan\n"];
    let (code, out, complaint) = grow("odd", &odd.concat(), &[]);
    assert_eq!((code, &*complaint), (Some(0), ""));
    assert!(out.starts_with("body: 4 triangles in 1 part, closed, 13.856407 cm2\n"), "{out}");
}

#[test]
fn no_file_reaches_the_terminal_as_it_is() {
    let long = format!("v 0 0 {}", "9x".repeat(500_000));
    for (name, mesh, word) in [
        ("escape", b"v 0 0 \x1b[31mred\nf 1 1 1\n".to_vec(), "line 1"),
        ("long", long.into_bytes(), "\u{2026}"),
        ("gzip", b"\x1f\x8b\x08\x00\x00\x00\x00\x00".to_vec(), "gzip"),
        ("utf-16", b"\xff\xfev\x00 \x00".to_vec(), "UTF-16"),
        ("ply", b"ply\nformat ascii \x1b[31m\n".to_vec(), "PLY"),
        ("glb", b"glTF\x02\0\0\0".to_vec(), "GLB"),
        ("comma", b"v 1,5 0 0\n".to_vec(), "point"),
        ("huge", tetrahedron("1e20 0 0").into_bytes(), "scale it"),
    ] {
        let (code, out, told) = grow(name, &mesh, &[]);
        assert_eq!((code, &*out), (Some(2), ""), "{name}: {told}");
        assert!(told.contains(word) && told.lines().count() == 1 && told.len() < 400, "{told}");
        assert!(!told.trim_end().contains(char::is_control), "{told:?}");
    }
}
