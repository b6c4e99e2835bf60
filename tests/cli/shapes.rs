//! Bodies from rules.

use crate::{file, json, mosaic, path, succeed};
use serde_json::Value;

#[test]
fn a_tree_is_told_in_numbers_that_agree() {
    let stats = json(&[
        "shape",
        "tree",
        "--matrix",
        "uniform",
        "--order",
        "5",
        "--individual",
        "7",
        "--stats",
    ]);
    assert_eq!(stats["order"], 5);
    let numbers = |value: &Value| -> Vec<f64> {
        value.as_array().unwrap().iter().map(|n| n.as_f64().unwrap()).collect()
    };
    let branches = numbers(&stats["branches"]);
    assert_eq!(
        (branches.len(), branches[0], branches[4]),
        (5, stats["leaves"].as_f64().unwrap(), 1.0)
    );
    let rows = stats["matrix"].as_array().unwrap();
    assert_eq!(rows.len(), 4);
    for (k, row) in (2..).zip(rows) {
        let row = numbers(row);
        assert!(row.len() == k && (row.iter().sum::<f64>() - 1.0).abs() < 1e-12, "{row:?}");
    }
    // Two branches of the next lower order at each fork, and the side branches: N_i as the source counts.
    let nodes = |k: usize| branches[k - 1] / numbers(&rows[k - 2])[k - 1];
    for i in 1..5 {
        let sides: f64 = (i + 1..=5).map(|k| nodes(k) * numbers(&rows[k - 2])[i - 1]).sum();
        assert!((2.0 * branches[i] + sides - branches[i - 1]).abs() < 1e-6, "order {i}");
    }
}

#[test]
fn the_same_tree_is_the_same_however_it_is_said() {
    let rows = file("rows.json", "[[0.5, 0.5], [0.5, 0.25, 0.25]]");
    let numbers = file(
        "tree.json",
        r#"{"order": 3, "matrix": [[0.5, 0.5], [0.5, 0.25, 0.25]], "fork_deg": 40}"#,
    );
    let stats = |more: &[&str]| {
        succeed(&[&["shape", "tree", "--stats", "--individual", "4"], more].concat())
    };
    let tree = stats(&["--matrix", "uniform", "--order", "3"]);
    assert_eq!(stats(&["--matrix", &rows, "--order", "3"]), tree);
    assert_eq!(stats(&["--numbers", &numbers]), tree);
    let perfect = stats(&["--numbers", &numbers, "--matrix", "perfect", "--order", "4"]);
    assert_eq!(
        perfect,
        "{\"order\":4,\"leaves\":8,\"branches\":[8,4,2,1],\"matrix\":[[0.0,1.0],[0.0,0.0,1.0],[0.0,0.0,0.0,1.0]]}\n"
    );
    let told = succeed(&["shape", "tree", "--matrix", "perfect", "--order", "4"]);
    assert_eq!(told, "tree of order 4, individual 1: 8 leaves, branches by order 8 4 2 1\n");
    let of_individual = |n: u32| {
        succeed(&["shape", "tree", "--stats", "--order", "4", "--individual", &n.to_string()])
    };
    assert_eq!(of_individual(3), of_individual(3));
    let others: std::collections::BTreeSet<String> = (0..20).map(of_individual).collect();
    assert_eq!(others.len(), 20, "twenty individuals, and no two alike");
}

#[test]
fn a_tree_is_written_as_a_mesh_that_can_be_grown_on() {
    let (one, other) = (path("tree-1.obj"), path("tree-2.obj"));
    for out in [&one, &other] {
        succeed(&["shape", "tree", "--matrix", "fern", "--order", "3", "--obj", out]);
    }
    let text = std::fs::read_to_string(&one).unwrap();
    assert_eq!(text, std::fs::read_to_string(&other).unwrap(), "the same tree twice");
    for line in ["g order 3", "g order 2", "g order 1", "usemtl bark"] {
        assert!(text.lines().any(|l| l == line), "{line}");
    }
    let recipe = file("on-tree.json", crate::SMALL);
    let grown = json(&["grow", "--mesh", &one, "--recipe", &recipe, "--day", "1", "--json"]);
    assert!(grown["days"][1]["cells"].as_u64() >= Some(60));
}

