//! A leaf as a mesh: blade, veins and petiole.

use super::blade::petiole;
use super::plan::spacing;
use super::triangles::{Flat, triangulate};
use super::{Blade, LeafNumbers, LeafPlan, LeafPoint, Limb};
use crate::shapes::ShapeError;
use crate::shapes::tube::{point, tube};
use crate::shapes::veins::{Network, VeinNumbers, grow, scatter};
use crate::surface::{Face, Group, Line, PolygonMesh};
use glam::{DVec2, DVec3, Vec2};

/// A grown leaf.
#[derive(Clone, Debug)]
pub struct Leaf {
    pub plan: LeafPlan,
    pub limb: Limb,
    /// Corners of the triangles of the limb, flat on the table.
    pub points: Vec<DVec2>,
    /// The first so many of them lie on the border.
    pub rim: usize,
    /// Where each of them lies in the leaf.
    pub coordinates: Vec<LeafPoint>,
    /// Counter-clockwise seen from above.
    pub triangles: Vec<[u32; 3]>,
    /// Of the third order, flat on the table; its roots lie on the veins of the plan.
    pub fine: Network,
    numbers: LeafNumbers,
}

/// Pieces of a petiole.
const PETIOLE: u32 = 6;

impl Leaf {
    /// Grows a leaf from its numbers, `individual` for the chance in it.
    ///
    /// # Errors
    /// Numbers out of their range.
    pub fn new(numbers: &LeafNumbers, individual: u32) -> Result<Leaf, ShapeError> {
        let plan = LeafPlan::new(numbers, individual)?;
        let limb = Limb::new(&plan);
        let spacing_cm = spacing(limb.area(), numbers.triangles);
        let fine = match &numbers.fine {
            Some(fine) => fine_veins(&plan, &limb, fine, individual)?,
            None => Network::default(),
        };
        let fine_paths = fine.paths();
        let paths = plan.veins.iter().map(|vein| &vein.path[..]);
        let paths: Vec<&[DVec2]> = paths.chain(fine_paths.iter().map(|path| &path[..])).collect();
        let Flat { points, triangles, rim } = triangulate(&limb, &paths, spacing_cm);
        let coordinates = points.iter().map(|&p| plan.coordinates(p)).collect();
        let numbers = numbers.clone();
        Ok(Leaf { plan, limb, points, rim, coordinates, triangles, fine, numbers })
    }

    /// The leaf in space, in centimetres, the foot of its petiole in the origin. The blade carries cells; its
    /// underside, if it has one, veins and petiole are bare. Texture coordinates of the blade: `x` the affinity
    /// ratio, under 0 on the left of the leaf, `y` the homothety ratio. Main veins are lines of the first order,
    /// secondary ones of the second, fine ones of the third.
    pub fn mesh(&self) -> PolygonMesh {
        let blade = Blade::new(&self.plan, &self.numbers);
        let mut mesh = PolygonMesh::default();
        let places: Vec<DVec3> = self.points.iter().map(|&p| blade.place(p)).collect();
        mesh.positions = places.iter().map(|&p| point(p)).collect();
        mesh.uvs = self.coordinates.iter().map(|at| self.plan.uv(at)).collect();
        start(&mut mesh, "blade", "blade");
        for t in &self.triangles {
            mesh.faces.push(Face { vertices: t.to_vec(), group: 0 });
        }
        if self.numbers.thickness_cm > 0.0 {
            self.underside(&mut mesh, &places);
        }
        self.veins(&mut mesh, &blade);
        if self.numbers.petiole_cm > 0.0 {
            start(&mut mesh, "petiole", "bare:petiole");
            let radius = self.numbers.petiole_width_cm / 2.0;
            let path: Vec<(DVec3, f64)> = (0..=PETIOLE)
                .map(|k| f64::from(k) / f64::from(PETIOLE))
                .map(|share| (petiole(&self.numbers, share), radius))
                .collect();
            tube(&mut mesh, 6, &path);
        }
        self.lines(&mut mesh, &blade);
        mesh.uvs.resize(mesh.positions.len(), Vec2::ZERO);
        mesh
    }

