//! `./playground measure`: a table of what the page costs on this machine. Nothing is asserted: times
//! depend on the machine.

use crate::engines::Graphics;
use crate::page::{Page, keys};
use crate::start::{Start, preset_link};
use clonal_mosaic::plants::{self, Plant};
use clonal_mosaic::play::protocol::{ToPage, ToWorker};
use clonal_mosaic::play::worker::Worker;
use serde_json::json;
use std::time::Instant;

/// The best of so many runs is printed: other work on the machine only ever adds to a time.
const RUNS: usize = 3;

#[test]
#[ignore = "measures, which takes minutes: ./playground measure"]
fn measure() {
    println!("\nAll days of each preset, best of {RUNS} runs, and its first live picture.\n");
    println!("               native   worker  ratio |      WebGPU           |      WebGL2");
    println!(
        "                    s        s        | gzip bytes         ms | gzip bytes         ms"
    );
    for plant in plants::all() {
        let native_s = best(|| Some(native_seconds(plant)));
        let Some(worker_s) =
            Page::start(Graphics::Neither).map(|page| best(|| Some(worker_seconds(&page, plant))))
        else {
            return;
        };
        print!("{:12} {native_s:8.2} {worker_s:8.2} {:6.2}", plant.key, worker_s / native_s);
        for graphics in [Graphics::WebGpu, Graphics::WebGl2] {
            let mut bytes = 0;
            let milliseconds = best(|| {
                let start = Start::of(graphics, &preset_link(plant))?;
                bytes = start.bytes();
                Some(start.milliseconds)
            });
            print!(" | {bytes:10} {milliseconds:10.0}");
        }
        println!();
    }
}

/// What it costs the page to show a day that it holds, for the plant with the most cells: the
/// handling of the wish and the frame after it, in which the day is on the screen; and with all frames
/// until it is there with all its pixels.
#[test]
#[ignore = "measures, which takes minutes: ./playground measure"]
fn measure_a_held_day() {
    const DAYS: [u32; 9] = [27, 30, 26, 29, 25, 30, 24, 28, 30];
    println!("\nA held day of the croton on the screen, milliseconds of the page, medians.");
    for graphics in [Graphics::WebGpu, Graphics::WebGl2] {
        let Some(page) = Page::start(graphics) else { return };
        time_frames(&page);
        page.visit("#croton?v=1&s=1&d=30");
        let state = page.on_day(30);
        let spent_ms = DAYS.map(|day| {
            page.run(&format!(
                "const field = document.getElementById('day-number');
                 field.value = {day};
                 const begun = performance.now();
                 field.dispatchEvent(new Event('change', {{bubbles: true}}));
                 window.spent_ms = [performance.now() - begun]"
            ));
            page.on_day(day);
            let spent_ms = page.run("return window.spent_ms");
            serde_json::from_value::<Vec<f64>>(spent_ms).expect("numbers")
        });
        let median = |frames: usize| {
            let mut sums = spent_ms.each_ref().map(|ms| ms.iter().take(frames).sum::<f64>());
            sums.sort_by(f64::total_cmp);
            sums[DAYS.len() / 2]
        };
        println!(
            "{graphics:?}: {:.1} ms in the next frame, {:.1} ms until all pixels; day 30 of {} cells",
            median(2),
            median(usize::MAX),
            state.cells
        );
    }
}

/// What the graphics card, or software in its place, takes for a frame with all pixels while the plant is
/// turned.
#[test]
#[ignore = "measures, which takes minutes: ./playground measure"]
fn measure_a_moving_frame() {
    const TURNS: usize = 12;
    println!(
        "\nA frame of a turned plant with all pixels, milliseconds of the adapter, best of {TURNS}."
    );
    let Some(page) = Page::start(Graphics::WebGpu) else { return };
    page.before_pages(
        "const submit = GPUQueue.prototype.submit;
         window.drawn_ms = [];
         GPUQueue.prototype.submit = function (buffers) {
             const begun = performance.now();
             submit.call(this, buffers);
             const canvas = document.getElementById('canvas');
             if (canvas.width === Math.round(canvas.clientWidth * devicePixelRatio))
                 this.onSubmittedWorkDone().then(() => window.drawn_ms.push(performance.now() - begun))
         }",
    );
    for plant in ["croton", "philodendron", "watermelon", "mushroom"] {
        page.visit(&format!("#{plant}?v=1&s=1"));
        page.ready();
        page.sharp();
        page.run("document.getElementById('stage').focus(); window.drawn_ms = []");
        for _ in 0..TURNS {
            page.press(&[keys::LEFT]);
            std::thread::sleep(std::time::Duration::from_secs(1));
            page.sharp();
        }
        let drawn_ms = page.run("return window.drawn_ms");
        let drawn_ms: Vec<f64> = serde_json::from_value(drawn_ms).expect("numbers");
        println!("{plant:12} {:8.1}", drawn_ms.into_iter().fold(f64::INFINITY, f64::min));
    }
}

/// Makes pages that are loaded from now on note what each frame takes them, in milliseconds, in `spent_ms`.
pub fn time_frames(page: &Page) {
    page.before_pages(
        "const ask = window.requestAnimationFrame.bind(window);
         window.spent_ms = [];
         window.requestAnimationFrame = callback => ask(now => {
             const begun = performance.now();
             callback(now);
             window.spent_ms.push(performance.now() - begun)
         })",
    );
}

fn best(mut run: impl FnMut() -> Option<f64>) -> f64 {
    (0..RUNS).filter_map(|_| run()).fold(f64::INFINITY, f64::min)
}

/// Body, all days, and the lists that are drawn, in this thread.
fn native_seconds(plant: &'static Plant) -> f64 {
    let mut worker = Worker::new(plants::all());
    let text = plant.body.mesh.text.to_string();
    worker.hear(ToWorker::Mesh { name: plant.body.mesh.name.to_string(), text });
    let begun = Instant::now();
    worker.hear(ToWorker::Grow { generation: 1, first: 0, link: preset_link(plant) });
    worker.work(|| false, |news| drop(news.to_words()));
    begun.elapsed().as_secs_f64()
}

/// The same in the worker: from the page's wish to the answer that all days have grown.
fn worker_seconds(page: &Page, plant: &'static Plant) -> f64 {
    let wish = ToWorker::Grow { generation: 1, first: 0, link: String::new() }.to_words()[0];
    let done = ToPage::Done { generation: 1 }.to_words()[0];
    let watch = format!(
        "window.Worker = class extends Worker {{
            constructor(...a) {{
                super(...a);
                this.addEventListener('message', ({{data}}) => {{
                    if (data[0] === {done}) window.grown_ms = performance.now() - this.wished_ms
                }})
            }}
            postMessage(data, ...a) {{
                if (data[0] === {wish}) this.wished_ms = performance.now();
                super.postMessage(data, ...a)
            }}
        }}"
    );
    let added = page.devtools("Page.addScriptToEvaluateOnNewDocument", json!({ "source": watch }));
    page.visit(&preset_link(plant));
    page.wait_for("all days to grow", "return !!window.grown_ms");
    page.devtools("Page.removeScriptToEvaluateOnNewDocument", added);
    page.run("return window.grown_ms").as_f64().expect("a number") / 1000.0
}
