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
    text: Text,
    /// The workers that have it: a bit for each number.
    handed_to: u32,
    /// Whether any worker ever had it.
    was_handed: bool,
}

#[derive(Debug, PartialEq)]
enum Text {
    OnItsWay,
    /// It could not be had; the next wish asks for it again.
    Failed,
    Here(String),
}

impl Meshes {
    /// What stands in a file, once a worker has it, too: the first cells wait for the worker, and so
    /// a page that builds the body for itself does that while the worker is busy.
    pub fn text(&self, name: &str) -> Option<&str> {
        match self.files.iter().find(|file| file.name == name && file.was_handed)?.text {
            Text::Here(ref text) => Some(text),
            _ => None,
        }
    }

    /// Whether a file could not be had when it was asked for last.
    pub fn has_failed(&self, name: &str) -> bool {
        self.files.iter().any(|file| file.name == name && file.text == Text::Failed)
    }

    /// Whether a file is there. Has it loaded if it is not on its way, and hands it to the worker of
    /// a number under 32, given if that one listens, unless it has it.
    pub fn provide(
        &mut self,
        name: &'static str,
        worker: Option<usize>,
        effects: &mut Vec<Effect>,
    ) -> bool {
        let known = self.files.iter().position(|file| file.name == name);
        let known = known.unwrap_or_else(|| {
            self.files.push(File { name, text: Text::Failed, handed_to: 0, was_handed: false });
            self.files.len() - 1
        });
        let file = &mut self.files[known];
        let text = match &file.text {
            Text::OnItsWay => return false,
            Text::Failed => {
                file.text = Text::OnItsWay;
                effects.push(Effect::LoadMesh(name));
                return false;
            }
            Text::Here(text) => text,
        };
        if let Some(worker) = worker.filter(|worker| file.handed_to & 1 << worker == 0) {
            file.handed_to |= 1 << worker;
            file.was_handed = true;
            let (name, text) = (name.to_string(), text.clone());
            effects.push(Effect::Post(ToWorker::Mesh { name, text }));
        }
        true
    }

    /// Takes a file that came, or why it cannot. That is news only where it was waited for, and
    /// returned then: the other brain of the page asks for files, too.
    pub fn take(&mut self, name: &str, text: Result<String, String>) -> Option<Result<(), String>> {
        let file = self.files.iter_mut().find(|file| file.name == name)?;
        match (&file.text, text) {
            (Text::Here(_), _) | (Text::Failed, Err(_)) => None,
            (_, Ok(text)) => {
                file.text = Text::Here(text);
                Some(Ok(()))
            }
            (Text::OnItsWay, Err(why)) => {
                file.text = Text::Failed;
                Some(Err(why))
            }
        }
    }

    /// The worker of a number is gone, and its files with it.
    pub fn forget(&mut self, worker: usize) {
        for file in &mut self.files {
            file.handed_to &= !(1 << worker);
        }
    }
}
