//! The mesh files that the page has loaded and handed to its workers: each once.

use super::page::Effect;
use super::protocol::ToWorker;

#[derive(Debug, Default)]
pub struct Meshes {
    files: Vec<File>,
}

#[derive(Debug)]
struct File {
    name: &'static str,
    /// None while it is on its way.
    text: Option<String>,
    /// The numbers of the workers that have it.
    handed_to: Vec<usize>,
}

impl Meshes {
    /// What stands in a file, once a worker has it, too: the first cells wait for the worker, and so
    /// a page that builds the body for itself does that while the worker is busy.
    pub fn text(&self, name: &str) -> Option<&str> {
        let handed = |file: &&File| file.name == name && !file.handed_to.is_empty();
        self.files.iter().find(handed)?.text.as_deref()
    }

    /// Whether a file is there. Has it loaded if it was not asked for yet, and hands it to the worker
    /// of a number, given if that one listens, unless it has it.
    pub fn provide(
        &mut self,
        name: &'static str,
        worker: Option<usize>,
        effects: &mut Vec<Effect>,
    ) -> bool {
        let Some(file) = self.files.iter_mut().find(|file| file.name == name) else {
            self.files.push(File { name, text: None, handed_to: Vec::new() });
            effects.push(Effect::LoadMesh(name));
            return false;
        };
        let Some(text) = &file.text else { return false };
        if let Some(worker) = worker.filter(|worker| !file.handed_to.contains(worker)) {
            file.handed_to.push(worker);
            let (name, text) = (name.to_string(), text.clone());
            effects.push(Effect::Post(ToWorker::Mesh { name, text }));
        }
        true
    }

    /// Takes a file that came. One that cannot is forgotten, so that the next wish asks for it
    /// again, and the reason returned.
    pub fn take(&mut self, name: &str, text: Result<String, String>) -> Option<String> {
        match text {
            Ok(text) => {
                let file = self.files.iter_mut().find(|file| file.name == name)?;
                file.text = Some(text);
                None
            }
            Err(why) => {
                self.files.retain(|file| file.name != name);
                Some(why)
            }
        }
    }
}
