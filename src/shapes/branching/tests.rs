//! Drawn trees against the exact laws of their matrices.

use super::{Census, Ramification, Tree, TreeNumbers, bark};
use crate::shapes::leaf::LeafNumbers;
use crate::surface::{Body, PolygonMesh};

/// Standard errors that a mean strays by less often than once in 90,000 times.
const STRAY: f64 = 4.4;

fn named(name: &str) -> Ramification {
    Ramification::named(name).unwrap()
}

/// Mean and variance of the leaves of trees of orders 1, 2, …: of a branch of order k, which has in the mean
/// `(1 - p) / p` side branches, their number geometric, and then forks into two of order k - 1.
fn leaves(matrix: &Ramification, order: u32) -> Vec<[f64; 2]> {
    let mut laws = vec![[1.0, 0.0]];
    for k in 2..=order {
        let row = matrix.row(k);
        let fork = row[k as usize - 1];
        let sides = (1.0 - fork) / fork;
        // Of a side branch: a mixture.
        let (mut mean, mut square) = (0.0, 0.0);
        if fork < 1.0 {
            for (chance, [of_mean, of_variance]) in row.iter().zip(&laws) {
                mean += chance / (1.0 - fork) * of_mean;
                square += chance / (1.0 - fork) * (of_variance + of_mean * of_mean);
            }
        }
        let [of_mean, of_variance] = laws[k as usize - 2];
        laws.push([
            2.0 * of_mean + sides * mean,
            2.0 * of_variance
                + sides * (square - mean * mean)
                + (1.0 - fork) / (fork * fork) * mean * mean,
        ]);
    }
    laws
}

#[test]
fn the_laws_are_those_that_were_worked_out_by_hand() {
    for (name, exact) in [
        ("perfect", [(2.0, 0.0), (4.0, 0.0), (8.0, 0.0), (16.0, 0.0), (32.0, 0.0)]),
        ("uniform", [(3.0, 1.414), (11.0, 6.481), (43.0, 26.72), (171.0, 107.7), (683.0, 431.5)]),
    ] {
        for ([mean, variance], (exact_mean, sd)) in leaves(&named(name), 6)[1..].iter().zip(exact) {
            assert!((mean - exact_mean).abs() < 1e-9, "{name}: {mean}, not {exact_mean}");
            assert!((variance.sqrt() - sd).abs() < 1e-3 * sd.max(1e-9), "{name}: {variance}");
        }
    }
    // One branch of order 4, two of order 3 and four of order 2: 8 leaves, and on each branch 4 leaflets in the
    // mean with a variance of 20.
    let fern = leaves(&named("fern"), 4)[3];
    assert!((fern[0] - 36.0).abs() < 1e-9 && (fern[1] - 140.0).abs() < 1e-9, "{fern:?}");
    let river = leaves(&named("river"), 6)[5];
    assert!((river[0] - 1069.87).abs() < 0.01, "{river:?}");
}

#[test]
fn trees_have_as_many_leaves_as_their_matrix_says() {
    for (name, order, trees) in [
        ("perfect", 5, 20),
        ("uniform", 2, 2000),
        ("uniform", 5, 1500),
        ("fern", 4, 2000),
        ("river", 5, 800),
        ("increasing", 6, 400),
        ("tokunaga:1,2", 5, 800),
    ] {
        let matrix = named(name);
        let [mean, variance] = leaves(&matrix, order)[order as usize - 1];
        let found: Vec<f64> = (0..trees)
            .map(|seed| {
                let tree = Tree::draw(&matrix, order, seed).unwrap();
                tree.check().unwrap();
                Census::new(&tree).leaves as f64
            })
            .collect();
        let n = f64::from(trees);
        let found_mean = found.iter().sum::<f64>() / n;
        let moment = |power| found.iter().map(|x| (x - mean).powi(power)).sum::<f64>() / n;
        let of_mean = (variance / n).sqrt();
        assert!((found_mean - mean).abs() <= STRAY * of_mean, "{name}: {found_mean}, not {mean}");
        // A variance strays by the fourth moment.
        let of_variance = ((moment(4) - moment(2) * moment(2)) / n).sqrt();
        let away = (moment(2) - variance).abs();
        assert!(away <= STRAY * of_variance, "{name}: {}, not {variance}", moment(2));
    }
}

