//! The playground's engine from a shell: grows a plant and tells each of its days.

mod options;
mod report;
mod subject;

use clonal_mosaic::export::write_cells;
use clonal_mosaic::tissue::{Growth, Progress};
use options::{Command, Options};
use report::{DayLine, Report};
use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::process::ExitCode;
use std::time::{Duration, Instant};

/// What is said, on one line, about input that cannot be used.
type Refusal = String;

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(refusal) => {
            eprintln!("mosaic: {}", refusal.replace('\n', " "));
            ExitCode::from(2)
        }
    }
}

fn run() -> Result<(), Refusal> {
    match options::read()? {
        Command::Grow(options) => grow(&options),
        Command::Help => say(options::HELP),
        Command::Version => say(concat!("mosaic ", env!("CARGO_PKG_VERSION"), "\n")),
    }
}

fn grow(options: &Options) -> Result<(), Refusal> {
    let subject = subject::load(options)?;
    // Opened first: nobody should wait for a plant that cannot be written down.
    let mut table = match &options.cells {
        Some(path) => Some((path, File::create(path).map_err(|e| cannot("write", path, &e))?)),
        None => None,
    };

    let started = Instant::now();
    let max_cells = subject.recipe.max_cells;
    let mut growth = subject.sow()?;
    let mut growing = started.elapsed();
    let mut report = Report::new(subject.plant.map(|plant| plant.key), subject.individual);
    loop {
        let (progress, time) = next_day(&mut growth);
        growing += time;
        match progress {
            Progress::Day(day) => {
                let line = DayLine::of(&growth.diary, day);
                if !options.json {
                    say(&line.to_string())?;
                }
                report.days.push(line);
            }
            Progress::Full => {
                eprintln!(
                    "mosaic: growth ends early, at the recipe's max_cells of {max_cells}; what \
                     has grown is kept"
                );
                break;
            }
            Progress::Event | Progress::Done => break,
        }
    }
    report.seconds = growing.as_secs_f64();

    if let Some((path, file)) = &mut table {
        let mut out = BufWriter::new(file);
        write_cells(&subject.mesh, &growth.diary, growth.diary.days.len() - 1, &mut out)
            .and_then(|()| out.flush())
            .map_err(|e| cannot("write", path, &e))?;
    }
    if options.json { say(&report.to_json()) } else { say(&report.summary()) }
}

/// Steps until a day is done or growth has ended, and how long that took.
fn next_day(growth: &mut Growth) -> (Progress, Duration) {
    let started = Instant::now();
    loop {
        let progress = growth.step();
        if progress != Progress::Event {
            return (progress, started.elapsed());
        }
    }
}

/// Prints to the standard output, which may be closed.
fn say(text: &str) -> Result<(), Refusal> {
    let mut out = io::stdout().lock();
    out.write_all(text.as_bytes())
        .and_then(|()| out.flush())
        .map_err(|e| format!("cannot write to the standard output: {e}"))
}

fn cannot(what: &str, path: &std::path::Path, error: &io::Error) -> Refusal {
    format!("cannot {what} {}: {error}", path.display())
}
