//! The wished day comes before all others.

use super::*;

#[test]
fn a_link_is_opened_and_rests_on_its_day() {
    let mut all = Together::open("#leaf?v=1&s=17&d=4");
    assert_eq!(all.page.state(), State::Loading);
    while all.drawn_day().is_none() {
        assert_eq!(all.page.state(), State::Loading);
        all.work();
    }
    // The wished day comes first, whole, and then those before it.
    assert_eq!((all.page.state(), all.drawn_day()), (State::Ready, Some(4)));
    assert_eq!((all.page.run().newest(), all.page.run().grown()), (None, Some(4)));
    assert_eq!(all.page.notice(), "");
    all.work_until_day(3);
    assert_eq!((all.page.run().newest(), all.page.is_moving()), (Some(4), false));
    all.finish();
    assert_eq!((all.page.state(), all.drawn_day()), (State::Ready, Some(4)));
    assert_eq!(all.page.run().end, Some(End::Done));
    assert_eq!(all.fingerprint(), fingerprint_of("#leaf?v=1&s=17&d=4"));
    assert_eq!(all.links, ["leaf?v=1&s=17&d=4"]);
    assert_eq!(all.wishes, 1);
    let cells = all.page.run().facts(4).unwrap().count.cells;
    assert!(all.said.last().unwrap().starts_with("Leaf, individual 17, day 4: "));
    assert!(all.said.last().unwrap().contains(&crate::play::words::grouped(cells)));
}

#[test]
fn a_day_to_come_is_followed() {
    let mut all = Together::open("#leaf?v=1&s=1&d=1");
    all.work_until_day(2);
    all.rest();
    assert_eq!(all.page.state(), State::Ready);
    all.hear(Event::Seek(5));
    all.rest();
    assert_eq!((all.page.state(), all.drawn_day()), (State::Growing, Some(2)));
    while all.page.run().facts(5).is_none() {
        all.work();
    }
    assert_eq!((all.page.state(), all.drawn_day()), (State::Ready, Some(5)));
    // It is asked for before the others, which come after it.
    assert_eq!(all.page.run().newest(), Some(2));
    // One that has not come yet is shown as soon as it is there.
    all.hear(Event::Seek(4));
    all.rest();
    assert_eq!((all.page.state(), all.drawn_day()), (State::Growing, Some(2)));
    while all.page.run().facts(4).is_none() {
        all.work();
    }
    assert_eq!((all.page.state(), all.drawn_day()), (State::Ready, Some(4)));
    all.hear(Event::Seek(5));
    all.finish();
    assert_eq!((all.page.state(), all.drawn_day()), (State::Ready, Some(5)));
}
