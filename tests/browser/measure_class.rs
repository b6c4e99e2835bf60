//! `./playground measure`: what a class waits for. Nothing is asserted: times depend on the machine.

use crate::engines::Graphics;
use crate::page::Page;
use serde_json::json;

const RUNS: usize = 3;

/// Marks when something that is told by a script is there for the first time, in milliseconds of the page.
fn mark(page: &Page, is_there: &str) {
    page.before_pages(&format!(
        "const look = () => {{ {is_there} }};
         const watcher = new MutationObserver(() => {{
             if (!look()) return;
             watcher.disconnect();
             window.there_ms = performance.now()
         }});
         watcher.observe(document, {{subtree: true, childList: true, attributes: true}})"
    ));
}

/// The least time from asking for an address until it is there, in milliseconds.
fn best_ms(page: &Page, link: &str) -> f64 {
    let run = || {
        page.visit(link);
        page.wait_for("what is measured", "return window.there_ms !== undefined");
        page.run("return window.there_ms").as_f64().expect("a number")
    };
    (0..RUNS).map(|_| run()).fold(f64::INFINITY, f64::min)
}

#[test]
#[ignore = "measures, which takes minutes: ./playground measure"]
fn measure_lessons() {
    println!("\nUntil a lesson is open, from its address on, milliseconds, best of {RUNS} loads.");
    for graphics in [Graphics::WebGpu, Graphics::WebGl2] {
        let Some(page) = Page::start(graphics) else { return };
        mark(
            &page,
            "const view = document.getElementById('lesson-view');
             return view && !view.hidden && document.getElementById('lesson-title').textContent",
        );
        for lesson in ["doubling", "jackpots"] {
            let link = format!("#croton?v=1&d=0~lesson/{lesson}");
            println!("{graphics:?} {lesson:12} {:6.0}", best_ms(&page, &link));
        }
    }
}

#[test]
#[ignore = "measures, which takes minutes: ./playground measure"]
fn measure_a_nursery() {
    const COUNT: usize = 12;
    let Some(page) = Page::start(Graphics::WebGpu) else { return };
    let pictures = |count: usize| {
        format!(
            "return document.querySelectorAll('#figure-list .picture[data-count]').length === {count}"
        )
    };
    mark(
        &page,
        "return document.documentElement.dataset.state === 'ready' && document.documentElement.dataset.day === '30'",
    );
    let alone_ms = best_ms(&page, "#croton?v=1&d=30&s=1");
    let Some(page) = Page::start(Graphics::WebGpu) else { return };
    mark(&page, &pictures(COUNT));
    let all_ms = best_ms(&page, &format!("#nursery/croton?v=1&d=30&s=1..{COUNT}"));
    let workers = page.run("return Math.max(1, Math.min(4, navigator.hardwareConcurrency - 1))");
    println!(
        "\n{COUNT} crotons to their last day {:.2} s, one alone {:.2} s, {workers} workers: \
         {:.2} times {COUNT} / {workers}.",
        all_ms / 1e3,
        alone_ms / 1e3,
        all_ms / alone_ms * workers.as_f64().expect("a number") / COUNT as f64
    );
}

/// Two plants of 120,000 cells each.
#[test]
#[ignore = "measures, which takes minutes: ./playground measure"]
fn measure_a_comparison() {
    const DAYS: [u32; 9] = [27, 30, 26, 29, 25, 30, 24, 28, 30];
    println!("\nA held day of a comparison, milliseconds of the page, medians.");
    for graphics in [Graphics::WebGpu, Graphics::WebGl2] {
        let Some(page) = Page::start(graphics) else { return };
        page.before_pages(
            "const ask = window.requestAnimationFrame.bind(window);
             window.spent_ms = [];
             window.requestAnimationFrame = callback => ask(now => {
                 const begun = performance.now();
                 callback(now);
                 window.spent_ms.push(performance.now() - begun)
             })",
        );
        let link = "croton?v=1&d=30&n=19400";
        page.visit(&format!("#compare/{link}/{link}&s=2"));
        let told = "return [...document.querySelectorAll('#figure-list .picture .told')].map(e => e.textContent)";
        page.wait_for(
            "both plants",
            "return document.querySelectorAll('#figure-list .picture[data-live]').length === 2
                 && document.documentElement.dataset.state === 'ready'",
        );
        page.rest();
        let mut spent_ms = DAYS.map(|day| {
            page.run(&format!(
                "const slider = document.querySelector('.days input');
                 slider.value = {day};
                 const begun = performance.now();
                 slider.dispatchEvent(new Event('input', {{bubbles: true}}));
                 window.spent_ms = [performance.now() - begun]"
            ));
            page.wait_for(
                "the day",
                &format!(
                    "return document.querySelector('.days output').textContent === 'Day {day}'
                         && document.documentElement.dataset.state === 'ready'"
                ),
            );
            page.rest();
            let spent_ms: Vec<f64> =
                serde_json::from_value(page.run("return window.spent_ms")).expect("numbers");
            [spent_ms.iter().sum(), spent_ms.iter().copied().fold(0.0, f64::max)]
        });
        let mut median = |of: usize| {
            spent_ms.sort_by(|a: &[f64; 2], b| a[of].total_cmp(&b[of]));
            spent_ms[DAYS.len() / 2][of]
        };
        let (all, longest) = (median(0), median(1));
        println!(
            "{graphics:?}: {all:.1} ms, the longest task {longest:.1} ms; {}",
            json!(page.run(told))
        );
    }
}
