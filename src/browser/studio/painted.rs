//! Painted plants and their addresses: a link of such a plant has its strokes behind the `~`, so that it opens
//! anywhere.

use super::own::hold;
use super::{files, subject, with};
use crate::browser::address::{fragment, wanted};
use crate::browser::dom::window;
use crate::import::{Brush, PAINTED, Painted};
use crate::plants::Show;
use crate::plants::{self, OWN};
use crate::play::{Scene, link};
use crate::surface::unpack;
use wasm_bindgen::JsValue;
use wasm_bindgen_futures::spawn_local;

/// What stands behind the `~` of the addresses of painted plants, by their keys.
#[derive(Default)]
pub struct Known {
    plants: Vec<(String, String)>,
    /// Whether one is on its way to the page.
    is_coming: bool,
}

impl Known {
    /// Has the address say of the plant that is there how it was painted, and of another one nothing.
    pub fn mend(&self) {
        let (link, beside) = (fragment(), wanted());
        let key = link.trim_start_matches('#').split('?').next().unwrap_or_default();
        let of_ours = beside.trim_start_matches('~').starts_with(PAINTED);
        if self.is_coming || !(of_ours || beside.is_empty()) {
            return;
        }
        let known = self.plants.iter().find(|(of, _)| of == key);
        let wished = match known {
            Some((_, painted)) => format!("~{painted}"),
            None => String::new(),
        };
        if wished != beside
            && let Ok(history) = window().history()
        {
            let address = format!("{link}{wished}");
            let _ = history.replace_state_with_url(&JsValue::NULL, "", Some(&address));
        }
    }
}

/// The strokes of the plant that the page shows, and the one below them; of any other plant none yet.
pub fn now() -> Painted {
    let scene = subject::wished();
    let of_address = Painted::read(&wanted()).and_then(Result::ok);
    match of_address.filter(|_| scene.plant.key.starts_with(OWN)) {
        Some(painted) => painted,
        None => Painted { base: scene.plant, strokes: Vec::new() },
    }
}

/// Shows a plant with other strokes; `obj` is the text of its mesh.
///
/// # Errors
/// In plain words, why it cannot be.
pub fn show(painted: &Painted, obj: &str) -> Result<(), String> {
    let scene = subject::wished();
    let Some(last) = painted.strokes.last() else {
        subject::go_to(&link::write(&on(painted.base, &scene, false)));
        return Ok(());
    };
    let own = painted.make(obj)?;
    let plant = plants::bring(&own.text).ok_or("it is no plant that can be read")?;
    hold(&own.key, &own.text);
    let link = link::write(&on(plant, &scene, last.brush == Brush::Lead));
    let words = painted.write();
    with(|studio| {
        studio.painted.plants.retain(|(key, _)| *key != own.key);
        studio.painted.plants.push((own.key.clone(), words.clone()));
    });
    subject::go(&link, &words);
    Ok(())
}

/// A scene on another plant of the same body: what the visitor has changed stays.
fn on(plant: &'static plants::Plant, scene: &Scene, is_led: bool) -> Scene {
    let before = scene.plant;
    let mut recipe = scene.recipe.clone();
    if recipe.anisotropy == before.recipe.anisotropy {
        recipe.anisotropy = plant.recipe.anisotropy;
    }
    let look = plants::Look { bare: plant.look.bare, ..scene.look.clone() };
    let show = match scene.show {
        _ if is_led => Show::FieldArrows,
        Show::FieldArrows => Show::Cells,
        show if show.is_of(plant) => show,
        _ => Show::Cells,
    };
    Scene { plant, recipe, look, show, cell: None, ..scene.clone() }
}

/// Makes the painted plant that a link asks for in vain, if its address says how, and shows it.
pub fn make(asked: &str) -> bool {
    let Some(painted) = Painted::read(&wanted()) else { return false };
    with(|studio| studio.painted.is_coming = true);
    let asked = asked.trim_start_matches('#').to_string();
    spawn_local(async move {
        let shown = match painted {
            Ok(painted) => show_asked(&painted, &asked).await,
            Err(why) => Err(why),
        };
        with(|studio| studio.painted.is_coming = false);
        if let Err(why) = shown {
            files::tell(&format!("What is painted on this plant cannot be shown: {why}."));
        }
    });
    true
}

async fn show_asked(painted: &Painted, asked: &str) -> Result<(), String> {
    let mesh = crate::browser::files::read_mesh(painted.base.body.mesh.name).await?;
    let own = painted.make(&unpack(&mesh))?;
    plants::bring(&own.text).ok_or("it is no plant that can be read")?;
    hold(&own.key, &own.text);
    // Another build may call it otherwise.
    let query = asked.split_once('?').map_or("", |(_, query)| query);
    let link = link::write(&link::read(&format!("{}?{query}", own.key), plants::all()).scene);
    let words = painted.write();
    with(|studio| studio.painted.plants.push((own.key, words.clone())));
    subject::go(&link, &words);
    Ok(())
}
