//! `mosaic export --baked`, read back by another reader of glTF and of PNG.

use crate::{path, succeed};
use clonal_mosaic::mosaic::SiteFinder;
use clonal_mosaic::plants::{self, srgb};
use clonal_mosaic::play::link;
use clonal_mosaic::tissue::{CellType, Progress};
use std::collections::HashMap;
use std::fs;
use std::sync::Arc;

/// A plant that grows in no time.
const PLANT: [&str; 7] = ["export", "--preset", "croton", "--individual", "4", "--day", "1"];

#[test]
fn a_baked_glb_has_a_texture_in_the_colours_of_the_cells() {
    const SIDE_PX: usize = 1024;
    let path = path("baked.glb");
    let told = succeed(&[&PLANT[..], &["--baked", &path, "--pixels", "1024"]].concat());
    assert!(told.contains("a texture of 1024 x 1024 pixels"), "{told}");
    let gltf = gltf::Gltf::from_slice(&fs::read(&path).unwrap()).unwrap();
    let blob = gltf.blob.as_deref().unwrap();
    let primitive = gltf.meshes().next().unwrap().primitives().next().unwrap();
    let material = primitive.material();
    let texture = material.pbr_metallic_roughness().base_color_texture().unwrap();
    assert_eq!(texture.tex_coord(), 0);
    let gltf::image::Source::View { view, mime_type } = texture.texture().source().source() else {
        panic!("it stands in the file")
    };
    assert_eq!(mime_type, "image/png");
    let png = &blob[view.offset()..view.offset() + view.length()];
    let mut png = png::Decoder::new(std::io::Cursor::new(png)).read_info().unwrap();
    let mut pixels = vec![0; png.output_buffer_size().unwrap()];
    png.next_frame(&mut pixels).unwrap();
    assert_eq!((png.info().width, png.info().height), (SIDE_PX as u32, SIDE_PX as u32));
    assert_eq!(pixels.len(), 3 * SIDE_PX * SIDE_PX);

    // What the page would show of the same day.
    let scene = link::read("croton?v=2&s=4&d=1", plants::all()).scene;
    let mesh = Arc::new(scene.plant.embedded_body().surface);
    let mut growth = scene.plant.sow(mesh.clone(), scene.recipe.clone(), scene.individual).unwrap();
    while growth.step() != Progress::Day(1) {}
    let controls = scene.plant.controls(scene.individual);
    let lists = SiteFinder::new(&mesh).coloured(controls).find(&mesh, &growth.diary, 1);

    let reader = primitive.reader(|_| Some(blob));
    let positions: Vec<[f32; 3]> = reader.read_positions().unwrap().collect();
    let places: Vec<[f32; 2]> = reader.read_tex_coords(0).unwrap().into_f32().collect();
    let indices: Vec<usize> =
        reader.read_indices().unwrap().into_u32().map(|k| k as usize).collect();
    let key = |corners: [[f32; 3]; 3]| corners.map(|corner| corner.map(f32::to_bits));
    let of_mesh = |t: u32| key(mesh.corners(t).map(|corner| corner.to_array()));
    let number: HashMap<_, u32> =
        (0..mesh.triangles.len() as u32).map(|t| (of_mesh(t), t)).collect();
    assert_eq!(indices.len(), 3 * mesh.triangles.len());
    let (mut compared, mut seen) = (0, 0);
    for corners in indices.as_chunks::<3>().0 {
        let triangle = number[&key(corners.map(|k| positions[k]))] as usize;
        let [x, y] = [0, 1].map(|n| {
            (corners.iter().map(|&k| places[k][n]).sum::<f32>() / 3.0 * SIDE_PX as f32) as usize
        });
        let head = &lists.heads[triangle];
        let mut sites: Vec<_> = lists.of(triangle).iter().map(|s| (s.now(head), s.tag())).collect();
        sites.sort_by(|(a, _), (b, _)| a.length().total_cmp(&b.length()));
        let [(near, tag), others @ ..] = &sites[..] else { panic!("no cells at {triangle}") };
        seen += 1;
        // Borders are mixed, and the pixel's middle lies elsewhere by up to 0.7 pixels.
        let corners_px = corners.map(|k| places[k].map(|x| x * SIDE_PX as f32));
        let along = |k: usize| [0, 1].map(|n| corners_px[k][n] - corners_px[0][n]);
        let area_px = (along(1)[0] * along(2)[1] - along(1)[1] * along(2)[0]).abs() / 2.0;
        let cm_per_px = (mesh.areas[triangle] / area_px).sqrt();
        let other = others.iter().find(|(_, other)| other.number != tag.number);
        if other.is_some_and(|(at, _)| at.length() - near.length() < 4.0 * cm_per_px) {
            continue;
        }
        let kind = CellType::ALL[tag.kind as usize];
        let expected = srgb(scene.look.of_cell(kind, tag.tint, tag.lightness));
        let found = &pixels[3 * (y * SIDE_PX + x)..][..3];
        for (found, expected) in found.iter().zip(expected) {
            let off = f32::from(*found) - 255.0 * expected;
            assert!(off.abs() < 1.5, "triangle {triangle}: {found} and not {}", 255.0 * expected);
        }
        compared += 1;
    }
    assert!(compared > 200, "{compared} of {seen}");
}
