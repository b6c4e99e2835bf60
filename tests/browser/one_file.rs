//! The edition in one file: by double click from a disk, as an upload, in a locked frame.

use crate::engines::{Engine, Graphics};
use crate::page::Page;
use crate::sameness::native;
use crate::server::Server;
use std::path::{Path, PathBuf};
use std::process::Command;

const LINK: &str = "watermelon?v=1&s=17&d=8";
const MOST_BYTES: u64 = 7_000_000;

/// Makes the file of the built page and puts it where a visitor may have it.
fn one_file() -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let packed = Command::new(root.join("playground")).arg("pack-single").status();
    assert!(packed.expect("bash is there").success());
    let stick = Path::new(env!("CARGO_TARGET_TMPDIR")).join("a stick, für die Schule");
    std::fs::create_dir_all(&stick).expect("a folder can be made");
    let file = stick.join("clonal-mosaic.html");
    std::fs::copy(root.join("dist-single/clonal-mosaic.html"), &file).expect("a copy");
    file
}

/// Everything grows out of the file that a browser has opened at this address.
#[track_caller]
fn grows_from(page: &Page, address: &str) {
    page.go(&format!("{address}#{LINK}"));
    assert_eq!(page.ready().fingerprint, native(LINK));
    assert_eq!(page.messages(), "");
    let stills =
        "return [...document.querySelectorAll('#plants img')].every(i => i.naturalWidth > 100)";
    page.wait_for("the stills of the chooser", stills);
    page.choose("cactus");
    page.wait("another plant", |s| s.state == "ready" && s.plant == "cactus");
    page.run("location.hash = '#figures/4.15'");
    page.ready();
    let stills = "return [...document.querySelectorAll('#figure-4\\\\.15 img')].every(i => i.naturalWidth > 100)";
    page.wait_for("the stills of the figures", stills);
    let asked =
        page.run("return performance.getEntriesByType('resource').map(e => e.name.slice(0, 5))");
    let asked: Vec<String> = serde_json::from_value(asked).expect("addresses");
    assert!(asked.iter().all(|kind| kind == "data:" || kind == "blob:"), "{asked:?}");
}

#[test]
fn one_file_grows_from_a_disk() {
    for graphics in [Graphics::WebGpu, Graphics::WebGl2, Graphics::Neither] {
        let Some(page) = Page::start(graphics) else { return };
        let file = one_file();
        let bytes = file.metadata().expect("it is there").len();
        assert!(bytes <= MOST_BYTES, "{bytes} bytes");
        if graphics == Graphics::Neither {
            page.go(&format!("file://{}#{LINK}", file.display()));
            assert_eq!(page.ready().fingerprint, native(LINK));
            continue;
        }
        grows_from(&page, &format!("file://{}", file.display()));
        page.run("location.hash = '#mushroom'");
        page.wait("the mushroom", |s| s.state == "ready" && s.plant == "mushroom");
        assert!(page.picture().colours() > 100, "{graphics:?}");
        assert_eq!(page.warnings(), [""; 0], "{graphics:?}");
    }
}

#[test]
fn one_file_grows_from_a_disk_in_firefox() {
    grows_from_a_disk(Engine::Firefox);
}

#[test]
fn one_file_grows_from_a_disk_in_webkit() {
    grows_from_a_disk(Engine::WebKit);
}

fn grows_from_a_disk(engine: Engine) {
    let Some(page) = Page::start(engine) else { return };
    grows_from(&page, &format!("file://{}", one_file().display()));
    page.run("location.hash = '#mushroom'");
    page.wait("the mushroom", |s| s.state == "ready" && s.plant == "mushroom");
    assert!(page.picture().colours() > 100);
}

#[test]
fn one_file_grows_as_an_upload_and_in_a_locked_frame_without_headers() {
    let Some(page) = Page::start(Graphics::WebGpu) else { return };
    let file = one_file();
    let server = Server::start(file.parent().expect("it lies in a folder"));
    let address = format!("{}clonal-mosaic.html", server.address());
    grows_from(&page, &address);
    page.go_to_frame(&format!("{address}#{LINK}"), "allow-scripts");
    assert_eq!(page.ready().fingerprint, native(LINK));
    assert_eq!(page.messages(), "");
    let asked = server.requested();
    assert!(asked.iter().all(|name| name == "clonal-mosaic.html"), "{asked:?}");
}
