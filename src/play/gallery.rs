//! The brain of the figures: grows one figure's row of pictures at a time, each growth on a worker of
//! its own, has the files of plants fetched that only a figure shows, and says which day of which growth every picture shows. Like the page's brain it knows no
//! browser.

use super::camera::Orbit;
use super::figures::{Figure, Picture};
use super::hand::Hand;
use super::meshes::Meshes;
use super::page::{Effect, State};
use super::protocol::{BUILD, ToPage, ToWorker};
use super::run::DayFacts;
use super::{End, Run, Scene, link, words};
use crate::mosaic::SiteLists;
use crate::plants::{Plant, bring};
use glam::Vec2;

/// Of so many pictures all days are held.
const ALL_DAYS_OF: usize = 12;
/// A growth that was lost with so many workers is not begun again.
const MOST_LOSSES: usize = 2;

/// What can happen to the figures.
#[derive(Clone, Debug)]
pub enum Event {
    /// A row comes into sight: the one that grew before is forgotten.
    Open(&'static Figure),
    /// A day is wished for all pictures of the row.
    Day(u32),
    /// All pictures of the row are turned, in degrees, and zoomed by a factor: they have one camera.
    Look { right_deg: f32, up_deg: f32, zoom: f32 },
    /// A worker, by its number, says something.
    FromWorker(usize, ToPage),
    /// The worker of a number is gone or cannot be had, and why.
    WorkerLost(usize, String),
    /// A mesh file came, or why it cannot.
    Mesh { name: &'static str, text: Result<String, String> },
}

/// The figures without their browser.
pub struct Gallery {
    plants: &'static [Plant],
    hands: Vec<Hand>,
    meshes: Meshes,
    row: Option<Row>,
    days: Days,
    /// Counts the growths of all rows.
    generation: u32,
}

/// The days to which readers have pulled figures, by their numbers.
pub type Days = Vec<(&'static str, u32)>;

/// The row that grows.
pub struct Row {
    pub figure: &'static Figure,
    /// None while the files of plants of their own are awaited.
    pub pictures: Vec<Scene>,
    /// The wished day: a picture whose own day is earlier stays on that one.
    pub day: u32,
    /// Pictures of one growth on different days share it.
    runs: Vec<Run>,
    /// The generations of what workers grew when they were lost.
    lost: Vec<u32>,
    /// Why something cannot be shown.
    pub trouble: Option<String>,
}

/// A day of a picture that can be drawn.
#[derive(Clone, Copy)]
pub struct ShownPicture<'a> {
    pub scene: &'a Scene,
    pub generation: u32,
    pub day: u32,
    pub facts: &'a DayFacts,
    pub lists: &'a SiteLists,
}

impl Gallery {
    /// `workers`: how many there will be at most. They are started as rows need them and asked for
    /// nothing before they said hello. `days` are those of figures that were open before.
    pub fn new(plants: &'static [Plant], workers: usize, days: Days) -> Gallery {
        let hands = (0..workers).map(|_| Hand::default()).collect();
        Gallery { plants, hands, meshes: Meshes::default(), row: None, days, generation: 0 }
    }

    /// The days to which rows were pulled.
    pub fn days(&self) -> &Days {
        &self.days
    }

    /// The day to which a figure was pulled, if it was.
    pub fn day_of(&self, figure: &Figure) -> Option<u32> {
        self.days.iter().find(|(number, _)| *number == figure.number).map(|(_, day)| *day)
    }

    /// The row that grows.
    pub fn row(&self) -> Option<&Row> {
        self.row.as_ref()
    }

    /// The text of a mesh file, once some worker has it.
    pub fn mesh(&self, name: &str) -> Option<&str> {
        self.meshes.text(name)
    }

    /// Takes an event; each effect is to be done with the worker of its number.
    pub fn hear(&mut self, event: Event) -> Vec<(usize, Effect)> {
        let mut effects = Vec::new();
        match event {
            Event::Open(figure) => self.open(figure, &mut effects),
            Event::Day(day) => self.wish_day(day, &mut effects),
            Event::Look { right_deg, up_deg, zoom } => {
                for scene in self.row.iter_mut().flat_map(|row| &mut row.pictures) {
                    let orbit = scene.orbit.turned(right_deg, up_deg).zoomed(zoom, Vec2::ZERO);
                    scene.orbit = orbit.above(Orbit::lowest_deg(scene.plant));
                }
            }
            Event::FromWorker(number, answer) => self.listen(number, answer, &mut effects),
            Event::WorkerLost(number, why) => self.lose(number, why, &mut effects),
            Event::Mesh { name, text } => {
                // That of a plant of its own says it.
                let is_plant = text.as_ref().is_ok_and(|text| bring(text).is_some());
                let news = self.meshes.take(name, text);
                if is_plant {
                    self.open_anew(&mut effects);
                }
                let is_wanted = |run: &&mut Run| run.scene.plant.body.mesh.name == name;
                if let (Some(Err(why)), Some(row)) = (news, &mut self.row) {
                    for run in row.runs.iter_mut().filter(is_wanted) {
                        run.end = Some(End::Failed);
                        row.trouble = Some(words::no_mesh(run.scene.plant, &why));
                    }
                    if row.figure.pictures.iter().any(|p| p.unknown() == Some(name)) {
                        row.trouble = Some(words::no_plants(&why));
                    }
                }
            }
        }
        self.assign(&mut effects);
        effects
    }

    fn open(&mut self, figure: &'static Figure, effects: &mut Vec<(usize, Effect)>) {
        let read = |link| link::read(link, self.plants).scene;
        let mut pictures: Vec<Scene> = figure.pictures.iter().map(|p| read(p.link)).collect();
        let mut files = Vec::new();
        for key in figure.pictures.iter().filter_map(Picture::unknown) {
            pictures.clear();
            self.meshes.provide(key, None, &mut files);
        }
        effects.extend(files.into_iter().map(|file| (0, file)));
        let mut runs: Vec<Run> = Vec::new();
        for picture in &pictures {
            // Days after the last one that is looked at need not grow.
            let alike = |run: &&mut Run| run.scene.grows_like(picture);
            match runs.iter_mut().find(alike) {
                Some(run) => run.scene.day = run.scene.day.max(picture.day),
                None => {
                    self.generation += 1;
                    runs.push(Run::without_clones(self.generation, picture.clone()));
                }
            }
        }
        for (number, hand) in self.hands.iter_mut().enumerate() {
            hand.forgive();
            if hand.grows.take().is_some() {
                effects.push((number, Effect::Post(ToWorker::Stop)));
            }
            if number < runs.len() {
                effects.extend(hand.start().map(|start| (number, start)));
            }
        }
        let mut row = Row { figure, pictures, day: 0, runs, lost: Vec::new(), trouble: None };
        row.day = self.day_of(figure).unwrap_or(row.last_day());
        self.row = Some(row);
    }

    /// Opens the row that waits for its plants once more: each file is asked for that is not on its way.
    fn open_anew(&mut self, effects: &mut Vec<(usize, Effect)>) {
        if let Some(row) = self.row.take_if(|row| row.pictures.is_empty()) {
            self.open(row.figure, effects);
        }
    }

    /// A row whose mesh could not be had is tried again.
    fn wish_day(&mut self, day: u32, effects: &mut Vec<(usize, Effect)>) {
        let Some(row) = &mut self.row else { return };
        row.day = if row.pictures.is_empty() { day } else { day.min(row.last_day()) };
        self.days.retain(|(number, _)| *number != row.figure.number);
        self.days.push((row.figure.number, row.day));
        let has_failed = |run: &&mut Run| self.meshes.has_failed(run.scene.plant.body.mesh.name);
        for run in row.runs.iter_mut().filter(has_failed) {
            row.trouble = None;
            run.end = None;
        }
        self.open_anew(effects);
    }

    fn listen(&mut self, number: usize, answer: ToPage, effects: &mut Vec<(usize, Effect)>) {
        let Some(hand) = self.hands.get_mut(number) else { return };
        let apart = self.row.as_ref().map_or(1, Row::days_apart);
        let runs = self.row.as_mut().map(|row| &mut row.runs[..]).unwrap_or_default();
        match answer {
            ToPage::Hello { build } if build != BUILD => effects.push((number, Effect::Reload)),
            ToPage::Hello { .. } => hand.greet(),
            // No clones are asked for here.
            ToPage::Born { .. } => {}
            ToPage::Day(news) => {
                hand.forgive();
                let run = runs.iter_mut().find(|run| run.generation == news.generation);
                let Some(run) = run else { return };
                let is_last = news.day >= run.scene.day;
                let before = news.day.checked_sub(1).filter(|day| day % apart != 0);
                run.add(news);
                if let Some(before) = before {
                    run.forget_lists(before);
                }
                if is_last {
                    hand.grows = None;
                    effects.push((number, Effect::Post(ToWorker::Stop)));
                }
            }
            ToPage::Full { generation } | ToPage::Done { generation } => {
                hand.finish(generation);
                if let Some(run) = runs.iter_mut().find(|run| run.generation == generation) {
                    run.end = Some(End::Done);
                }
            }
            ToPage::Failed { generation, text } => {
                hand.finish(generation);
                if let Some(row) = &mut self.row {
                    row.fail(generation, format!("This cannot be grown: {text}."));
                }
            }
        }
    }

    /// Another worker begins what the lost one grew, unless that was lost before; days that have come
    /// stay.
    fn lose(&mut self, number: usize, why: String, effects: &mut Vec<(usize, Effect)>) {
        let Some(hand) = self.hands.get_mut(number) else { return };
        let (may_start, grew) = hand.lose();
        self.meshes.forget(number);
        effects.push((number, Effect::EndWorker));
        if may_start {
            effects.extend(hand.start().map(|start| (number, start)));
        }
        let nobody_is_left = self.hands.iter().all(Hand::is_missing);
        let Some(row) = &mut self.row else { return };
        if let Some(generation) = grew {
            row.lost.push(generation);
            if row.lost.iter().filter(|lost| **lost == generation).count() == MOST_LOSSES {
                row.fail(generation, words::TOO_LARGE.to_string());
            }
        }
        if nobody_is_left {
            row.give_up(why);
        }
    }

    /// Gives what waits to workers that rest.
    fn assign(&mut self, effects: &mut Vec<(usize, Effect)>) {
        let Some(row) = &mut self.row else { return };
        for run in &row.runs {
            let generation = run.generation;
            let is_over = run.end.is_some() || run.newest() >= Some(run.scene.day);
            if is_over || self.hands.iter().any(|h| h.grows == Some(generation)) {
                continue;
            }
            let resting = |hand: &Hand| hand.listens() && hand.grows.is_none();
            let Some(number) = self.hands.iter().position(resting) else { return };
            let mut wishes = Vec::new();
            if self.meshes.provide(run.scene.plant.body.mesh.name, Some(number), &mut wishes) {
                self.hands[number].grows = Some(generation);
                let link = link::write(&run.scene);
                wishes.push(Effect::Post(ToWorker::Grow { generation, first: 0, link }));
            }
            effects.extend(wishes.into_iter().map(|wish| (number, wish)));
        }
    }
}

impl Row {
    /// The last day of any picture.
    pub fn last_day(&self) -> u32 {
        self.pictures.iter().map(|picture| picture.day).max().unwrap_or(0)
    }

    /// Of more pictures than a dozen only every second, third day and so on is held, and the newest: sixty
    /// take no more room than twelve.
    fn days_apart(&self) -> u32 {
        self.pictures.len().div_ceil(ALL_DAYS_OF) as u32
    }

    /// What a picture shows now: the wished day, or the nearest one before it that has grown.
    pub fn shown(&self, picture: usize) -> Option<ShownPicture<'_>> {
        let scene = &self.pictures[picture];
        let run = self.run(picture)?;
        let day = self.day.min(scene.day).min(run.newest()?);
        let (day, lists) = (0..=day).rev().find_map(|day| Some((day, run.lists(day)?)))?;
        let facts = run.facts(day)?;
        Some(ShownPicture { scene, generation: run.generation, day, facts, lists })
    }

    /// What a picture is called: where its own day tells it from its neighbours, by the day that it shows.
    pub fn label(&self, picture: usize) -> String {
        let (label, own) = (self.figure.pictures[picture].label, self.pictures[picture].day);
        match self.shown(picture) {
            Some(shown) if shown.day < own && names_day(label, own) => {
                format!("day {} of {own}", shown.day)
            }
            _ => label.to_string(),
        }
    }

    /// What is told below a picture: its cells, and of which day they are where nothing else says so.
    pub fn told(&self, picture: usize) -> Option<String> {
        let shown = self.shown(picture)?;
        let (count, own) = (shown.facts.count, shown.scene.day);
        let shares = words::shares(shown.scene.plant, count);
        let cells = format!("{} cells, {shares}", words::grouped(count.cells));
        let says_day = names_day(self.figure.pictures[picture].label, own);
        // What stands above it is true of the picture's own day.
        let is_clear = says_day || shown.day == own;
        Some(if is_clear { cells } else { format!("Day {}: {cells}", shown.day) })
    }

    /// The link of what a picture is to show, and what is beside it.
    pub fn link(&self, picture: usize) -> String {
        let scene = &self.pictures[picture];
        let link = link::write(&Scene { day: self.day.min(scene.day), ..scene.clone() });
        link + self.figure.pictures[picture].beside()
    }

    /// The growth that a picture shows a day of.
    fn run(&self, picture: usize) -> Option<&Run> {
        self.runs.iter().find(|run| run.scene.grows_like(&self.pictures[picture]))
    }

    /// How far the row has come, given the pictures that are on the screen.
    pub fn state(&self, is_drawn: impl Fn(&ShownPicture, usize) -> bool) -> State {
        if self.trouble.is_some() {
            return State::Error;
        }
        let mut all = if self.pictures.is_empty() { State::Loading } else { State::Ready };
        for (k, scene) in self.pictures.iter().enumerate() {
            let Some(shown) = self.shown(k) else { return State::Loading };
            let has_ended = self.run(k).is_some_and(|run| run.end.is_some());
            if !(is_drawn(&shown, k) && (has_ended || shown.day == self.day.min(scene.day))) {
                all = State::Growing;
            }
        }
        all
    }

    /// A growth of this row cannot go on, if it is one of this row.
    fn fail(&mut self, generation: u32, why: String) {
        if let Some(run) = self.runs.iter_mut().find(|run| run.generation == generation) {
            run.end = Some(End::Failed);
            self.trouble = Some(why);
        }
    }

    /// Nothing that is yet to grow will.
    fn give_up(&mut self, why: String) {
        self.runs.iter_mut().for_each(|run| run.end = Some(End::Failed));
        self.trouble = Some(why);
    }
}

/// Whether a label is the name of a day.
fn names_day(label: &str, day: u32) -> bool {
    label == format!("day {day}")
}

#[cfg(test)]
mod tests;
