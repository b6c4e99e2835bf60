//! Strokes of a brush as data, and as the short text that stands in a link: `f.500.w.k3f7a2.k3g0b1-e.300.wm.k4000`.

use crate::surface::Place;
use crate::tissue::{CellType, Scaled};

/// What a brush does to the skin that it passes over.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Brush {
    /// All first cells are of a type.
    Put(CellType),
    /// First cells of a type may be there, and nowhere where no stroke says so.
    Only(CellType),
    /// No first cell is of a type.
    Never(CellType),
    /// A number of the recipe, in hundredths of what it is elsewhere.
    Scale(Scaled, u32),
    /// No pattern.
    Bare,
    /// Cells follow the stroke.
    Lead,
    /// Takes strokes before it away where it meets them.
    Erase,
}

/// What a stroke makes of its points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// Goes from one to the next, straight.
    Free,
    /// A stripe around the body at the height of each, or across its leaf.
    Around,
    /// A stripe up and down the body through each, or along its leaf.
    Along,
    /// All of the part that each lies on.
    Part,
}

/// A stroke on the skin.
#[derive(Clone, Debug, PartialEq)]
pub struct Stroke {
    pub brush: Brush,
    /// That of the brush, in thousandths of a centimetre, 1 to `MOST_RADIUS`.
    pub radius: u32,
    pub way: Way,
    /// Whether it is there a second time in the mirror: on the other side of the leaf, or of the body.
    pub is_mirrored: bool,
    pub points: Vec<Spot>,
}

/// A place on the skin as a link has it: a triangle, and its second and third barycentric coordinates in 35ths.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Spot {
    pub triangle: u32,
    pub shares: [u8; 2],
}

pub const MOST_RADIUS: u32 = 99_999;
/// Of a text that is read, so that no link keeps a machine busy for minutes.
const MOST_STROKES: usize = 1000;
const MOST_POINTS: usize = 20_000;
const SHARES: u32 = 35;

/// The words of ways.
const WAYS: [(Way, &str); 4] =
    [(Way::Free, "w"), (Way::Around, "r"), (Way::Along, "a"), (Way::Part, "p")];

impl Spot {
    /// The nearest that can be written.
    pub fn of(place: Place) -> Spot {
        let share = |b: f32| (b.clamp(0.0, 1.0) * SHARES as f32 + 0.5) as u8;
        let one = share(place.b1);
        Spot { triangle: place.triangle, shares: [one, share(place.b2).min(SHARES as u8 - one)] }
    }

    pub fn place(self) -> Place {
        let [b1, b2] = self.shares.map(|share| f32::from(share) / SHARES as f32);
        Place { triangle: self.triangle, b1, b2 }
    }

    fn write(self, text: &mut String) {
        let mut digits = Vec::new();
        let mut rest = self.triangle;
        while rest > 0 || digits.is_empty() {
            digits.push(rest % 36);
            rest /= 36;
        }
        let shares = self.shares.map(u32::from);
        let all = digits.into_iter().rev().chain(shares);
        text.extend(all.filter_map(|digit| char::from_digit(digit, 36)));
    }

    fn read(text: &str) -> Option<Spot> {
        let (triangle, shares) = text.split_at_checked(text.len().checked_sub(2)?)?;
        let mut shares = shares.chars().map(|c| c.to_digit(36).map(|digit| digit as u8));
        let shares = [shares.next()??, shares.next()??];
        let is_within = u32::from(shares[0]) + u32::from(shares[1]) <= SHARES;
        let triangle = u32::from_str_radix(triangle, 36).ok()?;
        is_within.then_some(Spot { triangle, shares })
    }
}

impl Brush {
    /// Its word: a type's letter for `Put`, with `o` for `Only` and `n` for `Never`.
    pub fn word(self) -> String {
        let letter = |kind: CellType| kind.letter().to_ascii_lowercase();
        match self {
            Brush::Put(kind) => letter(kind).to_string(),
            Brush::Only(kind) => format!("{}o", letter(kind)),
            Brush::Never(kind) => format!("{}n", letter(kind)),
            Brush::Scale(Scaled::DivisionDays(kind), percent) => {
                format!("d{}{percent}", letter(kind))
            }
            Brush::Scale(Scaled::Repulsion, percent) => format!("p{percent}"),
            Brush::Scale(_, percent) => format!("r{percent}"),
            Brush::Bare => "n".to_string(),
            Brush::Lead => "l".to_string(),
            Brush::Erase => "e".to_string(),
        }
    }

