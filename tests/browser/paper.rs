//! The page on paper, in the visitor's own colours, and with nothing on the stage.

use crate::engines::Graphics;
use crate::page::Page;
use serde_json::json;

const SOON: &str = "#watermelon?v=1&s=1&d=4";

fn prints_picture_numbers_and_link(graphics: Graphics) {
    let Some(page) = Page::open(graphics, SOON) else { return };
    page.on_day(4);
    let pdf = page.devtools("Page.printToPDF", json!({ "printBackground": false }));
    // Most of it is the picture.
    assert!(pdf["data"].as_str().unwrap().len() > 100_000, "a page without a picture");
    let colours = page.run(
        "const canvas = document.getElementById('printed');
         const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
         const colours = new Set();
         for (let k = 0; k < data.length; k += 4) if (data[k + 3]) colours.add(data[k] << 16 | data[k + 1] << 8 | data[k + 2]);
         return colours.size",
    );
    assert!(colours.as_u64().unwrap() > 500, "{colours} colours");
    page.devtools("Emulation.setEmulatedMedia", json!({ "media": "print" }));
    let seen = |id: &str| {
        page.run(&format!("return document.getElementById('{id}').checkVisibility()")) == true
    };
    for id in ["printed", "name", "fact-cells", "fact-area", "printed-numbers", "printed-link"] {
        assert!(seen(id), "#{id} is printed");
    }
    for id in ["panel", "play", "canvas", "copy-link"] {
        assert!(!seen(id), "#{id} is not");
    }
    assert!(page.text("printed-link").ends_with(SOON), "{}", page.text("printed-link"));
    page.devtools("Emulation.setEmulatedMedia", json!({ "media": "" }));
    assert!(page.picture().colours() > 500, "the stage is as it was");
    assert_eq!(page.complaints(), [""; 0]);
}

#[test]
fn picture_numbers_and_link_are_printed_with_webgpu() {
    prints_picture_numbers_and_link(Graphics::WebGpu);
}

#[test]
fn picture_numbers_and_link_are_printed_with_webgl2() {
    prints_picture_numbers_and_link(Graphics::WebGl2);
}

#[test]
fn in_forced_colours_the_time_line_is_seen() {
    let Some(page) = Page::open(Graphics::Neither, SOON) else { return };
    page.on_day(4);
    page.devtools(
        "Emulation.setEmulatedMedia",
        json!({ "features": [{ "name": "forced-colors", "value": "active" }] }),
    );
    let colour =
        |element: &str| page.run(&format!("return getComputedStyle({element}).backgroundColor"));
    let track = colour("document.getElementById('grown')");
    assert_ne!(track, colour("document.querySelector('.timeline')"), "the track on its ground");
    assert_ne!(track, "rgba(0, 0, 0, 0)");
}

#[test]
fn the_wheel_goes_to_the_plant_and_an_empty_stage_offers_to_frame_it() {
    let Some(page) = Page::open(Graphics::WebGpu, "#cactus?v=1&s=1&d=2") else { return };
    page.on_day(2);
    let is_empty = "return document.getElementById('stage').hasAttribute('data-empty')";
    page.run(
        "const stage = document.getElementById('stage'), b = stage.getBoundingClientRect();
         for (let k = 0; k < 14; k++) stage.dispatchEvent(new WheelEvent('wheel',
             {deltaY: -100, clientX: b.left + 20, clientY: b.top + 20, bubbles: true, cancelable: true}))",
    );
    page.wait_for("the zoom", "return location.hash.includes('view=')");
    page.ready();
    assert_eq!(page.run(is_empty), false);
    page.visit("#cactus?v=1&s=1&d=2&view=0,14,30,1.1,0.3");
    page.on_day(2);
    page.wait_for("an empty stage", is_empty);
    let offer = page.run("return document.getElementById('framing').innerText");
    assert_eq!(offer, "Frame the plant again");
    page.click("framing");
    page.wait_for(
        "the plant",
        "return !document.getElementById('stage').hasAttribute('data-empty')",
    );
    assert_eq!(page.run("return document.getElementById('framing').innerText"), "");
}
