//! The numbers of a frame as the shaders read them.

use super::{Frame, geometry::Bounds};
use crate::plants::{Diagram, Look};
use bytemuck::{Pod, Zeroable};
use glam::{Mat4, Vec3, Vec4};

/// Bare materials that a body may have.
pub const BARE_MATERIALS: usize = 16;

/// Side length of the shadow map in texels. Sharper shadows than this gives are not those of
/// daylight through a curtain.
pub const SHADOW_SIDE: u32 = 1024;

/// Colour and gloss of a bare material that the look does not name.
const PLAIN: ([f32; 3], f32) = ([0.55, 0.53, 0.50], 0.1);

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
    bare: [Vec4; BARE_MATERIALS],
}

impl Scene {
    /// Light and veins for a body. `vein_lean` as `geometry::vein_lean` gives it; `sheet`: the
    /// surface has rims, so that light comes through it.
    pub fn set_body(&mut self, bounds: &Bounds, vein_lean: f32, sheet: bool) {
        self.tissue.y = vein_lean;
        self.tissue.z = flag(sheet);
        self.ground = bounds.ground();
        self.light_projection = light_projection(bounds);
        self.key_texel = key_direction().extend(2.0 * bounds.radius / SHADOW_SIDE as f32);
    }

    /// The colours of the cells and of the bare materials; `materials`: the names of those, by their
    /// numbers.
    pub fn set_look(&mut self, look: &Look, materials: &[String]) {
        let even = |colour| linear(colour).map(f32::sqrt).extend(1.0);
        self.cells = look.cells.map(even);
        self.tinted = self.cells;
        for &(kind, colour) in look.tinted {
            self.tinted[kind as usize] = even(colour);
        }
        self.look = Vec4::new(look.variation, look.border, look.gloss, flag(look.veins));
        for (bare, name) in self.bare.iter_mut().zip(materials) {
            let named = look.bare.iter().find(|(n, ..)| n == name);
            let (colour, gloss) = named.map_or(PLAIN, |&(_, colour, gloss)| (colour, gloss));
            *bare = linear(colour).extend(gloss);
        }
    }

    /// Mean distance between neighbouring cells, in centimetres.
    pub fn set_mean_spacing(&mut self, mean_spacing_cm: f32) {
        self.tissue.x = mean_spacing_cm.max(1e-6);
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

    pub fn set_frame(&mut self, frame: &Frame) {
        self.view_projection = frame.view_projection;
        self.eye_moment = frame.eye.extend(frame.moment);
        self.tissue.w = flag(frame.dark);
    }
}

/// Towards the key light: high in front, to the left.
pub fn key_direction() -> Vec3 {
    Vec3::new(-0.50, 0.78, 0.46).normalize()
}

/// World to the clip space of the shadow map: straight along the light, just around the body.
fn light_projection(bounds: &Bounds) -> Mat4 {
    let key = key_direction();
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

/// sRGB numbers to linear light (IEC 61966-2-1).
fn linear(srgb: [f32; 3]) -> Vec3 {
    Vec3::from(
        srgb.map(|c| if c <= 0.04045 { c / 12.92 } else { libm::powf((c + 0.055) / 1.055, 2.4) }),
    )
}
