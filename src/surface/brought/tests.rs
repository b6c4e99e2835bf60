//! Files as other programs write them, each with what is right for it.

use super::*;
use crate::surface::{Mesh, NO_TWIN};
use std::collections::BTreeMap;
use std::fmt::Write;

const TETRAHEDRON: &str =
    "v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n";

fn read(text: &str) -> Brought {
    let brought = Brought::read(text.as_bytes()).unwrap();
    brought.body.surface.check().unwrap();
    brought
}

fn error(text: &str) -> String {
    Brought::read(text.as_bytes()).unwrap_err().to_string()
}

fn rim_edges(mesh: &Mesh) -> usize {
    mesh.twins.iter().filter(|&&twin| twin == NO_TWIN).count()
}

/// Triangles, parts, rim edges, joined pairs and triangles left out.
fn numbers(brought: &Brought) -> [usize; 5] {
    let mesh = &brought.body.surface;
    let Brought { joined_edges, left_out_triangles, .. } = *brought;
    let rims = rim_edges(mesh);
    [mesh.triangles.len(), mesh.part_count(), rims, joined_edges, left_out_triangles]
}

fn assert_area(brought: &Brought, area: f64) {
    let found = f64::from(brought.body.surface.area);
    assert!((found / area - 1.0).abs() < 1e-6, "{found} and not {area}");
}

/// Faces that all have vertices of their own.
fn soup<const N: usize>(faces: &[[[i32; 3]; N]]) -> String {
    let mut text = String::new();
    for corner in faces.iter().flatten() {
        let _ = writeln!(text, "v {} {} {}", corner[0], corner[1], corner[2]);
    }
    for face in 0..faces.len() {
        text += &(0..N).fold("f".to_string(), |f, k| format!("{f} {}", face * N + k + 1));
        text += "\n";
    }
    text
}

