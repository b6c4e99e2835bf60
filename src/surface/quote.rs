//! Text of a visitor's own, as messages repeat it.

/// As many characters of it are repeated.
const MOST_CHARACTERS: usize = 40;

/// A text in quotation marks, safe to print: at most 40 characters of it, then `…`, and `�` in the place
/// of each one that would steer a terminal or turn the line around instead of being seen.
pub fn quoted(text: &str) -> String {
    let mut characters = text.chars();
    let mut quoted = String::from('"');
    quoted.extend(characters.by_ref().take(MOST_CHARACTERS).map(visible));
    if characters.next().is_some() {
        quoted.push('…');
    }
    quoted.push('"');
    quoted
}

/// Whether a text has a part. `str::contains` reports where, in so many cases that it is a kilobyte.
pub fn holds(text: &str, part: &str) -> bool {
    part.is_empty() || text.as_bytes().windows(part.len()).any(|bytes| bytes == part.as_bytes())
}

/// A text with words in the place of the names in it that stand in braces, as `{F}` does.
pub fn filled(text: &str, names: &[(&str, &str)]) -> String {
    let mut parts = text.split('{');
    let mut filled = parts.next().unwrap_or_default().to_string();
    for part in parts {
        let (name, rest) = part.split_once('}').unwrap_or((part, ""));
        filled.extend(names.iter().filter(|(known, _)| *known == name).map(|(_, word)| *word));
        filled += rest;
    }
    filled
}

fn visible(character: char) -> char {
    let turns_the_line = matches!(
        character,
        '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}'
    );
    if character.is_control() || turns_the_line { '\u{fffd}' } else { character }
}

#[cfg(test)]
mod tests {
    use super::{filled, holds, quoted};

    #[test]
    fn plain_words_stay_as_they_are() {
        assert_eq!(quoted(""), "\"\"");
        assert_eq!(quoted("1,5 né 葉"), "\"1,5 né 葉\"");
        let forty = "é".repeat(40);
        assert_eq!(quoted(&forty), format!("\"{forty}\""));
    }

    #[test]
    fn parts_are_found() {
        for text in ["", "a", "ab", "aab", "béa", "abab"] {
            for part in ["", "a", "ab", "b", "é", "abc"] {
                assert_eq!(holds(text, part), text.contains(part), "{text} {part}");
            }
        }
    }

    #[test]
    fn names_in_braces_are_filled_in() {
        let names = [("F", "yellow"), ("most", "9")];
        assert_eq!(filled("{F} and {F}: {most}.", &names), "yellow and yellow: 9.");
        assert_eq!(filled("none", &names), "none");
    }

    #[test]
    fn nothing_steers_a_terminal_and_long_text_is_shortened() {
        assert_eq!(quoted("\x1b[31mred"), "\"\u{fffd}[31mred\"");
        assert_eq!(
            quoted("a\r\n\t\0\u{9b}\u{7f}b"),
            "\"a\u{fffd}\u{fffd}\u{fffd}\u{fffd}\u{fffd}\u{fffd}b\""
        );
        assert_eq!(quoted("\u{202e}txt\u{2066}\u{200f}"), "\"\u{fffd}txt\u{fffd}\u{fffd}\"");
        assert_eq!(quoted(&"x".repeat(1_000_000)), format!("\"{}…\"", "x".repeat(40)));
    }
}
