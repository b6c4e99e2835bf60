//! What is loaded for a link before it grows.

use super::super::controls::load_studio;
use super::super::dom::{document, set_attribute};
use super::super::files;
use super::{send, send_to_figures};
use crate::plants;
use crate::play::gallery;
use crate::play::page::Event;
use crate::surface::unpack;

/// Has plants of files of their own known before a link with them is read. The studio puts them into the page, and knows
/// whether one was kept.
pub(super) fn bring_own(fragment: &str) {
    let is_of_key = |c: char| c.is_ascii_alphanumeric() || c == '-';
    let words = fragment.split(|c| !is_of_key(c));
    for key in words.filter(|word| word.starts_with(plants::OWN)) {
        match files::held(&files::mesh(key)) {
            Some(text) => {
                plants::bring(&text);
            }
            None => {
                let root = document().document_element().expect("a document has a root");
                set_attribute(&root, "data-own", fragment);
                load_studio("own");
            }
        }
    }
}

pub(super) async fn load_mesh(name: &'static str) {
    let text = files::read_mesh(name).await.map(|packed| unpack(&packed));
    if let Ok(text) = &text
        && name.starts_with(plants::OWN)
    {
        files::hold(&files::mesh(name), text);
    }
    send_to_figures(gallery::Event::Mesh { name, text: text.clone() });
    send(Event::Mesh { name, text });
}
