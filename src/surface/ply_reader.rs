//! PLY, the Stanford polygon format (G. Turk, The PLY Polygon File Format, 1994): in text, and in bytes of either
//! order.

use super::obj_reader::number;
use super::{Face, Group, PolygonMesh, quoted};
use glam::{DVec3, Vec2};

/// The positions of a file as exact as they stand there, and a mesh without them: vertices with their texture
/// coordinates, if they have some, and faces with three corners or more. All else is passed over.
///
/// # Errors
/// In plain words, what is not well formed or not there.
pub(super) fn read(bytes: &[u8]) -> Result<(Vec<DVec3>, PolygonMesh), String> {
    let (header, body) = Header::read(bytes)?;
    let mut body = Body { rest: body, encoding: header.encoding };
    let mut mesh = PolygonMesh::default();
    let mut positions = Vec::new();
    for element in &header.elements {
        match &*element.name {
            "vertex" => read_vertices(element, &mut body, &mut positions, &mut mesh.uvs)?,
            "face" => read_faces(element, &mut body, &mut mesh.faces)?,
            _ => element.each(&mut body, &mut |_| {})?,
        }
    }
    if mesh.faces.is_empty() {
        return Err("it has no faces".to_string());
    }
    let count = positions.len();
    let largest = mesh.faces.iter().flat_map(|face| &face.vertices).max();
    if let Some(vertex) = largest.filter(|&&vertex| vertex as usize >= count) {
        return Err(format!("a face names vertex {vertex}, but there are {count}, from 0 on"));
    }
    mesh.groups = vec![Group { part: String::new(), material: String::new() }];
    Ok((positions, mesh))
}

/// Names of texture coordinates, as the one or the other program writes them.
const UVS: [[&str; 2]; 3] = [["s", "t"], ["u", "v"], ["texture_u", "texture_v"]];

fn read_vertices(
    element: &Element,
    body: &mut Body,
    positions: &mut Vec<DVec3>,
    uvs: &mut Vec<Vec2>,
) -> Result<(), String> {
    let [Some(x), Some(y), Some(z)] = ["x", "y", "z"].map(|name| element.place(name)) else {
        return Err("its vertices have no x, y and z".to_string());
    };
    let uv = UVS.into_iter().find_map(|[u, v]| Some([element.place(u)?, element.place(v)?]));
    element.each(body, &mut |found| {
        let Found::Item(row) = found else { return };
        positions.push(DVec3::new(row[x], row[y], row[z]));
        if let Some([u, v]) = uv {
            let uv = Vec2::new(row[u] as f32, row[v] as f32);
            uvs.push(if uv.is_finite() { uv } else { Vec2::ZERO });
        }
    })
}

fn read_faces(element: &Element, body: &mut Body, faces: &mut Vec<Face>) -> Result<(), String> {
    let is_corners = |p: &Property| p.length.is_some() && p.name.starts_with("vertex_ind");
    if !element.properties.iter().any(is_corners) {
        return Err("its faces have no list of vertices".to_string());
    }
    let mut wrong = None;
    element.each(body, &mut |found| {
        let list = match found {
            Found::List(property, list) if is_corners(property) => list,
            _ => return,
        };
        let is_vertex = |n: &&f64| **n >= 0.0 && **n < f64::from(u32::MAX) && n.fract() == 0.0;
        wrong = wrong.or_else(|| list.iter().find(|n| !is_vertex(n)).copied());
        if list.len() >= 3 {
            let vertices = list.iter().map(|&n| n as u32).collect();
            faces.push(Face { vertices, group: 0 });
        }
    })?;
    match wrong {
        Some(number) => Err(format!("a face names vertex {number}, and there is none")),
        None => Ok(()),
    }
}

#[derive(Clone, Copy, PartialEq)]
enum Encoding {
    Text,
    LittleEndian,
    BigEndian,
}

#[derive(Clone, Copy)]
enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    fn of_word(word: &str) -> Option<Scalar> {
        Some(match word {
            "char" | "int8" => Scalar::I8,
            "uchar" | "uint8" => Scalar::U8,
            "short" | "int16" => Scalar::I16,
            "ushort" | "uint16" => Scalar::U16,
            "int" | "int32" => Scalar::I32,
            "uint" | "uint32" => Scalar::U32,
            "float" | "float32" => Scalar::F32,
            "double" | "float64" => Scalar::F64,
            _ => return None,
        })
    }
}

/// A number of each item, or with a type of length a list of them.
struct Property {
    name: String,
    scalar: Scalar,
    length: Option<Scalar>,
}

/// Items that are alike: vertices, faces.
struct Element {
    name: String,
    count: u64,
    properties: Vec<Property>,
}

struct Header {
    encoding: Encoding,
    elements: Vec<Element>,
}

