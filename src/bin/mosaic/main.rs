//! The playground's engine from a shell.

mod bench;
mod figures;
mod grow;
mod options;
mod report;
mod states;
mod subject;
mod sweep;
mod table;

use options::Command;
use std::io::{self, Write};
use std::process::ExitCode;

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
        Command::Grow(options) => grow::grow(&options),
        Command::Figures(options) => figures::figures(&options),
        Command::Bench { runs } => bench::bench(runs),
        Command::Help => say(options::HELP),
        Command::Version => say(concat!("mosaic ", env!("CARGO_PKG_VERSION"), "\n")),
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
