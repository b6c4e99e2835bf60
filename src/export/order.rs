//! A scene as files: what the shell and the page's studio do alike, before a file is a file.

use super::cells::write_cells;
use super::clones::write_clones;
use super::days::DayNumbers;
use super::flats::Flats;
use super::glb::write_glb;
use super::kind::Kind;
use super::leaves::LeafSet;
use super::obj::{write_mtl, write_obj};
use super::picture::{Channels, write_square};
use super::ply::write_ply;
use super::specimen::Specimen;
use super::svg::write_svg;
use super::three_mf::write_3mf;
use super::tile::Tile;
use super::usdz::write_usdz;
use crate::mosaic::Pattern;
use crate::plants::{self, Show};
use crate::play::{Scene, origin};
use crate::surface::{Body, Charts, Mesh, Ornament, STROKES, flat_torus};
use crate::tissue::{CLAN_STEPS, Diary, Growth, Noise, clan_step};
use glam::DVec3;
use std::io;
use std::sync::Arc;

/// A scene that is to be written as files of one kind, on its day.
pub struct Order {
    kind: Kind,
    scene: Scene,
    mesh: Arc<Mesh>,
    ornaments: Vec<Ornament>,
    noise: Option<Noise>,
}

/// What was written: the content of the file, of an OBJ then that of its materials, and what it is in a few words.
pub struct Written {
    pub files: Vec<Vec<u8>>,
    pub told: String,
}

/// The reach of the cells goes by their number, so it is no matter how large the square is.
const TILE_SIDE_CM: f32 = 16.0;
const TILE_PX: u32 = 2048;
/// Squares of the torus along its side: as many triangles as plants have.
const TILE_SQUARES: u32 = 48;
/// With fewer, cells would be neighbours of themselves, the long way around.
const FEWEST_OF_TILE: u32 = 500;

impl Order {
    /// Sows the scene on its plant's body, or a tile's on a torus: control images and direction fields lie on
    /// bodies, so that a tile grows without. The growth ends with the day of the scene.
    ///
    /// # Errors
    /// In plain words, what cannot be grown so.
    pub fn new(kind: Kind, scene: &Scene, body: Body) -> Result<(Order, Growth), String> {
        let mut grown = scene.clone();
        grown.recipe.days = scene.day;
        let Body { surface, ornaments } = body;
        let is_tile = kind == Kind::Tile;
        let mesh = Arc::new(if is_tile { ground_of_tile(scene)? } else { surface });
        let sown = if is_tile {
            Growth::new(mesh.clone(), grown.recipe, &[], scene.individual)
                .map(|growth| (growth, None))
        } else {
            grown.sow(mesh.clone())
        };
        let (growth, noise) = sown.map_err(|e| e.to_string())?;
        Ok((Order { kind, scene: scene.clone(), mesh, ornaments, noise }, growth))
    }

    /// Writes the last day of a diary of the growth. `name` is what an OBJ calls the file of its materials.
    ///
    /// # Errors
    /// In plain words, what cannot be written so.
    pub fn write(&self, diary: Diary, name: &str) -> Result<Written, String> {
        let day = diary.days.len() - 1;
        if self.kind == Kind::Days {
            return self.write_days(&diary);
        }
        if self.kind == Kind::Leaves {
            return write_leaves(&[(self, &diary)]);
        }
        let diary = self.painted(&diary, day).unwrap_or(diary);
        let mesh = &*self.mesh.on(day as u32);
        let mut written = match self.kind {
            Kind::Cells => file(|out| write_cells(mesh, DVec3::ZERO, &diary, day, out)),
            Kind::Clones => {
                let mut clones = 0;
                let written = file(|out| {
                    clones = write_clones(mesh, &diary, day, out)?;
                    Ok(())
                });
                written.map(|written| written.told(format!("{clones} clones")))
            }
            Kind::Tile => {
                let tile = Tile::new(mesh, TILE_SIDE_CM, &self.scene.look, &diary, day);
                let written = file(|out| {
                    out.extend(write_square(TILE_PX, Channels::Colour, &tile.pixels(TILE_PX))?);
                    Ok(())
                });
                written.map(|written| written.told(format!("{TILE_PX} pixels wide")))
            }
            Kind::Days | Kind::Leaves => unreachable!("written above"),
            Kind::Glb | Kind::Ply | Kind::Obj | Kind::ThreeMf | Kind::Usdz | Kind::Svg => {
                self.specimen(&diary, |specimen| write_specimen(self.kind, specimen, name))
            }
        }?;
        written.sum_up(self.kind, day, diary.days[day].places.len());
        Ok(written)
    }

