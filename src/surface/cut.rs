//! Polygons that are not convex, cut into triangles along their inside by constrained Delaunay
//! triangulation (spade). Unlike ear clipping it keeps corners that lie on a straight side, where
//! neighbours may have theirs.

use super::body::triangulate;
use super::{Face, PolygonMesh};
use glam::{DVec2, DVec3, Vec3};
use spade::handles::FixedVertexHandle;
use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation};
use std::collections::HashMap;

/// Puts triangles in the place of each polygon that `Body::new` would cut beyond its rim or into
/// triangles without area. A polygon that crosses itself is cut in whichever way keeps its area better.
pub fn cut_hollow(mesh: &mut PolygonMesh) {
    let mut faces = Vec::with_capacity(mesh.faces.len());
    for face in std::mem::take(&mut mesh.faces) {
        match better_cut(&mesh.positions, &face.vertices) {
            None => faces.push(face),
            Some(triangles) => faces
                .extend(triangles.iter().map(|t| Face { vertices: t.to_vec(), group: face.group })),
        }
    }
    mesh.faces = faces;
}

/// Triangles, if the usual ones are not right.
fn better_cut(positions: &[Vec3], corners: &[u32]) -> Option<Vec<[u32; 3]>> {
    if corners.len() < 4 {
        return None;
    }
    let at = |v: u32| positions[v as usize].as_dvec3();
    let twice_area = twice_area(corners.iter().map(|&v| at(v)));
    let normal = twice_area.try_normalize()?;
    let mut usual = Vec::with_capacity(corners.len() - 2);
    triangulate(positions, corners, &mut usual);
    // As `Mesh::new` asks for area.
    let is_right = |&[a, b, c]: &[u32; 3]| {
        let (ab, ac) = (at(b) - at(a), at(c) - at(a));
        ab.cross(ac).dot(normal) > 1e-7 * ab.length_squared().max(ac.length_squared())
    };
    if usual.iter().all(is_right) {
        return None;
    }
    let inside = inside(positions, corners, normal)?;
    let miss = |triangles: &[[u32; 3]]| {
        let areas = triangles.iter().map(|t| twice_area_of(t.map(at)).length());
        (areas.sum::<f64>() - twice_area.length()).abs()
    };
    (miss(&inside) <= miss(&usual)).then_some(inside)
}

/// Twice the area of a polygon, along its normal (Newell's method, from its first corner).
fn twice_area(mut corners: impl Iterator<Item = DVec3>) -> DVec3 {
    let first = corners.next().unwrap_or_default();
    let mut last = DVec3::ZERO;
    corners.fold(DVec3::ZERO, |sum, corner| {
        let before = std::mem::replace(&mut last, corner - first);
        sum + before.cross(last)
    })
}

fn twice_area_of([a, b, c]: [DVec3; 3]) -> DVec3 {
    (b - a).cross(c - a)
}

/// Triangles between the corners that the polygon runs around. Nothing if corners that are apart lie on
/// each other seen along the normal.
fn inside(positions: &[Vec3], corners: &[u32], normal: DVec3) -> Option<Vec<[u32; 3]>> {
    let mut points = Vec::with_capacity(corners.len());
    let mut vertices: Vec<u32> = Vec::with_capacity(corners.len());
    let mut numbers = HashMap::new();
    let mut rim = Vec::with_capacity(corners.len());
    for &vertex in corners {
        let position = positions[vertex as usize];
        let at = flat(position, normal);
        let number = *numbers.entry(at.to_array().map(f64::to_bits)).or_insert(points.len());
        if number == points.len() {
            points.push(Point2::new(at.x, at.y));
            vertices.push(vertex);
        } else if positions[vertices[number] as usize] != position {
            return None;
        }
        rim.push(number);
    }
    let next = rim.iter().cycle().skip(1);
    let rim: Vec<[usize; 2]> = rim.iter().zip(next).map(|(&a, &b)| [a, b]).collect();
    let sides = rim.iter().copied().filter(|[a, b]| a != b).collect();
    let cut = Cut::try_bulk_load_cdt(points, sides, |_| {}).ok()?;

    let windings = windings(&cut, &rim);
    let within = cut.inner_faces().filter(|face| windings[face.index()] != Some(0));
    Some(within.map(|face| face.vertices().map(|v| vertices[v.index()])).collect())
}

type Cut = ConstrainedDelaunayTriangulation<Point2<f64>>;

/// Seen along the axis that is nearest to the normal, counter-clockwise for a polygon of this normal. The
/// other two coordinates are kept as they are: corners on a line stay on it.
fn flat(p: Vec3, normal: DVec3) -> DVec2 {
    let (p, size) = (p.as_dvec3() + DVec3::ZERO, normal.abs());
    let (seen, along) = if size.x >= size.y && size.x >= size.z {
        (DVec2::new(p.y, p.z), normal.x)
    } else if size.y >= size.z {
        (DVec2::new(p.z, p.x), normal.y)
    } else {
        (DVec2::new(p.x, p.y), normal.z)
    };
    if along < 0.0 { DVec2::new(seen.y, seen.x) } else { seen }
}

