//! A tree with leaves: each end bears one in the place of its twig. Leaves in front have the border of their rule, and
//! those behind are spots of four corners (Viennot et al. 1989, section 6.2: small polygons in the place of leaves).

use super::bark::wood;
use super::skeleton::skeleton;
use super::{Limb, Tree, TreeNumbers};
use crate::shapes::ShapeError;
use crate::shapes::chance::{Purpose, either_way, part_key, uniform};
use crate::shapes::crossing::crosses;
use crate::shapes::leaf::{FlatLeaf, LeafNumbers};
use crate::shapes::tube::{point, tube};
use crate::surface::{Face, Group, PolygonMesh};
use glam::{DQuat, DVec3, Vec2, Vec3};
use std::collections::BTreeMap;

/// Ways to hang that a leaf tries until none of those before is in its way.
const WAYS: u32 = 8;
/// Sides of a petiole.
const SIDES: u32 = 3;

/// The leaves and the wood of a tree, in centimetres. Leaves carry cells, in leaf coordinates, and all else is bare.
///
/// # Errors
/// Numbers of the leaf that are out of their ranges.
pub fn leafy(
    tree: &Tree,
    numbers: &TreeNumbers,
    leaf: &LeafNumbers,
) -> Result<PolygonMesh, ShapeError> {
    let flat = FlatLeaf::new(leaf).map_err(|ShapeError(why)| ShapeError(format!("leaf.{why}")))?;
    let flat = flat.scaled(numbers.leaf_size);
    let petiole_radius_cm = numbers.leaf_size * leaf.petiole_width_cm / 2.0;
    let bears = |node: usize| {
        let at = &tree.nodes[node];
        at.order == 1 && uniform(part_key(at.key, 0), Purpose::Side) < numbers.leaf_ends
    };
    let limbs = skeleton(tree, numbers);
    let ends: Vec<usize> = (0..limbs.len()).filter(|&node| bears(node)).collect();
    let hung = hang(tree, &limbs, &ends, numbers, &flat);
    let spots = behind(&hung, numbers.leaf_spots);
    let mut mesh = PolygonMesh::default();
    for (part, of_spots) in [("leaves", false), ("far leaves", true)] {
        start(&mut mesh, part, "blade");
        let form = if of_spots { &flat.spot } else { &flat.blade };
        for (hung, _) in hung.iter().zip(&spots).filter(|(_, is_spot)| **is_spot == of_spots) {
            let first = mesh.positions.len() as u32;
            mesh.positions.extend(form.places.iter().map(|&p| point(hung.place(p))));
            mesh.uvs.extend(&form.uvs);
            mesh.faces.extend(form.faces.iter().map(|face| Face {
                vertices: face.iter().map(|k| first + k).collect(),
                group: mesh.groups.len() as u32 - 1,
            }));
        }
    }
    if leaf.petiole_cm > 0.0 {
        start(&mut mesh, "petioles", "bare:petiole");
        for hung in &hung {
            let path = flat.petiole.map(|p| (hung.place(p), petiole_radius_cm));
            tube(&mut mesh, SIDES, &path);
        }
    }
    let wood = wood(tree, numbers, &bears);
    let (vertices, groups) = (mesh.positions.len() as u32, mesh.groups.len() as u32);
    mesh.positions.extend(wood.positions);
    mesh.groups.extend(wood.groups);
    mesh.faces.extend(wood.faces.into_iter().map(|face| Face {
        vertices: face.vertices.into_iter().map(|v| v + vertices).collect(),
        group: face.group + groups,
    }));
    mesh.uvs.resize(mesh.positions.len(), Vec2::ZERO);
    Ok(mesh)
}

fn start(mesh: &mut PolygonMesh, part: &str, material: &str) {
    mesh.groups.push(Group { part: part.into(), material: material.into() });
}

/// How a leaf hangs: where the foot of its petiole is, and its directions, as long as it is large.
struct Hung {
    foot: DVec3,
    side: DVec3,
    along: DVec3,
    up: DVec3,
}

