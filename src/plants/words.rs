//! A plant as plain words, in the order of its fields: what one bundle of a build hands to another. The reader of
//! JSON, which knows every field by its name, would weigh more than the page has room for.

use super::paint::{
    Bands, Belts, Blaze, Cube, Grain, Image, ImageRule, Margins, Paint, Pixels, Rims, Stripes,
    Warts,
};
use super::{
    Growths, GuideVector, Guides, Levels, List, Look, MeshFile, Motion, Plant, Shape, Skin,
    Stretch, Text, View, all,
};
use crate::surface::{AlongVeins, Cylinder, Wrap};
use crate::tissue::{CellType, Clock, Recipe, Scaled, Use};
use glam::{Vec2, Vec3};

/// What can be said in words of 32 bits.
pub trait Words: Sized {
    fn push(&self, words: &mut Vec<u32>);
    /// Takes it off the front; none where these are no words of ours.
    fn take(words: &mut &[u32]) -> Option<Self>;
}

impl Words for u32 {
    fn push(&self, words: &mut Vec<u32>) {
        words.push(*self);
    }

    fn take(words: &mut &[u32]) -> Option<u32> {
        let (&first, rest) = words.split_first()?;
        *words = rest;
        Some(first)
    }
}

/// What is said as something else.
macro_rules! as_another {
    ($($type:ty as $other:ty: $to:expr, $from:expr;)*) => {$(
        impl Words for $type {
            fn push(&self, words: &mut Vec<u32>) {
                let to: fn(&$type) -> $other = $to;
                to(self).push(words);
            }

            fn take(words: &mut &[u32]) -> Option<$type> {
                let from: fn($other) -> Option<$type> = $from;
                from(<$other>::take(words)?)
            }
        }
    )*};
}

as_another! {
    f32 as u32: |x| x.to_bits(), |x| Some(f32::from_bits(x));
    f64 as [u32; 2]: |x| [(x.to_bits() >> 32) as u32, x.to_bits() as u32],
        |[high, low]| Some(f64::from_bits(u64::from(high) << 32 | u64::from(low)));
    bool as u32: |x| u32::from(*x), |x| Some(x != 0);
    Vec2 as [f32; 2]: |x| x.to_array(), |x| Some(x.into());
    Vec3 as [f32; 3]: |x| x.to_array(), |x| Some(x.into());
    CellType as u32: |x| *x as u32, |x| CellType::ALL.get(x as usize).copied();
    MeshFile as Text: |x| x.name, |name| {
        all().iter().map(|plant| plant.body.mesh).find(|mesh| mesh.name == name)
    };
}

impl Words for Text {
    fn push(&self, words: &mut Vec<u32>) {
        words.push(self.len() as u32);
        words.extend(self.bytes().map(u32::from));
    }

    fn take(words: &mut &[u32]) -> Option<Text> {
        let length = u32::take(words)? as usize;
        let (bytes, rest) = words.split_at_checked(length)?;
        *words = rest;
        let bytes = bytes.iter().map(|&byte| byte as u8).collect();
        Some(String::from_utf8(bytes).ok()?.leak())
    }
}

impl<T: Words> Words for List<T> {
    fn push(&self, words: &mut Vec<u32>) {
        words.push(self.len() as u32);
        self.iter().for_each(|item| item.push(words));
    }

    fn take(words: &mut &[u32]) -> Option<List<T>> {
        let length = u32::take(words)?;
        let items: Option<Vec<T>> = (0..length).map(|_| T::take(words)).collect();
        Some(items?.leak())
    }
}

impl<T: Words, const N: usize> Words for [T; N] {
    fn push(&self, words: &mut Vec<u32>) {
        self.iter().for_each(|item| item.push(words));
    }

    fn take(words: &mut &[u32]) -> Option<[T; N]> {
        let items: Option<Vec<T>> = (0..N).map(|_| T::take(words)).collect();
        items?.try_into().ok()
    }
}

impl<T: Words> Words for Option<T> {
    fn push(&self, words: &mut Vec<u32>) {
        self.is_some().push(words);
        self.iter().for_each(|item| item.push(words));
    }

    fn take(words: &mut &[u32]) -> Option<Option<T>> {
        Some(if bool::take(words)? { Some(T::take(words)?) } else { None })
    }
}

/// Rows and records, field by field.
macro_rules! records {
    ($($type:ty { $($field:tt),* })*) => {$(
        impl Words for $type {
            fn push(&self, words: &mut Vec<u32>) {
                $(self.$field.push(words);)*
            }

            fn take(words: &mut &[u32]) -> Option<$type> {
                Some(Self { $($field: Words::take(words)?),* })
            }
        }
    )*};
}

