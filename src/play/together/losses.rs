//! What is lost: the page that the figures stand before, mesh files, and workers.

use super::super::protocol::ToPage;
use super::*;

fn posts(effects: &[Effect]) -> usize {
    effects.iter().filter(|effect| matches!(effect, Effect::Post(_))).count()
}

#[test]
fn behind_the_figures_nothing_is_loaded_until_the_plant_is_opened() {
    for link in ["leaf?v=1&s=1&d=3", "fruit?v=1&s=1&d=3"] {
        let mut all = Together::open("#figures/4.8");
        all.hear(Event::LessMotion(true));
        assert_eq!((all.starts, all.loads.len(), all.links.len()), (0, 0, 0));
        // The first one is the very plant that waits behind the figures.
        all.hear(Event::OpenLink(format!("#{link}")));
        all.finish();
        assert_eq!((all.page.state(), all.starts, all.loads.len()), (State::Ready, 1, 1));
        assert_eq!(all.links, [link]);
    }
}

#[test]
fn the_figures_get_the_room_of_the_plant_and_it_comes_back() {
    let mut all = Together::open("#leaf?v=1&s=7&d=5");
    all.finish();
    let before = all.fingerprint();
    let effects = all.page.hear(Event::OpenLink("#figures".to_string()));
    assert_eq!((all.page.state(), all.page.drawn()), (State::Loading, None));
    assert_eq!(all.page.shown().day, None, "nothing is told of what is not held");
    all.take(effects);
    assert!(all.worker.is_none() && all.page.run().newest().is_none());
    // A file for the figures is no reason to grow.
    all.hear(Event::Mesh { name: "leaf", text: Ok(SHEET.to_string()) });
    all.hear(Event::OpenLink("#figures/4.1".to_string()));
    assert_eq!((all.starts, all.wishes, all.links.len()), (1, 1, 1));
    all.hear(Event::OpenLink(format!("#{}", all.page.link())));
    all.finish();
    assert_eq!((all.page.state(), all.drawn_day()), (State::Ready, Some(5)));
    assert_eq!((all.fingerprint(), all.loads.len()), (before, 1));
    assert!(!all.page.history().can_undo(), "the scene is the same");
}

#[test]
fn a_file_that_was_not_waited_for_changes_nothing() {
    let mut all = Together::open("#leaf?v=1&s=1&d=4");
    all.finish();
    for text in [Ok(String::new()), Err("503".to_string())] {
        for name in ["leaf", "fruit"] {
            let effects = all.page.hear(Event::Mesh { name, text: text.clone() });
            assert_eq!((effects, all.page.state()), (vec![], State::Ready), "{name}: {text:?}");
            assert_eq!(all.page.run().end, Some(End::Done));
        }
    }
    // Nor does it while the plant grows.
    all.hear(Event::Individual(2.0));
    let effects = all.page.hear(Event::Mesh { name: "leaf", text: Ok(SHEET.to_string()) });
    assert_eq!(posts(&effects), 0);
}

#[test]
fn a_file_that_is_not_wished_any_more_is_no_trouble() {
    for away in [Event::ChoosePlant("fruit".to_string()), Event::OpenLink("#figures".to_string())] {
        let (mut page, _) = Page::open("#leaf?v=1&s=1&d=1", PLANTS);
        page.hear(away.clone());
        let effects = page.hear(Event::Mesh { name: "leaf", text: Err("404".to_string()) });
        assert_eq!((effects, page.state()), (vec![], State::Loading), "{away:?}");
    }
}

#[test]
fn the_page_has_a_mesh_when_its_worker_has_it() {
    let (mut page, _) = Page::open("#leaf?v=1&s=1&d=1", PLANTS);
    page.hear(Event::Mesh { name: "leaf", text: Ok("f 1 2 3".to_string()) });
    assert_eq!(page.mesh(), None, "the first cells come first");
    page.hear(Event::FromWorker(Worker::hello()));
    assert_eq!(page.mesh(), Some("f 1 2 3"));
    // It needs it still when the worker is gone.
    page.hear(Event::WorkerLost(String::new()));
    assert_eq!(page.mesh(), Some("f 1 2 3"));
}

#[test]
fn a_plant_that_waits_for_its_file_did_not_kill_the_worker() {
    let mut all = Together::open("#leaf?v=1&s=1&d=3");
    all.work_until_day(1);
    let effects = all.page.hear(Event::ChoosePlant("fruit".to_string()));
    assert!(effects.contains(&Effect::LoadMesh("fruit")));
    // It was the one before.
    all.kill();
    assert_eq!((all.starts, all.told.len()), (2, 0));
    all.hear(Event::Mesh { name: "fruit", text: Ok(SHEET.to_string()) });
    all.finish();
    assert_eq!(all.page.state(), State::Ready);
    assert_eq!(all.page.drawn().unwrap().plant, "fruit");
}

