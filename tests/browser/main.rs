//! The built page (`dist/`) in headless Chromium, and its main journey in Firefox and WebKit, driven
//! through WebDriver as their visitors would.
//!
//! `./playground test` builds the page and fails where Chromium or the page is missing; a plain
//! `cargo test` skips these tests then, and says so. Firefox and WebKit are skipped, and named, where
//! they cannot be installed.

mod axe;
mod back;
mod base64;
mod bring_in;
mod class;
mod clones;
mod codap;
mod darkroom;
mod embedding;
mod engines;
mod fields;
mod figures;
mod fingers;
mod fit;
mod flowers;
mod graphics;
mod hosts;
mod icons;
mod journeys;
mod keys;
mod ladder;
mod languages;
mod lessons;
mod light;
mod losses;
mod measure;
mod measure_class;
mod measure_wished;
mod offline;
mod one_file;
mod page;
mod paint;
mod paper;
mod pixels;
mod policy;
mod posters;
mod rays;
mod reach;
mod sameness;
mod series;
mod server;
mod shapes;
mod start;
mod studio;
mod three_engines;
mod told;
mod tour;
mod views;
mod webdriver;
mod welcome;
