//! A flower as a mesh that opens.

use super::FlowerNumbers;
use super::growth::Growth;
use super::opening::joints;
use super::perianth::Perianth;
use super::receptacle;
use super::rod::Rod;
use super::sepals::Sepals;
use super::solve::Cholesky;
use super::stamens::Stamens;
use crate::shapes::ShapeError;
use crate::shapes::chance::{part_key, root_key};
use crate::shapes::tube::{point, rings, walls};
use crate::surface::{Face, Group, PolygonMesh};
use glam::{DQuat, DVec3, Vec2, Vec3};

/// A grown flower.
#[derive(Clone, Debug)]
pub struct Flower {
    pub petals: Perianth,
    pub sepals: Option<Perianth>,
    stamens: Option<Stamens>,
    style: Option<Rod>,
    numbers: FlowerNumbers,
    joints: Cholesky,
}

/// Corners around the style and the pedicel, and pieces of the latter.
const SIDES: u32 = 6;
const PEDICEL: u32 = 5;

impl Flower {
    /// Grows a flower from its numbers, `individual` for the chance in it.
    ///
    /// # Errors
    /// Numbers out of their range.
    pub fn new(numbers: &FlowerNumbers, individual: u32) -> Result<Flower, ShapeError> {
        numbers.check()?;
        let key = |kind| part_key(root_key(individual), kind);
        let irregularity = numbers.irregularity;
        let sepals = numbers.sepals.as_ref().filter(|sepals| sepals.count() > 0);
        let perianth = |numbers, kind| Perianth::new(numbers, irregularity, key(kind));
        Ok(Flower {
            petals: perianth(&numbers.petals, 0),
            sepals: sepals.map(|sepals| match sepals {
                Sepals::Around(few) => Perianth::around(few, &numbers.petals, irregularity, key(1)),
                Sepals::Drawn(drawn) => perianth(drawn.as_ref(), 1),
            }),
            stamens: numbers.stamens.as_ref().map(|s| Stamens::new(s, irregularity, key(2))),
            style: numbers.pistil.as_ref().map(|pistil| Rod::new(pistil, 0.0, 1.0)),
            numbers: numbers.clone(),
            joints: joints(),
        })
    }

    /// The open flower, in centimetres; the foot of its pedicel is the origin. The petals carry cells, in leaf
    /// coordinates; all else is bare.
    pub fn mesh(&self) -> PolygonMesh {
        let mut mesh = PolygonMesh::default();
        petals(&mut mesh, "petal", "petal", &self.petals);
        if let Some(sepals) = &self.sepals {
            petals(&mut mesh, "sepal", "bare:sepal", sepals);
        }
        if let Some(stamens) = &self.numbers.stamens {
            for (part, material) in [("filaments", "bare:filament"), ("anthers", "bare:anther")] {
                start(&mut mesh, part, material);
                for _ in 0..stamens.count {
                    stalk(&mut mesh, stamens.sides, stamens.rings);
                }
            }
        }
        if let Some(pistil) = &self.numbers.pistil {
            start(&mut mesh, "pistil", "bare:pistil");
            stalk(&mut mesh, SIDES, pistil.radii_cm.len() as u32);
        }
        if let Some(receptacle) = &self.numbers.receptacle {
            start(&mut mesh, "receptacle", "bare:receptacle");
            stalk(&mut mesh, receptacle::SIDES, receptacle::RINGS);
            start(&mut mesh, "carpels", "bare:pistil");
            for _ in 0..receptacle.carpels {
                let first = mesh.uvs.len() as u32;
                add(&mut mesh, [(first..first + 4).collect()], 4);
            }
        }
        if self.numbers.pedicel_cm > 0.0 {
            start(&mut mesh, "pedicel", "bare:pedicel");
            stalk(&mut mesh, SIDES, PEDICEL + 1);
        }
        mesh.positions = self.corners(1.0, 6.0).into_iter().map(point).collect();
        mesh
    }

    /// The vertices of the mesh at a time from 0, the bud, to 1, when the flower is open.
    pub fn at(&self, time: f64) -> Vec<Vec3> {
        self.corners(time, self.numbers.growth).into_iter().map(point).collect()
    }

