//! A picture at rest: the mean of several, each drawn with pixels, lamp and lens moved a little. Edges are
//! smooth then, shadows have true penumbrae, and what lies out of focus is a little soft.

use super::pipelines::{Maker, Pipelines, colour, layout, texture};
use super::renderer::{bind, target};
use wgpu::{BlendComponent, BlendFactor, BlendOperation, BlendState};

/// Of the mean: 8 bits would not hold a sixteenth of a picture.
pub const MEAN: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;

/// Where the pictures are drawn and mixed, for one size.
pub struct Still {
    pub picture: Image,
    mean: Image,
    mix: wgpu::RenderPipeline,
    put: wgpu::RenderPipeline,
}

pub struct Image {
    pub view: wgpu::TextureView,
    group: wgpu::BindGroup,
}

/// Whether an adapter can mix pictures. With WebGPU all can; wgpu would ask no adapter there, but a table
/// that is a kilobyte of the download.
pub fn can_mix(adapter: &wgpu::Adapter) -> bool {
    if !cfg!(feature = "webgl") {
        return true;
    }
    let features = adapter.get_texture_format_features(MEAN);
    features.allowed_usages.contains(wgpu::TextureUsages::RENDER_ATTACHMENT)
        && features.flags.contains(wgpu::TextureFormatFeatureFlags::BLENDABLE)
}

impl Still {
    /// `format`: of the canvas.
    pub fn new(
        device: &wgpu::Device,
        pipelines: &Pipelines,
        size: (u32, u32),
        format: wgpu::TextureFormat,
    ) -> Still {
        let layout = layout(
            device,
            wgpu::ShaderStages::FRAGMENT,
            &[texture(wgpu::TextureSampleType::Float { filterable: false })],
        );
        let image = |format| {
            let view = target(device, size, format, 1, wgpu::TextureUsages::TEXTURE_BINDING);
            let group = bind(device, &layout, &[wgpu::BindingResource::TextureView(&view)]);
            Image { view, group }
        };
        let maker = Maker { device, shader: &pipelines.shader };
        let whole = |format, blend| {
            maker.make(&[Some(&layout)], &[], "vs_whole", Some(("fs_whole", colour(format, blend))))
        };
        let share = BlendComponent {
            src_factor: BlendFactor::Constant,
            dst_factor: BlendFactor::OneMinusConstant,
            operation: BlendOperation::Add,
        };
        Still {
            picture: image(format),
            mean: image(MEAN),
            mix: whole(MEAN, Some(BlendState { color: share, alpha: share })),
            put: whole(format, None),
        }
    }

    /// Takes the picture of this number, from 0 on, into the mean of those before, and puts that on the
    /// canvas.
    pub fn take_in(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        number: u32,
        canvas: &wgpu::TextureView,
    ) {
        let share = 1.0 / f64::from(number + 1);
        let mut pass = |image: &Image, pipeline, view| {
            let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                    view,
                    depth_slice: None,
                    resolve_target: None,
                    ops: wgpu::Operations { load: wgpu::LoadOp::Load, store: wgpu::StoreOp::Store },
                })],
                ..Default::default()
            });
            pass.set_pipeline(pipeline);
            pass.set_bind_group(0, &image.group, &[]);
            pass.set_blend_constant(wgpu::Color { r: share, g: share, b: share, a: share });
            pass.draw(0..3, 0..1);
        };
        pass(&self.picture, &self.mix, &self.mean.view);
        pass(&self.mean, &self.put, canvas);
    }
}

impl Drop for Image {
    fn drop(&mut self) {
        self.view.texture().destroy();
    }
}
