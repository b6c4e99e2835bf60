//! What `mosaic export` is asked for.

use super::{FIRST_PLANT, Source, from_one_to, presets, whole};
use clap::Args;
use clonal_mosaic::export::Kind;
use std::path::{Path, PathBuf};

#[derive(Args)]
pub struct ExportOptions {
    #[command(flatten)]
    source: ExportSource,
    /// The seed, from 0 to 4294967295; without it the link's individual, or the first
    #[arg(long, value_name = "N", value_parser = whole, allow_negative_numbers = true)]
    pub individual: Option<u32>,
    /// The day; without it the link's day, or the last day of the plant
    #[arg(long, value_name = "D", value_parser = whole, allow_negative_numbers = true)]
    pub day: Option<u32>,
    /// With --leaves, those of so many individuals from this one on, up to 16
    #[arg(long, value_name = "N", value_parser = from_one_to::<16>, allow_negative_numbers = true)]
    pub individuals: Option<u32>,
    #[command(flatten)]
    wanted: Wanted,
}

/// Which plant: one of them, or the croton.
#[derive(Args)]
#[group(multiple = false)]
struct ExportSource {
    /// The plant and the numbers of a playground link, or of the part after its #
    #[arg(long, value_name = "TEXT")]
    link: Option<String>,
    #[arg(long, value_name = "NAME", help = presets())]
    preset: Option<String>,
    /// A plant as mosaic plant prints it
    #[arg(long, value_name = "FILE.json")]
    plant: Option<PathBuf>,
}

/// What to write, and where.
#[derive(Args)]
#[group(multiple = false)]
struct Wanted {
    /// The plant as binary glTF, for Blender, three.js and most viewers
    #[arg(long, value_name = "OUT.glb")]
    glb: Option<PathBuf>,
    /// The plant as PLY with a colour at each corner, for MeshLab and programs of one's own
    #[arg(long, value_name = "OUT.ply")]
    ply: Option<PathBuf>,
    /// The plant as OBJ with one material a type; OUT.mtl is written beside it
    #[arg(long, value_name = "OUT.obj")]
    obj: Option<PathBuf>,
    /// The plant to be printed in colours: closed bodies, and leaves 1.2 mm thick
    #[arg(long = "3mf", value_name = "OUT.3mf")]
    three_mf: Option<PathBuf>,
    /// The plant as USDZ, for iPhones and iPads, which put it into the room
    #[arg(long, value_name = "OUT.usdz")]
    usdz: Option<PathBuf>,
    /// Its leaves laid flat, true to scale, as SVG: one path for each type on each leaf
    #[arg(long, value_name = "OUT.svg")]
    svg: Option<PathBuf>,
    /// Its leaves laid flat side by side as pictures, 2048 pixels wide, in a ZIP: colours, alpha, normals and veins
    #[arg(long, value_name = "OUT.zip")]
    leaves: Option<PathBuf>,
    /// Its cells on a flat square that can be laid side by side without a seam, as PNG, 2048 pixels wide
    #[arg(long, value_name = "OUT.png")]
    tile: Option<PathBuf>,
    /// Its days up to this one as a table: cells, shares and patches of each type, and how many cells to expect
    #[arg(long, value_name = "OUT.csv")]
    days: Option<PathBuf>,
    /// Its clones as a table: founder,type,born_day,cells,F,B,M,area_cm2,part
    #[arg(long, value_name = "OUT.csv")]
    clones: Option<PathBuf>,
    /// Its cells as a table: id,parent,founder,type,part,triangle,x,y,z,born_day
    #[arg(long, value_name = "OUT.csv")]
    cells: Option<PathBuf>,
}

impl ExportOptions {
    pub fn source(&self) -> Source<'_> {
        match &self.source {
            ExportSource { link: Some(text), .. } => Source::Link(text),
            ExportSource { plant: Some(path), .. } => Source::Plant(path),
            ExportSource { preset, .. } => Source::Preset(preset.as_deref().unwrap_or(FIRST_PLANT)),
        }
    }

    /// What to write, and where, if anything was named.
    pub fn wanted(&self) -> Option<(Kind, &Path)> {
        Kind::ALL.into_iter().find_map(|kind| Some((kind, self.path(kind)?)))
    }

    fn path(&self, kind: Kind) -> Option<&Path> {
        let Wanted { glb, ply, obj, three_mf, usdz, svg, leaves, tile, days, clones, cells } =
            &self.wanted;
        let path = match kind {
            Kind::Glb => glb,
            Kind::Ply => ply,
            Kind::Obj => obj,
            Kind::ThreeMf => three_mf,
            Kind::Usdz => usdz,
            Kind::Svg => svg,
            Kind::Leaves => leaves,
            Kind::Tile => tile,
            Kind::Days => days,
            Kind::Clones => clones,
            Kind::Cells => cells,
        };
        path.as_deref()
    }
}
