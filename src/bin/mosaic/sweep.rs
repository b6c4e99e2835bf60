//! `mosaic sweep`: a plant with some of its numbers varied.

use super::individuals::Subject;
use super::many;
use super::options::{Format, SweepOptions};
use super::output::say;
use super::subject;
use super::table::Kind;
use super::{Refusal, memory};
use clonal_mosaic::play::parameters::{PARAMETERS, Parameter};
use clonal_mosaic::play::series::MOST_PICTURES;
use clonal_mosaic::play::{Scene, link};
use clonal_mosaic::surface::quoted;
use std::sync::Arc;

/// Values of a number when it is not said how many.
const VALUES: usize = 5;

/// Combinations at most: more is a typing error.
const MOST_COMBINATIONS: usize = 100_000;

/// A number of a plant and the values that it takes.
struct Varied {
    parameter: &'static Parameter,
    values: Vec<f64>,
}

pub fn sweep(options: &SweepOptions) -> Result<(), Refusal> {
    many::print(Kind::Sweep, &options.many, || subjects(options))?;
    let many = &options.many;
    let is_table = many.merge.is_empty() && many.print.shard.is_none();
    if !is_table || !matches!(many.print.format(), Format::Text) {
        return Ok(());
    }
    let scene = subject::scene(options.source(), options.day)?;
    match side_by_side(&scene, &varied(&options.vary)?) {
        Some(address) => say(&format!("\nSide by side in the playground: {address}\n")),
        None => Ok(()),
    }
}

/// What the page shows a picture of each combination by, two numbers as a map, if it shows so many.
fn side_by_side(scene: &Scene, all: &[Varied]) -> Option<String> {
    let pictures: usize = all.iter().map(|varied| varied.values.len()).product();
    if !(2..=MOST_PICTURES).contains(&pictures) {
        return None;
    }
    let link = link::write(scene);
    let varies = |word: &&str| all.iter().any(|v| word.split('=').next() == Some(v.parameter.key));
    let mut words: Vec<String> =
        link.split('&').filter(|word| !varies(word)).map(str::to_string).collect();
    for Varied { parameter, values } in all {
        let values: Vec<String> = values.iter().map(|&value| parameter.written(value)).collect();
        words.push(format!("{}={}", parameter.key, values.join(",")));
    }
    Some(format!("steps/{}", words.join("&")))
}

/// A subject for each combination, the last number varying first.
fn subjects(options: &SweepOptions) -> Result<Vec<Subject>, Refusal> {
    let scene = subject::scene(options.source(), options.day)?;
    let all = varied(&options.vary)?;
    let combinations = all
        .iter()
        .map(|varied| varied.values.len())
        .try_fold(1usize, |n, more| n.checked_mul(more).filter(|&n| n <= MOST_COMBINATIONS));
    let combinations = combinations
        .ok_or_else(|| format!("these are more than {MOST_COMBINATIONS} combinations of values"))?;
    let mesh = Arc::new(scene.plant.embedded_body().surface);
    (0..combinations)
        .map(|number| {
            let mut rest = number;
            let mut chosen: Vec<(&Parameter, f64)> = Vec::new();
            for Varied { parameter, values } in all.iter().rev() {
                chosen.push((parameter, values[rest % values.len()]));
                rest /= values.len();
            }
            chosen.reverse();
            let scene = with(&scene, &chosen)?;
            memory::check(&scene.recipe)?;
            let max_cells = scene.recipe.max_cells;
            let (figure, label) = (scene.plant.key.to_string(), label(&chosen));
            Ok(Subject { figure, label, scene, mesh: mesh.clone(), max_cells })
        })
        .collect()
}

/// What varies and how, `df=4 pf=0.2`.
fn label(chosen: &[(&Parameter, f64)]) -> String {
    let words = chosen.iter().map(|(parameter, value)| format!("{}={value}", parameter.key));
    words.collect::<Vec<_>>().join(" ")
}

/// The scene with these numbers. Shares make room for each other: that would not be what was asked for.
fn with(scene: &Scene, chosen: &[(&Parameter, f64)]) -> Result<Scene, Refusal> {
    let day = scene.day;
    let mut scene = scene.clone();
    for (parameter, value) in chosen {
        let refuse = |why| format!("{}={value}: {why}", parameter.key);
        parameter.set(&mut scene, *value).map_err(refuse)?;
    }
    for (parameter, value) in chosen {
        let now = parameter.get(&scene);
        if (now - value).abs() > 1e-6 * value.abs().max(1.0) {
            return Err(format!("{}: {} would be {now}", label(chosen), parameter.key));
        }
    }
    if scene.day < day {
        return Err(format!("{}: growth ends at day {}", label(chosen), scene.recipe.days));
    }
    Ok(scene)
}

fn varied(options: &[String]) -> Result<Vec<Varied>, Refusal> {
    let mut all: Vec<Varied> = Vec::new();
    for text in options {
        let varied = Varied::read(text).map_err(|why| format!("--vary {}: {why}", quoted(text)))?;
        if all.iter().any(|other| other.parameter.key == varied.parameter.key) {
            return Err(format!("--vary {} comes twice", varied.parameter.key));
        }
        all.push(varied);
    }
    Ok(all)
}

impl Varied {
    /// Reads `df=4..12:5` or `df=4,6,12`.
    fn read(text: &str) -> Result<Varied, Refusal> {
        let (key, values) = text.split_once('=').ok_or("it says no values, as df=4..12:5 does")?;
        let parameter = Parameter::of_key(key).filter(|p| !p.is_colour).ok_or_else(|| {
            let numbers = PARAMETERS.iter().filter(|p| !p.is_colour);
            let known: Vec<&str> = numbers.map(|p| p.key).collect();
            format!("there is no number {}: there are {}", quoted(key), known.join(", "))
        })?;
        let values = match values.split_once("..") {
            Some((from, rest)) => {
                let (to, count) = match rest.split_once(':') {
                    Some((to, count)) => (to, count.parse().unwrap_or(0)),
                    None => (rest, VALUES),
                };
                if !(2..=MOST_COMBINATIONS).contains(&count) {
                    return Err(format!("it takes from 2 to {MOST_COMBINATIONS} values"));
                }
                even_steps(number(from)?, number(to)?, count, parameter.is_whole())
            }
            None => values.split(',').map(number).collect::<Result<_, _>>()?,
        };
        if let Some(k) = (1..values.len()).find(|&k| values[..k].contains(&values[k])) {
            return Err(format!("the value {} comes twice", values[k]));
        }
        Ok(Varied { parameter, values })
    }
}

/// Values from one to the other, without the dust that sums leave behind their last digit.
fn even_steps(from: f64, to: f64, count: usize, is_whole: bool) -> Vec<f64> {
    let step = (to - from) / (count - 1) as f64;
    let value = |k: usize| if k == count - 1 { to } else { from + step * k as f64 };
    let tidy = |x: f64| if is_whole { x.round() } else { (x * 1e6).round() / 1e6 };
    (0..count).map(|k| tidy(value(k))).collect()
}

fn number(text: &str) -> Result<f64, Refusal> {
    let number = text.parse().ok().filter(|x: &f64| x.is_finite());
    number.ok_or_else(|| format!("{} is no number", quoted(text)))
}
