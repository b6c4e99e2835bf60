//! For a class: the presenter, numbers to be found out, simple sliders, and what is printed.

use crate::base64;
use crate::engines::Graphics;
use crate::page::{Page, keys};
use clonal_mosaic::plants;
use clonal_mosaic::play::link;
use serde_json::json;
use std::time::Duration;

const LINK: &str = "croton-shrub?v=1&s=2&d=3&n=300&pf=0.3&days=6";

/// Waits until a view is open, which the page says of itself.
#[track_caller]
fn view(page: &Page, name: &str) {
    let is_open = format!("return document.documentElement.dataset.view === '{name}'");
    page.wait_for(name, &is_open);
}

fn is_seen(page: &Page, css: &str) -> bool {
    page.run(&format!("return document.querySelector('{css}').checkVisibility()")) == true
}

/// What the QR code that is seen there says, read off its pixels.
pub fn read_code(page: &Page, css: &str) -> String {
    let png = page.png(css);
    let mut reader = png::Decoder::new(std::io::Cursor::new(png)).read_info().unwrap();
    let mut data = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut data).unwrap();
    let (width, step) = (info.width as usize, info.color_type.samples());
    let grey = |x: usize, y: usize| data[(y * width + x) * step];
    let mut image = rqrr::PreparedImage::prepare_from_greyscale(width, info.height as usize, grey);
    let codes = image.detect_grids();
    assert_eq!(codes.len(), 1, "one code in {css}");
    codes[0].decode().expect("a whole code").1
}

#[test]
fn the_presenter_goes_by_keys_and_its_code_is_the_link() {
    let Some(page) = Page::open(Graphics::Neither, &format!("#{LINK}~present")) else { return };
    page.on_day(3);
    view(&page, "presenter");
    for css in ["#panel", ".timeline", ".masthead", ".caption"] {
        assert!(!is_seen(&page, css), "{css}");
    }
    let number = |day: u32| {
        page.on_day(day);
        page.wait_for(
            "the day in large type",
            &format!("return document.querySelector('.presenter .number').textContent === '{day}'"),
        );
    };
    number(3);
    for (key, day) in [
        (keys::RIGHT, 4),
        (keys::PAGE_DOWN, 5),
        (keys::LEFT, 4),
        (keys::PAGE_UP, 3),
        (keys::END, 6),
        (keys::HOME, 0),
        (keys::RIGHT, 1),
    ] {
        page.press(&[key]);
        number(day);
    }
    let here = page.run("return location.href.split('#')[0]");
    let address = format!("{}#{}", here.as_str().unwrap(), LINK.replace("d=3", "d=1"));
    page.wait_for(
        "the code of the day",
        &format!("return document.querySelector('.presenter .qr').dataset.text === '{address}'"),
    );
    assert_eq!(read_code(&page, ".presenter .qr"), address);
    let share = page.run(
        "return document.querySelector('.presenter .qr').getBoundingClientRect().height / innerHeight",
    );
    assert!(share.as_f64().unwrap() > 0.22, "{share} of the height");
    page.press(&[keys::SPACE]);
    page.wait_for("play", "return document.getElementById('play').hasAttribute('data-playing')");
    page.press(&[keys::SPACE]);
    page.wait_for("pause", "return !document.getElementById('play').hasAttribute('data-playing')");
    page.press(&[keys::ESCAPE]);
    view(&page, "plant");
    assert!(is_seen(&page, "#panel") && !is_seen(&page, "#presenter"));
    assert!(!page.link().contains('~'), "{}", page.link());
    // The stage has the focus again.
    page.press(&["h"]);
    view(&page, "presenter");
    page.press(&["h"]);
    view(&page, "plant");
    page.fill_in("individual", "7h");
    view(&page, "plant");
    assert_eq!(page.complaints(), [""; 0]);
}

