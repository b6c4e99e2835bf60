//! A row with a plant that has a file of its own.

use super::*;

#[test]
fn a_plant_that_only_the_row_shows_is_fetched_first() {
    let croton = crate::plants::find("croton").unwrap();
    let mine = Plant { name: "Mine", paint: &[], guides: None, ..croton.clone() };
    let (key, text) = crate::plants::to_text(&mine, SHEET);
    let key: &'static str = key.leak();
    let link = format!("{key}?v=2&s=1&d=2~leaf=lobes:7").leak();
    let pictures = vec![Picture { label: "", link }].leak();
    let row: &'static Figure = Box::leak(Box::new(Figure { pictures, ..ROW }));
    let file = format!("{key}.obj").leak();

    let mut gallery = Gallery::new(PLANTS, 1, Vec::new());
    gallery.hear(Event::FromWorker(0, Worker::hello()));
    assert_eq!(gallery.hear(Event::Open(row)), [(0, Effect::LoadMesh(key))]);
    let state = |gallery: &Gallery| gallery.row().unwrap().state(|_, _| true);
    assert_eq!(state(&gallery), State::Loading);
    assert_eq!(gallery.hear(Event::Mesh { name: key, text: Err("no connection".into()) }), []);
    assert!(gallery.row().unwrap().trouble.as_ref().unwrap().contains("no connection"));
    assert_eq!(state(&gallery), State::Error);
    assert_eq!(gallery.hear(Event::Day(1)), [(0, Effect::LoadMesh(key))], "it is tried again");
    assert_eq!(state(&gallery), State::Loading);

    // Then it is a plant as all others are, by its own name.
    let came = |name| Event::Mesh { name, text: Ok(text.clone()) };
    assert_eq!(gallery.hear(came(key)), [(0, Effect::LoadMesh(file))]);
    let effects = gallery.hear(came(file));
    assert!(matches!(effects[..], [(0, Effect::Post(_)), (0, Effect::Post(_))]), "{effects:?}");
    let opened = gallery.row().unwrap();
    assert_eq!((opened.day, opened.pictures[0].plant.name), (1, "Mine"));
    assert_eq!(opened.link(0), format!("{key}?v=2&s=1&d=1~leaf=lobes:7"));
}
