//! What the page's brain hears and says: events in, effects out, and what is to be on the screen.

use super::protocol::{ToPage, ToWorker};
use super::run::DayFacts;
use crate::plants::Show;
use glam::Vec2;

/// What can happen to the page.
#[derive(Clone, Debug)]
pub enum Event {
    /// A link was opened: the fragment of an address. One of the figures leaves the plant.
    OpenLink(String),
    /// The key of a plant was chosen: its preset, with the individual that is shown.
    ChoosePlant(String),
    /// Another individual of the same plant, by its number as it was typed.
    Individual(f64),
    /// A parameter, by its key, was changed.
    Change {
        key: &'static str,
        value: f64,
    },
    /// All parameters back to the preset.
    ResetParameters,
    /// Perlin noise in the place of the cells' own types, or not.
    Noise(bool),
    /// Something else is to be seen on the body.
    Show(Show),
    /// The clone of a cell, by its number, is taken in hand, or with `clan` the one of its first cell; what
    /// is in hand already is let go.
    Take {
        cell: u32,
        clan: bool,
    },
    /// The clone of the mother of the cell in hand is taken.
    TakeMother,
    /// The clan of the cell in hand is taken.
    TakeClan,
    /// So many clans on (or back) from the one in hand.
    StepClans(i32),
    /// Whatever clone is in hand is let go.
    PutDown,
    /// A day is wished.
    Seek(u32),
    /// A day as it was typed.
    Day(f64),
    /// Days on (or back) from the wished one.
    StepDays(i32),
    /// The visitor's hand is on the time line, at a time in days.
    Scrub(f64),
    /// The hand lets go.
    LetGo,
    PlayOrPause,
    /// Somebody is here for the first time: it plays once, unless less motion is asked for.
    Premiere,
    /// Whatever the visitor did ends that.
    EndPremiere,
    /// Times the usual speed.
    Speed(f64),
    Loop(bool),
    /// Degrees to the right and upwards.
    Turn {
        right_deg: f32,
        up_deg: f32,
    },
    /// See `Orbit::zoomed`.
    Zoom {
        factor: f32,
        at: Vec2,
    },
    /// See `Orbit::panned`.
    Pan(Vec2),
    ResetView,
    Undo,
    Redo,
    /// Whether the visitor asked for less motion.
    LessMotion(bool),
    /// Time has passed, in seconds.
    Tick(f64),
    FromWorker(ToPage),
    /// A mesh file came, or why it cannot.
    Mesh {
        name: &'static str,
        text: Result<String, String>,
    },
    /// The worker is gone or cannot be had, and why.
    WorkerLost(String),
    /// What `shown` says is on the screen.
    Drawn {
        /// With all pixels of the stage.
        sharp: bool,
    },
    /// Nothing is on the screen any more: the graphics device is lost.
    PictureLost,
}

/// What was put in a field and cannot be.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// The field's word in links.
    pub field: &'static str,
    /// A sentence.
    pub why: String,
}

/// What the page's host has to do.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect {
    /// Start a worker, in the place of the one that is there; `WorkerLost` if there is none to be had.
    StartWorker,
    /// End the worker.
    EndWorker,
    Post(ToWorker),
    /// Load a mesh file: `Event::Mesh` is to follow.
    LoadMesh(&'static str),
    /// The worker is of another build: load the page again, once.
    Reload,
    /// The address of what is shown, without `#`, in the place of the one before.
    WriteLink(String),
    /// The same, but the one before stays in the browser's history.
    PushLink(String),
    /// For the live region, and the page has a new title.
    Say(String),
    /// Messages for the visitor, to be dismissed by hand; they replace older ones.
    Tell(Vec<String>),
}

/// Where the page stands, as `data-state` says it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// Nothing has grown yet.
    Loading,
    /// The wished day is not on the screen yet.
    Growing,
    /// The wished day is on the screen, with all pixels if it rests.
    Ready,
    /// It will not come; the messages say why.
    Error,
}

impl State {
    /// Its word for tests and embedders.
    pub fn word(self) -> &'static str {
        match self {
            State::Loading => "loading",
            State::Growing => "growing",
            State::Ready => "ready",
            State::Error => "error",
        }
    }
}

/// What is to be on the screen.
#[derive(Clone, Debug, PartialEq)]
pub struct Shown {
    pub plant: &'static str,
    pub individual: u32,
    /// The growth that the day is of.
    pub generation: u32,
    /// None: the bare body.
    pub day: Option<ShownDay>,
}

/// A day on the screen.
#[derive(Clone, Debug, PartialEq)]
pub struct ShownDay {
    pub day: u32,
    /// How far the cells are on their way from the day before, 0 to 1.
    pub moment: f32,
    pub facts: DayFacts,
}
