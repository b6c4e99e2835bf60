//! The canvases that follow one another on the stage as their graphics devices are lost.

/// Devices that are lost more often than this in `WITHIN_MS` are not asked for again.
const MOST_LOSSES: usize = 4;
const WITHIN_MS: f64 = 30_000.0;

/// Numbers the canvases: a device goes on talking after it is lost, also while the next one is on its
/// way, and what it says then is true of its own canvas alone.
#[derive(Clone, Debug, Default)]
pub struct Canvases {
    current: u32,
    losses_ms: Vec<f64>,
}

/// What the loss of a canvas leads to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Loss {
    /// Nothing: another canvas stands in its place already.
    Old,
    /// Another canvas, which has the current number now.
    Renew,
    /// The still picture: canvases were lost too often.
    GiveUp,
}

impl Canvases {
    /// The number of the canvas that is on the stage.
    pub fn current(&self) -> u32 {
        self.current
    }

    /// The device of the canvas of this number is lost or of no use. `now_ms`: milliseconds of any
    /// clock.
    pub fn lose(&mut self, number: u32, now_ms: f64) -> Loss {
        if number != self.current {
            return Loss::Old;
        }
        self.current += 1;
        self.losses_ms.retain(|&ms| now_ms - ms < WITHIN_MS);
        self.losses_ms.push(now_ms);
        if self.losses_ms.len() > MOST_LOSSES { Loss::GiveUp } else { Loss::Renew }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_canvas_is_lost_once_whatever_its_device_says_afterwards() {
        let mut canvases = Canvases::default();
        let first = canvases.current();
        assert_eq!(canvases.lose(first, 0.0), Loss::Renew);
        let second = canvases.current();
        assert_ne!(first, second);
        for _ in 0..10 {
            assert_eq!(canvases.lose(first, 1.0), Loss::Old);
        }
        assert_eq!(canvases.current(), second);
        assert_eq!(
            canvases.lose(second, 2.0),
            Loss::Renew,
            "the words of the first count for nothing"
        );
    }

    #[test]
    fn what_is_lost_again_and_again_is_given_up() {
        let mut canvases = Canvases::default();
        let mut lose = |now_ms| canvases.lose(canvases.current(), now_ms);
        assert!((0..4).all(|k| lose(f64::from(k)) == Loss::Renew));
        assert_eq!(lose(WITHIN_MS), Loss::Renew, "the first is long ago");
        assert_eq!(lose(WITHIN_MS), Loss::GiveUp);
    }
}
