//! A plant to be printed in colours, as 3MF (3MF Consortium, Core Specification 1.3): one object whose triangles
//! have the materials of their types.

use super::ply::bytes;
use super::solid::Solid;
use super::specimen::Specimen;
use super::zip::write_zip;
use crate::plants::linear;
use crate::tissue::CellType;
use std::fmt::Write as _;
use std::io::{self, Write};

const TYPES: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>
"#;

const RELATIONS: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>
"#;

/// Writes closed bodies; z is up, as printers have it. Returns how many triangles there are.
///
/// # Errors
/// What `out` says, and more than 4 GB.
pub fn write_3mf(specimen: &Specimen, out: &mut impl Write) -> io::Result<usize> {
    let solid = Solid::new(specimen);
    let link = specimen.link.replace('&', "&amp;").replace('<', "&lt;");
    let mut model = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"millimeter\" xml:lang=\"en\" \
         xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n\
         <metadata name=\"Description\">Clonal Mosaic {link}</metadata>\n\
         <resources>\n<basematerials id=\"1\">\n"
    );
    let types = CellType::ALL
        .map(|kind| (kind.letter().to_string(), linear(specimen.type_colours[kind as usize])));
    let bare = specimen.bare.iter().map(|bare| (bare.material.clone(), bare.colour));
    // Writing to a string does not fail.
    for (name, colour) in types.into_iter().chain(bare) {
        let [r, g, b] = bytes(colour);
        let _ = writeln!(model, "<base name=\"{name}\" displaycolor=\"#{r:02X}{g:02X}{b:02X}\"/>");
    }
    model += "</basematerials>\n<object id=\"2\" type=\"model\" pid=\"1\" pindex=\"0\">\n<mesh>\n<vertices>\n";
    for place in &solid.positions {
        let [x, y, z] = [place.x, -place.z, place.y].map(|x| 10.0 * x);
        let _ = writeln!(model, "<vertex x=\"{x}\" y=\"{y}\" z=\"{z}\"/>");
    }
    model += "</vertices>\n<triangles>\n";
    for ([a, b, c], material) in &solid.triangles {
        let _ = writeln!(
            model,
            "<triangle v1=\"{a}\" v2=\"{b}\" v3=\"{c}\" pid=\"1\" p1=\"{material}\"/>"
        );
    }
    model += "</triangles>\n</mesh>\n</object>\n</resources>\n<build>\n<item objectid=\"2\"/>\n\
              </build>\n</model>\n";
    let files = [
        ("[Content_Types].xml", TYPES.as_bytes()),
        ("_rels/.rels", RELATIONS.as_bytes()),
        ("3D/3dmodel.model", model.as_bytes()),
    ];
    write_zip(&files, 1, out)?;
    Ok(solid.triangles.len())
}