#[test]
fn a_tree_bears_leaves_that_carry_the_cells() {
    let numbers = file(
        "maple.json",
        r#"{"order": 4, "leaf": {"lobes": 3, "nodes": 4, "petiole_cm": 2}, "leaf_spots": 0.25}"#,
    );
    let out = path("maple.obj");
    let stats = json(&["shape", "tree", "--numbers", &numbers, "--obj", &out, "--stats"]);
    let ends = stats["leaves"].as_u64().unwrap() as usize;
    let text = std::fs::read_to_string(&out).unwrap();
    for line in
        ["g leaves", "g far leaves", "usemtl blade", "usemtl bare:petiole", "usemtl bare:bark"]
    {
        assert!(text.lines().any(|l| l == line), "{line}");
    }
    // All that carries cells are leaves, one on each end; a quarter of them are spots.
    let surface = clonal_mosaic::surface::Brought::read(text.as_bytes()).unwrap().body.surface;
    surface.check().unwrap();
    assert_eq!(surface.part_count(), ends);
    let mut faces = vec![0; ends];
    surface.parts.iter().for_each(|&part| faces[part as usize] += 1);
    let spots = faces.iter().filter(|&&count| count == 2).count();
    assert_eq!(spots, (0.25 * ends as f64).round() as usize, "of {ends}");
    let recipe = file("on-maple.json", crate::SMALL);
    let grown = json(&["grow", "--mesh", &out, "--recipe", &recipe, "--day", "1", "--json"]);
    assert!(grown["days"][1]["cells"].as_u64() >= Some(60));
    // Half of the ends may stay twigs.
    let half = file("half.json", r#"{"order": 4, "leaf": {"lobes": 1}, "leaf_ends": 0.5}"#);
    succeed(&["shape", "tree", "--numbers", &half, "--obj", &out]);
    let text = std::fs::read_to_string(&out).unwrap();
    let surface = clonal_mosaic::surface::Brought::read(text.as_bytes()).unwrap().body.surface;
    assert!((ends / 4..ends).contains(&surface.part_count()), "{ends}");
    assert!(text.lines().any(|l| l == "g order 1"));
}

#[test]
fn a_leaf_is_told_in_numbers_of_its_closed_forms() {
    let numbers = file(
        "leaf.json",
        r#"{"lobes": 1, "nodes": 9, "secondary_deg": 50, "length": {"linear": {"a_cm": 0.2, "b_cm": 0.3}},
            "secondary_scale": 1, "base": 1, "tip": 1, "border_factor": 1.2, "border": "polygon",
            "irregularity": 0}"#,
    );
    let stats = json(&["shape", "leaf", "--numbers", &numbers, "--stats"]);
    let whole = |key: &str| stats[key].as_u64().unwrap();
    assert_eq!([whole("lobes"), whole("main_veins"), whole("secondary_veins")], [1, 1, 16]);
    assert_eq!(whole("border_corners"), 18);
    // The pieces of the main vein, and two secondary veins as long as each but the first.
    let piece = |steps: u32| 0.2 * f64::from(steps) + 0.3;
    let veins = (1..=9).map(piece).sum::<f64>() + 2.0 * (1..9).map(piece).sum::<f64>();
    assert!((stats["vein_length_cm"].as_f64().unwrap() / veins - 1.0).abs() < 1e-12, "{stats}");
    // Trapezia between the feet of the secondary veins, of sides that are 1.2 times as long as those.
    let height = 50f64.to_radians().sin();
    let mut half = 0.0;
    let mut before = 0.0;
    for foot in (0..9).rev() {
        let out = if foot == 0 { 0.0 } else { 1.2 * piece(foot) };
        let along = piece(foot + 1) * if foot == 0 { 1.2 } else { 1.0 };
        half += 0.5 * (before + out) * along * height;
        before = out;
    }
    assert!((stats["area_cm2"].as_f64().unwrap() / (2.0 * half) - 1.0).abs() < 1e-12, "{stats}");
}

