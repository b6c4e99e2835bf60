//! Which moments a film shows.

use crate::play::Scene;
use crate::play::camera::Orbit;

/// What happens in a film.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Act {
    /// From day 0 to the last day; of flowers that open, that is their opening.
    Growth,
    /// One turn of the plant on its day. The frame after the last one would be the first.
    Turn,
}

/// The way in which a film is written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FilmFormat {
    /// As MP4, encoded as a codec string says (RFC 6381).
    Mp4 {
        codec: String,
    },
    Gif,
}

/// A film of a plant, frame by frame.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Film {
    pub act: Act,
    /// At least 2.
    pub frames: u32,
    pub size_px: [u32; 2],
    pub format: FilmFormat,
}

/// What a frame shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moment {
    pub day: u32,
    /// Between the day before (0) and the day (1).
    pub moment: f32,
    pub orbit: Orbit,
}

impl Film {
    /// Frames of a second. A GIF counts hundredths, and few programs show more than 20 of them.
    pub fn frames_per_s(&self) -> u32 {
        match self.format {
            FilmFormat::Mp4 { .. } => 30,
            FilmFormat::Gif => 20,
        }
    }

    /// Bits of a second of an MP4: enough for cells that all move.
    pub fn bits_per_s(&self) -> u32 {
        let [width, height] = self.size_px;
        width * height * self.frames_per_s() / 5
    }

    /// What frame `k` of a scene shows, whose last day has this number.
    pub fn moment(&self, k: u32, scene: &Scene, last_day: u32) -> Moment {
        let of = |frames: u32| f64::from(k) / f64::from(frames);
        let (time, right_deg) = match self.act {
            Act::Growth => (of(self.frames - 1) * f64::from(last_day), 0.0),
            Act::Turn => (f64::from(scene.day.min(last_day)), of(self.frames) * 360.0),
        };
        let day = time.ceil();
        Moment {
            day: day as u32,
            moment: if day == 0.0 { 1.0 } else { (1.0 - (day - time)) as f32 },
            orbit: scene.orbit.turned(right_deg as f32, 0.0),
        }
    }

    /// The film in words, which `read` understands: `growth 150 1280 720 avc1.640028`.
    pub fn written(&self) -> String {
        let act = match self.act {
            Act::Growth => "growth",
            Act::Turn => "turn",
        };
        let format = match &self.format {
            FilmFormat::Mp4 { codec } => codec,
            FilmFormat::Gif => "gif",
        };
        let [width, height] = self.size_px;
        format!("{act} {} {width} {height} {format}", self.frames)
    }

    /// None for words that say no film.
    pub fn read(words: &str) -> Option<Film> {
        let words: Vec<&str> = words.split(' ').collect();
        let [act, frames, width, height, format] = words[..] else { return None };
        let act = match act {
            "growth" => Act::Growth,
            "turn" => Act::Turn,
            _ => return None,
        };
        let number = |word: &str| word.parse::<u32>().ok();
        let format = match format {
            "gif" => FilmFormat::Gif,
            codec => FilmFormat::Mp4 { codec: codec.to_string() },
        };
        let frames = number(frames).filter(|&frames| frames > 1)?;
        Some(Film { act, frames, size_px: [number(width)?, number(height)?], format })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants;

    fn scene() -> Scene {
        let mut scene = Scene::preset(plants::find("croton").unwrap(), 1);
        scene.day = 12;
        scene
    }

    fn film(act: Act, frames: u32) -> Film {
        Film { act, frames, size_px: [640, 360], format: FilmFormat::Gif }
    }

    #[test]
    fn a_growth_begins_with_day_0_ends_with_the_last_and_goes_evenly() {
        let scene = scene();
        let times: Vec<f64> = (0..7)
            .map(|k| film(Act::Growth, 7).moment(k, &scene, 3))
            .inspect(|shown| assert_eq!(shown.orbit, scene.orbit))
            .map(|shown| f64::from(shown.day) - 1.0 + f64::from(shown.moment))
            .collect();
        assert_eq!(times, [0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0]);
        let first = film(Act::Growth, 7).moment(0, &scene, 3);
        assert_eq!((first.day, first.moment), (0, 1.0), "no cell is on its way from a day before");
    }

    #[test]
    fn a_turn_goes_around_once_on_one_day() {
        let scene = scene();
        let shown: Vec<_> = (0..4).map(|k| film(Act::Turn, 4).moment(k, &scene, 30)).collect();
        for (k, shown) in shown.iter().enumerate() {
            assert_eq!((shown.day, shown.moment), (12, 1.0));
            assert_eq!(shown.orbit, scene.orbit.turned(90.0 * k as f32, 0.0));
        }
        let early = film(Act::Turn, 4).moment(0, &scene, 5);
        assert_eq!(early.day, 5, "it grew no further");
    }

    #[test]
    fn words_say_a_film() {
        let mp4 = FilmFormat::Mp4 { codec: "avc1.640028".to_string() };
        for film in [film(Act::Growth, 150), Film { format: mp4, ..film(Act::Turn, 2) }] {
            assert_eq!(Film::read(&film.written()), Some(film));
        }
        for words in ["", "growth", "growth 1 2 3 gif", "dance 9 2 3 gif", "turn 9 a 3 gif"] {
            assert_eq!(Film::read(words), None, "{words}");
        }
    }
}
