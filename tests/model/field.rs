//! The direction field against closed forms.

use crate::meshes::{flat, icosphere, in_frame, shaken, sheet};
use clonal_mosaic::surface::{DirectionField, FieldError, Guide, Mesh};
use glam::{Vec2, Vec3};

const EPSILON_PER_CM: f64 = 0.4;

fn field(mesh: &Mesh, guides: &[Guide]) -> DirectionField {
    DirectionField::new(mesh, guides, EPSILON_PER_CM).unwrap()
}

/// The direction of a triangle in space.
fn in_space(mesh: &Mesh, field: &DirectionField, triangle: u32) -> Vec3 {
    let [x, y] = mesh.axes(triangle);
    let v = field.at(triangle);
    x * v.x + y * v.y
}

fn triangles(mesh: &Mesh) -> std::ops::Range<u32> {
    0..mesh.triangles.len() as u32
}

fn normal(mesh: &Mesh, triangle: u32) -> Vec3 {
    let [a, b, c] = mesh.corners(triangle);
    (b - a).cross(c - a).normalize()
}

/// Control vectors here and there on a sphere.
fn many(mesh: &Mesh) -> Vec<Guide> {
    (0..12u32)
        .map(|k| {
            let noise = |a: f32| libm::sinf(a * (k as f32 + 1.7)) * 3.0;
            let triangle = k * 97 % mesh.triangles.len() as u32;
            Guide { triangle, direction: Vec3::new(noise(1.1), noise(2.3), noise(3.7)) }
        })
        .collect()
}

#[test]
fn one_vector_leads_a_flat_sheet_evenly() {
    let mesh = sheet(9, 4.0, shaken(4.0, 0.1));
    let field = field(&mesh, &[Guide { triangle: 40, direction: Vec3::new(3.0, -4.0, 7.0) }]);
    for t in triangles(&mesh) {
        let expected = in_frame(&mesh, t, Vec2::new(0.6, -0.8));
        assert!((field.at(t) - expected).length() < 1e-6, "triangle {t}");
    }
}

#[test]
fn two_vectors_lead_a_flat_sheet_as_worked_out_by_hand() {
    let mesh = sheet(9, 4.0, shaken(4.0, 0.1));
    let (u, w) = (Vec3::X, Vec3::new(0.6, 0.8, 0.0));
    let guides = [Guide { triangle: 3, direction: u }, Guide { triangle: 150, direction: w }];
    let field = field(&mesh, &guides);
    let [p, q] = guides.map(|guide| mesh.centroid(guide.triangle));
    let basis = |a: Vec3, b: Vec3| {
        let rho = f64::from(a.distance(b));
        (1.0 / (1.0 + (EPSILON_PER_CM * rho).powi(2)).sqrt()) as f32
    };
    // [1 c; c 1] (a, b) = (u, w)
    let c = basis(p, q);
    let (a, b) = ((u - w * c) / (1.0 - c * c), (w - u * c) / (1.0 - c * c));
    for t in triangles(&mesh) {
        let x = mesh.centroid(t);
        let expected = (a * basis(x, p) + b * basis(x, q)).normalize();
        assert!((in_space(&mesh, &field, t) - expected).length() < 1e-5, "triangle {t}");
    }
}

#[test]
fn interpolation_returns_the_control_vectors() {
    for mesh in [icosphere(3, 10.0), sheet(12, 9.0, shaken(9.0, 0.2))] {
        let guides = many(&mesh);
        let field = field(&mesh, &guides);
        for Guide { triangle, direction } in guides {
            let up = normal(&mesh, triangle);
            let flat = (direction - up * direction.dot(up)).normalize();
            let found = in_space(&mesh, &field, triangle);
            assert!((found - flat).length() < 1e-5, "triangle {triangle}: {found} and not {flat}");
        }
    }
}

#[test]
fn a_field_is_tangent_and_of_unit_length_on_a_curved_body() {
    let mesh = icosphere(4, 10.0);
    let field = field(&mesh, &many(&mesh));
    for t in triangles(&mesh) {
        let v = in_space(&mesh, &field, t);
        assert!((v.length() - 1.0).abs() < 1e-5, "triangle {t}: {v}");
        assert!(v.dot(normal(&mesh, t)).abs() < 1e-5, "triangle {t}: {v}");
    }
}

