//! Faces that lie side by side without sharing vertices, and faces that stand twice: as programs write
//! them that give each face, or each side of a seam, vertices of its own.

use super::{Face, Moment, PolygonMesh};
use glam::{DVec3, Vec2};
use std::collections::{HashMap, HashSet};
use std::hash::Hash;

/// For each vertex the first one whose corner is exactly at the same place, at rest and at all moments.
pub fn same_places(places: &[DVec3], moments: &[Moment]) -> Vec<u32> {
    // 0 is added so that -0 is 0.
    let mut same = firsts(places.iter().map(|place| place.to_array().map(|x| (x + 0.0).to_bits())));
    for Moment { positions, .. } in moments {
        let then = positions.iter().map(|place| place.to_array().map(|x| (x + 0.0).to_bits()));
        same = firsts(same.iter().zip(then));
    }
    same
}

/// For each key the number of the first that is the same.
fn firsts<K: Hash + Eq>(keys: impl Iterator<Item = K>) -> Vec<u32> {
    let mut first = HashMap::new();
    (0..).zip(keys).map(|(number, key)| *first.entry(key).or_insert(number)).collect()
}

/// The faces without corners that repeat the place before, without what is no polygon then, and each
/// once of those whose corners have the same places in the same order, in any rotation or orientation.
///
/// A closed part keeps all its faces if one of them stands once: two cubes that touch with a whole side
/// stay closed.
pub fn once(mut faces: Vec<Face>, same: &[u32]) -> Vec<Face> {
    for face in &mut faces {
        let place = |v: u32| same[v as usize];
        let corners = &mut face.vertices;
        corners.dedup_by_key(|v| place(*v));
        while corners.len() > 1 && place(corners[0]) == place(corners[corners.len() - 1]) {
            corners.pop();
        }
    }
    faces.retain(|face| face.vertices.len() >= 3);
    let mut seen = HashSet::new();
    faces.retain(|face| seen.insert(outline(face.vertices.clone())));

    let outlines: Vec<Vec<u32>> = faces
        .iter()
        .map(|face| outline(face.vertices.iter().map(|&v| same[v as usize]).collect()))
        .collect();
    let mut times: HashMap<&[u32], u32> = HashMap::new();
    for outline in &outlines {
        *times.entry(outline).or_default() += 1;
    }
    let is_solid = solid(&faces, |face| times[&*outlines[face]] == 1);
    let mut taken: HashSet<&[u32]> =
        (0..faces.len()).filter(|&f| is_solid[f]).map(|f| &*outlines[f]).collect();
    let mut keep = is_solid.iter().zip(&outlines).map(|(solid, o)| *solid || taken.insert(o));
    faces.retain(|_| keep.next() == Some(true));
    faces
}

/// Joins each rim edge to the one other rim edge with the same two ends, where there is exactly one, and
/// tells how many pairs of rim edges are gone. The vertices of their ends become one; texture
/// coordinates are dropped if these had different ones.
///
/// Vertices at the same place that no such edges lead to stay apart: petals that touch are not one. Where
/// more than two rim edges have the same ends, two are one all the same if the edges around made their
/// ends one.
pub fn join_rims(mesh: &mut PolygonMesh, same: &[u32]) -> usize {
    let mut rims = rims(&mesh.faces);
    let before = rims.len();
    // From one end to the other in the same direction in both.
    for ends in &mut rims {
        ends.sort_unstable_by_key(|&v| same[v as usize]);
    }
    let places = |ends: &[u32; 2]| ends.map(|v| same[v as usize]);
    rims.sort_unstable_by_key(|ends| (places(ends), *ends));
    let mut sets = Sets::new(same.len());
    for alike in rims.chunk_by(|a, b| places(a) == places(b)) {
        if let [one, other] = alike {
            sets.join(one[0], other[0]);
            sets.join(one[1], other[1]);
        }
    }
    let numbers: Vec<u32> = (0..same.len() as u32).map(|v| sets.first(v)).collect();
    let mut named = mesh.faces.iter().flat_map(|face| &face.vertices);
    let uv = |v: u32| mesh.uvs.get(v as usize).copied().unwrap_or(Vec2::ZERO);
    if named.any(|&v| uv(v) != uv(numbers[v as usize])) {
        mesh.uvs.clear();
    }
    for vertex in mesh.faces.iter_mut().flat_map(|face| &mut face.vertices) {
        *vertex = numbers[*vertex as usize];
    }
    before.saturating_sub(self::rims(&mesh.faces).len()) / 2
}

