//! WebGPU, then WebGL2, then a still picture; and a graphics card that goes away.

use crate::engines::Graphics;
use crate::page::{Page, Picture, State};
use serde_json::json;

const LINK: &str = "#watermelon?v=1&s=2&d=3";

#[test]
fn webgpu_loads_no_webgl2() {
    let Some(page) = Page::open(Graphics::WebGpu, LINK) else { return };
    assert_eq!(page.ready().backend, "webgpu");
    let loaded = page.server.requested();
    assert!(!loaded.iter().any(|file| file.contains("page_gl")), "{loaded:?}");
    assert_eq!(page.complaints(), [""; 0]);
}

#[test]
fn without_webgpu_the_page_draws_the_same_with_webgl2() {
    let Some(page) = Page::open(Graphics::WebGl2, LINK) else { return };
    let with_webgl2 = page.ready();
    assert_eq!(with_webgl2.backend, "webgl2");
    assert!(page.server.requested().iter().any(|file| file.contains("page_gl")));
    let picture = page.picture();
    assert!(picture.colours() > 500, "a plant is on the canvas");
    assert_eq!(page.complaints(), [""; 0]);
    drop(page);

    let Some(page) = Page::open(Graphics::WebGpu, LINK) else { return };
    assert_eq!(page.ready().fingerprint, with_webgl2.fingerprint);
    let difference = page.picture().difference(&picture);
    assert!(difference < 2.0, "the pictures differ by {difference} of 255 in the mean");
}

#[test]
fn without_both_there_is_a_still_picture_and_plain_words() {
    let Some(page) = Page::open(Graphics::Neither, LINK) else { return };
    let state = page.ready();
    assert_eq!(state.backend, "none");
    assert_eq!(state.fingerprint.len(), 6, "the numbers are live all the same");
    let poster = "const p = document.getElementById('poster');
                  return p.checkVisibility() && p.complete && p.naturalWidth > 100
                      && p.src.includes('watermelon')";
    page.wait_for("the still picture", poster);
    let told = page.messages();
    assert!(told.contains("WebGPU") && told.contains("still picture"), "{told}");
    // The page works on.
    page.choose("cactus");
    page.wait("the cactus", |s| s.plant == "cactus" && !s.fingerprint.is_empty());
    assert!(page.messages().contains("still picture"), "it is one still");
    page.click("dismiss");
    page.choose("croton");
    page.wait("the croton", |s| s.plant == "croton" && !s.fingerprint.is_empty());
    assert!(!page.messages().contains("still picture"), "the visitor has read it");
    assert_eq!(page.complaints(), [""; 0]);
}

#[test]
fn the_poster_of_the_linked_plant_stands_there_before_the_page_has_come() {
    let Some(page) = Page::start(Graphics::Neither) else { return };
    // What the visitor sees while all but the HTML and the small first bundle is on its way.
    page.devtools("Network.enable", json!({}));
    page.devtools("Network.setBlockedURLs", json!({ "urls": ["*page*"] }));
    for (link, plant) in [("", "croton"), (LINK, "watermelon"), ("#figures", "croton")] {
        page.visit(link);
        let poster = format!(
            "const p = document.getElementById('poster');
             return p.checkVisibility() && p.complete && p.naturalWidth > 100
                 && p.src.includes('{plant}')"
        );
        let begun = std::time::Instant::now();
        while page.run(&poster) != true {
            assert!(begun.elapsed().as_secs() < 10, "no poster of the {plant}");
            std::thread::sleep(std::time::Duration::from_millis(50));
        }
        assert_eq!(page.run("return document.getElementById('stage').dataset.live"), json!(null));
    }
}

/// Opens a page that some files never reach, and waits until it says so.
fn open_without(files: &str) -> Option<Page> {
    let page = Page::start(Graphics::Neither)?;
    page.devtools("Network.enable", json!({}));
    page.devtools("Network.setBlockedURLs", json!({ "urls": [files] }));
    page.visit(LINK);
    let begun = std::time::Instant::now();
    while page.state().state != "error" {
        assert!(begun.elapsed().as_secs() < 20, "no error without {files}");
        std::thread::sleep(std::time::Duration::from_millis(50));
    }
    let poster = "const p = document.getElementById('poster');
                  return p.checkVisibility() && p.complete && p.naturalWidth > 100";
    assert_eq!(page.run(poster), true, "the still picture stays");
    Some(page)
}

#[test]
fn a_mesh_that_does_not_come_is_told() {
    let Some(page) = open_without("*meshes/*") else { return };
    let told = page.messages();
    assert!(told.contains("watermelon") && told.contains("could not be loaded"), "{told}");
}

#[test]
fn a_bundle_that_does_not_come_is_told() {
    for file in ["*/page.js*", "*/page_bg.wasm*"] {
        let Some(page) = open_without(file) else { return };
        let told = page.messages();
        assert!(told.contains("playground could not be loaded"), "{file}: {told}");
    }
}

#[test]
fn a_lost_webgpu_device_comes_back_with_the_same_picture() {
    let Some(page) = Page::start(Graphics::WebGpu) else { return };
    // Keeps the devices that the page asks for, to take them away later.
    let keep = "window.devices = [];
                if (window.GPUAdapter) {
                    const ask = GPUAdapter.prototype.requestDevice;
                    GPUAdapter.prototype.requestDevice = async function (...a) {
                        const device = await ask.apply(this, a);
                        window.devices.push(device);
                        return device
                    }
                }";
    page.devtools("Page.addScriptToEvaluateOnNewDocument", json!({ "source": keep }));
    page.visit(LINK);
    let before = page.ready();
    let picture = page.picture();
    lose_and_recover(&page, &before, &picture, "window.devices.at(-1).destroy()");
}

#[test]
fn a_lost_webgl2_context_comes_back_with_the_same_picture() {
    let Some(page) = Page::open(Graphics::WebGl2, LINK) else { return };
    let before = page.ready();
    let picture = page.picture();
    let lose = "const gl = document.getElementById('canvas').getContext('webgl2');
                gl.getExtension('WEBGL_lose_context').loseContext()";
    lose_and_recover(&page, &before, &picture, lose);
}

/// Takes the graphics away by a script: another canvas comes, with the same cells and picture.
fn lose_and_recover(page: &Page, before: &State, picture: &Picture, lose: &str) {
    page.run(&format!("window.old_canvas = document.getElementById('canvas'); {lose}"));
    let is_new = "return document.getElementById('canvas') !== window.old_canvas";
    page.wait_for("another canvas", is_new);
    page.wait("the plant to come back", |s| s == before);
    page.wait("the picture to be what it was", |_| page.picture().difference(picture) < 1.0);
    assert_eq!(page.messages(), "");
}
