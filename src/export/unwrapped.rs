//! A surface cut into pieces that lie flat, side by side in a square: where its texture has which part of it.

use super::packing::pack;
use crate::surface::{Mesh, NO_TWIN, cut_into_patches};
use glam::{DVec2, Vec2};

/// Pieces are laid flat with what lies within this share of the side of a square as large as the surface: gaps as wide
/// as a third of it are torn ones, and pieces narrower than half of it may be bent.
const REACH: f32 = 0.1;

/// Ways to lay a piece that are tried, over a quarter of a turn: that which takes the least room is taken.
const TURNS: usize = 16;

/// A mesh in the square of its texture.
pub(super) struct Unwrapped {
    /// The number of each corner on the mesh, and its place in the square, in pixels to the right and down. Where
    /// pieces are cut apart, a vertex of the mesh has several.
    pub corners: Vec<(u32, Vec2)>,
    /// Piece by piece.
    pub triangles: Vec<Unwound>,
    pub px_per_cm: f64,
}

/// A triangle of the mesh in the square.
pub(super) struct Unwound {
    pub triangle: u32,
    pub corners: [u32; 3],
    /// Whether its piece ends here.
    pub is_rim: bool,
}

/// A piece in a plane of its own, in centimetres, y down.
struct Piece {
    /// Corners and triangles as above, from the first of the piece on.
    corners: Vec<(u32, Vec2)>,
    triangles: Vec<u32>,
    size: Vec2,
}

impl Unwrapped {
    /// # Errors
    /// In plain words, why a square of so many pixels has no room for it.
    pub fn new(mesh: &Mesh, side_px: u32) -> Result<Unwrapped, String> {
        let mut pieces = Vec::new();
        let reach_cm = REACH * mesh.area.sqrt();
        cut_into_patches(mesh, f32::INFINITY, reach_cm, 0.0, |patch| {
            let own = &patch.images[..patch.own];
            pieces.push(Piece::new(mesh, own.iter().map(|own| (own.triangle, own.laid.corners()))));
            true
        });
        let sizes: Vec<DVec2> = pieces.iter().map(|piece| piece.size.as_dvec2()).collect();
        let (px_per_cm, places) = pack(&sizes, side_px as usize);
        if px_per_cm == 0.0 {
            return Err(format!(
                "{} pieces have no room in {side_px} pixels: more are needed",
                pieces.len()
            ));
        }
        let mut piece_of = vec![0; mesh.triangles.len()];
        for (piece, number) in pieces.iter().zip(0..) {
            piece.triangles.iter().for_each(|&triangle| piece_of[triangle as usize] = number);
        }
        let mut all = Unwrapped { corners: Vec::new(), triangles: Vec::new(), px_per_cm };
        for (piece, place) in pieces.iter().zip(places) {
            let place = Vec2::from(place.map(|px| px as f32));
            let first = all.corners.len() as u32;
            let in_square = |&(vertex, at): &(u32, Vec2)| (vertex, place + at * px_per_cm as f32);
            all.corners.extend(piece.corners.iter().map(in_square));
            for &triangle in &piece.triangles {
                let t = triangle as usize;
                let ends =
                    |&twin: &u32| twin == NO_TWIN || piece_of[twin as usize / 3] != piece_of[t];
                let is_rim = mesh.twins[3 * t..3 * t + 3].iter().any(ends);
                let corners = mesh.triangles[t].map(|vertex| first + piece.corner_of(vertex));
                all.triangles.push(Unwound { triangle, corners, is_rim });
            }
        }
        Ok(all)
    }
}

impl Piece {
    fn new(mesh: &Mesh, own: impl Iterator<Item = (u32, [Vec2; 3])>) -> Piece {
        let (mut corners, mut triangles) = (Vec::new(), Vec::new());
        for (triangle, laid) in own {
            corners.extend(mesh.triangles[triangle as usize].into_iter().zip(laid));
            triangles.push(triangle);
        }
        // Those of a piece that was fitted together are alike.
        corners.sort_by_key(|&(vertex, _)| vertex);
        corners.dedup_by_key(|&mut (vertex, _)| vertex);
        let turned = |turn: usize| {
            let angle = std::f32::consts::FRAC_PI_2 * turn as f32 / TURNS as f32;
            let (sin, cos) = libm::sincosf(angle);
            move |at: Vec2| Vec2::new(cos * at.x - sin * at.y, -sin * at.x - cos * at.y)
        };
        let ends = |turn: usize| {
            let places = corners.iter().map(|&(_, at)| turned(turn)(at));
            places.fold([Vec2::INFINITY, Vec2::NEG_INFINITY], |[low, high], at| {
                [low.min(at), high.max(at)]
            })
        };
        let room = |turn: &usize| {
            let [low, high] = ends(*turn);
            (high - low).element_product()
        };
        let best = (0..TURNS).min_by(|a, b| room(a).total_cmp(&room(b))).unwrap_or(0);
        let [low, high] = ends(best);
        corners.iter_mut().for_each(|(_, at)| *at = turned(best)(*at) - low);
        Piece { corners, triangles, size: high - low }
    }

    /// The number of the corner at a vertex.
    fn corner_of(&self, vertex: u32) -> u32 {
        self.corners.partition_point(|&(other, _)| other < vertex) as u32
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants;

    #[test]
    fn every_triangle_of_every_plant_has_its_own_room_and_nearly_its_shape() {
        const SIDE_PX: usize = 1024;
        for plant in plants::all() {
            let mesh = plant.embedded_body().surface;
            let unwrapped = Unwrapped::new(&mesh, SIDE_PX as u32).unwrap();
            let mut all: Vec<u32> = unwrapped.triangles.iter().map(|own| own.triangle).collect();
            all.sort_unstable();
            assert!(all.into_iter().eq(0..mesh.triangles.len() as u32), "{}", plant.key);
            let per_cm2 = (unwrapped.px_per_cm * unwrapped.px_per_cm) as f32;
            let (mut taken, mut twice, mut count) = (vec![false; SIDE_PX * SIDE_PX], 0, 0);
            let (mut off, mut covered) = (0.0, 0.0);
            for own in &unwrapped.triangles {
                let [a, b, c] = own.corners.map(|k| unwrapped.corners[k as usize].1);
                // y is down, so that triangles run the other way.
                let area = 0.5 * (c - a).perp_dot(b - a);
                assert!(area > 0.0, "{}: on its back", plant.key);
                let expected = mesh.areas[own.triangle as usize] * per_cm2;
                off += (area - expected).abs();
                covered += expected;
                let (low, high) = (a.min(b).min(c), a.max(b).max(c));
                assert!(low.min_element() >= 8.0 && high.max_element() <= SIDE_PX as f32 - 7.0);
                // Points well within it.
                for y in low.y.ceil() as usize..=high.y as usize {
                    for x in low.x.ceil() as usize..=high.x as usize {
                        let at = Vec2::new(x as f32, y as f32);
                        let within =
                            |p: Vec2, q: Vec2| (at - p).perp_dot(q - p) > 0.3 * p.distance(q);
                        if within(a, b) && within(b, c) && within(c, a) {
                            count += 1;
                            twice +=
                                usize::from(std::mem::replace(&mut taken[y * SIDE_PX + x], true));
                        }
                    }
                }
            }
            assert!(twice * 1000 <= count, "{}: {twice} of {count} lie on others", plant.key);
            assert!(off < 0.05 * covered, "{}: areas are off by {}", plant.key, off / covered);
            let share = covered / (SIDE_PX * SIDE_PX) as f32;
            assert!(share > 0.2, "{}: it takes {share} of the square", plant.key);
        }
    }
}
