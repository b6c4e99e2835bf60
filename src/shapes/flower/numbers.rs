//! The numbers of a flower, as they stand in a file.

use super::{Arrangement, PetalNumbers, ReceptacleNumbers, RodNumbers, Sepals, StamenNumbers};
use crate::shapes::ShapeError;
use crate::shapes::read::read;
use crate::shapes::wrong::within;
use serde::{Deserialize, Serialize};

/// A flower in numbers. What is left out of a file is as in `FlowerNumbers::default`; parts that are `null` are
/// not there.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct FlowerNumbers {
    /// The showy ones, which carry cells; in a lily all six tepals.
    pub petals: PetalNumbers,
    /// Green and bare, around the petals.
    pub sepals: Option<Sepals>,
    pub stamens: Option<StamenNumbers>,
    pub pistil: Option<RodNumbers>,
    /// An inverted cone with carpels in its flat top, as that of a lotus.
    pub receptacle: Option<ReceptacleNumbers>,
    /// The stalk from the ground to the flower: 0 (none) to 200.
    pub pedicel_cm: f64,
    /// 0.02 to 5.
    pub pedicel_width_cm: f64,
    /// What the flower turns from upright towards the viewer, and its stalk with it; 0 to 180.
    pub nod_deg: f64,
    /// The day on which the flower is open; the bud is that of day 0. 0.1 to 1000.
    pub open_day: f64,
    /// `g` of the growth function, 0 to 9. Only 6 ends with the open flower: 3 stops half-way, 9 goes half as far
    /// again.
    pub growth: f64,
    /// Share by which sizes differ by chance, and radians by which angles do; 0 (all petals alike) to 0.5.
    pub irregularity: f64,
}

impl Default for FlowerNumbers {
    /// A golden lily's.
    fn default() -> FlowerNumbers {
        FlowerNumbers {
            petals: PetalNumbers::default(),
            sepals: None,
            stamens: Some(StamenNumbers::default()),
            pistil: Some(RodNumbers::default()),
            receptacle: None,
            pedicel_cm: 14.0,
            pedicel_width_cm: 0.5,
            nod_deg: 60.0,
            open_day: 4.0,
            growth: 6.0,
            irregularity: 0.02,
        }
    }
}

impl FlowerNumbers {
    /// Reads numbers from a JSON object, and checks them.
    ///
    /// # Errors
    /// A text that is none, a name that is unknown, and what `check` refuses.
    pub fn from_json(text: &str) -> Result<FlowerNumbers, ShapeError> {
        let mut numbers: FlowerNumbers = read(text)?;
        numbers.check()?;
        numbers.sepals = numbers.sepals.filter(|sepals| sepals.count() > 0);
        Ok(numbers)
    }

    /// Says which number is out of its range.
    pub fn check(&self) -> Result<(), ShapeError> {
        for (name, value, range) in [
            ("pedicel_cm", self.pedicel_cm, 0.0..=200.0),
            ("pedicel_width_cm", self.pedicel_width_cm, 0.02..=5.0),
            ("nod_deg", self.nod_deg, 0.0..=180.0),
            ("open_day", self.open_day, 0.1..=1000.0),
            ("growth", self.growth, 0.0..=9.0),
            ("irregularity", self.irregularity, 0.0..=0.5),
        ] {
            within(name, value, &range)?;
        }
        self.petals.check("petals")?;
        self.sepals.as_ref().map_or(Ok(()), Sepals::check)?;
        self.stamens.as_ref().map_or(Ok(()), StamenNumbers::check)?;
        self.pistil.as_ref().map_or(Ok(()), |pistil| pistil.check("pistil"))?;
        self.receptacle.as_ref().map_or(Ok(()), ReceptacleNumbers::check)
    }
}

impl Arrangement {
    /// How many there are together.
    pub fn count(&self) -> u32 {
        match self {
            Arrangement::Whorls(whorls) => whorls.iter().sum(),
            Arrangement::Spiral { count, .. } => *count,
        }
    }

