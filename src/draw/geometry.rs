//! A body as the corners that the graphics card draws.

use super::occlusion::{Shade, Sky, Skylight, sample_spacing};
use super::scene::{BARE_MATERIALS, key_direction};
use crate::surface::{Body, Mesh};
use bytemuck::{Pod, Zeroable};
use glam::{Vec2, Vec3, Vec4};

/// A corner of a triangle: `Corner` in `scene.wgsl`.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Corner {
    pub position: Vec3,
    /// The unit normal, and the share of the sky that its side sees: 1 is `i16::MAX`.
    pub normal: [i16; 4],
    /// The mean direction of the sky that this side sees, and the share that the other one sees: 1 is
    /// `i8::MAX`.
    pub bent: [i8; 4],
    pub uv: Vec2,
    /// In the triangle's plane, from its centroid, in centimetres.
    pub plane: Vec2,
    /// Number of the triangle; in a bare part, of its material.
    pub number: u32,
}

/// A corner of the ground disc: `vs_ground` in `ground.wgsl`.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct GroundCorner {
    /// From the centre, in radii of the disc.
    pub out: Vec2,
    /// Shares of the sky and of the key light that the body takes away, and how near that is which takes
    /// the latter: 1 at the foot, 0 where its shadow has no edge.
    pub darkness: Vec3,
}

/// A sphere around a body, and its ground.
#[derive(Clone, Copy, Debug)]
pub struct Bounds {
    pub centre: Vec3,
    pub radius: f32,
    pub lowest: f32,
}

/// Everything of a body that is drawn.
pub struct Geometry {
    /// Three corners a triangle: first those of the surface, then those of the bare parts.
    pub corners: Vec<Corner>,
    /// The places and normals of the same corners the day before, if they move; else nothing.
    pub before: Vec<Corner>,
    pub surface_corners: u32,
    pub ground: Vec<GroundCorner>,
    pub ground_triangles: Vec<[u32; 3]>,
    pub bounds: Bounds,
    /// The names of the bare materials, by their numbers.
    pub materials: Vec<String>,
}

/// Radius of the ground disc, in radii of the body.
const GROUND_RADII: f32 = 2.4;
const GROUND_RINGS: u32 = 56;
const GROUND_SECTORS: u32 = 96;

/// How far above the ground, in radii of the body, that stands whose shadow has no edge any more.
const SOFT_RADII: f32 = 0.6;

/// The names of the bare materials of a body; what comes after the last place shares the first.
fn materials(body: &Body) -> Vec<&str> {
    let mut names: Vec<&str> = body.ornaments.iter().map(|part| part.material.as_str()).collect();
    names.sort_unstable();
    names.dedup();
    names.truncate(BARE_MATERIALS);
    names
}

impl Geometry {
    /// Takes a body apart. That takes twenty milliseconds for 20,000 triangles, most of them for how much
    /// of the sky each corner sees: once for each plant.
    pub fn new(body: &Body) -> Geometry {
        Geometry::within(Bounds::of(body), body)
    }

    /// The same of a body that moves, as it stands on a day and the day before.
    pub fn on(body: &Body, day: u32) -> Geometry {
        let bare = Skylight { front: 0.0, back: 0.0, bent: Vec3::Y };
        let unlit = |positions: &[Vec3], _: &[Vec3]| vec![bare; positions.len()];
        let before = corners(&body.on(day.saturating_sub(1)), unlit);
        Geometry { before, ..Geometry::within(Bounds::of(body), &body.on(day)) }
    }

    fn within(bounds: Bounds, body: &Body) -> Geometry {
        let casters = casters(body, sample_spacing(bounds.radius));
        let shade = Shade::new(casters.into_iter(), bounds.centre, bounds.radius * 1.01);
        let sky = shade.sky();
        let corners = corners(body, |positions, normals| skylights(&sky, positions, normals));
        let surface_corners = 3 * body.surface.triangles.len() as u32;
        let (ground, ground_triangles) = ground(&shade, &sky, &bounds);
        let materials = materials(body).into_iter().map(String::from).collect();
        let before = Vec::new();
        Geometry { corners, before, surface_corners, ground, ground_triangles, bounds, materials }
    }
}