#[test]
fn a_leaf_is_written_with_coordinates_of_its_own() {
    let (one, other) = (path("leaf-1.obj"), path("leaf-2.obj"));
    for out in [&one, &other] {
        succeed(&["shape", "leaf", "--individual", "7", "--obj", out]);
    }
    let text = std::fs::read_to_string(&one).unwrap();
    assert_eq!(text, std::fs::read_to_string(&other).unwrap(), "the same leaf twice");
    for line in ["usemtl blade", "usemtl bare:vein", "usemtl bare:petiole"] {
        assert!(text.lines().any(|l| l == line), "{line}");
    }
    let (mut low, mut high) = ([f64::MAX; 2], [f64::MIN; 2]);
    for line in text.lines().filter_map(|line| line.strip_prefix("vt ")) {
        for (k, number) in line.split(' ').enumerate() {
            let number: f64 = number.parse().unwrap();
            (low[k], high[k]) = (low[k].min(number), high[k].max(number));
        }
    }
    assert_eq!((low, high), ([-1.0, 0.0], [1.0, 1.0]), "from rim to rim, and from foot to tip");
    let recipe = file("on-leaf.json", crate::SMALL);
    let grown = json(&["grow", "--mesh", &one, "--recipe", &recipe, "--day", "1", "--json"]);
    assert!(grown["days"][1]["cells"].as_u64() >= Some(60));
}

#[test]
fn the_kinds_of_the_gallery_are_what_their_names_say() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/leaves/");
    let stats = |name: &str| {
        let numbers = format!("{folder}{name}.json");
        let out = path(&format!("gallery-{name}.obj"));
        let stats = json(&["shape", "leaf", "--numbers", &numbers, "--obj", &out, "--stats"]);
        let mesh = std::fs::read(&out).unwrap();
        (stats, clonal_mosaic::surface::Brought::read(&mesh).unwrap().body.surface)
    };
    for (name, lobes, longer_than_wide) in [
        ("beech", 1, 1.5..3.0),
        ("chestnut", 7, 0.5..1.2),
        ("fern_leaflet", 1, 1.5..3.0),
        ("holly", 1, 1.2..2.5),
        ("ivy", 5, 0.7..1.3),
        ("lady_mantle", 9, 0.6..1.2),
        ("maple", 5, 0.7..1.3),
        ("nasturtium", 9, 0.8..1.2),
        ("plane", 5, 0.7..1.3),
        ("poplar", 1, 0.9..1.5),
        ("willow", 1, 5.0..12.0),
    ] {
        let (stats, surface) = stats(name);
        assert_eq!(stats["lobes"], lobes, "{name}");
        assert!((3.0..300.0).contains(&stats["area_cm2"].as_f64().unwrap()), "{name}: {stats}");
        let used = || surface.triangles.iter().flatten().map(|&k| surface.positions[k as usize]);
        let size = used().fold(glam::Vec3::MIN, glam::Vec3::max)
            - used().fold(glam::Vec3::MAX, glam::Vec3::min);
        assert!(longer_than_wide.contains(&f64::from(size.y / size.x)), "{name}: {size}");
    }
    let files = std::fs::read_dir(folder).unwrap().count();
    assert_eq!(files, 11, "a kind of the gallery is not tested");
}

#[test]
fn a_flower_is_told_in_numbers_and_opens_from_day_to_day() {
    let lotus = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/flowers/lotus.json");
    let stats = |more: &[&str]| json(&[&["shape", "flower", "--stats"], more].concat());
    let count = |stats: &Value, key: &str| stats[key].as_u64().unwrap();
    let parts = ["petals", "sepals", "stamens", "pistils"];
    let lily = stats(&[]);
    assert_eq!(parts.map(|part| count(&lily, part)), [6, 0, 6, 1]);
    assert_eq!(lily["day"], 4.0);
    assert_eq!(parts.map(|part| count(&stats(&["--numbers", lotus]), part)), [16, 0, 24, 11]);
    let wild = file(
        "wild.json",
        r#"{"sepals": {"count": 5}, "petals": {"arrangement": {"whorls": [5]}}}"#,
    );
    assert_eq!(parts.map(|part| count(&stats(&["--numbers", &wild]), part)), [5, 5, 6, 1]);
    // It grows without a step back from its bud to the flower.
    let area = |day: &str| stats(&["--day", day])["area_cm2"].as_f64().unwrap();
    let areas = ["0", "1", "1.5", "2", "3", "4"].map(area);
    assert!(areas.windows(2).all(|pair| pair[0] < pair[1]), "{areas:?}");
    assert_eq!(areas[5], lily["area_cm2"].as_f64().unwrap());
    let told = succeed(&["shape", "flower", "--individual", "3", "--day", "0"]);
    assert!(told.starts_with("flower of 6 petals, individual 3, day 0: "), "{told}");
    assert!(told.ends_with(" cm\u{b2}, 6 stamens, 1 pistils\n") && told.lines().count() == 1);
}

