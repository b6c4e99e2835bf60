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

    /// What was there before the last change of more than day, view or what is seen; None if there was none.
    pub fn before_last_change(&self) -> Option<&Scene> {
        let now = self.now();
        let before = self.scenes[..self.now].iter().rev();
        before.into_iter().find(|scene| !scene.grows_like(now) || scene.look != now.look)
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

#[cfg(test)]
mod tests {
    use super::super::testing::PLANTS;
    use super::*;

    fn individual(number: u32) -> Scene {
        Scene::preset(&PLANTS[0], number)
    }

    #[test]
    fn a_new_scene_forgets_what_was_undone() {
        let mut history = History::new(individual(0));
        (1..=3).for_each(|number| history.go_on(individual(number), Change::Other));
        assert!(history.redo().is_none() && !history.can_redo());
        history.undo();
        assert_eq!(history.undo().unwrap().individual, 1);
        assert_eq!(history.redo().unwrap().individual, 2);
        history.go_on(individual(9), Change::Other);
        assert!(!history.can_redo());
        assert_eq!(history.undo().unwrap().individual, 2);
    }

    #[test]
    fn runs_of_one_change_are_a_step_but_not_across_steps_back() {
        let mut history = History::new(individual(0));
        let change = Change::Parameter("df");
        (1..=3).for_each(|number| history.go_on(individual(number), change));
        assert_eq!(history.undo().unwrap().individual, 0);
        assert_eq!(history.redo().unwrap().individual, 3);
        history.go_on(individual(4), change);
        assert_eq!(history.undo().unwrap().individual, 3, "a step of its own");
        history.go_on(individual(5), change);
        assert_eq!(history.undo().unwrap().individual, 3);
    }

    #[test]
    fn what_was_before_the_last_change_differs_in_more_than_day_and_view() {
        let mut history = History::new(individual(1));
        assert!(history.before_last_change().is_none());
        history.go_on(individual(2), Change::Other);
        history.go_on(Scene { day: 1, ..individual(2) }, Change::Other);
        let turned = individual(2).orbit.turned(30.0, 0.0);
        history.go_on(Scene { orbit: turned, ..individual(2) }, Change::View);
        assert_eq!(history.before_last_change().unwrap().individual, 1);
        let mut darker = individual(2);
        darker.look.border = 0.9;
        history.go_on(darker, Change::Parameter("bo"));
        assert!(history.before_last_change().unwrap().orbit == turned);
    }

    #[test]
    fn it_has_an_end() {
        let mut history = History::new(individual(0));
        (1..=500).for_each(|number| history.go_on(individual(number), Change::Other));
        let mut steps = 0;
        while history.undo().is_some() {
            steps += 1;
        }
        assert_eq!((steps, history.now().individual), (MOST - 1, 500 + 1 - MOST as u32));
    }
}
