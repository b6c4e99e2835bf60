//! The rules of the house, read off its sources: who may import whom, what the model may not use,
//! how long a file may be, and that nothing names the machine that it was written on.

use std::fs;
use std::path::{Path, PathBuf};

/// Each room and the rooms that it may import.
const ROOMS: [(&str, &[&str]); 9] = [
    ("surface", &[]),
    ("tissue", &["surface"]),
    ("mosaic", &["surface", "tissue"]),
    ("plants", &["surface", "tissue", "mosaic"]),
    ("play", &["surface", "tissue", "mosaic", "plants"]),
    ("export", &["surface", "tissue", "mosaic", "plants"]),
    ("draw", &["surface", "mosaic", "plants"]),
    ("browser", &["surface", "tissue", "mosaic", "plants", "play", "export", "draw"]),
    ("bin", &["surface", "tissue", "mosaic", "plants", "play", "export", "browser"]),
];

/// The rooms whose results must be the same bits on every machine.
const MODEL: [&str; 6] = ["surface", "tissue", "mosaic", "plants", "play", "export"];

/// Functions of std's floats that differ between platforms; `libm` has the same ones.
const PLATFORM_MATHS: [&str; 23] = [
    "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sin_cos", "sinh", "cosh", "tanh", "exp",
    "exp2", "exp_m1", "ln", "ln_1p", "log", "log2", "log10", "powf", "hypot", "asinh", "acosh",
];

/// What the model may not know: clocks, files, threads, the browser, the GPU.
const OUTSIDE: [&str; 9] = [
    "std::time",
    "std::fs",
    "std::thread",
    "std::env",
    "std::net",
    "web_sys",
    "js_sys",
    "wasm_bindgen",
    "wgpu",
];

const MOST_LINES: usize = 400;

#[test]
fn rooms_import_only_the_rooms_before_them() {
    let mut broken = Vec::new();
    for (room, allowed) in ROOMS {
        for (path, code) in room_sources(room) {
            for other in imports(&code) {
                let is_room = ROOMS.iter().any(|(name, _)| *name == other);
                if is_room && other != room && !allowed.contains(&other.as_str()) {
                    broken.push(format!("{}: {room} imports {other}", path.display()));
                }
            }
        }
    }
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}

#[test]
fn every_folder_of_the_library_is_a_room_of_this_plan() {
    for entry in fs::read_dir(root().join("src")).unwrap() {
        let entry = entry.unwrap();
        if entry.file_type().unwrap().is_dir() {
            let name = entry.file_name().into_string().unwrap();
            assert!(ROOMS.iter().any(|(room, _)| *room == name), "src/{name} is in no plan");
        }
    }
}

#[test]
fn the_model_uses_no_maths_of_the_platform() {
    let mut broken = Vec::new();
    for (path, code) in MODEL.into_iter().flat_map(room_sources) {
        for (number, line) in code.lines().enumerate() {
            for name in PLATFORM_MATHS {
                let forms = [format!(".{name}("), format!("f32::{name}"), format!("f64::{name}")];
                if forms.iter().any(|form| holds_word(line, form)) {
                    broken.push(format!("{}:{}: {}", path.display(), number + 1, line.trim()));
                }
            }
        }
    }
    assert!(broken.is_empty(), "use libm instead:\n{}", broken.join("\n"));
}

#[test]
fn the_model_knows_no_clock_file_thread_browser_or_gpu() {
    let mut broken = Vec::new();
    for (path, code) in MODEL.into_iter().flat_map(room_sources) {
        for name in OUTSIDE.into_iter().filter(|name| code.contains(name)) {
            broken.push(format!("{}: {name}", path.display()));
        }
    }
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}

#[test]
fn files_are_small_rooms() {
    let long: Vec<String> = ["src", "tests", "benches", "examples"]
        .into_iter()
        .flat_map(|folder| files(&root().join(folder)))
        .filter(|path| path.extension().is_some_and(|e| e == "rs" || e == "wgsl"))
        .map(|path| (fs::read_to_string(&path).unwrap().lines().count(), path))
        .filter(|(lines, _)| *lines > MOST_LINES)
        .map(|(lines, path)| format!("{} has {lines} lines", path.display()))
        .collect();
    assert!(long.is_empty(), "split where they hold two ideas:\n{}", long.join("\n"));
}

