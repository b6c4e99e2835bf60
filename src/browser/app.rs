//! The one application of this page: takes events to the page's brain, does what it says, and brings
//! the document into agreement with it.

use super::address::{base, fragment, write_link};
use super::backend;
use super::chooser::Chooser;
use super::controls::Controls;
use super::dom::{Listener, document, on, window};
use super::frames::Frames;
use super::gallery::Gallery;
use super::keyboard;
use super::mail::{self, Mail};
use super::messages::Messages;
use super::panel::Panel;
use super::pointer::Pointer;
use super::show::ShowChooser;
use super::stage::{Drawn, Stage};
use super::surroundings::{Surroundings, is_dark};
use super::timeline::Timeline;
use crate::draw::{DrawError, Renderer};
use crate::plants;
use crate::play::canvases::{Canvases, Loss};
use crate::play::figures::{Figure, asked_figure};
use crate::play::gallery;
use crate::play::page::{Effect, Event, Page};
use crate::play::parameters::Parameter;
use crate::play::protocol::BUILD;
use crate::surface::unpack;
use std::cell::RefCell;
use wasm_bindgen_futures::spawn_local;

/// Seconds that a frame counts at most: after a pause (a hidden tab) time goes on where it stopped.
const LONGEST_S: f64 = 0.1;

thread_local! {
    static APP: RefCell<Option<App>> = const { RefCell::new(None) };
}

struct App {
    page: Page,
    stage: Stage,
    /// The worker that grows the page's plant.
    mail: Option<Mail>,
    /// The figures while they are open.
    gallery: Option<Gallery>,
    messages: Messages,
    chooser: Chooser,
    timeline: Timeline,
    show_chooser: ShowChooser,
    panel: Panel,
    controls: Controls,
    surroundings: Surroundings,
    frames: Frames,
    canvases: Canvases,
    _pointer: Pointer,
    _keyboard: [Listener; 2],
    _link: Listener,
}

/// Starts the page: the worker and the graphics card at the same time.
pub fn start() {
    let fragment = fragment();
    let (page, effects) = Page::open(&fragment, plants::all());
    let stage = Stage::new();
    let mut app = App {
        mail: None,
        gallery: None,
        messages: Messages::new(),
        chooser: Chooser::new(plants::all()),
        timeline: Timeline::new(),
        show_chooser: ShowChooser::new(),
        panel: Panel::new(),
        controls: Controls::new(),
        surroundings: Surroundings::new(),
        frames: Frames::new(),
        canvases: Canvases::default(),
        _pointer: Pointer::new(stage.element()),
        _keyboard: keyboard::listen(stage.element()),
        _link: on(&window(), "hashchange", |_: web_sys::Event| with(App::open_address)),
        page,
        stage,
    };
    if let Some(number) = asked_figure(&fragment) {
        app.gallery = Some(Gallery::open(number, &app.page.link()));
    }
    app.act(effects);
    let calm = app.surroundings.less_motion();
    app.hear(Event::LessMotion(calm));
    APP.set(Some(app));
}

/// Ends the page: all that it listens to, and its worker.
pub fn end() {
    APP.take();
}

/// Tells the page that something has happened.
pub fn send(event: Event) {
    with(|app| app.hear(event));
}

/// The canvas to start a renderer on, and its number.
pub fn canvas() -> Option<(web_sys::HtmlCanvasElement, u32)> {
    APP.with_borrow(|app| app.as_ref().map(|app| (app.stage.canvas(), app.canvases.current())))
}

/// Whether the canvas of this number is the one on the stage.
pub fn is_current(canvas: u32) -> bool {
    APP.with_borrow(|app| app.as_ref().is_some_and(|app| app.canvases.current() == canvas))
}

/// Puts a canvas on the stage that has not been drawn on.
pub fn renew_canvas() {
    with(|app| app.stage.renew_canvas());
}

/// The renderer of the current canvas is there.
pub fn run(renderer: Renderer) {
    with(|app| {
        app.stage.run(renderer);
        app.repaint();
    });
}

/// Nothing can be drawn: the still picture stays, and a message says so.
pub fn stay_still(message: &str) {
    with(|app| {
        app.stage.stay_still();
        app.messages.keep(message);
        app.refresh();
    });
}

/// The graphics device of the canvas of this number is lost or of no use: starts another, unless
/// that was done.
pub fn lost(canvas: u32) {
    with(|app| app.lose(canvas));
}

pub fn resized() {
    with(|app| {
        app.stage.measure();
        app.frames.ask();
    });
}

/// What the frame shows changed without the page's doing: dark or light.
pub fn repaint() {
    with(App::repaint);
}

/// Tells the figures that something has happened.
pub fn send_to_figures(event: gallery::Event) {
    with(|app| app.hear_figures(event));
}

/// Whether the figures stand in the place of the plant.
pub fn shows_figures() -> bool {
    APP.with_borrow(|app| app.as_ref().is_some_and(|app| app.gallery.is_some()))
}

