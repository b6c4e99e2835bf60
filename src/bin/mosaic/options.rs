//! What the command line says.

mod export;
mod fit;

use super::Refusal;
use super::shape::ShapeOptions;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{ArgAction, Args, Parser, Subcommand};
use clonal_mosaic::plants;
use clonal_mosaic::surface::quoted;
pub use export::ExportOptions;
pub use fit::FitOptions;
use std::error::Error;
use std::path::PathBuf;

/// The plant when none is named.
pub const FIRST_PLANT: &str = "croton";

/// Grows a plant's Clonal Mosaic, cell for cell the one that the playground shows.
#[derive(Parser)]
#[command(
    name = "mosaic",
    version,
    after_help = "mosaic COMMAND --help lists the options of a command.\n\n\
                  Exit status: 0, or 2 with one line on the standard error when the input cannot be used."
)]
struct CommandLine {
    #[command(subcommand)]
    command: Command,
}

/// What the caller wants.
#[derive(Subcommand)]
pub enum Command {
    /// One individual, day by day
    Grow(GrowOptions),
    /// Many individuals of every picture of the thesis' Table 4.1, and their means
    ///
    /// Many individuals of every picture of the thesis' Table 4.1, and their means: cells and how many
    /// are expected, shares of the types by count and by area, patches of the first type, and the
    /// share of neighbours that are of unlike type.
    #[command(verbatim_doc_comment)]
    Figures(FigureOptions),
    /// Many individuals of a plant for every value of some of its numbers, and their means
    ///
    /// Many individuals of a plant for every value of some of its numbers, or for every combination of
    /// them, and their means as `mosaic figures` has them, each with the link that shows it.
    #[command(verbatim_doc_comment)]
    Sweep(SweepOptions),
    /// Numbers of a plant's recipe with which it becomes what is wanted
    ///
    /// Numbers of a plant's recipe with which it becomes what is wanted, found by trying: each try that is
    /// better than all before is printed with its link. Ctrl-C ends it.
    #[command(verbatim_doc_comment)]
    Fit(FitOptions),
    /// A plant as a document: JSON with all that makes it, for mosaic grow --plant
    Plant(PlantNameOptions),
    /// The plant of a day in a file, for other programs
    ///
    /// The plant of a day in a file, for other programs: its mosaic as triangles in the colours that the
    /// page shows, with its bare parts, or its cells or clones as a table. docs/export.md says more.
    #[command(verbatim_doc_comment)]
    Export(Box<ExportOptions>),
    /// A body grown from rules: a leaf, or a tree
    Shape(ShapeOptions),
    /// How fast the engine is on this machine
    Bench(BenchOptions),
}

#[derive(Args)]
pub struct GrowOptions {
    #[command(flatten)]
    source: SourceOptions,
    /// A body of your own, patterned all over: OBJ or PLY in centimetres, or GLB in metres
    #[arg(long, value_name = "FILE")]
    pub mesh: Option<PathBuf>,
    /// The seed, from 0 to 4294967295; each one is another individual
    #[arg(long, value_name = "N", value_parser = whole, allow_negative_numbers = true)]
    pub individual: Option<u32>,
    /// The last day to grow; without it the link's day, or all days of the recipe
    #[arg(long, value_name = "D", value_parser = whole, allow_negative_numbers = true)]
    pub day: Option<u32>,
    /// Writes the cells of the last day as a table:
    /// id,parent,founder,type,part,triangle,x,y,z,born_day
    #[arg(long, value_name = "OUT.csv", verbatim_doc_comment)]
    pub cells: Option<PathBuf>,
    /// So many threads share the work; without it one for each core. The cells are the same
    #[arg(long, value_name = "N", value_parser = from_one_to::<256>, allow_negative_numbers = true)]
    pub threads: Option<u32>,
    /// Prints one JSON object with all days, not a line for each
    #[arg(long)]
    pub json: bool,
}

/// What to grow: one of them, or the croton.
#[derive(Args)]
#[group(multiple = false)]
struct SourceOptions {
    /// The plant of a playground link, or of the part after its #
    #[arg(long, value_name = "TEXT")]
    link: Option<String>,
    #[arg(long, value_name = "NAME", help = presets())]
    preset: Option<String>,
    /// A recipe in JSON; what it leaves out has a default. Without --mesh it grows on the croton
    #[arg(long, value_name = "FILE.json")]
    recipe: Option<PathBuf>,
    /// A plant as mosaic plant prints it. With --mesh its images and guides lie on that body
    #[arg(long, value_name = "FILE.json")]
    plant: Option<PathBuf>,
}

