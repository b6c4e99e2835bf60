//! What `mosaic export` writes, read back by the readers of others.

use crate::{json, mosaic, path, succeed};
use clonal_mosaic::import::{link_of_file, made_of_words};
use clonal_mosaic::plants;
use clonal_mosaic::play::link;
use gltf::mesh::util::ReadIndices;
use std::fs;

/// A plant that grows in no time.
const PLANT: [&str; 7] = ["export", "--preset", "croton", "--individual", "4", "--day", "1"];

/// Exports the plant, and returns the path of the file and the line that is told.
fn export(option: &str, name: &str) -> (String, String) {
    let path = path(name);
    let told = succeed(&[&PLANT[..], &[option, &path]].concat());
    assert_eq!(told.lines().count(), 1, "{told}");
    assert!(told.starts_with(&format!("{path}: ")), "{told}");
    let bytes = fs::metadata(&path).unwrap().len();
    if option != "--obj" {
        assert!(told.contains(&format!("{bytes} bytes")), "{told} of {bytes} bytes");
    }
    (path, told)
}

/// The number before the last mention of a word in the line.
fn number(told: &str, word: &str) -> usize {
    let words: Vec<&str> = told.split([' ', ',', '\n']).collect();
    let at = words.iter().rposition(|other| *other == word).expect(told);
    words[at - 1].parse().unwrap()
}

