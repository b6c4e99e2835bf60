//! Films and large pictures: read by others, and compared with what the page shows.

use crate::base64;
use crate::engines::Graphics;
use crate::page::{Page, Picture, keys};
use crate::studio::{downloads, take};
use serde_json::json;
use std::path::Path;

const LINK: &str = "philodendron?v=1&s=4&d=1&days=3";
/// It opens.
const FLOWER: &str = "lotus?v=1&s=3&d=1&days=12";
const SIZE: (usize, usize) = (640, 360);

/// Chooses in the dialog.
fn choose(page: &Page, select: &str, value: &str) {
    page.run(&format!(
        "const e = document.querySelector('#take-away-dialog .{select}');
         if (e.type === 'checkbox') e.checked = '{value}' === 'yes'; else e.value = '{value}';
         e.dispatchEvent(new Event('change', {{bubbles: true}}))"
    ));
}

fn told(page: &Page, what: &str) -> String {
    let told = format!("return document.querySelector('#take-away-dialog .{what}').textContent");
    page.run(&told).as_str().unwrap().to_string()
}

fn open_dialog(page: &Page) {
    page.click("take-away");
    let shows = "const d = document.getElementById('take-away-dialog'); return !!(d && d.open)";
    page.wait_for("the studio", shows);
    let asked =
        "return /H.264|VP9|not in/.test(document.querySelector('.film-format').textContent)";
    page.wait_for("what the browser encodes", asked);
}

/// What the page shows of a link on a stage as large as the film.
fn as_seen(page: &Page, link: &str) -> Picture {
    page.devtools(
        "Emulation.setDeviceMetricsOverride",
        json!({ "width": SIZE.0, "height": SIZE.1, "deviceScaleFactor": 1, "mobile": false }),
    );
    page.visit(&format!("#{link}~ui=none"));
    page.ready();
    page.sharp();
    // The canvas fades in.
    std::thread::sleep(std::time::Duration::from_millis(600));
    let seen = Picture::decode(&page.png("#stage"));
    page.devtools("Emulation.clearDeviceMetricsOverride", json!({}));
    seen
}

/// Frames of an MP4 as a browser plays it, at times in seconds.
fn played(page: &Page, film: &[u8], times_s: &[f64]) -> Vec<Picture> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("host");
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join("film.mp4"), film).unwrap();
    page.go_to_host(&format!(
        "<link rel=icon href=data:><script>
         onload = async () => {{
             const video = document.createElement('video');
             video.muted = true;
             video.src = URL.createObjectURL(await (await fetch('film.mp4')).blob());
             await new Promise((done, fail) => {{ video.onloadeddata = done; video.onerror = fail }});
             const canvas = document.createElement('canvas');
             [canvas.width, canvas.height] = [video.videoWidth, video.videoHeight];
             const shown = [];
             for (const time of {times_s:?}) {{
                 await new Promise(done => {{ video.onseeked = done; video.currentTime = time }});
                 canvas.getContext('2d').drawImage(video, 0, 0);
                 shown.push(canvas.toDataURL().split(',')[1]);
             }}
             window.shown = shown;
         }}</script>"
    ));
    page.wait_for("the film to be played", "return !!window.shown");
    let shown: Vec<String> = serde_json::from_value(page.run("return window.shown")).unwrap();
    shown.iter().map(|png| Picture::decode(&base64::read(png))).collect()
}

/// That a film begins as day 0 is seen and ends as the last day is, but for so many levels of 256 in the mean.
fn assert_shows(frames: [&Picture; 2], days: [&Picture; 2], most: f64) {
    for (k, frame) in frames.into_iter().enumerate() {
        let off = [0, 1].map(|day| frame.difference(days[day]));
        assert!(off[k] < most && off[1 - k] > 1.5 * off[k], "frame {k}: {off:?} levels off");
    }
}

