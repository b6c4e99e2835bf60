//! A limb cut into triangles: along its border and its veins, and even ones between them.

use super::Limb;
use crate::shapes::chance::{Purpose, either_way, part_key};
use glam::DVec2;
use spade::handles::FixedVertexHandle;
use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation};

/// Corners of triangles, and the triangles counter-clockwise.
#[derive(Clone, Debug, Default)]
pub struct Flat {
    pub points: Vec<DVec2>,
    pub triangles: Vec<[u32; 3]>,
    /// The first so many points lie on the border.
    pub rim: usize,
}

/// Points of veins that are closer to another one than this share of the spacing are that one.
const ALIKE: f64 = 0.35;

/// Points between veins keep this share of the spacing away from them, so that pieces of veins are sides of
/// triangles.
const APART: f64 = 0.62;

/// Points between veins stray by this share of the spacing: where four lay on a circle, it would be rounding
/// that chooses how they are joined.
const STRAY: f64 = 0.06;

/// Corners closer than this are one, in centimetres.
const ONE_CM: f64 = 1e-5;

/// Cuts a limb, with corners about `spacing_cm` apart, along veins that go from point to point.
pub fn triangulate(limb: &Limb, veins: &[&[DVec2]], spacing_cm: f64) -> Flat {
    let mut points = Points::new(limb, spacing_cm);
    let border = points.add_border(limb);
    let rim = points.all.len();
    let along_veins = points.add_veins(veins, ALIKE * spacing_cm);
    points.fill(limb);
    let (mut flat, border) = cut_along(points.all, rim, border, along_veins);
    split_chords(&mut flat, &border);
    flat
}

/// Cuts a limb along veins with no other corners than those of its border and of the veins.
pub fn coarse(limb: &Limb, veins: &[&[DVec2]]) -> Flat {
    // No side is as long as this.
    let mut points = Points::new(limb, 1e100);
    let border = points.add_border(limb);
    let rim = points.all.len();
    let along_veins = points.add_veins(veins, ONE_CM);
    cut_along(points.all, rim, border, along_veins).0
}

/// The triangles inside the border, and the pieces of that, sorted.
fn cut_along(
    points: Vec<DVec2>,
    rim: usize,
    border: Vec<[usize; 2]>,
    along_veins: Vec<[usize; 2]>,
) -> (Flat, Vec<[usize; 2]>) {
    let places = points.iter().map(|p| Point2::new(p.x, p.y)).collect();
    let mut cut = ConstrainedDelaunayTriangulation::<Point2<f64>>::try_bulk_load_cdt(
        places,
        border,
        |_crossing| {},
    )
    .expect("coordinates of a leaf are finite and apart");
    // As they are in the triangulation, where a corner may lie on another piece of the border.
    let pieces = cut.undirected_edges().filter(|edge| edge.is_constraint_edge());
    let mut border: Vec<[usize; 2]> =
        pieces.map(|edge| edge.vertices().map(|vertex| vertex.index())).collect();
    border.iter_mut().for_each(|ends| ends.sort_unstable());
    border.sort_unstable();
    for ends in along_veins {
        // A vein that crosses the border, between two teeth, is no side of triangles there.
        let [from, to] = ends.map(FixedVertexHandle::from_index);
        cut.try_add_constraint(from, to);
    }
    (Flat { triangles: inside(&cut, &border), points, rim }, border)
}

