//! The page in a frame with a `sandbox`, as learning platforms embed it: there it is a stranger to every
//! host, to its own too.

use crate::engines::Graphics;
use crate::page::Page;
use crate::sameness::native;
use crate::server::{Server, dist};
use serde_json::json;
use std::time::Duration;

const LINK: &str = "watermelon?v=1&s=17&d=8";
/// Lets pages of any origin read what a host has.
const CORS: &str = "Access-Control-Allow-Origin: *\r\n";

#[test]
fn a_locked_frame_grows_where_the_host_lets_it_read() {
    for graphics in [Graphics::WebGpu, Graphics::WebGl2] {
        let Some(page) = Page::start(graphics) else { return };
        let server = Server::with_headers(&dist(), CORS);
        page.go_to_frame(&format!("{}#{LINK}", server.address()), "allow-scripts");
        assert_eq!(page.ready().fingerprint, native(LINK), "{graphics:?}");
        assert_eq!(page.run("return self.origin"), "null", "the frame is locked");
        assert_eq!(page.messages(), "");
        assert!(page.picture().colours() > 100, "it is drawn");
        assert_eq!(page.warnings(), [""; 0]);
        // Storage throws there: the choice of light or dark is for this visit only.
        page.click("theme");
        page.wait_for("another theme", "return !!document.documentElement.dataset.theme");
        page.click("another");
        page.wait("another one", |s| s.state == "ready" && s.individual != "17");
    }
}

#[test]
fn a_locked_frame_of_a_host_that_refuses_says_so_and_leads_out() {
    let Some(page) = Page::start(Graphics::WebGpu) else { return };
    page.go_to_frame(&format!("{}#{LINK}", page.server.address()), "allow-scripts allow-popups");
    says_that_nothing_starts(&page);
}

#[test]
fn a_folder_on_a_disk_says_that_nothing_starts() {
    let Some(page) = Page::start(Graphics::WebGpu) else { return };
    page.go(&format!("file://{}/index.html", dist().display()));
    says_that_nothing_starts(&page);
}

/// No script of ours runs: after a while a still plant is seen, a sentence and a link.
#[track_caller]
fn says_that_nothing_starts(page: &Page) {
    let styled = "return getComputedStyle(document.querySelector('.masthead')).display === 'flex'";
    page.wait_for("the style", styled);
    page.wait_for(
        "the sentence",
        "return document.querySelector('#stuck p').checkVisibility({visibilityProperty: true})",
    );
    page.wait_for(
        "the still plant",
        "return document.querySelector('#stuck img').naturalWidth > 100",
    );
    let told = page.text("stuck");
    assert!(told.contains("still picture") && told.contains("its own window"), "{told}");
    let on_top =
        "const a = document.querySelector('#stuck a'); const b = a.getBoundingClientRect();
                  return document.elementFromPoint(b.left + 5, b.top + 5) === a";
    assert_eq!(page.run(on_top), true, "the link can be clicked");
}

/// What the sentence needs is asked for after six seconds, which a very busy machine may take to start.
#[test]
fn a_page_that_starts_does_not_speak_of_it() {
    let mut asked = Vec::new();
    for _ in 0..3 {
        let Some(page) = Page::open(Graphics::Neither, &format!("#{LINK}")) else { return };
        page.ready();
        assert_eq!(page.run("return document.getElementById('stuck')"), serde_json::Value::Null);
        asked = page.server.requested();
        if !asked.iter().any(|name| name == "posters/croton.avif") {
            return;
        }
    }
    panic!("{asked:?}");
}

/// Turns a wheel, or presses a mouse button, over a place of the window.
fn mouse(page: &Page, kind: &str, [x, y]: [i32; 2], modifiers: u32) {
    page.devtools(
        "Input.dispatchMouseEvent",
        json!({
            "type": kind, "x": x, "y": y, "deltaX": 0, "deltaY": 120, "button": "left", "clickCount": 1,
            "modifiers": modifiers,
        }),
    );
}

