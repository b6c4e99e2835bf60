//! Whether one sees through a row of gates.

use super::lengths::length;
use glam::Vec2;

/// Whether some straight line passes through a chain of gates, each given by its left and its right
/// end as seen on the way out, the outermost first. They are left turned.
///
/// Seen along the way out, such a line `y = a + b x` runs below every left end and above every
/// right end. For a slope `b` the room left for `a` is the least height over the left ends minus
/// the greatest over the right ends: a concave function of `b`, whose greatest value is looked
/// for by cutting planes (Kelley 1960).
pub(super) fn is_in_sight(chain: &mut [(Vec2, Vec2)]) -> bool {
    /// More slopes than are ever needed, but for rounding; then there may be a line.
    const MOST_SLOPES: usize = 12;
    let middle = |(left, right): (Vec2, Vec2)| 0.5 * (left + right);
    let (outermost, first) = (chain[0], chain[chain.len() - 1]);
    let along = middle(outermost) - middle(first);
    let length = length(along);
    if length == 0.0 {
        return true;
    }
    let (origin, x_axis) = (middle(first), along / length);
    for (left, right) in chain.iter_mut() {
        *left = turned_back(*left - origin, x_axis);
        *right = turned_back(*right - origin, x_axis);
    }
    let slack = 1e-5 * length;
    let (mut slope, mut low, mut high) = (0.0f32, f32::NEG_INFINITY, f32::INFINITY);
    for _ in 0..MOST_SLOPES {
        let (mut roof, mut floor) = (f32::INFINITY, f32::NEG_INFINITY);
        let (mut roof_x, mut floor_x) = (0.0, 0.0);
        for (left, right) in chain.iter() {
            let (over, under) = (left.y - slope * left.x, right.y - slope * right.x);
            if over < roof {
                (roof, roof_x) = (over, left.x);
            }
            if under > floor {
                (floor, floor_x) = (under, right.x);
            }
        }
        let room = roof - floor;
        if room >= -slack {
            return true;
        }
        // The room grows at most so quickly with the slope.
        let growth = floor_x - roof_x;
        if growth == 0.0 {
            return false;
        }
        let needed = slope - room / growth;
        if growth > 0.0 {
            low = low.max(needed)
        } else {
            high = high.min(needed)
        }
        if low > high {
            return false;
        }
        slope = needed;
    }
    true
}

/// A vector in the frame whose x axis is a unit vector.
fn turned_back(v: Vec2, x_axis: Vec2) -> Vec2 {
    Vec2::new(x_axis.dot(v), x_axis.perp_dot(v))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether a line through a left and a right end passes between all ends with this much room.
    fn passes(ends: &[(Vec2, Vec2)], room: f32) -> bool {
        let lines = ends.iter().flat_map(|&(l, _)| ends.iter().map(move |&(_, r)| (l, r)));
        lines.into_iter().any(|(l, r)| {
            // Outwards is up in these tests.
            let along = if l.y > r.y { l - r } else { r - l }.normalize_or_zero();
            ends.iter().all(|&(left, right)| {
                along.perp_dot(left - l) >= room && along.perp_dot(right - r) <= -room
            })
        })
    }

    #[test]
    fn a_portal_is_seen_through_if_a_line_through_two_ends_passes_all() {
        let mut state = 7u32;
        let mut chance = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) as f32 / (1 << 24) as f32
        };
        let mut seen = [0; 2];
        for _ in 0..20_000 {
            let count = 2 + (chance() * 9.0) as usize;
            let lean = chance() - 0.5;
            let ends: Vec<(Vec2, Vec2)> = (0..count)
                .map(|k| {
                    let (y, middle) = (k as f32 + 0.6 * chance(), lean * k as f32 + chance());
                    let half = 0.1 + 0.5 * chance();
                    let (left, right) = (middle - half, middle + half);
                    (Vec2::new(left, y), Vec2::new(right, y + 0.3 * chance()))
                })
                .collect();
            let [surely, perhaps] = [1e-3, -1e-3].map(|room| passes_with(&ends, room));
            let outermost_first = ends.iter().rev().copied();
            let sees = is_in_sight(&mut outermost_first.collect::<Vec<_>>());
            if surely == perhaps {
                assert_eq!(sees, surely, "{ends:?}");
                seen[usize::from(sees)] += 1;
            }
        }
        assert!(seen[0] > 2_000 && seen[1] > 2_000, "{seen:?}");
    }

    /// The same with the ends moved apart (or together) by so much.
    fn passes_with(ends: &[(Vec2, Vec2)], room: f32) -> bool {
        let narrow = Vec2::new(room, 0.0);
        let moved: Vec<_> = ends.iter().map(|&(l, r)| (l + narrow, r - narrow)).collect();
        passes(&moved, -1e-6)
    }
}