/// Where the recipe comes from.
pub enum Source<'a> {
    Link(&'a str),
    Preset(&'a str),
    Recipe(&'a PathBuf),
    Plant(&'a PathBuf),
}

impl GrowOptions {
    pub fn source(&self) -> Source<'_> {
        match &self.source {
            SourceOptions { link: Some(text), .. } => Source::Link(text),
            SourceOptions { recipe: Some(path), .. } => Source::Recipe(path),
            SourceOptions { plant: Some(path), .. } => Source::Plant(path),
            SourceOptions { preset, .. } => {
                Source::Preset(preset.as_deref().unwrap_or(FIRST_PLANT))
            }
        }
    }
}

/// What `mosaic figures` is asked for.
#[derive(Args)]
pub struct FigureOptions {
    /// This figure alone, as 4.8 or Taxonomy; may be said several times
    #[arg(
        long = "figure", value_name = "NUMBER", action = ArgAction::Append,
        conflicts_with = "merge"
    )]
    pub figures: Vec<String>,
    #[command(flatten)]
    pub many: ManyOptions,
}

/// What `mosaic sweep` is asked for.
#[derive(Args)]
pub struct SweepOptions {
    #[command(flatten)]
    source: PlantOptions,
    /// The day to grow to; without it the link's day, or all days of the plant
    #[arg(
        long, value_name = "D", value_parser = whole, allow_negative_numbers = true,
        conflicts_with = "merge"
    )]
    pub day: Option<u32>,
    /// A number by its word in links, and its values: df=4..12:5 are five from 4 to 12 in even steps
    /// (without :5, too), df=4,6,12 are these. Said several times, every combination grows
    #[arg(
        long, value_name = "KEY=FROM..TO[:N]", action = ArgAction::Append,
        conflicts_with = "merge", verbatim_doc_comment
    )]
    pub vary: Vec<String>,
    #[command(flatten)]
    pub many: ManyOptions,
}

/// Which plant: one of them, or the croton.
#[derive(Args)]
#[group(multiple = false, conflicts_with = "merge")]
struct PlantOptions {
    /// The plant and the numbers of a playground link, or of the part after its #
    #[arg(long, value_name = "TEXT")]
    link: Option<String>,
    #[arg(long, value_name = "NAME", help = presets())]
    preset: Option<String>,
}

impl SweepOptions {
    pub fn source(&self) -> Source<'_> {
        match &self.source {
            PlantOptions { link: Some(text), .. } => Source::Link(text),
            PlantOptions { preset, .. } => Source::Preset(preset.as_deref().unwrap_or(FIRST_PLANT)),
        }
    }
}

/// How many individuals, and what becomes of their rows.
#[derive(Args)]
pub struct ManyOptions {
    /// Individuals 1 to N of each
    #[arg(
        long, value_name = "N", default_value = "5",
        value_parser = from_one_to::<100_000>, allow_negative_numbers = true
    )]
    pub individuals: u32,
    /// As many at a time; without it one for each core. The numbers are the same
    #[arg(long, value_name = "N", value_parser = from_one_to::<1000>, allow_negative_numbers = true)]
    pub threads: Option<u32>,
    /// Makes the table of the rows of all shards
    #[arg(
        long, value_name = "FILE", num_args = 1..,
        conflicts_with_all = ["individuals", "threads", "shard"]
    )]
    pub merge: Vec<PathBuf>,
    #[command(flatten)]
    pub print: PrintOptions,
}

/// What is printed of a sweep; a table to read when nothing is said.
#[derive(Args)]
#[group(multiple = false)]
pub struct PrintOptions {
    /// Grows the K-th of N parts of the work, and prints a row for each individual
    #[arg(long, value_name = "K/N", value_parser = part)]
    pub shard: Option<(u32, u32)>,
    /// Prints the table as CSV
    #[arg(long)]
    csv: bool,
    /// Prints the table as one JSON object
    #[arg(long)]
    json: bool,
}

#[derive(Clone, Copy)]
pub enum Format {
    Text,
    Csv,
    Json,
}

