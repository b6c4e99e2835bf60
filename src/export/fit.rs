//! Numbers of a recipe that make what is wanted of a plant, found by trying: a compass search (Kolda, Lewis and
//! Torczon, Optimization by Direct Search, SIAM Review 45, 2003, 1), which goes a step along one number as long as
//! that helps and takes half the step where none does. The same search always goes the same way.

use super::kind::Kind;
use super::order::Order;
use crate::play::Scene;
use crate::play::lesson::Measure;
use crate::play::parameters::Parameter;
use crate::surface::{Body, Charts, decimal, quoted};
use crate::tissue::{CellType, Progress};

/// What is wanted: a measure and its value, shares in 100.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Want {
    pub measure: Measure,
    pub value: f64,
}

impl Want {
    /// Reads `share=0.4,patches=200`: measures, of F where no type is named, as in `share-B`, and shares from 0 to 1.
    ///
    /// # Errors
    /// In plain words, what of it cannot be wanted.
    pub fn read(text: &str, scene: &Scene) -> Result<Vec<Want>, String> {
        let of_one = |pair: &str| {
            let refuse = |why: &str| format!("{}: {why}", quoted(pair));
            let (word, value) = pair.split_once('=').ok_or_else(|| refuse("it says no value"))?;
            let words = word.replace('-', " ");
            let measure = Measure::of_words(&words)
                .or_else(|| Measure::of_words(&format!("{words} F")))
                .ok_or_else(|| refuse(Measure::KNOWN))?;
            let value = decimal(value).filter(|value| value.is_finite() && *value >= 0.0);
            let value = value.ok_or_else(|| refuse("it must be a number from 0 on"))?;
            if measure.is_share() && value > 1.0 {
                return Err(refuse("a share is from 0 to 1"));
            }
            if measure.name(scene.plant).starts_with(' ') {
                return Err(refuse("this plant has no cells of that type"));
            }
            let value = if measure.is_share() { 100.0 * value } else { value };
            Ok(Want { measure, value })
        };
        text.split(',').map(of_one).collect()
    }
}

/// The first step and the last one, as shares of the way from a number's least value to its greatest.
const STEPS: [f64; 2] = [0.25, 0.01];
/// A share that is wanted to be none cannot be missed by a part of itself: it is missed by a part of this.
const LEAST: f64 = 5.0;

/// A search that is under way.
pub struct Fit {
    wants: Vec<Want>,
    numbers: Vec<&'static Parameter>,
    /// The best so far, and by how much it is off, 0.1 for a tenth. None before the first try.
    best: Option<(Scene, f64)>,
    scene: Scene,
    step: f64,
    /// The way that is tried next: up and down along each number.
    way: usize,
    has_helped: bool,
    tried: Vec<Vec<f64>>,
}

impl Fit {
    /// Searches from a scene on, along these numbers.
    pub fn new(scene: Scene, wants: Vec<Want>, numbers: Vec<&'static Parameter>) -> Fit {
        let (step, best, tried) = (STEPS[0], None, Vec::new());
        Fit { wants, numbers, best, scene, step, way: 0, has_helped: false, tried }
    }

