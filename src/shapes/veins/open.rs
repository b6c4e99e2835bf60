//! Open venation: each source pulls the node that is nearest to it, and is gone when a vein comes near.

use super::VeinNumbers;
use crate::shapes::ShapeError;
use glam::DVec2;

/// Nodes of veins, each behind its parent.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Network {
    pub nodes: Vec<DVec2>,
    /// Of each node; roots, the first ones, have themselves.
    pub parents: Vec<u32>,
    /// Of the vein between a node and its parent.
    pub width_cm: Vec<f64>,
    pub steps: u32,
}

/// A source that no vein has reached.
struct Source {
    at: DVec2,
    nearest: u32,
    square: f64,
}

/// Grows veins from their roots to all sources. A source between two veins that pull apart evenly may never be
/// reached; it is given up, instead of growing the same piece again and again.
///
/// # Errors
/// Numbers out of their range.
pub fn grow(
    roots: &[DVec2],
    sources: &[DVec2],
    numbers: &VeinNumbers,
) -> Result<Network, ShapeError> {
    numbers.check()?;
    let step = numbers.step * numbers.spacing_cm;
    let reach = numbers.reach * numbers.spacing_cm;
    let mut network = Network {
        nodes: roots.to_vec(),
        parents: (0..roots.len() as u32).collect(),
        ..Network::default()
    };
    let far = |&at: &DVec2| Source { at, nearest: 0, square: f64::INFINITY };
    let mut sources: Vec<Source> = sources.iter().map(far).collect();
    notice(&mut sources, &network.nodes, 0, reach);
    let mut pulls: Vec<DVec2> = Vec::new();
    let mut last_child: Vec<DVec2> = Vec::new();
    while !sources.is_empty() && !network.nodes.is_empty() {
        pulls.clear();
        pulls.resize(network.nodes.len(), DVec2::ZERO);
        last_child.resize(network.nodes.len(), DVec2::NAN);
        for source in &sources {
            let way = source.at - network.nodes[source.nearest as usize];
            pulls[source.nearest as usize] += way / way.length();
        }
        let before = network.nodes.len();
        let mut stuck = vec![false; before];
        for node in 0..before {
            // Nobody pulls, or two from either side.
            let Some(direction) = pulls[node].try_normalize() else {
                stuck[node] = true;
                continue;
            };
            let child = network.nodes[node] + direction * step;
            // The same sources pull as before: the last child was of no use to them.
            if last_child[node].distance(child) < 1e-6 * step {
                stuck[node] = true;
                continue;
            }
            last_child[node] = child;
            network.nodes.push(child);
            network.parents.push(node as u32);
        }
        network.steps += 1;
        sources.retain(|source| !stuck[source.nearest as usize]);
        notice(&mut sources, &network.nodes, before, reach);
    }
    network.width_cm = widths(&network, numbers);
    Ok(network)
}

/// Sources learn of nodes that are new, which can only be nearer than others, and go where one is within reach.
fn notice(sources: &mut Vec<Source>, nodes: &[DVec2], first_new: usize, reach: f64) {
    for source in sources.iter_mut() {
        for (k, node) in nodes.iter().enumerate().skip(first_new) {
            let square = node.distance_squared(source.at);
            if square < source.square {
                (source.nearest, source.square) = (k as u32, square);
            }
        }
    }
    sources.retain(|source| source.square > reach * reach);
}

/// Murray's law: as wide as all ends behind a node together.
fn widths(network: &Network, numbers: &VeinNumbers) -> Vec<f64> {
    let mut ends = vec![0.0; network.nodes.len()];
    for node in (0..network.nodes.len()).rev() {
        if ends[node] == 0.0 {
            ends[node] = 1.0;
        }
        let parent = network.parents[node] as usize;
        if parent != node {
            ends[parent] += ends[node];
        }
    }
    ends.into_iter().map(|ends| numbers.tip_cm * libm::pow(ends, 1.0 / numbers.exponent)).collect()
}
