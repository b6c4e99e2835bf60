//! Whether sheets pass through each other.

use glam::Vec3;

/// Whether a side of one triangle goes through the other.
pub fn crosses(one: &[Vec3; 3], other: &[Vec3; 3]) -> bool {
    let sides = [[one[0], one[1]], [one[1], one[2]], [one[2], one[0]]];
    sides.into_iter().any(|[p, q]| pierces(p, q, *other))
}

/// Whether the straight line from `p` to `q` goes through a triangle.
pub fn pierces(p: Vec3, q: Vec3, [a, b, c]: [Vec3; 3]) -> bool {
    let volume = |a: Vec3, b: Vec3, c: Vec3, d: Vec3| (b - a).cross(c - a).dot(d - a);
    let sides = [volume(p, q, a, b), volume(p, q, b, c), volume(p, q, c, a)];
    let through = sides.iter().all(|&v| v > 0.0) || sides.iter().all(|&v| v < 0.0);
    through && volume(a, b, c, p) * volume(a, b, c, q) < 0.0
}
