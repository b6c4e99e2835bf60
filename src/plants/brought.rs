//! Plants of a visitor's own: the text of a body whose first line is the plant that lives on it. Who has the text
//! knows the plant, as long as the program runs.

use super::words::{Reader, Words};
use super::{MeshFile, Plant, Shape, Text};
use crate::surface::PLAIN;
use crate::tissue::name_of;
use std::cell::RefCell;

thread_local! {
    static BROUGHT: RefCell<Vec<Own>> = const { RefCell::new(Vec::new()) };
}

/// A plant that was brought, and the mesh of the catalogue that its document names.
#[derive(Clone, Copy)]
struct Own {
    plant: &'static Plant,
    mesh: MeshFile,
}

/// How keys of such plants begin: no plant of the catalogue is called so.
pub const OWN: &str = "own-";

/// The text of a plant and its body as OBJ. Its key is made of what is in it.
pub fn to_text(plant: &Plant, obj: &str) -> (String, String) {
    let mut words = Vec::new();
    plant.push(&mut words);
    let mut line = PLAIN.to_string();
    for word in words {
        line += &format!("{word:x}.");
    }
    let key = format!("{OWN}{}", name_of(line.bytes().chain(obj.bytes()).map(u64::from)));
    (key.clone(), format!("{line} {key}\n{obj}"))
}

/// Takes a plant that was brought, unless it is known; none where the text is that of a mesh alone.
pub fn bring(text: &str) -> Option<&'static Plant> {
    let (line, _) = text.strip_prefix(PLAIN)?.split_once('\n')?;
    let (words, key) = line.split_once(' ')?;
    if let Some(known) = brought(key) {
        return Some(known);
    }
    let words = words.split_terminator('.').map(|word| u32::from_str_radix(word, 16).ok());
    let words: Vec<u32> = words.collect::<Option<_>>()?;
    let plant: Plant = Reader::read(&words)?;
    let key: Text = key.to_string().leak();
    let mesh = MeshFile {
        name: format!("{key}.obj").leak(),
        #[cfg(not(target_arch = "wasm32"))]
        text: text.to_string().leak(),
    };
    let named = plant.body.mesh;
    let plant = Plant { key, body: Shape { mesh, ..plant.body }, ..plant };
    let plant: &Plant = Box::leak(Box::new(plant));
    BROUGHT.with_borrow_mut(|all| all.push(Own { plant, mesh: named }));
    Some(plant)
}

/// The plant that was brought under a key.
pub fn brought(key: &str) -> Option<&'static Plant> {
    own(key).map(|own| own.plant)
}

impl Plant {
    /// A plant that was brought, as its document has it: on the mesh that it names.
    pub fn as_written(&self) -> Plant {
        let mesh = own(self.key).map_or(self.body.mesh, |own| own.mesh);
        Plant { body: Shape { mesh, ..self.body }, ..self.clone() }
    }
}

fn own(key: &str) -> Option<Own> {
    BROUGHT.with_borrow(|all| all.iter().find(|own| own.plant.key == key).copied())
}

#[cfg(test)]
mod tests {
    use super::super::find;
    use super::*;

    #[test]
    fn a_plant_that_was_brought_is_found_by_its_key() {
        let croton = find("croton").unwrap();
        let mine = Plant { name: "Mine", ..croton.clone() };
        let (key, text) = to_text(&mine, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        assert!(key.starts_with(OWN) && brought(&key).is_none());
        let plant = bring(&text).unwrap();
        assert_eq!((plant.key, plant.name), (&*key, "Mine"));
        assert!(std::ptr::eq(plant, bring(&text).unwrap()), "it is brought once");
        assert!(std::ptr::eq(plant, brought(&key).unwrap()));
        assert_eq!(plant.body.grow(plant.body.mesh.text).unwrap().surface.part_count(), 1);
        assert_eq!(plant.as_written(), Plant { key: plant.key, ..mine.clone() });
        let other = to_text(&mine, "v 0 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\n").0;
        assert_ne!(other, key, "another body is another plant");
        for text in ["", "v 0 0 0\n", "# plain 1.2. own-x\n", "# plain zz. own-y\n"] {
            assert!(bring(text).is_none(), "{text}");
        }
    }
}
