//! Page and worker joined in memory: what a visitor does, from event to picture.

use super::page::{Effect, Event, Page, State};
use super::protocol::{ToPage, ToWorker};
use super::testing::{PLANTS, SHEET};
use super::worker::Worker;
use super::{End, link};
use crate::plants::Show;
use crate::tissue::Progress;
use std::sync::Arc;

mod cloning;
mod fields;
mod first;
mod late;
mod looking;
mod losses;

/// A page and a worker with a mailbox between them, through the words of the protocol.
struct Together {
    page: Page,
    worker: Option<Worker>,
    /// What the worker has said and the page has not heard yet.
    mailbox: Vec<Vec<u32>>,
    starts: usize,
    /// All addresses, and those that were entries of their own.
    links: Vec<String>,
    pushed: Vec<String>,
    said: Vec<String>,
    told: Vec<String>,
    wishes: usize,
    /// Mesh files that were handed to workers.
    files: usize,
    loads: Vec<&'static str>,
}

impl Together {
    fn open(fragment: &str) -> Together {
        let (page, effects) = Page::open(fragment, PLANTS);
        let mut all = Together {
            page,
            worker: None,
            mailbox: Vec::new(),
            starts: 0,
            links: Vec::new(),
            pushed: Vec::new(),
            said: Vec::new(),
            told: Vec::new(),
            wishes: 0,
            files: 0,
            loads: Vec::new(),
        };
        all.take(effects);
        all.deliver();
        all
    }

    fn hear(&mut self, event: Event) {
        let effects = self.page.hear(event);
        self.take(effects);
        let drawn = self.page.hear(Event::Drawn { sharp: true });
        self.take(drawn);
    }

    fn take(&mut self, effects: Vec<Effect>) {
        for effect in effects {
            match effect {
                Effect::StartWorker => {
                    self.starts += 1;
                    self.worker = Some(Worker::new(PLANTS));
                    // What the one before has said is not heard any more.
                    self.mailbox = vec![Worker::hello().to_words()];
                }
                Effect::EndWorker => {
                    self.worker = None;
                    self.mailbox.clear();
                }
                Effect::Post(wish) => {
                    self.wishes += usize::from(matches!(wish, ToWorker::Grow { .. }));
                    self.files += usize::from(matches!(wish, ToWorker::Mesh { .. }));
                    let wish = ToWorker::from_words(&wish.to_words()).unwrap();
                    let answer = self.worker.as_mut().and_then(|worker| worker.hear(wish));
                    self.mailbox.extend(answer.map(|answer| answer.to_words()));
                }
                Effect::LoadMesh(name) => {
                    self.loads.push(name);
                    self.hear(Event::Mesh { name, text: Ok(SHEET.to_string()) });
                }
                Effect::WriteLink(link) => self.links.push(link),
                Effect::PushLink(link) => {
                    self.pushed.push(link.clone());
                    self.links.push(link);
                }
                Effect::Say(text) => self.said.push(text),
                Effect::Tell(texts) => self.told = texts,
                Effect::Reload => panic!("a stranger"),
            }
        }
    }

    fn is_busy(&self) -> bool {
        self.worker.as_ref().is_some_and(Worker::is_busy)
    }

    /// Lets the worker do one relaxation event; what it says is under way.
    fn grow(&mut self) {
        if let Some(worker) = &mut self.worker {
            worker.work(|| true, |answer| self.mailbox.push(answer.to_words()));
        }
    }

    /// The page hears what is under way.
    fn deliver(&mut self) {
        for words in std::mem::take(&mut self.mailbox) {
            self.hear(Event::FromWorker(ToPage::from_words(&words).unwrap()));
        }
    }

    fn work(&mut self) {
        self.grow();
        self.deliver();
    }

    /// Takes the worker away.
    fn kill(&mut self) {
        self.worker = None;
        self.mailbox.clear();
        self.hear(Event::WorkerLost("It is gone.".to_string()));
    }

    fn work_until_grown(&mut self, day: u32) {
        while self.page.run().grown() < Some(day) {
            self.work();
        }
    }

    fn work_until_day(&mut self, day: u32) {
        while self.page.run().newest() < Some(day) {
            self.work();
        }
    }

    fn finish_growth(&mut self) {
        self.deliver();
        while self.is_busy() {
            self.work();
        }
    }

    fn finish(&mut self) {
        self.finish_growth();
        self.rest();
    }

