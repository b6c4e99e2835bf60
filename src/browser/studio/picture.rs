//! The picture that the page would print, and links as QR codes.

use crate::browser::dom::{find, set_attribute, set_flag};
use qrcodegen::{QrCode, QrCodeEcc};
use std::fmt::Write;
use wasm_bindgen::JsCast;
use web_sys::{CanvasRenderingContext2d, Element, HtmlCanvasElement, ImageData};

/// What is said where there is no code: the largest holds 2953 bytes.
pub const TOO_LONG: &str = "The link is too long for a QR code.";

/// The pixels of what the page has put there to be printed; None where nothing could be drawn.
pub fn pixels() -> Option<ImageData> {
    let canvas: HtmlCanvasElement = find("printed");
    let pen: CanvasRenderingContext2d = canvas.get_context("2d").ok()??.unchecked_into();
    let (width, height) = (canvas.width(), canvas.height());
    let pixels = pen.get_image_data(0.0, 0.0, width.into(), height.into()).ok()?;
    pixels.data().iter().any(|&part| part != 0).then_some(pixels)
}

/// The QR code of a text as the content of an SVG: its `viewBox`, and a path of dark squares. None where it is too
/// long for one.
pub fn qr(text: &str) -> Option<(String, String)> {
    // A long one only with less that may be lost of it.
    let code = QrCode::encode_text(text, QrCodeEcc::Medium);
    let code = code.or_else(|_| QrCode::encode_text(text, QrCodeEcc::Low)).ok()?;
    // Four light squares around it, as readers need.
    let (size, rim) = (code.size(), 4);
    let mut path = String::new();
    for y in 0..size {
        for x in (0..size).filter(|&x| code.get_module(x, y)) {
            let _ = write!(path, "M{} {}h1v1h-1z", x + rim, y + rim);
        }
    }
    let side = size + 2 * rim;
    Some((format!("0 0 {side} {side}"), path))
}

/// Draws the QR code of a text, or says in its place that the text is too long for one.
pub fn show_qr(code: &Element, text: &str) {
    if code.get_attribute("data-text").as_deref() == Some(text) {
        return;
    }
    let (view_box, path) = qr(text).unwrap_or_default();
    let is_too_long = path.is_empty();
    set_flag(code, "hidden", is_too_long);
    set_attribute(code, "data-text", text);
    set_attribute(code, "viewBox", view_box);
    code.set_inner_html(&format!("<path d=\"{path}\"/>"));
    let said =
        code.next_element_sibling().filter(|beside| beside.matches(".no-code").unwrap_or(false));
    match said {
        None if is_too_long => {
            let html = format!("<p class=no-code>{TOO_LONG}</p>");
            let _ = code.insert_adjacent_html("afterend", &html);
        }
        Some(said) if !is_too_long => said.remove(),
        _ => {}
    }
}
