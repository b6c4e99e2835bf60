//! The one camera of a row.

use super::*;

#[test]
fn what_turns_one_picture_turns_all_and_grows_nothing() {
    let mut all = Together::new(2);
    all.hear(Event::Open(&ROW));
    all.finish();
    let wishes = all.wishes.len();
    let orbits = |all: &Together| -> Vec<Orbit> {
        all.gallery.row().unwrap().pictures.iter().map(|scene| scene.orbit).collect()
    };
    let before = orbits(&all);
    all.hear(Event::Look { right_deg: 40.0, up_deg: -10.0, zoom: 2.0 });
    for (before, after) in before.iter().zip(orbits(&all)) {
        assert_eq!(after, before.turned(40.0, -10.0).zoomed(2.0, Vec2::ZERO));
    }
    let row = all.gallery.row().unwrap();
    assert!((0..3).all(|k| row.link(k).contains("view=")), "{}", row.link(0));
    assert!((0..3).all(|k| row.shown(k).is_some()));
    assert_eq!(all.wishes.len(), wishes);
}
