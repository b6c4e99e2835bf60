//! Reading a lesson's text.

use super::{Growing, Guess, Kind, Lesson, Measure, Step, Student};
use crate::plants;
use crate::play::link;
use crate::surface::quoted;

/// More is no lesson but a mistake.
const MOST_BYTES: usize = 200_000;
const MOST_STEPS: usize = 60;
/// As many as a machine grows while a class waits.
const MOST_INDIVIDUALS: u32 = 60;

/// What is wrong with a lesson's text, and in which line, from 1.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("Line {line}: {what}.")]
pub struct LessonError {
    pub line: usize,
    pub what: String,
}

fn wrong<T>(line: usize, what: impl Into<String>) -> Result<T, LessonError> {
    Err(LessonError { line, what: what.into() })
}

/// Reads a lesson.
///
/// # Errors
/// The first line that is wrong, in plain words.
pub fn read(text: &str) -> Result<Lesson, LessonError> {
    if text.len() > MOST_BYTES {
        return wrong(1, format!("a lesson has at most {MOST_BYTES} letters"));
    }
    let lines = sorted(text)?;
    let mut lesson = Lesson::default();
    let head_ends = lines.iter().position(|l| matches!(l.is, Is::Step(..))).unwrap_or(lines.len());
    read_head(&mut lesson, &lines[..head_ends])?;
    let mut rest = &lines[head_ends..];
    if rest.is_empty() {
        return wrong(
            last(&lines),
            "there is no step yet: a step begins with a line such as [look]",
        );
    }
    while let Some((first, behind)) = rest.split_first() {
        let ends = behind.iter().position(|l| matches!(l.is, Is::Step(..))).unwrap_or(behind.len());
        let step = read_step(first, &behind[..ends])?;
        let is_asked = lesson.steps.last().is_some_and(|s| matches!(s.kind, Kind::Predict { .. }));
        if is_asked && !matches!(step.kind, Kind::Grow(_)) {
            return wrong(first.number, "after [predict] comes [grow], which answers it");
        }
        lesson.steps.push(step);
        if let Some(days) = lesson.sketched_before(lesson.steps.len() - 1).filter(|_| is_asked) {
            answer_sketch(&lesson.steps[lesson.steps.len() - 1], days, first.number)?;
        }
        if lesson.steps.len() > MOST_STEPS {
            return wrong(first.number, format!("a lesson has at most {MOST_STEPS} steps"));
        }
        rest = &behind[ends..];
    }
    match lesson.steps.last().map(|step| &step.kind) {
        Some(Kind::Predict { .. }) => {
            wrong(last(&lines), "after [predict] comes [grow], which answers it")
        }
        _ => Ok(lesson),
    }
}

/// A curve is answered by one plant, day by day.
fn answer_sketch(step: &Step, days: &[u32], line: usize) -> Result<(), LessonError> {
    let Kind::Grow(growing) = &step.kind else { return Ok(()) };
    if growing.individuals != 1 || !growing.measure.is_some_and(Measure::is_share) {
        return wrong(
            line,
            "a sketch: is answered by one individual and a measure: in 100, such as share F",
        );
    }
    let link = step.link.as_deref().unwrap_or_default();
    let last = link::read(link, plants::all()).scene.recipe.days;
    match days.iter().find(|&&day| day > last) {
        Some(day) => wrong(
            line,
            format!("its plant grows for {last} days, and the sketch: asks for day {day}"),
        ),
        None => Ok(()),
    }
}

/// A line of a lesson with what goes on with it.
struct Line<'a> {
    number: usize,
    is: Is<'a>,
}

enum Is<'a> {
    /// `[word] title`
    Step(&'a str, &'a str),
    /// `key: value`
    Key(&'a str, String),
    /// A paragraph.
    Text(String),
}

fn last(lines: &[Line]) -> usize {
    lines.last().map_or(1, |line| line.number)
}

/// Sorts the lines of a text. An indented line goes on with the value above it, and lines of text that follow each
/// other are one paragraph; what begins with `#` is nobody's.
fn sorted(text: &str) -> Result<Vec<Line<'_>>, LessonError> {
    let mut lines: Vec<Line> = Vec::new();
    let mut is_apart = true;
    for (number, raw) in (1..).zip(text.trim_start_matches('\u{feff}').lines()) {
        let line = raw.trim();
        if line.is_empty() || line.starts_with('#') {
            is_apart |= line.is_empty();
            continue;
        }
        if line.contains(|c: char| c.is_control() && c != '\t') {
            return wrong(number, "there is a character that is no text");
        }
        let is = if let Some(rest) = line.strip_prefix('[') {
            let Some((word, title)) = rest.split_once(']') else {
                return wrong(number, "a step's line needs a ] behind its word, such as [look]");
            };
            Some(Is::Step(word.trim(), title.trim()))
        } else if raw.starts_with([' ', '\t']) && !is_apart {
            None
        } else {
            let goes_on = !is_apart && matches!(lines.last(), Some(Line { is: Is::Text(_), .. }));
            key_of(line, goes_on).map(|(key, value)| Is::Key(key, value.to_string()))
        };
        match (is, lines.last_mut()) {
            (Some(is), _) => lines.push(Line { number, is }),
            (None, Some(Line { is: Is::Key(_, before), .. }))
                if raw.starts_with([' ', '\t']) && !is_apart =>
            {
                join(before, line);
            }
            (None, Some(Line { is: Is::Text(before), .. })) if !is_apart => join(before, line),
            _ => lines.push(Line { number, is: Is::Text(line.to_string()) }),
        }
        is_apart = false;
    }
    Ok(lines)
}