#[test]
fn a_flower_opens_in_a_film_from_day_0_to_the_last_day() {
    let Some(page) = Page::open(Graphics::WebGpu, &format!("#{FLOWER}")) else { return };
    page.on_day(1);
    let folder = downloads(&page, "filmed");
    assert!(!page.has_asked_for("darkroom"), "it is loaded when it is wanted");
    open_dialog(&page);
    // A long one is not waited for.
    choose(&page, "film-size", "1920 1080");
    choose(&page, "film-seconds", "16");
    page.run("document.querySelector('[data-take=film]').click()");
    page.wait_for(
        "a film to be begun",
        "return /Growing|of/.test(document.querySelector('#take-away-dialog .said').textContent)",
    );
    page.run("document.querySelector('#take-away-dialog .stop').click()");
    assert_eq!(told(&page, "said"), "Stopped.");
    choose(&page, "film-size", "640 360");
    choose(&page, "film-seconds", "4");
    assert!(told(&page, "film-told").starts_with("120 frames, 4 s, 640 × 360 pixels, up to"));
    let film = take(&page, "film", &folder.join("lotus-3-growth.mp4"));
    choose(&page, "film-format", "gif");
    assert_eq!(told(&page, "film-told"), "80 frames, 4 s, 640 × 360 pixels");
    let gif = take(&page, "film", &folder.join("lotus-3-growth.gif"));
    assert_eq!(page.state().day, "1", "the page is where it was");
    assert_eq!(page.complaints(), [""; 0]);

    let mp4 = re_mp4::Mp4::read_bytes(&film).unwrap();
    let track = mp4.tracks().values().next().unwrap();
    assert_eq!((usize::from(track.width), usize::from(track.height)), SIZE);
    assert_eq!((track.samples.len(), track.duration, track.timescale), (120, 120, 30));
    let shown: Vec<i64> = track.samples.iter().map(|s| s.composition_timestamp).collect();
    assert_eq!(shown, (0..120).collect::<Vec<i64>>());

    let days = [0, 12].map(|day| as_seen(&page, &FLOWER.replace("d=1&", &format!("d={day}&"))));
    let frames = played(&page, &film, &[0.5 / 30.0, 119.5 / 30.0]);
    assert_shows([&frames[0], &frames[1]], [&days[0], &days[1]], 3.0);

    let frames = frames_of_gif(&gif);
    assert_eq!(frames.len(), 80);
    assert_shows([&frames[0], &frames[79]], [&days[0], &days[1]], 5.0);

    // Films open again, too.
    for (name, bytes) in [("a.mp4", &film), ("a.gif", &gif)] {
        page.visit("#watermelon?v=1&s=2&d=0");
        page.on_day(0);
        open_dialog(&page);
        page.press(&[keys::ESCAPE]);
        page.drop(name, "application/octet-stream", bytes);
        page.wait("the plant of the film", |s| s.plant == "lotus" && s.day == "1");
        assert_eq!(page.link(), FLOWER);
    }
    assert_eq!(page.complaints(), [""; 0]);
}

/// The frames of a GIF as a browser would show them.
fn frames_of_gif(bytes: &[u8]) -> Vec<Picture> {
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let mut reader = options.read_info(bytes).unwrap();
    let (width, height) = (usize::from(reader.width()), usize::from(reader.height()));
    assert_eq!((width, height), SIZE);
    let mut rgb = vec![[0; 3]; width * height];
    let mut frames = Vec::new();
    while let Some(frame) = reader.read_next_frame().unwrap() {
        assert_eq!(frame.delay, 5);
        for (k, pixel) in frame.buffer.chunks_exact(4).enumerate().filter(|(_, p)| p[3] > 0) {
            let (x, y) = (k % usize::from(frame.width), k / usize::from(frame.width));
            let at = (usize::from(frame.top) + y) * width + usize::from(frame.left) + x;
            rgb[at] = [pixel[0], pixel[1], pixel[2]];
        }
        frames.push(Picture { width, height, rgb: rgb.clone() });
    }
    frames
}

