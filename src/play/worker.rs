//! The worker's brain: grows what the page wishes, a slice at a time, and answers day by day. A newer
//! wish interrupts the older one.

use super::link;
use super::protocol::{BUILD, DayNews, ToPage, ToWorker};
use crate::plants::Plant;
use crate::surface::Body;
use crate::tissue::{Growth, Progress};

/// The worker's desk: where wishes arrive and answers leave.
#[expect(async_fn_in_trait, reason = "a worker has one thread: no future need be Send")]
pub trait Desk {
    /// Waits for the next wish; wishes that a newer one has overtaken are dropped.
    async fn next(&mut self) -> ToWorker;
    /// Whether the slice of time is used up and it is time to look for wishes.
    fn slice_is_over(&mut self) -> bool;
    /// Lets wishes arrive, and starts the next slice; the newest wish, if any.
    async fn look_up(&mut self) -> Option<ToWorker>;
    fn post(&mut self, answer: ToPage);
}

/// Works for ever.
pub async fn work(desk: &mut impl Desk, plants: &'static [Plant]) {
    desk.post(ToPage::Hello { build: BUILD.to_string() });
    let mut bodies: Vec<(&str, Body)> = Vec::new();
    let mut wish = desk.next().await;
    loop {
        let ToWorker::Grow { generation, link } = &wish;
        wish = match grow(desk, plants, &mut bodies, *generation, link).await {
            Some(newer) => newer,
            None => desk.next().await,
        };
    }
}

/// Grows the scene of a link until it ends or a newer wish arrives. Bodies are made once and kept:
/// refining one takes longer than its first days.
async fn grow(
    desk: &mut impl Desk,
    plants: &'static [Plant],
    bodies: &mut Vec<(&str, Body)>,
    generation: u32,
    link: &str,
) -> Option<ToWorker> {
    let scene = link::read(link, plants).scene;
    let (plant, recipe) = (scene.plant, scene.recipe);
    let known = bodies.iter().position(|(key, _)| *key == plant.key).unwrap_or_else(|| {
        bodies.push((plant.key, (plant.body)()));
        bodies.len() - 1
    });
    let controls = (plant.controls)();
    let mesh = &bodies[known].1.surface;
    let mut growth = match Growth::new(mesh, &recipe, &controls, scene.individual) {
        Ok(growth) => growth,
        Err(why) => {
            desk.post(ToPage::Failed { generation, text: why.to_string() });
            return None;
        }
    };
    loop {
        match growth.step() {
            Progress::Event => {}
            Progress::Day(day) => desk.post(ToPage::Day(news(&growth, generation, day))),
            Progress::Full => {
                desk.post(ToPage::Full { generation });
                return None;
            }
            Progress::Done => {
                desk.post(ToPage::Done { generation });
                return None;
            }
        }
        if desk.slice_is_over()
            && let Some(newer) = desk.look_up().await
        {
            return Some(newer);
        }
    }
}

fn news(growth: &Growth, generation: u32, day: u32) -> DayNews {
    let index = day as usize;
    let today = &growth.diary.days[index];
    let before = index.checked_sub(1).map_or(0, |k| growth.diary.days[k].places.len());
    DayNews {
        generation,
        day,
        repulsive_radius: today.repulsive_radius,
        fingerprint: growth.diary.fingerprint(index),
        places: today.places.clone(),
        newborn: growth.diary.lineage[before..today.places.len()].to_vec(),
    }
}
