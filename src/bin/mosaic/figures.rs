//! `mosaic figures`: the pictures of the thesis in numbers.

use super::options::{FigureOptions, Format, Print};
use super::sweep::{self, HEADING, Row};
use super::table::Table;
use super::{Refusal, cannot, say};
use clonal_mosaic::play::figures::{FIGURES, Figure, find};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::available_parallelism;

pub fn figures(options: &FigureOptions) -> Result<(), Refusal> {
    match options {
        FigureOptions::Merge { files, format } => merge(files, *format),
        FigureOptions::Grow { figures, individuals, threads, print } => {
            let cores = || available_parallelism().map_or(1, usize::from);
            let threads = threads.map_or_else(cores, |n| n as usize);
            grow(&chosen(figures)?, *individuals, threads, *print)
        }
    }
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
            format!("there is no figure {number:?}: there are {}", known.join(", "))
        })?;
        if !chosen.contains(&figure) {
            chosen.push(figure);
        }
    }
    Ok(chosen)
}

fn grow(
    figures: &[&'static Figure],
    individuals: u32,
    threads: usize,
    print: Print,
) -> Result<(), Refusal> {
    let subjects = sweep::subjects(figures);
    let part = match print {
        Print::Shard(k, n) => (k, n),
        Print::Table(_) => (1, 1),
    };
    let done = AtomicUsize::new(0);
    let tell = |row: &Row| {
        let done = done.fetch_add(1, Ordering::Relaxed) + 1;
        let of = row.items.saturating_sub(part.0 as usize - 1).div_ceil(part.1 as usize);
        eprintln!(
            "mosaic: {done} of {of}: {}, {}, individual {}: {} cells",
            row.figure,
            row.picture,
            row.individual,
            row.cells()
        );
    };
    let rows = sweep::grow(&subjects, individuals, part, threads, tell);
    match print {
        Print::Table(format) => say(&Table::of(rows)?.print(format)),
        Print::Shard(..) => {
            let lines = rows.iter().map(|row| row.to_csv() + "\n");
            say(&(format!("{HEADING}\n") + &lines.collect::<String>()))
        }
    }
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