/// A picture as it was taken away, with four bytes a pixel, its link and the pixels of a metre.
fn opened(bytes: &[u8]) -> (u32, u32, Vec<[u8; 4]>, String, u32) {
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    let pixels = match info.color_type {
        png::ColorType::Rgba => pixels.chunks_exact(4).map(|p| [p[0], p[1], p[2], p[3]]).collect(),
        _ => pixels.chunks_exact(3).map(|p| [p[0], p[1], p[2], 255]).collect(),
    };
    let text = &reader.info().utf8_text[0];
    assert_eq!(text.keyword, "Link");
    let per_metre = reader.info().pixel_dims.unwrap().xppu;
    (info.width, info.height, pixels, text.get_text().unwrap(), per_metre)
}

#[test]
fn large_pictures_are_what_the_page_shows_and_open_again() {
    let Some(page) = Page::open(Graphics::WebGpu, &format!("#{LINK}")) else { return };
    page.on_day(1);
    page.sharp();
    let seen = Picture::decode(&page.png("#stage"));
    let folder = downloads(&page, "enlarged");
    open_dialog(&page);
    let file = |size: &str| folder.join(format!("philodendron-4-day-1-{size}.png"));

    // As on the screen, before the stage, and of four times as many pixels.
    choose(&page, "sheet-caption", "no");
    choose(&page, "sheet-size", "2x");
    let size = format!("{} × {} pixels", 2 * seen.width, 2 * seen.height);
    assert_eq!(told(&page, "sheet-told"), size);
    let (width, height, pixels, link, per_metre) = opened(&take(&page, "sheet", &file("2x")));
    assert_eq!((width as usize, height as usize), (2 * seen.width, 2 * seen.height));
    assert_eq!((link.as_str(), per_metre), (LINK, 7559));
    let half = |k: usize| {
        let (x, y) = (k % seen.width, k / seen.width);
        let at = |dx: usize, dy: usize| pixels[(2 * y + dy) * width as usize + 2 * x + dx];
        let four = [at(0, 0), at(1, 0), at(0, 1), at(1, 1)];
        [0, 1, 2].map(|part| (four.iter().map(|p| u32::from(p[part])).sum::<u32>() / 4) as u8)
    };
    let halved = Picture {
        width: seen.width,
        height: seen.height,
        rgb: (0..seen.width * seen.height).map(half).collect(),
    };
    // What lies over the stage, such as its buttons, is no part of it.
    let off = halved.difference(&seen);
    assert!(off < 2.5, "{off} levels off what is on the screen");

    // A page of paper on nothing, with all that may stand there.
    choose(&page, "sheet-caption", "yes");
    choose(&page, "sheet-code", "yes");
    choose(&page, "sheet-ground", "");
    choose(&page, "sheet-size", "a4");
    assert_eq!(told(&page, "sheet-told"), "2480 × 3508 pixels");
    let png = take(&page, "sheet", &file("a4"));
    let (width, height, pixels, link, per_metre) = opened(&png);
    assert_eq!((width, height, link.as_str(), per_metre), (2480, 3508, LINK, 11_811));
    assert_eq!(pixels[0][3], 0, "nothing is behind it");
    let solid = pixels.iter().filter(|p| p[3] == 255).count();
    assert!(solid > pixels.len() / 10, "{solid} pixels of a plant");
    let grey = |x: usize, y: usize| match pixels[y * width as usize + x] {
        [.., 0] => 255,
        [r, g, b, _] => ((u32::from(r) + u32::from(g) + u32::from(b)) / 3) as u8,
    };
    let mut image = rqrr::PreparedImage::prepare_from_greyscale(2480, 3508, grey);
    let codes = image.detect_grids();
    assert_eq!(codes.len(), 1);
    assert!(codes[0].decode().unwrap().1.ends_with(&format!("#{LINK}")));
    // Ink of the caption, on the left of the band.
    let ink = (3300..3500).flat_map(|y| (0..1200).map(move |x| (x, y)));
    assert!(ink.filter(|&(x, y)| grey(x, y) < 100).count() > 2_000);

    page.press(&[keys::ESCAPE]);
    page.choose("watermelon");
    page.wait("another plant", |s| s.plant == "watermelon");
    page.drop("a.png", "image/png", &png);
    page.wait("the plant of the picture", |s| s.plant == "philodendron" && s.day == "1");
    assert_eq!(page.link(), LINK);
    assert_eq!(page.complaints(), [""; 0]);
}
