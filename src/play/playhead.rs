//! The playhead: where on the line of days the picture stands, and how it gets where it is wished.
//! Time runs in days and fractions of them, so that cells can be shown on their way.

use crate::surface::limited;

/// Days in a second at speed 1.
const DAYS_PER_S: f64 = 2.0;
/// Days in a second at which a step of one day glides. Slower feels late, faster is a jump.
const GLIDE_DAYS_PER_S: f64 = 4.0;
/// Seconds in which a growing plant is followed: it never lags behind by more.
const FOLLOW_S: f64 = 0.25;

/// Speeds to choose from, 1 as it opens.
pub const SPEEDS: [f64; 6] = [0.25, 0.5, 1.0, 2.0, 4.0, 8.0];

/// Where the picture stands in time.
#[derive(Clone, Debug)]
pub struct Playhead {
    /// Days since sowing.
    time: f64,
    wished_day: u32,
    motion: Motion,
    pub speed: f64,
    /// Begin again at the end.
    pub looping: bool,
    /// No motion between days: whole days only, for visitors who asked for less motion.
    pub whole_days: bool,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Motion {
    /// To the wished day, or as far towards it as has grown.
    Glide,
    Play,
    /// Once to the wished day, which stays wished.
    Premiere,
    /// Held by the visitor; whether it played before.
    Scrub {
        played: bool,
    },
}

impl Playhead {
    pub fn new(wished_day: u32) -> Playhead {
        Playhead {
            time: 0.0,
            wished_day,
            motion: Motion::Glide,
            speed: 1.0,
            looping: false,
            whole_days: false,
        }
    }

    /// Days since sowing.
    pub fn time(&self) -> f64 {
        self.time
    }

    pub fn wished_day(&self) -> u32 {
        self.wished_day
    }

    /// The day whose cells are shown, and how far they are on their way there from the day before,
    /// 0 to 1.
    pub fn day_and_moment(&self) -> (u32, f32) {
        if self.whole_days {
            return ((self.time + 1e-6).floor() as u32, 1.0);
        }
        let day = self.time.ceil();
        (day as u32, if day == 0.0 { 1.0 } else { (1.0 - (day - self.time)) as f32 })
    }

    /// Wishes a day. A day beside the shown one is glided to, others are jumped to.
    pub fn seek(&mut self, day: u32, newest: Option<u32>) {
        self.wished_day = day;
        self.motion = Motion::Glide;
        let goal = self.goal(newest);
        if self.whole_days || (goal - self.time).abs() > 1.0 {
            self.time = goal;
        }
    }

    /// Begins anew with a plant of which nothing has grown.
    pub fn restart(&mut self, wished_day: u32) {
        self.time = 0.0;
        self.wished_day = wished_day;
        self.motion = Motion::Glide;
    }

    /// Plays on, from the beginning if it stands at the end.
    pub fn play(&mut self, last_day: u32) {
        if self.time >= f64::from(last_day) {
            self.time = 0.0;
        }
        self.motion = Motion::Play;
    }

    /// Plays once from the beginning to the wished day, for who sees it for the first time.
    pub fn premiere(&mut self) {
        self.time = 0.0;
        self.motion = Motion::Premiere;
    }

    /// Ends what plays for the first time on the day that is shown.
    pub fn end_premiere(&mut self) {
        if self.motion == Motion::Premiere {
            self.pause();
        }
    }

    /// Comes to rest on the day that is shown.
    pub fn pause(&mut self) {
        if matches!(self.motion, Motion::Play | Motion::Premiere) {
            self.wished_day = self.day_and_moment().0;
            self.motion = Motion::Glide;
        }
    }

    /// The day that it needs next: the wished one, or where it plays or is held, that of now.
    pub fn needs(&self) -> u32 {
        if self.motion == Motion::Glide { self.wished_day } else { self.time as u32 }
    }

    pub fn is_playing(&self) -> bool {
        matches!(self.motion, Motion::Play | Motion::Premiere | Motion::Scrub { played: true })
    }

