//! For each triangle the short list of sites whose Voronoi polygons may reach into it: what a
//! fragment shader needs to find the nearest one.

use crate::surface::{Charts, Mesh};
use crate::tissue::Diary;

/// One candidate site of one triangle, four words as the shader reads them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct Sites {
    /// Place on the shown day in the triangle's plane: `x` in the low 16 bits, `y` in the high 16,
    /// each `(value - 32768) * scale` centimetres from the triangle's centroid.
    pub now: u32,
    /// The same for the day before (for a cell born since: its parent's place). Motion between the
    /// days is the straight line from `before` to `now`.
    pub before: u32,
    /// The cell's number.
    pub cell: u32,
    /// `CellType` in the two low bits.
    pub kind: u32,
}

/// The lists of all triangles for one day.
#[derive(Clone, Debug, Default)]
pub struct SiteLists {
    /// For each triangle: first site, number of sites, bits of the f32 `scale`, and 0.
    pub heads: Vec<[u32; 4]>,
    pub sites: Vec<Sites>,
}

impl SiteLists {
    /// Builds the lists of a day, exact for every moment between the day before and this one.
    /// `charts` may serve any number of days of one mesh.
    pub fn build(&mut self, _mesh: &Mesh, _charts: &mut Charts, _diary: &Diary, _day: usize) {
        todo!()
    }
}