#[test]
fn symmetric_control_vectors_lead_a_symmetric_field() {
    // A sheet is its own mirror image about the diagonal x = y: triangle 2 k lies below it where
    // triangle 2 k' + 1 lies above.
    const N: u32 = 10;
    let mesh = sheet(N, 5.0, flat);
    let mirror = |t: u32| 2 * (t / 2 % N * N + t / 2 / N) + 1 - t % 2;
    let guides = |t: u32, d: Vec3| {
        [(t, d), (mirror(t), Vec3::new(d.y, d.x, d.z))]
            .map(|(triangle, direction)| Guide { triangle, direction })
    };
    let guides = [guides(7, Vec3::new(1.0, -0.3, 0.0)), guides(120, Vec3::new(-0.2, 0.9, 0.0))];
    let field = field(&mesh, guides.as_flattened());
    for t in triangles(&mesh) {
        let (here, there) = (mesh.centroid(t), mesh.centroid(mirror(t)));
        assert!((Vec3::new(here.y, here.x, 0.0) - there).length() < 1e-5);
        let (v, w) = (in_space(&mesh, &field, t), in_space(&mesh, &field, mirror(t)));
        assert!((Vec3::new(v.y, v.x, 0.0) - w).length() < 1e-4, "triangle {t}: {v} and {w}");
    }
}

#[test]
fn where_control_vectors_cancel_out_there_is_no_direction() {
    // The middle one of three triangles is as far from the first as from the last.
    let corners = [(0.0, 0.0), (2.0, 0.0), (1.0, 1.0), (3.0, 1.0), (4.0, 0.0)];
    let positions = corners.map(|(x, y)| Vec3::new(x, y, 0.0)).to_vec();
    let mesh = Mesh::new(positions, Vec::new(), vec![[0, 1, 2], [1, 3, 2], [1, 4, 3]]).unwrap();
    let direction = Vec3::new(0.3, 1.0, 0.0);
    let guides = [(0, direction), (2, -direction)];
    let guides = guides.map(|(triangle, direction)| Guide { triangle, direction });
    let field = field(&mesh, &guides);
    assert_eq!(field.at(1), Vec2::ZERO);
    assert!((field.at(0).length() - 1.0).abs() < 1e-6);
}

#[test]
fn control_vectors_lead_their_own_part_alone() {
    let one = sheet(4, 4.0, flat);
    let count = one.positions.len() as u32;
    let above = one.positions.iter().map(|p| *p + Vec3::Z * 0.01);
    let positions = one.positions.iter().copied().chain(above).collect();
    let upper = one.triangles.iter().map(|t| t.map(|v| v + count));
    let faces = one.triangles.iter().copied().chain(upper).collect();
    let mesh = Mesh::new(positions, Vec::new(), faces).unwrap();
    let guides =
        [(0, Vec3::X), (9, Vec3::Y)].map(|(triangle, direction)| Guide { triangle, direction });
    let led = field(&mesh, &guides);
    for t in triangles(&one) {
        assert_eq!(led.at(t), field(&one, &guides).at(t));
        assert_eq!(led.at(t + one.triangles.len() as u32), Vec2::ZERO);
    }
}

#[test]
fn control_vectors_that_make_no_field_are_refused() {
    let mesh = sheet(2, 4.0, flat);
    let guide = |triangle, direction| Guide { triangle, direction };
    for (guides, epsilon_per_cm, error) in [
        (vec![], 0.0, FieldError::Epsilon(0.0)),
        (vec![guide(8, Vec3::X)], 1.0, FieldError::NoSuchTriangle { triangle: 8, count: 8 }),
        (vec![guide(5, Vec3::Z)], 1.0, FieldError::Upright(5)),
        (vec![guide(5, Vec3::ZERO)], 1.0, FieldError::Upright(5)),
        (vec![guide(5, Vec3::X), guide(5, Vec3::Y)], 1.0, FieldError::Crowded(5)),
        (vec![guide(5, Vec3::X), guide(4, Vec3::Y)], 1e-7, FieldError::Crowded(4)),
    ] {
        assert_eq!(DirectionField::new(&mesh, &guides, epsilon_per_cm), Err(error));
    }
}
