//! Many individuals: grown at once or in parts, and the table of all of them.

use super::individuals::{self, HEADING, Row, Subject};
use super::options::ManyOptions;
use super::output::{cannot, say};
use super::progress::Progress;
use super::table::{Kind, Table};
use super::{Refusal, cores};
use std::fs;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Prints the table of all individuals of some subjects, or the rows of one part of them, or merges such
/// rows.
pub fn print(
    kind: Kind,
    options: &ManyOptions,
    subjects: impl FnOnce() -> Result<Vec<Subject>, Refusal>,
) -> Result<(), Refusal> {
    let format = options.print.format();
    if !options.merge.is_empty() {
        let mut rows = Vec::new();
        for path in &options.merge {
            rows.extend(read(path)?);
        }
        return say(&Table::of(rows, kind)?.print(format));
    }
    let subjects = subjects()?;
    let Some(shard) = options.print.shard else {
        return say(&Table::of(grow(&subjects, options, (1, 1))?, kind)?.print(format));
    };
    let rows = grow(&subjects, options, shard)?;
    let lines = rows.iter().map(|row| row.to_csv() + "\n");
    say(&(format!("{HEADING}\n") + &lines.collect::<String>()))
}

/// Grows one of so many parts of the work and tells how far it is.
fn grow(
    subjects: &[Subject],
    options: &ManyOptions,
    shard: (u32, u32),
) -> Result<Vec<Row>, Refusal> {
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
    individuals::grow(subjects, options.individuals, shard, threads, tell)
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
