//! Figures and their workers joined in memory.

use super::super::testing::{PLANTS, SHEET};
use super::super::worker::Worker;
use super::*;
mod files;
mod looking;

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
const OTHER: Figure =
    Figure { number: "4.1", pictures: &[Picture { label: "", link: "fruit?v=1&s=3&d=4" }], ..ROW };

/// Figures and their workers, with a mailbox between them.
struct Together {
    gallery: Gallery,
    workers: Vec<Option<Worker>>,
    /// What workers have said and the figures have not heard yet.
    mailbox: Vec<(usize, ToPage)>,
    starts: usize,
    loads: usize,
    wishes: Vec<usize>,
}

impl Together {
    fn new(workers: usize) -> Together {
        Together {
            gallery: Gallery::new(PLANTS, workers, Vec::new()),
            workers: (0..workers).map(|_| None).collect(),
            mailbox: Vec::new(),
            starts: 0,
            loads: 0,
            wishes: Vec::new(),
        }
    }

    fn hear(&mut self, event: Event) {
        for (number, effect) in self.gallery.hear(event) {
            match effect {
                Effect::StartWorker => {
                    self.starts += 1;
                    self.workers[number] = Some(Worker::new(PLANTS));
                    self.mailbox.push((number, Worker::hello()));
                }
                Effect::EndWorker => self.end(number),
                Effect::LoadMesh(name) => {
                    self.loads += 1;
                    self.hear(Event::Mesh { name, text: Ok(SHEET.to_string()) });
                }
                Effect::Post(wish) => {
                    if matches!(wish, ToWorker::Grow { .. }) {
                        self.wishes.push(number);
                    }
                    assert_eq!(self.workers[number].as_mut().unwrap().hear(wish), None);
                }
                other => panic!("{other:?}"),
            }
        }
    }

    /// A worker is there no more, and what it said is not heard.
    fn end(&mut self, number: usize) {
        self.workers[number] = None;
        self.mailbox.retain(|(from, _)| *from != number);
    }

    fn kill(&mut self, number: usize) {
        self.end(number);
        self.hear(Event::WorkerLost(number, "It is gone.".to_string()));
    }

    /// Every worker that is busy does one event; what it says is under way.
    fn grow(&mut self) {
        for (number, worker) in self.workers.iter_mut().enumerate() {
            if let Some(worker) = worker {
                worker.work(|| true, |answer| self.mailbox.push((number, answer)));
            }
        }
    }

    fn deliver(&mut self) {
        for (number, answer) in std::mem::take(&mut self.mailbox) {
            self.hear(Event::FromWorker(number, answer));
        }
    }

    fn work(&mut self) {
        self.grow();
        self.deliver();
    }

    fn is_busy(&self) -> bool {
        self.workers.iter().flatten().any(Worker::is_busy)
    }

