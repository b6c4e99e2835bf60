//! Bodies whose geometry is known exactly.

pub use clonal_mosaic::surface::icosphere;
use clonal_mosaic::surface::{Mesh, NO_TWIN, Place};
use glam::{Vec2, Vec3};
use std::collections::HashMap;

/// A flat square of `n` by `n` cells of two triangles each, from (0, 0) to (side, side), seen from
/// above; `bend` puts its vertices somewhere else.
pub fn sheet(n: u32, side: f32, bend: impl Fn(Vec2) -> Vec3) -> Mesh {
    let step = side / n as f32;
    let positions = (0..(n + 1) * (n + 1))
        .map(|k| bend(Vec2::new((k % (n + 1)) as f32 * step, (k / (n + 1)) as f32 * step)))
        .collect();
    Mesh::new(positions, Vec::new(), sheet_triangles(n)).unwrap()
}

/// Two flat sheets, a gap above each other.
pub fn two_sheets(n: u32, side: f32, gap: f32) -> Mesh {
    let one = sheet(n, side, flat);
    let count = one.positions.len() as u32;
    let above = one.positions.iter().map(|p| *p + Vec3::Z * gap);
    let positions = one.positions.iter().copied().chain(above).collect();
    let upper = one.triangles.iter().map(|t| t.map(|v| v + count));
    let triangles = one.triangles.iter().copied().chain(upper).collect();
    let mesh = Mesh::new(positions, Vec::new(), triangles).unwrap();
    assert_eq!(mesh.part_count(), 2);
    mesh
}

fn sheet_triangles(n: u32) -> Vec<[u32; 3]> {
    (0..n * n)
        .flat_map(|k| {
            let v = k % n + (n + 1) * (k / n);
            [[v, v + 1, v + n + 2], [v, v + n + 2, v + n + 1]]
        })
        .collect()
}

/// A vertex of a sheet left where it is.
pub fn flat(p: Vec2) -> Vec3 {
    p.extend(0.0)
}

/// The inner vertices of a sheet shaken, so that its triangles are of many shapes; `amount` is in
/// units of the sheet.
pub fn shaken(side: f32, amount: f32) -> impl Fn(Vec2) -> Vec3 {
    move |p| {
        let inner = |x: f32| x > 0.0 && x < side;
        if !(inner(p.x) && inner(p.y)) {
            return flat(p);
        }
        let noise = |a: f32, b: f32| (libm::sinf(p.x * a + p.y * b) * 43_758.547).fract();
        flat(p + Vec2::new(noise(12.9898, 78.233), noise(39.3468, 11.135)) * amount)
    }
}

/// A flat sheet whose opposite sides are joined: a torus without any curvature, which no mesh in
/// space can be. Its positions are those of the sheet.
pub fn flat_torus(n: u32, side: f32) -> Mesh {
    let mut mesh = sheet(n, side, flat);
    let edge = |mesh: &Mesh, h: usize| {
        let c = mesh.corners((h / 3) as u32);
        (c[(h % 3 + 1) % 3], c[(h % 3 + 2) % 3])
    };
    let rims: Vec<usize> = (0..mesh.twins.len()).filter(|&h| mesh.twins[h] == NO_TWIN).collect();
    for &h in &rims {
        let (from, to) = edge(&mesh, h);
        let across = |other: &usize| {
            let (back_from, back_to) = edge(&mesh, *other);
            let (a, b) = (back_to - from, back_from - to);
            (a - b).length() < 1e-4 && (a.length() - side).abs() < 1e-4
        };
        let twin = *rims.iter().find(|other| across(other)).expect("every rim has an opposite");
        mesh.twins[h] = twin as u32;
        let direction = |h: usize| {
            let c = mesh.frames[h / 3].corners();
            (c[(h % 3 + 2) % 3] - c[(h % 3 + 1) % 3]).normalize()
        };
        let (here, there) = (direction(h), -direction(twin));
        mesh.turns[h] = Vec2::new(here.dot(there), here.perp_dot(there));
    }
    mesh
}

