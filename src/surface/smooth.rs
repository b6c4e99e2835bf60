//! A body without its bumps: how it is laid out for reaches that are far longer than they are.

use super::{Mesh, NO_TWIN};
use glam::Vec3;

/// How far the two half steps of a round lead towards, and then away from, the mean of the neighbours
/// (G. Taubin, A Signal Processing Approach to Fair Surface Design, SIGGRAPH 1995): together they smooth
/// bumps and do not shrink the body.
const HALF_STEPS: [f32; 2] = [0.5, -0.53];

/// Rounds spread over about the square root of so many triangles. More than these change little.
const MOST_ROUNDS: usize = 40;

/// The reach is so many times as long as the bumps that are smoothed. More, and bumps of a triangle's size
/// stay where the reach is a few triangles long.
const BUMPS_PER_REACH: f32 = 2.0;

impl Mesh {
    /// The same triangles without bumps that are far smaller than a reach (centimetres). Rims keep to
    /// themselves, and triangles that would lose their area keep their shape. The area of the whole is
    /// that of the rough surface.
    pub fn smoothed(&self, reach: f32) -> Mesh {
        let edge = (2.0 * self.area / self.triangles.len() as f32).sqrt();
        let across = reach / (BUMPS_PER_REACH * edge);
        let rounds = ((across * across) as usize).min(MOST_ROUNDS);
        let mut smooth = self.clone();
        let edges = self.smoothing_edges();
        for _ in 0..rounds {
            for share in HALF_STEPS {
                smooth.approach_neighbours(&edges, share);
            }
        }
        for t in 0..self.triangles.len() {
            let frame = super::mesh::frame(smooth.corners(t as u32));
            let area = 0.5 * frame.length * frame.apex.y;
            if area > LEAST_AREA * self.areas[t] {
                (smooth.frames[t], smooth.areas[t]) = (frame, area);
            }
        }
        smooth
    }

    /// Pairs of vertices of which the first is drawn to the second: all neighbours, but on a rim along
    /// the rim alone.
    fn smoothing_edges(&self) -> Vec<[u32; 2]> {
        let ends = |h: usize| {
            let t = self.triangles[h / 3];
            [t[(h + 1) % 3], t[(h + 2) % 3]]
        };
        let mut on_rim = vec![false; self.positions.len()];
        let rim = (0..self.twins.len()).filter(|&h| self.twins[h] == NO_TWIN);
        for v in rim.flat_map(ends) {
            on_rim[v as usize] = true;
        }
        let mut edges = Vec::new();
        for (h, &twin) in self.twins.iter().enumerate() {
            let [a, b] = ends(h);
            for pair in [[a, b], [b, a]] {
                if !on_rim[pair[0] as usize] || twin == NO_TWIN {
                    edges.push(pair);
                }
            }
        }
        edges
    }

    fn approach_neighbours(&mut self, edges: &[[u32; 2]], share: f32) {
        let mut sums = vec![(Vec3::ZERO, 0.0); self.positions.len()];
        for &[vertex, neighbour] in edges {
            let (sum, count) = &mut sums[vertex as usize];
            *sum += self.positions[neighbour as usize];
            *count += 1.0;
        }
        for (position, (sum, count)) in self.positions.iter_mut().zip(sums) {
            if count > 0.0 {
                *position += (sum / count - *position) * share;
            }
        }
    }
}

/// Triangles that would keep less than this share of their area are left as they are.
const LEAST_AREA: f32 = 1e-3;

#[cfg(test)]
mod tests {
    use crate::surface::{Mesh, icosphere};

    /// How many times as large as a smooth one the sphere is, laid out.
    fn area(mesh: &Mesh, sphere: &Mesh) -> f32 {
        mesh.areas.iter().sum::<f32>() / sphere.area
    }

    #[test]
    fn a_sphere_stays_as_large_as_it_is_and_its_bumps_go() {
        let sphere = icosphere(4, 5.0);
        let smooth = area(&sphere.smoothed(5.0), &sphere);
        assert!((smooth - 1.0).abs() < 0.02, "{smooth}");
        let bump =
            |(k, p): (usize, &glam::Vec3)| *p * (1.0 + 0.03 * (k as f32 * 0.618_034).fract());
        let positions = sphere.positions.iter().enumerate().map(bump).collect();
        let rough = Mesh::new(positions, Vec::new(), sphere.triangles.clone()).unwrap();
        let smooth = rough.smoothed(5.0);
        assert_eq!(smooth.area, rough.area);
        // Without bumps its mean radius would make it so large.
        let even = 1.015 * 1.015;
        let [rough, smooth] = [&rough, &smooth].map(|mesh| area(mesh, &sphere) - even);
        assert!(smooth < 0.3 * rough, "of {rough} there are {smooth} left");
    }

    #[test]
    fn for_a_short_reach_nothing_is_smoothed() {
        let sphere = icosphere(3, 5.0);
        assert_eq!(sphere.smoothed(1.0).frames, sphere.frames);
    }
}
