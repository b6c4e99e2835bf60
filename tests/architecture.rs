//! The rules of the house, read off its sources: who may import whom, what the model may not use,
//! how long a file may be, and that nothing names the machine that it was written on.

use std::fs;
use std::path::{Path, PathBuf};

/// Each room and the rooms that it may import.
const ROOMS: [(&str, &[&str]); 11] = [
    ("surface", &[]),
    ("shapes", &["surface"]),
    ("tissue", &["surface"]),
    ("mosaic", &["surface", "tissue"]),
    ("plants", &["surface", "tissue", "mosaic"]),
    ("play", &["surface", "tissue", "mosaic", "plants"]),
    ("export", &["surface", "tissue", "mosaic", "plants", "play"]),
    ("import", &["surface", "shapes", "tissue", "plants", "play"]),
    ("draw", &["surface", "mosaic", "plants"]),
    ("browser", &["surface", "tissue", "mosaic", "plants", "play", "export", "import", "draw"]),
    (
        "bin",
        &["surface", "shapes", "tissue", "mosaic", "plants", "play", "export", "import", "browser"],
    ),
];

/// The rooms whose results must be the same bits on every machine.
const MODEL: [&str; 7] = ["surface", "shapes", "tissue", "mosaic", "plants", "play", "export"];

/// Functions of floats, of std and of `wide`, that differ between platforms or versions of the compiler.
/// `libm` has most of them, and the others can be written out.
const PLATFORM_MATHS: [&str; 39] = [
    "sin",
    "cos",
    "tan",
    "asin",
    "acos",
    "atan",
    "atan2",
    "sin_cos",
    "sinh",
    "cosh",
    "tanh",
    "asinh",
    "acosh",
    "atanh",
    "exp",
    "exp2",
    "exp_m1",
    "ln",
    "ln_1p",
    "log",
    "log2",
    "log10",
    "powf",
    "powi",
    "cbrt",
    "hypot",
    "gamma",
    "ln_gamma",
    "erf",
    "erfc",
    "recip",
    "recip_sqrt",
    "rsqrt",
    "mul_add",
    "mul_sub",
    "mul_neg_add",
    "mul_neg_sub",
    "pow_f32x4",
    "pow_f32x8",
];

/// Collections whose order is another in each run: what is in them may be looked up, not walked through.
const WITHOUT_ORDER: [&str; 2] = ["HashMap", "HashSet"];

/// Methods of theirs that look something up, or put it there.
const LOOK_UP: [&str; 9] =
    ["get", "get_mut", "contains", "contains_key", "insert", "entry", "remove", "len", "is_empty"];

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
            if PLATFORM_MATHS.iter().any(|name| calls(line, name)) {
                broken.push(format!("{}:{}: {}", path.display(), number + 1, line.trim()));
            }
        }
    }
    assert!(broken.is_empty(), "use libm instead:\n{}", broken.join("\n"));
}

#[test]
fn the_model_walks_through_nothing_that_has_no_order() {
    let mut broken = Vec::new();
    for (path, code) in MODEL.into_iter().flat_map(room_sources) {
        for line in walks_without_order(&code) {
            broken.push(format!("{}: {line}", path.display()));
        }
    }
    assert!(broken.is_empty(), "sort, or take a BTreeMap:\n{}", broken.join("\n"));
}

