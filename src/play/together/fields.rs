//! What is typed in fields, what is said there, and the browser's way back.

use super::*;

#[test]
fn a_day_is_refused_like_any_other_number() {
    let mut all = Together::open("#leaf?v=1&s=1&d=2");
    all.finish();
    for day in [99.0, -5.0, 4.5, f64::NAN] {
        all.hear(Event::Day(day));
        let why = "Not taken: it must be a whole number from 0 to 6.";
        assert_eq!(all.page.refusal("d"), Some(why), "{day}");
        assert_eq!(all.drawn_day(), Some(2));
    }
    all.hear(Event::Day(6.0));
    all.rest();
    assert_eq!((all.page.refusal("d"), all.drawn_day()), (None, Some(6)));
    // What was refused in another field stays there to be corrected.
    all.hear(Event::Individual(7.5));
    all.hear(Event::Scrub(3.0));
    assert!(all.page.refusal("s").is_some());
    all.hear(Event::Day(99.0));
    all.hear(Event::Scrub(3.0));
    assert_eq!(all.page.refusal("d"), None);
}

#[test]
fn a_number_that_moves_another_says_so_at_both() {
    let mut all = Together::open("#leaf?v=1&s=1&d=2&pm=0.3");
    all.finish();
    // The hand pulls a slider.
    for value in [0.6, 0.8, 0.9] {
        all.hear(Event::Change { key: "pf", value });
    }
    let remark = |all: &Together, key| all.page.remark(key).unwrap_or_default();
    assert_eq!(
        remark(&all, "pf"),
        "“First cells that are red” goes from 0.3 to 0.1: both are 1 at most."
    );
    assert_eq!(
        remark(&all, "pm"),
        "Was 0.3: it makes room for “First cells that are yellow”, as both are 1 at most."
    );
    assert_eq!(remark(&all, "df"), "");
    all.hear(Event::Change { key: "df", value: 4.0 });
    assert_eq!([remark(&all, "pf"), remark(&all, "pm"), remark(&all, "df")], [""; 3]);
}

#[test]
fn only_the_choice_of_a_plant_makes_an_entry_of_the_browser() {
    let mut all = Together::open("#leaf?v=1&s=1&d=2");
    all.finish();
    all.hear(Event::Seek(4));
    all.rest();
    assert_eq!(all.pushed, [""; 0]);
    all.hear(Event::ChoosePlant("fruit".to_string()));
    all.finish();
    assert_eq!(all.pushed, ["fruit?v=1&s=1&d=3"]);
    all.hear(Event::Individual(5.0));
    all.finish();
    // The browser goes back to the entry before.
    all.hear(Event::OpenLink("#leaf?v=1&s=1&d=4".to_string()));
    all.finish();
    assert_eq!((all.page.scene().plant.key, all.drawn_day()), ("leaf", Some(4)));
    all.hear(Event::Undo);
    all.finish();
    assert_eq!(all.page.drawn().unwrap().individual, 5, "undo goes its own way");
    assert_eq!(all.pushed.len(), 1);
}

#[test]
fn the_notice_follows_the_growth() {
    let mut all = Together::open("#leaf?v=1&s=1&d=6");
    for day in 0..6 {
        all.work_until_grown(day);
        let cells = all.page.run().pedigree.cells();
        let notice = format!("Day 6 is growing: so far day {day}, {cells} cells");
        assert_eq!(all.page.notice(), notice);
    }
    all.finish();
    assert_eq!(all.page.notice(), "");
}

#[test]
fn a_recipe_that_is_changed_is_no_longer_that_of_the_figure() {
    let mut all = Together::open("#leaf?v=1&s=1&d=2");
    assert_eq!(all.page.source(), "made for tests");
    all.hear(Event::Change { key: "df", value: 4.0 });
    assert_eq!(all.page.source(), "after made for tests, 1 change");
    all.hear(Event::Undo);
    assert_eq!(all.page.source(), "made for tests");
}

#[test]
fn the_title_is_told_again_after_the_figures() {
    let mut all = Together::open("#leaf?v=1&s=1&d=2");
    all.finish();
    let effects = all.page.hear(Event::OpenLink("#figures".to_string()));
    all.take(effects);
    all.hear(Event::OpenLink("#leaf?v=1&s=1&d=2".to_string()));
    all.finish();
    assert_eq!(all.said.len(), 2);
    assert_eq!(all.said[0], all.said[1]);
}
