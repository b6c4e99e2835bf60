//! One number of a plant that grows for it.

use super::kind::Kind;
use super::order::Order;
use crate::play::Scene;
use crate::play::lesson::Measure;
use crate::surface::{Body, Charts};
use crate::tissue::Progress;

/// Grows a scene on its body up to its day and measures it there.
///
/// # Errors
/// In plain words, what cannot be grown so.
pub fn measured(scene: &Scene, measure: Measure, body: Body) -> Result<f64, String> {
    let mut scene = scene.clone();
    if measure.is_of_lineage(&scene) {
        // Where the cells lie is no matter, so none is moved: a hundred times as fast.
        scene.recipe.initial_relaxations = 0;
        scene.recipe.relaxations_per_day = 0;
    }
    let (order, mut growth) = Order::new(Kind::Days, &scene, body)?;
    while !matches!(growth.step(), Progress::Done | Progress::Full) {}
    let day = growth.diary.days.len() - 1;
    let pattern = || order.pattern(&mut Charts::new(order.mesh()), &growth.diary, day);
    Ok(measure.value(&growth.diary, day, pattern))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::play::lesson::Usual;
    use crate::play::link;
    use crate::{plants, tissue::CellType::Foreground as F};

    fn scene(link: &str) -> Scene {
        let opened = link::read(link, plants::all());
        assert_eq!(opened.left_out, [""; 0]);
        opened.scene
    }

    /// The values of so many individuals, and their mean and standard deviation.
    fn grown(link: &str, measure: Measure, individuals: u32) -> (Vec<f64>, f64, f64) {
        let mut scene = scene(link);
        let body = scene.plant.embedded_body();
        let values: Vec<f64> = (1..=individuals)
            .map(|individual| {
                scene.individual = individual;
                measured(&scene, measure, body.clone()).unwrap()
            })
            .collect();
        let n = values.len() as f64;
        let mean = values.iter().sum::<f64>() / n;
        let square = values.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / n;
        (values, mean, square.sqrt())
    }

    #[test]
    fn what_the_lineage_decides_is_the_same_where_no_cell_moves() {
        for (link, measure) in [
            ("croton-shrub?v=1&s=3&d=12&n=200", Measure::Share(F)),
            ("moon-and-stars?v=1&s=2&d=12", Measure::SingleSpots),
            ("moon-and-stars?v=1&s=2&d=12", Measure::LargestClan),
        ] {
            let scene = scene(link);
            assert!(measure.is_of_lineage(&scene));
            let body = scene.plant.embedded_body();
            let (order, mut growth) = Order::new(Kind::Days, &scene, body.clone()).unwrap();
            while !matches!(growth.step(), Progress::Done | Progress::Full) {}
            let day = scene.day as usize;
            let pattern = || order.pattern(&mut Charts::new(order.mesh()), &growth.diary, day);
            let value = measure.value(&growth.diary, day, pattern);
            assert_eq!(measured(&scene, measure, body), Ok(value), "{link}");
        }
        assert!(!Measure::Share(F).is_of_lineage(&scene("croton?v=1")));
        assert!(!Measure::Mixed.is_of_lineage(&scene("croton-shrub?v=1")));
    }

    /// Growths scatter around the law as it says. Four standard errors: one seed in 16,000 misses.
    #[test]
    fn growths_keep_to_the_laws() {
        for (link, measure) in [
            ("croton-shrub?v=1&d=21&n=100&df=5&db=5", Measure::Cells),
            ("croton-shrub?v=1&d=25&n=20", Measure::Share(F)),
            ("croton-shrub?v=1&d=25&n=500&df=5&db=10&pf=0.1", Measure::Share(F)),
            ("croton-shrub?v=1&d=20&n=50&df=5&db=10&ck=1", Measure::Count(F)),
            ("cactus?v=1&d=25", Measure::Cells),
        ] {
            const INDIVIDUALS: u32 = 150;
            let Usual { mean: law, ends } = measure.usual(&scene(link)).unwrap();
            let (values, mean, _) = grown(link, measure, INDIVIDUALS);
            let deviation = (ends[1] - law) / 1.96;
            let error = deviation / f64::from(INDIVIDUALS).sqrt();
            // A share is a ratio, whose mean is that of the law to the first order alone.
            let of_ratio = if measure.is_share() { 0.03 * law } else { 0.0 };
            assert!((mean - law).abs() < 4.0 * error + of_ratio, "{link}: {mean}, not {law}");
            let within = values.iter().filter(|&&v| ends[0] <= v && v <= ends[1]).count();
            assert!((135..=149).contains(&within), "{link}: {within} of {INDIVIDUALS} within");
        }
        assert_eq!(Measure::Share(F).usual(&scene("moon-and-stars?v=1")), None);
        assert_eq!(Measure::Cells.usual(&scene("croton?v=1")), None);
    }

    #[test]
    fn half_of_all_spots_are_single_cells() {
        let link = "moon-and-stars?v=1&d=22&df=3.4";
        let (_, mean, deviation) = grown(link, Measure::SingleSpots, 24);
        // Yule's law: one in 1 + rho has two cells or more, where one child in 1 / (1 - rho) changes.
        let exact = 100.0 * (1.0 - 1.0 / (1.0 + 0.988));
        assert!((mean - exact).abs() < 4.0 * deviation / 24f64.sqrt(), "{mean}, not {exact}");
    }

    #[test]
    fn individuals_differ_far_more_than_independent_cells_would() {
        let link = "moon-and-stars?v=1&d=22&df=3.4&mbf=0.001&n=10&rs=0.7";
        let (mut values, mean, deviation) = grown(link, Measure::Count(F), 400);
        let exact = 10.0 * (libm::exp(22.0 / 3.4) - libm::exp(0.999 * 22.0 / 3.4));
        assert!((exact - 42.0).abs() < 0.5, "the lesson says 42, the law {exact}");
        assert!((mean - exact).abs() < 4.0 * deviation / 20.0, "{mean}, not {exact}");
        // By Poisson's law it would be the mean.
        assert!(deviation * deviation > 100.0 * mean, "{deviation}");
        assert_eq!(values[2], 932.0);
        assert_eq!(values[24], 97.0);
        values.sort_by(f64::total_cmp);
        assert!((19.0..=21.0).contains(&values[200]), "half have {}", values[200]);
    }

    /// What the texts of lessons say of single plants.
    #[test]
    fn lessons_tell_what_grows() {
        for (link, measure, told) in [
            ("croton-shrub?v=1&s=1&d=0", Measure::Mixed, 50.3),
            ("croton-shrub?v=1&s=1&d=30", Measure::Mixed, 27.4),
            ("croton-shrub?v=1&s=1&d=30&fb=1", Measure::Mixed, 46.9),
            ("croton-shrub?v=1&s=1&d=25&n=500&df=5&db=10&pf=0.1", Measure::Area(F), 36.8),
            ("moon-and-stars?v=1&s=1&d=22&df=3.4", Measure::Largest(F), 22.5),
            ("moon-and-stars?v=1&s=1&d=22&df=3.4&noise=1", Measure::Largest(F), 3.7),
            ("moon-and-stars?v=1&s=1&d=22&df=3.4", Measure::Count(F), 1682.0),
        ] {
            let scene = scene(link);
            let value = measured(&scene, measure, scene.plant.embedded_body()).unwrap();
            assert!((value - told).abs() <= 0.05, "{link}: {value}, not {told}");
        }
        let families = "moon-and-stars?v=1&d=20&n=12&mbf=0&rs=0.7";
        let (values, ..) = grown(families, Measure::Clans, 3);
        assert_eq!(values, [12.0; 3]);
        let (_, largest, _) = grown(families, Measure::LargestClan, 12);
        assert!((23.0..28.0).contains(&largest), "three times one in twelve: {largest}");
        let (values, ..) = grown("croton-shrub?v=1&d=25&n=20&rs=0.5", Measure::Share(F), 12);
        let (least, most) = (
            values.iter().copied().fold(100.0, f64::min),
            values.iter().copied().fold(0.0, f64::max),
        );
        assert!((24.0..26.0).contains(&least) && (62.0..66.0).contains(&most), "{least} to {most}");
    }
}
