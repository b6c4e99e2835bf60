//! A leaf of few triangles, for trees that have many: its border with straight sides, and the main veins alone.

use super::blade::petiole;
use super::triangles::{Flat, coarse};
use super::{Blade, LeafNumbers, LeafPlan, Limb};
use crate::shapes::ShapeError;
use glam::{DVec2, DVec3, Vec2, Vec3};

/// A leaf as it is laid on a tree: the foot of its petiole in the origin, `y` along it and the upper side towards `z`.
#[derive(Clone, Debug)]
pub struct FlatLeaf {
    pub blade: Form,
    /// Four corners that have its area, from the foot to the right, the tip and the left.
    pub spot: Form,
    /// The foot of its petiole, a point on it and its end.
    pub petiole: [DVec3; 3],
}

/// A sheet in leaf coordinates.
#[derive(Clone, Debug)]
pub struct Form {
    pub places: Vec<DVec3>,
    pub uvs: Vec<Vec2>,
    /// Counter-clockwise from above.
    pub faces: Vec<Vec<u32>>,
}

impl FlatLeaf {
    /// The first individual of these numbers.
    ///
    /// # Errors
    /// Numbers out of their ranges.
    pub fn new(numbers: &LeafNumbers) -> Result<FlatLeaf, ShapeError> {
        let plan = LeafPlan::new(numbers, 1)?;
        let limb = Limb::straight(&plan);
        let blade = Blade::new(&plan, numbers);
        let veins: Vec<Vec<DVec2>> = plan
            .lobes
            .iter()
            .map(|lobe| {
                let tip = lobe.corners[0][lobe.corners[0].len() - 1].y;
                let middle = lobe.feet[lobe.feet.len() / 2];
                [0.0, middle, tip].map(|along| lobe.point(0.0, along)).to_vec()
            })
            .collect();
        let veins: Vec<&[DVec2]> = veins.iter().map(Vec::as_slice).collect();
        let Flat { points, triangles, .. } = coarse(&limb, &veins);
        let uvs = points.iter().map(|&p| plan.uv(&plan.coordinates(p))).collect();
        Ok(FlatLeaf {
            blade: Form {
                places: points.iter().map(|&p| blade.place(p)).collect(),
                uvs,
                faces: triangles.iter().map(|t| t.to_vec()).collect(),
            },
            spot: spot(&limb, &blade),
            petiole: [0.0, 0.5, 1.0].map(|share| petiole(numbers, share)),
        })
    }

    /// The same leaf, so many times as large.
    pub fn scaled(mut self, size: f64) -> FlatLeaf {
        let forms = [&mut self.blade, &mut self.spot];
        let places = forms.into_iter().flat_map(|form| &mut form.places);
        places.chain(&mut self.petiole).for_each(|place| *place *= size);
        self
    }

    /// How far from the foot of its petiole it comes.
    pub fn reach_cm(&self) -> f64 {
        let places = self.blade.places.iter().chain(&self.spot.places);
        places.map(|p| p.length()).fold(0.0, f64::max)
    }

    /// The spot in two triangles, where it is placed.
    pub fn sheet(&self, place: impl Fn(DVec3) -> DVec3) -> [[Vec3; 3]; 2] {
        let at = |k: usize| place(self.spot.places[k]).as_vec3();
        [[at(0), at(1), at(2)], [at(0), at(2), at(3)]]
    }
}

/// A kite through the ends of the limb, as large as that.
fn spot(limb: &Limb, blade: &Blade) -> Form {
    let corners = || limb.outlines.iter().flatten().copied();
    let end = |of: fn(DVec2) -> f64| {
        corners().fold(DVec2::ZERO, |best, p| if of(p) > of(best) { p } else { best })
    };
    let [foot, right, tip, left] = [end(|p| -p.y), end(|p| p.x), end(|p| p.y), end(|p| -p.x)];
    let kite = [DVec2::new(0.0, foot.y), right, DVec2::new(0.0, tip.y), left];
    let area = 0.5 * (kite[2] - kite[0]).perp_dot(kite[3] - kite[1]).abs();
    let size = (limb.area() / area.max(1e-9)).sqrt();
    let middle = (kite[0] + kite[2]) / 2.0;
    let placed = kite.map(|p| blade.place(middle + (p - middle) * size));
    let uvs = [[0.0, 0.0], [1.0, 0.5], [0.0, 1.0], [-1.0, 0.5]].map(Vec2::from);
    Form { places: placed.to_vec(), uvs: uvs.to_vec(), faces: vec![vec![0, 1, 2, 3]] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::{Body, Face, Group, PolygonMesh};

    #[test]
    fn a_flat_leaf_has_few_triangles_and_the_area_of_its_border() {
        for (text, most) in [
            ("{}", 130),
            (r#"{"lobes": 1, "nodes": 6, "border": "smooth"}"#, 16),
            (r#"{"lobes": 3, "nodes": 4}"#, 40),
        ] {
            let numbers = LeafNumbers {
                fold_deg: 0.0,
                curl_deg: 0.0,
                wave_cm: 0.0,
                ..LeafNumbers::from_json(text).unwrap()
            };
            let leaf = FlatLeaf::new(&numbers).unwrap();
            let area = Limb::straight(&LeafPlan::new(&numbers, 1).unwrap()).area();
            for (form, most) in [(&leaf.blade, most), (&leaf.spot, 1)] {
                assert!(form.faces.len() <= most, "{text}: {} faces", form.faces.len());
                let group = Group { part: "leaf".into(), material: "blade".into() };
                let face = |vertices: &Vec<u32>| Face { vertices: vertices.clone(), group: 0 };
                let mesh = PolygonMesh {
                    positions: form.places.iter().map(|p| p.as_vec3()).collect(),
                    uvs: form.uvs.clone(),
                    faces: form.faces.iter().map(face).collect(),
                    groups: vec![group],
                    ..PolygonMesh::default()
                };
                let surface = Body::new(&mesh).unwrap().surface;
                assert!((f64::from(surface.area) / area - 1.0).abs() < 1e-3, "{text}");
                for t in 0..surface.triangles.len() as u32 {
                    let [a, b, c] = surface.corners(t);
                    assert!((b - a).cross(c - a).z > 0.0, "its upper side is above");
                }
            }
        }
    }
}
