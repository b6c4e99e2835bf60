//! Workers that die while they grow, as they do where memory runs out.

use crate::engines::Graphics;
use crate::page::Page;
use serde_json::json;

/// A browser whose workers die of a real exception, thrown where they send a day: `is_deadly` is a
/// condition on the `link` that they grow, the `day`, and the number of workers `made` before.
fn open(is_deadly: &str, link: &str) -> Option<Page> {
    let page = Page::start(Graphics::Neither)?;
    // Messages are words: 1, generation, first day, bytes of the link and the link to the worker; 3,
    // generation and day to the page.
    let source = format!(
        "let made = 0;
         window.Worker = class extends Worker {{
             constructor(address, options) {{
                 const source = `
                     const made = ${{made++}};
                     let link = '';
                     self.addEventListener('message', ({{data}}) => {{
                         if (data[0] === 1)
                             link = new TextDecoder().decode(new Uint8Array(data.buffer, 16, data[3]))
                     }});
                     const post = self.postMessage.bind(self);
                     self.postMessage = (words, ...rest) => {{
                         const day = words[0] === 3 ? words[2] : -1;
                         if ({is_deadly}) throw new RangeError('Array buffer allocation failed');
                         post(words, ...rest)
                     }};
                     import('${{new URL(address, document.baseURI)}}')`;
                 super(URL.createObjectURL(new Blob([source], {{type: 'text/javascript'}})), options)
             }}
         }}"
    );
    page.devtools("Page.addScriptToEvaluateOnNewDocument", json!({ "source": source }));
    page.visit(link);
    Some(page)
}

const TOO_LARGE: &str = "That seems to need more memory than this browser gives: back to";

#[test]
fn a_growth_that_kills_the_worker_brings_back_what_was_there_before() {
    let link = "watermelon?v=1&s=5&d=4";
    let deadly = "link.includes('df=2') && day >= 2";
    let Some(page) = open(deadly, &format!("#{link}&df=2")) else { return };
    // The very first link kills it.
    let state = page.wait("the preset", |s| s.state == "ready" && s.individual == "5");
    assert!(page.link().starts_with("watermelon?v=1&s=5&d="), "{}", page.link());
    assert!(!page.link().contains("df="), "{}", page.link());
    assert!(page.messages().contains(TOO_LARGE), "{}", page.messages());
    page.visit(&format!("#{}", page.link()));
    assert_eq!(page.ready(), state, "the address is that of a plant that grows");
    assert!(!page.messages().contains(TOO_LARGE), "{}", page.messages());

    page.run(&format!("location.hash = '#{link}&ff=0.3'"));
    let before = page.on_day(4);
    page.run(&format!("location.hash = '#{link}&ff=0.3&df=2'"));
    page.wait_for("the link to come back", &format!("return location.hash === '#{link}&ff=0.3'"));
    assert_eq!(page.ready(), before);
    assert!(page.messages().contains(TOO_LARGE), "{}", page.messages());
    page.click("another");
    page.wait("another one", |s| s.individual != "5" && s.state == "ready");
    assert!(!page.messages().contains(TOO_LARGE), "{}", page.messages());
}

#[test]
fn days_that_have_grown_stay_when_the_worker_dies() {
    let Some(page) = open("day >= 6", "#watermelon?v=1&s=5&d=4") else { return };
    page.wait_for("the end of the days", "return location.hash.endsWith('&d=4&days=5')");
    page.on_day(4);
    assert!(page.messages().contains(TOO_LARGE), "{}", page.messages());
    page.click("last");
    page.on_day(5);
}

#[test]
fn a_row_of_figures_outlives_a_worker() {
    let Some(page) = open("made < 1 && day >= 3", "#figures/4.15") else { return };
    page.ready();
    let told = "const told = [...document.querySelectorAll('#figure-4\\\\.15 .told')];
                return told.length === 3
                    && told.every(told => told.textContent.includes(' cells, '))";
    assert_eq!(page.run(told), true);
}
