//! A map over two numbers: a series in whose link two words have several values, `df=4,6,8&pf=0.1,0.2`. From
//! picture to picture the first of them changes first, so that it runs across, and the second one down.

use super::Scene;
use super::parameters::Parameter;
use crate::surface::{holds, limited};

/// A number of a series, and its values.
#[derive(Clone)]
pub struct Axis {
    pub number: &'static Parameter,
    pub values: Vec<f64>,
}

#[derive(Clone)]
pub struct Atlas {
    /// The link without the two words.
    rest: String,
    /// Across and down.
    pub axes: [Axis; 2],
}

impl Atlas {
    /// The map that a link stands for; None if anything but two numbers has several values.
    pub fn read(link: &str) -> Option<Atlas> {
        let (plant, query) = link.split_once('?')?;
        let (mut rest, mut axes) = (Vec::new(), Vec::new());
        for word in query.split('&') {
            match word.split_once('=') {
                Some((key, values)) if key != "view" && values.contains(',') => {
                    let number = Parameter::of_key(key).filter(|number| number.is_number())?;
                    let values = values.split(',').map(|value| number.read(value).ok());
                    axes.push(Axis { number, values: values.collect::<Option<_>>()? });
                }
                Some((key, range)) if key != "view" && holds(range, "..") => return None,
                _ => rest.push(word),
            }
        }
        let rest = format!("{plant}?{}", rest.join("&"));
        Some(Atlas { rest, axes: axes.try_into().ok()? })
    }

    /// Its link.
    pub fn write(&self) -> String {
        let word = |axis: &Axis| {
            let values = axis.values.iter().map(|&value| axis.number.written(value));
            format!("&{}={}", axis.number.key, values.collect::<Vec<_>>().join(","))
        };
        self.axes.iter().fold(self.rest.clone(), |link, axis| link + &word(axis))
    }

    /// The map around the numbers of a scene, so many times as wide, as far as the numbers' ranges go. A number
    /// that has no values between stays as it is.
    pub fn around(&self, scene: &Scene, times: f64) -> Atlas {
        let axes = self.axes.clone().map(|axis| {
            let Axis { number, values } = &axis;
            let [least, greatest] = number.range;
            let (low, high) = ends(values);
            let width = ((high - low) * times).min(greatest - least);
            let from = number.get(scene) - 0.5 * width;
            let from = limited(from, least, greatest - width);
            let values = values_between(number, from, from + width, values.len());
            if values.len() < 2 { axis } else { Axis { number: axis.number, values } }
        });
        Atlas { rest: self.rest.clone(), axes }
    }
}

fn ends(values: &[f64]) -> (f64, f64) {
    let start = (f64::INFINITY, f64::NEG_INFINITY);
    values.iter().fold(start, |(low, high), &value| (low.min(value), high.max(value)))
}

/// Values of a number in even steps, each once.
pub fn values_between(number: &Parameter, from: f64, to: f64, count: usize) -> Vec<f64> {
    let value = |k: usize| from + (to - from) * k as f64 / (count.max(2) - 1) as f64;
    let mut values: Vec<f64> = (0..count).map(|k| rounded(number, value(k))).collect();
    values.dedup();
    values
}

/// A value as it would be typed: in whole numbers where no others are, else with four decimals at most.
pub fn rounded(number: &Parameter, value: f64) -> f64 {
    if number.is_whole() { value.round() } else { (value * 1e4).round() / 1e4 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants;
    use crate::play::link;

    const LINK: &str = "cactus?v=1&s=2&d=9&view=10,20,1.5&pf=0.1,0.3,0.5&n=400,600,800,1000";

    #[test]
    fn a_link_with_two_numbers_of_several_values_is_a_map() {
        let atlas = Atlas::read(LINK).unwrap();
        let [across, down] = &atlas.axes;
        assert_eq!((across.number.key, &across.values[..]), ("pf", &[0.1, 0.3, 0.5][..]));
        assert_eq!((down.number.key, down.values.len()), ("n", 4));
        assert_eq!(atlas.write(), LINK);
        for other in [
            "cactus?v=1&pf=0.1,0.3",
            "cactus?v=1&pf=0.1,0.3&n=400,600&df=4,5",
            "cactus?v=1&pf=0.1,0.3&n=400,600&s=1..3",
            "cactus?v=1&pf=0.1,0.3&cf=ff0000,00ff00",
            "cactus?v=1&pf=0.1,x&n=400,600",
            "cactus",
        ] {
            assert!(Atlas::read(other).is_none(), "{other}");
        }
    }

    #[test]
    fn closer_values_stand_around_those_of_a_picture_within_their_ranges() {
        let atlas = Atlas::read(LINK).unwrap();
        let scene = link::read("cactus?v=1&s=2&d=9&pf=0.3&n=600", plants::all()).scene;
        let near = atlas.around(&scene, 0.5);
        assert_eq!(near.axes[0].values, [0.2, 0.3, 0.4]);
        assert_eq!(near.axes[1].values, [450.0, 550.0, 650.0, 750.0]);
        assert!(near.write().ends_with("&pf=0.2,0.3,0.4&n=450,550,650,750"), "{}", near.write());
        // Chances end at 0 and 1.
        let scene = link::read("cactus?v=1&s=2&d=9&pf=0.1&n=600", plants::all()).scene;
        assert_eq!(atlas.around(&scene, 1.0).axes[0].values, [0.0, 0.2, 0.4]);
        assert_eq!(atlas.around(&scene, 9.0).axes[0].values, [0.0, 0.5, 1.0]);
        // Between whole numbers there is nothing at last.
        let mut atlas = atlas;
        for _ in 0..20 {
            atlas = atlas.around(&scene, 0.5);
        }
        assert!(atlas.axes.iter().all(|axis| axis.values.len() >= 2));
    }
}
