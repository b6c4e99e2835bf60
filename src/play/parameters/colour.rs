//! The colours of the cells, as numbers among the others: `0xe8c83a` is said as `e8c83a`.

use super::table::NUMBER;
use super::{Needs, Parameter};
use crate::play::Scene;
use crate::tissue::CellType::{self, Background as B, Foreground as F, Middle as M};

/// White.
const GREATEST: u32 = 0xff_ffff;

const COLOUR: Parameter = Parameter {
    range: [0.0, GREATEST as f64],
    is_colour: true,
    effect: "What it is called here stays. A control image may tint it, where the plant has one.",
    regrows: false,
    ..NUMBER
};

pub const OF_F: Parameter = Parameter {
    key: "cf",
    label: "Colour of {F}",
    get: |s| get(s, F),
    set: |s, x| set(s, F, x),
    ..COLOUR
};

pub const OF_B: Parameter = Parameter {
    key: "cb",
    label: "Colour of {B}",
    get: |s| get(s, B),
    set: |s, x| set(s, B, x),
    ..COLOUR
};

pub const OF_M: Parameter = Parameter {
    key: "cm",
    label: "Colour of {M}",
    needs: Needs::Middle,
    get: |s| get(s, M),
    set: |s, x| set(s, M, x),
    ..COLOUR
};

fn get(scene: &Scene, kind: CellType) -> f64 {
    number_of(scene.look.cells[kind as usize])
}

/// The plant's own is kept as it is: it may lie between the colours that six digits say.
fn set(scene: &mut Scene, kind: CellType, number: f64) {
    let own = scene.plant.look.cells[kind as usize];
    let colour = if number == number_of(own) { own } else { colour_of(number) };
    scene.look.cells[kind as usize] = colour;
}

/// The number of a colour in sRGB, eight bits for each part.
pub fn number_of(colour: [f32; 3]) -> f64 {
    colour.iter().fold(0.0, |number, part| {
        256.0 * number + f64::from((part.clamp(0.0, 1.0) * 255.0).round())
    })
}

fn colour_of(number: f64) -> [f32; 3] {
    let [_, parts @ ..] = (number as u32).to_be_bytes();
    parts.map(|part| f32::from(part) / 255.0)
}

/// A colour as links say it.
pub fn written(number: f64) -> String {
    format!("{:06x}", number as u32)
}

/// Reads what `written` writes, with or without the `#` before it.
pub fn read(text: &str) -> Result<f64, String> {
    let digits = text.strip_prefix('#').unwrap_or(text);
    let are_digits = digits.len() == 6 && digits.bytes().all(|digit| digit.is_ascii_hexdigit());
    let number = u32::from_str_radix(digits, 16).ok().filter(|_| are_digits);
    number.map(f64::from).ok_or_else(|| "a colour is six digits from 0 to f".to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants;
    use crate::play::link;

    #[test]
    fn colours_of_all_plants_are_said_and_set() {
        for plant in plants::all() {
            for parameter in [OF_F, OF_B, OF_M].iter().filter(|p| p.is_for(plant)) {
                let preset = Scene::preset(plant, 1);
                let mut scene = preset.clone();
                parameter.set(&mut scene, f64::from(0x12_fe00)).unwrap();
                let link = link::write(&scene);
                assert!(link.ends_with(&format!("&{}=12fe00", parameter.key)), "{link}");
                let opened = link::read(&link, plants::all());
                assert_eq!(opened.left_out, [""; 0]);
                assert_eq!(opened.scene.look, scene.look);
                assert_eq!(opened.scene.recipe, preset.recipe, "colours are no matter to cells");
                assert!(opened.scene.grows_like(&preset));
                // And back, to the last bit.
                parameter.set(&mut scene, parameter.preset(plant)).unwrap();
                assert_eq!(scene.look, plant.look);
            }
        }
    }

    #[test]
    fn what_is_no_colour_is_told() {
        for text in ["", "fff", "12345", "1234567", "+12345", "gggggg", "1e4"] {
            let opened = link::read(&format!("croton?v=1&s=1&d=1&cf={text}"), plants::all());
            let why = format!("“cf={text}” was left out: a colour is six digits from 0 to f.");
            assert_eq!(opened.left_out, [why]);
        }
        let told = link::read("croton?v=1&cm=ffffff", plants::all()).left_out;
        assert_eq!(told, ["“cm=ffffff” was left out: this plant has no use for it."]);
        let hash = link::read("croton?v=1&s=1&d=1&cf=%23FF0080", plants::all());
        assert!(link::write(&hash.scene).ends_with("&cf=ff0080"), "{:?}", hash.left_out);
    }
}