records! {
    Plant { key, name, latin, source, colour_names, body, paint, guides, recipe, motion, look, view, first_day }
    Shape { mesh, levels, but, growths }
    Levels { group, levels }
    Paint { wrap, image, use_as }
    Cylinder { base, axis, zero, height }
    AlongVeins { order, reach_cm }
    Image { width, height, rule }
    Grain { black_at_the_top }
    Stripes { count, half_width, varies_between, varies_along, wander, teeth, cube }
    Cube { half_side_cm, bulge_cm }
    Belts { height_cm, near_cm, far_cm, lobes_cm }
    Blaze { all, none, uneven, strokes, broad, lean }
    Warts { radius_cm, height_cm, count, wart_radius_cm }
    Rims { caps_cm, height_cm }
    Margins { margin_cm }
    Bands { apart_cm, share, share_varies, zigzag_cm }
    Pixels { rows }
    Guides { epsilon_per_cm, vectors }
    Recipe { initial_cells, initial_probability, division_days, clock, mutation, adhesion, radius_scale, repulsion,
        anisotropy, initial_relaxations, relaxations_per_day, days, max_cells }
    Motion { unfolding_days, growth }
    Stretch { day, factors }
    Look { cells, tinted, variation, border, gloss, skin, veins, bare }
    Skin { gloss, raised, through, wax, unevenness }
    View { azimuth_deg, elevation_deg, zoom }
}

impl<A: Words, B: Words> Words for (A, B) {
    fn push(&self, words: &mut Vec<u32>) {
        self.0.push(words);
        self.1.push(words);
    }

    fn take(words: &mut &[u32]) -> Option<(A, B)> {
        Some((A::take(words)?, B::take(words)?))
    }
}

impl<A: Words, B: Words, C: Words> Words for (A, B, C) {
    fn push(&self, words: &mut Vec<u32>) {
        self.0.push(words);
        self.1.push(words);
        self.2.push(words);
    }

    fn take(words: &mut &[u32]) -> Option<(A, B, C)> {
        Some((A::take(words)?, B::take(words)?, C::take(words)?))
    }
}

/// One of several: its number, and what it has.
macro_rules! choices {
    ($($type:ident { $($number:literal: $variant:ident { $($field:tt: $name:ident),* }),* })*) => {$(
        impl Words for $type {
            fn push(&self, words: &mut Vec<u32>) {
                match self {
                    $($type::$variant { $($field: $name),* } => {
                        words.push($number);
                        $($name.push(words);)*
                    })*
                }
            }

            fn take(words: &mut &[u32]) -> Option<$type> {
                Some(match u32::take(words)? {
                    $($number => $type::$variant { $($field: Words::take(words)?),* },)*
                    _ => return None,
                })
            }
        }
    )*};
}

choices! {
    Growths { 0: Nothing {}, 1: Spines {}, 2: Moss {} }
    Wrap { 0: Cylinder { 0: cylinder }, 1: Leaf {}, 2: Veins { 0: along } }
    ImageRule { 0: Grain { 0: rule }, 1: Stripes { 0: rule }, 2: Belts { 0: rule }, 3: Blaze { 0: rule },
        4: Warts { 0: rule }, 5: Rims { 0: rule }, 6: Margins { 0: rule }, 7: Bands { 0: rule },
        8: Pixels { 0: rule } }
    Use { 0: FirstCells { of: of, instead: instead }, 1: Scale { number: number, black: black, white: white },
        2: Colour { of: of } }
    Scaled { 0: DivisionDays { 0: kind }, 1: RadiusScale {}, 2: Repulsion {}, 3: Adhesion { 0: a, 1: b } }
    GuideVector { 0: OnLeaves { at: at, direction: direction },
        1: Near { point_cm: point, direction: direction }, 2: AlongVeins { order: order } }
    Clock { 0: Poisson {}, 1: Exponential {} }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_plant_comes_back_bit_for_bit() {
        for plant in all() {
            let mut words = Vec::new();
            plant.push(&mut words);
            let mut rest = &words[..];
            assert_eq!(Plant::take(&mut rest).as_ref(), Some(plant), "{}", plant.key);
            assert!(rest.is_empty());
            for cut in 0..words.len() {
                assert_eq!(Plant::take(&mut &words[..cut]), None, "{} words", cut);
            }
        }
    }

    #[test]
    fn what_the_catalogue_does_not_use_comes_back_too() {
        let all = (
            (
                Some(2.5_f64),
                [Scaled::Repulsion, Scaled::Adhesion(CellType::Middle, CellType::Foreground)],
            ),
            (Clock::Exponential, Growths::Moss),
            Pixels { rows: &["0f", "é"] },
        );
        let mut words = Vec::new();
        all.push(&mut words);
        assert_eq!(Words::take(&mut &words[..]), Some(all));
        assert_eq!(Text::take(&mut &[u32::MAX, 1][..]), None);
        assert_eq!(Clock::take(&mut &[2][..]), None);
    }
}
