//! The numbers of a leaf, as they stand in a file.

use crate::shapes::ShapeError;
use crate::shapes::read::read;
use crate::shapes::veins::VeinNumbers;
use crate::shapes::wrong::within;
use serde::{Deserialize, Serialize};

/// A leaf in numbers. What is left out of a file is as in `LeafNumbers::default`.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct LeafNumbers {
    /// An odd number, 1 to 15; each has a main vein from the leafstalk on.
    pub lobes: u32,
    /// On the main vein of the lobe in the middle, its tip included; 2 to 40.
    pub nodes: u32,
    /// How many nodes each lobe has of those of its neighbour towards the middle, as a share; 0.3 to 1. At
    /// least two are left.
    pub nodes_kept: f64,
    /// Between neighbouring main veins (the source's Δ); 5 to 180.
    pub lobe_deg: f64,
    /// Between secondary veins and their main vein (δ); 10 to 150.
    pub secondary_deg: f64,
    /// Of the piece of a vein by the steps from its start to the tip of its lobe.
    pub length: Length,
    /// How much longer secondary veins are than that; 0.1 to 10. Our addition: the source has 1.
    pub secondary_scale: f64,
    /// The share of their length that the secondary veins have at the foot of the blade, and more of it up to
    /// the middle; 0 to 1. Our addition, for leaves that are widest in the middle: the source has 1. A border
    /// never turns in towards the foot, so that veins are as long as a straight base needs.
    pub base: f64,
    /// The same at the tip of a lobe, for pointed ones; 0 to 1. Our addition: the source has 1.
    pub tip: f64,
    /// How far the border lies beyond the ends of the veins, as a multiple of their last piece; 1 to 2.
    pub border_factor: f64,
    pub border: Border,
    /// Share by which lengths, and a quarter of it by which the angles between lobes, differ by chance; 0 (two
    /// halves that mirror each other) to 0.5.
    pub irregularity: f64,
    /// How high the blade starts above the foot of the petiole; 0 (no petiole) to 100.
    pub petiole_cm: f64,
    /// Of the petiole, and of the midrib where it starts; 0.02 to 2.
    pub petiole_width_cm: f64,
    /// About as many triangles make the blade; 50 to 50,000.
    pub triangles: u32,
    /// What each half of the blade is turned up about the midrib; 0 to 80.
    pub fold_deg: f64,
    /// What the tip is bent back, as an arc from the foot on; -300 to 300, under 0 forward.
    pub curl_deg: f64,
    /// Height of the waves of the rim; 0 to 5.
    pub wave_cm: f64,
    /// How many there are from the foot to the tip; 0 to 20.
    pub waves: f64,
    /// A blade with an underside of its own, so much under it; 0 (a single sheet) to 1.
    pub thickness_cm: f64,
    /// Veins of the third order that grow from those of the plan all over the blade, if there are any.
    pub fine: Option<VeinNumbers>,
}

/// The three laws of the source; `d` are the steps to the tip, from 1.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Length {
    Constant {
        b_cm: f64,
    },
    /// `a_cm d + b_cm`.
    Linear {
        a_cm: f64,
        b_cm: f64,
    },
    /// `a_cm ln(1 + d) + b_cm`, to the source the best.
    Logarithmic {
        a_cm: f64,
        b_cm: f64,
    },
}

/// How the points beyond the ends of the veins are joined.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Border {
    /// By straight sides.
    Polygon,
    /// By one smooth curve from the foot to the tip of a lobe.
    Smooth,
    /// By cubics that start and end so much inside the straight side, which makes teeth of the ends of the
    /// veins; under 0 outside, which makes rounded ones. -45 to 45.
    Toothed { tooth_deg: f64 },
}

impl Default for LeafNumbers {
    /// A maple's.
    fn default() -> LeafNumbers {
        LeafNumbers {
            lobes: 5,
            nodes: 8,
            nodes_kept: 0.88,
            lobe_deg: 46.0,
            secondary_deg: 42.0,
            length: Length::Logarithmic { a_cm: 0.7, b_cm: -0.15 },
            secondary_scale: 1.7,
            base: 0.8,
            tip: 0.15,
            border_factor: 1.15,
            border: Border::Toothed { tooth_deg: 22.0 },
            irregularity: 0.1,
            petiole_cm: 5.0,
            petiole_width_cm: 0.22,
            triangles: 2000,
            fold_deg: 8.0,
            curl_deg: 25.0,
            wave_cm: 0.15,
            waves: 3.0,
            thickness_cm: 0.0,
            fine: None,
        }
    }
}

impl LeafNumbers {
    /// Reads numbers from a JSON object, and checks them.
    ///
    /// # Errors
    /// A text that is none, a name that is unknown, and what `check` refuses.
    pub fn from_json(text: &str) -> Result<LeafNumbers, ShapeError> {
        let numbers: LeafNumbers = read(text)?;
        numbers.check()?;
        Ok(numbers)
    }

    /// The same leaf, so many times as large.
    pub fn scaled(mut self, size: f64) -> LeafNumbers {
        match &mut self.length {
            Length::Constant { b_cm } => *b_cm *= size,
            Length::Linear { a_cm, b_cm } | Length::Logarithmic { a_cm, b_cm } => {
                *a_cm *= size;
                *b_cm *= size;
            }
        }
        let fine = self.fine.iter_mut().flat_map(|fine| [&mut fine.spacing_cm, &mut fine.tip_cm]);
        let own = [
            &mut self.petiole_cm,
            &mut self.petiole_width_cm,
            &mut self.wave_cm,
            &mut self.thickness_cm,
        ];
        own.into_iter().chain(fine).for_each(|cm| *cm *= size);
        self
    }