#[test]
fn a_flower_is_written_as_a_mesh_with_its_parts() {
    let (one, other, bud) = (path("flower-1.obj"), path("flower-2.obj"), path("bud.obj"));
    for out in [&one, &other] {
        succeed(&["shape", "flower", "--individual", "7", "--obj", out]);
    }
    succeed(&["shape", "flower", "--individual", "7", "--day", "0", "--obj", &bud]);
    let [text, again, closed] = [&one, &other, &bud].map(|p| std::fs::read_to_string(p).unwrap());
    assert_eq!(text, again, "the same flower twice");
    for line in [
        "g petal 6",
        "usemtl petal",
        "usemtl bare:filament",
        "usemtl bare:anther",
        "usemtl bare:pistil",
        "usemtl bare:pedicel",
    ] {
        assert!(text.lines().any(|l| l == line), "{line}");
    }
    // The bud has the same faces in other places.
    let of = |text: &str, kind: &str| -> Vec<String> {
        text.lines().filter(|line| line.starts_with(kind)).map(str::to_string).collect()
    };
    assert_eq!(of(&text, "f "), of(&closed, "f "));
    assert_eq!(of(&text, "v ").len(), of(&closed, "v ").len());
    assert_ne!(of(&text, "v "), of(&closed, "v "));
    let recipe = file("on-flower.json", crate::SMALL);
    let grown = json(&["grow", "--mesh", &one, "--recipe", &recipe, "--day", "1", "--json"]);
    assert!(grown["days"][1]["cells"].as_u64() >= Some(60));
}

#[test]
fn a_flower_opens_while_cells_grow_on_it() {
    let days = ["0", "1", "3", "4"];
    let (opening, still) = (path("opening.obj"), days.map(|day| path(&format!("open-{day}.obj"))));
    succeed(&["shape", "flower", "--individual", "2", "--obj", &opening]);
    let brought =
        |file: &str| clonal_mosaic::surface::Brought::read(&std::fs::read(file).unwrap()).unwrap();
    let moving = brought(&opening);
    for (day, file) in days.iter().zip(&still) {
        succeed(&["shape", "flower", "--individual", "2", "--day", day, "--obj", file]);
        let day: f32 = day.parse().unwrap();
        let then = moving.mesh.moments.iter().find(|moment| moment.day == day).unwrap();
        let still = brought(file);
        assert!(still.body.surface.motion.is_still());
        // The very same, once the numbers of a text are read.
        assert_eq!(then.positions.len(), still.mesh.positions.len());
        assert!(then.positions == still.mesh.positions, "day {day}");
    }
    // The open flower is the body that moves, so its cells have the same triangles, and in the bud less room.
    let recipe = file("on-opening.json", crate::SMALL);
    let grow =
        |mesh: &str| json(&["grow", "--mesh", mesh, "--recipe", &recipe, "--day", "3", "--json"]);
    let (opened, open) = (grow(&opening), grow(&still[3]));
    assert_ne!(opened["days"][3]["fingerprint"], open["days"][3]["fingerprint"]);
    assert_eq!(opened["days"][3]["cells"], open["days"][3]["cells"]);
}

#[test]
fn fine_veins_of_a_leaf_are_open_or_close_in_loops() {
    let stats = |fine: &str| {
        let numbers = file(&format!("net-{}.json", fine.len()), &format!("{{\"fine\": {fine}}}"));
        let out = path(&format!("net-{}.obj", fine.len()));
        let stats = json(&["shape", "leaf", "--numbers", &numbers, "--obj", &out, "--stats"]);
        let text = std::fs::read_to_string(&out).unwrap();
        let surface = clonal_mosaic::surface::Brought::read(text.as_bytes()).unwrap().body.surface;
        surface.check().unwrap();
        (stats, surface.veins.any(1), text.contains("usemtl vein:3"))
    };
    let (none, ribs, net) = stats("null");
    assert_eq!(
        (&none["loops"], &none["fine_vein_length_cm"], ribs, net),
        (&0.into(), &0.0.into(), true, false)
    );
    let (open, _, net) = stats("{\"spacing_cm\": 0.2}");
    assert!(net && open["loops"] == 0 && open["fine_vein_length_cm"].as_f64() > Some(20.0));
    let (closed, ..) = stats("{\"spacing_cm\": 0.2, \"closed\": true}");
    assert!(closed["loops"].as_u64() > Some(50), "{closed}");
    assert!(closed["fine_vein_length_cm"].as_f64() > open["fine_vein_length_cm"].as_f64());
    assert_eq!(closed["area_cm2"], none["area_cm2"]);
}