/// The area of a triangle.
fn area([a, b, c]: [[f64; 3]; 3]) -> f64 {
    let [u, v] = [b, c].map(|p| [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
    let cross = |i: usize, j: usize| u[i] * v[j] - u[j] * v[i];
    0.5 * (cross(1, 2).powi(2) + cross(2, 0).powi(2) + cross(0, 1).powi(2)).sqrt()
}

/// The surface of the plant, as `mosaic grow` knows it.
fn surface_cm2() -> f64 {
    let grow = ["grow", "--preset", "croton", "--individual", "4", "--day", "0", "--json"];
    json(&grow)["body"]["area_cm2"].as_f64().unwrap()
}

#[test]
fn a_glb_has_the_plant_in_metres_its_colours_and_its_link() {
    let (path, told) = export("--glb", "plant.glb");
    let gltf = gltf::Gltf::from_slice(&fs::read(&path).unwrap()).unwrap();
    let blob = gltf.blob.as_deref().unwrap();
    let scene = gltf.default_scene().unwrap();
    let extras = scene.extras().as_ref().unwrap().get();
    assert!(extras.contains("croton?v=2&s=4&d=1"), "{extras}");
    let node = scene.nodes().next().unwrap();
    let (_, _, scale) = node.transform().decomposed();
    assert!(scale.iter().all(|s| (s - 0.01).abs() < 1e-9), "{scale:?}");

    let (mut triangles, mut materials, mut mosaic_cm2) = (0, Vec::new(), 0.0);
    for primitive in node.mesh().unwrap().primitives() {
        let material = primitive.material();
        assert!(material.double_sided());
        let name = material.name().unwrap().to_string();
        let reader = primitive.reader(|_| Some(blob));
        let positions: Vec<[f32; 3]> = reader.read_positions().unwrap().collect();
        let bounds = primitive.bounding_box();
        for k in 0..3 {
            let of = |least: fn(f32, f32) -> f32| positions.iter().map(|p| p[k]).reduce(least);
            assert_eq!((of(f32::min), of(f32::max)), (Some(bounds.min[k]), Some(bounds.max[k])));
        }
        let normals: Vec<[f32; 3]> = reader.read_normals().unwrap().collect();
        assert_eq!(normals.len(), positions.len());
        let length2 = |n: &[f32; 3]| n.iter().map(|x| x * x).sum::<f32>();
        assert!(normals.iter().all(|n| (length2(n) - 1.0).abs() < 1e-5));
        let Some(ReadIndices::U32(indices)) = reader.read_indices() else { panic!("{name}") };
        let indices: Vec<usize> = indices.map(|k| k as usize).collect();
        assert!(indices.iter().all(|&k| k < positions.len()));
        triangles += indices.len() / 3;
        if name == "mosaic" {
            let colours: Vec<[u16; 4]> = reader.read_colors(0).unwrap().into_rgba_u16().collect();
            assert_eq!(colours.len(), positions.len());
            assert_eq!(material.pbr_metallic_roughness().base_color_factor(), [1.0; 4]);
            // Each triangle has one colour, and leaves face the sky: they are wound as normals say.
            for t in indices.as_chunks::<3>().0 {
                assert!(t.iter().all(|&k| colours[k] == colours[t[0]]));
                mosaic_cm2 += area(t.map(|k| positions[k].map(f64::from)));
            }
            // Linear light: green (0.15, 0.33, 0.12) in sRGB is (0.020, 0.089, 0.013), yellow
            // (0.91, 0.784, 0.227) is (0.807, 0.577, 0.042), lighter and darker by up to a quarter.
            let is = |c: &[u16; 4], wanted: [f64; 3]| {
                c.iter().zip(wanted).all(|(&c, w)| (f64::from(c) / 65_535.0 / w - 1.0).abs() < 0.27)
            };
            let green = colours.iter().filter(|c| is(c, [0.0196, 0.089, 0.0134])).count();
            let yellow = colours.iter().filter(|c| is(c, [0.807, 0.577, 0.0421])).count();
            assert!(green > yellow && yellow > 100, "{green} and {yellow}");
            assert_eq!(green + yellow, colours.len());
        }
        materials.push(name);
    }
    assert_eq!(materials, ["mosaic", "bark", "petiole", "pot", "soil"]);
    assert_eq!(triangles, number(&told, "triangles"));
    assert!((mosaic_cm2 / surface_cm2() - 1.0).abs() < 1e-4, "{mosaic_cm2} cm2");
}

#[test]
fn a_ply_has_the_triangles_and_srgb_colours() {
    use ply_rs_bw::parser::Parser;
    use ply_rs_bw::ply::{DefaultElement, Property};
    let (path, told) = export("--ply", "plant.ply");
    let mut file = std::io::BufReader::new(fs::File::open(&path).unwrap());
    let ply = Parser::<DefaultElement>::new().read_ply(&mut file).unwrap();
    assert!(ply.header.comments.iter().any(|c| c.contains("croton?v=2&s=4&d=1")));
    let vertices: Vec<([f64; 3], [u8; 3])> = ply.payload["vertex"]
        .iter()
        .map(|vertex| {
            let float = |key: &str| match vertex[key] {
                Property::Float(x) => f64::from(x),
                ref other => panic!("{other:?}"),
            };
            let byte = |key: &str| match vertex[key] {
                Property::UChar(x) => x,
                ref other => panic!("{other:?}"),
            };
            (["x", "y", "z"].map(float), ["red", "green", "blue"].map(byte))
        })
        .collect();
    let faces = &ply.payload["face"];
    assert_eq!(faces.len(), number(&told, "triangles"));
    let (mut mosaic_cm2, mut pot) = (0.0, 0);
    for face in faces {
        let Property::ListUInt(corners) = &face["vertex_indices"] else { panic!("no list") };
        let corners: [usize; 3] = std::array::from_fn(|k| corners[k] as usize);
        let colour = vertices[corners[0]].1;
        assert!(corners.iter().all(|&k| vertices[k].1 == colour));
        // Petiole, bark, pot and soil in bytes.
        match colour {
            [168, 92, 61] => pot += 1,
            [107, 120, 51] | [120, 107, 84] | [51, 38, 28] => {}
            _ => mosaic_cm2 += area(corners.map(|k| vertices[k].0)),
        }
    }
    assert!(pot > 50, "{pot}");
    assert!((mosaic_cm2 / surface_cm2() - 1.0).abs() < 1e-4, "{mosaic_cm2} cm2");
}

#[test]
fn an_obj_has_a_material_for_each_type_and_its_colours_beside_it() {
    let (path, told) = export("--obj", "plant.obj");
    let (models, materials) = tobj::load_obj(&path, &tobj::LoadOptions::default()).unwrap();
    let materials = materials.unwrap();
    let names: Vec<&str> = materials.iter().map(|m| m.name.as_str()).collect();
    assert_eq!(names, ["F", "B", "M", "bark", "petiole", "pot", "soil"]);
    assert_eq!(materials[0].diffuse, Some([0.91, 0.784, 0.227]));
    let mut cm2 = vec![0.0; names.len()];
    let mut triangles = 0;
    for model in &models {
        let mesh = &model.mesh;
        assert!(mesh.face_arities.is_empty(), "triangles alone");
        triangles += mesh.indices.len() / 3;
        for t in mesh.indices.as_chunks::<3>().0 {
            let corner =
                |v: u32| std::array::from_fn(|k| f64::from(mesh.positions[3 * v as usize + k]));
            cm2[mesh.material_id.unwrap()] += area(t.map(corner));
        }
    }
    assert_eq!(triangles, number(&told, "triangles"));
    let mosaic_cm2: f64 = cm2[..3].iter().sum();
    assert!((mosaic_cm2 / surface_cm2() - 1.0).abs() < 1e-4, "{mosaic_cm2} cm2");
    assert!(cm2[0] > 0.05 * mosaic_cm2 && cm2[1] > 0.5 * mosaic_cm2 && cm2[2] == 0.0, "{cm2:?}");
    let parts = models.iter().filter(|model| model.name.starts_with("part_")).count();
    assert!(parts >= 18, "{parts}");
}

#[test]
fn an_svg_has_each_leaf_true_to_scale() {
    use svgtypes::{PathParser, PathSegment};
    let (path, told) = export("--svg", "plant.svg");
    let (obj, _) = export("--obj", "of-svg.obj");
    let (models, _) = tobj::load_obj(&obj, &tobj::LoadOptions::default()).unwrap();
    let text = fs::read_to_string(path).unwrap();
    let document = roxmltree::Document::parse(&text).unwrap();
    let element = |name: &'static str| document.descendants().filter(move |n| n.has_tag_name(name));
    assert!(element("desc").next().unwrap().text().unwrap().ends_with("croton?v=2&s=4&d=1"));
    assert_eq!(element("g").count(), 18);
    assert_eq!(number(&told, "parts"), 18);
    let box_of: Vec<f64> = element("svg")
        .next()
        .unwrap()
        .attribute("viewBox")
        .unwrap()
        .split(' ')
        .map(|x| x.parse().unwrap())
        .collect();
    let mut mm2 = [0.0; 2];
    for path in element("path") {
        let kind = "FB".find(path.attribute("id").unwrap().chars().last().unwrap()).unwrap();
        let colour = ["#e8c83a", "#26541f"][kind];
        assert_eq!(path.attribute("fill"), Some(colour));
        // Outer outlines run one way and holes the other.
        let (mut first, mut last, mut twice) = ([0.0; 2], [0.0; 2], 0.0);
        for segment in PathParser::from(path.attribute("d").unwrap()) {
            let to = match segment.unwrap() {
                PathSegment::MoveTo { x, y, .. } => {
                    (first, last) = ([x, y], [x, y]);
                    [x, y]
                }
                PathSegment::LineTo { x, y, .. } => [x, y],
                PathSegment::ClosePath { .. } => first,
                other => panic!("{other:?}"),
            };
            assert!(to[0] > 0.0 && to[1] > 0.0 && to[0] < box_of[2] && to[1] < box_of[3]);
            twice += last[0] * to[1] - last[1] * to[0];
            last = to;
        }
        mm2[kind] += twice.abs() / 2.0;
    }
    let mut cm2 = [0.0; 2];
    for mesh in models.iter().filter(|m| m.name.starts_with("part_")).map(|m| &m.mesh) {
        for t in mesh.indices.as_chunks::<3>().0 {
            let corner =
                |v: u32| std::array::from_fn(|k| f64::from(mesh.positions[3 * v as usize + k]));
            cm2[mesh.material_id.unwrap()] += area(t.map(corner));
        }
    }
    for kind in [0, 1] {
        let share = mm2[kind] / (100.0 * cm2[kind]);
        assert!((share - 1.0).abs() < 0.03, "{mm2:?} mm2 of {cm2:?} cm2");
    }
}

#[test]
fn a_3mf_has_closed_bodies_in_the_materials_of_their_types() {
    for (plant, day) in [("croton", "0"), ("watermelon", "1")] {
        let path = path(&format!("{plant}.3mf"));
        let told = succeed(&["export", "--preset", plant, "--day", day, "--3mf", &path]);
        let mut zip = zip::ZipArchive::new(fs::File::open(&path).unwrap()).unwrap();
        let names: Vec<String> = zip.file_names().map(str::to_string).collect();
        assert!(names.iter().any(|name| name == "[Content_Types].xml"), "{names:?}");
        let mut file = zip.by_name("3D/3dmodel.model").unwrap();
        let mut text = String::new();
        // This checks the sum, too.
        std::io::Read::read_to_string(&mut file, &mut text).unwrap();
        let document = roxmltree::Document::parse(&text).unwrap();
        let all = |name: &'static str| document.descendants().filter(move |n| n.has_tag_name(name));
        let materials: Vec<&str> =
            all("base").map(|base| base.attribute("name").unwrap()).collect();
        assert_eq!(materials[..3], ["F", "B", "M"]);
        let float = |n: roxmltree::Node, key| n.attribute(key).unwrap().parse::<f64>().unwrap();
        let vertices: Vec<[f64; 3]> =
            all("vertex").map(|v| ["x", "y", "z"].map(|key| float(v, key))).collect();
        let mut edges = Vec::new();
        let (mut mm3, mut mm2) = (0.0, vec![0.0; materials.len()]);
        for triangle in all("triangle") {
            let corners = ["v1", "v2", "v3"].map(|key| float(triangle, key) as usize);
            for k in 0..3 {
                let (a, b) = (corners[k], corners[(k + 1) % 3]);
                edges.push((a.min(b), a.max(b), a < b));
            }
            let [a, b, c] = corners.map(|v| vertices[v]);
            mm3 += (0..3)
                .map(|k| a[k] * (b[(k + 1) % 3] * c[(k + 2) % 3] - b[(k + 2) % 3] * c[(k + 1) % 3]))
                .sum::<f64>()
                / 6.0;
            mm2[float(triangle, "p1") as usize] += area([a, b, c]);
        }
        assert_eq!(edges.len(), 3 * number(&told, "triangles"));
        edges.sort_unstable();
        let is_closed = edges
            .chunk_by(|a, b| (a.0, a.1) == (b.0, b.1))
            .all(|of_one| 2 * of_one.iter().filter(|edge| edge.2).count() == of_one.len());
        assert!(is_closed, "{plant} has an edge with one side");
        assert!(mm2[0] > 0.0 && mm2[1] > 0.0 && mm2[2] == 0.0 && mm3 > 0.0, "{mm2:?}, {mm3}");
        if plant == "watermelon" {
            // As large as its surface says, and hardly less round than a ball.
            let ball =
                |mm2: f64| (mm2 / std::f64::consts::PI).powf(1.5) * std::f64::consts::PI / 6.0;
            let share = mm3 / ball(mm2[0] + mm2[1]);
            assert!((0.9..1.0).contains(&share), "{share}");
        }
    }
}

#[test]
fn clones_are_the_cells_by_their_founders() {
    let (clones, told) = export("--clones", "clones.csv");
    let (cells, _) = export("--cells", "cells.csv");
    let [clones, cells] = [clones, cells].map(|path| fs::read_to_string(path).unwrap());
    let rows = |text: &str| -> Vec<Vec<String>> {
        let rows = text.lines().skip(1);
        rows.map(|row| row.split(',').map(str::to_string).collect()).collect()
    };
    assert_eq!(clones.lines().next(), Some("founder,type,born_day,cells,F,B,M,area_cm2,part"));
    let (clones, cells) = (rows(&clones), rows(&cells));
    assert_eq!((clones.len(), cells.len()), (number(&told, "clones"), number(&told, "cells")));
    assert_eq!(clones.len(), 10_000, "all first cells live");
    let mut counted = vec![[0; 3]; cells.len()];
    for cell in &cells {
        let founder: usize = cell[2].parse().unwrap();
        counted[founder]["FBM".find(&cell[3]).unwrap()] += 1;
    }
    let mut cm2 = 0.0;
    for clone in &clones {
        let number = |k: usize| clone[k].parse::<usize>().unwrap();
        let of_founder = &cells[number(0)];
        let known = [&of_founder[3], &of_founder[9], &of_founder[4]];
        assert_eq!([&clone[1], &clone[2], &clone[8]], known);
        assert_eq!([number(4), number(5), number(6)], counted[number(0)]);
        assert_eq!(number(3), counted[number(0)].iter().sum::<usize>());
        cm2 += clone[7].parse::<f64>().unwrap();
    }
    assert!((cm2 / surface_cm2() - 1.0).abs() < 1e-4, "{cm2} cm2");
}

#[test]
fn a_link_is_exported_with_its_own_day_and_numbers() {
    let path = path("link.obj");
    let link = "watermelon?v=1&s=2&d=2&va=0.5";
    let told = succeed(&["export", "--link", link, "--obj", &path]);
    assert!(told.contains("day 2"), "{told}");
    let materials = fs::read_to_string(path.replace(".obj", ".mtl")).unwrap();
    assert!(materials.contains("newmtl B\nKd 0."), "{materials}");
    assert!(fs::read_to_string(&path).unwrap().contains(link));
}

#[test]
fn the_link_of_a_plant_of_ones_own_says_what_that_is_made_of() {
    for words in ["painted/watermelon/2/f.900.w.5z00", "leaf=lobes:1"] {
        let below = plants::find("watermelon").unwrap().body.mesh.text;
        let key = made_of_words(words, below).unwrap().key;
        let link = format!("{key}?v=2&s=1&d=0&n=3000~{words}");
        let path = path("own.ply");
        succeed(&["export", "--link", &link, "--ply", &path]);
        let now = link::read("", plants::all()).scene;
        assert_eq!(link_of_file(&fs::read(&path).unwrap(), &now), Ok(link));
    }
}

#[test]
fn what_cannot_be_exported_is_refused_on_one_line() {
    let folder = env!("CARGO_TARGET_TMPDIR");
    let (file, twice, nowhere) = (path("x.glb"), path("x.mtl"), path("no/such/folder.glb"));
    for (arguments, word) in [
        (&["export"][..], "--glb, --ply, --obj"),
        (&["export", "--glb"], "--glb"),
        (&["export", "--glb", &file, "--ply", &file], "only one of them"),
        (&["export", "--glb", &file, "--glb", &file], "only one --glb"),
        (&["export", "--stl", &file], "--stl is unknown"),
        (&["export", "--preset", "oak", "--glb", &file], "oak"),
        (&["export", "--preset", "croton", "--link", "croton?v=1", "--glb", &file], "only one"),
        (&["export", "--link", "rose?v=1", "--glb", &file], "rose"),
        (&["export", "--day", "999", "--glb", &file], "--day is 999"),
        (&["export", "--individual", "-1", "--glb", &file], "--individual"),
        (&["export", "--glb", &nowhere], "folder.glb"),
        (&["export", "--glb", folder], folder),
        (&["export", "--preset", "watermelon", "--day", "0", "--svg", &file], "it is closed"),
        (&["export", "--obj", &twice], "beside it"),
        (&["export", "--obj", "/dev/null"], "beside it"),
    ] {
        let output = mosaic(arguments);
        let told = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {told}");
        assert!(output.stdout.is_empty() && told.lines().count() == 1, "{arguments:?}: {told}");
        assert!(told.contains(word), "{arguments:?} is refused with: {told}");
    }
    assert!(!std::path::Path::new(&file).exists());
}
