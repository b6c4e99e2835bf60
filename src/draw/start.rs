//! Finds a graphics device for a canvas: the one place here that knows the browser.

use super::{DrawError, Renderer};
use std::cell::RefCell;
use std::rc::Rc;
use std::sync::Arc;
use wasm_bindgen::{JsCast, closure::Closure};

impl Renderer {
    /// Starts the graphics card for a canvas. `on_trouble` is told, in its own turn of the event
    /// loop, when the device is lost or refuses something; the renderer is of no use then: make
    /// another one, on a new canvas.
    pub async fn new(
        canvas: web_sys::HtmlCanvasElement,
        on_trouble: Box<dyn Fn(String)>,
    ) -> Result<Renderer, DrawError> {
        let trouble = Trouble::new(on_trouble);
        trouble.listen_to_context_loss(&canvas);
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
        let surface = instance
            .create_surface(wgpu::SurfaceTarget::Canvas(canvas))
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
            trouble.tell(format!("the graphics device is lost ({reason:?}): {message}"));
        });
        device.on_uncaptured_error(Arc::new(move |error| trouble.tell(format!("{error}"))));

        let mut config = surface
            .get_default_config(&adapter, 1, 1)
            .ok_or_else(|| DrawError::NoSurface("no format fits the adapter".into()))?;
        config.format = config.format.remove_srgb_suffix();
        let info = adapter.get_info();
        // A WebGL2 canvas is premultiplied by itself, and may not be asked to be.
        if info.backend == wgpu::Backend::BrowserWebGpu {
            config.alpha_mode = wgpu::CompositeAlphaMode::PreMultiplied;
        }
        Ok(Renderer::with_device(surface, config, device, queue, info))
    }
}

type Listener = Rc<dyn Fn(String)>;

thread_local! {
    /// Those who want to hear of trouble. Callbacks of a device must be `Send`, what the page hands
    /// in is not: they carry the number of a listener.
    static LISTENERS: RefCell<Vec<Listener>> = const { RefCell::new(Vec::new()) };
}

/// The number of a listener.
#[derive(Clone, Copy)]
struct Trouble(usize);

impl Trouble {
    fn new(on_trouble: Box<dyn Fn(String)>) -> Trouble {
        LISTENERS.with_borrow_mut(|listeners| {
            listeners.push(on_trouble.into());
            Trouble(listeners.len() - 1)
        })
    }

    /// Calls the listener a little later: the page may be in the midst of a call to the renderer.
    fn tell(self, message: String) {
        let listener = LISTENERS.with_borrow(|listeners| listeners[self.0].clone());
        wasm_bindgen_futures::spawn_local(async move { listener(message) });
    }

    /// WebGL2 says by an event on the canvas that its context is lost.
    fn listen_to_context_loss(self, canvas: &web_sys::HtmlCanvasElement) {
        let lost = Closure::<dyn Fn()>::new(move || {
            self.tell("the WebGL context is lost".into());
        });
        let listened = canvas
            .add_event_listener_with_callback("webglcontextlost", lost.as_ref().unchecked_ref());
        if listened.is_ok() {
            // The canvas owns the closure from now on.
            lost.forget();
        }
    }
}