#[test]
fn the_model_knows_no_clock_file_thread_browser_or_gpu() {
    let mut broken = Vec::new();
    for (path, code) in MODEL.into_iter().flat_map(room_sources) {
        // The one that works with threads: the cells are the same with any number of them.
        let may = |name: &&str| *name == "std::thread" && path.ends_with("tissue/team.rs");
        let known = OUTSIDE.into_iter().filter(|name| code.contains(name));
        for name in known.filter(|name| !may(name)) {
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

/// Where a name stands in a text as a whole word: what is before it and what behind.
fn words<'a>(text: &'a str, name: &str) -> Vec<(&'a str, &'a str)> {
    let is_of_word = |c: char| c.is_alphanumeric() || c == '_';
    text.match_indices(name)
        .map(|(at, _)| (&text[..at], &text[at + name.len()..]))
        .filter(|(before, behind)| !before.ends_with(is_of_word) && !behind.starts_with(is_of_word))
        .collect()
}

/// Whether a line calls or names a method, or a function of any path but `libm`.
fn calls(line: &str, name: &str) -> bool {
    words(line, name).into_iter().any(|(before, behind)| {
        (before.ends_with('.') && behind.starts_with(['(', ':']))
            || (before.ends_with("::") && !before.ends_with("libm::"))
    })
}

/// The lines that may walk through a collection without order: those that mention one and neither import it
/// nor give it a name, and those in which such a name does anything but look up.
fn walks_without_order(code: &str) -> Vec<&str> {
    let mentions = |line: &&str| WITHOUT_ORDER.iter().any(|kind| !words(line, kind).is_empty());
    let (mut broken, mut names) = (Vec::new(), Vec::new());
    for line in code.lines().filter(mentions).filter(|line| !line.trim().starts_with("use ")) {
        // `let mut name = HashMap::new()`, `name: HashMap<..>`, `name: &mut HashMap<..>`
        let of_type =
            line.split_once(": ").map(|(name, kind)| (name, kind.trim_start_matches("&mut ")));
        let bound = line.split_once(" = ").filter(|(left, _)| !left.contains(": ")).or(of_type);
        let is_bound = |kind: &str| WITHOUT_ORDER.iter().any(|other| kind.starts_with(other));
        match bound {
            Some((left, kind)) if is_bound(kind) => {
                names.push(
                    left.rsplit(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or(""),
                );
            }
            _ => broken.push(line.trim()),
        }
    }
    for line in code.lines().filter(|line| !mentions(line)) {
        let is_looked_up = |(before, behind): (&str, &str)| {
            // A function of that name, or a field of something else.
            let is_other =
                behind.starts_with('(') || before.ends_with('.') && !before.ends_with("self.");
            let is_given = before.ends_with("&mut ") && behind.starts_with([',', ')']);
            let method = behind.strip_prefix('.').map(word);
            is_other
                || is_given
                || behind.starts_with('[')
                || method.is_some_and(|method| LOOK_UP.contains(&method.as_str()))
        };
        if names.iter().any(|name| !words(line, name).into_iter().all(is_looked_up)) {
            broken.push(line.trim());
        }
    }
    broken
}

#[test]
fn the_readers_of_this_file_see_what_they_should() {
    let code = "use crate::{surface::{Mesh, play}, tissue};\nlet x = crate::draw::Look;";
    assert_eq!(imports(code), ["surface", "tissue", "draw"]);
    let text = "fn a() {} // crate::play\n#[cfg(test)]\nmod tests {\n crate::draw }";
    assert_eq!(production_code(text), "fn a() {} ");
    let declared = test_modules(Path::new("src/play/mod.rs"), "#[cfg(test)]\nmod a;\nmod b;");
    assert_eq!(declared, [Path::new("src/play/a"), Path::new("src/play/a.rs")]);
    for line in ["x.sin()", "map(f32::sin)", "x.sin().max(y)", "Float::sin(x)", "<f32>::sin(x)"] {
        assert!(calls(line, "sin"), "{line}");
    }
    for line in
        ["libm::sin(x)", "self.sin", "x.sinus()", "f32::since", "let sin = 3", "fn sin(x: f32)"]
    {
        assert!(!calls(line, "sin"), "{line}");
    }
    let start = "use std::collections::HashMap;\nlet mut seen = HashMap::new();\n";
    for line in
        ["seen.insert(1, 2);", "if seen.contains_key(&3) {", "f(3, &mut seen);", "x.seen(seen[&2])"]
    {
        assert_eq!(walks_without_order(&format!("{start}{line}")), [""; 0]);
    }
    for line in [
        "for (a, b) in &seen {",
        "for pair in seen {",
        "for pair in &mut seen {",
        "seen.iter().max()",
        "seen.values().sum::<f32>()",
        "let mut all = self.seen.into_iter();",
        "Some(seen)",
        "let all: HashMap<u32, u32> = f();\nall.drain()",
        "fn f() -> HashMap<u32, u32> {",
        "pairs.collect::<HashSet<_>>()",
    ] {
        assert_eq!(walks_without_order(&format!("{start}{line}")).len(), 1, "{line}");
    }
}
