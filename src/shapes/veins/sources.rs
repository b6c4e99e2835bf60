//! Sources: places that keep their distance, thrown like darts.

use crate::shapes::chance::{Purpose, part_key, root_key, uniform};
use glam::DVec2;

/// Misses one after the other until no room is left to be found.
const MISSES: u32 = 6000;

/// Places inside closed outlines (a place is inside where it is within an odd number of them), each at least
/// `spacing` from all others.
pub fn scatter(outlines: &[Vec<DVec2>], spacing: f64, individual: u32) -> Vec<DVec2> {
    let corners = || outlines.iter().flatten().copied();
    let low = corners().fold(DVec2::MAX, DVec2::min);
    let size = corners().fold(DVec2::MIN, DVec2::max) - low;
    let columns = (size.x / spacing) as usize + 1;
    let rows = (size.y / spacing) as usize + 1;
    // In a cell whose side is the spacing there are at most four.
    let mut cells: Vec<Vec<DVec2>> = vec![Vec::new(); columns * rows];
    let mut places = Vec::new();
    let key = root_key(individual);
    let (mut dart, mut misses) = (0, 0);
    while misses < MISSES {
        let key = part_key(key, dart);
        dart += 1;
        let at = DVec2::new(uniform(key, Purpose::Side), uniform(key, Purpose::Turn)) * size;
        let [column, row] = [at.x, at.y].map(|x| (x / spacing) as usize);
        let near = |row: usize| {
            (column.saturating_sub(1)..=(column + 1).min(columns - 1))
                .flat_map(move |column| [row * columns + column])
        };
        let around = (row.saturating_sub(1)..=(row + 1).min(rows - 1)).flat_map(near);
        let square = spacing * spacing;
        let is_free = around
            .flat_map(|cell| &cells[cell])
            .all(|other| other.distance_squared(low + at) >= square);
        if is_free && is_inside(outlines, low + at) {
            cells[row * columns + column].push(low + at);
            places.push(low + at);
            misses = 0;
        } else {
            misses += 1;
        }
    }
    places
}

fn is_inside(outlines: &[Vec<DVec2>], p: DVec2) -> bool {
    let mut inside = false;
    for outline in outlines {
        for (a, b) in outline.iter().zip(outline.iter().cycle().skip(1)) {
            if (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) {
                inside = !inside;
            }
        }
    }
    inside
}
