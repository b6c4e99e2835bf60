//! A flat torus: a square whose opposite sides are one, so that what grows on it can be laid side by side
//! without a seam.

use super::Mesh;
use glam::Vec3;

/// A square from the origin to `(side_cm, side_cm, 0)` in `squares` times `squares` squares of two triangles
/// each, with left and right and with lower and upper side glued together.
///
/// # Panics
/// For a side that is not over 0, and for no squares.
pub fn flat_torus(side_cm: f32, squares: u32) -> Mesh {
    let row = squares + 1;
    let at = |k: u32| side_cm * (k as f32 / squares as f32);
    let positions = (0..row * row).map(|v| Vec3::new(at(v % row), at(v / row), 0.0)).collect();
    let triangles = (0..squares * squares)
        .map(|k| k % squares + row * (k / squares))
        .flat_map(|a| [[a, a + 1, a + row + 1], [a, a + row + 1, a + row]])
        .collect();
    let mut mesh = Mesh::new(positions, Vec::new(), triangles).expect("a square has a surface");
    // The first half-edge of a square's lower right triangle; that of the upper left one is three on.
    let half_edge = |column: u32, line: u32| 6 * (column + squares * line);
    for k in 0..squares {
        let last = squares - 1;
        mesh.glue(half_edge(last, k), half_edge(0, k) + 3 + 1);
        mesh.glue(half_edge(k, last) + 3, half_edge(k, 0) + 2);
    }
    mesh
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::{NO_TWIN, Place, walk};
    use glam::Vec2;

    #[test]
    fn it_has_no_rim_and_all_is_in_its_place() {
        for squares in [1, 2, 7] {
            let torus = flat_torus(3.0, squares);
            torus.check().unwrap();
            assert!(!torus.twins.contains(&NO_TWIN));
            assert_eq!(torus.part_count(), 1);
            assert!((torus.area - 9.0).abs() < 1e-5);
        }
    }

    #[test]
    fn whoever_goes_straight_on_comes_back() {
        let torus = flat_torus(4.0, 8);
        let from = Place { triangle: 19, b1: 0.3, b2: 0.45 };
        let [x, y] = torus.axes(from.triangle);
        for way in [Vec3::X, -Vec3::X, Vec3::Y, -Vec3::Y, Vec3::new(1.0, 2.0, 0.0)] {
            let step = Vec2::new(way.dot(x), way.dot(y)) * 4.0;
            let to = walk(&torus, from, step);
            assert!(!to.caught);
            let apart_cm = torus.point(to.place).distance(torus.point(from));
            assert!(apart_cm < 1e-4, "{way}: {apart_cm} cm");
        }
        // Half the way ends on the other side, wherever the seam is.
        let step = Vec2::new(x.x, y.x) * 2.0;
        let there = torus.point(walk(&torus, from, step).place);
        let gone = (there - torus.point(from)).x.rem_euclid(4.0);
        assert!((gone - 2.0).abs() < 1e-4, "{gone}");
    }
}
