//! The mosaic as binary glTF (Khronos, glTF 2.0 Specification, 4.4 "GLB File Format"): one mesh, of which the
//! first primitive is the mosaic with a colour at each corner, and the others are the bare materials.

use super::specimen::Specimen;
use glam::Vec3;
use serde_json::{Value, json};
use std::io::{self, Write};

/// Numbers of the specification.
const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;
const UNSIGNED_SHORT: u32 = 5123;
const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;

/// Metres in a centimetre: glTF is in metres, and the node scales.
const METRES: f64 = 0.01;

/// Writes a plant. Its link stands in the `extras` of the scene.
///
/// # Errors
/// What `out` says, and more than 4 GB, which the format cannot hold.
pub fn write_glb(specimen: &Specimen, out: &mut impl Write) -> io::Result<()> {
    let mut file = File::default();
    let mosaic = specimen.coloured();
    let points: Vec<_> =
        mosaic.corners.iter().map(|corner| specimen.tiling.points[corner.0 as usize]).collect();
    let positions: Vec<Vec3> = points.iter().map(|point| point.position).collect();
    let normals: Vec<Vec3> = points.iter().map(|point| point.normal).collect();
    drop(points);
    let colours: Vec<[u16; 4]> = mosaic.corners.iter().map(|corner| opaque(corner.1)).collect();
    let colours = file.accessor(&colours, UNSIGNED_SHORT, "VEC4", ARRAY_BUFFER);
    file.accessors[colours]["normalized"] = json!(true);
    file.primitive(&positions, &normals, &mosaic.triangles, Some(colours));
    file.material("mosaic", Vec3::ONE, specimen.gloss);
    for bare in &specimen.bare {
        file.primitive(&bare.positions, &bare.normals, &bare.triangles, None);
        file.material(&bare.material, bare.colour, bare.gloss);
    }
    file.write(&specimen.link, out)
}

/// What stands in a file.
#[derive(Default)]
struct File {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
    primitives: Vec<Value>,
    materials: Vec<Value>,
}

impl File {
    /// Adds numbers, and returns where they are found.
    fn accessor<T: bytemuck::Pod>(
        &mut self,
        items: &[T],
        component: u32,
        kind: &str,
        target: u32,
    ) -> usize {
        let bytes: &[u8] = bytemuck::cast_slice(items);
        self.views.push(json!({
            "buffer": 0, "byteOffset": self.bytes.len(), "byteLength": bytes.len(), "target": target
        }));
        self.bytes.extend(bytes);
        let view = self.views.len() - 1;
        let scalars = if kind == "SCALAR" { size_of::<T>() / 4 } else { 1 };
        self.accessors.push(json!({
            "bufferView": view, "componentType": component, "count": items.len() * scalars, "type": kind
        }));
        self.accessors.len() - 1
    }

    /// Adds triangles, in the material that comes next.
    fn primitive(
        &mut self,
        positions: &[Vec3],
        normals: &[Vec3],
        triangles: &[[u32; 3]],
        colours: Option<usize>,
    ) {
        let low = positions.iter().copied().fold(Vec3::INFINITY, Vec3::min);
        let high = positions.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
        let places = self.accessor(positions, FLOAT, "VEC3", ARRAY_BUFFER);
        self.accessors[places]["min"] = json!(low.to_array());
        self.accessors[places]["max"] = json!(high.to_array());
        let normals = self.accessor(normals, FLOAT, "VEC3", ARRAY_BUFFER);
        let indices = self.accessor(triangles, UNSIGNED_INT, "SCALAR", ELEMENT_ARRAY_BUFFER);
        let mut attributes = json!({"POSITION": places, "NORMAL": normals});
        if let Some(colours) = colours {
            attributes["COLOR_0"] = json!(colours);
        }
        let material = self.materials.len();
        self.primitives
            .push(json!({"attributes": attributes, "indices": indices, "material": material}));
    }

    /// Adds a material, seen from both sides.
    fn material(&mut self, name: &str, colour: Vec3, gloss: f32) {
        // As `shade` in `scene.wgsl`.
        let roughness = 0.75 + (0.14 - 0.75) * gloss;
        self.materials.push(json!({
            "name": name,
            "doubleSided": true,
            "pbrMetallicRoughness": {
                "baseColorFactor": [colour.x, colour.y, colour.z, 1.0],
                "metallicFactor": 0.0,
                "roughnessFactor": roughness,
            },
        }));
    }

    fn write(self, link: &str, out: &mut impl Write) -> io::Result<()> {
        let json = json!({
            "asset": {"version": "2.0", "generator": "Clonal Mosaic"},
            "scene": 0,
            "scenes": [{"nodes": [0], "extras": {"link": link}}],
            "nodes": [{"name": "plant", "mesh": 0, "scale": [METRES, METRES, METRES]}],
            "meshes": [{"name": "plant", "primitives": self.primitives}],
            "materials": self.materials,
            "accessors": self.accessors,
            "bufferViews": self.views,
            "buffers": [{"byteLength": self.bytes.len()}],
        });
        let mut text = json.to_string().into_bytes();
        text.resize(text.len().next_multiple_of(4), b' ');
        // All numbers have four or eight bytes, so the other chunk is as long as it must be.
        let whole = 12 + 8 + text.len() + 8 + self.bytes.len();
        let too_long = |_| io::Error::other("a GLB file cannot hold more than 4 GB");
        let whole = u32::try_from(whole).map_err(too_long)?;
        out.write_all(b"glTF")?;
        for word in [2, whole] {
            out.write_all(&word.to_le_bytes())?;
        }
        for (kind, chunk) in [(b"JSON", &text), (b"BIN\0", &self.bytes)] {
            out.write_all(&(chunk.len() as u32).to_le_bytes())?;
            out.write_all(kind)?;
            out.write_all(chunk)?;
        }
        Ok(())
    }
}

/// A colour in linear light, as glTF has them.
fn opaque(linear: Vec3) -> [u16; 4] {
    let [red, green, blue] =
        linear.to_array().map(|c| (c.clamp(0.0, 1.0) * f32::from(u16::MAX) + 0.5) as u16);
    [red, green, blue, u16::MAX]
}
