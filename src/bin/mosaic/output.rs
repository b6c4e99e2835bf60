//! What comes out: text on the standard output, a line on the standard error, files.

use super::Refusal;
use std::fs::{self, File};
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::process;

/// Prints to the standard output. Where nobody reads on, as behind `| head`, the program ends: nothing
/// is wrong.
pub fn say(text: &str) -> Result<(), Refusal> {
    if try_say(text)? { Ok(()) } else { process::exit(0) }
}

/// Prints to the standard output, and returns whether somebody still reads.
pub fn try_say(text: &str) -> Result<bool, Refusal> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Ok(()) => Ok(true),
        Err(e) if e.kind() == ErrorKind::BrokenPipe => Ok(false),
        Err(e) => Err(format!("cannot write to the standard output: {e}")),
    }
}

/// Says something on one line of the standard error. Where that is closed, nobody is told.
pub fn warn(text: &str) {
    let line = text.replace(char::is_control, " ");
    let _ = writeln!(io::stderr(), "mosaic: {line}");
}

pub fn cannot(what: &str, path: &Path, error: &io::Error) -> Refusal {
    format!("cannot {what} {}: {error}", path.display())
}

/// A file that is written when all is done.
pub enum Target {
    /// Beside itself first and then renamed, so that a run that fails leaves the old file whole.
    Beside { path: PathBuf, beside: PathBuf },
    /// A device or a pipe.
    Open { path: PathBuf, file: File },
}

impl Target {
    /// Refuses what could not be written later: nobody should wait for that.
    pub fn new(path: &Path) -> Result<Target, Refusal> {
        Target::find(path).map_err(|e| cannot("write", path, &e))
    }

    fn find(path: &Path) -> io::Result<Target> {
        let there = fs::metadata(path);
        if path.starts_with("/dev") || there.as_ref().is_ok_and(|there| !there.is_file()) {
            let file = File::options().write(true).open(path)?;
            return Ok(Target::Open { path: path.to_path_buf(), file });
        }
        // The file itself and no link to it; one that may not be written to is not replaced either.
        let path = if there.is_ok() { fs::canonicalize(path)? } else { path.to_path_buf() };
        if there.is_ok() {
            File::options().append(true).open(&path)?;
        }
        let mut name = path.file_name().unwrap_or_default().to_os_string();
        name.push(format!(".{}.part", process::id()));
        let beside = path.with_file_name(name);
        File::create_new(&beside)?;
        fs::remove_file(&beside)?;
        Ok(Target::Beside { path, beside })
    }

    /// Whether it is no device or pipe.
    pub fn is_file(&self) -> bool {
        matches!(self, Target::Beside { .. })
    }

    /// Writes the file.
    pub fn write(
        self,
        content: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
    ) -> Result<(), Refusal> {
        let fill = |file| {
            let mut out = BufWriter::new(file);
            content(&mut out)?;
            out.flush()
        };
        match self {
            Target::Open { path, file } => fill(file).map_err(|e| cannot("write", &path, &e)),
            Target::Beside { path, beside } => {
                let written = File::create(&beside).and_then(fill);
                written.and_then(|()| replace(&path, &beside)).map_err(|e| {
                    let _ = fs::remove_file(&beside);
                    cannot("write", &path, &e)
                })
            }
        }
    }
}

/// Puts a file in the place of another, with the rights of that one.
fn replace(old: &Path, new: &Path) -> io::Result<()> {
    if let Ok(there) = fs::metadata(old) {
        fs::set_permissions(new, there.permissions())?;
    }
    fs::rename(new, old)
}
