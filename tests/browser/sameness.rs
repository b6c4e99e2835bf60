//! The same scene is the same cells: in the worker, natively, and for whoever opens the link.

use crate::engines::Graphics;
use crate::page::Page;
use clonal_mosaic::plants;
use clonal_mosaic::play::link;
use clonal_mosaic::tissue::Progress;
use std::sync::Arc;

/// The fingerprint of a link's day, grown natively.
pub fn native(text: &str) -> String {
    let opened = link::read(text, plants::all());
    assert!(opened.left_out.is_empty(), "{text}: {:?}", opened.left_out);
    let scene = opened.scene;
    let mesh = Arc::new(scene.plant.embedded_body().surface);
    let mut growth = scene.plant.sow(mesh, scene.recipe, scene.individual).unwrap();
    while growth.step() != Progress::Day(scene.day) {}
    growth.diary.fingerprint(scene.day as usize)
}

#[test]
fn the_worker_grows_the_cells_that_grow_natively() {
    let Some(page) = Page::start(Graphics::Neither) else { return };
    for link in [
        "croton?v=1&s=1&d=4",
        "croton?v=1&s=4294967295&d=2",
        "cactus?v=1&s=0&d=2",
        "watermelon?v=1&s=17&d=8",
        "mushroom?v=1&s=3&d=2",
        "philodendron?v=1&s=5&d=9",
    ] {
        page.visit(&format!("#{link}"));
        let state = page.ready();
        assert_eq!(state.fingerprint, native(link), "{link}");
        assert_eq!(page.link(), link, "the address stays as it is");
    }
}

#[test]
fn golden_links_show_what_they_showed() {
    let Some(page) = Page::start(Graphics::Neither) else { return };
    for line in include_str!("../golden_links.txt").lines().filter(|l| !l.starts_with('#')) {
        let (link, fingerprint) = line.split_once(' ').unwrap();
        page.visit(&format!("#{link}"));
        assert_eq!(page.ready().fingerprint, fingerprint, "{link}");
        assert!(!page.messages().contains("left out"), "{link}: {}", page.messages());
    }
}
