//! A phrasebook: what the page says in English, said in another language.
//!
//! The page knows English alone. A phrasebook is a text of its sentences with holes for what changes in them, each
//! with what it is in the other language, so that whatever the page puts together is translated as a whole:
//! `docs/languages.md` says how one is written.

use std::cell::RefCell;
use std::collections::BTreeMap;

/// The languages that there are phrasebooks of, beside the page's own English.
pub const PHRASEBOOKS: [&str; 3] = ["pt", "es", "zh"];

/// How a language writes numbers and which of its plural forms they want (Unicode CLDR, "Plural Rules").
pub trait Numbers {
    /// A number with so many decimals, its digits in groups or not.
    fn written(&self, value: f64, decimals: usize, grouped: bool) -> String;
    /// The plural category of a number: `one`, `few`, `many`, `other` and so on.
    fn category(&self, value: f64) -> String;
}

/// What the page says, in another language.
pub struct Phrasebook<N> {
    phrases: Vec<Phrase>,
    /// Which of them says a text without holes.
    by_text: BTreeMap<String, usize>,
    numbers: N,
    /// What was asked before, and parts of it: a text may be taken apart in many ways that share most of theirs.
    asked: RefCell<BTreeMap<String, Option<String>>>,
}

/// As many texts are remembered.
const MOST_REMEMBERED: usize = 4000;

/// Longer texts are nobody's sentence.
const MOST_BYTES: usize = 2000;

/// A phrase of fewer bytes says one thing here and another one elsewhere: `{} of {}`.
const SURE_BYTES: usize = 12;

/// What may stand around a text that is glued to another one.
const GLUE: [char; 5] = [',', ';', ':', '·', ' '];

struct Phrase {
    /// What stands before, between and behind the holes.
    pieces: Vec<String>,
    holes: Vec<Hole>,
    /// What it is in the other language; where there are several, by the plural category of the first hole.
    told: Vec<(Option<String>, String)>,
}

/// What a hole is for.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Hole {
    /// `{}`: whatever is there, which is told by itself.
    Any,
    /// `{n}`: a number alone.
    Number,
    /// `{v}`: what stays as it is, as the number of a figure.
    AsItIs,
}

impl Phrase {
    fn new(english: &str) -> Phrase {
        let mut parts = english.split('{');
        let mut pieces = vec![parts.next().unwrap_or_default().to_string()];
        let mut holes = Vec::new();
        for part in parts {
            let (hole, after) = part.split_once('}').unwrap_or(("", part));
            holes.push(match hole {
                "n" => Hole::Number,
                "v" => Hole::AsItIs,
                _ => Hole::Any,
            });
            pieces.push(after.to_string());
        }
        Phrase { pieces, holes, told: Vec::new() }
    }

    /// How many characters of it are not holes: the more there are, the surer it is what is meant.
    fn length(&self) -> usize {
        self.pieces.iter().map(String::len).sum()
    }

    /// Whether it says nothing itself, and joins what others say.
    fn is_punctuation(&self) -> bool {
        !self.pieces.iter().any(|piece| piece.contains(char::is_alphanumeric))
    }

    /// What stands in its holes in a text, the shortest first; None where it does not say the text.
    fn fillings<'t>(&self, text: &'t str) -> Option<Vec<&'t str>> {
        let mut holes = Vec::new();
        let rest = text.strip_prefix(self.pieces[0].as_str())?;
        self.fill(rest, &mut holes).then_some(holes)
    }

    fn fill<'t>(&self, text: &'t str, holes: &mut Vec<&'t str>) -> bool {
        let hole = holes.len();
        let Some(piece) = self.pieces.get(hole + 1) else { return text.is_empty() };
        let fits = |filling: &str| match self.holes[hole] {
            Hole::Number => Number::read(filling).is_some(),
            Hole::Any | Hole::AsItIs => !filling.is_empty(),
        };
        if hole + 2 == self.pieces.len() {
            let filling = text.strip_suffix(piece.as_str()).filter(|filling| fits(filling));
            holes.extend(filling);
            return filling.is_some();
        }
        for (at, _) in text.match_indices(piece.as_str()) {
            if fits(&text[..at]) {
                holes.push(&text[..at]);
                if self.fill(&text[at + piece.len()..], holes) {
                    return true;
                }
                holes.truncate(hole);
            }
        }
        false
    }
}

/// A number as the page writes it: `31,402`, `0.25`, `−3`.
struct Number {
    value: f64,
    decimals: usize,
    grouped: bool,
}

