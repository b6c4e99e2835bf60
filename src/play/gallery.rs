//! The brain of the figures: grows one figure's row of pictures at a time, each growth on a worker of
//! its own, and says which day of which growth every picture shows. Like the page's brain it knows no
//! browser.

use super::figures::Figure;
use super::meshes::Meshes;
use super::page::{Effect, State};
use super::protocol::{BUILD, ToPage, ToWorker};
use super::run::DayFacts;
use super::{End, Run, Scene, link};
use crate::mosaic::SiteLists;
use crate::plants::Plant;

/// What can happen to the figures.
#[derive(Clone, Debug)]
pub enum Event {
    /// A row comes into sight: the one that grew before is forgotten.
    Open(&'static Figure),
    /// A day is wished for all pictures of the row.
    Day(u32),
    /// A worker, by its number, says something.
    FromWorker(usize, ToPage),
    /// A mesh file came, or why it cannot.
    Mesh { name: &'static str, text: Result<String, String> },
}

/// The figures without their browser.
pub struct Gallery {
    plants: &'static [Plant],
    hands: Vec<Hand>,
    meshes: Meshes,
    row: Option<Row>,
    /// Counts the growths of all rows.
    generation: u32,
}

/// One worker as we know it.
#[derive(Default)]
struct Hand {
    listens: bool,
    /// The generation of what it grows.
    grows: Option<u32>,
}

/// The row that grows.
pub struct Row {
    pub figure: &'static Figure,
    pub pictures: Vec<Scene>,
    /// The wished day: a picture whose own day is earlier stays on that one.
    pub day: u32,
    /// Pictures of one growth on different days share it.
    runs: Vec<Run>,
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
    /// `workers`: how many there will be; they are asked for nothing before they said hello.
    pub fn new(plants: &'static [Plant], workers: usize) -> Gallery {
        let hands = (0..workers).map(|_| Hand::default()).collect();
        Gallery { plants, hands, meshes: Meshes::default(), row: None, generation: 0 }
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
            Event::Day(day) => {
                if let Some(row) = &mut self.row {
                    row.day = day.min(row.last_day());
                }
            }
            Event::FromWorker(number, answer) => self.listen(number, answer, &mut effects),
            Event::Mesh { name, text } => {
                let why = self.meshes.take(name, text);
                if let (Some(why), Some(row)) = (why, &mut self.row) {
                    row.trouble = Some(super::words::no_mesh(row.plant(), &why));
                    row.runs.iter_mut().for_each(|run| run.end = Some(End::Failed));
                }
            }
        }
        self.assign(&mut effects);
        effects
    }

    fn open(&mut self, figure: &'static Figure, effects: &mut Vec<(usize, Effect)>) {
        let read = |link| link::read(link, self.plants).scene;
        let pictures: Vec<Scene> = figure.pictures.iter().map(|p| read(p.link)).collect();
        let mut runs: Vec<Run> = Vec::new();
        for picture in &pictures {
            // Days after the last one that is looked at need not grow.
            let alike = |run: &&mut Run| run.scene.grows_like(picture);
            match runs.iter_mut().find(alike) {
                Some(run) => run.scene.day = run.scene.day.max(picture.day),
                None => {
                    self.generation += 1;
                    runs.push(Run::new(self.generation, picture.clone()));
                }
            }
        }
        for (number, hand) in self.hands.iter_mut().enumerate() {
            if hand.grows.take().is_some() {
                effects.push((number, Effect::Post(ToWorker::Stop)));
            }
        }
        let day = pictures.iter().map(|picture| picture.day).max().unwrap_or(0);
        self.row = Some(Row { figure, pictures, day, runs, trouble: None });
    }

    fn listen(&mut self, number: usize, answer: ToPage, effects: &mut Vec<(usize, Effect)>) {
        let Some(hand) = self.hands.get_mut(number) else { return };
        let runs = self.row.as_mut().map(|row| &mut row.runs[..]).unwrap_or_default();
        match answer {
            ToPage::Hello { build } if build != BUILD => effects.push((number, Effect::Reload)),
            ToPage::Hello { .. } => hand.listens = true,
            ToPage::Day(news) => {
                let run = runs.iter_mut().find(|run| run.generation == news.generation);
                let Some(run) = run else { return };
                let is_last = news.day >= run.scene.day;
                run.add(news);
                if is_last && hand.grows == Some(run.generation) {
                    hand.grows = None;
                    effects.push((number, Effect::Post(ToWorker::Stop)));
                }
            }
            ToPage::Full { generation } => {
                hand.finish(generation);
                if let Some(run) = runs.iter_mut().find(|run| run.generation == generation) {
                    run.end = Some(End::Full);
                }
            }
            ToPage::Done { generation } => hand.finish(generation),
            ToPage::Failed { generation, text } => {
                hand.finish(generation);
                if let Some(run) = runs.iter_mut().find(|run| run.generation == generation) {
                    run.end = Some(End::Failed);
                    self.tell(text);
                }
            }
        }
    }

    fn tell(&mut self, why: String) {
        if let Some(row) = &mut self.row {
            row.trouble = Some(format!("This cannot be grown: {why}."));
        }
    }

    /// Gives what waits to workers that rest.
    fn assign(&mut self, effects: &mut Vec<(usize, Effect)>) {
        let Some(row) = &mut self.row else { return };
        for run in &row.runs {
            let generation = run.generation;
            let has_begun = run.newest().is_some() || run.end.is_some();
            if has_begun || self.hands.iter().any(|h| h.grows == Some(generation)) {
                continue;
            }
            let resting = |hand: &Hand| hand.listens && hand.grows.is_none();
            let Some(number) = self.hands.iter().position(resting) else { return };
            let mut wishes = Vec::new();
            if self.meshes.provide(run.scene.plant.mesh.name, Some(number), &mut wishes) {
                self.hands[number].grows = Some(generation);
                let link = link::write(&run.scene);
                wishes.push(Effect::Post(ToWorker::Grow { generation, link }));
            }
            effects.extend(wishes.into_iter().map(|wish| (number, wish)));
        }
    }
}

impl Hand {
    fn finish(&mut self, generation: u32) {
        if self.grows == Some(generation) {
            self.grows = None;
        }
    }
}

impl Row {
    /// The last day of any picture.
    pub fn last_day(&self) -> u32 {
        self.pictures.iter().map(|picture| picture.day).max().unwrap_or(0)
    }