#[test]
fn the_matrix_of_drawn_trees_is_the_one_they_were_drawn_from() {
    let typed =
        Ramification::from_json("[[0.9, 0.1], [0.2, 0.1, 0.7], [0, 0.5, 0.2, 0.3]]").unwrap();
    for (matrix, order) in [(named("uniform"), 5), (named("increasing"), 6), (typed, 4)] {
        let mut census = Census::default();
        (0..300).for_each(|seed| census.add(&Tree::draw(&matrix, order, seed).unwrap()));
        for (k, (found, biorders)) in (2..).zip(census.matrix().iter().zip(&census.biorders)) {
            let nodes = biorders.iter().sum::<u64>() as f64;
            for (found, exact) in found.iter().zip(matrix.row(k)) {
                let error = (exact * (1.0 - exact) / nodes).sqrt();
                assert!((found - exact).abs() <= STRAY * error, "order {k}: {found}, not {exact}");
            }
        }
    }
}

#[test]
fn a_branch_has_a_geometric_number_of_side_branches() {
    let fork = 0.25f64;
    let matrix = Ramification::new(vec![vec![1.0 - fork, fork]]).unwrap();
    let trees = 20_000;
    let mut numbers = [0u32; 8];
    for seed in 0..trees {
        let leaves = Census::new(&Tree::draw(&matrix, 2, seed).unwrap()).leaves as usize;
        if let Some(number) = numbers.get_mut(leaves - 2) {
            *number += 1;
        }
    }
    for (m, number) in (0..).zip(numbers) {
        let chance = (1.0 - fork).powi(m) * fork;
        let error = (chance * (1.0 - chance) / f64::from(trees)).sqrt();
        let away = (f64::from(number) / f64::from(trees) - chance).abs();
        assert!(away <= STRAY * error, "{m} side branches: {number}");
    }
}

#[test]
fn branches_by_order_follow_hortons_law() {
    // Far from the tips N_i / N_(i+1) is R_B = (2 + c + a + sqrt((2 + c + a)^2 - 8 c)) / 2.
    for (name, [a, c], known) in [
        ("tokunaga:1,2", [1.0, 2.0], 4.0),
        ("river", [1.1, 2.5], 4.485),
        ("tokunaga:0,1", [0.0, 1.0], 2.0),
    ] {
        let b: f64 = 2.0 + c + a;
        let ratio = (b + (b * b - 8.0 * c).sqrt()) / 2.0;
        assert!((ratio - known).abs() < 5e-4);
        // Expected branches: N_i = 2 N_(i+1) + the sum of N_j T(j, i), T the ratio to the fork.
        let matrix = named(name);
        let order = matrix.most_order() as usize;
        let mut expected = vec![0.0; order + 1];
        expected[order] = 1.0;
        for i in (1..order).rev() {
            let sides: f64 = (i + 1..=order)
                .map(|j| {
                    let row = matrix.row(j as u32);
                    expected[j] * row[i - 1] / row[j - 1]
                })
                .sum();
            expected[i] = 2.0 * expected[i + 1] + sides;
        }
        let found = expected[1] / expected[2];
        assert!((found / ratio - 1.0).abs() < 0.03, "{name}: {found}, not {ratio}");
        let mut census = Census::default();
        let trees = 400;
        (0..trees).for_each(|seed| census.add(&Tree::draw(&matrix, 3, seed).unwrap()));
        assert_eq!(census.branches[2], u64::from(trees));
        let side = matrix.row(3)[1] / matrix.row(3)[2];
        let mean = census.branches[1] as f64 / f64::from(trees);
        let error = (side * (side + 1.0) / f64::from(trees)).sqrt();
        assert!((mean - 2.0 - side).abs() <= STRAY * error, "{name}: {mean} branches of order 2");
    }
}

/// A small generator for trees of other kinds than ours.
fn next(state: &mut u64) -> u64 {
    *state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
    *state >> 33
}

/// Numbers nodes from the root on.
fn from_the_root(children: &[Option<[usize; 2]>], root: usize) -> Tree {
    let mut order = vec![root];
    let mut sorted = Vec::new();
    let mut at = 0;
    while at < order.len() {
        let pair = children[order[at]];
        sorted.push(pair.map(|_| [order.len() as u32, order.len() as u32 + 1]));
        order.extend(pair.into_iter().flatten());
        at += 1;
    }
    Tree::of_children(&sorted)
}

