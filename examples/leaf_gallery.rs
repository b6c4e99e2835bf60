//! A sheet of leaves as SVG on the standard output: one for each file of numbers that is named, or the kinds
//! of `examples/leaves`.
//!
//!     cargo run --release --example leaf_gallery > leaves.svg

use clonal_mosaic::shapes::leaf::{Leaf, LeafNumbers};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Of a leaf's square, and leaves in a row.
const SIDE_PX: f64 = 300.0;
const COLUMNS: usize = 4;

fn main() -> ExitCode {
    match sheet() {
        Ok(svg) => {
            print!("{svg}");
            ExitCode::SUCCESS
        }
        Err(refusal) => {
            eprintln!("leaf_gallery: {refusal}");
            ExitCode::from(2)
        }
    }
}

fn sheet() -> Result<String, String> {
    let mut files: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    if files.is_empty() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/leaves");
        let entries = std::fs::read_dir(&folder).map_err(|e| e.to_string())?;
        files = entries.filter_map(|entry| Some(entry.ok()?.path())).collect();
        files.sort();
    }
    let rows = files.len().div_ceil(COLUMNS);
    let (width, height) = (COLUMNS as f64 * SIDE_PX, rows as f64 * SIDE_PX);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#fbfaf6\"/>\n"
    );
    for (k, file) in files.iter().enumerate() {
        let wrong = |e: &dyn std::fmt::Display| format!("{}: {e}", file.display());
        let text = std::fs::read_to_string(file).map_err(|e| wrong(&e))?;
        let numbers = LeafNumbers::from_json(&text).map_err(|e| wrong(&e))?;
        let leaf = Leaf::new(&numbers, 1).map_err(|e| wrong(&e))?;
        let corner = [(k % COLUMNS) as f64 * SIDE_PX, (k / COLUMNS) as f64 * SIDE_PX];
        let name = file.file_stem().unwrap_or_default().to_string_lossy().replace('_', " ");
        draw(&leaf, corner, &name, &mut svg);
    }
    svg.push_str("</svg>\n");
    Ok(svg)
}

/// The flat leaf in a square: limb, veins and name.
fn draw(leaf: &Leaf, [left, top]: [f64; 2], name: &str, svg: &mut String) {
    let border = || leaf.limb.outlines.iter().flatten();
    let low = border().fold(glam::DVec2::splat(0.0), |low, &p| low.min(p));
    let high = border().fold(glam::DVec2::splat(0.0), |high, &p| high.max(p));
    let size = high - low;
    let scale = 0.82 * SIDE_PX / size.x.max(size.y);
    let middle = (low + high) / 2.0;
    let place = |p: glam::DVec2| {
        let x = left + SIDE_PX / 2.0 + (p.x - middle.x) * scale;
        let y = top + SIDE_PX * 0.47 - (p.y - middle.y) * scale;
        format!("{x:.1} {y:.1}")
    };
    let path =
        |points: &[glam::DVec2]| points.iter().map(|&p| place(p)).collect::<Vec<_>>().join(" L ");
    for outline in &leaf.limb.outlines {
        let d = path(outline);
        let _ = writeln!(svg, "<path d=\"M {d} Z\" fill=\"#7fb05a\" stroke=\"#38602c\"/>");
    }
    for vein in &leaf.plan.veins {
        let (d, px) = (path(&vein.path), if vein.right.is_none() { 2.2 } else { 1.0 });
        let _ = writeln!(
            svg,
            "<path d=\"M {d}\" fill=\"none\" stroke=\"#e4efc4\" stroke-width=\"{px}\"/>"
        );
    }
    let (x, y) = (left + SIDE_PX / 2.0, top + SIDE_PX - 8.0);
    let _ = writeln!(
        svg,
        "<text x=\"{x}\" y=\"{y}\" font-family=\"sans-serif\" font-size=\"14\" \
         text-anchor=\"middle\">{name}</text>"
    );
}
