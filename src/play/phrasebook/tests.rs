use super::{Numbers, PHRASEBOOKS, Phrasebook};
use crate::play::lesson::{self, LESSONS, Lesson};

/// As Portuguese writes numbers: 31.402 and 0,25; and its plurals: 0 and 1 are `one`.
struct Portuguese;

impl Numbers for Portuguese {
    fn written(&self, value: f64, decimals: usize, grouped: bool) -> String {
        let text = format!("{value:.decimals$}").replace('.', ",");
        match grouped {
            true => {
                let (head, tail) = text.split_at(text.len() - 3);
                format!("{head}.{tail}")
            }
            false => text,
        }
    }

    fn category(&self, value: f64) -> String {
        if value < 2.0 { "one".into() } else { "other".into() }
    }
}

const BOOK: &str = "# a remark
Copy link
\tCopiar link
{n} cells
\t[one] {} célula
\t[other] {} células
{} cells
\tcélulas de cor {}
yellow
\tamarela
{}, individual {}, day {}
\t{1}, dia {3}, indivíduo {2}
Croton
\tCróton
{}, {}
\t{}, {}
{}. {}
\t{}. {}
{}.
\t{}.
Each is a first cell.
\tCada uma é uma célula inicial.
{} of {}
\t{} de {}
Thesis, Fig. {v}
\tDissertação, Fig. {}
Day {} is growing
\tO dia {} está crescendo
";

fn book() -> Phrasebook<Portuguese> {
    Phrasebook::read(BOOK, Portuguese).unwrap_or_else(|line| panic!("line {line}"))
}

#[test]
fn what_is_put_together_is_told_as_a_whole() {
    let book = book();
    let told = |text: &str| book.tell(text);
    assert_eq!(told("Copy link").as_deref(), Some("Copiar link"));
    assert_eq!(told(" Copy link\n").as_deref(), Some(" Copiar link\n"));
    assert_eq!(
        told("Croton, individual 7, day 12").as_deref(),
        Some("Cróton, dia 12, indivíduo 7"),
        "holes go where the other language has them"
    );
    assert_eq!(told("31,402 cells").as_deref(), Some("31.402 células"));
    assert_eq!(told("1 cells").as_deref(), Some("1 célula"));
    assert_eq!(told("yellow cells").as_deref(), Some("células de cor amarela"));
    assert_eq!(told("Yellow").as_deref(), Some("Amarela"), "at the start of a sentence");
    assert_eq!(
        told("31,402 cells, yellow. Each is a first cell.").as_deref(),
        Some("31.402 células, amarela. Cada uma é uma célula inicial.")
    );
    assert_eq!(told("Thesis, Fig. 4.14").as_deref(), Some("Dissertação, Fig. 4.14"));
    assert_eq!(told("The kings of France and Navarre"), None, "not by a word as short as this");
    assert_eq!(told(", 31,402 cells").as_deref(), Some(", 31.402 células"), "glued to another");
    assert_eq!(told("Each is a first cell").as_deref(), Some("Cada uma é uma célula inicial"));
    assert_eq!(
        told("Day 5 is growing. Copy link.").as_deref(),
        Some("O dia 5 está crescendo. Copiar link.")
    );
    assert_eq!(told("Day 5 is growing.").as_deref(), Some("O dia 5 está crescendo."));
}

#[test]
fn numbers_are_written_as_the_language_does() {
    let book = book();
    for (english, told) in [("31,402", "31.402"), ("0.25", "0,25"), ("38%", "38%"), ("7", "7")] {
        assert_eq!(book.tell(english).as_deref(), Some(told));
    }
    for text in ["tm72ve", "1,2,3", "4.14.", "12,34", "", "1e5", "-"] {
        assert_eq!(book.tell(text), None, "{text} is no number of the page");
    }
}

