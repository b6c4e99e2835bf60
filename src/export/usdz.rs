//! The plant for the cameras of phones, as USDZ (Pixar, USDZ File Format Specification): a text in USD and a picture
//! of its colours, one small square each, in a ZIP whose files lie at whole multiples of 64 bytes.
//!
//! Viewers of phones pass over colours at corners, and over what is said of the other side of a sheet. So each
//! triangle looks into the middle of the square of its colour, and a surface with a rim is there twice.

use super::picture::{Channels, write_square};
use super::ply::bytes;
use super::specimen::Specimen;
use super::zip::write_zip;
use crate::surface::NO_TWIN;
use glam::Vec3;
use std::fmt::Write as _;
use std::io::{self, Write};

/// Pixels of a square: so many that its middle is its own colour on smaller copies of the picture, too.
const SQUARE_PX: usize = 8;

/// What the format asks for.
const ALIGNED: usize = 64;

/// Writes a plant; its link stands in the layer's data. Returns how many triangles there are.
///
/// # Errors
/// What `out` says, and more than 4 GB.
pub fn write_usdz(specimen: &Specimen, out: &mut impl Write) -> io::Result<usize> {
    let mosaic = specimen.coloured();
    let mut colours: Vec<[u8; 3]> = mosaic.corners.iter().map(|corner| bytes(corner.1)).collect();
    let of_corner = colours.clone();
    colours.sort_unstable();
    colours.dedup();
    let side = (1..).find(|side| side * side >= colours.len()).unwrap_or(1);
    let place = |colour: &[u8; 3]| {
        let k = colours.partition_point(|other| other < colour);
        // The picture begins at the top, and its coordinates at the bottom.
        let [x, y] = [k % side, side - 1 - k / side];
        [x, y].map(|at| (at as f32 + 0.5) / side as f32)
    };
    let points: Vec<_> =
        mosaic.corners.iter().map(|corner| specimen.tiling.points[corner.0 as usize]).collect();
    let mut sheet = Sheet {
        positions: points.iter().map(|point| point.position).collect(),
        normals: points.iter().map(|point| point.normal).collect(),
        places: of_corner.iter().map(place).collect(),
        triangles: mosaic.triangles,
    };
    if specimen.mesh.twins.contains(&NO_TWIN) {
        sheet.add_other_side();
    }
    let mut triangles = sheet.triangles.len();
    let mut text = head(&specimen.link);
    sheet.write("mosaic", &mut text);
    for bare in &specimen.bare {
        let mut sheet = Sheet {
            positions: bare.positions.clone(),
            normals: bare.normals.clone(),
            places: Vec::new(),
            triangles: bare.triangles.clone(),
        };
        sheet.add_other_side();
        triangles += sheet.triangles.len();
        sheet.write(&word(&bare.material), &mut text);
    }
    text += "    def Scope \"materials\"\n    {\n";
    material("mosaic", specimen.gloss, None, &mut text);
    for bare in &specimen.bare {
        material(&word(&bare.material), bare.gloss, Some(bare.colour), &mut text);
    }
    text += "    }\n}\n";
    let side_px = side * SQUARE_PX;
    let pixel = |k: usize| {
        let [x, y] = [k % side_px, k / side_px].map(|at| at / SQUARE_PX);
        colours.get(x + y * side).copied().unwrap_or_default()
    };
    let pixels: Vec<u8> = (0..side_px * side_px).flat_map(pixel).collect();
    let picture = write_square(side_px as u32, Channels::Colour, &pixels)?;
    write_zip(&[("plant.usda", text.as_bytes()), ("colours.png", &picture)], ALIGNED, out)?;
    Ok(triangles)
}

/// Triangles of one material; of the mosaic, where each corner finds its colour in the picture.
struct Sheet {
    positions: Vec<Vec3>,
    normals: Vec<Vec3>,
    places: Vec<[f32; 2]>,
    triangles: Vec<[u32; 3]>,
}

impl Sheet {
    fn add_other_side(&mut self) {
        let first = self.positions.len() as u32;
        let other = |&[a, b, c]: &[u32; 3]| [c, b, a].map(|corner| first + corner);
        self.triangles.extend(self.triangles.iter().map(other).collect::<Vec<_>>());
        self.positions.extend_from_within(..);
        let normals: Vec<Vec3> = self.normals.iter().map(|&normal| -normal).collect();
        self.normals.extend(normals);
        self.places.extend_from_within(..);
    }

