//! A plant of the visitor's own: a document, or a mesh on which the plant that is there grows.

use crate::plants::{Growths, Motion, Plant, Shape, to_text};
use crate::play::Scene;
use crate::shapes::Rule;
use crate::surface::{Brought, BroughtError, NO_TWIN};
use std::sync::Arc;

/// A plant that was made of a file: its key, its text, and what was done to it in plain words.
#[derive(Clone, Debug, PartialEq)]
pub struct Own {
    pub key: String,
    pub text: String,
    pub told: Vec<String>,
}

/// Triangles of a body at most: each has a chart of its own, and phones have little memory.
pub(super) const MOST_TRIANGLES: usize = 60_000;
/// Bodies between these sizes stay as large as they are, in centimetres; others are made `USUAL_CM` large.
const SIZES_CM: std::ops::RangeInclusive<f32> = 1.0..=300.0;
const USUAL_CM: f32 = 20.0;

/// Makes a plant of a document. `obj` is the text of the mesh that it names.
///
/// # Errors
/// In plain words, why it cannot be grown.
pub fn of_document(json: &str, obj: &str) -> Result<Own, String> {
    // Numbers of a body are no document; what is wrong with them is said by their names.
    if let Some(Err(why)) = Rule::of_json(json) {
        return Err(why.to_string());
    }
    let plant = Plant::from_json(json).map_err(|why| why.to_string())?;
    let body = plant.grow_body(obj).map_err(|why| why.to_string())?;
    plant.check_on(&Arc::new(body.surface)).map_err(|why| why.to_string())?;
    let (key, text) = to_text(&plant, obj);
    Ok(Own { key, text, told: Vec::new() })
}

