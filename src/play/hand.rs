//! A worker as the brains of page and figures know it: whether it listens, what it grows, and how
//! often one was lost.

use super::page::Effect;

/// So many workers lost, without a day from any of them, and no other is started until something is
/// wished anew.
const MOST_LOSSES: u32 = 3;

/// One worker, or the place of one.
#[derive(Debug, Default)]
pub struct Hand {
    stage: Stage,
    /// The generation of what it grows.
    pub grows: Option<u32>,
    losses: u32,
}

#[derive(Debug, Default, PartialEq)]
enum Stage {
    #[default]
    Missing,
    Starting,
    Listening,
}

impl Hand {
    /// The effect that starts a worker, if there is none.
    pub fn start(&mut self) -> Option<Effect> {
        if !self.is_missing() {
            return None;
        }
        self.stage = Stage::Starting;
        Some(Effect::StartWorker)
    }

    pub fn is_missing(&self) -> bool {
        self.stage == Stage::Missing
    }

    /// It said hello.
    pub fn greet(&mut self) {
        self.stage = Stage::Listening;
    }

    pub fn listens(&self) -> bool {
        self.stage == Stage::Listening
    }

    /// A growth has come to its end, unless it grows another one by now.
    pub fn finish(&mut self, generation: u32) {
        self.grows.take_if(|grows| *grows == generation);
    }

    /// It works, or is to be given another chance: earlier losses count no more.
    pub fn forgive(&mut self) {
        self.losses = 0;
    }

    /// The worker is lost. Whether another is worth a try, and the generation of what it grew.
    pub fn lose(&mut self) -> (bool, Option<u32>) {
        self.losses += 1;
        (self.losses < MOST_LOSSES, self.end())
    }

    /// There is no worker any more. The generation of what it grew.
    pub fn end(&mut self) -> Option<u32> {
        self.stage = Stage::Missing;
        self.grows.take()
    }
}
