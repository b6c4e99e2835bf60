//! Four plain sliders for who meets the model first: each moves a few numbers of the recipe together, around
//! those of the plant. Nothing but the recipe is kept, so that where a slider stands is read off it.

use super::Scene;
use super::parameters::{PARAMETERS, Parameter};
use crate::tissue::{Clock, Recipe, expected_cells, mix};

/// A slider from 0 to 100. At 50, or at 0 where it only adds, the plant has its own numbers.
pub struct Dial {
    pub key: &'static str,
    pub name: &'static str,
    /// What its ends are called.
    pub ends: [&'static str; 2],
    /// What it moves.
    moves: &'static [(&'static str, Law)],
}

/// How a number follows a slider.
#[derive(Clone, Copy)]
enum Law {
    /// Its own times so much at both ends.
    Times(f64, f64),
    /// A share: its odds times so much at both ends.
    Odds(f64, f64),
    /// From its own to 1.
    ToOne,
}

/// All of them.
pub const DIALS: [Dial; 4] = [
    Dial {
        key: "size",
        name: "Size of the patches",
        ends: ["small", "large"],
        moves: &[("rs", Law::Times(0.5, 2.0)), ("n", Law::Times(1.4, 0.4))],
    },
    Dial {
        key: "amount",
        name: "Amount of the first colour",
        ends: ["little", "much"],
        moves: &[("pf", Law::Odds(0.1, 10.0)), ("mbf", Law::Odds(0.1, 10.0))],
    },
    Dial {
        key: "speed",
        name: "Speed of growth",
        ends: ["slow", "fast"],
        moves: &[
            ("df", Law::Times(2.5, 0.75)),
            ("db", Law::Times(2.5, 0.75)),
            ("dm", Law::Times(2.5, 0.75)),
        ],
    },
    Dial {
        key: "ragged",
        name: "Raggedness of the edges",
        ends: ["clear", "ragged"],
        moves: &[("fb", Law::ToOne), ("fm", Law::ToOne), ("bm", Law::ToOne)],
    },
];

/// The last position of a slider.
pub const LAST: u32 = 100;

impl Dial {
    /// What it is called for a plant.
    pub fn label(&self, scene: &Scene) -> String {
        match self.key {
            "amount" => format!("Amount of {}", scene.plant.colour_names[0]),
            _ => self.name.to_string(),
        }
    }

    /// The numbers that it moves on a plant: a number that is 0 stays so whatever it is multiplied by.
    pub fn numbers(&self, scene: &Scene) -> impl Iterator<Item = &'static Parameter> {
        self.moved(scene).map(|(number, _)| number)
    }

    fn moved(&self, scene: &Scene) -> impl Iterator<Item = (&'static Parameter, Law)> {
        let plant = scene.plant;
        let known =
            self.moves.iter().filter_map(|&(key, law)| Some((Parameter::of_key(key)?, law)));
        known.filter(move |(number, law)| {
            number.is_for(plant) && (matches!(law, Law::ToOne) || number.preset(plant) != 0.0)
        })
    }

    /// Where it stands: where its numbers would be nearest to those of the scene.
    pub fn position(&self, scene: &Scene) -> u32 {
        let numbers: Vec<_> = self
            .moved(scene)
            .map(|(number, law)| (number, law, number.preset(scene.plant), number.get(scene)))
            .collect();
        let off = |position: u32| -> f64 {
            let each = numbers.iter().map(|&(number, law, own, now)| {
                (at(number, law, own, position) - now).abs() / own.max(1e-3)
            });
            each.sum()
        };
        // Of equals the one in the middle: there numbers are the plant's own.
        let nearest = (0..=LAST).min_by(|&a, &b| {
            let middle = |position: u32| position.abs_diff(LAST / 2);
            off(a).total_cmp(&off(b)).then(middle(a).cmp(&middle(b)))
        });
        nearest.unwrap_or_default()
    }

    /// The scene with the slider elsewhere.
    pub fn turned(&self, scene: &Scene, position: u32) -> Scene {
        let mut turned = scene.clone();
        for (number, law) in self.moved(scene) {
            let value = at(number, law, number.preset(scene.plant), position.min(LAST));
            // What cannot be grown stays as it was.
            let _ = number.set(&mut turned, value);
        }
        turned
    }

    /// Where it stands for the plant itself.
    pub fn own(&self, scene: &Scene) -> u32 {
        self.position(&Scene::preset(scene.plant, scene.individual))
    }
}

