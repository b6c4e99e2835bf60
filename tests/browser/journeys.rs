//! What a visitor does: opens, chooses, scrubs, plays, asks for another individual, shares.

use crate::engines::Graphics;
use crate::page::Page;
use serde_json::json;

/// A plant and a day that are there soon.
const SOON: &str = "#watermelon?v=1&s=1&d=4";

#[test]
fn without_a_link_the_page_opens_on_the_croton() {
    let Some(page) = Page::open(Graphics::WebGpu, "") else { return };
    let first = page.wait("the first cells", |s| !s.fingerprint.is_empty());
    assert_eq!((first.plant.as_str(), first.backend.as_str()), ("croton", "webgpu"));
    let rest = page.ready();
    assert_eq!(rest.fingerprint.len(), 6);
    assert!(rest.cells.parse::<u32>().unwrap() > 1000);
    assert!(page.link().starts_with("croton?v=2&s="), "the address is a link: {}", page.link());
    // Plain words, for those who see and for those who hear the page.
    assert_eq!(page.text("name"), "Croton");
    assert_eq!(page.text("fact-fingerprint"), rest.fingerprint);
    let said = page.text("live").to_lowercase();
    for part in ["croton", "individual", "day", "cells", "% yellow"] {
        assert!(said.contains(part), "{part} is not in the live text: {said}");
    }
    assert!(page.picture().colours() > 500, "a plant is on the canvas");
    assert_eq!(page.messages(), "");
    assert_eq!(page.complaints(), [""; 0]);
}

#[test]
fn the_chooser_changes_the_plant() {
    let Some(page) = Page::open(Graphics::WebGpu, SOON) else { return };
    page.ready();
    for plant in ["mushroom", "cactus", "watermelon", "philodendron", "croton"] {
        page.choose(plant);
        let state = page.wait(plant, |s| s.plant == plant && !s.fingerprint.is_empty());
        assert_ne!(state.state, "error");
        page.wait_for(
            "the link to follow",
            &format!("return location.hash.startsWith('#{plant}?')"),
        );
    }
    assert_eq!(page.complaints(), [""; 0]);
}

#[test]
fn a_plant_is_found_by_its_names() {
    let Some(page) = Page::open(Graphics::Neither, SOON) else { return };
    page.ready();
    let seen = |text: &str| {
        page.run(&format!(
            "const search = document.getElementById('find');
             search.value = '{text}';
             search.dispatchEvent(new Event('input'));
             return [...document.getElementById('plants').children]
                 .filter(item => item.checkVisibility()).map(item => item.innerText.trim()).join()"
        ))
    };
    assert_eq!(seen("MOON "), "Not structured,Moon and Stars");
    assert_eq!(seen("fittonia"), "Led by veins,Nerve plant");
    let none = seen("nettle");
    assert_eq!((none, page.text("not-found")), ("".into(), "No plant is called that.".into()));
    let all = seen("");
    assert!(all.as_str().unwrap().split(',').count() >= 25, "{all}");
    assert_eq!(page.text("not-found"), "");
}

#[test]
fn the_slider_goes_both_ways() {
    let Some(page) = Page::open(Graphics::WebGpu, SOON) else { return };
    let fourth = page.on_day(4);
    page.drag_to_day(2.0);
    let second = page.on_day(2);
    assert_ne!(second.fingerprint, fourth.fingerprint);
    page.drag_to_day(7.0);
    let seventh = page.on_day(7);
    assert!(seventh.cells.parse::<u32>().unwrap() > fourth.cells.parse().unwrap());
    page.drag_to_day(4.0);
    assert_eq!(page.on_day(4), fourth, "the day is what it was");
    page.wait_for("the link to follow", "return location.hash.includes('d=4')");
    for (button, day) in [("back", 3), ("on", 4), ("first", 0)] {
        page.click(button);
        page.on_day(day);
    }
    page.fill_in("day-number", "6");
    page.on_day(6);
}

#[test]
fn between_two_days_the_slider_rests_on_a_day() {
    let Some(page) = Page::open(Graphics::WebGpu, SOON) else { return };
    page.on_day(4);
    page.drag_to_day(2.4);
    let day = page.ready().day;
    assert!(day == "2" || day == "3", "day {day}");
}

#[test]
fn play_goes_on_and_pause_stops() {
    let Some(page) = Page::open(Graphics::WebGpu, SOON) else { return };
    page.on_day(4);
    page.click("first");
    page.on_day(0);
    page.click("play");
    page.wait("some days to pass", |s| s.day.parse::<u32>().is_ok_and(|day| day >= 2));
    page.click("play");
    let paused = page.ready();
    std::thread::sleep(std::time::Duration::from_millis(1500));
    assert_eq!(page.ready(), paused, "the time stands still");
}

