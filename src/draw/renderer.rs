//! Holds what stands on the graphics card, and draws frames of it.

use super::data_texture::DataTexture;
use super::diagram;
use super::geometry::{Geometry, vein_lean};
use super::model::Model;
use super::pipelines::{DEPTH, Pipelines, SAMPLES};
use super::scene::{SHADOW_SIDE, STILL_PICTURES, Scene};
use super::still::Still;
use super::{DrawError, Frame, Marks};
use crate::mosaic::{Head, Site};
use crate::plants::{Diagram, Look};
use crate::surface::Body;
use bytemuck::Zeroable;
use wgpu::util::{BufferInitDescriptor, DeviceExt};

/// Draws a body with its mosaic on a canvas.
///
/// What is not needed any more is destroyed by hand: a browser would keep it until it collects its
/// garbage, of which the memory of the graphics card is no part.
pub struct Renderer {
    surface: wgpu::Surface<'static>,
    config: wgpu::SurfaceConfiguration,
    device: wgpu::Device,
    queue: wgpu::Queue,
    adapter: wgpu::AdapterInfo,
    can_mix: bool,
    pipelines: Pipelines,
    scene: Scene,
    scene_buffer: wgpu::Buffer,
    scene_group: wgpu::BindGroup,
    shadow_map: wgpu::TextureView,
    light_group: wgpu::BindGroup,
    heads: DataTexture,
    sites: DataTexture,
    covering: DataTexture,
    sites_group: wgpu::BindGroup,
    screen: Option<Screen>,
    model: Option<Model>,
}

/// The targets of a frame before it goes to the canvas, for one size.
struct Screen {
    colour: wgpu::TextureView,
    depth: wgpu::TextureView,
    still: Option<Still>,
}

impl Renderer {
    /// Sets up everything that does not depend on body or size. `config` gives format, alpha mode
    /// and usage of the canvas; its size counts for nothing until `resize`. `can_mix`: as `still` says.
    pub(super) fn with_device(
        surface: wgpu::Surface<'static>,
        config: wgpu::SurfaceConfiguration,
        device: wgpu::Device,
        queue: wgpu::Queue,
        adapter: wgpu::AdapterInfo,
        can_mix: bool,
    ) -> Renderer {
        let pipelines = Pipelines::new(&device, config.format);
        let scene = Scene::zeroed();
        let scene_buffer = device.create_buffer_init(&BufferInitDescriptor {
            label: None,
            contents: bytemuck::bytes_of(&scene),
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
        });
        let scene_group =
            bind(&device, &pipelines.scene_layout, &[scene_buffer.as_entire_binding()]);
        let shadow_map = target(
            &device,
            (SHADOW_SIDE, SHADOW_SIDE),
            DEPTH,
            1,
            wgpu::TextureUsages::TEXTURE_BINDING,
        );
        let sampler = device.create_sampler(&wgpu::SamplerDescriptor {
            mag_filter: wgpu::FilterMode::Linear,
            min_filter: wgpu::FilterMode::Linear,
            compare: Some(wgpu::CompareFunction::LessEqual),
            ..Default::default()
        });
        let light_group = bind(
            &device,
            &pipelines.light_layout,
            &[
                wgpu::BindingResource::TextureView(&shadow_map),
                wgpu::BindingResource::Sampler(&sampler),
            ],
        );
        let [heads, sites, covering] = std::array::from_fn(|_| DataTexture::new(&device));
        let sites_group = bind_sites(&device, &pipelines, [&heads, &sites, &covering]);
        Renderer {
            surface,
            config,
            device,
            queue,
            adapter,
            can_mix,
            pipelines,
            scene,
            scene_buffer,
            scene_group,
            shadow_map,
            light_group,
            heads,
            sites,
            covering,
            sites_group,
            screen: None,
            model: None,
        }
    }

