//! Gives page, worker and command line the number of their build, a hash of all sources, so that a
//! page never takes answers from a worker of another build out of a cache; and joins the shaders to
//! one text without comments and margins, which nobody is to download.

use std::hash::{DefaultHasher, Hasher};
use std::path::{Path, PathBuf};

fn main() {
    let mut files = Vec::new();
    for root in ["src", "meshes", "Cargo.lock"] {
        if Path::new(root).exists() {
            println!("cargo::rerun-if-changed={root}");
            list(Path::new(root), &mut files);
        }
    }
    files.sort();
    let mut hash = DefaultHasher::new();
    for file in files {
        hash.write(file.to_string_lossy().as_bytes());
        hash.write(&std::fs::read(&file).expect("a source file can be read"));
    }
    println!("cargo::rustc-env=MOSAIC_BUILD={:016x}", hash.finish());
    let out = std::env::var_os("OUT_DIR").expect("cargo says where to write");
    std::fs::write(Path::new(&out).join("shaders.wgsl"), shaders()).expect("a file can be written");
}

/// The shaders in the order in which they build on each other, without comments and margins.
fn shaders() -> String {
    let mut text = String::new();
    for name in ["scene", "mosaic", "diagram", "body", "ground"] {
        let file = format!("src/draw/shaders/{name}.wgsl");
        for line in std::fs::read_to_string(file).expect("a shader can be read").lines() {
            let code = line.split("//").next().unwrap_or_default().trim();
            if !code.is_empty() {
                text.push_str(&without_spaces(code));
                text.push('\n');
            }
        }
    }
    text
}

/// A line of code without the spaces that part no words; `- -` stays, which `--` is not.
fn without_spaces(code: &str) -> String {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let mut text = String::new();
    let mut characters = code.chars().peekable();
    while let Some(c) = characters.next() {
        let (before, after) = (text.chars().last(), characters.peek().copied());
        let parts = |a: char, b: char| is_word(a) && is_word(b) || a == b;
        if c != ' ' || before.zip(after).is_some_and(|(a, b)| parts(a, b)) {
            text.push(c);
        }
    }
    text
}

fn list(path: &Path, files: &mut Vec<PathBuf>) {
    if path.is_file() {
        files.push(path.to_path_buf());
        return;
    }
    for entry in std::fs::read_dir(path).expect("a source folder can be read") {
        list(&entry.expect("a source folder can be read").path(), files);
    }
}
