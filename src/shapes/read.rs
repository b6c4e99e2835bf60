//! Numbers as they stand in a text, and what is wrong with them in plain words: which name is not known, where, and
//! which one is meant.

use super::ShapeError;
use crate::surface::quoted;
use serde::de::value::{MapAccessDeserializer, StrDeserializer};
use serde::de::{self, DeserializeSeed, Deserializer, Expected, Unexpected, Visitor};
use serde_json::Value;
use std::fmt;

/// Reads numbers as they stand in a JSON text.
///
/// # Errors
/// A text that is no JSON, names that are not known, and values of another kind.
pub(super) fn read<T: de::DeserializeOwned>(text: &str) -> Result<T, ShapeError> {
    // What editors of Windows put before a text.
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let value: Value = serde_json::from_str(text).map_err(|why| {
        let [line, column] = [why.line(), why.column()];
        ShapeError(format!("it is no JSON: line {line}, column {column} cannot be read"))
    })?;
    T::deserialize(Place(&value)).map_err(|wrong| ShapeError(wrong.told()))
}

/// Reads numbers that stand within others, at this way.
///
/// # Errors
/// As `read`.
pub(super) fn read_within<T: de::DeserializeOwned>(
    way: &str,
    value: &Value,
) -> Result<T, ShapeError> {
    T::deserialize(Place(value)).map_err(|wrong| ShapeError(wrong.within(way).told()))
}

/// What is wrong, and the way to where.
#[derive(Debug)]
struct Wrong {
    way: Vec<String>,
    what: What,
}

#[derive(Debug)]
enum What {
    Name { unknown: String, known: &'static [&'static str] },
    Kind { unknown: String, known: &'static [&'static str] },
    Missing(&'static str),
    Value { found: String, wanted: &'static str },
    Length { found: usize, wanted: String },
    Said(String),
}

impl Wrong {
    fn within(mut self, name: impl ToString) -> Wrong {
        self.way.push(name.to_string());
        self
    }

    fn told(&self) -> String {
        let below = |name: &str| {
            let way = self.way.iter().rev().map(String::as_str);
            way.chain((!name.is_empty()).then_some(name)).collect::<Vec<_>>().join(".")
        };
        let way = below("");
        match &self.what {
            What::Name { unknown, known } => {
                let name = quoted(&below(unknown));
                match nearest(unknown, known) {
                    Some(meant) => {
                        let meant = quoted(&below(meant));
                        format!("there is no number {name}: the nearest one is {meant}")
                    }
                    None => format!("there is no number {name}: there are {}", known.join(", ")),
                }
            }
            What::Kind { unknown, known } => {
                let (unknown, known) = (quoted(unknown), known.join(", "));
                format!("{way} is {unknown}: it must be one of {known}")
            }
            What::Missing(name) => format!("{} is missing", below(name)),
            What::Value { found, wanted } if way.is_empty() => {
                format!("the whole is {found}: it must be {wanted}")
            }
            What::Value { found, wanted } => format!("{way} is {found}: it must be {wanted}"),
            What::Length { found, wanted } => {
                format!("{way} has {found} numbers: it must have {wanted}")
            }
            What::Said(said) => said.clone(),
        }
    }
}

/// The name that was meant, if one is not too far away.
fn nearest<'a>(name: &str, known: &[&'a str]) -> Option<&'a str> {
    let far = |other: &str| steps(name, other);
    let meant = known.iter().min_by_key(|other| far(other))?;
    // Fewer than one letter of three may be another, and one of few.
    (3 * far(meant) < name.chars().count().max(4)).then_some(meant)
}

/// How many letters have to be put in, left out or changed to make one word of another (Levenshtein's distance).
fn steps(one: &str, other: &str) -> usize {
    let other: Vec<char> = other.chars().collect();
    let mut row: Vec<usize> = (0..=other.len()).collect();
    for (k, letter) in one.chars().enumerate() {
        let mut before = std::mem::replace(&mut row[0], k + 1);
        for (j, of_other) in other.iter().enumerate() {
            let changed = before + usize::from(letter != *of_other);
            before = row[j + 1];
            row[j + 1] = changed.min(before + 1).min(row[j] + 1);
        }
    }
    row[other.len()]
}

impl fmt::Display for Wrong {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.told())
    }
}

impl std::error::Error for Wrong {}

impl de::Error for Wrong {
    fn custom<T: fmt::Display>(said: T) -> Wrong {
        What::Said(said.to_string()).into()
    }

