//! Spines and shoots: hundreds of thin spikes that grow at load, since in the mesh files they would
//! outweigh all the rest.

use crate::surface::{Face, Group, PolygonMesh};
use glam::Vec3;

/// The number of a new, empty group of this bare material.
pub fn new_group(mesh: &mut PolygonMesh, part: &str, material: &str) -> u32 {
    mesh.groups.push(Group { part: part.to_string(), material: material.to_string() });
    mesh.groups.len() as u32 - 1
}

/// Takes the faces of a material out of a mesh.
pub fn take_faces(mesh: &mut PolygonMesh, material: &str) -> Vec<Face> {
    let groups = &mesh.groups;
    let (taken, left) = std::mem::take(&mut mesh.faces)
        .into_iter()
        .partition(|face| groups[face.group as usize].material == material);
    mesh.faces = left;
    taken
}

/// A three-sided spike, open at its foot.
pub fn spike(mesh: &mut PolygonMesh, foot: Vec3, to_tip: Vec3, radius_cm: f32, group: u32) {
    let (a, b) = to_tip.normalize_or(Vec3::Y).any_orthonormal_pair();
    let first = mesh.positions.len() as u32;
    // The corners of an equilateral triangle.
    for (x, y) in [(1.0, 0.0), (-0.5, 0.866), (-0.5, -0.866)] {
        mesh.positions.push(foot + (a * x + b * y) * radius_cm);
    }
    pyramid(mesh, &[first, first + 1, first + 2], foot + to_tip, group);
}

/// The sides of a pyramid on a base that runs counter-clockwise seen from its top.
pub fn pyramid(mesh: &mut PolygonMesh, base: &[u32], top: Vec3, group: u32) {
    let apex = mesh.positions.len() as u32;
    mesh.positions.push(top);
    for (k, &corner) in base.iter().enumerate() {
        let vertices = vec![corner, base[(k + 1) % base.len()], apex];
        mesh.faces.push(Face { vertices, group });
    }
}
