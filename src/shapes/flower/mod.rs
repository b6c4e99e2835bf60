//! Flowers from a few strokes: petals as spline sheets, in the bud and open, and the way between them (Song et
//! al., *Sketch-Based Modeling and Animation of Floral Blossom*, Journal of Software 18, 2007).

mod bspline;
#[cfg(test)]
pub(crate) mod cut;
mod growth;
mod layout;
mod numbers;
mod opening;
mod perianth;
mod petal;
mod receptacle;
mod rod;
mod sepals;
mod solve;
mod stamens;
mod template;
#[cfg(test)]
mod tests;
mod whole;

pub use growth::Growth;
pub use numbers::FlowerNumbers;
pub use perianth::{Perianth, Petal};
pub use petal::{Arrangement, CrossStroke, PetalNumbers};
pub use receptacle::ReceptacleNumbers;
pub use rod::RodNumbers;
pub use sepals::{SepalNumbers, Sepals};
pub use stamens::StamenNumbers;
pub use whole::Flower;
