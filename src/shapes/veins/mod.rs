//! Fine veins on a finished blade: they grow towards sources of a growth hormone until each source is reached
//! (Runions, Fuhrer, Lane, Federl, Rolland-Lagan, Prusinkiewicz, *Modeling and Visualization of Leaf Venation
//! Patterns*, SIGGRAPH 2005), all sources at once and without growth of the blade. Open veins branch and end;
//! closed ones meet, too, and make loops.

mod closed;
mod open;
mod sources;
#[cfg(test)]
mod tests;

pub use sources::scatter;

use super::ShapeError;
use super::wrong::within;
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// Fine veins in numbers. What is left out of a file is as in `VeinNumbers::default`.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct VeinNumbers {
    /// Sources are at least so far apart; 0.005 to 10.
    pub spacing_cm: f64,
    /// A vein grows so far in a step, as a share of the spacing; 0.05 to 1.
    pub step: f64,
    /// A vein that comes so near reaches a source, as a share of the spacing: at least the step, at most 2.
    pub reach: f64,
    /// Width of an end.
    pub tip_cm: f64,
    /// Widths raised to this sum up from the ends to the root (Murray: 3; 2 keeps areas); 1 to 5.
    pub exponent: f64,
    /// Whether veins that come to a source from several sides meet there.
    pub closed: bool,
}

/// Nodes of veins, each behind its parent.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Network {
    pub nodes: Vec<DVec2>,
    /// Of each node; roots, the first ones, have themselves.
    pub parents: Vec<u32>,
    /// Pairs of nodes that are joined beside, one for each loop; roots count as joined to each other.
    pub joins: Vec<[u32; 2]>,
    /// Of the vein between a node and its parent. What is beside is as wide as an end.
    pub width_cm: Vec<f64>,
    pub steps: u32,
}

impl Default for VeinNumbers {
    fn default() -> VeinNumbers {
        VeinNumbers {
            spacing_cm: 0.2,
            step: 1.0 / 3.0,
            reach: 2.0 / 3.0,
            tip_cm: 0.008,
            exponent: 3.0,
            closed: false,
        }
    }
}

impl VeinNumbers {
    /// Says which number is out of its range.
    pub fn check(&self) -> Result<(), ShapeError> {
        within("spacing_cm", self.spacing_cm, &(0.005..=10.0))?;
        within("step", self.step, &(0.05..=1.0))?;
        within("reach", self.reach, &(self.step..=2.0))?;
        within("tip_cm", self.tip_cm, &(0.0001..=1.0))?;
        within("exponent", self.exponent, &(1.0..=5.0))
    }
}

/// Grows veins from their roots to all sources. A source between veins that pull apart evenly may never be
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
    let mut network = Network {
        nodes: roots.to_vec(),
        parents: (0..roots.len() as u32).collect(),
        ..Network::default()
    };
    match numbers.closed {
        true => closed::grow(&mut network, sources, numbers),
        false => open::grow(&mut network, sources, numbers),
    }
    network.width_cm = widths(&network, numbers);
    Ok(network)
}

impl Network {
    /// Each piece of a vein from node to node, and its width in centimetres.
    pub fn pieces(&self) -> impl Iterator<Item = ([DVec2; 2], f64)> {
        let tip_cm = self.width_cm.iter().copied().fold(f64::INFINITY, f64::min);
        let of_parents = (0..).zip(&self.parents).zip(&self.width_cm);
        let of_parents = of_parents.map(|((node, &parent), &width)| ([parent, node], width));
        let all = of_parents.chain(self.joins.iter().map(move |&ends| (ends, tip_cm)));
        let all = all.filter(|([from, to], _)| from != to);
        all.map(|(ends, width)| (ends.map(|node| self.nodes[node as usize]), width))
    }

    /// The same as lines, each from an end to where it meets another one or a root.
    pub fn paths(&self) -> Vec<Vec<DVec2>> {
        let mut is_laid = vec![false; self.nodes.len()];
        let mut paths = Vec::new();
        for end in (0..self.nodes.len() as u32).rev() {
            let (mut at, mut path) = (end as usize, Vec::new());
            while !is_laid[at] && self.parents[at] as usize != at {
                is_laid[at] = true;
                path.push(self.nodes[at]);
                at = self.parents[at] as usize;
            }
            if !path.is_empty() {
                path.push(self.nodes[at]);
                paths.push(path);
            }
        }
        let joins =
            self.joins.iter().map(|ends| ends.map(|node| self.nodes[node as usize]).to_vec());
        paths.extend(joins);
        paths
    }

    /// All pieces together, in centimetres.
    pub fn length_cm(&self) -> f64 {
        self.pieces().map(|([from, to], _)| from.distance(to)).sum::<f64>() + 0.0
    }
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
