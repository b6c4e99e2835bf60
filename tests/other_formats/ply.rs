//! PLY, as `ply-rs-bw` writes it.

use super::{ball, fingerprint, read, refusal};
use clonal_mosaic::surface::PolygonMesh;
use ply_rs_bw::ply::{
    DefaultElement, ElementDef, Encoding, Ply, Property, PropertyDef, PropertyType, ScalarType,
};
use ply_rs_bw::writer::Writer;

/// A body as a program of others writes it.
fn ply(mesh: &PolygonMesh, encoding: Encoding) -> Vec<u8> {
    let mut ply = Ply::<DefaultElement>::new();
    ply.header.encoding = encoding;
    ply.header.comments.push("Blender, Å".to_string());
    let element = |name: &str, properties: Vec<PropertyDef>| {
        let mut element = ElementDef::new(name.to_string());
        element.properties = properties.into_iter().map(|p| (p.name.clone(), p)).collect();
        (name.to_string(), element)
    };
    let scalar = |name: &str, kind| PropertyDef::new(name.into(), PropertyType::Scalar(kind));
    let list = PropertyType::List(ScalarType::UChar, ScalarType::Int);
    let corners = PropertyDef::new("vertex_index".to_string(), list);
    let places = ["x", "y", "z"].map(|name| scalar(name, ScalarType::Float));
    let vertex = [&[scalar("red", ScalarType::UChar)], &places[..]].concat();
    ply.header.elements.extend([
        element("vertex", vertex),
        element("camera", vec![scalar("f", ScalarType::Double)]),
        element("face", vec![scalar("flags", ScalarType::Short), corners]),
    ]);
    let item = |properties: Vec<(&str, Property)>| -> DefaultElement {
        properties.into_iter().map(|(name, value)| (name.to_string(), value)).collect()
    };
    let vertices = mesh.positions.iter().map(|p| {
        let places = [("x", p.x), ("y", p.y), ("z", p.z)];
        let places = places.map(|(name, x)| (name, Property::Float(x)));
        item([&[("red", Property::UChar(7))], &places[..]].concat())
    });
    let faces = mesh.faces.iter().map(|face| {
        let corners = face.vertices.iter().map(|&v| v as i32).collect();
        item(vec![("flags", Property::Short(-2)), ("vertex_index", Property::ListInt(corners))])
    });
    ply.payload.insert("vertex".to_string(), vertices.collect());
    ply.payload.insert("camera".to_string(), vec![item(vec![("f", Property::Double(0.5))])]);
    ply.payload.insert("face".to_string(), faces.collect());
    let mut bytes = Vec::new();
    Writer::new().write_ply(&mut bytes, &mut ply).unwrap();
    bytes
}

#[test]
fn a_ply_of_any_encoding_grows_the_cells_of_the_obj() {
    let squares = "v 0 0 0\nv 3 0 0.1\nv 3 3 0\nv 0 3 0\nv 6 0 0\nv 6 3 0\nf 1 2 3 4\nf 2 5 6 3\n";
    for mesh in [ball(), PolygonMesh::parse(squares).unwrap()] {
        let obj = fingerprint(mesh.to_obj().as_bytes());
        for encoding in [Encoding::Ascii, Encoding::BinaryLittleEndian, Encoding::BinaryBigEndian] {
            assert_eq!(fingerprint(&ply(&mesh, encoding)), obj, "{encoding:?}");
        }
        let text = String::from_utf8(ply(&mesh, Encoding::Ascii)).unwrap();
        for ends in ["\r\n", "\r"] {
            assert_eq!(fingerprint(text.replace('\n', ends).as_bytes()), obj, "{ends:?}");
        }
    }
}

#[test]
fn what_is_wrong_with_a_ply_is_told_in_a_sentence() {
    let head = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n";
    let faces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    let whole = format!("{head}property float z\n{faces}0 0 0 1 0 0 0 1 0\n3 0 1 2\n");
    assert_eq!(read(whole.as_bytes()).body.surface.area, 0.5);
    let binary = [whole.replace("ascii", "binary_little_endian").as_bytes(), &[0; 9]].concat();
    for (bytes, why) in [
        (whole.replace("3 0 1 2", "3 0 1 3").into_bytes(), "vertex 3, but there are 3"),
        (whole.replace("3 0 1 2", "3 0 1 -1").into_bytes(), "vertex -1"),
        (whole.replace("3 0 1 2", "3 0 1").into_bytes(), "ends before"),
        (whole.replace("3 0 1 2", "-3 0 1").into_bytes(), "a list of it has -3 numbers"),
        (whole.replace("1 0 0", "1 x 0").into_bytes(), "\"x\" is not a number"),
        (whole.replace(" z", " w").into_bytes(), "no x, y and z"),
        (whole.replace("float x", "quad x").into_bytes(), "its header says \"property quad x\""),
        (whole.replace("ascii", "utf16").into_bytes(), "its header says \"format utf16"),
        (whole.replace("format ascii 1.0\n", "").into_bytes(), "no format"),
        (whole.replace("vertex_indices", "corners").into_bytes(), "no list of vertices"),
        (whole.replace("end_header\n", "").into_bytes(), "its header says \"0 0 0"),
        (whole.replace("face 1", "face 0").into_bytes(), "it has no faces"),
        (b"ply\nformat ascii 1.0\n".to_vec(), "its header has no end"),
        (binary, "ends before"),
    ] {
        let told = refusal(&bytes);
        assert!(told.starts_with("the PLY file: ") && told.contains(why), "{told}");
    }
    // Lists of vertices are passed over.
    let lists = whole.replace("float z\n", "float z\nproperty list uchar uchar l\n");
    let lists = lists.replace("0 0 0 1 0 0 0 1 0", "0 0 0 2 7 7 1 0 0 0 0 1 0 1 9");
    assert_eq!(read(lists.as_bytes()).body.surface.area, 0.5);
    // However many items it is said to have, what is not there takes no time.
    let many = format!("{head}property float z\nelement none 99999999999999\n{faces}0 0 0");
    assert!(refusal(many.as_bytes()).contains("ends before"));
}