impl Bounds {
    fn of(body: &Body) -> Bounds {
        let (centre, radius, lowest) = body.ball();
        Bounds { centre, radius, lowest }
    }

    /// Centre of the ground disc and its radius. The ground is the plane y = 0, or lies just under
    /// a body that reaches deeper.
    pub fn ground(&self) -> Vec4 {
        Vec3::new(self.centre.x, self.lowest.min(0.0), self.centre.z)
            .extend(self.radius * GROUND_RADII)
    }
}

/// How far side veins that leave the midrib at 60 degrees run towards the tip while they cross
/// from midrib to rim, in leaf coordinates; 0 without them.
pub fn vein_lean(mesh: &Mesh) -> f32 {
    if mesh.uvs.is_empty() {
        return 0.0;
    }
    // Centimetres per leaf coordinate, across and along, as the mean over the blade's area.
    let mut lengths = Vec2::ZERO;
    for (t, &area) in mesh.triangles.iter().zip(&mesh.areas) {
        let [a, b, c] = t.map(|v| mesh.positions[v as usize]);
        let [ua, ub, uc] = t.map(|v| mesh.uvs[v as usize]);
        let (eb, ec) = (ub - ua, uc - ua);
        let turn = eb.perp_dot(ec);
        if turn.abs() > 1e-12 {
            let across = ((b - a) * ec.y - (c - a) * eb.y) / turn;
            let along = ((c - a) * eb.x - (b - a) * ec.x) / turn;
            lengths += Vec2::new(across.length(), along.length()) * area;
        }
    }
    const TAN_60: f32 = 1.732_050_8;
    if lengths.y > 0.0 { lengths.x / (lengths.y * TAN_60) } else { 0.0 }
}

impl Corner {
    /// A corner that has no place in a plane yet.
    fn new(position: Vec3, normal: Vec3, light: &Skylight) -> Corner {
        let normal = normal.extend(light.front).to_array();
        let bent = light.bent.extend(light.back).to_array();
        Corner {
            position,
            normal: normal.map(|x| (x * f32::from(i16::MAX)) as i16),
            bent: bent.map(|x| (x * f32::from(i8::MAX)) as i8),
            ..Zeroable::zeroed()
        }
    }
}

/// The corners of all triangles of a body; `lights`: those of the corners of a part.
fn corners(body: &Body, lights: impl Fn(&[Vec3], &[Vec3]) -> Vec<Skylight>) -> Vec<Corner> {
    let materials = materials(body);
    let number = |name: &str| materials.iter().position(|m| *m == name).unwrap_or(0) as u32;
    let surface = &body.surface;
    let mut corners = surface_corners(surface, &lights(&surface.positions, &surface.normals));
    for part in &body.ornaments {
        let lights = lights(&part.positions, &part.normals);
        let number = number(&part.material);
        corners.extend(part.triangles.iter().flatten().map(|&v| {
            let v = v as usize;
            Corner { number, ..Corner::new(part.positions[v], part.normals[v], &lights[v]) }
        }));
    }
    corners
}

fn skylights(sky: &Sky, positions: &[Vec3], normals: &[Vec3]) -> Vec<Skylight> {
    positions.iter().zip(normals).map(|(&point, &normal)| sky.light(point, normal)).collect()
}

fn surface_corners(mesh: &Mesh, lights: &[Skylight]) -> Vec<Corner> {
    let corners = mesh.triangles.iter().zip(&mesh.frames).enumerate();
    corners
        .flat_map(|(number, (t, frame))| {
            let plane = frame.corners();
            let centroid = (plane[1] + plane[2]) / 3.0;
            [0, 1, 2].map(|k| {
                let v = t[k] as usize;
                Corner {
                    uv: mesh.uvs.get(v).copied().unwrap_or_default(),
                    plane: plane[k] - centroid,
                    number: number as u32,
                    ..Corner::new(mesh.positions[v], mesh.normals[v], &lights[v])
                }
            })
        })
        .collect()
}

