//! The figures: rows of pictures that grow where the reader looks.

use crate::engines::{Engine, Graphics};
use crate::page::Page;
use clonal_mosaic::import::Made;
use clonal_mosaic::plants;
use clonal_mosaic::play::{figures, link, words};
use clonal_mosaic::tissue::Progress;
use serde_json::json;
use std::sync::Arc;

/// A row whose pictures differ, and grow fast.
const NUMBER: &str = "4.15";

/// What stands below each picture of the row when it has grown.
fn expected() -> Vec<String> {
    let figure = figures::find(NUMBER).expect("a row of the thesis");
    let pictures = figure.pictures.iter().map(|picture| {
        let scene = link::read(picture.link, plants::all()).scene;
        let mesh = Arc::new(scene.plant.embedded_body().surface);
        let mut growth = scene.plant.sow(mesh, scene.recipe, scene.individual).unwrap();
        while growth.step() != Progress::Day(scene.day) {}
        let count = growth.diary.count(scene.day as usize);
        let share = words::share(count.by_type[0], count.cells);
        let colour = scene.plant.colour_names[0];
        format!("{} cells, {share} {colour}", words::grouped(count.cells))
    });
    pictures.collect()
}

/// Whether each picture of the row is told and drawn as given.
fn wait_for_row(page: &Page, told: &[String]) {
    let told = serde_json::to_string(told).expect("texts");
    page.wait_for(
        "the row to grow",
        &format!(
            "const row = document.getElementById('figure-{NUMBER}');
             const told = [...row?.querySelectorAll('.told') ?? []].map(e => e.textContent);
             return JSON.stringify(told) === JSON.stringify({told})
                 && row.querySelectorAll('.picture[data-live]').length === told.length"
        ),
    );
}

/// The share of a picture's pixels on which something is drawn, and its mean green.
fn pixels(page: &Page, picture: usize) -> [f64; 2] {
    let script = format!(
        "const canvas = document.getElementById('figure-{}').querySelectorAll('canvas')[{picture}];
         const {{data}} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
         let [drawn, green] = [0, 0];
         for (let k = 0; k < data.length; k += 4)
             if (data[k + 3] > 200) {{ drawn += 1; green += data[k + 1] }}
         return [drawn / (data.length / 4), green / drawn]",
        NUMBER
    );
    serde_json::from_value(page.run(&script)).expect("two numbers")
}

/// How much each still of the row differs from each live picture, 0 to 255 in the mean.
fn differences(page: &Page) -> Vec<Vec<f64>> {
    // Those behind live pictures need not have been loaded.
    page.wait_for(
        "the stills",
        &format!(
            "const row = document.getElementById('figure-{NUMBER}');
             const stills = [...row.querySelectorAll('.picture img')];
             stills.forEach(still => still.loading = 'eager');
             return stills.every(still => still.complete && still.naturalWidth > 0)"
        ),
    );
    let script = format!(
        "const data = picture => {{
             const pen = new OffscreenCanvas(120, 120).getContext('2d');
             // What nearly lets everything through has a colour by rounding only.
             pen.fillStyle = '#f5f2ea';
             pen.fillRect(0, 0, 120, 120);
             pen.drawImage(picture, 0, 0, 120, 120);
             return pen.getImageData(0, 0, 120, 120).data
         }};
         const all = what =>
             [...document.getElementById('figure-{NUMBER}').querySelectorAll(what)].map(data);
         const live = all('canvas');
         return all('.picture img').map(still => live.map(other =>
             still.reduce((sum, x, k) => sum + Math.abs(x - other[k]), 0) / still.length))"
    );
    serde_json::from_value(page.run(&script)).expect("numbers")
}

