//! GLB, as `gltf` reads it.

use super::{ball, fingerprint, read, refusal, rim_edges};
use clonal_mosaic::surface::PolygonMesh;
use serde_json::{Value, json};

/// A GLB file that is made of its parts.
struct Glb {
    json: Value,
    bytes: Vec<u8>,
}

impl Glb {
    fn new(nodes: Value) -> Glb {
        let json = json!({
            "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": nodes,
            "meshes": [], "accessors": [], "bufferViews": [], "buffers": [{}],
        });
        Glb { json, bytes: Vec::new() }
    }

    /// Adds to a list, and returns the number.
    fn add(&mut self, list: &str, item: Value) -> usize {
        let list = self.json[list].as_array_mut().unwrap();
        list.push(item);
        list.len() - 1
    }

    fn accessor(&mut self, bytes: &[u8], count: usize, component: u32, kind: &str) -> usize {
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        let view = json!({"buffer": 0, "byteOffset": self.bytes.len(), "byteLength": bytes.len()});
        self.bytes.extend(bytes);
        let view = self.add("bufferViews", view);
        let accessor = json!({
            "bufferView": view, "componentType": component, "count": count, "type": kind
        });
        self.add("accessors", accessor)
    }

    /// Adds positions with their bounds.
    fn places(&mut self, places: &[[f32; 3]]) -> usize {
        let bytes: Vec<u8> = places.iter().flatten().flat_map(|x| x.to_le_bytes()).collect();
        let number = self.accessor(&bytes, places.len(), 5126, "VEC3");
        let bound = |least: fn(f32, f32) -> f32| {
            [0, 1, 2].map(|k| places.iter().map(|p| p[k]).reduce(least).unwrap_or(0.0))
        };
        self.json["accessors"][number]["min"] = json!(bound(f32::min));
        self.json["accessors"][number]["max"] = json!(bound(f32::max));
        number
    }

    fn indices(&mut self, corners: &[u32]) -> usize {
        let bytes: Vec<u8> = corners.iter().flat_map(|k| k.to_le_bytes()).collect();
        self.accessor(&bytes, corners.len(), 5125, "SCALAR")
    }

    fn mesh(&mut self, primitives: Value) {
        self.add("meshes", json!({"primitives": primitives}));
    }

    fn write(&self) -> Vec<u8> {
        let mut json = self.json.clone();
        json["buffers"][0]["byteLength"] = json!(self.bytes.len());
        let mut text = json.to_string().into_bytes();
        text.resize(text.len().next_multiple_of(4), b' ');
        let mut bytes = self.bytes.clone();
        bytes.resize(bytes.len().next_multiple_of(4), 0);
        let mut file = b"glTF".to_vec();
        file.extend(2u32.to_le_bytes());
        file.extend(((12 + 8 + text.len() + 8 + bytes.len()) as u32).to_le_bytes());
        for (kind, chunk) in [(b"JSON", text), (b"BIN\0", bytes)] {
            file.extend((chunk.len() as u32).to_le_bytes());
            file.extend(kind);
            file.extend(chunk);
        }
        file
    }
}

/// A body as a GLB file, which is in metres.
fn glb(mesh: &PolygonMesh) -> Glb {
    let mut glb = Glb::new(json!([{"mesh": 0, "scale": [0.01, 0.01, 0.01]}]));
    let places: Vec<[f32; 3]> = mesh.positions.iter().map(|p| p.to_array()).collect();
    let corners: Vec<u32> = mesh.faces.iter().flat_map(|f| f.vertices.clone()).collect();
    let (places, indices) = (glb.places(&places), glb.indices(&corners));
    glb.mesh(json!([{"attributes": {"POSITION": places}, "indices": indices}]));
    glb
}

/// The area in square centimetres as the reader of others finds it.
fn area_cm2(file: &[u8]) -> f64 {
    let gltf = gltf::Gltf::from_slice(file).unwrap();
    let mut open: Vec<_> = gltf.default_scene().unwrap().nodes().collect();
    let mut above = vec![glam::DMat4::IDENTITY; open.len()];
    let mut sum = 0.0;
    while let (Some(node), Some(up)) = (open.pop(), above.pop()) {
        let columns = node.transform().matrix().map(|column| column.map(f64::from));
        let here = up * glam::DMat4::from_cols_array_2d(&columns);
        for child in node.children() {
            open.push(child);
            above.push(here);
        }
        for primitive in node.mesh().into_iter().flat_map(|mesh| mesh.primitives()) {
            let reader = primitive.reader(|_| gltf.blob.as_deref());
            let places: Vec<glam::DVec3> = reader
                .read_positions()
                .unwrap()
                .map(|p| here.transform_point3(glam::DVec3::from(p.map(f64::from))))
                .collect();
            let corners: Vec<usize> = match reader.read_indices() {
                Some(indices) => indices.into_u32().map(|k| k as usize).collect(),
                None => (0..places.len()).collect(),
            };
            let of = |[a, b, c]: [usize; 3]| {
                0.5 * (places[b] - places[a]).cross(places[c] - places[a]).length()
            };
            sum += corners.as_chunks::<3>().0.iter().map(|t| of(*t)).sum::<f64>();
        }
    }
    1e4 * sum
}