/// What a number is at a position.
fn at(number: &Parameter, law: Law, own: f64, position: u32) -> f64 {
    let way = f64::from(position) / f64::from(LAST);
    // From the one factor over 1 to the other.
    let times = |least: f64, most: f64| match way < 0.5 {
        true => libm::pow(least, 1.0 - 2.0 * way),
        false => libm::pow(most, 2.0 * way - 1.0),
    };
    let value = match law {
        _ if position == LAST / 2 && !matches!(law, Law::ToOne) => own,
        Law::Times(least, most) => own * times(least, most),
        // Of all there is no more.
        Law::Odds(..) if own >= 1.0 && way > 0.5 => own,
        Law::Odds(least, most) => {
            let share = own.min(0.98);
            let odds = share / (1.0 - share) * times(least, most);
            odds / (1.0 + odds)
        }
        Law::ToOne => own + (1.0 - own) * way,
    };
    let [least, greatest] = number.range;
    let value = if value == own { own } else { rounded(value) };
    let value = if number.is_whole() { value.round() } else { value };
    value.clamp(least, greatest)
}

/// A number of two digits, so that links stay short, but for shares near 1.
fn rounded(value: f64) -> f64 {
    if value <= 0.0 {
        return 0.0;
    }
    let tens = libm::pow(10.0, libm::floor(libm::log10(value)) - 1.0);
    let two_digits = (value / tens).round() * tens;
    // Without the digits that come from rounding.
    (two_digits * 1e6).round() / 1e6
}

