//! What lies near an open rim, mirrored in it: images as if the surface went on behind the rim and were its
//! own mirror image there.

use super::chart::{Image, image};
use super::lengths::normalized;
use super::outline::Outline;
use super::{Mesh, NO_TWIN};
use glam::Vec2;

/// Adds to the images of a patch, each mirrored in the edge of a rim that its middle is nearest to, those that
/// come within `reach` (centimetres) of the patch.
pub(super) fn add_mirrored(mesh: &Mesh, images: &mut Vec<Image>, outline: &Outline, reach: f32) {
    let mut rims: Vec<[Vec2; 2]> = Vec::new();
    for image in &*images {
        let corners = image.laid.corners();
        for k in 0..3 {
            let edge = [corners[(k + 1) % 3], corners[(k + 2) % 3]];
            let is_rim = mesh.twins[3 * image.triangle as usize + k] == NO_TWIN;
            if is_rim && outline.is_within(reach, &edge) {
                rims.push(edge);
            }
        }
    }
    for k in 0..images.len() {
        let (triangle, laid) = (images[k].triangle, images[k].laid);
        let middle = laid.centroid();
        let distance = |rim: &[Vec2; 2]| distance_squared(middle, *rim);
        let Some(&rim) = rims.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))) else {
            return;
        };
        let corners = laid.corners().map(|corner| mirrored(corner, rim));
        if outline.is_within(reach, &corners) {
            images.push(image(triangle, 0.0, corners));
        }
    }
}

fn distance_squared(point: Vec2, [from, to]: [Vec2; 2]) -> f32 {
    let (edge, arm) = (to - from, point - from);
    let share = (arm.dot(edge) / edge.length_squared()).clamp(0.0, 1.0);
    (arm - edge * share).length_squared()
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
        assert!((distance_squared(Vec2::new(1.0, 7.0), rim) - 9.0).abs() < 1e-4);
        assert!((distance_squared(Vec2::new(1.0, -2.0), rim) - 16.0).abs() < 1e-4);
    }
}
