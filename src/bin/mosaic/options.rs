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

What to grow (the croton when nothing is said):
  --link TEXT        the plant of a playground link, or of the part after its #
  --preset NAME      a plant of the playground: croton, cactus, watermelon, mushroom, philodendron,
                     sansevieria, square-watermelon, croton-shrub, banded-cactus, long-watermelon,
                     amanita
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

  --help, --version

Exit status: 0, or 2 with one line on the standard error when the input cannot be used.
";

/// What the caller wants.
pub enum Command {
    Grow(Options),
    Help,
    Version,
}

pub struct Options {
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

/// Reads the command line of this process.
pub fn read() -> Result<Command, Refusal> {
    let mut parser = Parser::from_env();
    match next(&mut parser)? {
        Some(Arg::Long("help") | Arg::Short('h')) => Ok(Command::Help),
        Some(Arg::Long("version") | Arg::Short('V')) => Ok(Command::Version),
        Some(Arg::Value(word)) if word == "grow" => read_grow(parser),
        Some(Arg::Value(word)) if word == "help" => Ok(Command::Help),
        Some(other) => Err(format!("{}; try mosaic --help", other.unexpected())),
        None => Err("say what to do: mosaic grow, or mosaic --help".into()),
    }
}

fn read_grow(mut parser: Parser) -> Result<Command, Refusal> {
    let mut sources = Vec::new();
    let mut options = Options {
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
