//! Links that were sent once show the same cells for ever. The browser's tests read the same table.

use clonal_mosaic::plants;
use clonal_mosaic::play::link;
use clonal_mosaic::play::parameters::PARAMETERS;
use clonal_mosaic::tissue::Progress;
use std::sync::Arc;

const TABLE: &str = include_str!("golden_links.txt");

/// Links and their fingerprints.
fn golden() -> impl Iterator<Item = (&'static str, &'static str)> {
    TABLE.lines().filter(|line| !line.starts_with('#')).filter_map(|line| line.split_once(' '))
}

fn fingerprint(text: &str) -> String {
    let opened = link::read(text, plants::all());
    assert!(opened.left_out.is_empty(), "{text}: {:?}", opened.left_out);
    let scene = opened.scene;
    let mesh = Arc::new(scene.plant.embedded_body().surface);
    let mut growth = scene.plant.sow(mesh, scene.recipe, scene.individual).unwrap();
    while growth.step() != Progress::Day(scene.day) {}
    growth.diary.fingerprint(scene.day as usize)
}

#[test]
fn golden_links_grow_the_cells_that_they_grew() {
    assert!(golden().count() >= 10);
    let changed: Vec<String> = golden()
        .map(|(link, expected)| (link, expected, fingerprint(link)))
        .filter(|(_, expected, found)| expected != found)
        .map(|(link, expected, found)| format!("{link}: {expected} has become {found}"))
        .collect();
    assert!(changed.is_empty(), "links that were sent now lie:\n{}", changed.join("\n"));
}

#[test]
fn every_plant_has_a_golden_link_of_each_version() {
    for plant in plants::all() {
        for version in 1..=plant.rules as u32 {
            let begins = format!("{}?v={version}&", plant.key);
            assert!(golden().any(|(link, _)| link.starts_with(&begins)), "{begins}");
        }
    }
}

#[test]
fn golden_links_are_written_as_they_were_read() {
    for (text, _) in golden() {
        assert_eq!(link::write(&link::read(text, plants::all()).scene), text);
    }
}

/// For the days before a version is out: afterwards a changed fingerprint is a new version.
#[test]
#[ignore = "writes tests/golden_links.txt"]
fn write_golden_links_anew() {
    let comments = TABLE.lines().filter(|line| line.starts_with('#')).map(str::to_string);
    let rows = golden().map(|(link, _)| format!("{link} {}", fingerprint(link)));
    let text: Vec<String> = comments.chain(rows).collect();
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/golden_links.txt");
    std::fs::write(path, text.join("\n") + "\n").unwrap();
}

#[test]
fn every_word_of_a_link_is_documented_with_its_range() {
    let page = include_str!("../docs/links.md");
    let row = |word: &str| page.lines().find(|line| line.starts_with(&format!("| `{word}` |")));
    for parameter in PARAMETERS {
        let [least, most] = parameter.range.map(|end| parameter.written(end));
        let row = row(parameter.key).unwrap_or_else(|| panic!("no row for {}", parameter.key));
        assert!(row.ends_with(&format!("| {least} | {most} |")), "{row}");
    }
    for plant in plants::all() {
        assert!(page.contains(&format!("`{}`", plant.key)), "{}", plant.key);
    }
    let words = page.lines().filter_map(|line| line.strip_prefix("| `")?.split('`').next());
    assert_eq!(words.clone().count(), PARAMETERS.len() + 7);
    for word in words {
        let told = link::read(&format!("red-croton?{word}=?"), plants::all()).left_out;
        assert!(!told.iter().any(|why| why.contains("unknown to this")), "{word}: {told:?}");
    }
}
