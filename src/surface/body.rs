//! A body: the patterned surface of a plant and the bare parts that stand beside it.

use super::veins::Piece;
use super::{ControlImage, Mesh, Moment, Motion, Place, PolygonMesh, Shortest, Veins, Wrap};
use glam::{Vec2, Vec3};
use std::borrow::Cow;

/// What a plant is made of.
#[derive(Clone, Debug)]
pub struct Body {
    /// The surface that carries cells.
    pub surface: Mesh,
    /// Parts without cells: petioles, spines, soil.
    pub ornaments: Vec<Ornament>,
}

/// A part without cells, drawn in the plain colour of its material.
#[derive(Clone, Debug)]
pub struct Ornament {
    /// The name after `bare:`.
    pub material: String,
    pub positions: Vec<Vec3>,
    pub normals: Vec<Vec3>,
    pub triangles: Vec<[u32; 3]>,
    pub motion: Motion,
}

/// Why polygons do not make a body.
#[derive(Clone, Debug, thiserror::Error, PartialEq)]
pub enum SurfaceError {
    #[error("a face names vertex {}, but there are only {count}", .vertex + 1)]
    NoSuchVertex { vertex: u32, count: usize },
    #[error("vertex {} is not a finite number", .vertex + 1)]
    NotFinite { vertex: u32 },
    #[error("the mesh has no surface: every triangle has an area of zero")]
    NoArea,
    #[error("the mesh is too large")]
    TooLarge,
    #[error("the mesh has no part that carries cells: all materials are bare")]
    AllBare,
    #[error("the moment of day {} has {corners} vertices, and the mesh {count}", .day.shortest())]
    OtherCorners { day: f32, corners: usize, count: usize },
    #[error("the moment of day {} does not come after the one before it", .0.shortest())]
    OutOfOrder(f32),
    #[error("on day {} a triangle has no area", .0.shortest())]
    Flat(f32),
}

impl Body {
    /// Splits the polygons into the patterned surface and the bare parts, cuts them into triangles
    /// and joins the triangles to their neighbours.
    ///
    /// # Errors
    /// A face whose vertex is not there or not finite, moments that are not of the mesh, not in the order of
    /// their days or in which a patterned triangle has no area, and what `Mesh::new` refuses.
    pub fn new(polygons: &PolygonMesh) -> Result<Body, SurfaceError> {
        let count = polygons.positions.len();
        let motion = motion(polygons)?;
        let mut triangles = vec![Vec::new(); polygons.groups.len().max(1)];
        for face in &polygons.faces {
            for &vertex in &face.vertices {
                match polygons.positions.get(vertex as usize) {
                    None => return Err(SurfaceError::NoSuchVertex { vertex, count }),
                    Some(p) if !p.is_finite() => return Err(SurfaceError::NotFinite { vertex }),
                    Some(_) => {}
                }
            }
            triangulate(&polygons.positions, &face.vertices, &mut triangles[face.group as usize]);
        }
        let mut patterned = Vec::new();
        let mut ornaments = Vec::new();
        for (group, corners) in triangles.into_iter().enumerate() {
            match polygons.bare_name(group) {
                None => patterned.extend(corners),
                Some(material) => ornaments.push(ornament(material, polygons, &motion, &corners)),
            }
        }
        if patterned.is_empty() && !ornaments.is_empty() {
            return Err(SurfaceError::AllBare);
        }
        let (old, triangles) = compact(&patterned);
        let positions = old.iter().map(|&v| polygons.positions[v as usize]).collect();
        let uvs: Vec<Vec2> = if polygons.uvs.is_empty() {
            Vec::new()
        } else {
            old.iter().map(|&v| polygons.uvs[v as usize]).collect()
        };
        let mut surface = Mesh::new(positions, uvs, triangles)?;
        surface.veins = Veins::new(pieces(polygons)?, &surface);
        surface.motion = motion.of(&old);
        match surface.flattened() {
            Some(day) => Err(SurfaceError::Flat(day)),
            None => Ok(Body { surface, ornaments }),
        }
    }