/// Makes a plant of an OBJ, PLY or GLB file: its body, mended as `Brought` does, with the recipe and the colours of a scene. Its
/// control images and its direction field belong to its own body, and stay there.
///
/// # Errors
/// In plain words, why cells cannot grow on it.
pub fn of_mesh(file: &[u8], name: &str, scene: &Scene) -> Result<Own, String> {
    let brought = Brought::read(file).map_err(|why: BroughtError| why.to_string())?;
    let Brought { body, mut mesh, unit_cm, joined_edges, left_out_triangles, .. } = brought;
    let triangles = body.surface.triangles.len();
    if triangles > MOST_TRIANGLES {
        return Err(format!(
            "it has {triangles} triangles, and up to {MOST_TRIANGLES} grow here: save it with fewer"
        ));
    }
    let mut told = vec![match body.surface.part_count() {
        1 => format!("{triangles} triangles"),
        parts => format!("{triangles} triangles in {parts} parts"),
    }];
    if unit_cm > 1.0 {
        told.push("in metres, as GLB files are".to_string());
    }
    if joined_edges > 0 {
        told.push(format!("{joined_edges} pairs of rim edges were joined"));
    }
    if left_out_triangles > 0 {
        told.push(format!(
            "{left_out_triangles} triangles without area or that stood twice left out"
        ));
    }
    let low = mesh.positions.iter().copied().reduce(|a, b| a.min(b)).unwrap_or_default();
    let high = mesh.positions.iter().copied().reduce(|a, b| a.max(b)).unwrap_or_default();
    let size_cm = (high - low).max_element();
    if !SIZES_CM.contains(&size_cm) {
        let then = mesh.moments.iter_mut().flat_map(|moment| &mut moment.positions);
        mesh.positions.iter_mut().chain(then).for_each(|at| *at *= USUAL_CM / size_cm);
        told.push(format!("{size_cm} cm large, so it was made {USUAL_CM} cm"));
    }
    let Scene { plant, recipe, look, .. } = scene;
    let mut look = look.clone();
    // Light comes through sheets, and not through what is closed; veins lie on leaf coordinates.
    if !body.surface.twins.contains(&NO_TWIN) {
        look.skin.through = 0.0;
    }
    look.veins &= !body.surface.uvs.is_empty();
    let shape = Shape { levels: 0, but: &[], growths: Growths::Nothing, ..plant.body };
    let plant = Plant {
        name: name.to_string().leak(),
        latin: "",
        source: format!("Recipe of the {}", plant.name.to_ascii_lowercase()).leak(),
        body: shape,
        paint: &[],
        guides: None,
        recipe: recipe.clone(),
        motion: Motion::STILL,
        look,
        first_day: plant.first_day.min(recipe.days),
        ..(**plant).clone()
    };
    let (key, text) = to_text(&plant, &mesh.to_obj());
    Ok(Own { key, text, told })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants::{self, bring};
    use crate::play::link;
    use crate::surface::unpack;
    use crate::tissue::{Growth, Progress};

    fn scene(text: &str) -> Scene {
        link::read(text, plants::all()).scene
    }

    fn fingerprint(mut growth: Growth) -> String {
        while !matches!(growth.step(), Progress::Done | Progress::Full) {}
        growth.diary.fingerprint(growth.diary.days.len() - 1)
    }

    /// Grows the plant of a text as the page's worker does, and tells its cells.
    fn grown(own: &Own, day: u32) -> String {
        let plant = bring(&own.text).expect("a plant");
        assert_eq!(plant.key, own.key);
        let mut scene = scene(&format!("{}?v=1&s=3&d={day}", own.key));
        assert_eq!(scene.plant, plant);
        scene.recipe.days = day;
        let body = plant.body.grow(&unpack(&own.text)).unwrap();
        fingerprint(scene.sow(Arc::new(body.surface)).unwrap().0)
    }

    #[test]
    fn a_mesh_of_ones_own_grows_the_cells_that_a_shell_grows_on_it() {
        // The body of a plant, its faces taken apart and its groups in another order.
        let coarse = crate::surface::PolygonMesh::parse(plants::all()[8].body.mesh.text).unwrap();
        let apart: String = coarse
            .to_obj()
            .lines()
            .filter(|line| !line.starts_with("vt"))
            .map(|line| format!("{line}\n"))
            .collect();
        let shrub = scene("croton-shrub?v=1&s=3&d=2&n=300&cf=ff0000");
        let own = of_mesh(apart.as_bytes(), "leaf", &shrub).unwrap();
        let mesh = Arc::new(Brought::read(apart.as_bytes()).unwrap().body.surface);
        let recipe = crate::tissue::Recipe { days: 2, ..shrub.recipe.clone() };
        assert_eq!(grown(&own, 2), fingerprint(Growth::new(mesh, recipe, &[], 3).unwrap()));
        let plant = plants::brought(&own.key).unwrap();
        assert_eq!((plant.name, plant.look.cells[0]), ("leaf", [1.0, 0.0, 0.0]));
        assert_eq!(plant.check(), Ok(()));
    }

    #[test]
    fn a_document_grows_as_it_does_in_a_shell() {
        let json = plants::find("begonia").unwrap().to_json();
        let json = json.replace("\"name\": \"", "\"name\": \"My ");
        let plant = Plant::from_json(&json).unwrap();
        let own = of_document(&json, plant.body.mesh.text).unwrap();
        let surface = Arc::new(plant.embedded_body().surface);
        let recipe = crate::tissue::Recipe { days: 1, ..plant.recipe.clone() };
        assert_eq!(grown(&own, 1), fingerprint(plant.sow(surface, recipe, 3).unwrap()));
        let brought = plants::brought(&own.key).unwrap();
        assert!(brought.name.starts_with("My "));
        let written = Plant { key: plant.key, ..brought.as_written() };
        assert_eq!(written.to_json(), json, "it is written as it was read");
    }

    #[test]
    fn what_was_done_to_a_mesh_is_told_and_what_cannot_grow_is_refused() {
        let shrub = scene("croton-shrub?v=1&s=1&d=1");
        let halves = "v 0 0 0\nv 900 0 0\nv 0 900 0\nv 900 0 0\nv 900 900 0\nv 0 900 0\nf 1 2 3\nf 4 5 6\nf 3 2 1\n";
        let own = of_mesh(halves.as_bytes(), "square", &shrub).unwrap();
        let told = own.told.join("; ");
        for part in ["2 triangles", "1 pairs of rim edges", "1 triangles without", "made 20 cm"] {
            assert!(told.contains(part), "{told}");
        }
        let body = bring(&own.text).unwrap().body.grow(&own.text).unwrap();
        assert!((body.surface.area - 400.0).abs() < 1e-3, "{}", body.surface.area);
        for (file, why) in
            [(&b"glTF\x02\0\0\0"[..], "the GLB file: it ends"), (b"v 0 0 0\n", "no faces")]
        {
            let refused = of_mesh(file, "no", &shrub).unwrap_err();
            assert!(refused.contains(why), "{refused}");
        }
        let faces = "f 1 2 3\n".repeat(3);
        assert!(
            of_mesh(format!("v 0 0 0\nv 0 0 0\nv 0 0 0\n{faces}").as_bytes(), "", &shrub).is_err()
        );
    }
}