    fn invalid_type(found: Unexpected, wanted: &dyn Expected) -> Wrong {
        let found = match found {
            Unexpected::Bool(is) => is.to_string(),
            Unexpected::Unsigned(number) => number.to_string(),
            Unexpected::Signed(number) => number.to_string(),
            Unexpected::Float(number) => number.to_string(),
            Unexpected::Str(text) => quoted(text),
            Unexpected::Unit => "null".to_string(),
            Unexpected::Seq => "a list".to_string(),
            Unexpected::UnitVariant => "a name alone".to_string(),
            _ => "numbers with names".to_string(),
        };
        What::Value { found, wanted: kind(&wanted.to_string()) }.into()
    }

    fn invalid_value(found: Unexpected, wanted: &dyn Expected) -> Wrong {
        Wrong::invalid_type(found, wanted)
    }

    fn invalid_length(found: usize, wanted: &dyn Expected) -> Wrong {
        let wanted = wanted.to_string().chars().filter(char::is_ascii_digit).collect();
        What::Length { found, wanted }.into()
    }

    fn unknown_variant(unknown: &str, known: &'static [&'static str]) -> Wrong {
        What::Kind { unknown: unknown.to_string(), known }.into()
    }

    fn unknown_field(unknown: &str, known: &'static [&'static str]) -> Wrong {
        What::Name { unknown: unknown.to_string(), known }.into()
    }

    fn missing_field(name: &'static str) -> Wrong {
        What::Missing(name).into()
    }
}

impl From<What> for Wrong {
    fn from(what: What) -> Wrong {
        Wrong { way: Vec::new(), what }
    }
}

/// What serde wants, in the words of a visitor.
fn kind(wanted: &str) -> &'static str {
    let speaks_of = |word: &str| wanted.contains(word);
    match wanted {
        "u32" => "a whole number from 0 on",
        "f64" => "a number",
        "unit" => "null",
        _ if speaks_of("boolean") => "true or false",
        _ if speaks_of("string") => "a name",
        _ if speaks_of("variant") => "a name with its numbers",
        _ if speaks_of("struct") => "numbers with names",
        _ if speaks_of("sequence") || speaks_of("array") => "a list of numbers",
        _ => "a name, or a name with its numbers",
    }
}

/// A value at its place in the whole: errors within it are told with the way there.
#[derive(Clone, Copy)]
struct Place<'a>(&'a Value);

impl<'de> Deserializer<'de> for Place<'de> {
    type Error = Wrong;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Wrong> {
        match self.0 {
            Value::Null => visitor.visit_unit(),
            Value::Bool(is) => visitor.visit_bool(*is),
            Value::String(text) => visitor.visit_borrowed_str(text),
            Value::Array(items) => {
                let mut list = List { items, next: 0 };
                let made = visitor.visit_seq(&mut list)?;
                match list.next == items.len() {
                    true => Ok(made),
                    false => Err(de::Error::invalid_length(items.len(), &&*list.next.to_string())),
                }
            }
            Value::Object(fields) => {
                visitor.visit_map(Fields { fields: fields.iter(), value: None })
            }
            Value::Number(number) => match (number.as_u64(), number.as_i64()) {
                (Some(whole), _) => visitor.visit_u64(whole),
                (_, Some(whole)) => visitor.visit_i64(whole),
                _ => visitor.visit_f64(number.as_f64().unwrap_or(f64::NAN)),
            },
        }
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Wrong> {
        match self.0 {
            Value::Null => visitor.visit_none(),
            _ => visitor.visit_some(self),
        }
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        visitor: V,
    ) -> Result<V::Value, Wrong> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Wrong> {
        match self.0 {
            Value::String(name) => visitor.visit_enum(StrDeserializer::new(name)),
            Value::Object(fields) if fields.len() == 1 => {
                let fields = Fields { fields: fields.iter(), value: None };
                visitor.visit_enum(MapAccessDeserializer::new(fields))
            }
            _ => self.deserialize_any(visitor),
        }
    }

    serde::forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf unit unit_struct seq
        tuple tuple_struct map struct identifier ignored_any
    }
}

struct List<'a> {
    items: &'a [Value],
    next: usize,
}

impl<'de> de::SeqAccess<'de> for &mut List<'de> {
    type Error = Wrong;

    fn next_element_seed<T: DeserializeSeed<'de>>(
        &mut self,
        seed: T,
    ) -> Result<Option<T::Value>, Wrong> {
        let Some(item) = self.items.get(self.next) else { return Ok(None) };
        self.next += 1;
        let place = self.next - 1;
        seed.deserialize(Place(item)).map(Some).map_err(|wrong| wrong.within(place))
    }
}

