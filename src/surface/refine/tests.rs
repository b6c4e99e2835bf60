use super::*;
use crate::surface::Body;
use glam::Vec3;

fn cube() -> PolygonMesh {
    let mut text = String::new();
    for k in 0..8 {
        let sign = |bit: i32| if k >> bit & 1 == 1 { 1 } else { -1 };
        text += &format!("v {} {} {}\n", sign(0), sign(1), sign(2));
    }
    text += "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    PolygonMesh::parse(&text).unwrap()
}

/// A sheet of `n` by `n` squares in the plane y = 0, with texture coordinates like its places.
fn sheet(n: usize) -> PolygonMesh {
    let mut text = String::new();
    for k in 0..(n + 1) * (n + 1) {
        let (x, z) = (k % (n + 1), k / (n + 1));
        text += &format!("v {x} 0 {z}\nvt {x} {z}\n");
    }
    for k in 0..n * n {
        let a = k / n * (n + 1) + k % n + 1;
        let (b, c, d) = (a + n + 1, a + n + 2, a + 1);
        text += &format!("f {a}/{a} {b}/{b} {c}/{c} {d}/{d}\n");
    }
    PolygonMesh::parse(&text).unwrap()
}

#[test]
fn corners_that_repeat_and_faces_without_three_make_no_difference() {
    let mut repeating = cube();
    let first = repeating.faces[0].vertices.clone();
    repeating.faces[0].vertices = first.iter().chain(&first[..1]).flat_map(|&v| [v, v]).collect();
    for vertices in [vec![0, 0, 1, 1, 0], vec![2, 2], vec![]] {
        repeating.faces.push(Face { vertices, group: 0 });
    }
    assert_eq!(repeating.refined(1), cube().refined(1));
}

#[test]
fn the_rim_of_a_sheet_becomes_a_cubic_b_spline() {
    // An eighth of each neighbour along the rim and six of the vertex; the one within stays in the middle.
    let finer = sheet(2).refined(1);
    let places: Vec<[f32; 2]> = finer.positions[..9].iter().map(|p| [p.x, p.z]).collect();
    let rows = [0.125, 1.0, 1.875].map(|z| [[0.125, z], [1.0, z], [1.875, z]]);
    let mut expected = rows.concat();
    // Where the rim is straight it stays.
    for (k, place) in [(1, [1.0, 0.0]), (3, [0.0, 1.0]), (5, [2.0, 1.0]), (7, [1.0, 2.0])] {
        expected[k] = place;
    }
    assert_eq!(places, expected);
}

#[test]
fn a_cube_becomes_a_closed_ball() {
    let ball = cube().refined(4);
    assert_eq!(ball.faces.len(), 6 * 4_usize.pow(4));
    let edges = 2 * ball.faces.len();
    assert_eq!(ball.positions.len() + ball.faces.len(), edges + 2, "Euler characteristic 2");
    let radii = || ball.positions.iter().map(|p| p.length());
    let (least, most) = (radii().fold(f32::MAX, f32::min), radii().fold(0.0, f32::max));
    assert!(most / least < 1.12, "radii from {least} to {most}");
    let body = Body::new(&ball).unwrap();
    body.surface.check().unwrap();
    assert_eq!(body.surface.part_count(), 1);
    assert!(body.surface.twins.iter().all(|&twin| twin != crate::surface::NO_TWIN));
    let outward = |t: u32| {
        let [a, b, c] = body.surface.corners(t);
        (b - a).cross(c - a).dot(a + b + c) > 0.0
    };
    assert!((0..body.surface.triangles.len() as u32).all(outward));
}