    /// The plant of the last day of a diary.
    fn specimen<T>(&self, diary: &Diary, take: impl FnOnce(&Specimen) -> T) -> T {
        let day = diary.days.len() - 1;
        let mesh = &*self.mesh.on(day as u32);
        let ornaments: Vec<Ornament> =
            self.ornaments.iter().map(|part| part.on(day as u32)).collect();
        let (body, controls) =
            ((&*self.mesh, mesh, &ornaments[..]), self.scene.plant.controls(self.scene.individual));
        let link = self.link(day);
        take(&Specimen::new(body, &self.scene.look, &controls, (diary, day), link))
    }

    /// A day that stands in the diary of the growth, in numbers. `charts` are those of the body.
    pub fn numbers(&self, charts: &mut Charts, diary: &Diary, day: usize) -> DayNumbers {
        let Scene { plant, recipe, .. } = &self.scene;
        DayNumbers {
            day: day as u32,
            pattern: self.pattern(charts, diary, day),
            expected: plant.expected_cells(&self.mesh, recipe, diary, day as u32),
            clans: clans(diary, day),
            expected_clans: plant.expected_clans(&self.mesh, recipe, diary, day as u32),
        }
    }

    /// The pattern of a day that stands in the diary of the growth. `charts` are those of the body.
    pub fn pattern(&self, charts: &mut Charts, diary: &Diary, day: usize) -> Pattern {
        let painted = self.painted(diary, day);
        Pattern::of(&self.mesh, charts, painted.as_ref().unwrap_or(diary), day)
    }

    /// The fingerprint of a day that stands in the diary of the growth.
    pub fn fingerprint(&self, diary: &Diary, day: usize) -> String {
        self.painted(diary, day).as_ref().unwrap_or(diary).fingerprint(day)
    }

    /// How many leaves the plant has, 0 of one that is none.
    pub fn leaves(&self) -> u32 {
        if self.mesh.uvs.is_empty() { 0 } else { self.mesh.part_count() as u32 }
    }

    /// The body that it grows on.
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// What noise makes of a day, if it is noise that is to be seen.
    fn painted(&self, diary: &Diary, day: usize) -> Option<Diary> {
        self.noise.as_ref().map(|noise| noise.paint(&self.mesh, diary, day))
    }

    fn write_days(&self, diary: &Diary) -> Result<Written, String> {
        let mut charts = Charts::new(&self.mesh);
        let mut table = format!("{}\n", DayNumbers::HEADING);
        for day in 0..diary.days.len() {
            table += &self.numbers(&mut charts, diary, day).to_csv();
            table.push('\n');
        }
        let told = format!("days, 0 to {}, {} bytes", diary.days.len() - 1, table.len());
        Ok(Written { files: vec![table.into_bytes()], told })
    }

    /// The link that shows it, or, of a plant that no link can say, its name.
    fn link(&self, day: usize) -> String {
        let scene = &self.scene;
        let of_catalogue =
            plants::find(scene.plant.key).and_then(|newest| newest.under(scene.plant.rules as u32));
        let shown = Scene { day: day as u32, show: Show::Cells, ..scene.clone() };
        let link = origin::whole_link(&shown);
        if of_catalogue == Some(scene.plant) || link.contains('~') {
            return link;
        }
        format!("plant document {}, individual {}, day {day}", scene.plant.key, scene.individual)
    }
}

impl Written {
    fn told(self, told: String) -> Written {
        Written { told, ..self }
    }

