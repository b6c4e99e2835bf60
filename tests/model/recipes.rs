//! Recipes as text: what is read, what is refused, and in which words.

use clonal_mosaic::tissue::{Clock, Recipe};

/// The recipe of the command line's manual, whole.
const WHOLE: &str = r#"{"initial_cells":2000, "initial_probability":{"F":0.5,"B":0.5},
    "division_days":{"F":10,"B":10}, "adhesion":{"FF":0.5,"BB":0.8}, "mutation":{"F":{"B":0.01}},
    "radius_scale":1.0, "repulsion":0.09, "initial_relaxations":10, "relaxations_per_day":10,
    "days":35}"#;

#[test]
fn a_whole_recipe_is_read_and_written_back() {
    let recipe = Recipe::from_json(WHOLE).unwrap();
    assert_eq!(recipe.initial_cells, 2000);
    assert_eq!(recipe.initial_probability, [0.5, 0.5, 0.0]);
    assert_eq!(recipe.division_days[..2], [10.0, 10.0]);
    assert_eq!(recipe.mutation[0], [0.99, 0.01, 0.0]);
    assert_eq!(recipe.mutation[1], [0.0, 1.0, 0.0]);
    assert_eq!(recipe.adhesion, [[0.5, 0.0, 0.0], [0.0, 0.8, 0.0], [0.0; 3]]);
    assert_eq!(Recipe::from_json(&recipe.to_json()).unwrap(), recipe);
}

