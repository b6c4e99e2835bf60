//! Sites found from the cells' side: where few triangles hold cells, these look out for the triangles
//! around them, in the place of each triangle looking for cells.

use super::near::{NearSite, SortedCells};
use crate::surface::{Charts, Mesh};

/// The sites around each triangle of a mesh.
#[derive(Clone, Debug, Default)]
pub struct Lookout {
    seen: Vec<Seen>,
    /// The sites in the order of the triangles that they are seen from.
    sites: Vec<NearSite>,
    /// The first site of each triangle, and the end of the last.
    starts: Vec<u32>,
}

/// A site as it is seen from a triangle.
#[derive(Clone, Copy, Debug)]
struct Seen {
    from: u32,
    is_elsewhere: bool,
    site: NearSite,
}

impl Lookout {
    /// Finds all sites within `radius` (centimetres) of each triangle.
    pub fn look(&mut self, mesh: &Mesh, charts: &mut Charts, cells: &SortedCells, radius: f32) {
        self.seen.clear();
        for home in 0..mesh.triangles.len() {
            let rows = cells.of(home);
            if rows.is_empty() {
                continue;
            }
            let images = charts.around(mesh, home as u32, radius);
            for image in images.iter().take_while(|image| image.distance <= radius) {
                let (from, per_cm) = (image.triangle, image.to_barycentric());
                let there = |place: glam::Vec2| {
                    let [b1, b2] = per_cm.map(|per_cm| per_cm.dot(place - image.origin));
                    mesh.frames[from as usize].point(b1, b2)
                };
                for row in rows.clone() {
                    let site = cells.site(&mesh.frames[home], row);
                    let site =
                        NearSite { now: there(site.now), before: there(site.before), ..site };
                    self.seen.push(Seen { from, is_elsewhere: from as usize != home, site });
                }
            }
        }
        self.seen.sort_by_key(|seen| (seen.from, seen.is_elsewhere));
        self.sites.clear();
        self.sites.extend(self.seen.iter().map(|seen| seen.site));
        self.starts.clear();
        self.starts.resize(mesh.triangles.len() + 1, 0);
        for seen in &self.seen {
            self.starts[seen.from as usize + 1] += 1;
        }
        for t in 0..mesh.triangles.len() {
            self.starts[t + 1] += self.starts[t];
        }
    }

    /// The sites around a triangle, its own first.
    pub fn of(&self, triangle: usize) -> &[NearSite] {
        &self.sites[self.starts[triangle] as usize..self.starts[triangle + 1] as usize]
    }
}
