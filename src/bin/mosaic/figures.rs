//! `mosaic figures`: the pictures of the figures in numbers.

use super::Refusal;
use super::individuals;
use super::many;
use super::options::FigureOptions;
use super::table::Kind;
use clonal_mosaic::play::figures::{Figure, Picture, all};
use clonal_mosaic::surface::quoted;

pub fn figures(options: &FigureOptions) -> Result<(), Refusal> {
    let figures = chosen(&options.figures)?;
    many::print(Kind::Figures, &options.many, || Ok(individuals::subjects(&figures)))
}

/// The chapter of the thesis whose pictures are grown where no number is said: that of its Table 4.1.
const CHAPTER: &str = "4.";

/// The figures whose plants are all of the catalogue: a link of another one says a row of a table nothing.
fn of_catalogue() -> impl Iterator<Item = &'static Figure> {
    let is_known = |picture: &Picture| picture.unknown().is_none();
    all().iter().filter(move |figure| figure.pictures.iter().all(is_known))
}

/// The figures of these numbers; those of the chapter when there is none.
fn chosen(numbers: &[String]) -> Result<Vec<&'static Figure>, Refusal> {
    if numbers.is_empty() {
        return Ok(of_catalogue().filter(|figure| figure.number.starts_with(CHAPTER)).collect());
    }
    let mut chosen: Vec<&'static Figure> = Vec::new();
    for number in numbers {
        let figure = of_catalogue().find(|figure| figure.number == *number).ok_or_else(|| {
            let known: Vec<&str> = of_catalogue().map(|figure| figure.number).collect();
            format!("there is no figure {}: there are {}", quoted(number), known.join(", "))
        })?;
        if !chosen.contains(&figure) {
            chosen.push(figure);
        }
    }
    Ok(chosen)
}
