//! The panel of parameters, made from their table.

use super::app;
use super::dom::{Listener, copy_of_template, find, on, set_attribute, set_flag, set_text, within};
use super::typing::{self, set_value};
use crate::play::Scene;
use crate::play::page::{Event, Page};
use crate::play::parameters::{PARAMETERS, Parameter};
use crate::surface::Shortest;
use web_sys::{Element, HtmlElement, HtmlInputElement, HtmlOptionElement, HtmlSelectElement};

pub struct Panel {
    rows: Vec<Row>,
    reset: HtmlElement,
    /// Goes to the plant with the numbers of the thesis.
    thesis: Element,
    noise: HtmlInputElement,
    plant: Option<&'static str>,
    _listeners: [Listener; 2],
}

struct Row {
    parameter: &'static Parameter,
    element: HtmlElement,
    input: Input,
    reset: HtmlElement,
    _listeners: Vec<Listener>,
}

enum Input {
    Number { range: HtmlInputElement, number: HtmlInputElement, refusal: Element },
    Choice(HtmlSelectElement),
    Colour(HtmlInputElement),
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
        Panel { rows, reset, thesis: find("thesis"), noise, plant: None, _listeners: listeners }
    }

    pub fn show(&mut self, page: &Page) {
        let Scene { plant, individual, .. } = page.scene();
        let renamed = self.plant.replace(plant.key) != self.plant;
        let has_changed = plant.under(1).is_some_and(|first| first.rules != plant.rules);
        set_flag(&self.thesis, "hidden", !has_changed);
        set_attribute(&self.thesis, "href", format!("#{}?v=1&s={individual}", plant.key));
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
        let (template, make): (_, fn(_, &_, &mut _) -> _) = match () {
            () if parameter.is_colour => ("colour-template", Input::colour),
            () if parameter.names.is_empty() => ("parameter-template", Input::number),
            () => ("choice-template", Input::choice),
        };
        let element = copy_of_template(template);
        let id = format!("parameter-{}", parameter.key);
        let hint = format!("{id}-hint");
        set_attribute(&within(&element, "label"), "for", &id);
        within::<Element>(&element, ".hint").set_id(&hint);
        let cost = if parameter.regrows { "grows again from day 0" } else { "seen at once" };
        set_text(&within(&element, ".cost"), cost);
        set_flag(&element, "data-live", !parameter.regrows);
        let reset: HtmlElement = within(&element, "button");
        let mut listeners = vec![on(&reset, "click", move |_: web_sys::Event| {
            app::reset_parameter(parameter);
        })];
        let input = make(parameter, &element, &mut listeners);
        set_attribute(input.main(), "id", &id);
        set_attribute(input.main(), "aria-describedby", &hint);
        let _ = list.append_child(&element);
        Row { parameter, element, input, reset, _listeners: listeners }
    }

    /// Shows the value; true if it is not the preset's. `renamed`: the plant is another one.
    fn show(&self, page: &Page, renamed: bool) -> bool {
        let (parameter, scene) = (self.parameter, page.scene());
        if renamed {
            set_flag(&self.element, "hidden", !parameter.is_for(scene.plant));
            let label = parameter.label(scene.plant);
            set_text(&within(&self.element, "label .name"), &label);
            set_attribute(&self.reset, "aria-label", format!("{label}: back to the preset"));
            set_text(&within(&self.element, ".effect"), &parameter.effect(scene.plant));
            if let Input::Number { number, .. } = &self.input {
                set_attribute(number, "aria-label", format!("{label}, typed"));
            }
        }
        let value = parameter.get(scene);
        match &self.input {
            Input::Number { range, number, refusal } => {
                set_value(range, &parameter.position(value).shortest());
                set_attribute(range, "aria-valuetext", parameter.said(value));
                typing::show(number, &value.shortest(), refusal, page.refusal(parameter.key));
                let remark = page.remark(parameter.key);
                set_text(&within(&self.element, ".remark"), &remark.unwrap_or_default());
            }
            Input::Choice(select) => select.set_selected_index(value as i32),
            Input::Colour(colour) => colour.set_value(&parameter.said(value)),
        }
        let changed = value != parameter.preset(scene.plant);
        set_flag(&self.reset, "disabled", !changed);
        changed
    }
}

impl Input {
    /// A slider and a field to type in.
    fn number(
        parameter: &'static Parameter,
        element: &Element,
        listeners: &mut Vec<Listener>,
    ) -> Input {
        let range: HtmlInputElement = within(element, "input[type=range]");
        let number: HtmlInputElement = within(element, "input[inputmode]");
        let [least, greatest, step] = parameter.track();
        for (name, value) in [("min", least), ("max", greatest), ("step", step)] {
            set_attribute(&range, name, value.shortest());
        }
        set_text(&within(element, ".symbol"), parameter.symbol);
        set_text(&within(element, ".unit"), parameter.unit);
        let hand = range.clone();
        listeners.push(on(&range, "input", move |_: web_sys::Event| {
            change(parameter, parameter.at(hand.value_as_number()));
        }));
        let take = move |value| change(parameter, value);
        listeners.extend(typing::watch(&number, parameter.step, take));
        Input::Number { range, number, refusal: within(element, ".refusal") }
    }

    /// A list of the names.
    fn choice(
        parameter: &'static Parameter,
        element: &Element,
        listeners: &mut Vec<Listener>,
    ) -> Input {
        let select: HtmlSelectElement = within(element, "select");
        for name in parameter.names {
            if let Ok(option) = HtmlOptionElement::new_with_text(name) {
                let _ = select.append_child(&option);
            }
        }
        let chosen = select.clone();
        listeners.push(on(&select, "change", move |_: web_sys::Event| {
            change(parameter, f64::from(chosen.selected_index()));
        }));
        Input::Choice(select)
    }

    /// The browser's own way to choose a colour.
    fn colour(
        parameter: &'static Parameter,
        element: &Element,
        listeners: &mut Vec<Listener>,
    ) -> Input {
        let colour: HtmlInputElement = within(element, "input");
        let chosen = colour.clone();
        listeners.push(on(&colour, "input", move |_: web_sys::Event| {
            if let Ok(value) = parameter.read(&chosen.value()) {
                change(parameter, value);
            }
        }));
        Input::Colour(colour)
    }

    /// The element that the label belongs to.
    fn main(&self) -> &Element {
        match self {
            Input::Number { range, .. } => range,
            Input::Choice(select) => select,
            Input::Colour(colour) => colour,
        }
    }
}

fn change(parameter: &'static Parameter, value: f64) {
    app::send(Event::Change { key: parameter.key, value });
}
