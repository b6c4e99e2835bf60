//! What may be seen on the body of a plant: its cells, or what leads them.

use super::Plant;
use crate::mosaic::CLAN_COLOURS;
use crate::surface::filled;

/// What is seen on a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Show {
    #[default]
    Cells,
    /// The cells in the colours of their clans, the family map.
    Clans,
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

/// Colours of clans, sRGB: those of Okabe and Ito (Color Universal Design, 2008), which people who see
/// colours in other ways tell apart, too; with a dark indigo (Tol, Colour schemes, 2021) in the place of
/// their black, which would hide the light on a body.
pub const CLAN_PALETTE: [[f32; 3]; CLAN_COLOURS as usize] = [
    [0.90, 0.62, 0.00],
    [0.34, 0.71, 0.91],
    [0.00, 0.62, 0.45],
    [0.94, 0.89, 0.26],
    [0.00, 0.45, 0.70],
    [0.84, 0.37, 0.00],
    [0.80, 0.47, 0.65],
    [0.20, 0.13, 0.53],
];

use Show::*;

const ALL: [Show; 7] = [Cells, Clans, FieldArrows, FieldX, FieldY, FieldZ, ControlImages];

const ANGLES: &str = "Red: along the axis; yellow-green: across it; cyan: against it. x points to \
                      the right, y up, z to the front.";

/// For each of them its word in links, never to be given to another, its name, and how to read it.
const WORDS: [[&str; 3]; 7] = [
    ["cells", "Cells", ""],
    [
        "clans",
        "Family map",
        "Each clan, all that descend from one first cell, in a colour that no clan beside it has.",
    ],
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
            Cells | Clans => true,
            FieldArrows | FieldX | FieldY | FieldZ => plant.guides.is_some(),
            ControlImages => !plant.paint.is_empty(),
        }
    }

    /// Whether cells are seen, in whatever colours, and nothing in their place.
    pub fn is_of_cells(self) -> bool {
        matches!(self, Cells | Clans)
    }

    /// Its word in links.
    pub fn key(self) -> &'static str {
        WORDS[self as usize][0]
    }

    /// What it is called.
    pub fn name(self) -> &'static str {
        WORDS[self as usize][1]
    }

    /// How it is to be read, for a plant; empty for cells in their own colours.
    pub fn meaning(self, plant: &Plant) -> String {
        let mut text = filled(WORDS[self as usize][2], &[("F", plant.colour_names[0])]);
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
        assert_eq!(keys("cactus"), ["cells", "clans"]);
        assert_eq!(keys("croton"), ["cells", "clans", "controls"]);
        assert_eq!(
            keys("philodendron"),
            ["cells", "clans", "field-arrows", "field-x", "field-y", "field-z", "controls"]
        );
    }

    #[test]
    fn what_is_offered_can_be_drawn_and_comes_back_by_its_word() {
        for plant in all() {
            let mesh = plant.embedded_body().surface;
            for show in Show::offered(plant) {
                assert_eq!(Show::of_key(show.key()), Some(show));
                let drawn = show.diagram(plant, 1, &mesh) != Diagram::default();
                assert_eq!(drawn, !show.is_of_cells());
            }
        }
        assert_eq!(Show::of_key("bones"), None);
    }

    /// CIE Lab of sRGB numbers, as people see them who have all three cones, or lack that for red or green
    /// (Viénot, Brettel and Mollon 1999, as matrices of linear RGB).
    fn lab(srgb: [f32; 3], lacks: usize) -> [f64; 3] {
        let linear = srgb.map(|c| f64::from(c).powf(2.2));
        let seen = match lacks {
            0 => linear,
            1 => {
                let yellow = 0.11238 * linear[0] + 0.88762 * linear[1];
                let blue = 0.00401 * (linear[0] - linear[1]) + linear[2];
                [yellow, yellow, blue]
            }
            _ => {
                let yellow = 0.29275 * linear[0] + 0.70725 * linear[1];
                let blue = -0.02234 * (linear[0] - linear[1]) + linear[2];
                [yellow, yellow, blue]
            }
        };
        let row = |[r, g, b]: [f64; 3]| (r * seen[0] + g * seen[1] + b * seen[2]).max(0.0).cbrt();
        let x = row([0.4339, 0.3762, 0.1899]);
        let y = row([0.2126, 0.7152, 0.0722]);
        let z = row([0.0178, 0.1095, 0.8727]);
        [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
    }

    #[test]
    fn colours_of_clans_are_told_apart_by_eyes_of_all_kinds() {
        for lacks in 0..3 {
            for (k, &one) in CLAN_PALETTE.iter().enumerate() {
                for &other in &CLAN_PALETTE[..k] {
                    let (a, b) = (lab(one, lacks), lab(other, lacks));
                    let apart = (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt();
                    // 2 are just seen side by side.
                    assert!(apart > 9.0, "{one:?} and {other:?}: {apart}, eyes {lacks}");
                }
            }
        }
    }
}
