//! The skin of the plant that is painted on, as it is seen: what is under a point of the stage, and where a stroke
//! lies on it.

use super::subject;
use crate::browser::dom::find;
use crate::import::{Spot, Stroke, Way, lines_of};
use crate::plants::Plant;
use crate::play::camera::{Camera, Sphere};
use crate::play::outline::Outline;
use crate::play::pick::Picked;
use crate::surface::{Body, NO_TWIN, Place};
use glam::{Mat4, Vec2, Vec3};
use web_sys::HtmlElement;

/// A body that is painted on.
pub struct Skin {
    pub base: &'static Plant,
    /// The text of its mesh.
    pub obj: String,
    body: Body,
    sphere: Sphere,
}

/// How the stage shows it now.
pub struct Seen {
    /// The body of the day.
    body: Body,
    sphere: Sphere,
    camera: Camera,
    stage: HtmlElement,
}

impl Skin {
    pub fn new(base: &'static Plant, obj: String) -> Result<Skin, String> {
        let body = base.grow_body(&obj).map_err(|why| why.to_string())?;
        let sphere = Sphere::around(&body);
        Ok(Skin { base, obj, body, sphere })
    }

    /// A length that suits it, the radius of its ball, in centimetres.
    pub fn size_cm(&self) -> f32 {
        self.sphere.radius
    }

    pub fn seen(&self) -> Seen {
        let scene = subject::wished();
        Seen {
            body: self.body.on(scene.day).into_owned(),
            sphere: self.sphere,
            camera: Camera::new(scene.orbit),
            stage: find("stage"),
        }
    }
}

impl Seen {
    fn outline(&self) -> Outline<'_> {
        Outline { body: &self.body, sphere: &self.sphere, camera: &self.camera }
    }

    /// The middle of the stage and half a side of its centred square, in pixels of the stage.
    fn square(&self) -> (Vec2, f32) {
        let size = Vec2::new(self.stage.client_width() as f32, self.stage.client_height() as f32);
        (size * 0.5, size.min_element().max(2.0) * 0.5)
    }

    /// The place under a point of the stage.
    pub fn spot(&self, at_px: Vec2) -> Option<Spot> {
        let (middle, half) = self.square();
        let at = (at_px - middle) / half;
        self.outline().pick(Vec2::new(at.x, -at.y)).map(|picked| self.spot_of(&picked))
    }

    /// The place that is seen nearest to the middle.
    pub fn middle(&self) -> Option<Spot> {
        self.outline().pick_middle().map(|picked| self.spot_of(&picked))
    }

    fn spot_of(&self, picked: &Picked) -> Spot {
        let b = self.body.surface.frames[picked.triangle].barycentric(picked.place_cm);
        let third = 1.0 / 3.0;
        Spot::of(Place { triangle: picked.triangle as u32, b1: third + b.x, b2: third + b.y })
    }

    /// Where a stroke is seen: lines in pixels of the stage, and their width.
    pub fn lines(&self, stroke: &Stroke) -> (Vec<Vec<Vec2>>, f32) {
        let mesh = &self.body.surface;
        let to_clip = self.camera.view_projection(&self.sphere, 1, 1);
        let (middle, half) = self.square();
        let to_px = |to_clip: &Mat4, at: Vec3| {
            let at = to_clip.project_point3(at);
            middle + Vec2::new(at.x, -at.y) * half
        };
        let eye = self.camera.eye(&self.sphere);
        let is_closed = !mesh.twins.contains(&NO_TWIN);
        let faces = |triangle: u32, at: Vec3| {
            let [a, b, c] = mesh.corners(triangle);
            !is_closed || (b - a).cross(c - a).dot(eye - at) > 0.0
        };
        let mut seen = Vec::new();
        let mut width_px = 0.0f32;
        for line in lines_of(stroke, mesh).unwrap_or_default() {
            let mut run: Vec<Vec2> = Vec::new();
            for on in line {
                if faces(on.triangle, on.at) {
                    run.push(to_px(&to_clip, on.at));
                    let right = Vec3::Y.cross(eye - on.at).normalize_or(Vec3::X);
                    let aside = to_px(&to_clip, on.at + right * (stroke.radius as f32 * 0.001));
                    width_px = width_px.max(2.0 * aside.distance(run[run.len() - 1]));
                } else if !run.is_empty() {
                    seen.push(std::mem::take(&mut run));
                }
            }
            seen.push(run);
        }
        seen.retain(|run| !run.is_empty());
        (seen, if stroke.way == Way::Part { half } else { width_px })
    }

    /// So many places from one to another, straight over the skin.
    pub fn between(&self, [from, to]: [Spot; 2]) -> Vec<Spot> {
        const STEPS: u32 = 24;
        let mesh = &self.body.surface;
        let [from, to] = [from, to].map(|spot| mesh.point(spot.place()));
        (0..=STEPS)
            .map(|k| from + (to - from) * (k as f32 / STEPS as f32))
            .map(|at| Spot::of(crate::import::nearest(mesh, at)))
            .collect()
    }
}
