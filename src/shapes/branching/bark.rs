//! The surface of a tree: a tube for each branch.

use super::skeleton::skeleton;
use super::{Tree, TreeNumbers};
use crate::shapes::tube::tube;
use crate::surface::{Group, PolygonMesh};

/// How thin a branch becomes towards its last node, as a share of its own width.
const TIP: f64 = 0.6;

/// Orders of twigs, which have fewer sides.
const TWIGS: u32 = 2;

/// The branches of a tree as tapered tubes, in groups by their orders, the highest first. A branch goes
/// through all nodes of its order, one after the other; its foot lies in the branch that it leaves.
pub fn bark(tree: &Tree, numbers: &TreeNumbers) -> PolygonMesh {
    tubes(tree, numbers, "bark", &|_| false)
}

/// The same without the twigs of some nodes, and bare.
pub fn wood(
    tree: &Tree,
    numbers: &TreeNumbers,
    is_left_out: &dyn Fn(usize) -> bool,
) -> PolygonMesh {
    tubes(tree, numbers, "bare:bark", is_left_out)
}

fn tubes(
    tree: &Tree,
    numbers: &TreeNumbers,
    material: &str,
    is_left_out: &dyn Fn(usize) -> bool,
) -> PolygonMesh {
    let limbs = skeleton(tree, numbers);
    let mut starts = vec![0];
    for node in &tree.nodes {
        let Some([first, second]) = node.children else { continue };
        if tree.nodes[first as usize].order != node.order {
            starts.push(first);
        }
        starts.push(second);
    }
    starts.retain(|&start| !is_left_out(start as usize));
    let mut mesh = PolygonMesh::default();
    for order in (1..=tree.nodes[0].order).rev() {
        let part = format!("order {order}");
        mesh.groups.push(Group { part, material: material.into() });
        let twig_sides = (numbers.sides * 2).div_ceil(3).max(3);
        let sides = if order > TWIGS { numbers.sides } else { twig_sides };
        for &start in starts.iter().filter(|&&node| tree.nodes[node as usize].order == order) {
            let mut path = vec![(limbs[start as usize].from, limbs[start as usize].width_cm / 2.0)];
            let mut at = start as usize;
            loop {
                let next = tree.nodes[at].children.map(|pair| pair[0] as usize);
                match next.filter(|&next| tree.nodes[next].order == order) {
                    Some(next) => {
                        path.push((limbs[at].to, limbs[next].width_cm / 2.0));
                        at = next;
                    }
                    None => {
                        path.push((limbs[at].to, limbs[at].width_cm / 2.0 * TIP));
                        break;
                    }
                }
            }
            tube(&mut mesh, sides, &path);
        }
    }
    mesh
}
