//! The same page in the engines of all browsers: the journey of a first visit, the pixels, the figures.
//! Chromium is asked everything else too, in the other files; Firefox and WebKit are asked this.

use crate::engines::{Engine, Graphics};
use crate::figures::a_row_grows_and_opens;
use crate::page::{Page, keys};
use crate::pixels::{pixels_agree, tints_agree};
use crate::sameness::native;
use crate::views::views_agree;
use serde_json::json;

#[test]
fn chromium_takes_a_visitor_along() {
    first_visit(Engine::Chromium(Graphics::WebGpu));
}

#[test]
fn firefox_takes_a_visitor_along() {
    first_visit(Engine::Firefox);
}

#[test]
fn webkit_takes_a_visitor_along() {
    first_visit(Engine::WebKit);
}

#[test]
fn firefox_paints_the_voronoi_polygons_and_their_tints() {
    pixels_agree(Engine::Firefox);
    tints_agree(Engine::Firefox);
}

#[test]
fn webkit_paints_the_voronoi_polygons_and_their_tints() {
    pixels_agree(Engine::WebKit);
    tints_agree(Engine::WebKit);
}

#[test]
fn firefox_draws_what_leads_the_cells() {
    views_agree(Engine::Firefox);
}

#[test]
fn webkit_draws_what_leads_the_cells() {
    views_agree(Engine::WebKit);
}

#[test]
fn a_row_of_figures_grows_and_opens_with_firefox() {
    a_row_grows_and_opens(Engine::Firefox);
}

#[test]
fn a_row_of_figures_grows_and_opens_with_webkit() {
    a_row_grows_and_opens(Engine::WebKit);
}

fn first_visit(engine: Engine) {
    let Some(page) = Page::start(engine) else { return };
    let address = page.server.address();
    journey(&page, &address);
    what_is_set_survives_a_reload_or_starts_anew(&page);
    assert_eq!(page.state().backend, engine.backend());
}

/// What a visitor of the page at this address does first, and that all cells are those that grow
/// natively.
pub fn journey(page: &Page, address: &str) {
    const DAY: u32 = 4;
    page.go(&format!("{address}#mushroom?v=1&s=5&d={DAY}"));
    let opened = page.on_day(DAY);
    assert_eq!(opened.fingerprint, native(&page.link()), "the cells are those that grow natively");
    assert_eq!(page.text("fact-fingerprint"), opened.fingerprint);
    shows_a_mushroom(page);

    // By hand, and with a key.
    page.drag_to_day(2.0);
    assert_eq!(page.on_day(2).fingerprint, native(&page.link()));
    page.run("document.getElementById('day').focus()");
    page.press(&[keys::RIGHT]);
    assert_eq!(page.on_day(3).fingerprint, native(&page.link()));

    let before = page.picture();
    page.drag("#stage", 150, 40);
    page.wait_for("the view in the link", "return location.hash.includes('view=')");
    page.ready();
    assert!(page.picture().difference(&before) > 1.0, "the plant has turned");
    shows_a_mushroom(page);

    page.choose("cactus");
    page.wait("the cactus", |s| s.plant == "cactus" && s.state == "ready");
    page.click("another");
    let other = page.wait("another one", |s| s.individual != "1" && s.state == "ready");
    assert_eq!(other.fingerprint, native(&page.link()));

    page.run("navigator.clipboard.writeText = text => { window.copied = text; return Promise.resolve() }");
    page.click("copy-link");
    page.wait_for("the copy", "return !!window.copied");
    let copied = page.run("return window.copied");
    let copied = copied.as_str().expect("an address");
    assert!(copied.starts_with(address), "{copied}");
    page.go(copied);
    assert_eq!(page.ready(), other, "the link shows the same cells");
    assert_eq!(page.messages(), "");
    assert_eq!(page.complaints(), [""; 0]);
}

/// The canvas has the colours of a fly agaric: the red of its cap, the white of warts and stem, green.
fn shows_a_mushroom(page: &Page) {
    let picture = page.picture();
    let share = |is_so: fn([i32; 3]) -> bool| {
        let colours = picture.rgb.iter().map(|rgb| rgb.map(i32::from));
        colours.filter(|&rgb| is_so(rgb)).count() as f64 / picture.rgb.len() as f64
    };
    let red = share(|[r, g, b]| r > 120 && r > 2 * g && r > 2 * b);
    let green = share(|[r, g, b]| g > r + 15 && g > b + 15);
    assert!(red > 0.02 && green > 0.01, "{red} of the picture is red, {green} green");
    assert!(picture.colours() > 500, "light falls on it");
}

/// Some browsers fill in forms as they were before a reload: what they show must be what is so.
fn what_is_set_survives_a_reload_or_starts_anew(page: &Page) {
    page.click("loop");
    page.run(
        "const speed = document.getElementById('speed');
         speed.selectedIndex = speed.options.length - 1;
         speed.dispatchEvent(new Event('change', { bubbles: true }))",
    );
    let before = page.ready();
    page.run("window.is_old = true");
    // A reload by script: that of a driver may leave forms alone.
    page.run("setTimeout(() => location.reload())");
    page.wait_for(
        "the new page",
        "return !window.is_old && document.documentElement.dataset.state === 'ready'",
    );
    assert_eq!(page.state(), before, "the address tells it all");
    let shown = page.run(
        "const field = id => document.getElementById(id);
         return [field('loop').checked, field('speed').value, field('day').value,
                 field('day-number').value, field('individual').value]",
    );
    assert_eq!(shown, json!([false, "1", before.day, before.day, before.individual]));
}
