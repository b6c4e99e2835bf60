//! The figures, and the series that stand in their place.

use super::super::address::fragment;
use super::super::controls::load_studio;
use super::super::files;
use super::super::gallery::Gallery;
use super::{App, with};
use crate::play::figures;
use crate::play::series::asked_view;
use wasm_bindgen_futures::spawn_local;

/// The path of the text of all figures.
const TEXT: &str = "figures.txt";

/// Fetches the text of the figures, and opens them with it if somebody still waits for them.
async fn load() {
    let came = files::read(TEXT).await.map(figures::take);
    with(|app| app.figures_came(came));
}

impl App {
    /// Opens the figures or a series if the fragment of the address asks for them.
    pub(super) fn open_gallery(&mut self, fragment: &str) {
        if let Some((view, asked)) = asked_view(fragment) {
            // It is drawn on the page's stage.
            self.stage.forget();
            if !view.is_of_figures() {
                load_studio("pictures");
            } else if figures::all().is_empty() {
                spawn_local(load());
            }
            self.gallery = Some(Gallery::open(view, asked, &self.page.link(), &self.bookmark));
        }
    }

    /// The text of the figures has come, or why it cannot: they open anew if they wait for it.
    fn figures_came(&mut self, came: Result<(), String>) {
        if !self.gallery.as_ref().is_some_and(Gallery::is_empty) {
            return;
        }
        if let (Some(gallery), Err(why)) = (&mut self.gallery, &came) {
            gallery.fail(why);
        } else {
            self.gallery = None;
            self.open_gallery(&fragment());
        }
        self.frames.ask();
    }
}
