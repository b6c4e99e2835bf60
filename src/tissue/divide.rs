//! Division: when a cell divides, where its child appears and of what type it is
//! (Thesis 3.2.1.2).

use super::chance::{Poisson, Purpose, draw, exponential, founder_key, pick, uniform};
use super::ground::Ground;
use super::{CellType, Clock, Control, Lineage, Recipe, Scaled};
use crate::surface::{Mesh, Place, walk};
use glam::Vec2;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// A child appears in a disc around its parent that is this share of the repulsive radius across.
const CHILD_DISC: f64 = 0.01;

/// What divisions depend on beside the cells themselves.
pub struct Setting<'a> {
    /// The body on the day of the divisions, and as images lie on it.
    pub mesh: &'a Mesh,
    pub rest: &'a Mesh,
    pub recipe: &'a Recipe,
    pub controls: &'a [Control],
}

/// The clocks of all cells, by their numbers, and the calendar of the divisions to come.
pub struct Clocks {
    /// Keys of the cells' chance, from the seed and their lineage alone.
    keys: Vec<u64>,
    /// Divisions that each cell has been through.
    turns: Vec<u32>,
    /// For each day those that fall due on it, the first one first.
    due: Vec<BinaryHeap<Reverse<Due>>>,
    /// What the times between the divisions of each type of cell are drawn from.
    waits: [Poisson; 3],
    /// Divisions that have been told so far.
    told: u32,
}

/// A division to come. Of several at the same time the one comes first that was told first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Due {
    /// Days since day 0, as the bits of an f64: without a sign they are in the order of the numbers.
    time: u64,
    told: u32,
    cell: u32,
}

impl Clocks {
    /// Winds the clocks of the first cells where they are sown.
    pub fn new(setting: &Setting, seed: u32, founders: &[Lineage], places: &[Place]) -> Clocks {
        let mut clocks = Clocks {
            keys: (0..founders.len() as u32).map(|f| founder_key(seed, f)).collect(),
            turns: vec![0; founders.len()],
            due: vec![BinaryHeap::new(); setting.recipe.days as usize],
            waits: Default::default(),
            told: 0,
        };
        for (cell, (founder, &place)) in founders.iter().zip(places).enumerate() {
            clocks.wind(setting, cell as u32, founder.kind, place, 0.0);
        }
        clocks
    }

    /// Lets the clock of each first cell begin on a day of its own.
    pub fn delay(&mut self, first_days: &[u32]) {
        let days = self.due.len();
        let due = std::mem::replace(&mut self.due, vec![BinaryHeap::new(); days]);
        for Reverse(due) in due.into_iter().flatten() {
            let time = f64::from_bits(due.time) + f64::from(first_days[due.cell as usize]);
            self.note(Due { time: time.to_bits(), ..due });
        }
    }

    /// Puts a division down in the calendar. Those that the recipe's last day does not see are
    /// forgotten.
    fn note(&mut self, due: Due) {
        if let Some(day) = self.due.get_mut(f64::from_bits(due.time) as usize) {
            day.push(Reverse(due));
        }
    }

    /// Draws the time of a cell's next division, in days since day 0.
    fn wind(&mut self, setting: &Setting, cell: u32, kind: CellType, place: Place, now: f64) {
        let (key, turn) = (self.keys[cell as usize], self.turns[cell as usize]);
        let u = uniform(key, turn, Purpose::Clock);
        let mean = setting.division_days(kind, place);
        let wait = match setting.recipe.clock {
            Clock::Poisson => f64::from(self.waits[kind as usize].draw(mean, u)),
            Clock::Exponential => exponential(mean, u),
        };
        self.note(Due { time: (now + wait).to_bits(), told: self.told, cell });
        self.told += 1;
    }

    /// The next division that falls due on the day before a day: those of earlier days are done.
    fn next_before(&mut self, day: usize) -> Option<(f64, u32)> {
        let Reverse(due) = self.due[day - 1].pop()?;
        Some((f64::from_bits(due.time), due.cell))
    }