#[test]
fn wrong_numbers_are_refused_on_one_line() {
    let no_json = file("no-shape.json", "order = 3");
    let unknown = file("unknown-shape.json", "{\"height\": 3}");
    let steep = file("steep.json", "{\"fork_deg\": 120}");
    let short = file("short-rows.json", "[[0.5, 0.5]]");
    let leaky = file("leaky-rows.json", "[[0.5, 0.5], [0.2, 0.2, 0.5]]");
    let endless = file("endless-rows.json", "[[1, 0]]");
    let nameless = file("nameless.json", "{\"matrix\": \"oak\"}");
    let even = file("even.json", "{\"lobes\": 4}");
    let upside = file("upside.json", "{\"nod_deg\": 200}");
    let folder = env!("CARGO_TARGET_TMPDIR");
    for (arguments, words) in [
        (&[][..], "mosaic shape leaf, flower or tree"),
        (&["bush"], "bush"),
        (&["tree", "--order", "0"], "--order is 0"),
        (&["tree", "--order", "13"], "from 1 to 12"),
        (&["tree", "--individual", "-1"], "--individual"),
        (&["tree", "--matrix", "oak"], "no matrix \"oak\": there are perfect, uniform"),
        (&["tree", "--matrix", "tokunaga:1"], "two numbers"),
        (&["tree", "--matrix", "missing.json"], "missing.json"),
        (&["tree", "--matrix", folder], folder),
        (&["tree", "--matrix", &no_json], "no-shape.json"),
        (&["tree", "--matrix", &short, "--order", "3"], "from 1 to 2, the last row"),
        (&["tree", "--matrix", &leaky], "row of order 3 sums to 0.9"),
        (&["tree", "--matrix", &endless], "never end"),
        (&["tree", "--matrix", "uniform", "--order", "12"], "more than 100000 leaves"),
        (&["tree", "--numbers", "missing.json"], "missing.json"),
        (&["tree", "--numbers", &no_json], "no-shape.json"),
        (&["tree", "--numbers", &unknown], "there is no number \"height\": there are "),
        (&["tree", "--numbers", &steep], "fork_deg is 120: it must be from 0 to 90"),
        (&["tree", "--numbers", &nameless], "nameless.json: there is no matrix"),
        (&["tree", "--obj", "no/such/folder.obj"], "folder.obj"),
        (&["tree", "--csv"], "--csv"),
        (&["leaf", "--order", "3"], "--order"),
        (&["leaf", "--numbers", "missing.json"], "missing.json"),
        (&["leaf", "--numbers", &no_json], "no-shape.json"),
        (&["leaf", "--numbers", &unknown], "there is no number \"height\": there are "),
        (&["leaf", "--numbers", &even], "even.json: lobes is 4: it must be an odd number"),
        (&["leaf", "--obj", "no/such/folder.obj"], "folder.obj"),
        (&["flower", "--numbers", "missing.json"], "missing.json"),
        (&["flower", "--numbers", &unknown], "there is no number \"height\": there are "),
        (
            &["flower", "--numbers", &upside],
            "upside.json: nod_deg is 200: it must be from 0 to 180",
        ),
        (&["flower", "--day", "5"], "--day is 5: it must be from 0 to 4"),
        (&["flower", "--day", "-1"], "--day is -1: it must be from 0 to 4"),
        (&["flower", "--day", "soon"], "--day"),
        (&["flower", "--obj", "no/such/folder.obj"], "folder.obj"),
        (&["leaf", "--day", "1"], "--day"),
    ] {
        let arguments = [&["shape"], arguments].concat();
        let output = mosaic(&arguments);
        let told = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {told}");
        assert!(output.stdout.is_empty(), "{arguments:?} printed something");
        assert_eq!(told.lines().count(), 1, "{arguments:?}: {told}");
        assert!(told.contains(words), "{arguments:?} is refused with: {told}");
    }
}
