//! The tables of CODAP, the data tool of the Concord Consortium: what the page tells it of days and of individuals, as the
//! requests of its Data Interactive Plugin API, in JSON.

use super::days::DayNumbers;
use super::series::Grown;
use crate::play::words::source;
use crate::play::{Scene, origin};

/// A table: its name within CODAP and its collections, the outer one first.
pub struct Table {
    pub name: &'static str,
    title: &'static str,
    collections: &'static [(&'static str, &'static [Column])],
}

/// A column: its name, and what it says.
type Column = (&'static str, &'static str);

const PLANT: &[Column] = &[
    ("plant", "Name of the plant"),
    ("individual", "Number of the individual: what chance makes of the recipe"),
    ("recipe", "Where the recipe comes from, and whether numbers of it are changed"),
    ("colour_F", "What colour the cells of type F have"),
    ("colour_B", "What colour the cells of type B have"),
    ("colour_M", "What colour the cells of type M have; empty where there are none"),
];

/// The days of growths.
pub const DAYS: Table = Table {
    name: "clonal_mosaic_days",
    title: "Days of a clonal mosaic",
    collections: &[
        ("plants", PLANT),
        (
            "days",
            &[
                ("day", "Days since the first cells"),
                ("cells", "Number of cells"),
                ("share_F", "Share of the cells that are of type F, 0 to 1"),
                ("share_B", "Share of the cells that are of type B, 0 to 1"),
                ("share_M", "Share of the cells that are of type M, 0 to 1"),
                ("area_F", "Share of the surface that cells of type F cover, 0 to 1"),
                ("area_B", "Share of the surface that cells of type B cover, 0 to 1"),
                ("area_M", "Share of the surface that cells of type M cover, 0 to 1"),
                ("patches_F", "Sets of cells of type F that hang together"),
                ("patches_B", "Sets of cells of type B that hang together"),
                ("patches_M", "Sets of cells of type M that hang together"),
                ("fingerprint", "The same only where all cells are the same, bit for bit"),
                ("link", "Shows this day in the playground"),
            ],
        ),
    ],
};

/// The individuals of a nursery, or the pictures of another series.
pub const INDIVIDUALS: Table = Table {
    name: "clonal_mosaic_individuals",
    title: "Individuals of a clonal mosaic",
    collections: &[(
        "individuals",
        &[
            ("plant", "Name of the plant"),
            ("individual", "Number of the individual: what chance makes of the recipe"),
            ("differs", "What tells it from the others"),
            ("day", "Days since the first cells"),
            ("cells", "Number of cells"),
            ("share_F", "Share of the cells that are of type F, 0 to 1"),
            ("share_B", "Share of the cells that are of type B, 0 to 1"),
            ("share_M", "Share of the cells that are of type M, 0 to 1"),
            ("link", "Shows this individual in the playground"),
        ],
    )],
};

/// Columns of texts; all others are of numbers.
const TEXTS: [&str; 8] =
    ["plant", "recipe", "colour_F", "colour_B", "colour_M", "differs", "fingerprint", "link"];