const CHINESE: char = '\u{2e80}'; // which has no spaces between words
fn join(before: &mut String, line: &str) {
    let gap = if before.ends_with(|last: char| last < CHINESE) { " " } else { "" };
    before.push_str(gap);
    before.push_str(line);
}

/// All words that are keys somewhere.
const KEYS: [&str; 19] = [
    "title",
    "age",
    "minutes",
    "about",
    "source",
    "link",
    "ask",
    "choice",
    "right",
    "bar",
    "number",
    "sketch",
    "days",
    "measure",
    "individuals",
    "expected",
    "nature",
    "student",
    "reply",
];

/// The key of a line and its value. A key is one word of small letters, for sentences begin with a large one; a
/// line that goes on with a sentence has keys that are known alone.
fn key_of(line: &str, goes_on: bool) -> Option<(&str, &str)> {
    let (key, value) = line.split_once(':')?;
    let is_word = !key.is_empty() && key.len() <= 20 && key.bytes().all(|b| b.is_ascii_lowercase());
    (is_word && (!goes_on || KEYS.contains(&key))).then(|| (key, value.trim()))
}

fn read_head(lesson: &mut Lesson, lines: &[Line]) -> Result<(), LessonError> {
    for line in lines {
        match &line.is {
            Is::Key("title", value) => lesson.title.clone_from(value),
            Is::Key("age", value) => lesson.age.clone_from(value),
            Is::Key("about", value) => lesson.about.clone_from(value),
            Is::Key("source", value) => lesson.sources.push(value.clone()),
            Is::Key("minutes", value) => match value.parse() {
                Ok(minutes @ 1..=600) => lesson.minutes = minutes,
                _ => return wrong(line.number, "minutes is a whole number from 1 to 600"),
            },
            Is::Key(key, _) => {
                return unknown(line.number, key, "title, age, minutes, about and source");
            }
            Is::Text(_) | Is::Step(..) => {
                return wrong(
                    line.number,
                    "text belongs into a step, behind a line such as [look]",
                );
            }
        }
    }
    if lesson.title.is_empty() {
        return wrong(1, "the lesson has no title yet: a line such as title: Doubling");
    }
    Ok(())
}

fn unknown<T>(line: usize, key: &str, known: &str) -> Result<T, LessonError> {
    wrong(line, format!("{} is unknown here; there are {known}", quoted(key)))
}

fn read_step(first: &Line, lines: &[Line]) -> Result<Step, LessonError> {
    let Is::Step(word, title) = first.is else { return wrong(first.number, "a step begins here") };
    let words = ["look", "play", "predict", "grow", "explain"];
    if !words.contains(&word) {
        let word = quoted(word);
        return wrong(first.number, format!("there is no step {word}, but {}", words.join(", ")));
    }
    if title.is_empty() {
        return wrong(first.number, format!("the step needs a title behind [{word}]"));
    }
    let mut parts =
        Parts { growing: Growing { individuals: 1, ..Growing::default() }, ..Parts::default() };
    for line in lines {
        match &line.is {
            Is::Key(key, value) => parts.take(word, line.number, key, value)?,
            Is::Text(text) => parts.text.push(text.clone()),
            Is::Step(..) => {}
        }
    }
    parts.finish(word, title, first.number)
}

/// What the lines of a step say.
#[derive(Default)]
struct Parts {
    link: Option<String>,
    text: Vec<String>,
    ask: String,
    guess: Option<Guess>,
    days: Vec<u32>,
    growing: Growing,
    students: Vec<Student>,
}