#[test]
fn numbers_to_be_found_out_are_hidden_until_the_answer() {
    let Some(page) = Page::open(Graphics::Neither, &format!("#{LINK}")) else { return };
    page.on_day(3);
    page.click("class");
    page.wait_for("the dialog", "return document.getElementById('class-dialog')?.open === true");
    page.run(
        "const d = document.getElementById('class-dialog');
         d.querySelector('details').open = true;
         for (const css of ['[data-part=plants]', '[data-part=figures]', '[data-number=pf]', '[data-number=df]'])
             d.querySelector(css).click()",
    );
    let value = |css: &str| {
        let script = format!("return document.querySelector('#class-dialog {css}').value");
        page.run(&script).as_str().unwrap().to_string()
    };
    let here = page.run("return location.href.split('#')[0]");
    let for_students = value(".link");
    let wanted = format!(
        "{}#{LINK}~class/only=individual,show,recipe,charts,take,hide=pf,df",
        here.as_str().unwrap()
    );
    assert_eq!(for_students, wanted);
    assert_eq!(value(".teacher"), format!("{wanted},answers"));
    assert!(value(".embed").contains(&wanted.replace('&', "&amp;")));
    assert_eq!(read_code(&page, "#class-dialog .qr"), wanted);
    page.press(&[keys::ESCAPE]);

    page.go(&for_students);
    page.on_day(3);
    view(&page, "class");
    page.run("document.querySelector('.recipe').open = true");
    for css in [
        "#parameter-pf",
        "#parameter-df",
        "#source",
        "#plants",
        "#to-figures",
        "#copy-link",
        "#take-away",
        "#class",
    ] {
        assert!(!is_seen(&page, css), "{css}");
    }
    for css in ["#parameter-db", "#individual", "#charts", "#parameter-rs"] {
        assert!(is_seen(&page, css), "{css}");
    }
    assert_eq!(page.run("return document.getElementById('parameter-pf').disabled"), true);
    let told = "return document.querySelector('#pupils p').textContent";
    assert_eq!(
        page.run(told),
        "Hidden here: First cells that are yellow; Days between divisions, yellow."
    );
    // Another individual leaves it as it is.
    page.click("another");
    page.wait("another one", |s| s.state == "ready" && s.individual != "2");
    assert!(page.link().ends_with("hide=pf,df"), "{}", page.link());
    page.run("document.querySelector('#pupils button').click()");
    page.wait_for("the answer", "return location.hash.endsWith(',answers')");
    page.wait_for("the number", "return document.getElementById('parameter-pf').checkVisibility()");
    let told = page.run(told).as_str().unwrap().to_string();
    assert!(told.starts_with("The answer: First cells that are yellow (pf): 0.3 share;"), "{told}");
    assert_eq!(page.run("return document.getElementById('parameter-pf').disabled"), false);
    assert!(is_seen(&page, "#source"));
    assert_eq!(page.complaints(), [""; 0]);
}

#[test]
fn the_presenter_of_a_class_hides_what_the_class_is_to_find_out() {
    let beside = "~class/only=simple,hide=df";
    let Some(page) = Page::open(Graphics::Neither, &format!("#{LINK}{beside}")) else { return };
    page.on_day(3);
    view(&page, "class");
    let shut = page.run(
        "return [...document.querySelectorAll('#simple-view input')].map(input => input.disabled)",
    );
    assert_eq!(shut, json!([false, false, true, false]));
    page.run("document.getElementById('stage').focus()");
    page.press(&["h"]);
    view(&page, "presenter");
    assert!(read_code(&page, ".presenter .qr").ends_with(&format!("{LINK}{beside}")));
    page.press(&[keys::ESCAPE]);
    view(&page, "class");
    assert!(page.link().ends_with(beside), "{}", page.link());
}