    /// What a picture shows now: the wished day, or the nearest one before it that has grown.
    pub fn shown(&self, picture: usize) -> Option<ShownPicture<'_>> {
        let scene = &self.pictures[picture];
        let run = self.run(picture)?;
        let day = self.day.min(scene.day).min(run.newest()?);
        let (facts, lists) = (run.facts(day)?, run.lists(day)?);
        Some(ShownPicture { scene, generation: run.generation, day, facts, lists })
    }

    /// The link of what a picture is to show.
    pub fn link(&self, picture: usize) -> String {
        let scene = &self.pictures[picture];
        link::write(&Scene { day: self.day.min(scene.day), ..scene.clone() })
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
        let mut all = State::Ready;
        for (k, scene) in self.pictures.iter().enumerate() {
            let Some(shown) = self.shown(k) else { return State::Loading };
            let has_ended = self.run(k).is_some_and(|run| run.end.is_some());
            if !(is_drawn(&shown, k) && (has_ended || shown.day == self.day.min(scene.day))) {
                all = State::Growing;
            }
        }
        all
    }

    fn plant(&self) -> &'static Plant {
        self.pictures[0].plant
    }
}

#[cfg(test)]
mod tests {
    use super::super::figures::Picture;
    use super::super::testing::PLANTS;
    use super::super::worker::Worker;
    use super::*;

    const ROW: Figure = Figure {
        number: "4.0",
        title: "Leaves",
        caption: "Three pictures of two growths.",
        pictures: &[
            Picture { label: "day 2", link: "leaf?v=1&s=1&d=2" },
            Picture { label: "day 4", link: "leaf?v=1&s=1&d=4" },
            Picture { label: "individual 2", link: "leaf?v=1&s=2&d=5" },
        ],
    };
    const OTHER: Figure = Figure {
        number: "4.1",
        pictures: &[Picture { label: "", link: "fruit?v=1&s=3&d=4" }],
        ..ROW
    };

    /// Figures and their workers, with a mailbox between them.
    struct Together {
        gallery: Gallery,
        workers: Vec<Worker>,
        loads: usize,
        wishes: Vec<usize>,
    }

