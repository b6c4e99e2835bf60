//! A body by its rule: of which kind it is, its numbers, and which individual.

use super::branching::{Tree, TreeNumbers, body};
use super::flower::{Flower, FlowerNumbers};
use super::leaf::{Leaf, LeafNumbers};
use super::wrong::within;
use super::{ShapeError, short};
use crate::surface::{Moment, PolygonMesh, quoted};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;
use std::ops::RangeInclusive;

/// A body that a rule makes of its numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Rule {
    pub numbers: Numbers,
    /// Another one of the same numbers.
    pub individual: u32,
}

/// The numbers of a body of each kind.
#[derive(Clone, Debug, PartialEq)]
pub enum Numbers {
    Leaf(LeafNumbers),
    Tree(TreeNumbers),
    Flower(Box<FlowerNumbers>),
}

/// The words before the individual, and before how much larger than its numbers a leaf is.
const INDIVIDUAL: &str = "individual:";
const SIZE: &str = "size:";
/// 1 is as the numbers say.
const SIZES: RangeInclusive<f64> = 0.1..=10.0;

impl Rule {
    /// Reads what links have: the kind, `leaf`, `tree` or `flower`, and what differs from its usual numbers and its
    /// first individual, as `lobes:7,border:smooth,individual:3`. A leaf may have `size:2`, which makes it twice as
    /// large.
    ///
    /// # Errors
    /// Words of another kind, and numbers out of their ranges.
    pub fn of_words(kind: &str, words: &str) -> Result<Rule, ShapeError> {
        let (mut rest, mut individual, mut size) = (Vec::new(), 1, 1.0);
        for word in words.split(',') {
            if let Some(number) = word.strip_prefix(INDIVIDUAL) {
                individual = number.parse().map_err(|_| {
                    let most = u32::MAX;
                    ShapeError(format!(
                        "individual is {number}: it must be a whole number from 0 to {most}"
                    ))
                })?;
            } else if let Some(number) = word.strip_prefix(SIZE).filter(|_| kind == "leaf") {
                size = number.parse().map_err(|_| {
                    ShapeError(format!("size is {}: it must be a number", quoted(number)))
                })?;
                within("size", size, &SIZES)?;
            } else {
                rest.push(word);
            }
        }
        let rest = rest.join(",");
        let numbers = match kind {
            "leaf" => {
                let numbers = read(&rest, LeafNumbers::from_json)?.scaled(size);
                numbers.check()?;
                Numbers::Leaf(numbers)
            }
            "tree" => Numbers::Tree(read(&rest, TreeNumbers::from_json)?),
            "flower" => Numbers::Flower(read(&rest, FlowerNumbers::from_json)?.into()),
            _ => return Err(ShapeError("a shape is a leaf, a tree or a flower".into())),
        };
        Ok(Rule { numbers, individual })
    }

    /// Reads a file of numbers, as `to_json` writes them, as those of the kind that has most of its names; of a text
    /// that has none of them nothing.
    ///
    /// # Errors
    /// Names of another kind, and numbers out of their ranges.
    pub fn of_json(text: &str) -> Option<Result<Rule, ShapeError>> {
        let told: Value = serde_json::from_str(text.trim_start_matches('\u{feff}')).ok()?;
        let told = told.as_object()?;
        let known = |usual: Value| told.keys().filter(|name| usual.get(name).is_some()).count();
        let leaf = known(json(&LeafNumbers::default()));
        let tree = known(json(&TreeNumbers::default()));
        let flower = known(json(&FlowerNumbers::default()));
        let numbers = match leaf.max(tree).max(flower) {
            0 => return None,
            most if most == leaf => LeafNumbers::from_json(text).map(Numbers::Leaf),
            most if most == tree => TreeNumbers::from_json(text).map(Numbers::Tree),
            _ => FlowerNumbers::from_json(text).map(|numbers| Numbers::Flower(numbers.into())),
        };
        Some(numbers.map(|numbers| Rule { numbers, individual: 1 }))
    }

