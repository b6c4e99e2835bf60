//! What lies before the first live picture: bytes and milliseconds.

use crate::engines::Graphics;
use crate::page::Page;
use crate::server::dist;
use clonal_mosaic::plants::{self, Plant};
use clonal_mosaic::play::{FIRST_INDIVIDUAL, Scene, link};
use flate2::{Compression, write::GzEncoder};
use serde_json::json;
use std::io::Write;

/// Bytes that a visitor may have to download, compressed, until cells are seen.
const MOST_BYTES_WEBGPU: usize = 320_000;
const MOST_BYTES_WEBGL2: usize = 1_020_000;
/// And when something of the studio is first wanted.
const MOST_BYTES_STUDIO: usize = 268_000;

/// Nothing that exists, asked for when the first live picture stands.
const MARKER: &str = "the-plant-lives";

/// From navigation to the first live picture.
pub struct Start {
    /// The files that were asked for, and their bytes after `gzip -9`.
    pub files: Vec<(String, usize)>,
    /// Until the browser was asked for the frame after it.
    pub milliseconds: f64,
}

impl Start {
    /// Opens a link in a browser that has nothing in its cache.
    pub fn of(graphics: Graphics, link: &str) -> Option<Start> {
        // Sees the stage come alive from within: no question from outside slows the page down.
        let watch = format!(
            "new MutationObserver((_, watcher) => {{
                if (!document.querySelector('#stage[data-live]')) return;
                watcher.disconnect();
                fetch('{MARKER}').then(() => {{ window.marked = true }});
                requestAnimationFrame(() => {{ window.live_ms = performance.now() }})
            }}).observe(document, {{subtree: true, attributeFilter: ['data-live']}})"
        );
        let page = Page::start(graphics)?;
        page.devtools("Page.addScriptToEvaluateOnNewDocument", json!({ "source": watch }));
        page.visit(link);
        page.wait_for("the first live picture", "return !!(window.live_ms && window.marked)");
        let before = page.server.requested().into_iter().take_while(|name| name != MARKER);
        let files = before.map(|name| {
            let bytes = gzipped_bytes(&name);
            (name, bytes)
        });
        let files = files.collect();
        let milliseconds = page.run("return window.live_ms").as_f64().expect("a number");
        Some(Start { files, milliseconds })
    }

    pub fn bytes(&self) -> usize {
        self.files.iter().map(|(_, bytes)| bytes).sum()
    }
}

/// The link of a plant as the chooser opens it.
pub fn preset_link(plant: &'static Plant) -> String {
    format!("#{}", link::write(&Scene::preset(plant, FIRST_INDIVIDUAL)))
}

fn gzipped_bytes(name: &str) -> usize {
    let file = dist().join(if name.is_empty() { "index.html" } else { name });
    let content = std::fs::read(&file).unwrap_or_else(|e| panic!("{}: {e}", file.display()));
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(&content).expect("memory takes it");
    encoder.finish().expect("memory takes it").len()
}

/// The files that a plant asks for, told from those of another one: its own are its body and its still.
fn files_like(files: &[(String, usize)], other: &Plant, plant: &Plant) -> Vec<(String, usize)> {
    let own = |plant: &Plant| {
        let mesh = plant.body.mesh.name.replace(".obj", ".txt");
        [format!("meshes/{mesh}"), format!("posters/{}.avif", plant.key)]
    };
    let [theirs, ours] = [own(other), own(plant)];
    assert!(theirs.iter().all(|name| files.iter().any(|(file, _)| file == name)), "{files:?}");
    let name_of = |name: &String| match theirs.iter().position(|their| their == name) {
        Some(k) => ours[k].clone(),
        None => name.clone(),
    };
    files
        .iter()
        .map(|(name, _)| name_of(name))
        .map(|name| (name.clone(), gzipped_bytes(&name)))
        .collect()
}

/// Two plants are opened; what the others ask for is told from that.
fn assert_light(graphics: Graphics, most_bytes: usize) {
    let [first, second] = [&plants::all()[0], &plants::all()[3]];
    let Some(start) = Start::of(graphics, &preset_link(first)) else { return };
    let Some(other) = Start::of(graphics, &preset_link(second)) else { return };
    let sorted = |mut files: Vec<(String, usize)>| {
        files.sort();
        files
    };
    assert_eq!(sorted(other.files), sorted(files_like(&start.files, first, second)));
    for plant in plants::all() {
        let files = files_like(&start.files, first, plant);
        let bytes: usize = files.iter().map(|(_, bytes)| bytes).sum();
        assert!(bytes <= most_bytes, "{}: {bytes} bytes, {files:#?}", plant.key);
        let later = ["offline.js", "install/", "studio", "workshop", "darkroom", "figures"];
        let is_kept_later = files.iter().all(|(name, _)| !later.iter().any(|of| name.contains(of)));
        assert!(is_kept_later, "what is for later comes after it: {files:#?}");
    }
}

#[test]
fn the_first_picture_is_light_with_webgpu() {
    assert_light(Graphics::WebGpu, MOST_BYTES_WEBGPU);
}

#[test]
fn the_first_picture_is_light_with_webgl2() {
    assert_light(Graphics::WebGl2, MOST_BYTES_WEBGL2);
}

#[test]
fn what_the_studio_shows_is_light() {
    let names = std::fs::read_dir(dist()).expect("a built page");
    let mut names = names.filter_map(|entry| entry.ok()?.file_name().into_string().ok());
    let folder = names.find(|name| name.starts_with("bundles-")).expect("bundles");
    let bytes = gzipped_bytes(&format!("{folder}/studio_bg.wasm"));
    assert!(bytes <= MOST_BYTES_STUDIO, "{bytes} bytes");
}
