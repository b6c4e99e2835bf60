//! Trees from a matrix: how branches of each order meet decides the shape of the whole (Viennot,
//! Eyrolles, Janey, Arquès, *Combinatorial Analysis of Ramified Patterns and Computer Imagery of
//! Trees*, SIGGRAPH 1989).

mod bark;
mod census;
mod foliage;
mod named;
mod numbers;
mod ramification;
mod skeleton;
#[cfg(test)]
mod tests;
mod tree;

pub use bark::{bark, wood};
pub use census::Census;
pub use named::NAMES;
pub use numbers::{Law, Matrix, TreeNumbers, Width};
pub use ramification::Ramification;
pub use skeleton::{Limb, skeleton};
pub use tree::{Node, Tree};

use super::ShapeError;
use crate::surface::PolygonMesh;

/// A tree as its numbers say: bare, of bark that carries cells, or with leaves that do.
///
/// # Errors
/// Numbers of a leaf that are out of their ranges.
pub fn body(tree: &Tree, numbers: &TreeNumbers) -> Result<PolygonMesh, ShapeError> {
    match &numbers.leaf {
        Some(leaf) => foliage::leafy(tree, numbers, leaf),
        None => Ok(bark(tree, numbers)),
    }
}
