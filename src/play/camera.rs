//! The orbit camera: turns around the middle of a body, and fits the body's bounding sphere into the
//! centred square of the picture, so that a square still picture coincides with the live one.

use crate::plants::{Plant, View};
use crate::surface::Body;
use glam::camera::rh::{proj::directx::perspective, view::look_at_mat4};
use glam::{Mat4, Vec2, Vec3};

/// Opening angle of the centred square at zoom 1. Wider bends the near leaves towards the eye,
/// narrower flattens the shrub.
const FIELD_DEG: f32 = 24.0;
/// The least zoom leaves the plant a third of the picture, the greatest shows single cells.
const ZOOM: [f32; 2] = [0.4, 40.0];
/// At 90 degrees "up" loses its meaning, and far below the horizon a fruit shows where it lay.
const ELEVATION_DEG: [f32; 2] = [-60.0, 88.0];
/// The least for a plant whose pot or bed would hide it from below, and for one on moss: far enough to
/// look up at the gills, and not yet through the moss into the stem.
const LOWEST_IN_SOIL_DEG: f32 = -8.0;
const LOWEST_ON_MOSS_DEG: f32 = -22.0;
/// How far the middle may be moved aside, in bounding radii: the plant's rim stays in reach.
const PAN_LIMIT: f32 = 1.2;
/// Seconds in which the shown orbit does 63% of its way to the wished one. Longer feels heavy,
/// shorter shows the steps of a wheel.
const EASE_S: f32 = 0.07;

/// From where a body is looked at. The eye of azimuth 0 stands on the `+z` side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orbit {
    /// Degrees around the upright axis.
    pub azimuth_deg: f32,
    /// Degrees above the horizon.
    pub elevation_deg: f32,
    /// 1: the bounding sphere just fills the centred square.
    pub zoom: f32,
    /// How far the middle of the picture lies right of and above the body's, in bounding radii.
    pub pan: Vec2,
}

/// The ball around a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    pub centre: Vec3,
    pub radius: f32,
}

/// A wished orbit and the one that is shown, which eases towards it.
#[derive(Clone, Debug)]
pub struct Camera {
    wished: Orbit,
    shown: Orbit,
}

impl Sphere {
    /// The ball around the box around a body with all its bare parts, at all its moments.
    pub fn around(body: &Body) -> Sphere {
        let (centre, radius, _) = body.ball();
        Sphere { centre, radius }
    }
}

impl Orbit {
    /// The view that suits a plant.
    pub fn of(view: &View) -> Orbit {
        let View { azimuth_deg, elevation_deg, zoom } = *view;
        Orbit { azimuth_deg, elevation_deg, zoom, pan: Vec2::ZERO }.limited()
    }

    /// Turns by angles in degrees, to the right and upwards.
    pub fn turned(self, right_deg: f32, up_deg: f32) -> Orbit {
        let azimuth_deg = self.azimuth_deg + right_deg;
        Orbit { azimuth_deg, elevation_deg: self.elevation_deg + up_deg, ..self }.limited()
    }

    /// Zooms by a factor, and keeps what is under a point in place: `at` is -1 to 1 over the centred
    /// square, `y` upwards.
    pub fn zoomed(self, factor: f32, at: Vec2) -> Orbit {
        let zoom = (self.zoom * factor).clamp(ZOOM[0], ZOOM[1]);
        let pan = self.pan + at * half_square() * (1.0 / self.zoom - 1.0 / zoom);
        Orbit { zoom, pan, ..self }.limited()
    }

    /// Moves the picture by a vector in half sides of the centred square, `y` upwards.
    pub fn panned(self, by: Vec2) -> Orbit {
        Orbit { pan: self.pan - by * half_square() / self.zoom, ..self }.limited()
    }

    /// The lowest elevation from which there is something of a plant to see.
    pub fn lowest_deg(plant: &Plant) -> f32 {
        match (plant.has_bare("soil"), plant.has_bare("moss")) {
            (true, _) => LOWEST_IN_SOIL_DEG,
            (_, true) => LOWEST_ON_MOSS_DEG,
            _ => ELEVATION_DEG[0],
        }
    }

    /// The same orbit, or the lowest one that is allowed.
    pub fn above(self, lowest_deg: f32) -> Orbit {
        Orbit { elevation_deg: self.elevation_deg.max(lowest_deg), ..self }
    }

