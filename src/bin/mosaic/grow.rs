//! `mosaic grow`: grows a plant and tells each of its days.

use super::options::GrowOptions;
use super::output::{Target, say, try_say, warn};
use super::report::{DayLine, Report};
use super::subject::{self, Subject};
use super::{Refusal, cores, memory, progress};
use clonal_mosaic::export::write_cells;
use clonal_mosaic::tissue::{Diary, Growth, Progress};
use glam::DVec3;
use std::time::{Duration, Instant};

pub fn grow(options: &GrowOptions) -> Result<(), Refusal> {
    let subject = subject::load(options)?;
    memory::check(&subject.recipe)?;
    // Tried first: nobody should wait for a plant that cannot be written down.
    let table = options.cells.as_deref().map(Target::new).transpose()?;
    // Where nobody reads on, there is still the table to write.
    let print = |text: &str| if table.is_some() { try_say(text).map(drop) } else { say(text) };
    let seen =
        if options.json { progress::Progress::new() } else { progress::Progress::beside_lines() };

    let mut report = Report::new(&subject);
    if subject.reading.is_some() && !options.json {
        print(&report.body.to_string())?;
    }
    for warning in report.body.warnings() {
        warn(&warning);
    }
    let started = Instant::now();
    let max_cells = subject.recipe.max_cells;
    let threads = options.threads.map_or_else(cores, |threads| threads as usize);
    let mut growth = subject.sow()?.on_threads(threads);
    let mut growing = started.elapsed();
    loop {
        let (progress, time) = next_day(&mut growth);
        growing += time;
        match progress {
            Progress::Day(day) => {
                let painted = paint(&subject, &growth.diary, day as usize);
                let line = DayLine::of(painted.as_ref().unwrap_or(&growth.diary), day);
                seen.clear();
                if !options.json {
                    print(&line.to_string())?;
                }
                seen.tell(&format!("day {day} of {}", subject.recipe.days));
                report.days.push(line);
            }
            Progress::Full => {
                seen.clear();
                warn(&format!(
                    "growth ends early, at the recipe's max_cells of {max_cells}; what has grown is \
                     kept"
                ));
                break;
            }
            Progress::Event | Progress::Done => break,
        }
    }
    report.seconds = growing.as_secs_f64();
    drop(seen);
    report.body.caught_walks = growth.caught_walks();
    if let Some(warning) = report.body.warning_of_growth() {
        warn(&warning);
    }

    if let Some(table) = table {
        let last = growth.diary.days.len() - 1;
        let painted = paint(&subject, &growth.diary, last);
        let origin = subject.reading.map_or(DVec3::ZERO, |reading| reading.origin);
        let diary = painted.as_ref().unwrap_or(&growth.diary);
        table.write(|out| write_cells(&subject.mesh.on(last as u32), origin, diary, last, out))?;
    }
    say(&if options.json { report.to_json() } else { report.summary() })
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