#[test]
fn another_individual_is_another() {
    let Some(page) = Page::open(Graphics::WebGpu, SOON) else { return };
    let first = page.on_day(4);
    page.click("another");
    let other = page.wait("another one", |s| s.individual != "1" && s.state == "ready");
    assert_ne!(other.fingerprint, first.fingerprint);
    for number in ["42", "0", "4294967295"] {
        page.fill_in("individual", number);
        page.wait("the typed one", |s| s.individual == number && s.state == "ready");
        assert!(page.link().contains(&format!("s={number}&")), "{}", page.link());
    }
    page.fill_in("individual", "1");
    let again = page.wait("the first one", |s| s.individual == "1" && s.state == "ready");
    assert_eq!((again.day, again.fingerprint), (first.day, first.fingerprint));
    page.click("undo");
    page.wait("the one before", |s| s.individual == "4294967295" && s.state == "ready");
}

#[test]
fn what_cannot_be_is_told_at_its_field() {
    let Some(page) = Page::open(Graphics::Neither, SOON) else { return };
    let before = page.on_day(4);
    page.run("document.querySelector('details.recipe').open = true");
    let told = |css: &str| {
        let script = format!("return document.querySelector('{css}').innerText");
        page.run(&script).as_str().unwrap_or_default().to_string()
    };
    let is_marked = |css: &str| {
        page.run(&format!("return document.querySelector('{css}').ariaInvalid")) == "true"
    };
    // The first number of the recipe, the one of the first cells.
    let (field, reason) = (".parameter input[inputmode]", ".parameter .refusal");
    assert!(told(reason).is_empty() && !is_marked(field));
    for text in ["-5", "1e30", "e"] {
        page.run(&format!("document.querySelector('{field}').id = 'first-number'"));
        page.fill_in("first-number", text);
        assert!(
            told(reason).starts_with("Not taken: it must be from "),
            "{text}: {}",
            told(reason)
        );
        assert!(is_marked(field));
    }
    for text in ["7.5", "99999999999"] {
        page.fill_in("individual", text);
        assert!(told("#individual-refusal").contains("a whole number from 0 to 4294967295"));
        assert!(is_marked("#individual") && told(reason).is_empty());
    }
    assert_eq!(page.state(), before);
    page.fill_in("individual", "8");
    page.wait("the typed one", |s| s.individual == "8" && s.state == "ready");
    assert!(told("#individual-refusal").is_empty() && !is_marked("#individual"));
}

#[test]
fn a_copied_link_shows_the_same_cells() {
    let Some(page) = Page::open(Graphics::WebGpu, "#watermelon?v=1&s=9&d=3&ff=0.3") else { return };
    let here = page.on_day(3);
    page.run("navigator.clipboard.writeText = text => { window.copied = text; return Promise.resolve() }");
    page.click("copy-link");
    page.wait_for("the copy", "return !!window.copied");
    let copied = page.run("return window.copied");
    let (address, link) = copied.as_str().unwrap().split_once('#').unwrap();
    assert_eq!(address, page.server.address());
    assert_eq!(link, "watermelon?v=1&s=9&d=3&ff=0.3");
    page.visit(&format!("#{link}"));
    assert_eq!(page.on_day(3), here);
}

#[test]
fn a_bad_link_loads_what_it_can_and_says_what_it_left_out() {
    let link = "#watermelon?v=1&s=5&d=2&zz=1&df=bad";
    let Some(page) = Page::open(Graphics::WebGpu, link) else { return };
    let state = page.ready();
    assert_eq!(
        (state.plant.as_str(), state.individual.as_str(), state.day.as_str()),
        ("watermelon", "5", "2")
    );
    let told = page.messages();
    assert!(told.contains("zz=1") && told.contains("df=bad"), "{told}");
    page.click("dismiss");
    assert_eq!(page.messages(), "");
    // A link of another world, typed into the address of the open page.
    page.run("location.hash = '#oak?v=1&s=3'");
    page.wait("the first plant to stand in", |s| s.plant == "croton" && s.individual == "3");
    assert!(page.messages().contains("oak"), "{}", page.messages());
}

