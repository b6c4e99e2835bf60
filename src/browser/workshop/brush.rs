//! Strokes under the visitor's hand, on a plant that is held ready for them.

use crate::import::{Painted, Skin, Stroke};
use crate::play::Scene;
use glam::Vec2;
use js_sys::{Array, Float32Array};
use wasm_bindgen::prelude::*;

const NOTHING: &str = "there is nothing to paint on";

/// Holds the plant below strokes ready; `mesh` is the text of its mesh.
pub fn hold(skin: &mut Option<Skin>, words: &str, mesh: &str) -> Result<JsValue, String> {
    let painted = Painted::read(words).ok_or(NOTHING)??;
    let skin = skin.insert(Skin::new(painted.base, mesh)?);
    Ok(Array::of1(&skin.size_cm().into()).into())
}

/// Takes a stroke on, and says where it is seen.
pub fn stroke(skin: &Option<Skin>, scene: &Scene, more: &Array) -> Result<JsValue, String> {
    let words = more.get(0).as_string().unwrap_or_default();
    let mut stroke = Stroke::read(&words).ok_or(NOTHING)?;
    let px = more.get(1).unchecked_into::<Float32Array>().to_vec();
    let px: Vec<Vec2> = px.chunks_exact(2).map(Vec2::from_slice).collect();
    let (&stage_px, at_px) = px.split_first().ok_or(NOTHING)?;
    let seen = skin.as_ref().ok_or(NOTHING)?.seen(scene, stage_px);
    seen.lead(&mut stroke, at_px);
    let (lines, width_px) = seen.lines(&stroke);
    let line = |points: &Vec<Vec2>| {
        // A dab is a line to itself.
        let points = points.iter().chain(points.last()).map(|at| format!("{},{}", at.x, at.y));
        format!("<polyline points='{}'/>", points.collect::<Vec<_>>().join(" "))
    };
    let lines: String = lines.iter().map(line).collect();
    Ok(Array::of3(&stroke.write().into(), &lines.into(), &width_px.into()).into())
}
