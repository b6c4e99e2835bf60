//! Division: when a cell divides, where its child appears and of what type it is
//! (Thesis 3.2.1.2).

use super::chance::{Poisson, Purpose, draw, founder_key, pick, uniform};
use super::{CellType, Lineage, Recipe};
use crate::surface::{Mesh, Place, walk};
use glam::Vec2;

/// A child appears in a disc around its parent that is this share of the repulsive radius across.
const CHILD_DISC: f64 = 0.01;

/// The clocks of all cells, by their numbers, and the queue of those that divide on each day.
pub struct Clocks {
    /// Keys of the cells' chance, from the seed and their lineage alone.
    keys: Vec<u64>,
    /// Divisions that each cell has been through.
    turns: Vec<u32>,
    /// The cells that divide on each day, in the order in which they were told so.
    due: Vec<Vec<u32>>,
    waits: [Poisson; 3],
}

impl Clocks {
    /// Winds the clocks of the first cells. Divisions after the recipe's last day are forgotten.
    pub fn new(recipe: &Recipe, seed: u32, founders: &[Lineage]) -> Clocks {
        let mut clocks = Clocks {
            keys: (0..founders.len() as u32).map(|f| founder_key(seed, f)).collect(),
            turns: vec![0; founders.len()],
            due: vec![Vec::new(); recipe.days as usize],
            waits: recipe.division_days.map(Poisson::new),
        };
        for (cell, founder) in founders.iter().enumerate() {
            clocks.wind(cell as u32, founder.kind, 0);
        }
        clocks
    }

    /// Draws the day of a cell's next division.
    fn wind(&mut self, cell: u32, kind: CellType, today: usize) {
        let (key, turn) = (self.keys[cell as usize], self.turns[cell as usize]);
        let wait = self.waits[kind as usize].sample(uniform(key, turn, Purpose::Clock));
        if let Some(day) = self.due.get_mut(today + wait as usize) {
            day.push(cell);
        }
    }

    /// Divides every cell that is due on a day, children born on the same spot of time included.
    /// Adds the children to `lineage` and `places`, where they are there from `day + 1` on.
    /// Returns false, with the division half done, when the population would pass the cap.
    pub fn divide(
        &mut self,
        mesh: &Mesh,
        recipe: &Recipe,
        day: usize,
        radius: f32,
        lineage: &mut Vec<Lineage>,
        places: &mut Vec<Place>,
    ) -> bool {
        let mut next = 0;
        while next < self.due[day].len() {
            if places.len() >= recipe.max_cells as usize {
                return false;
            }
            let parent = self.due[day][next];
            next += 1;
            let mother = lineage[parent as usize];
            let (key, turn) = (self.keys[parent as usize], self.turns[parent as usize]);
            let child = places.len() as u32;
            let row = &recipe.mutation[mother.kind as usize];
            let kind = CellType::from_index(pick(row, uniform(key, turn, Purpose::Type)) as u8);
            lineage.push(Lineage {
                parent,
                founder: mother.founder,
                born_day: day as u32 + 1,
                kind,
            });
            places.push(beside(mesh, places[parent as usize], radius, key, turn));
            self.keys.push(draw(key, turn, Purpose::Child));
            self.turns.push(0);
            self.turns[parent as usize] += 1;
            self.wind(parent, mother.kind, day);
            self.wind(child, kind, day);
        }
        self.due[day] = Vec::new();
        true
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
