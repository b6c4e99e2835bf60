//! The mosaic as binary glTF (Khronos, glTF 2.0 Specification, 4.4 "GLB File Format"): one mesh, of which the
//! first primitive is the mosaic with a colour at each corner, or the body with the mosaic as its texture, and the
//! others are the bare materials.

use super::specimen::{Bare, Specimen};
use super::unwrapped::Unwrapped;
use crate::surface::Mesh;
use glam::{Vec2, Vec3};
use serde_json::{Value, json};
use std::io::{self, Write};

/// Numbers of the specification.
const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;
const UNSIGNED_SHORT: u32 = 5123;
const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;
const LINEAR: u32 = 9729;
const LINEAR_MIPMAP_LINEAR: u32 = 9987;
const CLAMP_TO_EDGE: u32 = 33071;

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
    file.primitive(&positions, &normals, &mosaic.triangles, Some(("COLOR_0", colours)));
    file.material("mosaic", Vec3::ONE, specimen.gloss);
    file.bare(&specimen.bare);
    file.write(&specimen.link, out)
}

/// A body with its mosaic as a texture.
pub(super) struct Textured<'a> {
    pub link: String,
    pub mesh: &'a Mesh,
    pub unwrapped: &'a Unwrapped,
    pub side_px: u32,
    /// The texture as PNG.
    pub png: &'a [u8],
    pub gloss: f32,
    pub bare: &'a [Bare],
}

impl Textured<'_> {
    /// Writes it as `write_glb` does a plant.
    ///
    /// # Errors
    /// The same.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        let mut file = File::default();
        let (mesh, corners) = (self.mesh, &self.unwrapped.corners);
        let positions: Vec<Vec3> =
            corners.iter().map(|&(k, _)| mesh.positions[k as usize]).collect();
        let normals: Vec<Vec3> = corners.iter().map(|&(k, _)| mesh.normals[k as usize]).collect();
        let places: Vec<Vec2> = corners.iter().map(|&(_, px)| px / self.side_px as f32).collect();
        let triangles: Vec<[u32; 3]> =
            self.unwrapped.triangles.iter().map(|own| own.corners).collect();
        let places = file.accessor(&places, FLOAT, "VEC2", ARRAY_BUFFER);
        file.primitive(&positions, &normals, &triangles, Some(("TEXCOORD_0", places)));
        file.material("mosaic", Vec3::ONE, self.gloss);
        file.picture(self.png);
        file.bare(self.bare);
        file.write(&self.link, out)
    }
}

/// What stands in a file.
#[derive(Default)]
struct File {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
    primitives: Vec<Value>,
    materials: Vec<Value>,
    images: Vec<Value>,
    samplers: Vec<Value>,
    textures: Vec<Value>,
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
        more: Option<(&str, usize)>,
    ) {
        let low = positions.iter().copied().fold(Vec3::INFINITY, Vec3::min);
        let high = positions.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
        let places = self.accessor(positions, FLOAT, "VEC3", ARRAY_BUFFER);
        self.accessors[places]["min"] = json!(low.to_array());
        self.accessors[places]["max"] = json!(high.to_array());
        let normals = self.accessor(normals, FLOAT, "VEC3", ARRAY_BUFFER);
        let indices = self.accessor(triangles, UNSIGNED_INT, "SCALAR", ELEMENT_ARRAY_BUFFER);
        let mut attributes = json!({"POSITION": places, "NORMAL": normals});
        if let Some((name, numbers)) = more {
            attributes[name] = json!(numbers);
        }
        let material = self.materials.len();
        self.primitives
            .push(json!({"attributes": attributes, "indices": indices, "material": material}));
    }

    fn bare(&mut self, parts: &[Bare]) {
        for bare in parts {
            self.primitive(&bare.positions, &bare.normals, &bare.triangles, None);
            self.material(&bare.material, bare.colour, bare.gloss);
        }
    }

    /// Adds a PNG as the texture of the material that came last.
    fn picture(&mut self, png: &[u8]) {
        self.views
            .push(json!({"buffer": 0, "byteOffset": self.bytes.len(), "byteLength": png.len()}));
        self.bytes.extend(png);
        // What follows has four bytes or eight.
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        self.images.push(json!({"bufferView": self.views.len() - 1, "mimeType": "image/png"}));
        self.samplers.push(json!({
            "magFilter": LINEAR, "minFilter": LINEAR_MIPMAP_LINEAR,
            "wrapS": CLAMP_TO_EDGE, "wrapT": CLAMP_TO_EDGE
        }));
        self.textures
            .push(json!({"source": self.images.len() - 1, "sampler": self.samplers.len() - 1}));
        if let Some(material) = self.materials.last_mut() {
            material["pbrMetallicRoughness"]["baseColorTexture"] =
                json!({"index": self.textures.len() - 1});
        }
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
        let mut json = json!({
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
        // A list that is there must hold something.
        let pictures =
            [("images", self.images), ("samplers", self.samplers), ("textures", self.textures)];
        for (name, list) in pictures.into_iter().filter(|(_, list)| !list.is_empty()) {
            json[name] = Value::Array(list);
        }
        let mut text = json.to_string().into_bytes();
        text.resize(text.len().next_multiple_of(4), b' ');
        // All numbers have four or eight bytes, and pictures are filled up: the other chunk is as long as it must be.
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