    pub fn of_word(word: &str) -> Option<Brush> {
        let kind = |text: &str| {
            let mut all = CellType::ALL.into_iter();
            all.find(|kind| text.len() == 1 && text.starts_with(kind.letter().to_ascii_lowercase()))
        };
        let percent = |text: &str| text.parse().ok().filter(|percent| *percent <= 10_000);
        let (first, rest) = word.split_at_checked(1)?;
        match (first, rest) {
            ("n", "") => Some(Brush::Bare),
            ("l", "") => Some(Brush::Lead),
            ("e", "") => Some(Brush::Erase),
            ("r", rest) => Some(Brush::Scale(Scaled::RadiusScale, percent(rest)?)),
            ("p", rest) => Some(Brush::Scale(Scaled::Repulsion, percent(rest)?)),
            ("d", rest) => {
                let (of, rest) = rest.split_at_checked(1)?;
                Some(Brush::Scale(Scaled::DivisionDays(kind(of)?), percent(rest)?))
            }
            (of, "") => kind(of).map(Brush::Put),
            (of, "o") => kind(of).map(Brush::Only),
            (of, "n") => kind(of).map(Brush::Never),
            _ => None,
        }
    }
}

impl Stroke {
    /// As `f.500.w.k3f7a2`.
    pub fn write(&self) -> String {
        let word = WAYS.iter().find(|(way, _)| *way == self.way).map_or("", |(_, word)| word);
        let mirror = if self.is_mirrored { "m" } else { "" };
        let mut text = format!("{}.{}.{word}{mirror}", self.brush.word(), self.radius);
        for point in &self.points {
            text.push('.');
            point.write(&mut text);
        }
        text
    }

    /// That of a text; it may have no points yet.
    pub fn read(text: &str) -> Option<Stroke> {
        let mut words = text.split('.');
        let brush = Brush::of_word(words.next()?)?;
        let radius = words.next()?.parse().ok().filter(|r| (1..=MOST_RADIUS).contains(r))?;
        let word = words.next()?;
        let way = word.strip_suffix('m').unwrap_or(word);
        let &(way, _) = WAYS.iter().find(|(_, known)| *known == way)?;
        let points: Vec<Spot> = words.map(Spot::read).collect::<Option<_>>()?;
        let is_mirrored = word.ends_with('m');
        Some(Stroke { brush, radius, way, is_mirrored, points })
    }
}

/// Strokes as a text of small letters, digits, `.` and `-`.
pub fn write(strokes: &[Stroke]) -> String {
    strokes.iter().map(Stroke::write).collect::<Vec<_>>().join("-")
}

/// Strokes of a text.
///
/// # Errors
/// In plain words, what is wrong with it.
pub fn read(text: &str) -> Result<Vec<Stroke>, String> {
    let parts: Vec<&str> = text.split('-').filter(|part| !part.is_empty()).collect();
    if parts.len() > MOST_STROKES {
        return Err(format!("there are {} strokes: at most {MOST_STROKES}", parts.len()));
    }
    let read = |(k, part): (usize, &&str)| {
        let stroke = Stroke::read(part).filter(|stroke| !stroke.points.is_empty());
        stroke.ok_or_else(|| format!("stroke {} cannot be read", k + 1))
    };
    let strokes: Vec<Stroke> = parts.iter().enumerate().map(read).collect::<Result<_, _>>()?;
    match strokes.iter().map(|stroke| stroke.points.len()).sum::<usize>() {
        ..=MOST_POINTS => Ok(strokes),
        points => Err(format!("the strokes have {points} points: at most {MOST_POINTS}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strokes_come_back_from_their_text() {
        let brushes = [
            Brush::Put(CellType::Foreground),
            Brush::Only(CellType::Middle),
            Brush::Never(CellType::Background),
            Brush::Scale(Scaled::RadiusScale, 150),
            Brush::Scale(Scaled::Repulsion, 0),
            Brush::Scale(Scaled::DivisionDays(CellType::Background), 10_000),
            Brush::Bare,
            Brush::Lead,
            Brush::Erase,
        ];
        let spot = |triangle, one, two| Spot { triangle, shares: [one, two] };
        let strokes: Vec<Stroke> = brushes
            .into_iter()
            .zip(WAYS.into_iter().cycle())
            .enumerate()
            .map(|(k, (brush, (way, _)))| Stroke {
                brush,
                radius: 1 + 12_000 * k as u32,
                way,
                is_mirrored: k % 2 == 1,
                points: vec![spot(0, 0, 35), spot(35, 12, 23), spot(u32::MAX, 35, 0)],
            })
            .collect();
        let text = write(&strokes);
        let is_plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || ".-".contains(c);
        assert!(text.chars().all(is_plain), "{text}");
        assert_eq!(read(&text), Ok(strokes));
        assert_eq!(read(""), Ok(vec![]));
        for wrong in
            ["f", "f.500.w", "f.0.w.k00", "f.5.x.k00", "q.5.w.k00", "f.5.w.kzz", "r.5.w.k00"]
        {
            assert_eq!(read(wrong), Err("stroke 1 cannot be read".to_string()), "{wrong}");
        }
    }

    #[test]
    fn places_are_written_as_near_as_a_seventieth() {
        for (b1, b2) in [(0.0, 0.0), (0.31, 0.47), (0.5, 0.5), (0.02, 0.98)] {
            let place = Spot::of(Place { triangle: 7, b1, b2 }).place();
            let off = (place.b1 - b1).abs().max((place.b2 - b2).abs());
            assert!(off < 0.03 && place.b1 + place.b2 <= 1.0, "{b1} {b2}: {place:?}");
        }
    }
}