    /// The body as it stands on a day.
    pub fn on(&self, day: u32) -> Cow<'_, Body> {
        match self.surface.on(day) {
            Cow::Borrowed(_) => Cow::Borrowed(self),
            Cow::Owned(surface) => {
                let ornaments = self.ornaments.iter().map(|part| part.on(day)).collect();
                Cow::Owned(Body { surface, ornaments })
            }
        }
    }

    /// The ball around the box around it with all its bare parts, at all its moments: its centre, its radius, and
    /// how low it reaches.
    pub fn ball(&self) -> (Vec3, f32, f32) {
        let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        self.visit(&mut |p| (low, high) = (low.min(p), high.max(p)));
        let centre = (low + high) * 0.5;
        let mut squared = 0.0f32;
        self.visit(&mut |p| squared = squared.max(p.distance_squared(centre)));
        (centre, squared.sqrt(), low.y)
    }

    /// Visits where its corners ever are.
    fn visit(&self, visit: &mut dyn FnMut(Vec3)) {
        let mut of = |positions: &[Vec3], motion: &Motion| {
            positions.iter().for_each(|&p| visit(p));
            for moment in motion.moments() {
                moment.positions.iter().for_each(|&p| visit(p));
            }
        };
        of(&self.surface.positions, &self.surface.motion);
        for part in &self.ornaments {
            of(&part.positions, &part.motion);
        }
    }

    /// No pattern where a control image is black (Thesis 3.2.3): the triangles whose centres lie
    /// there are taken out of the patterned surface and become one bare part more, so that no cell
    /// ever comes there. The rest must not be empty.
    pub fn bared(
        mut self,
        wrap: &Wrap,
        image: &ControlImage,
        material: &str,
    ) -> Result<Body, SurfaceError> {
        let whole = &self.surface;
        let patterned = |triangle: u32| {
            let centre = Place { triangle, b1: 1.0 / 3.0, b2: 1.0 / 3.0 };
            let (turns, height) = wrap.coordinates(image, whole, centre);
            image.is_white(turns, height)
        };
        let (kept, covered): (Vec<u32>, Vec<u32>) =
            (0..whole.triangles.len() as u32).partition(|&t| patterned(t));
        if kept.is_empty() {
            return Err(SurfaceError::AllBare);
        }
        if covered.is_empty() {
            return Ok(self);
        }
        let cut = |numbers: &[u32]| {
            compact(&numbers.iter().map(|&t| whole.triangles[t as usize]).collect::<Vec<_>>())
        };
        let of_old = |all: &[Vec3], old: &[u32]| old.iter().map(|&v| all[v as usize]).collect();
        let (old, triangles) = cut(&covered);
        // Normals of the whole surface, so that no edge shows where the pattern ends.
        let bare = Ornament {
            material: material.to_string(),
            positions: of_old(&whole.positions, &old),
            normals: of_old(&whole.normals, &old),
            triangles,
            motion: whole.motion.of(&old),
        };
        let (old, triangles) = cut(&kept);
        let uvs = old.iter().filter_map(|&v| whole.uvs.get(v as usize).copied()).collect();
        let mut surface = Mesh::new(of_old(&whole.positions, &old), uvs, triangles)?;
        surface.normals = of_old(&whole.normals, &old);
        surface.veins = Veins::new(whole.veins.pieces.clone(), &surface);
        surface.motion = whole.motion.of(&old);
        self.surface = surface;
        self.ornaments.push(bare);
        Ok(self)
    }
}

/// The straight pieces of veins.
fn pieces(polygons: &PolygonMesh) -> Result<Vec<Piece>, SurfaceError> {
    let at = |&vertex: &u32| {
        let point = polygons.positions[vertex as usize];
        if point.is_finite() { Ok(point) } else { Err(SurfaceError::NotFinite { vertex }) }
    };
    let mut pieces = Vec::new();
    for line in &polygons.lines {
        for ends in line.vertices.windows(2) {
            pieces.push(Piece { order: line.order, ends: [at(&ends[0])?, at(&ends[1])?] });
        }
    }
    Ok(pieces)
}

/// Cuts a convex polygon into triangles. Quads are cut along their shorter diagonal, larger polygons as
/// a fan from their first corner.
pub(super) fn triangulate(positions: &[Vec3], corners: &[u32], out: &mut Vec<[u32; 3]>) {
    let at = |k: usize| positions[corners[k] as usize];
    if corners.len() == 4 && at(1).distance_squared(at(3)) < at(0).distance_squared(at(2)) {
        out.push([corners[0], corners[1], corners[3]]);
        out.push([corners[1], corners[2], corners[3]]);
        return;
    }
    for k in 2..corners.len() {
        out.push([corners[0], corners[k - 1], corners[k]]);
    }
}

impl Ornament {
    /// The part as it stands on a day.
    pub fn on(&self, day: u32) -> Ornament {
        let Some(positions) = self.motion.on(day as f32) else { return self.clone() };
        let normals = super::mesh::vertex_normals(&positions, &self.triangles);
        Ornament { positions, normals, motion: Motion::default(), ..self.clone() }
    }
}

/// The ways of all vertices.
fn motion(polygons: &PolygonMesh) -> Result<Motion, SurfaceError> {
    let count = polygons.positions.len();
    let mut last_day = f32::NEG_INFINITY;
    for Moment { day, positions } in &polygons.moments {
        if positions.len() != count {
            return Err(SurfaceError::OtherCorners { day: *day, corners: positions.len(), count });
        }
        if let Some(vertex) = positions.iter().position(|p| !p.is_finite()) {
            return Err(SurfaceError::NotFinite { vertex: vertex as u32 });
        }
        if !(*day > last_day && day.is_finite()) {
            return Err(SurfaceError::OutOfOrder(*day));
        }
        last_day = *day;
    }
    Ok(Motion::new(polygons.moments.clone()))
}

fn ornament(
    material: &str,
    polygons: &PolygonMesh,
    motion: &Motion,
    corners: &[[u32; 3]],
) -> Ornament {
    let (old, triangles) = compact(corners);
    let positions: Vec<Vec3> = old.iter().map(|&v| polygons.positions[v as usize]).collect();
    let normals = super::mesh::vertex_normals(&positions, &triangles);
    let motion = motion.of(&old);
    Ornament { material: material.to_string(), positions, normals, triangles, motion }
}

/// Renumbers the vertices in the order of their first use; returns the old numbers as well.
fn compact(triangles: &[[u32; 3]]) -> (Vec<u32>, Vec<[u32; 3]>) {
    const UNUSED: u32 = u32::MAX;
    let largest = triangles.iter().flatten().max().map_or(0, |&v| v as usize);
    let mut new = vec![UNUSED; largest + 1];
    let mut old = Vec::new();
    let renumbered = triangles
        .iter()
        .map(|t| {
            t.map(|v| {
                let number = &mut new[v as usize];
                if *number == UNUSED {
                    *number = old.len() as u32;
                    old.push(v);
                }
                *number
            })
        })
        .collect();
    (old, renumbered)
}
