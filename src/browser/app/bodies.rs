//! The texts of bodies: from the host, or those that the page holds.

use super::send;
use crate::browser::controls::load_studio;
use crate::browser::dom::{document, set_attribute};
use crate::browser::files;
use crate::plants;
use crate::play::gallery;
use crate::play::page::Event;
use crate::surface::unpack;

/// Has a plant of the visitor's own known before its link is read. The studio puts it into the page, and knows
/// whether it was kept.
pub fn bring_own(fragment: &str) {
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

/// Reads a mesh, for the plant and for the figures.
pub async fn load_mesh(name: &'static str) {
    let text = files::read_mesh(name).await.map(|packed| unpack(&packed));
    super::send_to_figures(gallery::Event::Mesh { name, text: text.clone() });
    send(Event::Mesh { name, text });
}
