//! Catmull-Clark subdivision: a small control mesh becomes a smooth body at load.
//!
//! E. Catmull, J. Clark, Recursively generated B-spline surfaces on arbitrary topological meshes,
//! Computer-Aided Design 10 (1978); rims as in H. Biermann, A. Levin, D. Zorin, Piecewise smooth
//! subdivision surfaces with normal control, SIGGRAPH 2000.

use super::{Face, Group, Line, Moment, PolygonMesh};
use glam::Vec2;
use std::collections::BTreeMap;
use std::ops::{Add, Mul};

impl PolygonMesh {
    /// `levels` rounds of Catmull-Clark subdivision; texture coordinates are carried along, veins are not. Rims of
    /// open surfaces become cubic B-spline curves that depend on the rim alone, so that parts which
    /// share a rim but no vertices stay together. Only `+ - * /`, so that every machine gets the
    /// same bits.
    ///
    /// Where more than two faces share an edge, the edge is taken as a rim; where several rims meet
    /// in a vertex, the vertex stays. Edges without length and faces that they leave with fewer
    /// than three corners go.
    ///
    /// # Panics
    /// If a face names a vertex that is not there (`parse` makes no such mesh), also at a moment.
    pub fn refined(&self, levels: u32) -> PolygonMesh {
        (0..levels).fold(self.clone(), |mesh, _| mesh.refined_once())
    }

    /// As `refined`, with a number of levels for each group: spines need none where the skin needs
    /// some. Groups with different numbers are taken apart; those with the same number that share
    /// vertices go on doing so.
    ///
    /// # Panics
    /// As `refined`.
    pub fn refined_by(&self, levels: &dyn Fn(&Group) -> u32) -> PolygonMesh {
        let unnamed = Group { part: String::new(), material: String::new() };
        let level_of =
            |face: &Face| levels(self.groups.get(face.group as usize).unwrap_or(&unnamed));
        let mut by_level: BTreeMap<u32, Vec<&Face>> = BTreeMap::new();
        for face in &self.faces {
            by_level.entry(level_of(face)).or_default().push(face);
        }
        let mut whole = self.empty();
        for (level, faces) in by_level {
            whole.append(self.cut_out(&faces).refined(level));
        }
        // Veins lie on the refined surface, as they are.
        for line in &self.lines {
            let first = whole.positions.len() as u32;
            whole.positions.extend(line.vertices.iter().map(|&v| self.positions[v as usize]));
            let vertices = (first..whole.positions.len() as u32).collect();
            whole.lines.push(Line { vertices, ..*line });
        }
        for (moment, before) in whole.moments.iter_mut().zip(&self.moments) {
            let on_veins = self.lines.iter().flat_map(|line| &line.vertices);
            moment.positions.extend(on_veins.map(|&v| before.positions[v as usize]));
        }
        if !whole.uvs.is_empty() {
            whole.uvs.resize(whole.positions.len(), Vec2::ZERO);
        }
        whole
    }

    /// These faces alone, with the vertices that they use.
    fn cut_out(&self, faces: &[&Face]) -> PolygonMesh {
        let mut cut = self.empty();
        const UNUSED: u32 = u32::MAX;
        let mut numbers = vec![UNUSED; self.positions.len()];
        for face in faces {
            let vertices = face.vertices.iter().map(|&old| {
                let number = &mut numbers[old as usize];
                if *number == UNUSED {
                    *number = cut.positions.len() as u32;
                    cut.positions.push(self.positions[old as usize]);
                    cut.uvs.extend(self.uvs.get(old as usize));
                    for (moment, whole) in cut.moments.iter_mut().zip(&self.moments) {
                        moment.positions.push(whole.positions[old as usize]);
                    }
                }
                *number
            });
            cut.faces.push(Face { vertices: vertices.collect(), group: face.group });
        }
        cut
    }

    /// The same groups and the days of the same moments, and nothing else.
    fn empty(&self) -> PolygonMesh {
        let empty = |moment: &Moment| Moment { day: moment.day, positions: Vec::new() };
        PolygonMesh {
            groups: self.groups.clone(),
            moments: self.moments.iter().map(empty).collect(),
            ..PolygonMesh::default()
        }
    }

    /// Adds the vertices and faces of a mesh with the same groups and moments.
    fn append(&mut self, other: PolygonMesh) {
        let first = self.positions.len() as u32;
        self.positions.extend(other.positions);
        self.uvs.extend(other.uvs);
        for (moment, more) in self.moments.iter_mut().zip(other.moments) {
            moment.positions.extend(more.positions);
        }
        self.faces.extend(other.faces.into_iter().map(|face| Face {
            vertices: face.vertices.iter().map(|v| v + first).collect(),
            group: face.group,
        }));
    }

    fn refined_once(&self) -> PolygonMesh {
        let net = Net::new(&self.faces);
        PolygonMesh {
            positions: net.subdivide(&self.positions),
            uvs: if self.uvs.is_empty() { Vec::new() } else { net.subdivide(&self.uvs) },
            faces: net.quads(self.positions.len()),
            groups: self.groups.clone(),
            lines: Vec::new(),
            moments: self
                .moments
                .iter()
                .map(|moment| Moment {
                    day: moment.day,
                    positions: net.subdivide(&moment.positions),
                })
                .collect(),
        }
    }
}

/// The faces of a mesh and their edges.
struct Net {
    faces: Vec<Face>,
    /// For each face the edge from each of its corners to the next.
    face_edges: Vec<Vec<u32>>,
    edges: Vec<Edge>,
}

