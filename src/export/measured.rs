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
mod explore {
    use super::*;
    use crate::plants;
    use crate::play::link;

    #[test]
    #[ignore]
    fn explore() {
        let text = std::fs::read_to_string("/tmp/explore.txt").unwrap();
        for line in text.lines().filter(|l| !l.is_empty() && !l.starts_with('#')) {
            let (n, rest) = line.split_once('|').unwrap();
            let (measure, link) = rest.split_once('|').unwrap();
            let opened = link::read(link, plants::all());
            assert!(opened.left_out.is_empty(), "{:?}", opened.left_out);
            let measure = Measure::of_words(measure).unwrap();
            let n: u32 = n.parse().unwrap();
            let begun = std::time::Instant::now();
            let values: Vec<f64> = (0..n)
                .map(|k| {
                    let mut scene = opened.scene.clone();
                    scene.individual += k;
                    measured(&scene, measure, scene.plant.embedded_body()).unwrap()
                })
                .collect();
            let mean = values.iter().sum::<f64>() / f64::from(n);
            let var = values.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>() / f64::from(n);
            let told: Vec<String> = values.iter().take(24).map(|v| format!("{v:.1}")).collect();
            println!("{line}\n  mean {mean:.2} sd {:.2} {:?} {:.2} s\n  {}", var.sqrt(), measure.usual(&opened.scene), begun.elapsed().as_secs_f64(), told.join(" "));
        }
    }
}
