//! Files out: tables, and the plant of a day as other programs read it.

mod cells;
mod chart;
mod clones;
mod codap;
mod convex;
mod course;
mod days;
mod film;
mod fit;
mod flat;
mod flats;
mod gif;
mod glb;
mod in_words;
mod joints;
mod kind;
mod leaves;
mod lesson;
mod measured;
mod mp4;
mod obj;
mod order;
mod outlines;
mod picture;
mod ply;
mod series;
mod sheet;
mod sketch;
mod solid;
mod specimen;
mod svg;
mod three_mf;
mod tile;
mod tiling;
mod usdz;
mod zip;

pub use cells::write_cells;
pub use chart::Chart;
pub use codap::{
    DAYS as CODAP_DAYS, INDIVIDUALS as CODAP_INDIVIDUALS, Table as CodapTable, day_case,
    individual_case, json_text,
};
pub use course::{sizes_of_clans, the_course};
pub use days::DayNumbers;
pub use film::{Act, Film, FilmFormat, Moment};
pub use fit::{Fit, Want, grown};
pub use gif::Gif;
pub use in_words::pattern_in_words;
pub use kind::Kind;
pub use lesson::{curves, strip, worksheet};
pub use measured::measured;
pub use mp4::{Codec, FilmColours, Sample, write_mp4};
pub use order::{Order, Written, write_leaves};
pub use picture::{with_link, write_picture};
pub use series::{Grown, nursery, steps};
pub use sheet::{CodePlace, Sheet, SheetSize, TILE_PX};
pub use sketch::{SketchView, sketch, told_of};
pub use specimen::Specimen;
pub use tiling::{Facet, Point, Tiling};
pub use zip::write_zip;
