//! The stage: the canvas, its renderer, and what has been handed to it.

pub(super) mod picture;

use super::app;
use super::dom::{Listener, find, mark_when_missing, set_attribute, set_flag, window};
use super::files;
use crate::draw::{DrawError, Frame, Renderer};
use crate::plants::OWN;
use crate::play::camera::Camera;
use crate::play::clone::ClanMap;
use crate::play::detail::Detail;
use crate::play::gallery::ShownPicture;
use crate::play::handed::Handed;
use crate::play::page::{Page, Shown};
use glam::Vec2;
use picture::{Cells, OnStage, Picture};
use wasm_bindgen::prelude::*;
use web_sys::{
    CanvasRenderingContext2d, HtmlCanvasElement, HtmlElement, HtmlImageElement, ResizeObserver,
};

/// Device pixels to a CSS pixel at most: more are not seen and cost four times the work.
const MOST_PIXEL_RATIO: f64 = 2.0;
/// Pixels of a side of the printed picture: 16 cm at 250 to an inch.
const PRINTED_PX: u32 = 1600;

pub struct Stage {
    element: HtmlElement,
    canvas: HtmlCanvasElement,
    poster: HtmlImageElement,
    graphics: Graphics,
    /// The body on the stage, and the key of its plant.
    body: Option<(&'static str, OnStage)>,
    /// What the renderer has been handed.
    handed: Handed,
    /// The last frame that it drew of that, and in which size.
    frame: Option<Frame>,
    frame_px: (u32, u32),
    /// So many pictures of it were mixed since it rests.
    pictures: u32,
    clan_map: ClanMap,
    size_px: (u32, u32),
    detail: Detail,
    _resize: ResizeObserver,
    _on_resize: Closure<dyn FnMut()>,
    _poster_missing: Listener,
}

/// How the picture gets on the screen.
enum Graphics {
    Starting,
    Running(Box<Renderer>),
    /// Neither WebGPU nor WebGL2: the still picture stays.
    None,
}

/// That a picture stands on the stage, or would, where nothing can be drawn.
#[derive(Clone, Copy, Debug)]
pub struct Drawn {
    /// With all its pixels.
    pub sharp: bool,
    /// As good as it gets: nothing more is to be drawn of it.
    pub done: bool,
}

impl Drawn {
    pub const DONE: Drawn = Drawn { sharp: true, done: true };
}

impl Stage {
    pub fn new() -> Stage {
        let element: HtmlElement = find("stage");
        let poster: HtmlImageElement = find("poster");
        let on_resize = Closure::<dyn FnMut()>::new(app::resized);
        let resize = ResizeObserver::new(on_resize.as_ref().unchecked_ref())
            .expect("browsers observe sizes");
        resize.observe(&element);
        let poster_missing = mark_when_missing(&poster);
        let mut stage = Stage {
            element,
            canvas: find("canvas"),
            poster,
            graphics: Graphics::Starting,
            body: None,
            handed: Handed::default(),
            frame: None,
            frame_px: (0, 0),
            pictures: 0,
            clan_map: ClanMap::default(),
            size_px: (0, 0),
            detail: Detail::new(false),
            _resize: resize,
            _on_resize: on_resize,
            _poster_missing: poster_missing,
        };
        stage.measure();
        stage
    }

    pub fn element(&self) -> &HtmlElement {
        &self.element
    }

    pub fn canvas(&self) -> HtmlCanvasElement {
        self.canvas.clone()
    }

    /// `webgpu`, `webgl2` or `none`.
    pub fn backend(&self) -> &'static str {
        match &self.graphics {
            Graphics::Running(renderer) => renderer.backend(),
            Graphics::Starting | Graphics::None => "none",
        }
    }

    /// Takes the renderer of this stage's canvas.
    pub fn run(&mut self, renderer: Renderer) {
        self.detail = Detail::new(renderer.is_software());
        self.graphics = Graphics::Running(Box::new(renderer));
        self.handed = Handed::default();
        self.frame = None;
    }

    /// Settles for the still picture.
    pub fn stay_still(&mut self) {
        self.graphics = Graphics::None;
    }

    /// Whether there is nothing but still pictures.
    pub fn is_still(&self) -> bool {
        matches!(self.graphics, Graphics::None)
    }

