//! Where the values of a number lie on its slider.

use super::Parameter;

/// How values lie along a slider.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Equal steps have equal ways.
    Even,
    /// Equal ratios have about equal ways, from 1.5 to 200: on an even scale all values of the thesis
    /// but two would lie in its first third.
    Ratio,
}

/// Stretches of the scale by ratio, in tenths: where each begins, and its steps. So every value is a
/// round one, and 3 to 8% more than the one before.
const STRETCHES: [[u32; 2]; 7] =
    [[15, 1], [30, 2], [60, 5], [150, 10], [300, 20], [600, 50], [1500, 100]];
/// The last value, in tenths.
const LAST: u32 = 2000;

impl Parameter {
    /// Least and greatest position of the slider, and its step.
    pub fn track(&self) -> [f64; 3] {
        match self.scale {
            // Sliders count their steps from 0, so that they meet round numbers.
            Scale::Even => {
                let [least, greatest] = self.range;
                [(least / self.step).floor() * self.step, greatest, self.step]
            }
            Scale::Ratio => [0.0, (rungs().count() - 1) as f64, 1.0],
        }
    }

    /// The position that is nearest to a value.
    pub fn position(&self, value: f64) -> f64 {
        match self.scale {
            Scale::Even => value,
            Scale::Ratio => {
                rungs().filter(|rung| value > rung + gap_after(*rung) / 2.0).count() as f64
            }
        }
    }

    /// The value at a position.
    pub fn at(&self, position: f64) -> f64 {
        match self.scale {
            Scale::Even => position.max(self.range[0]),
            Scale::Ratio => rungs().nth(position as usize).unwrap_or(self.range[1]),
        }
    }
}

/// The values of the scale by ratio.
fn rungs() -> impl Iterator<Item = f64> {
    let ends = STRETCHES[1..].iter().map(|[from, _]| *from).chain([LAST + 1]);
    let stretches = STRETCHES.iter().zip(ends);
    let tenths = stretches.flat_map(|(&[from, step], end)| (from..end).step_by(step as usize));
    tenths.map(|tenths| f64::from(tenths) / 10.0)
}

/// How much more the next value is.
fn gap_after(rung: f64) -> f64 {
    let stretch = STRETCHES.iter().rfind(|[from, _]| f64::from(*from) <= 10.0 * rung);
    stretch.map_or(0.0, |[_, step]| f64::from(*step) / 10.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants;
    use crate::play::parameters::PARAMETERS;

    fn by_ratio() -> impl Iterator<Item = &'static Parameter> {
        PARAMETERS.iter().filter(|p| p.scale == Scale::Ratio)
    }

    #[test]
    fn equal_ratios_have_equal_ways() {
        assert_eq!(by_ratio().count(), 3);
        for parameter in by_ratio() {
            let [least, greatest] = parameter.range;
            let [first, last, _] = parameter.track();
            assert_eq!((parameter.at(first), parameter.at(last)), (least, greatest));
            for position in 0..=last as u32 {
                let value = parameter.at(f64::from(position));
                assert_eq!(parameter.position(value), f64::from(position), "{value}");
                let ideal = (value / least).ln() / (greatest / least).ln();
                assert!((f64::from(position) / last - ideal).abs() < 0.03, "{value}");
                let step = parameter.at(f64::from(position) + 1.0) / value;
                assert!((1.03..1.09).contains(&step) || value == greatest, "{value}: {step}");
            }
            // Values of links may lie between the steps.
            assert_eq!(parameter.at(parameter.position(7.3)), 7.5);
            assert_eq!(parameter.at(parameter.position(199.0)), 200.0);
        }
    }

    #[test]
    fn the_values_of_all_plants_have_places_of_their_own() {
        for plant in plants::all() {
            for (parameter, days) in by_ratio().zip(plant.recipe.division_days) {
                assert_eq!(parameter.at(parameter.position(days)), days, "{}", plant.key);
            }
        }
        let slower = by_ratio().next().unwrap();
        let way = |days| slower.position(days) / slower.track()[1];
        assert!(way(3.0) > 0.1 && way(10.0) > 0.3 && way(60.0) < 0.8);
    }

    #[test]
    fn even_sliders_meet_round_numbers() {
        let reach = Parameter::of_key("rs").unwrap();
        assert_eq!(reach.track(), [0.1, 6.0, 0.1]);
        assert_eq!((reach.position(2.0), reach.at(2.0)), (2.0, 2.0));
        let cells = Parameter::of_key("n").unwrap();
        assert_eq!((cells.track()[0], cells.at(0.0)), (0.0, 1.0));
        assert_eq!(cells.said(2000.0), "2000 cells");
        assert_eq!(Parameter::of_key("ff").unwrap().said(0.5), "0.5");
    }
}
