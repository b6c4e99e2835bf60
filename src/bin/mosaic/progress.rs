//! How far long work has come: one line on the standard error that is written over, for people only.

use std::io::{self, IsTerminal, Stderr, Write};
use std::sync::Mutex;

/// The line; nothing where the standard error is no terminal.
pub struct Progress<W: Write = Stderr>(Option<Mutex<W>>);

impl Progress {
    /// Progress that is seen where somebody looks.
    pub fn new() -> Progress {
        Progress(io::stderr().is_terminal().then(|| Mutex::new(io::stderr())))
    }

    /// The same beside something that is printed line by line: on a terminal that shows it all.
    pub fn beside_lines() -> Progress {
        if io::stdout().is_terminal() { Progress(None) } else { Progress::new() }
    }
}

impl<W: Write> Progress<W> {
    /// Says how far it is. Any thread may.
    pub fn tell(&self, text: &str) {
        self.write(&format!("\r\x1b[K{text}"));
    }

    /// Takes the line away, before something else is printed.
    pub fn clear(&self) {
        self.write("\r\x1b[K");
    }

    fn write(&self, text: &str) {
        if let Some(Ok(mut out)) = self.0.as_ref().map(Mutex::lock) {
            // Who does not see it misses nothing.
            let _ = out.write_all(text.as_bytes()).and_then(|()| out.flush());
        }
    }
}

impl<W: Write> Drop for Progress<W> {
    fn drop(&mut self) {
        self.clear();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_written_over_and_taken_away() {
        let mut seen = Vec::new();
        let progress = Progress(Some(Mutex::new(&mut seen)));
        progress.tell("day 1 of 30");
        progress.tell("day 2 of 30");
        drop(progress);
        assert_eq!(seen, b"\r\x1b[Kday 1 of 30\r\x1b[Kday 2 of 30\r\x1b[K");
        Progress::<Vec<u8>>(None).tell("nobody looks");
    }
}