    /// The numbers of a plant that decide most of what is wanted.
    pub fn numbers_of(wants: &[Want], scene: &Scene) -> Vec<&'static Parameter> {
        let keys = |want: &Want| -> &[&str] {
            match want.measure {
                Measure::Cells | Measure::Count(_) => &["n", "df", "db"],
                Measure::Share(CellType::Middle) | Measure::Area(CellType::Middle) => &["pm"],
                Measure::Share(_) | Measure::Area(_) => &["pf"],
                Measure::Patches(_) | Measure::Clans => &["n", "fb"],
                Measure::Largest(_) | Measure::Mixed => &["fb", "rs"],
                Measure::Spots | Measure::SingleSpots => &["mbf", "db"],
                Measure::LargestClan => &["n"],
            }
        };
        let mut numbers: Vec<&Parameter> = Vec::new();
        for key in wants.iter().flat_map(keys) {
            let number = Parameter::of_key(key).filter(|number| number.is_for(scene.plant));
            numbers.extend(number.filter(|number| numbers.iter().all(|p| p.key != number.key)));
        }
        numbers
    }

    /// The scene to try next; none at the end of the search.
    pub fn next_scene(&mut self) -> Option<Scene> {
        if self.best.is_none() {
            self.tried.push(self.values(&self.scene));
            return Some(self.scene.clone());
        }
        while self.step >= STEPS[1] {
            if self.way == 2 * self.numbers.len() {
                if !std::mem::take(&mut self.has_helped) {
                    self.step /= 2.0;
                }
                self.way = 0;
                continue;
            }
            if let Some(scene) = self.stepped() {
                return Some(scene);
            }
            self.way += 1;
        }
        None
    }

    /// Takes what the scene came to, a value of each want; none where it cannot be grown. Whether it is better than
    /// all before.
    pub fn tell(&mut self, scene: Scene, values: Option<&[f64]>) -> bool {
        let off = values.map_or(f64::INFINITY, |values| self.off_by(values));
        let helps = self.best.as_ref().is_none_or(|(_, best)| off < *best);
        if helps {
            self.has_helped |= self.best.is_some();
            self.best = Some((scene, off));
        } else {
            self.way += 1;
        }
        helps
    }

    /// The best so far, and by how much it is off.
    pub fn best(&self) -> Option<&(Scene, f64)> {
        self.best.as_ref()
    }

    /// How many were tried.
    pub fn tries(&self) -> usize {
        self.tried.len()
    }

    /// The root of the mean square of the shares by which values miss what is wanted.
    fn off_by(&self, values: &[f64]) -> f64 {
        let squares = self.wants.iter().zip(values).map(|(want, value)| {
            let whole =
                if want.measure.is_share() { want.value.max(LEAST) } else { want.value.max(1.0) };
            let off = (value - want.value) / whole;
            off * off
        });
        (squares.sum::<f64>() / self.wants.len() as f64).sqrt()
    }

    /// A step from the best, unless it was tried or leads nowhere.
    fn stepped(&mut self) -> Option<Scene> {
        let (best, _) = self.best.as_ref()?;
        let number = self.numbers[self.way / 2];
        let sign = if self.way.is_multiple_of(2) { 1.0 } else { -1.0 };
        let at = place(number, number.get(best)) + sign * self.step;
        let mut scene = best.clone();
        number.set(&mut scene, value(number, at.clamp(0.0, 1.0))).ok()?;
        // Shares make room for each other: what they make of another number is no way of its own.
        let values = self.values(&scene);
        if self.tried.contains(&values) || scene.day != best.day {
            return None;
        }
        self.tried.push(values);
        Some(scene)
    }

    fn values(&self, scene: &Scene) -> Vec<f64> {
        self.numbers.iter().map(|number| number.get(scene)).collect()
    }
}

/// Whether a number goes by ratios: from one cell to two is as far as from thousands to twice as many.
fn goes_by_ratio(number: &Parameter) -> bool {
    let [least, greatest] = number.range;
    least > 0.0 && greatest / least > 20.0
}

/// Where a value lies between the least, 0, and the greatest, 1.
fn place(number: &Parameter, value: f64) -> f64 {
    let [least, greatest] = number.range;
    match goes_by_ratio(number) {
        true => libm::log(value / least) / libm::log(greatest / least),
        false => (value - least) / (greatest - least),
    }
}

/// The value at a place, with three digits that count.
fn value(number: &Parameter, place: f64) -> f64 {
    let [least, greatest] = number.range;
    let value = match goes_by_ratio(number) {
        true => least * libm::pow(greatest / least, place),
        false => least + place * (greatest - least),
    };
    if value <= 0.0 {
        return 0.0;
    }
    let unit = libm::pow(10.0, libm::floor(libm::log10(value)) - 2.0);
    let rounded = (value / unit).round() * unit;
    let rounded = if number.is_whole() { rounded.round() } else { (rounded * 1e6).round() / 1e6 };
    rounded.clamp(least, greatest)
}

