//! What lies near an open rim, mirrored in it: images as if the surface went on behind the rim and were its
//! own mirror image there.

use super::chart::{Image, image};
use super::lengths::normalized;
use super::outline::Outline;
use super::{Mesh, NO_TWIN};
use glam::{Vec2, Vec3};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// For each triangle the half-edge of a rim that its centre is nearest to, found from neighbour to neighbour;
/// `NO_TWIN` where its part has no rim.
pub(super) fn nearest_rims(mesh: &Mesh) -> Vec<u32> {
    let mut nearest = vec![NO_TWIN; mesh.triangles.len()];
    // By distance, whose bits order as it does, then by the numbers of triangle and rim.
    let mut waiting: BinaryHeap<Reverse<(u32, u32, u32)>> = BinaryHeap::new();
    let candidate = |triangle: u32, rim: u32| {
        let (corners, k) = (mesh.corners(rim / 3), rim as usize % 3);
        let edge = [corners[(k + 1) % 3], corners[(k + 2) % 3]];
        Reverse((distance_squared(mesh.centroid(triangle), edge).to_bits(), triangle, rim))
    };
    for (rim, &twin) in (0..).zip(&mesh.twins) {
        if twin == NO_TWIN {
            waiting.push(candidate(rim / 3, rim));
        }
    }
    while let Some(Reverse((_, triangle, rim))) = waiting.pop() {
        if nearest[triangle as usize] != NO_TWIN {
            continue;
        }
        nearest[triangle as usize] = rim;
        for &twin in &mesh.twins[3 * triangle as usize..3 * triangle as usize + 3] {
            if twin != NO_TWIN && nearest[twin as usize / 3] == NO_TWIN {
                waiting.push(candidate(twin / 3, rim));
            }
        }
    }
    nearest
}

fn distance_squared(point: Vec3, [from, to]: [Vec3; 2]) -> f32 {
    let (edge, arm) = (to - from, point - from);
    let share = (arm.dot(edge) / edge.length_squared()).clamp(0.0, 1.0);
    (arm - edge * share).length_squared()
}

/// Adds to the images of a patch, each mirrored in the rim that its triangle is nearest to, those that come
/// within `reach` (centimetres) of the patch. `image_of`: for each triangle its index in `images`, if it has one.
pub(super) fn add_mirrored(
    nearest_rims: &[u32],
    images: &mut Vec<Image>,
    image_of: &[u32],
    outline: &Outline,
    reach: f32,
) {
    for k in 0..images.len() {
        let Image { triangle, laid, .. } = images[k];
        let rim = nearest_rims[triangle as usize];
        if rim == NO_TWIN {
            continue;
        }
        let Some(at_rim) = images.get(image_of[rim as usize / 3] as usize) else { continue };
        let (corners, k) = (at_rim.laid.corners(), rim as usize % 3);
        let rim = [corners[(k + 1) % 3], corners[(k + 2) % 3]];
        let corners = laid.corners().map(|corner| mirrored(corner, rim));
        if outline.is_within(reach, &corners) {
            images.push(image(triangle, 0.0, corners));
        }
    }
}

fn mirrored(point: Vec2, [from, to]: [Vec2; 2]) -> Vec2 {
    let along = normalized(to - from);
    let arm = point - from;
    from + along * (2.0 * arm.dot(along)) - arm
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_and_its_mirror_image_are_as_far_from_all_of_the_line() {
        let rim = [Vec2::new(1.0, 2.0), Vec2::new(4.0, 6.0)];
        for point in [Vec2::new(3.0, -1.0), Vec2::new(0.5, 0.25), Vec2::new(7.0, 9.0)] {
            let image = mirrored(point, rim);
            assert!(image.distance(mirrored(rim[0], rim)) - point.distance(rim[0]) < 1e-5);
            assert!((image.distance(rim[1]) - point.distance(rim[1])).abs() < 1e-5);
            assert!(mirrored(image, rim).distance(point) < 1e-5 && image.distance(point) > 0.1);
        }
    }

    #[test]
    fn triangles_know_the_rim_that_they_are_nearest_to() {
        // A row of squares: their long sides are nearer than the ends.
        let at = |k: u32| Vec3::new((k / 2) as f32, (k % 2) as f32, 0.0);
        let square = |k: u32| [[2 * k, 2 * k + 2, 2 * k + 3], [2 * k, 2 * k + 3, 2 * k + 1]];
        let mesh =
            Mesh::new((0..12).map(at).collect(), Vec::new(), (0..5).flat_map(square).collect());
        let mesh = mesh.unwrap();
        for (triangle, rim) in (0..).zip(nearest_rims(&mesh)) {
            let (corners, k) = (mesh.corners(rim / 3), rim as usize % 3);
            let edge = [corners[(k + 1) % 3], corners[(k + 2) % 3]];
            let to = |edge| distance_squared(mesh.centroid(triangle), edge);
            assert!((to(edge) - 1.0 / 9.0).abs() < 1e-5, "triangle {triangle}: {edge:?}");
        }
        assert_eq!(nearest_rims(&crate::surface::icosphere(0, 1.0)), [NO_TWIN; 20]);
    }
}
