//! What may be seen on the body of a plant: its cells, or what leads them.

use super::Plant;

/// What is seen on a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Show {
    #[default]
    Cells,
    /// The direction field, an arrow in each triangle.
    FieldArrows,
    /// The direction field, each triangle in the colour of its angle with an axis of the world
    /// (Thesis 3.2.4).
    FieldX,
    FieldY,
    FieldZ,
    /// What the control images say, and the cylinders that they are wrapped on.
    ControlImages,
}

use Show::*;

const ALL: [Show; 6] = [Cells, FieldArrows, FieldX, FieldY, FieldZ, ControlImages];

const ANGLES: &str = "Red: along the axis; yellow-green: across it; cyan: against it. x points to \
                      the right, y up, z to the front.";

/// For each of them its word in links, never to be given to another, its name, and how to read it.
const WORDS: [[&str; 3]; 6] = [
    ["cells", "Cells", ""],
    [
        "field-arrows",
        "Direction field: arrows",
        "Each triangle turns the steps of its cells that way. From afar, fewer arrows are drawn.",
    ],
    ["field-x", "Direction field: angle with x", ANGLES],
    ["field-y", "Direction field: angle with y", ANGLES],
    ["field-z", "Direction field: angle with z", ANGLES],
    [
        "controls",
        "Control images",
        "White: first cells may be {F}. Grey and black: they are of the other colours. Red: \
         cylinders that the images are wrapped on.",
    ],
];

/// What is to be added where control images tint cells.
const TINTS: &str = " Pale grey counts as white, dark grey as black: the lighter, the more the cells \
                     are tinted.";

impl Show {
    /// What a plant has to show, its cells first.
    pub fn offered(plant: &Plant) -> impl Iterator<Item = Show> {
        ALL.into_iter().filter(|show| show.is_of(plant))
    }

    /// What a word in a link means.
    pub fn of_key(key: &str) -> Option<Show> {
        WORDS.iter().position(|words| words[0] == key).map(|number| ALL[number])
    }

    /// Whether a plant has that.
    pub fn is_of(self, plant: &Plant) -> bool {
        match self {
            Cells => true,
            FieldArrows | FieldX | FieldY | FieldZ => plant.guides.is_some(),
            ControlImages => !plant.paint.is_empty(),
        }
    }

    /// Its word in links.
    pub fn key(self) -> &'static str {
        WORDS[self as usize][0]
    }

    /// What it is called.
    pub fn name(self) -> &'static str {
        WORDS[self as usize][1]
    }

    /// How it is to be read, for a plant; empty for cells.
    pub fn meaning(self, plant: &Plant) -> String {
        let mut text = WORDS[self as usize][2].replace("{F}", plant.colour_names[0]);
        if self == ControlImages && !plant.look.tinted.is_empty() {
            text += TINTS;
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants::{Diagram, all, find};

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
                let drawn = show.diagram(plant, &mesh) != Diagram::default();
                assert_eq!(drawn, show != Cells);
            }
        }
        assert_eq!(Show::of_key("bones"), None);
    }
}