    /// Puts a new canvas in the place of one whose device is lost: the old one may never draw again.
    pub fn renew_canvas(&mut self) {
        self.graphics = Graphics::Starting;
        if let Ok(fresh) = self.canvas.clone_node() {
            let fresh: HtmlCanvasElement = fresh.unchecked_into();
            if self.canvas.replace_with_with_node_1(&fresh).is_ok() {
                self.canvas = fresh;
            }
        }
    }

    /// Reads the size of the stage again.
    pub fn measure(&mut self) {
        let ratio = window().device_pixel_ratio().min(MOST_PIXEL_RATIO);
        let pixels = |css: i32| (f64::from(css) * ratio).round().max(1.0) as u32;
        self.size_px = (pixels(self.element.client_width()), pixels(self.element.client_height()));
        self.frame = None;
    }

    /// Brings the screen into agreement with the page, so many seconds after the frame before. Errors
    /// if the device is of no use any more, or, once for each picture, if that is too large for it:
    /// the poster stands in for it then.
    pub fn bring(
        &mut self,
        page: &Page,
        dark: bool,
        seconds: f64,
    ) -> Result<Option<Drawn>, DrawError> {
        let brought = self.draw(page, dark, seconds);
        self.show_poster(page.shown());
        brought
    }

    fn draw(&mut self, page: &Page, dark: bool, seconds: f64) -> Result<Option<Drawn>, DrawError> {
        let picture = Picture::of(page, self.size_px);
        if self.handed.refuses(&picture.wanted(None)) {
            return Ok(Some(Drawn::DONE));
        }
        let drawn = self.portray(&picture, dark, Some(seconds))?;
        // Once more: with these cells the live picture may take the poster's place.
        self.show_poster(page.shown());
        Ok(drawn)
    }

    /// Draws what is shown, large and on paper, and copies it to the canvas of `pen`. False and errors as
    /// in `copy`.
    pub fn print(
        &mut self,
        page: &Page,
        pen: &CanvasRenderingContext2d,
    ) -> Result<bool, DrawError> {
        let Some(canvas) = pen.canvas() else { return Ok(false) };
        canvas.set_width(PRINTED_PX);
        canvas.set_height(PRINTED_PX);
        self.copy_picture(&Picture::of(page, (PRINTED_PX, PRINTED_PX)), false, pen)
    }

    /// Draws a picture of a figure and copies it to the canvas of `pen`, as large as that is. False
    /// if nothing can be drawn now. Errors if the device is of no use any more, or if the picture is
    /// too large for it.
    pub fn copy(
        &mut self,
        shown: &ShownPicture,
        mesh: Option<&str>,
        dark: bool,
        pen: &CanvasRenderingContext2d,
    ) -> Result<bool, DrawError> {
        let Some(canvas) = pen.canvas() else { return Ok(false) };
        let (generation, day, count) = (shown.generation, shown.day, shown.facts.count.cells);
        let picture = Picture {
            plant: shown.scene.plant,
            individual: shown.scene.individual,
            look: &shown.scene.look,
            show: shown.scene.show,
            mesh,
            cells: Some(Cells { generation, day, count, lists: shown.lists, painted: None }),
            camera: &Camera::new(shown.scene.orbit),
            moment: 1.0,
            size_px: (canvas.width(), canvas.height()),
            calm: true,
        };
        self.copy_picture(&picture, dark, pen)
    }

    fn copy_picture(
        &mut self,
        picture: &Picture,
        dark: bool,
        pen: &CanvasRenderingContext2d,
    ) -> Result<bool, DrawError> {
        self.frame = None;
        let drawn = self.portray(picture, dark, None)?.is_some() && self.frame.take().is_some();
        if drawn {
            let (width, height) = picture.size_px;
            pen.clear_rect(0.0, 0.0, f64::from(width), f64::from(height));
            // Fails only for an empty picture.
            let _ = pen.draw_image_with_html_canvas_element(&self.canvas, 0.0, 0.0);
        }
        Ok(drawn)
    }

    /// The place of the plant that is nearest to a point of the stage, for a camera: see `Outline`.
    pub fn nearest(&self, camera: &Camera, at: Vec2) -> Vec2 {
        let outline = self.body.as_ref().map(|(_, on)| on.outline(camera));
        outline.map_or(at, |outline| outline.nearest(at))
    }

