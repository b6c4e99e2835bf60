//! A body that moves: where its corners are on some days, and straight ways between them. The triangles and
//! what is joined to what stay the same, so that a cell keeps its triangle and its barycentric coordinates.

use super::mesh::has_area;
use super::{Body, Frame, Mesh};
use glam::Vec3;
use std::borrow::Cow;
use std::sync::Arc;

/// Where all corners are on a day.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    /// Days since day 0; finite.
    pub day: f32,
    pub positions: Vec<Vec3>,
}

/// The ways of the corners of a body, or of a part of it. One without moments stands still.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Motion {
    moments: Arc<[Moment]>,
}

impl Motion {
    /// `moments`: in the order of their days, all of the same number of corners.
    pub fn new(moments: Vec<Moment>) -> Motion {
        Motion { moments: moments.into() }
    }

    /// Whether the corners never move.
    pub fn is_still(&self) -> bool {
        self.moments.is_empty()
    }

    /// The same ways for some of the corners, by their numbers.
    pub(super) fn of(&self, corners: &[u32]) -> Motion {
        let some = |moment: &Moment| Moment {
            day: moment.day,
            positions: corners.iter().map(|&v| moment.positions[v as usize]).collect(),
        };
        Motion { moments: self.moments.iter().map(some).collect() }
    }

    /// Where the corners are on a day: between two moments on the straight ways from the first to the second,
    /// before the first and after the last as they are then. None where they never move.
    pub fn on(&self, day: f32) -> Option<Vec<Vec3>> {
        let after = self.moments.partition_point(|moment| moment.day <= day);
        let next = self.moments.get(after);
        let Some(last) = after.checked_sub(1).map(|k| &self.moments[k]) else {
            return next.map(|first| first.positions.clone());
        };
        let Some(next) = next else { return Some(last.positions.clone()) };
        let share = (day - last.day) / (next.day - last.day);
        let ways = last.positions.iter().zip(&next.positions);
        Some(ways.map(|(&from, &to)| from + (to - from) * share).collect())
    }

    pub fn moments(&self) -> &[Moment] {
        &self.moments
    }
}

impl Body {
    /// A body that is so many times larger along x, y and z, from the origin, on these days; between them it
    /// grows evenly. Of moments that it had before nothing is left. Without any days it is left as it is.
    pub fn stretched(mut self, sizes: &[(f32, Vec3)]) -> Body {
        if sizes.is_empty() {
            return self;
        }
        let motion = |positions: &[Vec3]| {
            let stretch = |&(day, factors): &(f32, Vec3)| Moment {
                day,
                positions: positions.iter().map(|&p| p * factors).collect(),
            };
            Motion::new(sizes.iter().map(stretch).collect())
        };
        self.surface.motion = motion(&self.surface.positions);
        for part in &mut self.ornaments {
            part.motion = motion(&part.positions);
        }
        self
    }
}

impl Mesh {
    /// The mesh as it stands on a day: the same triangles, parts and neighbours, and where it moves, corners
    /// elsewhere.
    pub fn on(&self, day: u32) -> Cow<'_, Mesh> {
        let Some(positions) = self.motion.on(day as f32) else { return Cow::Borrowed(self) };
        let mut moved = Mesh { positions, motion: Motion::default(), ..self.clone() };
        moved.measure();
        Cow::Owned(moved)
    }

    /// How many times larger another mesh of the same triangles is, if it is of the same shape to the last
    /// digits that an f32 has.
    pub fn scale_to(&self, other: &Mesh) -> Option<f32> {
        const DIGITS: f32 = 2e-6;
        let scale = other.frames.first()?.length / self.frames.first()?.length;
        let fits = |from: &Frame, to: &Frame| {
            let longest = to.length.max(to.apex.x.abs()).max(to.apex.y);
            let off = (from.apex * scale - to.apex).abs();
            off.max_element().max((from.length * scale - to.length).abs()) <= DIGITS * longest
        };
        self.frames.iter().zip(&other.frames).all(|(from, to)| fits(from, to)).then_some(scale)
    }

    /// Whether a triangle has lost its area at some moment; that one's day.
    pub(super) fn flattened(&self) -> Option<f32> {
        let flat = |positions: &[Vec3]| !self.triangles.iter().all(|t| has_area(positions, t));
        self.motion.moments().iter().find(|moment| flat(&moment.positions)).map(|moment| moment.day)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_go_straight_from_moment_to_moment_and_rest_outside() {
        let moment = |day, x| Moment { day, positions: vec![Vec3::new(x, 0.0, 1.0), Vec3::Y * x] };
        let motion = Motion::new(vec![moment(2.0, 1.0), moment(4.0, 3.0), moment(12.0, -1.0)]);
        for (day, x) in [
            (0.0, 1.0),
            (2.0, 1.0),
            (3.0, 2.0),
            (4.0, 3.0),
            (10.0, 0.0),
            (12.0, -1.0),
            (99.0, -1.0),
        ] {
            assert_eq!(motion.on(day).unwrap(), moment(day, x).positions, "day {day}");
        }
        assert_eq!(motion.of(&[1]).on(3.0).unwrap(), [Vec3::Y * 2.0]);
        assert!(Motion::default().is_still() && Motion::default().on(1.0).is_none());
    }
}
