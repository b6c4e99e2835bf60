//! The built page (`dist/`) in headless Chromium, driven through chromedriver as its visitor would.
//!
//! `./playground test` builds the page and fails where Chromium or the page is missing; a plain
//! `cargo test` skips these tests then, and says so.

mod figures;
mod graphics;
mod journeys;
mod ladder;
mod light;
mod losses;
mod measure;
mod page;
mod pixels;
mod posters;
mod rays;
mod reach;
mod sameness;
mod server;
mod start;
mod views;
mod webdriver;