#[test]
fn the_panel_has_the_parameters_of_the_plant_and_the_clock_is_chosen_by_name() {
    let Some(page) = Page::open(Graphics::Neither, "#sansevieria?v=1&s=1&d=1") else { return };
    let before = page.on_day(1);
    page.run("document.querySelector('details.recipe').open = true");
    let shows = |key: &str| {
        page.run(&format!("return document.getElementById('parameter-{key}').checkVisibility()"))
    };
    let shown = || ["ck", "pm", "mbm", "an"].map(|key| shows(key) == true);
    assert_eq!(shown(), [true, true, true, false]);
    let choose = |clock: u32| {
        page.run(&format!(
            "const s = document.getElementById('parameter-ck'); s.selectedIndex = {clock};
             s.dispatchEvent(new Event('change'))"
        ))
    };
    choose(1);
    page.wait_for("the link to follow", "return location.hash.endsWith('d=1&ck=1')");
    page.wait("other cells", |s| s.state == "ready" && s.fingerprint != before.fingerprint);
    choose(0);
    page.wait_for("the link to follow", "return location.hash.endsWith('s=1&d=1')");
    assert_eq!(page.ready().fingerprint, before.fingerprint);
    page.visit("#philodendron?v=1&s=1&d=0&ck=1");
    page.ready();
    page.run("document.querySelector('details.recipe').open = true");
    assert_eq!(shown(), [true, false, false, true]);
    assert_eq!(page.run("return document.getElementById('parameter-ck').selectedIndex"), 1);
    assert_eq!(page.complaints(), [""; 0]);
}

#[test]
fn a_page_at_rest_draws_nothing() {
    let Some(page) = Page::start(Graphics::WebGpu) else { return };
    page.count_frames();
    page.visit(SOON);
    page.ready();
    let at_rest = page.rest();
    page.click("on");
    page.on_day(5);
    assert!(page.rest() > at_rest);
}

#[test]
fn growing_does_not_fill_the_history() {
    let Some(page) = Page::open(Graphics::WebGpu, SOON) else { return };
    page.ready();
    let before = page.run("return history.length");
    page.drag_to_day(2.0);
    page.on_day(2);
    page.click("another");
    page.wait("another one", |s| s.individual != "1" && s.state == "ready");
    assert_eq!(page.run("return history.length"), before);
}

/// Notes the share of its pixels along each side that the first live picture is drawn with.
const FIRST_SHARE: &str = "new MutationObserver((_, watcher) => {
    if (!document.querySelector('#stage[data-live]')) return;
    watcher.disconnect();
    const canvas = document.getElementById('canvas');
    window.first_share = canvas.width / (canvas.clientWidth * devicePixelRatio);
}).observe(document, {subtree: true, attributeFilter: ['data-live']})";

#[test]
fn software_shows_its_first_picture_with_few_pixels_and_rests_with_all() {
    for graphics in [Graphics::WebGpu, Graphics::WebGl2] {
        let Some(page) = Page::start(graphics) else { return };
        page.devtools("Page.addScriptToEvaluateOnNewDocument", json!({ "source": FIRST_SHARE }));
        page.visit(SOON);
        page.on_day(4);
        page.picture();
        let share = page.run("return window.first_share").as_f64().expect("a number");
        assert!((0.3..0.4).contains(&share), "a third along each side, not {share}");
        let sharp = "const canvas = document.getElementById('canvas');
            return canvas.width > 0.99 * canvas.clientWidth * devicePixelRatio";
        assert_eq!(page.run(sharp), true);
    }
}

#[test]
fn a_slow_device_turns_a_coarser_picture_and_rests_on_a_sharp_one() {
    let Some(page) = Page::start(Graphics::WebGpu) else { return };
    // Frames come no sooner than after 100 ms, and of what draws them nothing is known.
    let slow = "const info = window.GPUAdapterInfo?.prototype;
        if (info) Object.defineProperty(info, 'isFallbackAdapter', {value: false});
        const ask = window.requestAnimationFrame.bind(window);
        window.requestAnimationFrame = callback => setTimeout(() => ask(callback), 100)";
    page.devtools("Page.addScriptToEvaluateOnNewDocument", json!({ "source": slow }));
    page.devtools("Page.addScriptToEvaluateOnNewDocument", json!({ "source": FIRST_SHARE }));
    page.visit(SOON);
    let before = page.on_day(4);
    let picture = page.picture();
    let is_coarse = "const canvas = document.getElementById('canvas');
        return canvas.width < 0.8 * canvas.clientWidth * devicePixelRatio";
    assert_eq!(page.run(is_coarse), false);
    assert_eq!(page.run("return window.first_share > 0.99"), true);
    page.run(
        "const key = new KeyboardEvent('keydown', {key: 'ArrowRight', bubbles: true});
         const stage = document.getElementById('stage');
         window.turning = setInterval(() => stage.dispatchEvent(key), 50)",
    );
    page.wait_for("fewer pixels", is_coarse);
    page.wait("the plant to be what it was", |s| *s == before);
    page.run("clearInterval(window.turning)");
    assert!(page.picture().difference(&picture) > 1.0, "the plant has turned");
    assert_eq!(page.complaints(), [""; 0]);
}
