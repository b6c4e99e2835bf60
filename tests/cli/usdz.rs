//! The plant for the cameras of phones: the ZIP as the format asks for it, and the colours as in the other models.

use crate::{path, succeed};
use std::fs;
use std::io::{Cursor, Read};

/// The numbers of a list in the text of a mesh.
fn numbers(mesh: &str, name: &str) -> Vec<f64> {
    let start = mesh.find(&format!("{name} = [")).unwrap_or_else(|| panic!("no {name}"));
    let list = mesh[start..].split_once('[').unwrap().1.split_once(']').unwrap();
    // That of `float3[] extent` is after its own brackets.
    list.0
        .split([',', '(', ')', ' '])
        .filter(|number| !number.is_empty())
        .map(|number| number.parse().unwrap_or_else(|_| panic!("{number} in {name}")))
        .collect()
}

fn export(option: &str, name: &str) -> Vec<u8> {
    let path = path(name);
    succeed(&["export", "--preset", "croton", "--individual", "4", "--day", "1", option, &path]);
    fs::read(path).unwrap()
}

#[test]
fn a_usdz_has_its_files_in_line_and_the_colours_of_the_glb() {
    let bytes = export("--usdz", "plant.usdz");
    let mut zip = zip::ZipArchive::new(Cursor::new(&bytes)).unwrap();
    assert_eq!(zip.file_names().collect::<Vec<_>>(), ["plant.usda", "colours.png"]);
    let mut read = |k: usize| {
        let mut file = zip.by_index(k).unwrap();
        assert_eq!(file.compression(), zip::CompressionMethod::Stored);
        assert_eq!(file.data_start().unwrap() % 64, 0, "{}", file.name());
        let mut content = Vec::new();
        file.read_to_end(&mut content).unwrap();
        content
    };
    let (text, picture) = (String::from_utf8(read(0)).unwrap(), read(1));
    assert!(text.starts_with("#usda 1.0\n") && text.contains("croton?v=2&s=4&d=1"));
    for part in
        ["defaultPrim = \"plant\"", "metersPerUnit = 0.01", "upAxis = \"Y\"", "@colours.png@"]
    {
        assert!(text.contains(part), "{part}");
    }
    let meshes: Vec<&str> = text.split("def Mesh ").skip(1).collect();
    let names: Vec<&str> = meshes.iter().map(|mesh| mesh.split('"').nth(1).unwrap()).collect();
    assert_eq!(names, ["mosaic", "bare_bark", "bare_petiole", "bare_pot", "bare_soil"]);
    for (mesh, name) in meshes.iter().zip(&names) {
        let [counts, corners, points, normals] =
            ["faceVertexCounts", "faceVertexIndices", "points", "normals"]
                .map(|of| numbers(mesh, of));
        assert!(counts.iter().all(|&count| count == 3.0) && 3 * counts.len() == corners.len());
        assert_eq!(points.len(), normals.len());
        assert!(corners.iter().all(|&corner| 3.0 * corner < points.len() as f64));
        assert!(text.contains(&format!("def Material \"{name}\"")));
    }

    // What each triangle looks at is what the corners of the GLB's have, and there is the other side of each.
    let mut reader = png::Decoder::new(Cursor::new(&picture)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    let (width, height) = (f64::from(info.width), f64::from(info.height));
    let seen = |x: f64, y: f64| {
        let at = ((1.0 - y) * height) as usize * info.width as usize + (x * width) as usize;
        [0, 1, 2].map(|k| f64::from(pixels[3 * at + k]))
    };
    let (places, corners) =
        (numbers(meshes[0], "primvars:st"), numbers(meshes[0], "faceVertexIndices"));
    let glb = gltf::Gltf::from_slice(&export("--glb", "beside.glb")).unwrap();
    let blob = glb.blob.as_deref().unwrap();
    let mosaic = glb.meshes().next().unwrap().primitives().next().unwrap();
    let reader = mosaic.reader(|_| Some(blob));
    let colours: Vec<[f32; 3]> = reader.read_colors(0).unwrap().into_rgb_f32().collect();
    let indices: Vec<u32> = reader.read_indices().unwrap().into_u32().collect();
    assert_eq!(corners.len(), 2 * indices.len());
    let srgb = |c: f32| {
        let c = f64::from(c);
        255.0 * if c <= 0.003_130_8 { 12.92 * c } else { 1.055 * c.powf(1.0 / 2.4) - 0.055 }
    };
    for triangle in (0..indices.len() / 3).step_by(indices.len() / 3 / 200) {
        let wanted = colours[indices[3 * triangle] as usize].map(srgb);
        for corner in [corners[3 * triangle], corners[indices.len() + 3 * triangle]] {
            let k = 2 * corner as usize;
            let is = seen(places[k], places[k + 1]);
            assert!(is.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1.0), "{is:?} {wanted:?}");
        }
    }
}