    /// Divides every cell that falls due strictly before a day, in the order of time, children that
    /// fall due before it too included. Adds the children to `lineage` and `places`, where they are
    /// there from that day on. Returns false, with the division half done, when the population would
    /// pass the cap.
    pub fn divide(
        &mut self,
        setting: &Setting,
        day: usize,
        ground: &Ground,
        lineage: &mut Vec<Lineage>,
        places: &mut Vec<Place>,
    ) -> bool {
        while let Some((time, parent)) = self.next_before(day) {
            if places.len() >= setting.recipe.max_cells as usize {
                return false;
            }
            let mother = lineage[parent as usize];
            let place = places[parent as usize];
            let (key, turn) = (self.keys[parent as usize], self.turns[parent as usize]);
            let child = places.len() as u32;
            let row = &setting.recipe.mutation[mother.kind as usize];
            let kind = CellType::from_index(pick(row, uniform(key, turn, Purpose::Type)) as u8);
            lineage.push(Lineage { parent, founder: mother.founder, born_day: day as u32, kind });
            let radius = ground.at(place.triangle).radius;
            let beside = beside(setting.mesh, place, radius, key, turn);
            places.push(beside);
            self.keys.push(draw(key, turn, Purpose::Child));
            self.turns.push(0);
            self.turns[parent as usize] += 1;
            self.wind(setting, parent, mother.kind, place, time);
            self.wind(setting, child, kind, beside, time);
        }
        true
    }
}

impl Setting<'_> {
    /// The mean days to the next division of a cell whose clock is wound at a place.
    fn division_days(&self, kind: CellType, place: Place) -> f64 {
        let factors =
            self.controls.iter().map(|c| c.factor(self.rest, place, Scaled::DivisionDays(kind)));
        self.recipe.division_days[kind as usize] * factors.product::<f64>()
    }
}

/// A uniform place in the disc around a parent.
fn beside(mesh: &Mesh, parent: Place, radius: f32, key: u64, turn: u32) -> Place {
    let reach = 0.5 * CHILD_DISC * f64::from(radius);
    let length = reach * uniform(key, turn, Purpose::ChildRadius).sqrt();
    let angle_rad = std::f64::consts::TAU * uniform(key, turn, Purpose::ChildAngle);
    let offset =
        Vec2::new((length * libm::cos(angle_rad)) as f32, (length * libm::sin(angle_rad)) as f32);
    walk(mesh, parent, offset).place
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    #[test]
    fn divisions_come_in_the_order_of_time_and_each_on_its_day() {
        let triangle = vec![Vec3::ZERO, Vec3::X, Vec3::Y];
        let mesh = Mesh::new(triangle, Vec::new(), vec![[0, 1, 2]]).unwrap();
        for clock in [Clock::Poisson, Clock::Exponential] {
            let recipe = Recipe { clock, division_days: [3.0; 3], days: 9, ..Recipe::DEFAULT };
            let setting = Setting { mesh: &mesh, rest: &mesh, recipe: &recipe, controls: &[] };
            let founder = |k| {
                let kind = CellType::Foreground;
                Lineage { parent: k, founder: k, born_day: 0, kind }
            };
            let founders: Vec<Lineage> = (0..500).map(founder).collect();
            let places = vec![Place::default(); 500];
            let mut clocks = Clocks::new(&setting, 3, &founders, &places);
            let (mut last, mut divided) = ((0.0, 0), 0);
            for day in 1..=9 {
                while let Some((time, cell)) = clocks.next_before(day) {
                    assert!((day as f64 - 1.0..day as f64).contains(&time));
                    assert!((time, cell) > last || divided == 0, "of equal times the first told");
                    assert_eq!(time.fract() == 0.0, clock == Clock::Poisson);
                    last = (time, cell);
                    divided += 1;
                }
            }
            assert!((460..500).contains(&divided), "{divided} of 500 in 9 days");
            assert!(clocks.due.iter().all(BinaryHeap::is_empty), "each has come");
        }
    }
}