    fn finish(&mut self) {
        self.deliver();
        while self.is_busy() {
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
        assert_eq!((all.loads, all.starts), (1, workers.min(2)), "as many as the row has growths");
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
    let mut all = Together::new(2);
    all.hear(Event::Open(&ROW));
    all.work();
    all.hear(Event::Open(&OTHER));
    let busy = all.workers.iter().flatten().filter(|worker| worker.is_busy()).count();
    assert_eq!(busy, 1, "it has one growth");
    all.finish();
    assert_eq!(all.days(), [Some(4)]);
}

#[test]
fn a_late_end_frees_no_worker_of_the_new_row() {
    for late in [
        ToPage::Done { generation: 1 },
        ToPage::Full { generation: 1 },
        ToPage::Failed { generation: 1, text: "it cannot be".to_string() },
    ] {
        let mut all = Together::new(1);
        all.hear(Event::Open(&ROW));
        all.deliver();
        all.hear(Event::Open(&OTHER));
        all.mailbox.push((0, late.clone()));
        all.finish();
        assert_eq!(all.wishes, [0, 0], "{late:?}: one for each row");
        let row = all.gallery.row().unwrap();
        assert_eq!((row.shown(0).unwrap().day, row.trouble.clone()), (4, None), "{late:?}");
    }
}

#[test]
fn growths_that_end_early_free_their_worker() {
    for early in [
        ToPage::Full { generation: 1 },
        ToPage::Failed { generation: 1, text: "it cannot be".to_string() },
    ] {
        let mut all = Together::new(1);
        all.hear(Event::Open(&ROW));
        while all.days()[0].is_none() {
            all.work();
        }
        all.workers[0].as_mut().unwrap().hear(ToWorker::Stop);
        all.mailbox = vec![(0, early.clone())];
        all.finish();
        assert_eq!((all.days()[1..].to_vec(), &all.wishes), (vec![Some(0), Some(5)], &vec![0, 0]));
        let is_full = matches!(early, ToPage::Full { .. });
        let state = if is_full { State::Ready } else { State::Error };
        assert_eq!(all.gallery.row().unwrap().state(|_, _| true), state);
        all.hear(Event::Day(3));
        assert_eq!(all.wishes.len(), 2, "that is no reason to grow it again");
    }
}

#[test]
fn late_days_are_of_no_use_to_the_new_row() {
    let mut all = Together::new(1);
    all.hear(Event::Open(&ROW));
    all.deliver();
    while all.mailbox.is_empty() {
        all.grow();
    }
    all.hear(Event::Open(&OTHER));
    all.deliver();
    assert_eq!(all.days(), [None]);
    all.finish();
    assert_eq!(all.days(), [Some(4)]);
}

#[test]
fn what_a_lost_worker_grew_is_given_to_another() {
    let grown = |all: &Together| -> Vec<String> {
        let row = all.gallery.row().unwrap();
        (0..3).map(|k| row.shown(k).unwrap().facts.fingerprint.clone()).collect()
    };
    let mut whole = Together::new(2);
    whole.hear(Event::Open(&ROW));
    whole.finish();
    for workers in [1, 2] {
        let mut all = Together::new(workers);
        all.hear(Event::Open(&ROW));
        while all.days()[0] < Some(1) {
            all.work();
        }
        all.kill(0);
        assert!(all.days()[0] >= Some(1), "what has come stays");
        all.finish();
        assert_eq!(grown(&all), grown(&whole));
        assert_eq!(all.gallery.row().unwrap().state(|_, _| true), State::Ready);
        assert_eq!((all.starts, all.loads), (workers + 1, 1));
    }
}

#[test]
fn workers_that_work_may_be_lost_again_and_again() {
    const WIDE: Figure = Figure {
        pictures: &[
            Picture { label: "", link: "leaf?v=1&s=1&d=3" },
            Picture { label: "", link: "leaf?v=1&s=2&d=3" },
            Picture { label: "", link: "leaf?v=1&s=3&d=3" },
        ],
        ..ROW
    };
    let mut all = Together::new(1);
    all.hear(Event::Open(&WIDE));
    for picture in 0..3 {
        while all.days()[picture].is_none() {
            all.work();
        }
        all.kill(0);
    }
    all.finish();
    assert_eq!((all.days(), all.starts), (vec![Some(3); 3], 4));
    assert_eq!(all.gallery.row().unwrap().trouble, None);
}

#[test]
fn a_growth_that_kills_its_workers_is_told_and_the_others_go_on() {
    let mut all = Together::new(1);
    all.hear(Event::Open(&ROW));
    for _ in 0..2 {
        all.deliver();
        all.kill(0);
    }
    all.finish();
    assert_eq!(all.days(), [None, None, Some(5)]);
    let row = all.gallery.row().unwrap();
    assert!(row.trouble.as_ref().unwrap().contains("more memory"), "{:?}", row.trouble);
    assert_eq!(all.wishes.len(), 3);
    // The next row knows nothing of it.
    all.hear(Event::Open(&OTHER));
    all.finish();
    assert_eq!((all.days(), all.starts), (vec![Some(4)], 3));
    assert_eq!(all.gallery.row().unwrap().trouble, None);
}

#[test]
fn workers_that_never_speak_are_not_started_without_end() {
    let mut all = Together::new(2);
    all.hear(Event::Open(&ROW));
    for number in [0, 0, 0, 1, 1] {
        assert_eq!(all.gallery.row().unwrap().trouble, None);
        all.kill(number);
    }
    assert_eq!(all.starts, 6);
    all.kill(1);
    assert_eq!(all.starts, 6);
    let row = all.gallery.row().unwrap();
    assert_eq!(
        (row.trouble.as_deref(), row.state(|_, _| true)),
        (Some("It is gone."), State::Error)
    );
    // A row that is opened anew is tried anew.
    all.hear(Event::Open(&ROW));
    all.kill(0);
    all.finish();
    assert_eq!((all.days(), all.starts), (vec![Some(2), Some(4), Some(5)], 9));
    let effects = all.gallery.hear(Event::WorkerLost(1, String::new()));
    assert_eq!(effects, [(1, Effect::EndWorker), (1, Effect::StartWorker)]);
}

#[test]
fn a_mesh_that_does_not_come_is_told_and_asked_for_when_the_row_is_wished_again() {
    let mut gallery = Gallery::new(PLANTS, 1, Vec::new());
    gallery.hear(Event::FromWorker(0, Worker::hello()));
    let text = || Err("no connection".to_string());
    for wish in [Event::Open(&ROW), Event::Day(3), Event::Open(&ROW), Event::Day(1)] {
        assert_eq!(gallery.hear(wish.clone()), [(0, Effect::LoadMesh("leaf"))], "{wish:?}");
        assert_eq!(gallery.hear(Event::Day(2)), [], "it is on its way");
        assert_eq!(gallery.hear(Event::Mesh { name: "fruit", text: text() }), []);
        assert_eq!(gallery.row().unwrap().trouble, None, "that was for the page");
        assert_eq!(gallery.hear(Event::Mesh { name: "leaf", text: text() }), []);
        let row = gallery.row().unwrap();
        assert!(row.trouble.as_ref().unwrap().contains("no connection"));
        assert_eq!(row.state(|_, _| true), State::Error);
    }
    assert_eq!(gallery.hear(Event::Day(2)).len(), 1);
    let effects = gallery.hear(Event::Mesh { name: "leaf", text: Ok(SHEET.to_string()) });
    assert!(matches!(effects[..], [(0, Effect::Post(_)), (0, Effect::Post(_))]), "{effects:?}");
}

#[test]
fn a_file_of_another_row_is_no_reason_to_try_again() {
    let mut gallery = Gallery::new(PLANTS, 1, Vec::new());
    gallery.hear(Event::FromWorker(0, Worker::hello()));
    gallery.hear(Event::Open(&ROW));
    gallery.hear(Event::Mesh { name: "leaf", text: Err("no connection".to_string()) });
    gallery.hear(Event::Open(&OTHER));
    gallery.hear(Event::Mesh { name: "fruit", text: Ok(SHEET.to_string()) });
    let text = "it cannot be".to_string();
    gallery.hear(Event::FromWorker(0, ToPage::Failed { generation: 3, text }));
    assert_eq!(gallery.hear(Event::Day(1)), []);
    assert!(gallery.row().unwrap().trouble.as_ref().unwrap().contains("cannot be grown"));
}

#[test]
fn a_mesh_that_comes_too_late_is_no_trouble_of_the_next_row() {
    let mut gallery = Gallery::new(PLANTS, 1, Vec::new());
    gallery.hear(Event::FromWorker(0, Worker::hello()));
    gallery.hear(Event::Open(&ROW));
    gallery.hear(Event::Open(&OTHER));
    let text = Err("no connection".to_string());
    gallery.hear(Event::Mesh { name: "leaf", text });
    assert_eq!(gallery.row().unwrap().trouble, None);
}

#[test]
fn the_days_of_a_row_come_back_with_it() {
    let mut all = Together::new(2);
    all.hear(Event::Open(&ROW));
    all.hear(Event::Day(3));
    all.finish();
    all.hear(Event::Open(&OTHER));
    all.finish();
    assert_eq!(all.days(), [Some(4)], "another row has its own");
    all.hear(Event::Open(&ROW));
    all.finish();
    assert_eq!(all.days(), [Some(2), Some(3), Some(3)]);
    // The figures are left and opened again.
    let days = all.gallery.days().clone();
    let mut again = Together::new(2);
    again.gallery = Gallery::new(PLANTS, 2, days);
    assert_eq!(again.gallery.day_of(&ROW), Some(3));
    again.hear(Event::Open(&ROW));
    again.finish();
    assert_eq!(again.days(), [Some(2), Some(3), Some(3)]);
}

#[test]
fn pictures_are_called_by_the_day_that_they_show() {
    let mut all = Together::new(2);
    all.hear(Event::Open(&ROW));
    all.finish();
    let row = |all: &Together| {
        let row = all.gallery.row().unwrap();
        [0, 1, 2].map(|k| (row.label(k), row.told(k).unwrap()))
    };
    let whole = row(&all);
    assert_eq!([0, 1, 2].map(|k| whole[k].0.as_str()), ["day 2", "day 4", "individual 2"]);
    assert!(whole.iter().all(|(_, told)| !told.starts_with("Day")));
    all.hear(Event::Day(3));
    let early = row(&all);
    assert_eq!([0, 1, 2].map(|k| early[k].0.as_str()), ["day 2", "day 3 of 4", "individual 2"]);
    let says_day = [0, 1, 2].map(|k| early[k].1.starts_with("Day 3: "));
    assert_eq!(says_day, [false, false, true]);
}
