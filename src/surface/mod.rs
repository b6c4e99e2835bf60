//! Where cells live: triangle meshes, their neighbours, and the ways across their edges.

mod body;
mod chart;
mod cylinder;
mod mesh;
mod obj;
mod refine;
mod walk;

pub use body::{Body, Ornament, SurfaceError};
pub use chart::{Charts, Image, Images};
pub use cylinder::{Control, ControlImage, Cylinder, Tone, Wrap};
pub use mesh::{Frame, Mesh, NO_TWIN, Place};
pub use obj::{Face, Group, ObjError, PolygonMesh};
pub use walk::{Step, walk};