    /// `webgpu` or `webgl2`.
    pub fn backend(&self) -> &'static str {
        match self.adapter.backend {
            wgpu::Backend::BrowserWebGpu => "webgpu",
            _ => "webgl2",
        }
    }

    /// Whether the processor draws, in the place of a graphics card.
    pub fn is_software(&self) -> bool {
        self.adapter.device_type == wgpu::DeviceType::Cpu
    }

    /// Of how many pictures one at rest is the mean here; 0: it stays as it is.
    pub fn still_pictures(&self) -> u32 {
        if self.can_mix && !self.is_software() { STILL_PICTURES } else { 0 }
    }

    /// Shows a body, bare until its sites come: `set_sites` of the body before counts no more, nor
    /// does `set_look`. `geometry` is that of the body.
    pub fn set_body(&mut self, body: &Body, geometry: &Geometry) {
        self.scene.set_body(&geometry.bounds, vein_lean(&body.surface));
        self.model = Some(Model::new(&self.device, geometry));
        self.scene.set_diagram(&Diagram::default());
        self.heads = DataTexture::new(&self.device);
        self.bind_sites();
    }

    /// Shows the body in another shape, with the same cells.
    pub fn set_shape(&mut self, geometry: &Geometry) {
        self.model = Some(Model::new(&self.device, geometry));
    }

    /// Colours the body, whose geometry this is, and its cells: nothing but the numbers that every
    /// frame takes along.
    pub fn set_look(&mut self, look: &Look, geometry: &Geometry) {
        self.scene.set_look(look, &geometry.materials);
    }

    /// Draws a diagram in place of the cells, or, when it is empty, the cells; call it after
    /// `set_body`, which shows the cells. Errors if it does not fit into the textures of this device;
    /// then nothing has changed.
    pub fn set_diagram(&mut self, diagram: &Diagram) -> Result<(), DrawError> {
        if self.covering.write(&self.device, &self.queue, &diagram::pack(diagram))? {
            self.bind_sites();
        }
        self.scene.set_diagram(diagram);
        if let Some(model) = &mut self.model {
            model.set_lines(&self.device, &diagram.lines);
        }
        Ok(())
    }

    /// Shows the cells of a day, with marks if they have some; call it after `set_body`. `mean_spacing_cm`: mean distance
    /// between neighbouring cells, `sqrt(area / cells)`. Errors if the lists do not fit into the
    /// textures of this device; then the cells are none of any day, until others are set.
    pub fn set_sites(
        &mut self,
        heads: &[Head],
        sites: &[Site],
        marks: Option<Marks>,
        mean_spacing_cm: f32,
    ) -> Result<(), DrawError> {
        self.scene.set_mean_spacing(mean_spacing_cm);
        self.scene.set_marks(marks);
        let (heads, sites) = (bytemuck::cast_slice(heads), bytemuck::cast_slice(sites));
        let heads_grew = self.heads.write(&self.device, &self.queue, heads);
        let sites_grew = self.sites.write(&self.device, &self.queue, sites);
        // Also where one of them is too large, the other may be a new texture.
        if heads_grew != Ok(false) || sites_grew != Ok(false) {
            self.bind_sites();
        }
        heads_grew.and(sites_grew).map(|_| ())
    }

    /// Gives the canvas a size in device pixels; sizes that the device cannot draw are cut down.
    pub fn resize(&mut self, width_px: u32, height_px: u32) {
        let most = self.device.limits().max_texture_dimension_2d;
        let size = (width_px.clamp(1, most), height_px.clamp(1, most));
        if self.screen.is_some() && size == (self.config.width, self.config.height) {
            return;
        }
        (self.config.width, self.config.height) = size;
        self.scene.set_size(size.0, size.1);
        self.surface.configure(&self.device, &self.config);
        // The old ones go before the new ones come.
        self.screen = None;
        let make =
            |format| target(&self.device, size, format, SAMPLES, wgpu::TextureUsages::empty());
        let (colour, depth) = (make(self.config.format), make(DEPTH));
        self.screen = Some(Screen { colour, depth, still: None });
    }

    /// Draws a frame on the canvas; or the mean of the first pictures of a still one, of which this is
    /// the last, after those before it were drawn. Without a body the canvas stays as it is, and before
    /// the first `resize`. Errors if the canvas gives no surface any more.
    pub fn draw(&mut self, frame: &Frame, picture: Option<u32>) -> Result<(), DrawError> {
        let (Some(screen), Some(model)) = (&mut self.screen, &mut self.model) else {
            return Ok(());
        };
        let Some(canvas) = next_texture(&self.surface, &self.device, &self.config)? else {
            return Ok(());
        };
        let canvas_view = canvas.texture.create_view(&Default::default());
        let number = picture.unwrap_or(0);
        self.scene.set_frame(frame, &model.bounds, number);
        self.queue.write_buffer(&self.scene_buffer, 0, bytemuck::bytes_of(&self.scene));
        let still = picture.map(|_| {
            let size = (self.config.width, self.config.height);
            let new = || Still::new(&self.device, &self.pipelines, size, self.config.format);
            &*screen.still.get_or_insert_with(new)
        });

        let mut encoder = self.device.create_command_encoder(&Default::default());
        let shadow = (number, if model.before.is_some() { frame.moment } else { 1.0 });
        if model.shadow_of.replace(shadow) != Some(shadow) {
            let mut pass = begin_pass(&mut encoder, None, &self.shadow_map, wgpu::StoreOp::Store);
            pass.set_bind_group(0, &self.scene_group, &[]);
            pass.set_pipeline(&self.pipelines.shadow);
            model.stand(&mut pass);
            pass.draw(0..model.all_corners, 0..1);
        }
        let onto = still.map_or(&canvas_view, |still| &still.picture.view);
        let mut pass = begin_pass(
            &mut encoder,
            Some((&screen.colour, onto)),
            &screen.depth,
            wgpu::StoreOp::Discard,
        );
        pass.set_bind_group(0, &self.scene_group, &[]);
        pass.set_bind_group(1, &self.light_group, &[]);
        pass.set_bind_group(2, &self.sites_group, &[]);
        model.stand(&mut pass);
        pass.set_pipeline(&self.pipelines.surface);
        pass.draw(0..model.surface_corners, 0..1);
        if model.all_corners > model.surface_corners {
            pass.set_pipeline(&self.pipelines.bare);
            pass.draw(model.surface_corners..model.all_corners, 0..1);
        }
        if let Some((lines, count)) = &model.lines {
            pass.set_pipeline(&self.pipelines.lines);
            pass.set_vertex_buffer(0, lines.slice(..));
            pass.draw(0..9, 0..*count);
        }
        pass.set_pipeline(&self.pipelines.ground);
        pass.set_vertex_buffer(0, model.ground.slice(..));
        pass.set_index_buffer(model.ground_indices.slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed(0..model.ground_index_count, 0, 0..1);
        drop(pass);
        if let Some(still) = still {
            still.take_in(&mut encoder, number, &canvas_view);
        }
        self.queue.submit([encoder.finish()]);
        self.queue.present(canvas);
        Ok(())
    }

    fn bind_sites(&mut self) {
        let textures = [&self.heads, &self.sites, &self.covering];
        self.sites_group = bind_sites(&self.device, &self.pipelines, textures);
    }
}