#[test]
fn the_uniform_matrix_is_that_of_trees_by_remys_algorithm() {
    // Rémy 1985: an edge or the root gets a new node with a new leaf on a random side.
    let mut state = 7;
    let mut census = Census::default();
    for _ in 0..4 {
        let mut children: Vec<Option<[usize; 2]>> = vec![None];
        let mut parent = vec![usize::MAX];
        let mut root = 0;
        for _ in 0..20_000 {
            let at = next(&mut state) as usize % children.len();
            let leaf = children.len();
            let node = leaf + 1;
            let pair = if next(&mut state).is_multiple_of(2) { [at, leaf] } else { [leaf, at] };
            children.extend([None, Some(pair)]);
            parent.extend([node, parent[at]]);
            match parent[at] {
                usize::MAX => root = node,
                above => {
                    children[above] =
                        children[above].map(|pair| pair.map(|k| if k == at { node } else { k }));
                }
            }
            parent[at] = node;
        }
        let tree = from_the_root(&children, root);
        tree.check().unwrap();
        census.add(&tree);
    }
    let matrix = named("uniform");
    for (k, found) in (2..=4).zip(census.matrix()) {
        for (found, exact) in found.iter().zip(matrix.row(k)) {
            assert!((found - exact).abs() < 0.02, "order {k}: {found}, not {exact}");
        }
    }
}

#[test]
fn the_increasing_matrix_is_that_of_trees_whose_leaves_fork_at_random() {
    let mut state = 11;
    let mut census = Census::default();
    for _ in 0..4 {
        let mut children: Vec<Option<[usize; 2]>> = vec![None];
        let mut leaves = vec![0];
        for _ in 0..30_000 {
            let at = next(&mut state) as usize % leaves.len();
            let new = children.len();
            children[leaves[at]] = Some([new, new + 1]);
            children.extend([None, None]);
            leaves[at] = new;
            leaves.push(new + 1);
        }
        census.add(&from_the_root(&children, 0));
    }
    let matrix = named("increasing");
    for (k, found) in (2..=5).zip(census.matrix()) {
        for (found, exact) in found.iter().zip(matrix.row(k)) {
            assert!((found - exact).abs() < 0.02, "order {k}: {found}, not {exact}");
        }
    }
}

#[test]
fn trees_that_cannot_be_drawn_are_refused() {
    let uniform = named("uniform");
    let wrong = |matrix, order| Tree::draw(matrix, order, 1).unwrap_err().to_string();
    assert!(wrong(&uniform, 0).contains("from 1 to 12"));
    assert!(wrong(&uniform, 13).contains("from 1 to 12"));
    assert!(wrong(&uniform, 12).contains("more than 100000 leaves"));
    for name in ["oak", "tokunaga", "tokunaga:", "tokunaga:1", "tokunaga:-1,2", "tokunaga:nan,2"] {
        Ramification::named(name).unwrap_err();
    }
    // The next row would have 75,789 side branches to a fork.
    assert_eq!(named("tokunaga:9,20").most_order(), 4);
}

#[test]
fn a_tree_is_a_surface_of_one_tube_for_each_branch() {
    for (name, order) in [("uniform", 4), ("fern", 1), ("river", 3)] {
        let tree = Tree::draw(&named(name), order, 5).unwrap();
        let numbers = TreeNumbers::default();
        let mesh = bark(&tree, &numbers);
        assert_eq!(PolygonMesh::parse(&mesh.to_obj()).unwrap(), mesh);
        let body = Body::new(&mesh).unwrap();
        body.surface.check().unwrap();
        let branches: u64 = Census::new(&tree).branches.iter().sum();
        assert_eq!(body.surface.part_count() as u64, branches);
    }
}

#[test]
fn leaves_may_be_as_small_and_as_large_as_their_range_says() {
    for petiole_width_cm in [0.02, 2.0] {
        let leaf = LeafNumbers { petiole_width_cm, ..LeafNumbers::default() };
        let blades_cm2 = [0.05, 1.0, 10.0].map(|leaf_size| {
            let leaf = Some(leaf.clone());
            let numbers =
                TreeNumbers { leaf, leaf_size, leaf_spots: 0.0, ..TreeNumbers::default() };
            let tree = Tree::draw(&named("uniform"), 3, 5).unwrap();
            let mesh = PolygonMesh::parse(&super::body(&tree, &numbers).unwrap().to_obj()).unwrap();
            Body::new(&mesh).unwrap().surface.areas.iter().map(|area| f64::from(*area)).sum::<f64>()
        });
        let [small, usual, large] = blades_cm2;
        // Each is a tenth larger or smaller by how it hangs, which is another way where there is less room.
        let as_large = 0.81 / 1.21..1.21 / 0.81;
        assert!(as_large.contains(&(small / usual / 0.0025)), "{blades_cm2:?}");
        assert!(as_large.contains(&(large / usual / 100.0)), "{blades_cm2:?}");
    }
}
