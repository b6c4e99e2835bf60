//! Many individuals of many pictures, grown on several threads or in several processes.

use super::Refusal;
use clonal_mosaic::mosaic::Pattern;
use clonal_mosaic::plants;
use clonal_mosaic::play::figures::Figure;
use clonal_mosaic::play::{Scene, link};
use clonal_mosaic::surface::{Charts, Mesh, quoted};
use clonal_mosaic::tissue::{Diary, Expected, Progress, Recipe, expected_cells};
use std::collections::BTreeMap;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// A picture whose individuals are grown.
pub struct Subject {
    pub figure: String,
    pub label: String,
    pub scene: Scene,
    pub mesh: Arc<Mesh>,
    /// An individual with more cells is refused.
    pub max_cells: u32,
}

/// One individual of a picture: a row of what a shard prints.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Its number in the sweep, from 0, and how many there are.
    pub item: usize,
    pub items: usize,
    /// Of a plant whose numbers vary: its key, and `df=4 pf=0.2`.
    pub figure: String,
    pub picture: String,
    pub individual: u32,
    /// What the playground shows it by.
    pub link: String,
    pub fingerprint: String,
    pub by_type: [u32; 3],
    pub area_shares: [f64; 3],
    /// Of F cells.
    pub patches: u32,
    pub mixed_edges: f64,
    /// Mean and variance of the number of cells over all individuals that begin with as many first
    /// cells of each type as this one.
    pub expected: Option<[f64; 2]>,
}

