//! Uniform cubic B-splines through the ends of their control points, as curves and as the sum that a sheet
//! takes across and along.

use glam::{DVec2, DVec3};
use std::ops::{Add, Mul};

/// Of four control points in a row, the first of which is `first`; they sum to 1.
#[derive(Clone, Copy, Debug)]
pub struct Weights {
    pub first: usize,
    pub of: [f64; 4],
}

impl Weights {
    /// At a share, 0 to 1, of the way along `count` control points, at least 4. Beyond each end stands a point as
    /// far out as its neighbour is in, so that the curve begins and ends in control points, straight.
    pub fn at(count: usize, share: f64) -> Weights {
        let spans = (count - 1) as f64;
        let way = (share * spans).clamp(0.0, spans);
        let span = (way as usize).min(count - 2);
        let t = way - span as f64;
        let s = 1.0 - t;
        let [a, b, c, d] =
            [s * s * s, (3.0 * t - 6.0) * t * t + 4.0, (3.0 * s - 6.0) * s * s + 4.0, t * t * t]
                .map(|w| w / 6.0);
        if span == 0 {
            Weights { first: 0, of: [2.0 * a + b, c - a, d, 0.0] }
        } else if span == count - 2 {
            Weights { first: count - 4, of: [0.0, a, b - d, c + 2.0 * d] }
        } else {
            Weights { first: span - 1, of: [a, b, c, d] }
        }
    }

    /// Their sum of control points.
    pub fn sum<T>(&self, control: impl Fn(usize) -> T) -> T
    where
        T: Copy + Mul<f64, Output = T> + Add<Output = T>,
    {
        let [a, b, c, d] = self.of;
        let at = |k: usize| control(self.first + k);
        at(0) * a + at(1) * b + at(2) * c + at(3) * d
    }
}

/// Turns points into the control points of a spline that goes through them, evenly timed; at least 3.
pub fn control_points(points: &mut [DVec3]) {
    let last = points.len() - 1;
    // (before + 4 control + behind) / 6 = point, from one end to the other and back; both ends stay.
    let mut shares = vec![0.0; last];
    for k in 1..last {
        let whole = 4.0 - shares[k - 1];
        shares[k] = 1.0 / whole;
        points[k] = (points[k] * 6.0 - points[k - 1]) / whole;
    }
    for k in (1..last).rev() {
        let behind = points[k + 1];
        points[k] -= behind * shares[k];
    }
}

/// A drawn line of 2 points or more, smoothed: it is the control polygon of a spline, which is measured.
#[derive(Clone, Debug)]
pub struct Stroke {
    points: Vec<DVec2>,
    /// The way up to each of them, in centimetres.
    ways: Vec<f64>,
}

/// Pieces of a measured stroke: fine enough for a millimetre on a petal of any size.
const PIECES: usize = 256;

impl Stroke {
    pub fn new(line: &[[f64; 2]]) -> Stroke {
        let mut control: Vec<DVec2> = line.iter().map(|&p| DVec2::from(p)).collect();
        while control.len() < 4 {
            let middles = control.windows(2).flat_map(|ends| [ends[0], ends[0].midpoint(ends[1])]);
            let last = control[control.len() - 1];
            control = middles.chain([last]).collect();
        }
        let at = |k: usize| {
            Weights::at(control.len(), k as f64 / PIECES as f64).sum(|point| control[point])
        };
        let points: Vec<DVec2> = (0..=PIECES).map(at).collect();
        let mut way = 0.0;
        let further = points.windows(2).map(|ends| {
            way += ends[0].distance(ends[1]);
            way
        });
        let ways = [0.0].into_iter().chain(further).collect();
        Stroke { points, ways }
    }

    pub fn length_cm(&self) -> f64 {
        self.ways[PIECES]
    }

    pub fn start(&self) -> DVec2 {
        self.points[0]
    }

    /// The point so far along, and the direction there; straight on beyond both ends.
    pub fn at(&self, cm: f64) -> (DVec2, DVec2) {
        let piece = self.ways.partition_point(|&way| way <= cm).clamp(1, PIECES) - 1;
        let length = self.ways[piece + 1] - self.ways[piece];
        let share = if length > 0.0 { (cm - self.ways[piece]) / length } else { 0.0 };
        let point = self.points[piece] + (self.points[piece + 1] - self.points[piece]) * share;
        // Between those at both ends of the piece, so that it turns evenly.
        let around = |k: usize| self.points[(k + 1).min(PIECES)] - self.points[k.saturating_sub(1)];
        let inside = share.clamp(0.0, 1.0);
        let direction = around(piece) * (1.0 - inside) + around(piece + 1) * inside;
        (point, direction.normalize_or(DVec2::Y))
    }

    /// The point at a share of the way, 0 to 1.
    pub fn share(&self, share: f64) -> DVec2 {
        self.at(share * self.length_cm()).0
    }
}

/// The cubic through values at growing places, straight at both ends (a natural spline). Beyond them it stays.
pub fn through(knots: &[(f64, f64)], x: f64) -> f64 {
    let last = knots.len() - 1;
    if x <= knots[0].0 || last == 0 {
        return knots[0].1;
    }
    if x >= knots[last].0 {
        return knots[last].1;
    }
    // Bends at the inner knots: a tridiagonal system, solved from one end to the other and back.
    let step = |k: usize| knots[k + 1].0 - knots[k].0;
    let slope = |k: usize| (knots[k + 1].1 - knots[k].1) / step(k);
    let mut rows = vec![(0.0, 0.0); last + 1];
    for k in 1..last {
        let (before, bend) = rows[k - 1];
        let middle = 2.0 * (step(k - 1) + step(k)) - step(k - 1) * before;
        let right = 6.0 * (slope(k) - slope(k - 1)) - step(k - 1) * bend;
        rows[k] = (step(k) / middle, right / middle);
    }
    let mut bends = vec![0.0; last + 1];
    for k in (1..last).rev() {
        bends[k] = rows[k].1 - rows[k].0 * bends[k + 1];
    }
    let k = (knots.partition_point(|knot| knot.0 <= x) - 1).min(last - 1);
    let h = step(k);
    let (a, b) = ((knots[k + 1].0 - x) / h, (x - knots[k].0) / h);
    a * knots[k].1
        + b * knots[k + 1].1
        + ((a * a * a - a) * bends[k] + (b * b * b - b) * bends[k + 1]) * h * h / 6.0
}
