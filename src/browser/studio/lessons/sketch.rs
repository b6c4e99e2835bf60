//! A curve that is drawn: with a pointer across its field, or day by day with the keys of a slider each.

use super::list::add;
use crate::browser::dom::{set_attribute, set_text, within};
use wasm_bindgen::JsCast;
use web_sys::{Element, EventInit, HtmlInputElement, NodeList, PointerEvent};

/// Puts the field there for these days, with what was said if something was.
pub fn show(ways: &Element, of: &str, days: &[u32], said: &[f64]) {
    let field = add(ways, "div", "sketch", "");
    let svg = "<svg preserveAspectRatio=none aria-hidden=true><polyline/></svg>";
    let _ = field.insert_adjacent_html("beforeend", svg);
    for (k, day) in days.iter().enumerate() {
        let label = add(&field, "label", "", "");
        let range: HtmlInputElement = add(&label, "input", "", "").unchecked_into();
        range.set_type("range");
        for (name, value) in [("min", "0"), ("max", "100"), ("step", "1")] {
            set_attribute(&range, name, value);
        }
        set_attribute(&range, "aria-label", format!("Day {day}, {of}"));
        if let Some(value) = said.get(k) {
            range.set_value(&value.to_string());
            set_attribute(&range, "data-touched", "");
        }
        add(&label, "output", "", "");
        add(&label, "span", "hint", &format!("Day {day}"));
    }
    add(
        ways,
        "p",
        "hint",
        "Draw across it from the first day to the last, or use the arrow keys on each day.",
    );
    trace(ways);
}

/// What was drawn, in 100, if each day has its point.
pub fn drawn(view: &Element) -> Option<Vec<f64>> {
    let ranges = ranges(view);
    let values = ranges
        .iter()
        .map(|range| range.has_attribute("data-touched").then(|| range.value_as_number()));
    values.collect()
}

/// Draws the line through the points that are there, and says them.
pub fn trace(ways: &Element) {
    let ranges = ranges(ways);
    if ranges.is_empty() {
        return;
    }
    let mut points = String::new();
    for (k, range) in
        ranges.iter().enumerate().filter(|(_, range)| range.has_attribute("data-touched"))
    {
        points += &format!("{},{} ", 10 * k + 5, 100.0 - range.value_as_number());
        set_attribute(range, "aria-valuetext", format!("{} in 100", range.value()));
        if let Some(output) = range.next_element_sibling() {
            set_text(&output, &range.value());
        }
    }
    let svg: Element = within(ways, ".sketch svg");
    set_attribute(&svg, "viewBox", format!("0 0 {} 100", 10 * ranges.len()));
    set_attribute(&within(&svg, "polyline"), "points", points);
}

/// The pointer that draws over the field gives the day below it its point.
pub fn draw(event: &PointerEvent) {
    let target = event.target().and_then(|target| target.dyn_into::<Element>().ok());
    let Some(svg) = target.and_then(|target| target.closest(".sketch svg").ok().flatten()) else {
        return;
    };
    let Some(field) = svg.parent_element().filter(|_| event.buttons() & 1 == 1) else { return };
    // Fails only for pointers that are gone already.
    let _ = svg.set_pointer_capture(event.pointer_id());
    let (ranges, place) = (ranges(&field), svg.get_bounding_client_rect());
    let across = (f64::from(event.client_x()) - place.left()) / place.width();
    let up = 1.0 - (f64::from(event.client_y()) - place.top()) / place.height();
    let day = (across * ranges.len() as f64).floor().clamp(0.0, ranges.len() as f64 - 1.0);
    let range = &ranges[day as usize];
    if range.matches(":disabled").unwrap_or(true) {
        return;
    }
    range.set_value(&(100.0 * up).clamp(0.0, 100.0).round().to_string());
    let init = EventInit::new();
    init.set_bubbles(true);
    if let Ok(event) = web_sys::Event::new_with_event_init_dict("input", &init) {
        let _ = range.dispatch_event(&event);
    }
}

fn ranges(parent: &Element) -> Vec<HtmlInputElement> {
    let found = parent.query_selector_all(".sketch input").ok();
    let items = |all: NodeList| (0..all.length()).filter_map(move |k| all.item(k));
    found.into_iter().flat_map(items).map(JsCast::unchecked_into).collect()
}
