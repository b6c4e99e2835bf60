//! A tree in space: where its edges are and how thick.

use super::{Tree, TreeNumbers, Width};
use crate::shapes::chance::{Purpose, either_way};
use glam::{DQuat, DVec3};

/// The edge below a node: from the parent, or from the ground, to the node itself. In centimetres, the
/// foot of the trunk in the origin and `y` up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limb {
    pub from: DVec3,
    pub to: DVec3,
    /// At the lower end.
    pub width_cm: f64,
    /// That of its node.
    pub order: u32,
    /// Unit vector across the plane in which the node's children part.
    pub across: DVec3,
}

/// An edge for each node of a tree, in the order of the nodes (Viennot et al. 1989).
pub fn skeleton(tree: &Tree, numbers: &TreeNumbers) -> Vec<Limb> {
    let widths = widths(tree, numbers.width);
    let limb = |from: DVec3, direction: DVec3, across: DVec3, node: usize| {
        let (order, key) = (tree.nodes[node].order, tree.nodes[node].key);
        let spread = 1.0 + numbers.length_spread * either_way(key, Purpose::Length);
        let to = from + direction * (numbers.length.of(order) * spread);
        Limb { from, to, width_cm: widths[node], order, across }
    };
    let mut limbs = vec![limb(DVec3::ZERO, DVec3::Y, DVec3::Z, 0); tree.nodes.len()];
    for (at, node) in tree.nodes.iter().enumerate() {
        let Some(pair) = node.children else { continue };
        let Limb { from, to, across, .. } = limbs[at];
        let along = (to - from).normalize();
        let left = if node.first_left { 1.0 } else { -1.0 };
        let turns = turns_deg(tree, at as u32, numbers);
        for ((child, turn_deg), side) in pair.into_iter().zip(turns).zip([left, -left]) {
            let key = tree.nodes[child as usize].key;
            let turn_deg =
                turn_deg * (1.0 + numbers.angle_spread * either_way(key, Purpose::Angle));
            let direction = turned(along, across, side * turn_deg);
            let direction =
                (direction + DVec3::Y * numbers.rise).try_normalize().unwrap_or(direction);
            let roll_deg =
                numbers.turn_deg * (1.0 + numbers.angle_spread * either_way(key, Purpose::Turn));
            // The plane keeps to the new direction.
            let across = (across - direction * across.dot(direction))
                .try_normalize()
                .unwrap_or_else(|| direction.any_orthonormal_vector());
            let across =
                turned(across, direction, if numbers.turn_deg == 0.0 { 0.0 } else { roll_deg });
            limbs[child as usize] = limb(to, direction, across, child as usize);
        }
    }
    limbs
}

/// How far the two children of a node turn away from each other: at a fork alike, else the branch the more
/// and the side branch the less, the more important the side branch is.
fn turns_deg(tree: &Tree, node: u32, numbers: &TreeNumbers) -> [f64; 2] {
    match tree.biorder(node) {
        Some((k, i)) if k > i => {
            let [k, i] = [k, i].map(f64::from);
            [numbers.main_deg * i / (k - 1.0), numbers.side_deg * (k - i) / (k - 1.0)]
        }
        _ => [numbers.fork_deg; 2],
    }
}

/// A vector turned about a unit vector.
fn turned(vector: DVec3, about: DVec3, angle_deg: f64) -> DVec3 {
    DQuat::from_axis_angle(about, angle_deg.to_radians()) * vector
}

/// Below each node.
fn widths(tree: &Tree, width: Width) -> Vec<f64> {
    let (tip_cm, exponent) = match width {
        Width::ByOrder(law) => return tree.nodes.iter().map(|node| law.of(node.order)).collect(),
        Width::Murray { tip_cm, exponent } => (tip_cm, exponent),
    };
    // In shares of a tip's: sums of whole numbers, whatever the exponent.
    let mut tips = vec![1.0; tree.nodes.len()];
    for (at, node) in tree.nodes.iter().enumerate().rev() {
        if let Some([a, b]) = node.children {
            tips[at] = tips[a as usize] + tips[b as usize];
        }
    }
    tips.into_iter().map(|tips| tip_cm * libm::pow(tips, 1.0 / exponent)).collect()
}

#[cfg(test)]
mod tests {
    use super::super::{Law, Ramification};
    use super::*;

