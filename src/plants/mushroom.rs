//! Fly agaric: white warts on a red cap (Thesis, Fig. 4.15).

use super::{BodyError, Look, Plant, Skin, View, scatter, spikes};
use crate::surface::{Body, ControlImage, Cylinder, PolygonMesh, Wrap};
use crate::tissue::CellType::Foreground;
use crate::tissue::{Control, Recipe, Use};
use glam::Vec3;

pub const PLANT: Plant = Plant {
    key: "mushroom",
    name: "Fly agaric",
    latin: "Amanita muscaria",
    source: "Thesis, Fig. 4.15",
    colour_names: ["red", "white", ""],
    // The cells live on the caps alone. In the thesis the stem is made of B cells that a texture
    // keeps white; a plain white stem looks the same, and saves a third of the cells.
    recipe: Recipe {
        initial_cells: 6_000,
        // Open in the thesis. With what `warts` adds at the top, a sixth of the cells is white;
        // with a third the warts run into worms.
        initial_probability: [0.9, 0.1, 0.0],
        division_days: [8.0, 8.0, 8.0],
        mutation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        adhesion: [[0.7, 0.0, 0.0], [0.0, 0.9, 0.0], [0.0, 0.0, 0.0]],
        radius_scale: 3.0,
        // Open in the thesis. 0.04 * 3^2 = 0.36 keeps steps small; at 0.01 warts are ragged and run
        // together.
        repulsion: 0.04,
        // Open in the thesis. From 20 on the first cells are spread evenly.
        initial_relaxations: 20,
        // Open in the thesis. Warts are round from 3 on.
        relaxations_per_day: 6,
        days: 20,
        // Individuals have from 26,000 to 27,000 cells.
        max_cells: 60_000,
        ..Recipe::DEFAULT
    },
    first_day: 20,
    look: Look {
        cells: [[0.761, 0.118, 0.102], [0.957, 0.925, 0.847], [0.5, 0.5, 0.2]],
        tinted: &[(Foreground, [0.88, 0.37, 0.08])],
        variation: 0.08,
        border: 0.15,
        gloss: 0.5,
        skin: Skin {
            gloss: [1.0, 0.1, 1.0],
            raised: [0.0, 0.28, 0.0],
            unevenness: 0.015,
            ..Skin::EVEN
        },
        veins: false,
        bare: &[
            ("gills", [0.96, 0.94, 0.88], 0.0),
            ("flesh", [0.74, 0.68, 0.57], 0.0),
            ("stem", [0.93, 0.91, 0.85], 0.1),
            ("ring", [0.95, 0.92, 0.82], 0.05),
            ("moss", [0.24, 0.33, 0.12], 0.0),
            ("shoot", [0.38, 0.5, 0.18], 0.0),
        ],
    },
    view: View { azimuth_deg: 0.0, elevation_deg: 15.0, zoom: 1.08 },
    mesh: mesh_file!("mushroom.obj"),
    body: grow_body,
    controls: Some(|| vec![warts(), orange_rims()]),
    field: None,
    unfolding_days: &[],
};

fn grow_body(obj: &str) -> Result<Body, BodyError> {
    let mut mesh = super::smooth(obj, &|group| {
        match group.part.as_str() {
            // About as many triangles as first cells: finer, and the wide repulsive radius has far
            // more of them to unfold around each cell.
            "cap" => 2,
            "lamellae" | "volva" => 1,
            _ => 2,
        }
    })?;
    grow_moss(&mut mesh);
    Ok(Body::new(&mesh)?)
}

/// Short shoots all over the moss cushion.
fn grow_moss(mesh: &mut PolygonMesh) {
    let shoots = spikes::new_group(mesh, "shoots", "bare:shoot");
    let faces = spikes::take_faces(mesh, "bare:moss");
    for (number, face) in faces.iter().enumerate() {
        let shaken = |purpose| 2.0 * scatter(number as u32, purpose) - 1.0;
        // Each third quad: a closer stand hides the cushion, a wider one looks like grass.
        if number % 3 == 0 {
            let corner = |k: usize| mesh.positions[face.vertices[k] as usize];
            let foot = (corner(0) + corner(2)) * 0.5 - Vec3::Y * 0.1;
            let to_tip = Vec3::new(0.3 * shaken(1), 0.55 + 0.2 * shaken(2), 0.3 * shaken(3));
            spikes::spike(mesh, foot, to_tip, 0.11, shoots);
        }
    }
    mesh.faces.extend(faces);
}

/// Where the veil tore last, at the top of the cap, more of it is left: the higher, the more first
/// cells are white, in a fine random grain.
fn warts() -> Control {
    const WHITE_AT_THE_TOP: f32 = 0.2;
    let cylinder = Cylinder { base: Vec3::Y * 12.5, axis: Vec3::Y, zero: Vec3::X, height: 3.9 };
    let image = ControlImage::paint(256, 128, |turns, height| {
        let grain = scatter((turns * 256.0) as u32 + 256 * (height * 128.0) as u32, 0);
        grain > WHITE_AT_THE_TOP * height
    });
    Control::foreground(Wrap::Cylinder(cylinder), image)
}

/// Red is tinted with orange towards the rims of the caps of `meshes/mushroom.obj`.
pub(super) fn orange_rims() -> Control {
    /// Heights of the rim and of the top of the button and of the grown cap, and of the image.
    const CAPS_CM: [[f32; 2]; 2] = [[4.1, 6.8], [12.4, 16.1]];
    const HEIGHT_CM: f32 = 17.0;
    let cylinder = Cylinder { base: Vec3::ZERO, axis: Vec3::Y, zero: Vec3::X, height: HEIGHT_CM };
    let image = ControlImage::shade(1, 256, &|_, height| {
        let [rim_cm, top_cm] = CAPS_CM[usize::from(height > 0.5)];
        let from_top = ((top_cm - height * HEIGHT_CM) / (top_cm - rim_cm)).clamp(0.0, 1.0);
        from_top * from_top
    });
    Control { wrap: Wrap::Cylinder(cylinder), image, use_as: Use::Colour { of: Foreground } }
}
