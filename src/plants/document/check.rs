//! Whether a plant's numbers are in their ranges.

use super::super::paint::Paint;
use super::super::{Look, Plant, View};
use super::PlantError;
use crate::surface::{Mesh, Shortest, Wrap, quoted};
use crate::tissue::Growth;
use std::sync::Arc;

impl Plant {
    /// Whether its numbers are in their ranges; else what is wrong.
    pub fn check(&self) -> Result<(), PlantError> {
        let of = |part: &str, result: Result<(), String>| {
            result.map_err(|why| PlantError(format!("{part}: {why}")))
        };
        of("names", self.check_names())?;
        of("body", self.body.check())?;
        for (number, paint) in self.paint.iter().enumerate() {
            of(&format!("paint[{number}]"), paint.check())?;
        }
        of("guides", self.guides.map_or(Ok(()), |guides| guides.check()))?;
        of("recipe", self.recipe.check().map_err(|e| e.to_string()))?;
        of("motion", self.motion.check())?;
        of("look", self.look.check())?;
        of("view", self.view.check())?;
        of(
            "first_day",
            match self.first_day {
                day if day > self.recipe.days => {
                    Err(format!("it is {day}, but the recipe ends at day {}", self.recipe.days))
                }
                _ => Ok(()),
            },
        )
    }

    /// Whether images and guides fit a surface and leave all numbers in their ranges; else what is wrong.
    pub fn check_on(&self, surface: &Arc<Mesh>) -> Result<(), PlantError> {
        let on_leaves = self.paint.iter().position(|paint| paint.wrap == Wrap::Leaf);
        if let Some(number) = on_leaves.filter(|_| surface.uvs.is_empty()) {
            return Err(PlantError(format!(
                "paint[{number}] lies on leaf coordinates: this mesh has none"
            )));
        }
        let without = |paint: &Paint| matches!(&paint.wrap, Wrap::Veins(along) if !surface.veins.any(along.order));
        if let Some(number) = self.paint.iter().position(without) {
            return Err(PlantError(format!(
                "paint[{number}] lies along veins: this mesh has none of that order"
            )));
        }
        self.field(surface).map_err(|why| PlantError(format!("guides: {why}")))?;
        Growth::new(Arc::clone(surface), self.recipe.clone(), &self.controls(0), 0)
            .map(|_| ())
            .map_err(|e| PlantError(e.to_string()))
    }

    fn check_names(&self) -> Result<(), String> {
        let is_plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
        if self.key.is_empty() || !self.key.chars().all(is_plain) {
            let key = quoted(self.key);
            return Err(format!("key is {key}: it may have small letters, digits and hyphens"));
        }
        let texts = [self.key, self.name, self.latin, self.source].into_iter();
        match texts.chain(self.colour_names).find(|text| text.chars().count() > 200) {
            Some(text) => Err(format!("{} is longer than 200 letters", quoted(text))),
            None => Ok(()),
        }
    }
}

impl Look {
    fn check(&self) -> Result<(), String> {
        let bare = self.bare.iter().map(|(_, colour, _)| colour);
        let tinted = self.tinted.iter().map(|(_, colour)| colour);
        for &part in self.cells.iter().chain(bare).chain(tinted).flatten() {
            kept("a part of a colour", part, 0.0, 1.0)?;
        }
        for &(_, _, gloss) in self.bare {
            kept("gloss of a bare part", gloss, 0.0, 1.0)?;
        }
        kept("variation", self.variation, 0.0, 1.0)?;
        kept("border", self.border, 0.0, 1.0)?;
        kept("gloss", self.gloss, 0.0, 1.0)?;
        self.skin.gloss.iter().try_for_each(|&share| kept("skin.gloss", share, 0.0, 1.0))?;
        self.skin.raised.iter().try_for_each(|&slope| kept("skin.raised", slope, -1.0, 1.0))?;
        kept("skin.through", self.skin.through, 0.0, 1.0)?;
        kept("skin.wax", self.skin.wax, 0.0, 1.0)?;
        kept("skin.unevenness", self.skin.unevenness, 0.0, 1.0)
    }
}

impl View {
    fn check(&self) -> Result<(), String> {
        kept("azimuth_deg", self.azimuth_deg, -360.0, 360.0)?;
        kept("elevation_deg", self.elevation_deg, -90.0, 90.0)?;
        kept("zoom", self.zoom, 0.1, 20.0)
    }
}

/// Whether a number is in its range; else what it must be.
pub(in crate::plants) fn kept(name: &str, value: f32, least: f32, most: f32) -> Result<(), String> {
    if (least..=most).contains(&value) {
        return Ok(());
    }
    let [value, least, most] = [value, least, most].map(f32::shortest);
    Err(format!("{name} is {value}: it must be from {least} to {most}"))
}
