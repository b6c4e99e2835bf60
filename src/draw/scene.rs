//! The numbers of a frame as the shaders read them.

use super::{Frame, Marks, geometry::Bounds};
use crate::mosaic::CLAN_COLOURS;
use crate::plants::{CLAN_PALETTE, Diagram, Look, linear};
use bytemuck::{Pod, Zeroable};
use glam::{Mat4, Vec2, Vec3, Vec4};

/// Bare materials that a body may have.
pub const BARE_MATERIALS: usize = 16;

/// Side length of the shadow map in texels. Sharper shadows than this gives are not those of
/// daylight through a curtain.
pub const SHADOW_SIDE: u32 = 1024;

/// Pictures of which a still one is the mean.
pub const STILL_PICTURES: u32 = 16;
/// Sine of half the angle under which the key lamp is seen.
const LAMP: f32 = 0.12;
/// How far a point that lies a radius before or behind the middle is blurred, as a share of half the
/// picture's height: a breath.
const LENS: f32 = 0.002;
const GOLDEN_ANGLE_RAD: f32 = 2.399_963_2;

/// `Scene` in `scene.wgsl`.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub struct Scene {
    view_projection: Mat4,
    light_projection: Mat4,
    eye_moment: Vec4,
    key_texel: Vec4,
    cells: [Vec4; 3],
    tinted: [Vec4; 3],
    look: Vec4,
    tissue: Vec4,
    ground: Vec4,
    diagram: Vec4,
    ink: Vec4,
    skin: Vec4,
    clans: [Vec4; CLAN_COLOURS as usize],
    bare: [Vec4; BARE_MATERIALS],
}

impl Scene {
    /// Ground and veins of a body. `vein_lean` as `geometry::vein_lean` gives it.
    pub fn set_body(&mut self, bounds: &Bounds, vein_lean: f32) {
        self.tissue.y = vein_lean;
        self.ground = bounds.ground();
    }

    /// The colours of the cells and of the bare materials; `materials`: the names of those, by their
    /// numbers.
    pub fn set_look(&mut self, look: &Look, materials: &[String]) {
        let even = |colour| linear(colour).map(f32::sqrt);
        for (k, &colour) in look.cells.iter().enumerate() {
            self.cells[k] = even(colour).extend(look.skin.gloss[k]);
            self.tinted[k] = even(colour).extend(look.skin.raised[k]);
        }
        for &(kind, colour) in look.tinted {
            self.tinted[kind as usize] = even(colour).extend(look.skin.raised[kind as usize]);
        }
        self.look = Vec4::new(look.variation, look.border, look.gloss, flag(look.veins));
        (self.skin.x, self.skin.y) = (look.skin.wax, look.skin.unevenness);
        self.clans = CLAN_PALETTE.map(|colour| even(colour).extend(1.0));
        self.tissue.z = look.skin.through;
        for (bare, name) in self.bare.iter_mut().zip(materials) {
            let (colour, gloss) = look.of_bare(name);
            *bare = linear(colour).extend(gloss);
        }
    }

    /// Mean distance between neighbouring cells, in centimetres.
    pub fn set_mean_spacing(&mut self, mean_spacing_cm: f32) {
        self.tissue.x = mean_spacing_cm.max(1e-6);
    }

    /// Whether the sites have marks in the place of their lightness, and whether the marks are colours of clans.
    pub fn set_marks(&mut self, marks: Option<Marks>) {
        (self.skin.z, self.skin.w) = match marks {
            None => (0.0, 0.0),
            Some(Marks::Lit) => (1.0, 0.0),
            Some(Marks::Clans) => (1.0, 1.0),
        };
    }

    /// What covers the surface, and how a diagram's lines are drawn.
    pub fn set_diagram(&mut self, diagram: &Diagram) {
        self.diagram.x = flag(!diagram.colours.is_empty());
        self.diagram.y = diagram.layers.len() as f32;
        self.ink = linear(diagram.ink).extend(diagram.head);
    }

    /// Width and height of the canvas, in device pixels.
    pub fn set_size(&mut self, width: u32, height: u32) {
        (self.diagram.z, self.diagram.w) = (width as f32, height as f32);
    }

