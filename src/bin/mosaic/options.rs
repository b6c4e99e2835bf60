//! What the command line says.

use super::Refusal;
use lexopt::{Arg, Parser, ValueExt};
use std::ffi::OsString;
use std::path::PathBuf;

/// The plant when none is named.
pub const FIRST_PLANT: &str = "croton";

pub const HELP: &str = "\
mosaic grows a plant's Clonal Mosaic, cell for cell the one that the playground shows.

Usage: mosaic grow [--link TEXT | --preset NAME | --recipe FILE.json] [--mesh FILE.obj]
                   [--individual N] [--day D] [--cells OUT.csv] [--json]
       mosaic figures [--figure NUMBER]... [--individuals N] [--threads N]
                      [--csv | --json | --shard K/N]
       mosaic figures --merge FILE... [--csv | --json]
       mosaic bench [--runs N]

mosaic grow: one individual, day by day.

What to grow (the croton when nothing is said):
  --link TEXT        the plant of a playground link, or of the part after its #
  --preset NAME      a plant of the playground: croton, cactus, watermelon, mushroom, philodendron,
                     sansevieria, square-watermelon, croton-shrub, red-croton, banded-cactus,
                     long-watermelon, amanita, philodendron-shoot
  --recipe FILE      a recipe in JSON; what it leaves out has a default. Without --mesh it grows on
                     the croton
  --mesh FILE        a body of your own as OBJ, patterned all over

How:
  --individual N     the seed, from 0 to 4294967295; each one is another individual
  --day D            the last day to grow; without it the link's day, or all days of the recipe

What comes out (a line for each day when nothing is said):
  --cells OUT.csv    the cells of the last day as a table:
                     id,parent,founder,type,part,triangle,x,y,z,born_day
  --json             one JSON object with all days instead of the lines

mosaic figures: many individuals of every picture of the thesis' Table 4.1, and their means: cells
and how many are expected, shares of the types by count and by area, patches of the first type, and
the share of neighbours that are of unlike type.

  --figure NUMBER    this figure alone, as 4.8; may be said several times
  --individuals N    individuals 1 to N of each picture; 5 when nothing is said
  --threads N        as many at a time; without it one for each core. The numbers are the same
  --shard K/N        grows the K-th of N parts of the work, and prints a row for each individual
  --merge FILE...    makes the table of the rows of all shards
  --csv, --json      the table as CSV, or as one JSON object

mosaic bench: how fast the engine is on this machine, beside the original program.

  --runs N           the best of N runs is told; 3 when nothing is said

  --help, --version

Exit status: 0, or 2 with one line on the standard error when the input cannot be used.
";

/// What the caller wants.
pub enum Command {
    Grow(GrowOptions),
    Figures(FigureOptions),
    Bench { runs: u32 },
    Help,
    Version,
}

pub struct GrowOptions {
    pub source: Source,
    pub mesh: Option<PathBuf>,
    pub individual: Option<u32>,
    pub day: Option<u32>,
    pub cells: Option<PathBuf>,
    pub json: bool,
}

/// Where the recipe comes from.
pub enum Source {
    Link(String),
    Preset(String),
    Recipe(PathBuf),
}

/// What `mosaic figures` is asked for.
pub enum FigureOptions {
    Grow {
        /// Numbers of figures; all when there is none.
        figures: Vec<String>,
        individuals: u32,
        threads: Option<u32>,
        print: Print,
    },
    Merge {
        files: Vec<PathBuf>,
        format: Format,
    },
}

/// What is printed of a sweep.
#[derive(Clone, Copy)]
pub enum Print {
    Table(Format),
    /// The rows of one of so many shards, counted from 1.
    Shard(u32, u32),
}

#[derive(Clone, Copy)]
pub enum Format {
    Text,
    Csv,
    Json,
}

/// Reads the command line of this process.
pub fn read() -> Result<Command, Refusal> {
    let mut parser = Parser::from_env();
    match next(&mut parser)? {
        Some(Arg::Long("help") | Arg::Short('h')) => Ok(Command::Help),
        Some(Arg::Long("version") | Arg::Short('V')) => Ok(Command::Version),
        Some(Arg::Value(word)) => match word.to_str() {
            Some("grow") => read_grow(parser),
            Some("figures") => read_figures(parser),
            Some("bench") => read_bench(parser),
            Some("help") => Ok(Command::Help),
            _ => Err(format!("{}; try mosaic --help", Arg::Value(word).unexpected())),
        },
        Some(other) => Err(format!("{}; try mosaic --help", other.unexpected())),
        None => Err("say what to do: mosaic grow, figures or bench, or mosaic --help".into()),
    }
}

