//! The command line as its user meets it.

mod exports;
mod fits;
mod leaves;
mod plants;
mod shapes;
mod sweeps;
mod tiles;
mod usdz;

use serde_json::Value;
use std::path::PathBuf;
use std::process::{Command, Output};

/// A recipe that grows in no time.
const SMALL: &str = r#"{"initial_cells":60, "days":6, "division_days":{"F":4,"B":6}}"#;

/// A tetrahedron of side 1.
const TETRAHEDRON: &str = "v 1 1 1\nv 1 -1 -1\nv -1 1 -1\nv -1 -1 1\n\
                           f 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n";

fn mosaic(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_mosaic")).args(arguments).output().unwrap()
}

/// The standard output of a call that must succeed and have nothing to complain about.
fn succeed(arguments: &[&str]) -> String {
    let output = mosaic(arguments);
    let complaint = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success() && complaint.is_empty(), "{arguments:?}: {complaint}");
    String::from_utf8(output.stdout).unwrap()
}

fn json(arguments: &[&str]) -> Value {
    serde_json::from_str(&succeed(arguments)).unwrap()
}

/// Writes a file into the tests' own folder and returns its path.
fn file(name: &str, content: &str) -> String {
    let path = path(name);
    std::fs::write(&path, content).unwrap();
    path
}

fn path(name: &str) -> String {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    path.to_str().unwrap().to_string()
}

#[test]
fn a_preset_prints_a_line_for_each_day() {
    let out = succeed(&["grow", "--preset", "cactus", "--day", "2"]);
    let lines: Vec<&str> = out.lines().collect();
    assert_eq!(lines.len(), 4, "days 0, 1, 2 and the time:\n{out}");
    for (day, line) in lines[..3].iter().enumerate() {
        let words: Vec<&str> = line.split_whitespace().collect();
        assert_eq!(words[..2], ["day", &day.to_string()]);
        assert_eq!(words[3], "cells");
        assert_eq!(words.last().unwrap().len(), 6, "a fingerprint ends the line: {line}");
    }
    assert!(lines[3].starts_with("cactus, individual 1: "), "{out}");
}

#[test]
fn json_is_one_object_with_all_days() {
    let recipe = file("json.json", SMALL);
    let mesh = file("json.obj", TETRAHEDRON);
    let run = json(&["grow", "--recipe", &recipe, "--mesh", &mesh, "--individual", "9", "--json"]);
    assert_eq!(run["plant"], Value::Null);
    assert_eq!(run["individual"], 9);
    assert!(run["seconds"].as_f64().unwrap() > 0.0);
    let days = run["days"].as_array().unwrap();
    assert_eq!(days.len(), 7);
    for (number, day) in days.iter().enumerate() {
        assert_eq!(day["day"], number);
        let count = |key: &str| day[key].as_u64().unwrap();
        assert_eq!(count("cells"), count("F") + count("B") + count("M"));
        // The tetrahedron's area is sqrt(3) times its squared edge, 8.
        let spacing = (8.0 * 3f64.sqrt() / count("cells") as f64).sqrt();
        assert!((day["r"].as_f64().unwrap() / spacing - 1.0).abs() < 1e-5);
        assert_eq!(day["fingerprint"].as_str().unwrap().len(), 6);
    }
    assert_eq!(days[0]["cells"], 60);
    assert!(days[6]["cells"].as_u64() > Some(60));
}

#[test]
fn the_same_wish_is_the_same_however_it_is_said() {
    let days = |run: Value| run["days"].clone();
    let preset = ["grow", "--preset", "croton", "--individual", "3", "--day", "2", "--json"];
    let first = days(json(&preset));
    assert_eq!(first, days(json(&preset)), "the same cells again");
    assert_eq!(first, days(json(&["grow", "--individual", "3", "--day", "2", "--json"])));
    for link in [
        "croton?v=2&s=3&d=2",
        "#croton?v=2&s=3&d=2",
        "https://a.b/c/#croton?v=2&s=3&d=2",
        "https://a.b/c/#croton?v=2&s=3&d=2).",
        "https://a.b/c/%23croton%3Fv=2&s=3&d=2",
    ] {
        assert_eq!(first, days(json(&["grow", "--link", link, "--json"])), "{link}");
    }
    let more = days(json(&["grow", "--link", "croton?v=2&s=3&d=0", "--day", "2", "--json"]));
    assert_eq!(first, more, "--day goes before the link's day");
    let plain = ["grow", "--link", "https://a.b/c/", "--individual", "3", "--day", "2", "--json"];
    assert_eq!(first, days(json(&plain)), "the page's own address");
    let sister = days(json(&["grow", "--individual", "0", "--day", "2", "--json"]));
    assert_ne!(first[2]["fingerprint"], sister[2]["fingerprint"]);
}