    /// All veins as lines, with as many points as their bends on the blade need.
    fn lines(&self, mesh: &mut PolygonMesh, blade: &Blade) {
        let step_cm = blade.length() / 40.0;
        let of_plan = self.plan.veins.iter().map(|vein| {
            let order = if vein.right.is_none() { 1 } else { 2 };
            (order, along(&vein.path, step_cm))
        });
        let fine = self.fine.paths().into_iter().map(|path| (3, path));
        for (order, path) in of_plan.chain(fine) {
            let first = mesh.positions.len() as u32;
            mesh.positions.extend(path.iter().map(|&p| point(blade.place(p))));
            mesh.lines
                .push(Line { vertices: (first..mesh.positions.len() as u32).collect(), order });
        }
    }

    /// A second sheet under the first, joined to it at the rim.
    fn underside(&self, mesh: &mut PolygonMesh, places: &[DVec3]) {
        let mut normals = vec![DVec3::ZERO; places.len()];
        for t in &self.triangles {
            let [a, b, c] = t.map(|k| places[k as usize]);
            let weighted = (b - a).cross(c - a);
            t.iter().for_each(|&k| normals[k as usize] += weighted);
        }
        let first = mesh.positions.len() as u32;
        let inner = places.iter().zip(&normals).skip(self.rim);
        let under = inner.map(|(p, n)| *p - n.normalize_or_zero() * self.numbers.thickness_cm);
        mesh.positions.extend(under.map(point));
        start(mesh, "underside", "bare:underside");
        let rim = self.rim as u32;
        for &[a, b, c] in &self.triangles {
            let vertices = [a, c, b].map(|k| if k < rim { k } else { first + k - rim }).to_vec();
            mesh.faces.push(Face { vertices, group: mesh.groups.len() as u32 - 1 });
        }
    }

    /// Tubes along the veins, half of them above the blade; as thick as Murray's law has it where a vein feeds
    /// all ends that come after.
    fn veins(&self, mesh: &mut PolygonMesh, blade: &Blade) {
        start(mesh, "veins", "bare:vein");
        let nodes = f64::from(self.numbers.nodes);
        let width =
            |ends: f64| self.numbers.petiole_width_cm * libm::cbrt(ends / (2.0 * nodes - 1.0));
        let step_cm = blade.length() / 40.0;
        for vein in &self.plan.veins {
            let mut path: Vec<(DVec3, f64)> = Vec::new();
            let pieces = vein.path.len() - 1;
            for (k, ends) in vein.path.windows(2).enumerate() {
                let after =
                    if vein.right.is_none() { 2.0 * (pieces - k) as f64 - 1.0 } else { 1.0 };
                let count = ((ends[1] - ends[0]).length() / step_cm).ceil().max(1.0);
                for step in 0..count as u32 {
                    let p = ends[0] + (ends[1] - ends[0]) * (f64::from(step) / count);
                    path.push((blade.place(p), width(after) / 2.0));
                }
            }
            path.push((blade.place(vein.path[pieces]), width(1.0) / 4.0));
            tube(mesh, 4, &path);
        }
    }
}

/// Points of a line at most so far apart, its own ones among them.
fn along(path: &[DVec2], apart_cm: f64) -> Vec<DVec2> {
    let mut points = vec![path[0]];
    for ends in path.windows(2) {
        let pieces = (ends[0].distance(ends[1]) / apart_cm).ceil().max(1.0);
        let shares = (1..=pieces as u32).map(|piece| f64::from(piece) / pieces);
        points.extend(shares.map(|share| ends[0].lerp(ends[1], share)));
    }
    points
}

/// Veins that grow from those of the plan towards sources all over the limb.
fn fine_veins(
    plan: &LeafPlan,
    limb: &Limb,
    numbers: &VeinNumbers,
    individual: u32,
) -> Result<Network, ShapeError> {
    let step_cm = numbers.step * numbers.spacing_cm;
    let roots: Vec<DVec2> = plan.veins.iter().flat_map(|vein| along(&vein.path, step_cm)).collect();
    // None beside a vein that is there.
    let is_free =
        |source: &DVec2| roots.iter().all(|root| root.distance(*source) >= numbers.spacing_cm);
    let mut sources = scatter(&limb.outlines, numbers.spacing_cm, individual);
    sources.retain(is_free);
    grow(&roots, &sources, numbers)
}

fn start(mesh: &mut PolygonMesh, part: &str, material: &str) {
    mesh.groups.push(Group { part: part.into(), material: material.into() });
}
