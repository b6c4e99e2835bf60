//! A clone in hand, and the family map: in which colours cells are seen then, and what is told of a clone.

use super::page::ShownDay;
use super::run::Run;
use super::words::{grouped, share};
use crate::mosaic::{ClanColours, Site, touching};
use crate::surface::Mesh;

/// What is told of the clone in hand, in sentences.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Told {
    /// `Clone of cell 1,234`, or `Clan of first cell 17`.
    pub title: String,
    /// Type, birthday and line of mothers.
    pub story: String,
    /// How large it is on the day that is shown.
    pub size: String,
    /// From its first day on, how many cells it has.
    pub days: Vec<(u32, u32)>,
    /// Whether there is a mother to go back to.
    pub has_mother: bool,
}

impl Told {
    /// `sizes`: how many cells the clone of the cell has on each day that has grown.
    pub fn of(run: &Run, cell: u32, sizes: &[u32], shown: Option<&ShownDay>) -> Told {
        let name = grouped(cell);
        let pedigree = &run.pedigree;
        if cell >= pedigree.cells() {
            return Told {
                title: format!("Clone of cell {name}"),
                story: "Not born on the days that have grown so far.".to_string(),
                size: String::new(),
                days: Vec::new(),
                has_mother: false,
            };
        }
        let birthday = pedigree.birthday(cell);
        let mut colour = match run.scene.noise {
            // Its colour changes with the noise.
            true => "cell".to_string(),
            false => run.scene.plant.colour_names[pedigree.kind(cell) as usize].to_string(),
        };
        if let Some(first) = colour.get_mut(..1) {
            first.make_ascii_uppercase();
        }
        let mut mothers = pedigree.mothers(cell);
        let mother = mothers.next();
        let (title, story) = match mother {
            None => (
                format!("Clan of first cell {name}"),
                format!("{colour}, one of the {} first cells.", grouped(pedigree.clans())),
            ),
            Some(mother) => {
                let back = 1 + mothers.count() as u32;
                let founder = pedigree.founders()[cell as usize];
                let divisions = if back == 1 { "division" } else { "divisions" };
                let story = format!(
                    "{colour}, born on day {birthday} of cell {}. {back} {divisions} back to first \
                     cell {}.",
                    grouped(mother),
                    grouped(founder)
                );
                (format!("Clone of cell {name}"), story)
            }
        };
        let size = match shown {
            Some(shown) if shown.day < birthday => {
                let stands = pedigree.of_line(cell, shown.day).unwrap_or(cell);
                format!(
                    "Day {}: not born yet; cell {} of its line is lit.",
                    shown.day,
                    grouped(stands)
                )
            }
            Some(shown) => {
                let size = sizes.get(shown.day as usize).copied().unwrap_or_default();
                let cells = if size == 1 { "cell" } else { "cells" };
                let of_all = share(size, shown.facts.count.cells);
                format!("Day {}: {} {cells}, {of_all} of all.", shown.day, grouped(size))
            }
            None => String::new(),
        };
        let days = (0..).zip(sizes.iter().copied()).skip(birthday as usize).collect();
        Told { title, story, size, days, has_mother: mother.is_some() }
    }

    /// All of it but the days.
    pub fn in_words(&self) -> String {
        format!("{}. {} {}", self.title, self.story, self.size)
    }
}

/// In which colours the cells of a day are seen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Paint {
    /// The cell that is lit with all of its clone, or, on days before the one in hand is born, alone.
    pub lit: Option<Lit>,
    /// Whether cells have the colours of their clans.
    pub clans: bool,
}

/// What is lit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lit {
    Clone(u32),
    Alone(u32),
}

/// Where cells have marks in the place of their lightness: whether they are lit, and else the number of a
/// colour, or what is left of the lightness.
const IS_LIT: u32 = 8;

impl Paint {
    /// `cell`: whose clone is in hand.
    pub fn of(run: &Run, day: u32, cell: Option<u32>, clans: bool) -> Paint {
        let of_line = |cell| Some((cell, run.pedigree.of_line(cell, day)?));
        let lit = cell.and_then(of_line).map(|(cell, stands)| match stands == cell {
            true => Lit::Clone(cell),
            false => Lit::Alone(stands),
        });
        Paint { lit, clans }
    }

    /// The marked sites of a day; none where cells are as they are.
    pub fn sites(self, run: &Run, day: u32, mesh: &Mesh, map: &mut ClanMap) -> Option<Vec<Site>> {
        let (lists, cell_of) = (run.lists(day)?, run.cell_of(day));
        if self == Paint::default() || cell_of.len() != lists.sites.len() {
            return None;
        }
        let clone = match self.lit {
            Some(Lit::Clone(cell)) => run.pedigree.clone_of(cell),
            Some(Lit::Alone(_)) | None => Vec::new(),
        };
        let is_lit = |cell: u32| match self.lit {
            Some(Lit::Clone(_)) => clone.get(cell as usize).is_some_and(|&is| is),
            Some(Lit::Alone(lit)) => cell == lit,
            None => true,
        };
        let founders = run.pedigree.founders();
        let colours = if self.clans { map.bring(run, day, mesh) } else { &[] };
        let marked = lists.sites.iter().zip(cell_of).map(|(site, &cell)| {
            let founder = founders.get(cell as usize).map_or(0, |&founder| founder as usize);
            let shade = match colours.get(founder) {
                Some(&colour) => u32::from(colour),
                None => site.tag().lightness / 2,
            };
            site.marked(shade | if is_lit(cell) { IS_LIT } else { 0 })
        });
        Some(marked.collect())
    }
}

/// The colours of the clans of one growth, as far as they were asked for.
#[derive(Clone, Debug, Default)]
pub struct ClanMap {
    generation: u32,
    colours: ClanColours,
}

impl ClanMap {
    /// The colours of a day that has grown. Those of the days before it are found first.
    fn bring(&mut self, run: &Run, day: u32, mesh: &Mesh) -> &[u8] {
        if self.generation != run.generation {
            *self = ClanMap { generation: run.generation, ..ClanMap::default() };
        }
        let founders = run.pedigree.founders();
        for next in self.colours.days()..=day as usize {
            let Some(lists) = run.lists(next as u32) else { return &[] };
            let cell_of = run.cell_of(next as u32);
            let clan_of = |site: usize| founders[cell_of[site] as usize];
            self.colours
                .add(run.pedigree.clans(), |is_wanted| touching(mesh, lists, clan_of, is_wanted));
        }
        self.colours.of(day as usize)
    }
}
