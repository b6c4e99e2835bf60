//! What strokes come to on a mesh: lines on its skin.

use super::stroke::{Spot, Stroke, Way};
use crate::surface::{Mesh, NO_TWIN, Place};
use glam::{Vec2, Vec3};

/// A point of a line, and the triangle that it lies on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct On {
    pub triangle: u32,
    pub at: Vec3,
}

/// The lines of a stroke, its mirror image included; a point alone is a line of one.
///
/// # Errors
/// In plain words, if it lies on triangles that are not there.
pub fn lines_of(stroke: &Stroke, mesh: &Mesh) -> Result<Vec<Vec<On>>, String> {
    let count = mesh.triangles.len();
    if let Some(spot) = stroke.points.iter().find(|spot| spot.triangle as usize >= count) {
        return Err(format!(
            "a stroke lies on triangle {}, but there are only {count}",
            spot.triangle
        ));
    }
    let mut points: Vec<Vec<Place>> =
        vec![stroke.points.iter().copied().map(Spot::place).collect()];
    if stroke.is_mirrored {
        points.push(points[0].iter().map(|&place| mirrored(mesh, place)).collect());
    }
    let on = |&place: &Place| On { triangle: place.triangle, at: mesh.point(place) };
    Ok(points
        .iter()
        .flat_map(|points| match stroke.way {
            Way::Free => vec![points.iter().map(on).collect()],
            Way::Part => points.iter().map(|place| vec![on(place)]).collect(),
            Way::Around => points.iter().map(|&place| level(mesh, place, true)).collect(),
            Way::Along => points.iter().map(|&place| level(mesh, place, false)).collect(),
        })
        .collect())
}

/// Whether a part of the mesh has leaf coordinates.
fn is_leaf(mesh: &Mesh, triangle: u32) -> bool {
    !mesh.uvs.is_empty()
        && mesh.triangles[triangle as usize].iter().any(|&v| mesh.uvs[v as usize] != Vec2::ZERO)
}

/// The middle of the box around the surface.
fn middle(mesh: &Mesh) -> Vec3 {
    let (low, high) = (mesh.positions.iter())
        .fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |ends, &p| (ends.0.min(p), ends.1.max(p)));
    (low + high) * 0.5
}

/// The line through a place on which the height, or the angle around the upright axis through the middle, stays the
/// same; on a leaf the way along it, or across.
fn level(mesh: &Mesh, from: Place, is_around: bool) -> Vec<On> {
    let (start, centre) = (mesh.point(from), middle(mesh));
    let out = Vec3::new(start.x - centre.x, 0.0, start.z - centre.z);
    let of_leaf = is_leaf(mesh, from.triangle);
    let value = |vertex: u32| {
        let (at, vertex) = (mesh.positions[vertex as usize], vertex as usize);
        match (of_leaf, is_around) {
            (true, true) => mesh.uvs[vertex].y,
            (true, false) => mesh.uvs[vertex].x,
            (false, true) => at.y,
            (false, false) => (at - centre).cross(Vec3::Y).dot(out),
        }
    };
    let wanted = match (of_leaf, is_around) {
        (true, true) => mesh.uv(from).y,
        (true, false) => mesh.uv(from).x,
        (false, true) => start.y,
        (false, false) => 0.0,
    };
    // An upright plane through the axis meets the other side, too.
    let stays = |at: Vec3| of_leaf || is_around || (at - centre).dot(out) >= 0.0;
    // Where the line leaves a triangle: its half-edge, and the point.
    let crossings = |triangle: u32| {
        let corners = mesh.triangles[triangle as usize];
        (0..3).filter_map(move |k| {
            let [a, b] = [(k + 1) % 3, (k + 2) % 3].map(|corner: usize| corners[corner]);
            let [from, to] = [a, b].map(|vertex| value(vertex) - wanted);
            let share = from / (from - to);
            let [a, b] = [a, b].map(|vertex| mesh.positions[vertex as usize]);
            ((from >= 0.0) != (to >= 0.0)).then(|| (3 * triangle + k as u32, a + (b - a) * share))
        })
    };
    let mut line = vec![On { triangle: from.triangle, at: start }];
    for side in 0..2 {
        let mut next = crossings(from.triangle).nth(side);
        for _ in 0..mesh.triangles.len() {
            let Some((edge, at)) = next.filter(|(_, at)| stays(*at)) else { break };
            line.push(On { triangle: edge / 3, at });
            let twin = mesh.twins[edge as usize];
            if twin == NO_TWIN {
                break;
            }
            if twin / 3 == from.triangle {
                line.push(line[0]);
                return line;
            }
            next = crossings(twin / 3).find(|(edge, _)| *edge != twin);
        }
        // From the other end on.
        line.reverse();
    }
    line
}

/// The place on the other side of the midrib, or of the middle of the body.
fn mirrored(mesh: &Mesh, place: Place) -> Place {
    if is_leaf(mesh, place.triangle) {
        let uv = mesh.uv(place);
        return on_leaf(mesh, mesh.parts[place.triangle as usize], Vec2::new(-uv.x, uv.y));
    }
    let at = mesh.point(place);
    nearest(mesh, Vec3::new(2.0 * middle(mesh).x - at.x, at.y, at.z))
}

/// The place of a leaf that is nearest to leaf coordinates.
fn on_leaf(mesh: &Mesh, part: u32, uv: Vec2) -> Place {
    let corners = |t: u32| mesh.triangles[t as usize].map(|v| mesh.uvs[v as usize].extend(0.0));
    let of_part = (0..mesh.triangles.len() as u32).filter(|&t| mesh.parts[t as usize] == part);
    best(of_part, uv.extend(0.0), corners)
}

