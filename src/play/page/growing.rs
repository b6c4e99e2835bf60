//! What the page has grown, and by whom: its worker and the mesh files, and what becomes of the
//! picture when one of them is lost.

use super::super::protocol::{BUILD, ToPage, ToWorker};
use super::super::{End, Run, Scene, link, words};
use super::{Effect, Page, bare};

/// The page has one worker; this is its number for `Meshes`.
const WORKER: usize = 0;

impl Page {
    /// Begins a growth.
    pub(super) fn grow(&mut self, scene: Scene, effects: &mut Vec<Effect>) {
        self.playhead.restart(scene.day);
        self.run = Run::new(self.run.generation + 1, scene);
        self.hand.forgive();
        self.wish(effects);
    }

    /// Asks for what grows, as soon as there are a mesh and a worker for it.
    pub(super) fn wish(&mut self, effects: &mut Vec<Effect>) {
        if self.is_away {
            return;
        }
        effects.extend(self.hand.start());
        let Run { generation, scene, .. } = &self.run;
        let worker = self.hand.listens().then_some(WORKER);
        let has_mesh = self.meshes.provide(scene.plant.body.mesh.name, worker, effects);
        if has_mesh && self.hand.listens() {
            let (generation, link) = (*generation, link::write(scene));
            // Who sees it for the first time sees it grow.
            let first = if self.playhead.is_playing() { 0 } else { self.playhead.wished_day() };
            self.run.end = None;
            self.hand.grows = Some(generation);
            effects.push(Effect::Post(ToWorker::Grow { generation, first, link }));
        }
    }

    /// Wishes once more what could not be.
    pub(super) fn try_again(&mut self, effects: &mut Vec<Effect>) {
        if self.run.end == Some(End::Failed) {
            self.adopt(self.wished_scene(), effects);
        }
    }

    /// Wishes a day of what grows.
    pub(super) fn go(&mut self, day: u32, effects: &mut Vec<Effect>) {
        self.playhead.seek(day, self.run.newest_from(day));
        self.ask(effects);
    }

    /// The newest day as far as what is shown can go.
    pub(super) fn newest(&self) -> Option<u32> {
        self.run.newest_from(self.playhead.needs())
    }

    /// Asks for the wished day, if it has not come: what could not be is tried again.
    pub(super) fn ask(&mut self, effects: &mut Vec<Effect>) {
        self.try_again(effects);
        let day = self.playhead.wished_day();
        if self.run.facts(day).is_some() {
            return;
        }
        if self.run.end.is_some() {
            // Its worker was lost after the day that was wished then.
            self.grow(self.wished_scene(), effects);
        } else if self.hand.grows == Some(self.run.generation) {
            effects.push(Effect::Post(ToWorker::First { day }));
        }
    }

    /// Makes room for the figures: days and worker are given up until the plant is opened again.
    pub(super) fn leave(&mut self, effects: &mut Vec<Effect>) {
        self.is_away = true;
        self.run = Run::new(self.run.generation + 1, self.wished_scene());
        self.shown = bare(&self.scene);
        self.drawn = None;
        // The title is that of the figures meanwhile.
        self.heard = None;
        self.end_worker(effects);
    }

    pub(super) fn listen(&mut self, answer: ToPage, effects: &mut Vec<Effect>) {
        let current = self.run.generation;
        match answer {
            ToPage::Hello { build } if build != BUILD => effects.push(Effect::Reload),
            ToPage::Hello { .. } => {
                self.hand.greet();
                self.wish(effects);
            }
            ToPage::Born { generation, born } => self.run.bear(generation, &born),
            ToPage::Day(news) => {
                let (day, wished) = (news.day, self.playhead.wished_day());
                self.run.add(news);
                let newest = self.newest();
                if day == wished && self.playhead.is_settled() {
                    // What is wished comes at once, whatever has come of the days before.
                    self.playhead.seek(day, newest);
                } else if self.less_motion {
                    // With less motion each day is seen at once.
                    self.playhead.advance(0.0, newest, self.run.last_day());
                }
                self.sum_up_again(day);
            }
            ToPage::Full { generation } if generation == current => {
                self.end(End::Full);
                effects.push(Effect::Tell(vec![words::full(&self.run)]));
            }
            ToPage::Done { generation } if generation == current => self.end(End::Done),
            ToPage::Failed { generation, text } if generation == current => {
                self.fail(format!("This cannot be grown: {text}."), effects);
            }
            // Of a growth that is wished no more.
            ToPage::Full { .. } | ToPage::Done { .. } | ToPage::Failed { .. } => {}
        }
    }

    pub(super) fn take_mesh(
        &mut self,
        name: &str,
        text: Result<String, String>,
        effects: &mut Vec<Effect>,
    ) {
        let news = self.meshes.take(name, text);
        let plant = self.run.scene.plant;
        if plant.body.mesh.name != name || self.is_away {
            return;
        }
        match news {
            Some(Ok(())) => self.wish(effects),
            Some(Err(why)) => self.fail(words::no_mesh(plant, &why), effects),
            None => {}
        }
    }

    /// The worker is gone. If it was growing what is wished, that is taken to have been too much for it: days
    /// that have come are kept where they are what was wished, else the scene that worked last comes
    /// back, or the preset of the plant. So the same link does not kill the next worker, too.
    pub(super) fn lose(&mut self, why: String, effects: &mut Vec<Effect>) {
        let (may_start, grew) = self.hand.lose();
        self.end_worker(effects);
        if self.run.end.is_some() {
            // The next wish starts another one.
            return;
        }
        if grew != Some(self.run.generation) {
            return if may_start { self.wish(effects) } else { self.fail(why, effects) };
        }
        let before = match std::mem::take(&mut self.worked).as_str() {
            "" => Scene::preset(self.scene.plant, self.scene.individual),
            worked => link::read(worked, self.plants).scene,
        };
        let newest = self.run.last_held();
        let is_held = self.run.facts(self.playhead.wished_day()).is_some();
        if !is_held && !before.grows_like(&self.run.scene) {
            self.adopt(before, effects);
        } else if let Some(newest) = newest {
            self.end_after(newest);
        } else {
            return self.fail(words::TOO_LARGE.to_string(), effects);
        }
        effects.push(Effect::Tell(vec![words::TOO_LARGE_SO_BACK.to_string()]));
    }

    fn end_worker(&mut self, effects: &mut Vec<Effect>) {
        self.hand.end();
        self.meshes.forget(WORKER);
        effects.push(Effect::EndWorker);
    }

    /// No day after this one is wished any more, neither now nor when the link is opened again.
    fn end_after(&mut self, newest: u32) {
        for scene in [&mut self.scene, &mut self.run.scene] {
            // A recipe has a day at least.
            scene.recipe.days = newest.max(1);
        }
        self.end(End::Done);
    }

    /// The growth is over. If that was early, no later day may be waited for.
    fn end(&mut self, end: End) {
        self.run.end = Some(end);
        if self.playhead.wished_day() > self.run.last_day() {
            let last_day = self.run.last_day();
            self.playhead.seek(last_day, self.run.newest_from(last_day));
        }
    }

    /// What is wished cannot be: the text says why.
    fn fail(&mut self, text: String, effects: &mut Vec<Effect>) {
        effects.push(Effect::Tell(vec![text]));
        self.run.end = Some(End::Failed);
    }
}