    /// The cell that is seen at a point of the stage (-1 to 1 over its centred square), or, without one, in
    /// the middle or next to it. None where there is no cell.
    pub fn cell_at(&self, page: &Page, at: Option<Vec2>) -> Option<u32> {
        let (_, on) = self.body.as_ref().filter(|(key, _)| *key == page.shown().plant)?;
        let outline = on.outline(page.camera());
        let picked = at.map_or_else(|| outline.pick_middle(), |at| outline.pick(at))?;
        page.cell_at(&picked)
    }

    /// Forgets what is on the stage: something else was drawn there.
    pub fn forget(&mut self) {
        self.handed = Handed::default();
        self.measure();
    }

    /// `seconds`: since the frame before, where pixels may be left out for the sake of speed.
    fn portray(
        &mut self,
        picture: &Picture,
        dark: bool,
        seconds: Option<f64>,
    ) -> Result<Option<Drawn>, DrawError> {
        if let Graphics::None = self.graphics {
            return Ok(Some(Drawn::DONE));
        }
        let key = picture.plant.key;
        if self.body.as_ref().is_none_or(|(of, _)| *of != key) {
            // What is no mesh the worker tells.
            let on_stage = picture.mesh.and_then(|mesh| OnStage::of(picture.plant, mesh).ok());
            self.body = on_stage.map(|on_stage| (key, on_stage));
        }
        // The body is ready when the graphics card is.
        let (Graphics::Running(renderer), Some((_, on_stage))) =
            (&mut self.graphics, &mut self.body)
        else {
            return Ok(None);
        };
        on_stage.stand(picture.shape(on_stage));
        let (on_stage, wanted) = (&*on_stage, picture.wanted(Some(on_stage)));
        while let Some(part) = self.handed.lacks(&wanted) {
            if let Err(too_large) = picture.hand(part, on_stage, renderer, &mut self.clan_map) {
                self.handed.refuse(&wanted);
                return Err(too_large);
            }
            self.handed.take(part, &wanted);
            self.frame = None;
        }
        if !self.handed.has_cells() {
            // The poster stands there still; a frame of the bare body would only delay the first
            // one with cells.
            return Ok(Some(Drawn::DONE));
        }
        let (width, height) = picture.size_px;
        let frame = Frame {
            view_projection: picture.camera.view_projection(&on_stage.sphere, width, height),
            eye: picture.camera.eye(&on_stage.sphere),
            moment: picture.moment,
            dark,
        };
        let changes = self.frame != Some(frame);
        let share = seconds.map_or(1.0, |seconds| self.detail.share(seconds, changes));
        let size_px = [width, height].map(|px| (f64::from(px) * share).round() as u32).into();
        let sharp = size_px == picture.size_px;
        let pictures = if picture.calm { 0 } else { renderer.still_pictures() };
        if changes || self.frame_px != size_px {
            renderer.resize(size_px.0, size_px.1);
            renderer.draw(&frame, None)?;
            self.frame = Some(frame);
            self.frame_px = size_px;
            let half = Vec2::new(width as f32, height as f32) / width.min(height) as f32;
            let is_empty = !on_stage.outline(picture.camera).is_in_sight(half);
            set_flag(&self.element, "data-empty", is_empty);
            self.pictures = 0;
        } else if sharp && self.pictures < pictures {
            renderer.draw(&frame, Some(self.pictures))?;
            self.pictures += 1;
        }
        Ok(Some(Drawn { sharp, done: sharp && self.pictures >= pictures }))
    }

    /// The poster stands in until cells are drawn.
    fn show_poster(&self, shown: &Shown) {
        let live = matches!(self.graphics, Graphics::Running(_)) && self.handed.has_cells();
        set_flag(&self.element, "data-live", live);
        if shown.plant.starts_with(OWN) {
            // Nobody drew one of a plant that a visitor brought.
            set_flag(&self.poster, "data-missing", true);
        } else if !live {
            let address = files::address(&format!("posters/{}.avif", shown.plant));
            if self.poster.get_attribute("src").as_deref() != Some(&address) {
                set_flag(&self.poster, "data-missing", false);
                set_attribute(&self.poster, "src", address);
            }
        }
    }
}

impl Drop for Stage {
    fn drop(&mut self) {
        self._resize.disconnect();
    }
}
