//! Closed venation: a source pulls all nodes of which none is in the other's way, and where several of them
//! have reached it they meet and close a loop.

use super::{Network, VeinNumbers};
use glam::DVec2;

/// Pulls are summed in whole parts of a unit vector, so that their order makes no difference: what is a mirror
/// image grows as one.
const PARTS: f64 = (1u64 << 40) as f64;

struct Source {
    at: DVec2,
    /// The nodes that it pulls, or that have reached it: its relative neighbours.
    near: Vec<u32>,
}

/// Grows veins from the roots of a network to all sources, and joins those that meet.
pub(super) fn grow(network: &mut Network, sources: &[DVec2], numbers: &VeinNumbers) {
    let step = numbers.step * numbers.spacing_cm;
    let reach = numbers.reach * numbers.spacing_cm;
    let mut sources: Vec<Source> =
        sources.iter().map(|&at| Source { at, near: Vec::new() }).collect();
    let mut first_new = 0;
    let mut last_child: Vec<Option<DVec2>> = Vec::new();
    while !sources.is_empty() && !network.nodes.is_empty() {
        sources.iter_mut().for_each(|source| source.notice(&network.nodes, first_new));
        first_new = network.nodes.len();
        last_child.resize(first_new, None);
        let mut pulls = vec![[0i64; 2]; first_new];
        let arrived = |source: &Source, node: u32| {
            network.nodes[node as usize].distance_squared(source.at) <= reach * reach
        };
        for source in &sources {
            for &node in source.near.iter().filter(|&&node| !arrived(source, node)) {
                let way = source.at - network.nodes[node as usize];
                let unit = way / way.length_squared().sqrt() * PARTS;
                let pull = &mut pulls[node as usize];
                *pull = [pull[0] + unit.x.round() as i64, pull[1] + unit.y.round() as i64];
            }
        }
        let mut children = Vec::new();
        let mut moves = vec![false; first_new];
        for (node, pull) in pulls.iter().enumerate().filter(|(_, pull)| **pull != [0; 2]) {
            let pull = DVec2::new(pull[0] as f64, pull[1] as f64);
            let child = network.nodes[node] + pull * (step / pull.length_squared().sqrt());
            // Where the last child was, another one would be of no use.
            let is_there = |last: DVec2| last.distance_squared(child) < 1e-12 * step * step;
            if !last_child[node].is_some_and(is_there) {
                last_child[node] = Some(child);
                moves[node] = true;
                children.push((node as u32, child));
            }
        }
        // Reached by all, or by all but those that cannot come nearer.
        let is_done = |source: &Source| {
            source.near.iter().all(|&node| arrived(source, node) || !moves[node as usize])
        };
        let mut meetings = Vec::new();
        sources.retain(|source| {
            let done = is_done(source);
            let ends: Vec<u32> =
                source.near.iter().copied().filter(|&node| arrived(source, node)).collect();
            if done && ends.len() > 1 {
                meetings.push((source.at, ends));
            }
            !done
        });
        for (node, child) in children {
            network.nodes.push(child);
            network.parents.push(node);
        }
        for (at, ends) in meetings {
            let meeting = network.nodes.len() as u32;
            network.nodes.push(at);
            network.parents.push(ends[0]);
            network.joins.extend(ends[1..].iter().map(|&end| [end, meeting]));
        }
        network.steps += 1;
    }
}

impl Source {
    /// Learns of nodes that are new: of its neighbours those stay, and of the new ones those come, that no node
    /// is in the way of. What is in the way of a node once is so for ever.
    fn notice(&mut self, nodes: &[DVec2], first_new: usize) {
        let at = self.at;
        let is_in_the_way = |u: DVec2, v: DVec2| {
            let square = v.distance_squared(at);
            u.distance_squared(at) < square && u.distance_squared(v) < square
        };
        let new = &nodes[first_new..];
        self.near.retain(|&v| !new.iter().any(|&u| is_in_the_way(u, nodes[v as usize])));
        let squares = new.iter().map(|node| node.distance_squared(at));
        let mut from_near: Vec<(f64, u32)> = squares.zip(first_new as u32..).collect();
        from_near.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        for (_, number) in from_near {
            let v = nodes[number as usize];
            // Of the neighbours so far, which are nearer, most likely one is in the way.
            let free = !self.near.iter().any(|&u| is_in_the_way(nodes[u as usize], v))
                && !nodes.iter().rev().any(|&u| is_in_the_way(u, v));
            if free {
                self.near.push(number);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::chance::{Purpose, either_way, part_key, root_key};

    #[test]
    fn neighbours_are_those_whose_lune_is_empty() {
        let place = |k| {
            let key = part_key(root_key(5), k);
            DVec2::new(either_way(key, Purpose::Side), either_way(key, Purpose::Turn))
        };
        let nodes: Vec<DVec2> = (0..300).map(place).collect();
        let mut most = 0;
        for k in 300..360 {
            let mut source = Source { at: place(k), near: Vec::new() };
            // In pieces, as they grow.
            let mut seen = 0;
            for upto in [1, 7, 8, 60, 61, 150, 300] {
                source.notice(&nodes[..upto], seen);
                seen = upto;
                let lune_is_empty = |v: &DVec2| {
                    let between = |u: &DVec2| u.distance(source.at).max(u.distance(*v));
                    !nodes[..upto].iter().any(|u| between(u) < v.distance(source.at) - 1e-12)
                };
                let mut near = source.near.clone();
                near.sort_unstable();
                let all = (0..upto as u32).filter(|&v| lune_is_empty(&nodes[v as usize]));
                assert_eq!(near, all.collect::<Vec<_>>());
            }
            most = most.max(source.near.len());
        }
        assert!((3..=6).contains(&most), "{most}");
    }
}
