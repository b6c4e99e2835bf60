//! A body as it stands on the graphics card.

use super::geometry::{Bounds, Geometry};
use glam::Vec3;
use wgpu::util::{BufferInitDescriptor, DeviceExt};

/// A body on the graphics card.
pub struct Model {
    pub corners: wgpu::Buffer,
    /// Of a body that moves, where the corners were the day before.
    pub before: Option<wgpu::Buffer>,
    pub surface_corners: u32,
    pub all_corners: u32,
    pub ground: wgpu::Buffer,
    pub ground_indices: wgpu::Buffer,
    pub ground_index_count: u32,
    pub bounds: Bounds,
    /// The lines of a diagram.
    pub lines: Option<(wgpu::Buffer, u32)>,
    /// Of which picture of a still one the shadow map is, and of which moment of a body that moves.
    pub shadow_of: Option<(u32, f32)>,
}

impl Model {
    /// Brings the corners of a body and of its ground there.
    pub fn new(device: &wgpu::Device, geometry: &Geometry) -> Model {
        let buffer = |contents, usage| {
            device.create_buffer_init(&BufferInitDescriptor { label: None, contents, usage })
        };
        let vertices = wgpu::BufferUsages::VERTEX;
        Model {
            corners: buffer(bytemuck::cast_slice(&geometry.corners), vertices),
            before: (!geometry.before.is_empty())
                .then(|| buffer(bytemuck::cast_slice(&geometry.before), vertices)),
            surface_corners: geometry.surface_corners,
            all_corners: geometry.corners.len() as u32,
            ground: buffer(bytemuck::cast_slice(&geometry.ground), vertices),
            ground_indices: buffer(
                bytemuck::cast_slice(&geometry.ground_triangles),
                wgpu::BufferUsages::INDEX,
            ),
            ground_index_count: 3 * geometry.ground_triangles.len() as u32,
            bounds: geometry.bounds,
            lines: None,
            shadow_of: None,
        }
    }

    /// Lets a pass draw the body as it stands at a moment between the day before and the day.
    pub fn stand(&self, pass: &mut wgpu::RenderPass) {
        pass.set_vertex_buffer(0, self.corners.slice(..));
        pass.set_vertex_buffer(1, self.before.as_ref().unwrap_or(&self.corners).slice(..));
    }

    /// Sets the lines of a diagram, in the place of those before.
    pub fn set_lines(&mut self, device: &wgpu::Device, lines: &[[Vec3; 2]]) {
        self.drop_lines();
        // A buffer may not be empty.
        self.lines = (!lines.is_empty()).then(|| {
            let contents = bytemuck::cast_slice(lines);
            let usage = wgpu::BufferUsages::VERTEX;
            let descriptor = BufferInitDescriptor { label: None, contents, usage };
            (device.create_buffer_init(&descriptor), lines.len() as u32)
        });
    }

    fn drop_lines(&mut self) {
        if let Some((lines, _)) = self.lines.take() {
            lines.destroy();
        }
    }
}

impl Drop for Model {
    fn drop(&mut self) {
        self.drop_lines();
        let buffers = [&self.corners, &self.ground, &self.ground_indices];
        for buffer in buffers.into_iter().chain(&self.before) {
            buffer.destroy();
        }
    }
}
