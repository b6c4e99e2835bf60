//! `mosaic export`: writes the plant of a day as other programs read it.

use super::options::ExportOptions;
use super::output::{Target, say, warn};
use super::{Refusal, cores, memory, progress, subject};
use clonal_mosaic::export::{Kind, Order, write_leaves};
use clonal_mosaic::tissue::{Diary, Growth, Progress, Recipe};
use std::io::Write;
use std::path::Path;

pub fn export(options: &ExportOptions) -> Result<(), Refusal> {
    let (kind, path) = options.wanted().ok_or_else(|| {
        let words: Vec<String> =
            Kind::ALL.iter().map(|kind| format!("--{}", kind.word())).collect();
        format!("say what to write, and where: one of {}", words.join(", "))
    })?;
    let individuals = options.individuals.unwrap_or(1);
    if options.individuals.is_some() && kind != Kind::Leaves {
        return Err("--individuals is for --leaves: all else is of one individual".to_string());
    }
    let mut scene = subject::scene(options.source(), options.day)?;
    scene.individual = options.individual.unwrap_or(scene.individual);
    // Tried first: nobody should wait for a plant that cannot be written down.
    let mut targets = Vec::new();
    let mut name = String::new();
    if kind == Kind::Obj {
        let (said, beside) = materials_beside(path)?;
        name = said;
        targets.push(beside);
    }
    targets.push(Target::new(path)?);
    let is_file = targets.iter().all(Target::is_file);

    let mut recipe = scene.recipe.clone();
    recipe.days = scene.day;
    memory::check(&recipe)?;
    let mut grown = Vec::new();
    for _ in 0..individuals {
        let (order, growth) = Order::new(kind, &scene, scene.plant.embedded_body())?;
        grown.push((order, grow(growth.on_threads(cores()), &recipe)));
        scene.individual = scene.individual.wrapping_add(1);
    }
    let seen = progress::Progress::new();
    seen.tell("writing");
    let written = match kind {
        Kind::Leaves => {
            let of_each = grown.iter().map(|(order, diary)| (order, diary));
            write_leaves(&of_each.collect::<Vec<_>>())
        }
        _ => {
            let (order, diary) = grown.remove(0);
            order.write(diary, &name)
        }
    }?;
    // The materials of an OBJ first: it speaks of them.
    for (target, bytes) in targets.into_iter().zip(written.files.iter().rev()) {
        target.write(|out| out.write_all(bytes))?;
    }
    drop(seen);
    let line = format!("{}: {}", path.display(), written.told);
    if is_file {
        return say(&(line + "\n"));
    }
    // Where the plant itself goes to the standard output, nothing else may.
    warn(&line);
    Ok(())
}

/// Grows to the last day, or as long as there is room for cells.
fn grow(mut growth: Growth, recipe: &Recipe) -> Diary {
    let seen = progress::Progress::new();
    loop {
        match growth.step() {
            Progress::Event => {}
            Progress::Day(day) => seen.tell(&format!("day {day} of {}", recipe.days)),
            Progress::Done => break,
            Progress::Full => {
                seen.clear();
                warn(&format!(
                    "growth ends early, at the recipe's max_cells of {}; what has grown is written",
                    recipe.max_cells
                ));
                break;
            }
        }
    }
    growth.diary
}

/// The file for the materials of an OBJ, and its name as the OBJ says it.
fn materials_beside(path: &Path) -> Result<(String, Target), Refusal> {
    let beside = path.with_extension("mtl");
    let name = beside.file_name().and_then(|name| name.to_str()).unwrap_or_default();
    if path.file_stem().is_none() || name.is_empty() || name.contains(char::is_control) {
        return Err(format!("{}: an OBJ needs a plain name", path.display()));
    }
    let target = Target::new(path)?;
    if beside == path || !target.is_file() {
        return Err(format!(
            "{}: an OBJ is a file, with its colours in a .mtl file beside it",
            path.display()
        ));
    }
    Ok((name.to_string(), Target::new(&beside)?))
}
