//! `./playground measure`: what a class waits for. Nothing is asserted: times depend on the machine.

use crate::engines::Graphics;
use crate::measure::time_frames;
use crate::page::Page;

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
            "return document.querySelectorAll('#figure-list .picture[data-count^=\"30 \"]').length === {count}"
        )
    };
    mark(&page, &pictures(1));
    let alone_ms = best_ms(&page, "#nursery/croton?v=1&d=30&s=1..1");
    drop(page);
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

/// What the page itself works for a day that it holds, of two plants with 120,000 cells each: the handling of the wish,
/// and the frames in which both pictures are handed over.
#[test]
#[ignore = "measures, which takes minutes: ./playground measure"]
fn measure_a_comparison() {
    const DAYS: [u32; 9] = [22, 24, 23, 21, 24, 22, 23, 21, 24];
    println!("\nA held day of a comparison, milliseconds of the page, medians.");
    for graphics in [Graphics::WebGpu, Graphics::WebGl2] {
        let Some(page) = Page::start(graphics) else { return };
        time_frames(&page);
        let link = "croton?v=1&d=24&n=19400";
        page.visit(&format!("#compare/{link}/{link}&s=2"));
        let on_day = |day: u32| {
            let told = if day == 24 { String::new() } else { format!("Day {day}: ") };
            page.wait_for(
                "both plants on their day",
                &format!(
                    "const told = [...document.querySelectorAll('#figure-list .picture[data-live] .told')];
                     return told.length === 2 && document.documentElement.dataset.state === 'ready'
                         && told.every(e => /\\d,\\d+ cells/.test(e.textContent)
                             && e.textContent.startsWith('{told}') && /^D/.test(e.textContent) === {})",
                    day != 24
                ),
            );
        };
        on_day(24);
        let spent_ms = DAYS.map(|day| {
            page.run(&format!(
                "const slider = document.querySelector('.days input');
                 slider.value = {day};
                 const begun = performance.now();
                 slider.dispatchEvent(new Event('input', {{bubbles: true}}));
                 window.spent_ms = [performance.now() - begun]"
            ));
            on_day(day);
            let spent_ms: Vec<f64> =
                serde_json::from_value(page.run("return window.spent_ms")).expect("numbers");
            [spent_ms.iter().sum(), spent_ms.into_iter().fold(0.0, f64::max)]
        });
        let median = |of: usize| {
            let mut all = spent_ms.map(|times: [f64; 2]| times[of]);
            all.sort_by(f64::total_cmp);
            all[DAYS.len() / 2]
        };
        let told = page.run(
            "return [...document.querySelectorAll('#figure-list .picture .told')].map(e => e.textContent)",
        );
        println!("{graphics:?}: {:.1} ms, at most {:.1} at a time; {told}", median(0), median(1));
    }
}
