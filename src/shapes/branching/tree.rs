//! A binary tree drawn from a ramification matrix.

use super::Ramification;
use crate::shapes::ShapeError;
use crate::shapes::chance::{Purpose, part_key, root_key, uniform};

/// Leaves at most: more would take seconds to show.
const MOST_LEAVES: usize = 100_000;

/// A binary tree. Node 0 is the root, and children stand behind their parents.
#[derive(Clone, Debug, PartialEq)]
pub struct Tree {
    pub nodes: Vec<Node>,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Node {
    /// Horton–Strahler: 1 for a leaf; of a node whose children have unlike orders the higher one, of one
    /// whose children have like orders one more.
    pub order: u32,
    /// Two children or none. That of the node's own order comes first; at a fork, the left one.
    pub children: Option<[u32; 2]>,
    /// Whether the first child goes to the left and the second to the right.
    pub first_left: bool,
    /// What all chance of this node is drawn from.
    pub(super) key: u64,
}

impl Tree {
    /// Draws an individual from the root on (Viennot et al. 1989): how a node branches is drawn from the
    /// row of its order, and which child goes left by a coin. The matrix of many such trees is the given one.
    ///
    /// # Errors
    /// An order that has no row in the matrix, and more than 100,000 leaves.
    pub fn draw(matrix: &Ramification, order: u32, seed: u32) -> Result<Tree, ShapeError> {
        let most = matrix.most_order();
        if !(1..=most).contains(&order) {
            return Err(ShapeError(format!(
                "the order is {order}: it must be from 1 to {most}, the last row of the matrix"
            )));
        }
        let leaf = |order, key| Node { order, children: None, first_left: false, key };
        let mut nodes = vec![leaf(order, root_key(seed))];
        let mut at = 0;
        while at < nodes.len() {
            let Node { order, key, .. } = nodes[at];
            if order > 1 {
                let column = matrix.pick(order, uniform(key, Purpose::Biorder));
                let orders = if column < order { [order, column] } else { [order - 1; 2] };
                let first = nodes.len() as u32;
                nodes[at].children = Some([first, first + 1]);
                nodes[at].first_left = column == order || uniform(key, Purpose::Side) < 0.5;
                nodes.extend([0, 1].map(|k| leaf(orders[k as usize], part_key(key, k))));
                if nodes.len() > 2 * MOST_LEAVES - 1 {
                    return Err(ShapeError(format!(
                        "a tree of order {} of this matrix has more than {MOST_LEAVES} leaves: choose \
                         a lower order",
                        nodes[0].order
                    )));
                }
            }
            at += 1;
        }
        Ok(Tree { nodes })
    }

    /// A tree of which it is known which node has which children; orders follow from that.
    ///
    /// `children` stand behind their parents, and every node but the root is the child of one.
    pub fn of_children(children: &[Option<[u32; 2]>]) -> Tree {
        let leaf = Node { order: 1, children: None, first_left: true, key: 0 };
        let mut nodes = vec![leaf; children.len()];
        for (at, pair) in children.iter().enumerate().rev() {
            let Some([a, b]) = *pair else { continue };
            let (i, j) = (nodes[a as usize].order, nodes[b as usize].order);
            nodes[at].order = if i == j { i + 1 } else { i.max(j) };
            nodes[at].children = Some(if j > i { [b, a] } else { [a, b] });
            nodes[at].first_left = j <= i;
        }
        Tree { nodes }
    }

    /// The orders `(k, i)` of a node's children as the source calls its biorder, the higher first.
    pub fn biorder(&self, node: u32) -> Option<(u32, u32)> {
        let pair = self.nodes[node as usize].children?;
        let [first, second] = pair.map(|child| self.nodes[child as usize].order);
        Some((first, second))
    }

    /// Says what is wrong with the tree, if anything: children that stand before their parents or belong to
    /// two, orders that are not those of Horton and Strahler.
    pub fn check(&self) -> Result<(), String> {
        let mut parents = vec![0; self.nodes.len()];
        for (at, node) in self.nodes.iter().enumerate() {
            let Some(pair) = node.children else {
                if node.order != 1 {
                    return Err(format!("leaf {at} has the order {}", node.order));
                }
                continue;
            };
            if pair.iter().any(|&child| child as usize <= at) {
                return Err(format!("children of node {at} do not stand behind it"));
            }
            pair.iter().for_each(|&child| parents[child as usize] += 1);
            let [first, second] = pair.map(|child| self.nodes[child as usize].order);
            let order = if first == second { first + 1 } else { first };
            if second > first || node.order != order {
                return Err(format!("node {at} has the order {}, not {order}", node.order));
            }
        }
        match parents.iter().skip(1).position(|&number| number != 1) {
            Some(k) => Err(format!("node {} has not one parent", k + 1)),
            None if parents[0] > 0 => Err("the root has a parent".into()),
            None => Ok(()),
        }
    }
}