/// The place of the skin that is nearest to a point.
pub fn nearest(mesh: &Mesh, point: Vec3) -> Place {
    best(0..mesh.triangles.len() as u32, point, |triangle| mesh.corners(triangle))
}

fn best(
    triangles: impl Iterator<Item = u32>,
    point: Vec3,
    corners: impl Fn(u32) -> [Vec3; 3],
) -> Place {
    let mut best = (f32::INFINITY, Place::default());
    for triangle in triangles {
        let [a, b, c] = corners(triangle);
        let [b1, b2] = nearest_in([a, b, c], point);
        let distance = (a + (b - a) * b1 + (c - a) * b2).distance_squared(point);
        if distance < best.0 {
            best = (distance, Place { triangle, b1, b2 });
        }
    }
    best.1
}

/// The barycentric coordinates of the point of a triangle that is nearest to a point: its foot on the plane, or
/// else the nearest point of the nearest side.
fn nearest_in([a, b, c]: [Vec3; 3], point: Vec3) -> [f32; 2] {
    let (u, v, w) = (b - a, c - a, point - a);
    let (uu, uv, vv, wu, wv) = (u.dot(u), u.dot(v), v.dot(v), w.dot(u), w.dot(v));
    let area = uu * vv - uv * uv;
    let [b1, b2] = [(vv * wu - uv * wv) / area, (uu * wv - uv * wu) / area];
    if b1 >= 0.0 && b2 >= 0.0 && b1 + b2 <= 1.0 {
        return [b1, b2];
    }
    let share = |from: Vec3, to: Vec3| {
        let way = to - from;
        ((point - from).dot(way) / way.length_squared().max(f32::MIN_POSITIVE)).clamp(0.0, 1.0)
    };
    let (ab, ac, bc) = (share(a, b), share(a, c), share(b, c));
    let sides = [[ab, 0.0], [0.0, ac], [1.0 - bc, bc]];
    let distance = |[b1, b2]: &[f32; 2]| (a + u * *b1 + v * *b2).distance_squared(point);
    let nearest = sides.into_iter().min_by(|s, t| distance(s).total_cmp(&distance(t)));
    nearest.unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::super::stroke::Brush;
    use super::*;
    use crate::surface::icosphere;
    use crate::tissue::CellType;

    fn stroke(way: Way, is_mirrored: bool, at: Place) -> Stroke {
        let brush = Brush::Put(CellType::Foreground);
        Stroke { brush, radius: 500, way, is_mirrored, points: vec![Spot::of(at)] }
    }

    #[test]
    fn stripes_go_around_and_along_a_ball() {
        let ball = icosphere(4, 10.0);
        let place = nearest(&ball, Vec3::new(6.0, 4.0, 6.0));
        let start = ball.point(Spot::of(place).place());
        let [around, along] = [Way::Around, Way::Along].map(|way| {
            let lines = lines_of(&stroke(way, false, place), &ball).unwrap();
            assert_eq!(lines.len(), 1);
            lines.into_iter().next().unwrap()
        });
        assert!(around.iter().all(|on| (on.at.y - start.y).abs() < 1e-3));
        assert_eq!(around.first(), around.last(), "it comes back");
        let length = |line: &[On]| line.windows(2).map(|w| w[0].at.distance(w[1].at)).sum::<f32>();
        let ring = 2.0 * std::f32::consts::PI * (100.0 - start.y * start.y).sqrt();
        assert!((length(&around) / ring - 1.0).abs() < 0.02, "{} of {ring}", length(&around));
        // From pole to pole.
        let half = 10.0 * std::f32::consts::PI;
        assert!((length(&along) / half - 1.0).abs() < 0.06, "{} of {half}", length(&along));
        for on in around.iter().chain(&along) {
            let place = nearest(&ball, on.at);
            assert!(ball.point(place).distance(on.at) < 1e-3, "it lies on the skin");
        }
    }

    #[test]
    fn the_mirror_image_lies_on_the_other_side() {
        let ball = icosphere(4, 10.0);
        let place = nearest(&ball, Vec3::new(6.0, 4.0, 6.0));
        let lines = lines_of(&stroke(Way::Free, true, place), &ball).unwrap();
        let (here, there) = (lines[0][0].at, lines[1][0].at);
        assert!(there.distance(Vec3::new(-here.x, here.y, here.z)) < 0.1, "{here} {there}");

        let leaf = crate::plants::find("philodendron").unwrap().embedded_body().surface;
        let lines =
            lines_of(&stroke(Way::Free, true, Place { triangle: 40, b1: 0.3, b2: 0.3 }), &leaf);
        let lines = lines.unwrap();
        let uv = |on: On| leaf.uv(nearest(&leaf, on.at));
        let (here, there) = (uv(lines[0][0]), uv(lines[1][0]));
        assert!(there.distance(Vec2::new(-here.x, here.y)) < 0.05, "{here} {there}");
        let across =
            lines_of(&stroke(Way::Around, false, Place { triangle: 40, b1: 0.3, b2: 0.3 }), &leaf);
        let across = &across.unwrap()[0];
        assert!(across.len() > 5 && across.iter().all(|&on| (uv(on).y - here.y).abs() < 0.02));
    }

    #[test]
    fn triangles_that_are_not_there_are_told() {
        let far = stroke(Way::Free, false, Place { triangle: 5000, b1: 0.0, b2: 0.0 });
        assert!(lines_of(&far, &icosphere(1, 1.0)).unwrap_err().contains("triangle 5000"));
    }
}
