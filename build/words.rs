//! What visitors read, in every language: finds all texts of the page in its HTML, its figures and its sources, and
//! says which of them a phrasebook (`www/words`) lacks, so that a word without a translation does not compile.

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

const PHRASEBOOKS: [&str; 3] = ["pt", "es", "zh"];

/// Rooms whose sources have texts for visitors. What `draw` and the shell say is for programmers.
const ROOMS: [&str; 8] =
    ["browser", "play", "plants", "surface", "tissue", "import", "export", "shapes"];

/// Texts of the sources that no visitor reads, one a line.
const UNSPOKEN: &str = "build/unspoken.txt";

/// Attributes that are read out or shown.
const ATTRIBUTES: [&str; 6] =
    ["aria-label", "title", "placeholder", "alt", "aria-roledescription", "label"];

/// Calls whose texts are for programmers.
const PANICS: [&str; 9] = [
    "panic",
    "unreachable",
    "todo",
    "assert",
    "assert_eq",
    "assert_ne",
    "debug_assert",
    "debug_assert_eq",
    "expect",
];

/// Panics with all texts that a phrasebook lacks, and with all that it has in vain.
pub fn check() {
    let unspoken = read(Path::new(UNSPOKEN));
    let unspoken: BTreeSet<String> = unspoken.lines().map(normal).collect();
    let mut texts: BTreeMap<String, PathBuf> = BTreeMap::new();
    for file in files() {
        let text = read(&file);
        let found = match file.extension().and_then(|e| e.to_str()) {
            Some("html") => texts_of_html(&text),
            Some("txt") => super::figures::texts(&text).map(normal).collect(),
            _ => texts_of_rust(&text, &file).into_iter().filter(|text| is_read(text)).collect(),
        };
        let spoken = found.into_iter().filter(|text| has_word(text) && !unspoken.contains(text));
        for text in spoken {
            texts.entry(text).or_insert_with(|| file.clone());
        }
    }
    let mut faults = Vec::new();
    for language in PHRASEBOOKS {
        let book = read(Path::new(&format!("www/words/{language}.txt")));
        let known: BTreeSet<String> = keys(&book).map(normal).collect();
        for (text, file) in &texts {
            if !known.contains(text) {
                faults.push(format!("{language}: {}: {text}", file.display()));
            }
        }
    }
    assert!(
        faults.is_empty(),
        "texts without a translation in www/words (or a line in {UNSPOKEN}, if no visitor reads \
         them):\n{}",
        faults.join("\n")
    );
}

fn files() -> Vec<PathBuf> {
    let mut files = vec![PathBuf::from("www/index.html"), PathBuf::from(super::FIGURES)];
    for room in ROOMS {
        super::list(Path::new(&format!("src/{room}")), &mut files);
    }
    let is_read = |file: &PathBuf| {
        let path = file.to_string_lossy();
        let is_test = path.ends_with("tests.rs")
            || path.ends_with("testing.rs")
            || ["/tests/", "/together", "/bodies/", "/original"]
                .iter()
                .any(|part| path.contains(part));
        !is_test && (path.ends_with(".rs") || path.ends_with(".html") || path == super::FIGURES)
    };
    files.into_iter().filter(is_read).collect()
}

fn read(file: &Path) -> String {
    std::fs::read_to_string(file).unwrap_or_else(|e| panic!("{}: {e}", file.display()))
}

/// The English texts of a phrasebook: lines that are neither indented nor empty nor remarks.
fn keys(book: &str) -> impl Iterator<Item = &str> {
    book.lines().filter(|line| !line.starts_with(['\t', '#']) && !line.trim().is_empty())
}

/// A text with `{}` for each of its holes and one space between words, without what it is glued to others with.
fn normal(text: &str) -> String {
    let mut plain = String::new();
    let mut rest = text;
    while let Some(at) = rest.find('{') {
        plain.push_str(&rest[..at]);
        rest = &rest[at..];
        if let Some(after) = rest.strip_prefix("{{") {
            plain.push('{');
            rest = after;
        } else {
            plain.push_str("{}");
            rest = rest.find('}').map_or("", |end| &rest[end + 1..]);
        }
    }
    plain.push_str(rest);
    // Holes side by side are one.
    while plain.contains("{}{}") {
        plain = plain.replace("{}{}", "{}");
    }
    let words: Vec<&str> = plain.split_whitespace().collect();
    let glue = |c: char| c.is_whitespace() || ",;:·.".contains(c);
    words.join(" ").trim_start_matches(glue).trim_end_matches([',', ';', ':', '·', ' ']).to_string()
}

