//! Control images: what an image on the body changes in the cells below it (Thesis 3.2.3; scaling and
//! colour as in the original program). An image that leaves triangles without any pattern is the body's own business,
//! `Body::bared`.

use super::{CellType, Recipe, RecipeError, Scaled};
use crate::surface::{ControlImage, Mesh, NO_TWIN, Place, Shortest, Wrap};
use serde::{Deserialize, Serialize};

/// A control image on a body and its use.
#[derive(Clone, Debug, PartialEq)]
pub struct Control {
    pub wrap: Wrap,
    pub image: ControlImage,
    pub use_as: Use,
}

/// What a control image is used for.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Use {
    /// First cells of one type only where it is white: where it is black they are of the other.
    FirstCells { of: CellType, instead: CellType },
    /// A number of the recipe, times a factor, 0 or more, that goes evenly from that of black to
    /// that of white. Days between divisions go by where the cell is when its clock is wound; what
    /// pushes a cell goes by the middle of the triangle that it is in (see `Ground`).
    Scale { number: Scaled, black: f64, white: f64 },
    /// The colour of cells of one type, wherever they are: it goes evenly from the type's own, black,
    /// to its tinted one, white. It is of no account for their lives.
    Colour { of: CellType },
    /// No step leads over it, and nothing is felt through it: along veins each vein, as far as it is white
    /// there, and elsewhere the border between what is white and what is black, both from edge to edge of the
    /// triangles.
    Wall,
}

impl Use {
    /// F only where the image is white, and B instead: what most plants have.
    pub const FOREGROUND: Use =
        Use::FirstCells { of: CellType::Foreground, instead: CellType::Background };
}

impl Control {
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

    /// The factor for a number of the recipe at a place.
    pub fn factor(&self, mesh: &Mesh, place: Place, number: Scaled) -> f64 {
        match self.use_as {
            Use::Scale { number: scaled, black, white } if scaled.is(number) => {
                let grey = f64::from(self.grey(mesh, place));
                black * (1.0 - grey) + white * grey
            }
            _ => 1.0,
        }
    }

    /// How far the colour of a cell of this type is tinted at a place, 0 to 1.
    pub fn tint(&self, mesh: &Mesh, place: Place, kind: CellType) -> f32 {
        match self.use_as {
            Use::Colour { of } if of == kind => self.grey(mesh, place),
            _ => 0.0,
        }
    }

    /// Takes away what joins triangles on two sides of a wall, if it is one: the edges there become rims, and the
    /// parts stay what they are.
    pub fn wall_off(&self, mesh: &mut Mesh) {
        // What lies on leaf coordinates that are not there is refused elsewhere.
        if self.use_as != Use::Wall || self.wrap == Wrap::Leaf && mesh.uvs.is_empty() {
            return;
        }
        for h in 0..mesh.twins.len() as u32 {
            let twin = mesh.twins[h as usize];
            if twin != NO_TWIN && self.parts(mesh, [h / 3, twin / 3]) {
                mesh.part(h);
            }
        }
    }

    /// Whether a wall is between two triangles that share an edge.
    fn parts(&self, mesh: &Mesh, triangles: [u32; 2]) -> bool {
        let [one, other] = triangles.map(|triangle| {
            let centre = Place { triangle, b1: 1.0 / 3.0, b2: 1.0 / 3.0 };
            let (turns, height) = self.wrap.coordinates(&self.image, mesh, centre);
            self.image.is_white(turns, height)
        });
        match self.wrap {
            Wrap::Veins(along) => one && other && mesh.veins.part(mesh, triangles, along.order),
            _ => one != other,
        }
    }

    fn grey(&self, mesh: &Mesh, place: Place) -> f32 {
        let (turns, height) = self.wrap.coordinates(&self.image, mesh, place);
        self.image.grey(turns, height)
    }

    /// Whether cells under it may be pushed in another way than the recipe says.
    pub fn scales_forces(&self) -> bool {
        matches!(self.use_as, Use::Scale { number, .. } if !number.is_days())
    }

    /// The factors for a number at the two ends of the image, the least first.
    fn ends(&self, number: Scaled) -> [f64; 2] {
        match self.use_as {
            Use::Scale { number: scaled, black, white } if scaled.is(number) => {
                [black.min(white), black.max(white)]
            }
            _ => [1.0, 1.0],
        }
    }
}

/// Refuses control images under which a number of the recipe could leave its range.
pub(super) fn check(recipe: &Recipe, controls: &[Control]) -> Result<(), RecipeError> {
    for control in controls {
        if let Use::Scale { black, white, .. } = control.use_as
            && ![black, white].iter().all(|factor| (0.0..=1000.0).contains(factor))
        {
            return Err(RecipeError(format!(
                "a control image has the factors {} at black and {} at white: they must be from 0 to 1000",
                black.shortest(),
                white.shortest()
            )));
        }
    }
    for end in [0, 1] {
        let factor = |number| controls.iter().map(|c| c.ends(number)[end]).product();
        recipe
            .scaled(&factor)
            .check()
            .map_err(|e| RecipeError(format!("under a control image, {e}")))?;
    }
    Ok(())
}