/// The pictures of some figures. Those of a figure that differ in the individual alone are one.
pub fn subjects(figures: &[&'static Figure]) -> Vec<Subject> {
    let mut meshes: BTreeMap<&str, Arc<Mesh>> = BTreeMap::new();
    let mut subjects: Vec<Subject> = Vec::new();
    for figure in figures {
        let first = subjects.len();
        for picture in figure.pictures {
            let scene = Scene { individual: 1, ..link::read(picture.link, plants::all()).scene };
            if let Some(same) = subjects[first..].iter_mut().find(|other| other.scene == scene) {
                same.label = "individuals".into();
                continue;
            }
            let surface = || Arc::new(scene.plant.embedded_body().surface);
            let mesh = meshes.entry(scene.plant.key).or_insert_with(surface).clone();
            // The cap guards a visitor's memory; here it would cut off the largest individuals.
            let max_cells = Recipe::MOST_CELLS;
            let (figure, label) = (figure.number.into(), picture.label.into());
            subjects.push(Subject { figure, label, scene, mesh, max_cells });
        }
    }
    subjects
}

/// Grows one of so many shards, counted from 1, of the individuals `1..=individuals` of all subjects,
/// on some threads. `tell` hears of each that is done; the rows come in the order of their numbers. The
/// first that cannot be grown ends all.
pub fn grow(
    subjects: &[Subject],
    individuals: u32,
    (shard, shards): (u32, u32),
    threads: usize,
    tell: impl Fn(&Row) + Sync,
) -> Result<Vec<Row>, Refusal> {
    let items = subjects.len() * individuals as usize;
    let work: Vec<usize> = (shard as usize - 1..items).step_by(shards as usize).collect();
    let next = AtomicUsize::new(0);
    let work_off = || {
        let mut rows = Vec::new();
        while let Some(&item) = work.get(next.fetch_add(1, Ordering::Relaxed)) {
            let subject = &subjects[item / individuals as usize];
            let individual = (item % individuals as usize) as u32 + 1;
            let grown = subject.grow(individual).inspect_err(|_| {
                // Nobody begins another one.
                next.store(work.len(), Ordering::Relaxed);
            })?;
            let row = Row { item, items, ..grown };
            tell(&row);
            rows.push(row);
        }
        Ok(rows)
    };
    let rows: Result<Vec<Vec<Row>>, Refusal> = thread::scope(|scope| {
        let workers: Vec<_> = (0..threads.min(work.len())).map(|_| scope.spawn(work_off)).collect();
        workers.into_iter().map(|worker| worker.join().expect("a worker grows")).collect()
    });
    let mut rows = rows?.concat();
    rows.sort_by_key(|row| row.item);
    Ok(rows)
}

impl Subject {
    /// Grows an individual up to the picture's day.
    fn grow(&self, individual: u32) -> Result<Row, Refusal> {
        let day = self.scene.day;
        let max_cells = self.max_cells;
        let recipe = Recipe { days: day, max_cells, ..self.scene.recipe.clone() };
        let scene = Scene { individual, recipe, ..self.scene.clone() };
        let refuse = |why: String| format!("{}, individual {individual}: {why}", self.label);
        let sown = scene.sow(self.mesh.clone());
        let (mut growth, noise) = sown.map_err(|e| refuse(e.to_string()))?;
        loop {
            match growth.step() {
                Progress::Done => break,
                Progress::Full => {
                    let full = growth.diary.days.len();
                    return Err(refuse(format!(
                        "on day {full} there are more than {max_cells} cells, its max_cells; \
                         take an earlier --day or fewer cells"
                    )));
                }
                Progress::Event | Progress::Day(_) => {}
            }
        }
        let expected = self.expected(&scene, &growth.diary);
        let painted = noise.map(|noise| noise.paint(&self.mesh, &growth.diary, day as usize));
        let diary = painted.unwrap_or(growth.diary);
        let pattern = Pattern::of(&self.mesh, &mut Charts::new(&self.mesh), &diary, day as usize);
        Ok(Row {
            item: 0,
            items: 0,
            figure: self.figure.clone(),
            picture: self.label.clone(),
            individual,
            link: link::write(&Scene { individual, ..self.scene.clone() }),
            fingerprint: diary.fingerprint(day as usize),
            by_type: pattern.count.by_type,
            area_shares: pattern.area_shares,
            patches: pattern.patches[0],
            mixed_edges: pattern.mixed_edges,
            expected: expected.map(|e| [e.mean, e.variance]),
        })
    }

    /// What the model says of the first cells of an individual, each part at its own age.
    fn expected(&self, scene: &Scene, diary: &Diary) -> Option<Expected> {
        let Scene { plant, recipe, .. } = scene;
        let controls = plant.controls(scene.individual);
        let mut by_age = BTreeMap::<u32, [u32; 3]>::new();
        for (place, cell) in diary.days[0].places.iter().zip(&diary.lineage) {
            let part = self.mesh.parts[place.triangle as usize] as usize;
            let unfolded = plant.motion.unfolding_days.get(part).copied().unwrap_or(0);
            let age = self.scene.day.saturating_sub(unfolded);
            by_age.entry(age).or_default()[cell.kind as usize] += 1;
        }
        let mut all = Expected::default();
        for (age, first_cells) in by_age {
            let of_age = expected_cells(recipe, &controls, first_cells, age as usize)?;
            all.mean += of_age.mean;
            all.variance += of_age.variance;
        }
        Some(all)
    }
}

/// The columns of a row as a shard prints it. Numbers have as many digits as it takes to read the
/// same bits back.
pub const HEADING: &str = "item,items,figure,picture,individual,link,fingerprint,F,B,M,area_F,\
                           area_B,area_M,patches,mixed_edges,expected_cells,expected_variance";

impl Row {
    pub fn cells(&self) -> u32 {
        self.by_type.iter().sum()
    }

    pub fn to_csv(&self) -> String {
        let Row { item, items, figure, picture, individual, link, fingerprint, .. } = self;
        let ([f, b, m], [area_f, area_b, area_m]) = (self.by_type, self.area_shares);
        let expected =
            self.expected.map_or(",".into(), |[mean, variance]| format!("{mean},{variance}"));
        format!(
            "{item},{items},{figure},{picture},{individual},{link},{fingerprint},{f},{b},{m},\
             {area_f},{area_b},{area_m},{},{},{expected}",
            self.patches, self.mixed_edges
        )
    }

    /// Reads what `to_csv` has written; says what is wrong with anything else.
    pub fn from_csv(line: &str) -> Result<Row, Refusal> {
        let words: Vec<&str> = line.split(',').collect();
        let names: Vec<&str> = HEADING.split(',').collect();
        if words.len() != names.len() {
            return Err(format!("{} columns, but a shard has {}", words.len(), names.len()));
        }
        fn number<T: std::str::FromStr>(name: &str, word: &str) -> Result<T, Refusal> {
            let refuse = |_| format!("{name} is {}, which is no number of its kind", quoted(word));
            word.parse().map_err(refuse)
        }
        let whole = |k: usize| number::<u32>(names[k], words[k]);
        let real = |k: usize| number::<f64>(names[k], words[k]);
        Ok(Row {
            item: number(names[0], words[0])?,
            items: number(names[1], words[1])?,
            figure: words[2].into(),
            picture: words[3].into(),
            individual: whole(4)?,
            link: words[5].into(),
            fingerprint: words[6].into(),
            by_type: [whole(7)?, whole(8)?, whole(9)?],
            area_shares: [real(10)?, real(11)?, real(12)?],
            patches: whole(13)?,
            mixed_edges: real(14)?,
            expected: if words[15].is_empty() { None } else { Some([real(15)?, real(16)?]) },
        })
    }
}