impl Drop for Renderer {
    fn drop(&mut self) {
        self.device.destroy();
    }
}

impl Drop for Screen {
    fn drop(&mut self) {
        self.colour.texture().destroy();
        self.depth.texture().destroy();
    }
}

/// The texture of the canvas for the next frame; none where nobody sees it. Errors if the canvas gives none
/// any more.
fn next_texture(
    surface: &wgpu::Surface,
    device: &wgpu::Device,
    config: &wgpu::SurfaceConfiguration,
) -> Result<Option<wgpu::SurfaceTexture>, DrawError> {
    use wgpu::CurrentSurfaceTexture::*;
    let mut texture = surface.get_current_texture();
    if let Outdated = texture {
        surface.configure(device, config);
        texture = surface.get_current_texture();
    }
    match texture {
        Success(texture) | Suboptimal(texture) => Ok(Some(texture)),
        Timeout | Occluded => Ok(None),
        Outdated | Lost | Validation => Err(DrawError::SurfaceLost),
    }
}

/// A pass into a depth target and, if given, a multisampled colour target and what it resolves to.
/// Everything starts empty.
fn begin_pass<'a>(
    encoder: &'a mut wgpu::CommandEncoder,
    colour: Option<(&wgpu::TextureView, &wgpu::TextureView)>,
    depth: &wgpu::TextureView,
    depth_store: wgpu::StoreOp,
) -> wgpu::RenderPass<'a> {
    let colour = colour.map(|(view, resolve_target)| {
        Some(wgpu::RenderPassColorAttachment {
            view,
            depth_slice: None,
            resolve_target: Some(resolve_target),
            ops: wgpu::Operations {
                load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                store: wgpu::StoreOp::Discard,
            },
        })
    });
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        color_attachments: colour.as_slice(),
        depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
            view: depth,
            depth_ops: Some(wgpu::Operations {
                load: wgpu::LoadOp::Clear(1.0),
                store: depth_store,
            }),
            stencil_ops: None,
        }),
        ..Default::default()
    })
}

/// A texture to draw into.
pub fn target(
    device: &wgpu::Device,
    (width, height): (u32, u32),
    format: wgpu::TextureFormat,
    sample_count: u32,
    usage: wgpu::TextureUsages,
) -> wgpu::TextureView {
    let texture = device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: usage | wgpu::TextureUsages::RENDER_ATTACHMENT,
        view_formats: &[],
    });
    texture.create_view(&Default::default())
}

fn bind_sites(
    device: &wgpu::Device,
    pipelines: &Pipelines,
    textures: [&DataTexture; 3],
) -> wgpu::BindGroup {
    let views = textures.map(|texture| wgpu::BindingResource::TextureView(&texture.view));
    bind(device, &pipelines.sites_layout, &views)
}

/// A bind group whose bindings are numbered from 0.
pub fn bind(
    device: &wgpu::Device,
    layout: &wgpu::BindGroupLayout,
    resources: &[wgpu::BindingResource],
) -> wgpu::BindGroup {
    let entries: Vec<_> = (0..)
        .zip(resources)
        .map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource: resource.clone() })
        .collect();
    device.create_bind_group(&wgpu::BindGroupDescriptor { label: None, layout, entries: &entries })
}