#[test]
fn a_mesh_that_cannot_be_loaded_is_told_and_asked_for_whenever_the_scene_is_wished_again() {
    let (mut page, effects) = Page::open("#leaf?v=1&s=1&d=1", PLANTS);
    assert!(effects.contains(&Effect::LoadMesh("leaf")));
    page.hear(Event::FromWorker(Worker::hello()));
    let fail = |page: &mut Page| {
        let effects = page.hear(Event::Mesh { name: "leaf", text: Err("404".to_string()) });
        assert_eq!(page.state(), State::Error);
        let Effect::Tell(told) = &effects[0] else { panic!("{effects:?}") };
        assert!(told[0].contains("leaf") && told[0].contains("404"), "{told:?}");
    };
    let loads = |effects: &[Effect]| effects.contains(&Effect::LoadMesh("leaf"));
    for wish in [
        Event::Individual(2.0),
        Event::Individual(2.0),
        Event::ChoosePlant("leaf".to_string()),
        Event::Seek(4),
        Event::StepDays(1),
        Event::LetGo,
    ] {
        fail(&mut page);
        assert!(loads(&page.hear(wish.clone())), "{wish:?}");
        assert_eq!(page.state(), State::Loading);
        assert!(!loads(&page.hear(wish.clone())), "{wish:?}: it is on its way");
    }
    fail(&mut page);
    // The figures got it.
    let effects = page.hear(Event::Mesh { name: "leaf", text: Ok(SHEET.to_string()) });
    assert_eq!((posts(&effects), page.run().end.clone()), (2, None));
}

#[test]
fn a_growth_that_is_too_large_brings_back_what_was_there_before() {
    let mut all = Together::open("#leaf?v=1&s=1&d=4&bo=0.8");
    all.finish();
    let before = all.fingerprint();
    all.hear(Event::Change { key: "df", value: 3.0 });
    all.work_until_grown(1);
    all.kill();
    assert!(all.told[0].contains("more memory") && all.told[0].contains("back"));
    assert_eq!(all.links.last().unwrap(), "leaf?v=1&s=1&d=4&bo=0.8");
    assert_eq!(all.starts, 2);
    all.finish();
    assert_eq!((all.page.state(), all.fingerprint()), (State::Ready, before));
    assert!(all.told[0].contains("more memory"), "it is still there to be read");
    all.hear(Event::Undo);
    assert_eq!(all.links.last().unwrap(), "leaf?v=1&s=1&d=4&df=3&bo=0.8", "the visitor may insist");
}

#[test]
fn a_link_that_is_too_large_from_the_start_brings_the_preset() {
    let mut all = Together::open("#leaf?v=1&s=9&d=5&df=2");
    all.kill();
    assert_eq!(all.links.last().unwrap(), "leaf?v=1&s=9&d=3");
    all.finish();
    assert_eq!(all.page.state(), State::Ready);
}

#[test]
fn where_even_the_preset_is_too_large_another_plant_can_be_chosen() {
    let mut all = Together::open("#leaf?v=1&s=9&d=5&df=2");
    all.kill();
    all.deliver();
    all.kill();
    assert_eq!((all.page.state(), all.starts), (State::Error, 2));
    assert!(all.told[0].contains("more memory"), "{:?}", all.told);
    all.hear(Event::ChoosePlant("fruit".to_string()));
    all.finish();
    assert_eq!((all.page.state(), all.told.len()), (State::Ready, 0));
}

#[test]
fn what_came_back_and_is_lost_too_does_not_come_back_again() {
    let mut all = Together::open("#leaf?v=1&s=1&d=4&df=4");
    all.finish();
    all.hear(Event::Change { key: "df", value: 3.0 });
    for link in ["leaf?v=1&s=1&d=4&df=4", "leaf?v=1&s=1&d=3"] {
        all.kill();
        all.deliver();
        assert_eq!(all.links.last().unwrap(), link);
    }
    all.work_until_day(2);
    all.kill();
    assert_eq!(all.links.last().unwrap(), "leaf?v=1&s=1&d=3&days=3", "these days did grow");
    all.rest();
    assert_eq!((all.page.state(), all.starts), (State::Ready, 3));
}

#[test]
fn days_that_have_come_stay_when_the_wished_one_is_among_them() {
    let mut all = Together::open("#leaf?v=1&s=1&d=2");
    all.work_until_day(3);
    all.rest();
    let before = all.fingerprint();
    all.kill();
    assert!(all.told[0].contains("more memory"), "{:?}", all.told);
    assert_eq!((all.page.state(), all.fingerprint()), (State::Ready, before));
    assert_eq!(all.page.run().last_day(), 3);
    // The link is one that grows.
    assert_eq!(all.links.last().unwrap(), "leaf?v=1&s=1&d=2&days=3");
    all.hear(Event::Seek(99));
    all.rest();
    assert_eq!((all.page.state(), all.drawn_day()), (State::Ready, Some(3)));
    all.hear(Event::Change { key: "bo", value: 0.7 });
    assert_eq!((all.starts, all.wishes), (1, 1), "nobody needs a worker yet");
    all.hear(Event::Individual(2.0));
    all.finish();
    assert_eq!((all.page.state(), all.starts), (State::Ready, 2));
}