#[test]
fn what_is_left_out_has_its_default() {
    assert_eq!(Recipe::from_json("{}").unwrap(), Recipe::default());
    let recipe = Recipe::from_json(r#"{"division_days":{"F":3},"adhesion":{"FB":0.2}}"#).unwrap();
    assert_eq!(recipe.division_days[0], 3.0);
    assert_eq!(recipe.division_days[1], Recipe::default().division_days[1]);
    assert_eq!((recipe.adhesion[0][1], recipe.adhesion[1][0]), (0.2, 0.2));
    assert_eq!(recipe.adhesion[0][0], Recipe::default().adhesion[0][0]);
    assert_eq!((recipe.clock, recipe.anisotropy), (Clock::Poisson, 0.0));
    let recipe = Recipe::from_json(r#"{"clock":"exponential","anisotropy":0.25}"#).unwrap();
    assert_eq!((recipe.clock, recipe.anisotropy), (Clock::Exponential, 0.25));
    assert_eq!(Recipe::from_json(&recipe.to_json()).unwrap(), recipe);
}

#[test]
fn what_cannot_be_grown_is_refused_in_plain_words() {
    for (text, words) in [
        ("", "the recipe is no JSON"),
        ("[]", "the recipe: an object {...} is needed, not a list"),
        ("{\"days\":}", "the recipe is no JSON"),
        ("{} {}", "the recipe is no JSON"),
        ("3", "the recipe: an object {...} is needed, not 3"),
        (r#"{"dayz":3}"#, "dayz"),
        (r#"{"days":-1}"#, "days: a whole number from 0 to 4294967295 is needed, not -1"),
        (r#"{"days":2.5}"#, "2.5"),
        (r#"{"days":100000}"#, "days is 100000"),
        (r#"{"initial_cells":0}"#, "initial_cells is 0"),
        (r#"{"initial_probability":{"F":0.5}}"#, "sum 1"),
        (r#"{"initial_probability":{"F":1.5,"B":-0.5}}"#, "initial_probability"),
        (r#"{"initial_probability":{"Q":1}}"#, "Q"),
        (r#"{"division_days":{"F":0.6}}"#, "division_days of F is 0.6: it must be over 1"),
        (r#"{"division_days":{"F":null}}"#, "division_days.F: a number is needed, not null"),
        (r#"{"mutation":{"F":{"B":"often"}}}"#, "mutation.F.B: a number is needed, not \"often\""),
        (r#"{"division_days":{"B":1}}"#, "division_days of B is 1"),
        (r#"{"mutation":{"F":{"B":1.2}}}"#, "mutation of F"),
        (r#"{"mutation":{"F":{"F":0.5,"B":0.1}}}"#, "mutation of F"),
        (r#"{"adhesion":{"FF":1.2}}"#, "adhesion FF is 1.2"),
        (r#"{"adhesion":{"FF":"much"}}"#, "adhesion.FF: a number is needed, not \"much\""),
        (
            r#"{"adhesion":{"BF":0.2}}"#,
            "adhesion: it has no \"BF\"; it may have FF, BB, MM, FB, FM and BM",
        ),
        (r#"{"radius_scale":0}"#, "radius_scale is 0"),
        (r#"{"radius_scale":1e9}"#, "radius_scale"),
        (r#"{"repulsion":-1}"#, "repulsion is -1"),
        (r#"{"anisotropy":1.5}"#, "anisotropy is 1.5: it must be from 0 to 1"),
        (r#"{"anisotropy":-0.1}"#, "anisotropy is -0.1"),
        (r#"{"clock":"sundial"}"#, "sundial"),
        (r#"{"clock":"exponential","division_days":{"F":0.9}}"#, "division_days of F is 0.9"),
        (r#"{"relaxations_per_day":5000}"#, "relaxations_per_day is 5000"),
        (r#"{"max_cells":10}"#, "max_cells is 10"),
        (r#"{"clock":3}"#, "clock: \"poisson\" or \"exponential\" is needed, not 3"),
        (
            r#"{"clock":{"poisson":1}}"#,
            "clock: \"poisson\" or \"exponential\" is needed, not an object",
        ),
        (r#"{"adhesion":[[0.5,0]]}"#, "adhesion: an object {...} is needed, not a list"),
        (r#"{"repulsion":1e999}"#, "the recipe: number out of range"),
        (r#"{"days":3,"days":4}"#, "the recipe: \"days\" stands in it twice"),
        (r#"{"mutation":{"F":{"B":0.1,"B":0.2}}}"#, "mutation.F: \"B\" stands in it twice"),
        (r#"{"adhesion":{"FF":0.1,"FF":0.1}}"#, "adhesion: \"FF\" stands in it twice"),
        (r#"{"initial_probability":{"F":0.5,"B":0.49}}"#, "sum 1"),
        (r#"{"mutation":{"F":{"B":0.8,"M":0.3}}}"#, "mutation of F is F 0, B 0.8, M 0.3"),
        (
            &format!(r#"{{"{0}":"{0}"}}"#, "\\u001b".repeat(1000)),
            "the recipe: it has no \"\u{fffd}",
        ),
    ] {
        let error = Recipe::from_json(text).expect_err(text).to_string();
        assert!(error.contains(words), "{text} is refused with: {error}");
        assert!(!error.contains(char::is_control) && error.len() < 400, "one line: {error}");
        assert_eq!(error.contains("no JSON"), words.contains("no JSON"), "{text}: {error}");
    }
}

#[test]
fn numbers_are_read_as_people_write_them() {
    let recipe = Recipe::from_json("\u{feff}{\"initial_cells\":2e3,\"days\":3.0,\"repulsion\":1}");
    let recipe = recipe.unwrap();
    assert_eq!((recipe.initial_cells, recipe.days, recipe.repulsion), (2000, 3, 1.0));
}

#[test]
fn shares_that_were_rounded_are_scaled_to_one() {
    let shares = |text: &str| Recipe::from_json(text).unwrap().initial_probability;
    let row = shares(r#"{"initial_probability":{"F":0.333,"B":0.666}}"#);
    assert!((row[0] - 1.0 / 3.0).abs() < 1e-9 && row[2] == 0.0, "{row:?}");
    // What was exact enough before stays as it was written.
    let row = shares(r#"{"initial_probability":{"F":0.3333333,"B":0.6666666}}"#);
    assert_eq!(row, [0.333_333_3, 0.666_666_6, 0.0]);
    let rows = Recipe::from_json(r#"{"mutation":{"M":{"F":0.5,"B":0.501},"F":{"B":0.3,"M":0.3}}}"#);
    let rows = rows.unwrap().mutation;
    assert!((rows[2].iter().sum::<f64>() - 1.0).abs() < 1e-12 && rows[2][2] == 0.0, "{rows:?}");
    assert_eq!(rows[0], [1.0 - (0.3 + 0.3), 0.3, 0.3]);
}

#[test]
fn numbers_go_to_the_ends_that_are_named_and_no_further() {
    type Set = fn(&mut Recipe, f64);
    let numbers: [(&str, Set, &[f64], &[f64]); 11] = [
        ("initial_cells", |r, x| r.initial_cells = x as u32, &[1.0, 2e6], &[0.0, 2_000_001.0]),
        ("max_cells", |r, x| r.max_cells = x as u32, &[2000.0, 1e8], &[1999.0, 100_000_001.0]),
        ("days", |r, x| r.days = x as u32, &[0.0, 1000.0], &[1001.0]),
        ("relaxations_per_day", |r, x| r.relaxations_per_day = x as u32, &[0.0, 1e3], &[1001.0]),
        ("initial_relaxations", |r, x| r.initial_relaxations = x as u32, &[0.0, 1e4], &[10_001.0]),
        ("division_days", |r, x| r.division_days[1] = x, &[1.001, 500.0], &[1.0, 500.1, f64::NAN]),
        ("adhesion", |r, x| r.adhesion[0][2] = x as f32, &[0.0, 1.0], &[-0.001, 1.001, f64::NAN]),
        (
            "radius_scale",
            |r, x| r.radius_scale = x as f32,
            &[0.001, 10.0],
            &[0.0, 10.001, f64::NAN],
        ),
        ("repulsion", |r, x| r.repulsion = x as f32, &[0.0, 2.0], &[-0.001, 2.001, f64::NAN]),
        ("anisotropy", |r, x| r.anisotropy = x as f32, &[0.0, 1.0], &[-0.001, 1.001, f64::NAN]),
        (
            "initial_probability",
            |r, x| r.initial_probability = [x, 1.0 - x, 0.0],
            &[0.0, 1.0],
            &[-0.001, 1.001, f64::NAN],
        ),
    ];
    for (name, set, within, beyond) in numbers {
        let with = |x: f64| {
            let mut recipe =
                Recipe { initial_cells: 2000, max_cells: 100_000_000, ..Recipe::default() };
            set(&mut recipe, x);
            recipe.check()
        };
        for &x in within {
            assert_eq!(with(x), Ok(()), "{name} {x}");
        }
        for &x in beyond {
            assert!(with(x).unwrap_err().to_string().contains(name), "{name} {x}");
        }
    }
    let of_sum = |sum: f64| {
        let initial_probability = [0.5, 0.25, sum - 0.75];
        Recipe { initial_probability, ..Recipe::default() }.check().is_ok()
    };
    assert_eq!(
        [0.999_99, 0.999_999_5, 1.0, 1.000_000_5, 1.000_01].map(of_sum),
        [false, true, true, true, false]
    );
}
