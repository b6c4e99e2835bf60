//! What is drawn of leaves, against the lists of sites that the page's shader reads, and against areas.

use super::*;
use crate::mosaic::SiteFinder;
use crate::plants;
use crate::tissue::{Diary, Progress};
use std::sync::Arc;

/// A plant on a day, with few cells.
fn grown(key: &str) -> (&'static plants::Plant, Arc<crate::surface::Mesh>, Diary) {
    let plant = plants::find(key).unwrap();
    let mesh = Arc::new(plant.embedded_body().surface);
    let recipe = crate::tissue::Recipe { days: 1, ..plant.recipe.clone() };
    let mut growth = plant.sow(mesh.clone(), recipe, 3).unwrap();
    while !matches!(growth.step(), Progress::Done | Progress::Full) {}
    (plant, mesh, growth.diary)
}

#[test]
fn pixels_have_the_colours_of_the_cells_that_the_shader_finds_there() {
    for key in ["begonia", "croton"] {
        let (plant, mesh, diary) = grown(key);
        let day = diary.days.len() - 1;
        let controls = plant.controls(3);
        let body = (&*mesh, &*mesh, &[][..]);
        let specimen = Specimen::new(body, &plant.look, &controls, (&diary, day), String::new());
        let flats = Flats::new(&specimen).unwrap();
        let mut set = LeafSet::new(&flats, 1, mesh.veins.any(9));
        set.draw(0, 3, &specimen, &flats);
        let lists = SiteFinder::new(&mesh).coloured(controls).find(&mesh, &diary, day);

        let (mut same, mut other, mut covered) = (0u32, 0u32, 0.0);
        let (mut vein_pixels, mut near_midrib) = (0u32, 0u32);
        for (flat, corner) in flats.pieces.iter().zip(&set.corners) {
            for t in (0..mesh.triangles.len()).filter(|&t| mesh.parts[t] == flat.part) {
                let own = mesh.triangles[t].map(|v| flat.places[v as usize] * set.px_per_mm);
                // The centre, and a point towards each corner.
                for k in 0..4 {
                    let share = [0, 1, 2].map(|j| match k {
                        3 => 1.0 / 3.0,
                        k if k == j => 0.6,
                        _ => 0.2,
                    });
                    let at: DVec2 = own.iter().zip(share).map(|(p, s)| *p * s).sum();
                    let [x, y] = [at.x as usize + corner[0], at.y as usize + corner[1]];
                    let pixel = y * set.side_px as usize + x;
                    assert!(set.alpha[pixel] > 0, "{key}: part {} at {x}, {y}", flat.part);
                    let corners = mesh.frames[t].corners();
                    let centre = (corners[0] + corners[1] + corners[2]) / 3.0;
                    let plane: Vec2 =
                        corners.iter().zip(share).map(|(p, s)| *p * s as f32).sum::<Vec2>();
                    let Some(site) = lists.nearest(t, plane - centre, 1.0) else { continue };
                    let tag = lists.sites[site].tag();
                    let kind = crate::tissue::CellType::ALL[tag.kind as usize];
                    // As the shader, which knows the lightness in 16 steps.
                    let colour = plant.look.of_cell(kind, tag.tint, tag.lightness);
                    let expected = srgb(colour).map(|c| 255.0 * c);
                    let found = set.colour[pixel].map(f32::from);
                    let is_same = found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 2.0);
                    same += u32::from(is_same);
                    other += u32::from(!is_same);
                    if let Some(veins) = &set.veins {
                        let place =
                            Place { triangle: t as u32, b1: share[1] as f32, b2: share[2] as f32 };
                        let distance = mesh.veins.distance_cm(&mesh, place, 1);
                        vein_pixels += u32::from(veins[pixel] > 127);
                        if distance < 0.03 {
                            near_midrib += 1;
                            assert!(
                                veins[pixel] > 200,
                                "{distance} cm of a midrib: {}",
                                veins[pixel]
                            );
                        }
                    }
                }
            }
            let size = (flat.size * set.px_per_mm).to_array().map(|x| x.ceil() as usize);
            for y in corner[1]..=corner[1] + size[1] {
                for x in corner[0]..=corner[0] + size[0] {
                    covered += f64::from(set.alpha[y * set.side_px as usize + x]) / 255.0;
                }
            }
        }
        // Only pixels on borders of cells are mixed.
        assert!(same > 6 * other, "{key}: {same} pixels are the same, and {other} are not");
        let parts = flats.pieces.iter().map(|flat| flat.part);
        let cm2: f32 = parts
            .map(|part| {
                let of_part = (0..mesh.triangles.len()).filter(|&t| mesh.parts[t] == part);
                of_part.map(|t| mesh.areas[t]).sum::<f32>()
            })
            .sum();
        let px_per_cm = 10.0 * set.px_per_mm;
        let share = covered / (f64::from(cm2) * px_per_cm * px_per_cm);
        assert!((share - 1.0).abs() < 0.03, "{key}: {share} of the leaves' area");
        assert_eq!(set.veins.is_some(), key == "begonia");
        if key == "begonia" {
            assert!(near_midrib > 3 && vein_pixels > near_midrib, "{near_midrib}, {vein_pixels}");
        }
    }
}

#[test]
fn leaves_lie_apart() {
    let sizes: Vec<DVec2> =
        (1..40).map(|k| DVec2::new(f64::from(k % 7 + 2), f64::from(k))).collect();
    let corners = places(&sizes, 9.0, 2048).unwrap();
    for (k, a) in corners.iter().enumerate() {
        for (j, b) in corners.iter().enumerate().filter(|(j, _)| *j != k) {
            let px = |k: usize| (sizes[k] * 9.0).to_array().map(|x| x.ceil() as usize);
            let apart = (0..2)
                .any(|n| a[n] + px(k)[n] + GAP_PX <= b[n] || b[n] + px(j)[n] + GAP_PX <= a[n]);
            assert!(apart, "{k} and {j}");
        }
        assert!((0..2).all(|n| a[n] >= GAP_PX));
    }
    assert!(places(&sizes, 100.0, 2048).is_none());
}