impl Header {
    /// Reads a header, and returns what comes after it.
    fn read(bytes: &[u8]) -> Result<(Header, &[u8]), String> {
        // What follows the last line may be any bytes, so that the first must say how lines end.
        let end: &[u8] = match bytes {
            [b'p', b'l', b'y', b'\r', b'\n', ..] => b"\r\n",
            [b'p', b'l', b'y', b'\r', ..] => b"\r",
            _ => b"\n",
        };
        let (mut encoding, mut elements) = (None, Vec::<Element>::new());
        let mut rest = bytes;
        loop {
            let length = rest.windows(end.len()).position(|window| window == end);
            // A text without any faces may end here.
            let (line, after) = match length {
                Some(length) => (&rest[..length], &rest[length + end.len()..]),
                None => (rest, &rest[rest.len()..]),
            };
            let line = String::from_utf8_lossy(line);
            let words: Vec<&str> = line.split_whitespace().collect();
            let unknown = || format!("its header says {}", quoted(line.trim()));
            match words[..] {
                ["end_header"] => {
                    let encoding = encoding.ok_or("its header says no format")?;
                    return Ok((Header { encoding, elements }, after));
                }
                _ if length.is_none() => return Err("its header has no end".to_string()),
                ["format", word, ..] => {
                    encoding = Some(match word {
                        "ascii" => Encoding::Text,
                        "binary_little_endian" => Encoding::LittleEndian,
                        "binary_big_endian" => Encoding::BigEndian,
                        _ => return Err(unknown()),
                    });
                }
                ["element", name, count] => {
                    let count = count.parse().map_err(|_| unknown())?;
                    elements.push(Element { name: name.into(), count, properties: Vec::new() });
                }
                ["property", ref kind @ .., name] => {
                    let scalars: Option<Vec<Scalar>> =
                        kind.iter().filter(|w| **w != "list").map(|w| Scalar::of_word(w)).collect();
                    let (scalar, length) = match (kind.first(), scalars.as_deref()) {
                        (Some(&"list"), Some(&[length, scalar])) => (scalar, Some(length)),
                        (_, Some(&[scalar])) => (scalar, None),
                        _ => return Err(unknown()),
                    };
                    let element = elements.last_mut().ok_or_else(unknown)?;
                    element.properties.push(Property { name: name.into(), scalar, length });
                }
                [] | ["ply"] | ["comment" | "obj_info", ..] => {}
                _ => return Err(unknown()),
            }
            rest = after;
        }
    }
}

/// What is read of an item.
enum Found<'a> {
    List(&'a Property, &'a [f64]),
    /// Its numbers in the order of the properties, with a zero in the place of each list.
    Item(&'a [f64]),
}

impl Element {
    /// Where a number stands among those of an item.
    fn place(&self, name: &str) -> Option<usize> {
        self.properties.iter().position(|p| p.name == name && p.length.is_none())
    }

    /// Reads all items, and hands on each list as it is read, and then the numbers of its item.
    fn each(&self, body: &mut Body, take: &mut dyn FnMut(Found)) -> Result<(), String> {
        let (mut row, mut list) = (vec![0.0; self.properties.len()], Vec::new());
        // Whatever its count, an item without properties is nothing.
        let count = if row.is_empty() { 0 } else { self.count };
        for _ in 0..count {
            for (number, property) in row.iter_mut().zip(&self.properties) {
                let Some(length) = property.length else {
                    *number = body.number(property.scalar)?;
                    continue;
                };
                list.clear();
                let length = body.number(length)?;
                if !(length >= 0.0 && length.fract() == 0.0) {
                    return Err(format!("a list of it has {length} numbers"));
                }
                for _ in 0..length as u64 {
                    list.push(body.number(property.scalar)?);
                }
                take(Found::List(property, &list));
            }
            take(Found::Item(&row));
        }
        Ok(())
    }
}

/// What comes after the header.
struct Body<'a> {
    rest: &'a [u8],
    encoding: Encoding,
}

impl Body<'_> {
    fn number(&mut self, scalar: Scalar) -> Result<f64, String> {
        if self.encoding == Encoding::Text {
            let word = self.word()?;
            return number(Some(&String::from_utf8_lossy(word)));
        }
        Ok(match scalar {
            Scalar::I8 => i8::from_le_bytes(self.bytes()?).into(),
            Scalar::U8 => u8::from_le_bytes(self.bytes()?).into(),
            Scalar::I16 => i16::from_le_bytes(self.bytes()?).into(),
            Scalar::U16 => u16::from_le_bytes(self.bytes()?).into(),
            Scalar::I32 => i32::from_le_bytes(self.bytes()?).into(),
            Scalar::U32 => u32::from_le_bytes(self.bytes()?).into(),
            Scalar::F32 => f32::from_le_bytes(self.bytes()?).into(),
            Scalar::F64 => f64::from_le_bytes(self.bytes()?),
        })
    }

    /// The next word of a text.
    fn word(&mut self) -> Result<&[u8], String> {
        let start = self.rest.trim_ascii_start();
        let length = start.iter().position(u8::is_ascii_whitespace).unwrap_or(start.len());
        let (word, rest) = start.split_at(length);
        self.rest = rest;
        if word.is_empty() { Err(too_short()) } else { Ok(word) }
    }

    /// The next bytes, the lowest first.
    fn bytes<const N: usize>(&mut self) -> Result<[u8; N], String> {
        let (bytes, rest) = self.rest.split_first_chunk::<N>().ok_or_else(too_short)?;
        self.rest = rest;
        let mut bytes = *bytes;
        if self.encoding == Encoding::BigEndian {
            bytes.reverse();
        }
        Ok(bytes)
    }
}

fn too_short() -> String {
    "it ends before all its vertices and faces are there".to_string()
}
