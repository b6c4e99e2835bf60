//! A step on the page.

use super::list::{add, when};
use super::{LessonView, Place, root, sketch};
use crate::browser::dom::{set_attribute, set_flag, set_text};
use crate::play::lesson::{Guess, Kind, Said, Student};
use crate::play::typed;
use wasm_bindgen::JsCast;
use web_sys::{Element, HtmlElement, HtmlInputElement};

/// The name that the radio buttons of a question share.
const CHOICE: &str = "lesson-choice";

/// The prediction that stands in the form; in an error, what is missing.
pub fn said(view: &Element, guess: &Guess) -> Result<Said, &'static str> {
    let input = |selector: &str| {
        let found = view.query_selector(selector).ok().flatten();
        found.and_then(|input| input.dyn_into::<HtmlInputElement>().ok())
    };
    match guess {
        Guess::Choice { .. } => {
            let chosen = input(".ways :checked").and_then(|radio| radio.value().parse().ok());
            chosen.map(Said::Choice).ok_or("Choose one first.")
        }
        Guess::Bar { .. } => input(".ways input[data-touched]")
            .map(|bar| Said::Number(bar.value_as_number()))
            .ok_or("Move the bar first."),
        Guess::Sketch { .. } => {
            sketch::drawn(view).map(Said::Curve).ok_or("Give each day its point first.")
        }
        Guess::Number { .. } => {
            let text = input(".ways input").map(|input| input.value()).unwrap_or_default();
            let number = typed::number(&text, true);
            (number >= 0.0)
                .then_some(Said::Number(number))
                .ok_or("Type a number first: 1200, or 1,200.")
        }
    }
}

impl LessonView {
    /// Empties what steps and the list have in common.
    pub(super) fn clear(&mut self) {
        for part in [".text", ".students", ".ways", ".result", ".guess .refusal", ".said", ".taken"]
        {
            self.part::<Element>(part).set_text_content(None);
        }
        let (title, text): (Element, Element) = (self.part("#lesson-title"), self.part(".text"));
        let _ = title.insert_adjacent_element("afterend", &text);
        for part in [".guess", ".outcome"] {
            set_flag(&self.part(part), "hidden", true);
        }
    }

    /// Shows the step where the visitor is.
    pub(super) fn show_step(&mut self) {
        let Some(place) = self.place.clone() else { return };
        let Place { lesson, step, name } = &place;
        let (count, step_is) = (lesson.steps.len(), &lesson.steps[*step]);
        set_attribute(&root(), "data-lesson", step_is.word());
        self.clear();
        set_text(&self.part(".where"), &format!("{} · step {} of {count}", lesson.title, step + 1));
        set_text(&self.part("#lesson-title"), &step_is.title);
        for (part, hidden) in [
            (".lessons", true),
            (".own", true),
            (".take", false),
            ("footer", false),
            (".list", false),
        ] {
            set_flag(&self.part(part), "hidden", hidden);
        }
        set_flag(&self.part(".take"), "open", step + 1 == count);
        let sources: Element = self.part(".sources");
        sources.set_text_content(None);
        for source in &lesson.sources {
            add(&sources, "p", "hint", source);
        }
        let text: Element = self.part(".text");
        if *step == 0 {
            add(&text, "p", "hint", &[when(lesson), lesson.about.clone()].join(". "));
        }
        let said = self.answers.get(name).and_then(|answers| answers.said(*step));
        let is_grow = matches!(step_is.kind, Kind::Grow(_));
        if !is_grow {
            self.growth = None;
            step_is.text.iter().for_each(|paragraph| {
                add(&text, "p", "", paragraph);
            });
        }
        let mut may_go_on = true;
        let next_grows =
            lesson.steps.get(step + 1).is_some_and(|s| matches!(s.kind, Kind::Grow(_)));
        match &step_is.kind {
            Kind::Look | Kind::Play => {}
            Kind::Predict { ask, guess } => {
                may_go_on = said.is_some();
                self.show_guess(&place, ask, guess, said);
            }
            Kind::Grow(_) => self.grow(&place),
            Kind::Explain { students } => self.show_students(students),
        }
        let next: HtmlElement = self.part(".next");
        let word = match step + 1 {
            after if after == count => "All lessons",
            _ if next_grows => "Grow",
            _ => "Next",
        };
        set_text(&next, word);
        set_flag(&next, "disabled", !may_go_on);
        set_flag(&self.part(".back"), "disabled", *step == 0);
        let way: Element = self.part(".way");
        set_attribute(&way, "max", count.to_string());
        set_attribute(&way, "value", (step + 1).to_string());
        self.lay_worksheet_out(&place);
        self.begin();
    }

