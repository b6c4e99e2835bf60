//! A flower opens under the day slider, and its cells go with the petals.

use crate::engines::Graphics;
use crate::page::{Page, Picture, keys};
use crate::sameness::native;

const LINK: &str = "lily?v=1&s=3&d=20";

/// Pixels of petals.
fn golden(picture: &Picture) -> usize {
    picture.rgb.iter().filter(|[r, g, b]| *r > 150 && *g > 90 && *b < *g - 60).count()
}

#[test]
fn a_lily_opens_as_its_days_are_pulled() {
    for graphics in [Graphics::WebGpu, Graphics::WebGl2] {
        let Some(page) = Page::open(graphics, &format!("#{LINK}")) else { return };
        let last = page.on_day(20);
        assert_eq!(last.fingerprint, native(LINK), "{graphics:?}");
        page.sharp();
        let open = page.picture();
        let shown = |day: u32| {
            page.drag_to_day(f64::from(day));
            page.on_day(day);
            page.sharp();
            page.picture()
        };
        let golden_on = [4, 10, 14].map(|day| golden(&shown(day)));
        let [young, bud, opening] = golden_on;
        assert!(young > 500 && bud > young, "the bud grows: {golden_on:?}");
        assert!(opening > bud && golden(&open) > 2 * bud, "it opens: {golden_on:?}");
        let again = open.difference(&shown(20));
        assert!(again < 0.2, "it is what it was: {again}");
        // Next to the middle of the stage a cell is found on the petals as they stand now.
        page.run("document.getElementById('stage').focus()");
        page.press(&[keys::ENTER]);
        page.wait_for("a clone", "return document.getElementById('clone').checkVisibility()");
        assert_eq!(page.complaints(), [""; 0]);
    }
}