    /// The kind as `of_words` reads it.
    pub fn kind(&self) -> &'static str {
        match self.numbers {
            Numbers::Leaf(_) => "leaf",
            Numbers::Tree(_) => "tree",
            Numbers::Flower(_) => "flower",
        }
    }

    /// The words that `of_words` reads.
    pub fn to_words(&self) -> String {
        let words = match &self.numbers {
            Numbers::Leaf(numbers) => written(numbers),
            Numbers::Tree(numbers) => written(numbers),
            Numbers::Flower(numbers) => written(&**numbers),
        };
        let individual = format!("{INDIVIDUAL}{}", self.individual);
        match (self.individual, &*words) {
            (1, _) => words,
            (_, "") => individual,
            _ => format!("{words},{individual}"),
        }
    }

    /// All numbers as the file that `mosaic shape --numbers` reads.
    pub fn to_json(&self) -> String {
        let json = match &self.numbers {
            Numbers::Leaf(numbers) => serde_json::to_string_pretty(numbers),
            Numbers::Tree(numbers) => serde_json::to_string_pretty(numbers),
            Numbers::Flower(numbers) => serde_json::to_string_pretty(numbers),
        };
        json.expect("numbers are JSON") + "\n"
    }

    /// The body in centimetres, as `mosaic shape --obj` writes it: of a flower from bud to open.
    ///
    /// # Errors
    /// Numbers that make none.
    pub fn mesh(&self) -> Result<PolygonMesh, ShapeError> {
        match &self.numbers {
            Numbers::Leaf(numbers) => Ok(Leaf::new(numbers, self.individual)?.mesh()),
            Numbers::Tree(numbers) => {
                numbers.check()?;
                let matrix = numbers.matrix.ramification()?;
                body(&Tree::draw(&matrix, numbers.order, self.individual)?, numbers)
            }
            Numbers::Flower(numbers) => {
                Ok(opening(&Flower::new(numbers, self.individual)?, numbers.open_day))
            }
        }
    }
}

/// Moments at least of a flower that opens.
const MOMENTS: f64 = 12.0;

/// A flower as it is open, with moments from the bud to there: on every whole day, between them if those are few, and
/// on the last one.
pub fn opening(flower: &Flower, open_day: f64) -> PolygonMesh {
    let a_day = (MOMENTS / open_day).ceil();
    let steps = (0..).map(|step| f64::from(step) / a_day).take_while(|&day| day < open_day);
    let moment = |day: f64| Moment { day: day as f32, positions: flower.at(day / open_day) };
    let moments = steps.chain([open_day]).map(moment).collect();
    PolygonMesh { positions: flower.at(1.0), moments, ..flower.mesh() }
}

fn read<T: Serialize + Default>(
    words: &str,
    parse: fn(&str) -> Result<T, ShapeError>,
) -> Result<T, ShapeError> {
    parse(&short::read(words, json(&T::default()))?.to_string())
}

fn written<T: Serialize + Default + DeserializeOwned>(numbers: &T) -> String {
    short::written(&json(numbers), &json(&T::default()))
}

fn json(numbers: &impl Serialize) -> Value {
    serde_json::to_value(numbers).expect("numbers are JSON")
}

#[cfg(test)]
mod tests {
    use super::super::flower::{Arrangement, CrossStroke};
    use super::*;

    #[test]
    fn words_are_read_back_as_they_were_written() {
        for (kind, words) in [
            ("leaf", ""),
            ("leaf", "border:polygon,lobes:7,individual:4294967295"),
            ("leaf", "individual:3"),
            (
                "leaf",
                "fine.closed:true,fine.exponent:3,fine.reach:0.5,fine.spacing_cm:0.4,fine.step:0.25,fine.tip_cm:0.01",
            ),
            ("leaf", "length.linear.a_cm:0.5,length.linear.b_cm:-0.1"),
            ("tree", "matrix:0.5_0.5;0.25_0.25_0.5,order:3"),
            ("tree", "matrix:tokunaga:1+2,order:5"),
            ("tree", "leaf_ends:0.5,leaf_hang:0"),
            (
                "flower",
                "sepals.count:5,sepals.lead:0.3,sepals.length:0.5,sepals.open_deg:40,sepals.width:0.9",
            ),
            ("flower", "growth:3,petals.open_cm:1_2;3_4.5;4_7,pistil:none"),
            (
                "flower",
                "petals.arrangement.spiral.count:17,petals.arrangement.spiral.divergence_deg:137.5",
            ),
        ] {
            let rule = Rule::of_words(kind, words).unwrap();
            assert_eq!(rule.to_words(), words);
        }
        let mut numbers = FlowerNumbers::default();
        numbers.petals.arrangement = Arrangement::Whorls(vec![5]);
        numbers.petals.cross =
            vec![CrossStroke { at: 0.25, lift_cm: vec![[-1.0, 0.5], [1.0, 0.1]] }];
        let rule = Rule { numbers: Numbers::Flower(numbers.into()), individual: 2 };
        assert_eq!(Rule::of_words("flower", &rule.to_words()), Ok(rule.clone()));
        let Numbers::Flower(numbers) = &rule.numbers else { unreachable!() };
        assert_eq!(FlowerNumbers::from_json(&rule.to_json()).as_ref(), Ok(&**numbers));
    }