/// A recipe for the plant that nobody has thought of: each slider somewhere, the adhesion within the colours a
/// little other than its own, and at times children that turn. The same chance makes the same recipe.
pub fn surprise(scene: &Scene, chance: u32) -> Scene {
    let mut state = u64::from(chance);
    let mut draw = |from: f64, to: f64| {
        state = mix(state);
        from + (to - from) * (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let mut made = scene.clone();
    // Sizes, days and looks are the visitor's; what the cells are like is drawn.
    for number in PARAMETERS.iter().filter(|number| number.regrows && number.key != "days") {
        let _ = number.set(&mut made, number.preset(scene.plant));
    }
    made.noise = false;
    for dial in &DIALS {
        let (from, to) = match dial.key {
            "size" => (5.0, 95.0),
            "speed" => (25.0, 60.0),
            "ragged" => (-40.0, 60.0),
            _ => (15.0, 95.0),
        };
        let position = draw(from, to).max(0.0).round() as u32;
        // Edges that are clear stay as clear as the plant has them.
        if dial.key != "ragged" || position > 0 {
            made = dial.turned(&made, position);
        }
    }
    for key in ["ff", "bb"] {
        let Some(number) = Parameter::of_key(key) else { continue };
        let value = (number.get(&made) + draw(-0.25, 0.25)).clamp(0.2, 0.95);
        let _ = number.set(&mut made, (value / number.step).round() * number.step);
    }
    for key in ["mfb", "mbf"] {
        let (happens, share) = (draw(0.0, 1.0), draw(0.005, 0.05));
        if let (true, Some(number)) = (happens < 0.25, Parameter::of_key(key)) {
            let _ = number.set(&mut made, rounded(share));
        }
    }
    // Slower where it would come to the plant's limit before its last day.
    let speed = &DIALS[2];
    let mut position = speed.position(&made);
    while cells(&made.recipe) > f64::from(made.recipe.max_cells) && position > 0 {
        position = position.saturating_sub(5);
        made = speed.turned(&made, position);
    }
    made
}

/// About how many cells there will be on the last day, as if no child turned.
fn cells(recipe: &Recipe) -> f64 {
    let n = f64::from(recipe.initial_cells);
    let first = recipe.initial_probability.map(|share| (n * share) as u32);
    let [f, b, m] = [0, 1, 2].map(|of| std::array::from_fn(|to| f64::from(u8::from(of == to))));
    let true_to_type = Recipe { mutation: [f, b, m], clock: Clock::Poisson, ..recipe.clone() };
    let expected = expected_cells(&true_to_type, &[], first, recipe.days as usize);
    expected.map_or(0.0, |expected| expected.mean)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants;
    use crate::play::link;

    fn presets() -> impl Iterator<Item = Scene> {
        plants::all().iter().map(|plant| Scene::preset(plant, 1))
    }

    #[test]
    fn a_plant_of_its_own_numbers_has_its_sliders_in_their_places() {
        for scene in presets() {
            for dial in &DIALS {
                let own = dial.own(&scene);
                assert!(dial.turned(&scene, own) == scene, "{} {}", scene.plant.key, dial.key);
                assert!(dial.numbers(&scene).count() > 0, "{} {}", scene.plant.key, dial.key);
                assert!(dial.key == "ragged" || own == 50, "{} {}", scene.plant.key, dial.key);
            }
        }
    }

    #[test]
    fn sliders_are_read_off_what_they_made_and_both_ends_differ() {
        for scene in presets() {
            for dial in &DIALS {
                let what = format!("{} {}", scene.plant.key, dial.key);
                let [low, high] = [0, LAST].map(|end| dial.turned(&scene, end));
                assert!(low != high, "{what}");
                for position in (0..=LAST).step_by(5) {
                    let turned = dial.turned(&scene, position);
                    let again = dial.turned(&turned, dial.position(&turned));
                    assert!(again == turned, "{what} {position}: {}", link::write(&turned));
                    assert_eq!(turned.recipe.check(), Ok(()), "{what} {position}");
                }
            }
        }
    }

    #[test]
    fn each_end_moves_what_it_says() {
        let croton = Scene::preset(&plants::all()[0], 1);
        let end = |key: &str, position| {
            let dial = DIALS.iter().find(|dial| dial.key == key).unwrap();
            link::write(&dial.turned(&croton, position))
        };
        for (key, low, high) in [
            ("size", "n=14000&rs=0.5", "n=4000&rs=2"),
            ("amount", "pf=0.023", "pf=0.7"),
            ("speed", "df=13&db=25", "df=3.8&db=7.5"),
            ("ragged", "d=8", "fb=1"),
        ] {
            assert!(end(key, 0).ends_with(low), "{}", end(key, 0));
            assert!(end(key, LAST).ends_with(high), "{}", end(key, LAST));
        }
    }

    #[test]
    fn a_surprise_is_sound_its_own_and_the_same_for_the_same_chance() {
        for scene in presets() {
            let made: Vec<String> =
                (0..40).map(|chance| link::write(&surprise(&scene, chance))).collect();
            assert_eq!(made[7], link::write(&surprise(&scene, 7)));
            for (k, text) in made.iter().enumerate() {
                let opened = link::read(text, plants::all());
                assert_eq!(opened.left_out, [""; 0], "{text}");
                assert_eq!(opened.scene.recipe.check(), Ok(()), "{text}");
                assert!(!made[..k].contains(text), "{text} twice");
                assert_eq!(opened.scene.day, scene.day);
                let most = f64::from(scene.recipe.max_cells);
                assert!(cells(&opened.scene.recipe) <= most, "{text}");
            }
            // What was drawn before leaves no trace.
            let twice = surprise(&surprise(&scene, 3), 4);
            assert!(twice == surprise(&scene, 4));
        }
    }
}
