//! `mosaic fit`: numbers of a recipe that make what is wanted of a plant.

use super::options::FitOptions;
use super::output::say;
use super::progress::Progress;
use super::{Refusal, cores, memory, subject};
use clonal_mosaic::export::{Fit, Want, grown};
use clonal_mosaic::play::parameters::Parameter;
use clonal_mosaic::play::{Scene, link};
use clonal_mosaic::surface::{Body, quoted};
use std::sync::atomic::{AtomicU32, Ordering};
use std::thread;

/// Prints each try that is better than all before, with its link: whoever stops it has the best as the last line.
pub fn fit(options: &FitOptions) -> Result<(), Refusal> {
    let scene = subject::scene(options.source(), options.day)?;
    memory::check(&scene.recipe)?;
    let wants = Want::read(&options.want, &scene).map_err(|why| format!("--want {why}"))?;
    let numbers = numbers(options, &wants, &scene)?;
    let body = scene.plant.embedded_body();
    let plant = scene.plant;
    let seen = Progress::beside_lines();
    let mut fit = Fit::new(scene, wants.clone(), numbers.clone());
    while let Some(scene) = fit.next_scene().filter(|_| fit.tries() <= options.tries as usize) {
        seen.tell(&format!("try {} of at most {}", fit.tries(), options.tries));
        let values = means(&scene, &wants, &body, options.individuals);
        if let (1, Err(why)) = (fit.tries(), &values) {
            return Err(why.clone());
        }
        let values = values.ok();
        if !fit.tell(scene, values.as_deref()) {
            continue;
        }
        let (Some((best, off)), Some(values)) = (fit.best(), values) else { continue };
        seen.clear();
        let set = numbers.iter().map(|number| format!("{}={}", number.key, number.get(best)));
        let came = wants.iter().zip(values).map(|(want, value)| {
            format!("{} {}", want.measure.name(plant), want.measure.told(value))
        });
        let list = |texts: &mut dyn Iterator<Item = String>| texts.collect::<Vec<_>>().join(", ");
        say(&format!(
            "try {}: {}: {}; off by {:.1} %; {}\n",
            fit.tries(),
            list(&mut { set }),
            list(&mut { came }),
            100.0 * off,
            link::write(best)
        ))?;
    }
    Ok(())
}

/// The numbers that are named, or else those that decide most.
fn numbers(
    options: &FitOptions,
    wants: &[Want],
    scene: &Scene,
) -> Result<Vec<&'static Parameter>, Refusal> {
    let Some(named) = &options.vary else { return Ok(Fit::numbers_of(wants, scene)) };
    let mut numbers: Vec<&Parameter> = Vec::new();
    for key in named.split(',') {
        let number =
            Parameter::of_key(key).filter(|p| p.is_number() && p.regrows && p.key != "days");
        let number = number
            .filter(|number| number.is_for(scene.plant))
            .ok_or_else(|| format!("--vary: there is no number {} to vary", quoted(key)))?;
        if numbers.iter().all(|other| other.key != key) {
            numbers.push(number);
        }
    }
    Ok(numbers)
}

/// The mean values of individuals, from the scene's on, grown on as many threads as there are cores.
fn means(
    scene: &Scene,
    wants: &[Want],
    body: &Body,
    individuals: u32,
) -> Result<Vec<f64>, Refusal> {
    let next = AtomicU32::new(0);
    let work = || {
        let mut sums = vec![0.0; individuals as usize * wants.len()];
        loop {
            let k = next.fetch_add(1, Ordering::Relaxed);
            if k >= individuals {
                return Ok(sums);
            }
            let individual = scene.individual.wrapping_add(k);
            let values = grown(&Scene { individual, ..scene.clone() }, wants, body.clone())?;
            sums[k as usize * wants.len()..][..wants.len()].copy_from_slice(&values);
        }
    };
    let parts: Result<Vec<Vec<f64>>, Refusal> = thread::scope(|scope| {
        let threads = cores().min(individuals as usize);
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        workers.into_iter().map(|worker| worker.join().expect("a worker grows")).collect()
    });
    let parts = parts?;
    // Summed up in their order, whoever grew them: the same digits with any number of cores.
    let value = |k: usize| parts.iter().map(|part| part[k]).sum::<f64>();
    let mean = |want: usize| {
        let of = |k: u32| value(k as usize * wants.len() + want);
        (0..individuals).map(of).sum::<f64>() / f64::from(individuals)
    };
    Ok((0..wants.len()).map(mean).collect())
}