pub fn a_row_grows_and_opens(engine: impl Into<Engine>) {
    let Some(page) = Page::open(engine, &format!("#figures/{NUMBER}")) else { return };
    wait_for_row(&page, &expected());
    page.ready();
    for (k, row) in differences(&page).iter().enumerate() {
        let nearest = (0..row.len()).min_by(|&a, &b| row[a].total_cmp(&row[b]));
        assert_eq!(nearest, Some(k), "stills are those of these pictures: {row:?}");
        assert!(row[k] < 5.0, "and drawn by this engine: {row:?}");
    }
    let greens = [0, 1, 2].map(|k| {
        let [drawn, green] = pixels(&page, k);
        assert!((0.1..0.9).contains(&drawn), "{drawn} of the picture is drawn");
        green
    });
    // The slower red divides, the whiter the cap.
    assert!(greens[0] + 1.0 < greens[1] && greens[1] + 1.0 < greens[2], "{greens:?}");

    page.run(&format!(
        "document.getElementById('figure-{NUMBER}').querySelectorAll('.picture')[2].click()"
    ));
    let state = page.ready();
    assert_eq!((state.plant.as_str(), state.day.as_str()), ("mushroom", "20"));
    let link = figures::find(NUMBER).unwrap().pictures[2].link;
    assert_eq!(page.run("return location.hash"), format!("#{link}"));
    assert!(page.run("return document.getElementById('figures').hidden") == true);

    page.run("history.back()");
    wait_for_row(&page, &expected());
    page.run("document.getElementById('from-figures').click()");
    assert_eq!(page.ready(), state, "the plant is as it was left");
}

#[test]
fn a_row_grows_and_opens_with_webgpu() {
    a_row_grows_and_opens(Graphics::WebGpu);
}

#[test]
fn a_row_grows_and_opens_with_webgl2() {
    a_row_grows_and_opens(Graphics::WebGl2);
}

#[test]
fn the_plant_behind_the_figures_is_loaded_when_it_is_opened() {
    let Some(page) = Page::open(Graphics::WebGpu, &format!("#figures/{NUMBER}")) else { return };
    page.ready();
    let is_croton = |file: &String| file.ends_with("croton.txt");
    assert!(!page.server.requested().iter().any(is_croton), "nobody has asked for it");
    page.run("document.getElementById('from-figures').click()");
    assert_eq!(
        page.wait("the croton", |s| s.state == "ready" && !s.day.is_empty()).plant,
        "croton"
    );
    assert_eq!(page.run("return document.getElementById('stage').hasAttribute('data-live')"), true);
}

#[test]
fn the_days_of_a_row_are_pulled_together() {
    let Some(page) = Page::open(Graphics::WebGpu, &format!("#figures/{NUMBER}")) else { return };
    wait_for_row(&page, &expected());
    page.run(&format!(
        "const day = document.getElementById('figure-{NUMBER}').querySelector('.days input');
         day.value = 0;
         day.dispatchEvent(new Event('input', {{bubbles: true}}))"
    ));
    // The first cells are the same, whatever the pace of their divisions.
    page.wait_for(
        "day 0",
        &format!(
            "const row = document.getElementById('figure-{NUMBER}');
             const told = new Set([...row.querySelectorAll('.told')].map(e => e.textContent));
             return row.querySelector('output').textContent === 'Day 0'
                 && told.size === 1 && [...told][0].startsWith('Day 0: 6,000 cells')
                 && [...row.querySelectorAll('.picture')].every(a => a.hash.includes('d=0'))"
        ),
    );
}

/// The file of the figures' text, as it is asked for.
const TEXT: &str = "figures.txt";

#[test]
fn the_text_is_fetched_when_the_figures_are_opened() {
    let Some(page) = Page::open(Graphics::Neither, "#mushroom?v=1&s=1&d=1&df=20") else { return };
    page.on_day(1);
    // Whose recipe it is the page knows by itself.
    assert_eq!(page.text("source"), "Thesis, Fig. 4.15");
    assert!(!has_fetched(&page, TEXT));
    page.click("to-figures");
    let count = figures::all().len();
    let all = format!("return document.querySelectorAll('.figure').length === {count}");
    page.wait_for("all rows", &all);
    assert!(has_fetched(&page, TEXT));
}

