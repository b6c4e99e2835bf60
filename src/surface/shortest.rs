//! Writes numbers as `Display` does: with as few digits as tell them from their neighbours. That one brings two ways
//! to find these and a table into the page, nine kilobytes. Here it is the older of the two alone, by Steele and White
//! (1990, "How to print floating-point numbers accurately").

use super::decimal::Natural;
use std::cmp::Ordering;

/// Numbers that are told from all others of their kind by some decimal digits.
pub trait Shortest {
    /// The shortest text that is read back as this number, and of these the nearest to it; never with an exponent.
    fn shortest(self) -> String;
}

impl Shortest for f64 {
    fn shortest(self) -> String {
        let bits = self.to_bits();
        text(self, (bits >> 52) as i64 & 0x7ff, bits & ((1 << 52) - 1), 52, 1075)
    }
}

impl Shortest for f32 {
    fn shortest(self) -> String {
        let bits = self.to_bits();
        let fraction = u64::from(bits) & ((1 << 23) - 1);
        text(f64::from(self), i64::from(bits >> 23 & 0xff), fraction, 23, 150)
    }
}

/// A number to the nearest of `parts` parts of 1, which is a power of ten, without zeros at its end.
pub fn rounded(number: f64, parts: f64) -> String {
    ((number * parts).round() / parts).shortest()
}

/// `clamp` without its panic, which would bring the other ways of writing numbers along.
pub fn limited<T: PartialOrd>(number: T, least: T, most: T) -> T {
    if number < least {
        least
    } else if number > most {
        most
    } else {
        number
    }
}

/// `biased` and `fraction` are the parts of the number as it is stored, which has `width` bits after the first.
fn text(number: f64, biased: i64, fraction: u64, width: i64, bias: i64) -> String {
    if !number.is_finite() {
        return if number.is_nan() {
            "NaN"
        } else if number > 0.0 {
            "inf"
        } else {
            "-inf"
        }
        .into();
    }
    let mut text = String::from(if number.is_sign_negative() { "-" } else { "" });
    // Numbers whose first bit is not stored; the others are small.
    let is_normal = biased > 0;
    let mantissa = fraction + (u64::from(is_normal) << width);
    if mantissa == 0 {
        return text + "0";
    }
    let exponent = biased.max(1) - bias;
    let is_even = mantissa.is_multiple_of(2);
    // Below a power of two its neighbours lie twice as close.
    let is_closer_below = fraction == 0 && biased > 1;
    let (digits, power) = digits(mantissa, exponent, is_even, is_closer_below);
    let count = digits.len() as i64;
    if power <= 0 {
        text.push_str("0.");
    }
    (power..0).for_each(|_| text.push('0'));
    for (place, digit) in (0..).zip(digits) {
        if place == power && place > 0 {
            text.push('.');
        }
        text.push(char::from(b'0' + digit));
    }
    (count..power).for_each(|_| text.push('0'));
    text
}

/// The digits of `mantissa * 2^exponent`, and the power of ten before whose first one the point would stand.
fn digits(mantissa: u64, exponent: i64, is_even: bool, is_closer_below: bool) -> (Vec<u8>, i64) {
    // The number is `rest / whole`; all that lies nearer to it than `above / whole` over it or `below / whole`
    // under it is read as this number, and what lies just there if it is even.
    let mut rest = Natural::new(4 * mantissa);
    let mut whole = Natural::new(4);
    let (mut above, mut below) =
        (Natural::new(2), Natural::new(if is_closer_below { 1 } else { 2 }));
    if exponent > 0 {
        for number in [&mut rest, &mut above, &mut below] {
            number.shift(exponent);
        }
    } else {
        whole.shift(-exponent);
    }
    let counts = |order: Ordering| order.is_lt() || is_even && order.is_eq();
    let reaches = |rest: &Natural, above: &Natural, whole: &Natural| {
        let mut gap = whole.clone();
        rest.compare(whole).is_ge() || {
            gap.minus(rest);
            counts(gap.compare(above))
        }
    };
    let mut power = 0;
    while reaches(&rest, &above, &whole) {
        whole.times_plus(10, 0);
        power += 1;
    }
    let mut digits = Vec::new();
    loop {
        for number in [&mut rest, &mut above, &mut below] {
            number.times_plus(10, 0);
        }
        if digits.is_empty() && !reaches(&rest, &above, &whole) {
            power -= 1;
            continue;
        }
        let mut digit = 0;
        while rest.compare(&whole).is_ge() {
            rest.minus(&whole);
            digit += 1;
        }
        let (is_low, is_high) = (counts(rest.compare(&below)), reaches(&rest, &above, &whole));
        if is_low || is_high {
            rest.times_plus(2, 0);
            digits.push(digit + u8::from(is_high && !(is_low && rest.compare(&whole).is_lt())));
            return (digits, power);
        }
        digits.push(digit);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(bits: u64) {
        let (long, short) = (f64::from_bits(bits), f32::from_bits(bits as u32));
        assert_eq!(long.shortest(), long.to_string(), "{bits:x}");
        assert_eq!(short.shortest(), short.to_string(), "{bits:x}");
    }

    #[test]
    fn numbers_are_written_as_the_standard_library_writes_them() {
        let mut bits = 1_u64;
        for _ in 0..4_000 {
            bits = bits
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            check(bits);
            check(bits.rotate_left(32));
        }
    }

    #[test]
    fn powers_of_two_and_their_neighbours_too() {
        for biased in 0..=2047_u64 {
            for near in [u64::MAX, 0, 1, 2] {
                let near = (biased << 52).wrapping_add(near);
                assert_eq!(f64::from_bits(near).shortest(), f64::from_bits(near).to_string());
            }
        }
        for biased in 0..=255_u64 {
            (-2..=2).for_each(|near| check((biased << 23).wrapping_add_signed(near)));
        }
        check(1 << 63 | 1 << 31);
    }

    #[test]
    fn the_numbers_of_sliders_and_their_sums_too() {
        for k in 0..20_000 {
            let number = f64::from(k - 10_000);
            for number in
                [number, number / 1000.0, number * 0.05, 10_f64.powi(k % 23), 1e-9 * number]
            {
                assert_eq!(number.shortest(), number.to_string());
                assert_eq!((number as f32).shortest(), (number as f32).to_string());
            }
        }
    }

    #[test]
    fn decimals_at_the_end_are_left_away() {
        for (number, parts, told) in [
            (12.0, 1e3, "12"),
            (0.123_456, 1e3, "0.123"),
            (2.5, 1e3, "2.5"),
            (99.96, 10.0, "100"),
            (0.0, 10.0, "0"),
        ] {
            assert_eq!(rounded(number, parts), told);
        }
    }
}
