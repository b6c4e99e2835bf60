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
        ("[]", "recipe"),
        ("{\"days\":}", "the recipe is no JSON"),
        ("{} {}", "the recipe is no JSON"),
        ("3", "the recipe: invalid type: integer `3`, expected an object"),
        (r#"{"dayz":3}"#, "dayz"),
        (r#"{"days":-1}"#, "days: invalid value: integer `-1`, expected a whole number"),
        (r#"{"days":2.5}"#, "2.5"),
        (r#"{"days":100000}"#, "days is 100000"),
        (r#"{"initial_cells":0}"#, "initial_cells is 0"),
        (r#"{"initial_probability":{"F":0.5}}"#, "sum 1"),
        (r#"{"initial_probability":{"F":1.5,"B":-0.5}}"#, "initial_probability"),
        (r#"{"initial_probability":{"Q":1}}"#, "Q"),
        (r#"{"division_days":{"F":0.6}}"#, "division_days of F is 0.6: it must be over 1"),
        (r#"{"division_days":{"F":null}}"#, "division_days: invalid type: null, expected a number"),
        (r#"{"mutation":{"F":{"B":"often"}}}"#, "mutation: invalid type"),
        (r#"{"division_days":{"B":1}}"#, "division_days of B is 1"),
        (r#"{"mutation":{"F":{"B":1.2}}}"#, "mutation of F"),
        (r#"{"mutation":{"F":{"F":0.5,"B":0.1}}}"#, "mutation of F"),
        (r#"{"adhesion":{"FF":1.2}}"#, "adhesion FF is 1.2"),
        (r#"{"adhesion":{"FF":"much"}}"#, "adhesion.FF: invalid type: string"),
        (r#"{"adhesion":{"BF":0.2}}"#, "no pair BF"),
        (r#"{"radius_scale":0}"#, "radius_scale is 0"),
        (r#"{"radius_scale":1e9}"#, "radius_scale"),
        (r#"{"repulsion":-1}"#, "repulsion is -1"),
        (r#"{"anisotropy":1.5}"#, "anisotropy is 1.5: it must be from 0 to 1"),
        (r#"{"anisotropy":-0.1}"#, "anisotropy is -0.1"),
        (r#"{"clock":"sundial"}"#, "sundial"),
        (r#"{"clock":"exponential","division_days":{"F":0.9}}"#, "division_days of F is 0.9"),
        (r#"{"relaxations_per_day":5000}"#, "relaxations_per_day is 5000"),
        (r#"{"max_cells":10}"#, "max_cells is 10"),
    ] {
        let error = Recipe::from_json(text).expect_err(text).to_string();
        assert!(error.contains(words), "{text} is refused with: {error}");
        assert!(!error.contains('\n') && error.len() < 300, "one line: {error}");
    }
}
