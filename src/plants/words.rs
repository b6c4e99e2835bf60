//! A plant as plain words, in the order of its fields: what one bundle of a build hands to another. The reader of
//! JSON, which knows every field by its name, would weigh more than the page has room for.

use super::paint::{
    Bands, Belts, Blaze, Cube, Grain, Image, ImageRule, Margins, Paint, Pixels, Rims, Stripes,
    Warts,
};
use super::{
    Growths, GuideVector, Guides, Levels, List, Look, MeshFile, Motion, Plant, Rules, Shape, Skin,
    Stretch, Text, View, all,
};
use crate::surface::{AlongVeins, Cylinder, Wrap};
use crate::tissue::{CellType, Clock, Recipe, Scaled, Use};
use glam::{Vec2, Vec3};

/// What can be said in words of 32 bits.
pub trait Words: Sized {
    fn push(&self, words: &mut Vec<u32>);
    /// Takes it off the front. Where these are no words of ours it is anything, and the reader knows: to ask at each
    /// word whether all is well would be more than half of the reader's bytes.
    fn take(reader: &mut Reader) -> Self;
}

/// Words that are read.
pub struct Reader<'a> {
    words: &'a [u32],
    has_failed: bool,
}

impl Reader<'_> {
    /// What the words say, all of them; none where they are no words of ours.
    pub fn read<T: Words>(words: &[u32]) -> Option<T> {
        let mut reader = Reader { words, has_failed: false };
        let value = T::take(&mut reader);
        (!reader.has_failed && reader.words.is_empty()).then_some(value)
    }

    #[inline(never)]
    fn word(&mut self) -> u32 {
        let Some((&first, rest)) = self.words.split_first() else {
            self.has_failed = true;
            return 0;
        };
        self.words = rest;
        first
    }

    /// How many items follow; each has a word at least, but for those that fail.
    fn length(&mut self) -> usize {
        let length = self.word() as usize;
        self.has_failed |= length > self.words.len();
        length.min(self.words.len())
    }

    /// One of a few.
    fn known<T>(&mut self, found: Option<T>, other: T) -> T {
        self.has_failed |= found.is_none();
        found.unwrap_or(other)
    }
}

impl Words for u32 {
    fn push(&self, words: &mut Vec<u32>) {
        words.push(*self);
    }

    fn take(reader: &mut Reader) -> u32 {
        reader.word()
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

            fn take(reader: &mut Reader) -> $type {
                let from: fn(&mut Reader, $other) -> $type = $from;
                let other = <$other>::take(reader);
                from(reader, other)
            }
        }
    )*};
}

as_another! {
    f32 as u32: |x| x.to_bits(), |_, x| f32::from_bits(x);
    f64 as [u32; 2]: |x| [(x.to_bits() >> 32) as u32, x.to_bits() as u32],
        |_, [high, low]| f64::from_bits(u64::from(high) << 32 | u64::from(low));
    bool as u32: |x| u32::from(*x), |_, x| x != 0;
    Vec2 as [f32; 2]: |x| x.to_array(), |_, x| x.into();
    Vec3 as [f32; 3]: |x| x.to_array(), |_, x| x.into();
    CellType as u32: |x| *x as u32,
        |reader, x| reader.known(CellType::ALL.get(x as usize).copied(), CellType::Background);
    MeshFile as Text: |x| x.name, |reader, name| {
        let mut meshes = all().iter().map(|plant| plant.body.mesh);
        reader.known(meshes.find(|mesh| mesh.name == name), all()[0].body.mesh)
    };
}

impl Words for Text {
    fn push(&self, words: &mut Vec<u32>) {
        words.push(self.len() as u32);
        words.extend(self.bytes().map(u32::from));
    }

    fn take(reader: &mut Reader) -> Text {
        let length = reader.length();
        let bytes = (0..length).map(|_| reader.word() as u8).collect();
        let text = String::from_utf8(bytes).ok();
        reader.known(text, String::new()).leak()
    }
}

impl<T: Words> Words for List<T> {
    fn push(&self, words: &mut Vec<u32>) {
        words.push(self.len() as u32);
        self.iter().for_each(|item| item.push(words));
    }

    fn take(reader: &mut Reader) -> List<T> {
        let length = reader.length();
        (0..length).map(|_| T::take(reader)).collect::<Vec<T>>().leak()
    }
}

impl<T: Words, const N: usize> Words for [T; N] {
    fn push(&self, words: &mut Vec<u32>) {
        self.iter().for_each(|item| item.push(words));
    }

    fn take(reader: &mut Reader) -> [T; N] {
        std::array::from_fn(|_| T::take(reader))
    }
}

impl<T: Words> Words for Option<T> {
    fn push(&self, words: &mut Vec<u32>) {
        self.is_some().push(words);
        self.iter().for_each(|item| item.push(words));
    }

