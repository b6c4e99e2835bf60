//! Films.

use super::easel::{Easel, Shot};
use super::encoder::FilmEncoder;
use super::paper::Paper;
use super::{a_moment, tell, text};
use crate::export::{Act, Film, FilmFormat, Gif};
use crate::plants::Show;
use crate::play::{Scene, origin};
use glam::UVec2;
use js_sys::Array;
use wasm_bindgen::JsCast;
use web_sys::ImageData;

/// Frames of a film whose colours make the palette of a GIF, and of so many of their pixels one.
const SAMPLED_FRAMES: u32 = 8;
const SAMPLED_PIXELS: usize = 7;

/// Draws and writes a film: `more` is an array of its words, of the light of its stage as a small picture, and of
/// whether that is dark.
pub async fn film(scene: &Scene, mesh: &str, more: &Array) -> Result<Vec<u8>, String> {
    let film = Film::read(&text(more, 0)).ok_or("There is no such film.")?;
    let last_day = if film.act == Act::Growth { scene.recipe.days } else { scene.day };
    let easel = Easel::new(scene, mesh, last_day).await?;
    let [width, height] = film.size_px;
    let paper = Paper::new(width, height, film.format == FilmFormat::Gif)?;
    let mut set = Set {
        scene,
        easel,
        paper,
        light: more.get(1).unchecked_into(),
        dark: more.get(2).is_truthy(),
    };
    // Days have grown before.
    let done = |k: u32| tell(last_day + k + 1);
    match &film.format {
        FilmFormat::Mp4 { .. } => {
            let encoder = FilmEncoder::new(&film)?;
            for k in 0..film.frames {
                set.draw(&film, k)?;
                encoder.add(&set.paper.canvas, k).await?;
                done(k);
            }
            encoder.finish(&origin::whole_link(scene)).await
        }
        FilmFormat::Gif => {
            let mut gif = set.begin_gif(&film)?;
            for k in 0..film.frames {
                set.draw(&film, k)?;
                gif.add(&set.pixels(&film)?).map_err(|why| unwritten(&why))?;
                done(k);
                a_moment().await;
            }
            gif.finish().map_err(|why| unwritten(&why))
        }
    }
}

/// A plant before the light of its stage.
struct Set<'a> {
    scene: &'a Scene,
    easel: Easel,
    paper: Paper,
    light: ImageData,
    dark: bool,
}

impl Set<'_> {
    /// Draws a frame onto the paper.
    fn draw(&mut self, film: &Film, k: u32) -> Result<(), String> {
        let shown = film.moment(k, self.scene, self.easel.last_day());
        let show = match film.act {
            // What leads the cells is the same on every day.
            Act::Growth if !self.scene.show.is_of_cells() => Show::Cells,
            _ => self.scene.show,
        };
        let [width, height] = film.size_px;
        self.easel.draw(&Shot {
            day: shown.day,
            moment: shown.moment,
            orbit: shown.orbit,
            show,
            dark: self.dark,
            size_px: UVec2::new(width, height),
            part: None,
        })?;
        self.paper.paint(&self.light, f64::from(width), f64::from(height))?;
        self.paper.lay(&self.easel.canvas, 0.0, 0.0)
    }

    /// What is on the paper.
    fn pixels(&self, film: &Film) -> Result<Vec<u8>, String> {
        let [width, height] = film.size_px.map(f64::from);
        let pixels = self.paper.pen.get_image_data(0.0, 0.0, width, height);
        Ok(pixels.map_err(|_| "This browser lets nobody read its pictures.")?.data().0)
    }

    /// Looks at some frames for their colours.
    fn begin_gif(&mut self, film: &Film) -> Result<Gif, String> {
        let mut sample = Vec::new();
        for k in 0..SAMPLED_FRAMES {
            self.draw(film, k * (film.frames - 1) / (SAMPLED_FRAMES - 1))?;
            let pixels = self.pixels(film)?;
            sample.extend(pixels.chunks_exact(4).step_by(SAMPLED_PIXELS).flatten());
        }
        let size_px = film.size_px.map(|length| length as u16);
        let delay_cs = (100 / film.frames_per_s()) as u16;
        Gif::new(size_px, delay_cs, &sample, &origin::whole_link(self.scene))
            .map_err(|why| unwritten(&why))
    }
}

fn unwritten(why: &impl std::fmt::Display) -> String {
    format!("The GIF cannot be written: {why}.")
}
