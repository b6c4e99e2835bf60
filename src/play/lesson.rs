//! Lessons: plain text that a teacher writes, read into steps (`docs/lessons.md`).
//!
//! Whatever the text is, it is read or refused with the number of the line and what is wrong there.

mod answers;
mod measure;
mod read;
#[cfg(test)]
mod tests;

pub use answers::{Answers, Grown, Said};
pub use measure::{Measure, Usual};
pub use read::{LessonError, read};

/// The lessons that come with the playground, by the names of their files, in the order of their list.
pub const LESSONS: [&str; 8] = [
    "doubling",
    "chance",
    "early-and-late",
    "jackpots",
    "clones-or-signals",
    "who-wins",
    "borders",
    "families",
];

#[derive(Clone, Debug, Default, PartialEq)]
pub struct Lesson {
    pub title: String,
    pub age: String,
    pub minutes: u32,
    pub about: String,
    pub sources: Vec<String>,
    pub steps: Vec<Step>,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    pub title: String,
    /// What the page shows from this step on.
    pub link: Option<String>,
    /// Paragraphs.
    pub text: Vec<String>,
    pub kind: Kind,
}

#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// There is something to see.
    Look,
    /// The visitor plays with the controls of the plant.
    Play,
    /// The visitor says what will be, before it is seen.
    Predict { ask: String, guess: Guess },
    /// The plant grows, and what comes out stands beside what was said.
    Grow(Growing),
    /// What others think, and what is right about it.
    Explain { students: Vec<Student> },
}

/// How something is predicted.
#[derive(Clone, Debug, PartialEq)]
pub enum Guess {
    /// One of several; `right` is the one that will turn out so.
    Choice { choices: Vec<String>, right: usize },
    /// From 0 to 100 in 100 of something.
    Bar { of: String },
    /// A number of something.
    Number { of: String },
    /// A curve: how many in 100 of something on each of some days, which ascend.
    Sketch { of: String, days: Vec<u32> },
}

#[derive(Clone, Debug, Default, PartialEq)]
pub struct Growing {
    pub measure: Option<Measure>,
    /// How many are grown to measure: that of the link, and those after it.
    pub individuals: u32,
    /// What is to be expected, in the words of the lesson; empty to have it worked out where a law is known.
    pub expected: String,
    /// What was counted in nature; empty if that is not told.
    pub nature: String,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Student {
    pub says: String,
    pub reply: String,
}

impl Step {
    /// The word for its kind in a lesson's file.
    pub fn word(&self) -> &'static str {
        match self.kind {
            Kind::Look => "look",
            Kind::Play => "play",
            Kind::Predict { .. } => "predict",
            Kind::Grow(_) => "grow",
            Kind::Explain { .. } => "explain",
        }
    }
}

impl Lesson {
    /// The prediction that a step's growth answers: the last one before it.
    pub fn asked_before(&self, step: usize) -> Option<usize> {
        let before = self.steps.get(..step)?;
        before.iter().rposition(|step| matches!(step.kind, Kind::Predict { .. }))
    }

    /// The days of the curve that a step's growth answers; None if what was asked is no curve.
    pub fn sketched_before(&self, step: usize) -> Option<&[u32]> {
        match &self.steps[self.asked_before(step)?].kind {
            Kind::Predict { guess: Guess::Sketch { days, .. }, .. } => Some(days),
            _ => None,
        }
    }
}
