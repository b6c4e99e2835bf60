//! The ground that cells push each other on: even, or in each triangle as its control images say
//! (Thesis 3.2.3).

use super::forces::Forces;
use super::lanes::LANES;
use super::{Control, Recipe};
use crate::surface::{Mesh, Place};
use wide::f32x4;

/// The forces of a day, all over the body.
///
/// Under images that scale them they are those of the recipe with the numbers scaled as in the
/// middle of the cell's triangle: at each event a cell is pushed as its own triangle has it, however
/// its neighbours are. Triangles are as small as cells, or nearly, and to look an image up for each
/// cell at each event would take as long as to push it.
pub enum Ground {
    Even(Forces),
    /// By triangle.
    Uneven(Vec<Forces>),
}

impl Ground {
    /// The forces of a day whose repulsive radius is made for so many cells. `mesh`: the body on that day;
    /// `rest`: as images lie on it.
    pub fn new(
        mesh: &Mesh,
        rest: &Mesh,
        recipe: &Recipe,
        controls: &[Control],
        cells: usize,
        day: usize,
    ) -> Ground {
        let forces = |recipe: &Recipe| Forces::new(recipe, mesh.area, cells, day);
        if !controls.iter().any(Control::scales_forces) {
            return Ground::Even(forces(recipe));
        }
        let local = |triangle| {
            let middle = Place { triangle, b1: 1.0 / 3.0, b2: 1.0 / 3.0 };
            let factor = |number| controls.iter().map(|c| c.factor(rest, middle, number)).product();
            forces(&recipe.scaled(&factor))
        };
        Ground::Uneven((0..mesh.triangles.len() as u32).map(local).collect())
    }

    /// The forces on cells in a triangle.
    #[inline]
    pub fn at(&self, triangle: u32) -> &Forces {
        match self {
            Ground::Even(forces) => forces,
            Ground::Uneven(forces) => &forces[triangle as usize],
        }
    }

    /// For cells in four triangles.
    #[inline]
    pub(super) fn repulsions_and_radii_cm(
        &self,
        triangles: impl FnOnce() -> [u32; LANES],
    ) -> (f32x4, f32x4) {
        match self {
            Ground::Even(forces) => (f32x4::splat(forces.repulsion), f32x4::splat(forces.radius)),
            Ground::Uneven(forces) => {
                let four = triangles().map(|triangle| &forces[triangle as usize]);
                (f32x4::new(four.map(|f| f.repulsion)), f32x4::new(four.map(|f| f.radius)))
            }
        }
    }

    /// The greatest repulsive radius, in centimetres.
    pub fn reach_cm(&self) -> f32 {
        match self {
            Ground::Even(forces) => forces.radius,
            Ground::Uneven(forces) => forces.iter().map(|f| f.radius).fold(0.0, f32::max),
        }
    }
}
