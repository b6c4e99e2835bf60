//! The one application of this page: takes events to the page's brain, does what it says, and brings
//! the document into agreement with it.

mod figures;
mod frame;
mod loading;

use super::address::{fragment, mark_ui, push_link, wanted, with_fragment, write_link};
use super::card::Card;
use super::chooser::Chooser;
use super::controls::{Controls, load_studio};
use super::dom::{Listener, document, on, window};
use super::fingers::Fingers;
use super::frames::Frames;
use super::gallery::{Bookmark, Gallery};
use super::host::Host;
use super::keyboard;
use super::mail::{self, Mail};
use super::messages::Messages;
use super::offline;
use super::panel::Panel;
use super::pointer::Pointer;
use super::sheet::Sheet;
use super::show::ShowChooser;
use super::stage::Stage;
use super::surroundings::Surroundings;
use super::timeline::Timeline;
use super::welcome::{Welcome, is_first_visit};
use crate::draw::Renderer;
use crate::plants;
use crate::play::canvases::Canvases;
use crate::play::figures::Figure;
use crate::play::gallery;
use crate::play::page::{Effect, Event, Page, State};
use crate::play::parameters::Parameter;
use crate::play::series::asked_view;
use glam::Vec2;
use loading::{bring_own, load_mesh};
use std::cell::RefCell;
use wasm_bindgen_futures::spawn_local;

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
    /// Where the reader of the figures was when they were left.
    bookmark: Bookmark,
    messages: Messages,
    chooser: Chooser,
    timeline: Timeline,
    show_chooser: ShowChooser,
    panel: Panel,
    card: Card,
    controls: Controls,
    surroundings: Surroundings,
    frames: Frames,
    canvases: Canvases,
    welcome: Welcome,
    /// The page around this one, if it stands in a frame.
    host: Option<Host>,
    _pointer: Pointer,
    _fingers: Fingers,
    _sheet: Sheet,
    _listeners: [Listener; 4],
}

/// Starts the page: the worker and the graphics card at the same time.
pub fn start() {
    let asked = fragment();
    bring_own(&asked);
    let (page, effects) = Page::open(&asked, plants::all());
    let stage = Stage::new();
    let [stage_keys, keys] = keyboard::listen(stage.element());
    let link = on(&window(), "hashchange", |_: web_sys::Event| {
        mark_ui();
        load_studio(&wanted());
        open_link(&fragment());
    });
    let print = on(&window(), "beforeprint", |_: web_sys::Event| {
        let address = address();
        with(|app| app.print(&address));
    });
    let mut app = App {
        mail: None,
        gallery: None,
        bookmark: Bookmark::default(),
        messages: Messages::new(),
        chooser: Chooser::new(),
        timeline: Timeline::new(),
        show_chooser: ShowChooser::new(),
        panel: Panel::new(),
        card: Card::new(),
        controls: Controls::new(),
        surroundings: Surroundings::new(),
        frames: Frames::new(),
        canvases: Canvases::default(),
        welcome: Welcome::new(),
        host: Host::find(stage.element()),
        _pointer: Pointer::new(stage.element()),
        _fingers: Fingers::new(),
        _sheet: Sheet::new(),
        _listeners: [stage_keys, keys, link, print],
        page,
        stage,
    };
    app.open_gallery(&asked);
    app.act(effects);
    let calm = app.surroundings.less_motion();
    app.hear(Event::LessMotion(calm));
    // Kept at every visit, whatever its address shows.
    if is_first_visit() && asked.len() < 2 && !calm {
        app.hear(Event::Premiere);
        app.welcome.show();
    }
    APP.set(Some(app));
    load_studio(&wanted());
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

/// Zooms by a factor, to the place of the plant that is nearest to a point: see `Orbit::zoomed`.
pub fn zoom(factor: f32, at: Vec2) {
    with(|app| app.zoom(factor, at));
}

/// Takes the clone of the cell at a point of the stage, or its clan; see `Stage::cell_at`. Where there is no
/// cell, what is in hand is let go.
pub fn take(at: Option<Vec2>, clan: bool) {
    with(|app| {
        let cell = app.stage.cell_at(&app.page, at);
        app.hear(cell.map_or(Event::PutDown, |cell| Event::Take { cell, clan }));
    });
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

/// Shows what the fragment of an address asks for.
pub fn open_link(fragment: &str) {
    with(|app| app.open_link(fragment));
}

/// Whether anybody sees the page, which stands in a frame.
pub fn seen(is_seen: bool) {
    with(|app| app.frames.hold(!is_seen));
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
    let fragment = fragment();
    if asked_view(&fragment).is_some() {
        return with_fragment(fragment.trim_start_matches('#'));
    }
    let link = APP.with_borrow(|app| app.as_ref().map(|app| app.page.link()));
    with_fragment(&link.unwrap_or_default())
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

    /// Shows what a link asks for: the figures or a plant.
    fn open_link(&mut self, fragment: &str) {
        bring_own(fragment);
        if let Some(gallery) = self.gallery.take() {
            self.bookmark = gallery.bookmark();
            self.stage.forget();
        }
        self.open_gallery(fragment);
        self.hear(Event::OpenLink(fragment.to_string()));
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
                Effect::PushLink(link) => push_link(&link),
                Effect::Say(text) => {
                    document().set_title(&format!("{} · Clonal Mosaic", self.page.title()));
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
        self.card.show(page);
        self.controls.show(page);
        self.show_state();
    }

    fn show_state(&self) {
        let state = self.gallery.as_ref().map_or(self.page.state(), Gallery::state);
        self.controls.show_state(state, &self.page, self.stage.backend());
        if state == State::Ready {
            offline::keep_page();
        }
    }
}
