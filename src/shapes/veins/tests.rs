//! Veins against exact runs and known densities.

use super::{VeinNumbers, grow, scatter};
use glam::DVec2;

fn square() -> Vec<Vec<DVec2>> {
    vec![[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(DVec2::from).to_vec()]
}

fn numbers(spacing_cm: f64) -> VeinNumbers {
    VeinNumbers { spacing_cm, ..VeinNumbers::default() }
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
        let constant = network.length_cm() * spacing;
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

fn closed(spacing_cm: f64) -> VeinNumbers {
    VeinNumbers { closed: true, ..numbers(spacing_cm) }
}

#[test]
fn a_closed_vein_runs_straight_to_one_source_and_ends_there() {
    for (x, spacing, step, reach) in
        [(0.99, 0.1, 1.0 / 3.0, 2.0 / 3.0), (0.77, 0.05, 0.5, 0.5), (0.31, 0.2, 0.25, 1.0)]
    {
        let numbers = VeinNumbers { step, reach, ..closed(spacing) };
        let network = grow(&[DVec2::ZERO], &[DVec2::new(x, 0.0)], &numbers).unwrap();
        let exact = ((x - reach * spacing) / (step * spacing)).ceil();
        assert_eq!((network.nodes.len(), network.joins.len()), (1 + exact as usize, 0));
        assert!(network.nodes.iter().all(|node| node.y == 0.0));
    }
}

#[test]
fn veins_from_around_a_source_meet_in_it() {
    for count in 2..=5 {
        let root = |k| {
            let angle = std::f64::consts::TAU * f64::from(k) / f64::from(count) + 0.3;
            DVec2::new(libm::cos(angle), libm::sin(angle)) * 0.98
        };
        let roots: Vec<DVec2> = (0..count).map(root).collect();
        let numbers = closed(0.1);
        let network = grow(&roots, &[DVec2::ZERO], &numbers).unwrap();
        // Each comes within reach, and they meet in the source: a loop less than there are veins.
        let run = ((0.98 - numbers.reach * 0.1) / (numbers.step * 0.1)).ceil() as usize;
        assert_eq!(network.nodes.len(), roots.len() * (1 + run) + 1);
        assert_eq!(network.nodes.last(), Some(&DVec2::ZERO));
        assert_eq!(network.joins.len(), roots.len() - 1);
        let whole = roots.len() as f64 * 0.98;
        assert!((network.length_cm() / whole - 1.0).abs() < 1e-12, "{}", network.length_cm());
        // An open vein is nearest to it alone.
        let open = grow(&roots, &[DVec2::ZERO], &VeinNumbers { closed: false, ..numbers }).unwrap();
        assert!(open.joins.is_empty() && open.length_cm() < 0.98);
    }
}

#[test]
fn a_node_that_another_one_is_in_the_way_of_is_not_pulled() {
    // The nearer root is nearer to the farther one than that is to the source.
    let roots = [DVec2::new(1.0, 0.0), DVec2::new(0.8, 0.3)];
    let network = grow(&roots, &[DVec2::ZERO], &closed(0.1)).unwrap();
    assert!(network.parents[2..].iter().all(|&parent| parent != 0) && network.joins.is_empty());
}

#[test]
fn mirrored_sources_have_mirrored_loops() {
    let mut sources = Vec::new();
    for k in 1..=40 {
        let p = DVec2::new(0.03 + 0.071 * f64::from(k * 7 % 11), 0.025 * f64::from(k));
        sources.extend([p, DVec2::new(-p.x, p.y)]);
    }
    let roots: Vec<DVec2> = (0..=10).map(|k| DVec2::new(0.0, 0.1 * f64::from(k))).collect();
    let network = grow(&roots, &sources, &closed(0.08)).unwrap();
    let sides = [1.0, -1.0].map(|sign| {
        let bits = |p: DVec2| [(p.x * sign + 0.0).to_bits(), p.y.to_bits()];
        let mut nodes: Vec<[u64; 2]> = network.nodes.iter().copied().map(bits).collect();
        nodes.sort_unstable();
        let mut joins: Vec<_> = network
            .pieces()
            .map(|(ends, _)| {
                let mut ends = ends.map(bits);
                ends.sort_unstable();
                ends
            })
            .collect();
        joins.sort_unstable();
        (nodes, joins)
    });
    assert!(network.joins.len() > 8, "{} loops", network.joins.len());
    assert_eq!(sides[0], sides[1]);
}

#[test]
fn loops_are_what_joins_more_than_a_tree_does() {
    let sources = scatter(&square(), 0.04, 4);
    let network = grow(&[DVec2::new(0.5, 0.0)], &sources, &closed(0.04)).unwrap();
    // Euler: pieces less nodes and one more for each connected part.
    let mut part: Vec<usize> = (0..network.nodes.len()).collect();
    fn find(part: &mut [usize], mut k: usize) -> usize {
        while part[k] != k {
            part[k] = part[part[k]];
            k = part[k];
        }
        k
    }
    let tree = (0..).zip(&network.parents).skip(1).map(|(node, &parent)| [node, parent]);
    let pieces: Vec<[u32; 2]> = tree.chain(network.joins.iter().copied()).collect();
    for &[a, b] in &pieces {
        let [a, b] = [a, b].map(|k| find(&mut part, k as usize));
        part[a] = b;
    }
    let parts = (0..network.nodes.len()).filter(|&k| part[k] == k).count();
    assert_eq!((parts, pieces.len() + 1 - network.nodes.len()), (1, network.joins.len()));
    let share = network.joins.len() as f64 / sources.len() as f64;
    assert!((0.3..0.6).contains(&share), "{share} loops a source");
    // Pieces are a step long, but for those that meet.
    let step = numbers(0.04).step * 0.04;
    let reach = numbers(0.04).reach * 0.04;
    for ([from, to], _) in network.pieces() {
        let long = from.distance(to);
        assert!((long / step - 1.0).abs() < 1e-9 || long <= reach, "{long}");
    }
    // Lines are the same pieces, each once.
    let lines: Vec<f64> = network
        .paths()
        .iter()
        .flat_map(|path| path.windows(2).map(|ends| ends[0].distance(ends[1])).collect::<Vec<_>>())
        .collect();
    assert_eq!(lines.len(), network.pieces().count());
    assert!((lines.iter().sum::<f64>() / network.length_cm() - 1.0).abs() < 1e-9);
    let root = network.width_cm[0];
    assert!(network.width_cm.iter().all(|&width| width <= root));
}
