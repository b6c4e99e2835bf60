//! A clone in hand, without a mouse and with one, and the family map.

use crate::engines::Graphics;
use crate::page::{Page, Picture, keys};
use clonal_mosaic::plants::CLAN_PALETTE;

const LINK: &str = "#watermelon?v=1&s=1&d=4";

#[track_caller]
fn wait_for_card(page: &Page, is_there: bool) {
    let script = "return document.getElementById('clone').checkVisibility()";
    page.wait_for("the card", &format!("{script} === {is_there}"));
    page.ready();
}

#[test]
fn a_clone_is_taken_followed_and_let_go_by_keys() {
    let Some(page) = Page::open(Graphics::WebGpu, LINK) else { return };
    page.on_day(4);
    // With the ring of the focus, which keys make visible.
    page.run("document.getElementById('stage').focus()");
    page.press(&[keys::ESCAPE]);
    let plain = page.picture();
    page.press(&[keys::ENTER]);
    wait_for_card(&page, true);
    let title = page.text("clone-title");
    assert!(title.starts_with("Clone of cell ") || title.starts_with("Clan of first"), "{title}");
    assert!(page.link().contains("&cell="), "{}", page.link());
    assert!(page.text("live").contains(&title), "{}", page.text("live"));
    let lit = page.picture();
    assert!(plain.difference(&lit) > 4.0, "{}", plain.difference(&lit));

    page.click("clan");
    page.wait_for(
        "the clan",
        "return /^Clan/.test(document.getElementById('clone-title').textContent)",
    );
    page.ready();
    let early = page.text("clone-size");
    assert!(early.starts_with("Day 4: "), "{early}");
    page.drag_to_day(18.0);
    page.on_day(18);
    let late = page.text("clone-size");
    assert!(late.starts_with("Day 18: ") && late[8..] != early[7..], "{early} {late}");
    let day = page.run("return document.getElementById('clone-days').children[18].textContent");
    assert!(late.starts_with(day.as_str().unwrap()), "{day} in the list, {late}");
    // Back from another page.
    let link = page.link();
    page.visit(&format!("#{link}"));
    page.on_day(18);
    assert_eq!(page.text("clone-size"), late);
    assert_eq!(page.link(), link);

    page.run("document.getElementById('stage').focus()");
    page.drag_to_day(4.0);
    page.on_day(4);
    page.press(&[keys::ESCAPE]);
    wait_for_card(&page, false);
    assert!(!page.link().contains("cell="), "{}", page.link());
    let again = page.picture();
    assert!(plain.difference(&again) < 0.1, "{}", plain.difference(&again));
    assert_eq!(page.complaints(), [""; 0]);
}

#[test]
fn a_click_takes_and_a_second_one_lets_go() {
    let Some(page) = Page::open(Graphics::WebGpu, LINK) else { return };
    page.on_day(4);
    page.click("stage");
    wait_for_card(&page, true);
    let link = page.link();
    assert!(!link.contains("view="), "nothing turned: {link}");
    // A drag is no click.
    page.drag("#stage", 60, 0);
    page.wait_for("the turn", "return location.hash.includes('view=')");
    wait_for_card(&page, true);
    page.press(&["0"]);
    page.wait_for("the turn back", "return !location.hash.includes('view=')");
    page.click("stage");
    wait_for_card(&page, false);
    assert!(!page.link().contains("cell="), "{}", page.link());
}

#[test]
fn the_family_map_has_many_colours() {
    for graphics in [Graphics::WebGpu, Graphics::WebGl2] {
        let Some(page) = Page::open(graphics, &format!("{LINK}&show=clans&view=20,15,4")) else {
            return;
        };
        page.on_day(4);
        let seen = palette(&page.picture());
        assert!(seen >= 6, "{seen} colours of the palette are seen, {graphics:?}");
        page.run(
            "const show = document.getElementById('show'); show.value = 'cells';
             show.dispatchEvent(new Event('change', {bubbles: true}))",
        );
        page.wait_for("the cells", "return !location.hash.includes('show=')");
        page.ready();
        assert!(palette(&page.picture()) < 4, "a watermelon is green");
    }
}

/// How many hues of the palette are seen on a hundredth of a picture.
fn palette(picture: &Picture) -> usize {
    let hues = CLAN_PALETTE.map(|colour| hue_deg(colour).0);
    let mut seen = [0; CLAN_PALETTE.len()];
    for rgb in &picture.rgb {
        let (hue, chroma) = hue_deg(rgb.map(|c| f32::from(c) / 255.0));
        let turn = |other: f32| (hue - other + 540.0).rem_euclid(360.0) - 180.0;
        let near =
            (0..hues.len()).min_by(|a, b| turn(hues[*a]).abs().total_cmp(&turn(hues[*b]).abs()));
        if let Some(near) = near.filter(|near| chroma > 0.2 && turn(hues[*near]).abs() < 8.0) {
            seen[near] += 1;
        }
    }
    seen.iter().filter(|pixels| **pixels * 100 > picture.rgb.len()).count()
}

/// The hue of a colour in degrees, and its chroma.
fn hue_deg([r, g, b]: [f32; 3]) -> (f32, f32) {
    let (most, least) = (r.max(g).max(b), r.min(g).min(b));
    let chroma = most - least;
    let sixth = if chroma == 0.0 {
        0.0
    } else if most == r {
        ((g - b) / chroma).rem_euclid(6.0)
    } else if most == g {
        (b - r) / chroma + 2.0
    } else {
        (r - g) / chroma + 4.0
    };
    (60.0 * sixth, chroma)
}
