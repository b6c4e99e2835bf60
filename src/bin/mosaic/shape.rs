//! `mosaic shape`: bodies from rules.

use super::Refusal;
use super::options::{from_one_to, whole};
use super::output::{Target, cannot, say};
use clap::{Args, Subcommand};
use clonal_mosaic::shapes::branching::{self, Census, Matrix, Ramification, Tree, TreeNumbers};
use clonal_mosaic::shapes::flower::{Flower, FlowerNumbers};
use clonal_mosaic::shapes::leaf::{Leaf, LeafNumbers, Limb};
use clonal_mosaic::shapes::{ShapeError, opening};
use clonal_mosaic::surface::PolygonMesh;
use serde::Serialize;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

/// What `mosaic shape` is asked for.
#[derive(Args)]
pub struct ShapeOptions {
    #[command(subcommand)]
    what: Shape,
}

#[derive(Subcommand)]
enum Shape {
    /// A leaf of lobes with veins, and coordinates that belong to it
    Leaf(LeafOptions),
    /// A flower that opens, from the strokes of its petals
    Flower(FlowerOptions),
    /// A tree drawn from a ramification matrix
    Tree(TreeOptions),
}

#[derive(Args)]
struct LeafOptions {
    #[command(flatten)]
    body: BodyOptions,
}

#[derive(Args)]
struct FlowerOptions {
    #[command(flatten)]
    body: BodyOptions,
    /// The flower's own day, from 0, its bud, to the one on which it is open: it stands still as it is
    /// then. Without, its mesh opens from day to day
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    day: Option<f64>,
}

#[derive(Args)]
struct TreeOptions {
    #[command(flatten)]
    body: BodyOptions,
    /// How branches of each order meet: perfect, uniform, increasing, fern, river,
    /// tokunaga:A,C, or a file with a list of rows, as [[0.5,0.5],[0.5,0.25,0.25]]
    #[arg(long, value_name = "NAME|FILE.json", verbatim_doc_comment)]
    matrix: Option<String>,
    /// The order of the root, from 1 to 12
    #[arg(long, value_name = "S", value_parser = from_one_to::<12>, allow_negative_numbers = true)]
    order: Option<u32>,
}

/// What all bodies have in common.
#[derive(Args)]
struct BodyOptions {
    /// The numbers of the body; what the file leaves out has a default
    #[arg(long, value_name = "FILE.json")]
    numbers: Option<PathBuf>,
    /// The seed, from 0 to 4294967295; each one is another individual
    #[arg(
        long, value_name = "N", default_value = "1", value_parser = whole,
        allow_negative_numbers = true
    )]
    individual: u32,
    /// Writes the body as a mesh, in centimetres
    #[arg(long, value_name = "OUT.obj")]
    obj: Option<PathBuf>,
    /// Prints one JSON object with what there is in the body, not a line
    #[arg(long)]
    stats: bool,
}

pub fn shape(options: &ShapeOptions) -> Result<(), Refusal> {
    match &options.what {
        Shape::Leaf(options) => leaf(&options.body),
        Shape::Flower(options) => flower(options),
        Shape::Tree(options) => tree(options),
    }
}

/// What is told of a leaf.
#[derive(Serialize)]
struct LeafStats {
    lobes: u32,
    main_veins: usize,
    secondary_veins: usize,
    vein_length_cm: f64,
    /// Before its sides are curved.
    border_corners: usize,
    area_cm2: f64,
    fine_vein_length_cm: f64,
    /// That fine veins close.
    loops: usize,
}

fn leaf(body: &BodyOptions) -> Result<(), Refusal> {
    let numbers = body.read(LeafNumbers::from_json)?;
    let target = body.target()?;
    let leaf = Leaf::new(&numbers, body.individual).map_err(|e| e.to_string())?;
    if let Some(target) = target {
        write(target, &leaf.mesh())?;
    }
    let main_veins = leaf.plan.lobes.len();
    let stats = LeafStats {
        lobes: numbers.lobes,
        main_veins,
        secondary_veins: leaf.plan.veins.len() - main_veins,
        vein_length_cm: leaf.plan.vein_length(),
        border_corners: Limb::straight(&leaf.plan).corners(),
        area_cm2: leaf.limb.area(),
        fine_vein_length_cm: leaf.fine.length_cm(),
        loops: leaf.fine.joins.len(),
    };
    let line = format!(
        "leaf of {}, individual {}: {:.2} cm\u{b2}, {} veins of {:.1} cm together",
        if stats.lobes == 1 { "1 lobe".into() } else { format!("{} lobes", stats.lobes) },
        body.individual,
        stats.area_cm2,
        leaf.plan.veins.len(),
        stats.vein_length_cm
    );
    body.tell(&stats, &line)
}

/// What is told of a flower.
#[derive(Serialize)]
struct FlowerStats {
    day: f64,
    petals: u32,
    sepals: u32,
    stamens: u32,
    pistils: u32,
    /// Of the petals on that day, one side of them.
    area_cm2: f64,
}

