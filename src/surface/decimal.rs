//! Reads decimal numbers as `str::parse` does, to the last bit. That one brings a table of ten kilobytes into the
//! page, which nothing compresses; the numbers of meshes and links are short, and need none.

use std::cmp::Ordering;

/// As many digits of a number count; if there are others, a 1 behind them stands for all: no number lies so near to
/// the middle of two that it would take more.
const MOST_DIGITS: usize = 800;

/// The number that a word says, the nearest that an f64 can hold: digits with or without a point, sign and exponent
/// (`-1.5e3`), or `inf`, `infinity` and `nan` in letters of any case. None if it says none.
pub fn decimal(word: &str) -> Option<f64> {
    let bytes = word.as_bytes();
    let (is_negative, rest) = match bytes {
        [b'-', rest @ ..] => (true, rest),
        [b'+', rest @ ..] => (false, rest),
        rest => (false, rest),
    };
    let size = match () {
        _ if rest.eq_ignore_ascii_case(b"inf") || rest.eq_ignore_ascii_case(b"infinity") => {
            f64::INFINITY
        }
        _ if rest.eq_ignore_ascii_case(b"nan") => f64::NAN,
        _ => unsigned(rest)?,
    };
    Some(if is_negative { -size } else { size })
}

fn unsigned(bytes: &[u8]) -> Option<f64> {
    let at_e = bytes.iter().position(|byte| matches!(byte, b'e' | b'E'));
    let (digits, exponent) = match at_e {
        Some(at) => (&bytes[..at], whole(&bytes[at + 1..])?),
        None => (bytes, 0),
    };
    // The digits from the first on that is not 0, and the power of ten of the last.
    let mut significant = Vec::with_capacity(digits.len().min(MOST_DIGITS + 1));
    let (mut power, mut seen, mut past_point) = (exponent, false, false);
    for &byte in digits {
        match byte {
            b'.' if !past_point => past_point = true,
            b'0'..=b'9' => {
                seen = true;
                let counts = byte != b'0' || !significant.is_empty();
                if counts && significant.len() < MOST_DIGITS {
                    significant.push(byte - b'0');
                    power -= i64::from(past_point);
                } else if counts {
                    if byte != b'0' && significant.len() == MOST_DIGITS {
                        significant.push(1);
                        power -= 1;
                    }
                    power += i64::from(!past_point);
                } else {
                    power -= i64::from(past_point);
                }
            }
            _ => return None,
        }
    }
    if !seen {
        return None;
    }
    let size = power + significant.len() as i64;
    match () {
        _ if significant.is_empty() || size < -330 => Some(0.0),
        _ if size > 310 => Some(f64::INFINITY),
        _ if significant.len() <= 15 && power.abs() <= 22 => {
            // Both are exact, and so what is rounded is rounded once.
            let digits = significant.iter().fold(0.0, |sum, &digit| 10.0 * sum + f64::from(digit));
            let scale = (0..power.abs()).fold(1.0, |scale, _| 10.0 * scale);
            Some(if power < 0 { digits / scale } else { digits * scale })
        }
        _ => Some(nearest(&significant, power)),
    }
}

/// A whole number, which is cut where it is larger than any exponent that counts.
fn whole(bytes: &[u8]) -> Option<i64> {
    let (sign, digits) = match bytes {
        [b'-', digits @ ..] => (-1, digits),
        [b'+', digits @ ..] => (1, digits),
        digits => (1, digits),
    };
    let sum = |sum: i64, &byte: &u8| {
        byte.is_ascii_digit().then(|| (10 * sum + i64::from(byte - b'0')).min(1 << 40))
    };
    if digits.is_empty() { None } else { digits.iter().try_fold(0, sum).map(|size| sign * size) }
}

/// The nearest f64 of `digits * 10^power`, and of two the even one: by long division in binary.
fn nearest(digits: &[u8], power: i64) -> f64 {
    let (mut rest, mut divisor) = (Natural(Vec::new()), Natural(vec![1]));
    digits.iter().for_each(|&digit| rest.times_plus(10, digit.into()));
    let scaled = if power < 0 { &mut divisor } else { &mut rest };
    (0..power.abs()).for_each(|_| scaled.times_plus(10, 0));
    // Both are shifted until the quotient is at least 1 and under 2: it is its first bit's power of two.
    let mut exponent = rest.bits() - divisor.bits();
    if exponent > 0 {
        divisor.shift(exponent)
    } else {
        rest.shift(-exponent)
    }
    if rest.compare(&divisor).is_lt() {
        rest.shift(1);
        exponent -= 1;
    }
    // Small numbers have fewer bits.
    let count = (53 + (exponent + 1022).min(0)).max(0);
    let mut bits = 0_u64;
    // One more than there is room for tells on which side of the middle it lies.
    for _ in 0..=count {
        bits <<= 1;
        if rest.compare(&divisor).is_ge() {
            rest.minus(&divisor);
            bits |= 1;
        }
        rest.shift(1);
    }
    let rounds_up = bits & 1 == 1 && (bits & 2 == 2 || !rest.is_zero());
    let is_too_small = exponent < -1022 - 53;
    let bits = (bits >> 1) + u64::from(rounds_up && !is_too_small);
    // The first bit of numbers that are not small is not written down; a carry makes the exponent one larger.
    let above = if exponent >= -1022 { ((exponent + 1022) as u64) << 52 } else { 0 };
    if exponent > 1023 { f64::INFINITY } else { f64::from_bits(above + bits) }
}

/// A whole number of any size: 32 bits each, the least first, none of the last being 0.
#[derive(Clone)]
pub(super) struct Natural(Vec<u32>);

