//! The ground that cells push each other on: even, or in each triangle as its control images say
//! (Thesis 3.2.3).

use super::forces::Forces;
use super::lanes::LANES;
use super::{Control, Recipe};
use crate::surface::{Mesh, Place};
use wide::f32x4;

/// What shares a repulsive radius: its area in square centimetres, and the number of its cells.
pub type Share = (f32, usize);

/// The forces of a day, all over the body.
///
/// Under images that scale them they are those of the recipe with the numbers scaled as in the
/// middle of the cell's triangle: at each event a cell is pushed as its own triangle has it, however
/// its neighbours are. Triangles are as small as cells, or nearly, and to look an image up for each
/// cell at each event would take as long as to push it.
pub enum Ground {
    /// By part of the body, or one for all.
    Even(Vec<Forces>),
    /// By triangle.
    Uneven(Vec<Forces>),
}

impl Ground {
    /// The forces of a day. `shares`: of each part of the body, or one of all of it.
    pub fn new(
        mesh: &Mesh,
        recipe: &Recipe,
        controls: &[Control],
        shares: &[Share],
        day: usize,
    ) -> Ground {
        let forces = |recipe: &Recipe, share| Forces::new(recipe, share, day);
        if !controls.iter().any(Control::scales_forces) {
            return Ground::Even(shares.iter().map(|&share| forces(recipe, share)).collect());
        }
        let local = |triangle| {
            let middle = Place { triangle, b1: 1.0 / 3.0, b2: 1.0 / 3.0 };
            let factor = |number| controls.iter().map(|c| c.factor(mesh, middle, number)).product();
            forces(&recipe.scaled(&factor), *of_part(shares, mesh, triangle))
        };
        Ground::Uneven((0..mesh.triangles.len() as u32).map(local).collect())
    }

    /// The forces on cells in a triangle.
    #[inline]
    pub fn at(&self, mesh: &Mesh, triangle: u32) -> &Forces {
        match self {
            Ground::Even(forces) => of_part(forces, mesh, triangle),
            Ground::Uneven(forces) => &forces[triangle as usize],
        }
    }

    /// For cells in four triangles of one part.
    #[inline]
    pub(super) fn repulsions_and_radii_cm(
        &self,
        mesh: &Mesh,
        triangles: [u32; LANES],
    ) -> (f32x4, f32x4) {
        match self {
            Ground::Even(forces) => {
                let forces = of_part(forces, mesh, triangles[0]);
                (f32x4::splat(forces.repulsion), f32x4::splat(forces.radius))
            }
            Ground::Uneven(forces) => {
                let four = triangles.map(|triangle| &forces[triangle as usize]);
                (f32x4::new(four.map(|f| f.repulsion)), f32x4::new(four.map(|f| f.radius)))
            }
        }
    }

    /// The greatest repulsive radius, in centimetres.
    pub fn reach_cm(&self) -> f32 {
        let (Ground::Even(forces) | Ground::Uneven(forces)) = self;
        forces.iter().map(|f| f.radius).fold(0.0, f32::max)
    }

    /// The greatest on the part of a triangle, or where it differs within parts, on the body.
    pub(super) fn reach_around_cm(&self, mesh: &Mesh, triangle: u32) -> f32 {
        match self {
            Ground::Even(forces) => of_part(forces, mesh, triangle).radius,
            Ground::Uneven(_) => self.reach_cm(),
        }
    }
}

/// What belongs to the part of a triangle, if there is something for each, or else to the whole body.
#[inline]
fn of_part<'a, T>(things: &'a [T], mesh: &Mesh, triangle: u32) -> &'a T {
    &things[(mesh.parts[triangle as usize] as usize).min(things.len() - 1)]
}