#[test]
fn a_day_that_was_wished_later_is_given_up() {
    let mut all = Together::open("#leaf?v=1&s=1&d=1");
    all.work_until_day(2);
    all.rest();
    all.hear(Event::Seek(6));
    all.kill();
    all.rest();
    assert_eq!(all.links.last().unwrap(), "leaf?v=1&s=1&d=2&days=2");
    assert_eq!((all.page.state(), all.drawn_day()), (State::Ready, Some(2)));
}

#[test]
fn a_wished_day_that_has_come_stays_without_those_before_it() {
    let mut all = Together::open("#leaf?v=1&s=1&d=2&df=4");
    while all.page.run().facts(2).is_none() {
        all.work();
    }
    assert_eq!(all.page.run().newest(), None);
    all.kill();
    assert_eq!(all.links.last().unwrap(), "leaf?v=1&s=1&d=2&df=4&days=2");
    all.rest();
    assert_eq!((all.page.state(), all.drawn_day(), all.wishes), (State::Ready, Some(2), 1));
    // A day before it is grown again when somebody wishes it.
    all.hear(Event::Seek(1));
    all.finish();
    assert_eq!((all.page.state(), all.drawn_day(), all.wishes), (State::Ready, Some(1), 2));
    assert_eq!(all.fingerprint(), fingerprint_of("#leaf?v=1&s=1&d=1&df=4"));
}

#[test]
fn a_first_day_alone_is_kept_too() {
    let mut all = Together::open("#leaf?v=1&s=1&d=0");
    all.work_until_day(0);
    all.kill();
    assert_eq!((all.page.state(), all.drawn_day()), (State::Ready, Some(0)));
    assert_eq!(all.page.run().last_day(), 0);
    assert_eq!(all.links.last().unwrap(), "leaf?v=1&s=1&d=0&days=1");
}

#[test]
fn a_worker_that_rests_may_go() {
    let mut all = Together::open("#leaf?v=1&s=1&d=4");
    all.finish();
    let links = all.links.len();
    all.kill();
    assert_eq!((all.page.state(), all.told.len()), (State::Ready, 0));
    assert_eq!((all.starts, all.links.len()), (1, links));
    all.hear(Event::Seek(2));
    all.rest();
    assert_eq!((all.page.state(), all.starts), (State::Ready, 1));
    all.hear(Event::Individual(2.0));
    all.finish();
    assert_eq!((all.page.state(), all.starts), (State::Ready, 2));
}

#[test]
fn workers_that_never_speak_are_not_started_without_end() {
    let (mut page, effects) = Page::open("#leaf?v=1&s=1&d=1", PLANTS);
    let starts = |effects: &[Effect]| effects.iter().filter(|e| **e == Effect::StartWorker).count();
    assert_eq!(starts(&effects), 1);
    let lost = || Event::WorkerLost("It is gone.".to_string());
    for _ in 0..2 {
        assert_eq!(starts(&page.hear(lost())), 1);
        assert_eq!(page.state(), State::Loading);
    }
    let effects = page.hear(lost());
    assert_eq!((starts(&effects), page.state()), (0, State::Error));
    assert!(effects.contains(&Effect::Tell(vec!["It is gone.".to_string()])));
    // The visitor wishes something: as many tries again.
    assert_eq!(starts(&page.hear(Event::Seek(2))), 1);
    assert_eq!(starts(&page.hear(lost())) + starts(&page.hear(lost())), 2);
    assert_eq!(starts(&page.hear(lost())), 0);
}

#[test]
fn a_recipe_that_is_refused_leaves_the_scene_and_says_why() {
    let mut all = Together::open("#leaf?v=1&s=1&d=2");
    all.finish();
    all.hear(Event::Change { key: "df", value: 3.0 });
    let (generation, text) = (all.page.run().generation, "there is no room".to_string());
    all.mailbox = vec![ToPage::Failed { generation, text }.to_words()];
    all.deliver();
    assert_eq!(all.told, ["This cannot be grown: there is no room."]);
    assert_eq!(all.page.state(), State::Error);
    assert_eq!(all.links.last().unwrap(), "leaf?v=1&s=1&d=2&df=3");
    assert_eq!(all.drawn_day(), Some(2), "the picture before stays");
    all.hear(Event::Undo);
    all.finish();
    assert_eq!((all.page.state(), all.told.len()), (State::Ready, 0));
}

#[test]
fn a_stranger_is_sent_away() {
    let (mut page, _) = Page::open("", PLANTS);
    let hello = ToPage::Hello { build: "another".to_string() };
    assert_eq!(page.hear(Event::FromWorker(hello)), [Effect::Reload]);
}