    fn show_guess(&self, place: &Place, ask: &str, guess: &Guess, said: Option<Said>) {
        set_flag(&self.part(".guess"), "hidden", false);
        set_text(&self.part(".ask"), ask);
        let ways: Element = self.part(".ways");
        match guess {
            Guess::Choice { choices, .. } => {
                for (k, choice) in choices.iter().enumerate() {
                    let label = add(&ways, "label", "choice", "");
                    let radio: HtmlInputElement = add(&label, "input", "", "").unchecked_into();
                    radio.set_type("radio");
                    radio.set_name(CHOICE);
                    radio.set_value(&k.to_string());
                    radio.set_checked(said == Some(Said::Choice(k)));
                    add(&label, "span", "", choice);
                }
            }
            Guess::Bar { of } => {
                let bar = add(&ways, "label", "bar", "");
                let output = add(&bar, "output", "", "– in 100");
                let range: HtmlInputElement = add(&bar, "input", "", "").unchecked_into();
                range.set_type("range");
                for (name, value) in [("min", "0"), ("max", "100"), ("step", "1")] {
                    set_attribute(&range, name, value);
                }
                set_attribute(&range, "aria-label", format!("{ask} {of}"));
                if let Some(Said::Number(number)) = said {
                    range.set_value(&number.to_string());
                    set_text(&output, &format!("{number} in 100"));
                }
                let ends = add(&ways, "p", "hint ends", "");
                for end in ["0", of, "100"] {
                    add(&ends, "span", "", end);
                }
            }
            Guess::Sketch { of, days } => {
                let said = match &said {
                    Some(Said::Curve(values)) => &values[..],
                    _ => &[],
                };
                sketch::show(&ways, of, days, said);
            }
            Guess::Number { of } => {
                let label = add(&ways, "label", "number", "");
                let input: HtmlInputElement = add(&label, "input", "", "").unchecked_into();
                set_attribute(&input, "inputmode", "decimal");
                set_attribute(&input, "autocomplete", "off");
                set_attribute(&input, "aria-label", format!("{ask} {of}"));
                add(&label, "span", "", of);
                if let Some(Said::Number(number)) = said {
                    input.set_value(&number.to_string());
                }
            }
        }
        set_flag(&self.part("fieldset"), "disabled", said.is_some());
        set_flag(&self.part(".guess .primary"), "hidden", said.is_some());
        if said.is_some() {
            let told = self.answers.get(&place.name).map(|a| a.told(&place.lesson, place.step));
            let told = format!("You said: {}. Now it stands.", told.unwrap_or_default());
            set_text(&self.part(".guess .said"), &told.replace("..", "."));
        }
    }

    fn show_students(&self, students: &[Student]) {
        let list: Element = self.part(".students");
        if !students.is_empty() {
            add(&list, "h3", "", "What is right about each?");
        }
        for student in students {
            let details = add(&list, "details", "", "");
            add(&details, "summary", "", &format!("“{}”", student.says));
            add(&details, "p", "", &student.reply);
        }
    }

    /// What grew, beside what was said.
    pub(super) fn show_result(&self, place: &Place) {
        let none = Default::default();
        let answers = self.answers.get(&place.name).unwrap_or(&none);
        let (lesson, step) = (&place.lesson, place.step);
        let (Some(grown), Kind::Grow(growing)) = (answers.grown(step), &lesson.steps[step].kind)
        else {
            return;
        };
        let result: Element = self.part(".result");
        result.set_text_content(None);
        let measured = crate::play::lesson::Answers::measured(lesson, step);
        if !measured.is_empty() {
            add(&result, "p", "measured", &measured);
        }
        let asked = lesson.asked_before(step);
        let said = asked.and_then(|asked| answers.said(asked));
        if let Some(days) = lesson.sketched_before(step) {
            let said = if let Some(Said::Curve(said)) = said { said } else { Vec::new() };
            let chart = crate::export::curves(&measured, days, &said, &grown.values);
            let _ = result.insert_adjacent_html("beforeend", &chart.to_svg(None));
            add(&result, "p", "hint", "Dashed: what you drew. The other curve grew.");
        } else if let Some(measure) = growing.measure.filter(|_| !grown.values.is_empty()) {
            let strip = crate::export::strip(grown, said, measure.is_share());
            let _ = result.insert_adjacent_html("beforeend", &strip);
            let dots =
                if grown.values.len() > 1 { "A dot is an individual" } else { "The dot grew" };
            let band = if grown.usual.is_some() { "; 95 in 100 end in the band." } else { "." };
            add(&result, "p", "hint", &format!("{dots}{band}"));
        }
        let list = add(&result, "dl", "", "");
        for (name, told) in answers.beside(lesson, step) {
            let line = add(&list, "div", "", "");
            add(&line, "dt", "", name);
            add(&line, "dd", "", &told);
        }
        let text: Element = self.part(".text");
        text.set_text_content(None);
        for paragraph in &lesson.steps[step].text {
            add(&text, "p", "", paragraph);
        }
        // Below what it explains.
        let outcome: Element = self.part(".outcome");
        let _ = outcome.insert_adjacent_element("afterend", &text);
        self.lay_worksheet_out(place);
    }
}