    /// The same orbit within the limits; the azimuth in `0..360`.
    pub fn limited(self) -> Orbit {
        Orbit {
            azimuth_deg: self.azimuth_deg.rem_euclid(360.0),
            elevation_deg: self.elevation_deg.clamp(ELEVATION_DEG[0], ELEVATION_DEG[1]),
            zoom: self.zoom.clamp(ZOOM[0], ZOOM[1]),
            pan: self.pan.clamp_length_max(PAN_LIMIT),
        }
    }

    /// As a link writes it: whole degrees, and zoom and pan in hundredths.
    pub fn rounded(self) -> Orbit {
        let hundredths = |x: f32| (x * 100.0).round() / 100.0;
        Orbit {
            azimuth_deg: self.azimuth_deg.round(),
            elevation_deg: self.elevation_deg.round(),
            zoom: hundredths(self.zoom),
            pan: Vec2::new(hundredths(self.pan.x), hundredths(self.pan.y)),
        }
        .limited()
    }
}

impl Camera {
    pub fn new(orbit: Orbit) -> Camera {
        Camera { wished: orbit, shown: orbit }
    }

    pub fn wished(&self) -> Orbit {
        self.wished
    }

    /// Wishes another orbit; the shown one takes the shorter way round.
    pub fn wish(&mut self, orbit: Orbit) {
        self.wished = orbit;
        let turn = self.shown.azimuth_deg - orbit.azimuth_deg;
        self.shown.azimuth_deg -= 360.0 * (turn / 360.0).round();
    }

    /// Shows the wished orbit at once.
    pub fn jump(&mut self) {
        self.shown = self.wished;
    }

    pub fn at_rest(&self) -> bool {
        self.shown == self.wished
    }

    /// Eases the shown orbit for a time in seconds.
    pub fn advance(&mut self, seconds: f32) {
        let share = 1.0 - libm::expf(-seconds / EASE_S);
        let ease = |from: f32, to: f32| from + (to - from) * share;
        let (from, to) = (self.shown, self.wished);
        self.shown = Orbit {
            azimuth_deg: ease(from.azimuth_deg, to.azimuth_deg),
            elevation_deg: ease(from.elevation_deg, to.elevation_deg),
            // Zoom is felt as a ratio.
            zoom: from.zoom * libm::powf(to.zoom / from.zoom, share),
            pan: from.pan.lerp(to.pan, share),
        };
        let near = (from.azimuth_deg - to.azimuth_deg).abs() < 0.02
            && (from.elevation_deg - to.elevation_deg).abs() < 0.02
            && (from.zoom / to.zoom - 1.0).abs() < 0.0005
            && from.pan.distance(to.pan) < 0.0005;
        if near {
            self.jump();
        }
    }

    /// The one that shows the wished orbit.
    pub fn arrived(&self) -> Camera {
        Camera::new(self.wished)
    }

    /// Where the eye stands.
    pub fn eye(&self, sphere: &Sphere) -> Vec3 {
        self.middle(sphere) + self.backward() * distance(sphere)
    }

    /// World to clip space (depth 0 to 1) for a picture of a width and height in pixels.
    pub fn view_projection(&self, sphere: &Sphere, width_px: u32, height_px: u32) -> Mat4 {
        let (width, height) = (width_px.max(1) as f32, height_px.max(1) as f32);
        let square = width.min(height);
        let tan_half = libm::tanf(half_field_rad()) * height / square / self.shown.zoom;
        let far = distance(sphere);
        // The ground's shadow reaches beyond the ball: leave it room.
        let (near, far) = (far - 1.5 * sphere.radius, far + 3.0 * sphere.radius);
        let projection = perspective(2.0 * libm::atanf(tan_half), width / height, near, far);
        projection * look_at_mat4(self.eye(sphere), self.middle(sphere), Vec3::Y)
    }

    fn middle(&self, sphere: &Sphere) -> Vec3 {
        let backward = self.backward();
        let right = Vec3::Y.cross(backward).normalize_or(Vec3::X);
        let up = backward.cross(right);
        sphere.centre + (right * self.shown.pan.x + up * self.shown.pan.y) * sphere.radius
    }

    /// Unit vector from the body to the eye.
    fn backward(&self) -> Vec3 {
        let azimuth_rad = self.shown.azimuth_deg.to_radians();
        let elevation_rad = self.shown.elevation_deg.to_radians();
        let level = libm::cosf(elevation_rad);
        Vec3::new(
            libm::sinf(azimuth_rad) * level,
            libm::sinf(elevation_rad),
            libm::cosf(azimuth_rad) * level,
        )
    }
}

fn half_field_rad() -> f32 {
    0.5 * FIELD_DEG.to_radians()
}

/// From the eye to the middle, so that the ball touches the sides of the square at zoom 1.
fn distance(sphere: &Sphere) -> f32 {
    sphere.radius / libm::sinf(half_field_rad())
}

