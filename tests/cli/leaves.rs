//! Leaves as a set of pictures, read back by the readers of others.

use super::*;
use std::io::{Cursor, Read};

/// The files of a ZIP, by their names.
fn unpacked(path: &str) -> Vec<(String, Vec<u8>)> {
    let mut zip = zip::ZipArchive::new(std::fs::File::open(path).unwrap()).unwrap();
    let names: Vec<String> = zip.file_names().map(str::to_string).collect();
    let read = |name: String| {
        let mut bytes = Vec::new();
        zip.by_name(&name).unwrap().read_to_end(&mut bytes).unwrap();
        (name, bytes)
    };
    names.into_iter().map(read).collect()
}

/// The side of a square picture, and its bytes.
fn picture(files: &[(String, Vec<u8>)], name: &str, kind: png::ColorType) -> (usize, Vec<u8>) {
    let (_, bytes) = files.iter().find(|(other, _)| other == name).expect(name);
    let mut reader = png::Decoder::new(Cursor::new(bytes)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    assert_eq!((info.width, info.color_type), (info.height, kind), "{name}");
    (info.width as usize, pixels)
}

#[test]
fn leaves_of_several_individuals_stand_in_one_set_of_pictures() {
    let path = path("leaves.zip");
    let plant = ["export", "--preset", "begonia", "--day", "1", "--individual", "4"];
    let told = succeed(&[&plant[..], &["--individuals", "2", "--leaves", &path]].concat());
    assert!(told.contains("leaves, day 1") && told.contains("2 individuals"), "{told}");
    let files = unpacked(&path);
    let facts: Value =
        serde_json::from_slice(&files.iter().find(|f| f.0 == "leaves.json").unwrap().1).unwrap();
    assert_eq!(facts["link"], "begonia?v=1&s=4&d=1");
    let (side, colour) = picture(&files, "colour.png", png::ColorType::Rgb);
    let (_, alpha) = picture(&files, "alpha.png", png::ColorType::Grayscale);
    let (_, normal) = picture(&files, "normal.png", png::ColorType::Rgb);
    let (_, veins) = picture(&files, "veins.png", png::ColorType::Grayscale);
    assert_eq!((side, facts["side_px"].as_u64()), (4096, Some(4096)));
    assert_eq!([colour.len(), alpha.len(), normal.len()], [3, 1, 3].map(|n| n * side * side));

    // The leaves are as large as on the plant, whose parts all can be laid flat.
    let grow = ["grow", "--preset", "begonia", "--day", "0", "--json"];
    let cm2 = json(&grow)["body"]["area_cm2"].as_f64().unwrap();
    let per_cm = facts["px_per_cm"].as_f64().unwrap();
    let covered = alpha.iter().map(|&a| f64::from(a) / 255.0).sum::<f64>() / (per_cm * per_cm);
    assert!((covered / (2.0 * cm2) - 1.0).abs() < 0.03, "{covered} cm2 of twice {cm2}");

    let leaves = facts["leaves"].as_array().unwrap();
    let numbers = |leaf: &Value, key: &str| -> [usize; 2] {
        [0, 1].map(|k| leaf[key][k].as_u64().unwrap() as usize)
    };
    let pixels = |leaf: &Value| {
        let ([x, y], [width, height]) = (numbers(leaf, "corner_px"), numbers(leaf, "size_px"));
        (y..y + height).flat_map(move |y| (x..x + width).map(move |x| y * side + x))
    };
    let of = |individual: u64| leaves.iter().filter(move |leaf| leaf["individual"] == individual);
    assert!(of(4).count() > 1 && of(4).count() == of(5).count());
    let (mut seen, mut on_veins) = (0, 0);
    for leaf in leaves {
        let mut sum = [0.0; 3];
        for pixel in pixels(leaf).filter(|&pixel| alpha[pixel] == 255) {
            let direction = [0, 1, 2].map(|k| f64::from(normal[3 * pixel + k]) / 127.5 - 1.0);
            let length = direction.iter().map(|x| x * x).sum::<f64>();
            assert!((length - 1.0).abs() < 0.05, "{direction:?}");
            (0..3).for_each(|k| sum[k] += direction[k]);
            seen += 1;
            on_veins += usize::from(veins[pixel] > 127);
        }
        // In the mean they look out of the picture.
        assert!(sum[2] > 8.0 * sum[0].abs() && sum[2] > 8.0 * sum[1].abs(), "{sum:?}");
    }
    let share = on_veins as f64 / seen as f64;
    assert!(share > 0.01 && share < 0.3, "{share} of the leaves are veins");

    // Another individual has other cells on leaves of the same form, in the same colours.
    let [one, other] = [4, 5].map(|k| of(k).next().unwrap());
    assert_eq!(numbers(one, "size_px"), numbers(other, "size_px"));
    let pairs = || pixels(one).zip(pixels(other));
    assert!(pairs().all(|(a, b)| alpha[a].abs_diff(alpha[b]) <= 64), "the same form");
    let differ = pairs().filter(|&(a, b)| {
        alpha[a] == 255 && (0..3).any(|k| colour[3 * a + k].abs_diff(colour[3 * b + k]) > 9)
    });
    assert!(differ.count() * 20 > pairs().count(), "other cells");
}

#[test]
fn what_has_no_leaves_is_refused_in_words() {
    let path = path("no-leaves.zip");
    for (arguments, told) in [
        (["--preset", "watermelon", "--day", "0"], "nothing of this plant can be laid flat"),
        (["--day", "0", "--individuals", "17"], "from 1 to 16"),
    ] {
        let refused = mosaic(&[&["export", "--leaves", &path], &arguments[..]].concat());
        let line = String::from_utf8(refused.stderr).unwrap();
        assert_eq!((refused.status.code(), line.lines().count()), (Some(2), 1), "{line}");
        assert!(line.contains(told), "{line}");
    }
    let refused = mosaic(&["export", "--individuals", "2", "--svg", &path]);
    assert!(String::from_utf8(refused.stderr).unwrap().contains("is for --leaves"));
}
