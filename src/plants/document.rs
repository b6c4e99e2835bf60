//! A plant as a document: all that makes it, in JSON. What is written is read back bit for bit.

mod check;
mod kept;
mod rows;
#[cfg(test)]
mod tests;

use super::{Guides, Look, Motion, Paint, Plant, Rules, Shape, View};
use crate::tissue::Recipe;
pub(super) use check::kept;
use kept::ByType;
pub(super) use kept::{Bare, Listed, Tint, by_type, kept_list, kept_text, kept_texts};
use rows::Rows;
use serde::{Deserialize, Serialize};

/// A text or a list of a plant. Those of the catalogue stand in the program; those of a document that
/// was read are kept until it ends, as the plant is.
pub type Text = &'static str;
pub type List<T> = &'static [T];

/// Why a text is not a plant that can be grown, in words for whoever wrote it.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{0}")]
pub struct PlantError(pub String);

/// The version of documents that is written and read.
const VERSION: u32 = 1;

/// The document as it is written.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Document {
    mosaic_plant: u32,
    /// Documents of the days when there were but the first ones say none.
    #[serde(default = "first")]
    rules: Rules,
    names: Names,
    body: Shape,
    #[serde(default, deserialize_with = "kept_list")]
    paint: List<Paint>,
    #[serde(default)]
    guides: Option<Guides>,
    recipe: Recipe,
    #[serde(default = "still")]
    motion: Motion,
    look: Look,
    view: View,
    first_day: u32,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Names {
    #[serde(deserialize_with = "kept_text")]
    key: Text,
    #[serde(deserialize_with = "kept_text")]
    name: Text,
    #[serde(default, deserialize_with = "kept_text")]
    latin: Text,
    #[serde(default, deserialize_with = "kept_text")]
    source: Text,
    colours: ByType<Colour>,
}

/// The name of a colour.
#[derive(Serialize, Deserialize)]
#[serde(transparent)]
struct Colour(#[serde(deserialize_with = "kept_text")] Text);

fn first() -> Rules {
    Rules::First
}

fn still() -> Motion {
    Motion::STILL
}

impl Plant {
    /// The plant as JSON, every number named.
    pub fn to_json(&self) -> String {
        let document = Document {
            mosaic_plant: VERSION,
            rules: self.rules,
            names: Names {
                key: self.key,
                name: self.name,
                latin: self.latin,
                source: self.source,
                colours: ByType::of(self.colour_names.map(Colour)),
            },
            body: self.body,
            paint: self.paint,
            guides: self.guides,
            recipe: self.recipe.clone(),
            motion: self.motion,
            look: self.look.clone(),
            view: self.view,
            first_day: self.first_day,
        };
        let mut json = Vec::new();
        let mut serializer = serde_json::Serializer::with_formatter(&mut json, Rows::default());
        document.serialize(&mut serializer).expect("a plant holds plain numbers and texts");
        String::from_utf8(json).expect("JSON is UTF-8")
    }

    /// Reads a plant from JSON. The error says what is wrong, and where.
    pub fn from_json(text: &str) -> Result<Plant, PlantError> {
        // What editors of Windows put before a text.
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        // A list would be taken for the fields in their order.
        if text.trim_start().starts_with('[') {
            return Err(PlantError("the plant: an object {...} is needed, not a list".to_string()));
        }
        let mut json = serde_json::Deserializer::from_str(text);
        let read = serde_path_to_error::deserialize(&mut json);
        let document: Document = read.map_err(|e| {
            let (path, why) = (e.path().to_string(), e.inner().to_string());
            if e.inner().is_syntax() || e.inner().is_eof() {
                return PlantError(format!("the plant is no JSON: {why}"));
            }
            let at = if path == "." { "the plant".to_string() } else { path };
            PlantError(format!("{at}: {}", in_plain_words(&why)))
        })?;
        json.end().map_err(|e| PlantError(format!("the plant is no JSON: {e}")))?;
        if document.mosaic_plant != VERSION {
            let version = document.mosaic_plant;
            let why = format!("mosaic_plant is {version}: this program reads version {VERSION}");
            return Err(PlantError(why));
        }
        let Document { mosaic_plant: _, rules, names, body, paint, guides, recipe, .. } = document;
        let plant = Plant {
            rules,
            key: names.key,
            name: names.name,
            latin: names.latin,
            source: names.source,
            colour_names: names.colours.row().map(|colour| colour.0),
            body,
            paint,
            guides,
            recipe,
            motion: document.motion,
            look: document.look,
            view: document.view,
            first_day: document.first_day,
        };
        plant.check()?;
        Ok(plant)
    }
}

/// What serde calls things, as a gardener would.
fn in_plain_words(why: &str) -> String {
    let types = [
        ("expected f32", "a number is needed"),
        ("expected f64", "a number is needed"),
        ("expected u32", "a whole number from 0 on is needed"),
        ("expected a sequence", "a list is needed"),
        ("expected a string", "a text is needed"),
        ("expected a boolean", "true or false is needed"),
        ("invalid type: ", "not what is needed here: "),
        ("invalid value: ", "not what is needed here: "),
    ];
    types.iter().fold(why.to_string(), |text, (word, plain)| text.replace(word, plain))
}
