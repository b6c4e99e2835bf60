//! A lesson on paper, and what grew beside what was said, as a strip.

use super::chart::{Chart, Line, escaped, step};
use crate::play::lesson::{Answers, Grown, Guess, Kind, Lesson, Said, Step};
use std::fmt::Write;

/// The size of a strip, and what it leaves free at each side of its line.
const SIZE: [f64; 2] = [320.0, 74.0];
const MARGIN: f64 = 16.0;
/// Where its line runs.
const LINE: f64 = 44.0;

/// What was said and what grew on one line, as SVG: a dot for each individual, a pointer for what was said, and
/// where 95 in 100 end as a band. Whoever cannot see it has the same in words beside it.
pub fn strip(grown: &Grown, said: Option<Said>, is_share: bool) -> String {
    let [width, height] = SIZE;
    let said = said.and_then(|said| match said {
        Said::Number(x) => Some(x),
        Said::Choice(_) | Said::Curve(_) => None,
    });
    let ends = grown.usual.map(|usual| usual.ends);
    let all = grown.values.iter().copied().chain(ends.into_iter().flatten());
    let grown_most = all.fold(0.0, f64::max);
    let most = if is_share && grown_most.max(said.unwrap_or(0.0)) > 20.0 {
        100.0
    } else {
        // What was said may be far out; what grew is still to be told apart.
        let most = said.unwrap_or(0.0).min(4.0 * grown_most).max(grown_most);
        let step = step(most);
        (most / step).ceil().max(1.0) * step
    };
    let x = |value: f64| MARGIN + (width - 2.0 * MARGIN) * (value / most).clamp(0.0, 1.0);
    let mut svg = format!(
        "<svg class=\"strip\" viewBox=\"0 0 {width} {height}\" aria-hidden=\"true\" font-size=\"13\">"
    );
    if let Some([low, high]) = ends {
        let (from, to) = (x(low), x(high));
        let _ = write!(
            svg,
            "<rect class=\"usual\" x=\"{from:.1}\" y=\"{:.1}\" width=\"{:.1}\" height=\"22\" rx=\"3\"/>",
            LINE - 11.0,
            (to - from).max(3.0)
        );
    }
    let _ = write!(svg, "<path class=\"line\" d=\"M{MARGIN} {LINE}H{}\"/>", width - MARGIN);
    let step = step(most);
    for mark in 0..=(most / step).round() as usize {
        let value = mark as f64 * step;
        let _ = write!(
            svg,
            "<path class=\"line\" d=\"M{0:.1} {1}v5\"/><text x=\"{0:.1}\" y=\"{2}\" text-anchor=\"middle\">{3}</text>",
            x(value),
            LINE,
            LINE + 24.0,
            short(value)
        );
    }
    for &value in &grown.values {
        let _ =
            write!(svg, "<circle class=\"grown\" cx=\"{:.1}\" cy=\"{LINE}\" r=\"5\"/>", x(value));
    }
    if let Some(said) = said {
        let at = x(said);
        let _ = write!(
            svg,
            "<path class=\"said\" d=\"M{at:.1} {:.1}l-6 -10h12z\"/><text class=\"said\" x=\"{at:.1}\" y=\"{:.1}\" \
             text-anchor=\"{}\">you</text>",
            LINE - 7.0,
            LINE - 22.0,
            if at > width - 30.0 { "end" } else { "middle" }
        );
    }
    svg + "</svg>"
}

/// A curve that was drawn and the one that grew, in 100 of something, beside each other.
pub fn curves(of: &str, days: &[u32], said: &[f64], grown: &[f64]) -> Chart {
    let line = |name: &str, colour: &str, is_dashed, values: &[f64]| {
        // Where nothing was said there is nothing to draw.
        let values = (0..days.len()).map(|k| values.get(k).map_or(f64::NAN, |value| value / 100.0));
        let (name, colour) = (name.to_string(), colour.to_string());
        Line { name, colour, is_dashed, is_dots: false, values: values.collect() }
    };
    Chart {
        title: of.to_string(),
        along: "day",
        places: days.iter().map(u32::to_string).collect(),
        lines: vec![line("you", "#d8a51d", true, said), line("grown", "#2f5f34", false, grown)],
        is_share: true,
        ..Chart::default()
    }
}