    /// Says which number is out of its range.
    pub fn check(&self) -> Result<(), ShapeError> {
        if self.lobes.is_multiple_of(2) || self.lobes > 15 {
            return Err(ShapeError(format!(
                "lobes is {}: it must be an odd number from 1 to 15",
                self.lobes
            )));
        }
        for (name, value, range) in [
            ("nodes", f64::from(self.nodes), 2.0..=40.0),
            ("nodes_kept", self.nodes_kept, 0.3..=1.0),
            ("lobe_deg", self.lobe_deg, 5.0..=180.0),
            ("secondary_deg", self.secondary_deg, 10.0..=150.0),
            ("secondary_scale", self.secondary_scale, 0.1..=10.0),
            ("base", self.base, 0.0..=1.0),
            ("tip", self.tip, 0.0..=1.0),
            ("border_factor", self.border_factor, 1.0..=2.0),
            ("irregularity", self.irregularity, 0.0..=0.5),
            ("petiole_cm", self.petiole_cm, 0.0..=100.0),
            ("petiole_width_cm", self.petiole_width_cm, 0.02..=2.0),
            ("triangles", f64::from(self.triangles), 50.0..=50_000.0),
            ("fold_deg", self.fold_deg, 0.0..=80.0),
            ("curl_deg", self.curl_deg, -300.0..=300.0),
            ("wave_cm", self.wave_cm, 0.0..=5.0),
            ("waves", self.waves, 0.0..=20.0),
            ("thickness_cm", self.thickness_cm, 0.0..=1.0),
        ] {
            within(name, value, &range)?;
        }
        if let Border::Toothed { tooth_deg } = self.border {
            within("border.toothed.tooth_deg", tooth_deg, &(-45.0..=45.0))?;
        }
        if let Some(fine) = &self.fine {
            fine.check().map_err(|e| ShapeError(format!("fine: {e}")))?;
        }
        self.length.check()
    }
}

impl Length {
    /// Of the piece that starts so many steps before the tip, in centimetres.
    pub fn of(&self, steps: u32) -> f64 {
        match *self {
            Length::Constant { b_cm } => b_cm,
            Length::Linear { a_cm, b_cm } => a_cm * f64::from(steps) + b_cm,
            Length::Logarithmic { a_cm, b_cm } => a_cm * libm::log1p(f64::from(steps)) + b_cm,
        }
    }

    fn check(&self) -> Result<(), ShapeError> {
        let (a_cm, b_cm) = match *self {
            Length::Constant { b_cm } => (0.0, b_cm),
            Length::Linear { a_cm, b_cm } | Length::Logarithmic { a_cm, b_cm } => (a_cm, b_cm),
        };
        within("a_cm of length", a_cm, &(0.0..=20.0))?;
        within("b_cm of length", b_cm, &(-20.0..=20.0))?;
        // The pieces are the longer the farther the tip is.
        let last = self.of(1);
        if last >= 0.01 {
            return Ok(());
        }
        Err(ShapeError(format!(
            "the last piece of a main vein would be {last:.3} cm long: length must make it at least 0.01"
        )))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_back_as_they_were_written() {
        for border in [Border::Polygon, Border::Smooth, Border::Toothed { tooth_deg: -7.5 }] {
            for length in [Length::Constant { b_cm: 0.1 }, Length::Linear { a_cm: 0.3, b_cm: 0.7 }]
            {
                let numbers = LeafNumbers { border, length, ..LeafNumbers::default() };
                let text = serde_json::to_string(&numbers).unwrap();
                assert_eq!(LeafNumbers::from_json(&text).unwrap(), numbers, "{text}");
            }
        }
        let fine = Some(VeinNumbers { closed: true, ..VeinNumbers::default() });
        let net = LeafNumbers { fine, ..LeafNumbers::default() };
        assert_eq!(LeafNumbers::from_json(r#"{"fine": {"closed": true}}"#).unwrap(), net);
        assert_eq!(LeafNumbers::from_json("{}").unwrap(), LeafNumbers::default());
    }

    #[test]
    fn wrong_numbers_are_named() {
        for (text, words) in [
            ("{\"lobes\": 4}", "lobes is 4: it must be an odd number"),
            ("{\"lobes\": 17}", "from 1 to 15"),
            ("{\"lobes\": -1}", "lobes is -1: it must be a whole number from 0 on"),
            ("{\"nodes\": 1}", "nodes is 1: it must be from 2 to 40"),
            ("{\"leaves\": 1}", "there is no number \"leaves\": there are lobes"),
            ("{\"secondary_deg\": 5}", "secondary_deg is 5: it must be from 10 to 150"),
            ("{\"triangles\": 60000}", "triangles is 60000"),
            ("{\"border\": \"wavy\"}", "border is \"wavy\": it must be one of polygon"),
            ("{\"border\": {\"toothed\": {\"tooth_deg\": 60}}}", "tooth_deg is 60"),
            ("{\"length\": {\"linear\": {\"a_cm\": 1, \"b_cm\": -1}}}", "would be 0.000 cm long"),
            ("{\"fine\": {\"step\": 3}}", "fine: step is 3: it must be from 0.05 to 1"),
            ("{\"length\": {\"constant\": {\"b_cm\": 30}}}", "b_cm of length is 30"),
        ] {
            let wrong = LeafNumbers::from_json(text).unwrap_err().to_string();
            assert!(wrong.contains(words) && wrong.lines().count() == 1, "{text}: {wrong}");
        }
    }
}
