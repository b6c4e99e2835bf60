//! Many individuals: the pictures of the thesis, and a plant with its numbers varied.

use crate::{file, json, mosaic, path, succeed};
use clonal_mosaic::play::atlas::Atlas;
use clonal_mosaic::play::series::asked_view;
use serde_json::Value;

/// The standard output of a sweep.
fn sweep(arguments: &[&str]) -> String {
    succeed(&[&["figures"], arguments].concat())
}

#[test]
fn a_sweep_has_the_means_of_its_individuals() {
    let table = sweep(&["--figure", "4.12", "--individuals", "2", "--json"]);
    let table: Value = serde_json::from_str(&table).unwrap();
    assert_eq!(table["individuals"], 2);
    let pictures = table["pictures"].as_array().unwrap();
    let labels: Vec<&str> = pictures.iter().map(|p| p["picture"].as_str().unwrap()).collect();
    assert_eq!(labels, ["day 23", "day 27", "day 30"]);
    let of_individual = |n: &str| {
        json(&["grow", "--link", "philodendron?v=1&d=30", "--individual", n, "--json"])["days"]
            .clone()
    };
    let days = [of_individual("1"), of_individual("2")];
    for (picture, day) in pictures.iter().zip([23, 27, 30]) {
        let number = |value: &Value| value.as_f64().unwrap();
        let mean =
            |value: &dyn Fn(&Value) -> f64| days.iter().map(|d| value(&d[day])).sum::<f64>() / 2.0;
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-9, "day {day}: {a} and not {b}");
        near(number(&picture["cells"]), mean(&|d| number(&d["cells"])));
        for kind in ["F", "B", "M"] {
            let share = mean(&|d| number(&d[kind]) / number(&d["cells"]));
            near(number(&picture["count_shares"][kind]), share);
        }
        let areas = ["F", "B", "M"].map(|kind| number(&picture["area_shares"][kind]));
        assert!((areas.iter().sum::<f64>() - 1.0).abs() < 1e-3 && areas[2] == 0.0, "{areas:?}");
        let error = number(&picture["standard_error"]);
        let from_mean = number(&picture["cells"]) - number(&picture["expected_cells"]);
        assert!(error > 0.0 && from_mean.abs() < 4.4 * error, "{from_mean} and {error}");
        assert!((0.0..0.5).contains(&number(&picture["mixed_edges"])));
        assert!(number(&picture["patches"]) > 10.0);
    }
}

#[test]
fn shards_on_any_number_of_threads_merge_to_the_table_of_the_whole() {
    let what = ["--figure", "4.12", "--individuals", "2"];
    let whole = sweep(&[&what[..], &["--threads", "1", "--csv"]].concat());
    assert_eq!(whole.lines().count(), 4, "{whole}");
    let shards = ["3/3", "1/3", "2/3"].map(|shard| {
        let rows = sweep(&[&what[..], &["--threads", "2", "--shard", shard]].concat());
        (shard, rows)
    });
    assert!(shards.iter().all(|(_, rows)| rows.lines().count() == 3), "a heading and two rows");
    let files = shards.each_ref().map(|(shard, rows)| file(&shard.replace('/', "-"), rows));
    let [third, first, second] = files.each_ref().map(String::as_str);
    assert_eq!(succeed(&["figures", "--merge", third, first, second, "--csv"]), whole);
    let all: String = shards.iter().map(|(_, rows)| rows.as_str()).collect();
    let on_end = file("on-end.csv", &all);
    assert_eq!(succeed(&["figures", "--csv", "--merge", &on_end]), whole);
    assert_eq!(succeed(&["figures", "--merge", &on_end]).lines().count(), 8, "a table to read");

    // A row is a link and a fingerprint: it can be grown again.
    let row: Vec<&str> = shards[1].1.lines().nth(1).unwrap().split(',').collect();
    let run = json(&["grow", "--link", row[5], "--json"]);
    assert_eq!(run["days"][23]["fingerprint"], row[6]);

    for (arguments, words) in [
        (&["--merge", first, third][..], "2 of 6 rows are missing, the first is row 1"),
        (&["--merge", &on_end, third], "row 2 of 6 comes twice"),
        (&["--merge", &file("junk.csv", "1,2,3\n")], "junk.csv, line 1: 3 columns"),
        (&["--merge", &file("bad.csv", &all.replacen("\n0,", "\nx,", 1))], "item is \"x\""),
        (&["--merge", &file("empty.csv", "")], "no rows"),
        (&["--merge", &path("missing.csv")], "missing.csv"),
        (&["--merge", &on_end, "--individuals", "3"], "--merge"),
        (&["--merge"], "--merge"),
    ] {
        let output = mosaic(&[&["figures"], arguments].concat());
        let told = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {told}");
        assert!(told.lines().count() == 1 && told.contains(words), "{arguments:?}: {told}");
    }
}

