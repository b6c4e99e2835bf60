//! The page under its content security policy: it runs, asks no other host, and the console is empty.

use crate::engines::Graphics;
use crate::page::Page;
use crate::server::{Server, dist};

const LINK: &str = "#watermelon?v=1&s=2&d=3";

/// The policy that stands in the page.
fn policy() -> &'static str {
    let html = include_str!("../../www/index.html");
    let (_, from) = html.split_once("\"Content-Security-Policy\" content=\"").expect("a policy");
    from.split('"').next().expect("its end")
}

#[test]
fn a_visit_under_the_strict_policy_is_silent_and_asks_no_other_host() {
    for graphics in [Graphics::WebGpu, Graphics::WebGl2] {
        let Some(page) = Page::start(graphics) else { return };
        let server =
            Server::with_headers(&dist(), &format!("Content-Security-Policy: {}\r\n", policy()));
        page.go(&format!("{}{LINK}", server.address()));
        page.ready();
        assert!(page.picture().colours() > 100, "{graphics:?}");
        page.click("last");
        page.wait("the last day", |s| s.state == "ready" && s.day != "3");
        page.choose("cactus");
        page.wait("the cactus", |s| s.state == "ready" && s.plant == "cactus");
        page.run("location.hash = '#figures/4.15'");
        page.ready();
        // What an element asks for with a style of its own would be refused.
        let in_a_row = "const p = document.querySelectorAll('#figure-4\\\\.15 .picture');
                        return p.length === 3 && p[0].offsetTop === p[2].offsetTop";
        assert_eq!(page.run(in_a_row), true, "three pictures stand in a row");
        assert_eq!(page.warnings(), [""; 0], "{graphics:?}");
        let asked = page.run("return performance.getEntriesByType('resource').map(e => e.name)");
        let asked: Vec<String> = serde_json::from_value(asked).expect("addresses");
        assert!(asked.len() > 10, "{asked:?}");
        let own =
            |name: &&String| !name.starts_with(&server.address()) && !name.starts_with("data:");
        assert_eq!(asked.iter().filter(own).collect::<Vec<_>>(), [""; 0]);
    }
}

#[test]
fn what_is_not_ours_is_refused() {
    let Some(page) = Page::open(Graphics::Neither, LINK) else { return };
    page.ready();
    let other = Server::start(&dist());
    let script = format!(
        "fetch('{0}').catch(() => 0); new Image().src = '{0}icon.svg';
         const s = document.createElement('script'); s.text = 'window.ran = true';
         document.head.append(s); return !!window.ran",
        other.address()
    );
    assert_eq!(page.run(&script), false, "scripts in the HTML do not run");
    page.wait_for("the refusals", "return true");
    assert_eq!(other.requested(), [""; 0]);
    assert!(page.complaints().iter().any(|told| told.contains("Content Security Policy")));
}

#[test]
fn hosts_are_told_the_policy_of_the_page() {
    let policy = policy();
    let told = include_str!("../../ARCHITECTURE.md");
    assert!(told.contains(&format!("Content-Security-Policy: {policy}\n")), "{policy}");
}