/// Half a side of the square at the body's middle, in bounding radii, at zoom 1.
fn half_square() -> f32 {
    1.0 / libm::cosf(half_field_rad())
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec4Swizzles;

    const SPHERE: Sphere = Sphere { centre: Vec3::new(1.0, 8.0, -2.0), radius: 9.0 };

    fn orbit() -> Orbit {
        Orbit { azimuth_deg: 30.0, elevation_deg: 20.0, zoom: 1.0, pan: Vec2::ZERO }
    }

    fn clip(camera: &Camera, width: u32, height: u32, point: Vec3) -> Vec3 {
        let clip = camera.view_projection(&SPHERE, width, height) * point.extend(1.0);
        clip.xyz() / clip.w
    }

    /// The farthest that any point of the ball lies from the middle of the picture, in pixels.
    fn reach_px(camera: &Camera, width: u32, height: u32) -> f32 {
        let mut reach = 0f32;
        for k in 0..4000 {
            let (z, turn) = (1.0 - (k as f32 + 0.5) / 2000.0, k as f32 * 2.399_963);
            let level = (1.0 - z * z).sqrt();
            let unit = Vec3::new(level * libm::cosf(turn), level * libm::sinf(turn), z);
            let at = clip(camera, width, height, SPHERE.centre + unit * SPHERE.radius);
            assert!((0.0..=1.0).contains(&at.z), "the ball is never cut by the planes");
            reach = reach.max((at.x * width as f32 * 0.5).hypot(at.y * height as f32 * 0.5));
        }
        reach
    }

    #[test]
    fn the_ball_fills_the_centred_square() {
        let camera = Camera::new(orbit());
        for (width, height) in [(800, 800), (1440, 700), (390, 700)] {
            let half = width.min(height) as f32 / 2.0;
            let reach = reach_px(&camera, width, height);
            assert!((reach / half - 1.0).abs() < 0.01, "{width} x {height}: {reach} of {half}");
        }
    }

    #[test]
    fn zoom_keeps_the_point_under_the_pointer() {
        let mut camera = Camera::new(orbit());
        let at = Vec2::new(0.3, -0.2);
        let point_under = |camera: &Camera| {
            let back = camera.view_projection(&SPHERE, 600, 600).inverse();
            // The point of the plane through the middle of the body that faces the eye.
            let near = back.project_point3(at.extend(0.0));
            let far = back.project_point3(at.extend(1.0));
            let normal = camera.backward();
            let t = (SPHERE.centre - near).dot(normal) / (far - near).dot(normal);
            near + (far - near) * t
        };
        let before = point_under(&camera);
        camera.wish(camera.wished().zoomed(3.0, at));
        camera.jump();
        let after = point_under(&camera);
        assert!(before.distance(after) < 0.01, "{before} and {after}");
    }

    #[test]
    fn an_eased_camera_takes_the_short_way_and_comes_to_rest() {
        let mut camera = Camera::new(Orbit { azimuth_deg: 350.0, ..orbit() });
        camera.wish(Orbit { azimuth_deg: 10.0, ..orbit() });
        assert!((camera.shown.azimuth_deg - -10.0).abs() < 1e-4);
        let mut frames = 0;
        while !camera.at_rest() {
            camera.advance(1.0 / 60.0);
            frames += 1;
        }
        assert!((5..60).contains(&frames), "{frames}");
    }

    #[test]
    fn only_plants_with_an_underside_are_seen_from_below() {
        let low = |key| {
            let plant = crate::plants::find(key).unwrap();
            orbit().turned(0.0, -500.0).above(Orbit::lowest_deg(plant)).elevation_deg
        };
        for key in ["watermelon", "long-watermelon", "square-watermelon"] {
            assert_eq!(low(key), -60.0, "{key}");
        }
        for key in ["mushroom", "amanita"] {
            assert_eq!(low(key), -22.0, "{key}");
        }
        for key in ["croton", "cactus", "philodendron", "sansevieria"] {
            assert_eq!(low(key), -8.0, "{key}");
        }
    }

    #[test]
    fn limits_hold() {
        let far = orbit().turned(0.0, 500.0).zoomed(1e9, Vec2::ZERO).panned(Vec2::splat(1e9));
        assert_eq!(far.elevation_deg, 88.0);
        assert_eq!(far.zoom, 40.0);
        assert!(far.pan.length() <= 1.2001);
        assert!(!Camera::new(far).at_rest() || Camera::new(far).eye(&SPHERE).is_finite());
    }
}
