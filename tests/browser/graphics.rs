//! What crosses to the graphics card, and what comes of a card that fails or is too small.

use crate::engines::Graphics;
use crate::page::Page;
use serde_json::json;

const SMALL: &str = "#watermelon?v=1&s=2&d=3";

/// Opens a link after a script has laid its hands on the graphics of the browser.
fn open_after(graphics: Graphics, script: &str, link: &str) -> Option<Page> {
    let page = Page::start(graphics)?;
    page.devtools("Page.addScriptToEvaluateOnNewDocument", json!({ "source": script }));
    page.visit(link);
    Some(page)
}

/// Keeps the devices that the page asks for; each but the first comes a second late.
const KEEP_DEVICES: &str = "window.devices = [];
    if (window.GPUAdapter) {
        const ask = GPUAdapter.prototype.requestDevice;
        GPUAdapter.prototype.requestDevice = async function (...a) {
            const device = await ask.apply(this, a);
            if (window.devices.push(device) > 1) await new Promise(go => setTimeout(go, 1000));
            return device
        }
    }";

#[test]
fn what_an_old_device_still_says_costs_the_new_one_nothing() {
    let Some(page) = open_after(Graphics::WebGpu, KEEP_DEVICES, SMALL) else { return };
    let before = page.ready();
    page.run(
        "window.canvases = [document.getElementById('canvas')];
         new MutationObserver(() => {
             const canvas = document.getElementById('canvas');
             if (canvas && !window.canvases.includes(canvas)) window.canvases.push(canvas)
         }).observe(document.getElementById('stage'), { childList: true, subtree: true });
         window.complain = () => {
             const error = new GPUValidationError('said late');
             const type = 'uncapturederror';
             window.devices[0].dispatchEvent(new GPUUncapturedErrorEvent(type, { error }))
         };
         window.devices[0].destroy()",
    );
    page.wait_for("another canvas", "return window.canvases.length === 2");
    // While the new device is on its way, and when it is there.
    page.run("for (let k = 0; k < 3; k++) window.complain()");
    page.wait_for("another device", "return window.devices.length === 2");
    page.run("for (let k = 0; k < 3; k++) window.complain()");
    page.wait("the plant to come back", |s| *s == before);
    page.run("for (let k = 0; k < 3; k++) window.complain()");
    std::thread::sleep(std::time::Duration::from_millis(1500));
    assert_eq!(page.state(), before);
    assert_eq!(page.run("return [window.canvases.length, window.devices.length]"), json!([2, 2]));
    assert_eq!(page.messages(), "");
}

#[test]
fn webgl2_contexts_that_are_lost_at_the_start_are_replaced() {
    let lose_two = "window.lost = 0;
        const get = HTMLCanvasElement.prototype.getContext;
        HTMLCanvasElement.prototype.getContext = function (kind, ...a) {
            const context = get.call(this, kind, ...a);
            if (kind === 'webgl2' && this.id === 'canvas' && !this.seen && window.lost < 2) {
                window.lost += 1;
                setTimeout(() => context.getExtension('WEBGL_lose_context').loseContext())
            }
            this.seen = true;
            return context
        }";
    let Some(page) = open_after(Graphics::WebGl2, lose_two, SMALL) else { return };
    page.wait_for("two losses", "return window.lost === 2");
    page.wait("the plant", |s| s.state == "ready" && s.backend == "webgl2");
    assert!(page.picture().colours() > 500, "a plant is on the canvas");
    assert_eq!(page.messages(), "");
}