    /// The area of all petals, one side of them, at a time.
    pub fn area_cm2(&self, time: f64) -> f64 {
        let growth = Growth::share(self.numbers.growth);
        let corners = self.petals.at(&self.joints, &growth, time);
        let mut area = 0.0;
        let mut first = 0;
        for petal in &self.petals.petals {
            let at = |k: u32| corners[first + k as usize];
            for face in &petal.layout.faces {
                let fan = face.windows(2).skip(1).map(|ends| {
                    (at(ends[0]) - at(face[0])).cross(at(ends[1]) - at(face[0])).length() / 2.0
                });
                area += fan.sum::<f64>();
            }
            first += petal.layout.corners.len();
        }
        area
    }

    fn corners(&self, time: f64, g: f64) -> Vec<DVec3> {
        let growth = Growth::share(g);
        let share = growth.at(time);
        let mut corners = self.petals.at(&self.joints, &growth, time);
        if let Some(sepals) = &self.sepals {
            corners.extend(sepals.at(&self.joints, &growth, time));
        }
        if let Some(stamens) = &self.stamens {
            corners.extend(stamens.at(share).into_iter().flatten());
        }
        if let Some(style) = &self.style {
            corners.extend(style.corners(SIDES, &style.path(share), share));
        }
        if let Some(receptacle) = &self.numbers.receptacle {
            let size = receptacle.bud * (1.0 - share) + share;
            let all = receptacle.rings().into_iter().chain(receptacle.heads());
            corners.extend(all.map(|p| p * size));
        }
        let mut pedicel = self.pedicel();
        let turn = DQuat::from_rotation_x(self.numbers.nod_deg.to_radians());
        let top = pedicel[pedicel.len() - 1].0;
        corners.iter_mut().for_each(|p| *p = turn * *p + top);
        if self.numbers.pedicel_cm > 0.0 {
            // It carries the petals.
            let last = pedicel.len() - 1;
            pedicel[last].1 = pedicel[last].1.max(0.9 * self.petals.foot_cm);
            corners.extend(rings(SIDES, &pedicel, DVec3::X));
        }
        corners
    }

    /// The way from the ground up and over to where the petals stand, with radii.
    fn pedicel(&self) -> Vec<(DVec3, f64)> {
        const STEPS: u32 = 12;
        let radius = self.numbers.pedicel_width_cm / 2.0;
        let piece = self.numbers.pedicel_cm / f64::from(STEPS * PEDICEL);
        let mut end = DVec3::ZERO;
        let mut path = vec![(end, radius)];
        for step in 0..STEPS * PEDICEL {
            // Straight up at first.
            let share = (f64::from(step) + 0.5) / f64::from(STEPS * PEDICEL);
            let bent = ((share - 0.4) / 0.6).max(0.0);
            let nod = self.numbers.nod_deg.to_radians() * bent * bent * (3.0 - 2.0 * bent);
            end += DVec3::new(0.0, libm::cos(nod), libm::sin(nod)) * piece;
            if (step + 1) % STEPS == 0 {
                path.push((end, radius));
            }
        }
        path
    }
}

fn start(mesh: &mut PolygonMesh, part: &str, material: &str) {
    mesh.groups.push(Group { part: part.into(), material: material.into() });
}

/// Adds polygons to the last group, and texture coordinates for so many vertices that have none.
fn add(mesh: &mut PolygonMesh, faces: impl IntoIterator<Item = Vec<u32>>, vertices: u32) {
    let group = mesh.groups.len() as u32 - 1;
    mesh.faces.extend(faces.into_iter().map(|vertices| Face { vertices, group }));
    mesh.uvs.resize(mesh.uvs.len() + vertices as usize, Vec2::ZERO);
}

fn stalk(mesh: &mut PolygonMesh, sides: u32, rings: u32) {
    walls(mesh, mesh.uvs.len() as u32, sides, rings);
    add(mesh, [], sides * rings);
}

fn petals(mesh: &mut PolygonMesh, part: &str, material: &str, perianth: &Perianth) {
    for (number, petal) in (1..).zip(&perianth.petals) {
        start(mesh, &format!("{part} {number}"), material);
        let first = mesh.uvs.len() as u32;
        let faces = petal.layout.faces.iter();
        add(mesh, faces.map(|face| face.iter().map(|v| v + first).collect()), 0);
        mesh.uvs.extend(petal.layout.corners.iter().map(|uv| {
            let short = |share: f64| (share * 1e5).round() / 1e5 + 0.0;
            Vec2::new(short(uv.x) as f32, short(uv.y) as f32)
        }));
    }
}
