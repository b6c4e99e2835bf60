//! The first visit: the plant grows once, with a sentence.

use crate::engines::Graphics;
use crate::page::{Page, keys};
use serde_json::json;

/// Whether the sentence is seen.
fn greets(page: &Page) -> bool {
    page.run("return document.getElementById('welcome').checkVisibility()") == true
}

fn plays(page: &Page) -> bool {
    page.run("return document.getElementById('play').hasAttribute('data-playing')") == true
}

/// Waits until the plant plays under the sentence.
#[track_caller]
fn is_greeted(page: &Page) {
    page.wait("the second day", |s| s.day == "1" && s.state == "growing");
    assert!(greets(page) && plays(page));
    assert!(page.text("welcome").starts_with("Every patch is the family"));
    assert!(page.link().starts_with("croton?v=2&s=1&d=8"), "{}", page.link());
}

#[test]
fn who_has_never_been_here_sees_the_croton_grow_once() {
    let Some(page) = Page::open(Graphics::Neither, "") else { return };
    is_greeted(&page);
    page.press(&[keys::TAB]);
    let state = page.ready();
    assert!(!greets(&page) && !plays(&page));
    assert_eq!(page.link(), format!("croton?v=2&s=1&d={}", state.day), "it stops where it is");

    // Not a second time.
    page.visit("");
    let state = page.wait("some cells", |s| !s.day.is_empty());
    assert!(!greets(&page) && !plays(&page), "{state:?}");

    // Who comes by a link has been here.
    page.run("localStorage.clear()");
    page.visit("#watermelon?v=1&s=1&d=1");
    page.on_day(1);
    assert!(!greets(&page));
    page.visit("");
    page.wait("some cells", |s| !s.day.is_empty());
    assert!(!greets(&page) && !plays(&page));

    page.run("localStorage.clear()");
    page.devtools(
        "Emulation.setEmulatedMedia",
        json!({ "features": [{ "name": "prefers-reduced-motion", "value": "reduce" }] }),
    );
    page.visit("");
    page.wait("some cells", |s| !s.day.is_empty());
    assert!(!greets(&page) && !plays(&page));
    assert_eq!(page.complaints(), [""; 0]);
}

#[test]
fn where_nothing_can_be_kept_it_plays_at_each_visit_and_pauses_by_its_button() {
    let Some(page) = Page::start(Graphics::Neither) else { return };
    page.before_pages(
        "Object.defineProperty(window, 'localStorage', {get() { throw new DOMException('no', 'SecurityError') }})",
    );
    for _ in 0..2 {
        page.visit("");
        is_greeted(&page);
    }
    page.click("play");
    page.ready();
    assert!(!greets(&page) && !plays(&page));
}
