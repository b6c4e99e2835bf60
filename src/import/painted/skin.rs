//! The skin of a plant that is painted on, as a stage shows it: what lies under its points, and where a stroke is seen.

use super::stroke::{Spot, Stroke, Way};
use super::ways::{lines_of, nearest};
use crate::plants::Plant;
use crate::play::Scene;
use crate::play::camera::{Camera, Sphere};
use crate::play::outline::Outline;
use crate::play::pick::Picked;
use crate::surface::{Body, NO_TWIN, Place};
use glam::{Mat4, Vec2, Vec3};

/// Steps of a straight line between two places.
const STEPS: u32 = 24;

/// A body that is painted on.
pub struct Skin {
    body: Body,
    sphere: Sphere,
}

/// How a stage shows it.
pub struct Seen<'a> {
    /// The body of the day.
    body: std::borrow::Cow<'a, Body>,
    sphere: Sphere,
    camera: Camera,
    stage_px: Vec2,
}

impl Skin {
    /// That of a plant, of which `obj` is the text of its mesh.
    ///
    /// # Errors
    /// In plain words, why there is no such body.
    pub fn new(plant: &Plant, obj: &str) -> Result<Skin, String> {
        let body = plant.grow_body(obj).map_err(|why| why.to_string())?;
        let sphere = Sphere::around(&body);
        Ok(Skin { body, sphere })
    }

    /// A length that suits it, the radius of its ball, in centimetres.
    pub fn size_cm(&self) -> f32 {
        self.sphere.radius
    }

    /// As a stage of so many pixels shows it in a scene.
    pub fn seen(&self, scene: &Scene, stage_px: Vec2) -> Seen<'_> {
        Seen {
            body: self.body.on(scene.day),
            sphere: self.sphere,
            camera: Camera::new(scene.orbit),
            stage_px,
        }
    }
}

impl Seen<'_> {
    /// Takes a stroke on to the places that lie under points of the stage, in its pixels; without any, straight to the
    /// place that is seen nearest to the middle.
    pub fn lead(&self, stroke: &mut Stroke, at_px: &[Vec2]) {
        if at_px.is_empty() {
            let to = self.outline().pick_middle().map(|picked| self.spot_of(&picked));
            let from = stroke.points.last().copied();
            match from.zip(to) {
                Some((from, to)) => stroke.points.extend(self.between([from, to])),
                None => stroke.points.extend(to),
            }
        }
        stroke.points.extend(at_px.iter().filter_map(|&at| self.spot(at)));
        stroke.points.dedup();
    }

    fn outline(&self) -> Outline<'_> {
        Outline { body: &self.body, sphere: &self.sphere, camera: &self.camera }
    }

    /// The middle of the stage and half a side of its centred square, in pixels.
    fn square(&self) -> (Vec2, f32) {
        (self.stage_px * 0.5, self.stage_px.min_element().max(2.0) * 0.5)
    }

    fn spot(&self, at_px: Vec2) -> Option<Spot> {
        let (middle, half) = self.square();
        let at = (at_px - middle) / half;
        self.outline().pick(Vec2::new(at.x, -at.y)).map(|picked| self.spot_of(&picked))
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

    /// Places from one to another, straight over the skin.
    fn between(&self, [from, to]: [Spot; 2]) -> impl Iterator<Item = Spot> {
        let mesh = &self.body.surface;
        let [from, to] = [from, to].map(|spot| mesh.point(spot.place()));
        (1..=STEPS)
            .map(move |k| from + (to - from) * (k as f32 / STEPS as f32))
            .map(move |at| Spot::of(nearest(mesh, at)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::import::Brush;
    use crate::plants;
    use crate::play::FIRST_INDIVIDUAL;
    use crate::tissue::CellType;

    fn stroke(way: Way) -> Stroke {
        let brush = Brush::Put(CellType::Foreground);
        Stroke { brush, radius: 500, way, is_mirrored: false, points: vec![] }
    }

    #[test]
    fn a_stroke_is_seen_where_it_was_drawn() {
        for key in ["watermelon", "croton", "lily"] {
            let scene = Scene::preset(plants::find(key).unwrap(), FIRST_INDIVIDUAL);
            let skin = Skin::new(scene.plant, scene.plant.body.mesh.text).unwrap();
            let stage_px = Vec2::new(640.0, 480.0);
            let seen = skin.seen(&scene, stage_px);
            // From the plant's middle, wherever that is, some steps to the side.
            let mut start = stroke(Way::Free);
            seen.lead(&mut start, &[]);
            let from_px = seen.lines(&start).0[0][0];
            let at_px: Vec<Vec2> = (0..6).map(|k| from_px + Vec2::X * (3 * k) as f32).collect();
            let mut drawn = stroke(Way::Free);
            seen.lead(&mut drawn, &at_px[..2]);
            seen.lead(&mut drawn, &at_px[2..]);
            let (lines, width_px) = seen.lines(&drawn);
            assert!((0.5..200.0).contains(&width_px), "{key}: {width_px}");
            assert!(drawn.points.len() > 2, "{key}: {drawn:?}");
            for at in lines.iter().flatten() {
                let off = at_px.iter().map(|px| px.distance(*at)).fold(f32::INFINITY, f32::min);
                // A place is written in 35ths of its triangle.
                assert!(off < 4.0, "{key}: {off} px");
            }
            // Beside the plant there is nothing.
            let mut beside = stroke(Way::Free);
            seen.lead(&mut beside, &[Vec2::ZERO]);
            assert!(beside.points.is_empty(), "{key}");
        }
    }

    #[test]
    fn without_a_point_a_stroke_goes_straight_to_the_middle() {
        let scene = Scene::preset(plants::find("watermelon").unwrap(), FIRST_INDIVIDUAL);
        let skin = Skin::new(scene.plant, scene.plant.body.mesh.text).unwrap();
        let seen = skin.seen(&scene, Vec2::splat(500.0));
        let mut line = stroke(Way::Free);
        seen.lead(&mut line, &[Vec2::new(200.0, 250.0)]);
        let first = line.points[0];
        seen.lead(&mut line, &[]);
        let (from, to) = (seen.lines(&line).0[0][0], *seen.lines(&line).0[0].last().unwrap());
        assert_eq!(line.points[0], first);
        assert!(line.points.len() > 5 && line.points.len() <= 1 + STEPS as usize);
        assert!(from.distance(Vec2::new(200.0, 250.0)) < 4.0, "{from}");
        assert!(to.distance(Vec2::splat(250.0)) < 4.0, "{to}");
    }
}
