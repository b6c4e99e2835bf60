//! Tiles, and plants as documents that are taken away.

use super::*;

#[test]
fn a_tile_goes_on_over_its_border() {
    let path = path("tile.png");
    let told = succeed(&["export", "--preset", "croton-shrub", "--day", "3", "--tile", &path]);
    assert!(told.contains("tile, day 3") && told.contains("2048 pixels wide"), "{told}");
    let file = std::io::BufReader::new(std::fs::File::open(&path).unwrap());
    let mut reader = png::Decoder::new(file).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    assert_eq!((info.width, info.height, info.color_type), (2048, 2048, png::ColorType::Rgb));

    // Pixels of two columns, or of two rows, that are unlike.
    let pixel = |x: usize, y: usize| &pixels[3 * (2048 * y + x)..][..3];
    let unlike = |a: usize, b: usize, is_row: bool| {
        let differ = |k: &usize| match is_row {
            true => pixel(*k, a) != pixel(*k, b),
            false => pixel(a, *k) != pixel(b, *k),
        };
        (0..2048).filter(differ).count() as f64
    };
    for is_row in [false, true] {
        let within = (0..64).map(|k| unlike(31 * k, 31 * k + 1, is_row));
        let (mean, most) = within.fold((0.0, 0.0), |(sum, most): (f64, f64), count| {
            (sum + count / 64.0, most.max(count))
        });
        let border = unlike(2047, 0, is_row);
        assert!(mean > 50.0 && border <= most, "{border} at the border, {mean}, at most {most}");
    }
}

#[test]
fn what_makes_no_tile_is_refused_in_words() {
    let path = path("no-tile.png");
    for (link, told) in
        [("cactus?v=1&n=900", "needs 1024 first cells, not 900"), ("croton?v=1&noise=1", "noise")]
    {
        let refused = mosaic(&["export", "--link", link, "--day", "0", "--tile", &path]);
        let line = String::from_utf8(refused.stderr).unwrap();
        assert_eq!((refused.status.code(), line.lines().count()), (Some(2), 1), "{line}");
        assert!(line.contains(told), "{line}");
    }
}

#[test]
fn a_plant_as_a_document_is_taken_away_as_its_preset_is() {
    let text = succeed(&["plant", "cactus"]);
    let export = |source: [&str; 2], name: &str| {
        let out = path(name);
        succeed(&["export", source[0], source[1], "--day", "0", "--ply", &out]);
        std::fs::read(out).unwrap()
    };
    let same = file("same.json", &text);
    let preset = export(["--preset", "cactus"], "preset.ply");
    assert!(export(["--plant", &same], "same.ply") == preset);
    let other = file("other.json", &text.replace("\"name\": \"Cactus\"", "\"name\": \"Mine\""));
    let other = export(["--plant", &other], "other.ply");
    // No link shows it.
    assert!(String::from_utf8_lossy(&other[..400]).contains("plant document cactus, individual 1"));
}
