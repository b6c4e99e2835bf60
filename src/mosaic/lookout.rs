//! Sites found from the cells' side: where few triangles hold cells, these look out for the triangles
//! around them, in the place of each triangle looking for cells.

use super::near::{NearSite, SortedCells};
use crate::surface::{Charts, Mesh};
use glam::Vec2;

/// The sites around each triangle of a mesh.
#[derive(Clone, Debug, Default)]
pub struct Lookout {
    /// As they were found.
    seen: Vec<NearSite>,
    /// For each of them the triangle that it is seen from, whether that is another than its own, and its
    /// number, in one integer that orders by them.
    order: Vec<u64>,
    /// In the order of the triangles.
    sites: Vec<NearSite>,
    /// The first site of each triangle, and the end of the last.
    starts: Vec<u32>,
}

impl Lookout {
    /// Finds all sites within `radius` (centimetres) of each triangle.
    pub fn look(&mut self, mesh: &Mesh, charts: &mut Charts, cells: &SortedCells, radius: f32) {
        self.seen.clear();
        self.order.clear();
        for home in 0..mesh.triangles.len() {
            let rows = cells.of(home);
            if rows.is_empty() {
                continue;
            }
            let images = charts.around(mesh, home as u32, radius);
            for image in images.iter().take_while(|image| image.distance <= radius) {
                let (from, per_cm) = (image.triangle, image.laid.to_barycentric());
                let there = |place: Vec2| {
                    let [b1, b2] = per_cm.map(|per_cm| per_cm.dot(place - image.laid.origin));
                    mesh.frames[from as usize].point(b1, b2)
                };
                for row in rows.clone() {
                    let key = u64::from(from) << 1 | u64::from(from as usize != home);
                    self.order.push(key << 32 | self.seen.len() as u64);
                    let site = cells.site(&mesh.frames[home], row);
                    let (now, before) = (there(site.now), there(site.before));
                    self.seen.push(NearSite { now, before, ..site });
                }
            }
        }
        self.order.sort_unstable();
        self.sites.clear();
        self.sites.extend(self.order.iter().map(|&key| self.seen[key as u32 as usize]));
        self.starts.clear();
        self.starts.resize(mesh.triangles.len() + 1, 0);
        for key in &self.order {
            self.starts[(key >> 33) as usize + 1] += 1;
        }
        for triangle in 0..mesh.triangles.len() {
            self.starts[triangle + 1] += self.starts[triangle];
        }
    }

    /// The sites around a triangle, its own first.
    pub fn of(&self, triangle: usize) -> &[NearSite] {
        &self.sites[self.starts[triangle] as usize..self.starts[triangle + 1] as usize]
    }
}
