//! Catmull-Clark subdivision: a small control mesh becomes a smooth body at load.

use super::PolygonMesh;

impl PolygonMesh {
    /// `levels` rounds of Catmull-Clark subdivision with smooth boundary curves; texture coordinates
    /// are carried along. Only `+ - * /`, so that every machine gets the same bits.
    pub fn refined(&self, _levels: u32) -> PolygonMesh {
        todo!()
    }
}
