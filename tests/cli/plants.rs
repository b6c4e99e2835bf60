//! Plants as documents.

use super::*;
use clonal_mosaic::plants;

#[test]
fn every_plant_is_printed_and_grows_as_its_preset_does() {
    for plant in plants::all() {
        let text = succeed(&["plant", plant.key]);
        let document = file(&format!("{}.json", plant.key), &text);
        let run = |source: &str, name: &str| json(&["grow", source, name, "--day", "1", "--json"]);
        let (own, preset) = (run("--plant", &document), run("--preset", plant.key));
        assert_eq!(own["plant"], plant.key);
        assert_eq!(own["days"], preset["days"], "{}", plant.key);
    }
}

#[test]
fn a_changed_number_is_a_changed_plant() {
    let text = succeed(&["plant", "banded-cactus"]);
    let grow = |text: &str| {
        let document = file("changed.json", text);
        json(&["grow", "--plant", &document, "--day", "0", "--json"])["days"][0].clone()
    };
    let before = grow(&text);
    for (from, to) in [
        ("[9.0, 15.5]", "[9.0, 25.5]"),
        ("\"initial_cells\": 14000", "\"initial_cells\": 13000"),
        // The skin is refined as all the rest then.
        ("\"skin\"", "\"flesh\""),
        ("\"cactus.obj\"", "\"watermelon.obj\""),
    ] {
        assert!(text.contains(from), "{from}");
        assert_ne!(grow(&text.replacen(from, to, 1)), before, "{to}");
    }
    // A longer belt has more yellow first cells.
    let yellow = |day: &Value| day["F"].as_u64().unwrap();
    let longer = grow(&text.replacen("[9.0, 15.5]", "[9.0, 25.5]", 1));
    assert!(yellow(&longer) > yellow(&before) + 100, "{longer} after {before}");
}

#[test]
fn growth_that_is_the_same_everywhere_changes_nothing_and_other_growth_does() {
    let text = succeed(&["plant", "mushroom"]);
    let still = "\"growth\": []";
    assert!(text.contains(still));
    let grow = |growth: &str, mesh: &[&str]| {
        let document =
            file("growing.json", &text.replace(still, &format!("\"growth\": [{growth}]")));
        let grow = [&["grow", "--plant", &document, "--day", "4", "--json"], mesh].concat();
        json(&grow)["days"].clone()
    };
    let size =
        |day: u32, factors: [f32; 3]| format!("{{\"day\": {day}, \"factors\": {factors:?}}}");
    let even = [size(1, [0.25; 3]), size(2, [0.5; 3]), size(3, [2.0; 3])].join(", ");
    let upwards = [size(0, [1.0; 3]), size(4, [1.0, 3.0, 1.0])].join(", ");
    let mesh = file("growing.obj", TETRAHEDRON);
    for mesh in [&[][..], &["--mesh", &mesh]] {
        let still = grow("", mesh);
        let fingerprint = |days: &Value, day: usize| days[day]["fingerprint"].clone();
        let (even, upwards) = (grow(&even, mesh), grow(&upwards, mesh));
        for day in 0..=4 {
            assert_eq!(fingerprint(&even, day), fingerprint(&still, day), "day {day}");
        }
        assert_eq!(upwards[4]["cells"], still[4]["cells"]);
        assert_ne!(fingerprint(&upwards, 4), fingerprint(&still, 4));
    }
}

#[test]
fn images_and_guides_of_a_document_lie_on_a_mesh_of_ones_own() {
    let mesh = file("plants.obj", TETRAHEDRON);
    let half = succeed(&["plant", "croton"])
        .replace("\"base\": [0.0, 10.0, 0.0]", "\"base\": [0.0, 0.0, 0.0]")
        .replace("\"height_cm\": 28.0", "\"height_cm\": 1.0")
        .replace("\"black_at_the_top\": 0.65", "\"black_at_the_top\": 1.0");
    let document = file("half.json", &half);
    let grow = ["grow", "--plant", &document, "--mesh", &mesh, "--day", "0", "--json"];
    let day = json(&grow)["days"][0].clone();
    // Upwards of the middle there are ever fewer yellow first cells, of 19 in 100.
    let yellow = day["F"].as_f64().unwrap() / day["cells"].as_f64().unwrap();
    assert!((0.08..0.15).contains(&yellow), "{yellow}");

    let leaf = file("leaf.json", &succeed(&["plant", "philodendron"]));
    let refused = mosaic(&["grow", "--plant", &leaf, "--mesh", &mesh]);
    let told = String::from_utf8(refused.stderr).unwrap();
    assert!(told.contains("lies on leaf coordinates: this mesh has none"), "{told}");
    assert_eq!((refused.status.code(), told.lines().count()), (Some(2), 1));
}

#[test]
fn what_is_no_plant_is_refused_in_one_line() {
    let text = succeed(&["plant", "mushroom"]);
    for (text, told) in [
        (
            text.replace("\"gloss\": 0.5", "\"gloss\": 5"),
            "look: gloss is 5: it must be from 0 to 1",
        ),
        (text.replace("\"moss\"", "\"mould\""), "body.growths"),
        (text.replace("\"rims\"", "\"rimes\""), "paint[1].image.rule"),
        (
            text.replace(
                "\"growth\": []",
                "\"growth\": [{\"day\": 2, \"factors\": [1, 1, 1]}, {\"day\": 2, \"factors\": [2, 1, 1]}]",
            ),
            "motion: growth: day 2 stands after day 2",
        ),
        (
            text.replace("\"growth\": []", "\"growth\": [{\"day\": 2, \"factors\": [1, 0, 1]}]"),
            "motion: a factor of growth is 0: it must be from 0.01 to 100",
        ),
        (text.replace("\"view\"", "\"vue\""), "vue"),
        ("{}".to_string(), "missing field"),
        (" [1, {}]".to_string(), "an object {...} is needed, not a list"),
        ("no".to_string(), "the plant is no JSON"),
    ] {
        let document = file("refused.json", &text);
        let refused = mosaic(&["grow", "--plant", &document]);
        let line = String::from_utf8(refused.stderr).unwrap();
        assert_eq!((refused.status.code(), line.lines().count()), (Some(2), 1), "{line}");
        assert!(line.contains(told) && line.contains("refused.json"), "{told}: {line}");
    }
    let unknown = mosaic(&["plant", "nettle"]);
    let line = String::from_utf8(unknown.stderr).unwrap();
    assert!(line.contains("there is no preset \"nettle\""), "{line}");
}
