//! Spines and shoots: hundreds of thin spikes that grow at load, since in the mesh files they would
//! outweigh all the rest.

use super::Chance;
use crate::surface::{Face, Group, PolygonMesh};
use glam::Vec3;

/// Spines of an areole: the last one stands out, the others spread around it.
const SPINES: u32 = 6;

/// Raises a cushion with spines on each diamond of the areoles.
pub(super) fn raise_spines(mesh: &mut PolygonMesh) {
    let spines = new_group(mesh, "spines", "bare:spine");
    let diamonds = take_faces(mesh, "bare:areole");
    for (number, diamond) in diamonds.iter().enumerate() {
        let [right, top, left, bottom] =
            [0, 1, 2, 3].map(|k| mesh.positions[diamond.vertices[k] as usize]);
        let (side, along) = ((right - left).normalize(), (top - bottom).normalize());
        let outward = side.cross(along);
        let centre = (right + left) * 0.5;
        pyramid(mesh, &diamond.vertices, centre + outward * 0.28, diamond.group);
        for k in 0..SPINES {
            let item = number as u32 * SPINES + k;
            let spread =
                if k + 1 == SPINES { 0.2 } else { 0.8 + 0.4 * Chance::PLANT.scatter(item, 1) };
            let turns = (k as f32 + 0.4 * Chance::PLANT.scatter(item, 2)) / (SPINES - 1) as f32;
            let angle_rad = turns * std::f32::consts::TAU;
            let across = side * libm::cosf(angle_rad) + along * libm::sinf(angle_rad);
            let direction = (outward + across * spread).normalize();
            let length_cm = 0.9 + 0.7 * Chance::PLANT.scatter(item, 3);
            spike(mesh, centre, direction * length_cm, 0.07, spines);
        }
    }
}

/// Short shoots all over the moss cushion.
pub(super) fn grow_moss(mesh: &mut PolygonMesh) {
    let shoots = new_group(mesh, "shoots", "bare:shoot");
    let faces = take_faces(mesh, "bare:moss");
    for (number, face) in faces.iter().enumerate() {
        let shaken = |purpose| Chance::PLANT.shaken(number as u32, purpose);
        // Each third quad: a closer stand hides the cushion, a wider one looks like grass.
        if number % 3 == 0 {
            let corner = |k: usize| mesh.positions[face.vertices[k] as usize];
            let foot = (corner(0) + corner(2)) * 0.5 - Vec3::Y * 0.1;
            let to_tip = Vec3::new(0.3 * shaken(1), 0.55 + 0.2 * shaken(2), 0.3 * shaken(3));
            spike(mesh, foot, to_tip, 0.11, shoots);
        }
    }
    mesh.faces.extend(faces);
}

/// The number of a new, empty group of this bare material.
fn new_group(mesh: &mut PolygonMesh, part: &str, material: &str) -> u32 {
    mesh.groups.push(Group { part: part.to_string(), material: material.to_string() });
    mesh.groups.len() as u32 - 1
}

/// Takes the faces of a material out of a mesh.
fn take_faces(mesh: &mut PolygonMesh, material: &str) -> Vec<Face> {
    let groups = &mesh.groups;
    let (taken, left) = std::mem::take(&mut mesh.faces)
        .into_iter()
        .partition(|face| groups[face.group as usize].material == material);
    mesh.faces = left;
    taken
}

/// A three-sided spike, open at its foot.
fn spike(mesh: &mut PolygonMesh, foot: Vec3, to_tip: Vec3, radius_cm: f32, group: u32) {
    let (a, b) = to_tip.normalize_or(Vec3::Y).any_orthonormal_pair();
    let first = mesh.positions.len() as u32;
    // The corners of an equilateral triangle.
    for (x, y) in [(1.0, 0.0), (-0.5, 0.866), (-0.5, -0.866)] {
        mesh.positions.push(foot + (a * x + b * y) * radius_cm);
    }
    pyramid(mesh, &[first, first + 1, first + 2], foot + to_tip, group);
}

/// The sides of a pyramid on a base that runs counter-clockwise seen from its top.
fn pyramid(mesh: &mut PolygonMesh, base: &[u32], top: Vec3, group: u32) {
    let apex = mesh.positions.len() as u32;
    mesh.positions.push(top);
    for (k, &corner) in base.iter().enumerate() {
        let vertices = vec![corner, base[(k + 1) % base.len()], apex];
        mesh.faces.push(Face { vertices, group });
    }
}
