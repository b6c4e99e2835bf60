//! `mosaic figures`: the pictures of the thesis in numbers.

use super::Refusal;
use super::individuals;
use super::many;
use super::options::FigureOptions;
use super::table::Kind;
use clonal_mosaic::play::figures::{FIGURES, Figure, find};
use clonal_mosaic::surface::quoted;

pub fn figures(options: &FigureOptions) -> Result<(), Refusal> {
    let figures = chosen(&options.figures)?;
    many::print(Kind::Figures, &options.many, || Ok(individuals::subjects(&figures)))
}

/// The figures of these numbers; all when there is none.
fn chosen(numbers: &[String]) -> Result<Vec<&'static Figure>, Refusal> {
    if numbers.is_empty() {
        return Ok(FIGURES.iter().collect());
    }
    let mut chosen: Vec<&'static Figure> = Vec::new();
    for number in numbers {
        let figure = find(number).ok_or_else(|| {
            let known: Vec<&str> = FIGURES.iter().map(|figure| figure.number).collect();
            format!("there is no figure {}: there are {}", quoted(number), known.join(", "))
        })?;
        if !chosen.contains(&figure) {
            chosen.push(figure);
        }
    }
    Ok(chosen)
}
