//! What the graphics card draws against a second method: the pixels of the canvas show the colour of
//! the Voronoi polygon, by spade, that the ray through them meets.

use crate::page::{Graphics, Page, Picture};
use crate::rays::Rays;
use clonal_mosaic::mosaic::{Piece, polygons};
use clonal_mosaic::plants;
use clonal_mosaic::play::link;
use clonal_mosaic::surface::Charts;
use clonal_mosaic::tissue::{CellType, Progress};
use glam::Vec2;
use std::sync::Arc;

/// Red and cream can be told apart in every light.
const LINK: &str = "mushroom?v=1&s=3&d=12&view=20,40,3";

/// Pixels from one sample to the next, and how far around a sample the type must be one.
const STEP_PX: usize = 11;
const AWAY_FROM_BORDERS_PX: f32 = 2.5;

#[test]
fn webgpu_paints_the_voronoi_polygons() {
    pixels_agree(Graphics::WebGpu, "webgpu");
}

#[test]
fn webgl2_paints_the_voronoi_polygons() {
    pixels_agree(Graphics::WebGl2, "webgl2");
}

fn pixels_agree(graphics: Graphics, backend: &str) {
    let Some(page) = Page::open(graphics, &format!("#{LINK}")) else { return };
    assert_eq!(page.ready().backend, backend);
    let picture = page.picture();
    let scene = Polygons::grow(&picture);
    let (mut agree, mut differ, mut unclear) = (0, 0, 0);
    let (width, height) = (picture.width, picture.height);
    // The middle of the picture: buttons float over its corners.
    for y in (height / 5..4 * height / 5).step_by(STEP_PX) {
        for x in (width / 4..3 * width / 4).step_by(STEP_PX) {
            let at = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
            let around = [Vec2::ZERO, Vec2::X, Vec2::Y, -Vec2::X, -Vec2::Y];
            let kinds = around.map(|side| scene.kind_at(at + side * AWAY_FROM_BORDERS_PX));
            let Some(kind) = kinds[0] else { continue };
            if kinds.iter().any(|&k| k != Some(kind)) {
                continue;
            }
            match painted(picture.rgb[y * width + x]) {
                None => unclear += 1,
                Some(painted) if painted == kind => agree += 1,
                Some(_) => differ += 1,
            }
        }
    }
    let compared = agree + differ + unclear;
    assert!(compared > 500, "{compared} pixels lie on the cap");
    assert!(unclear * 20 < compared, "{unclear} of {compared} pixels are neither red nor cream");
    assert!(differ * 500 < compared, "{differ} of {compared} pixels show another type");
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
    fn grow(picture: &Picture) -> Polygons {
        let scene = link::read(LINK, plants::all()).scene;
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