/// Sides that go from the border to the border through the limb get a corner in their middle, so that an
/// underside that shares the border shares no such side.
fn split_chords(flat: &mut Flat, border: &[[usize; 2]]) {
    let ends = |t: &[u32; 3], k: usize| {
        let [a, b] = [t[k], t[(k + 1) % 3]];
        [a.min(b), a.max(b)]
    };
    let all = flat.triangles.iter().flat_map(|t| [0, 1, 2].map(|k| ends(t, k)));
    let mut chords: Vec<[u32; 2]> = all
        .filter(|ends| (ends[1] as usize) < flat.rim)
        .filter(|ends| border.binary_search(&ends.map(|k| k as usize)).is_err())
        .collect();
    chords.sort_unstable();
    chords.dedup();
    let first = flat.points.len() as u32;
    for ends in &chords {
        let [a, b] = ends.map(|k| flat.points[k as usize]);
        flat.points.push((a + b) / 2.0);
    }
    let middle = |ends: [u32; 2]| chords.binary_search(&ends).ok().map(|k| first + k as u32);
    let mut triangles = Vec::with_capacity(flat.triangles.len());
    for t in &flat.triangles {
        // Sides in the order in which they are cut off: one without a middle last.
        let start = (0..3).find(|&k| middle(ends(t, (k + 2) % 3)).is_none()).unwrap_or(0);
        let mut t = *t;
        t.rotate_left(start);
        let [a, b, c] = t;
        match [0, 1, 2].map(|k| middle(ends(&t, k))) {
            [None, None, None] => triangles.push(t),
            [Some(ab), None, _] => triangles.extend([[a, ab, c], [ab, b, c]]),
            [None, Some(bc), _] => triangles.extend([[a, b, bc], [a, bc, c]]),
            [Some(ab), Some(bc), None] => triangles.extend([[ab, b, bc], [a, ab, bc], [a, bc, c]]),
            [Some(ab), Some(bc), Some(ca)] => {
                triangles.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
            }
            [None, None, Some(_)] => unreachable!("the last side has a middle only if all have"),
        }
    }
    flat.triangles = triangles;
}

/// The triangles that one comes into from outside over an odd number of pieces of the border, sorted.
fn inside(
    cut: &ConstrainedDelaunayTriangulation<Point2<f64>>,
    border: &[[usize; 2]],
) -> Vec<[u32; 3]> {
    let mut seen = vec![false; cut.num_all_faces()];
    let outer = cut.outer_face().fix().index();
    seen[outer] = true;
    let over = |edge: &spade::handles::DirectedEdgeHandle<_, _, _, _>| {
        let mut ends = [edge.from().index(), edge.to().index()];
        ends.sort_unstable();
        border.binary_search(&ends).is_ok()
    };
    let mut waiting = Vec::new();
    for edge in cut.convex_hull() {
        // Either side of the hull is the outer face.
        let other = if edge.face().fix().index() == outer { edge.rev() } else { edge };
        if let Some(face) = other.face().as_inner() {
            waiting.push((face, over(&edge)));
        }
    }
    let mut triangles = Vec::new();
    while let Some((face, is_inside)) = waiting.pop() {
        if std::mem::replace(&mut seen[face.fix().index()], true) {
            continue;
        }
        if is_inside {
            let mut corners = face.vertices().map(|vertex| vertex.index() as u32);
            let first = (0..3).min_by_key(|&k| corners[k]).unwrap_or(0);
            corners.rotate_left(first);
            triangles.push(corners);
        }
        for edge in face.adjacent_edges() {
            if let Some(next) = edge.rev().face().as_inner()
                && !seen[next.fix().index()]
            {
                waiting.push((next, is_inside != over(&edge)));
            }
        }
    }
    triangles.sort_unstable();
    triangles
}

const NONE: u32 = u32::MAX;

/// Points in a grid of cells, so that those near a place are found quickly.
struct Points {
    all: Vec<DVec2>,
    spacing: f64,
    corner: DVec2,
    cell: f64,
    columns: usize,
    /// The last point of each cell, and for each point the one before it in its cell.
    last: Vec<u32>,
    before: Vec<u32>,
}

impl Points {
    fn new(limb: &Limb, spacing: f64) -> Points {
        let border = || limb.outlines.iter().flatten().copied();
        let low = border().fold(DVec2::MAX, DVec2::min);
        let size = border().fold(DVec2::MIN, DVec2::max) - low;
        // Leaves of thin lobes far apart have much nothing around them.
        const MOST_CELLS: f64 = 1e6;
        let cell = spacing.max((size.x * size.y / MOST_CELLS).sqrt());
        let columns = (size.x / cell) as usize + 1;
        let rows = (size.y / cell) as usize + 1;
        let last = vec![NONE; columns * rows];
        Points { all: Vec::new(), spacing, corner: low, cell, columns, last, before: Vec::new() }
    }

    /// Columns and rows of the cells within a distance of a place.
    fn cells(&self, p: DVec2, within: f64) -> [std::ops::RangeInclusive<usize>; 2] {
        let rows = self.last.len() / self.columns;
        let cell = |x: f64, count: usize| ((x / self.cell).max(0.0) as usize).min(count - 1);
        let [low, high] = [p - self.corner - within, p - self.corner + within];
        [
            cell(low.x, self.columns)..=cell(high.x, self.columns),
            cell(low.y, rows)..=cell(high.y, rows),
        ]
    }