    /// Whether it plays without a day that it is to come to rest on.
    pub fn plays_on(&self) -> bool {
        self.is_playing() && self.motion != Motion::Premiere
    }

    /// Whether the visitor's hand is on the time line.
    pub fn is_scrubbed(&self) -> bool {
        matches!(self.motion, Motion::Scrub { .. })
    }

    /// Follows the visitor's hand, to a time in days.
    pub fn scrub(&mut self, time: f64, newest: Option<u32>, last_day: u32) {
        if !matches!(self.motion, Motion::Scrub { .. }) {
            self.motion = Motion::Scrub { played: self.motion == Motion::Play };
        }
        let time = limited(time, 0.0, f64::from(last_day));
        self.wished_day = time.round() as u32;
        self.time = time.min(newest.map_or(0.0, f64::from));
    }

    /// The hand lets go: what played plays on, else the nearest day is wished.
    pub fn let_go(&mut self) {
        if let Motion::Scrub { played } = self.motion {
            self.motion = if played { Motion::Play } else { Motion::Glide };
        }
    }

    /// Whether it moves by itself now, given the newest day that has grown.
    pub fn is_moving(&self, newest: Option<u32>, last_day: u32) -> bool {
        match self.motion {
            Motion::Glide => self.time != self.goal(newest),
            Motion::Premiere => self.time < self.goal(newest),
            Motion::Play => {
                let newest = newest.map_or(0.0, f64::from);
                self.time < newest || newest >= f64::from(last_day)
            }
            Motion::Scrub { .. } => false,
        }
    }

    /// Whether the wished day is shown and nothing will change that.
    pub fn is_at_rest(&self) -> bool {
        self.motion == Motion::Glide && self.time == f64::from(self.wished_day)
    }

    /// Whether it neither plays nor is held: what is wished stays wished.
    pub fn is_settled(&self) -> bool {
        self.motion == Motion::Glide
    }

    /// Moves for a time in seconds.
    pub fn advance(&mut self, seconds: f64, newest: Option<u32>, last_day: u32) {
        match self.motion {
            Motion::Glide => {
                let goal = self.goal(newest);
                let way = goal - self.time;
                let rate = GLIDE_DAYS_PER_S.max(way.abs() / FOLLOW_S);
                let step = rate * seconds;
                let arrives = self.whole_days || way.abs() <= step;
                self.time = if arrives { goal } else { self.time + step.copysign(way) };
            }
            Motion::Play => self.play_on(seconds, newest, last_day),
            Motion::Premiere => {
                let time = self.time + self.speed * DAYS_PER_S * seconds;
                self.time = time.min(self.goal(newest));
                if self.time == f64::from(self.wished_day) {
                    self.motion = Motion::Glide;
                }
            }
            Motion::Scrub { .. } => {}
        }
    }

    fn play_on(&mut self, seconds: f64, newest: Option<u32>, last_day: u32) {
        let end = f64::from(last_day);
        let grown = newest.map_or(0.0, f64::from);
        if self.time >= end && self.looping {
            self.time = 0.0;
            return;
        }
        self.time = (self.time + self.speed * DAYS_PER_S * seconds).min(grown);
        self.wished_day = self.day_and_moment().0;
        if self.time >= end && !self.looping {
            self.wished_day = last_day;
            self.motion = Motion::Glide;
        }
    }

