//! What many individuals of a recipe come to, and what a number in steps: charts and a sentence, against the
//! exact law where it is known.

use super::chart::{Band, Chart, Line, step};
use super::course::{DEVIATIONS, EXPECTED, colour};
use crate::play::Scene;
use crate::play::parameters::{PARAMETERS, Parameter};
use crate::play::words::grouped;
use crate::tissue::{CellType, DayCount};

/// From so many times the deviation of a lottery on, it is worth to say where that comes from.
const EARLY: f64 = 1.2;

/// A picture of a series: its scene on the day that is seen, and the cells of that day.
#[derive(Clone, Debug)]
pub struct Grown {
    pub scene: Scene,
    pub count: DayCount,
}

impl Grown {
    fn foreground(&self) -> f64 {
        self.count.by_type[0].into()
    }

    fn share(&self) -> f64 {
        self.foreground() / f64::from(self.count.cells.max(1))
    }
}

/// Individuals of one recipe on one day, from the one with the fewest foreground cells to the one with the most,
/// and what they come to in words. None of fewer than three.
pub fn nursery(grown: &[Grown]) -> Option<(Chart, String)> {
    let [Grown { scene, .. }, _, _, ..] = grown else { return None };
    let mut sorted: Vec<&Grown> = grown.iter().collect();
    sorted.sort_by_key(|grown| (grown.count.by_type[0], grown.scene.individual));
    let values: Vec<f64> = sorted.iter().map(|grown| grown.foreground()).collect();
    let name = scene.plant.colour_names[0];
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let squares: f64 = values.iter().map(|value| (value - mean) * (value - mean)).sum();
    let deviation = (squares / (values.len() - 1) as f64).sqrt();
    let places = sorted.iter().map(|grown| grown.scene.individual.to_string()).collect();
    let line = |name: &str, colour: String, is_dots: bool, values| Line {
        name: name.to_string(),
        colour,
        is_dashed: !is_dots,
        is_dots,
        values,
    };
    let dots = line(name, colour(&scene.look, CellType::Foreground), true, values);
    let mut lines = vec![dots];
    let mut told = format!(
        "{} individuals on day {}: {} {name} cells in the mean, with a standard deviation of {}.",
        sorted.len(),
        scene.day,
        whole(mean),
        whole(deviation)
    );
    let law = scene.plant.expected_individuals(&scene.recipe, scene.day);
    let law = law.filter(|_| !scene.noise).map(|(of_types, _)| of_types[0]);
    let mut band = None;
    if let Some(law) = law {
        let spread = law.variance.sqrt();
        lines.push(line("exact mean", EXPECTED.into(), false, vec![law.mean; sorted.len()]));
        let off = DEVIATIONS * spread;
        let ends = vec![[(law.mean - off).max(0.0), law.mean + off]; sorted.len()];
        band = Some(Band { name: "95 in 100 individuals".into(), ends });
        told += &format!(
            " The exact law says {} and {}, without growing anything.",
            whole(law.mean),
            whole(spread)
        );
    }
    // What a binomial law of the same mean would give.
    let cells: u32 = sorted.iter().map(|grown| grown.count.cells).sum();
    let share = mean * sorted.len() as f64 / f64::from(cells.max(1));
    let by_lot = (mean * (1.0 - share)).sqrt();
    if by_lot > 0.0 {
        told += &format!(
            " If each cell drew its colour by itself, the deviation would be about {}.",
            whole(by_lot)
        );
        if deviation > EARLY * by_lot {
            told += &format!(
                " A cell that is {name} early passes it on to a large family: individuals differ \
                 {:.1} times as much.",
                deviation / by_lot
            );
        }
    }
    let title = format!("{} cells of each individual", capital(name));
    // What individuals differ in fills the frame.
    let ends = band.iter().map(|band: &Band| band.ends[0]);
    let [least, most] = ends
        .fold([lines[0].values[0], lines[0].values[sorted.len() - 1]], |a, b| {
            [a[0].min(b[0]), a[1].max(b[1])]
        });
    let step = step(most - least);
    let foot = (least / step).floor() * step;
    Some((Chart { title, along: "individual", places, lines, band, is_share: false, foot }, told))
}

