//! Open venation: each source pulls the node that is nearest to it, and is gone when a vein comes near.

use super::{Network, VeinNumbers};
use glam::DVec2;
use std::collections::BTreeMap;

/// Sources stand in cells of so many spacings, so that most nodes are looked at for a whole cell at once.
const CELL: f64 = 4.0;

struct Source {
    at: DVec2,
    nearest: u32,
    /// Of the distance to that node.
    square: f64,
    /// Whether it has been reached, or given up.
    is_gone: bool,
}

struct Sources {
    all: Vec<Source>,
    cells: Vec<Cell>,
}

/// Sources close to each other.
struct Cell {
    low: DVec2,
    high: DVec2,
    members: Vec<u32>,
}

/// Grows veins from the roots of a network to all sources.
pub(super) fn grow(network: &mut Network, sources: &[DVec2], numbers: &VeinNumbers) {
    let step = numbers.step * numbers.spacing_cm;
    let reach = numbers.reach * numbers.spacing_cm;
    let roots = network.nodes.len();
    let mut sources = Sources::new(sources, CELL * numbers.spacing_cm);
    sources.notice(&network.nodes, 0, reach);
    let mut pulls: Vec<DVec2> = Vec::new();
    let mut last_child: Vec<DVec2> = Vec::new();
    while sources.all.iter().any(|source| !source.is_gone) && roots > 0 {
        pulls.clear();
        pulls.resize(network.nodes.len(), DVec2::ZERO);
        last_child.resize(network.nodes.len(), DVec2::NAN);
        for source in sources.all.iter().filter(|source| !source.is_gone) {
            let way = source.at - network.nodes[source.nearest as usize];
            pulls[source.nearest as usize] += way / way.length_squared().sqrt();
        }
        let before = network.nodes.len();
        let mut stuck = vec![false; before];
        for node in 0..before {
            // Nobody pulls, or two from either side.
            let pull = pulls[node].length_squared().sqrt();
            if pull == 0.0 {
                stuck[node] = true;
                continue;
            }
            let child = network.nodes[node] + pulls[node] * (step / pull);
            // The same sources pull as before: the last child was of no use to them.
            if last_child[node].distance_squared(child) < 1e-12 * step * step {
                stuck[node] = true;
                continue;
            }
            last_child[node] = child;
            network.nodes.push(child);
            network.parents.push(node as u32);
        }
        network.steps += 1;
        for source in &mut sources.all {
            source.is_gone |= stuck[source.nearest as usize];
        }
        sources.notice(&network.nodes, before, reach);
    }
}

impl Sources {
    fn new(places: &[DVec2], side: f64) -> Sources {
        let cell = |p: DVec2| [(p.x / side).floor() as i64, (p.y / side).floor() as i64];
        let mut members: BTreeMap<[i64; 2], Vec<u32>> = BTreeMap::new();
        for (k, &p) in (0..).zip(places) {
            members.entry(cell(p)).or_default().push(k);
        }
        let cells = members.into_values().map(|members| {
            let places = || members.iter().map(|&k| places[k as usize]);
            let low = places().fold(DVec2::MAX, DVec2::min);
            let high = places().fold(DVec2::MIN, DVec2::max);
            Cell { low, high, members }
        });
        let far = |&at: &DVec2| Source { at, nearest: 0, square: f64::INFINITY, is_gone: false };
        Sources { cells: cells.collect(), all: places.iter().map(far).collect() }
    }

    /// Sources learn of nodes that are new, which can only be nearer than others, and go where one is within
    /// reach.
    fn notice(&mut self, nodes: &[DVec2], first_new: usize, reach: f64) {
        for cell in &mut self.cells {
            cell.members.retain(|&k| !self.all[k as usize].is_gone);
            let squares = cell.members.iter().map(|&k| self.all[k as usize].square);
            let farthest = squares.fold(0.0, f64::max);
            for (number, &node) in (first_new as u32..).zip(&nodes[first_new..]) {
                if node.distance_squared(node.clamp(cell.low, cell.high)) >= farthest {
                    continue;
                }
                for &k in &cell.members {
                    let source = &mut self.all[k as usize];
                    let square = node.distance_squared(source.at);
                    if square < source.square {
                        (source.nearest, source.square) = (number, square);
                    }
                }
            }
            for &k in &cell.members {
                let source = &mut self.all[k as usize];
                source.is_gone = source.square <= reach * reach;
            }
        }
    }
}
