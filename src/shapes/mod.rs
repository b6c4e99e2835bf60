//! Bodies from rules: a few numbers in, a body with coordinates of its own out.

pub mod branching;
mod chance;
pub(crate) mod crossing;
pub mod flower;
pub mod leaf;
mod read;
mod rule;
mod short;
mod tube;
pub mod veins;
mod wrong;

pub use rule::{Numbers, Rule, opening};
pub use wrong::ShapeError;
