//! The page's brain: takes what visitor and worker do, keeps the scene and what is shown of it, and
//! says what is to be done. It knows no browser; whoever hosts it brings the screen into agreement
//! with `shown`, `camera` and the rest after each event.

mod cloning;
mod growing;
mod told;

use super::camera::{Camera, Orbit};
use super::hand::Hand;
use super::history::{Change, History};
use super::link::{self, DAY, INDIVIDUAL, individual};
use super::meshes::Meshes;
use super::narration::Moment;
use super::parameters::Parameter;
use super::playhead::Playhead;
use super::run::{End, Run};
use super::scene::Scene;
use super::series::asked_view;
use super::words;
use crate::plants::Plant;
use cloning::InHand;
use told::Moves;

pub use super::events::{Effect, Event, Refusal, Shown, ShownDay, State};

/// The page without its browser.
pub struct Page {
    plants: &'static [Plant],
    scene: Scene,
    history: History,
    run: Run,
    playhead: Playhead,
    camera: Camera,
    shown: Shown,
    drawn: Option<Shown>,
    /// Whether it was drawn with all pixels once.
    sharp: bool,
    /// The worker that grows the plant.
    hand: Hand,
    meshes: Meshes,
    /// The link of the scene that was ready last, if any: what to go back to when a worker is lost.
    worked: String,
    /// Whether the figures stand in the place of the plant: then nothing grows here.
    is_away: bool,
    refusal: Option<Refusal>,
    /// What the last change of a number has moved.
    moves: Option<Moves>,
    /// See `source()`.
    source: String,
    in_hand: Option<InHand>,
    less_motion: bool,
    written: String,
    /// What was told of last, and the words for all of it.
    heard: Option<Moment>,
    summary: String,
}

impl Page {
    /// Opens a link, or waits behind the figures if the fragment asks for those. The growth is asked
    /// for when the worker says hello.
    pub fn open(fragment: &str, plants: &'static [Plant]) -> (Page, Vec<Effect>) {
        let is_away = asked_view(fragment).is_some();
        let opened = link::read(if is_away { "" } else { fragment }, plants);
        let scene = opened.scene;
        let mut page = Page {
            plants,
            history: History::new(scene.clone()),
            run: Run::new(1, scene.clone()),
            playhead: Playhead::new(scene.day),
            camera: Camera::new(scene.orbit),
            shown: bare(&scene),
            drawn: None,
            sharp: false,
            hand: Hand::default(),
            meshes: Meshes::default(),
            worked: String::new(),
            is_away,
            refusal: None,
            moves: None,
            source: String::new(),
            in_hand: None,
            less_motion: false,
            written: String::new(),
            heard: None,
            summary: String::new(),
            scene,
        };
        let mut effects = vec![Effect::Tell(opened.left_out)];
        page.wish(&mut effects);
        page.settle(Change::Other, Effect::WriteLink, &mut effects);
        (page, effects)
    }

    /// Takes an event; the effects are to be done in their order.
    pub fn hear(&mut self, event: Event) -> Vec<Effect> {
        let mut effects = Vec::new();
        let change = match &event {
            Event::Change { key, .. } => Change::Parameter(key),
            Event::Turn { .. } | Event::Zoom { .. } | Event::Pan(_) | Event::Tick(_) => {
                Change::View
            }
            _ => Change::Other,
        };
        // The browser's own way back leads from plant to plant.
        let write = match &event {
            Event::ChoosePlant(_) => Effect::PushLink,
            _ => Effect::WriteLink,
        };
        self.take(event, &mut effects);
        self.know_clone(&mut effects);
        self.show();
        if self.is_settled() {
            self.scene.day = self.playhead.wished_day();
            self.scene.orbit = self.camera.wished();
            self.settle(change, write, &mut effects);
        }
        effects
    }

    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The growth whose days can be shown.
    pub fn run(&self) -> &Run {
        &self.run
    }

    pub fn shown(&self) -> &Shown {
        &self.shown
    }

    /// The text of the mesh file of the plant, once the worker has it.
    pub fn mesh(&self) -> Option<&str> {
        self.meshes.text(self.scene.plant.body.mesh.name)
    }

    /// What is on the screen now.
    pub fn drawn(&self) -> Option<&Shown> {
        self.drawn.as_ref()
    }

    pub fn camera(&self) -> &Camera {
        &self.camera
    }

    pub fn playhead(&self) -> &Playhead {
        &self.playhead
    }

    pub fn history(&self) -> &History {
        &self.history
    }

    /// Whether the next frame will differ from this one by itself.
    pub fn is_moving(&self) -> bool {
        !self.camera.at_rest() || self.playhead.is_moving(self.newest(), self.run.last_day())
    }

