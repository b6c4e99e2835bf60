//! Who was born of whom: what is kept of a growth to tell clones by.
//!
//! The **clone** of a cell is all that descend from it, and itself. The clone of a first cell is called
//! its **clan**.

use super::{CellType, Diary};

/// The parents of all cells that have been born, day by day. Cells are numbered in the order of their
/// birth, and a mother stays who she is: only her child is new.
#[derive(Clone, Debug, Default)]
pub struct Pedigree {
    /// Of each cell; a first cell is its own.
    parents: Vec<u32>,
    founders: Vec<u32>,
    kinds: Vec<CellType>,
    /// How many cells there were on each day.
    counts: Vec<u32>,
}

/// The type stands in the two high bits of a parent's number.
const TYPE_SHIFT: u32 = 30;

impl Pedigree {
    /// What a day of a diary adds to the pedigree of the days before it: a word for each cell that is
    /// new.
    pub fn news(diary: &Diary, day: usize) -> Vec<u32> {
        let count = |day: usize| diary.days[day].places.len();
        let before = day.checked_sub(1).map_or(0, count);
        let born = &diary.lineage[before..count(day)];
        born.iter().map(|cell| cell.parent | (cell.kind as u32) << TYPE_SHIFT).collect()
    }

    /// Adds the news of the next day. A parent that was not born before its child is taken for the
    /// child itself.
    pub fn add(&mut self, news: &[u32]) {
        for word in news {
            let cell = self.parents.len() as u32;
            let parent = (word & ((1 << TYPE_SHIFT) - 1)).min(cell);
            let founder = if parent == cell { cell } else { self.founders[parent as usize] };
            self.parents.push(parent);
            self.founders.push(founder);
            self.kinds.push(CellType::ALL[(word >> TYPE_SHIFT).min(2) as usize]);
        }
        self.counts.push(self.parents.len() as u32);
    }

    /// How many days are known.
    pub fn days(&self) -> u32 {
        self.counts.len() as u32
    }

    /// How many cells have been born so far.
    pub fn cells(&self) -> u32 {
        self.parents.len() as u32
    }

    /// How many first cells there are: they have the first numbers.
    pub fn clans(&self) -> u32 {
        self.counts.first().map_or(0, |&count| count)
    }

    /// Of each cell the first cell that it descends from.
    pub fn founders(&self) -> &[u32] {
        &self.founders
    }

    /// The type of a cell that has been born.
    pub fn kind(&self, cell: u32) -> CellType {
        self.kinds[cell as usize]
    }

    /// The day on which a cell that has been born was first there.
    pub fn birthday(&self, cell: u32) -> u32 {
        self.counts.partition_point(|&count| count <= cell) as u32
    }

    /// The line of a cell that has been born: its mother, hers, and so on to a first cell.
    pub fn mothers(&self, cell: u32) -> impl Iterator<Item = u32> {
        let mother = |&cell: &u32| Some(self.parents[cell as usize]).filter(|&p| p != cell);
        std::iter::successors(mother(&cell), move |cell| mother(cell))
    }

    /// The cell itself on days when it is there; before, the one of its line that was. None if cell or
    /// day are yet to come.
    pub fn of_line(&self, cell: u32, day: u32) -> Option<u32> {
        let &count = self.counts.get(day as usize)?;
        (cell < self.cells())
            .then(|| [cell].into_iter().chain(self.mothers(cell)).find(|&cell| cell < count))
            .flatten()
    }

    /// For each cell whether it is of the clone of this one.
    pub fn clone_of(&self, cell: u32) -> Vec<bool> {
        let mut of_clone = vec![false; self.parents.len()];
        for (number, &parent) in self.parents.iter().enumerate().skip(cell as usize) {
            // Parents have lower numbers than their children.
            of_clone[number] = number == cell as usize || of_clone[parent as usize];
        }
        of_clone
    }

