//! Veins against exact runs and known densities.

use super::{Network, VeinNumbers, grow, scatter};
use glam::DVec2;

fn square() -> Vec<Vec<DVec2>> {
    vec![[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(DVec2::from).to_vec()]
}

fn numbers(spacing_cm: f64) -> VeinNumbers {
    VeinNumbers { spacing_cm, ..VeinNumbers::default() }
}

fn length(network: &Network) -> f64 {
    let parents = network.parents.iter().map(|&parent| network.nodes[parent as usize]);
    network.nodes.iter().zip(parents).map(|(node, parent)| node.distance(parent)).sum()
}

#[test]
fn one_source_is_reached_in_a_straight_run() {
    for (x, spacing, step, reach) in
        [(0.99, 0.1, 1.0 / 3.0, 2.0 / 3.0), (0.77, 0.05, 0.5, 0.5), (0.31, 0.2, 0.25, 1.0)]
    {
        let numbers = VeinNumbers { step, reach, ..numbers(spacing) };
        let network = grow(&[DVec2::ZERO], &[DVec2::new(x, 0.0)], &numbers).unwrap();
        let exact = ((x - reach * spacing) / (step * spacing)).ceil();
        assert_eq!(network.nodes.len(), 1 + exact as usize);
        assert!(network.nodes.iter().all(|node| node.y == 0.0));
        assert!(network.width_cm.iter().all(|&width| width == numbers.tip_cm));
    }
}

#[test]
fn mirrored_sources_have_mirrored_veins() {
    let mut sources = Vec::new();
    for k in 1..=12 {
        let p = DVec2::new(0.05 + 0.07 * f64::from(k % 5), 0.1 * f64::from(k));
        sources.extend([p, DVec2::new(-p.x, p.y)]);
    }
    // From one root in the middle all pairs would pull straight on.
    let roots = [DVec2::new(0.02, 0.0), DVec2::new(-0.02, 0.0)];
    let network = grow(&roots, &sources, &numbers(0.06)).unwrap();
    let mut sides = [1.0, -1.0].map(|sign| {
        let nodes = network.nodes.iter().filter(|node| node.x * sign > 0.0);
        let mut bits: Vec<[u64; 2]> =
            nodes.map(|node| [(node.x * sign).to_bits(), node.y.to_bits()]).collect();
        bits.sort_unstable();
        bits
    });
    sides.iter_mut().for_each(|side| assert!(side.len() > 20));
    assert_eq!(sides[0], sides[1]);
}

#[test]
fn a_node_between_two_sources_is_no_end_without_end() {
    let network =
        grow(&[DVec2::ZERO], &[DVec2::new(1.0, 0.0), DVec2::new(-1.0, 0.0)], &numbers(0.1))
            .unwrap();
    assert_eq!(network.nodes.len(), 1);
    let apart = [DVec2::new(0.3, 1.0), DVec2::new(-0.3, 1.0)];
    let network = grow(&[DVec2::ZERO], &apart, &numbers(0.1)).unwrap();
    assert!(network.nodes.len() < 60, "{} nodes", network.nodes.len());
}

#[test]
fn darts_fill_the_plane_to_the_known_jamming_cover() {
    // Discs of random sequential adsorption cover 0.5471; those at the border reach beyond it.
    for (spacing, individual) in [(0.05, 1), (0.03, 2), (0.02, 3)] {
        let places = scatter(&square(), spacing, individual);
        let side = 1.0 + spacing;
        let full = 0.547069 / (std::f64::consts::FRAC_PI_4 * spacing * spacing);
        let share = places.len() as f64 / full;
        assert!((0.92..side * side * 1.02).contains(&share), "{share} at {spacing}");
        for (k, p) in places.iter().enumerate() {
            assert!(p.min_element() >= 0.0 && p.max_element() <= 1.0);
            assert!(places[k + 1..].iter().all(|q| q.distance(*p) >= spacing));
        }
    }
}

#[test]
fn veins_of_a_square_have_the_known_length_and_reach_nearly_all_sources() {
    for spacing in [0.05, 0.03] {
        let sources = scatter(&square(), spacing, 4);
        let numbers = numbers(spacing);
        let network = grow(&[DVec2::new(0.5, 0.0)], &sources, &numbers).unwrap();
        let constant = length(&network) * spacing;
        assert!((constant - 0.575).abs() < 0.03, "{constant}");
        let steps = f64::from(network.steps) * spacing;
        assert!((2.0..6.0).contains(&steps), "{steps}");
        let reached = |p: &&DVec2| {
            network.nodes.iter().any(|node| node.distance(**p) <= numbers.reach * spacing)
        };
        let share = sources.iter().filter(reached).count() as f64 / sources.len() as f64;
        assert!(share > 0.9, "{share}");
        // A tree, each piece a step long.
        for (node, &parent) in network.parents.iter().enumerate().skip(1) {
            assert!((parent as usize) < node);
            let step = network.nodes[node].distance(network.nodes[parent as usize]);
            assert!((step / (numbers.step * spacing) - 1.0).abs() < 1e-9);
        }
        let mut has_child = vec![false; network.nodes.len()];
        network.parents.iter().skip(1).for_each(|&parent| has_child[parent as usize] = true);
        let tips = has_child.iter().filter(|child| !**child).count() as f64;
        let root = network.width_cm[0] / numbers.tip_cm;
        assert!((root / tips.cbrt() - 1.0).abs() < 1e-12, "{root} of {tips} tips");
        assert!((0.25..0.45).contains(&(tips / sources.len() as f64)), "{tips} tips");
    }
}

#[test]
fn wrong_numbers_are_named() {
    for (wrong, words) in [
        (VeinNumbers { spacing_cm: 0.0, ..numbers(0.1) }, "spacing_cm is 0: it must be from 0.005"),
        (VeinNumbers { step: 0.0, ..numbers(0.1) }, "step is 0"),
        (VeinNumbers { step: 0.9, ..numbers(0.1) }, "it must be from 0.9 to 2"),
        (VeinNumbers { exponent: f64::NAN, ..numbers(0.1) }, "exponent is NaN"),
    ] {
        let told = grow(&[DVec2::ZERO], &[DVec2::ONE], &wrong).unwrap_err().to_string();
        assert!(told.contains(words), "{told}");
    }
}