    pub(super) fn check(&self, of: &str) -> Result<(), ShapeError> {
        if let Arrangement::Spiral { divergence_deg, .. } = self {
            let name = format!("{of}.arrangement.spiral.divergence_deg");
            within(&name, *divergence_deg, &(1.0..=359.0))?;
        }
        if let Arrangement::Whorls(whorls) = self {
            let name = format!("a number in {of}.arrangement.whorls");
            for &count in whorls {
                within(&name, f64::from(count), &(1.0..=60.0))?;
            }
        }
        match self.count() {
            1..=60 => Ok(()),
            count => Err(ShapeError(format!("{of} has {count} of them: it must be from 1 to 60"))),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::SepalNumbers;
    use super::*;

    #[test]
    fn numbers_are_read_back_as_they_were_written() {
        let lily = FlowerNumbers::default();
        let mut lotus = FlowerNumbers {
            sepals: Some(Sepals::Drawn(PetalNumbers::default().into())),
            stamens: None,
            pistil: None,
            receptacle: Some(ReceptacleNumbers::default()),
            ..lily.clone()
        };
        lotus.petals.arrangement = Arrangement::Spiral { count: 17, divergence_deg: 137.5 };
        let around = SepalNumbers { count: 3, ..SepalNumbers::default() };
        let wild = FlowerNumbers { sepals: Some(Sepals::Around(around)), ..lily.clone() };
        for numbers in [lily, lotus, wild] {
            let text = serde_json::to_string(&numbers).unwrap();
            assert_eq!(FlowerNumbers::from_json(&text).unwrap(), numbers, "{text}");
        }
        for none in ["{}", r#"{"sepals": {}}"#, r#"{"sepals": {"count": 0, "length": 0.7}}"#] {
            assert_eq!(FlowerNumbers::from_json(none).unwrap(), FlowerNumbers::default());
        }
    }

    #[test]
    fn wrong_numbers_are_named() {
        for (text, words) in [
            ("{\"tepals\": 6}", "there is no number \"tepals\": the nearest one is \"sepals\""),
            ("{\"nod_deg\": 190}", "nod_deg is 190: it must be from 0 to 180"),
            ("{\"growth\": 12}", "growth is 12"),
            ("{\"open_day\": 0}", "open_day is 0"),
            ("{\"petals\": {\"bud_deg\": 0}}", "petals.bud_deg is 0: it must be from 1 to 175"),
            ("{\"sepals\": {\"rows\": 1}}", "sepals.rows is 1: it must be from 2 to 200"),
            ("{\"sepals\": {\"count\": 13}}", "sepals.count is 13: it must be from 0 to 12"),
            ("{\"sepals\": {\"lengt\": 1}}", "the nearest one is \"sepals.length\""),
            ("{\"sepals\": 3}", "sepals is 3: it must be numbers with names"),
            ("{\"petals\": {\"vein_cm\": [[0, 0]]}}", "petals.vein_cm has 1 points"),
            ("{\"petals\": {\"vein_cm\": [[0, 0], [3, 0]]}}", "0.1 cm above the foot"),
            ("{\"petals\": {\"bud_cm\": [[1, 1], [1, 1]]}}", "petals.bud_cm goes nowhere"),
            ("{\"petals\": {\"open_cm\": [[1, 1], [-1, 3]]}}", "beyond the axis"),
            (
                "{\"petals\": {\"left_cm\": [[1, 1], [400, 3]]}}",
                "a number in petals.left_cm is 400",
            ),
            (
                "{\"petals\": {\"left_cm\": [[1, 1, 2], [4, 3]]}}",
                "petals.left_cm.0 has 3 numbers: it must have 2",
            ),
            ("{\"petals\": {\"arrangement\": {\"whorls\": []}}}", "petals has 0 of them"),
            ("{\"petals\": {\"arrangement\": {\"whorls\": [3, 0]}}}", "whorls is 0"),
            ("{\"petals\": {\"arrangement\": {\"whorls\": [40, 40]}}}", "petals has 80 of them"),
            (
                "{\"petals\": {\"arrangement\": {\"spiral\": {\"count\": 8}}}}",
                "petals.arrangement.spiral.divergence_deg is missing",
            ),
            (
                "{\"petals\": {\"arrangement\": {\"spiral\": {\"count\": 8, \"divergence_deg\": 0}}}}",
                "divergence_deg is 0",
            ),
            (
                "{\"petals\": {\"cross\": [{\"at\": 0.5, \"lift_cm\": [[1, 0], [-1, 0]]}]}}",
                "must go from left to right",
            ),
            (
                "{\"petals\": {\"cross\": [{\"at\": 0.5, \"lift_cm\": [[-1, 0], [1, 1]]},
                  {\"at\": 0.51, \"lift_cm\": [[-1, 0], [1, 1]]}]}}",
                "two strokes at 0.51",
            ),
            ("{\"stamens\": {\"count\": 0}}", "stamens.count is 0"),
            ("{\"stamens\": {\"rings\": 1}}", "stamens.rings is 1"),
            ("{\"pistil\": {\"radii_cm\": [1]}}", "pistil.radii_cm has 1 numbers"),
            ("{\"receptacle\": {\"carpels\": 100}}", "receptacle.carpels is 100"),
        ] {
            let wrong = FlowerNumbers::from_json(text).unwrap_err().to_string();
            assert!(wrong.contains(words) && wrong.lines().count() == 1, "{text}: {wrong}");
        }
    }
}