impl Parts {
    fn take(&mut self, word: &str, line: usize, key: &str, value: &str) -> Result<(), LessonError> {
        if value.is_empty() {
            return wrong(line, format!("nothing stands behind {key}:"));
        }
        let value = value.to_string();
        match (word, key) {
            (_, "link") => self.link = Some(read_link(line, &value)?),
            ("predict", "ask") => self.ask = value,
            ("predict", "choice" | "right") => self.choose(line, key == "right", value)?,
            ("predict", "bar") => self.guess(line, Guess::Bar { of: value })?,
            ("predict", "number") => self.guess(line, Guess::Number { of: value })?,
            ("predict", "sketch") => self.guess(line, Guess::Sketch { of: value, days: vec![] })?,
            ("predict", "days") => self.days = read_days(line, &value)?,
            ("grow", "measure") => match Measure::of_words(&value) {
                Some(measure) => self.growing.measure = Some(measure),
                None => {
                    return wrong(line, format!("there is no such measure; {}", Measure::KNOWN));
                }
            },
            ("grow", "individuals") => match value.parse() {
                Ok(n) if (1..=MOST_INDIVIDUALS).contains(&n) => self.growing.individuals = n,
                _ => {
                    let what =
                        format!("individuals is a whole number from 1 to {MOST_INDIVIDUALS}");
                    return wrong(line, what);
                }
            },
            ("grow", "expected") => self.growing.expected = value,
            ("grow", "nature") => self.growing.nature = value,
            ("explain", "student") => {
                self.students.push(Student { says: value, reply: String::new() });
            }
            ("explain", "reply") => match self.students.last_mut() {
                Some(student) if student.reply.is_empty() => student.reply = value,
                _ => return wrong(line, "a reply: stands below its student:"),
            },
            _ => {
                let known = match word {
                    "predict" => "link, ask, choice, right, bar, number, sketch and days",
                    "grow" => "link, measure, individuals, expected and nature",
                    "explain" => "link, student and reply",
                    _ => "link alone",
                };
                return unknown(line, key, known);
            }
        }
        Ok(())
    }

    fn choose(&mut self, line: usize, is_right: bool, value: String) -> Result<(), LessonError> {
        match &mut self.guess {
            Some(Guess::Choice { choices, right }) => {
                if is_right && *right != usize::MAX {
                    return wrong(line, "one choice alone can be right:");
                }
                if is_right {
                    *right = choices.len();
                }
                choices.push(value);
                Ok(())
            }
            None => {
                let right = if is_right { 0 } else { usize::MAX };
                self.guess = Some(Guess::Choice { choices: vec![value], right });
                Ok(())
            }
            Some(_) => wrong(line, ONE_WAY),
        }
    }

    fn guess(&mut self, line: usize, guess: Guess) -> Result<(), LessonError> {
        match self.guess.replace(guess) {
            None => Ok(()),
            Some(_) => wrong(line, ONE_WAY),
        }
    }

    fn finish(self, word: &str, title: &str, line: usize) -> Result<Step, LessonError> {
        let kind = match word {
            "look" => Kind::Look,
            "play" => Kind::Play,
            "explain" => {
                if let Some(student) = self.students.iter().find(|s| s.reply.is_empty()) {
                    let says = quoted(&student.says);
                    return wrong(line, format!("{says} has no reply:"));
                }
                Kind::Explain { students: self.students }
            }
            "grow" => Kind::Grow(self.growing),
            _ => {
                if self.ask.is_empty() {
                    return wrong(line, "a prediction needs a question, ask:");
                }
                let Some(mut guess) = self.guess else { return wrong(line, ONE_WAY) };
                match &mut guess {
                    Guess::Sketch { days, .. } if !self.days.is_empty() => *days = self.days,
                    Guess::Sketch { .. } => {
                        return wrong(line, "a sketch: needs its days:, such as days: 0, 10, 20");
                    }
                    _ if !self.days.is_empty() => return wrong(line, "days: belong to a sketch:"),
                    _ => {}
                }
                if let Guess::Choice { choices, right } = &guess {
                    if choices.len() < 2 {
                        return wrong(line, "one choice is none: two at least");
                    }
                    if *right == usize::MAX {
                        return wrong(
                            line,
                            "one of the choices is written right: in place of choice:",
                        );
                    }
                }
                Kind::Predict { ask: self.ask, guess }
            }
        };
        let needs_link = matches!(word, "look" | "grow");
        if needs_link && self.link.is_none() {
            return wrong(line, format!("[{word}] needs a link:, which the page copies for you"));
        }
        Ok(Step { title: title.to_string(), link: self.link, text: self.text, kind })
    }
}

const ONE_WAY: &str = "a prediction has one of choice: lines, bar:, number: or sketch:";

/// Days of a curve: from two to eight, each later than the one before.
fn read_days(line: usize, value: &str) -> Result<Vec<u32>, LessonError> {
    let days: Option<Vec<u32>> = value.split(',').map(|day| day.trim().parse().ok()).collect();
    match days {
        Some(days) if (2..=8).contains(&days.len()) && days.is_sorted_by(|a, b| a < b) => Ok(days),
        _ => wrong(
            line,
            "days: are from two to eight whole numbers, each greater than the one before",
        ),
    }
}

/// The link of an address, if all of it can be shown.
fn read_link(line: usize, address: &str) -> Result<String, LessonError> {
    let link = address.split_once('#').map_or(address, |(_, link)| link);
    let link = link.split('~').next().unwrap_or_default();
    match link::read(link, plants::all()).left_out.first() {
        _ if link.is_empty() => wrong(line, "the link is empty"),
        Some(why) => wrong(line, why.trim_end_matches('.')),
        None => Ok(link.to_string()),
    }
}
