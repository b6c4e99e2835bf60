//! The border of half a lobe: corners beyond the ends of the veins, and the curves between them. `x` is the
//! distance from the main vein and `y` that along it.

use super::Border;
use glam::DVec2;

/// Pieces of a curved side at most.
const MOST_PIECES: f64 = 16.0;

/// The leafstalk, a point beyond the end of each secondary vein, and one beyond the tip of the main vein: the
/// last piece of each is `factor` times as long. `feet` are the nodes of the main vein, `lengths` those of the
/// secondary veins from the first inner node on.
///
/// A secondary vein is at least so long that the border does not turn in between the leafstalk and the corner
/// beyond it: every ray from the leafstalk leaves the half once, which makes the homothety ratio one number.
pub fn corners(feet: &[f64], lengths: &[f64], secondary: DVec2, factor: f64) -> Vec<DVec2> {
    let last = feet.len() - 1;
    let tip = feet[last] + (factor - 1.0) * (feet[last] - feet[last - 1]);
    let mut half = vec![DVec2::new(0.0, tip)];
    let mut slope = 0.0f64;
    for (&foot, length) in feet[1..last].iter().zip(lengths).rev() {
        let out = (length * factor).max(slope * foot);
        slope = out / foot;
        half.push(DVec2::new(0.0, foot) + secondary * out);
    }
    half.push(DVec2::ZERO);
    half.reverse();
    half
}

/// The corners with a cubic in the place of each side (the source: with given tangents at both ends), which
/// keeps to its own half.
pub fn curve(corners: &[DVec2], border: Border, spacing_cm: f64) -> Vec<DVec2> {
    if border == Border::Polygon {
        return corners.to_vec();
    }
    let last = corners.len() - 1;
    let mut points = vec![corners[0]];
    for k in 0..last {
        let [a, b] = [corners[k], corners[k + 1]];
        let side = b - a;
        let [start, end] = match border {
            Border::Toothed { tooth_deg } => {
                let radians = tooth_deg.to_radians();
                let inward = DVec2::new(libm::cos(radians), libm::sin(radians));
                // No tooth in the leafstalk.
                let start = if k == 0 { side } else { inward.rotate(side) };
                [start, DVec2::new(inward.x, -inward.y).rotate(side)]
            }
            _ => {
                let tangent = |k: usize| {
                    let around = corners[k + 1] - corners[k - 1];
                    around * (side.length() / around.length())
                };
                let start = if k == 0 { side } else { tangent(k) };
                [start, if k + 1 == last { side } else { tangent(k + 1) }]
            }
        };
        let pieces = (side.length() / spacing_cm).ceil().clamp(2.0, MOST_PIECES);
        let [first, second] = [a + start / 3.0, b - end / 3.0];
        for piece in 1..pieces as u32 {
            let t = f64::from(piece) / pieces;
            let s = 1.0 - t;
            let p = a * (s * s * s)
                + first * (3.0 * s * s * t)
                + second * (3.0 * s * t * t)
                + b * (t * t * t);
            points.push(DVec2::new(p.x.max(0.0), p.y));
        }
        points.push(b);
    }
    points
}
