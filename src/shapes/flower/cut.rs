//! How far petals pass through each other, for tests.

use crate::shapes::crossing::crosses;
use glam::Vec3;

/// The share of the area of all triangles that lies in those which a triangle of another petal crosses; each comes with the number
/// of its petal.
pub fn cut_share(mut triangles: Vec<([Vec3; 3], u32)>) -> f64 {
    let least = |t: &[Vec3; 3]| t[0].min(t[1]).min(t[2]);
    let most = |t: &[Vec3; 3]| t[0].max(t[1]).max(t[2]);
    triangles.sort_by(|a, b| least(&a.0).x.total_cmp(&least(&b.0).x));
    let mut is_cut = vec![false; triangles.len()];
    for (k, (one, petal)) in triangles.iter().enumerate() {
        for (j, (other, another)) in triangles.iter().enumerate().skip(k + 1) {
            if least(other).x > most(one).x {
                break;
            }
            let apart = least(one).cmpgt(most(other)).any() || least(other).cmpgt(most(one)).any();
            if petal != another && !apart && (crosses(one, other) || crosses(other, one)) {
                (is_cut[k], is_cut[j]) = (true, true);
            }
        }
    }
    let area = |t: &[Vec3; 3]| f64::from((t[1] - t[0]).cross(t[2] - t[0]).length());
    let all: f64 = triangles.iter().map(|t| area(&t.0)).sum();
    let cut = triangles.iter().zip(&is_cut).filter(|(_, cut)| **cut).map(|(t, _)| area(&t.0));
    cut.sum::<f64>() / all
}
