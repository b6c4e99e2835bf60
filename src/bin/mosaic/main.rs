//! The playground's engine from a shell.

mod bench;
mod export;
mod figures;
mod fit;
mod grow;
mod individuals;
mod many;
mod memory;
mod options;
mod output;
mod progress;
mod report;
mod shape;
mod states;
mod subject;
mod sweep;
mod table;

use options::{Asked, Command};
use output::{say, warn};
use std::process::ExitCode;

/// What is said, on one line, about input that cannot be used.
type Refusal = String;

/// How many threads there is a core for.
fn cores() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

/// The exit status of all refusals.
const REFUSED: u8 = 2;

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(refusal) => {
            warn(&refusal);
            ExitCode::from(REFUSED)
        }
    }
}

fn run() -> Result<(), Refusal> {
    let command = match options::read()? {
        Asked::For(command) => command,
        Asked::Text(text) => return say(&text),
    };
    match *command {
        Command::Grow(options) => grow::grow(&options),
        Command::Figures(options) => figures::figures(&options),
        Command::Sweep(options) => sweep::sweep(&options),
        Command::Fit(options) => fit::fit(&options),
        Command::Shape(options) => shape::shape(&options),
        Command::Export(options) => export::export(&options),
        Command::Plant(options) => say(&(subject::plant(&options.name)?.to_json() + "\n")),
        Command::Bench(options) => bench::bench(options.runs),
    }
}