    /// How many cells the clone of a cell has on each day that has grown.
    pub fn clone_sizes(&self, cell: u32) -> Vec<u32> {
        let of_clone = self.clone_of(cell);
        let (mut size, mut first) = (0, 0);
        let sizes = self.counts.iter().map(|&count| {
            size += of_clone[first..count as usize].iter().filter(|&&is| is).count() as u32;
            first = count as usize;
            size
        });
        sizes.collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::Mesh;
    use crate::tissue::{Growth, Progress, Recipe};
    use glam::Vec3;
    use std::sync::Arc;

    /// Some days of cells on a square.
    fn grown() -> Diary {
        let corners = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
        let positions = corners.map(|[x, y]| Vec3::new(x, y, 0.0)).to_vec();
        let mesh = Mesh::new(positions, Vec::new(), vec![[0, 1, 2], [0, 2, 3]]).unwrap();
        let recipe = Recipe { initial_cells: 20, days: 12, ..Recipe::default() };
        let recipe = Recipe { division_days: [3.0, 4.0, 5.0], ..recipe };
        let mut growth = Growth::new(Arc::new(mesh), recipe, &[], 7).unwrap();
        while growth.step() != Progress::Done {}
        growth.diary
    }

    fn pedigree(diary: &Diary) -> Pedigree {
        let mut pedigree = Pedigree::default();
        (0..diary.days.len()).for_each(|day| pedigree.add(&Pedigree::news(diary, day)));
        pedigree
    }

    #[test]
    fn what_crosses_is_the_lineage_of_the_diary() {
        let diary = grown();
        let pedigree = pedigree(&diary);
        assert_eq!((pedigree.cells() as usize, pedigree.clans()), (diary.lineage.len(), 20));
        for (cell, lineage) in (0..).zip(&diary.lineage) {
            assert_eq!(pedigree.kind(cell), lineage.kind);
            assert_eq!(pedigree.birthday(cell), lineage.born_day);
            assert_eq!(pedigree.founders()[cell as usize], lineage.founder);
            let oldest = pedigree.mothers(cell).last().unwrap_or(cell);
            assert_eq!(oldest, lineage.founder);
        }
    }

    /// Whether a cell descends from another, read off the diary step by step.
    fn descends(diary: &Diary, mut cell: usize, from: usize) -> bool {
        while cell != from && diary.lineage[cell].parent as usize != cell {
            cell = diary.lineage[cell].parent as usize;
        }
        cell == from
    }

    #[test]
    fn clones_are_what_a_walk_through_the_diary_finds() {
        let diary = grown();
        let pedigree = pedigree(&diary);
        let cells = diary.lineage.len();
        for from in (0..cells).step_by(7) {
            let of_clone = pedigree.clone_of(from as u32);
            let sizes = pedigree.clone_sizes(from as u32);
            assert_eq!(sizes.len(), diary.days.len());
            for (day, size) in diary.days.iter().zip(sizes) {
                let there = (0..day.places.len()).filter(|&cell| descends(&diary, cell, from));
                assert_eq!(there.count() as u32, size);
            }
            assert!((0..cells).all(|cell| of_clone[cell] == descends(&diary, cell, from)));
        }
        // All clans together are all cells.
        let whole: u32 = (0..20).map(|first| *pedigree.clone_sizes(first).last().unwrap()).sum();
        assert_eq!(whole as usize, cells);
    }

    #[test]
    fn before_its_birth_its_line_stands_for_a_cell() {
        let diary = grown();
        let pedigree = pedigree(&diary);
        let last = pedigree.cells() - 1;
        let days = diary.days.len() as u32;
        assert_eq!(pedigree.of_line(last, days - 1), Some(last));
        for day in 0..days {
            let there = pedigree.of_line(last, day).unwrap();
            assert!((there as usize) < diary.days[day as usize].places.len());
            assert!(descends(&diary, last as usize, there as usize));
        }
        assert_eq!(pedigree.of_line(last, 0), Some(diary.lineage[last as usize].founder));
        assert_eq!((pedigree.of_line(last, days), pedigree.of_line(last + 1, 0)), (None, None));
    }

    #[test]
    fn words_of_nobody_make_no_harm() {
        let mut pedigree = Pedigree::default();
        pedigree.add(&[u32::MAX, 0, 7]);
        assert_eq!(pedigree.founders(), [0, 0, 2]);
        assert_eq!(pedigree.kind(0), CellType::Middle);
    }
}
