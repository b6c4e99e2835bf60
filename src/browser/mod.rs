//! The edge to the browser: puts the brains of page and worker into a document and a worker thread.
//! What can be decided without a browser is decided in `play`.

#[cfg(feature = "draw")]
mod app;
#[cfg(feature = "draw")]
mod backend;
#[cfg(feature = "draw")]
mod chooser;
#[cfg(feature = "draw")]
mod controls;
#[cfg(feature = "draw")]
mod dom;
#[cfg(feature = "draw")]
mod frames;
#[cfg(feature = "draw")]
mod keyboard;
#[cfg(feature = "draw")]
mod mail;
#[cfg(feature = "draw")]
mod messages;
#[cfg(feature = "draw")]
mod panel;
#[cfg(feature = "draw")]
mod pointer;
#[cfg(feature = "draw")]
mod stage;
#[cfg(feature = "draw")]
mod surroundings;
#[cfg(feature = "draw")]
mod timeline;
mod worker;

#[cfg(feature = "draw")]
pub use backend::start_page;
pub use worker::start_worker;
