//! The edge to the browser: puts the brains of page and worker into a document and a worker thread.
//! What can be decided without a browser is decided in `play`.

mod address;
#[cfg(feature = "draw")]
mod app;
#[cfg(feature = "draw")]
mod backend;
mod boot;
#[cfg(feature = "draw")]
mod card;
#[cfg(feature = "draw")]
mod chooser;
#[cfg(feature = "draw")]
mod controls;
#[cfg(feature = "draw")]
mod darkroom;
mod dom;
mod files;
#[cfg(feature = "draw")]
mod fingers;
#[cfg(feature = "draw")]
mod frames;
#[cfg(feature = "draw")]
mod gallery;
#[cfg(feature = "draw")]
mod host;
mod interpreter;
#[cfg(feature = "draw")]
mod keyboard;
#[cfg(feature = "draw")]
mod mail;
#[cfg(feature = "draw")]
mod messages;
mod offline;
#[cfg(feature = "draw")]
mod panel;
#[cfg(feature = "draw")]
mod pointer;
#[cfg(feature = "draw")]
mod sheet;
#[cfg(feature = "draw")]
mod show;
#[cfg(feature = "draw")]
mod stage;
mod studio;
#[cfg(feature = "draw")]
mod surroundings;
#[cfg(feature = "draw")]
mod timeline;
#[cfg(feature = "draw")]
mod turning;
#[cfg(feature = "draw")]
mod typing;
#[cfg(feature = "draw")]
mod welcome;
#[cfg(feature = "draw")]
mod worker;
mod workshop;

/// Starts the bundle that chooses among the others.
pub fn start_boot() {
    boot::boot();
}

/// Starts what says the page in another language.
pub fn start_interpreter() {
    console_error_panic_hook::set_once();
    interpreter::start();
}

/// Starts the studio.
pub fn start_studio() {
    console_error_panic_hook::set_once();
    studio::start();
}

/// Starts the worker that grows and writes for the studio.
pub fn start_workshop() {
    console_error_panic_hook::set_once();
    workshop::listen();
}

/// Starts the worker that draws films and large pictures for the studio.
#[cfg(feature = "draw")]
pub fn start_darkroom() {
    console_error_panic_hook::set_once();
    darkroom::listen();
}

/// Starts the service worker, which keeps a build of which all files are named.
pub fn start_service_worker(build: &str, files: &str) {
    console_error_panic_hook::set_once();
    offline::keep(build, files);
}

/// Starts what a bundle is: the page, or, where it was started as a worker, the worker.
#[cfg(feature = "draw")]
pub fn start() {
    console_error_panic_hook::set_once();
    if web_sys::window().is_some() { backend::start_page() } else { worker::start_worker() }
}
