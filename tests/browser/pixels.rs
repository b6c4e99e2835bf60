//! What the graphics card draws against a second method: the pixels of the canvas show the colour of
//! the Voronoi polygon, by spade, that the ray through them meets.

use crate::engines::{Engine, Graphics};
use crate::page::{Page, Picture};
use crate::rays::Rays;
use clonal_mosaic::mosaic::{Piece, polygons};
use clonal_mosaic::plants;
use clonal_mosaic::play::link;
use clonal_mosaic::surface::{Charts, Place};
use clonal_mosaic::tissue::{CellType, Control, Progress};
use glam::Vec2;
use std::sync::Arc;

/// Red and cream can be told apart in every light.
const LINK: &str = "mushroom?v=1&s=3&d=12&view=20,40,3";

/// The whole cap, from its orange rim to its red top.
const WHOLE_CAP: &str = "mushroom?v=1&s=3&d=12&view=0,20,1.3";

/// Pixels from one sample to the next, and how far around a sample the type must be one.
const STEP_PX: usize = 11;
const AWAY_FROM_BORDERS_PX: f32 = 2.5;

#[test]
fn webgpu_paints_the_voronoi_polygons() {
    pixels_agree(Graphics::WebGpu);
}

#[test]
fn webgl2_paints_the_voronoi_polygons() {
    pixels_agree(Graphics::WebGl2);
}

#[test]
fn webgpu_tints_red_towards_the_rim() {
    tints_agree(Graphics::WebGpu);
}

#[test]
fn webgl2_tints_red_towards_the_rim() {
    tints_agree(Graphics::WebGl2);
}

pub fn pixels_agree(engine: impl Into<Engine>) {
    let engine = engine.into();
    let Some(page) = Page::open(engine, &format!("#{LINK}")) else { return };
    assert_eq!(page.ready().backend, engine.backend());
    let picture = page.picture();
    let (mut agree, mut differ, mut unclear) = (0, 0, 0);
    for (rgb, _, kind) in Polygons::grow(LINK, &picture).samples(&picture) {
        match painted(rgb) {
            None => unclear += 1,
            Some(painted) if painted == kind => agree += 1,
            Some(_) => differ += 1,
        }
    }
    let compared = agree + differ + unclear;
    assert!(compared > 500, "{compared} pixels lie on the cap");
    assert!(unclear * 20 < compared, "{unclear} of {compared} pixels are neither red nor cream");
    assert!(differ * 500 < compared, "{differ} of {compared} pixels show another type");
}

/// The more the control images tint red cells, the more green is in their pixels.
pub fn tints_agree(engine: impl Into<Engine>) {
    let Some(page) = Page::open(engine, &format!("#{WHOLE_CAP}")) else { return };
    page.ready();
    let picture = page.picture();
    let scene = Polygons::grow(WHOLE_CAP, &picture);
    let mesh = &scene.rays.body.surface;
    let controls = plants::find("mushroom").unwrap().controls(3);
    // Green in red, and pixels, from little tint to much.
    let mut steps = [(0.0, 0); 4];
    for ([red, green, _], place, kind) in scene.samples(&picture) {
        let tint = |control: &Control| control.tint(mesh, place, kind);
        let tint = controls.iter().map(tint).fold(0.0, f32::max);
        if kind == CellType::Foreground {
            let step = &mut steps[(tint * 3.999) as usize];
            *step = (step.0 + f32::from(green) / f32::from(red.max(1)), step.1 + 1);
        }
    }
    assert!(steps.iter().all(|&(_, count)| count > 20), "{steps:?}");
    let means = steps.map(|(sum, count)| sum / count as f32);
    // In one red, there is rather less green towards the rim.
    assert!(means.is_sorted() && means[3] > means[0] + 0.1, "{means:?}");
}

/// The type of cell that a pixel shows: red F, cream B, or neither for sure.
fn painted([red, green, _]: [u8; 3]) -> Option<CellType> {
    let share = f32::from(green) / f32::from(red.max(1));
    match share {
        s if s < 0.5 => Some(CellType::Foreground),
        s if s > 0.68 => Some(CellType::Background),
        _ => None,
    }
}

/// The same scene by the second method.
struct Polygons {
    rays: Rays,
    /// The pieces of each triangle, with their cells' types.
    pieces: Vec<Vec<(Piece, CellType)>>,
}

impl Polygons {
    fn grow(link: &str, picture: &Picture) -> Polygons {
        let scene = link::read(link, plants::all()).scene;
        let rays = Rays::of(&scene, picture);
        let mesh = Arc::new(rays.body.surface.clone());
        let mut growth =
            scene.plant.sow(mesh.clone(), scene.recipe.clone(), scene.individual).unwrap();
        while growth.step() != Progress::Day(scene.day) {}
        let places = &growth.diary.days[scene.day as usize].places;
        let mut charts = Charts::new(&mesh);
        let mut pieces = vec![Vec::new(); mesh.triangles.len()];
        for piece in polygons(&mesh, &mut charts, places) {
            let kind = growth.diary.lineage[piece.cell as usize].kind;
            pieces[piece.triangle as usize].push((piece, kind));
        }
        Polygons { rays, pieces }
    }

    /// Colour, place and type of pixels that show the caps, away from cells of another type.
    fn samples(&self, picture: &Picture) -> Vec<([u8; 3], Place, CellType)> {
        let mut samples = Vec::new();
        let (width, height) = (picture.width, picture.height);
        // The middle of the picture: buttons float over its corners.
        for y in (height / 5..4 * height / 5).step_by(STEP_PX) {
            for x in (width / 4..3 * width / 4).step_by(STEP_PX) {
                let at = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
                let (Some(place), Some(kind)) = (self.rays.surface_at(at), self.kind_at(at)) else {
                    continue;
                };
                let mut around = [Vec2::X, Vec2::Y, -Vec2::X, -Vec2::Y].into_iter();
                if around.all(|v| self.kind_at(at + v * AWAY_FROM_BORDERS_PX) == Some(kind)) {
                    samples.push((picture.rgb[y * width + x], place, kind));
                }
            }
        }
        samples
    }

    /// The type of the cell that is seen through a point of the picture, in pixels; none where
    /// something else is seen.
    fn kind_at(&self, pixel: Vec2) -> Option<CellType> {
        let place = self.rays.surface_at(pixel)?;
        let triangle = place.triangle as usize;
        let at = self.rays.body.surface.frames[triangle].point(place.b1, place.b2);
        let holds = |piece: &Piece| {
            let next = piece.corners.iter().cycle().skip(1);
            piece.corners.iter().zip(next).all(|(&a, &b)| (b - a).perp_dot(at - a) >= 0.0)
        };
        self.pieces[triangle].iter().find(|(piece, _)| holds(piece)).map(|&(_, kind)| kind)
    }
}