/// The share of the foreground by the values of the number that differs, one dot an individual. None where no
/// number of the recipe does.
pub fn steps(grown: &[Grown]) -> Option<(Chart, String)> {
    let Grown { scene, .. } = grown.first()?;
    let plant = scene.plant;
    let differs = |p: &&Parameter| grown.iter().any(|other| p.get(&other.scene) != p.get(scene));
    let mut differing =
        PARAMETERS.iter().filter(|p| p.is_for(plant) && !p.is_colour).filter(differs);
    let parameter = differing.next()?;
    if let Some(other) = differing.next() {
        return Some(map(grown, parameter, other));
    }
    let mut steps: Vec<(f64, Vec<f64>)> = Vec::new();
    for grown in grown {
        let value = parameter.get(&grown.scene);
        match steps.iter_mut().find(|(step, _)| *step == value) {
            Some((_, shares)) => shares.push(grown.share()),
            None => steps.push((value, vec![grown.share()])),
        }
    }
    steps.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    let means = steps.iter().map(|(_, shares)| shares.iter().sum::<f64>() / shares.len() as f64);
    let means: Vec<f64> = means.collect();
    let line = |name: String, is_dots: bool, values: Vec<f64>| Line {
        name,
        colour: colour(&scene.look, CellType::Foreground),
        is_dashed: false,
        is_dots,
        values,
    };
    let mut lines = vec![line("mean".into(), false, means.clone())];
    let most = steps.iter().map(|(_, shares)| shares.len()).max().unwrap_or(0);
    for k in 0..most {
        let values = steps.iter().map(|(_, shares)| shares.get(k).copied().unwrap_or(f64::NAN));
        lines.push(line(format!("individual {}", k + 1), true, values.collect()));
    }
    let name = plant.colour_names[0];
    let label = parameter.label(plant);
    let ends = [0, steps.len() - 1]
        .map(|k| format!("{} in 100 with {}", whole(100.0 * means[k]), steps[k].0));
    let told =
        format!("{label}: on day {} the {name} cells are {}, {}.", scene.day, ends[0], ends[1]);
    let chart = Chart {
        title: format!("Share of the {name} cells by {label}"),
        along: "with",
        places: steps.iter().map(|(value, _)| value.to_string()).collect(),
        lines,
        band: None,
        is_share: true,
        foot: 0.0,
    };
    Some((chart, told))
}

/// The share of the foreground by the values of two numbers: a line for each value of the second one.
fn map(grown: &[Grown], across: &Parameter, down: &Parameter) -> (Chart, String) {
    let Scene { plant, day, .. } = grown[0].scene;
    let name = plant.colour_names[0];
    let values = |number: &Parameter| {
        let mut values: Vec<f64> = grown.iter().map(|grown| number.get(&grown.scene)).collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        values
    };
    let (columns, rows) = (values(across), values(down));
    let share = |x: f64, y: f64| {
        let there = |grown: &&Grown| across.get(&grown.scene) == x && down.get(&grown.scene) == y;
        let shares: Vec<f64> = grown.iter().filter(there).map(Grown::share).collect();
        shares.iter().sum::<f64>() / shares.len() as f64
    };
    let lines = rows.iter().enumerate().map(|(k, &y)| Line {
        name: format!("{} {y}", down.label(plant)),
        colour: between(k as f64 / (rows.len() - 1) as f64),
        is_dashed: false,
        is_dots: false,
        values: columns.iter().map(|&x| share(x, y)).collect(),
    });
    let (mut least, mut most) = (&grown[0], &grown[0]);
    for grown in grown {
        least = if grown.share() < least.share() { grown } else { least };
        most = if grown.share() > most.share() { grown } else { most };
    }
    let labels = [across, down].map(|number| number.label(plant));
    let said = |grown: &Grown| {
        let [x, y] = [across, down].map(|number| number.get(&grown.scene));
        format!("{} in 100 with {x} and {y}", whole(100.0 * grown.share()))
    };
    let told = format!(
        "{} and {}: on day {day} the {name} cells are fewest, {}, and most, {}.",
        labels[0],
        labels[1],
        said(least),
        said(most)
    );
    let chart = Chart {
        title: format!("Share of the {name} cells by {}", labels[0]),
        along: "with",
        places: columns.iter().map(f64::to_string).collect(),
        lines: lines.collect(),
        band: None,
        is_share: true,
        foot: 0.0,
    };
    (chart, told)
}

/// A colour on the way from the first line of a map to its last one.
fn between(share: f64) -> String {
    let part = |from: f64, to: f64| (from + (to - from) * share) as u8;
    let [r, g, b] = [part(230.0, 40.0), part(180.0, 60.0), part(40.0, 150.0)];
    format!("#{r:02x}{g:02x}{b:02x}")
}