#[test]
fn nothing_names_the_machine_it_was_written_on() {
    // Put together here so that this file does not hold them.
    let foreign =
        ["/wo-rk/", "/ro-ot/", "/ho-me/", "/tm-p/", "C:-\\Users"].map(|path| path.replace('-', ""));
    let mut named = Vec::new();
    let folders = ["src", "tests", "benches", "examples", "docs", "www", "meshes", ".ci", ".cargo"];
    let texts = ["rs", "wgsl", "html", "css", "toml", "md", "json", "webmanifest", "sh", ""];
    let single = ["playground", "README.md", "ARCHITECTURE.md", "Cargo.toml", "Trunk.toml"];
    let of_folders = folders.iter().flat_map(|folder| files(&root().join(folder)));
    for path in of_folders.chain(single.iter().map(|name| root().join(name))) {
        let extension = path.extension().map_or("", |e| e.to_str().unwrap());
        if !texts.contains(&extension) {
            continue;
        }
        let Ok(text) = fs::read_to_string(&path) else { continue };
        for name in foreign.iter().filter(|name| text.contains(name.as_str())) {
            named.push(format!("{} names {name}", path.display()));
        }
    }
    assert!(named.is_empty(), "{}", named.join("\n"));
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// All files under a folder; none when it is not there.
fn files(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = fs::read_dir(folder) else { return Vec::new() };
    let mut found = Vec::new();
    for path in entries.map(|entry| entry.unwrap().path()) {
        if path.is_dir() { found.extend(files(&path)) } else { found.push(path) }
    }
    found.sort();
    found
}

/// The sources of a room without comments and without their tests.
fn room_sources(room: &str) -> Vec<(PathBuf, String)> {
    let sources: Vec<(PathBuf, String)> = files(&root().join("src").join(room))
        .into_iter()
        .filter(|path| path.extension().is_some_and(|e| e == "rs"))
        .map(|path| (path.clone(), fs::read_to_string(&path).unwrap()))
        .collect();
    let for_tests: Vec<PathBuf> =
        sources.iter().flat_map(|(path, text)| test_modules(path, text)).collect();
    sources
        .into_iter()
        .filter(|(path, _)| !for_tests.iter().any(|module| path.starts_with(module)))
        .map(|(path, text)| (path, production_code(&text)))
        .collect()
}

/// The files, and the folders, of the modules that a file declares for tests only.
fn test_modules(path: &Path, text: &str) -> Vec<PathBuf> {
    let folder = match path.file_stem().and_then(|stem| stem.to_str()) {
        Some("mod" | "lib" | "main") => path.with_file_name(""),
        _ => path.with_extension(""),
    };
    let lines: Vec<&str> = text.lines().collect();
    lines
        .windows(2)
        .filter(|pair| pair[0].starts_with("#[cfg(test)]") || pair[0].starts_with("#[cfg(all(test"))
        .filter_map(|pair| pair[1].strip_prefix("mod ")?.strip_suffix(';'))
        .flat_map(|name| [folder.join(name), folder.join(format!("{name}.rs"))])
        .collect()
}

fn production_code(text: &str) -> String {
    let tests = text
        .match_indices("#[cfg(test)]\nmod ")
        .find(|(at, _)| text[*at..].lines().nth(1).is_some_and(|line| line.ends_with('{')));
    let code = &text[..tests.map_or(text.len(), |(at, _)| at)];
    let without_comment = |line: &str| line.split("//").next().unwrap_or("").to_string();
    code.lines().map(without_comment).collect::<Vec<_>>().join("\n")
}

/// The first names after `crate::`, also those of a group in braces.
fn imports(code: &str) -> Vec<String> {
    let mut found = Vec::new();
    for start in ["crate::", "clonal_mosaic::"] {
        for (at, _) in code.match_indices(start) {
            let rest = &code[at + start.len()..];
            if rest.starts_with('{') {
                found.extend(group(rest));
            } else {
                found.push(word(rest));
            }
        }
    }
    found
}

/// The first names of the items in `{a::b, c::{d, e}}`.
fn group(text: &str) -> Vec<String> {
    let mut depth = 0;
    let mut found = Vec::new();
    let mut item_starts = false;
    for (at, c) in text.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            break;
        }
        if depth == 1 && (c == '{' || c == ',') {
            item_starts = true;
        } else if item_starts && !c.is_whitespace() {
            found.push(word(&text[at..]));
            item_starts = false;
        }
    }
    found
}

fn word(text: &str) -> String {
    text.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect()
}

/// Whether `form` stands in the line as a whole word (so that `f32::exp` is not `f32::expect`).
fn holds_word(line: &str, form: &str) -> bool {
    line.match_indices(form).any(|(at, _)| {
        form.ends_with('(')
            || !line[at + form.len()..].starts_with(|c: char| c.is_alphanumeric() || c == '_')
    })
}

#[test]
fn the_readers_of_this_file_see_what_they_should() {
    let code = "use crate::{surface::{Mesh, play}, tissue};\nlet x = crate::draw::Look;";
    assert_eq!(imports(code), ["surface", "tissue", "draw"]);
    let text = "fn a() {} // crate::play\n#[cfg(test)]\nmod tests {\n crate::draw }";
    assert_eq!(production_code(text), "fn a() {} ");
    let declared = test_modules(Path::new("src/play/mod.rs"), "#[cfg(test)]\nmod a;\nmod b;");
    assert_eq!(declared, [Path::new("src/play/a"), Path::new("src/play/a.rs")]);
    assert!(holds_word("x.sin()", ".sin(") && holds_word("map(f32::exp)", "f32::exp"));
    assert!(!holds_word("f32::expect", "f32::exp") && !holds_word("libm::sin(x)", ".sin("));
}
