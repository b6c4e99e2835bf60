//! Trees from a matrix: how branches of each order meet decides the shape of the whole (Viennot,
//! Eyrolles, Janey, Arquès, *Combinatorial Analysis of Ramified Patterns and Computer Imagery of
//! Trees*, SIGGRAPH 1989).

mod bark;
mod census;
mod named;
mod numbers;
mod ramification;
mod skeleton;
#[cfg(test)]
mod tests;
mod tree;

pub use bark::bark;
pub use census::Census;
pub use named::NAMES;
pub use numbers::{Law, Matrix, TreeNumbers, Width};
pub use ramification::Ramification;
pub use skeleton::{Limb, skeleton};
pub use tree::{Node, Tree};