/// A closed cube of `n` by `n` squares a side.
pub fn cube(n: u32, side: f32) -> Mesh {
    box_of([n, n, n], Vec3::splat(side))
}

/// A closed blade: a thin box, its two faces 1/200 of its side apart.
pub fn blade(n: u32, side: f32) -> Mesh {
    box_of([n, n, 1], Vec3::new(side, side, side / 200.0))
}

/// The surface of a box from the origin to `size`, in `n` squares along each axis.
fn box_of(n: [u32; 3], size: Vec3) -> Mesh {
    let mut numbers = HashMap::new();
    let mut positions = Vec::new();
    let mut triangles = Vec::new();
    for axis in 0..3 {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        for level in [0, n[axis]] {
            for (i, j) in (0..n[u]).flat_map(|i| (0..n[v]).map(move |j| (i, j))) {
                let mut corner = |i: u32, j: u32| {
                    let mut at = [0; 3];
                    (at[axis], at[u], at[v]) = (level, i, j);
                    *numbers.entry(at).or_insert_with(|| {
                        let part = |k: usize| at[k] as f32 / n[k] as f32;
                        positions.push(size * Vec3::new(part(0), part(1), part(2)));
                        positions.len() as u32 - 1
                    })
                };
                let [a, b, c, d] =
                    [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
                // Seen from outside the far faces run with the axes, the near ones against them.
                triangles.extend(match level {
                    0 => [[a, c, b], [a, d, c]],
                    _ => [[a, b, c], [a, c, d]],
                });
            }
        }
    }
    Mesh::new(positions, Vec::new(), triangles).unwrap()
}

/// A vector of the xy plane in the frame of a triangle that lies in that plane.
pub fn in_frame(mesh: &Mesh, triangle: u32, vector: Vec2) -> Vec2 {
    let [a, b, _] = mesh.corners(triangle).map(|p| p.truncate());
    let x = (b - a).normalize();
    Vec2::new(vector.dot(x), vector.dot(x.perp()))
}

/// The place on a mesh in the xy plane that lies over a point.
pub fn place_at(mesh: &Mesh, point: Vec2) -> Place {
    (0..mesh.triangles.len() as u32)
        .find_map(|triangle| {
            let corner = mesh.corners(triangle)[0].truncate();
            let b = mesh.frames[triangle as usize].barycentric(in_frame(
                mesh,
                triangle,
                point - corner,
            ));
            let inside = b.x >= 0.0 && b.y >= 0.0 && b.x + b.y <= 1.0;
            inside.then_some(Place { triangle, b1: b.x, b2: b.y })
        })
        .expect("the point lies over the mesh")
}

#[test]
fn the_bodies_are_what_they_say() {
    let sphere = icosphere(4, 10.0);
    assert_eq!(sphere.triangles.len(), 5120);
    assert!((sphere.area / (4.0 * std::f32::consts::PI * 100.0) - 1.0).abs() < 0.01);
    for (mesh, area, rims) in [
        (sphere, 1255.1, 0),
        (cube(4, 3.0), 54.0, 0),
        (blade(8, 4.0), 2.0 * 16.0 + 4.0 * 4.0 * 0.02, 0),
        (sheet(8, 4.0, shaken(4.0, 0.12)), 16.0, 32),
        (flat_torus(8, 4.0), 16.0, 0),
    ] {
        assert!((mesh.area - area).abs() < 0.001 * area, "{} and not {area}", mesh.area);
        assert_eq!(mesh.part_count(), 1);
        assert_eq!(mesh.twins.iter().filter(|&&twin| twin == NO_TWIN).count(), rims);
    }
    for mesh in [icosphere(2, 1.0), cube(4, 3.0), blade(8, 4.0), sheet(8, 4.0, shaken(4.0, 0.12))] {
        mesh.check().unwrap();
    }
}
