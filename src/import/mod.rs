//! Files in: what was taken away is opened again, as the link of the scene that it shows; and photographs, as
//! the colours of a plant.

mod drawn;
mod made;
mod own;
mod painted;
mod palette;
mod photo;
#[cfg(test)]
mod pictured_tests;

use crate::plants::{self, Look};
use crate::play::{FIRST_INDIVIDUAL, Scene, link, origin};
use crate::shapes::Rule;
use crate::surface::quoted;
use crate::tissue::Recipe;
pub use drawn::{in_few_points, line_meant};
pub use made::Made;
pub use own::{Own, of_document, of_mesh};
pub use painted::{Brush, MOST_RADIUS, Painted, Skin, Spot, Stroke, Way, painted_of_link};
pub use palette::{Palette, Part, Photo, palette};
pub use photo::{coloured, matched, patterned, types};
use serde_json::Value;

/// The link of the scene in a file: of a picture, a model or a drawing that was taken away here the one that
/// is written in it, of a plant document the one that says its numbers, of the numbers of a body by rule the
/// one that makes it, of a recipe the one that grows it on the plant of `now`.
///
/// # Errors
/// In plain words, why there is none.
pub fn link_of_file(bytes: &[u8], now: &Scene) -> Result<String, String> {
    match std::str::from_utf8(bytes) {
        Ok(text) if text.trim_start_matches('\u{feff}').trim_start().starts_with('{') => {
            link_of_json(text, now)
        }
        _ => {
            let comment = gif_comment(bytes);
            let text = comment.as_deref().or_else(|| png_text(bytes)).unwrap_or(bytes);
            link_within(text).ok_or_else(|| {
                "This file holds no link of the playground: it opens pictures, films, models and documents \
                 that were taken away here."
                    .to_string()
            })
        }
    }
}

/// The plant of the words that stand behind the `~` of its link: of a body by rule, or of strokes on a plant, of which
/// `obj` is the text of its mesh.
///
/// # Errors
/// In plain words, why there is none.
pub fn made_of_words(words: &str, obj: &str) -> Result<Own, String> {
    match Painted::read(words) {
        Some(painted) => painted?.make(obj),
        None => Made::of_words(words)?.own(),
    }
}

/// The text of a PNG that our pictures keep their link in. What comes after it, a checksum, may be letters too.
fn png_text(bytes: &[u8]) -> Option<&[u8]> {
    let mut rest = bytes.strip_prefix(b"\x89PNG\r\n\x1a\n")?;
    loop {
        let (length, after) = rest.split_first_chunk::<4>()?;
        let length = u32::from_be_bytes(*length) as usize;
        let chunk = after.get(..length.checked_add(4)?)?;
        // Not packed, in no language, and without another keyword.
        if let Some(text) = chunk.strip_prefix(b"iTXtLink\0\0\0\0\0") {
            return Some(text);
        }
        rest = after.get(length.checked_add(8)?..)?;
    }
}

/// The comment of a GIF, which stands in blocks of at most 255 bytes. Ours comes before the first frame.
fn gif_comment(bytes: &[u8]) -> Option<Vec<u8>> {
    let rest = bytes.strip_prefix(b"GIF89a")?;
    let at = rest.windows(2).position(|two| two == b"\x21\xfe")?;
    let (mut rest, mut text) = (&rest[at + 2..], Vec::new());
    while let Some((&length, after)) = rest.split_first().filter(|(length, _)| **length > 0) {
        let (block, after) = after.split_at_checked(length.into())?;
        text.extend(block);
        rest = after;
    }
    Some(text)
}