    /// Whether the visitor asked for less motion.
    pub fn less_motion(&self) -> bool {
        self.less_motion
    }

    pub fn state(&self) -> State {
        if self.run.end == Some(End::Failed) {
            return State::Error;
        }
        let Some(Shown { generation, day: Some(day), .. }) = &self.drawn else {
            return State::Loading;
        };
        let arrived = self.playhead.plays_on() || day.moment == 1.0 && self.sharp;
        let wished = day.day == self.playhead.wished_day() && *generation == self.run.generation;
        if wished && arrived { State::Ready } else { State::Growing }
    }

    /// The link of what is wished now, also while it plays.
    pub fn link(&self) -> String {
        link::write(&self.wished_scene())
    }

    fn take(&mut self, event: Event, effects: &mut Vec<Effect>) {
        let (newest, last_day) = (self.newest(), self.run.last_day());
        match event {
            Event::OpenLink(fragment) if asked_view(&fragment).is_some() => self.leave(effects),
            Event::OpenLink(fragment) => {
                let opened = link::read(&fragment, self.plants);
                // The address bar holds what was typed: it is to hold what was understood.
                self.written.clear();
                self.adopt(opened.scene, effects);
                effects.push(Effect::Tell(opened.left_out));
            }
            Event::ChoosePlant(key) => {
                if let Some(plant) = self.plants.iter().find(|p| p.key == key) {
                    self.adopt(Scene::preset(plant, self.scene.individual), effects);
                }
            }
            Event::Individual(number) => match individual(number) {
                Ok(individual) => {
                    let before = self.wished_scene();
                    // Numbers of cells mean others now.
                    self.adopt(Scene { individual, cell: None, ..before }, effects);
                }
                Err(why) => self.refuse(INDIVIDUAL, &why),
            },
            Event::Change { key, value } => {
                let Some(parameter) = Parameter::of_key(key) else { return };
                let before = self.wished_scene();
                let mut scene = before.clone();
                match parameter.set(&mut scene, value) {
                    Ok(()) => {
                        scene.cell = scene.cell.filter(|_| scene.grows_like(&before));
                        let moves = Moves::of(parameter, &before, &scene, self.moves.take());
                        self.adopt(scene, effects);
                        self.moves = Some(moves);
                    }
                    Err(why) => self.refuse(key, &why),
                }
            }
            Event::ResetParameters => {
                let Scene { plant, individual, day, orbit, show, .. } = self.wished_scene();
                let preset = Scene { orbit, show, ..Scene::preset(plant, individual) };
                self.adopt(Scene { day: day.min(preset.recipe.days), ..preset }, effects);
            }
            Event::Noise(noise) => {
                self.adopt(Scene { noise, cell: None, ..self.wished_scene() }, effects);
            }
            Event::Show(show) => self.adopt(Scene { show, ..self.wished_scene() }, effects),
            Event::Take { cell, clan } => self.take_clone(cell, clan, effects),
            Event::TakeMother => self.take_mother(effects),
            Event::TakeClan => self.step_clans(0, effects),
            Event::StepClans(by) => self.step_clans(by, effects),
            Event::PutDown => self.hold(None, effects),
            Event::Seek(day) => self.seek(day, effects),
            Event::Day(day) => {
                let last_day = f64::from(last_day);
                match day.fract() == 0.0 && (0.0..=last_day).contains(&day) {
                    true => self.seek(day as u32, effects),
                    false => self.refuse(DAY, &link::not_whole(last_day)),
                }
            }
            Event::StepDays(by) => {
                self.seek(self.playhead.wished_day().saturating_add_signed(by), effects);
            }
            Event::Scrub(time) => {
                self.forgive_day();
                self.playhead.scrub(time, self.run.newest_from(time as u32), last_day);
            }
            Event::LetGo => {
                self.playhead.let_go();
                self.ask(effects);
            }
            Event::PlayOrPause if self.playhead.is_playing() => self.playhead.pause(),
            Event::PlayOrPause => self.playhead.play(last_day),
            Event::Premiere if self.less_motion => {}
            Event::Premiere => self.playhead.premiere(),
            Event::EndPremiere => self.playhead.end_premiere(),
            Event::Speed(speed) => self.playhead.speed = speed,
            Event::Loop(looping) => self.playhead.looping = looping,
            Event::Turn { right_deg, up_deg } => {
                let turned = self.camera.wished().turned(right_deg, up_deg);
                self.camera.wish(turned.above(Orbit::lowest_deg(self.scene.plant)));
            }
            Event::Zoom { factor, at } => self.camera.wish(self.camera.wished().zoomed(factor, at)),
            Event::Pan(by) => self.camera.wish(self.camera.wished().panned(by)),
            Event::ResetView => {
                self.camera.wish(Scene::preset(self.scene.plant, 0).orbit);
            }
            // Where a step comes to rest on the very scene that it left, the address is the same.
            Event::Undo => {
                self.written.clear();
                if let Some(scene) = self.history.undo().cloned() {
                    self.adopt(scene, effects);
                }
            }
            Event::Redo => {
                self.written.clear();
                if let Some(scene) = self.history.redo().cloned() {
                    self.adopt(scene, effects);
                }
            }
            Event::LessMotion(less) => {
                self.less_motion = less;
                self.playhead.whole_days = less;
            }
            Event::Tick(seconds) => {
                self.playhead.advance(seconds, newest, last_day);
                self.camera.advance(seconds as f32);
            }
            Event::FromWorker(answer) => self.listen(answer, effects),
            Event::Mesh { name, text } => self.take_mesh(name, text, effects),
            Event::WorkerLost(why) => self.lose(why, effects),
            Event::Drawn { sharp } => {
                self.sharp = sharp || self.sharp && self.drawn.as_ref() == Some(&self.shown);
                self.drawn = Some(self.shown.clone());
            }
            Event::PictureLost => self.drawn = None,
        }
        if self.less_motion {
            self.camera.jump();
        }
    }

