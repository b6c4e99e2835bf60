//! The table of a sweep: a line for each picture, with the means of its individuals.

use super::Refusal;
use super::individuals::Row;
use super::options::Format;
use serde::Serialize;
use serde::ser::{SerializeMap, Serializer};
use std::fmt::Write;

/// What the lines of a table are.
#[derive(Clone, Copy, PartialEq)]
pub enum Kind {
    /// Pictures of the thesis.
    Figures,
    /// A plant with some of its numbers varied.
    Sweep,
}

/// A whole table, as `--json` prints it.
#[derive(Serialize)]
pub struct Table {
    #[serde(skip)]
    kind: Kind,
    individuals: usize,
    pictures: Vec<Line>,
}

/// A picture. Numbers are means over its individuals.
#[derive(Serialize)]
struct Line {
    #[serde(flatten)]
    names: Names,
    cells: f64,
    /// What the model expects of these first cells, and the standard error of the mean of so many
    /// individuals; both from the model alone.
    expected_cells: Option<f64>,
    standard_error: Option<f64>,
    count_shares: Shares,
    area_shares: Shares,
    patches: f64,
    mixed_edges: f64,
    /// What the playground shows its first individual by.
    link: String,
}

/// What a line is about, in columns: figure and picture, or the plant and each number that varies.
struct Names(Vec<(String, String)>);

impl Names {
    fn of(row: &Row, kind: Kind) -> Names {
        let name = |heading: &str, value: &str| (heading.to_string(), value.to_string());
        if kind == Kind::Figures {
            return Names(vec![name("figure", &row.figure), name("picture", &row.picture)]);
        }
        let numbers = row.picture.split_whitespace().filter_map(|word| word.split_once('='));
        let numbers = numbers.map(|(key, value)| name(key, value));
        Names([name("plant", &row.figure)].into_iter().chain(numbers).collect())
    }
}

impl Serialize for Names {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for (heading, value) in &self.0 {
            // A figure's number has the form of one, but 4.1 and 4.10 are two.
            match value.parse::<f64>().ok().filter(|_| heading != "figure") {
                Some(number) => map.serialize_entry(heading, &number)?,
                None => map.serialize_entry(heading, value)?,
            }
        }
        map.end()
    }
}

/// Shares of the types, 0 to 1.
#[derive(Serialize)]
#[serde(rename_all = "UPPERCASE")]
struct Shares {
    f: f64,
    b: f64,
    m: f64,
}

impl Table {
    /// The table of all rows of one sweep, in any order. Refuses rows that are missing, that come
    /// twice, or that are of different sweeps.
    pub fn of(mut rows: Vec<Row>, kind: Kind) -> Result<Table, Refusal> {
        rows.sort_by_key(|row| row.item);
        let items = rows.first().map_or(0, |row| row.items);
        if rows.iter().any(|row| row.items != items) {
            return Err("the rows are of different sweeps".into());
        }
        if let Some(pair) = rows.windows(2).find(|pair| pair[0].item == pair[1].item) {
            return Err(format!("row {} of {items} comes twice", pair[0].item));
        }
        if let Some(missing) = (0..items).find(|&k| rows.get(k).is_none_or(|row| row.item != k)) {
            let count = items.saturating_sub(rows.len());
            return Err(format!("{count} of {items} rows are missing, the first is row {missing}"));
        }
        if rows.is_empty() {
            return Err("there are no rows".into());
        }
        let last = rows.iter().map(|row| row.individual as usize).max().unwrap_or(1);
        let picture = |row: &Row| (row.figure.clone(), row.picture.clone());
        let is_whole = |of_picture: &[Row]| {
            let numbers = of_picture.iter().map(|row| row.individual as usize);
            numbers.eq(1..=last) && of_picture.iter().all(|r| picture(r) == picture(&of_picture[0]))
        };
        if !rows.chunks(last.max(1)).all(is_whole) {
            return Err("the rows are of different sweeps".into());
        }
        // A sweep says the key of a plant, and a figure has a number or a name.
        let is_of_kind = |row: &Row| {
            (kind == Kind::Sweep) == row.figure.starts_with(|c: char| c.is_ascii_lowercase())
        };
        if !rows.iter().all(is_of_kind) {
            let [this, other] = match kind {
                Kind::Figures => ["figures", "sweep"],
                Kind::Sweep => ["sweep", "figures"],
            };
            return Err(format!("these rows are not of mosaic {this}: try mosaic {other} --merge"));
        }
        let pictures = rows.chunks(last).map(|rows| Line::of(rows, kind)).collect();
        Ok(Table { kind, individuals: last, pictures })
    }

    pub fn print(&self, format: Format) -> String {
        match format {
            Format::Text => self.to_text(),
            Format::Csv => self.to_csv(),
            Format::Json => {
                serde_json::to_string(self).expect("a table holds plain numbers and words") + "\n"
            }
        }
    }

