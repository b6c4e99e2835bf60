//! What is seen through each pixel of the canvas, found by rays.

use crate::page::Picture;
use clonal_mosaic::play::Scene;
use clonal_mosaic::play::camera::{Camera, Sphere};
use clonal_mosaic::surface::{Body, Place};
use glam::{Mat4, Vec2, Vec3};

/// A body as it is seen in a picture.
pub struct Rays {
    pub body: Body,
    from_clip: Mat4,
    size: Vec2,
}

impl Rays {
    pub fn of(scene: &Scene, picture: &Picture) -> Rays {
        let body = scene.plant.embedded_body();
        let camera = Camera::new(scene.orbit);
        let (width, height) = (picture.width as u32, picture.height as u32);
        let view_projection = camera.view_projection(&Sphere::around(&body), width, height);
        let size = Vec2::new(width as f32, height as f32);
        Rays { body, from_clip: view_projection.inverse(), size }
    }

    /// The place of the patterned surface that is seen through a point of the picture, in pixels;
    /// none where something else is seen.
    pub fn surface_at(&self, pixel: Vec2) -> Option<Place> {
        let clip = (pixel / self.size * 2.0 - Vec2::ONE) * Vec2::new(1.0, -1.0);
        let near = self.from_clip.project_point3(clip.extend(0.0));
        let far = self.from_clip.project_point3(clip.extend(1.0));
        let mesh = &self.body.surface;
        let (time, place) = nearest_hit(near, far, &mesh.positions, &mesh.triangles)?;
        let hidden = self.body.ornaments.iter().any(|ornament| {
            nearest_hit(near, far, &ornament.positions, &ornament.triangles)
                .is_some_and(|(before, _)| before < time)
        });
        (!hidden).then_some(place)
    }
}

/// The first triangle on the way between two points, and how far along it is met (Moeller and
/// Trumbore 1997).
fn nearest_hit(
    from: Vec3,
    to: Vec3,
    positions: &[Vec3],
    triangles: &[[u32; 3]],
) -> Option<(f32, Place)> {
    let way = to - from;
    let mut nearest: Option<(f32, Place)> = None;
    for (triangle, corners) in (0..).zip(triangles) {
        let [a, b, c] = corners.map(|v| positions[v as usize]);
        let (edge1, edge2) = (b - a, c - a);
        let across = way.cross(edge2);
        let volume = edge1.dot(across);
        let b1 = (from - a).dot(across) / volume;
        let other = (from - a).cross(edge1);
        let b2 = way.dot(other) / volume;
        let time = edge2.dot(other) / volume;
        let inside = b1 >= 0.0 && b2 >= 0.0 && b1 + b2 <= 1.0;
        if inside && time > 0.0 && nearest.is_none_or(|(before, _)| time < before) {
            nearest = Some((time, Place { triangle, b1, b2 }));
        }
    }
    nearest
}
