//! The playground without a browser: scene, link, camera, messages, and the brains of page and
//! worker.

pub mod atlas;
pub mod camera;
pub mod canvases;
pub mod classroom;
pub mod clone;
pub mod detail;
mod events;
pub mod figures;
pub mod gallery;
mod hand;
pub mod handed;
mod history;
pub mod lesson;
pub mod link;
mod meshes;
mod narration;
pub mod offline;
pub mod origin;
pub mod outline;
pub mod page;
pub mod parameters;
pub mod phrasebook;
pub mod pick;
pub mod playhead;
pub mod protocol;
mod run;
mod scene;
pub mod series;
pub mod simple;
pub mod strip;
#[cfg(test)]
mod testing;
#[cfg(test)]
mod together;
pub mod typed;
pub mod words;
pub mod worker;

pub use run::{DayFacts, End, Run};
pub use scene::{FIRST_INDIVIDUAL, Scene};
