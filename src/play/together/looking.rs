//! What only changes how the plant is looked at, and the address and the steps back that follow it.

use super::*;

fn turn(right_deg: f32) -> Event {
    Event::Turn { right_deg, up_deg: 0.0 }
}

/// A leaf on the day 2, at rest.
fn leaf() -> Together {
    let mut all = Together::open("#leaf?v=1&s=1&d=2");
    all.finish();
    all
}

#[test]
fn the_address_follows_when_the_camera_rests_and_turns_are_one_step() {
    let mut all = leaf();
    for _ in 0..3 {
        all.hear(turn(10.0));
        assert_eq!(all.links.len(), 1);
    }
    all.rest();
    assert_eq!(all.links.len(), 2);
    assert!(all.links[1].contains("view="), "{:?}", all.links);
    all.hear(turn(10.0));
    all.rest();
    all.hear(Event::Undo);
    all.rest();
    assert_eq!(all.links.last().unwrap(), "leaf?v=1&s=1&d=2");
    assert!(!all.page.history().can_undo());
}

#[test]
fn whoever_acts_while_a_step_back_is_under_way_goes_on_from_there() {
    let mut all = leaf();
    all.hear(turn(30.0));
    all.rest();
    for (step, act) in [(Event::Undo, turn(30.0)), (Event::Redo, turn(-30.0))] {
        // The turn takes the step back: the address stays, the way does not.
        all.hear(step);
        all.hear(act);
        all.rest();
        assert!(all.page.history().now() == all.page.scene());
        assert!(!all.page.history().can_redo());
        all.hear(Event::Undo);
        all.rest();
    }
}

#[test]
fn an_address_that_was_typed_becomes_the_one_that_was_understood() {
    let mut all = leaf();
    all.hear(Event::OpenLink("#leaf?v=1&s=1&d=2&zz=1".to_string()));
    assert_eq!(all.links, ["leaf?v=1&s=1&d=2"; 2]);
    assert!(!all.page.history().can_undo());
}

#[test]
fn another_plant_is_not_turned_to() {
    let mut all = leaf();
    all.hear(turn(30.0));
    assert!(!all.page.camera().at_rest());
    all.rest();
    all.hear(Event::ChoosePlant("fruit".to_string()));
    assert!(all.page.camera().at_rest());
}

#[test]
fn with_less_motion_nothing_moves() {
    let mut all = Together::open("#leaf?v=1&s=1&d=4");
    all.hear(Event::LessMotion(true));
    while all.drawn_day().is_none() {
        all.work();
    }
    assert_eq!((all.drawn_day(), all.page.is_moving()), (Some(4), false));
    all.work_until_day(4);
    assert_eq!((all.drawn_day(), all.page.state()), (Some(4), State::Ready));
    for _ in 0..2 {
        all.hear(turn(30.0));
    }
    all.hear(Event::Undo);
    assert_eq!(all.links.last().unwrap(), "leaf?v=1&s=1&d=4", "one step, as with motion");
    all.hear(Event::StepDays(-1));
    assert_eq!((all.drawn_day(), all.page.is_moving()), (Some(3), false));
    all.hear(Event::LessMotion(false));
    all.hear(turn(30.0));
    assert!(all.page.is_moving());
}

#[test]
fn a_lost_picture_is_no_picture() {
    let mut all = leaf();
    all.page.hear(Event::PictureLost);
    assert_eq!((all.page.state(), all.page.drawn()), (State::Loading, None));
    all.page.hear(Event::Drawn { sharp: true });
    assert_eq!(all.page.state(), State::Ready);
}

#[test]
fn the_end_of_growth_does_not_end_a_loop() {
    let mut all = Together::open("#leaf?v=1&s=1&d=5");
    all.work_until_day(6);
    all.rest();
    all.hear(Event::Loop(true));
    all.hear(Event::PlayOrPause);
    all.hear(Event::Tick(0.1));
    assert_eq!((all.page.playhead().wished_day(), all.page.run().end.clone()), (6, None));
    all.finish_growth();
    assert_eq!(all.page.run().end, Some(End::Done));
    assert!(all.page.playhead().is_playing());
}
