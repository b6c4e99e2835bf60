//! A body without its cells, drawn at once into pixels: what is seen of a shape while its numbers change.

use crate::plants::{Look, Plant};
use crate::surface::PolygonMesh;
use glam::{Vec2, Vec3};

/// From where a body is looked at, and how large the picture is.
#[derive(Clone, Copy, Debug)]
pub struct SketchView {
    pub size_px: [usize; 2],
    /// Degrees around the upright axis, and above the horizon.
    pub azimuth_deg: f32,
    pub elevation_deg: f32,
    /// Of a body that moves, the share of its days, 0 to 1.
    pub time: f32,
}

/// Pixels are means of so many times so many.
const FINER: usize = 2;
/// Share of the picture that stays free at each side.
const MARGIN: f32 = 0.05;
/// Towards the light, from the eye.
const LIGHT: Vec3 = Vec3::new(-0.38, 0.55, 0.74);
/// What is turned away from the light has this share of it.
const SHADE: f32 = 0.45;

/// Draws a body as RGBA, row by row from the top; what is beside it lets everything through.
pub fn sketch(mesh: &PolygonMesh, plant: &Plant, view: SketchView) -> Vec<u8> {
    let then = (view.time * (mesh.moments.len() as f32 - 1.0)).max(0.0) as usize;
    let positions = match mesh.moments.get(then) {
        Some(moment) if view.time < 1.0 => &moment.positions,
        _ => &mesh.positions,
    };
    let [width, height] = view.size_px.map(|side| side * FINER);
    let mut canvas = Canvas::new(width, height);
    let seen = turned(positions, view);
    // All moments fit: a bud is seen small.
    let fit = fit(&turned(&mesh.positions, view), mesh, [width as f32, height as f32]);
    let seen: Vec<Vec3> = seen.into_iter().map(|p| fit.place(p)).collect();
    let normals = normals(mesh, &seen);
    for face in &mesh.faces {
        let colour = colour_of(&plant.look, &mesh.groups[face.group as usize].material);
        let [first, rest @ ..] = &face.vertices[..] else { continue };
        for pair in rest.windows(2) {
            canvas.triangle(
                [*first, pair[0], pair[1]].map(|k| (seen[k as usize], normals[k as usize])),
                colour,
            );
        }
    }
    canvas.smaller()
}

/// How large a body is, and how many faces it has, in a few words.
pub fn told_of(mesh: &PolygonMesh) -> String {
    let corners = || mesh.faces.iter().flat_map(|face| &face.vertices);
    let places = || corners().map(|&k| mesh.positions[k as usize]);
    let size = places().fold(Vec3::MIN, Vec3::max) - places().fold(Vec3::MAX, Vec3::min);
    let [wide, high, deep] = size.to_array().map(|cm| (10.0 * cm).round() / 10.0);
    format!("{wide} cm wide, {high} cm high and {deep} cm deep, {} faces", mesh.faces.len())
}

/// The colour of a material in sRGB: that of B cells where cells grow.
fn colour_of(look: &Look, material: &str) -> [f32; 3] {
    match material.strip_prefix("bare:") {
        Some(material) => look.of_bare(material).0,
        None => look.cells[1],
    }
}

/// `x` to the right, `y` up and `z` towards the eye.
fn turned(positions: &[Vec3], view: SketchView) -> Vec<Vec3> {
    let [around, above] =
        [view.azimuth_deg, view.elevation_deg].map(|degrees: f32| degrees.to_radians());
    let (sin, cos) = (libm::sinf(around), libm::cosf(around));
    let (up_sin, up_cos) = (libm::sinf(above), libm::cosf(above));
    let turn = |p: &Vec3| {
        let (x, z) = (p.x * cos - p.z * sin, p.x * sin + p.z * cos);
        Vec3::new(x, p.y * up_cos - z * up_sin, p.y * up_sin + z * up_cos)
    };
    positions.iter().map(turn).collect()
}

/// From centimetres to pixels.
struct Fit {
    middle: Vec2,
    scale: f32,
    size: Vec2,
}

impl Fit {
    fn place(&self, p: Vec3) -> Vec3 {
        let at = (p.truncate() - self.middle) * self.scale;
        Vec3::new(0.5 * self.size.x + at.x, 0.5 * self.size.y - at.y, p.z * self.scale)
    }
}

fn fit(seen: &[Vec3], mesh: &PolygonMesh, size: [f32; 2]) -> Fit {
    let corners = || mesh.faces.iter().flat_map(|face| &face.vertices).map(|&k| seen[k as usize]);
    let low = corners().fold(Vec3::MAX, Vec3::min).truncate();
    let high = corners().fold(Vec3::MIN, Vec3::max).truncate();
    let size = Vec2::from(size);
    let share = (high - low).max(Vec2::splat(1e-6)) / size;
    Fit { middle: (low + high) / 2.0, scale: (1.0 - 2.0 * MARGIN) / share.max_element(), size }
}

/// Of each corner, in the picture; the longer, the larger its faces.
fn normals(mesh: &PolygonMesh, seen: &[Vec3]) -> Vec<Vec3> {
    let mut normals = vec![Vec3::ZERO; seen.len()];
    for face in &mesh.faces {
        let [first, rest @ ..] = &face.vertices[..] else { continue };
        for pair in rest.windows(2) {
            let [a, b, c] = [*first, pair[0], pair[1]].map(|k| seen[k as usize]);
            let normal = (b - a).cross(c - a);
            face.vertices.iter().for_each(|&k| normals[k as usize] += normal);
        }
    }
    // The picture's `y` goes down, so that all are turned over; both sides of a sheet are seen alike.
    let towards_eye = |n: Vec3| {
        let n = Vec3::new(n.x, -n.y, n.z).normalize_or_zero();
        if n.z < 0.0 { -n } else { n }
    };
    normals.into_iter().map(towards_eye).collect()
}