#[test]
fn the_table_has_the_cells_of_the_last_day() {
    let (recipe, mesh) = (file("table.json", SMALL), file("table.obj", TETRAHEDRON));
    let table = path("table.csv");
    let run = json(&["grow", "--recipe", &recipe, "--mesh", &mesh, "--cells", &table, "--json"]);
    let last = run["days"].as_array().unwrap().last().unwrap();
    let text = std::fs::read_to_string(&table).unwrap();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("id,parent,founder,type,part,triangle,x,y,z,born_day"));
    let rows: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    assert_eq!(rows.len() as u64, last["cells"].as_u64().unwrap());
    for (id, row) in rows.iter().enumerate() {
        let number = |column: usize| row[column].parse::<usize>().unwrap();
        assert_eq!((row.len(), number(0)), (10, id));
        assert!(number(1) <= id && number(2) < 60 && number(4) == 0 && number(5) < 4);
        assert!(["F", "B", "M"].contains(&row[3]));
        assert_eq!(number(9) == 0, id < 60, "the first cells are born on day 0");
        let xyz: Vec<f64> = row[6..9].iter().map(|x| x.parse().unwrap()).collect();
        assert!(xyz.iter().all(|x| x.abs() <= 1.0 + 1e-6));
    }
    let of_type = |letter: &str| rows.iter().filter(|row| row[3] == letter).count();
    for letter in ["F", "B", "M"] {
        assert_eq!(last[letter], of_type(letter));
    }
}

#[test]
fn a_recipe_needs_no_mesh_and_a_preset_may_have_one() {
    let recipe = file("alone.json", SMALL);
    let run = json(&["grow", "--recipe", &recipe, "--json"]);
    assert_eq!((&run["plant"], &run["days"][0]["cells"]), (&"croton".into(), &60.into()));
    let mesh = file("preset.obj", TETRAHEDRON);
    let run = json(&["grow", "--preset", "watermelon", "--mesh", &mesh, "--day", "1", "--json"]);
    assert_eq!(run["plant"], "watermelon");
    assert_eq!(run["days"].as_array().unwrap().len(), 2);
}

#[test]
fn the_cap_is_told_and_what_has_grown_is_kept() {
    let recipe = file(
        "cap.json",
        r#"{"initial_cells":50,"max_cells":120,"days":30,"division_days":{"F":3,"B":3}}"#,
    );
    let output = mosaic(&["grow", "--recipe", &recipe, "--json"]);
    assert!(output.status.success());
    let told = String::from_utf8(output.stderr).unwrap();
    assert!(told.contains("120") && told.lines().count() == 1, "{told}");
    let run: Value = serde_json::from_slice(&output.stdout).unwrap();
    let days = run["days"].as_array().unwrap();
    assert!(days.len() < 31 && days.last().unwrap()["cells"].as_u64() <= Some(120));
}