    /// A frame of a body, or one of the pictures of which a still one is the mean: pixels, lamp and
    /// lens are moved a little, but for picture 0.
    pub fn set_frame(&mut self, frame: &Frame, bounds: &Bounds, picture: u32) {
        let (right, up) = key_direction().any_orthonormal_pair();
        let (sin, cos) = libm::sincosf(picture as f32 * GOLDEN_ANGLE_RAD);
        // A sunflower for lamp and lens, and Roberts' R2 sequence for the pixels.
        let disc = Vec2::new(cos, sin) * (picture as f32 / STILL_PICTURES as f32).sqrt();
        let turn = |ratio: f32| (0.5 + ratio * picture as f32).fract() - 0.5;
        let key = (key_direction() + (right * disc.x + up * disc.y) * LAMP).normalize();
        self.light_projection = light_projection(bounds, key);
        self.key_texel = key.extend(2.0 * bounds.radius / SHADOW_SIDE as f32);

        let size = Vec2::new(self.diagram.z, self.diagram.w);
        let pixel = Vec2::new(turn(0.754_877_7), turn(0.569_840_3)) * 2.0 / size;
        let view = frame.view_projection;
        // What lies so deep stands still when the lens moves; what lies a radius behind or before it
        // moves as far as `LENS` says.
        let focus = (view * bounds.centre.extend(1.0)).w;
        let lens = disc * Vec2::new(size.y / size.x, 1.0) * (LENS * focus / bounds.radius);
        let depth = view.row(3);
        let moved =
            |k: usize| view.row(k) + depth * (pixel + lens)[k] - Vec4::W * (lens[k] * focus);
        self.view_projection = Mat4::from_cols(moved(0), moved(1), view.row(2), depth).transpose();
        self.eye_moment = frame.eye.extend(frame.moment);
        self.tissue.w = flag(frame.dark);
    }
}

/// Towards the key light: high in front, to the left.
pub fn key_direction() -> Vec3 {
    Vec3::new(-0.50, 0.78, 0.46).normalize()
}

/// World to the clip space of the shadow map: straight along the light, just around the body.
fn light_projection(bounds: &Bounds, key: Vec3) -> Mat4 {
    let (right, up) = key.any_orthonormal_pair();
    let per_length = 1.0 / (1.02 * bounds.radius);
    let row = |axis: Vec3, scale: f32, offset: f32| {
        let axis = axis * (scale * per_length);
        axis.extend(offset - axis.dot(bounds.centre))
    };
    // Depth is 0 next to the lamp, 1 away from it.
    Mat4::from_cols(row(right, 1.0, 0.0), row(up, 1.0, 0.0), row(key, -0.5, 0.5), Vec4::W)
        .transpose()
}

fn flag(on: bool) -> f32 {
    if on { 1.0 } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3Swizzles;
    use glam::camera::rh::{proj::directx::perspective, view::look_at_mat4};

    /// Where a point is seen in each picture of a still one, in pixels from where the frame shows it.
    fn moves(point: Vec3) -> Vec<Vec2> {
        let bounds = Bounds { centre: Vec3::ZERO, radius: 10.0, lowest: -10.0 };
        let eye = Vec3::new(0.0, 0.0, 50.0);
        let view = perspective(0.5, 2.0, 1.0, 100.0) * look_at_mat4(eye, Vec3::ZERO, Vec3::Y);
        let frame = Frame { view_projection: view, eye, moment: 1.0, dark: false };
        let mut scene = Scene::zeroed();
        scene.set_size(1000, 500);
        let seen = |view: Mat4| view.project_point3(point).xy() * Vec2::new(500.0, 250.0);
        let from = seen(view);
        (0..STILL_PICTURES)
            .map(|picture| {
                scene.set_frame(&frame, &bounds, picture);
                seen(scene.view_projection) - from
            })
            .collect()
    }

    #[test]
    fn the_pictures_of_a_still_one_share_a_pixel_and_a_breath_of_blur() {
        let middle = moves(Vec3::ZERO);
        assert!(middle[0].length() < 1e-3, "the first is the frame itself: {}", middle[0]);
        assert!(middle.iter().all(|by| by.abs().max_element() <= 0.501), "{middle:?}");
        let mean = middle.iter().sum::<Vec2>() / middle.len() as f32;
        assert!(mean.length() < 0.1, "evenly spread: {mean}");
        let behind = moves(Vec3::new(0.0, 0.0, -10.0));
        let lens = middle.iter().zip(&behind).map(|(a, b)| (*a - *b).length()).fold(0.0, f32::max);
        assert!((0.2..0.6).contains(&lens), "{lens} pixels at the far side of the body");
    }
}
