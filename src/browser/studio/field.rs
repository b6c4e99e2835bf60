//! The numbers of a body by rule in their dialog: sliders, choices and what is typed, as words of links.

use wasm_bindgen::JsCast;
use web_sys::{Element, HtmlInputElement, HtmlSelectElement, HtmlTextAreaElement, Node, NodeList};

/// The choice of something that the numbers below say.
pub const TYPED: &str = "typed";

/// A number of the body in the dialog.
pub enum Field {
    Input(HtmlInputElement),
    Choice(HtmlSelectElement),
    Text(HtmlTextAreaElement),
}

impl Field {
    /// The field of an element by what that is.
    pub fn of(element: Element) -> Field {
        match &*element.tag_name() {
            "SELECT" => Field::Choice(element.unchecked_into()),
            "TEXTAREA" => Field::Text(element.unchecked_into()),
            _ => Field::Input(element.unchecked_into()),
        }
    }

    /// Its value as a word, if it is not the usual one.
    pub fn changed(&self) -> Option<String> {
        let element: &Element = match self {
            Field::Input(input) => input,
            Field::Choice(select) => select,
            Field::Text(area) => area,
        };
        // What is hidden says nothing; a number that a choice has brought is said even if it is the usual one.
        let chosen = element.closest("[data-if]").ok().flatten();
        if chosen.as_ref().is_some_and(|part| part.has_attribute("hidden")) {
            return None;
        }
        let (value, usual) = match self {
            Field::Input(input) if chosen.is_some() => (input.value(), String::new()),
            Field::Input(input) => (input.value(), input.default_value()),
            // Empty is usual, and of what is typed the field below says it.
            Field::Choice(select) => (select.value(), TYPED.into()),
            // A line is a row.
            Field::Text(area) => {
                let row = |row: &str| row.split_whitespace().collect::<Vec<_>>().join("_");
                let rows = area.value();
                let rows: Vec<String> =
                    rows.lines().map(row).filter(|row| !row.is_empty()).collect();
                (rows.join(";") + if rows.len() == 1 { ";" } else { "" }, String::new())
            }
        };
        (value != usual && !value.is_empty()).then_some(value)
    }

    /// Shows a word, or what is usual.
    pub fn set(&self, value: Option<&str>) {
        match self {
            Field::Input(input) => input.set_value(value.unwrap_or(&input.default_value())),
            Field::Choice(select) => {
                select.set_value(value.unwrap_or_default());
                if select.selected_index() < 0 {
                    let is_list = value.is_some_and(|value| value.contains('_'));
                    select.set_value(if is_list { TYPED } else { "" });
                }
            }
            Field::Text(area) => {
                if let Some(rows) = value.filter(|rows| rows.contains('_')) {
                    area.set_value(&rows.replace(';', "\n").replace('_', " "));
                }
            }
        }
    }
}

/// The elements within another that a selector finds.
pub fn each(parent: &Element, selector: &str) -> Vec<Element> {
    let found: Option<NodeList> = parent.query_selector_all(selector).ok();
    let found = found.iter().flat_map(|all| (0..all.length()).filter_map(|k| all.item(k)));
    found.map(|node: Node| node.unchecked_into()).collect()
}