#[test]
fn a_change_of_colours_uploads_nothing_but_numbers() {
    let count = "window.calls = { createBuffer: 0, writeTexture: 0, writeBuffer: 0 };
        for (const of of [window.GPUDevice, window.GPUQueue])
            for (const call of Object.keys(window.calls).filter(call => of?.prototype[call])) {
                const inner = of.prototype[call];
                of.prototype[call] = function (...a) {
                    window.calls[call] += 1;
                    return inner.apply(this, a)
                }
            }";
    let Some(page) = open_after(Graphics::WebGpu, count, SMALL) else { return };
    page.ready();
    let (plain, link) = (page.picture(), page.link());
    let before = page.run("return window.calls");
    assert!(before["createBuffer"].as_u64() > Some(0) && before["writeTexture"].as_u64() > Some(0));
    page.run(
        "const slider = document.querySelector('.parameter:has(#parameter-bo) input[type=range]');
         slider.value = slider.max;
         slider.dispatchEvent(new Event('input', { bubbles: true }))",
    );
    page.wait("the change", |s| s.state == "ready" && page.link() != link);
    let difference = page.picture().difference(&plain);
    assert!(difference > 0.5, "the borders are seen: {difference}");
    let after = page.run("return window.calls");
    for call in ["createBuffer", "writeTexture"] {
        assert_eq!(after[call], before[call], "{call}");
    }
    assert!(after["writeBuffer"].as_u64() > before["writeBuffer"].as_u64(), "{after}");
}

/// Makes devices as small as `window.most`, if that is set, and notes the rows of the largest texture
/// of data that is written.
const SMALL_DEVICE: &str = "if (window.GPUQueue) {
        const limits = GPUSupportedLimits.prototype;
        const { get } = Object.getOwnPropertyDescriptor(limits, 'maxTextureDimension2D');
        Object.defineProperty(limits, 'maxTextureDimension2D', {
            get() { return window.most ?? get.call(this) }
        });
        window.rows = 0;
        const write = GPUQueue.prototype.writeTexture;
        GPUQueue.prototype.writeTexture = function (target, bytes, layout, size) {
            const height = size.height ?? size[1] ?? 1;
            window.rows = Math.max(window.rows, (target.origin?.y ?? 0) + height);
            return write.call(this, target, bytes, layout, size)
        }
    }";

#[test]
fn a_plant_that_is_too_large_for_the_graphics_card_leaves_the_others_alone() {
    let Some(page) = open_after(Graphics::WebGpu, SMALL_DEVICE, "#croton?v=2&s=2") else { return };
    let small = page.ready();
    let rows = page.run("return window.rows");
    page.choose("watermelon");
    let large = page.wait("the watermelon", |s| s.plant == "watermelon" && s.state == "ready");
    let more = page.run("return window.rows");
    assert!(more.as_u64() > rows.as_u64(), "{more} rows of the watermelon, {rows} of the croton");

    page.choose("croton");
    page.wait("the croton", |s| *s == small);
    page.run(&format!("window.most = {rows}"));
    page.choose("watermelon");
    page.wait("the watermelon again", |s| s == &large);
    page.wait_for(
        "its poster",
        "const poster = document.getElementById('poster');
         return !document.getElementById('stage').hasAttribute('data-live')
             && poster.checkVisibility() && poster.src.includes('watermelon')",
    );
    assert!(page.messages().contains("cannot hold so many cells"), "{}", page.messages());

    page.choose("croton");
    page.wait("the croton", |s| *s == small);
    assert_eq!(small.backend, "webgpu");
    page.wait_for(
        "it to be live",
        "return document.getElementById('stage').hasAttribute('data-live')",
    );
    assert_eq!(page.messages(), "", "what was told is over");
}

#[test]
fn figures_that_are_too_large_for_the_graphics_card_keep_their_stills() {
    let script = format!("window.most = 1; {SMALL_DEVICE}");
    let Some(page) = open_after(Graphics::WebGpu, &script, "#figures/4.15") else { return };
    let state = page.ready();
    assert_eq!(state.backend, "webgpu");
    let all_stay = page.run(
        "const row = [...document.querySelectorAll('#figure-4\\\\.15 .picture')];
         return row.length > 0 && row.every(picture => !picture.hasAttribute('data-live')
             && picture.querySelector('.told').textContent.includes('a still picture'))",
    );
    assert_eq!(all_stay, true);
    assert_eq!(page.messages(), "");
}
