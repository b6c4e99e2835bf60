//! The scenes that a visitor has been through, to go back to and forward again.

use super::Scene;

/// Scenes kept at most: more steps than anybody counts back.
const MOST: usize = 200;

/// What a new scene came from; runs of the same small change are one step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Change {
    View,
    Parameter(&'static str),
    Other,
}

/// The way so far; never empty.
#[derive(Debug)]
pub struct History {
    scenes: Vec<Scene>,
    now: usize,
    last: Change,
}

impl History {
    pub fn new(scene: Scene) -> History {
        History { scenes: vec![scene], now: 0, last: Change::Other }
    }

    pub fn now(&self) -> &Scene {
        &self.scenes[self.now]
    }

    /// Goes on to a scene; what had been undone is forgotten.
    pub fn go_on(&mut self, scene: Scene, change: Change) {
        self.scenes.truncate(self.now + 1);
        if change != Change::Other && change == self.last {
            self.scenes[self.now] = scene;
            return;
        }
        self.last = change;
        self.scenes.push(scene);
        if self.scenes.len() > MOST {
            self.scenes.remove(0);
        }
        self.now = self.scenes.len() - 1;
    }

    pub fn can_undo(&self) -> bool {
        self.now > 0
    }

    pub fn can_redo(&self) -> bool {
        self.now + 1 < self.scenes.len()
    }

    /// The scene before, if any.
    pub fn undo(&mut self) -> Option<&Scene> {
        self.now = self.now.checked_sub(1)?;
        self.last = Change::Other;
        Some(self.now())
    }

    /// The scene that was undone last, if any.
    pub fn redo(&mut self) -> Option<&Scene> {
        if !self.can_redo() {
            return None;
        }
        self.now += 1;
        self.last = Change::Other;
        Some(self.now())
    }
}
