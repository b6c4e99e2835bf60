//! Tubes: branches and stalks.

use crate::surface::{Face, PolygonMesh};
use glam::{DVec3, Vec3};

/// Adds a tube along a path of `(centre, radius)` in centimetres, of at least two places, to the last
/// group of a mesh: quads all along, open at its foot and closed by a polygon at its end. Outside is
/// counter-clockwise. At least 3 sides.
pub fn tube(mesh: &mut PolygonMesh, sides: u32, path: &[(DVec3, f64)]) {
    walls(mesh, mesh.positions.len() as u32, sides, path.len() as u32);
    mesh.positions.extend(rings(sides, path, DVec3::ZERO).into_iter().map(point));
}

/// The corners of a tube, ring by ring. The first of each ring lies in the direction `across`, or in any one if that
/// is zero.
pub fn rings(sides: u32, path: &[(DVec3, f64)], mut across: DVec3) -> Vec<DVec3> {
    let mut corners = Vec::with_capacity(path.len() * sides as usize);
    for (k, &(centre, radius)) in path.iter().enumerate() {
        let along = path[(k + 1).min(path.len() - 1)].0 - path[k.saturating_sub(1)].0;
        let along = along.try_normalize().unwrap_or(DVec3::Y);
        // The same side all along, so that the tube does not twist.
        across = (across - along * across.dot(along))
            .try_normalize()
            .unwrap_or_else(|| along.any_orthonormal_vector());
        let other = along.cross(across);
        for side in 0..sides {
            let angle = std::f64::consts::TAU * f64::from(side) / f64::from(sides);
            let out = across * libm::cos(angle) + other * libm::sin(angle);
            corners.push(centre + out * radius);
        }
    }
    corners
}

/// The polygons of a tube of so many rings, from the vertex `first` on, in the last group of a mesh; two sides make a
/// single sheet.
pub fn walls(mesh: &mut PolygonMesh, first: u32, sides: u32, rings: u32) {
    let group = mesh.groups.len() as u32 - 1;
    for ring in (1..rings).map(|k| first + k * sides) {
        let last = ring - sides;
        for side in 0..if sides == 2 { 1 } else { sides } {
            let next = (side + 1) % sides;
            let vertices = vec![last + side, last + next, ring + next, ring + side];
            mesh.faces.push(Face { vertices, group });
        }
    }
    if sides == 2 {
        return;
    }
    let end = first + (rings - 1) * sides;
    mesh.faces.push(Face { vertices: (end..end + sides).collect(), group });
}

/// A point on a grid of a ten-thousandth of a millimetre: finer than a cell, and short in files.
pub fn point(p: DVec3) -> Vec3 {
    const STEPS_PER_CM: f64 = 100_000.0;
    // Zero has no sign in a file.
    ((p * STEPS_PER_CM).round() / STEPS_PER_CM + DVec3::ZERO).as_vec3()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::{Body, Group};

    #[test]
    fn a_cone_has_the_area_of_its_flat_sides() {
        let mut mesh = PolygonMesh::default();
        mesh.groups.push(Group { part: "cone".into(), material: "bark".into() });
        let path = [(DVec3::ZERO, 2.0), (DVec3::new(0.0, 3.0, 0.0), 1.0)];
        tube(&mut mesh, 4, &path);
        let body = Body::new(&mesh).unwrap();
        body.surface.check().unwrap();
        // Four trapezia with sides of 2 sqrt 2 and sqrt 2, and a square lid of side sqrt 2.
        let slant = (9.0f64 + 0.5).sqrt();
        let exact = 4.0 * 1.5 * 2f64.sqrt() * slant + 2.0;
        assert!((f64::from(body.surface.area) / exact - 1.0).abs() < 1e-5);
        // Outside is out.
        for t in 0..8 {
            let outward = body.surface.centroid(t) * Vec3::new(1.0, 0.0, 1.0);
            let [a, b, c] = body.surface.corners(t);
            assert!((b - a).cross(c - a).dot(outward) > 0.0);
        }
    }
}
