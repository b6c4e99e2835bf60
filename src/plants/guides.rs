//! What leads the direction field: control vectors (Thesis 3.2.4) that are found on any mesh, however
//! its triangles are numbered.

use super::{List, kept, kept_list};
use crate::surface::{DirectionField, Guide, Mesh};
use glam::{Vec2, Vec3};
use serde::{Deserialize, Serialize};

/// Control vectors, and how sharply the field turns from one to the next.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Guides {
    /// That of the inverse multiquadric, over 0.
    pub epsilon_per_cm: f64,
    #[serde(deserialize_with = "kept_list")]
    pub vectors: List<GuideVector>,
}

/// A control vector and where it stands.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum GuideVector {
    /// On every leaf, at the triangle whose centre is nearest to these leaf coordinates: across from -1
    /// to 1, along from 0 to 1. Its direction is in leaf coordinates, too.
    OnLeaves { at: Vec2, direction: Vec2 },
    /// On the triangle whose centre is nearest to a point.
    Near { point_cm: Vec3, direction: Vec3 },
    /// On every triangle, along the vein up to this order that is nearest to its centre. It stands alone.
    AlongVeins { order: u32 },
}

impl Guides {
    /// The field on a mesh, or in words why there is none.
    pub fn lead(&self, mesh: &Mesh) -> Result<DirectionField, String> {
        if let &[GuideVector::AlongVeins { order }] = self.vectors {
            let along = DirectionField::along_veins(mesh, order);
            return along.ok_or_else(|| format!("the mesh has no veins up to order {order}"));
        }
        let mut guides = Vec::new();
        for part in 0..mesh.part_count() as u32 {
            for vector in self.vectors {
                let &GuideVector::OnLeaves { at, direction } = vector else { continue };
                if mesh.uvs.is_empty() {
                    return Err("guides on leaves need leaf coordinates: the mesh has none".into());
                }
                let triangle = nearest_on_leaf(mesh, part, at);
                let [across, along] = leaf_axes(mesh, triangle);
                let direction = across * direction.x + along * direction.y;
                guides.push(Guide { triangle, direction });
            }
        }
        for vector in self.vectors {
            let &GuideVector::Near { point_cm, direction } = vector else { continue };
            let distance = |t: u32| mesh.centroid(t).distance_squared(point_cm);
            guides.push(Guide {
                triangle: nearest(0..mesh.triangles.len() as u32, distance),
                direction,
            });
        }
        DirectionField::new(mesh, &guides, self.epsilon_per_cm).map_err(|e| e.to_string())
    }

    /// Whether its numbers are in their ranges; else why not.
    pub fn check(&self) -> Result<(), String> {
        kept("epsilon_per_cm", self.epsilon_per_cm as f32, 0.001, 1000.0)?;
        let numbers = self.vectors.iter().flat_map(|vector| match *vector {
            GuideVector::OnLeaves { at, direction } => [at.extend(0.0), direction.extend(0.0)],
            GuideVector::Near { point_cm, direction } => [point_cm, direction],
            GuideVector::AlongVeins { .. } => [Vec3::ZERO; 2],
        });
        for number in numbers.flat_map(|v| v.to_array()) {
            kept("a number of a vector", number, -10_000.0, 10_000.0)?;
        }
        let of_veins = |vector: &GuideVector| matches!(vector, GuideVector::AlongVeins { .. });
        if self.vectors.iter().any(of_veins) && self.vectors.len() > 1 {
            return Err("along_veins leads every triangle: it stands alone".into());
        }
        match self.vectors.len() {
            1..=500 => Ok(()),
            count => Err(format!("there are {count} vectors: there must be from 1 to 500")),
        }
    }
}

/// The triangle of a leaf whose centre is nearest in leaf coordinates.
fn nearest_on_leaf(mesh: &Mesh, part: u32, leaf: Vec2) -> u32 {
    let centre = |t: u32| {
        mesh.triangles[t as usize].iter().map(|&v| mesh.uvs[v as usize]).sum::<Vec2>() / 3.0
    };
    let on_leaf = (0..mesh.triangles.len() as u32).filter(|&t| mesh.parts[t as usize] == part);
    nearest(on_leaf, |t| centre(t).distance_squared(leaf))
}

fn nearest(triangles: impl Iterator<Item = u32>, distance: impl Fn(u32) -> f32) -> u32 {
    triangles
        .min_by(|&s, &t| distance(s).total_cmp(&distance(t)))
        .expect("every mesh and every part has triangles")
}

/// The ways in space along which each of the leaf coordinates grows by one.
fn leaf_axes(mesh: &Mesh, triangle: u32) -> [Vec3; 2] {
    let [a, b, c] = mesh.corners(triangle);
    let [ua, ub, uc] = mesh.triangles[triangle as usize].map(|v| mesh.uvs[v as usize]);
    let (to_b, to_c) = (ub - ua, uc - ua);
    let area = to_b.perp_dot(to_c);
    [((b - a) * to_c.y - (c - a) * to_b.y) / area, ((c - a) * to_b.x - (b - a) * to_c.x) / area]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::icosphere;

    #[test]
    fn the_field_of_a_philodendron_leads_from_the_midrib_to_the_rim() {
        let plant = crate::plants::find("philodendron").unwrap();
        let surface = plant.embedded_body().surface;
        let field = plant.field(&surface).unwrap().unwrap();
        for t in 0..surface.triangles.len() as u32 {
            let direction = field.at(t);
            assert!((direction.length() - 1.0).abs() < 1e-5, "triangle {t}: {direction}");
            let [a, b, c] = surface.triangles[t as usize].map(|v| surface.uvs[v as usize]);
            let frame = surface.frames[t as usize].barycentric(direction);
            let in_leaf = (b - a) * frame.x + (c - a) * frame.y;
            let across = (a.x + b.x + c.x) / 3.0;
            let outwards = in_leaf.x * across.signum() > 0.0;
            assert!(outwards || across.abs() < 0.12, "{across} across: {in_leaf}");
        }
    }

    #[test]
    fn a_vector_in_space_leads_the_triangle_that_it_is_near_to() {
        let sphere = icosphere(2, 10.0);
        let seventh = 7;
        let point_cm = sphere.centroid(seventh) * 1.1;
        let vectors = vec![GuideVector::Near { point_cm, direction: Vec3::X }].leak();
        let guides = Guides { epsilon_per_cm: 0.2, vectors };
        let field = guides.lead(&sphere).unwrap();
        let [x, y] = sphere.axes(seventh);
        let led = x * field.at(seventh).x + y * field.at(seventh).y;
        let normal = x.cross(y);
        let flat = (Vec3::X - normal * normal.x).normalize();
        assert!(led.distance(flat) < 1e-5, "{led} for {flat}");
    }

    #[test]
    fn leaves_without_coordinates_are_refused_in_words() {
        const VECTORS: [GuideVector; 1] =
            [GuideVector::OnLeaves { at: Vec2::new(0.5, 0.5), direction: Vec2::X }];
        let guides = Guides { epsilon_per_cm: 0.2, vectors: &VECTORS };
        assert!(guides.lead(&icosphere(1, 1.0)).unwrap_err().contains("leaf coordinates"));
    }
}