#[test]
fn what_is_somebodys_own_stays() {
    let book = book();
    for text in [
        "my leaf, the second",
        "https://example.org/#croton?v=1&s=1",
        "A lesson of mine. It is short.",
    ] {
        assert_eq!(book.tell(text), None, "{text}");
    }
    // A name that is unknown stands as it is in what is known.
    assert_eq!(book.tell("Fern, individual 7, day 1").as_deref(), Some("Fern, dia 1, indivíduo 7"));
}

/// A text that may be taken apart in many ways takes no longer for it.
#[test]
fn long_lists_are_soon_told() {
    let list = vec!["yellow, a. b of c"; 60].join(", ");
    let told = book().tell(&list).expect("some of it is known");
    assert_eq!(told.matches("amarela").count(), 60);
}

#[test]
fn a_phrase_without_its_other_language_is_refused() {
    assert!(Phrasebook::read("Copy link\n", Portuguese).is_err());
    assert!(Phrasebook::read("\tCopiar\n", Portuguese).is_err());
}

/// All phrasebooks have the same phrases, each with all of its holes.
#[test]
fn phrasebooks_are_whole() {
    let keys = |text: &str| -> Vec<String> {
        let is_key = |line: &&str| !line.starts_with(['\t', '#']) && !line.trim().is_empty();
        text.lines().filter(is_key).map(String::from).collect()
    };
    let texts = PHRASEBOOKS.map(|language| {
        std::fs::read_to_string(format!("www/words/{language}.txt")).expect("a phrasebook is there")
    });
    for (text, language) in texts.iter().zip(PHRASEBOOKS) {
        assert_eq!(keys(text), keys(&texts[0]), "{language} and {}", PHRASEBOOKS[0]);
        let book = Phrasebook::read(text, Portuguese);
        let book = book.unwrap_or_else(|line| panic!("{language}: phrase {line}"));
        assert!(book.phrases.len() > 900, "{language}");
        for phrase in &book.phrases {
            let holes = phrase.holes.len();
            for (category, told) in &phrase.told {
                let places: Vec<&str> = told
                    .split('{')
                    .skip(1)
                    .filter_map(|part| Some(part.split_once('}')?.0))
                    .collect();
                // One cell may be told without its number.
                if category.as_deref() == Some("one") && places.len() < holes {
                    continue;
                }
                let mut named: Vec<usize> = places.iter().filter_map(|p| p.parse().ok()).collect();
                named.sort_unstable();
                let all: Vec<usize> = (1..=holes).collect();
                assert!(
                    places.len() == holes && (named.is_empty() || named == all),
                    "{language}: {:?}: {told}",
                    phrase.pieces
                );
            }
        }
    }
}

/// A lesson is the same lesson in every language: its steps, links, measures and right answers.
#[test]
fn lessons_are_the_same_in_every_language() {
    let read = |path: String| -> (Lesson, Vec<String>) {
        let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"));
        let lesson = lesson::read(&text).unwrap_or_else(|e| panic!("{path}: {e:?}"));
        let is_same = |line: &&str| {
            ["link:", "measure:", "individuals:", "days:", "minutes:"]
                .iter()
                .any(|k| line.starts_with(k))
        };
        let same = text.lines().filter(is_same).map(String::from);
        // Of the others their order counts.
        let keys = text.lines().filter_map(|line| {
            let word: String = line.chars().take_while(|c| c.is_ascii_lowercase()).collect();
            let is_step = line.starts_with('[');
            let key = line.strip_prefix(&word)?.starts_with(':').then_some(word);
            key.or_else(|| is_step.then(|| line.split(']').next().unwrap_or_default().to_string()))
        });
        let known = ["see", "then"];
        let told = same.chain(keys.filter(|k| !known.contains(&k.as_str()))).collect();
        (lesson, told)
    };
    for name in LESSONS {
        let (english, same) = read(format!("www/lessons/{name}.txt"));
        for language in PHRASEBOOKS {
            let (lesson, told) = read(format!("www/lessons/{language}/{name}.txt"));
            assert_eq!(told, same, "{language}/{name}");
            assert_eq!(lesson.steps.len(), english.steps.len(), "{language}/{name}");
            assert_ne!(lesson.title, english.title, "{language}/{name}");
        }
    }
}
