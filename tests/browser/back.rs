//! The browser's way back: from plant to plant, and to the place in the figures.

use crate::engines::Graphics;
use crate::page::Page;
use serde_json::json;

#[test]
fn back_and_forward_go_from_plant_to_plant() {
    let Some(page) = Page::open(Graphics::Neither, "#watermelon?v=1&s=1&d=4") else { return };
    page.on_day(4);
    page.drag_to_day(6.0);
    page.on_day(6);
    page.choose("cactus");
    page.wait("the cactus", |s| s.plant == "cactus" && s.state == "ready");
    page.choose("mushroom");
    page.wait("the mushroom", |s| s.plant == "mushroom" && s.state == "ready");
    page.run("history.back()");
    page.wait("the cactus", |s| s.plant == "cactus" && s.state == "ready");
    page.run("history.back()");
    page.wait("the melon", |s| s.plant == "watermelon" && s.state == "ready" && s.day == "6");
    page.run("history.forward()");
    page.wait("the cactus", |s| s.plant == "cactus" && s.state == "ready");
    page.click("undo");
    page.wait("the melon", |s| s.plant == "watermelon" && s.state == "ready");
}

#[test]
fn place_and_days_of_the_figures_come_back() {
    let Some(page) = Page::open(Graphics::WebGpu, "#figures") else { return };
    page.wait_for("the row", "return document.getElementById('figure-4.15') !== null");
    assert_eq!(page.run("return document.title"), "Figures · Clonal Mosaic");
    page.run("document.getElementById('figures').scrollTop = document.getElementById('figure-4.15').offsetTop - 60");
    page.run(
        "const day = document.querySelector('[id=\"figure-4.15\"] .days input');
         day.value = 3; day.dispatchEvent(new Event('input', {bubbles: true}))",
    );
    page.wait_for(
        "day 3",
        "return [...document.querySelectorAll('[id=\"figure-4.15\"] .told')].every(e => e.textContent.startsWith('Day 3: '))",
    );
    let place = page.run("return document.getElementById('figures').scrollTop");
    let is_back = format!(
        "const f = document.getElementById('figures');
         return !f.hidden && Math.abs(f.scrollTop - {place}) < 2
             && document.querySelector('[id=\"figure-4.15\"] .days input').value === '3'"
    );
    page.run("document.querySelector('[id=\"figure-4.15\"] .picture').click()");
    page.wait("the mushroom", |s| s.plant == "mushroom" && s.day == "3" && s.state == "ready");
    assert!(
        page.run("return document.title").as_str().unwrap().starts_with("Fly agaric"),
        "{}",
        page.run("return document.title")
    );
    page.run("history.back()");
    page.wait_for("the same place", &is_back);
    page.run("document.getElementById('from-figures').click()");
    page.wait("the mushroom", |s| s.plant == "mushroom" && s.state == "ready");
    page.click("to-figures");
    page.wait_for("the same place", &is_back);
    let numbers =
        page.run("return document.querySelector('[id=\"figure-4.15\"] .numbers').textContent");
    assert!(numbers.as_str().unwrap().contains("D_F 6 / 8 / 20 (red)"), "{numbers}");
}

#[test]
fn pictures_of_the_figures_are_called_by_the_day_that_they_show() {
    let Some(page) = Page::open(Graphics::WebGpu, "#figures/4.3") else { return };
    page.ready();
    page.run(
        "const day = document.querySelector('[id=\"figure-4.3\"] .days input');
         day.value = 9; day.dispatchEvent(new Event('input', {bubbles: true}))",
    );
    let labels = "return [...document.querySelectorAll('[id=\"figure-4.3\"] .label')].map(e => e.textContent)";
    page.wait_for("day 9", &format!("{labels}.includes('day 9 of 30')"));
    assert_eq!(page.run(labels), json!(["day 5", "day 9 of 15", "day 9 of 20", "day 9 of 30"]));
}