impl Table {
    /// Asks whether it is there.
    pub fn ask(&self) -> String {
        format!(r#"{{"action":"get","resource":"dataContext[{}]"}}"#, self.name)
    }

    /// Makes it, empty.
    pub fn make(&self) -> String {
        let mut outer = String::new();
        let mut collections = Vec::new();
        for (name, columns) in self.collections {
            let columns: Vec<String> = columns.iter().map(column).collect();
            let columns = columns.join(",");
            collections.push(format!(r#"{{"name":"{name}"{outer},"attrs":[{columns}]}}"#));
            outer = format!(r#","parent":"{name}""#);
        }
        format!(
            r#"{{"action":"create","resource":"dataContext","values":{{"name":"{}","title":"{}","collections":[{}]}}}}"#,
            self.name,
            self.title,
            collections.join(",")
        )
    }

    /// Shows it.
    pub fn show(&self) -> String {
        format!(
            r#"{{"action":"create","resource":"component","values":{{"type":"caseTable","dataContext":"{}"}}}}"#,
            self.name
        )
    }

    /// Adds cases to it, each as `day_case` or `individual_case` has it.
    pub fn add(&self, cases: &[String]) -> String {
        let (name, cases) = (self.name, cases.join(","));
        format!(r#"{{"action":"create","resource":"dataContext[{name}].item","values":[{cases}]}}"#)
    }
}

fn column((name, meaning): &Column) -> String {
    let kind = if TEXTS.contains(name) { "categorical" } else { "numeric" };
    // Shares are small: by itself CODAP writes two digits.
    let precision = if name.starts_with("share") || name.starts_with("area") { 4 } else { 0 };
    let name = name.to_string();
    match kind {
        "numeric" => format!(
            r#"{{"name":"{name}","type":"{kind}","precision":{precision},"description":"{meaning}"}}"#
        ),
        _ => format!(r#"{{"name":"{name}","type":"{kind}","description":"{meaning}"}}"#),
    }
}

/// A day as a case. `address` is that of the playground, up to its `#`.
pub fn day_case(scene: &Scene, now: &DayNumbers, fingerprint: &str, address: &str) -> String {
    let plant = scene.plant;
    let pattern = &now.pattern;
    let link = origin::whole_link(&Scene { day: now.day, ..scene.clone() });
    let [f, b, m] = plant.colour_names.map(json_text);
    let mut members = vec![
        ("plant", json_text(plant.name)),
        ("individual", scene.individual.to_string()),
        ("recipe", json_text(&source(scene))),
        ("colour_F", f),
        ("colour_B", b),
        ("colour_M", m),
        ("day", now.day.to_string()),
        ("cells", pattern.count.cells.to_string()),
    ];
    members.extend(shares(pattern.count_shares()));
    let [f, b, m] = pattern.area_shares.map(number);
    members.extend([("area_F", f), ("area_B", b), ("area_M", m)]);
    let [f, b, m] = pattern.patches.map(|count| count.to_string());
    members.extend([("patches_F", f), ("patches_B", b), ("patches_M", m)]);
    members.push(("fingerprint", json_text(fingerprint)));
    members.push(("link", json_text(&format!("{address}#{link}"))));
    object(&members)
}

/// A picture of a series as a case; `differs` is what tells it from the others.
pub fn individual_case(grown: &Grown, differs: &str, address: &str) -> String {
    let Grown { scene, count } = grown;
    let cells = f64::from(count.cells.max(1));
    let mut members = vec![
        ("plant", json_text(scene.plant.name)),
        ("individual", scene.individual.to_string()),
        ("differs", json_text(differs)),
        ("day", scene.day.to_string()),
        ("cells", count.cells.to_string()),
    ];
    members.extend(shares(count.by_type.map(|of_type| f64::from(of_type) / cells)));
    members.push(("link", json_text(&format!("{address}#{}", origin::whole_link(scene)))));
    object(&members)
}

fn shares(shares: [f64; 3]) -> [(&'static str, String); 3] {
    let [f, b, m] = shares.map(number);
    [("share_F", f), ("share_B", b), ("share_M", m)]
}

fn object(members: &[(&str, String)]) -> String {
    let members: Vec<String> =
        members.iter().map(|(name, value)| format!(r#""{name}":{value}"#)).collect();
    format!("{{{}}}", members.join(","))
}

/// A number, or an empty text where there is none: JSON has no other.
fn number(value: f64) -> String {
    if value.is_finite() { value.to_string() } else { "\"\"".to_string() }
}

/// A text in JSON.
pub fn json_text(text: &str) -> String {
    let mut written = String::from('"');
    for c in text.chars() {
        match c {
            '"' | '\\' => written.extend(['\\', c]),
            '\0'..' ' => written.push(' '),
            _ => written.push(c),
        }
    }
    written + "\""
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mosaic::Pattern;
    use crate::plants;
    use crate::play::link;
    use crate::tissue::{CLAN_STEPS, DayCount};
    use serde_json::{Value, json};

    fn read(text: &str) -> Value {
        serde_json::from_str(text).unwrap_or_else(|why| panic!("{why}: {text}"))
    }

    /// The names of the columns of a request that makes a table.
    fn columns(made: &Value) -> Vec<String> {
        let collections = made["values"]["collections"].as_array().unwrap();
        let columns = collections.iter().flat_map(|c| c["attrs"].as_array().unwrap());
        columns.map(|column| column["name"].as_str().unwrap().to_string()).collect()
    }

    fn names(case: &Value) -> Vec<String> {
        let mut names: Vec<String> = case.as_object().unwrap().keys().cloned().collect();
        names.sort();
        names
    }

    #[test]
    fn cases_have_the_columns_of_their_tables() {
        let scene = link::read("croton?v=1&s=7&d=30", plants::all()).scene;
        let count = DayCount { cells: 10, by_type: [4, 6, 0] };
        let pattern = Pattern {
            count,
            area_shares: [0.25, f64::NAN, 0.0],
            patches: [3, 1, 0],
            largest_patches: [2, 6, 0],
            largest_areas: [0.1, 0.7, 0.0],
            mixed_edges: 0.5,
        };
        let now = DayNumbers {
            day: 3,
            pattern,
            expected: None,
            clans: [0; CLAN_STEPS],
            expected_clans: None,
        };
        let day = read(&day_case(&scene, &now, "k3v9qa", "https://example.org/"));
        assert_eq!(day["link"], "https://example.org/#croton?v=1&s=7&d=3");
        assert_eq!(
            [&day["cells"], &day["share_F"], &day["patches_F"]],
            [&json!(10), &json!(0.4), &json!(3)]
        );
        assert_eq!([&day["area_F"], &day["area_B"]], [&json!(0.25), &json!("")]);
        let mut expected = columns(&read(&DAYS.make()));
        expected.sort();
        assert_eq!(names(&day), expected);
        let grown = Grown { scene, count };
        let individual = read(&individual_case(&grown, "individual \"7\"", "https://example.org/"));
        let mut expected = columns(&read(&INDIVIDUALS.make()));
        expected.sort();
        assert_eq!(names(&individual), expected);
        assert_eq!(individual["differs"], "individual \"7\"");
    }

    #[test]
    fn requests_are_as_the_api_of_codap_has_them() {
        let made = read(&DAYS.make());
        assert_eq!((&made["action"], &made["resource"]), (&json!("create"), &json!("dataContext")));
        let [plants, days] = [0, 1].map(|k| made["values"]["collections"][k].clone());
        assert_eq!((&plants["name"], &plants["parent"]), (&json!("plants"), &Value::Null));
        assert_eq!((&days["name"], &days["parent"]), (&json!("days"), &json!("plants")));
        assert_eq!(days["attrs"][0]["type"], "numeric");
        assert_eq!(plants["attrs"][0]["type"], "categorical");
        let added = read(&INDIVIDUALS.add(&["{\"a\":1}".to_string(), "{}".to_string()]));
        assert_eq!(added["resource"], "dataContext[clonal_mosaic_individuals].item");
        assert_eq!(added["values"], json!([{"a": 1}, {}]));
        assert_eq!(read(&DAYS.ask())["resource"], "dataContext[clonal_mosaic_days]");
        assert_eq!(read(&DAYS.show())["values"]["type"], "caseTable");
    }
}