    /// Lets time pass until nothing moves.
    fn rest(&mut self) {
        for _ in 0..10_000 {
            if !self.page.is_moving() {
                return;
            }
            self.hear(Event::Tick(1.0 / 60.0));
        }
        panic!("never at rest");
    }

    fn drawn_day(&self) -> Option<u32> {
        self.page.drawn().and_then(|d| d.day.as_ref()).map(|d| d.day)
    }

    fn fingerprint(&self) -> String {
        self.page.drawn().and_then(|d| d.day.as_ref()).unwrap().facts.fingerprint.clone()
    }
}

/// The fingerprint that the model gives without page and worker.
fn fingerprint_of(fragment: &str) -> String {
    let scene = link::read(fragment, PLANTS).scene;
    let mesh = Arc::new(scene.plant.embedded_body().surface);
    let mut growth = scene.plant.sow(mesh, scene.recipe, scene.individual).unwrap();
    while growth.step() != Progress::Day(scene.day) {}
    growth.diary.fingerprint(scene.day as usize)
}

#[test]
fn held_days_need_no_worker() {
    let mut all = Together::open("#leaf?v=1&s=1&d=6");
    all.finish();
    for day in [0, 5, 2, 6] {
        all.hear(Event::Seek(day));
        all.rest();
        assert_eq!((all.page.state(), all.drawn_day()), (State::Ready, Some(day)));
        assert_eq!(all.fingerprint(), fingerprint_of(&format!("#leaf?v=1&s=1&d={day}")));
    }
    assert_eq!(all.wishes, 1);
    assert_eq!(all.links.last().unwrap(), "leaf?v=1&s=1&d=6");
}

#[test]
fn the_newest_wish_wins() {
    let mut all = Together::open("#leaf?v=1&s=1&d=6");
    all.work_until_day(2);
    all.rest();
    all.hear(Event::Individual(2.0));
    // The picture before stays until something of the new one has grown.
    assert_eq!(all.page.state(), State::Growing);
    assert_eq!(all.page.drawn().unwrap().individual, 1);
    all.hear(Event::Individual(3.0));
    all.hear(Event::ChoosePlant("fruit".to_string()));
    assert_eq!(all.page.state(), State::Loading);
    assert_eq!(all.page.drawn().unwrap().plant, "fruit");
    all.finish();
    assert_eq!(all.page.drawn().unwrap().individual, 3);
    assert_eq!(all.fingerprint(), fingerprint_of("#fruit?v=1&s=3&d=3"));
    assert_eq!(all.page.run().generation, 4);
}

#[test]
fn playing_goes_to_the_end_and_the_link_follows_at_rest() {
    let mut all = Together::open("#leaf?v=1&s=1&d=0");
    all.finish();
    let links = all.links.len();
    all.hear(Event::PlayOrPause);
    let mut moments = 0;
    while all.page.playhead().is_playing() {
        all.hear(Event::Tick(1.0 / 60.0));
        let day = all.page.shown().day.clone().unwrap();
        moments += usize::from(day.moment < 1.0);
        if all.page.playhead().is_playing() {
            assert_eq!(all.links.len(), links);
        }
    }
    assert!(moments > 100, "cells move between the days");
    assert_eq!((all.page.state(), all.drawn_day()), (State::Ready, Some(6)));
    assert_eq!(all.links.last().unwrap(), "leaf?v=1&s=1&d=6");
}

#[test]
fn parameters_regrow_or_not_and_can_be_undone() {
    let mut all = Together::open("#leaf?v=1&s=1&d=2");
    all.finish();
    let before = all.fingerprint();
    all.hear(Event::Change { key: "bo", value: 0.8 });
    assert_eq!((all.wishes, all.page.state()), (1, State::Ready));
    all.hear(Event::Change { key: "df", value: 3.0 });
    all.hear(Event::Change { key: "df", value: 2.5 });
    all.finish();
    assert_eq!(all.wishes, 3);
    assert_ne!(all.fingerprint(), before);
    assert_eq!(all.links.last().unwrap(), "leaf?v=1&s=1&d=2&df=2.5&bo=0.8");
    all.hear(Event::Undo);
    all.finish();
    assert_eq!(all.links.last().unwrap(), "leaf?v=1&s=1&d=2&bo=0.8");
    assert_eq!(all.fingerprint(), before);
    all.hear(Event::Redo);
    all.hear(Event::ResetParameters);
    all.finish();
    assert_eq!(all.links.last().unwrap(), "leaf?v=1&s=1&d=2");
    all.hear(Event::Change { key: "df", value: 0.1 });
    assert_eq!(all.page.refusal("df"), Some("Not taken: it must be from 1.5 to 200 days."));
    assert_eq!(all.page.refusal("db"), None);
    all.hear(Event::Change { key: "df", value: 3.0 });
    assert_eq!(all.page.refusal("df"), None, "over with the next value");
    for number in [7.5, -1.0, 1e11, f64::NAN] {
        all.hear(Event::Individual(number));
        assert!(all.page.refusal("s").unwrap().contains("whole number from 0 to 4294967295"));
        assert_eq!(all.page.scene().individual, 1);
    }
}

