//! Which place of a body is seen at a point of the picture.

use super::outline::Outline;
use crate::surface::Body;
use glam::{Vec2, Vec3};

/// A place on the surface: the triangle, and the place in its plane from its centroid, in centimetres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Picked {
    pub triangle: usize,
    pub place_cm: Vec2,
}

/// Steps from the middle to the rim of the picture when something is looked for around a point.
const RINGS: usize = 24;

impl Outline<'_> {
    /// What is seen at a point (-1 to 1 over the centred square); nothing where there is no surface, or
    /// something bare before it.
    pub fn pick(&self, at: Vec2) -> Option<Picked> {
        let back = self.camera.view_projection(self.sphere, 1, 1).inverse();
        let [eye, far] = [0.0, 1.0].map(|depth| back.project_point3(at.extend(depth)));
        let way = far - eye;
        let Body { surface, ornaments } = self.body;
        let mut first = (f32::INFINITY, None);
        for (triangle, corners) in surface.triangles.iter().enumerate() {
            let corners = corners.map(|vertex| surface.positions[vertex as usize]);
            if let Some((depth, b1, b2)) = hit(eye, way, corners).filter(|hit| hit.0 < first.0) {
                let frame = &surface.frames[triangle];
                let third = 1.0 / 3.0;
                let place_cm = frame.point(b1, b2) - frame.point(third, third);
                first = (depth, Some(Picked { triangle, place_cm }));
            }
        }
        for part in ornaments {
            for corners in &part.triangles {
                let corners = corners.map(|vertex| part.positions[vertex as usize]);
                if hit(eye, way, corners).is_some_and(|hit| hit.0 < first.0) {
                    return None;
                }
            }
        }
        first.1
    }

    /// What is seen nearest to the middle of the picture.
    pub fn pick_middle(&self) -> Option<Picked> {
        let at = |ring: usize, step: usize| {
            let turn = step as f32 / (6 * ring).max(1) as f32 * std::f32::consts::TAU;
            let (sin, cos) = libm::sincosf(turn);
            Vec2::new(cos, sin) * (ring as f32 / RINGS as f32)
        };
        (0..=RINGS)
            .find_map(|ring| (0..(6 * ring).max(1)).find_map(|step| self.pick(at(ring, step))))
    }
}

/// Where a ray meets a triangle: how far along the way, and the barycentric coordinates (Möller and
/// Trumbore 1997).
fn hit(eye: Vec3, way: Vec3, [a, b, c]: [Vec3; 3]) -> Option<(f32, f32, f32)> {
    let (along, across) = (b - a, c - a);
    let normal = along.cross(across);
    let facing = normal.dot(way);
    if facing == 0.0 {
        return None;
    }
    let from = eye - a;
    let turned = way.cross(from) / facing;
    let (b1, b2) = (across.dot(turned), -along.dot(turned));
    let depth = -normal.dot(from) / facing;
    (b1 >= 0.0 && b2 >= 0.0 && b1 + b2 <= 1.0 && depth >= 0.0).then_some((depth, b1, b2))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants;
    use crate::play::camera::{Camera, Orbit, Sphere};

    #[test]
    fn a_place_is_picked_where_it_is_seen() {
        let (mut seen, mut hidden) = (0, 0);
        for key in ["croton", "cactus", "watermelon", "mushroom"] {
            let plant = plants::find(key).unwrap();
            let body = plant.embedded_body();
            let sphere = Sphere::around(&body);
            let camera = Camera::new(Orbit::of(&plant.view));
            let outline = Outline { body: &body, sphere: &sphere, camera: &camera };
            let to_clip = camera.view_projection(&sphere, 1, 1);
            let mesh = &body.surface;
            for triangle in (0..mesh.triangles.len()).step_by(97) {
                let point = mesh.centroid(triangle as u32);
                let at = to_clip.project_point3(point);
                let Some(picked) = outline.pick(at.truncate()) else {
                    hidden += 1;
                    continue;
                };
                if picked.triangle == triangle {
                    // Its centroid.
                    let size = mesh.frames[triangle].length;
                    assert!(picked.place_cm.length() < 0.01 * size, "{key}: {picked:?}");
                    seen += 1;
                } else {
                    // Something that lies before it.
                    let [x, y] = mesh.axes(picked.triangle as u32);
                    let flat = x * picked.place_cm.x + y * picked.place_cm.y;
                    let before =
                        to_clip.project_point3(mesh.centroid(picked.triangle as u32) + flat);
                    assert!(before.truncate().distance(at.truncate()) < 1e-3, "{key}");
                    assert!(before.z < at.z, "{key}: {before} and {at}");
                    hidden += 1;
                }
            }
            assert!(outline.pick(Vec2::new(3.0, 3.0)).is_none(), "beside the plant");
            assert!(outline.pick_middle().is_some(), "{key}");
        }
        assert!(seen > 50 && hidden > 50, "{seen} seen, {hidden} hidden");
    }
}