/// Grows a scene on its body up to its day, and measures all that is wanted there.
///
/// # Errors
/// In plain words, what cannot be grown so.
pub fn grown(scene: &Scene, wants: &[Want], body: Body) -> Result<Vec<f64>, String> {
    let mut scene = scene.clone();
    if wants.iter().all(|want| want.measure.is_of_lineage(&scene)) {
        // Where the cells lie is no matter, so none is moved.
        scene.recipe.initial_relaxations = 0;
        scene.recipe.relaxations_per_day = 0;
    }
    let (order, mut growth) = Order::new(Kind::Days, &scene, body)?;
    loop {
        match growth.step() {
            Progress::Done => break,
            Progress::Full => return Err("it has too many cells".to_string()),
            Progress::Event | Progress::Day(_) => {}
        }
    }
    let day = growth.diary.days.len() - 1;
    let pattern = std::cell::OnceCell::new();
    let seen = || {
        let pattern = pattern
            .get_or_init(|| order.pattern(&mut Charts::new(order.mesh()), &growth.diary, day));
        pattern.clone()
    };
    Ok(wants.iter().map(|want| want.measure.value(&growth.diary, day, seen)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants;
    use crate::play::link;
    use CellType::Foreground as F;

    fn fit(wants: &[(Measure, f64)], keys: &[&str]) -> Fit {
        let scene = link::read("croton-shrub?v=1&s=1&d=6&n=500", plants::all()).scene;
        let wants = wants.iter().map(|&(measure, value)| Want { measure, value }).collect();
        let numbers = keys.iter().map(|key| Parameter::of_key(key).unwrap()).collect();
        Fit::new(scene, wants, numbers)
    }

    /// Searches where a law says what comes of a scene.
    fn search(fit: &mut Fit, law: impl Fn(&Scene) -> Option<Vec<f64>>) -> Vec<f64> {
        let mut better = Vec::new();
        while let Some(scene) = fit.next_scene() {
            let values = law(&scene);
            if fit.tell(scene, values.as_deref()) {
                better.push(fit.best().unwrap().1);
            }
        }
        better
    }

    #[test]
    fn two_numbers_are_found_that_two_laws_want() {
        let wants = [(Measure::Share(F), 37.0), (Measure::Patches(F), 1200.0)];
        let mut fit = fit(&wants, &["pf", "n"]);
        let better = search(&mut fit, |scene| {
            let recipe = &scene.recipe;
            let share = recipe.initial_probability[0];
            // What nobody can grow is gone around.
            (share < 0.9).then(|| vec![100.0 * share, f64::from(recipe.initial_cells) * share])
        });
        assert!(better.is_sorted_by(|a, b| a > b) && better.len() > 4, "{better:?}");
        let (scene, off) = fit.best().unwrap();
        assert!(*off < 0.02, "{off} after {} tries", fit.tries());
        assert!((scene.recipe.initial_probability[0] - 0.37).abs() < 0.01);
        assert!((f64::from(scene.recipe.initial_cells) / (1200.0 / 0.37) - 1.0).abs() < 0.05);
        assert!(fit.tries() < 120, "{}", fit.tries());
        // It is a scene that a link says.
        let read = link::read(&link::write(scene), plants::all());
        assert_eq!((read.left_out.len(), read.scene.recipe == scene.recipe), (0, true));
    }

    #[test]
    fn the_share_of_a_growth_is_found() {
        let mut fit = fit(&[(Measure::Share(F), 25.0)], &["pf"]);
        let body = fit.scene.plant.embedded_body();
        let wants = fit.wants.clone();
        search(&mut fit, |scene| Some(grown(scene, &wants, body.clone()).unwrap()));
        let (scene, off) = fit.best().unwrap();
        assert!(*off < 0.04, "{off}");
        // Both types divide alike, so that the first share stays but for chance.
        assert!((scene.recipe.initial_probability[0] - 0.25).abs() < 0.06);
    }

    #[test]
    fn a_search_ends_where_nothing_helps() {
        let mut fit = fit(&[(Measure::Cells, 10.0)], &["pf", "fb"]);
        assert_eq!(search(&mut fit, |_| Some(vec![20.0])), [1.0]);
        assert!(fit.tries() < 40, "{}", fit.tries());
    }
}