fn has_word(text: &str) -> bool {
    text.split(|c: char| !c.is_alphabetic()).any(|word| word.chars().any(char::is_lowercase))
}

/// Whether a text of a source looks as if somebody were to read it: words, and not a piece of code.
fn is_read(text: &str) -> bool {
    let letters = text.replace("{}", " ");
    let is_word = |word: &&str| word.chars().filter(|c| c.is_alphabetic()).count() >= 2;
    let words = letters.split_whitespace().filter(is_word).count();
    let is_code = text.starts_with(['<', '[', '.', '#', '@', '(', '*'])
        || [".{}", "/{}", "{}/", "-{}", "{}-", "{}_", "_{}", "](", ")]", "://", "=", "{\""]
            .iter()
            .any(|part| text.contains(part))
        || text.split("{}.").skip(1).any(|after| after.starts_with(char::is_alphabetic));
    let starts_high = letters.trim_start().starts_with(char::is_uppercase)
        && letters.contains(char::is_lowercase);
    !is_code && (words >= 2 || words == 1 && (starts_high || text.contains(' ')))
}

/// The texts of a document and of its attributes that are read.
fn texts_of_html(html: &str) -> Vec<String> {
    let mut texts = Vec::new();
    let mut silent: Option<String> = None;
    for piece in html.split('<').skip(1) {
        let (tag, text) = piece.split_once('>').unwrap_or((piece, ""));
        let name: String =
            tag.chars().take_while(|c| c.is_ascii_alphanumeric() || *c == '/').collect();
        match &silent {
            Some(open) if name == format!("/{open}") => silent = None,
            Some(_) => continue,
            // What is no text of the page, or says itself of which language it is.
            None if ["script", "style", "code"].contains(&name.as_str())
                || name != "html" && tag.contains(" lang=")
                || tag.contains(" translate=") =>
            {
                silent = Some(name);
                continue;
            }
            None => {}
        }
        for attribute in ATTRIBUTES {
            for quote in ['"', '\''] {
                if let Some((_, after)) = tag.split_once(&format!(" {attribute}={quote}")) {
                    texts.push(after.split(quote).next().unwrap_or_default());
                }
            }
        }
        texts.push(text);
    }
    texts.into_iter().map(normal).map(|text| text.replace("&amp;", "&")).collect()
}

/// The texts of a source, but for those of tests, attributes, remarks and panics.
fn texts_of_rust(source: &str, file: &Path) -> Vec<String> {
    let tokens: TokenStream = source.parse().unwrap_or_else(|e| panic!("{}: {e}", file.display()));
    let mut texts = Vec::new();
    collect(tokens, &mut texts);
    // What stands in markup is read, too.
    let markup: Vec<String> =
        texts.iter().filter(|t| t.contains("</")).flat_map(|t| texts_of_html(t)).collect();
    texts.retain(|text| !text.contains("</"));
    texts.iter().map(|text| normal(text)).chain(markup).collect()
}

fn collect(tokens: TokenStream, texts: &mut Vec<String>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let mut k = 0;
    while let Some(token) = tokens.get(k) {
        k += 1;
        match token {
            TokenTree::Punct(mark) if mark.as_char() == '#' => {
                // Those of the file itself begin with `#!`.
                k += usize::from(tokens.get(k).is_some_and(is_bang));
                let Some(TokenTree::Group(attribute)) = tokens.get(k) else { continue };
                k += 1;
                let told = attribute.stream().to_string();
                // What the derive of errors writes is read.
                if told.starts_with("error") {
                    collect(attribute.stream(), texts);
                }
                if told.replace(' ', "") == "cfg(test)" {
                    // Up to the end of what is for tests alone.
                    while let Some(token) = tokens.get(k) {
                        k += 1;
                        match token {
                            TokenTree::Group(body) if body.delimiter() == Delimiter::Brace => break,
                            TokenTree::Punct(end) if end.as_char() == ';' => break,
                            _ => {}
                        }
                    }
                }
            }
            TokenTree::Ident(name) if PANICS.contains(&name.to_string().as_str()) => {
                k += usize::from(tokens.get(k).is_some_and(is_bang));
                k += usize::from(matches!(tokens.get(k), Some(TokenTree::Group(_))));
            }
            TokenTree::Group(group) => collect(group.stream(), texts),
            TokenTree::Literal(literal) => {
                if let Ok(text) = syn::parse_str::<syn::LitStr>(&literal.to_string()) {
                    texts.push(text.value());
                }
            }
            _ => {}
        }
    }
}

fn is_bang(token: &TokenTree) -> bool {
    matches!(token, TokenTree::Punct(mark) if mark.as_char() == '!')
}
