//! What the page says in words: of the picture, of the growth, and at its fields.

use super::super::narration::{Moment, change, summary};
use super::super::parameters::{PARAMETERS, Parameter};
use super::super::{End, Scene, words};
use super::{Effect, Page};
use crate::surface::Shortest;

/// Numbers that had to make room for another one, each with what it was.
pub(super) struct Moves {
    pub by: &'static Parameter,
    others: Vec<(&'static Parameter, f64)>,
}

impl Moves {
    /// What one change has moved. `earlier`: what the same number had moved up to the scene before.
    pub fn of(
        by: &'static Parameter,
        before: &Scene,
        after: &Scene,
        earlier: Option<Moves>,
    ) -> Moves {
        let earlier = earlier.filter(|moves| moves.by.key == by.key);
        let was = |other: &Parameter| {
            let mut known = earlier.iter().flat_map(|moves| &moves.others);
            known.find(|(p, _)| p.key == other.key).map_or(other.get(before), |(_, was)| *was)
        };
        let others = PARAMETERS.iter().filter(|other| other.key != by.key);
        let moved = others.map(|other| (other, was(other)));
        Moves { by, others: moved.filter(|(other, was)| other.get(after) != *was).collect() }
    }
}

impl Page {
    /// What is on the screen, in short: `Croton, individual 7, day 12`.
    pub fn title(&self) -> String {
        let (name, shown) = (self.scene.plant.name, &self.shown);
        match &shown.day {
            Some(day) => format!("{name}, individual {}, day {}", shown.individual, day.day),
            None => format!("{name}, individual {}", self.scene.individual),
        }
    }

    /// The picture that came to rest last, in words: see `narration::summary`.
    pub fn summary(&self) -> &str {
        &self.summary
    }

    /// Says what is on the screen, or what the last act has changed there, unless that was said.
    pub(super) fn narrate(&mut self, effects: &mut Vec<Effect>) {
        let Some(day) = self.shown.day.clone() else { return };
        let clone = self.told_of_clone().map(|told| told.in_words()).unwrap_or_default();
        let now = Moment { scene: self.scene.clone(), day, clone };
        if self.heard.as_ref() == Some(&now) {
            return;
        }
        self.summary = summary(&self.run, &now);
        effects.push(Effect::Say(match &self.heard {
            Some(before) if before.scene.plant.key == now.scene.plant.key => change(before, &now),
            _ => self.summary.clone(),
        }));
        self.heard = Some(now);
    }

    /// The day before the one that was summed up has come: now there is something to compare it with.
    pub(super) fn sum_up_again(&mut self, day: u32) {
        if let Some(heard) = self.heard.as_ref().filter(|heard| heard.day.day == day + 1)
            && self.run.scene.grows_like(&heard.scene)
        {
            self.summary = summary(&self.run, heard);
        }
    }

    /// What is being waited for; nothing where nothing is.
    pub fn notice(&self) -> String {
        let wished = self.playhead.wished_day();
        if self.run.end == Some(End::Failed) {
            return String::new();
        }
        match self.run.grown() {
            None => "Sowing the first cells…".to_string(),
            Some(grown) if self.run.facts(wished).is_none() && !self.playhead.is_playing() => {
                let cells = words::grouped(self.run.pedigree.cells());
                format!("Day {wished} is growing: so far day {grown}, {cells} cells")
            }
            _ => String::new(),
        }
    }

    /// Where the recipe comes from, and how many numbers of it are changed.
    pub fn source(&self) -> &str {
        &self.source
    }

    /// What was put in a field last, if it cannot be.
    pub fn refusal(&self, field: &str) -> Option<&str> {
        self.refusal.as_ref().filter(|r| r.field == field).map(|r| r.why.as_str())
    }

    /// What is to be said at the field of a number that has moved another, or was moved by one.
    pub fn remark(&self, key: &str) -> Option<String> {
        let moves = self.moves.as_ref()?;
        let plant = self.scene.plant;
        let mut of_it = moves.others.iter().filter(|(p, _)| moves.by.key == key || p.key == key);
        let (other, was) = of_it.next()?;
        let (was, now) = (was.shortest(), other.get(&self.scene).shortest());
        Some(match other.key == key {
            true => format!(
                "Was {was}: it makes room for “{}”, as both are 1 at most.",
                moves.by.label(plant)
            ),
            false => {
                format!("“{}” goes from {was} to {now}: both are 1 at most.", other.label(plant))
            }
        })
    }
}
