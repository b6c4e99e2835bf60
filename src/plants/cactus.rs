//! Cactus: yellow blotches on blue-green columns (Thesis, Fig. 4.8).

use super::{Look, Plant, View, scatter};
use crate::surface::{Body, Control, Face, Group, PolygonMesh};
use crate::tissue::Recipe;
use glam::Vec3;

pub const PLANT: Plant = Plant {
    key: "cactus",
    name: "Cactus",
    latin: "Cereus hildmannianus",
    source: "Thesis, Fig. 4.8",
    colour_names: ["yellow", "green", ""],
    recipe: Recipe {
        initial_cells: 5_000,
        initial_probability: [0.002, 0.998, 0.0],
        division_days: [3.0, 60.0, 60.0],
        mutation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        adhesion: [[0.5, 0.0, 0.0], [0.0, 0.9, 0.0], [0.0, 0.0, 0.0]],
        radius_scale: 4.0,
        // Open in the thesis.
        repulsion: 0.02,
        initial_relaxations: 20,
        relaxations_per_day: 10,
        days: 25,
        max_cells: 120_000,
    },
    first_day: 25,
    look: Look {
        cells: [[0.925, 0.824, 0.341], [0.247, 0.478, 0.31], [0.5, 0.5, 0.2]],
        variation: 0.08,
        border: 0.18,
        gloss: 0.3,
        veins: false,
        bare: &[
            ("areole", [0.78, 0.72, 0.6], 0.0),
            ("spine", [0.4, 0.26, 0.14], 0.2),
            ("soil", [0.43, 0.35, 0.27], 0.0),
            ("stone", [0.6, 0.57, 0.52], 0.05),
        ],
    },
    view: View { azimuth_deg: 0.0, elevation_deg: 14.0, zoom: 1.0 },
    body: grow_body,
    controls: no_controls,
};

fn grow_body() -> Body {
    let obj = include_str!("../../meshes/cactus.obj");
    let mut control = PolygonMesh::parse(obj).expect("our own mesh is well formed");
    raise_spines(&mut control);
    super::smooth(&control, |group| match group.material.as_str() {
        "bare:areole" | "bare:spine" => 0,
        _ => 2,
    })
}

fn no_controls() -> Vec<Control> {
    Vec::new()
}

/// Spines of an areole: the last one stands out, the others spread around it.
const SPINES: u32 = 6;

/// Raises a cushion with spines on each diamond of the areoles. They grow here and not in the mesh
/// file because they would be two thirds of it.
fn raise_spines(mesh: &mut PolygonMesh) {
    let is_areole = |group: &Group| group.material == "bare:areole";
    let Some(areoles) = mesh.groups.iter().position(is_areole) else { return };
    let spines = mesh.groups.len() as u16;
    mesh.groups.push(Group { part: "spines".to_string(), material: "bare:spine".to_string() });
    let (diamonds, others): (Vec<Face>, Vec<Face>) =
        std::mem::take(&mut mesh.faces).into_iter().partition(|f| f.group as usize == areoles);
    mesh.faces = others;
    for (number, diamond) in diamonds.iter().enumerate() {
        let corner = |k: usize| mesh.positions[diamond.vertices[k] as usize];
        let (side, along) =
            ((corner(0) - corner(2)).normalize(), (corner(1) - corner(3)).normalize());
        let outward = side.cross(along);
        let centre = (corner(0) + corner(2)) * 0.5;
        pyramid(mesh, &diamond.vertices, centre + outward * 0.28, diamond.group);
        for k in 0..SPINES {
            let item = number as u32 * SPINES + k;
            let spread = if k + 1 == SPINES { 0.2 } else { 0.8 + 0.4 * scatter(item, 1) };
            let turns = (k as f32 + 0.4 * scatter(item, 2)) / (SPINES - 1) as f32;
            let angle_rad = turns * std::f32::consts::TAU;
            let across = side * libm::cosf(angle_rad) + along * libm::sinf(angle_rad);
            let direction = (outward + across * spread).normalize();
            let length_cm = 0.9 + 0.7 * scatter(item, 3);
            spine(mesh, centre, direction * length_cm, spines);
        }
    }
}

/// A three-sided spike.
fn spine(mesh: &mut PolygonMesh, foot: Vec3, to_tip: Vec3, group: u16) {
    const RADIUS_CM: f32 = 0.07;
    let (a, b) = to_tip.normalize().any_orthonormal_pair();
    let first = mesh.positions.len() as u32;
    // The corners of an equilateral triangle.
    for (x, y) in [(1.0, 0.0), (-0.5, 0.866), (-0.5, -0.866)] {
        mesh.positions.push(foot + (a * x + b * y) * RADIUS_CM);
    }
    pyramid(mesh, &[first, first + 1, first + 2], foot + to_tip, group);
}

fn pyramid(mesh: &mut PolygonMesh, base: &[u32], top: Vec3, group: u16) {
    let apex = mesh.positions.len() as u32;
    mesh.positions.push(top);
    for (k, &corner) in base.iter().enumerate() {
        let vertices = vec![corner, base[(k + 1) % base.len()], apex];
        mesh.faces.push(Face { vertices, group });
    }
}
