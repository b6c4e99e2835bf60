//! Where in the picture a plant lies: what zooms go to, and whether there is anything to be seen.
//! Points are -1 to 1 over the centred square of the picture, `y` upwards.

use super::camera::{Camera, Sphere};
use crate::surface::Body;
use glam::{Vec2, Vec3};

/// A plant as a camera sees it.
#[derive(Clone, Copy)]
pub struct Outline<'a> {
    pub body: &'a Body,
    pub sphere: &'a Sphere,
    pub camera: &'a Camera,
}

impl Outline<'_> {
    /// The point itself if it lies on the plant, else the corner of the plant that is nearest to it.
    pub fn nearest(&self, point: Vec2) -> Vec2 {
        let mut nearest = (f32::INFINITY, point);
        for corners in self.triangles() {
            if contains(corners, point) {
                return point;
            }
            for corner in corners {
                let distance = corner.distance_squared(point);
                if distance < nearest.0 {
                    nearest = (distance, corner);
                }
            }
        }
        nearest.1
    }

    /// Whether some of the plant may be in a picture that reaches so far to each side. Told from the
    /// boxes around its triangles.
    pub fn is_in_sight(&self, half: Vec2) -> bool {
        self.triangles().any(|[a, b, c]| {
            let (low, high) = (a.min(b).min(c), a.max(b).max(c));
            low.cmple(half).all() && high.cmpge(-half).all()
        })
    }

    /// The corners of all triangles in the picture, bare parts included.
    fn triangles(&self) -> impl Iterator<Item = [Vec2; 3]> {
        let to_clip = self.camera.view_projection(self.sphere, 1, 1);
        let Body { surface, ornaments } = self.body;
        let bare = ornaments.iter().map(|part| (&part.positions, &part.triangles));
        let parts = [(&surface.positions, &surface.triangles)].into_iter().chain(bare);
        parts.flat_map(move |(positions, triangles)| {
            let place = move |vertex: u32| {
                let point: Vec3 = to_clip.project_point3(positions[vertex as usize]);
                point.truncate()
            };
            triangles.iter().map(move |corners| corners.map(place))
        })
    }
}

fn contains([a, b, c]: [Vec2; 3], point: Vec2) -> bool {
    let sides = [(a, b), (b, c), (c, a)].map(|(from, to)| (to - from).perp_dot(point - from));
    sides.iter().all(|side| *side >= 0.0) || sides.iter().all(|side| *side <= 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants;
    use crate::play::camera::Orbit;

    const WHEEL_NOTCH: f32 = 1.1618;

    fn with_each_plant(check: impl Fn(&str, &Body, &Sphere, Orbit)) {
        for key in ["croton", "cactus", "mushroom", "watermelon", "sansevieria"] {
            let plant = plants::find(key).unwrap();
            let body = plant.embedded_body();
            check(key, &body, &Sphere::around(&body), Orbit::of(&plant.view));
        }
    }

    #[test]
    fn a_wheel_beside_the_plant_never_empties_the_picture() {
        with_each_plant(|key, body, sphere, first| {
            for beside in [Vec2::new(0.9, 0.9), Vec2::new(-1.5, 0.2), Vec2::new(0.1, -0.98)] {
                let (mut here, mut blind) = (first, first);
                for _ in 0..30 {
                    let camera = Camera::new(here);
                    let at = Outline { body, sphere, camera: &camera }.nearest(beside);
                    here = here.zoomed(WHEEL_NOTCH, at);
                    blind = blind.zoomed(WHEEL_NOTCH, beside);
                }
                let sees = |orbit| {
                    let camera = Camera::new(orbit);
                    Outline { body, sphere, camera: &camera }.is_in_sight(Vec2::new(1.6, 1.0))
                };
                assert!(sees(here), "{key} from {beside}");
                assert!(!sees(blind), "without that, {key} is lost from {beside}");
            }
        });
    }

    #[test]
    fn on_the_plant_the_point_itself_is_kept() {
        with_each_plant(|key, body, sphere, orbit| {
            let camera = Camera::new(Orbit { zoom: 20.0, ..orbit });
            let outline = Outline { body, sphere, camera: &camera };
            let triangle = outline.triangles().nth(100).unwrap();
            let middle = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
            assert_eq!(outline.nearest(middle), middle, "{key}");
        });
    }
}