#[test]
fn a_page_around_it_talks_with_the_plant_and_scrolls_over_it() {
    let Some(page) = Page::start(Graphics::Neither) else { return };
    page.count_frames();
    let address = format!("{}#{LINK}~ui=play", page.server.address());
    page.go_to_host(&format!(
        "<!doctype html><link rel=icon href=data:><body style='margin:0'>
         <iframe src='{address}' width=900 height=500></iframe><div style='height:3000px'></div>
         <script>told = []; addEventListener('message', event => told.push(event.data))
                 say = message => frames[0].postMessage(message, '*')</script>"
    ));
    let told = |link: &str, day: u32| {
        let last = "const last = told.at(-1)";
        page.wait_for(
            &format!("{link}, day {day}"),
            &format!("{last}; return last?.link === '{link}' && last.day === {day}"),
        );
        let told = page.run(&format!("{last}; return last"));
        let cells = told["cells"].as_u64().expect("a number");
        assert_eq!(
            told,
            json!({
                "mosaic": 1, "link": link, "day": day, "cells": cells, "fingerprint": native(link),
                "state": "ready",
            })
        );
        assert!(cells > 100, "{cells}");
    };
    told(LINK, 8);
    page.run("say({mosaic: 1, day: 5})");
    told("watermelon?v=1&s=17&d=5", 5);
    for stranger in ["{mosaic: 2, day: 1}", "'day'", "null", "{day: 1}", "{mosaic: 1, day: 'x'}"] {
        page.run(&format!("say({stranger})"));
    }
    page.run("say({mosaic: 1, link: '#mushroom?v=1&s=2&d=1'})");
    told("mushroom?v=1&s=2&d=1", 1);
    assert_eq!(
        page.run("return history.length"),
        page.in_frame(|| page.run("return history.length"))
    );

    // The wheel is the host's, but with Ctrl or once the plant was clicked.
    let scrolled = || page.run("return scrollY").as_f64().expect("a number");
    let middle = [450, 200];
    mouse(&page, "mouseWheel", middle, 0);
    page.wait_for("the host to scroll", "return scrollY > 50");
    let zoomed = |is_so: bool| {
        page.in_frame(|| {
            page.wait_for("a zoom", &format!("return location.hash.includes('view=') === {is_so}"));
        });
    };
    zoomed(false);
    page.run("scrollTo(0, 0)");
    mouse(&page, "mouseWheel", middle, 2);
    zoomed(true);
    page.in_frame(|| {
        page.run("document.querySelector('.framing').click()");
    });
    zoomed(false);
    let touch = "return getComputedStyle(document.getElementById('stage')).touchAction";
    assert_eq!(page.in_frame(|| page.run(touch)), "pan-y");
    mouse(&page, "mousePressed", middle, 0);
    mouse(&page, "mouseReleased", middle, 0);
    mouse(&page, "mouseWheel", middle, 0);
    zoomed(true);
    assert_eq!(scrolled(), 0.0);
    assert_eq!(page.in_frame(|| page.run(touch)), "none");
}

#[test]
fn off_screen_nothing_is_drawn() {
    let Some(page) = Page::start(Graphics::Neither) else { return };
    page.count_frames();
    let address = format!("{}#{LINK}~ui=none", page.server.address());
    page.go_to_host(&format!(
        "<!doctype html><link rel=icon href=data:><body style='margin:0'>
         <iframe src='{address}' width=600 height=400></iframe><div style='height:5000px'></div>
         <script>told = []; addEventListener('message', event => told.push(event.data))
                 say = message => frames[0].postMessage(message, '*')</script>"
    ));
    page.wait_for("the plant", "return told.at(-1)?.day === 8");
    page.run("scrollTo(0, 4000)");
    // An observer hears of it after a frame or two of the host's.
    std::thread::sleep(Duration::from_millis(500));
    let asked = || page.in_frame(|| page.run("return frames_asked"));
    let before = asked();
    page.run("say({mosaic: 1, day: 2})");
    std::thread::sleep(Duration::from_millis(1000));
    assert_eq!((asked(), page.run("return told.at(-1).day")), (before, json!(8)));
    page.run("scrollTo(0, 0)");
    page.wait_for("the day", "return told.at(-1).day === 2");
}

#[test]
fn a_frame_shows_as_much_of_the_page_as_it_asks_for() {
    let Some(page) = Page::start(Graphics::Neither) else { return };
    for (ui, seen, unseen) in [
        ("play", ["stage", "day", "play", "strip"], ["panel", "name", "last", "help"]),
        ("none", ["stage", "stage", "stage", "stage"], ["panel", "name", "day", "copy-link"]),
        ("full", ["stage", "day", "panel", "help"], ["welcome", "keys", "clone", "figures"]),
    ] {
        page.visit(&format!("#{LINK}~ui={ui}"));
        page.ready();
        let is_seen = |id: &str| {
            page.run(&format!("return document.getElementById('{id}').checkVisibility()"))
        };
        assert!(seen.iter().all(|id| is_seen(id) == true), "{ui}: {seen:?}");
        assert!(unseen.iter().all(|id| is_seen(id) == false), "{ui}: {unseen:?}");
        assert_eq!(page.run("return document.documentElement.hasAttribute('data-studio')"), false);
    }
    assert_eq!(page.complaints(), [""; 0]);
}
