//! The sheet of a petal from three strokes, in the bud and open.

use super::bspline::{Stroke, control_points, through};
use super::petal::{CrossStroke, PetalNumbers};
use super::sepals::SepalNumbers;
use glam::{DVec2, DVec3};

/// Control points of a sheet across and along.
pub const COLUMNS: usize = 5;
pub const ROWS: usize = 9;

/// How much farther out than the petals sepals lie in the bud, as a share.
const APART: f64 = 0.04;
/// How much lower the foot of sepals lies, as a share of its distance from the axis.
const LOWER: f64 = 0.15;

/// How a petal differs from the others of its flower.
#[derive(Clone, Copy, Debug)]
pub struct Seat {
    pub azimuth: f64,
    /// 0 outermost to 1 innermost; sepals, which are farther out, -1.
    pub rank: f64,
    pub width: f64,
    pub length: f64,
    /// Radians more upright.
    pub turn: f64,
}

/// The sheet of all petals of a kind, and the ways that its vein takes.
#[derive(Clone, Debug)]
pub struct Template {
    /// Row by row from the foot, each from left to right; `x` across, `y` along, `z` up.
    pub flat: Vec<DVec3>,
    length_cm: f64,
    bud: Stroke,
    open: Stroke,
    bud_rad: f64,
    throat: f64,
    lean: f64,
    nest: f64,
    /// Of sepals, how long they are; they are as narrow in the bud as they are flat.
    sepal_cm: Option<f64>,
}

/// From -1 at the left rim to 1 at the right.
pub fn across(column: usize) -> f64 {
    2.0 * column as f64 / (COLUMNS - 1) as f64 - 1.0
}

impl Template {
    pub fn new(numbers: &PetalNumbers) -> Template {
        let [left, vein, right] =
            [&numbers.left_cm, &numbers.vein_cm, &numbers.right_cm].map(|line| Stroke::new(line));
        let mut flat = Vec::with_capacity(ROWS * COLUMNS);
        for row in 0..ROWS {
            let along = row as f64 / (ROWS - 1) as f64;
            let middle = vein.share(along);
            for column in 0..COLUMNS {
                let x = across(column);
                let edge = if x < 0.0 { &left } else { &right };
                let p = middle + (edge.share(along) - middle) * x.abs();
                flat.push(p.extend(lift(numbers, x, along)));
            }
        }
        Template {
            flat,
            length_cm: vein.share(1.0).y,
            bud: Stroke::new(&numbers.bud_cm),
            open: Stroke::new(&numbers.open_cm),
            bud_rad: numbers.bud_deg.to_radians(),
            throat: numbers.throat,
            lean: numbers.lean,
            nest: numbers.nest,
            sepal_cm: None,
        }
    }

    /// Sepals around the petals of a template: their vein goes along that of the petals, outside it.
    pub fn around(&self, sepals: &SepalNumbers) -> Template {
        let room = std::f64::consts::PI / f64::from(sepals.count);
        let apart = APART + self.lean.abs();
        let widest = (0..=ROWS)
            .map(|row| row as f64 / ROWS as f64 * sepals.length * self.bud.length_cm())
            .map(|way| self.bud.at(way).0.x * (1.0 + apart))
            .fold(0.0, f64::max);
        let half = sepals.width * room * widest;
        let points = (0..ROWS * COLUMNS).map(|k| {
            let along = (k / COLUMNS) as f64 / (ROWS - 1) as f64;
            let x = across(k % COLUMNS) * half * SepalNumbers::form(along);
            DVec3::new(x, along * sepals.length * self.length_cm, 0.0)
        });
        Template {
            flat: points.collect(),
            bud_rad: 0.98 * room,
            lean: 0.0,
            nest: apart,
            sepal_cm: Some(sepals.length * self.length_cm),
            ..self.clone()
        }
    }

    /// Its width at a share of its length, in lengths.
    pub fn slenderness(&self, along: f64) -> f64 {
        let way = along * (ROWS - 1) as f64;
        let row = (way as usize).min(ROWS - 2);
        let width = |row: usize| {
            self.flat[row * COLUMNS]
                .truncate()
                .distance(self.flat[row * COLUMNS + COLUMNS - 1].truncate())
        };
        let part = way - row as f64;
        (width(row) * (1.0 - part) + width(row + 1) * part) / self.length_cm
    }

    /// The sheet in the bud: rolled round the axis of the flower. All buds are one form in different sizes, the
    /// inner ones smaller, and so none cuts another.
    pub fn in_bud(&self, seat: &Seat) -> Vec<DVec3> {
        self.placed(|x, p| {
            let vein = self.bud.at(p.y / self.length_cm * self.bud.length_cm()).0;
            let vein = vein * self.size(seat, x);
            let angle = match self.sepal_cm {
                Some(_) => (p.x / vein.x.max(1e-3)).clamp(-self.bud_rad, self.bud_rad),
                None => x * self.bud_rad,
            };
            round(seat.azimuth + angle, vein - self.lower(p.y))
        })
    }