fn flower(options: &FlowerOptions) -> Result<(), Refusal> {
    let body = &options.body;
    let numbers = body.read(FlowerNumbers::from_json)?;
    let day = options.day.unwrap_or(numbers.open_day);
    if !(0.0..=numbers.open_day).contains(&day) {
        return Err(format!("--day is {day}: it must be from 0 to {}", numbers.open_day));
    }
    let target = body.target()?;
    let flower = Flower::new(&numbers, body.individual).map_err(|e| e.to_string())?;
    let time = day / numbers.open_day;
    if let Some(target) = target {
        let mesh = match options.day {
            Some(_) => PolygonMesh { positions: flower.at(time), ..flower.mesh() },
            None => opening(&flower, numbers.open_day),
        };
        write(target, &mesh)?;
    }
    let stats = FlowerStats {
        day,
        petals: numbers.petals.arrangement.count(),
        sepals: numbers.sepals.map_or(0, |sepals| sepals.count()),
        stamens: numbers.stamens.map_or(0, |stamens| stamens.count),
        pistils: u32::from(numbers.pistil.is_some()) + numbers.receptacle.map_or(0, |r| r.carpels),
        area_cm2: flower.area_cm2(time),
    };
    let line = format!(
        "flower of {} petals, individual {}, day {day}: {:.2} cm\u{b2}, {} stamens, {} pistils",
        stats.petals, body.individual, stats.area_cm2, stats.stamens, stats.pistils
    );
    body.tell(&stats, &line)
}

/// What is told of a tree.
#[derive(Serialize)]
struct TreeStats {
    order: u32,
    leaves: u64,
    branches: Vec<u64>,
    matrix: Vec<Vec<f64>>,
}

fn tree(options: &TreeOptions) -> Result<(), Refusal> {
    let body = &options.body;
    let mut numbers = body.read(TreeNumbers::from_json)?;
    numbers.order = options.order.unwrap_or(numbers.order);
    let matrix = match &options.matrix {
        Some(text) => matrix(text)?,
        None => of_numbers(body, numbers.matrix.ramification())?,
    };
    let target = body.target()?;
    let tree = Tree::draw(&matrix, numbers.order, body.individual).map_err(|e| e.to_string())?;
    if let Some(target) = target {
        write(target, &of_numbers(body, branching::body(&tree, &numbers))?)?;
    }
    let Census { leaves, branches, .. } = Census::new(&tree);
    let matrix = Census::new(&tree).matrix();
    let stats = TreeStats { order: numbers.order, leaves, branches, matrix };
    let by_order: Vec<String> = stats.branches.iter().map(u64::to_string).collect();
    let line = format!(
        "tree of order {}, individual {}: {} leaves, branches by order {}",
        stats.order,
        body.individual,
        stats.leaves,
        by_order.join(" ")
    );
    body.tell(&stats, &line)
}

/// A matrix by its name or, where that looks like one, of a file.
fn matrix(text: &str) -> Result<Ramification, Refusal> {
    let path = Path::new(text);
    let is_file = path.extension().is_some_and(|end| end.eq_ignore_ascii_case("json"));
    if is_file || text.contains(['/', '\\']) {
        let rows = fs::read_to_string(path).map_err(|e| cannot("read", path, &e))?;
        return Ramification::from_json(&rows).map_err(|e| of_file(path, &e));
    }
    Matrix::Named(text.into()).ramification().map_err(|e| e.to_string())
}

impl BodyOptions {
    /// The numbers of the file, or those that stand for none.
    fn read<T: Default>(&self, parse: fn(&str) -> Result<T, ShapeError>) -> Result<T, Refusal> {
        let Some(path) = &self.numbers else { return Ok(T::default()) };
        let text = fs::read_to_string(path).map_err(|e| cannot("read", path, &e))?;
        parse(&text).map_err(|e| of_file(path, &e))
    }

    /// Where the mesh goes, if anywhere.
    fn target(&self) -> Result<Option<Target>, Refusal> {
        self.obj.as_deref().map(Target::new).transpose()
    }

    fn tell(&self, stats: &impl Serialize, line: &str) -> Result<(), Refusal> {
        if self.stats {
            let json = serde_json::to_string(stats).map_err(|e| e.to_string())?;
            return say(&format!("{json}\n"));
        }
        say(&format!("{line}\n"))
    }
}

fn write(target: Target, mesh: &PolygonMesh) -> Result<(), Refusal> {
    target.write(|out| out.write_all(mesh.to_obj().as_bytes()))
}

/// What is wrong with the numbers as a whole, with the file that they come from.
fn of_numbers<T>(body: &BodyOptions, made: Result<T, ShapeError>) -> Result<T, Refusal> {
    made.map_err(|e| match &body.numbers {
        Some(path) => of_file(path, &e),
        None => e.to_string(),
    })
}

fn of_file(path: &Path, error: &ShapeError) -> Refusal {
    format!("{}: {error}", path.display())
}
