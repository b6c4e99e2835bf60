//! The shaders, what is bound to them, and how each kind of thing is drawn.

use super::geometry::{Corner, GroundCorner};
use glam::Vec3;
use wgpu::{BindGroupLayout, BindingType, ShaderStages, vertex_attr_array};

pub const SAMPLES: u32 = 4;
pub const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth24Plus;

pub struct Pipelines {
    pub shader: wgpu::ShaderModule,
    /// The scene's numbers.
    pub scene_layout: BindGroupLayout,
    /// The shadow map.
    pub light_layout: BindGroupLayout,
    /// The site lists, and the records of a diagram.
    pub sites_layout: BindGroupLayout,
    pub surface: wgpu::RenderPipeline,
    pub bare: wgpu::RenderPipeline,
    pub ground: wgpu::RenderPipeline,
    pub lines: wgpu::RenderPipeline,
    pub shadow: wgpu::RenderPipeline,
}

const CORNER: &[wgpu::VertexAttribute] = &vertex_attr_array![
    0 => Float32x3, 1 => Snorm16x4, 2 => Snorm8x4, 3 => Float32x2, 4 => Float32x2, 5 => Uint32
];
/// Of the day before.
const BEFORE: &[wgpu::VertexAttribute] = &[
    wgpu::VertexAttribute { format: wgpu::VertexFormat::Float32x3, offset: 0, shader_location: 6 },
    wgpu::VertexAttribute { format: wgpu::VertexFormat::Snorm16x4, offset: 12, shader_location: 7 },
];
const GROUND_CORNER: &[wgpu::VertexAttribute] = &vertex_attr_array![0 => Float32x2, 1 => Float32x3];
const LINE: &[wgpu::VertexAttribute] = &vertex_attr_array![0 => Float32x3, 1 => Float32x3];

impl Pipelines {
    /// `target`: the format of the canvas, not an sRGB one: the shaders encode by themselves.
    pub fn new(device: &wgpu::Device, target: wgpu::TextureFormat) -> Pipelines {
        let shader = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("draw"),
            source: wgpu::ShaderSource::Wgsl(
                // All of `shaders`, joined by the build script.
                include_str!(concat!(env!("OUT_DIR"), "/shaders.wgsl")).into(),
            ),
        });
        let scene_layout = layout(
            device,
            ShaderStages::VERTEX_FRAGMENT,
            &[BindingType::Buffer {
                ty: wgpu::BufferBindingType::Uniform,
                has_dynamic_offset: false,
                min_binding_size: None,
            }],
        );
        let light_layout = layout(
            device,
            ShaderStages::FRAGMENT,
            &[
                texture(wgpu::TextureSampleType::Depth),
                BindingType::Sampler(wgpu::SamplerBindingType::Comparison),
            ],
        );
        let words = texture(wgpu::TextureSampleType::Uint);
        let sites_layout = layout(device, ShaderStages::FRAGMENT, &[words, words, words]);

        let make = Maker { device, shader: &shader };
        let lit = [Some(&scene_layout), Some(&light_layout), Some(&sites_layout)];
        let corner = [Some(buffer::<Corner>(CORNER)), Some(buffer::<Corner>(BEFORE))];
        let ground_corner = [Some(buffer::<GroundCorner>(GROUND_CORNER))];
        let line = [Some(wgpu::VertexBufferLayout {
            step_mode: wgpu::VertexStepMode::Instance,
            ..buffer::<[Vec3; 2]>(LINE)
        })];
        let over = Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING);
        let colour = |blend| colour(target, blend);
        Pipelines {
            surface: make.make(&lit, &corner, "vs_body", Some(("fs_body", colour(None)))),
            bare: make.make(&lit[..2], &corner, "vs_body", Some(("fs_bare", colour(None)))),
            ground: make.make(
                &lit[..2],
                &ground_corner,
                "vs_ground",
                Some(("fs_ground", colour(over))),
            ),
            lines: make.make(&lit[..1], &line, "vs_line", Some(("fs_line", colour(None)))),
            shadow: make.make(&lit[..1], &corner, "vs_shadow", None),
            scene_layout,
            light_layout,
            sites_layout,
            shader,
        }
    }
}

/// A target that may be blended into.
pub fn colour(
    format: wgpu::TextureFormat,
    blend: Option<wgpu::BlendState>,
) -> Option<wgpu::ColorTargetState> {
    Some(wgpu::ColorTargetState { format, blend, write_mask: wgpu::ColorWrites::ALL })
}

pub struct Maker<'a> {
    pub device: &'a wgpu::Device,
    pub shader: &'a wgpu::ShaderModule,
}

impl Maker<'_> {
    /// A pipeline for triangles seen from both sides; without a fragment shader one for the shadow
    /// map, and without buffers one that has nothing but a colour target.
    pub fn make(
        &self,
        layouts: &[Option<&BindGroupLayout>],
        buffers: &[Option<wgpu::VertexBufferLayout>],
        vertex: &str,
        fragment: Option<(&str, Option<wgpu::ColorTargetState>)>,
    ) -> wgpu::RenderPipeline {
        let layout = self.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: None,
            bind_group_layouts: layouts,
            immediate_size: 0,
        });
        let casts_shadow = fragment.is_none();
        let blends =
            fragment.as_ref().is_some_and(|(_, t)| t.as_ref().is_some_and(|t| t.blend.is_some()));
        let fragment = fragment.as_ref().map(|(entry, target)| wgpu::FragmentState {
            module: self.shader,
            entry_point: Some(entry),
            compilation_options: Default::default(),
            targets: std::slice::from_ref(target),
        });
        self.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some(vertex),
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module: self.shader,
                entry_point: Some(vertex),
                compilation_options: Default::default(),
                buffers,
            },
            primitive: Default::default(),
            depth_stencil: (!buffers.is_empty()).then(|| wgpu::DepthStencilState {
                format: DEPTH,
                depth_write_enabled: Some(!blends),
                depth_compare: Some(wgpu::CompareFunction::Less),
                stencil: Default::default(),
                // Pushes the shadow map off the surface where light grazes it: without, stripes;
                // much more, and light leaks in under the stalks.
                bias: wgpu::DepthBiasState {
                    constant: 0,
                    slope_scale: if casts_shadow { 2.5 } else { 0.0 },
                    clamp: 0.0,
                },
            }),
            multisample: wgpu::MultisampleState {
                count: if casts_shadow || buffers.is_empty() { 1 } else { SAMPLES },
                ..Default::default()
            },
            fragment,
            multiview_mask: None,
            cache: None,
        })
    }
}

fn buffer<T>(attributes: &[wgpu::VertexAttribute]) -> wgpu::VertexBufferLayout<'_> {
    wgpu::VertexBufferLayout {
        array_stride: size_of::<T>() as u64,
        step_mode: wgpu::VertexStepMode::Vertex,
        attributes,
    }
}

pub fn texture(sample_type: wgpu::TextureSampleType) -> BindingType {
    BindingType::Texture {
        sample_type,
        view_dimension: wgpu::TextureViewDimension::D2,
        multisampled: false,
    }
}

/// A layout whose bindings are numbered from 0.
pub fn layout(
    device: &wgpu::Device,
    visibility: ShaderStages,
    types: &[BindingType],
) -> BindGroupLayout {
    let entries: Vec<_> = (0..)
        .zip(types)
        .map(|(binding, &ty)| wgpu::BindGroupLayoutEntry { binding, visibility, ty, count: None })
        .collect();
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: None,
        entries: &entries,
    })
}
