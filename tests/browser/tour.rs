//! The tour of the page, and the tone of the days.

use crate::engines::Graphics;
use crate::page::{Page, keys};

const LINK: &str = "#watermelon?v=1&s=2&d=3";

/// Waits until the card is at this step, with what it is about marked.
#[track_caller]
fn at_step(page: &Page, step: usize, marked: &str) {
    page.wait_for(
        &format!("step {step}"),
        &format!(
            "return document.querySelector('#tour-card:not([hidden]) .where')?.textContent === 'A tour, step {step} of 5'
                 && !!document.querySelector('{marked}[data-toured]')
                 && document.querySelectorAll('[data-toured]').length === 1
                 && document.activeElement.id === 'tour-card'"
        ),
    );
}

fn is_over(page: &Page) -> bool {
    page.run("return document.getElementById('tour-card').hidden && !document.querySelector('[data-toured]')") == true
}

#[test]
fn a_tour_leads_through_the_page_and_is_left_at_any_time() {
    let Some(page) = Page::open(Graphics::Neither, LINK) else { return };
    page.on_day(3);
    page.click("help");
    page.click("tour");
    let stops = ["#stage", ".timeline", ".individuals", ".recipe", "#copy-link"];
    for (k, stop) in stops.into_iter().enumerate() {
        at_step(&page, k + 1, stop);
        page.press(&[keys::TAB]);
        page.run("document.querySelector('#tour-card [data-by=\"1\"]').click()");
    }
    assert!(is_over(&page), "the last step ends it");
    assert_eq!(page.run("return document.activeElement.id"), "help");

    page.run("location.hash += '~lesson'");
    page.wait_for(
        "the lessons",
        "return !!document.querySelector('#lesson-view:not([hidden]) [data-take=tour]')",
    );
    page.run("document.querySelector('#lesson-view [data-take=tour]').click()");
    at_step(&page, 1, "#stage");
    assert!(!page.link().contains('~'), "{}", page.link());
    // What it shows can be used meanwhile.
    page.click("on");
    page.on_day(4);
    page.press(&[keys::ESCAPE]);
    assert!(is_over(&page));
    assert_eq!(page.complaints(), [""; 0]);
}

#[test]
fn days_sound_as_high_as_the_share_once_that_is_ticked() {
    let Some(page) = Page::start(Graphics::Neither) else { return };
    page.before_pages(
        "window.tones = []; const set = AudioParam.prototype.setValueAtTime;
         AudioParam.prototype.setValueAtTime = function (value, when) {
             window.tones.push(value); return set.call(this, value, when)
         }",
    );
    page.visit(LINK);
    page.on_day(3);
    page.click("charts");
    page.wait_for("the charts", "return !!document.getElementById('sound')");
    page.click("on");
    page.on_day(4);
    assert_eq!(page.run("return tones.length"), 0, "silent by itself");
    page.click("sound");
    page.drag_to_day(5.0);
    page.on_day(5);
    page.wait_for("a tone", "return tones.length > 1");
    let share = "const share = parseInt(document.getElementById('fact-share').textContent);
                 return Math.abs(tones.at(-1) - 220 * 4 ** (share / 100)) < 0.1";
    assert_eq!(page.run(share), true);
    page.click("sound");
    let before = page.run("return tones.length");
    page.drag_to_day(2.0);
    page.on_day(2);
    assert_eq!(page.run("return tones.length"), before);
    assert_eq!(page.complaints(), [""; 0]);
}
