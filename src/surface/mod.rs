//! Where cells live: triangle meshes, their neighbours, and the ways across their edges.

mod body;
mod brought;
mod chart;
mod cut;
mod cylinder;
mod field;
mod fitting;
mod formats;
mod layout;
mod lengths;
mod mesh;
mod obj;
mod obj_reader;
mod outline;
mod patches;
mod quote;
mod refine;
mod sight;
mod sphere;
mod stitch;
mod walk;

pub use body::{Body, Ornament, SurfaceError};
pub use brought::{Brought, BroughtError};
pub use chart::{Charts, Image};
pub use cylinder::{ControlImage, Cylinder, Wrap};
pub use field::{DirectionField, FieldError, Guide};
pub(crate) use lengths::{distance, length};
pub use mesh::{Frame, Mesh, NO_TWIN, Place};
pub use obj::{Face, Group, ObjError, PolygonMesh};
pub use outline::Outline;
pub use patches::{Patch, Patches};
pub use quote::quoted;
pub use sphere::icosphere;
pub use walk::{Step, walk};