    fn to_text(&self) -> String {
        let names: Vec<&Names> = self.pictures.iter().map(|line| &line.names).collect();
        let columns = names.first().map_or(&[][..], |names| &names.0);
        let widths: Vec<usize> = (0..columns.len())
            .map(|k| {
                let value = |names: &&Names| names.0.get(k).map_or(0, |(_, v)| v.chars().count());
                let widest = names.iter().map(value).max().unwrap_or(0);
                widest.max(columns[k].0.len()) + 2
            })
            .collect();
        let padded = |texts: &mut dyn Iterator<Item = &str>| -> String {
            texts.zip(&widths).map(|(text, width)| format!("{text:width$}")).collect()
        };
        let mut text = format!(
            "Means of {} individuals. Expected: what the model says of the first cells that were\n\
             drawn, and the standard error of such a mean. Shares in %.\n\n\
             {:width$}{:^18}{:^18}{:>10}{:>8}\n\
             {}{:>9}{:>9}{:>6}{:>6}{:>6}{:>6}{:>6}{:>6}{:>6}{:>10}{:>8}\n",
            self.individuals,
            "",
            "by count",
            "by area",
            "patches",
            "mixed",
            padded(&mut columns.iter().map(|(heading, _)| heading.as_str())),
            "cells",
            "expected",
            "+-",
            "F",
            "B",
            "M",
            "F",
            "B",
            "M",
            "of F",
            "edges",
            width = widths.iter().sum::<usize>() + 24
        );
        for line in &self.pictures {
            let Line { names, cells, count_shares, area_shares, .. } = line;
            let known = |x: Option<f64>| x.map_or("-".into(), |x| format!("{x:.0}"));
            let link =
                if self.kind == Kind::Sweep { format!("  {}", line.link) } else { String::new() };
            let _ = writeln!(
                text,
                "{}{cells:>9.0}{:>9}{:>6}{count_shares}{area_shares}{:>10.1}{:>8.1}{link}",
                padded(&mut names.0.iter().map(|(_, value)| value.as_str())),
                known(line.expected_cells),
                known(line.standard_error),
                line.patches,
                100.0 * line.mixed_edges
            );
        }
        text
    }

    fn to_csv(&self) -> String {
        let comma = |texts: &mut dyn Iterator<Item = &str>| texts.collect::<Vec<_>>().join(",");
        let columns = self.pictures.first().map_or(&[][..], |line| &line.names.0);
        let mut text = format!(
            "{},individuals,cells,expected_cells,standard_error,F,B,M,area_F,area_B,area_M,\
             patches,mixed_edges,link\n",
            comma(&mut columns.iter().map(|(heading, _)| heading.as_str()))
        );
        for line in &self.pictures {
            let known = |x: Option<f64>| x.map_or(String::new(), |x| x.to_string());
            let (count, area) = (&line.count_shares, &line.area_shares);
            let _ = writeln!(
                text,
                "{},{},{},{},{},{},{},{},{},{},{},{},{},{}",
                comma(&mut line.names.0.iter().map(|(_, value)| value.as_str())),
                self.individuals,
                line.cells,
                known(line.expected_cells),
                known(line.standard_error),
                count.f,
                count.b,
                count.m,
                area.f,
                area.b,
                area.m,
                line.patches,
                line.mixed_edges,
                line.link
            );
        }
        text
    }
}

impl Line {
    /// The means of all individuals of one picture.
    fn of(rows: &[Row], kind: Kind) -> Line {
        let n = rows.len() as f64;
        let mean = |value: &dyn Fn(&Row) -> f64| rows.iter().map(value).sum::<f64>() / n;
        let shares = |value: &dyn Fn(&Row, usize) -> f64| {
            let [f, b, m] = [0, 1, 2].map(|kind| mean(&|row| value(row, kind)));
            Shares { f, b, m }
        };
        let expected = |k: usize| {
            let all: Option<Vec<f64>> = rows.iter().map(|row| Some(row.expected?[k])).collect();
            all.map(|values| values.iter().sum::<f64>() / n)
        };
        let share = |row: &Row, kind: usize| f64::from(row.by_type[kind]) / f64::from(row.cells());
        Line {
            names: Names::of(&rows[0], kind),
            cells: mean(&|row| f64::from(row.cells())),
            expected_cells: expected(0),
            standard_error: expected(1).map(|variance| (variance / n).sqrt()),
            count_shares: shares(&share),
            area_shares: shares(&|row, kind| row.area_shares[kind]),
            patches: mean(&|row| f64::from(row.patches)),
            mixed_edges: mean(&|row| row.mixed_edges),
            link: rows[0].link.clone(),
        }
    }
}

/// Three columns of a line of text.
impl std::fmt::Display for Shares {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        [self.f, self.b, self.m].iter().try_for_each(|share| write!(f, "{:>6.1}", 100.0 * share))
    }
}
