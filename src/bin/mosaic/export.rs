//! `mosaic export`: writes the plant of a day as other programs read it.

use super::options::{ExportOptions, Kind};
use super::output::{Target, say, warn};
use super::{Refusal, cores, memory, progress, subject};
use clonal_mosaic::export::{
    Pattern, Specimen, Tile, write_3mf, write_cells, write_clones, write_glb, write_mtl, write_obj,
    write_ply,
};
use clonal_mosaic::plants::{self, Show};
use clonal_mosaic::play::{Scene, link};
use clonal_mosaic::surface::{Body, Mesh, flat_torus};
use clonal_mosaic::tissue::{Diary, Growth, Progress};
use glam::DVec3;
use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::Path;
use std::sync::Arc;

pub fn export(options: &ExportOptions) -> Result<(), Refusal> {
    let (kind, path) = options.wanted().ok_or_else(|| {
        let words: Vec<String> =
            Kind::ALL.iter().map(|kind| format!("--{}", kind.word())).collect();
        format!("say what to write, and where: one of {}", words.join(", "))
    })?;
    let mut scene = subject::scene(options.source(), options.day)?;
    scene.individual = options.individual.unwrap_or(scene.individual);
    // Tried first: nobody should wait for a plant that cannot be written down.
    let materials = if kind == Kind::Obj { Some(materials_beside(path)?) } else { None };
    let target = Target::new(path)?;
    let is_file = target.is_file();

    let Body { surface, ornaments } = scene.plant.embedded_body();
    let mesh = Arc::new(if kind == Kind::Tile { ground_of_tile(&scene)? } else { surface });
    let (diary, day) = grow(&scene, &mesh, kind == Kind::Tile)?;
    let seen = progress::Progress::new();
    seen.tell("writing");
    let written = match kind {
        Kind::Cells => {
            let write = |out: &mut Counted| write_cells(&mesh, DVec3::ZERO, &diary, day, out);
            format!("{} bytes", fill(target, write)?)
        }
        Kind::Clones => {
            let mut clones = 0;
            let bytes = fill(target, |out| {
                clones = write_clones(&mesh, &diary, day, out)?;
                Ok(())
            })?;
            format!("{clones} clones, {bytes} bytes")
        }
        Kind::Tile => {
            let tile = Tile::new(&mesh, TILE_SIDE_CM, &scene.look, &diary, day);
            format!("{TILE_PX} pixels wide, {} bytes", fill(target, |out| write_png(&tile, out))?)
        }
        Kind::Glb | Kind::Ply | Kind::Obj | Kind::ThreeMf | Kind::Svg => {
            let plant = scene.plant;
            let (body, controls) = ((&*mesh, &ornaments[..]), plant.controls(scene.individual));
            let shown = Scene { day: day as u32, show: Show::Cells, ..scene.clone() };
            let own = plants::find(plant.key).and_then(|own| own.under(plant.rules as u32));
            let link = if own.is_some_and(|own| own.to_json() == plant.to_json()) {
                link::write(&shown)
            } else {
                format!(
                    "plant document {}, individual {}, day {day}",
                    scene.plant.key, scene.individual
                )
            };
            let specimen = Specimen::new(body, &scene.look, &controls, (&diary, day), link);
            match (kind, materials) {
                (Kind::Svg, _) => write_svg(&specimen, target)?,
                (Kind::ThreeMf, _) => {
                    let mut triangles = 0;
                    let bytes = fill(target, |out| {
                        triangles = write_3mf(&specimen, out)?;
                        Ok(())
                    })?;
                    format!("{triangles} triangles, {bytes} bytes")
                }
                (kind, materials) => {
                    let bytes = write_model(kind, &specimen, target, materials)?;
                    format!("{} triangles, {bytes} bytes", specimen.triangle_count())
                }
            }
        }
    };
    drop(seen);
    let cells = diary.days[day].places.len();
    let line = format!("{}: {}, day {day}, {cells} cells, {written}", path.display(), kind.word());
    if is_file {
        return say(&(line + "\n"));
    }
    // Where the plant itself goes to the standard output, nothing else may.
    warn(&line);
    Ok(())
}

/// The reach of the cells goes by their number, so it is no matter how large the square is.
const TILE_SIDE_CM: f32 = 16.0;
const TILE_PX: u32 = 2048;
/// Squares of the torus along its side: as many triangles as plants have.
const TILE_SQUARES: u32 = 48;
/// With fewer, cells would be neighbours of themselves, the long way around.
const FEWEST_OF_TILE: u32 = 500;

/// The torus that a tile grows on, if it can be one.
fn ground_of_tile(scene: &Scene) -> Result<Mesh, Refusal> {
    let recipe = &scene.recipe;
    if scene.noise {
        return Err("a tile shows clones: noise does not go on over its border".to_string());
    }
    // Cells within reach of each other on both ways around.
    let fewest = FEWEST_OF_TILE.max((64.0 * recipe.radius_scale * recipe.radius_scale) as u32);
    if recipe.initial_cells < fewest {
        let cells = recipe.initial_cells;
        return Err(format!("a tile of this recipe needs {fewest} first cells, not {cells}"));
    }
    Ok(flat_torus(TILE_SIDE_CM, TILE_SQUARES))
}

