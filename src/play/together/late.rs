//! Answers that are under way when something else is wished: they are of a growth that nobody wants
//! any more.

use super::super::protocol::ToPage;
use super::*;

/// A plant of which so much is under way to the page, and another one that is wished meanwhile.
fn with_answers_under_way(fragment: &str, enough: impl Fn(&[ToPage]) -> bool) -> Together {
    let mut all = Together::open(fragment);
    let said = |all: &Together| -> Vec<ToPage> {
        all.mailbox.iter().map(|words| ToPage::from_words(words).unwrap()).collect()
    };
    while !enough(&said(&all)) {
        assert!(all.is_busy());
        all.grow();
    }
    all.hear(Event::Individual(2.0));
    all.deliver();
    all
}

/// The individual 2 is there with all its days, and as the model gives them.
fn is_the_second(all: &mut Together) {
    all.finish();
    assert_eq!((all.page.state(), all.page.run().end.clone()), (State::Ready, Some(End::Done)));
    assert_eq!(all.page.run().newest(), Some(6));
    for day in 0..=6 {
        let grown = fingerprint_of(&format!("#leaf?v=1&s=2&d={day}"));
        assert_eq!(all.page.run().facts(day).unwrap().fingerprint, grown, "day {day}");
    }
}

#[test]
fn late_days_are_not_taken_for_those_of_the_new_growth() {
    let days = |said: &[ToPage]| said.iter().filter(|s| matches!(s, ToPage::Day(_))).count();
    let mut all = with_answers_under_way("#leaf?v=1&s=1&d=6", |said| days(said) == 3);
    assert_eq!(all.page.run().newest(), None);
    is_the_second(&mut all);
}

#[test]
fn late_days_do_not_come_back_behind_the_figures() {
    let mut all = Together::open("#leaf?v=1&s=1&d=6");
    let is_day = |words: &Vec<u32>| matches!(ToPage::from_words(words), Ok(ToPage::Day(_)));
    while !all.mailbox.last().is_some_and(is_day) {
        all.grow();
    }
    let late = ToPage::from_words(all.mailbox.last().unwrap()).unwrap();
    all.hear(Event::OpenLink("#figures".to_string()));
    all.hear(Event::FromWorker(late));
    assert_eq!(all.page.run().newest(), None);
}

#[test]
fn a_late_end_does_not_end_the_new_growth() {
    let done = |said: &[ToPage]| matches!(said.last(), Some(ToPage::Done { .. }));
    let mut all = with_answers_under_way("#leaf?v=1&s=1&d=6", done);
    assert_eq!((all.page.run().end.clone(), all.page.run().last_day()), (None, 6));
    is_the_second(&mut all);
}

#[test]
fn late_refusals_and_full_populations_are_not_told() {
    for late in [
        ToPage::Full { generation: 1 },
        ToPage::Failed { generation: 1, text: "it cannot be".to_string() },
    ] {
        let mut all = Together::open("#leaf?v=1&s=1&d=6");
        all.work_until_grown(1);
        all.mailbox.push(late.to_words());
        all.hear(Event::Individual(2.0));
        all.deliver();
        assert_eq!((all.page.run().end.clone(), all.told.len()), (None, 0), "{late:?}");
        is_the_second(&mut all);
    }
}