#[test]
fn simple_sliders_move_numbers_and_the_page_takes_them_back() {
    let Some(page) = Page::open(Graphics::Neither, "#croton-shrub?v=1&s=2&d=2~simple") else {
        return;
    };
    let before = page.on_day(2);
    view(&page, "simple");
    page.run(
        "const slider = document.getElementById('simple-amount');
         slider.value = 90;
         slider.dispatchEvent(new Event('input', {bubbles: true}))",
    );
    let moves = "return document.querySelector('#simple-amount-moves').textContent";
    let told = page.run(moves).as_str().unwrap().to_string();
    assert!(told.starts_with("First cells that are yellow (pf) 0.8"), "{told}");
    page.wait_for("the link", "return location.hash.includes('pf=0.8')");
    let after = page.on_day(2);
    assert_ne!(after.fingerprint, before.fingerprint);
    assert!(page.link().ends_with("~simple"), "{}", page.link());
    page.run("document.querySelector('#simple-view [data-do=undo]').click()");
    page.wait("the plant of before", |s| s.state == "ready" && s.fingerprint == before.fingerprint);
    page.wait_for("the slider", "return document.getElementById('simple-amount').value === '50'");
    page.run("document.querySelector('#simple-view [data-do=surprise]').click()");
    page.wait("a surprise", |s| s.state == "ready" && s.fingerprint != before.fingerprint);
    let scene = link::read(&page.link(), plants::all());
    assert_eq!((scene.left_out, scene.scene.day), (vec![], 2));
    page.run("document.querySelector('#simple-view [data-do=own]').click()");
    page.wait("its own", |s| s.state == "ready" && s.fingerprint == before.fingerprint);
    page.run("document.querySelector('#simple-view .close').click()");
    view(&page, "plant");
    assert_eq!(page.complaints(), [""; 0]);
}

#[test]
fn on_paper_stand_the_code_and_a_page_of_numbers() {
    let Some(page) = Page::open(Graphics::Neither, &format!("#{LINK}")) else { return };
    page.on_day(3);
    page.run("window.print = () => window.dispatchEvent(new Event('beforeprint'))");
    page.click("class");
    page.wait_for("the dialog", "return document.getElementById('class-dialog')?.open === true");
    page.run("document.querySelector('#class-dialog [data-do=print]').click()");
    let rows = page.run(
        "return [...document.querySelectorAll('#leaflet tbody tr')].map(row => row.innerText)",
    );
    assert!(rows.to_string().contains("0.3 share (else 0.5 share)"), "{rows}");
    page.devtools("Emulation.setEmulatedMedia", json!({ "media": "print" }));
    // As many dots as the worst of printers has.
    page.devtools(
        "Emulation.setDeviceMetricsOverride",
        json!({ "width": 794, "height": 1123, "deviceScaleFactor": 3, "mobile": false }),
    );
    assert!(is_seen(&page, "#leaflet") && !is_seen(&page, "#playground"));
    assert!(read_code(&page, "#leaflet .qr").ends_with(LINK));
    let pdf = page.devtools("Page.printToPDF", json!({ "printBackground": false }));
    let pdf = base64::read(pdf["data"].as_str().unwrap());
    let pages = String::from_utf8_lossy(&pdf).matches("/Type /Page\n").count();
    assert!(pages <= 1, "{pages} pages");
    page.run("window.dispatchEvent(new Event('afterprint'))");
    assert!(is_seen(&page, "#printed-code") && !is_seen(&page, "#panel"));
    assert!(read_code(&page, "#printed-code").ends_with(LINK));
    assert_eq!(page.complaints(), [""; 0]);
}

#[test]
fn all_of_it_fits_on_a_phone() {
    let Some(page) = Page::start(Graphics::Neither) else { return };
    page.devtools(
        "Emulation.setDeviceMetricsOverride",
        json!({ "width": 390, "height": 844, "deviceScaleFactor": 1, "mobile": true }),
    );
    let fits = |what: &str| {
        std::thread::sleep(Duration::from_millis(300));
        let wide = page.run(
            "return [...document.querySelectorAll('.presenter *, dialog[open] *, #simple-view *, #pupils *')]
                 .filter(e => e.checkVisibility() && !e.closest('.unseen'))
                 .filter(e => { const b = e.getBoundingClientRect(); return b.right > 391 || b.left < -1 })
                 .map(e => e.outerHTML.slice(0, 80))",
        );
        assert_eq!(wide, json!([]), "{what}");
    };
    for (beside, name) in
        [("present", "presenter"), ("simple", "simple"), ("class/only=individual,hide=pf", "class")]
    {
        page.visit(&format!("#{LINK}~{beside}"));
        page.on_day(3);
        view(&page, name);
        fits(name);
    }
    page.visit(&format!("#{LINK}"));
    page.on_day(3);
    page.run("document.getElementById('class').click()");
    page.wait_for("the dialog", "return document.getElementById('class-dialog')?.open === true");
    page.run("document.querySelector('#class-dialog details').open = true");
    fits("the dialog");
}