struct Canvas {
    width: usize,
    height: usize,
    /// How near to the eye what is seen at a pixel lies; nothing is infinitely far.
    near: Vec<f32>,
    colours: Vec<[u8; 3]>,
}

impl Canvas {
    fn new(width: usize, height: usize) -> Canvas {
        let count = width * height;
        Canvas { width, height, near: vec![f32::NEG_INFINITY; count], colours: vec![[0; 3]; count] }
    }

    /// Fills what of a triangle is nearer than all that is there.
    fn triangle(&mut self, corners: [(Vec3, Vec3); 3], colour: [f32; 3]) {
        let [a, b, c] = corners.map(|(at, _)| at.truncate());
        let area = (b - a).perp_dot(c - a);
        if area == 0.0 {
            return;
        }
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        let rows = low.y.max(0.0) as usize..=(high.y.max(0.0) as usize).min(self.height - 1);
        for row in rows {
            let columns = low.x.max(0.0) as usize..=(high.x.max(0.0) as usize).min(self.width - 1);
            for column in columns {
                let p = Vec2::new(column as f32 + 0.5, row as f32 + 0.5);
                let shares =
                    [(b - p).perp_dot(c - p), (c - p).perp_dot(a - p), (a - p).perp_dot(b - p)]
                        .map(|share| share / area);
                if shares.iter().any(|share| *share < 0.0) {
                    continue;
                }
                let sum = |of: fn(&(Vec3, Vec3)) -> Vec3| {
                    corners
                        .iter()
                        .zip(shares)
                        .map(|(corner, share)| of(corner) * share)
                        .sum::<Vec3>()
                };
                let near = sum(|corner| corner.0).z;
                let k = row * self.width + column;
                if near > self.near[k] {
                    let lit = sum(|corner| corner.1).normalize_or_zero().dot(LIGHT).max(0.0);
                    let light = SHADE + (1.0 - SHADE) * lit;
                    self.near[k] = near;
                    self.colours[k] = colour.map(|c| (255.0 * (c * light * 1.15).min(1.0)) as u8);
                }
            }
        }
    }

    /// The picture with its pixels, which are means.
    fn smaller(&self) -> Vec<u8> {
        let mut pixels = Vec::with_capacity(4 * self.near.len() / FINER / FINER);
        for row in (0..self.height).step_by(FINER) {
            for column in (0..self.width).step_by(FINER) {
                let mut sum = [0u32; 3];
                let mut count = 0;
                for k in 0..FINER * FINER {
                    let at = (row + k / FINER) * self.width + column + k % FINER;
                    if self.near[at] > f32::NEG_INFINITY {
                        count += 1;
                        sum.iter_mut()
                            .zip(self.colours[at])
                            .for_each(|(sum, c)| *sum += u32::from(c));
                    }
                }
                pixels.extend(sum.map(|sum| sum.checked_div(count).unwrap_or(0) as u8));
                pixels.push((255 * count / (FINER * FINER) as u32) as u8);
            }
        }
        pixels
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants;
    use crate::surface::{Face, Group};

    #[test]
    fn the_nearer_of_two_squares_is_seen_and_nothing_beside_them() {
        let square = |x: f32, z: f32| {
            [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
                .map(|[u, v]| Vec3::new(x + u, v, z))
        };
        let group = |material: &str| Group { part: String::new(), material: material.into() };
        let mesh = PolygonMesh {
            positions: [square(0.0, 0.0), square(1.0, 1.0)].concat(),
            faces: vec![
                Face { vertices: vec![0, 1, 2, 3], group: 0 },
                Face { vertices: vec![4, 5, 6, 7], group: 1 },
            ],
            groups: vec![group("blade"), group("bare:petiole")],
            ..PolygonMesh::default()
        };
        let plant = plants::find("croton").unwrap();
        let view =
            SketchView { size_px: [60, 60], azimuth_deg: 0.0, elevation_deg: 0.0, time: 1.0 };
        let at = |pixels: &[u8], x: usize, y: usize| -> [u8; 4] {
            pixels[4 * (60 * y + x)..][..4].try_into().unwrap()
        };
        assert_eq!(told_of(&mesh), "3 cm wide, 2 cm high and 1 cm deep, 2 faces");
        let pixels = sketch(&mesh, plant, view);
        assert_eq!(pixels.len(), 60 * 60 * 4);
        assert_eq!(at(&pixels, 30, 1)[3], 0, "it is wider than high");
        let (blade, petiole) = (at(&pixels, 10, 30), at(&pixels, 40, 30));
        assert_eq!((blade[3], petiole[3]), (255, 255));
        assert!(blade[1] > blade[0] && petiole[0] > 2 * blade[0], "{blade:?} {petiole:?}");
        // From behind the other one covers it.
        let pixels = sketch(&mesh, plant, SketchView { azimuth_deg: 180.0, ..view });
        assert_eq!(at(&pixels, 30, 30)[0], blade[0]);
        assert!(at(&pixels, 10, 30)[0] > 2 * blade[0]);
    }
}