    impl Together {
        fn new(workers: usize) -> Together {
            let all = Together {
                gallery: Gallery::new(PLANTS, workers),
                workers: (0..workers).map(|_| Worker::new(PLANTS)).collect(),
                loads: 0,
                wishes: Vec::new(),
            };
            (0..workers).fold(all, |mut all, number| {
                all.hear(Event::FromWorker(number, Worker::hello()));
                all
            })
        }

        fn hear(&mut self, event: Event) {
            for (number, effect) in self.gallery.hear(event) {
                match effect {
                    Effect::LoadMesh(name) => {
                        self.loads += 1;
                        self.hear(Event::Mesh { name, text: Ok(String::new()) });
                    }
                    Effect::Post(wish) => {
                        if matches!(wish, ToWorker::Grow { .. }) {
                            self.wishes.push(number);
                        }
                        assert_eq!(self.workers[number].hear(wish), None);
                    }
                    other => panic!("{other:?}"),
                }
            }
        }

        /// Every worker that is busy does one event.
        fn work(&mut self) {
            for number in 0..self.workers.len() {
                let mut answers = Vec::new();
                self.workers[number].work(|| true, |answer| answers.push(answer));
                for answer in answers {
                    self.hear(Event::FromWorker(number, answer));
                }
            }
        }

        fn finish(&mut self) {
            while self.workers.iter().any(Worker::is_busy) {
                self.work();
            }
        }

        fn days(&self) -> Vec<Option<u32>> {
            let row = self.gallery.row().unwrap();
            (0..row.pictures.len()).map(|k| row.shown(k).map(|shown| shown.day)).collect()
        }
    }

    #[test]
    fn a_row_grows_once_for_each_growth_with_any_number_of_workers() {
        let fingerprints = [1, 2, 5].map(|workers| {
            let mut all = Together::new(workers);
            all.hear(Event::Open(&ROW));
            assert_eq!(all.days(), [None; 3]);
            let state = |all: &Together, drawn| all.gallery.row().unwrap().state(|_, _| drawn);
            assert_eq!(state(&all, true), State::Loading);
            while all.days().contains(&None) {
                all.work();
            }
            assert_eq!(state(&all, true), State::Growing);
            all.finish();
            assert_eq!((state(&all, false), state(&all, true)), (State::Growing, State::Ready));
            assert_eq!(all.days(), [Some(2), Some(4), Some(5)]);
            assert_eq!(all.loads, 1);
            assert_eq!(all.wishes, if workers == 1 { [0, 0] } else { [0, 1] });
            let row = all.gallery.row().unwrap();
            assert_eq!(row.runs[0].newest(), Some(4), "no day that nobody looks at grows");
            [0, 1, 2].map(|k| row.shown(k).unwrap().facts.fingerprint.clone())
        });
        assert!(fingerprints.iter().all(|f| *f == fingerprints[0]));
    }

    #[test]
    fn days_go_together_up_to_each_pictures_own() {
        let mut all = Together::new(2);
        all.hear(Event::Open(&ROW));
        all.finish();
        all.hear(Event::Day(3));
        assert_eq!(all.days(), [Some(2), Some(3), Some(3)]);
        let row = all.gallery.row().unwrap();
        let linked = [0, 1, 2].map(|k| link::read(&row.link(k), PLANTS).scene.day);
        assert_eq!(linked, [2, 3, 3], "what is seen is what opens");
        all.hear(Event::Day(99));
        assert_eq!(all.days(), [Some(2), Some(4), Some(5)]);
    }

    #[test]
    fn another_row_takes_the_workers_over() {
        let mut all = Together::new(1);
        all.hear(Event::Open(&ROW));
        all.work();
        all.hear(Event::Open(&OTHER));
        all.finish();
        assert_eq!(all.days(), [Some(4)]);
    }

    #[test]
    fn a_mesh_that_does_not_come_is_told_and_not_asked_for_again() {
        let mut gallery = Gallery::new(PLANTS, 1);
        gallery.hear(Event::FromWorker(0, Worker::hello()));
        assert_eq!(gallery.hear(Event::Open(&ROW)), [(0, Effect::LoadMesh("leaf"))]);
        let text = Err("no connection".to_string());
        assert_eq!(gallery.hear(Event::Mesh { name: "leaf", text }), []);
        let row = gallery.row().unwrap();
        assert!(row.trouble.as_ref().unwrap().contains("no connection"));
        assert_eq!(row.state(|_, _| true), State::Error);
    }
}