#[test]
#[cfg(target_os = "linux")]
fn cells_for_which_there_is_no_memory_are_refused_before_they_grow() {
    for (name, numbers, words) in [
        (
            "huge.json",
            r#"{"initial_cells":2000000,"max_cells":100000000,"days":1000,"division_days":{"F":20,"B":20,"M":20}}"#,
            "GB of memory",
        ),
        ("uncapped.json", r#"{"max_cells":4000000000}"#, "at most 100,000,000"),
    ] {
        let output = mosaic(&["grow", "--recipe", &file(name, numbers)]);
        let told = String::from_utf8(output.stderr).unwrap();
        assert_eq!((output.status.code(), told.lines().count()), (Some(2), 1), "{told}");
        assert!(told.contains(words) && output.stdout.is_empty(), "{told}");
    }
}

#[test]
fn any_number_of_threads_prints_the_same() {
    let grown = |threads| {
        let output =
            mosaic(&["grow", "--preset", "mushroom", "--day", "6", "--threads", threads, "--json"]);
        let mut run: Value = serde_json::from_slice(&output.stdout).unwrap();
        run["seconds"] = Value::Null;
        run
    };
    assert_eq!(grown("1"), grown("2"));
}

#[test]
fn help_and_version_are_there() {
    let grow =
        ["--link", "--preset", "--recipe", "--mesh", "--individual", "--day", "--cells", "--json"];
    let figures =
        ["--figure", "--individuals", "--threads", "--shard", "--merge", "--csv", "--json"];
    let sweep = ["--link", "--preset", "--day", "--vary", "df=4..12:5", "--individuals", "--shard"];
    let export = [
        "--link",
        "--preset",
        "--individual",
        "--day",
        "--glb",
        "--ply",
        "--obj",
        "--svg",
        "--clones",
    ];
    let all = ["grow", "figures", "sweep", "export", "shape", "plant", "bench", "Exit status"];
    for (arguments, words) in [
        (&["--help"][..], &all[..]),
        (&["help"], &all),
        (&["-h"], &all),
        (&["grow", "--help"], &grow),
        (&["help", "grow"], &grow),
        (&["figures", "--help"], &figures),
        (&["sweep", "--help"], &sweep),
        (&["export", "--help"], &export),
        (&["bench", "--help"], &["--runs"]),
        (&["shape", "--help"], &["leaf", "tree"]),
        (&["shape", "leaf", "--help"], &["--numbers", "--individual", "--obj", "--stats"]),
        (&["shape", "tree", "--help"], &["--matrix", "--order", "--numbers", "--obj", "--stats"]),
    ] {
        let help = succeed(arguments);
        for word in words {
            assert!(help.contains(word), "{word} is not in the help of {arguments:?}:\n{help}");
        }
        assert!(help.lines().all(|line| line.chars().count() <= 120), "{help}");
    }
    let help = succeed(&["grow", "--help"]);
    for plant in clonal_mosaic::plants::all() {
        assert!(help.contains(plant.key), "{} is not in the help", plant.key);
    }
    assert!(succeed(&["--version"]).contains(env!("CARGO_PKG_VERSION")));
}

#[test]
fn wrong_input_is_refused_on_one_line() {
    let recipe = file("good.json", SMALL);
    let bad_recipe = file("bad.json", r#"{"division_days":{"F":0.5}}"#);
    let no_json = file("no.json", "initial_cells = 3");
    let no_mesh = file("no.obj", "v 0 0 0\n");
    let bad_mesh = file("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
    let flat_mesh = file("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
    let missing = path("missing");
    let nowhere = path("no/such/folder.csv");
    let folder = env!("CARGO_TARGET_TMPDIR");
    for (arguments, word) in [
        (&[][..], "mosaic grow"),
        (&["shrink"], "shrink"),
        (&["--grow"], "--grow"),
        (&["grow", "--fast"], "--fast"),
        (&["grow", "croton"], "croton"),
        (&["grow", "--json=yes"], "--json"),
        (&["grow", "--preset"], "--preset"),
        (&["grow", "--preset", "oak"], "croton"),
        (&["grow", "--preset", "croton", "--recipe", &recipe], "only one"),
        (&["grow", "--preset", "croton", "--preset", "cactus"], "only one"),
        (&["grow", "--individual", "-1"], "--individual"),
        (&["grow", "--individual", "4294967296"], "4294967296"),
        (&["grow", "--individual", "seven"], "seven"),
        (&["grow", "--day", "1.5"], "1.5"),
        (&["grow", "--day", "9999"], "9999"),
        (&["grow", "--recipe", &recipe, "--day", "7"], "day 6"),
        (&["grow", "--link", "oak?v=1&s=1"], "oak"),
        (&["grow", "--link", "croton?v=1&s=1&zz=3"], "zz"),
        (&["grow", "--link", "croton?v=1&s=x"], "s=x"),
        (&["grow", "--link", "croton?v=99&s=1"], "v=99"),
        (&["grow", "--link", "croton?v=1&s=1&d=9999"], "9999"),
        (&["grow", "--recipe", &missing], "missing"),
        (&["grow", "--recipe", folder], folder),
        (&["grow", "--recipe", &no_json], "no.json"),
        (&["grow", "--recipe", &bad_recipe], "division_days of F is 0.5"),
        (&["grow", "--recipe", &recipe, "--mesh", &missing], "missing"),
        (&["grow", "--recipe", &recipe, "--mesh", &no_mesh], "no.obj"),
        (&["grow", "--recipe", &recipe, "--mesh", &bad_mesh], "bad.obj"),
        (&["grow", "--recipe", &recipe, "--mesh", &flat_mesh], "flat.obj"),
        (&["grow", "--recipe", &recipe, "--mesh", &no_json], "no.json"),
        (&["grow", "--recipe", &recipe, "--cells", &nowhere], "folder.csv"),
        (&["grow", "--recipe", &recipe, "--cells", folder], folder),
        (&["figures", "4.3"], "4.3"),
        (&["figures", "--figure", "9.9"], "there are 4."),
        (&["figures", "--individuals", "0"], "--individuals is 0"),
        (&["figures", "--individuals", "many"], "many"),
        (&["figures", "--threads", "0"], "--threads is 0"),
        (&["sweep", "--vary", "df"], "no values"),
        (&["sweep", "--vary", "nix=1..2"], "there is no number \"nix\": there are n, "),
        (&["sweep", "--vary", "df=1..x"], "\"x\" is no number"),
        (&["sweep", "--vary", "df=4..8:1"], "from 2 to"),
        (&["sweep", "--vary", "df=4,4"], "4 comes twice"),
        (&["sweep", "--vary", "df=4,5", "--vary", "df=6,7"], "df comes twice"),
        (&["sweep", "--vary", "df=0.5,5"], "df=0.5: it must be from"),
        (
            &["sweep", "--preset", "red-croton", "--vary", "pf=0.7,0.8", "--vary", "pm=0.6,0.9"],
            "pf would be",
        ),
        (&["sweep", "--vary", "n=1..20000:400", "--vary", "df=2..9:400"], "combinations"),
        (&["sweep", "--day", "999", "--vary", "df=4,5"], "--day is 999"),
        (&["sweep", "--link", "rose?v=1", "--vary", "df=4,5"], "rose"),
        (&["sweep", "--link", "croton?v=1", "--preset", "cactus"], "only one"),
        (&["sweep", "--merge", "x.csv", "--vary", "df=4,5"], "only one"),
        (&["figures", "--shard", "3"], "--shard"),
        (&["figures", "--shard", "0/4"], "0/4"),
        (&["figures", "--shard", "5/4"], "5/4"),
        (&["figures", "--shard", "1/2", "--csv"], "only one"),
        (&["figures", "--json", "--csv"], "only one"),
        (&["bench", "--runs", "0"], "--runs is 0"),
        (&["bench", "fast"], "fast"),
        (&["grow", "--link", "croton?v=1&s=1&\u{1b}]0;x\u{7}=3"], "unknown"),
        (&["grow", "--individual", "\u{1b}[31m"], "--individual"),
    ] {
        let output = mosaic(arguments);
        let told = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {told}");
        assert!(output.stdout.is_empty(), "{arguments:?} printed something");
        assert_eq!(told.lines().count(), 1, "{arguments:?}: {told}");
        assert!(!told.trim_end().contains(char::is_control), "{arguments:?}: {told:?}");
        assert!(told.contains(word), "{arguments:?} is refused with: {told}");
    }
}

#[cfg(unix)]
#[test]
fn odd_bytes_are_refused_too() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    for option in ["--preset", "--link", "--individual", "--day"] {
        let mut command = Command::new(env!("CARGO_BIN_EXE_mosaic"));
        let output = command.args(["grow", option]).arg(OsStr::from_bytes(b"\xff\xfe")).output();
        let output = output.unwrap();
        assert_eq!(output.status.code(), Some(2));
        assert_eq!(String::from_utf8(output.stderr).unwrap().lines().count(), 1);
    }
    let binary = path("binary.obj");
    std::fs::write(&binary, [0xff, 0xfe, 0, 1]).unwrap();
    let output = mosaic(&["grow", "--mesh", &binary]);
    assert_eq!(output.status.code(), Some(2));
}
