//! What of a picture the graphics card holds, so that only what it lacks is handed to it.

use super::clone::Paint;
use crate::plants::{Look, Rules, Show};

/// The parts of a picture, in the order in which they are handed over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Corners of body and ground; all other parts are to be handed over anew then.
    Body,
    /// The corners of a body that moves, as they stand on another day.
    Shape,
    /// A few numbers: colours, borders, gloss.
    Look,
    /// A diagram in the place of the cells, or none.
    Show,
    /// The site lists of a day.
    Cells,
}

/// A picture that is to be drawn.
#[derive(Clone, Copy, Debug)]
pub struct Wanted<'a> {
    /// Its key.
    pub plant: &'static str,
    /// The day on which its body stands as it does here. None if it stands still.
    pub shape: Option<u32>,
    /// Whose control images are shown.
    pub individual: (Rules, u32),
    pub look: &'a Look,
    pub show: Show,
    /// Generation and day. None: the cells that are there stay.
    pub cells: Option<(u32, u32)>,
    /// In which colours they are seen.
    pub paint: Paint,
}

/// What has been handed over.
#[derive(Clone, Debug, Default)]
pub struct Handed {
    plant: Option<&'static str>,
    shape: Option<u32>,
    look: Option<Look>,
    individual: Option<(Rules, u32)>,
    show: Show,
    cells: Option<(u32, u32)>,
    paint: Paint,
    /// What was too large.
    refused: Option<(Show, Option<(u32, u32)>)>,
}

impl Handed {
    /// The next part that is to be handed over; none when all of the picture is there.
    pub fn lacks(&self, wanted: &Wanted) -> Option<Part> {
        if self.plant != Some(wanted.plant) {
            Some(Part::Body)
        } else if self.shape != wanted.shape {
            Some(Part::Shape)
        } else if self.look.as_ref() != Some(wanted.look) {
            Some(Part::Look)
        } else if self.show != wanted.show
            || self.show == Show::ControlImages && self.individual != Some(wanted.individual)
        {
            Some(Part::Show)
        } else if wanted.cells.is_some() && (self.cells, self.paint) != (wanted.cells, wanted.paint)
        {
            Some(Part::Cells)
        } else {
            None
        }
    }

    /// A part of the picture has been handed over.
    pub fn take(&mut self, part: Part, wanted: &Wanted) {
        match part {
            Part::Body => {
                let (plant, shape) = (Some(wanted.plant), wanted.shape);
                *self = Handed { plant, shape, ..Handed::default() };
            }
            Part::Shape => self.shape = wanted.shape,
            Part::Look => self.look = Some(wanted.look.clone()),
            Part::Show => (self.show, self.individual) = (wanted.show, Some(wanted.individual)),
            Part::Cells => {
                (self.cells, self.paint, self.refused) = (wanted.cells, wanted.paint, None);
            }
        }
    }

    /// Whether there are cells to draw.
    pub fn has_cells(&self) -> bool {
        self.cells.is_some()
    }

    /// The picture is too large for the graphics card: no cells are to be drawn until those of
    /// another picture are handed over.
    pub fn refuse(&mut self, wanted: &Wanted) {
        (self.cells, self.refused) = (None, Some((wanted.show, wanted.cells)));
    }

    /// Whether this picture was refused: it need not be tried again.
    pub fn refuses(&self, wanted: &Wanted) -> bool {
        self.plant == Some(wanted.plant) && self.refused == Some((wanted.show, wanted.cells))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants;

    /// Hands everything over that is lacking.
    fn hand(handed: &mut Handed, wanted: &Wanted) -> Vec<Part> {
        let mut parts = Vec::new();
        while let Some(part) = handed.lacks(wanted) {
            handed.take(part, wanted);
            parts.push(part);
        }
        parts
    }

    fn look() -> Look {
        plants::all()[0].look.clone()
    }

    #[test]
    fn only_what_changed_is_handed_over() {
        let (look, mut handed) = (look(), Handed::default());
        let croton = Wanted {
            plant: "croton",
            shape: None,
            individual: (Rules::First, 1),
            look: &look,
            show: Show::Cells,
            cells: Some((1, 12)),
            paint: Paint::default(),
        };
        assert_eq!(hand(&mut handed, &croton), [Part::Body, Part::Look, Part::Cells]);
        assert_eq!(hand(&mut handed, &croton), []);

        let mut paler = look.clone();
        paler.cells[0][1] += 0.1;
        let paler = Wanted { look: &paler, ..croton };
        assert_eq!(hand(&mut handed, &paler), [Part::Look], "a colour is no reason for a new body");
        let next_day = Wanted { cells: Some((1, 13)), ..paler };
        assert_eq!(hand(&mut handed, &next_day), [Part::Cells]);
        let map = Wanted { paint: Paint { clans: true, ..Paint::default() }, ..next_day };
        assert_eq!(hand(&mut handed, &map), [Part::Cells], "the same day in other colours");
        assert_eq!(hand(&mut handed, &next_day), [Part::Cells]);
        let controls = Wanted { show: Show::ControlImages, cells: None, ..next_day };
        assert_eq!(hand(&mut handed, &controls), [Part::Show]);
        assert!(handed.has_cells(), "they wait under the diagram");
        for individual in [(Rules::First, 2), (Rules::Second, 2)] {
            let of_another = Wanted { individual, ..controls };
            assert_eq!(hand(&mut handed, &of_another), [Part::Show], "with images of its own");
        }

        let cactus = Wanted { plant: "cactus", ..controls };
        assert_eq!(hand(&mut handed, &cactus), [Part::Body, Part::Look, Part::Show]);
        assert!(!handed.has_cells(), "those of the croton are gone with its body");
    }

    #[test]
    fn a_body_that_moves_takes_its_shape_from_day_to_day() {
        let (look, mut handed) = (look(), Handed::default());
        let day = |day| Wanted {
            plant: "lily",
            shape: Some(day),
            individual: (Rules::First, 1),
            look: &look,
            show: Show::Cells,
            cells: Some((1, day)),
            paint: Paint::default(),
        };
        assert_eq!(hand(&mut handed, &day(3)), [Part::Body, Part::Look, Part::Cells]);
        assert_eq!(hand(&mut handed, &day(4)), [Part::Shape, Part::Cells]);
        let as_made = Wanted { shape: None, show: Show::ControlImages, cells: None, ..day(4) };
        assert_eq!(hand(&mut handed, &as_made), [Part::Shape, Part::Show]);
    }

    #[test]
    fn what_is_too_large_leaves_room_for_the_next() {
        let (look, mut handed) = (look(), Handed::default());
        let day = |day| Wanted {
            plant: "croton",
            shape: None,
            individual: (Rules::First, 1),
            look: &look,
            show: Show::Cells,
            cells: Some((1, day)),
            paint: Paint::default(),
        };
        hand(&mut handed, &day(1));
        handed.refuse(&day(2));
        assert!(handed.refuses(&day(2)) && !handed.has_cells());
        assert!(!handed.refuses(&day(1)) && !handed.refuses(&Wanted { plant: "cactus", ..day(2) }));
        assert_eq!(hand(&mut handed, &day(1)), [Part::Cells]);
        assert!(handed.has_cells() && !handed.refuses(&day(2)));
    }
}
