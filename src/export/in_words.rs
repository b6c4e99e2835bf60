//! The pattern of a day in words, for who hears the page: patches too, which have to be counted first.

use super::days::DayNumbers;
use crate::plants::Plant;
use crate::play::words::grouped;

/// What a part is of the whole, in the words that most people have for it.
const FRACTIONS: [(f64, &str); 15] = [
    (1.0, "all"),
    (0.9, "nine tenths"),
    (3.0 / 4.0, "three quarters"),
    (2.0 / 3.0, "two thirds"),
    (1.0 / 2.0, "half"),
    (1.0 / 3.0, "a third"),
    (1.0 / 4.0, "a quarter"),
    (1.0 / 5.0, "a fifth"),
    (1.0 / 6.0, "a sixth"),
    (1.0 / 8.0, "an eighth"),
    (1.0 / 10.0, "a tenth"),
    (1.0 / 20.0, "a twentieth"),
    (1.0 / 50.0, "a fiftieth"),
    (1.0 / 100.0, "a hundredth"),
    (1.0 / 1000.0, "a thousandth"),
];
/// Of less than that there is one word only.
const LEAST_FRACTION: f64 = 0.0005;

/// A day in words, colour by colour, and whether there is more of it than before: `Day 12, of the surface: 43 in 100
/// yellow, in 212 patches, the largest a fifth of a leaf; more than on day 11.` `leaves` is how many the plant has,
/// 0 of one that is no leaves. What was before is told by its day where it is of the same growth.
pub fn pattern_in_words(
    plant: &Plant,
    leaves: u32,
    now: &DayNumbers,
    before: Option<(&DayNumbers, bool)>,
) -> String {
    let colours = [0, 2, 1].into_iter().filter(|&k| !plant.colour_names[k].is_empty());
    let told: Vec<String> = colours
        .map(|k| {
            let told = colour(plant.colour_names[k], k, leaves, now);
            match before {
                None => format!("{told}."),
                Some((was, is_same)) => format!("{told}; {}.", compared(k, now, was, is_same)),
            }
        })
        .collect();
    format!("Day {}, of the surface: {}", now.day, told.join(" "))
}

/// One colour of a day.
fn colour(name: &str, k: usize, leaves: u32, now: &DayNumbers) -> String {
    let pattern = &now.pattern;
    let percent = in_hundred(pattern.area_shares[k]);
    let largest = pattern.largest_areas[k];
    let of = match leaves {
        0 => largest,
        leaves => largest * f64::from(leaves),
    };
    let (largest, what) = (fraction(of), ["it", "the leaf", "a leaf"][leaves.min(2) as usize]);
    match pattern.patches[k] {
        0 => format!("nothing {name}"),
        1 => format!("{percent} in 100 {name}, in one patch, {largest} of {what}"),
        patches => {
            let patches = grouped(patches);
            format!(
                "{percent} in 100 {name}, in {patches} patches, the largest {largest} of {what}"
            )
        }
    }
}

fn compared(k: usize, now: &DayNumbers, was: &DayNumbers, is_same: bool) -> String {
    let [is, before] = [now, was].map(|day| in_hundred(day.pattern.area_shares[k]));
    let is_more = now.pattern.area_shares[k] > was.pattern.area_shares[k];
    let than = if is_same { format!("on day {}", was.day) } else { "before".to_string() };
    match () {
        () if is == before => format!("as much as {than}"),
        () if is_more => format!("more than {than}"),
        () => format!("less than {than}"),
    }
}

/// A share in a hundred, never none or all where it is not: `43`, `under 1`.
fn in_hundred(share: f64) -> String {
    match (share * 100.0).round() as u32 {
        0 if share > 0.0 => "under 1".to_string(),
        100.. if share < 1.0 => "over 99".to_string(),
        percent => percent.to_string(),
    }
}

/// The nearest of `FRACTIONS`, by their ratio.
fn fraction(share: f64) -> &'static str {
    if share < LEAST_FRACTION {
        return "less than a thousandth";
    }
    let far = |&(part, _): &(f64, &str)| (share / part).max(part / share);
    let nearest = FRACTIONS.iter().min_by(|a, b| far(a).total_cmp(&far(b)));
    nearest.map_or("", |(_, words)| words)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mosaic::Pattern;
    use crate::plants;
    use crate::tissue::{CLAN_STEPS, DayCount};

    fn day(day: u32, yellow: f64, patches: [u32; 3], largest: f64) -> DayNumbers {
        let pattern = Pattern {
            count: DayCount { cells: 9, by_type: [5, 4, 0] },
            area_shares: [yellow, 1.0 - yellow, 0.0],
            patches,
            largest_patches: [4, 3, 0],
            largest_areas: [largest, 0.9, 0.0],
            mixed_edges: 0.0,
        };
        let clans = [0; CLAN_STEPS];
        DayNumbers { day, pattern, expected: None, clans, expected_clans: None }
    }

    #[test]
    fn a_day_is_told_colour_by_colour_against_the_one_before() {
        let croton = plants::find("croton").expect("a plant");
        let (eleven, twelve) = (day(11, 0.4, [230, 3, 0], 0.02), day(12, 0.43, [1212, 1, 0], 0.03));
        assert_eq!(
            pattern_in_words(croton, 7, &twelve, Some((&eleven, true))),
            "Day 12, of the surface: 43 in 100 yellow, in 1,212 patches, the largest a fifth of a leaf; more than on \
             day 11. 57 in 100 green, in one patch, all of a leaf; less than on day 11."
        );
        assert_eq!(
            pattern_in_words(croton, 0, &eleven, Some((&eleven, false))),
            "Day 11, of the surface: 40 in 100 yellow, in 230 patches, the largest a fiftieth of it; as much as \
             before. 60 in 100 green, in 3 patches, the largest nine tenths of it; as much as before."
        );
    }

    #[test]
    fn what_is_hardly_there_is_neither_none_nor_all() {
        let croton = plants::find("croton").expect("a plant");
        let told = pattern_in_words(croton, 1, &day(0, 0.0004, [2, 1, 0], 0.0003), None);
        assert_eq!(
            told,
            "Day 0, of the surface: under 1 in 100 yellow, in 2 patches, the largest less than a thousandth of the \
             leaf. over 99 in 100 green, in one patch, nine tenths of the leaf."
        );
        let none = pattern_in_words(croton, 1, &day(0, 0.0, [0, 1, 0], 0.0), None);
        assert!(
            none.starts_with("Day 0, of the surface: nothing yellow. 100 in 100 green"),
            "{none}"
        );
        assert_eq!([1.1, 0.36, 0.0006].map(fraction), ["all", "a third", "a thousandth"]);
    }
}
