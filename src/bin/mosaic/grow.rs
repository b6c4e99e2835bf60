//! `mosaic grow`: grows a plant and tells each of its days.

use super::options::GrowOptions;
use super::report::{DayLine, Report};
use super::subject::{self, Subject};
use super::{Refusal, cannot, say};
use clonal_mosaic::export::write_cells;
use clonal_mosaic::tissue::{Diary, Growth, Progress};
use glam::DVec3;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::time::{Duration, Instant};

pub fn grow(options: &GrowOptions) -> Result<(), Refusal> {
    let subject = subject::load(options)?;
    // Opened first: nobody should wait for a plant that cannot be written down.
    let mut table = match &options.cells {
        Some(path) => Some((path, File::create(path).map_err(|e| cannot("write", path, &e))?)),
        None => None,
    };

    let mut report = Report::new(&subject);
    if subject.reading.is_some() && !options.json {
        say(&report.body.to_string())?;
    }
    for warning in report.body.warnings() {
        eprintln!("mosaic: {warning}");
    }
    let started = Instant::now();
    let max_cells = subject.recipe.max_cells;
    let mut growth = subject.sow()?;
    let mut growing = started.elapsed();
    loop {
        let (progress, time) = next_day(&mut growth);
        growing += time;
        match progress {
            Progress::Day(day) => {
                let painted = paint(&subject, &growth.diary, day as usize);
                let line = DayLine::of(painted.as_ref().unwrap_or(&growth.diary), day);
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
    report.body.caught_walks = growth.caught_walks();
    if let Some(warning) = report.body.warning_of_growth() {
        eprintln!("mosaic: {warning}");
    }

    if let Some((path, file)) = &mut table {
        let mut out = BufWriter::new(file);
        let last = growth.diary.days.len() - 1;
        let painted = paint(&subject, &growth.diary, last);
        let origin = subject.reading.map_or(DVec3::ZERO, |reading| reading.origin);
        let diary = painted.as_ref().unwrap_or(&growth.diary);
        write_cells(&subject.mesh, origin, diary, last, &mut out)
            .and_then(|()| out.flush())
            .map_err(|e| cannot("write", path, &e))?;
    }
    if options.json { say(&report.to_json()) } else { say(&report.summary()) }
}

/// A day in the types of the subject's noise, if it has one.
fn paint(subject: &Subject, diary: &Diary, day: usize) -> Option<Diary> {
    subject.noise.as_ref().map(|noise| noise.paint(&subject.mesh, diary, day))
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
