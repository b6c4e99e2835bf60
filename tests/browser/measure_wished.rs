//! `./playground measure`: what it costs to see a late day after a number was changed. Nothing is asserted.

use crate::engines::Graphics;
use crate::page::Page;
use clonal_mosaic::plants;
use clonal_mosaic::play::link;
use clonal_mosaic::play::protocol::{ToPage, ToWorker};
use clonal_mosaic::play::worker::Worker;
use clonal_mosaic::tissue::Progress;
use serde_json::json;
use std::sync::Arc;
use std::time::Instant;

const RUNS: usize = 3;
/// Plants, their late days, and a number that is not the preset's.
const LINKS: [&str; 3] =
    ["croton?v=1&s=1&d=30&df=6", "cactus?v=1&s=1&d=25&pf=0.002", "mushroom?v=1&s=1&d=20&ff=0.6"];

#[test]
#[ignore = "measures, which takes minutes: ./playground measure"]
fn measure_the_wished_day() {
    println!("\nUntil a late day is there, seconds, best of {RUNS} runs in turn.");
    println!("                        native                       |        worker");
    println!("              growth  in order   first   first/growth | in order   first");
    for text in LINKS {
        let scene = link::read(text, plants::all()).scene;
        let mut worker = Worker::new(plants::all());
        let mesh = scene.plant.body.mesh;
        worker.hear(ToWorker::Mesh { name: mesh.name.to_string(), text: mesh.text.to_string() });
        let body = Arc::new(scene.plant.embedded_body().surface);
        let mut best = [f64::INFINITY; 3];
        for _ in 0..RUNS {
            let begun = Instant::now();
            let (mut growth, _) = scene.sow(body.clone()).expect("a preset grows");
            while growth.step() != Progress::Day(scene.day) {}
            let alone = begun.elapsed().as_secs_f64();
            let [in_order, first] =
                [0, scene.day].map(|first| told(&mut worker, text, first, scene.day));
            for (best, time) in best.iter_mut().zip([alone, in_order, first]) {
                *best = best.min(time);
            }
        }
        let [alone, in_order, first] = best;
        print!(
            "{:12} {alone:7.2} {in_order:9.2} {first:7.2} {:14.2} |",
            scene.plant.key,
            first / alone
        );
        let Some(page) = Page::start(Graphics::Neither) else { return };
        let mut best = [f64::INFINITY; 2];
        for _ in 0..RUNS {
            for (best, first) in best.iter_mut().zip([0, scene.day]) {
                *best = best.min(in_the_page(&page, text, first, scene.day));
            }
        }
        println!(" {:8.2} {:7.2}", best[0], best[1]);
    }
}

/// Seconds until a worker, which holds the body already, tells a day.
fn told(worker: &mut Worker, link: &str, first: u32, day: u32) -> f64 {
    let begun = Instant::now();
    let wish = ToWorker::Grow { generation: 1, first, link: link.to_string() };
    assert_eq!(worker.hear(wish), None);
    let mut is_there = false;
    while !is_there {
        worker
            .work(|| true, |said| is_there |= matches!(said, ToPage::Day(news) if news.day == day));
    }
    worker.hear(ToWorker::Stop);
    begun.elapsed().as_secs_f64()
}

/// The same in a page that is loaded anew: from its wish, to which another first day is given, to the day.
fn in_the_page(page: &Page, link: &str, first: u32, day: u32) -> f64 {
    let grow = ToWorker::Grow { generation: 1, first: 0, link: String::new() }.to_words()[0];
    // A day is 3, generation and day.
    let watch = format!(
        "window.Worker = class extends Worker {{
            constructor(...a) {{
                super(...a);
                this.addEventListener('message', ({{data}}) => {{
                    if (data[0] === 3 && data[2] === {day})
                        window.there_ms ??= performance.now() - this.wished_ms
                }})
            }}
            postMessage(data, ...a) {{
                if (data[0] === {grow}) {{ this.wished_ms = performance.now(); data[2] = {first} }}
                super.postMessage(data, ...a)
            }}
        }}"
    );
    let added = page.devtools("Page.addScriptToEvaluateOnNewDocument", json!({ "source": watch }));
    page.visit(&format!("#{link}"));
    page.wait_for("the day", "return !!window.there_ms");
    page.devtools("Page.removeScriptToEvaluateOnNewDocument", added);
    page.run("return window.there_ms").as_f64().expect("a number") / 1000.0
}