impl PrintOptions {
    pub fn format(&self) -> Format {
        match (self.csv, self.json) {
            (true, _) => Format::Csv,
            (_, true) => Format::Json,
            _ => Format::Text,
        }
    }
}

#[derive(Args)]
pub struct PlantNameOptions {
    #[arg(value_name = "NAME", help = presets())]
    pub name: String,
}

#[derive(Args)]
pub struct BenchOptions {
    /// The best of N runs is told
    #[arg(
        long, value_name = "N", default_value = "3",
        value_parser = from_one_to::<100>, allow_negative_numbers = true
    )]
    pub runs: u32,
}

/// What a command line asks for.
pub enum Asked {
    For(Box<Command>),
    /// Help or the version.
    Text(String),
}

/// Reads the command line of this process.
pub fn read() -> Result<Asked, Refusal> {
    match CommandLine::try_parse() {
        Ok(line) => Ok(Asked::For(Box::new(line.command))),
        Err(error) => match error.kind() {
            ErrorKind::DisplayHelp | ErrorKind::DisplayVersion => {
                Ok(Asked::Text(error.render().to_string()))
            }
            _ => Err(refusal(&error)),
        },
    }
}

/// What clap says in several lines, in one.
fn refusal(error: &clap::Error) -> Refusal {
    let context = |kind| match error.get(kind) {
        Some(ContextValue::String(text)) => plain(text),
        Some(ContextValue::Strings(texts)) => {
            texts.iter().map(|t| plain(t)).collect::<Vec<_>>().join(", ")
        }
        _ => String::new(),
    };
    // `--day <D>`
    let option = |kind| context(kind).split(" <").next().unwrap_or_default().to_string();
    let argument = option(ContextKind::InvalidArg);
    match error.kind() {
        ErrorKind::MissingSubcommand | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => {
            let told = error.render().to_string();
            if told.contains("mosaic shape") {
                return "say which: mosaic shape leaf, flower or tree, or mosaic shape --help"
                    .into();
            }
            "say what to do: mosaic grow, figures, sweep, fit, export, shape, plant or bench, or mosaic --help".into()
        }
        ErrorKind::InvalidSubcommand => {
            format!(
                "there is no command {}; try mosaic --help",
                context(ContextKind::InvalidSubcommand)
            )
        }
        ErrorKind::UnknownArgument => format!("{argument} is unknown here; try mosaic --help"),
        ErrorKind::ArgumentConflict => match option(ContextKind::PriorArg) {
            prior if prior == argument => format!("there can be only one {argument}"),
            prior => format!("{argument} and {prior}: there can be only one of them"),
        },
        ErrorKind::ValueValidation => {
            let why = error.source().map(ToString::to_string).unwrap_or_default();
            format!("{argument} is {}: {why}", context(ContextKind::InvalidValue))
        }
        _ => {
            let told = error.render().to_string();
            let line = told.lines().next().unwrap_or_default().trim_start_matches("error: ");
            format!("{line}; try mosaic --help")
        }
    }
}

/// Plain words as they are, anything else in quotes and not too long.
fn plain(text: &str) -> String {
    let is_plain = |c: char| c.is_ascii_graphic() || c == ' ';
    if text.len() <= 40 && text.chars().all(is_plain) { text.to_string() } else { quoted(text) }
}

fn presets() -> String {
    let keys: Vec<&str> = plants::all().iter().map(|plant| plant.key).collect();
    let lines: Vec<String> = keys.chunks(6).map(|keys| keys.join(", ")).collect();
    format!("A plant of the playground:\n{}", lines.join(",\n"))
}

pub fn whole(text: &str) -> Result<u32, String> {
    text.parse().map_err(|_| format!("it must be a whole number from 0 to {}", u32::MAX))
}

pub fn from_one_to<const MOST: u32>(text: &str) -> Result<u32, String> {
    match text.parse() {
        Ok(number) if (1..=MOST).contains(&number) => Ok(number),
        _ => Err(format!("it must be a whole number from 1 to {MOST}")),
    }
}

/// `3/10`: the third of ten parts.
fn part(text: &str) -> Result<(u32, u32), String> {
    match text.split_once('/').map(|(k, n)| (k.parse(), n.parse())) {
        Some((Ok(k), Ok(n))) if (1..=n).contains(&k) => Ok((k, n)),
        _ => Err("it must say which of how many, from 1/N to N/N".into()),
    }
}
