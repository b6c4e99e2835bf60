//! Draws the icons of the installed page anew, from the one of the tab: `./playground posters` runs this.

use crate::base64;
use crate::engines::Graphics;
use crate::page::Page;
use serde_json::json;
use std::path::Path;

/// File, side in pixels, and the share of it that the drawing takes. Of the maskable one a system may cut
/// all but a circle four fifths wide, and so it has a ground.
const ICONS: [(&str, u32, f64, &str); 3] = [
    ("icon-192.png", 192, 1.0, "transparent"),
    ("icon-512.png", 512, 1.0, "transparent"),
    ("icon-maskable-512.png", 512, 0.75, "#f5f2ea"),
];

#[test]
#[ignore = "it writes into www/"]
fn draw_icons() {
    let Some(page) = Page::start(Graphics::Neither) else { return };
    let www = Path::new(env!("CARGO_MANIFEST_DIR")).join("www");
    let svg = std::fs::read_to_string(www.join("icon.svg")).expect("an icon");
    for (name, side_px, share, ground) in ICONS {
        page.run(&format!(
            "const [svg, side, share, ground] = {};
             window.drawn = null;
             const icon = new Image();
             icon.onload = () => {{
                 const canvas = document.createElement('canvas');
                 canvas.width = canvas.height = side;
                 const pen = canvas.getContext('2d');
                 pen.fillStyle = ground;
                 pen.fillRect(0, 0, side, side);
                 const [size, margin] = [share * side, (1 - share) / 2 * side];
                 pen.drawImage(icon, margin, margin, size, size);
                 window.drawn = canvas.toDataURL().split(',')[1]
             }};
             const sized = svg.replace('<svg', `<svg width=\"${{side}}\" height=\"${{side}}\"`);
             icon.src = 'data:image/svg+xml,' + encodeURIComponent(sized)",
            json!([svg, side_px, share, ground])
        ));
        page.wait_for("the icon", "return !!window.drawn");
        let drawn = page.run("return window.drawn");
        let bytes = base64::read(drawn.as_str().expect("a picture"));
        std::fs::write(www.join("install").join(name), bytes).expect("it can be written");
    }
}