/// The first link that stands in a file as text: all of ours are written so. Of a plant of the visitor's own it is one
/// that says what that is made of.
fn link_within(bytes: &[u8]) -> Option<String> {
    const MARK: &[u8] = b"?v=";
    let marks = bytes.windows(MARK.len()).enumerate().filter(|(_, window)| *window == MARK);
    marks.map(|(at, _)| at).find_map(|at| {
        let of_name = |b: &u8| b.is_ascii_lowercase() || b.is_ascii_digit() || *b == b'-';
        let of_query = |b: &u8| b.is_ascii_alphanumeric() || b"=&.,-+;_?".contains(b);
        let of_origin = |b: &u8| of_query(b) || b"~:/".contains(b);
        let name = bytes[..at].iter().rev().take_while(|b| of_name(b)).count();
        let query = bytes[at..].iter().take_while(|b| of_query(b)).count();
        let text = std::str::from_utf8(&bytes[at - name..at + query]).ok()?;
        // No name begins so.
        let text = text.trim_start_matches(|c: char| c.is_ascii_digit());
        let key = text.split('?').next()?;
        if plants::find(key).is_some() {
            return Some(link::write(&link::read(text, plants::all()).scene));
        }
        // Nobody knows it yet, so that its link stays as it is written.
        let beside = bytes[at + query..].iter().take_while(|b| of_origin(b)).count();
        let beside = std::str::from_utf8(&bytes[at + query..at + query + beside]).ok()?;
        let [origin, _] = origin::parts(beside);
        let is_made = key.starts_with(plants::OWN) && !origin.is_empty();
        is_made.then(|| format!("{}{origin}", text.replace("&amp;", "&")))
    })
}

fn link_of_json(text: &str, now: &Scene) -> Result<String, String> {
    let json: Value = serde_json::from_str(text.trim_start_matches('\u{feff}'))
        .map_err(|why| format!("it is no JSON: {why}"))?;
    // A document says so itself; the numbers of a body have names of their own; what has none of them is a recipe.
    if json.get("mosaic_plant").is_some() {
        return link_of_plant(&json);
    }
    if let Some(rule) = Rule::of_json(text) {
        let rule = rule.map_err(|why| why.to_string())?;
        let kind = rule.kind();
        return Ok(format!("{}{kind}~{kind}={}", plants::OWN, rule.to_words()));
    }
    let recipe = Recipe::from_json(text).map_err(|why| why.to_string())?;
    link_that_says(&Scene { day: now.day.min(recipe.days), recipe, ..now.clone() })
}

/// That of a document whose plant is in the catalogue but for its numbers and its colours. Read as plain JSON: the
/// reader of documents, which knows every field, weighs more than all else that opens files.
fn link_of_plant(document: &Value) -> Result<String, String> {
    let text = |field: &str| document["names"][field].as_str().unwrap_or_default();
    let without_numbers = |document: &Value| {
        let mut rest = document.as_object().cloned().unwrap_or_default();
        rest.retain(|field, _| !["rules", "recipe", "look"].contains(&field.as_str()));
        rest
    };
    let version = document["rules"].as_u64().unwrap_or(1) as u32;
    let of_version = plants::find(text("key")).and_then(|newest| newest.under(version));
    let own = of_version.filter(|own| {
        let own: Value = serde_json::from_str(&own.to_json()).expect("documents are JSON");
        without_numbers(&own) == without_numbers(document)
    });
    let own = own.ok_or_else(|| {
        format!(
            "{} is a plant of its own: the page grows the plants of its catalogue and what their numbers make \
             of them. In a shell, mosaic grow --plant grows it.",
            quoted(text("name"))
        )
    })?;
    let recipe =
        Recipe::from_json(&document["recipe"].to_string()).map_err(|why| why.to_string())?;
    let look: Look = serde_json::from_value(document["look"].clone())
        .map_err(|why| format!("its look: {why}"))?;
    let preset = Scene::preset(own, FIRST_INDIVIDUAL);
    link_that_says(&Scene { day: preset.day.min(recipe.days), recipe, look, ..preset })
}