    /// The sheet of the open flower: round the axis in the throat, and flat but for its lift beyond.
    pub fn opened(&self, seat: &Seat) -> Vec<DVec3> {
        let foot = self.open.start();
        let scale = self.length_cm * seat.length / self.open.length_cm();
        let (sin, cos) = (libm::sin(seat.turn), libm::cos(seat.turn));
        let turn = |p: DVec2| DVec2::new(p.x * cos - p.y * sin, p.y * cos + p.x * sin);
        let outward = round(seat.azimuth, DVec2::X);
        let side = DVec3::new(-outward.z, 0.0, outward.x);
        self.placed(|x, p| {
            let (point, along) = self.open.at(p.y * seat.length / scale);
            let along = turn(along);
            let vein = foot * self.size(seat, 0.0) - self.lower(p.y)
                + turn(point - foot) * scale
                + DVec2::new(-along.y, along.x) * (p.z * seat.width);
            let width = p.x * seat.width;
            let straight = round(seat.azimuth, vein) + side * width;
            let bent = self.bent(p.y / self.length_cm);
            if bent == 0.0 {
                return straight;
            }
            let angle = (width / vein.x.max(1e-3)).clamp(-self.bud_rad, self.bud_rad);
            let lean = self.size(seat, x) / self.size(seat, 0.0);
            straight.lerp(round(seat.azimuth + angle, vein * DVec2::new(lean, 1.0)), bent)
        })
    }

    /// How much lower than petals sepals lie there: below the foot of petals that lean out.
    fn lower(&self, along_cm: f64) -> DVec2 {
        let above = self.sepal_cm.map_or(0.0, |length| (1.0 - along_cm / length).max(0.0));
        DVec2::Y * (LOWER * self.bud.start().x * above * above)
    }

    /// What the bud of a petal is, as a share of the outermost one's.
    fn size(&self, seat: &Seat, x: f64) -> f64 {
        (1.0 - self.nest * seat.rank) * (1.0 + self.lean * x)
    }

    /// How far the open petal follows the circle round the axis: 1 at its foot, 0 beyond the throat.
    fn bent(&self, along: f64) -> f64 {
        if along >= self.throat {
            return 0.0;
        }
        let t = (along / self.throat).max(0.0);
        1.0 - t * t * (3.0 - 2.0 * t)
    }

    fn placed(&self, place: impl Fn(f64, DVec3) -> DVec3) -> Vec<DVec3> {
        let points = self.flat.iter().enumerate();
        through_points(points.map(|(k, &p)| place(across(k % COLUMNS), p)).collect())
    }
}

/// The control points of the sheet that goes through these points.
fn through_points(mut sheet: Vec<DVec3>) -> Vec<DVec3> {
    sheet.chunks_mut(COLUMNS).for_each(control_points);
    for column in 0..COLUMNS {
        let mut points: Vec<DVec3> = sheet[column..].iter().step_by(COLUMNS).copied().collect();
        control_points(&mut points);
        sheet[column..].iter_mut().step_by(COLUMNS).zip(points).for_each(|(p, new)| *p = new);
    }
    sheet
}

/// The lift of the flat petal: a spline along each column through all cross strokes, and the waves of the rim.
fn lift(numbers: &PetalNumbers, x: f64, along: f64) -> f64 {
    let knot = |stroke: &CrossStroke| (nearest(stroke.at), between(&stroke.lift_cm, x));
    let mut knots: Vec<(f64, f64)> = numbers.cross.iter().map(knot).collect();
    for end in [0.0, 1.0] {
        if knots.iter().all(|knot| knot.0 != end) {
            knots.push((end, 0.0));
        }
    }
    knots.sort_by(|a, b| a.0.total_cmp(&b.0));
    let wave = libm::sin(std::f64::consts::TAU * numbers.waves * along);
    through(&knots, along) + numbers.wave_cm * x * x * wave
}

/// The row of control points that a stroke lifts, as a share of the way.
pub fn nearest(at: f64) -> f64 {
    libm::round(at * (ROWS - 1) as f64) / (ROWS - 1) as f64
}

/// The height of a drawn line at a place across, straight between its points.
fn between(line: &[[f64; 2]], x: f64) -> f64 {
    let next = line.partition_point(|point| point[0] <= x).clamp(1, line.len() - 1);
    let ([x0, y0], [x1, y1]) = (line[next - 1], line[next]);
    y0 + (y1 - y0) * ((x - x0) / (x1 - x0)).clamp(0.0, 1.0)
}

/// A point at an angle round the axis, by its distance from it and its height.
pub fn round(azimuth: f64, at: DVec2) -> DVec3 {
    DVec3::new(at.x * libm::cos(azimuth), at.y, at.x * libm::sin(azimuth))
}