    /// The nearest point within a distance.
    fn near(&self, p: DVec2, within: f64) -> Option<u32> {
        let [columns, rows] = self.cells(p, within);
        let mut nearest = None;
        let mut least = within * within;
        for row in rows {
            for column in columns.clone() {
                let mut k = self.last[row * self.columns + column];
                while k != NONE {
                    let square = self.all[k as usize].distance_squared(p);
                    if square < least || square == least && nearest.is_none_or(|other| k < other) {
                        (least, nearest) = (square, Some(k));
                    }
                    k = self.before[k as usize];
                }
            }
        }
        nearest
    }

    fn add(&mut self, p: DVec2) -> usize {
        let [columns, rows] = self.cells(p, 0.0);
        let cell = rows.start() * self.columns + columns.start();
        let number = self.all.len();
        self.before.push(std::mem::replace(&mut self.last[cell], number as u32));
        self.all.push(p);
        number
    }

    /// The outlines of a limb, and the edges along them.
    fn add_border(&mut self, limb: &Limb) -> Vec<[usize; 2]> {
        let mut edges = Vec::new();
        for outline in &limb.outlines {
            let closed: Vec<DVec2> = outline.iter().chain(outline.first()).copied().collect();
            self.add_line(&closed, 0.0, &mut edges);
        }
        edges
    }

    fn add_veins(&mut self, veins: &[&[DVec2]], alike: f64) -> Vec<[usize; 2]> {
        let mut edges = Vec::new();
        veins.iter().for_each(|vein| self.add_line(vein, alike, &mut edges));
        edges
    }

    /// A line with points as far apart as the spacing says, and the edges between them.
    fn add_line(&mut self, path: &[DVec2], alike: f64, edges: &mut Vec<[usize; 2]>) {
        let spacing = self.spacing;
        let mut number = |p: DVec2| match self.near(p, alike) {
            Some(there) => there as usize,
            None => self.add(p),
        };
        let mut from = number(path[0]);
        for ends in path.windows(2) {
            let way = ends[1] - ends[0];
            let pieces = (way.length() / spacing).round().max(1.0);
            for piece in 1..=pieces as u32 {
                let share = f64::from(piece) / pieces;
                // The end itself, without rounding.
                let to = number(if share < 1.0 { ends[0] + way * share } else { ends[1] });
                if to != from {
                    edges.push([from, to]);
                }
                from = to;
            }
        }
    }

    /// Even points wherever there is room inside the border.
    fn fill(&mut self, limb: &Limb) {
        let height = self.spacing * 0.75f64.sqrt();
        let first = (self.corner.y / height).floor();
        let mut rows: Vec<Vec<f64>> = Vec::new();
        for outline in &limb.outlines {
            for (a, b) in outline.iter().zip(outline.iter().cycle().skip(1)) {
                let (low, high) = if a.y < b.y { (a, b) } else { (b, a) };
                let mut row = (low.y / height).ceil();
                // Ends belong to the upper side alone, so that no row passes a corner twice.
                while row * height < high.y {
                    let k = (row - first) as usize;
                    if rows.len() <= k {
                        rows.resize(k + 1, Vec::new());
                    }
                    let share = (row * height - low.y) / (high.y - low.y);
                    rows[k].push(low.x + (high.x - low.x) * share);
                    row += 1.0;
                }
            }
        }
        let apart = APART * self.spacing;
        for (k, mut ends) in rows.into_iter().enumerate() {
            let row = first + k as f64;
            ends.sort_unstable_by(f64::total_cmp);
            let shift = if row.rem_euclid(2.0) == 0.0 { 0.0 } else { 0.5 };
            for pair in ends.chunks_exact(2) {
                let mut column = (pair[0] / self.spacing - shift).ceil();
                while (column + shift) * self.spacing < pair[1] {
                    let key = part_key(row as i64 as u64, column as i64 as u32);
                    let stray = [Purpose::Side, Purpose::Turn].map(|way| either_way(key, way));
                    let even = DVec2::new((column + shift) * self.spacing, row * height);
                    let p = even + DVec2::from(stray) * (STRAY * self.spacing);
                    if self.near(p, apart).is_none() {
                        self.add(p);
                    }
                    column += 1.0;
                }
            }
        }
    }
}
