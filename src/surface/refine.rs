//! Catmull-Clark subdivision: a small control mesh becomes a smooth body at load.
//!
//! E. Catmull, J. Clark, Recursively generated B-spline surfaces on arbitrary topological meshes,
//! Computer-Aided Design 10 (1978); rims as in H. Biermann, A. Levin, D. Zorin, Piecewise smooth
//! subdivision surfaces with normal control, SIGGRAPH 2000.

use super::{Face, Group, Line, PolygonMesh};
use glam::Vec2;
use std::collections::{BTreeMap, HashMap};
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
    /// If a face names a vertex that is not there (`parse` makes no such mesh).
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
        let mut whole = PolygonMesh { groups: self.groups.clone(), ..PolygonMesh::default() };
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
        if !whole.uvs.is_empty() {
            whole.uvs.resize(whole.positions.len(), Vec2::ZERO);
        }
        whole
    }

    /// These faces alone, with the vertices that they use.
    fn cut_out(&self, faces: &[&Face]) -> PolygonMesh {
        let mut cut = PolygonMesh { groups: self.groups.clone(), ..PolygonMesh::default() };
        let mut numbers = HashMap::new();
        for face in faces {
            let vertices = face.vertices.iter().map(|&old| {
                *numbers.entry(old).or_insert_with(|| {
                    cut.positions.push(self.positions[old as usize]);
                    cut.uvs.extend(self.uvs.get(old as usize));
                    cut.positions.len() as u32 - 1
                })
            });
            cut.faces.push(Face { vertices: vertices.collect(), group: face.group });
        }
        cut
    }

    /// Adds the vertices and faces of a mesh with the same groups.
    fn append(&mut self, other: PolygonMesh) {
        let first = self.positions.len() as u32;
        self.positions.extend(other.positions);
        self.uvs.extend(other.uvs);
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
        let mut numbers = HashMap::new();
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
                let number = *numbers.entry(ends).or_insert(net.edges.len() as u32);
                if number as usize == net.edges.len() {
                    net.edges.push(Edge { ends, faces: Vec::with_capacity(2) });
                }
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
mod tests {
    use super::super::Body;
    use super::*;
    use glam::Vec3;

    fn cube() -> PolygonMesh {
        let mut text = String::new();
        for k in 0..8 {
            let sign = |bit: i32| if k >> bit & 1 == 1 { 1 } else { -1 };
            text += &format!("v {} {} {}\n", sign(0), sign(1), sign(2));
        }
        text += "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
        PolygonMesh::parse(&text).unwrap()
    }

    /// A sheet of `n` by `n` squares in the plane y = 0, with texture coordinates like its places.
    fn sheet(n: usize) -> PolygonMesh {
        let mut text = String::new();
        for k in 0..(n + 1) * (n + 1) {
            let (x, z) = (k % (n + 1), k / (n + 1));
            text += &format!("v {x} 0 {z}\nvt {x} {z}\n");
        }
        for k in 0..n * n {
            let a = k / n * (n + 1) + k % n + 1;
            let (b, c, d) = (a + n + 1, a + n + 2, a + 1);
            text += &format!("f {a}/{a} {b}/{b} {c}/{c} {d}/{d}\n");
        }
        PolygonMesh::parse(&text).unwrap()
    }

    #[test]
    fn corners_that_repeat_and_faces_without_three_make_no_difference() {
        let mut repeating = cube();
        let first = repeating.faces[0].vertices.clone();
        repeating.faces[0].vertices =
            first.iter().chain(&first[..1]).flat_map(|&v| [v, v]).collect();
        for vertices in [vec![0, 0, 1, 1, 0], vec![2, 2], vec![]] {
            repeating.faces.push(Face { vertices, group: 0 });
        }
        assert_eq!(repeating.refined(1), cube().refined(1));
    }

    #[test]
    fn the_rim_of_a_sheet_becomes_a_cubic_b_spline() {
        // An eighth of each neighbour along the rim and six of the vertex; the one within stays in the middle.
        let finer = sheet(2).refined(1);
        let places: Vec<[f32; 2]> = finer.positions[..9].iter().map(|p| [p.x, p.z]).collect();
        let rows = [0.125, 1.0, 1.875].map(|z| [[0.125, z], [1.0, z], [1.875, z]]);
        let mut expected = rows.concat();
        // Where the rim is straight it stays.
        for (k, place) in [(1, [1.0, 0.0]), (3, [0.0, 1.0]), (5, [2.0, 1.0]), (7, [1.0, 2.0])] {
            expected[k] = place;
        }
        assert_eq!(places, expected);
    }

    #[test]
    fn a_cube_becomes_a_closed_ball() {
        let ball = cube().refined(4);
        assert_eq!(ball.faces.len(), 6 * 4_usize.pow(4));
        let edges = 2 * ball.faces.len();
        assert_eq!(ball.positions.len() + ball.faces.len(), edges + 2, "Euler characteristic 2");
        let radii = || ball.positions.iter().map(|p| p.length());
        let (least, most) = (radii().fold(f32::MAX, f32::min), radii().fold(0.0, f32::max));
        assert!(most / least < 1.12, "radii from {least} to {most}");
        let body = Body::new(&ball).unwrap();
        body.surface.check().unwrap();
        assert_eq!(body.surface.part_count(), 1);
        assert!(body.surface.twins.iter().all(|&twin| twin != crate::surface::NO_TWIN));
        let outward = |t: u32| {
            let [a, b, c] = body.surface.corners(t);
            (b - a).cross(c - a).dot(a + b + c) > 0.0
        };
        assert!((0..body.surface.triangles.len() as u32).all(outward));
    }

    #[test]
    fn a_flat_sheet_stays_flat_with_a_smooth_rim() {
        let mesh = sheet(3).refined(3);
        assert_eq!(mesh.faces.len(), 9 * 64);
        assert!(mesh.positions.iter().all(|p| p.y == 0.0));
        // The texture coordinates went through the same rule as the places.
        assert!(mesh.positions.iter().zip(&mesh.uvs).all(|(p, uv)| p.x == uv.x && p.z == uv.y));
        // The rim is the B-spline of the square: straight in the middle, rounded at the corners.
        let nearest =
            mesh.positions.iter().map(|p| p.distance(Vec3::ZERO)).fold(f32::MAX, f32::min);
        assert!(nearest > 0.2 && nearest < 0.4, "{nearest}");
        let body = Body::new(&mesh).unwrap();
        body.surface.check().unwrap();
        let rims = body.surface.twins.iter().filter(|&&twin| twin == crate::surface::NO_TWIN);
        assert_eq!(rims.count(), 12 * 8);
    }

    #[test]
    fn parts_do_not_pull_at_each_other() {
        let one = sheet(2);
        let mut two = sheet(2);
        let far = one.positions.len() as u32;
        two.positions.extend(one.positions.iter().map(|&p| p + Vec3::Y));
        two.uvs.extend(&one.uvs);
        two.faces.extend(
            one.faces
                .iter()
                .map(|f| Face { vertices: f.vertices.iter().map(|v| v + far).collect(), group: 0 }),
        );
        let (one, two) = (one.refined(2), two.refined(2));
        assert_eq!(two.positions.len(), 2 * one.positions.len());
        assert!(one.positions.iter().all(|p| two.positions.contains(p)));
    }

    #[test]
    fn bare_and_patterned_faces_part_after_refinement() {
        let mut mesh = cube();
        mesh.groups
            .push(crate::surface::Group { part: String::new(), material: "bare:soil".to_string() });
        mesh.faces[0].group = 1;
        let body = Body::new(&mesh.refined(2)).unwrap();
        assert_eq!(body.surface.triangles.len(), 5 * 16 * 2);
        assert_eq!(body.ornaments.len(), 1);
        assert_eq!(body.ornaments[0].material, "soil");
        assert_eq!(body.ornaments[0].triangles.len(), 16 * 2);
    }

    #[test]
    fn each_group_can_have_its_own_levels() {
        let mut mesh = sheet(2);
        let square = Group { part: String::new(), material: String::new() };
        mesh.groups = vec![square, Group { part: "spine".to_string(), material: String::new() }];
        mesh.faces[3].group = 1;
        let mixed = mesh.refined_by(&|group| if group.part.is_empty() { 2 } else { 0 });
        assert_eq!(mixed.faces.len(), 3 * 16 + 1);
        assert_eq!(mixed.uvs.len(), mixed.positions.len());
        assert!(mixed.positions.iter().zip(&mixed.uvs).all(|(p, uv)| p.x == uv.x && p.z == uv.y));
        let even = mesh.refined_by(&|_| 2);
        assert_eq!(even.faces.len(), mesh.refined(2).faces.len());
        assert_eq!(even.positions.len(), mesh.refined(2).positions.len());
    }

    #[test]
    fn odd_meshes_are_refined_too() {
        // Three faces at one edge, a bow tie, a face that folds back, repeated corners, a stray
        // vertex, a triangle and a pentagon.
        let text = "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 1\nv -1 0 0\nv -1 -1 0\nv 0 -1 0\nv 9 9 9\n\
                    f 1 2 3\nf 1 2 4\nf 1 2 5\nf 1 5 6\nf 1 3 7 6 5\nf 1 1 2 2\nf 3 3 3\nf 1 3 4 3 2 1\n";
        let mesh = PolygonMesh::parse(text).unwrap();
        let fine = mesh.refined(3);
        assert!(fine.positions.iter().all(|p| p.is_finite()));
        let count = fine.positions.len() as u32;
        assert!(
            fine.faces
                .iter()
                .all(|f| f.vertices.len() == 4 && f.vertices.iter().all(|&v| v < count))
        );
        assert!(fine.positions.contains(&Vec3::splat(9.0)));
        Body::new(&fine).unwrap().surface.check().unwrap();
    }
}