#[test]
fn a_flat_sheet_stays_flat_with_a_smooth_rim() {
    let mesh = sheet(3).refined(3);
    assert_eq!(mesh.faces.len(), 9 * 64);
    assert!(mesh.positions.iter().all(|p| p.y == 0.0));
    // The texture coordinates went through the same rule as the places.
    assert!(mesh.positions.iter().zip(&mesh.uvs).all(|(p, uv)| p.x == uv.x && p.z == uv.y));
    // The rim is the B-spline of the square: straight in the middle, rounded at the corners.
    let nearest = mesh.positions.iter().map(|p| p.distance(Vec3::ZERO)).fold(f32::MAX, f32::min);
    assert!(nearest > 0.2 && nearest < 0.4, "{nearest}");
    let body = Body::new(&mesh).unwrap();
    body.surface.check().unwrap();
    let rims = body.surface.twins.iter().filter(|&&twin| twin == crate::surface::NO_TWIN);
    assert_eq!(rims.count(), 12 * 8);
}

#[test]
fn parts_do_not_pull_at_each_other() {
    let one = sheet(2);
    let mut two = sheet(2);
    let far = one.positions.len() as u32;
    two.positions.extend(one.positions.iter().map(|&p| p + Vec3::Y));
    two.uvs.extend(&one.uvs);
    two.faces.extend(
        one.faces
            .iter()
            .map(|f| Face { vertices: f.vertices.iter().map(|v| v + far).collect(), group: 0 }),
    );
    let (one, two) = (one.refined(2), two.refined(2));
    assert_eq!(two.positions.len(), 2 * one.positions.len());
    assert!(one.positions.iter().all(|p| two.positions.contains(p)));
}

#[test]
fn bare_and_patterned_faces_part_after_refinement() {
    let mut mesh = cube();
    mesh.groups
        .push(crate::surface::Group { part: String::new(), material: "bare:soil".to_string() });
    mesh.faces[0].group = 1;
    let body = Body::new(&mesh.refined(2)).unwrap();
    assert_eq!(body.surface.triangles.len(), 5 * 16 * 2);
    assert_eq!(body.ornaments.len(), 1);
    assert_eq!(body.ornaments[0].material, "soil");
    assert_eq!(body.ornaments[0].triangles.len(), 16 * 2);
}

#[test]
fn each_group_can_have_its_own_levels() {
    let mut mesh = sheet(2);
    let square = Group { part: String::new(), material: String::new() };
    mesh.groups = vec![square, Group { part: "spine".to_string(), material: String::new() }];
    mesh.faces[3].group = 1;
    let mixed = mesh.refined_by(&|group| if group.part.is_empty() { 2 } else { 0 });
    assert_eq!(mixed.faces.len(), 3 * 16 + 1);
    assert_eq!(mixed.uvs.len(), mixed.positions.len());
    assert!(mixed.positions.iter().zip(&mixed.uvs).all(|(p, uv)| p.x == uv.x && p.z == uv.y));
    let even = mesh.refined_by(&|_| 2);
    assert_eq!(even.faces.len(), mesh.refined(2).faces.len());
    assert_eq!(even.positions.len(), mesh.refined(2).positions.len());
}

#[test]
fn odd_meshes_are_refined_too() {
    // Three faces at one edge, a bow tie, a face that folds back, repeated corners, a stray
    // vertex, a triangle and a pentagon.
    let text = "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 1\nv -1 0 0\nv -1 -1 0\nv 0 -1 0\nv 9 9 9\n\
                f 1 2 3\nf 1 2 4\nf 1 2 5\nf 1 5 6\nf 1 3 7 6 5\nf 1 1 2 2\nf 3 3 3\nf 1 3 4 3 2 1\n";
    let mesh = PolygonMesh::parse(text).unwrap();
    let fine = mesh.refined(3);
    assert!(fine.positions.iter().all(|p| p.is_finite()));
    let count = fine.positions.len() as u32;
    assert!(
        fine.faces.iter().all(|f| f.vertices.len() == 4 && f.vertices.iter().all(|&v| v < count))
    );
    assert!(fine.positions.contains(&Vec3::splat(9.0)));
    Body::new(&fine).unwrap().surface.check().unwrap();
}
