//! Gives page, worker and command line the number of their build, a hash of all sources, so that a
//! page never takes answers from a worker of another build out of a cache; and joins the shaders to
//! one text without comments, margins and long names, which nobody is to download; and takes out of the text of the
//! figures what the page is to know of them at once.

mod figures;
mod words;

use std::collections::{BTreeMap, BTreeSet};
use std::hash::{DefaultHasher, Hasher};
use std::path::{Path, PathBuf};

/// The text of the figures.
const FIGURES: &str = "www/figures.txt";

fn main() {
    let mut files = Vec::new();
    words::check();
    for root in ["src", "meshes", "Cargo.lock", "build", "www/index.html", FIGURES, "www/words"] {
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
    let write = |name: &str, text: String| {
        std::fs::write(Path::new(&out).join(name), text).expect("a file can be written");
    };
    write("shaders.wgsl", shaders());
    let of_figures = std::fs::read_to_string(FIGURES).expect("the figures can be read");
    write("changed.txt", figures::changed(&of_figures));
}

/// The shaders in the order in which they build on each other, without comments, margins and long names.
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
    with_short_names(&text)
}

/// Gives everything that the shaders declare a short name, the most frequent ones the shortest; but for
/// entry points, whose names the program knows, and names that the language has uses for as well.
fn with_short_names(text: &str) -> String {
    let words = words_of(text);
    let is_word = |word: &str| word.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    for word in words.iter().filter(|word| is_word(word)) {
        *counts.entry(word).or_default() += 1;
    }
    let (mut declared, mut kept) = (BTreeSet::new(), BTreeSet::new());
    for (k, &word) in words.iter().enumerate() {
        let before = |n: usize| k.checked_sub(n).map_or("", |k| words[k]);
        let after = words.get(k + 1).copied().unwrap_or_default();
        if ["fn", "let", "var", "const", "struct", ">"].contains(&before(2)) && before(1) == " "
            || after.starts_with(':') && !after.starts_with("::")
        {
            declared.insert(word);
        }
        let is_ours = ["fn", "struct"].iter().any(|kind| {
            [format!("{kind} {word}("), format!("{kind} {word}{{")].iter().any(|d| text.contains(d))
        });
        // What is called and not ours is of the language, as `position` is in `@builtin(position)`.
        let is_builtin = after.starts_with('(') && !is_ours
            || before(2) == "builtin" && before(1).ends_with('(');
        let is_entry = word.starts_with("vs_") || word.starts_with("fs_");
        // Swizzles too.
        if is_builtin || is_entry || word.len() < 3 || ["xyz", "rgb"].contains(&word) {
            kept.insert(word);
        }
    }
    let mut names: Vec<&str> = declared.difference(&kept).copied().filter(|w| is_word(w)).collect();
    names.sort_by_key(|name| std::cmp::Reverse(counts[name]));
    let letters = || ('a'..='z').chain('A'..='Z').map(String::from);
    let longer = letters().flat_map(|a| letters().map(move |b| format!("{a}{b}")));
    let free = letters().chain(longer).filter(|name| {
        !counts.contains_key(name.as_str())
            && !["as", "do", "if", "in", "of", "or"].contains(&&**name)
    });
    let short: BTreeMap<&str, String> = names.into_iter().zip(free).collect();
    words.iter().map(|&word| short.get(word).map_or(word, String::as_str)).collect()
}

/// A text cut into words and what stands between them.
fn words_of(text: &str) -> Vec<&str> {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let mut words = Vec::new();
    let mut from = 0;
    for (at, c) in text.char_indices() {
        let before = text[..at].chars().next_back();
        // A number's point and its letters are of it: 1.5f.
        if before.is_some_and(|before| is_word(before) != is_word(c)) {
            words.push(&text[from..at]);
            from = at;
        }
    }
    words.push(&text[from..]);
    words
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
