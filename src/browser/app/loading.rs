//! What is loaded for a link before it grows.

use super::super::controls::load_studio;
use super::super::dom::{document, set_attribute};
use super::super::files;
use super::{send, send_to_figures};
use crate::plants;
use crate::play::gallery;
use crate::play::page::Event;
use crate::surface::unpack;

/// Has a plant of the visitor's own known before its link is read. The studio puts it into the page, and knows
/// whether it was kept.
pub(super) fn bring_own(fragment: &str) {
    let is_of_key = |c: char| c.is_ascii_alphanumeric() || c == '-';
    let mut words = fragment.split(|c| !is_of_key(c));
    let Some(key) = words.find(|word| word.starts_with(plants::OWN)) else { return };
    match files::held(&format!("meshes/{key}.txt")) {
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

pub(super) async fn load_mesh(name: &'static str) {
    let text = files::read_mesh(name).await.map(|packed| unpack(&packed));
    send_to_figures(gallery::Event::Mesh { name, text: text.clone() });
    send(Event::Mesh { name, text });
}