/// Whether the page itself has fetched a file: the service worker keeps all of them.
fn has_fetched(page: &Page, file: &str) -> bool {
    let script = format!(
        "return performance.getEntriesByType('resource').some(e => e.name.includes('{file}'))"
    );
    page.run(&script) == true
}

#[test]
fn figures_that_do_not_come_are_told_and_asked_for_again() {
    let Some(page) = Page::start(Graphics::Neither) else { return };
    page.devtools("Network.enable", json!({}));
    page.devtools("Network.setBlockedURLs", json!({ "urls": [format!("*{TEXT}*")] }));
    page.visit(&format!("#figures/{NUMBER}"));
    let told = "const told = document.getElementById('figures-trouble');
                return told.checkVisibility() && told.textContent.includes('could not be loaded')
                    && document.documentElement.dataset.state === 'error'";
    page.wait_for("the trouble", told);
    assert_eq!(page.run("return document.querySelectorAll('.figure').length"), 0);
    page.devtools("Network.setBlockedURLs", json!({ "urls": [] }));
    page.run("document.querySelector('#figures-trouble button').click()");
    page.wait_for(
        "the row that was asked for",
        &format!(
            "const row = document.getElementById('figure-{NUMBER}');
             const top = row?.getBoundingClientRect().top;
             return !document.getElementById('figures-trouble').checkVisibility()
                 && top >= 0 && top < innerHeight"
        ),
    );
}

#[test]
fn leaves_by_numbers_grow_from_files_of_their_own() {
    let figure = figures::find("Viennot-19").expect("a row of leaves");
    let Some(page) = Page::open(Graphics::WebGpu, "#figures/4.8") else { return };
    page.ready();
    assert!(!has_fetched(&page, "own-figure-"), "nobody has looked at them");
    page.run(&format!("location.hash = '#figures/{}'", figure.number));
    page.wait_for(
        "the leaves",
        &format!(
            "const row = document.getElementById('figure-{}');
             return row && row.querySelectorAll('.picture[data-live]').length === {}
                 && document.documentElement.dataset.state === 'ready'",
            figure.number,
            figure.pictures.len()
        ),
    );
    let told = page.run(&format!(
        "const row = document.getElementById('figure-{}');
         return [...row.querySelectorAll('.told')].map(e => e.textContent)",
        figure.number
    ));
    let told: Vec<String> = serde_json::from_value(told).expect("texts");
    for (picture, told) in figure.pictures.iter().zip(&told) {
        assert_eq!(told, &natively(picture.link), "{}", picture.label);
    }

    // One opens as any plant, and its link anywhere.
    page.run(&format!(
        "document.getElementById('figure-{}').querySelectorAll('.picture')[3].click()",
        figure.number
    ));
    let state = page.ready();
    // The page knows the file by now: its link needs no words.
    let link = figure.pictures[3].link.split('~').next().unwrap();
    assert_eq!(
        (page.link().as_str(), state.plant.as_str()),
        (link, link.split('?').next().unwrap())
    );
    page.visit(&format!("#{link}"));
    let again = page.wait("the same leaf", |s| s.plant == state.plant && s.state == "ready");
    assert_eq!(again.fingerprint, state.fingerprint);
    assert_eq!(page.complaints(), [""; 0]);
}

/// What stands below the picture of a leaf by rule.
fn natively(link: &str) -> String {
    let (link, words) = link.split_once('~').expect("the words of its body");
    let own = Made::of_words(words).unwrap().own().unwrap();
    plants::bring(&own.text);
    let query = link.split_once('?').expect("a link").1;
    let scene = link::read(&format!("{}?{query}", own.key), plants::all()).scene;
    let mesh = Arc::new(scene.plant.grow_body(scene.plant.body.mesh.text).unwrap().surface);
    let mut growth = scene.plant.sow(mesh, scene.recipe, scene.individual).unwrap();
    while growth.step() != Progress::Day(scene.day) {}
    let count = growth.diary.count(scene.day as usize);
    let shares = words::shares(scene.plant, count);
    format!("{} cells, {shares}", words::grouped(count.cells))
}