impl Hung {
    fn new(limb: &Limb, key: u64, way: u32, hang: f64) -> Hung {
        let key = part_key(key, 1 + way);
        let shaken = |purpose| either_way(key, purpose);
        let out = (limb.to - limb.from).normalize_or(DVec3::Y);
        // The longer it looks for room, the farther it turns away.
        let aside = limb.across * (0.08 * f64::from(way) * shaken(Purpose::Turn));
        let down = DVec3::Y * (hang + 0.2 * shaken(Purpose::Angle));
        let along = (out - down + aside).normalize_or(DVec3::NEG_Y);
        // The upper side looks up and away from the trunk.
        let outward = DVec3::new(limb.from.x, 0.0, limb.from.z).normalize_or(DVec3::Z);
        let side = along.cross(DVec3::Y + outward * 0.7).normalize_or(DVec3::X);
        let roll = (0.3 + 0.08 * f64::from(way)) * shaken(Purpose::Side);
        let side = DQuat::from_axis_angle(along, roll) * side;
        let size = 1.0 + 0.1 * shaken(Purpose::Length);
        let up = side.cross(along);
        Hung { foot: limb.from, side: side * size, along: along * size, up: up * size }
    }

    fn place(&self, p: DVec3) -> DVec3 {
        self.foot + self.side * p.x + self.along * p.y + self.up * p.z
    }
}

/// The spot of a leaf where that hangs, and the box around it.
struct Sheet {
    triangles: [[Vec3; 3]; 2],
    low: Vec3,
    high: Vec3,
}

impl Sheet {
    fn new(triangles: [[Vec3; 3]; 2]) -> Sheet {
        let corners = || triangles.iter().flatten().copied();
        let (low, high) =
            (corners().fold(Vec3::MAX, Vec3::min), corners().fold(Vec3::MIN, Vec3::max));
        Sheet { triangles, low, high }
    }

    fn cuts(&self, other: &Sheet) -> bool {
        let apart = self.low.cmpgt(other.high).any() || other.low.cmpgt(self.high).any();
        let cut = |one: &[Vec3; 3]| {
            other.triangles.iter().any(|other| crosses(one, other) || crosses(other, one))
        };
        !apart && self.triangles.iter().any(cut)
    }
}

/// Hangs a leaf on each end, in the first way that none of those before is in the way of, by its spot.
fn hang(
    tree: &Tree,
    limbs: &[Limb],
    ends: &[usize],
    numbers: &TreeNumbers,
    flat: &FlatLeaf,
) -> Vec<Hung> {
    let reach = flat.reach_cm();
    let cell = |p: DVec3| (p / (2.2 * reach)).floor().to_array().map(|at| at as i32);
    let mut near: BTreeMap<[i32; 3], Vec<Sheet>> = BTreeMap::new();
    let around = |[x, y, z]: [i32; 3]| {
        (-1..=1).flat_map(move |i| {
            (-1..=1).flat_map(move |j| (-1..=1).map(move |k| [x + i, y + j, z + k]))
        })
    };
    let hung_on = |&end: &usize| {
        let limb = &limbs[end];
        let others: Vec<&Sheet> =
            around(cell(limb.from)).filter_map(|at| near.get(&at)).flatten().collect();
        let way = |way| {
            let hung = Hung::new(limb, tree.nodes[end].key, way, numbers.leaf_hang);
            let sheet = Sheet::new(flat.sheet(|p| hung.place(p)));
            (!others.iter().any(|other| sheet.cuts(other)), hung, sheet)
        };
        let (_, hung, sheet) =
            (0..WAYS).map(&way).find(|(is_free, ..)| *is_free).unwrap_or_else(|| way(0));
        near.entry(cell(limb.from)).or_default().push(sheet);
        hung
    };
    ends.iter().map(hung_on).collect()
}

/// Which leaves are among the share that stands farthest behind.
fn behind(hung: &[Hung], share: f64) -> Vec<bool> {
    let mut order: Vec<usize> = (0..hung.len()).collect();
    order.sort_by(|&a, &b| hung[a].foot.z.total_cmp(&hung[b].foot.z).then(a.cmp(&b)));
    let mut is_behind = vec![false; hung.len()];
    let count = (share * hung.len() as f64).round() as usize;
    order.iter().take(count).for_each(|&k| is_behind[k] = true);
    is_behind
}