    #[test]
    fn a_file_of_numbers_says_of_which_kind_it_is() {
        for (kind, words) in [
            ("leaf", "lobes:7,fine.closed:true"),
            ("leaf", ""),
            ("tree", "matrix:0.5_0.5;,order:2"),
            ("tree", "leaf.lobes:1,leaf.border:smooth"),
            ("flower", "pistil:none,sepals.count:5"),
        ] {
            let rule = Rule::of_words(kind, words).unwrap();
            assert_eq!(rule.kind(), kind);
            assert_eq!(Rule::of_json(&rule.to_json()), Some(Ok(rule.clone())));
            assert_eq!(Rule::of_words(kind, &rule.to_words()), Ok(rule));
        }
        for (text, kind) in [
            (r#"{"lobes": 3}"#, "leaf"),
            (r#"{"order": 3}"#, "tree"),
            (r#"{"nod_deg": 3}"#, "flower"),
        ] {
            assert_eq!(Rule::of_json(text).unwrap().unwrap().kind(), kind);
        }
        let told = Rule::of_json(r#"{"lobes": 3, "nods": 4}"#).unwrap().unwrap_err().to_string();
        assert_eq!(told, "there is no number \"nods\": the nearest one is \"nodes\"");
        for other in ["", "3", "{}", r#"{"days": 3, "initial_cells": 4}"#] {
            assert_eq!(Rule::of_json(other), None);
        }
    }

    #[test]
    fn a_leaf_of_twice_the_size_is_twice_as_wide() {
        let area = |words: &str| {
            let Numbers::Leaf(numbers) = Rule::of_words("leaf", words).unwrap().numbers else {
                unreachable!()
            };
            Leaf::new(&numbers, 1).unwrap().limb.area()
        };
        assert!((area("size:2") / area("") - 4.0).abs() < 1e-6);
        let words = Rule::of_words("leaf", "size:2,length.constant.b_cm:0.5").unwrap().to_words();
        assert!(words.contains("length.constant.b_cm:1,"), "{words}");
    }

    #[test]
    fn words_that_make_no_body_are_told() {
        for (kind, words, told) in [
            ("moss", "", "a leaf, a tree or a flower"),
            ("leaf", "lobes", "no colon"),
            ("leaf", "lobes:4", "odd number"),
            ("leaf", "lobes.more:4", "lobes is numbers with names: it must be a whole number"),
            ("leaf", "lobess:4", "there is no number \"lobess\": the nearest one is \"lobes\""),
            ("leaf", "individual:-1", "individual is -1"),
            ("leaf", "size:11", "size is 11"),
            ("leaf", "size:large", "size is \"large\": it must be a number"),
            ("leaf", "size:10,petiole_cm:20", "petiole_cm is 200"),
            ("tree", "order:13", "from 1 to 12"),
            ("flower", "petals.cross.0.at:0.5", "petals.cross.0.lift_cm is missing"),
            ("flower", "petals.open_cm:1_2", "petals.open_cm.0 is 1: it must be a list of numbers"),
        ] {
            let wrong = Rule::of_words(kind, words).unwrap_err().to_string();
            assert!(wrong.contains(told), "{words}: {wrong}");
        }
        let fern = Rule::of_words("tree", "matrix:moss").unwrap();
        assert!(fern.mesh().unwrap_err().to_string().contains("there is no matrix"));
    }
}