impl Natural {
    pub(super) fn new(number: u64) -> Natural {
        let mut natural = Natural(vec![number as u32, (number >> 32) as u32]);
        natural.trim();
        natural
    }

    pub(super) fn times_plus(&mut self, factor: u32, summand: u32) {
        let mut carry = u64::from(summand);
        for part in &mut self.0 {
            carry += u64::from(*part) * u64::from(factor);
            *part = carry as u32;
            carry >>= 32;
        }
        if carry > 0 {
            self.0.push(carry as u32);
        }
    }

    fn bits(&self) -> i64 {
        let last = self.0.last().map_or(0, |part| 32 - i64::from(part.leading_zeros()));
        32 * (self.0.len() as i64 - 1).max(0) + last
    }

    /// Doubles it so often.
    pub(super) fn shift(&mut self, times: i64) {
        for _ in 0..times / 32 {
            self.0.insert(0, 0);
        }
        self.times_plus(1 << (times % 32), 0);
        self.trim();
    }

    pub(super) fn compare(&self, other: &Natural) -> Ordering {
        let by_length = self.0.len().cmp(&other.0.len());
        by_length.then_with(|| self.0.iter().rev().cmp(other.0.iter().rev()))
    }

    /// Takes one away that is not larger.
    pub(super) fn minus(&mut self, other: &Natural) {
        let mut borrow = 0_i64;
        for (k, part) in self.0.iter_mut().enumerate() {
            let next = i64::from(*part) - i64::from(other.0.get(k).copied().unwrap_or(0)) + borrow;
            *part = next as u32;
            borrow = next >> 32;
        }
        self.trim();
    }

    fn trim(&mut self) {
        while self.0.last() == Some(&0) {
            self.0.pop();
        }
    }

    fn is_zero(&self) -> bool {
        self.0.is_empty()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether a word is read as the standard library reads it, bit for bit.
    fn check(word: &str) {
        let ours = decimal(word).map(f64::to_bits);
        let theirs = word.parse::<f64>().ok().map(f64::to_bits);
        assert_eq!(ours, theirs, "{word}");
    }

    fn bits(k: u64) -> u64 {
        let mut z = k.wrapping_mul(0x9e37_79b9_7f4a_7c15);
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    #[test]
    fn numbers_of_any_bits_are_read_to_the_last_one() {
        for k in 0..20_000 {
            let number = f64::from_bits(bits(k));
            if number.is_finite() {
                check(&format!("{number:?}"));
                check(&format!("{number:e}"));
                // More digits than it takes, and fewer.
                check(&format!("{number:.25e}"));
                check(&format!("{number:.9e}"));
            }
            let short = bits(k) as u32 as f32 / 1e4;
            check(&short.to_string());
            check(&format!("{}", bits(k) % 1_000_000_000_000));
        }
    }

    #[test]
    fn the_middle_of_two_goes_to_the_even_one() {
        for k in 0..2_000 {
            // A number with one bit more than there is room for, in all its digits.
            let number = (1_u128 << 53 | u128::from(bits(k) >> 11)) << 1 | 1;
            for shift in [0, 1, 30, 60] {
                let middle = number << shift;
                check(&middle.to_string());
                check(&format!("{}e-1", 10 * middle + 1));
                check(&format!("{middle}.0000000000000000000000000000000000000000000000000000001"));
                check(&(middle - 1).to_string());
            }
        }
        let long = format!("0.{}", "9".repeat(2_000));
        check(&long);
        check(&format!("9007199254740993.{}1", "0".repeat(1_500)));
        check(&format!("9007199254740993{}", "0".repeat(200)));
    }

    #[test]
    fn small_and_large_ones_too() {
        for exponent in -345..=312 {
            for digits in [
                "1",
                "4.9406564584124654",
                "2.2250738585072014",
                "1.7976931348623157",
                "9.99",
                "2.4703282292062327208",
            ] {
                check(&format!("{digits}e{exponent}"));
                check(&format!("-{digits}E{exponent}"));
            }
        }
        for word in [
            "1.7976931348623158e308",
            "1.7976931348623159e308",
            "2.4703282292062328e-324",
            "2.4703282292062327e-324",
            "1e99999999999999999999",
            "1e-99999999999999999999",
            "0e99999999999999999999",
        ] {
            check(word);
        }
        check(&format!("0.{}1", "0".repeat(400)));
        check(&format!("0.{}1e390", "0".repeat(400)));
        check(&format!("1{}e-390", "0".repeat(400)));
    }

    #[test]
    fn words_that_say_none_are_refused() {
        for word in [
            "",
            "-",
            "+",
            ".",
            "-.",
            "e5",
            ".e5",
            "1e",
            "1e+",
            "1e5.",
            "1.2.3",
            "--1",
            "+-1",
            "1 ",
            " 1",
            "0x10",
            "1_000",
            "1,5",
            "nano",
            "infinit",
            "−1",
            "٣",
            "1e5e5",
            "NaN",
            "-nan",
            "inf",
            "-Infinity",
            "INF",
            "+inf",
            "5.",
            ".5",
            "-0",
            "+0.0",
            "00012",
            "1e05",
            "1E-05",
        ] {
            let ours = decimal(word)
                .map(|x| (x.is_nan(), x.is_nan() || x.is_sign_negative(), x.abs().to_bits()));
            let theirs = word.parse::<f64>().ok();
            let theirs =
                theirs.map(|x| (x.is_nan(), x.is_nan() || x.is_sign_negative(), x.abs().to_bits()));
            assert_eq!(ours.map(|x| x.0), theirs.map(|x| x.0), "{word}");
            assert!(ours.is_none_or(|x| x.0) || ours == theirs, "{word}");
        }
    }
}
