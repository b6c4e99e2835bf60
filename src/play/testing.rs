//! Small plants for the tests of this room, so that they need no catalogue and grow in no time.

use crate::plants::{BodyError, Look, MeshFile, Plant, Skin, View};
use crate::surface::{Body, DirectionField, Face, Guide, Mesh, PolygonMesh};
use crate::tissue::Recipe;
use glam::Vec3;

/// Two plants of one square sheet each; the first has M cells and a direction field.
pub const PLANTS: &[Plant] =
    &[plant("leaf", "Leaf", 6, "red", Some(eastwards)), plant("fruit", "Fruit", 4, "", None)];

const fn plant(
    key: &'static str,
    name: &'static str,
    days: u32,
    middle: &'static str,
    field: Option<fn(&Mesh) -> DirectionField>,
) -> Plant {
    Plant {
        key,
        name,
        latin: "Folium quadratum",
        source: "made for tests",
        colour_names: ["yellow", "green", middle],
        recipe: Recipe {
            initial_cells: 100,
            initial_probability: [0.5, 0.5, 0.0],
            division_days: [5.0, 8.0, 10.0],
            mutation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            adhesion: [[0.5, 0.0, 0.0], [0.0, 0.8, 0.0], [0.0, 0.0, 0.0]],
            radius_scale: 1.0,
            repulsion: 0.09,
            initial_relaxations: 3,
            relaxations_per_day: 2,
            days,
            max_cells: 100_000,
            ..Recipe::DEFAULT
        },
        first_day: 3,
        look: Look {
            cells: [[0.9, 0.8, 0.2], [0.1, 0.4, 0.2], [0.5, 0.5, 0.5]],
            tinted: &[],
            variation: 0.1,
            border: 0.3,
            gloss: 0.5,
            skin: Skin::EVEN,
            veins: false,
            bare: &[],
        },
        view: View { azimuth_deg: 0.0, elevation_deg: 20.0, zoom: 1.0 },
        mesh: MeshFile { name: key, text: "" },
        body: sheet,
        controls: None,
        field,
        unfolding_days: &[],
    }
}

/// A square of 4 by 4 centimetres in 32 triangles.
fn sheet(_: &str) -> Result<Body, BodyError> {
    let positions = (0..25).map(|k| Vec3::new((k % 5) as f32, 1.0, -((k / 5) as f32))).collect();
    let corner = |k: u32| (k % 4) + 5 * (k / 4);
    let faces = (0..16)
        .map(corner)
        .map(|v| Face { vertices: vec![v, v + 1, v + 6, v + 5], group: 0 })
        .collect();
    let polygons = PolygonMesh { positions, faces, ..PolygonMesh::default() };
    Ok(Body::new(&polygons)?)
}

fn eastwards(mesh: &Mesh) -> DirectionField {
    let guide = Guide { triangle: 0, direction: Vec3::X };
    DirectionField::new(mesh, &[guide], 1.0).expect("one control vector")
}
