//! Philodendron: a lime blaze along the midrib that spreads to the rim in feathered strokes
//! (Thesis, Fig. 4.12).

use super::{BodyError, Look, Plant, Skin, View, rough, scatter};
use crate::surface::{Body, ControlImage, DirectionField, Group, Guide, Mesh, Wrap};
use crate::tissue::{Control, Recipe};
use glam::{Vec2, Vec3};

pub const PLANT: Plant = Plant {
    key: "philodendron",
    name: "Philodendron",
    latin: "Philodendron hederaceum",
    source: "Thesis, Fig. 4.12",
    colour_names: ["lime", "green", ""],
    recipe: Recipe {
        initial_cells: 10_000,
        // Open in the thesis. Within the blaze of the control image; one green cell in twenty gives
        // it green flecks, with one in five it is more fleck than blaze.
        initial_probability: [0.95, 0.05, 0.0],
        division_days: [30.0, 120.0, 120.0],
        adhesion: [[0.5, 0.0, 0.0], [0.0, 0.7, 0.0], [0.0, 0.0, 0.0]],
        radius_scale: 2.0,
        // Open in the thesis. 0.09 * 2^2 = 0.36 keeps steps small.
        repulsion: 0.09,
        // Open in the thesis. Up to a half, a cell that is pushed back goes back, and clones run
        // together in rings and worms as without a field; over it none goes back and they are drawn
        // out in strokes; from 0.65 on the cells leave the midrib bare and crowd at the rim.
        anisotropy: 0.6,
        // Open in the thesis. From 20 on the first cells are spread evenly.
        initial_relaxations: 20,
        // Open in the thesis. With 1 there are flecks and no strokes yet, with 6 the midrib is bare.
        relaxations_per_day: 3,
        days: 32,
        // Individuals have about 12,000 cells.
        max_cells: 40_000,
        ..Recipe::DEFAULT
    },
    first_day: 30,
    look: Look {
        cells: [[0.76, 0.83, 0.29], [0.15, 0.385, 0.19], [0.5, 0.5, 0.2]],
        tinted: &[],
        variation: 0.1,
        border: 0.15,
        gloss: 0.45,
        skin: Skin::LEAF,
        veins: true,
        bare: &[
            ("petiole", [0.5, 0.56, 0.24], 0.3),
            ("stem", [0.4, 0.46, 0.22], 0.3),
            ("pot", [0.86, 0.84, 0.8], 0.25),
            ("soil", [0.2, 0.15, 0.11], 0.0),
        ],
    },
    view: View { azimuth_deg: 0.0, elevation_deg: 12.0, zoom: 0.98 },
    mesh: mesh_file!("philodendron.obj"),
    body: grow_body,
    controls: Some(blaze),
    field: Some(side_veins),
    unfolding_days: &[],
};

fn grow_body(obj: &str) -> Result<Body, BodyError> {
    let levels = |group: &Group| if group.material == "bare:soil" { 1 } else { 2 };
    Ok(Body::new(&super::smooth(obj, &levels)?)?)
}

/// How far a side vein goes along the leaf on its way from midrib to rim.
const LEAN: f32 = 0.2;

/// Lime along the middle, fading out towards the rim in a fine random grain, sooner along one side
/// vein and later along another.
fn blaze() -> Vec<Control> {
    /// From the midrib, 0, to the rim, 1: up to where all first cells may be lime, and from where
    /// none, give or take some.
    const ALL: f32 = 0.1;
    const NONE: f32 = 0.7;
    const UNEVEN: f32 = 0.3;
    /// Strokes that could be told apart along the midrib.
    const STROKES: f32 = 30.0;
    /// Up to here along the midrib the blaze grows broader: in the notch the rim is near.
    const BROAD: f32 = 0.2;
    let image = ControlImage::paint(256, 256, |turns, along| {
        let across = (2.0 * turns - 1.0).abs();
        let from_midrib = across / (along / BROAD).min(1.0);
        // From the side vein at whose end the notch is, so that it is not below 0.
        let stroke = (along - LEAN * across + LEAN) * STROKES;
        let none = NONE + UNEVEN * rough(stroke, 0, u32::from(turns < 0.5));
        let grain = scatter((turns * 256.0) as u32 + 256 * (along * 256.0) as u32, 2);
        grain > (from_midrib - ALL) / (none - ALL)
    });
    vec![Control::foreground(Wrap::Leaf, image)]
}

/// From the midrib to the rim and a little towards the tip, as the side veins run.
fn side_veins(surface: &Mesh) -> DirectionField {
    /// Leaf coordinates of the control vectors, across on either side and along.
    const ACROSS: [f32; 4] = [-0.8, -0.35, 0.35, 0.8];
    const ALONG: [f32; 5] = [0.12, 0.3, 0.5, 0.7, 0.88];
    /// The control vectors are about 2 cm apart. At 0.2 per cm those of one half of a leaf turn the
    /// field of the other around beside the midrib; at 4 nothing looks better.
    const EPSILON_PER_CM: f64 = 0.4;
    let mut guides = Vec::new();
    for part in 0..surface.part_count() as u32 {
        for leaf in ALONG.iter().flat_map(|&along| ACROSS.map(|across| Vec2::new(across, along))) {
            let triangle = nearest(surface, part, leaf);
            let [across, along] = leaf_axes(surface, triangle);
            guides.push(Guide { triangle, direction: across * leaf.x.signum() + along * LEAN });
        }
    }
    DirectionField::new(surface, &guides, EPSILON_PER_CM).expect("control vectors that stand apart")
}

/// The triangle of a leaf whose centre is nearest in leaf coordinates.
fn nearest(surface: &Mesh, part: u32, leaf: Vec2) -> u32 {
    let centre = |t: u32| {
        surface.triangles[t as usize].iter().map(|&v| surface.uvs[v as usize]).sum::<Vec2>() / 3.0
    };
    let distance = |t: u32| centre(t).distance_squared(leaf);
    (0..surface.triangles.len() as u32)
        .filter(|&t| surface.parts[t as usize] == part)
        .min_by(|&s, &t| distance(s).total_cmp(&distance(t)))
        .expect("every part has triangles")
}

/// The ways in space along which each of the leaf coordinates grows by one.
fn leaf_axes(surface: &Mesh, triangle: u32) -> [Vec3; 2] {
    let [a, b, c] = surface.corners(triangle);
    let [ua, ub, uc] = surface.triangles[triangle as usize].map(|v| surface.uvs[v as usize]);
    let (to_b, to_c) = (ub - ua, uc - ua);
    let area = to_b.perp_dot(to_c);
    [((b - a) * to_c.y - (c - a) * to_b.y) / area, ((c - a) * to_b.x - (b - a) * to_c.x) / area]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_field_leads_from_the_midrib_to_the_rim() {
        let surface = crate::plants::find("philodendron").unwrap().embedded_body().surface;
        let field = side_veins(&surface);
        for t in 0..surface.triangles.len() as u32 {
            let direction = field.at(t);
            assert!((direction.length() - 1.0).abs() < 1e-5, "triangle {t}: {direction}");
            let [a, b, c] = surface.triangles[t as usize].map(|v| surface.uvs[v as usize]);
            let frame = surface.frames[t as usize].barycentric(direction);
            let in_leaf = (b - a) * frame.x + (c - a) * frame.y;
            let across = (a.x + b.x + c.x) / 3.0;
            let outwards = in_leaf.x * across.signum() > 0.0;
            assert!(outwards || across.abs() < 0.12, "{across} across: {in_leaf}");
        }
    }
}
