//! A plant as bodies that can be printed: what is closed stays as it is, and sheets get a thickness.

use super::outlines::outlines;
use super::specimen::Specimen;
use crate::surface::NO_TWIN;
use glam::Vec3;

/// How thick sheets become, in centimetres: three lines of a usual nozzle.
pub const THICKNESS_CM: f32 = 0.12;

/// Closed bodies: each edge of a triangle is met by one that runs the other way.
#[derive(Default)]
pub struct Solid {
    /// In centimetres, y up.
    pub positions: Vec<Vec3>,
    /// Corners, and the material: F, B, M, and from 3 on the bare ones.
    pub triangles: Vec<([u32; 3], usize)>,
}

impl Solid {
    pub fn new(specimen: &Specimen) -> Solid {
        let (mesh, tiling) = (specimen.mesh, &specimen.tiling);
        let points: Vec<(Vec3, Vec3)> =
            tiling.points.iter().map(|point| (point.position, point.normal)).collect();
        let mut parts = vec![Vec::new(); mesh.part_count()];
        for facet in &tiling.facets {
            let part = mesh.parts[facet.triangle as usize];
            parts[part as usize].push((facet.corners, specimen.kind(facet) as usize));
        }
        let mut is_open = vec![false; parts.len()];
        for (half_edge, _) in mesh.twins.iter().enumerate().filter(|(_, twin)| **twin == NO_TWIN) {
            is_open[mesh.parts[half_edge / 3] as usize] = true;
        }
        let mut solid = Solid::default();
        for (part, is_open) in parts.into_iter().zip(is_open) {
            solid.add(&points, part, is_open);
        }
        for (material, bare) in (3..).zip(&specimen.bare) {
            let points: Vec<(Vec3, Vec3)> =
                bare.positions.iter().copied().zip(bare.normals.iter().copied()).collect();
            for part in connected(points.len(), &bare.triangles) {
                let is_open = outlines(part.iter().copied()).next().is_some();
                solid.add(&points, part.into_iter().map(|t| (t, material)).collect(), is_open);
            }
        }
        solid
    }

    /// Adds triangles between points with normals.
    fn add(&mut self, points: &[(Vec3, Vec3)], part: Vec<([u32; 3], usize)>, is_open: bool) {
        let mut used: Vec<u32> = part.iter().flat_map(|(corners, _)| *corners).collect();
        used.sort_unstable();
        used.dedup();
        let first = self.positions.len() as u32;
        let number = |point: u32| first + used.partition_point(|&other| other < point) as u32;
        let under = used.len() as u32;
        let half = if is_open { 0.5 * THICKNESS_CM } else { 0.0 };
        let at = |&point: &u32| points[point as usize];
        self.positions.extend(used.iter().map(at).map(|(place, normal)| place + normal * half));
        let top: Vec<([u32; 3], usize)> =
            part.iter().map(|&(corners, material)| (corners.map(number), material)).collect();
        self.triangles.extend(&top);
        let outlines = outlines(top.iter().map(|t| t.0));
        if !is_open {
            // Cracks without width, which rounding left.
            for outline in outlines {
                for k in 2..outline.len() {
                    self.triangles.push(([outline[0], outline[k], outline[k - 1]], top[0].1));
                }
            }
            return;
        }
        self.positions.extend(used.iter().map(at).map(|(place, normal)| place - normal * half));
        let turned = |&([a, b, c], material): &([u32; 3], usize)| {
            ([a, c, b].map(|point| point + under), material)
        };
        self.triangles.extend(top.iter().map(turned));
        for outline in outlines {
            for (k, &a) in outline.iter().enumerate() {
                let b = outline[(k + 1) % outline.len()];
                let material = top[0].1;
                self.triangles.push(([b, a, a + under], material));
                self.triangles.push(([b, a + under, b + under], material));
            }
        }
    }
}

/// The triangles that hang together by their corners.
fn connected(points: usize, triangles: &[[u32; 3]]) -> Vec<Vec<[u32; 3]>> {
    let mut towards: Vec<u32> = (0..points as u32).collect();
    for t in triangles {
        for k in 1..3 {
            let [a, b] = [t[0], t[k]].map(|point| follow(&mut towards, point));
            towards[a.max(b) as usize] = a.min(b);
        }
    }
    let mut parts: Vec<(u32, [u32; 3])> =
        triangles.iter().map(|&t| (follow(&mut towards, t[0]), t)).collect();
    parts.sort_by_key(|part| part.0);
    let of_one = parts.chunk_by(|a, b| a.0 == b.0);
    of_one.map(|part| part.iter().map(|&(_, t)| t).collect()).collect()
}

/// The point that stands for all that hang together with a point; ways that were gone are shortened by half.
fn follow(towards: &mut [u32], mut point: u32) -> u32 {
    while towards[point as usize] != point {
        let next = towards[point as usize] as usize;
        towards[point as usize] = towards[next];
        point = towards[point as usize];
    }
    point
}
