//! Closes the gaps that curvature leaves between triangles that were laid down one by one.

use super::Mesh;
use super::chart::{Image, image};
use glam::Vec2;
use wide::f32x4;

/// The gaps that unfolding leaves spread over about the square root of so many triangles.
const ROUNDS: usize = 6;

/// Triangles that are fitted side by side.
const LANES: usize = 4;

/// Fits the triangles of a mesh together in the plane.
pub(super) struct Fitting {
    corners: Vec<Corner>,
    /// For each four images those of their triangles' corners.
    arms: Vec<[Arms; 3]>,
    /// For each vertex of the mesh its index in `corners`, if it has one.
    corner_of: Vec<u32>,
}

/// Where triangles meet.
#[derive(Clone, Copy, Debug, Default)]
struct Corner {
    vertex: u32,
    at: Vec2,
    /// The sum of the places that its triangles wish for it, and their number.
    wished: Vec2,
    wishes: f32,
}

/// A corner of each of four triangles, seen from their centroids in their own frames.
#[derive(Clone, Copy, Debug, Default)]
struct Arms {
    /// Their indices in `corners`.
    corners: [u32; LANES],
    x: f32x4,
    y: f32x4,
}

impl Fitting {
    pub(super) fn new(mesh: &Mesh) -> Fitting {
        let corner_of = vec![0; mesh.positions.len()];
        Fitting { corners: Vec::new(), arms: Vec::new(), corner_of }
    }

    /// Moves the images so that their corners meet and each triangle keeps its shape as well as it can
    /// (the local and the global step of O. Sorkine, M. Alexa, As-Rigid-As-Possible Surface Modeling,
    /// SGP 2007, in the plane).
    pub(super) fn fit_together(&mut self, mesh: &Mesh, images: &mut [Image]) {
        self.corners.clear();
        self.arms.clear();
        for four in images.chunks(LANES) {
            let mut arms = [Arms::default(); 3];
            for (lane, image) in four.iter().enumerate() {
                self.take_up(mesh, image, lane, &mut arms);
            }
            self.arms.push(arms);
        }
        for _ in 0..ROUNDS {
            self.corners.iter_mut().for_each(Corner::settle);
            let arms = std::mem::take(&mut self.arms);
            for (arms, four) in arms.iter().zip(images.chunks(LANES)) {
                self.wish(arms, four.len());
            }
            self.arms = arms;
        }
        self.corners.iter_mut().for_each(Corner::settle);
        for (k, known) in images.iter_mut().enumerate() {
            let corners =
                self.arms[k / LANES].map(|arms| self.corners[arms.corners[k % LANES] as usize].at);
            *known = image(known.triangle, 0.0, corners);
        }
    }

    /// Notes the corners of an image, in a lane of its four.
    fn take_up(&mut self, mesh: &Mesh, image: &Image, lane: usize, arms: &mut [Arms; 3]) {
        let vertices = mesh.triangles[image.triangle as usize];
        let corners = image.laid.corners();
        let shape = mesh.frames[image.triangle as usize].corners();
        let centroid = (shape[1] + shape[2]) / 3.0;
        for (k, arm) in arms.iter_mut().enumerate() {
            let known = self.corner_of[vertices[k] as usize] as usize;
            let corner = match self.corners.get(known) {
                Some(c) if c.vertex == vertices[k] => known,
                _ => {
                    self.corner_of[vertices[k] as usize] = self.corners.len() as u32;
                    self.corners.push(Corner { vertex: vertices[k], ..Corner::default() });
                    self.corners.len() - 1
                }
            };
            self.corners[corner].wish(corners[k]);
            arm.corners[lane] = corner as u32;
            let from_centroid = shape[k] - centroid;
            arm.x.as_mut_array()[lane] = from_centroid.x;
            arm.y.as_mut_array()[lane] = from_centroid.y;
        }
    }

    /// Wishes for the corners of up to four triangles the places that leave these their shapes.
    #[inline]
    fn wish(&mut self, arms: &[Arms; 3], triangles: usize) {
        let now = arms.map(|arm| {
            let at = arm.corners.map(|corner| self.corners[corner as usize].at);
            (f32x4::new(at.map(|at| at.x)), f32x4::new(at.map(|at| at.y)))
        });
        let mean = |[a, b, c]: [f32x4; 3]| (a + b + c) / f32x4::splat(3.0);
        let middle = (mean(now.map(|at| at.0)), mean(now.map(|at| at.1)));
        // The rotation that fits best, as a complex number; none where there is no best one.
        let (mut cos, mut sin) = (f32x4::ZERO, f32x4::ZERO);
        for (arm, now) in arms.iter().zip(now) {
            let (x, y) = (now.0 - middle.0, now.1 - middle.1);
            cos += arm.x * x + arm.y * y;
            sin += arm.x * y - arm.y * x;
        }
        let per_length = f32x4::ONE / (cos * cos + sin * sin).sqrt();
        let turns = per_length.is_finite() & per_length.simd_gt(f32x4::ZERO);
        let cos = turns.select(cos * per_length, f32x4::ONE);
        let sin = turns & (sin * per_length);
        let wished = arms.map(|arm| {
            let x = middle.0 + (cos * arm.x - sin * arm.y);
            let y = middle.1 + (sin * arm.x + cos * arm.y);
            (x.to_array(), y.to_array())
        });
        for lane in 0..triangles {
            for (arm, (x, y)) in arms.iter().zip(&wished) {
                let corner = arm.corners[lane] as usize;
                self.corners[corner].wish(Vec2::new(x[lane], y[lane]));
            }
        }
    }
}

impl Corner {
    fn wish(&mut self, place: Vec2) {
        self.wished += place;
        self.wishes += 1.0;
    }

    fn settle(&mut self) {
        self.at = self.wished / self.wishes;
        (self.wished, self.wishes) = (Vec2::ZERO, 0.0);
    }
}
