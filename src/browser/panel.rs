//! The panel of parameters, made from their table.

use super::app;
use super::dom::{
    Listener, copy_of_template, find, on, set_attribute, set_flag, set_text, set_value, typed,
    watch_typing, within,
};
use crate::play::page::{Event, Page};
use crate::play::parameters::{PARAMETERS, Parameter};
use web_sys::{Element, HtmlElement, HtmlInputElement};

pub struct Panel {
    rows: Vec<Row>,
    reset: HtmlElement,
    noise: HtmlInputElement,
    plant: Option<&'static str>,
    _listeners: [Listener; 2],
}

struct Row {
    parameter: &'static Parameter,
    element: HtmlElement,
    range: HtmlInputElement,
    number: HtmlInputElement,
    reset: HtmlElement,
    _listeners: Vec<Listener>,
}

impl Panel {
    pub fn new() -> Panel {
        let list: Element = find("parameters");
        list.set_text_content(None);
        let rows = PARAMETERS.iter().map(|p| Row::new(p, &list)).collect();
        let reset: HtmlElement = find("reset");
        let noise: HtmlInputElement = find("noise");
        let switch = noise.clone();
        let listeners = [
            on(&reset, "click", |_: web_sys::Event| app::send(Event::ResetParameters)),
            on(&noise, "change", move |_: web_sys::Event| {
                app::send(Event::Noise(switch.checked()))
            }),
        ];
        Panel { rows, reset, noise, plant: None, _listeners: listeners }
    }

    pub fn show(&mut self, page: &Page) {
        let renamed = self.plant.replace(page.scene().plant.key) != self.plant;
        self.noise.set_checked(page.scene().noise);
        let mut changed = page.scene().noise;
        for row in &self.rows {
            changed |= row.show(page, renamed);
        }
        set_flag(&self.reset, "disabled", !changed);
    }
}

impl Row {
    fn new(parameter: &'static Parameter, list: &Element) -> Row {
        let element = copy_of_template("parameter-template");
        let range: HtmlInputElement = within(&element, "input[type=range]");
        let number: HtmlInputElement = within(&element, "input[type=number]");
        let reset: HtmlElement = within(&element, "button");
        let id = format!("parameter-{}", parameter.key);
        let hint = format!("{id}-hint");
        range.set_id(&id);
        set_attribute(&within(&element, "label"), "for", &id);
        within::<Element>(&element, ".hint").set_id(&hint);
        set_attribute(&range, "aria-describedby", &hint);
        for input in [&range, &number] {
            set_attribute(input, "min", parameter.range[0]);
            set_attribute(input, "max", parameter.range[1]);
        }
        // Sliders count their steps from 0, so that they meet round numbers.
        set_attribute(
            &range,
            "min",
            (parameter.range[0] / parameter.step).floor() * parameter.step,
        );
        set_attribute(&range, "step", parameter.step);
        set_attribute(&number, "step", "any");
        set_text(&within(&element, ".unit"), parameter.unit);
        let cost = if parameter.regrows { "grows again from day 0" } else { "seen at once" };
        set_text(&within(&element, ".cost"), cost);
        set_flag(&element, "data-live", !parameter.regrows);
        let change = |value: f64| app::send(Event::Change { key: parameter.key, value });
        let (hand, field) = (range.clone(), number.clone());
        let mut listeners = vec![
            on(&range, "input", move |_: web_sys::Event| {
                change(hand.value_as_number().max(parameter.range[0]));
            }),
            on(&number, "change", move |_: web_sys::Event| match typed(&field) {
                Some(value) => change(value),
                None => app::repaint(),
            }),
            on(&reset, "click", move |_: web_sys::Event| {
                app::reset_parameter(parameter);
            }),
        ];
        listeners.extend(watch_typing(&number));
        let _ = list.append_child(&element);
        Row { parameter, element, range, number, reset, _listeners: listeners }
    }

    /// Shows the value; true if it is not the preset's. `renamed`: the colours have other names.
    fn show(&self, page: &Page, renamed: bool) -> bool {
        let (parameter, scene) = (self.parameter, page.scene());
        if renamed {
            let label = parameter.label(scene.plant);
            set_text(&within(&self.element, "label"), &label);
            set_attribute(&self.number, "aria-label", format!("{label}, typed"));
            set_attribute(&self.reset, "aria-label", format!("{label}: back to the preset"));
            set_text(&within(&self.element, ".effect"), &parameter.effect(scene.plant));
        }
        let value = parameter.get(scene);
        set_value(&self.range, value);
        set_value(&self.number, value);
        let changed = value != parameter.preset(scene.plant);
        set_flag(&self.reset, "disabled", !changed);
        changed
    }
}