/// Points on all surfaces of a body, at most about `spacing` apart.
fn casters(body: &Body, spacing: f32) -> Vec<Vec3> {
    let mut points = Vec::new();
    let surface = (&body.surface.positions, &body.surface.triangles);
    let bare = body.ornaments.iter().map(|part| (&part.positions, &part.triangles));
    for (positions, triangles) in std::iter::once(surface).chain(bare) {
        for t in triangles {
            let [a, b, c] = t.map(|v| positions[v as usize]);
            let longest = (b - a).length().max((c - a).length()).max((c - b).length());
            let n = ((longest / spacing).ceil() as u32).clamp(1, 200);
            // The centroids of the n * n equal triangles that the triangle falls into, less every
            // second row's flipped ones: n * (n + 1) / 2 of them.
            for i in 0..n {
                for j in 0..n - i {
                    let share = |k: u32| (k as f32 + 1.0 / 3.0) / n as f32;
                    points.push(a + (b - a) * share(i) + (c - a) * share(j));
                }
            }
        }
    }
    points
}

/// The ground disc: rings that crowd towards the body.
fn ground(shade: &Shade, sky: &Sky, bounds: &Bounds) -> (Vec<GroundCorner>, Vec<[u32; 3]>) {
    let disc = bounds.ground();
    let outs: Vec<Vec2> = (0..=GROUND_RINGS)
        .flat_map(|ring| {
            let share = ring as f32 / GROUND_RINGS as f32;
            let radius = share * (0.35 + 0.65 * share);
            (0..GROUND_SECTORS).map(move |sector| {
                let turn = sector as f32 / GROUND_SECTORS as f32;
                let (sin, cos) = libm::sincosf(turn * std::f32::consts::TAU);
                Vec2::new(cos, sin) * radius
            })
        })
        .collect();
    let points: Vec<Vec3> =
        outs.iter().map(|out| disc.truncate() + Vec3::new(out.x, 0.0, out.y) * disc.w).collect();
    let sky = points.iter().map(|&point| sky.light(point, Vec3::Y).front);
    let lamp = shade.lamp(key_direction(), &points, bounds.radius * SOFT_RADII);
    let darkness = sky.zip(&lamp).map(|(sky, lamp)| Vec3::new(1.0 - sky, 1.0 - lamp.x, lamp.y));
    let darkness = smoothed(darkness.collect());
    let corners =
        outs.into_iter().zip(darkness).map(|(out, darkness)| GroundCorner { out, darkness });
    let triangles = (0..GROUND_RINGS)
        .flat_map(|ring| (0..GROUND_SECTORS).map(move |sector| (ring, sector)))
        .flat_map(|(ring, sector)| {
            let at = |ring: u32, sector: u32| ring * GROUND_SECTORS + sector % GROUND_SECTORS;
            let (a, b) = (at(ring, sector), at(ring, sector + 1));
            let (c, d) = (at(ring + 1, sector), at(ring + 1, sector + 1));
            [[a, b, c], [b, d, c]]
        })
        .collect();
    (corners.collect(), triangles)
}

/// Rounds off what the grain of the depth maps leaves in the shadow: each corner of the ground is
/// mixed with its four neighbours, a few times.
fn smoothed(mut darkness: Vec<Vec3>) -> Vec<Vec3> {
    let sectors = GROUND_SECTORS as usize;
    for _ in 0..6 {
        let old = darkness.clone();
        for (k, value) in darkness.iter_mut().enumerate() {
            let (ring, sector) = (k / sectors * sectors, k % sectors);
            let around = old[ring + (sector + 1) % sectors]
                + old[ring + (sector + sectors - 1) % sectors]
                + old[k.checked_sub(sectors).unwrap_or(k)]
                + old.get(k + sectors).copied().unwrap_or(old[k]);
            *value = 0.4 * old[k] + 0.15 * around;
        }
    }
    darkness
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_take_little_memory_and_keep_their_light() {
        assert!(size_of::<Corner>() <= 44);
        let light = Skylight { front: 1.0, back: 0.25, bent: Vec3::NEG_X };
        let corner = Corner::new(Vec3::ONE, Vec3::Y, &light);
        assert_eq!(corner.normal, [0, i16::MAX, 0, i16::MAX]);
        assert_eq!(corner.bent, [-i8::MAX, 0, 0, i8::MAX / 4]);
    }
}
