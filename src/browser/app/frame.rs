//! What the page draws: frame by frame, and for the printer.

use super::super::backend;
use super::super::dom::{find, set_attribute, set_flag, set_text};
use super::super::gallery::Gallery;
use super::super::stage::Drawn;
use super::super::surroundings::is_dark;
use super::App;
use crate::draw::DrawError;
use crate::play::canvases::Loss;
use crate::play::gallery;
use crate::play::page::{Event, State};
use crate::play::{link, words};
use glam::Vec2;
use wasm_bindgen::JsCast;
use wasm_bindgen_futures::spawn_local;
use web_sys::{Element, HtmlCanvasElement};

/// Seconds that a frame counts at most: after a pause (a hidden tab) time goes on where it stopped.
const LONGEST_S: f64 = 0.1;

impl App {
    pub(super) fn frame(&mut self, now_ms: f64) {
        let seconds = self.frames.begin(now_ms);
        if self.gallery.is_some() {
            return self.frame_of_figures();
        }
        if self.page.is_moving() {
            let effects = self.page.hear(Event::Tick(seconds.min(LONGEST_S)));
            self.act(effects);
        }
        let drawn = match self.stage.bring(&self.page, is_dark(), seconds) {
            Ok(drawn) => drawn,
            Err(DrawError::TooLarge { .. }) => {
                self.messages.also(backend::TOO_LARGE);
                Some(Drawn::DONE)
            }
            Err(_) => return self.lose(self.canvases.current()),
        };
        if let Some(Drawn { sharp, .. }) = drawn {
            let effects = self.page.hear(Event::Drawn { sharp });
            self.act(effects);
        }
        self.show();
        if self.page.is_moving() || drawn.is_some_and(|drawn| !drawn.done) {
            self.frames.ask();
        } else {
            self.frames.rest();
            self.tell_host();
        }
    }

    /// Tells the page around this one what has come to rest here.
    fn tell_host(&mut self) {
        let (Some(host), state) = (&mut self.host, self.page.state()) else { return };
        if !matches!(state, State::Ready | State::Error) {
            return;
        }
        let day = self.page.drawn().and_then(|drawn| drawn.day.as_ref());
        host.tell(format!(
            r#""link":"{}","day":{},"cells":{},"fingerprint":"{}","state":"{}""#,
            self.page.link(),
            day.map_or(self.page.scene().day, |day| day.day),
            day.map_or(0, |day| day.facts.count.cells),
            day.map_or("", |day| &day.facts.fingerprint),
            state.word()
        ));
    }

    fn frame_of_figures(&mut self) {
        if let Some(figure) = self.gallery.as_mut().and_then(Gallery::next_row) {
            self.hear_figures(gallery::Event::Open(figure));
        }
        let Some(gallery) = &mut self.gallery else { return };
        match gallery.show(&mut self.stage, is_dark()) {
            Ok(true) => self.frames.ask(),
            Ok(false) => self.frames.rest(),
            Err(_) => return self.lose(self.canvases.current()),
        }
        self.show_state();
    }

    /// The canvas of this number is of no use any more.
    pub(super) fn lose(&mut self, canvas: u32) {
        if self.stage.is_still() {
            return;
        }
        let loss = self.canvases.lose(canvas, js_sys::Date::now());
        if loss == Loss::Old {
            return;
        }
        self.stage.renew_canvas();
        self.hear(Event::PictureLost);
        if loss == Loss::GiveUp {
            self.stage.stay_still();
            self.messages.keep(backend::GIVEN_UP);
        } else {
            let number = self.canvases.current();
            spawn_local(backend::start_renderer(self.stage.canvas(), number));
        }
    }

    /// Zooms to where the plant is: what is beside it would go out of the picture and take it along.
    pub(super) fn zoom(&mut self, factor: f32, at: Vec2) {
        let at = self.stage.nearest(&self.page.camera().arrived(), at);
        self.hear(Event::Zoom { factor, at });
    }

    /// Brings picture, numbers and link to where they are printed from: the screen's canvas is empty there.
    pub(super) fn print(&mut self, address: &str) {
        let scene = self.page.scene();
        let numbers = words::numbers(scene.plant, std::slice::from_ref(&scene.recipe));
        set_text(
            &find::<Element>("printed-numbers"),
            &format!("{}: {numbers}", self.page.source()),
        );
        let printed: Element = find("printed-link");
        set_text(&printed, address);
        let before = self.page.history().before_last_change().map(link::write);
        set_attribute(&printed, "data-before", before.unwrap_or_default());
        if self.gallery.is_some() {
            return;
        }
        let canvas: HtmlCanvasElement = find("printed");
        let pen = canvas.get_context("2d").ok().flatten().expect("browsers draw in 2D");
        // What cannot be drawn is printed as the still that stands in for it.
        let is_drawn = self.stage.print(&self.page, pen.unchecked_ref()).unwrap_or(false);
        set_flag(self.stage.element(), "data-printed", is_drawn);
        self.frames.ask();
    }
}
