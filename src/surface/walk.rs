//! Straight walks over the surface: a step in the plane of one triangle goes on over its edges as
//! if the neighbours were unfolded into that plane, and slides along the rim of an open surface.

use super::lengths::{length, normalized};
use super::{Mesh, NO_TWIN, Place, limited};
use glam::Vec2;

/// Edges that one step may cross, and how many more for each mean edge of the mesh that it is long. A
/// relaxation step is at most half a repulsive radius long and crosses a few; where cells are few it may
/// lead halfway around the body, and through fans of narrow triangles. A walk that comes farther is caught
/// among slivers.
const MAX_CROSSINGS: usize = 64;
const CROSSINGS_PER_EDGE: f32 = 64.0;

/// A walk that met a rim so few crossings ago stands in a corner of it, where it comes to and fro between two
/// edges of the rim over those that meet there.
const EDGES_AT_A_CORNER: usize = 8;

/// No edge: the walk has just begun.
const NONE: usize = 3;

/// Where a walk ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    pub place: Place,
    /// The walk was cut short at its last valid place after too many crossings.
    pub caught: bool,
}

/// Walks from a place along `step`, a vector in the frame of the place's triangle (centimetres).
#[inline]
pub fn walk(mesh: &Mesh, from: Place, step: Vec2) -> Step {
    let change = mesh.frames[from.triangle as usize].barycentric(step);
    let (b1, b2) = (from.b1 + change.x, from.b2 + change.y);
    if b1 >= 0.0 && b2 >= 0.0 && b1 + b2 <= 1.0 {
        // Most steps stay in their triangle.
        let b2 = b2.min(1.0 - b1);
        return Step { place: Place { triangle: from.triangle, b1, b2 }, caught: false };
    }
    walk_out(mesh, from, step)
}

fn walk_out(mesh: &Mesh, from: Place, step: Vec2) -> Step {
    let mut triangle = from.triangle as usize;
    let mut b = [1.0 - from.b1 - from.b2, from.b1, from.b2];
    let mut rest = step;
    let mut entered = NONE;
    let mut on_rim = false;
    let mut since_rim = 0;
    let mut most_crossings = MAX_CROSSINGS;
    for crossings in 0.. {
        if crossings == MAX_CROSSINGS {
            most_crossings += (CROSSINGS_PER_EDGE * length(step) / mean_edge(mesh)) as usize;
        }
        if crossings == most_crossings {
            break;
        }
        let change = mesh.frames[triangle].barycentric(rest);
        let change = [-(change.x + change.y), change.x, change.y];
        let (exit, time) = first_exit(&b, &change, entered);
        if exit == NONE {
            return Step { place: place(triangle, &b, &change), caught: false };
        }
        let (next, last) = ((exit + 1) % 3, (exit + 2) % 3);
        let along = (b[last] + time * change[last]).clamp(0.0, 1.0);
        b[exit] = 0.0;
        b[next] = 1.0 - along;
        b[last] = along;
        rest *= 1.0 - time;
        let twin = mesh.twins[3 * triangle + exit];
        if twin == NO_TWIN {
            if on_rim && time == 0.0 {
                // A corner of the rim: whichever edge it follows, the step leads out.
                break;
            }
            let corners = mesh.frames[triangle].corners();
            let edge = normalized(corners[last] - corners[next]);
            rest = edge * rest.dot(edge);
            entered = exit;
            on_rim = true;
            since_rim = 0;
            continue;
        }
        let turn = mesh.turns[3 * triangle + exit];
        rest = Vec2::new(turn.x * rest.x - turn.y * rest.y, turn.y * rest.x + turn.x * rest.y);
        triangle = twin as usize / 3;
        entered = twin as usize % 3;
        on_rim = false;
        since_rim += 1;
        b[entered] = 0.0;
        b[(entered + 1) % 3] = along;
        b[(entered + 2) % 3] = 1.0 - along;
    }
    Step { place: place(triangle, &b, &[0.0; 3]), caught: since_rim > EDGES_AT_A_CORNER }
}

/// The edge of a square of two triangles of mean area, in centimetres.
fn mean_edge(mesh: &Mesh) -> f32 {
    (2.0 * mesh.area / mesh.triangles.len() as f32).sqrt()
}

/// The edge through which the walk leaves its triangle first and when, with 1 the end of the step;
/// never the edge just entered; of equal times the lowest index.
fn first_exit(b: &[f32; 3], change: &[f32; 3], entered: usize) -> (usize, f32) {
    let mut first = (NONE, 1.0);
    for k in 0..3 {
        if k != entered && b[k] + change[k] < 0.0 {
            let time = b[k] / -change[k];
            if time < first.1 {
                first = (k, time);
            }
        }
    }
    first
}

/// Rounding may leave a coordinate a hair below 0: it is put back on the edge.
fn place(triangle: usize, b: &[f32; 3], change: &[f32; 3]) -> Place {
    let b1 = (b[1] + change[1]).clamp(0.0, 1.0);
    let b2 = limited(b[2] + change[2], 0.0, 1.0 - b1);
    Place { triangle: triangle as u32, b1, b2 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_edges_that_are_reached_at_the_same_time_the_first_counts() {
        let (b, change) = ([0.25, 0.25, 0.5], [-0.5, -0.5, 1.0]);
        assert_eq!(first_exit(&b, &change, NONE), (0, 0.5));
        assert_eq!(first_exit(&b, &change, 0), (1, 0.5), "never the one just entered");
        assert_eq!(first_exit(&b, &[0.0; 3], NONE), (NONE, 1.0));
    }

    #[test]
    fn what_lies_a_hair_outside_is_put_back_on_the_edge() {
        let put = |b: [f32; 3], change: [f32; 3]| place(7, &b, &change);
        let on_edge = |b1, b2| Place { triangle: 7, b1, b2 };
        assert_eq!(put([0.25, 0.5, 0.25], [-0.375, 0.25, 0.125]), on_edge(0.75, 0.25));
        assert_eq!(put([0.5, 0.25, 0.25], [0.25, -0.375, 0.125]), on_edge(0.0, 0.375));
        assert_eq!(put([0.5, 0.25, 0.25], [0.25, 0.125, -0.375]), on_edge(0.375, 0.0));
    }
}