fn whole(value: f64) -> String {
    grouped(value.round() as u32)
}

/// An English word with a large first letter: those of other alphabets would bring their tables along.
fn capital(word: &str) -> String {
    let mut letters = word.chars();
    let first = letters.next().map(|first| first.to_ascii_uppercase());
    first.into_iter().chain(letters).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants;
    use crate::play::link;

    fn grown(link: &str, by_type: [u32; 3]) -> Grown {
        let scene = link::read(link, plants::all()).scene;
        Grown { scene, count: DayCount { cells: by_type.iter().sum(), by_type } }
    }

    #[test]
    fn individuals_stand_in_the_order_of_their_cells_with_mean_and_deviation() {
        let links =
            ["croton-shrub?v=1&s=1&d=0", "croton-shrub?v=1&s=2&d=0", "croton-shrub?v=1&s=3&d=0"];
        let all = [[1030, 970, 0], [970, 1030, 0], [1000, 1000, 0]];
        let all: Vec<Grown> = links.iter().zip(all).map(|(link, n)| grown(link, n)).collect();
        let (chart, told) = nursery(&all).unwrap();
        assert_eq!(chart.places, ["2", "3", "1"]);
        assert_eq!(chart.lines[0].values, [970.0, 1000.0, 1030.0]);
        assert!(
            told.contains("1,000 yellow cells in the mean, with a standard deviation of 30."),
            "{told}"
        );
        // 2,000 first cells, each of them yellow with chance one half.
        assert_eq!(chart.lines[1].values, [1000.0; 3]);
        assert!(chart.foot > 900.0 && chart.foot <= 956.0, "{}", chart.foot);
        assert!(told.contains("The exact law says 1,000 and 22"), "{told}");
        assert!(
            told.ends_with(
                "the deviation would be about 22. A cell that is yellow early passes it on to \
                               a large family: individuals differ 1.3 times as much."
            ),
            "{told}"
        );
        let [low, high] = chart.band.unwrap().ends[0];
        assert!((high - low - 2.0 * 1.96 * 500.0_f64.sqrt()).abs() < 1e-6, "{low} {high}");
        assert!(nursery(&all[..2]).is_none());
    }

    #[test]
    fn steps_are_sorted_and_each_individual_is_a_dot() {
        let all = [
            grown("croton-shrub?v=1&s=1&d=9&pf=0.5", [50, 50, 0]),
            grown("croton-shrub?v=1&s=2&d=9&pf=0.5", [70, 30, 0]),
            grown("croton-shrub?v=1&s=1&d=9&pf=0.1", [10, 90, 0]),
        ];
        let (chart, told) = steps(&all).unwrap();
        assert_eq!(chart.places, ["0.1", "0.5"]);
        assert_eq!(chart.lines[0].values, [0.1, 0.6]);
        assert_eq!(chart.lines[1].values, [0.1, 0.5]);
        assert!(chart.lines[2].values[0].is_nan() && chart.lines[2].values[1] == 0.7);
        assert!(told.contains("10 in 100 with 0.1, 60 in 100 with 0.5"), "{told}");
        assert!(steps(&all[..2]).is_none(), "only the individual differs");
    }

    #[test]
    fn two_numbers_make_a_line_for_each_value_of_the_second() {
        let link = |pf: f64, df: f64| format!("croton-shrub?v=1&s=1&d=9&pf={pf}&df={df}");
        let all = [
            grown(&link(0.5, 9.0), [50, 50, 0]),
            grown(&link(0.1, 9.0), [10, 90, 0]),
            grown(&link(0.5, 6.0), [80, 20, 0]),
            grown(&link(0.1, 6.0), [30, 70, 0]),
        ];
        let (chart, told) = steps(&all).unwrap();
        let values: Vec<&[f64]> = chart.lines.iter().map(|line| &line.values[..]).collect();
        // In the order of the table of numbers, which has pf first.
        assert_eq!(chart.places, ["0.1", "0.5"]);
        assert_eq!(values, [[0.3, 0.8], [0.1, 0.5]]);
        assert!(chart.lines[0].name.ends_with(" 6") && chart.lines[1].name.ends_with(" 9"));
        assert!(told.contains("fewest, 10 in 100 with 0.1 and 9, and most, 80 in 100"), "{told}");
    }
}
