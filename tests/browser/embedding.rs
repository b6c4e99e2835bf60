//! The page in a frame with a `sandbox`, as learning platforms embed it: there it is a stranger to every
//! host, to its own too.

use crate::engines::Graphics;
use crate::page::Page;
use crate::sameness::native;
use crate::server::{Server, dist};

const LINK: &str = "watermelon?v=1&s=17&d=8";
/// Lets pages of any origin read what a host has.
const CORS: &str = "Access-Control-Allow-Origin: *\r\n";

#[test]
fn a_locked_frame_grows_where_the_host_lets_it_read() {
    for graphics in [Graphics::WebGpu, Graphics::WebGl2] {
        let Some(page) = Page::start(graphics) else { return };
        let server = Server::with_headers(&dist(), CORS);
        page.go_to_frame(&format!("{}#{LINK}", server.address()), "allow-scripts");
        assert_eq!(page.ready().fingerprint, native(LINK), "{graphics:?}");
        assert_eq!(page.run("return self.origin"), "null", "the frame is locked");
        assert_eq!(page.messages(), "");
        assert!(page.picture().colours() > 100, "it is drawn");
        assert_eq!(page.warnings(), [""; 0]);
        // Storage throws there: the choice of light or dark is for this visit only.
        page.click("theme");
        page.wait_for("another theme", "return !!document.documentElement.dataset.theme");
        page.click("another");
        page.wait("another one", |s| s.state == "ready" && s.individual != "17");
    }
}

#[test]
fn a_locked_frame_of_a_host_that_refuses_says_so_and_leads_out() {
    let Some(page) = Page::start(Graphics::WebGpu) else { return };
    page.go_to_frame(&format!("{}#{LINK}", page.server.address()), "allow-scripts allow-popups");
    says_that_nothing_starts(&page);
}

#[test]
fn a_folder_on_a_disk_says_that_nothing_starts() {
    let Some(page) = Page::start(Graphics::WebGpu) else { return };
    page.go(&format!("file://{}/index.html", dist().display()));
    says_that_nothing_starts(&page);
}

/// No script of ours runs: after a while a still plant is seen, a sentence and a link.
#[track_caller]
fn says_that_nothing_starts(page: &Page) {
    let styled = "return getComputedStyle(document.querySelector('.masthead')).display === 'flex'";
    page.wait_for("the style", styled);
    page.wait_for(
        "the sentence",
        "return document.querySelector('#stuck p').checkVisibility({visibilityProperty: true})",
    );
    page.wait_for(
        "the still plant",
        "return document.querySelector('#stuck img').naturalWidth > 100",
    );
    let told = page.text("stuck");
    assert!(told.contains("still picture") && told.contains("its own window"), "{told}");
    let on_top =
        "const a = document.querySelector('#stuck a'); const b = a.getBoundingClientRect();
                  return document.elementFromPoint(b.left + 5, b.top + 5) === a";
    assert_eq!(page.run(on_top), true, "the link can be clicked");
}

/// What the sentence needs is asked for after six seconds, which a very busy machine may take to start.
#[test]
fn a_page_that_starts_does_not_speak_of_it() {
    let mut asked = Vec::new();
    for _ in 0..3 {
        let Some(page) = Page::open(Graphics::Neither, &format!("#{LINK}")) else { return };
        page.ready();
        assert_eq!(page.run("return document.getElementById('stuck')"), serde_json::Value::Null);
        asked = page.server.requested();
        if !asked.iter().any(|name| name == "posters/croton.avif") {
            return;
        }
    }
    panic!("{asked:?}");
}