impl Number {
    fn read(text: &str) -> Option<Number> {
        let is_digit = |c: char| c.is_ascii_digit();
        let digits = text.trim_start_matches(['-', '−']);
        let (whole, decimals) = digits.split_once('.').unwrap_or((digits, "0"));
        let in_groups = whole.split(',').enumerate().all(|(k, group)| {
            group.chars().all(is_digit) && (k == 0 && !group.is_empty() || group.len() == 3)
        });
        let is_number = text.chars().count() <= digits.chars().count() + 1
            && in_groups
            && !decimals.is_empty()
            && decimals.chars().all(is_digit);
        let plain = text.replace(',', "").replace('−', "-");
        let value = is_number.then(|| plain.parse().ok()).flatten()?;
        let decimals = if digits.contains('.') { decimals.len() } else { 0 };
        Some(Number { value, decimals, grouped: whole.contains(',') })
    }
}

impl<N: Numbers> Phrasebook<N> {
    /// Reads a phrasebook; the error names the line that cannot be understood.
    pub fn read(text: &str, numbers: N) -> Result<Phrasebook<N>, usize> {
        let mut phrases: Vec<Phrase> = Vec::new();
        for (k, line) in text.lines().enumerate() {
            if let Some(told) = line.strip_prefix('\t') {
                let of_category = told
                    .strip_prefix('[')
                    .and_then(|rest| rest.split_once("] "))
                    .filter(|(category, _)| category.chars().all(|c| c.is_ascii_lowercase()));
                let told = match of_category {
                    Some((category, told)) => (Some(category.to_string()), told.to_string()),
                    None => (None, told.to_string()),
                };
                phrases.last_mut().ok_or(k + 1)?.told.push(told);
            } else if !line.trim().is_empty() && !line.starts_with('#') {
                phrases.push(Phrase::new(line));
            }
        }
        if let Some(bad) = phrases.iter().position(|phrase| phrase.told.is_empty()) {
            return Err(bad + 1);
        }
        // In the order in which they are tried.
        let of_numbers =
            |phrase: &Phrase| phrase.holes.iter().filter(|&&hole| hole == Hole::Number).count();
        phrases.sort_by_key(|phrase| std::cmp::Reverse((phrase.length(), of_numbers(phrase))));
        let whole = phrases.iter().enumerate().filter(|(_, phrase)| phrase.holes.is_empty());
        let by_text = whole.map(|(k, phrase)| (phrase.pieces[0].clone(), k)).collect();
        Ok(Phrasebook { phrases, by_text, numbers, asked: RefCell::default() })
    }

    /// A text of the page in the other language; None where the phrasebook has no word of it.
    pub fn tell(&self, english: &str) -> Option<String> {
        let bare = english.trim().trim_matches(GLUE).trim_start_matches(['.', ' ']);
        if bare.is_empty() || english.len() > MOST_BYTES {
            return None;
        }
        let told = self.remembered(bare)?;
        Some(english.replacen(bare, &told, 1))
    }

    fn remembered(&self, text: &str) -> Option<String> {
        if let Some(told) = self.asked.borrow().get(text) {
            return told.clone();
        }
        let told = self.tell_trimmed(text);
        let mut asked = self.asked.borrow_mut();
        if asked.len() >= MOST_REMEMBERED {
            asked.clear();
        }
        asked.insert(text.to_string(), told.clone());
        told
    }

    fn tell_trimmed(&self, text: &str) -> Option<String> {
        self.known(text).or_else(|| self.number(text)).or_else(|| self.filled(text))
    }

    /// A text without holes, as it stands or as it would within or at the end of a sentence.
    fn known(&self, text: &str) -> Option<String> {
        Said::ways(text).into_iter().find_map(|said| {
            let &phrase = self.by_text.get(&said.text)?;
            Some(said.back(&self.phrases[phrase].told[0].1))
        })
    }

    fn number(&self, text: &str) -> Option<String> {
        let digits = text.strip_suffix('%').unwrap_or(text);
        let Number { value, decimals, grouped } = Number::read(digits)?;
        Some(self.numbers.written(value, decimals, grouped) + &text[digits.len()..])
    }