#[test]
fn a_glb_grows_the_cells_of_the_obj() {
    let mesh = ball();
    let file = glb(&mesh).write();
    assert_eq!(fingerprint(&file), fingerprint(mesh.to_obj().as_bytes()));
    assert_eq!(read(&file).unit_cm, 100.0);
    let (ours, others) = (f64::from(read(&file).body.surface.area), area_cm2(&file));
    assert!((ours / others - 1.0).abs() < 1e-5, "{ours} and {others}");
}

#[test]
fn nodes_stand_in_each_other_and_repeat_a_mesh() {
    // A turned and stretched node with two in it, one of them mirrored; one on its own by a matrix.
    let mut glb = glb(&ball());
    let half = 0.5f64.sqrt();
    glb.json["nodes"] = json!([
        {"rotation": [half, 0, 0, half], "scale": [0.01, 0.02, 0.03], "children": [1, 2]},
        {"mesh": 0, "translation": [20, 0, 0], "rotation": [0, half, 0, half]},
        {"mesh": 0, "scale": [-1, 1, 1], "name": "mirrored\nf 1 2 3"},
        {"mesh": 0, "matrix": [0.01, 0, 0, 0, 0, 0.01, 0, 0, 0, 0, 0.01, 0, 0, 5, 0, 1]},
    ]);
    glb.json["scenes"] = json!([{"nodes": []}, {"nodes": [3, 0]}]);
    glb.json["scene"] = json!(1);
    let file = glb.write();
    let brought = read(&file);
    let mesh = &brought.body.surface;
    assert_eq!((mesh.part_count(), rim_edges(mesh)), (3, 0));
    let (ours, others) = (f64::from(mesh.area), area_cm2(&file));
    assert!((ours / others - 1.0).abs() < 1e-5, "{ours} and {others}");
    // Those of a mirrored node are turned around, so that all are seen from outside.
    let volume: f32 = mesh
        .triangles
        .iter()
        .map(|t| t.map(|v| mesh.positions[v as usize]))
        .map(|[a, b, c]| a.cross(b).dot(c) / 6.0)
        .sum();
    let positions = ball();
    let one: f32 = positions
        .faces
        .iter()
        .map(|f| [0, 1, 2].map(|k| positions.positions[f.vertices[k] as usize]))
        .map(|[a, b, c]| a.cross(b).dot(c) / 6.0)
        .sum();
    assert!((volume / (one * 13.0) - 1.0).abs() < 1e-3, "{volume} and 13 of {one}");
    // What its names say of lines is no line of the OBJ file that is kept.
    let again = PolygonMesh::parse(&brought.mesh.to_obj()).unwrap();
    assert_eq!(again.faces.len(), brought.mesh.faces.len());

    // Without scenes, nodes that stand in no other.
    glb.json.as_object_mut().unwrap().retain(|key, _| !key.starts_with("scene"));
    assert_eq!(read(&glb.write()).body.surface.part_count(), 3);
    glb.json["nodes"].as_array_mut().unwrap().pop();
    glb.json["nodes"][2]["children"] = json!([0]);
    assert!(refusal(&glb.write()).contains("has no triangles"), "all stand in another");
    glb.json["scenes"] = json!([{"nodes": [0]}]);
    assert!(refusal(&glb.write()).contains("node 0 stands in its tree twice"));
}

/// A square of 2 m in the plane z = 0.
const SQUARE: [[f32; 3]; 4] = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [2.0, 2.0, 0.0]];

#[test]
fn triangles_stand_in_lists_strips_and_fans_with_numbers_of_any_size() {
    for (mode, corners) in [(4, &[0u8, 1, 2, 2, 1, 3][..]), (5, &[0, 1, 2, 3]), (6, &[0, 1, 3, 2])]
    {
        for component in [5121, 5123, 5125] {
            let bytes: Vec<u8> = corners
                .iter()
                .flat_map(|&k| match component {
                    5121 => vec![k],
                    5123 => vec![k, 0],
                    _ => vec![k, 0, 0, 0],
                })
                .collect();
            let mut glb = Glb::new(json!([{"mesh": 0}]));
            let places = glb.places(&SQUARE);
            let indices = glb.accessor(&bytes, corners.len(), component, "SCALAR");
            let points = json!({"attributes": {"POSITION": places}, "mode": 0});
            glb.mesh(json!([
                points,
                {"attributes": {"POSITION": places}, "indices": indices, "mode": mode}
            ]));
            gltf::Gltf::from_slice(&glb.write()).unwrap();
            let brought = read(&glb.write());
            let mesh = &brought.body.surface;
            assert_eq!((mesh.triangles.len(), mesh.area, rim_edges(mesh)), (2, 4e4, 4));
            let up = |t: &[u32; 3]| {
                let [a, b, c] = t.map(|v| mesh.positions[v as usize]);
                (b - a).cross(c - a).z > 0.0
            };
            assert!(mesh.triangles.iter().all(up), "mode {mode}");
        }
    }
}

