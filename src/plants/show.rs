//! What may be seen on the body of a plant: its cells, or what leads them.

use super::Plant;

/// What is seen on a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Show {
    #[default]
    Cells,
    /// The direction field, an arrow in each triangle.
    FieldArrows,
    /// The direction field, each triangle in the colour of its angle with an axis of the world, 0 to
    /// 2 for x, y and z (Thesis 3.2.4).
    FieldAngle(usize),
    /// What the control images say, and the cylinders that they are wrapped on.
    ControlImages,
}

/// For each of them: its word in links, never to be given to another; its name; what it means.
const ALL: [(Show, &str, &str, &str); 6] = [
    (Show::Cells, "cells", "Cells", ""),
    (
        Show::FieldArrows,
        "field-arrows",
        "Direction field: arrows",
        "Where each triangle turns the steps of its cells.",
    ),
    (Show::FieldAngle(0), "field-x", "Direction field: angle with x, rightwards", ANGLES),
    (Show::FieldAngle(1), "field-y", "Direction field: angle with y, upwards", ANGLES),
    (Show::FieldAngle(2), "field-z", "Direction field: angle with z, forwards", ANGLES),
    (
        Show::ControlImages,
        "controls",
        "Control images",
        "First cells are {F} only where it is white; grey and black are for the other colours. \
         Red: the cylinders that the images are wrapped on.",
    ),
];

const ANGLES: &str = "Red runs along the axis, yellow-green across it, cyan against it.";

impl Show {
    /// What a plant has to show, its cells first.
    pub fn offered(plant: &Plant) -> impl Iterator<Item = Show> {
        ALL.into_iter().map(|(show, ..)| show).filter(|show| show.is_of(plant))
    }

    /// What a word in a link means.
    pub fn of_key(key: &str) -> Option<Show> {
        ALL.into_iter().find(|(_, word, ..)| *word == key).map(|(show, ..)| show)
    }

    /// Whether a plant has that.
    pub fn is_of(self, plant: &Plant) -> bool {
        match self {
            Show::Cells => true,
            Show::FieldArrows | Show::FieldAngle(_) => plant.field.is_some(),
            Show::ControlImages => plant.controls.is_some(),
        }
    }

    /// Its word in links.
    pub fn key(self) -> &'static str {
        self.entry().1
    }

    /// What it is called.
    pub fn name(self) -> &'static str {
        self.entry().2
    }

    /// How it is to be read, for a plant; empty for cells.
    pub fn meaning(self, plant: &Plant) -> String {
        self.entry().3.replace("{F}", plant.colour_names[0])
    }

    fn entry(self) -> &'static (Show, &'static str, &'static str, &'static str) {
        ALL.iter().find(|(show, ..)| *show == self).unwrap_or(&ALL[0])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants::{all, find};

    #[test]
    fn only_what_a_plant_has_is_offered() {
        let keys = |key| Show::offered(find(key).unwrap()).map(Show::key).collect::<Vec<_>>();
        assert_eq!(keys("cactus"), ["cells"]);
        assert_eq!(keys("croton"), ["cells", "controls"]);
        assert_eq!(
            keys("philodendron"),
            ["cells", "field-arrows", "field-x", "field-y", "field-z", "controls"]
        );
    }

    #[test]
    fn what_is_offered_can_be_drawn_and_comes_back_by_its_word() {
        for plant in all() {
            let mesh = plant.embedded_body().surface;
            for show in Show::offered(plant) {
                assert_eq!(Show::of_key(show.key()), Some(show));
                assert_eq!(show.diagram(plant, &mesh).is_none(), show == Show::Cells);
            }
        }
        assert_eq!(Show::of_key("bones"), None);
    }
}
