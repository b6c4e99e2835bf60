//! Finds a graphics device for a canvas: the one place here that knows the browser.

use super::still::can_mix;
use super::{DrawError, Renderer};
use std::sync::Arc;
use wasm_bindgen::{JsCast, closure::Closure};
use wasm_bindgen_futures::spawn_local;
use web_sys::{EventTarget, HtmlCanvasElement, OffscreenCanvas};

/// What a renderer draws on: a canvas of a page or, in a worker, one that nobody sees.
pub trait Canvas: AsRef<EventTarget> {
    #[doc(hidden)]
    fn target(self) -> wgpu::SurfaceTarget<'static>;
}

impl Canvas for HtmlCanvasElement {
    fn target(self) -> wgpu::SurfaceTarget<'static> {
        wgpu::SurfaceTarget::Canvas(self)
    }
}

impl Canvas for OffscreenCanvas {
    fn target(self) -> wgpu::SurfaceTarget<'static> {
        wgpu::SurfaceTarget::OffscreenCanvas(self)
    }
}

impl Renderer {
    /// Starts the graphics card for a canvas. `on_trouble` is told, in its own turn of the event
    /// loop, when the device is lost or refuses something; the renderer is of no use then: make
    /// another one, on a new canvas. It may be told more than once, also before the renderer is there
    /// and after it is dropped.
    pub async fn new(
        canvas: impl Canvas,
        on_trouble: impl Fn(String) + Copy + Send + Sync + 'static,
    ) -> Result<Renderer, DrawError> {
        // A little later: the page may be in the midst of a call to the renderer.
        let tell = move |message| spawn_local(async move { on_trouble(message) });
        listen_to_context_loss(canvas.as_ref(), tell);
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
        let surface = instance
            .create_surface(canvas.target())
            .map_err(|e| DrawError::NoSurface(e.to_string()))?;
        let adapter = instance
            .request_adapter(&wgpu::RequestAdapterOptions {
                compatible_surface: Some(&surface),
                ..Default::default()
            })
            .await
            .map_err(|e| DrawError::NoAdapter(e.to_string()))?;
        let (device, queue) = adapter
            .request_device(&wgpu::DeviceDescriptor {
                required_limits: wgpu::Limits::downlevel_webgl2_defaults()
                    .using_resolution(adapter.limits()),
                ..Default::default()
            })
            .await
            .map_err(|e| DrawError::NoDevice(e.to_string()))?;
        device.set_device_lost_callback(move |reason, message| {
            tell(format!("the graphics device is lost ({reason:?}): {message}"));
        });
        device.on_uncaptured_error(Arc::new(move |error| tell(format!("{error}"))));

        let mut config = surface
            .get_default_config(&adapter, 1, 1)
            .ok_or_else(|| DrawError::NoSurface("no format fits the adapter".into()))?;
        config.format = config.format.remove_srgb_suffix();
        let info = adapter.get_info();
        // A WebGL2 canvas is premultiplied by itself, and may not be asked to be.
        if info.backend == wgpu::Backend::BrowserWebGpu {
            config.alpha_mode = wgpu::CompositeAlphaMode::PreMultiplied;
        }
        let can_mix = can_mix(&adapter);
        Ok(Renderer::with_device(surface, config, device, queue, info, can_mix))
    }
}

/// WebGL2 says by an event on the canvas that its context is lost: once, since nobody asks for it back.
fn listen_to_context_loss(canvas: &EventTarget, tell: impl Fn(String) + 'static) {
    let lost = Closure::once_into_js(move || tell("the WebGL context is lost".into()));
    // Fails for no canvas.
    let _ = canvas.add_event_listener_with_callback("webglcontextlost", lost.unchecked_ref());
}