#[test]
fn a_number_is_varied_and_each_line_can_be_grown_again() {
    let what = [
        "sweep",
        "--link",
        "mushroom?v=1",
        "--day",
        "6",
        "--vary",
        "df=3..9:3",
        "--vary",
        "n=100,200",
    ];
    let run = |more: &[&str]| succeed(&[&what[..], more].concat());
    let table: Value = serde_json::from_str(&run(&["--individuals", "2", "--json"])).unwrap();
    let lines = table["pictures"].as_array().unwrap();
    let numbers: Vec<(f64, f64)> = lines
        .iter()
        .map(|line| (line["df"].as_f64().unwrap(), line["n"].as_f64().unwrap()))
        .collect();
    assert_eq!(
        numbers,
        [(3.0, 100.0), (3.0, 200.0), (6.0, 100.0), (6.0, 200.0), (9.0, 100.0), (9.0, 200.0)]
    );
    for line in lines {
        let link = line["link"].as_str().unwrap();
        assert!(link.starts_with("mushroom?v=1&s=1&d=6&n="), "{link}");
        let of_individual = |n: &str| {
            let grown = json(&["grow", "--link", link, "--individual", n, "--json"]);
            grown["days"][6]["cells"].as_f64().unwrap()
        };
        assert_eq!(line["cells"], (of_individual("1") + of_individual("2")) / 2.0, "{link}");
    }
    // The quicker red divides, the more of it there is.
    let red = |k: usize| lines[k]["count_shares"]["F"].as_f64().unwrap();
    assert!(red(0) > red(2) && red(2) > red(4), "{lines:?}");

    // The page shows all of them, one individual each, and two numbers as a map.
    let text = run(&[]);
    let address = text.lines().last().unwrap().rsplit(' ').next().unwrap();
    assert_eq!(address, "steps/mushroom?v=1&s=1&d=6&df=3,6,9&n=100,200");
    let (view, rest) = asked_view(address.to_string().leak()).unwrap();
    let [row] = view.rows(rest)[..] else { panic!("one row") };
    let mut shown: Vec<&str> = row.pictures.iter().map(|picture| picture.link).collect();
    let mut told: Vec<&str> = lines.iter().map(|line| line["link"].as_str().unwrap()).collect();
    shown.sort_unstable();
    told.sort_unstable();
    assert_eq!(shown, told);
    assert!(Atlas::read(rest).is_some());

    let whole = run(&["--csv"]);
    assert!(whole.starts_with("plant,df,n,individuals,cells,"), "{whole}");
    let shards = ["2/2", "1/2"].map(|shard| {
        let rows = run(&["--shard", shard]);
        file(&format!("vary-{}.csv", &shard[..1]), &rows)
    });
    assert_eq!(succeed(&["sweep", "--merge", &shards[0], &shards[1], "--csv"]), whole);
    let output = mosaic(&["figures", "--merge", &shards[0], &shards[1]]);
    let told = String::from_utf8(output.stderr).unwrap();
    assert!(told.contains("not of mosaic figures: try mosaic sweep"), "{told}");
    let read = succeed(&["sweep", "--merge", &shards[0], &shards[1]]);
    assert!(read.lines().skip(5).all(|line| line.contains("  mushroom?v=1&s=1&d=6")), "{read}");

    // What the link itself says of a number that varies makes room, and one value is no series.
    let one = ["sweep", "--link", "mushroom?v=1&n=300&df=4", "--day", "1", "--individuals", "1"];
    let last = |more: &[&str]| {
        let text = succeed(&[&one[..], more].concat());
        text.lines().last().unwrap().to_string()
    };
    let address = last(&["--vary", "df=3,6"]);
    assert!(address.ends_with(" steps/mushroom?v=1&s=1&d=1&n=300&df=3,6"), "{address}");
    assert!(!last(&["--vary", "df=3"]).contains("steps/"));

    // An individual that outgrows its recipe has no line: the mean would lie.
    let output =
        mosaic(&["sweep", "--link", "mushroom?v=1&s=1&d=20&n=20000", "--vary", "df=1.5,2"]);
    let told = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{told}");
    assert!(
        told.contains("df=1.5, individual 1: on day ") && told.contains("60000 cells"),
        "{told}"
    );
}