/// The sides of a cube of edge 2 around a place, seen from outside.
fn cube([x, y, z]: [i32; 3]) -> Vec<[[i32; 3]; 4]> {
    let corner = |k: usize| {
        let sign = |bit: usize| if k >> bit & 1 == 1 { 1 } else { -1 };
        [x + sign(0), y + sign(1), z + sign(2)]
    };
    [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
        .map(|side| side.map(corner))
        .to_vec()
}

/// The same faces, with each place one vertex.
fn indexed(faces: &[[[i32; 3]; 4]]) -> String {
    let mut numbers = BTreeMap::new();
    let (mut vertices, mut text) = (String::new(), String::new());
    for face in faces {
        text += "f";
        for corner in face {
            let next = numbers.len() + 1;
            let number = *numbers.entry(corner).or_insert(next);
            if number == next {
                let _ = writeln!(vertices, "v {} {} {}", corner[0], corner[1], corner[2]);
            }
            let _ = write!(text, " {number}");
        }
        text += "\n";
    }
    vertices + &text
}

/// The second text's faces after the first one's, by numbers from the end.
fn beside(first: &str, second: &str) -> String {
    let count = second.lines().filter(|line| line.starts_with("v ")).count() as i64;
    let from_end = |line: &str| {
        let words = line.split(' ').skip(1).map(|n| n.parse::<i64>().unwrap() - count - 1);
        words.fold("f".to_string(), |f, n| format!("{f} {n}"))
    };
    let lines = second.lines().map(|l| if l.starts_with('f') { from_end(l) } else { l.into() });
    format!("{first}{}\n", lines.collect::<Vec<_>>().join("\n"))
}

#[test]
fn sides_with_vertices_of_their_own_are_one_body() {
    let sides = read(&soup(&cube([0, 0, 0])));
    assert_eq!(numbers(&sides), [12, 1, 0, 12, 0]);
    assert_area(&sides, 24.0);
    assert_eq!(sides.body.surface.positions.len(), 8);

    // Turned at random, they are turned to agree.
    let mut turned = cube([0, 0, 0]);
    for k in [1, 2, 5] {
        turned[k].reverse();
    }
    assert_eq!(numbers(&read(&soup(&turned))), [12, 1, 0, 12, 0]);

    let square = [[[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 0], [0, 1, 0]]];
    assert_eq!(numbers(&read(&soup(&square))), [2, 1, 4, 1, 0]);
}

#[test]
fn what_touches_without_a_free_edge_stays_apart() {
    let [one, other, beside_it] = [[0, 0, 0], [2, 2, 2], [2, 0, 0]].map(cube);
    // Two cubes that have a corner in common, and two with a whole side.
    let corner = beside(&indexed(&one), &indexed(&other));
    assert_eq!(numbers(&read(&corner)), [24, 2, 0, 0, 0]);
    assert_eq!(numbers(&read(&soup(&[one.clone(), other].concat()))), [24, 2, 0, 24, 0]);
    // Two that have an edge in common: four rim edges have its ends, and those around tell which are one.
    let edge = [cube([0, 0, 0]), cube([2, 2, 0])];
    assert_eq!(numbers(&read(&soup(&edge.concat()))), [24, 2, 0, 24, 0]);
    assert_eq!(numbers(&read(&beside(&indexed(&edge[0]), &indexed(&edge[1])))), [24, 2, 0, 0, 0]);
    let side = beside(&indexed(&one), &indexed(&beside_it));
    assert_eq!(numbers(&read(&side)), [24, 2, 0, 0, 0]);
    // Three sheets that meet in one edge.
    let sheets = [[1, 1, 0], [-1, 1, 0], [0, 1, 1]].map(|tip| [[0, 0, 0], [0, 2, 0], tip]);
    assert_eq!(numbers(&read(&soup(&sheets))), [3, 3, 9, 0, 0]);
}

#[test]
fn only_exactly_the_same_place_joins() {
    let apart = |gap: &str| {
        format!("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv {gap} 0 0\nv 0 1 0\nf 1 2 3\nf 5 4 6\n")
    };
    assert_eq!(numbers(&read(&apart("1.0"))), [2, 1, 4, 1, 0]);
    assert_eq!(numbers(&read(&apart("1e0"))), [2, 1, 4, 1, 0]);
    assert_eq!(numbers(&read(&apart("1.00000001"))), [2, 2, 6, 0, 0]);
    let zeros = apart("1").replace("v 0 1 0\nf", "v -0 1 -0.0\nf");
    assert_eq!(numbers(&read(&zeros)), [2, 1, 4, 1, 0], "-0 is 0");
}

#[test]
fn texture_coordinates_stay_where_a_joined_vertex_has_one() {
    let seam = |uv: &str| {
        format!(
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n\
             vt 0 0\nvt 1 0\nvt 0 1\nvt {uv}\nvt 1 1\nf 1/1 2/2 3/3\nf 4/4 5/5 6/3\n"
        )
    };
    assert_eq!(read(&seam("1 0")).body.surface.uvs.len(), 4);
    let split = read(&seam("0.5 0"));
    assert_eq!((split.body.surface.uvs.len(), numbers(&split)), (0, [2, 1, 4, 1, 0]));
}

#[test]
fn faces_that_stand_twice_are_taken_once() {
    let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    let twice = read(&format!("{square}f 1 2 3\nf 1 3 4\nf 2 3 1\nf 4 3 1\n"));
    assert_eq!(numbers(&twice), [2, 1, 4, 0, 2]);
    assert_area(&twice, 1.0);
    // The back of a leaf with vertices of its own, and a closed body as a whole.
    let back =
        beside(&format!("{square}f 1 2 3\nf 1 3 4\n"), &format!("{square}f 3 2 1\nf 4 3 1\n"));
    assert_eq!(numbers(&read(&back)), [2, 1, 4, 0, 2]);
    let closed = indexed(&cube([0, 0, 0]));
    assert_eq!(numbers(&read(&beside(&closed, &closed))), [12, 1, 0, 0, 12]);
    let faces = cube([0, 0, 0]);
    assert_eq!(
        numbers(&read(&indexed(&[faces.clone(), faces.clone()].concat()))),
        [12, 1, 0, 0, 12]
    );
    assert_eq!(numbers(&read(&soup(&[faces.clone(), faces].concat()))), [12, 1, 0, 12, 12]);
    // A picture laid on a closed body is not its side.
    let decal = beside(&soup(&[cube([0, 0, 0])[2]]), &closed);
    assert_eq!(numbers(&read(&decal)), [12, 1, 0, 0, 2]);
}

#[test]
fn corners_that_repeat_a_place_and_triangles_without_area_are_told() {
    // A slit that a triangle without area fills, as exports of quads have it at poles.
    let pole =
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\nf 1 2 3\nf 1 2 5\nf 1 3 4\nf 2 2 3 3\n";
    assert_eq!(numbers(&read(pole)), [2, 1, 4, 0, 3]);
    let quad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 1 1 0\nf 1 2 3 4\n";
    assert_eq!(numbers(&read(quad)), [1, 1, 3, 0, 1]);
}

#[test]
fn a_body_far_from_the_origin_keeps_its_shape_and_says_where_it_was() {
    let far =
        "v 1000001.125 5000001 1\nv 1000001 4999999 -1\nv 999999 5000001 -1\nv 999999 4999999 1\n";
    let faces = &TETRAHEDRON[TETRAHEDRON.find('f').unwrap()..];
    let brought = read(&format!("{far}{faces}v 1e300 nan 0\n"));
    assert_eq!(numbers(&brought), [4, 1, 0, 0, 0]);
    assert_eq!(brought.origin, DVec3::new(1e6, 5e6, 0.0), "its middle, in whole centimetres");
    let first = brought.body.surface.positions[0].as_dvec3() + brought.origin;
    assert_eq!(first, DVec3::new(1000001.125, 5000001.0, 1.0), "to the bit");

    // One that is not far keeps the bits that it has.
    let near = TETRAHEDRON.replace("v 1 ", "v 1.1 ");
    let brought = read(&near);
    let plain = Body::new(&PolygonMesh::parse(&near).unwrap()).unwrap().surface;
    assert_eq!((brought.origin, brought.body.surface.positions), (DVec3::ZERO, plain.positions));
}

#[test]
fn sizes_that_can_be_grown_on_end_in_words() {
    let scaled = |by: &str| TETRAHEDRON.replace('1', by).replace(&format!("f {by}"), "f 1");
    let faces = &TETRAHEDRON[TETRAHEDRON.find('f').unwrap()..];
    let scaled = |by: &str| scaled(by).split_once("f ").unwrap().0.to_string() + faces;
    for by in ["1e-4", "4.9e5", "0.01", "3.3e3"] {
        let by_number: f64 = by.parse().unwrap();
        assert_area(&read(&scaled(by)), 8.0 * 3f64.sqrt() * by_number * by_number);
    }
    for (by, size) in [("1e20", "2e20"), ("3e18", "6e18"), ("1e-12", "2e-12"), ("1e200", "2e200")] {
        let told = error(&scaled(by));
        assert!(told.contains(&format!("{size} cm")) && told.contains("scale it"), "{told}");
    }
    assert!(error(&scaled("1e308")).contains("scale it"));
    assert!(error(&scaled("1e999")).contains("vertex 1 is not a finite number"));
    assert!(error("v 7 7 7\nf 1 1 1\n").contains("no surface"));
}

#[test]
fn parts_without_cells_neither_join_nor_count() {
    let square = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    let brought = read(&format!("{square}f 1 2 3\nusemtl bare:pot\nf 4 5 6\nf 4 5 6\n"));
    assert_eq!(numbers(&brought), [1, 1, 3, 0, 0]);
    assert_eq!(brought.body.ornaments[0].triangles.len(), 2);
    assert!(error(&format!("{square}usemtl bare:pot\nf 1 2 3\n")).contains("bare"));
    let dart =
        "v 0 1 0\nv -0.1 0 0\nv 0 2 0\nv 0.1 0 0\nv 0 0 1\nf 1 2 5\nusemtl bare:pot\nf 1 2 3 4\n";
    let pot = &read(dart).body.ornaments[0];
    let area = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|v| pot.positions[v as usize]);
        0.5 * (b - a).cross(c - a).length()
    };
    let area: f32 = pot.triangles.iter().map(area).sum();
    assert!((area - 0.1).abs() < 1e-6, "{area}");
}
