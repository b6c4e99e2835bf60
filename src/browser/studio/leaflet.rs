//! On paper: the link as a QR code beside the picture that the page prints, and a page of all numbers of a plant.

use super::{picture, subject};
use crate::browser::dom::{document, find, on, set_attribute, window, within};
use crate::plants;
use crate::play::parameters::PARAMETERS;
use crate::play::{link, words};
use std::fmt::Write;
use wasm_bindgen::JsCast;
use web_sys::{CanvasRenderingContext2d, Element, Event, HtmlCanvasElement};

/// Has the page print the QR code of its link, too.
pub fn print_code() {
    let caption = document().query_selector(".caption").ok().flatten();
    let caption = caption.expect("a plant has a caption");
    let html = "<svg id=printed-code class='printed qr' role=img aria-label='The link as a QR code'></svg>";
    let _ = caption.insert_adjacent_html("beforeend", html);
    // After the page, which has written its link by then.
    std::mem::forget(on(&window(), "beforeprint", |_: Event| {
        subject::print_origin();
        let address = find::<Element>("printed-link").text_content().unwrap_or_default();
        picture::show_qr(&find("printed-code"), &format!("{address}{}", super::pupils::beside()));
    }));
    std::mem::forget(on(&window(), "afterprint", |_: Event| {
        if let Some(leaflet) = document().get_element_by_id("leaflet") {
            leaflet.remove();
        }
    }));
}

/// Prints a page of a plant: its picture, every number of it but those that are to be found out, and an address.
pub fn print(link: &str, address: &str, hidden: &[&str]) {
    let scene = link::read(link, plants::all()).scene;
    let plant = scene.plant;
    let mut rows = String::new();
    for number in PARAMETERS.iter().filter(|number| number.is_for(plant)) {
        let (value, own) = (number.get(&scene), number.preset(plant));
        let value = match hidden.contains(&number.key) {
            true => "<span class=blank>?</span>".to_string(),
            false if value != own => {
                format!("<b>{}</b> (else {})", number.said(value), number.said(own))
            }
            false => number.said(value),
        };
        let [least, greatest] = number.range.map(|end| number.written(end));
        let _ = write!(
            rows,
            "<tr><th scope=row>{}</th><td>{}</td><td>{value}</td><td><code>{}</code></td><td>{least} to {greatest}</td></tr>",
            number.label(plant),
            number.symbol,
            number.key
        );
    }
    let source = if hidden.is_empty() { words::source(&scene) } else { String::new() };
    let html = format!(
        "<article id=leaflet class=leaflet><header><div><h1>{}</h1><p><i lang=la>{}</i></p>\
         <p>Individual {}, day {} of {}. {source}</p><p class=link></p></div>\
         <svg class=qr role=img aria-label='The link as a QR code'></svg><canvas></canvas></header>\
         <table><thead><tr><th>Number</th><th>Symbol</th><th>Here</th><th>In links</th><th>Range</th></tr></thead>\
         <tbody>{rows}</tbody></table>\
         <p class=hint>Grown cell by cell by the Clonal Mosaic model. The same link grows the same cells on every machine.</p></article>",
        plant.name, plant.latin, scene.individual, scene.day, scene.recipe.days
    );
    let body = document().body().expect("a page has a body");
    let _ = body.insert_adjacent_html("beforeend", &html);
    let leaflet: Element = find("leaflet");
    picture::show_qr(&within(&leaflet, ".qr"), address);
    // An address would tell what is to be found out.
    let shown = if hidden.is_empty() { address } else { "" };
    within::<Element>(&leaflet, ".link").set_text_content(Some(shown));
    copy_picture(&within(&leaflet, "canvas"));
    let _ = window().print();
}

/// Copies what the page has drawn to be printed.
fn copy_picture(canvas: &HtmlCanvasElement) {
    // It is asked to draw it anew, or it may be another plant's.
    subject::address();
    let drawn: HtmlCanvasElement = find("printed");
    set_attribute(canvas, "width", drawn.width().to_string());
    set_attribute(canvas, "height", drawn.height().to_string());
    if let Ok(Some(pen)) = canvas.get_context("2d") {
        let pen: CanvasRenderingContext2d = pen.unchecked_into();
        let _ = pen.draw_image_with_html_canvas_element(&drawn, 0.0, 0.0);
    }
}
