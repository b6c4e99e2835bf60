//! Recipes as JSON, as people write them. What `Recipe::to_json` has written is read back bit for bit.

use super::{CellType, Clock, Recipe, RecipeError};
use crate::surface::quoted;
use serde::de::{IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::fmt;

/// How far shares may miss the sum 1 and be scaled to it: three that were rounded to three digits after
/// the point have a sum of 0.999 or 1.001, and no share that matters is as small as what is missing.
const ROUNDING: f64 = 0.001_5;

/// The pairs of types, by their names in JSON.
const PAIRS: [(&str, usize, usize); 6] =
    [("FF", 0, 0), ("BB", 1, 1), ("MM", 2, 2), ("FB", 0, 1), ("FM", 0, 2), ("BM", 1, 2)];

/// Reads a recipe; `Recipe::check` has still to be asked whether it can be grown.
pub(super) fn read(text: &str) -> Result<Recipe, RecipeError> {
    // What editors of Windows put before a text.
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    serde_json::from_str::<IgnoredAny>(text).or_else(|e| refuse("the recipe is no JSON", e))?;
    let json: Json = serde_json::from_str(text).or_else(|e| refuse("the recipe", e))?;
    recipe(&json)
}

/// A recipe inside another document; it has to be checked as that of `read`.
impl<'de> Deserialize<'de> for Recipe {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Recipe, D::Error> {
        recipe(&Json::deserialize(deserializer)?).map_err(serde::de::Error::custom)
    }
}

fn recipe(json: &Json) -> Result<Recipe, RecipeError> {
    let mut recipe = Recipe::DEFAULT;
    for (key, value) in json.members("the recipe")? {
        let at = key.as_str();
        match at {
            "initial_cells" => recipe.initial_cells = value.whole(at)?,
            "initial_probability" => recipe.initial_probability = read_shares(at, value)?,
            "division_days" => read_row(at, value, &mut recipe.division_days)?,
            "clock" => recipe.clock = read_clock(at, value)?,
            "mutation" => read_mutation(at, value, &mut recipe.mutation)?,
            "adhesion" => read_adhesion(at, value, &mut recipe.adhesion)?,
            "radius_scale" => recipe.radius_scale = value.number(at)? as f32,
            "repulsion" => recipe.repulsion = value.number(at)? as f32,
            "anisotropy" => recipe.anisotropy = value.number(at)? as f32,
            "initial_relaxations" => recipe.initial_relaxations = value.whole(at)?,
            "relaxations_per_day" => recipe.relaxations_per_day = value.whole(at)?,
            "days" => recipe.days = value.whole(at)?,
            "max_cells" => recipe.max_cells = value.whole(at)?,
            _ => return unknown("the recipe", key, NAMES),
        }
    }
    Ok(recipe)
}

/// All that a recipe may name.
const NAMES: &str = "initial_cells, initial_probability, division_days, clock, mutation, adhesion, \
                     radius_scale, repulsion, anisotropy, initial_relaxations, relaxations_per_day, \
                     days and max_cells";

/// The numbers of the types that are named.
fn read_row(at: &str, json: &Json, row: &mut [f64; 3]) -> Result<(), RecipeError> {
    for (key, value) in json.members(at)? {
        row[type_of(at, key)? as usize] = value.number(&format!("{at}.{key}"))?;
    }
    Ok(())
}

/// What is not named has probability 0.
fn read_shares(at: &str, json: &Json) -> Result<[f64; 3], RecipeError> {
    let mut row = [0.0; 3];
    read_row(at, json, &mut row)?;
    Ok(without_rounding(row))
}

/// What is not named does not mutate: the diagonal is what the named chances leave.
fn read_mutation(at: &str, json: &Json, rows: &mut [[f64; 3]; 3]) -> Result<(), RecipeError> {
    for (key, value) in json.members(at)? {
        let from = type_of(at, key)? as usize;
        // No number of JSON.
        let mut row = [f64::NAN; 3];
        read_row(&format!("{at}.{key}"), value, &mut row)?;
        let left = row[from].is_nan();
        row = row.map(|share| if share.is_nan() { 0.0 } else { share });
        if left {
            row[from] = (1.0 - row.iter().sum::<f64>()).max(0.0);
        }
        rows[from] = without_rounding(row);
    }
    Ok(())
}

fn read_adhesion(at: &str, json: &Json, rows: &mut [[f32; 3]; 3]) -> Result<(), RecipeError> {
    for (key, value) in json.members(at)? {
        let Some(&(_, i, j)) = PAIRS.iter().find(|(name, ..)| name == key) else {
            return unknown(at, key, "FF, BB, MM, FB, FM and BM");
        };
        rows[i][j] = value.number(&format!("{at}.{key}"))? as f32;
        rows[j][i] = rows[i][j];
    }
    Ok(())
}

fn read_clock(at: &str, json: &Json) -> Result<Clock, RecipeError> {
    match json {
        Json::Text(name) if name == "poisson" => Ok(Clock::Poisson),
        Json::Text(name) if name == "exponential" => Ok(Clock::Exponential),
        _ => json.is_not(at, "\"poisson\" or \"exponential\""),
    }
}

fn type_of(at: &str, key: &str) -> Result<CellType, RecipeError> {
    let named = CellType::ALL.into_iter().find(|kind| key.chars().eq([kind.letter()]));
    named.map_or_else(|| unknown(at, key, "F, B and M"), Ok)
}

/// Shares with the sum 1 where they missed it by rounding. Any others stay as they are, bit for bit.
fn without_rounding(row: [f64; 3]) -> [f64; 3] {
    let sum: f64 = row.iter().sum();
    let is_rounded = (1e-6..ROUNDING).contains(&(sum - 1.0).abs());
    if is_rounded { row.map(|share| share / sum) } else { row }
}

/// What stands in JSON, with all members in their order, also those that come twice.
enum Json {
    Number(f64),
    Text(String),
    Object(Vec<(String, Json)>),
    /// Anything else, by its name.
    Other(&'static str),
}

impl Json {
    /// The members of an object, each of another name.
    fn members(&self, at: &str) -> Result<&[(String, Json)], RecipeError> {
        let Json::Object(members) = self else { return self.is_not(at, "an object {...}") };
        for (k, (key, _)) in members.iter().enumerate() {
            if members[..k].iter().any(|(other, _)| other == key) {
                return refuse(at, format_args!("{} stands in it twice", quoted(key)));
            }
        }
        Ok(members)
    }

    fn number(&self, at: &str) -> Result<f64, RecipeError> {
        match *self {
            Json::Number(number) => Ok(number),
            _ => self.is_not(at, "a number"),
        }
    }

    fn whole(&self, at: &str) -> Result<u32, RecipeError> {
        match *self {
            Json::Number(x) if x.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(&x) => {
                Ok(x as u32)
            }
            _ => self.is_not(at, &format!("a whole number from 0 to {}", u32::MAX)),
        }
    }

    fn is_not<T>(&self, at: &str, needed: &str) -> Result<T, RecipeError> {
        let found = match self {
            Json::Number(x) => format!("{x:?}").trim_end_matches(".0").to_string(),
            Json::Text(text) => quoted(text),
            Json::Object(_) => "an object".to_string(),
            Json::Other(name) => name.to_string(),
        };
        refuse(at, format_args!("{needed} is needed, not {found}"))
    }
}

fn unknown<T>(at: &str, key: &str, known: &str) -> Result<T, RecipeError> {
    refuse(at, format_args!("it has no {}; it may have {known}", quoted(key)))
}

fn refuse<T>(at: &str, why: impl fmt::Display) -> Result<T, RecipeError> {
    Err(RecipeError(format!("{at}: {why}")))
}

impl<'de> Deserialize<'de> for Json {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Json, D::Error> {
        deserializer.deserialize_any(AnyJson)
    }
}

struct AnyJson;

impl<'de> Visitor<'de> for AnyJson {
    type Value = Json;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("JSON")
    }

    fn visit_u64<E>(self, number: u64) -> Result<Json, E> {
        Ok(Json::Number(number as f64))
    }

    fn visit_i64<E>(self, number: i64) -> Result<Json, E> {
        Ok(Json::Number(number as f64))
    }

    fn visit_f64<E>(self, number: f64) -> Result<Json, E> {
        Ok(Json::Number(number))
    }

    fn visit_str<E>(self, text: &str) -> Result<Json, E> {
        Ok(Json::Text(text.to_string()))
    }

    fn visit_bool<E>(self, is_true: bool) -> Result<Json, E> {
        Ok(Json::Other(if is_true { "true" } else { "false" }))
    }

    fn visit_unit<E>(self) -> Result<Json, E> {
        Ok(Json::Other("null"))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Json, A::Error> {
        while list.next_element::<IgnoredAny>()?.is_some() {}
        Ok(Json::Other("a list"))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut object: A) -> Result<Json, A::Error> {
        let mut members = Vec::new();
        while let Some(member) = object.next_entry()? {
            members.push(member);
        }
        Ok(Json::Object(members))
    }
}

/// A value for each type, by its letter.
#[derive(Serialize)]
#[serde(rename_all = "UPPERCASE")]
struct ByType<T> {
    f: T,
    b: T,
    m: T,
}

fn by_type<T>([f, b, m]: [T; 3]) -> ByType<T> {
    ByType { f, b, m }
}

pub(super) fn write_row<S: Serializer>(row: &[f64; 3], s: S) -> Result<S::Ok, S::Error> {
    by_type(*row).serialize(s)
}

pub(super) fn write_mutation<S: Serializer>(rows: &[[f64; 3]; 3], s: S) -> Result<S::Ok, S::Error> {
    by_type(rows.map(by_type)).serialize(s)
}

pub(super) fn write_adhesion<S: Serializer>(rows: &[[f32; 3]; 3], s: S) -> Result<S::Ok, S::Error> {
    s.collect_map(PAIRS.map(|(name, i, j)| (name, rows[i][j])))
}
