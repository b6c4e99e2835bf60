//! Binary glTF (Khronos, glTF 2.0 Specification, 4.4 "GLB File Format"): the triangles of all meshes, where the
//! nodes of the scene have them.

use super::obj_reader::name;
use super::{Face, Group, PolygonMesh, quoted};
use glam::{DMat4, DQuat, DVec3, DVec4, Vec2};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};

/// Centimetres in a unit: glTF is in metres.
pub(super) const UNIT_CM: f64 = 100.0;

/// Corners at most: nodes may repeat a mesh, so that a small file may have any number of them.
const MOST_CORNERS: usize = 5_000_000;

/// Compressions, by a word in the names of their extensions.
const COMPRESSIONS: [(&str, &str); 2] =
    [("draco_mesh_compression", "Draco"), ("meshopt_compression", "meshopt")];

/// Extensions that change nothing about where triangles are, by a part of their names, and those that are read.
const HARMLESS: [&str; 6] =
    ["_materials_", "_texture_", "_lights_", "_xmp", "KHR_mesh_quantization", "_animation_"];

/// The positions of a file in centimetres, and a mesh without them: every primitive is a group with the names of its
/// node and of its material.
///
/// # Errors
/// In plain words, what is not well formed, not there or not read.
pub(super) fn read(bytes: &[u8]) -> Result<(Vec<DVec3>, PolygonMesh), String> {
    let file = File::read(bytes)?;
    let mut joined = Joined::default();
    let mut seen = BTreeSet::new();
    let mut open: Vec<(u64, DMat4)> = Vec::new();
    let root = DMat4::from_scale(DVec3::splat(UNIT_CM));
    open.extend(file.roots()?.into_iter().rev().map(|node| (node, root)));
    while let Some((number, above)) = open.pop() {
        if !seen.insert(number) {
            return Err(format!("node {number} stands in its tree twice"));
        }
        let node = file.item("nodes", number)?;
        let here = above * matrix(node);
        open.extend(indices(&node["children"])?.into_iter().rev().map(|child| (child, here)));
        if let Some(mesh) = node["mesh"].as_u64() {
            // What moves with a skeleton stands where its own corners say.
            let place = if node["skin"].is_null() { here } else { root };
            let mesh = file.item("meshes", mesh)?;
            let part = text(&node["name"]).or(text(&mesh["name"])).unwrap_or_default();
            for primitive in mesh["primitives"].as_array().into_iter().flatten() {
                joined.add(&file, primitive, place, part)?;
            }
        }
    }
    let Joined { positions, mut mesh, has_uvs, .. } = joined;
    if mesh.faces.is_empty() {
        return Err("it has no triangles".to_string());
    }
    if !has_uvs {
        mesh.uvs.clear();
    }
    Ok((positions, mesh))
}

/// All primitives so far.
#[derive(Default)]
struct Joined {
    positions: Vec<DVec3>,
    mesh: PolygonMesh,
    has_uvs: bool,
    groups: BTreeMap<[String; 2], u32>,
}

impl Joined {
    fn add(
        &mut self,
        file: &File,
        primitive: &Value,
        place: DMat4,
        part: &str,
    ) -> Result<(), String> {
        let mode = primitive["mode"].as_u64().unwrap_or(TRIANGLES);
        let attributes = &primitive["attributes"];
        // Points and lines carry no cells.
        if !(TRIANGLES..=TRIANGLE_FAN).contains(&mode) || attributes["POSITION"].is_null() {
            return Ok(());
        }
        let places = file.numbers(&attributes["POSITION"], 3)?;
        let count = places.len() / 3;
        let corners = match &primitive["indices"] {
            Value::Null => (0..count as u32).map(f64::from).collect(),
            indices => file.numbers(indices, 1)?,
        };
        let first = self.positions.len();
        if first + count + corners.len() > MOST_CORNERS {
            return Err(format!("it has more than {MOST_CORNERS} corners"));
        }
        if let Some(corner) = corners.iter().find(|&&k| k >= count as f64) {
            return Err(format!("a triangle names corner {corner}, but there are {count}"));
        }
        let places = places.as_chunks::<3>().0.iter();
        self.positions.extend(places.map(|&p| place.transform_point3(p.into())));
        if !attributes["TEXCOORD_0"].is_null() {
            let uvs = file.numbers(&attributes["TEXCOORD_0"], 2)?;
            // They run down in glTF, and up in OBJ.
            let uvs = uvs.as_chunks().0.iter().map(|&[u, v]| Vec2::new(u as f32, (1.0 - v) as f32));
            self.mesh.uvs.extend(uvs.map(|uv| if uv.is_finite() { uv } else { Vec2::ZERO }));
            self.has_uvs = true;
        }
        self.mesh.uvs.resize(self.positions.len(), Vec2::ZERO);
        let group = self.group(part, file.material(primitive));
        let is_mirrored = place.determinant() < 0.0;
        let corner = |k: usize| first as u32 + corners[k] as u32;
        for mut vertices in triangles(mode, corners.len()).map(|t| t.map(corner)) {
            if is_mirrored {
                vertices.swap(1, 2);
            }
            self.mesh.faces.push(Face { vertices: vertices.to_vec(), group });
        }
        Ok(())
    }

