//! Leaves from a few numbers: lobes with a main vein each, secondary veins, a border drawn beyond the ends
//! of the veins, and coordinates that belong to the leaf (Viennot, Eyrolles, Janey, Arquès, *Combinatorial
//! Analysis of Ramified Patterns and Computer Imagery of Trees*, SIGGRAPH 1989, section 6).

mod blade;
mod border;
mod coordinates;
mod flat;
mod limb;
mod mesh;
mod numbers;
mod plan;
#[cfg(test)]
mod tests;
mod triangles;

pub use blade::Blade;
pub use coordinates::LeafPoint;
pub use flat::FlatLeaf;
pub use limb::Limb;
pub use mesh::Leaf;
pub use numbers::{Border, LeafNumbers, Length};
pub use plan::{LeafPlan, Lobe, Vein};
