//! Numbers in a few words, as links have them: what differs from the usual ones, `lobes:7,border:smooth`. What lies
//! within something is named by its way, `border.toothed.tooth_deg:12`; numbers of a list stand with `_` between
//! them, lists with `;`.

use super::ShapeError;
use crate::surface::quoted;
use serde_json::{Map, Value};

/// What differs from the usual numbers, in the order of their names.
pub(super) fn written(value: &Value, usual: &Value) -> String {
    let mut words = Vec::new();
    push("", value, Some(usual), &mut words);
    words.join(",")
}

/// The usual numbers, with what the words say in their places.
pub(super) fn read(text: &str, usual: Value) -> Result<Value, ShapeError> {
    let (mut all, mut begun) = (usual, Vec::new());
    for word in text.split(',').filter(|word| !word.is_empty()) {
        let Some((way, value)) = word.split_once(':') else {
            return Err(ShapeError(format!("{} has no colon in it", quoted(word))));
        };
        set(&mut all, way, of_word(value), &mut begun);
    }
    Ok(all)
}

fn push(way: &str, value: &Value, usual: Option<&Value>, words: &mut Vec<String>) {
    if usual == Some(value) {
        return;
    }
    let below = |name: &str| match way {
        "" => name.to_string(),
        _ => format!("{way}.{name}"),
    };
    match value {
        Value::Object(fields) => {
            let of_usual = usual.and_then(Value::as_object);
            // One of several kinds has another name in it.
            let of_usual = of_usual.filter(|usual| usual.keys().eq(fields.keys()));
            for (name, field) in fields {
                push(&below(name), field, of_usual.and_then(|usual| usual.get(name)), words);
            }
        }
        Value::Array(items) if items.iter().any(Value::is_object) => {
            for (k, item) in items.iter().enumerate() {
                push(&below(&k.to_string()), item, None, words);
            }
        }
        _ => words.push(format!("{way}:{}", word(value))),
    }
}

/// A number, a name or a list as a word.
fn word(value: &Value) -> String {
    let joined = |items: &[Value], between: &str| {
        let mut text = items.iter().map(word).collect::<Vec<_>>().join(between);
        if items.len() == 1 {
            text += between;
        }
        text
    };
    match value {
        Value::Null => "none".into(),
        Value::String(name) => name.replace(',', "+"),
        // Whole numbers need no point.
        Value::Number(number)
            if number.as_f64().is_some_and(|x| x == x.trunc() && x.abs() < 1e9) =>
        {
            format!("{}", number.as_f64().unwrap_or_default() + 0.0)
        }
        Value::Array(items) if items.is_empty() => "empty".into(),
        Value::Array(items) if items[0].is_array() => joined(items, ";"),
        Value::Array(items) => joined(items, "_"),
        other => other.to_string(),
    }
}

fn of_word(word: &str) -> Value {
    let list = |text: &str, between: char| -> Vec<Value> {
        text.split_terminator(between).map(of_word).collect()
    };
    match word {
        "none" => Value::Null,
        "true" => true.into(),
        "false" => false.into(),
        "empty" => Value::Array(Vec::new()),
        _ if word.contains(';') => list(word, ';').into(),
        _ if word.contains('_') && word.starts_with(|c: char| c == '-' || c.is_ascii_digit()) => {
            list(word, '_').into()
        }
        _ => match (word.parse::<i64>(), word.parse::<f64>()) {
            (Ok(whole), _) => whole.into(),
            (_, Ok(number)) if number.is_finite() => number.into(),
            _ => word.replace('+', ",").into(),
        },
    }
}

/// Puts a value where its way leads; what is wrong about the way is told by who reads the numbers.
fn set(all: &mut Value, way: &str, value: Value, begun: &mut Vec<String>) {
    let mut at = all;
    let mut so_far = String::new();
    for name in way.split('.') {
        let place = name.parse::<usize>().ok();
        if let Some(place) = place.filter(|_| !at.is_object()) {
            // A list with things in it is told as a whole.
            if !begun.contains(&so_far) {
                begun.push(so_far.clone());
                *at = Value::Array(Vec::new());
            }
            let Value::Array(items) = at else { return };
            if place >= items.len() {
                items.push(Value::Null);
            }
            let last = items.len() - 1;
            at = &mut items[place.min(last)];
        } else {
            if !at.is_object() {
                *at = Value::Object(Map::new());
            }
            let Value::Object(fields) = at else { return };
            if fields.len() == 1 && !fields.contains_key(name) && !begun.contains(&so_far) {
                fields.clear();
            }
            begun.push(so_far.clone());
            at = fields.entry(name).or_insert(Value::Null);
        }
        so_far += name;
        so_far.push('.');
    }
    *at = value;
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn what_differs_is_written_and_read_back() {
        let usual = json!({
            "lobes": 5, "size": 0.7, "border": {"toothed": {"deg": 22.0}}, "fine": null,
            "matrix": "river", "cross": [{"at": 0.5, "line": [[0.0, 1.0], [1.0, 2.0]]}],
        });
        let law = json!({"a": 0.1, "b": -1e-7});
        for (changed, text) in [
            (json!({}), ""),
            (json!({"lobes": 7}), "lobes:7"),
            (json!({"border": "smooth", "size": 1.0}), "border:smooth,size:1"),
            (json!({"border": {"toothed": {"deg": -3.5}}}), "border.toothed.deg:-3.5"),
            (json!({"border": {"law": law}}), "border.law.a:0.1,border.law.b:-1e-7"),
            (json!({"fine": {"closed": true}}), "fine.closed:true"),
            (json!({"matrix": "tokunaga:1,2"}), "matrix:tokunaga:1+2"),
            (json!({"matrix": [[0.5, 0.5]]}), "matrix:0.5_0.5;"),
            (json!({"matrix": [[0.5, 0.5], [0.0, 0.1, 0.9]]}), "matrix:0.5_0.5;0_0.1_0.9"),
            (json!({"matrix": {"whorls": [6]}}), "matrix.whorls:6_"),
            (json!({"cross": []}), "cross:empty"),
            (
                json!({"cross": [{"at": 0.1, "line": [[0.0, 1.0]]}, {"at": 0.9, "line": []}]}),
                "cross.0.at:0.1,cross.0.line:0_1;,cross.1.at:0.9,cross.1.line:empty",
            ),
        ] {
            let mut value = usual.clone();
            for (name, field) in changed.as_object().unwrap() {
                value[name] = field.clone();
            }
            assert_eq!(written(&value, &usual), text);
            let read = read(text, usual.clone()).unwrap();
            assert_eq!(written(&read, &usual), text);
            assert_eq!(read.to_string().replace(".0", ""), value.to_string().replace(".0", ""));
        }
        let wrong = read("lobes", usual).unwrap_err();
        assert_eq!(wrong.to_string(), "\"lobes\" has no colon in it");
    }
}
