//! A page for everybody: on a phone, by keyboard alone, with reduced motion.

use crate::engines::Graphics;
use crate::page::{Page, keys};
use serde_json::json;

const LINK: &str = "#watermelon?v=1&s=2&d=3";

/// The controls that nobody may miss.
const CONTROLS: [&str; 11] = [
    "day",
    "day-number",
    "play",
    "first",
    "last",
    "back",
    "on",
    "another",
    "individual",
    "show",
    "copy-link",
];

#[test]
fn nothing_is_out_of_reach_on_a_phone() {
    let Some(page) = Page::start(Graphics::WebGpu) else { return };
    for (width, height) in [(360, 740), (320, 568), (740, 360), (667, 375)] {
        page.devtools(
            "Emulation.setDeviceMetricsOverride",
            json!({ "width": width, "height": height, "deviceScaleFactor": 2, "mobile": true }),
        );
        page.visit(LINK);
        page.ready();
        let widest = page.run("return document.documentElement.scrollWidth");
        assert!(widest.as_i64().unwrap() <= width, "{width} wide, but {widest} are laid out");
        // On narrow screens some of them lie on a sheet that is drawn up first.
        let draw_up = "const handle = document.querySelector('.sheet-handle');
                       if (handle && handle.checkVisibility()) handle.click()";
        let canvas = "const b = document.getElementById('canvas').getBoundingClientRect();
                      return b.width >= 150 && b.height >= 150";
        assert_eq!(page.run(canvas), true, "the plant has room at {width} by {height}");
        page.run(draw_up);
        for id in CONTROLS {
            let script = format!(
                "const e = document.getElementById('{id}'); e.scrollIntoView({{block: 'center'}});
                 const b = e.getBoundingClientRect();
                 return e.checkVisibility() && b.left >= 0 && b.right <= innerWidth + 0.5
                     && b.width >= 24 && b.height >= 16"
            );
            assert_eq!(page.run(&script), true, "#{id} at {width} by {height}");
        }
    }
}

#[test]
fn the_keyboard_alone_is_enough() {
    let Some(page) = Page::open(Graphics::WebGpu, LINK) else { return };
    page.on_day(3);
    let focus = || page.run("return document.activeElement.id || document.activeElement.name");
    // Every control is reached by Tab, and one sees where one is.
    let mut reached = Vec::new();
    for _ in 0..80 {
        page.press(&[keys::TAB]);
        let id = focus().as_str().unwrap_or_default().to_string();
        let seen = "const s = getComputedStyle(document.activeElement);
                    return document.activeElement === document.body
                        || document.activeElement.matches(':focus-visible')
                        && (s.outlineStyle !== 'none' || s.boxShadow !== 'none'
                            || s.opacity === '0' || s.clipPath !== 'none')";
        assert_eq!(page.run(seen), true, "the focus on {id} cannot be seen");
        reached.push(id);
    }
    for id in CONTROLS.into_iter().chain(["stage"]) {
        assert!(reached.iter().any(|r| r == id), "#{id} is not reached: {reached:?}");
    }

    let focus_on = |id: &str| page.run(&format!("document.getElementById('{id}').focus()"));
    focus_on("day");
    page.press(&[keys::RIGHT]);
    page.on_day(4);
    page.press(&[keys::LEFT, keys::LEFT]);
    page.on_day(2);
    focus_on("on");
    page.press(&[keys::ENTER]);
    page.on_day(3);
    focus_on("first");
    page.press(&[keys::SPACE]);
    page.on_day(0);
    page.run("document.querySelector('#plants input:checked').focus()");
    page.press(&[keys::DOWN]);
    page.wait("the next plant", |s| s.plant != "watermelon" && !s.fingerprint.is_empty());
    // On the stage.
    let link = page.link();
    focus_on("stage");
    page.press(&[keys::RIGHT, keys::RIGHT]);
    page.wait_for("the view to turn", &format!("return location.hash !== '#{link}'"));
    assert!(page.link().contains("view="), "{}", page.link());
    page.press(&[keys::HOME]);
    page.on_day(0);
    page.press(&["."]);
    page.on_day(1);
    page.press(&["?"]);
    page.wait_for("the list of keys", "return document.getElementById('keys').open");
}

#[test]
fn every_control_has_a_name() {
    let Some(page) = Page::open(Graphics::Neither, LINK) else { return };
    page.ready();
    page.devtools("Accessibility.enable", json!({}));
    let tree = page.devtools("Accessibility.getFullAXTree", json!({}));
    let mut controls = 0;
    for node in tree["nodes"].as_array().unwrap().iter().filter(|n| n["ignored"] == false) {
        let role = node["role"]["value"].as_str().unwrap_or_default();
        if ["button", "slider", "spinbutton", "radio", "combobox", "checkbox", "link", "textbox"]
            .contains(&role)
        {
            controls += 1;
            let name = node["name"]["value"].as_str().unwrap_or_default();
            assert!(!name.trim().is_empty(), "a {role} has no name: {node}");
        }
    }
    assert!(controls > 15, "{controls} controls");
}

#[test]
fn less_motion_is_less_motion() {
    let Some(page) = Page::start(Graphics::WebGpu) else { return };
    page.devtools(
        "Emulation.setEmulatedMedia",
        json!({ "features": [{ "name": "prefers-reduced-motion", "value": "reduce" }] }),
    );
    page.visit(LINK);
    page.on_day(3);
    let moving = "return document.getAnimations().filter(a => a.playState === 'running').length";
    assert_eq!(page.run(moving), 0);
}
