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
    let Some(at) = fragment.find(plants::OWN) else { return };
    let key = fragment[at..].split('?').next().unwrap_or_default();
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