/// A number that stands below a mark: `20,000` is `20k`.
fn short(value: f64) -> String {
    match value {
        _ if value >= 1e6 => format!("{}M", value / 1e6),
        _ if value >= 1e4 => format!("{}k", value / 1e3),
        _ => format!("{}", (value * 100.0).round() / 100.0),
    }
}

/// All of a lesson as HTML to print, with room to write; what was said already stands there.
pub fn worksheet(lesson: &Lesson, answers: &Answers, address: &str) -> String {
    let mut html = format!(
        "<h1>{}</h1><p class=\"hint\">{}</p><p class=\"name\">Name <span class=\"rule\"></span></p>",
        escaped(&lesson.title),
        escaped(&lesson.about)
    );
    for (k, step) in lesson.steps.iter().enumerate() {
        let _ = write!(html, "<section><h2>{}. {}</h2>", k + 1, escaped(&step.title));
        // What a growth is explained by is read when it has grown, on the screen.
        if !matches!(step.kind, Kind::Grow(_)) {
            for text in &step.text {
                let _ = write!(html, "<p>{}</p>", escaped(text));
            }
        }
        write_task(lesson, answers, (k, step), &mut html);
        html += "</section>";
    }
    if !lesson.sources.is_empty() {
        html += "<section><h2>Sources</h2>";
        for source in &lesson.sources {
            let _ = write!(html, "<p class=\"hint\">{}</p>", escaped(source));
        }
        html += "</section>";
    }
    let _ = write!(html, "<p class=\"hint\">{}</p>", escaped(address));
    html
}

fn write_task(lesson: &Lesson, answers: &Answers, (k, step): (usize, &Step), html: &mut String) {
    const RULE: &str = "<span class=\"rule\"></span>";
    match &step.kind {
        Kind::Look | Kind::Play => {
            let _ = write!(html, "<p>What I saw {RULE}</p><p class=\"rule\"></p>");
        }
        Kind::Predict { ask, guess } => {
            let _ = write!(html, "<p><strong>{}</strong></p>", escaped(ask));
            let told = escaped(&answers.told(lesson, k));
            match guess {
                Guess::Choice { choices, .. } => {
                    for (c, choice) in choices.iter().enumerate() {
                        let mark =
                            if answers.said(k) == Some(Said::Choice(c)) { "☒" } else { "☐" };
                        let _ = write!(html, "<p>{mark} {}</p>", escaped(choice));
                    }
                }
                Guess::Bar { of } if told.is_empty() => {
                    let _ = write!(
                        html,
                        "<p>{}: mark it.</p><div class=\"scale\"><span>0</span><span>25</span><span>50</span>\
                         <span>75</span><span>100</span></div>",
                        escaped(of)
                    );
                }
                Guess::Number { of } if told.is_empty() => {
                    let _ = write!(html, "<p>My number: {RULE} {}</p>", escaped(of));
                }
                Guess::Sketch { of, days } if told.is_empty() => {
                    let heads: String =
                        days.iter().map(|day| format!("<th>Day {day}</th>")).collect();
                    let cells = "<td></td>".repeat(days.len());
                    let _ = write!(
                        html,
                        "<p>{}: draw the curve, 0 at the foot and 100 at the head.</p>\
                         <table class=\"sketch\"><tr>{cells}</tr><tr>{heads}</tr></table>",
                        escaped(of)
                    );
                }
                _ => {
                    let _ = write!(html, "<p>I said {told}.</p>");
                }
            }
            let _ = write!(html, "<p>Why I think so {RULE}</p><p class=\"rule\"></p>");
        }
        Kind::Grow(_) => {
            let measured = Answers::measured(lesson, k);
            if answers.grown(k).is_some() {
                for (name, told) in answers.beside(lesson, k) {
                    let _ = write!(html, "<p>{name}: {}</p>", escaped(&told));
                }
            } else if !measured.is_empty() {
                let _ = write!(html, "<p>Grown: {RULE} {}</p>", escaped(&measured));
            }
            let _ = write!(html, "<p>What surprised me {RULE}</p><p class=\"rule\"></p>");
        }
        Kind::Explain { students } => {
            for student in students {
                let _ = write!(
                    html,
                    "<p>A student says: “{}” What is right about it? {RULE}</p><p class=\"rule\"></p>",
                    escaped(&student.says)
                );
            }
        }
    }
}
