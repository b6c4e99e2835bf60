//! What there is in a tree, by order.

use super::Tree;

/// Numbers of a tree, or of many.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Census {
    pub leaves: u64,
    /// Branches of orders 1, 2, …: runs of nodes of one order, each the child of the one before.
    pub branches: Vec<u64>,
    /// For orders 2, 3, … the nodes whose side branch has order 1, 2, …, and, the last, those that fork.
    pub biorders: Vec<Vec<u64>>,
}

impl Census {
    pub fn new(tree: &Tree) -> Census {
        let mut census = Census::default();
        census.add(tree);
        census
    }

    /// Counts another tree.
    pub fn add(&mut self, tree: &Tree) {
        let order = tree.nodes[0].order as usize;
        self.branches.resize(self.branches.len().max(order), 0);
        for k in self.biorders.len() + 2..=order {
            self.biorders.push(vec![0; k]);
        }
        self.branches[order - 1] += 1;
        for (at, node) in (0..).zip(&tree.nodes) {
            let Some((first, second)) = tree.biorder(at) else {
                self.leaves += 1;
                continue;
            };
            let row = &mut self.biorders[node.order as usize - 2];
            if first == second {
                self.branches[first as usize - 1] += 2;
                row[node.order as usize - 1] += 1;
            } else {
                self.branches[second as usize - 1] += 1;
                row[second as usize - 1] += 1;
            }
        }
    }

    /// The ramification matrix as it was found: `r(k, i) = b(k, i) / a_k` of `b` nodes with that biorder among
    /// `a` nodes of order k (Viennot et al. 1989).
    pub fn matrix(&self) -> Vec<Vec<f64>> {
        let share = |row: &Vec<u64>| {
            let all = row.iter().sum::<u64>() as f64;
            row.iter().map(|&number| number as f64 / all).collect()
        };
        self.biorders.iter().map(share).collect()
    }
}