    /// Says what has been told so far in a line with the rest.
    fn sum_up(&mut self, kind: Kind, day: usize, cells: usize) {
        let bytes: usize = self.files.iter().map(Vec::len).sum();
        let facts = [format!("{cells} cells"), std::mem::take(&mut self.told)];
        let facts: Vec<String> = facts.into_iter().filter(|fact| !fact.is_empty()).collect();
        self.told = format!("{}, day {day}, {}, {bytes} bytes", kind.word(), facts.join(", "));
    }
}

/// One file in memory, which takes all that fits.
fn file(content: impl FnOnce(&mut Vec<u8>) -> io::Result<()>) -> Result<Written, String> {
    let mut bytes = Vec::new();
    content(&mut bytes).map_err(|e| e.to_string())?;
    Ok(Written { files: vec![bytes], told: String::new() })
}

/// A file of which its writer says how many triangles it has.
fn counted(content: impl FnOnce(&mut Vec<u8>) -> io::Result<usize>) -> Result<Written, String> {
    let mut triangles = 0;
    let written = file(|out| {
        triangles = content(out)?;
        Ok(())
    })?;
    Ok(written.told(format!("{triangles} triangles")))
}

fn write_specimen(kind: Kind, specimen: &Specimen, name: &str) -> Result<Written, String> {
    let triangles = format!("{} triangles", specimen.triangle_count());
    match kind {
        Kind::Svg => {
            let flats = Flats::new(specimen)?;
            Ok(file(|out| write_svg(specimen, &flats, out))?.told(flats.told()))
        }
        Kind::ThreeMf => counted(|out| write_3mf(specimen, out)),
        Kind::Usdz => counted(|out| write_usdz(specimen, out)),
        Kind::Obj => {
            let mut written = file(|out| write_obj(specimen, name, out))?;
            written.files.append(&mut file(|out| write_mtl(specimen, out))?.files);
            Ok(written.told(triangles))
        }
        Kind::Glb => Ok(file(|out| write_glb(specimen, out))?.told(triangles)),
        _ => Ok(file(|out| write_ply(specimen, out))?.told(triangles)),
    }
}

/// Writes the leaves of some individuals of one plant on the last days of their diaries, which belong to growths of
/// `Kind::Leaves`.
///
/// # Errors
/// In plain words, why there are none.
pub fn write_leaves(grown: &[(&Order, &Diary)]) -> Result<Written, String> {
    let mut set: Option<LeafSet> = None;
    let (mut link, mut told) = (String::new(), String::new());
    for (k, (order, diary)) in grown.iter().enumerate() {
        let painted = order.painted(diary, diary.days.len() - 1);
        order.specimen(painted.as_ref().unwrap_or(diary), |specimen| {
            let flats = Flats::new(specimen)?;
            let has_veins = specimen.mesh.veins.any(STROKES - 1);
            let set = set.get_or_insert_with(|| {
                (link, told) = (specimen.link.clone(), flats.told());
                LeafSet::new(&flats, grown.len() as u32, has_veins)
            });
            set.draw(k, order.scene.individual, specimen, &flats);
            Ok::<(), String>(())
        })?;
    }
    let set = set.ok_or("there are no individuals")?;
    let mut written = file(|out| set.write(&link, out))?.told(format!("{told}, {}", set.told()));
    let last_days = grown.iter().filter_map(|(_, diary)| diary.days.last());
    let day = grown.iter().map(|(_, diary)| diary.days.len() - 1).max().unwrap_or(0);
    written.sum_up(Kind::Leaves, day, last_days.map(|day| day.places.len()).sum());
    Ok(written)
}

/// The clans of a day, by the steps of their sizes.
fn clans(diary: &Diary, day: usize) -> [u32; CLAN_STEPS] {
    let living = diary.days[day].places.len();
    let mut cells = vec![0; diary.days[0].places.len()];
    for cell in &diary.lineage[..living] {
        cells[cell.founder as usize] += 1;
    }
    let mut steps = [0; CLAN_STEPS];
    cells.into_iter().for_each(|cells| steps[clan_step(cells)] += 1);
    steps
}

/// The torus that a tile grows on, if it can be one.
fn ground_of_tile(scene: &Scene) -> Result<Mesh, String> {
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
