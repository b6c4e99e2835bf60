//! `mosaic figures`: the pictures of the thesis in numbers.

use super::options::{FigureOptions, Format};
use super::output::{cannot, say};
use super::progress::Progress;
use super::sweep::{self, HEADING, Row};
use super::table::Table;
use super::{Refusal, cores};
use clonal_mosaic::play::figures::{FIGURES, Figure, find};
use clonal_mosaic::surface::quoted;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

pub fn figures(options: &FigureOptions) -> Result<(), Refusal> {
    let format = options.print.format();
    if !options.merge.is_empty() {
        return merge(&options.merge, format);
    }
    let figures = chosen(&options.figures)?;
    let Some(shard) = options.print.shard else {
        return say(&Table::of(grow(&figures, options, (1, 1)))?.print(format));
    };
    let rows = grow(&figures, options, shard);
    let lines = rows.iter().map(|row| row.to_csv() + "\n");
    say(&(format!("{HEADING}\n") + &lines.collect::<String>()))
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

/// Grows one of so many parts of the work and tells how far it is.
fn grow(figures: &[&'static Figure], options: &FigureOptions, shard: (u32, u32)) -> Vec<Row> {
    let threads = options.threads.map_or_else(cores, |n| n as usize);
    let (done, progress) = (AtomicUsize::new(0), Progress::new());
    let tell = |row: &Row| {
        let done = done.fetch_add(1, Ordering::Relaxed) + 1;
        let of = row.items.saturating_sub(shard.0 as usize - 1).div_ceil(shard.1 as usize);
        progress.tell(&format!(
            "{done} of {of}: {}, {}, individual {}: {} cells",
            row.figure,
            row.picture,
            row.individual,
            row.cells()
        ));
    };
    sweep::grow(&sweep::subjects(figures), options.individuals, shard, threads, tell)
}

fn merge(files: &[PathBuf], format: Format) -> Result<(), Refusal> {
    let mut rows = Vec::new();
    for path in files {
        rows.extend(read(path)?);
    }
    say(&Table::of(rows)?.print(format))
}

/// The rows of a file, which may be several shards on end.
fn read(path: &Path) -> Result<Vec<Row>, Refusal> {
    let text = fs::read_to_string(path).map_err(|e| cannot("read", path, &e))?;
    let lines = (1..).zip(text.lines()).filter(|(_, line)| !line.is_empty() && *line != HEADING);
    lines
        .map(|(number, line)| {
            Row::from_csv(line).map_err(|e| format!("{}, line {number}: {e}", path.display()))
        })
        .collect()
}