#[test]
fn messages_go_with_the_scene() {
    let mut all = Together::open("#leaf?v=1&s=1&d=2&zz=1");
    assert_eq!(all.told.len(), 1);
    all.hear(Event::Seek(1));
    all.hear(Event::Change { key: "df", value: 0.1 });
    assert_eq!(all.told.len(), 1, "nothing was taken yet");
    all.hear(Event::Change { key: "df", value: 3.0 });
    assert_eq!(all.told, [""; 0]);
}

#[test]
fn what_is_shown_never_grows_and_can_be_undone() {
    // These plants have nothing to show but cells; the page takes what it is told.
    let mut all = Together::open("#leaf?v=1&s=1&d=2");
    all.finish();
    all.hear(Event::Show(Show::ControlImages));
    assert_eq!((all.wishes, all.page.state()), (1, State::Ready));
    assert_eq!(all.links.last().unwrap(), "leaf?v=1&s=1&d=2&show=controls");
    assert!(all.said.last().unwrap().ends_with("Seen now: Control images."), "{:?}", all.said);
    all.hear(Event::ResetParameters);
    assert_eq!(all.page.scene().show, Show::ControlImages);
    all.hear(Event::Undo);
    assert_eq!(all.page.scene().show, Show::Cells);
    assert_eq!(all.links.last().unwrap(), "leaf?v=1&s=1&d=2");
    assert_eq!(all.wishes, 1);
}

#[test]
fn a_full_population_ends_the_line_of_days() {
    static CROWDED: std::sync::LazyLock<Vec<crate::plants::Plant>> =
        std::sync::LazyLock::new(|| {
            let mut plant = PLANTS[0].clone();
            plant.recipe.max_cells = 130;
            vec![plant]
        });
    let (mut page, _) = Page::open("#leaf?v=1&s=1&d=6", &CROWDED);
    page.hear(Event::Mesh { name: "leaf", text: Ok(SHEET.to_string()) });
    let mut worker = Worker::new(&CROWDED);
    let mut told = Vec::new();
    for effect in page.hear(Event::FromWorker(Worker::hello())) {
        let Effect::Post(wish) = effect else { continue };
        assert_eq!(worker.hear(wish), None);
    }
    let mut answers = Vec::new();
    worker.work(|| false, |answer| answers.push(answer));
    for answer in answers {
        for effect in page.hear(Event::FromWorker(answer)) {
            if let Effect::Tell(texts) = effect {
                told = texts;
            }
        }
    }
    while page.is_moving() {
        page.hear(Event::Tick(0.1));
    }
    page.hear(Event::Drawn { sharp: true });
    let last = page.run().last_day();
    assert!((1..6).contains(&last));
    assert_eq!(page.state(), State::Ready);
    assert_eq!(page.scene().day, last);
    assert!(told[0].starts_with(&format!("Growth ended on day {last}")), "{told:?}");
}

#[test]
fn a_picture_is_ready_when_it_has_all_its_pixels() {
    let mut all = Together::open("#leaf?v=1&s=1&d=4");
    all.finish();
    let page = &mut all.page;
    for event in [Event::Seek(2), Event::Change { key: "va", value: 0.2 }] {
        page.hear(event.clone());
        while page.is_moving() {
            page.hear(Event::Tick(0.1));
        }
        for (sharp, state) in [
            (false, State::Growing),
            (true, State::Ready),
            // The plant is turned.
            (false, State::Ready),
        ] {
            page.hear(Event::Drawn { sharp });
            assert_eq!(page.state(), state, "{event:?}");
        }
    }
}

#[test]
fn each_mesh_is_loaded_once() {
    let mut all = Together::open("#leaf?v=1&s=1&d=1");
    for plant in ["fruit", "leaf", "fruit"] {
        all.hear(Event::ChoosePlant(plant.to_string()));
        all.finish();
        assert_eq!(all.page.drawn().unwrap().plant, plant);
    }
    assert_eq!((all.loads, all.files), (vec!["leaf", "fruit"], 2));
}
