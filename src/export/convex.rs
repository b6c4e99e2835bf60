//! Convex polygons as triangles that are as fat as they can be.

use glam::Vec2;

/// Cuts convex polygons into triangles; it keeps its memory from one to the next.
#[derive(Debug, Default)]
pub struct Cutter {
    /// For each pair of corners how fat the leanest triangle between them is at best, and its third corner.
    best: Vec<(f32, usize)>,
    waiting: Vec<(usize, usize)>,
}

impl Cutter {
    /// The triangles of a polygon, counter-clockwise as its corners are, of which the leanest is as fat as it
    /// can be. Corners in the middle of a side are allowed.
    pub fn cut(&mut self, corners: &[Vec2], out: &mut Vec<[usize; 3]>) {
        let n = corners.len();
        out.clear();
        if n < 3 {
            return;
        }
        // Every chord, the short ones first (G. T. Klincsek, Minimal triangulations of polygonal domains,
        // 1980, with the leanest triangle in the place of the sum).
        self.best.clear();
        self.best.resize(n * n, (f32::INFINITY, 0));
        for span in 2..n {
            for from in 0..n - span {
                let to = from + span;
                let mut best = (f32::NEG_INFINITY, from + 1);
                for third in from + 1..to {
                    let fat = fatness([corners[from], corners[third], corners[to]])
                        .min(self.best[from * n + third].0)
                        .min(self.best[third * n + to].0);
                    if fat > best.0 {
                        best = (fat, third);
                    }
                }
                self.best[from * n + to] = best;
            }
        }
        self.waiting.clear();
        self.waiting.push((0, n - 1));
        while let Some((from, to)) = self.waiting.pop() {
            if to - from < 2 {
                continue;
            }
            let third = self.best[from * n + to].1;
            out.push([from, third, to]);
            self.waiting.extend([(third, to), (from, third)]);
        }
    }
}

/// Twice the area of a triangle by the square of its longest side: 0 for a line, 0.87 at most.
fn fatness([a, b, c]: [Vec2; 3]) -> f32 {
    let longest = a.distance_squared(b).max(b.distance_squared(c)).max(c.distance_squared(a));
    if longest > 0.0 { (b - a).perp_dot(c - a) / longest } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fatnesses(corners: &[[f32; 2]]) -> Vec<f32> {
        let corners: Vec<Vec2> = corners.iter().map(|&c| Vec2::from(c)).collect();
        let mut triangles = Vec::new();
        Cutter::default().cut(&corners, &mut triangles);
        triangles.iter().map(|t| fatness(t.map(|k| corners[k]))).collect()
    }

    #[test]
    fn a_square_with_corners_in_its_sides_has_no_line_among_its_triangles() {
        let square = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0], [3.0, 1.0], [3.0, 3.0]];
        let fat = fatnesses(&[&square[..], &[[1.5, 3.0], [0.0, 3.0], [0.0, 0.5]]].concat());
        assert_eq!(fat.len(), 7);
        assert!(fat.iter().all(|&fat| fat > 0.2), "{fat:?}");
    }

    #[test]
    fn a_rhombus_is_cut_along_its_shorter_diagonal() {
        // Two triangles with sides sqrt(5), sqrt(5), 2, and not two with a base of 4.
        let fat = fatnesses(&[[2.0, 0.0], [0.0, 1.0], [-2.0, 0.0], [0.0, -1.0]]);
        assert!(fat.len() == 2 && fat.iter().all(|f| (f - 4.0 / 5.0).abs() < 1e-6), "{fat:?}");
        assert!(fatnesses(&[[0.0, 0.0], [1.0, 0.0]]).is_empty());
    }
}