    /// The number of a group. Its names become those of an OBJ file, where they are a line.
    fn group(&mut self, part: &str, material: &str) -> u32 {
        let [part, material] = [part, material].map(|text| name(&format!("g {text}")));
        let groups = &mut self.mesh.groups;
        *self.groups.entry([part.clone(), material.clone()]).or_insert_with(|| {
            groups.push(Group { part, material });
            groups.len() as u32 - 1
        })
    }
}

/// Modes of primitives.
const TRIANGLES: u64 = 4;
const TRIANGLE_STRIP: u64 = 5;
const TRIANGLE_FAN: u64 = 6;

/// The corners of each triangle, in the orders that the specification says (3.7.2.1).
fn triangles(mode: u64, corners: usize) -> impl Iterator<Item = [usize; 3]> {
    let count = if mode == TRIANGLES { corners / 3 } else { corners.saturating_sub(2) };
    (0..count).map(move |k| match mode {
        TRIANGLE_STRIP => [k, k + 1 + k % 2, k + 2 - k % 2],
        TRIANGLE_FAN => [k + 1, k + 2, 0],
        _ => [3 * k, 3 * k + 1, 3 * k + 2],
    })
}

/// The two parts of a file.
struct File<'a> {
    json: Value,
    bytes: &'a [u8],
}

impl<'a> File<'a> {
    fn read(bytes: &'a [u8]) -> Result<File<'a>, String> {
        let short = "it ends before all that it says is there";
        let word = |at: usize| {
            let bytes = bytes.get(at..)?.first_chunk::<4>()?;
            Some(u32::from_le_bytes(*bytes) as usize)
        };
        if word(4).ok_or(short)? != 2 {
            return Err("it is not of version 2 of glTF: save it anew".to_string());
        }
        let chunk = |at: usize, kind: &[u8]| {
            let body = at.checked_add(8)?;
            let chunk = bytes.get(body..body.checked_add(word(at)?)?)?;
            (bytes.get(at + 4..body)? == kind).then_some(chunk)
        };
        let json = chunk(12, b"JSON").ok_or(short)?;
        let bytes = chunk(20 + json.len(), b"BIN\0").unwrap_or_default();
        let json: Value =
            serde_json::from_slice(json).map_err(|why| format!("what it says of itself: {why}"))?;
        for extension in json["extensionsRequired"].as_array().into_iter().flatten() {
            let extension = extension.as_str().unwrap_or_default();
            refuse_compression(extension)?;
            if !HARMLESS.iter().any(|part| extension.contains(part)) {
                let name = quoted(extension);
                return Err(format!("it needs the extension {name}, which is not read here"));
            }
        }
        Ok(File { json, bytes })
    }

    /// One of the things that are numbered.
    fn item(&self, kind: &str, number: u64) -> Result<&Value, String> {
        let item = usize::try_from(number).ok().and_then(|number| self.json[kind].get(number));
        item.ok_or_else(|| format!("number {number} of its {kind} is not there"))
    }

    /// The nodes that stand on top in the scene, or without scenes all that stand in no other.
    fn roots(&self) -> Result<Vec<u64>, String> {
        if !self.json["scenes"].is_null() {
            let scene = self.item("scenes", self.json["scene"].as_u64().unwrap_or(0))?;
            return indices(&scene["nodes"]);
        }
        let nodes = self.json["nodes"].as_array().map(Vec::as_slice).unwrap_or_default();
        let mut below = BTreeSet::new();
        for node in nodes {
            below.extend(indices(&node["children"])?);
        }
        Ok((0..nodes.len() as u64).filter(|node| !below.contains(node)).collect())
    }

    fn material(&self, primitive: &Value) -> &str {
        let material = primitive["material"].as_u64();
        let material = material.and_then(|number| self.item("materials", number).ok());
        material.and_then(|material| text(&material["name"])).unwrap_or_default()
    }

    /// The numbers of an accessor, so many for each of its items.
    fn numbers(&self, accessor: &Value, parts: usize) -> Result<Vec<f64>, String> {
        let accessor = self.item("accessors", accessor.as_u64().unwrap_or(u64::MAX))?;
        let wrong = || "its accessors are not well formed".to_string();
        let kind = ["SCALAR", "VEC2", "VEC3"][parts - 1];
        if accessor["type"] != kind {
            return Err(wrong());
        }
        if !accessor["sparse"].is_null() {
            return Err(
                "it says some places as changes of others (sparse accessors), which is not \
                        read here: save it without them"
                    .to_string(),
            );
        }
        let Some(view) = accessor["bufferView"].as_u64() else {
            let used = self.json["extensionsUsed"].as_array().into_iter().flatten();
            used.filter_map(Value::as_str).try_for_each(refuse_compression)?;
            return Err("places of its corners are not there".to_string());
        };
        let view = self.item("bufferViews", view)?;
        let extensions = view["extensions"].as_object();
        extensions.into_iter().flatten().try_for_each(|(name, _)| refuse_compression(name))?;
        let buffer = view["buffer"].as_u64().unwrap_or(u64::MAX);
        if buffer != 0 || !self.item("buffers", 0)?["uri"].is_null() {
            return Err("its numbers lie in another file: save it as one GLB file".to_string());
        }

        let size = |value: &Value| value.as_u64().and_then(|number| usize::try_from(number).ok());
        let bytes = (|| {
            let start = size(&view["byteOffset"]).unwrap_or(0);
            let end = start.checked_add(size(&view["byteLength"])?)?;
            self.bytes.get(start..end)?.get(size(&accessor["byteOffset"]).unwrap_or(0)..)
        })();
        let bytes = bytes.ok_or_else(wrong)?;
        let number = Component::of(accessor).ok_or_else(wrong)?;
        let stride = size(&view["byteStride"]).unwrap_or(0).max(parts * number.bytes);
        let count = size(&accessor["count"]).ok_or_else(wrong)?;
        let last = count.checked_sub(1).and_then(|last| last.checked_mul(stride));
        let ends = last.and_then(|last| last.checked_add(parts * number.bytes));
        if count > 0 && ends.is_none_or(|ends| ends > bytes.len()) {
            return Err("its accessors reach beyond its numbers".to_string());
        }
        let read = |k: usize| number.read(&bytes[k / parts * stride + k % parts * number.bytes..]);
        Ok((0..count * parts).map(read).collect())
    }
}

/// How a number is written.
struct Component {
    kind: u64,
    bytes: usize,
    /// Whole numbers of a quantized mesh stand for 0 to 1, or -1 to 1, if this is more than 1.
    greatest: f64,
}

impl Component {
    fn of(accessor: &Value) -> Option<Component> {
        let kind = accessor["componentType"].as_u64()?;
        let (bytes, greatest) = match kind {
            5120 => (1, f64::from(i8::MAX)),
            5121 => (1, f64::from(u8::MAX)),
            5122 => (2, f64::from(i16::MAX)),
            5123 => (2, f64::from(u16::MAX)),
            5125 => (4, f64::from(u32::MAX)),
            5126 => (4, 1.0),
            _ => return None,
        };
        let is_normalized = accessor["normalized"] == true;
        Some(Component { kind, bytes, greatest: if is_normalized { greatest } else { 1.0 } })
    }