    fn even() -> TreeNumbers {
        TreeNumbers {
            fork_deg: 30.0,
            side_deg: 30.0,
            main_deg: 10.0,
            length: Law::Exponential { first_cm: 2.0, factor: 1.4 },
            angle_spread: 0.0,
            length_spread: 0.0,
            rise: 0.0,
            turn_deg: 0.0,
            ..TreeNumbers::default()
        }
    }

    /// The angles of the children of a node to the edge below it, the higher order first.
    fn angles_deg(tree: &Tree, limbs: &[Limb], node: usize) -> [f64; 2] {
        let way = |limb: &Limb| limb.to - limb.from;
        let below = way(&limbs[node]);
        let pair = tree.nodes[node].children.unwrap();
        pair.map(|child| below.angle_between(way(&limbs[child as usize])).to_degrees())
    }

    #[test]
    fn branches_part_at_the_angles_of_the_source() {
        let matrix = Ramification::named("uniform").unwrap();
        let tree = Tree::draw(&matrix, 6, 3).unwrap();
        for turn_deg in [0.0, 137.5] {
            let limbs = skeleton(&tree, &TreeNumbers { turn_deg, ..even() });
            let mut seen = [0; 3];
            for node in 0..tree.nodes.len() {
                let Some((k, i)) = tree.biorder(node as u32) else { continue };
                // A fork; a side branch nearly as important as the branch; one of order 1.
                let exact = if k == i {
                    seen[0] += 1;
                    [30.0, 30.0]
                } else if i == k - 1 {
                    seen[1] += 1;
                    [10.0, 30.0 / f64::from(k - 1)]
                } else if i == 1 {
                    seen[2] += 1;
                    [10.0 / f64::from(k - 1), 30.0]
                } else {
                    continue;
                };
                let found = angles_deg(&tree, &limbs, node);
                for (found, exact) in found.into_iter().zip(exact) {
                    assert!((found - exact).abs() < 1e-6, "({k}, {i}): {found}, not {exact}");
                }
            }
            assert!(seen.iter().all(|&number| number > 20), "{seen:?}");
        }
    }

    #[test]
    fn a_tree_that_does_not_turn_is_flat_and_two_children_take_two_sides() {
        let tree = Tree::draw(&Ramification::named("river").unwrap(), 4, 1).unwrap();
        let limbs = skeleton(&tree, &even());
        assert!(limbs.iter().all(|limb| limb.to.z == 0.0));
        for (at, node) in tree.nodes.iter().enumerate() {
            let Some(pair) = node.children else { continue };
            let along = limbs[at].to - limbs[at].from;
            let [first, second] = pair.map(|child| {
                let way = limbs[child as usize].to - limbs[child as usize].from;
                along.cross(way).z
            });
            assert!(first * second < 0.0, "node {at}");
            assert_eq!(first > 0.0, node.first_left);
        }
    }

    #[test]
    fn lengths_and_widths_follow_their_laws() {
        let tree = Tree::draw(&Ramification::named("perfect").unwrap(), 6, 1).unwrap();
        // In a perfect tree Murray's law is one of orders.
        let by_order = Law::Exponential { first_cm: 0.2, factor: 2f64.cbrt() };
        let murray = TreeNumbers { width: Width::Murray { tip_cm: 0.2, exponent: 3.0 }, ..even() };
        let alike = TreeNumbers { width: Width::ByOrder(by_order), ..even() };
        for (one, other) in skeleton(&tree, &murray).iter().zip(skeleton(&tree, &alike)) {
            assert!((one.width_cm / other.width_cm - 1.0).abs() < 1e-12);
            let length = 2.0 * 1.4f64.powi(one.order as i32 - 1);
            assert!(((one.to - one.from).length() / length - 1.0).abs() < 1e-12);
        }
        // In any tree the root is as thick as its leaves together.
        let tree = Tree::draw(&Ramification::named("increasing").unwrap(), 5, 2).unwrap();
        let leaves = tree.nodes.len().div_ceil(2) as f64;
        let trunk = skeleton(&tree, &murray)[0].width_cm;
        assert!((trunk / (0.2 * leaves.cbrt()) - 1.0).abs() < 1e-12);
        assert_eq!(Law::Linear { first_cm: 2.0, more_cm: 0.5 }.of(4), 3.5);
        assert_eq!(Law::Power { first_cm: 2.0, exponent: 2.0 }.of(3), 18.0);
    }
}
