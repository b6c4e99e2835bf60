//! The studio: what is taken away is what the shell writes, byte for byte, and opens again.

use crate::engines::Graphics;
use crate::page::{Page, keys};
use clonal_mosaic::export::{DayNumbers, Kind, Order};
use clonal_mosaic::plants;
use clonal_mosaic::play::{Scene, link};
use clonal_mosaic::surface::Charts;
use clonal_mosaic::tissue::{Diary, Growth, Progress};
use serde_json::json;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

const LINK: &str = "philodendron?v=1&s=4&d=1";

/// A folder for the downloads of a test.
pub fn downloads(page: &Page, name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    page.devtools(
        "Page.setDownloadBehavior",
        json!({ "behavior": "allow", "downloadPath": folder }),
    );
    folder
}

/// Asks the studio for a file, and waits for it.
pub fn take(page: &Page, wanted: &str, file: &Path) -> Vec<u8> {
    page.run(&format!("document.querySelector('[data-take={wanted}]').click()"));
    let begun = Instant::now();
    loop {
        match fs::read(file) {
            Ok(bytes) if !bytes.is_empty() => return bytes,
            _ => std::thread::sleep(Duration::from_millis(50)),
        }
        let told = page.run("return document.querySelector('#take-away-dialog .work').innerText");
        assert!(begun.elapsed() < Duration::from_secs(240), "no {}: {told}", file.display());
    }
}

fn scene() -> Scene {
    link::read(LINK, plants::all()).scene
}

fn grown(mut growth: Growth) -> Diary {
    while !matches!(growth.step(), Progress::Done | Progress::Full) {}
    growth.diary
}

fn natively(kind: Kind) -> Vec<u8> {
    let scene = scene();
    let (order, growth) = Order::new(kind, &scene, scene.plant.embedded_body()).unwrap();
    let written = order.write(grown(growth), "").unwrap();
    written.files.into_iter().next().unwrap()
}

#[test]
fn what_is_taken_away_is_what_the_shell_writes_and_opens_again() {
    let Some(page) = Page::open(Graphics::WebGpu, &format!("#{LINK}")) else { return };
    page.on_day(1);
    let folder = downloads(&page, "taken");
    let file = |end: &str| folder.join(format!("philodendron-4-day-1.{end}"));
    assert!(!page.has_asked_for("studio"), "it is loaded when it is wanted");
    page.click("take-away");
    let shows = "const d = document.getElementById('take-away-dialog'); return !!(d && d.open)";
    page.wait_for("the studio", shows);
    assert!(
        page.run("return document.querySelector('#take-away-dialog .link').value")
            .as_str()
            .unwrap()
            .ends_with(LINK)
    );
    for (kind, end) in [(Kind::Glb, "glb"), (Kind::Svg, "svg"), (Kind::Cells, "csv")] {
        let bytes = take(&page, kind.word(), &file(end));
        assert!(bytes == natively(kind), "{} differs from what the shell writes", kind.word());
    }
    let document = take(&page, "document", &file("mosaic.json"));
    assert_eq!(
        plants::Plant::from_json(std::str::from_utf8(&document).unwrap()),
        Ok(scene().plant.clone())
    );

    // The picture, with its link inside, opens again.
    let png = take(&page, "picture", &file("png"));
    let mut reader = png::Decoder::new(std::io::Cursor::new(&png)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut pixels).unwrap();
    let seen = pixels.chunks_exact(4).filter(|pixel| pixel[3] == 255).count();
    assert!(seen > pixels.len() / 40, "{seen} pixels of a plant");
    let text = &reader.info().utf8_text[0];
    assert_eq!((text.keyword.as_str(), text.get_text().unwrap().as_str()), ("Link", LINK));

    page.press(&[keys::ESCAPE]);
    page.choose("watermelon");
    page.wait("another plant", |s| s.plant == "watermelon");
    page.drop("a.png", "image/png", &png);
    page.wait("the plant of the picture", |s| s.plant == "philodendron" && s.day == "1");
    assert_eq!(page.link(), LINK);
    page.drop("b.txt", "text/plain", b"nothing of ours");
    page.wait_for(
        "a word",
        "return document.getElementById('messages').innerText.includes('b.txt')",
    );
    assert_eq!(page.complaints(), [""; 0]);
}

#[test]
fn charts_say_the_numbers_of_the_growth_and_go_with_the_days() {
    let link = "croton-shrub?v=1&s=2&d=3&n=300&days=6";
    let Some(page) = Page::open(Graphics::Neither, &format!("#{link}")) else { return };
    page.on_day(3);
    page.click("charts");
    page.wait_for(
        "all charts",
        "const v = document.getElementById('charts-view');
         return !!v && v.querySelectorAll('.chart').length === 5 && !v.querySelector('.said').textContent",
    );
    let rows = page.run(
        "return [...document.querySelectorAll('#charts-view .chart:first-child tr')]
             .slice(1).map(row => [...row.cells].map(cell => cell.textContent))",
    );
    let scene = link::read(link, plants::all()).scene;
    let whole = Scene { day: scene.recipe.days, ..scene };
    let (order, growth) = Order::new(Kind::Days, &whole, whole.plant.embedded_body()).unwrap();
    let (diary, mut charts) = (grown(growth), Charts::new(order.mesh()));
    let numbers: Vec<DayNumbers> =
        (0..diary.days.len()).map(|day| order.numbers(&mut charts, &diary, day)).collect();
    assert_eq!(rows.as_array().unwrap().len(), 7);
    for (row, numbers) in rows.as_array().unwrap().iter().zip(&numbers) {
        assert_eq!(row[1], numbers.pattern.count.cells.to_string());
        assert_eq!(row[2], numbers.expected.unwrap().mean.to_string());
    }
    let read = "return document.querySelector('#charts-view .chart .read').textContent";
    assert!(page.run(read).as_str().unwrap().starts_with("day 3: "));
    page.drag_to_day(5.0);
    page.wait_for("the next day", "return document.querySelector('#charts-view .chart .read').textContent.startsWith('day 5: ')");
    assert_eq!(page.complaints(), [""; 0]);
}