/// The same for every rotation and orientation of a polygon: its corners from the lowest on, towards the
/// lower neighbour.
fn outline(mut corners: Vec<u32>) -> Vec<u32> {
    let lowest = (0..corners.len()).min_by_key(|&k| corners[k]).unwrap_or(0);
    corners.rotate_left(lowest);
    if corners.last() < corners.get(1) {
        corners[1..].reverse();
    }
    corners
}

/// Whether each face belongs to a closed part, by the vertices that faces share, with a face of some kind.
fn solid(faces: &[Face], is_of_kind: impl Fn(usize) -> bool) -> Vec<bool> {
    let mut sets = Sets::new(faces.len());
    let edges = edges(faces);
    for [(_, one), (_, other)] in edges.array_windows().filter(|[a, b]| a.0 == b.0) {
        sets.join(*one, *other);
    }
    let parts: Vec<usize> = (0..faces.len() as u32).map(|f| sets.first(f) as usize).collect();
    let mut is_open = vec![false; faces.len()];
    for alike in edges.chunk_by(|a, b| a.0 == b.0).filter(|alike| alike.len() == 1) {
        is_open[parts[alike[0].1 as usize]] = true;
    }
    let mut has_kind = vec![false; faces.len()];
    for face in (0..faces.len()).filter(|&face| is_of_kind(face)) {
        has_kind[parts[face]] = true;
    }
    parts.iter().map(|&part| has_kind[part] && !is_open[part]).collect()
}

/// The edges of which there is one, by the vertices that faces share.
fn rims(faces: &[Face]) -> Vec<[u32; 2]> {
    let edges = edges(faces);
    let alone = edges.chunk_by(|a, b| a.0 == b.0).filter(|alike| alike.len() == 1);
    alone.map(|alike| alike[0].0).collect()
}

/// The ends, the lower first, and the face of each edge, in order.
fn edges(faces: &[Face]) -> Vec<([u32; 2], u32)> {
    let of_face = |(f, face): (u32, &Face)| {
        let corners = face.vertices.clone();
        let next = |k: usize| corners[(k + 1) % corners.len()];
        let ends = |k: usize| [corners[k].min(next(k)), corners[k].max(next(k))];
        (0..corners.len()).map(|k| (ends(k), f)).collect::<Vec<_>>()
    };
    let mut edges: Vec<_> = (0..).zip(faces).flat_map(of_face).collect();
    edges.sort_unstable();
    edges
}

/// Numbers that become sets (R. Tarjan, Efficiency of a good but not linear set union algorithm, 1975).
struct Sets {
    /// A lower number of the same set, or itself.
    lower: Vec<u32>,
}

impl Sets {
    fn new(count: usize) -> Sets {
        Sets { lower: (0..count as u32).collect() }
    }

    /// The lowest number of the set; the way to it is halved.
    fn first(&mut self, mut number: u32) -> u32 {
        while self.lower[number as usize] != number {
            let lower = self.lower[number as usize];
            self.lower[number as usize] = self.lower[lower as usize];
            number = lower;
        }
        number
    }

    fn join(&mut self, one: u32, other: u32) {
        let (one, other) = (self.first(one), self.first(other));
        self.lower[one.max(other) as usize] = one.min(other);
    }
}
