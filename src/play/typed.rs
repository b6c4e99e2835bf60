//! Numbers as people type them.

use crate::surface::decimal;

/// Reads a number that was typed in a field: a decimal comma counts as a point, and in whole numbers
/// commas and points between groups of three digits count as nothing. Not a number if it is none.
pub fn number(text: &str, is_whole: bool) -> f64 {
    let text: String =
        text.chars().filter(|c| !matches!(c, ' ' | '\u{a0}' | '\u{202f}' | '’')).collect();
    let groups = is_whole && is_grouped(&text);
    let read = text.chars().filter_map(|c| match c {
        ',' | '.' if groups => None,
        ',' => Some('.'),
        '−' => Some('-'),
        c => Some(c),
    });
    plain(&read.collect::<String>()).unwrap_or(f64::NAN)
}

/// Reads a number as links have it.
pub fn plain(text: &str) -> Option<f64> {
    decimal(text).filter(|x| x.is_finite())
}

/// `10,000` and `1.000.000`, but not `0,125`.
fn is_grouped(text: &str) -> bool {
    let digits = text.trim_start_matches(['-', '−']);
    let mut groups = digits.split([',', '.']);
    let first = groups.next().unwrap_or_default();
    let begins = (1..=3).contains(&first.len()) && !first.starts_with('0');
    begins && first.len() < digits.len() && groups.all(|group| group.len() == 3)
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn a_decimal_comma_is_understood() {
        for (text, value) in [
            ("6,5", 6.5),
            ("6.5", 6.5),
            (" 0,125 ", 0.125),
            ("−5", -5.0),
            ("1,000", 1.0),
            ("1e2", 100.0),
        ] {
            assert_eq!(number(text, false), value, "{text}");
        }
        assert_eq!(number("6,5", true), 6.5, "to be refused, not taken for 65");
    }

    #[test]
    fn groups_of_digits_are_understood_in_whole_numbers() {
        for text in ["10000", "10,000", "10.000", "10 000", "10’000", "1e4"] {
            assert_eq!(number(text, true), 10_000.0, "{text}");
        }
        assert_eq!(number("1,234,567", true), 1_234_567.0);
        assert_eq!(number("0,125", true), 0.125);
    }

    #[test]
    fn what_is_no_number_is_none() {
        for text in ["", "e", "6,5,4", "1.2.3", "1,234.5", "inf", "NaN", "1e999", "six"] {
            assert!(number(text, false).is_nan(), "{text}");
        }
    }
}
