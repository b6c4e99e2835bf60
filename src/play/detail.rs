//! How finely the picture is drawn: while it changes with as many pixels as the device draws in time,
//! and with all of them when it rests.

/// A frame that takes longer than this, in seconds, is felt; then pixels are left out until frames
/// may take `GOAL_S`.
const SLOW_S: f64 = 0.050;
const GOAL_S: f64 = 0.033;
/// So many frames that take less than this in a row, and more pixels are tried. `MORE` squared is less
/// than `SLOW_S / QUICK_S`: what is tried is not taken back.
const QUICK_S: f64 = 0.020;
const QUICK_FRAMES: u32 = 30;
const MORE: f64 = 1.25;
/// Coarser, and a plant is not seen for its pixels; most of what a frame then costs is something else.
const LEAST_SHARE: f64 = 1.0 / 3.0;
/// Seconds after the last change until all pixels are drawn: longer than between two keys or two
/// moves of a hand.
const REST_S: f64 = 0.2;

/// Learns from the time that frames take.
#[derive(Clone, Debug)]
pub struct Detail {
    /// Share of the pixels along each side of a picture that changes.
    share: f64,
    /// Whether the last frame changed the picture.
    changed: bool,
    /// Seconds since one did.
    rested_s: f64,
    /// What the last of these took, in seconds.
    last_s: f64,
    quick_frames: u32,
}

impl Detail {
    /// A graphics card is taken to be quick, and software in its place to be slow, until frames tell:
    /// so the first picture comes sooner.
    pub fn new(is_software: bool) -> Detail {
        let share = if is_software { LEAST_SHARE } else { 1.0 };
        Detail { share, changed: false, rested_s: 0.0, last_s: 0.0, quick_frames: 0 }
    }

    /// The share of the pixels along each side to draw a frame with. `seconds`: since the last frame
    /// began. `changes`: whether this one will differ from it otherwise than in its pixels.
    pub fn share(&mut self, seconds: f64, changes: bool) -> f64 {
        if self.changed {
            self.learn(seconds);
        }
        self.rested_s = if changes { 0.0 } else { self.rested_s + seconds };
        self.changed = changes;
        if self.rested_s < REST_S { self.share } else { 1.0 }
    }

    fn learn(&mut self, seconds: f64) {
        // One slow frame alone has other reasons.
        let both_s = seconds.min(self.last_s);
        self.last_s = seconds;
        if both_s > SLOW_S {
            self.share = (self.share * (GOAL_S / both_s).sqrt()).max(LEAST_SHARE);
            self.last_s = 0.0;
        }
        self.quick_frames = if seconds < QUICK_S { self.quick_frames + 1 } else { 0 };
        if self.quick_frames == QUICK_FRAMES {
            self.share = (self.share * MORE).min(1.0);
            self.quick_frames = 0;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Draws changing frames on a device that takes this long for all pixels.
    fn after(frames: u32, whole_s: f64, detail: &mut Detail) -> f64 {
        let mut share = detail.share;
        for _ in 0..frames {
            share = detail.share(whole_s * share * share, true);
        }
        share
    }

    #[test]
    fn quick_devices_draw_all_pixels_always() {
        let mut detail = Detail::new(false);
        assert_eq!(after(200, 0.016, &mut detail), 1.0);
        // A hiccup changes nothing.
        detail.share(0.4, true);
        assert_eq!(after(200, 0.016, &mut detail), 1.0);
    }

    #[test]
    fn software_begins_coarse_and_gets_its_pixels_if_it_is_quick() {
        let mut detail = Detail::new(true);
        assert_eq!(detail.share(0.016, true), LEAST_SHARE);
        assert_eq!(detail.share(REST_S, false), 1.0, "at rest all pixels at once");
        assert_eq!(after(400, 0.01, &mut detail), 1.0);
    }

    #[test]
    fn slow_devices_draw_in_time_and_settle() {
        for whole_s in [0.06, 0.1, 0.2, 0.25] {
            let mut detail = Detail::new(false);
            let share = after(10, whole_s, &mut detail);
            assert!(share < 1.0 && whole_s * share * share < SLOW_S, "{whole_s}: {share}");
            let shares: Vec<f64> = (0..400).map(|_| after(1, whole_s, &mut detail)).collect();
            let settled = &shares[200..];
            assert!(settled.iter().all(|&s| s == settled[0]), "{whole_s}: no to and fro");
        }
    }

    #[test]
    fn the_slowest_draw_a_third() {
        assert_eq!(after(20, 5.0, &mut Detail::new(false)), LEAST_SHARE);
    }

    #[test]
    fn what_becomes_quick_gets_its_pixels_back() {
        let mut detail = Detail::new(false);
        assert!(after(10, 0.3, &mut detail) < 0.5);
        assert_eq!(after(400, 0.01, &mut detail), 1.0);
    }

    #[test]
    fn at_rest_all_pixels_are_drawn() {
        let mut detail = Detail::new(false);
        let coarse = after(10, 0.3, &mut detail);
        assert_eq!(detail.share(0.05, false), coarse, "the next key may come");
        assert_eq!(detail.share(0.2, false), 1.0);
        assert_eq!(detail.share(2.0, false), 1.0);
        assert_eq!(detail.share(1.0, true), coarse, "what rested took no time of a changing one");
    }
}