/// The link of a scene, if links have words for all that is in it.
fn link_that_says(scene: &Scene) -> Result<String, String> {
    let link = link::write(scene);
    let read = link::read(&link, plants::all()).scene;
    if read.recipe == scene.recipe && read.look == scene.look {
        return Ok(link);
    }
    Err("It has numbers that no link can say. In a shell, mosaic grow takes it as a file."
        .to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants::Plant;

    fn scene(text: &str) -> Scene {
        link::read(text, plants::all()).scene
    }

    #[test]
    fn a_link_is_found_in_bytes_of_any_kind() {
        let link = "red-croton?v=1&s=7&d=12&df=6.5";
        for file in [
            // Its checksum looks like more of the number.
            [
                b"\x89PNG\r\n\x1a\n\0\0\0\x01IHDR?0000\0\0\0\x27iTXtLink\0\0\0\0\0",
                link.as_bytes(),
                b"77=1\0",
            ]
            .concat(),
            format!("<metadata>Clonal Mosaic {}</metadata>", link.replace('&', "&amp;"))
                .into_bytes(),
            format!("ply\ncomment {link}\nend_header\n\u{1}").into_bytes(),
            // A GIF has its comment in blocks.
            [
                b"GIF89a0000000\x21\xfe\x0a",
                &link.as_bytes()[..10],
                b"\x14",
                &link.as_bytes()[10..],
                b"\09",
            ]
            .concat(),
        ] {
            assert_eq!(link_of_file(&file, &scene("")).as_deref(), Ok(link));
        }
        let made = "own-k3f7a2?v=2&s=1&d=3&df=6.5~painted/croton/2/f.500.wm.k3f7a2-n.40.p.k00";
        let file = format!("<desc>Clonal Mosaic {}</desc>", made.replace('&', "&amp;"));
        assert_eq!(link_of_file(file.as_bytes(), &scene("")).as_deref(), Ok(made));
        let file = b"ply\ncomment own-k3f7a2?v=2&s=1~leaf=on:croton.2,lobes:7\nend_header\n";
        let made = "own-k3f7a2?v=2&s=1~leaf=on:croton.2,lobes:7";
        assert_eq!(link_of_file(file, &scene("")).as_deref(), Ok(made));
        for other in [&b""[..], b"what?v=1&s=2", b"own-k3f7a2?v=2&s=1", b"?v=", b"\xff\xfe\x80"] {
            assert!(link_of_file(other, &scene("")).unwrap_err().contains("no link"));
        }
    }

    #[test]
    fn documents_are_links_as_far_as_links_can_say_them() {
        let changed = scene("watermelon?v=1&s=1&d=2&df=7&bo=0.5");
        let (recipe, look) = (changed.recipe.clone(), changed.look.clone());
        let plant = Plant { recipe, look, ..changed.plant.clone() };
        let link = link_of_file(plant.to_json().as_bytes(), &scene("")).unwrap();
        let read = scene(&link);
        assert_eq!((&read.recipe, &read.look), (&changed.recipe, &changed.look));

        let own = Plant { name: "Mine", key: "mine", ..plant.clone() };
        let why = link_of_file(own.to_json().as_bytes(), &scene("")).unwrap_err();
        assert!(why.contains("Mine") && why.contains("is a plant of its own"), "{why}");
        let broken = plant.to_json().replace("\"recipe\"", "\"recipes\"");
        assert!(link_of_file(broken.as_bytes(), &scene("")).is_err());

        // Numbers of a body lead to it.
        let made = Made::of_words("leaf=lobes:7,border:smooth").unwrap();
        assert_eq!(
            link_of_file(made.to_json().as_bytes(), &scene("")).as_deref(),
            Ok("own-leaf~leaf=border:smooth,lobes:7")
        );
        let why = link_of_file(b"{\"lobes\": 4}", &scene("")).unwrap_err();
        assert!(why.contains("lobes is 4: it must be an odd number"), "{why}");
        assert_eq!(of_document("{\"lobes\": 4}", "").unwrap_err(), why);

        // A recipe grows on the plant that is there, if links can say it.
        let now = scene("cactus?v=1&s=3&d=2");
        let link = "cactus?v=1&s=3&d=2&df=7";
        let file = scene(link).recipe.to_json();
        assert_eq!(link_of_file(file.as_bytes(), &now).as_deref(), Ok(link));
        let file = file.replace("60000", "61000");
        assert!(link_of_file(file.as_bytes(), &now).unwrap_err().contains("no link can say"));
    }
}