struct Fields<'a> {
    fields: serde_json::map::Iter<'a>,
    value: Option<(&'a str, &'a Value)>,
}

impl<'de> de::MapAccess<'de> for Fields<'de> {
    type Error = Wrong;

    fn next_key_seed<K: DeserializeSeed<'de>>(
        &mut self,
        seed: K,
    ) -> Result<Option<K::Value>, Wrong> {
        let Some((name, value)) = self.fields.next() else { return Ok(None) };
        self.value = Some((name, value));
        seed.deserialize(StrDeserializer::new(name)).map(Some)
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, Wrong> {
        let (name, value) = self.value.take().expect("a value comes behind its name");
        seed.deserialize(Place(value)).map_err(|wrong| wrong.within(name))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::flower::FlowerNumbers;
    use crate::shapes::leaf::LeafNumbers;

    fn told<T: de::DeserializeOwned>(text: &str) -> String {
        read::<T>(text).err().map(|wrong| wrong.to_string()).unwrap_or_default()
    }

    #[test]
    fn names_that_are_not_known_are_told_with_the_nearest_one_or_all() {
        for (text, words) in [
            (r#"{"lobess": 5}"#, "there is no number \"lobess\": the nearest one is \"lobes\""),
            (r#"{"lobe-deg": 5}"#, "the nearest one is \"lobe_deg\""),
            (
                r#"{"border": {"toothed": {"tooth": 3}}}"#,
                "no number \"border.toothed.tooth\": there are tooth_deg",
            ),
            (r#"{"fine": {"clossed": true}}"#, "the nearest one is \"fine.closed\""),
            (
                r#"{"height": 5}"#,
                "there is no number \"height\": there are lobes, nodes, nodes_kept, ",
            ),
            (
                r#"{"border": "wavy"}"#,
                "border is \"wavy\": it must be one of polygon, smooth, toothed",
            ),
            (
                r#"{"border": "toothed"}"#,
                "border is a name alone: it must be a name with its numbers",
            ),
            (
                r#"{"length": {"cubic": 1}}"#,
                "length is \"cubic\": it must be one of constant, linear",
            ),
        ] {
            let told = told::<LeafNumbers>(text);
            assert!(told.contains(words), "{text}: {told}");
        }
        let told = told::<FlowerNumbers>(r#"{"petals": {"cross": [{"att": 1}]}}"#);
        assert_eq!(
            told,
            "there is no number \"petals.cross.0.att\": the nearest one is \"petals.cross.0.at\""
        );
    }

    #[test]
    fn values_of_another_kind_are_told_with_what_they_must_be() {
        for (text, words) in [
            ("", "it is no JSON: line 1, column 0 cannot be read"),
            (r#"{"nod_deg": 1e999}"#, "it is no JSON: line 1, column 1"),
            ("7", "the whole is 7: it must be numbers with names"),
            (r#"{"nod_deg": "low"}"#, "nod_deg is \"low\": it must be a number"),
            (r#"{"stamens": 3}"#, "stamens is 3: it must be numbers with names"),
            (r#"{"stamens": {"count": 2.5}}"#, "stamens.count is 2.5: it must be a whole number"),
            (r#"{"stamens": {"count": -1}}"#, "stamens.count is -1: it must be a whole number"),
            (r#"{"petals": {"vein_cm": 3}}"#, "petals.vein_cm is 3: it must be a list of numbers"),
            (r#"{"petals": {"vein_cm": [[1]]}}"#, "petals.vein_cm.0 has 1 numbers: it must have 2"),
            (r#"{"petals": {"vein_cm": [[1, 2, 3]]}}"#, "vein_cm.0 has 3 numbers: it must have 2"),
            (r#"{"petals": {"cross": [{"at": 1}]}}"#, "petals.cross.0.lift_cm is missing"),
            (r#"{"petals": {"arrangement": 3}}"#, "petals.arrangement is 3: it must be a name"),
        ] {
            let told = told::<FlowerNumbers>(text);
            assert!(told.contains(words), "{text}: {told}");
        }
    }

    #[test]
    fn steps_between_words_are_counted() {
        for (one, other, count) in [
            ("", "abc", 3),
            ("lobes", "lobes", 0),
            ("lobess", "lobes", 1),
            ("kitten", "sitting", 3),
        ] {
            assert_eq!((steps(one, other), steps(other, one)), (count, count));
        }
    }
}
