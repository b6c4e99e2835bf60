//! The table of a sweep: a line for each picture, with the means of its individuals.

use super::Refusal;
use super::options::Format;
use super::sweep::Row;
use serde::Serialize;
use std::fmt::Write;

/// A whole table, as `--json` prints it.
#[derive(Serialize)]
pub struct Table {
    individuals: usize,
    pictures: Vec<Line>,
}

/// A picture. Numbers are means over its individuals.
#[derive(Serialize)]
struct Line {
    figure: String,
    picture: String,
    cells: f64,
    /// What the model expects of these first cells, and the standard error of the mean of so many
    /// individuals; both from the model alone.
    expected_cells: Option<f64>,
    standard_error: Option<f64>,
    count_shares: Shares,
    area_shares: Shares,
    patches: f64,
    mixed_edges: f64,
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
    pub fn of(mut rows: Vec<Row>) -> Result<Table, Refusal> {
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
        Ok(Table { individuals: last, pictures: rows.chunks(last).map(Line::of).collect() })
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
        let mut text = format!(
            "Means of {} individuals. Expected: what the model says of the first cells that were\n\
             drawn, and the standard error of such a mean. Shares in %.\n\n\
             {:44}{:^18}{:^18}{:>10}{:>8}\n\
             {:8}{:18}{:>9}{:>9}{:>6}{:>6}{:>6}{:>6}{:>6}{:>6}{:>6}{:>10}{:>8}\n",
            self.individuals,
            "",
            "by count",
            "by area",
            "patches",
            "mixed",
            "figure",
            "picture",
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
            "edges"
        );
        for line in &self.pictures {
            let Line { figure, picture, cells, count_shares, area_shares, .. } = line;
            let known = |x: Option<f64>| x.map_or("-".into(), |x| format!("{x:.0}"));
            let _ = writeln!(
                text,
                "{figure:8}{picture:18}{cells:>9.0}{:>9}{:>6}{count_shares}{area_shares}{:>10.1}{:>8.1}",
                known(line.expected_cells),
                known(line.standard_error),
                line.patches,
                100.0 * line.mixed_edges
            );
        }
        text
    }

    fn to_csv(&self) -> String {
        let mut text =
            "figure,picture,individuals,cells,expected_cells,standard_error,F,B,M,area_F,\
                        area_B,area_M,patches,mixed_edges\n"
                .to_string();
        for line in &self.pictures {
            let known = |x: Option<f64>| x.map_or(String::new(), |x| x.to_string());
            let (count, area) = (&line.count_shares, &line.area_shares);
            let _ = writeln!(
                text,
                "{},{},{},{},{},{},{},{},{},{},{},{},{},{}",
                line.figure,
                line.picture,
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
                line.mixed_edges
            );
        }
        text
    }
}

impl Line {
    /// The means of all individuals of one picture.
    fn of(rows: &[Row]) -> Line {
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
            figure: rows[0].figure.clone(),
            picture: rows[0].picture.clone(),
            cells: mean(&|row| f64::from(row.cells())),
            expected_cells: expected(0),
            standard_error: expected(1).map(|variance| (variance / n).sqrt()),
            count_shares: shares(&share),
            area_shares: shares(&|row, kind| row.area_shares[kind]),
            patches: mean(&|row| f64::from(row.patches)),
            mixed_edges: mean(&|row| row.mixed_edges),
        }
    }
}

/// Three columns of a line of text.
impl std::fmt::Display for Shares {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        [self.f, self.b, self.m].iter().try_for_each(|share| write!(f, "{:>6.1}", 100.0 * share))
    }
}