fn read_grow(mut parser: Parser) -> Result<Command, Refusal> {
    let mut sources = Vec::new();
    let mut options = GrowOptions {
        source: Source::Preset(FIRST_PLANT.into()),
        mesh: None,
        individual: None,
        day: None,
        cells: None,
        json: false,
    };
    while let Some(arg) = next(&mut parser)? {
        match arg {
            Arg::Long("link") => sources.push(Source::Link(text("--link", value(&mut parser)?)?)),
            Arg::Long("preset") => {
                sources.push(Source::Preset(text("--preset", value(&mut parser)?)?));
            }
            Arg::Long("recipe") => sources.push(Source::Recipe(value(&mut parser)?.into())),
            Arg::Long("mesh") => options.mesh = Some(value(&mut parser)?.into()),
            Arg::Long("cells") => options.cells = Some(value(&mut parser)?.into()),
            Arg::Long("individual") => {
                options.individual = Some(whole("--individual", &value(&mut parser)?)?);
            }
            Arg::Long("day") => options.day = Some(whole("--day", &value(&mut parser)?)?),
            Arg::Long("json") => options.json = true,
            Arg::Long("help") | Arg::Short('h') => return Ok(Command::Help),
            other => return Err(format!("{}; try mosaic --help", other.unexpected())),
        }
    }
    if sources.len() > 1 {
        return Err("--link, --preset and --recipe: only one of them can be grown at a time".into());
    }
    if let Some(source) = sources.pop() {
        options.source = source;
    }
    Ok(Command::Grow(options))
}

fn read_figures(mut parser: Parser) -> Result<Command, Refusal> {
    let (mut figures, mut files, mut formats) = (Vec::new(), Vec::new(), Vec::new());
    let (mut individuals, mut threads, mut shard) = (None, None, None);
    while let Some(arg) = next(&mut parser)? {
        match arg {
            Arg::Long("figure") => figures.push(text("--figure", value(&mut parser)?)?),
            Arg::Long("individuals") => {
                individuals = Some(from_one_to(100_000, "--individuals", &value(&mut parser)?)?);
            }
            Arg::Long("threads") => {
                threads = Some(from_one_to(1000, "--threads", &value(&mut parser)?)?);
            }
            Arg::Long("shard") => shard = Some(part(&value(&mut parser)?)?),
            Arg::Long("merge") => {
                let named = parser.values().map_err(|e| format!("{e}; try mosaic --help"))?;
                files.extend(named.map(PathBuf::from));
            }
            Arg::Long("csv") => formats.push(Format::Csv),
            Arg::Long("json") => formats.push(Format::Json),
            Arg::Long("help") | Arg::Short('h') => return Ok(Command::Help),
            other => return Err(format!("{}; try mosaic --help", other.unexpected())),
        }
    }
    if formats.len() + usize::from(shard.is_some()) > 1 {
        return Err("--csv, --json and --shard: only one of them can be printed".into());
    }
    let format = formats.pop().unwrap_or(Format::Text);
    if files.is_empty() {
        let print = shard.map_or(Print::Table(format), |(k, n)| Print::Shard(k, n));
        let individuals = individuals.unwrap_or(5);
        return Ok(Command::Figures(FigureOptions::Grow { figures, individuals, threads, print }));
    }
    if !figures.is_empty() || individuals.is_some() || threads.is_some() || shard.is_some() {
        return Err("--merge takes the rows as they are, with --csv or --json at most".into());
    }
    Ok(Command::Figures(FigureOptions::Merge { files, format }))
}

fn read_bench(mut parser: Parser) -> Result<Command, Refusal> {
    let mut runs = 3;
    while let Some(arg) = next(&mut parser)? {
        match arg {
            Arg::Long("runs") => runs = from_one_to(100, "--runs", &value(&mut parser)?)?,
            Arg::Long("help") | Arg::Short('h') => return Ok(Command::Help),
            other => return Err(format!("{}; try mosaic --help", other.unexpected())),
        }
    }
    Ok(Command::Bench { runs })
}

/// `3/10`: the third of ten parts.
fn part(value: &OsString) -> Result<(u32, u32), Refusal> {
    let numbers = value.to_str().and_then(|text| text.split_once('/'));
    match numbers.map(|(k, n)| (k.parse(), n.parse())) {
        Some((Ok(k), Ok(n))) if (1..=n).contains(&k) => Ok((k, n)),
        _ => Err(format!(
            "--shard wants which of how many, from 1/N to N/N, not {:?}",
            value.to_string_lossy()
        )),
    }
}

fn from_one_to(most: u32, option: &str, value: &OsString) -> Result<u32, Refusal> {
    match whole(option, value)? {
        number if (1..=most).contains(&number) => Ok(number),
        number => Err(format!("{option} is {number}: it must be from 1 to {most}")),
    }
}

fn next(parser: &mut Parser) -> Result<Option<Arg<'_>>, Refusal> {
    parser.next().map_err(|e| format!("{e}; try mosaic --help"))
}

fn value(parser: &mut Parser) -> Result<OsString, Refusal> {
    parser.value().map_err(|e| format!("{e}; try mosaic --help"))
}

fn text(option: &str, value: OsString) -> Result<String, Refusal> {
    value.string().map_err(|_| format!("{option} wants text in UTF-8"))
}

fn whole(option: &str, value: &OsString) -> Result<u32, Refusal> {
    value.to_str().and_then(|text| text.parse().ok()).ok_or_else(|| {
        format!(
            "{option} wants a whole number from 0 to {}, not {:?}",
            u32::MAX,
            value.to_string_lossy()
        )
    })
}