#[test]
fn places_may_be_quantized_interleaved_and_without_indices() {
    // Shorts from -1 to 1 with two of padding, as `KHR_mesh_quantization` has them, and coordinates in bytes.
    let mut glb = Glb::new(json!([{"mesh": 0, "scale": [2, 2, 2]}]));
    glb.json["extensionsRequired"] = json!(["KHR_mesh_quantization", "KHR_materials_unlit"]);
    glb.json["materials"] = json!([{"name": "leaf"}]);
    let triangle = [[0i16, 0, 0, 0], [i16::MAX, 0, 0, 0], [0, i16::MAX, 0, 0]];
    let bytes: Vec<u8> = triangle.iter().flatten().flat_map(|x| x.to_le_bytes()).collect();
    let places = glb.accessor(&bytes, 3, 5122, "VEC3");
    glb.json["accessors"][places]["normalized"] = json!(true);
    let view = &mut glb.json["bufferViews"][places];
    view["byteStride"] = json!(8);
    let uvs = glb.accessor(&[0, 255, 255, 255, 0, 0], 3, 5121, "VEC2");
    glb.json["accessors"][uvs]["normalized"] = json!(true);
    let attributes = json!({"POSITION": places, "TEXCOORD_0": uvs});
    glb.mesh(json!([{"attributes": attributes, "material": 0}]));
    let brought = read(&glb.write());
    assert_eq!(brought.body.surface.area, 2e4, "half of a square of 2 m");
    let uvs: Vec<[f32; 2]> = brought.mesh.uvs.iter().map(|uv| uv.to_array()).collect();
    assert_eq!(uvs, [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], "they run up, as in OBJ");
    assert_eq!(brought.mesh.groups[0].material, "leaf");
}

#[test]
fn what_is_not_read_of_a_glb_is_told_in_a_sentence() {
    let whole = glb(&ball());
    let with = |path: &str, value: Value| {
        let mut glb = Glb { json: whole.json.clone(), bytes: whole.bytes.clone() };
        *glb.json.pointer_mut(path).unwrap() = value;
        glb.write()
    };
    let required = |name: &str| {
        let mut glb = Glb { json: whole.json.clone(), bytes: whole.bytes.clone() };
        glb.json["extensionsRequired"] = json!([name]);
        glb.write()
    };
    let sparse = json!({"componentType": 5126, "count": 3, "type": "VEC3", "sparse": {"count": 1}});
    let empty = json!({"componentType": 5126, "count": 4000000000u32, "type": "VEC3"});
    let packed =
        json!({"buffer": 0, "byteLength": 8, "extensions": {"EXT_meshopt_compression": {}}});
    let mut old = whole.write();
    old[4] = 1;
    for (bytes, why) in [
        (required("KHR_draco_mesh_compression"), "compressed with Draco: save it without"),
        (required("EXT_meshopt_compression"), "compressed with meshopt"),
        (required("EXT_mesh_gpu_instancing"), "\"EXT_mesh_gpu_instancing\", which is not read"),
        (with("/bufferViews/0", packed), "compressed with meshopt"),
        (with("/accessors/0", sparse), "sparse"),
        (with("/accessors/0", empty), "are not there"),
        (with("/buffers/0", json!({"uri": "a.bin"})), "in another file"),
        (with("/accessors/0/count", json!(99)), "names corner"),
        (with("/accessors/0/count", json!(u64::MAX)), "beyond its numbers"),
        (with("/bufferViews/0/byteLength", json!(1e9)), "not well formed"),
        (with("/accessors/0/type", json!("VEC4")), "not well formed"),
        (with("/nodes/0/mesh", json!(7)), "number 7 of its meshes is not there"),
        (with("/nodes", json!([])), "number 0 of its nodes is not there"),
        (with("/meshes/0/primitives", json!([])), "it has no triangles"),
        (old, "not of version 2"),
        (whole.write()[..200].to_vec(), "ends before"),
        (b"glTF".to_vec(), "ends before"),
    ] {
        let told = refusal(&bytes);
        assert!(told.starts_with("the GLB file: ") && told.contains(why), "{told} for {why}");
    }
}
