//! The page without a network, once it was seen with one: whole, and of one build.

use crate::engines::{Engine, Graphics};
use crate::page::Page;
use crate::sameness::native;
use crate::server::{Server, dist};
use clonal_mosaic::play::figures;
use serde_json::json;
use std::fs;
use std::path::{Path, PathBuf};

const LINK: &str = "mushroom?v=1&s=5&d=4";

#[test]
fn without_a_network_the_page_is_whole() {
    lives_without_a_network(Engine::Chromium(Graphics::WebGpu));
}

#[test]
fn without_a_network_the_page_is_whole_with_webgl2() {
    lives_without_a_network(Engine::Chromium(Graphics::WebGl2));
}

#[test]
fn without_a_network_the_page_is_whole_in_firefox() {
    lives_without_a_network(Engine::Firefox);
}

#[test]
fn without_a_network_the_page_is_whole_in_webkit() {
    lives_without_a_network(Engine::WebKit);
}

#[test]
fn a_new_build_is_seen_at_once_and_the_old_one_is_forgotten() {
    let Some(page) = Page::start(Graphics::WebGpu) else { return };
    let folder = copy_of_page("two-builds");
    let server = Server::without_caching(&folder);
    page.go(&format!("{}#{LINK}", server.address()));
    is_kept(&page);
    let old = caches(&page);
    assert_eq!(old.len(), 1, "{old:?}");

    // Another build: its page differs, and so does the name that its service worker was given.
    change(&folder.join("index.html"), "data-bundles=", "data-build=new data-bundles=");
    change(&folder.join("offline.js"), "wasm_bindgen.keep('", "wasm_bindgen.keep('1");
    page.go(&format!("{}#{LINK}", server.address()));
    let build = "return document.documentElement.dataset.build";
    assert_eq!(page.run(build), "new");
    assert_eq!(page.run("return navigator.serviceWorker.controller !== null"), true);
    page.wait_for(
        "the new build to be kept",
        "return navigator.serviceWorker.getRegistration().then(r => !!r.waiting)",
    );
    assert_eq!(caches(&page).len(), 2, "the page of the old build stays whole");

    // With the last page of the old build it goes.
    // A browser that is busy may hold on to that page for a while longer.
    let goes = "return new Promise(async told => {
        for (let k = 0; k < 100 && (await caches.keys()).length > 1; k += 1)
            await new Promise(go => setTimeout(go, 200));
        told((await caches.keys()).length === 1)
    })";
    let gone = (0..3).any(|_| {
        page.go(&format!("{}#{LINK}", server.address()));
        page.run(goes) == true
    });
    assert!(gone, "the old build stays: {:?}", caches(&page));
    assert_ne!(caches(&page), old);
    server.go_down();
    page.go(&format!("{}#{LINK}", server.address()));
    assert_eq!(page.run(build), "new");
    assert_eq!(page.ready().fingerprint, native(LINK));
}

#[test]
fn where_nothing_can_be_kept_nobody_is_told() {
    let refusals = [
        // As in a frame without an origin, and where the address is not secure.
        "get() { throw new DOMException('sandboxed', 'SecurityError') }",
        "get() { return undefined }",
        "get() { return { register: () => { window.asked = true; return Promise.reject(new TypeError('no')) } } }",
    ];
    for refusal in refusals {
        let Some(page) = Page::start(Graphics::WebGpu) else { return };
        let script = format!(
            "Object.defineProperty(Navigator.prototype, 'serviceWorker', {{ {} }})",
            refusal.replace("get() {", "get() { window.touched = true;")
        );
        page.devtools("Page.addScriptToEvaluateOnNewDocument", json!({ "source": script }));
        page.visit(&format!("#{LINK}"));
        page.ready();
        page.wait_for("the page to ask", "return window.touched === true");
        std::thread::sleep(std::time::Duration::from_millis(300));
        page.drag_to_day(3.0);
        page.on_day(3);
        assert_eq!(page.messages(), "");
        assert_eq!(page.complaints(), [""; 0]);
    }
}

#[test]
fn the_page_can_be_installed() {
    let Some(page) = Page::open(Graphics::Neither, &format!("#{LINK}")) else { return };
    is_kept(&page);
    let manifest = page.devtools("Page.getAppManifest", json!({}));
    assert_eq!(manifest["errors"], json!([]));
    assert!(manifest["url"].as_str().unwrap().ends_with("/install/manifest.webmanifest"));
    let manifest: serde_json::Value =
        serde_json::from_str(manifest["data"].as_str().unwrap()).unwrap();
    for icon in manifest["icons"].as_array().unwrap() {
        let file = dist().join("install").join(icon["src"].as_str().unwrap());
        let icon_file = png::Decoder::new(std::io::BufReader::new(fs::File::open(file).unwrap()));
        let info = icon_file.read_info().unwrap();
        let sizes = format!("{}x{}", info.info().width, info.info().height);
        assert_eq!(icon["sizes"], sizes);
    }
    let errors = page.devtools("Page.getInstallabilityErrors", json!({}));
    assert_eq!(errors["installabilityErrors"], json!([]));
}

fn lives_without_a_network(engine: Engine) {
    let Some(page) = Page::start(engine) else { return };
    // The browser's own cache is no help.
    let server = Server::without_caching(&dist());
    page.go(&format!("{}#{LINK}", server.address()));
    is_kept(&page);
    let before = page.ready();
    assert_eq!(
        (before.fingerprint.as_str(), before.backend.as_str()),
        (&*native(LINK), engine.backend())
    );

    server.go_down();
    page.go(&format!("{}#{LINK}", server.address()));
    assert_eq!(page.ready(), before);
    assert!(page.picture().colours() > 500, "a plant is on the canvas");
    page.choose("cactus");
    let cactus = page.wait("another plant", |s| s.plant == "cactus" && s.state == "ready");
    assert_eq!(cactus.fingerprint, native(&page.link()));

    let row = figures::find("4.15").expect("a row of the thesis");
    page.go(&format!("{}#figures/{}", server.address(), row.number));
    page.wait_for(
        "a row of figures",
        &format!(
            "return document.querySelectorAll('.picture[data-live]').length >= {}",
            row.pictures.len()
        ),
    );
    page.wait_for(
        "all stills",
        "const stills = [...document.querySelectorAll('#figures img')];
         stills.forEach(still => still.loading = 'eager');
         return stills.length > 30 && stills.every(still => still.complete && still.naturalWidth > 0)",
    );
    assert_eq!(page.messages(), "");
}

/// Waits until the browser keeps the whole page.
fn is_kept(page: &Page) {
    page.ready();
    page.wait_for(
        "the page to be kept",
        "return navigator.serviceWorker.getRegistration().then(r => !!r && r.active?.state === 'activated')",
    );
}

fn caches(page: &Page) -> Vec<String> {
    serde_json::from_value(page.run("return caches.keys()")).expect("names")
}

/// The built page once more, to change something in it.
fn copy_of_page(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    copy(&dist(), &folder);
    folder
}

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let path = entry.unwrap().path();
        let target = to.join(path.file_name().unwrap());
        if path.is_dir() {
            copy(&path, &target)
        } else {
            fs::copy(&path, &target).map(drop).unwrap()
        }
    }
}

fn change(file: &Path, from: &str, to: &str) {
    let text = fs::read_to_string(file).unwrap();
    assert!(text.contains(from), "{} has no {from}", file.display());
    fs::write(file, text.replace(from, to)).unwrap();
}