/// How many times the rim runs around each face, by the face's index. A side that it runs along to and
/// fro, as to a hole, makes no difference.
fn windings(cut: &Cut, rim: &[[usize; 2]]) -> Vec<Option<i32>> {
    let mut turns: HashMap<[usize; 2], i32> = HashMap::new();
    for &[from, to] in rim {
        *turns.entry([from, to]).or_default() += 1;
        *turns.entry([to, from]).or_default() -= 1;
    }
    let step = |from: FixedVertexHandle, to: FixedVertexHandle| {
        turns.get(&[from.index(), to.index()]).copied().unwrap_or(0)
    };
    let mut windings = vec![None; cut.num_all_faces()];
    windings[cut.outer_face().index()] = Some(0);
    // Half-edges from whose faces the faces on their other sides are still to be reached.
    let mut waiting: Vec<_> =
        cut.directed_edges().filter(|edge| edge.is_outer_edge()).map(|edge| edge.fix()).collect();
    while let Some(edge) = waiting.pop() {
        let edge = cut.directed_edge(edge);
        let here = windings[edge.face().index()].unwrap_or(0);
        let other = edge.rev();
        if windings[other.face().index()].is_some() {
            continue;
        }
        let across = here - step(edge.from().fix(), edge.to().fix());
        windings[other.face().index()] = Some(across);
        waiting.extend([other.next().fix(), other.prev().fix()]);
    }
    windings
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::Body;

    /// Corners of one polygon in a tilted plane.
    fn polygon(corners: &[[f32; 2]]) -> PolygonMesh {
        let place = |&[x, y]: &[f32; 2]| Vec3::new(x, y, 0.5 * x - 0.25 * y);
        PolygonMesh {
            positions: corners.iter().map(place).collect(),
            faces: vec![Face { vertices: (0..corners.len() as u32).collect(), group: 0 }],
            ..PolygonMesh::default()
        }
    }

    /// Area as seen from above of a polygon in that plane once it is cut, and its triangles.
    fn cut_area(mut mesh: PolygonMesh) -> (f64, usize) {
        cut_hollow(&mut mesh);
        let body = Body::new(&mesh).unwrap();
        body.surface.check().unwrap();
        let tilt = (1.0 + 0.5 * 0.5 + 0.25 * 0.25f64).sqrt();
        (f64::from(body.surface.area) / tilt, body.surface.triangles.len())
    }

    fn assert_cut(corners: &[[f32; 2]], area: f64) {
        for turn in 0..corners.len().min(20) {
            let mut turned = corners.to_vec();
            turned.rotate_left(turn);
            for _ in 0..2 {
                turned.reverse();
                let (found, triangles) = cut_area(polygon(&turned));
                assert!((found / area - 1.0).abs() < 1e-5, "{found} and not {area}: {turned:?}");
                assert_eq!(triangles, corners.len() - 2, "{turned:?}");
            }
        }
    }

    #[test]
    fn no_triangle_reaches_over_the_rim_from_whichever_corner_it_begins() {
        let dart = [[0.0, 1.0], [-1.0, 0.0], [0.0, 2.0], [1.0, 0.0]];
        assert_cut(&dart, 1.0);
        let l = [[1.0, 1.0], [1.0, 2.0], [0.0, 2.0], [0.0, 0.0], [2.0, 0.0], [2.0, 1.0]];
        assert_cut(&l, 3.0);
        let star: Vec<[f32; 2]> = (0..10)
            .map(|k| {
                let (sin, cos) = (std::f32::consts::PI * k as f32 / 5.0).sin_cos();
                let radius = if k % 2 == 0 { 1.0 } else { 0.25 };
                [radius * cos, radius * sin]
            })
            .collect();
        assert_cut(&star, 10.0 * 0.5 * 0.25 * (std::f64::consts::PI / 5.0).sin());
    }

    #[test]
    fn corners_on_a_straight_side_stay() {
        let square = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [2.0, 2.0], [0.0, 2.0]];
        assert_cut(&square, 4.0);
        assert_cut(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [1.0, 3.0]], 3.0);
    }

    #[test]
    fn a_hole_that_a_side_leads_to_and_from_stays_open() {
        let mut mesh = polygon(&[
            [0.0, 0.0],
            [4.0, 0.0],
            [4.0, 4.0],
            [0.0, 4.0],
            [1.0, 1.0],
            [1.0, 3.0],
            [3.0, 3.0],
            [3.0, 1.0],
        ]);
        mesh.faces[0].vertices = vec![0, 1, 2, 3, 0, 4, 5, 6, 7, 4];
        let (area, triangles) = cut_area(mesh);
        assert!((area - 12.0).abs() < 1e-5 && triangles == 8, "{area} in {triangles}");
    }

    #[test]
    fn convex_polygons_are_left_to_the_usual_cut() {
        for corners in 3..40 {
            let round: Vec<[f32; 2]> = (0..corners)
                .map(|k| (std::f32::consts::TAU * k as f32 / corners as f32).sin_cos().into())
                .collect();
            let mut mesh = polygon(&round);
            let before = mesh.clone();
            cut_hollow(&mut mesh);
            assert_eq!(mesh, before);
        }
    }

    #[test]
    fn a_polygon_that_crosses_itself_does_no_harm() {
        let bow = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]];
        assert!(cut_area(polygon(&bow)).0 <= 1.0 + 1e-6);
        let star = [[0.0, 0.0], [2.0, 3.0], [4.0, 0.0], [0.0, 2.0], [4.0, 2.0]];
        assert!(cut_area(polygon(&star)).0 < 12.0);
    }

    #[test]
    fn a_comb_of_100_000_corners_takes_no_time() {
        let teeth = 50_000;
        let mut comb = vec![[0.0, -300.0]];
        comb.extend((0..2 * teeth - 2).map(|k| [k as f32 * 0.01, (k % 2) as f32]));
        comb.push([(2 * teeth - 3) as f32 * 0.01, -300.0]);
        let triangles = cut_area(polygon(&comb)).1;
        assert_eq!(triangles, comb.len() - 2);
    }
}