fn write_png(tile: &Tile, out: &mut Counted) -> io::Result<()> {
    let mut encoder = png::Encoder::new(out, TILE_PX, TILE_PX);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    let mut png = encoder.write_header().map_err(io::Error::other)?;
    png.write_image_data(&tile.pixels(TILE_PX)).map_err(io::Error::other)
}

/// Writes GLB, OBJ with its materials, or PLY; how many bytes that takes.
fn write_model(
    kind: Kind,
    specimen: &Specimen,
    target: Target,
    materials: Option<(String, Target)>,
) -> Result<u64, Refusal> {
    match materials {
        Some((name, beside)) => {
            let bytes = fill(beside, |out| write_mtl(specimen, out))?;
            Ok(bytes + fill(target, |out| write_obj(specimen, &name, out))?)
        }
        None if kind == Kind::Glb => fill(target, |out| write_glb(specimen, out)),
        None => fill(target, |out| write_ply(specimen, out)),
    }
}

/// Writes what can be laid flat; what is told of it.
fn write_svg(specimen: &Specimen, target: Target) -> Result<String, Refusal> {
    let pattern = Pattern::new(specimen);
    let mut why: Vec<&str> = pattern.left_out.iter().map(|(_, why)| why.as_str()).collect();
    why.dedup();
    if pattern.count() == 0 {
        return Err(format!("nothing of this plant can be laid flat: {}", why.join("; ")));
    }
    let bytes = fill(target, |out| pattern.write(specimen, out))?;
    let (sheets, stretch) = (pattern.count(), 100.0 * pattern.stretch);
    let left_out = match pattern.left_out.len() {
        0 => String::new(),
        parts => format!("; without {parts} that cannot be laid flat: {}", why.join("; ")),
    };
    let word = if sheets == 1 { "part" } else { "parts" };
    Ok(format!("{sheets} {word}, stretched by {stretch:.1} %, {bytes} bytes{left_out}"))
}

/// Grows a scene to its day, or to the last one that there is room for; its diary and that day. Control
/// images and direction fields lie on bodies: as a tile it grows without.
fn grow(scene: &Scene, mesh: &Arc<Mesh>, as_tile: bool) -> Result<(Diary, usize), Refusal> {
    let mut scene = scene.clone();
    scene.recipe.days = scene.day;
    memory::check(&scene.recipe)?;
    let (growth, noise) = if as_tile {
        let growth = Growth::new(mesh.clone(), scene.recipe.clone(), &[], scene.individual);
        (growth.map_err(|e| e.to_string())?, None)
    } else {
        scene.sow(mesh.clone()).map_err(|e| e.to_string())?
    };
    let mut growth = growth.on_threads(cores());
    let seen = progress::Progress::new();
    loop {
        match growth.step() {
            Progress::Event => {}
            Progress::Day(day) => seen.tell(&format!("day {day} of {}", scene.day)),
            Progress::Done => break,
            Progress::Full => {
                seen.clear();
                warn(&format!(
                    "growth ends early, at the recipe's max_cells of {}; what has grown is written",
                    scene.recipe.max_cells
                ));
                break;
            }
        }
    }
    let day = growth.diary.days.len() - 1;
    let painted = noise.map(|noise| noise.paint(mesh, &growth.diary, day));
    Ok((painted.unwrap_or(growth.diary), day))
}

/// The file for the materials of an OBJ, and its name as the OBJ says it.
fn materials_beside(path: &Path) -> Result<(String, Target), Refusal> {
    let beside = path.with_extension("mtl");
    let name = beside.file_name().and_then(|name| name.to_str()).unwrap_or_default();
    if path.file_stem().is_none() || name.is_empty() || name.contains(char::is_control) {
        return Err(format!("{}: an OBJ needs a plain name", path.display()));
    }
    let target = Target::new(path)?;
    if beside == path || !target.is_file() {
        return Err(format!(
            "{}: an OBJ is a file, with its colours in a .mtl file beside it",
            path.display()
        ));
    }
    Ok((name.to_string(), Target::new(&beside)?))
}

/// Writes a file, and returns how many bytes it has.
fn fill(
    target: Target,
    content: impl FnOnce(&mut Counted) -> io::Result<()>,
) -> Result<u64, Refusal> {
    let mut bytes = 0;
    target.write(|out| {
        let mut counted = Counted { out, bytes: 0 };
        content(&mut counted)?;
        bytes = counted.bytes;
        Ok(())
    })?;
    Ok(bytes)
}

/// A file whose bytes are counted.
struct Counted<'a> {
    out: &'a mut BufWriter<File>,
    bytes: u64,
}

impl Write for Counted<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let count = self.out.write(bytes)?;
        self.bytes += count as u64;
        Ok(count)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}