    fn goal(&self, newest: Option<u32>) -> f64 {
        f64::from(self.wished_day.min(newest.unwrap_or(0)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at_rest_on(day: u32) -> Playhead {
        let mut playhead = Playhead::new(0);
        playhead.seek(day, Some(30));
        playhead.advance(10.0, Some(30), 30);
        assert!(playhead.is_at_rest());
        playhead
    }

    #[test]
    fn held_days_are_jumped_to_and_steps_glide() {
        let mut playhead = at_rest_on(20);
        playhead.seek(5, Some(30));
        assert_eq!(playhead.day_and_moment(), (5, 1.0));
        assert!(playhead.is_at_rest());
        playhead.seek(6, Some(30));
        playhead.advance(0.125, Some(30), 30);
        assert_eq!(playhead.day_and_moment(), (6, 0.5));
        playhead.advance(0.2, Some(30), 30);
        assert_eq!(playhead.day_and_moment(), (6, 1.0));
        assert!(!playhead.is_moving(Some(30), 30));
    }

    #[test]
    fn days_to_come_are_followed() {
        let mut playhead = Playhead::new(12);
        assert!(!playhead.is_moving(Some(0), 30));
        for newest in 1..=12 {
            playhead.advance(1.0, Some(newest), 30);
            assert_eq!(playhead.day_and_moment(), (newest, 1.0));
            assert_eq!(playhead.is_at_rest(), newest == 12);
        }
        // Further days do not draw it on.
        playhead.advance(1.0, Some(20), 30);
        assert_eq!(playhead.time(), 12.0);
    }

    #[test]
    fn playing_waits_for_growth_and_ends_or_loops() {
        let mut playhead = at_rest_on(2);
        playhead.speed = 8.0;
        playhead.play(10);
        playhead.advance(1.0, Some(4), 10);
        assert_eq!(playhead.time(), 4.0);
        assert!(!playhead.is_moving(Some(4), 10));
        playhead.advance(1.0, Some(10), 10);
        assert!(playhead.is_at_rest() && !playhead.is_playing());
        playhead.looping = true;
        playhead.play(10);
        assert_eq!(playhead.time(), 0.0);
        for _ in 0..100 {
            playhead.advance(0.1, Some(10), 10);
        }
        assert!(playhead.is_playing());
    }

    #[test]
    fn a_scrub_shows_what_is_under_the_hand_and_then_plays_on() {
        let mut playhead = at_rest_on(2);
        playhead.scrub(7.25, Some(30), 30);
        assert_eq!(playhead.day_and_moment(), (8, 0.25));
        playhead.let_go();
        playhead.advance(1.0, Some(30), 30);
        assert_eq!(playhead.day_and_moment(), (7, 1.0));
        playhead.play(30);
        playhead.scrub(3.0, Some(30), 30);
        assert!(!playhead.is_moving(Some(30), 30));
        playhead.let_go();
        assert!(playhead.is_playing() && playhead.is_moving(Some(30), 30));
        playhead.pause();
        assert_eq!(playhead.wished_day(), 3);
    }

    #[test]
    fn the_first_play_keeps_its_wish_and_ends_there_or_where_it_is_stopped() {
        let mut playhead = Playhead::new(5);
        playhead.premiere();
        playhead.advance(1.5, Some(2), 10);
        assert_eq!((playhead.time(), playhead.wished_day()), (2.0, 5), "it waits for growth");
        assert!(playhead.is_playing() && !playhead.plays_on());
        assert!(!playhead.is_moving(Some(2), 10));
        let mut stopped = playhead.clone();
        stopped.advance(0.25, Some(10), 10);
        stopped.end_premiere();
        stopped.advance(10.0, Some(10), 10);
        assert_eq!((stopped.time(), stopped.wished_day()), (3.0, 3));
        playhead.advance(10.0, Some(10), 10);
        assert!(playhead.is_at_rest() && !playhead.is_playing());
        assert_eq!(playhead.time(), 5.0);
        // What plays by the visitor's will is not stopped.
        playhead.play(10);
        playhead.end_premiere();
        assert!(playhead.is_playing());
    }

    #[test]
    fn less_motion_shows_whole_days() {
        let mut playhead = at_rest_on(2);
        playhead.whole_days = true;
        playhead.seek(3, Some(30));
        assert_eq!(playhead.day_and_moment(), (3, 1.0));
        playhead.play(30);
        playhead.advance(0.3, Some(30), 30);
        assert_eq!(playhead.day_and_moment(), (3, 1.0));
    }
}