    /// A text by the first phrase with holes that says it.
    fn filled(&self, text: &str) -> Option<String> {
        let ways = Said::ways(text);
        let mut with_holes = self.phrases.iter().filter(|phrase| !phrase.holes.is_empty());
        with_holes.find_map(|phrase| {
            let ways = if phrase.is_punctuation() { &ways[..1] } else { &ways };
            let (said, holes) =
                ways.iter().find_map(|way| Some((way, phrase.fillings(&way.text)?)))?;
            // What runs over the end of a sentence is no part of another.
            if !phrase.is_punctuation() && holes.iter().any(|hole| has_end(hole)) {
                return None;
            }
            let told: Vec<Option<String>> = holes
                .iter()
                .zip(&phrase.holes)
                .map(|(filling, hole)| match hole {
                    Hole::AsItIs => Some(filling.to_string()),
                    Hole::Any | Hole::Number => self.tell(filling),
                })
                .collect();
            // What joins nothing that is known may as well be somebody's own text.
            let mut known = told.iter().zip(&holes).filter(|(told, _)| told.is_some());
            let is_ours = match phrase.is_punctuation() {
                true => known.any(|(_, hole)| Number::read(hole).is_none()),
                false => phrase.length() >= SURE_BYTES || known.next().is_some(),
            };
            let fillings: Vec<String> = told
                .iter()
                .zip(&holes)
                .map(|(told, hole)| told.clone().unwrap_or_else(|| hole.to_string()))
                .collect();
            is_ours.then(|| said.back(&fill(self.form(phrase, &holes), &fillings)))
        })
    }

    /// The form of a phrase that the number in its first hole wants.
    fn form<'p>(&self, phrase: &'p Phrase, holes: &[&str]) -> &'p str {
        let number = holes.first().and_then(|hole| Number::read(hole));
        let category = match number {
            Some(number) if phrase.told.len() > 1 => self.numbers.category(number.value),
            _ => "other".to_string(),
        };
        let of = |wanted: &str| phrase.told.iter().find(|(c, _)| c.as_deref() == Some(wanted));
        let last = &phrase.told[phrase.told.len() - 1];
        &of(&category).or_else(|| of("other")).unwrap_or(last).1
    }
}

/// A text as a phrasebook may have it: parts of what is put together lose the full stop at their end, and
/// sentences have a large letter at their start.
struct Said {
    text: String,
    without_stop: bool,
    in_capitals: bool,
}

impl Said {
    fn ways(text: &str) -> Vec<Said> {
        let as_it_is = Said { text: text.to_string(), without_stop: false, in_capitals: false };
        let mut ways = vec![as_it_is];
        if !text.ends_with(['.', '…', '?', '!']) {
            ways.push(Said { text: format!("{text}."), without_stop: true, in_capitals: false });
        }
        let lower: Vec<Said> = ways
            .iter()
            .filter_map(|way| {
                let text = with_first(&way.text, |c| c.to_lowercase().collect())?;
                Some(Said { text, without_stop: way.without_stop, in_capitals: true })
            })
            .collect();
        ways.extend(lower);
        ways
    }

    /// What was told of it, as the text was.
    fn back(&self, told: &str) -> String {
        let told = if self.without_stop { told.trim_end_matches(['.', '。']) } else { told };
        let in_capitals = with_first(told, |c| c.to_uppercase().collect());
        in_capitals.filter(|_| self.in_capitals).unwrap_or_else(|| told.to_string())
    }
}

/// Whether a sentence, or a part of one that could be one, ends within a text.
fn has_end(text: &str) -> bool {
    let mut ends = text.match_indices(". ").filter(|&(at, _)| !text[..at].ends_with("Fig"));
    ends.next().is_some() || text.contains("; ")
}

/// A text with another first letter; None where it stays as it is.
fn with_first(text: &str, change: impl Fn(char) -> String) -> Option<String> {
    let mut letters = text.chars();
    let first = letters.next()?;
    let changed = change(first) + letters.as_str();
    (changed != text).then_some(changed)
}

/// Fills the holes of a phrase: `{}` one after the other, or `{2}` by their place in the English one.
fn fill(phrase: &str, fillings: &[String]) -> String {
    let mut parts = phrase.split('{');
    let mut text = parts.next().unwrap_or_default().to_string();
    for (k, part) in parts.enumerate() {
        let (place, after) = part.split_once('}').unwrap_or(("", part));
        let place = place.parse::<usize>().map_or(k, |place| place.saturating_sub(1));
        text.push_str(fillings.get(place).map_or("", String::as_str));
        text.push_str(after);
    }
    text
}

#[cfg(test)]
mod tests;