/// Makes a figure the one that grows, unless it is.
pub fn open_figure(figure: &'static Figure) {
    with(|app| {
        if app.gallery.as_ref().is_some_and(|gallery| !gallery.grows(figure)) {
            app.hear_figures(gallery::Event::Open(figure));
        }
    });
}

/// The reader scrolls through the figures.
pub fn figures_scrolled() {
    with(|app| {
        if let Some(gallery) = &mut app.gallery {
            gallery.scrolled();
            app.frames.ask();
        }
    });
}

/// The next frame is due.
pub fn frame(now_ms: f64) {
    with(|app| app.frame(now_ms));
}

/// A message that is soon over, such as "Link copied".
pub fn say(text: &str) {
    with(|app| app.messages.say(text));
}

/// A message that stays until it is dismissed.
pub fn tell(text: &str) {
    with(|app| app.messages.tell(&[text.to_string()]));
}

/// Sets a parameter back to the preset of the plant.
pub fn reset_parameter(parameter: &'static Parameter) {
    with(|app| {
        let value = parameter.preset(app.page.scene().plant);
        app.hear(Event::Change { key: parameter.key, value });
    });
}

/// The address of what is shown, also while it plays.
pub fn address() -> String {
    if let Some(number) = asked_figure(&fragment()) {
        return format!("{}#figures/{number}", base());
    }
    let link = APP.with_borrow(|app| app.as_ref().map(|app| app.page.link()));
    format!("{}#{}", base(), link.unwrap_or_default())
}

/// The individual that is wished now.
pub fn individual() -> u32 {
    APP.with_borrow(|app| app.as_ref().map_or(0, |app| app.page.scene().individual))
}

fn with(f: impl FnOnce(&mut App)) {
    APP.with_borrow_mut(|app| app.as_mut().map(f));
}

impl App {
    fn start_worker(&mut self) {
        let started = Mail::start(|said| match said {
            Ok(answer) => send(Event::FromWorker(answer)),
            Err(why) => send(Event::WorkerLost(why)),
        });
        match started {
            Ok(mail) => self.mail = Some(mail),
            Err(why) => self.hear(Event::WorkerLost(why)),
        }
    }

    /// Shows what the address asks for: the figures or a plant.
    fn open_address(&mut self) {
        let fragment = fragment();
        let asked = asked_figure(&fragment);
        if self.gallery.take().is_some() || asked.is_some() {
            // The figures are drawn on the page's stage.
            self.stage.forget();
        }
        if let Some(number) = asked {
            self.gallery = Some(Gallery::open(number, &self.page.link()));
        }
        self.hear(Event::OpenLink(fragment));
    }

    fn hear_figures(&mut self, event: gallery::Event) {
        let effects = self.gallery.as_mut().map(|gallery| gallery.hear(event));
        self.act(effects.unwrap_or_default());
        self.frames.ask();
    }

    /// Draws everything again.
    fn repaint(&mut self) {
        if let Some(gallery) = &mut self.gallery {
            gallery.forget_drawn();
        }
        self.refresh();
    }

    fn hear(&mut self, event: Event) {
        let effects = self.page.hear(event);
        self.act(effects);
        self.refresh();
    }

    fn act(&mut self, effects: Vec<Effect>) {
        for effect in effects {
            match effect {
                Effect::Post(wish) => {
                    if let Some(mail) = &self.mail {
                        mail.post(&wish);
                    }
                }
                Effect::StartWorker => self.start_worker(),
                Effect::EndWorker => self.mail = None,
                Effect::Reload => {
                    if !mail::reload_once() {
                        self.hear(Event::WorkerLost(
                            "Parts of this page are of different versions. Please empty the \
                             browser's cache for it and load it again."
                                .to_string(),
                        ));
                    }
                }
                Effect::LoadMesh(name) => spawn_local(load_mesh(name)),
                Effect::WriteLink(link) => write_link(&link),
                Effect::Say(text) => {
                    document().set_title(&format!("{text} · Clonal Mosaic"));
                    self.messages.say(&text);
                }
                Effect::Tell(texts) => self.messages.tell(&texts),
            }
        }
    }

    /// Brings the document into agreement with the page, and asks for a frame: whether there is
    /// anything to draw is decided there.
    fn refresh(&mut self) {
        self.show();
        self.frames.ask();
    }

    fn show(&mut self) {
        let page = &self.page;
        self.chooser.show(page);
        self.timeline.show(page);
        self.show_chooser.show(page);
        self.panel.show(page);
        self.controls.show(page);
        self.show_state();
    }

    fn show_state(&self) {
        let state = self.gallery.as_ref().map_or(self.page.state(), Gallery::state);
        self.controls.show_state(state, &self.page, self.stage.backend());
    }

    fn frame(&mut self, now_ms: f64) {
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
        }
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

    fn lose(&mut self, canvas: u32) {
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
}

async fn load_mesh(name: &'static str) {
    let packed = name.replace(".obj", ".txt");
    let packed = mail::fetch_text(&format!("./meshes/{packed}?build={BUILD}")).await;
    let text = packed.map(|packed| unpack(&packed));
    send_to_figures(gallery::Event::Mesh { name, text: text.clone() });
    send(Event::Mesh { name, text });
}