    fn take(reader: &mut Reader) -> Option<T> {
        bool::take(reader).then(|| T::take(reader))
    }
}

/// Records, field by field.
macro_rules! records {
    ($($type:ty { $($field:tt),* })*) => {$(
        impl Words for $type {
            fn push(&self, words: &mut Vec<u32>) {
                $(self.$field.push(words);)*
            }

            fn take(reader: &mut Reader) -> $type {
                Self { $($field: Words::take(reader)),* }
            }
        }
    )*};
}

records! {
    Plant { rules, key, name, latin, source, colour_names, body, paint, guides, recipe, motion, look, view, first_day }
    Shape { mesh, levels, but, growths }
    Levels { group, levels }
    Paint { wrap, image, use_as }
    Cylinder { base, axis, zero, height }
    AlongVeins { order, reach_cm }
    Image { width, height, rule }
    Grain { black_at_the_top }
    Stripes { count, half_width, varies_between, varies_along, wander, teeth, astray, cube }
    Cube { half_side_cm, bulge_cm }
    Belts { height_cm, near_cm, far_cm, lobes_cm, astray_cm }
    Blaze { all, none, uneven, strokes, broad, lean, astray }
    Warts { radius_cm, height_cm, count, wart_radius_cm, astray }
    Rims { caps_cm, height_cm }
    Margins { margin_cm }
    Bands { apart_cm, share, share_varies, zigzag_cm, astray }
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

    fn take(reader: &mut Reader) -> (A, B) {
        (A::take(reader), B::take(reader))
    }
}

impl<A: Words, B: Words, C: Words> Words for (A, B, C) {
    fn push(&self, words: &mut Vec<u32>) {
        self.0.push(words);
        self.1.push(words);
        self.2.push(words);
    }

    fn take(reader: &mut Reader) -> (A, B, C) {
        (A::take(reader), B::take(reader), C::take(reader))
    }
}

/// One of several: its number, and what it has.
macro_rules! choices {
    ($($type:ident or $other:expr; { $($number:literal: $variant:ident { $($field:tt: $name:ident),* }),* })*) => {$(
        impl Words for $type {
            fn push(&self, words: &mut Vec<u32>) {
                match self {
                    $($type::$variant { $($field: $name),* } => {
                        words.push($number);
                        $($name.push(words);)*
                    })*
                }
            }

            fn take(reader: &mut Reader) -> $type {
                match reader.word() {
                    $($number => $type::$variant { $($field: Words::take(reader)),* },)*
                    _ => reader.known(None, $other),
                }
            }
        }
    )*};
}

choices! {
    Growths or Growths::Nothing; { 0: Nothing {}, 1: Spines {}, 2: Moss {} }
    Wrap or Wrap::Leaf; { 0: Cylinder { 0: cylinder }, 1: Leaf {}, 2: Veins { 0: along } }
    ImageRule or ImageRule::Pixels(Pixels { rows: &[] }); { 0: Grain { 0: rule }, 1: Stripes { 0: rule }, 2: Belts { 0: rule }, 3: Blaze { 0: rule },
        4: Warts { 0: rule }, 5: Rims { 0: rule }, 6: Margins { 0: rule }, 7: Bands { 0: rule },
        8: Pixels { 0: rule } }
    Use or Use::FOREGROUND; { 0: FirstCells { of: of, instead: instead }, 1: Scale { number: number, black: black, white: white },
        2: Colour { of: of }, 3: Wall {} }
    Scaled or Scaled::Repulsion; { 0: DivisionDays { 0: kind }, 1: RadiusScale {}, 2: Repulsion {}, 3: Adhesion { 0: a, 1: b } }
    GuideVector or GuideVector::OnLeaves { at: Vec2::ZERO, direction: Vec2::ZERO }; { 0: OnLeaves { at: at, direction: direction },
        1: Near { point_cm: point, direction: direction }, 2: AlongVeins { order: order } }
    Rules or Rules::First; { 1: First {}, 2: Second {} }
    Clock or Clock::Poisson; { 0: Poisson {}, 1: Exponential {} }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_plant_comes_back_bit_for_bit() {
        for plant in all() {
            let mut words = Vec::new();
            plant.push(&mut words);
            assert_eq!(Reader::read::<Plant>(&words).as_ref(), Some(plant), "{}", plant.key);
            for cut in 0..words.len() {
                assert_eq!(Reader::read::<Plant>(&words[..cut]), None, "{cut} words");
            }
            words.push(0);
            assert_eq!(Reader::read::<Plant>(&words), None, "a word too many");
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
        assert_eq!(Reader::read(&words), Some(all));
        assert_eq!(Reader::read::<Text>(&[u32::MAX, 1]), None);
        assert_eq!(Reader::read::<Clock>(&[2]), None);
    }
}
