//! The petals, or the sepals, of a flower: all of one form, each in its place.

use super::growth::Growth;
use super::layout::Layout;
use super::opening::Opening;
use super::petal::{Arrangement, PetalNumbers};
use super::sepals::SepalNumbers;
use super::solve::Cholesky;
use super::template::{ROWS, Seat, Template};
use crate::shapes::chance::{Purpose, either_way, part_key};
use glam::DVec3;

/// Petals of one kind.
#[derive(Clone, Debug)]
pub struct Perianth {
    pub petals: Vec<Petal>,
    /// Their distance from the axis.
    pub foot_cm: f64,
    inner_lag: f64,
    tip_lag: f64,
    /// How much earlier all of them are open.
    lead: f64,
}

#[derive(Clone, Debug)]
pub struct Petal {
    pub seat: Seat,
    pub opening: Opening,
    pub layout: Layout,
}

impl Arrangement {
    /// Azimuth in degrees and rank, 0 to 1, of each petal, the outermost first.
    pub fn places(&self) -> Vec<(f64, f64)> {
        let rank = |k: u32, count: u32| f64::from(k) / f64::from((count - 1).max(1));
        match self {
            Arrangement::Spiral { count, divergence_deg } => {
                (0..*count).map(|k| (f64::from(k) * divergence_deg, rank(k, *count))).collect()
            }
            Arrangement::Whorls(whorls) => {
                let mut first_deg = 0.0;
                let mut places = Vec::new();
                for (k, &count) in (0..).zip(whorls) {
                    let step_deg = 360.0 / f64::from(count);
                    let turned = |j: u32| first_deg + f64::from(j) * step_deg;
                    places.extend((0..count).map(|j| (turned(j), rank(k, whorls.len() as u32))));
                    first_deg += step_deg / 2.0;
                }
                places
            }
        }
    }
}

impl Perianth {
    /// `irregularity` as in the flower's numbers; `key` is that of its chance.
    pub fn new(numbers: &PetalNumbers, irregularity: f64, key: u64) -> Perianth {
        let template = Template::new(numbers);
        let places = numbers.arrangement.places();
        let petals = (0..).zip(places).map(|(number, (azimuth_deg, rank))| {
            let key = part_key(key, number);
            let chance = |purpose| irregularity * either_way(key, purpose);
            let inner = |share: f64| 1.0 + (share - 1.0) * rank;
            let seat = Seat {
                azimuth: (numbers.first_deg + azimuth_deg).to_radians() + chance(Purpose::Turn),
                rank,
                width: inner(numbers.inner_width) * (1.0 + chance(Purpose::Width)),
                length: inner(numbers.inner_length) * (1.0 + chance(Purpose::Length)),
                turn: numbers.outer_turn_deg.to_radians() * (rank - 1.0) + chance(Purpose::Angle),
            };
            // As many quads in every individual.
            let slender = inner(numbers.inner_width) / inner(numbers.inner_length);
            let slender = |along| template.slenderness(along) * slender;
            Petal {
                layout: Layout::new(numbers.rows, numbers.columns, slender),
                opening: Opening::new(template.in_bud(&seat), template.opened(&seat)),
                seat,
            }
        });
        Perianth {
            petals: petals.collect(),
            foot_cm: numbers.bud_cm[0][0],
            inner_lag: numbers.inner_lag,
            tip_lag: numbers.tip_lag,
            lead: 0.0,
        }
    }

    /// Sepals around petals; they are open at once from foot to tip.
    pub fn around(
        sepals: &SepalNumbers,
        petals: &PetalNumbers,
        irregularity: f64,
        key: u64,
    ) -> Perianth {
        let template = Template::new(petals).around(sepals);
        let step_deg = 360.0 / f64::from(sepals.count);
        let rows = (f64::from(petals.rows) * sepals.length).ceil() as u32 + 1;
        let sepal = |number: u32| {
            let key = part_key(key, number);
            let chance = |purpose| irregularity * either_way(key, purpose);
            let azimuth_deg = petals.first_deg + step_deg * (f64::from(number) + 0.5);
            let out_deg = petals.outer_turn_deg + sepals.open_deg;
            let seat = Seat {
                azimuth: azimuth_deg.to_radians(),
                rank: -1.0,
                width: 1.0,
                length: 1.0 + chance(Purpose::Length),
                turn: chance(Purpose::Angle) - out_deg.to_radians(),
            };
            let slender = |along| template.slenderness(along) / sepals.length;
            Petal {
                layout: Layout::new(rows, petals.columns, slender),
                opening: Opening::new(template.in_bud(&seat), template.opened(&seat)),
                seat,
            }
        };
        Perianth {
            petals: (0..sepals.count).map(sepal).collect(),
            foot_cm: petals.bud_cm[0][0],
            inner_lag: 0.0,
            tip_lag: 0.0,
            // They are ahead of the foot of the outermost petals, which is ahead of all else.
            lead: 1.0 - (1.0 - petals.inner_lag) * (1.0 - petals.tip_lag) * (1.0 - sepals.lead),
        }
    }

    /// The sheets of all petals, by their control points, at a time from 0 to 1.
    pub fn sheets<'a>(
        &'a self,
        joints: &'a Cholesky,
        growth: &'a Growth,
        time: f64,
    ) -> impl Iterator<Item = Vec<DVec3>> + 'a {
        let time = (time / (1.0 - self.lead)).min(1.0);
        let late = |time: f64, lag: f64, share: f64| (time - lag * share) / (1.0 - lag);
        self.petals.iter().map(move |petal| {
            let time = late(time, self.inner_lag, petal.seat.rank);
            let opened: [f64; ROWS] = std::array::from_fn(|row| {
                growth.at(late(time, self.tip_lag, row as f64 / (ROWS - 1) as f64))
            });
            petal.opening.at(joints, &opened)
        })
    }

    /// The corners of all petals at a time.
    pub fn at(&self, joints: &Cholesky, growth: &Growth, time: f64) -> Vec<DVec3> {
        let sheets = self.sheets(joints, growth, time);
        self.petals.iter().zip(sheets).flat_map(|(petal, sheet)| petal.layout.on(sheet)).collect()
    }
}