    /// The number with which some bytes begin, as many as it has at least.
    fn read(&self, bytes: &[u8]) -> f64 {
        let [a, b] = [bytes[0], bytes[self.bytes / 2]];
        let four = || [bytes[0], bytes[1], bytes[2], bytes[3]];
        let number = match self.kind {
            5120 => f64::from(a as i8),
            5121 => f64::from(a),
            5122 => f64::from(i16::from_le_bytes([a, b])),
            5123 => f64::from(u16::from_le_bytes([a, b])),
            5125 => f64::from(u32::from_le_bytes(four())),
            _ => f64::from(f32::from_le_bytes(four())),
        };
        if self.greatest > 1.0 { (number / self.greatest).max(-1.0) } else { number }
    }
}

fn refuse_compression(extension: &str) -> Result<(), String> {
    match COMPRESSIONS.iter().find(|(word, _)| extension.contains(word)) {
        Some((_, name)) => {
            Err(format!("it is compressed with {name}: save it without compression"))
        }
        None => Ok(()),
    }
}

/// Where a node stands in the one above it.
fn matrix(node: &Value) -> DMat4 {
    if let Some(columns) = floats::<16>(&node["matrix"]) {
        let column = |k: usize| DVec4::from_slice(&columns[4 * k..]);
        return DMat4::from_cols(column(0), column(1), column(2), column(3));
    }
    let scale = floats::<3>(&node["scale"]).map_or(DVec3::ONE, DVec3::from);
    let rotation = floats::<4>(&node["rotation"]).map(|[x, y, z, w]| DVec4::new(x, y, z, w));
    let rotation =
        rotation.and_then(DVec4::try_normalize).map_or(DQuat::IDENTITY, DQuat::from_vec4);
    let translation = floats::<3>(&node["translation"]).map_or(DVec3::ZERO, DVec3::from);
    DMat4::from_scale_rotation_translation(scale, rotation, translation)
}

/// So many numbers, if they are there.
fn floats<const N: usize>(value: &Value) -> Option<[f64; N]> {
    let list = value.as_array().filter(|list| list.len() == N)?;
    let mut numbers = [0.0; N];
    for (number, value) in numbers.iter_mut().zip(list) {
        *number = value.as_f64()?;
    }
    Some(numbers)
}

/// Numbers of other things; none at all are none.
fn indices(value: &Value) -> Result<Vec<u64>, String> {
    let numbers = value.as_array().into_iter().flatten();
    let numbers: Option<Vec<u64>> = numbers.map(Value::as_u64).collect();
    numbers.ok_or_else(|| "its nodes are not well formed".to_string())
}

fn text(value: &Value) -> Option<&str> {
    value.as_str().filter(|text| !text.is_empty())
}
