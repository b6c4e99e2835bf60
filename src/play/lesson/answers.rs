//! What a visitor has said in a lesson, and what came out. It is kept nowhere else.

use super::measure::{Usual, rounded};
use super::{Guess, Kind, Lesson};
use crate::plants;
use crate::play::link;
use std::collections::BTreeMap;
use std::fmt::Write;

/// A prediction.
#[derive(Clone, Debug, PartialEq)]
pub enum Said {
    Choice(usize),
    /// A bar's or a typed number.
    Number(f64),
    /// In 100, for each day of a sketch.
    Curve(Vec<f64>),
}

/// What came out of a step's growth: a value for each individual, or for each day of a curve, and what is to be expected of one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Grown {
    pub values: Vec<f64>,
    pub usual: Option<Usual>,
}

/// By the number of the step, from 0.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Answers {
    said: BTreeMap<usize, Said>,
    grown: BTreeMap<usize, Grown>,
}

impl Answers {
    /// Takes a prediction; the first one counts.
    pub fn say(&mut self, step: usize, said: Said) {
        self.said.entry(step).or_insert(said);
    }

    pub fn said(&self, step: usize) -> Option<Said> {
        self.said.get(&step).cloned()
    }

    pub fn grow(&mut self, step: usize, grown: Grown) {
        self.grown.insert(step, grown);
    }

    pub fn grown(&self, step: usize) -> Option<&Grown> {
        self.grown.get(&step)
    }

    /// What was said at a step, in words; empty if nothing was.
    pub fn told(&self, lesson: &Lesson, step: usize) -> String {
        let guess = lesson.steps.get(step).and_then(|step| match &step.kind {
            Kind::Predict { guess, .. } => Some(guess),
            _ => None,
        });
        match (guess, self.said(step)) {
            (Some(Guess::Choice { choices, .. }), Some(Said::Choice(k))) => {
                choices.get(k).cloned().unwrap_or_default()
            }
            (Some(Guess::Bar { .. }), Some(Said::Number(x))) => format!("{} in 100", rounded(x)),
            (Some(Guess::Number { of }), Some(Said::Number(x))) => format!("{} {of}", rounded(x)),
            (Some(Guess::Sketch { days, .. }), Some(Said::Curve(values))) => curve(days, &values),
            _ => String::new(),
        }
    }

    /// What is to be read beside each other when a step has grown: what each is called, and what it is.
    pub fn beside(&self, lesson: &Lesson, step: usize) -> Vec<(&'static str, String)> {
        let Some(Kind::Grow(growing)) = lesson.steps.get(step).map(|step| &step.kind) else {
            return Vec::new();
        };
        let mut lines = Vec::new();
        if let Some(asked) = lesson.asked_before(step) {
            let told = self.told(lesson, asked);
            if !told.is_empty() {
                lines.push(("You said", told));
            }
            if let Kind::Predict { guess: Guess::Choice { choices, right }, .. } =
                &lesson.steps[asked].kind
            {
                lines.push(("It turns out", choices[*right].clone()));
            }
        }
        let grown = self.grown(step).cloned().unwrap_or_default();
        let sketched = lesson.sketched_before(step);
        if let (Some(measure), [first, ..]) = (growing.measure, &grown.values[..]) {
            let values = &grown.values;
            let told = match values.len() {
                _ if sketched.is_some() => curve(sketched.unwrap_or_default(), values),
                1 => measure.told(*first),
                n => {
                    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
                    let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
                    let mean = values.iter().sum::<f64>() / n as f64;
                    format!(
                        "{n} individuals: {} in the mean, from {} to {}",
                        measure.told(mean),
                        rounded(least),
                        rounded(most)
                    )
                }
            };
            lines.push(("Grown", told));
        }
        match (grown.usual, growing.measure) {
            _ if !growing.expected.is_empty() => lines.push(("Expected", growing.expected.clone())),
            (Some(Usual { mean, ends: [low, high] }), Some(measure)) if sketched.is_none() => lines
                .push((
                    "Expected",
                    format!(
                        "{} in the mean; 95 in 100 individuals lie between {} and {}",
                        measure.told(mean),
                        rounded(low),
                        rounded(high)
                    ),
                )),
            _ => {}
        }
        if !growing.nature.is_empty() {
            lines.push(("In nature", growing.nature.clone()));
        }
        lines
    }

    /// What it is that a step's growth measures, on its plant; empty if it measures nothing.
    pub fn measured(lesson: &Lesson, step: usize) -> String {
        let Some(step) = lesson.steps.get(step) else { return String::new() };
        let Kind::Grow(growing) = &step.kind else { return String::new() };
        let scene = link::read(step.link.as_deref().unwrap_or_default(), plants::all()).scene;
        growing.measure.map(|measure| measure.name(scene.plant)).unwrap_or_default()
    }

    /// All predictions and what came out, as text.
    pub fn to_text(&self, lesson: &Lesson) -> String {
        let mut text = format!("{}\n", lesson.title);
        for (k, step) in lesson.steps.iter().enumerate() {
            match &step.kind {
                Kind::Predict { ask, .. } => {
                    let _ = write!(text, "\n{}. {ask}\n", k + 1);
                    if self.said(k).is_none() {
                        text += "You said: nothing yet\n";
                    }
                }
                Kind::Grow(_) => {
                    for (name, told) in self.beside(lesson, k) {
                        let _ = writeln!(text, "{name}: {told}");
                    }
                }
                _ => {}
            }
        }
        text
    }

    /// A row for each prediction and for each growth.
    pub fn to_csv(&self, lesson: &Lesson) -> String {
        let mut table = "lesson,step,kind,question,said,grown,expected\n".to_string();
        for (k, step) in lesson.steps.iter().enumerate() {
            let mut columns = [String::new(), String::new(), String::new(), String::new()];
            match &step.kind {
                Kind::Predict { ask, .. } => {
                    columns[0].clone_from(ask);
                    columns[1] = self.told(lesson, k);
                }
                Kind::Grow(_) => {
                    columns[0] = Answers::measured(lesson, k);
                    for (name, told) in self.beside(lesson, k) {
                        match name {
                            "Grown" => columns[2] = told,
                            "Expected" if self.grown(k).is_some() => columns[3] = told,
                            _ => {}
                        }
                    }
                }
                _ => continue,
            }
            let [question, said, grown, expected] = columns.map(|column| quoted(&column));
            let (title, kind) = (quoted(&lesson.title), step.word());
            let _ =
                writeln!(table, "{title},{},{kind},{question},{said},{grown},{expected}", k + 1);
        }
        table
    }
}

/// A curve in words: `10 in 100 on day 0, 25 on day 10`.
fn curve(days: &[u32], values: &[f64]) -> String {
    let mut unit = " in 100";
    let points = days.iter().zip(values);
    let points: Vec<String> = points
        .map(|(day, value)| {
            format!("{}{} on day {day}", rounded(*value), std::mem::take(&mut unit))
        })
        .collect();
    points.join(", ")
}

/// A field of a table (RFC 4180). What a spreadsheet would take for a formula is kept from it.
fn quoted(text: &str) -> String {
    let guard = if text.starts_with(['=', '+', '-', '@']) { "'" } else { "" };
    format!("\"{guard}{}\"", text.replace('"', "\"\""))
}
