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

/// What may stand around a text that is glued to another one.
const GLUE: [char; 5] = [',', ';', ':', '·', ' '];

struct Phrase {
    /// What stands before, between and behind the holes.
    pieces: Vec<String>,
    /// Whether each hole is for a number alone.
    takes_numbers: Vec<bool>,
    /// What it is in the other language; where there are several, by the plural category of the first hole.
    told: Vec<(Option<String>, String)>,
}

impl Phrase {
    fn new(english: &str) -> Phrase {
        let mut parts = english.split('{');
        let mut pieces = vec![parts.next().unwrap_or_default().to_string()];
        let mut takes_numbers = Vec::new();
        for part in parts {
            let (hole, after) = part.split_once('}').unwrap_or(("", part));
            takes_numbers.push(hole == "n");
            pieces.push(after.to_string());
        }
        Phrase { pieces, takes_numbers, told: Vec::new() }
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
    fn holes<'t>(&self, text: &'t str) -> Option<Vec<&'t str>> {
        let mut holes = Vec::new();
        let rest = text.strip_prefix(self.pieces[0].as_str())?;
        self.fill(rest, &mut holes).then_some(holes)
    }

    fn fill<'t>(&self, text: &'t str, holes: &mut Vec<&'t str>) -> bool {
        let hole = holes.len();
        let Some(piece) = self.pieces.get(hole + 1) else { return text.is_empty() };
        let fits = |filling: &str| match self.takes_numbers[hole] {
            true => Number::read(filling).is_some(),
            false => !filling.is_empty(),
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
        phrases.sort_by_key(|phrase| std::cmp::Reverse(phrase.length()));
        let whole =
            phrases.iter().enumerate().filter(|(_, phrase)| phrase.takes_numbers.is_empty());
        let by_text = whole.map(|(k, phrase)| (phrase.pieces[0].clone(), k)).collect();
        Ok(Phrasebook { phrases, by_text, numbers, asked: RefCell::default() })
    }

    /// A text of the page in the other language; None where the phrasebook has no word of it.
    pub fn tell(&self, english: &str) -> Option<String> {
        let bare = english.trim().trim_matches(GLUE);
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
        self.known(text).or_else(|| self.number(text)).or_else(|| self.filled(text, 1)).or_else(
            || {
                // A sentence that others follow was cut off before its end.
                if text.ends_with(['.', '…', '?', '!']) {
                    return None;
                }
                let whole = format!("{text}.");
                let told = self.known(&whole).or_else(|| self.filled(&whole, 2))?;
                Some(told.trim_end_matches(['.', '。']).to_string())
            },
        )
    }

    /// A text without holes, at the start of a sentence or within it.
    fn known(&self, text: &str) -> Option<String> {
        let told = |text: &str| Some(self.phrases[*self.by_text.get(text)?].told[0].1.clone());
        told(text).or_else(|| {
            let lower = with_first(text, |c| c.to_lowercase().collect())?;
            with_first(&told(&lower)?, |c| c.to_uppercase().collect())
        })
    }

    fn number(&self, text: &str) -> Option<String> {
        let digits = text.strip_suffix('%').unwrap_or(text);
        let Number { value, decimals, grouped } = Number::read(digits)?;
        Some(self.numbers.written(value, decimals, grouped) + &text[digits.len()..])
    }

    /// A text by the first phrase with holes that says it and is so long at least.
    fn filled(&self, text: &str, least_length: usize) -> Option<String> {
        let long = self.phrases.iter().take_while(|phrase| phrase.length() >= least_length);
        long.filter(|phrase| !phrase.takes_numbers.is_empty()).find_map(|phrase| {
            let holes = phrase.holes(text)?;
            // What runs over the end of a sentence is no part of another.
            if !phrase.is_punctuation() && holes.iter().any(|hole| has_end(hole)) {
                return None;
            }
            let told: Vec<Option<String>> = holes.iter().map(|hole| self.tell(hole)).collect();
            // What joins nothing that is known may as well be somebody's own text.
            let is_known = |(hole, told): (&&str, &Option<String>)| {
                told.is_some() && Number::read(hole).is_none()
            };
            if phrase.is_punctuation() && !holes.iter().zip(&told).any(is_known) {
                return None;
            }
            let fillings: Vec<String> = told
                .into_iter()
                .zip(&holes)
                .map(|(told, hole)| told.unwrap_or_else(|| hole.to_string()))
                .collect();
            Some(fill(self.form(phrase, &holes), &fillings))
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