struct Edge {
    ends: [u32; 2],
    faces: Vec<u32>,
}

impl Net {
    fn new(faces: &[Face]) -> Net {
        let mut net = Net { faces: Vec::new(), face_edges: Vec::new(), edges: Vec::new() };
        // For each vertex the edges to later ones, few, with their numbers.
        let mut edges_of: Vec<Vec<(u32, u32)>> = Vec::new();
        for face in faces {
            let mut vertices = face.vertices.clone();
            vertices.dedup();
            while vertices.len() > 1 && vertices.first() == vertices.last() {
                vertices.pop();
            }
            if vertices.len() < 3 {
                continue;
            }
            let corners = vertices.len();
            let face_edges = (0..corners).map(|k| {
                let (a, b) = (vertices[k], vertices[(k + 1) % corners]);
                let ends = [a.min(b), a.max(b)];
                if edges_of.len() <= ends[0] as usize {
                    edges_of.resize(ends[0] as usize + 1, Vec::new());
                }
                let known = &mut edges_of[ends[0] as usize];
                let number = match known.iter().find(|(end, _)| *end == ends[1]) {
                    Some(&(_, number)) => number,
                    None => {
                        net.edges.push(Edge { ends, faces: Vec::with_capacity(2) });
                        known.push((ends[1], net.edges.len() as u32 - 1));
                        net.edges.len() as u32 - 1
                    }
                };
                net.edges[number as usize].faces.push(net.faces.len() as u32);
                number
            });
            let face_edges = face_edges.collect();
            net.face_edges.push(face_edges);
            net.faces.push(Face { vertices, group: face.group });
        }
        net
    }

    /// New values of the old vertices, then one value per edge, then one per face.
    fn subdivide<T>(&self, old: &[T]) -> Vec<T>
    where
        T: Copy + Default + Add<Output = T> + Mul<f32, Output = T>,
    {
        let at = |v: u32| old[v as usize];
        let face_points: Vec<T> =
            self.faces.iter().map(|f| mean(f.vertices.iter().map(|&v| at(v)))).collect();
        let middle = |edge: &Edge| (at(edge.ends[0]) + at(edge.ends[1])) * 0.5;
        let edge_points = self.edges.iter().map(|edge| match *edge.faces {
            [a, b] => {
                (middle(edge) + (face_points[a as usize] + face_points[b as usize]) * 0.5) * 0.5
            }
            _ => middle(edge),
        });

        let mut around: Vec<Around<T>> = vec![Around::default(); old.len()];
        for (face, &point) in self.faces.iter().zip(&face_points) {
            for &v in &face.vertices {
                around[v as usize].add_face(point);
            }
        }
        for edge in &self.edges {
            let is_rim = edge.faces.len() != 2;
            for v in edge.ends {
                around[v as usize].add_edge(middle(edge), is_rim);
            }
        }
        let vertex_points = around.iter().zip(old).map(|(a, &p)| a.vertex_point(p));
        vertex_points.chain(edge_points).chain(face_points.iter().copied()).collect()
    }

    /// The faces of the finer mesh: one quad per corner of each old face.
    fn quads(&self, old_vertices: usize) -> Vec<Face> {
        let edge_vertex = |edge: u32| old_vertices as u32 + edge;
        let first_face_vertex = old_vertices + self.edges.len();
        let mut quads = Vec::with_capacity(4 * self.faces.len());
        for (f, (face, edges)) in self.faces.iter().zip(&self.face_edges).enumerate() {
            let corners = face.vertices.len();
            for (k, &vertex) in face.vertices.iter().enumerate() {
                let next = edge_vertex(edges[k]);
                let last = edge_vertex(edges[(k + corners - 1) % corners]);
                let vertices = vec![vertex, next, (first_face_vertex + f) as u32, last];
                quads.push(Face { vertices, group: face.group });
            }
        }
        quads
    }
}

/// What surrounds a vertex: sums and numbers of face points, edge middles and rim middles.
#[derive(Clone, Copy, Default)]
struct Around<T> {
    faces: (T, u32),
    edges: (T, u32),
    rims: (T, u32),
}

impl<T: Copy + Add<Output = T> + Mul<f32, Output = T>> Around<T> {
    fn add_face(&mut self, point: T) {
        self.faces = (self.faces.0 + point, self.faces.1 + 1);
    }

    fn add_edge(&mut self, middle: T, is_rim: bool) {
        self.edges = (self.edges.0 + middle, self.edges.1 + 1);
        if is_rim {
            self.rims = (self.rims.0 + middle, self.rims.1 + 1);
        }
    }

    fn vertex_point(&self, p: T) -> T {
        match self.rims.1 {
            0 if self.faces.1 > 0 => {
                let n = self.faces.1 as f32;
                let (faces, edges) =
                    (self.faces.0 * (1.0 / n), self.edges.0 * (1.0 / self.edges.1 as f32));
                (faces + edges * 2.0 + p * (n - 3.0)) * (1.0 / n)
            }
            // The middles of the two rim edges already hold half of the vertex.
            2 => self.rims.0 * 0.25 + p * 0.5,
            _ => p,
        }
    }
}

fn mean<T: Copy + Default + Add<Output = T> + Mul<f32, Output = T>>(
    values: impl ExactSizeIterator<Item = T>,
) -> T {
    let count = values.len() as f32;
    values.fold(T::default(), |sum, value| sum + value) * (1.0 / count)
}

#[cfg(test)]
mod tests;
