//! Control images: what an image on the body changes in the life of the cells below it
//! (Thesis 3.2.3). An image that leaves triangles without any pattern is the body's own business,
//! `Body::bared`.

use super::CellType;
use crate::surface::{ControlImage, Mesh, Place, Wrap};

/// A control image on a body and its use.
#[derive(Clone, Debug, PartialEq)]
pub struct Control {
    pub wrap: Wrap,
    pub image: ControlImage,
    pub use_as: Use,
}

/// What a control image is used for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Use {
    /// First cells of one type only where it is white: where it is black they are of the other.
    FirstCells { of: CellType, instead: CellType },
    /// The mean days between the divisions of a type, times a factor that goes evenly from that of
    /// black to that of white; what counts is where the cell is when its clock is wound.
    DivisionDays { of: CellType, black: f64, white: f64 },
}

impl Control {
    /// F only where the image is white, and B instead: the use that most plants have.
    pub fn foreground(wrap: Wrap, image: ControlImage) -> Control {
        let use_as = Use::FirstCells { of: CellType::Foreground, instead: CellType::Background };
        Control { wrap, image, use_as }
    }

    /// The type of a first cell of which this type was drawn.
    pub fn first_type(&self, mesh: &Mesh, place: Place, drawn: CellType) -> CellType {
        match self.use_as {
            Use::FirstCells { of, instead } if of == drawn => {
                let (turns, height) = self.wrap.coordinates(&self.image, mesh, place);
                if self.image.is_white(turns, height) { drawn } else { instead }
            }
            _ => drawn,
        }
    }

    /// The factor for the mean days between divisions of a cell that divides at a place.
    pub fn days_factor(&self, mesh: &Mesh, place: Place, kind: CellType) -> f64 {
        match self.use_as {
            Use::DivisionDays { of, black, white } if of == kind => {
                let (turns, height) = self.wrap.coordinates(&self.image, mesh, place);
                let grey = f64::from(self.image.grey(turns, height));
                black * (1.0 - grey) + white * grey
            }
            _ => 1.0,
        }
    }

    /// The least and the greatest factor that there can be for a type.
    pub fn days_factors(&self, kind: CellType) -> [f64; 2] {
        match self.use_as {
            Use::DivisionDays { of, black, white } if of == kind => {
                [black.min(white), black.max(white)]
            }
            _ => [1.0, 1.0],
        }
    }
}