    fn write(&self, name: &str, text: &mut String) {
        let low = self.positions.iter().copied().reduce(Vec3::min).unwrap_or_default();
        let high = self.positions.iter().copied().reduce(Vec3::max).unwrap_or_default();
        let _ = write!(
            text,
            "    def Mesh \"{name}\" (\n        prepend apiSchemas = [\"MaterialBindingAPI\"]\n    )\n    {{\n\
             \x20       uniform bool doubleSided = 1\n\
             \x20       float3[] extent = [{}, {}]\n\
             \x20       rel material:binding = </plant/materials/{name}>\n\
             \x20       uniform token subdivisionScheme = \"none\"\n",
            row(low.to_array(), 4),
            row(high.to_array(), 4),
        );
        let counts = self.triangles.iter().map(|_| "3".to_string());
        list("int[] faceVertexCounts", counts, "", text);
        let corners = self.triangles.iter().map(|[a, b, c]| format!("{a}, {b}, {c}"));
        list("int[] faceVertexIndices", corners, "", text);
        let positions = self.positions.iter().map(|at| row(at.to_array(), 4));
        list("point3f[] points", positions, "", text);
        let of_vertices = " (\n            interpolation = \"vertex\"\n        )";
        let normals = self.normals.iter().map(|normal| row(normal.to_array(), 3));
        list("normal3f[] normals", normals, of_vertices, text);
        if !self.places.is_empty() {
            let places = self.places.iter().map(|&at| row(at, 5));
            list("texCoord2f[] primvars:st", places, of_vertices, text);
        }
        *text += "    }\n";
    }
}

/// The layer's head, in centimetres with y up.
fn head(link: &str) -> String {
    let link = link.replace('\\', "\\\\").replace('"', "\\\"");
    format!(
        "#usda 1.0\n(\n    customLayerData = {{\n        string creator = \"Clonal Mosaic\"\n        string link = \"{link}\"\n\
         \x20   }}\n    defaultPrim = \"plant\"\n    metersPerUnit = 0.01\n    upAxis = \"Y\"\n)\n\n\
         def Xform \"plant\" (\n    kind = \"component\"\n)\n{{\n"
    )
}

/// A material: a plain colour, in linear light, or else the colours of the picture.
fn material(name: &str, gloss: f32, colour: Option<Vec3>, text: &mut String) {
    let path = format!("/plant/materials/{name}");
    // As `shade` in `scene.wgsl`.
    let roughness = 0.75 + (0.14 - 0.75) * gloss;
    let diffuse = match colour {
        Some(colour) => format!("color3f inputs:diffuseColor = {}", row(colour.to_array(), 4)),
        None => format!("color3f inputs:diffuseColor.connect = <{path}/colours.outputs:rgb>"),
    };
    let _ = write!(
        text,
        "        def Material \"{name}\"\n        {{\n\
         \x20           token outputs:surface.connect = <{path}/surface.outputs:surface>\n\
         \x20           def Shader \"surface\"\n            {{\n\
         \x20               uniform token info:id = \"UsdPreviewSurface\"\n\
         \x20               {diffuse}\n\
         \x20               float inputs:metallic = 0\n                float inputs:roughness = {roughness}\n\
         \x20               token outputs:surface\n            }}\n"
    );
    if colour.is_none() {
        let _ = write!(
            text,
            "            def Shader \"colours\"\n            {{\n\
             \x20               uniform token info:id = \"UsdUVTexture\"\n\
             \x20               asset inputs:file = @colours.png@\n\
             \x20               token inputs:sourceColorSpace = \"sRGB\"\n\
             \x20               float2 inputs:st.connect = <{path}/places.outputs:result>\n\
             \x20               token inputs:wrapS = \"clamp\"\n                token inputs:wrapT = \"clamp\"\n\
             \x20               float3 outputs:rgb\n            }}\n\
             \x20           def Shader \"places\"\n            {{\n\
             \x20               uniform token info:id = \"UsdPrimvarReader_float2\"\n\
             \x20               string inputs:varname = \"st\"\n                float2 outputs:result\n            }}\n"
        );
    }
    *text += "        }\n";
}

/// Writes an attribute that is a list.
fn list(name: &str, items: impl Iterator<Item = String>, meta: &str, text: &mut String) {
    let _ = write!(text, "        {name} = [");
    for (k, item) in items.enumerate() {
        text.push_str(if k == 0 { "" } else { ", " });
        text.push_str(&item);
    }
    let _ = writeln!(text, "]{meta}");
}

/// `(0.1, -2, 3.25)`, with so many digits after the point and none that say nothing.
fn row<const N: usize>(numbers: [f32; N], digits: usize) -> String {
    let said = numbers.map(|x| {
        let text = format!("{x:.digits$}");
        let short = text.trim_end_matches('0').trim_end_matches('.');
        if short == "-0" { "0".to_string() } else { short.to_string() }
    });
    format!("({})", said.join(", "))
}

/// A name as USD has them: letters, digits and low lines, and no digit first.
fn word(name: &str) -> String {
    let word: String =
        name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
    format!("bare_{word}")
}
