//! The sphere that the original program was measured on.

use super::Mesh;
use glam::Vec3;
use std::collections::HashMap;

/// A closed sphere: an icosahedron whose triangles are cut in four `levels` times, with all corners
/// `radius_cm` from the origin. Level 4 has 5,120 triangles.
///
/// # Panics
/// For a radius that is not over 0.
pub fn icosphere(levels: u32, radius_cm: f32) -> Mesh {
    let (mut positions, mut triangles) = icosahedron();
    for _ in 0..levels {
        let mut middles = HashMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                positions.push((positions[a as usize] + positions[b as usize]) * 0.5);
                positions.len() as u32 - 1
            })
        };
        triangles = triangles
            .iter()
            .flat_map(|&[a, b, c]| {
                let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
                [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
            })
            .collect();
        positions = positions.into_iter().map(|p| p.normalize()).collect();
    }
    let positions = positions.into_iter().map(|p| p.normalize() * radius_cm).collect();
    Mesh::new(positions, Vec::new(), triangles).expect("a sphere has a surface")
}

/// Corners and triangles of an icosahedron with edges of length 2, seen from outside.
fn icosahedron() -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let golden = (1.0 + 5f32.sqrt()) / 2.0;
    let mut positions = Vec::new();
    for (a, b) in [(-1.0, golden), (1.0, golden), (-1.0, -golden), (1.0, -golden)] {
        positions.extend([Vec3::new(a, b, 0.0), Vec3::new(0.0, a, b), Vec3::new(b, 0.0, a)]);
    }
    // All triples of corners that are an edge apart, turned so that they look outwards.
    let near = |a: usize, b: usize| (positions[a].distance(positions[b]) - 2.0f32).abs() < 1e-3;
    let mut triangles = Vec::new();
    for a in 0..12 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                if near(a, b) && near(b, c) && near(c, a) {
                    let normal = (positions[b] - positions[a]).cross(positions[c] - positions[a]);
                    let outwards = normal.dot(positions[a]) > 0.0;
                    let [a, b, c] = [a as u32, b as u32, c as u32];
                    triangles.push(if outwards { [a, b, c] } else { [a, c, b] });
                }
            }
        }
    }
    (positions, triangles)
}