    /// The scene with the day and the view that are wished now.
    fn wished_scene(&self) -> Scene {
        let day = self.playhead.wished_day();
        Scene { day, orbit: self.camera.wished(), ..self.scene.clone() }
    }

    fn refuse(&mut self, field: &'static str, why: &str) {
        self.refusal = Some(Refusal { field, why: format!("Not taken: {why}.") });
    }

    /// Another day is wished than the one that was refused.
    fn forgive_day(&mut self) {
        self.refusal.take_if(|refusal| refusal.field == DAY);
    }

    /// Makes a scene the wished one: grows again only if it must.
    fn adopt(&mut self, scene: Scene, effects: &mut Vec<Effect>) {
        self.refusal = None;
        self.moves = None;
        // What was told of the last scene is over.
        effects.push(Effect::Tell(Vec::new()));
        let seen = |scene: &Scene| (scene.show, scene.cell);
        self.sharp &= seen(&scene) == seen(&self.scene) && scene.look == self.scene.look;
        self.camera.wish(scene.orbit);
        if scene.plant.key != self.scene.plant.key {
            self.camera.jump();
        }
        let comes_back = std::mem::take(&mut self.is_away);
        let failed = self.run.end == Some(End::Failed);
        if scene.grows_like(&self.run.scene) && !comes_back && !failed {
            self.go(scene.day, effects);
        } else {
            self.grow(scene.clone(), effects);
        }
        self.scene = scene;
    }

    fn seek(&mut self, day: u32, effects: &mut Vec<Effect>) {
        self.forgive_day();
        self.go(day.min(self.run.last_day()), effects);
    }

    /// Decides what is to be on the screen. While nothing of a new growth has come, the picture
    /// before stays, unless it is of another plant.
    fn show(&mut self) {
        let (day, moment) = self.playhead.day_and_moment();
        if let Some(facts) = self.run.facts(day) {
            self.shown = Shown {
                generation: self.run.generation,
                day: Some(ShownDay { day, moment, facts: facts.clone() }),
                ..bare(&self.run.scene)
            };
        } else if self.shown.plant != self.scene.plant.key {
            self.shown = bare(&self.scene);
        }
    }

    /// Neither time nor camera is under way, except to days that are yet to grow.
    fn is_settled(&self) -> bool {
        self.camera.at_rest() && self.playhead.is_settled()
    }

    /// Writes the link and says what is shown, if they changed.
    fn settle(&mut self, change: Change, write: fn(String) -> Effect, effects: &mut Vec<Effect>) {
        // The address is that of the figures.
        if self.is_away {
            return;
        }
        let link = link::write(&self.scene);
        if link != self.written {
            if link != link::write(self.history.now()) {
                self.history.go_on(self.scene.clone(), change);
            }
            self.written.clone_from(&link);
            self.source = words::source(&self.scene);
            effects.push(write(link));
        }
        if self.state() == State::Ready {
            self.worked.clone_from(&self.written);
            self.narrate(effects);
        }
    }
}

fn bare(scene: &Scene) -> Shown {
    Shown { plant: scene.plant.key, individual: scene.individual, generation: 0, day: None }
}
