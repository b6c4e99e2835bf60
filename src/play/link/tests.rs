//! What links say, and what is told of those that say something else.

use super::*;
use crate::plants::Rules;
use crate::play::testing::PLANTS;
use crate::tissue::Clock;

fn open(text: &str) -> Opened {
    read(text, PLANTS)
}

#[test]
fn an_empty_link_is_the_first_plant() {
    for text in ["", "#", "#leaf", "#leaf?"] {
        let opened = open(text);
        assert!(opened.left_out.is_empty());
        assert_eq!(write(&opened.scene), "leaf?v=1&s=1&d=3");
    }
}

#[test]
fn a_link_holds_what_differs_and_nothing_else() {
    let link = "leaf?v=1&s=0&d=2&df=6&ff=0.35&noise=1&view=30,20,1.5";
    let opened = open(link);
    assert_eq!(opened.left_out, [""; 0]);
    assert_eq!(opened.scene.individual, 0);
    assert_eq!(opened.scene.recipe.division_days[0], 6.0);
    assert_eq!(opened.scene.recipe.adhesion[0][0], 0.35);
    assert!(opened.scene.noise);
    assert_eq!(write(&opened.scene), link);
}

#[test]
fn a_clone_in_hand_comes_back() {
    let link = "leaf?v=1&s=1&d=2&show=clans&cell=1234";
    let opened = open(link);
    assert_eq!((opened.scene.cell, opened.left_out), (Some(1234), Vec::new()));
    assert_eq!(write(&opened.scene), link);
    let whole_numbers = "it must be a whole number from 0 to 4294967295";
    for value in ["-1", "1.5", "x", ""] {
        let opened = open(&format!("leaf?v=1&s=1&d=2&cell={value}"));
        assert_eq!(opened.scene.cell, None);
        assert_eq!(opened.left_out, [format!("“cell={value}” was left out: {whole_numbers}.")]);
    }
}

#[test]
fn every_parameter_comes_back() {
    for parameter in PARAMETERS {
        let mut scene = Scene::preset(&PLANTS[0], 9);
        let [least, greatest] = parameter.range;
        let between = least + 0.25 * (greatest - least);
        let value = if parameter.is_whole() { greatest } else { between };
        parameter.set(&mut scene, value).expect(parameter.key);
        let opened = open(&write(&scene));
        assert_eq!(opened.left_out, [""; 0], "{}", parameter.key);
        assert!(opened.scene == scene, "{}", write(&scene));
        assert_eq!(opened.scene.recipe, scene.recipe);
    }
}

#[test]
fn three_types_come_back_together() {
    let link = "leaf?v=1&s=3&d=3&pf=0.3&pm=0.6&dm=7&ck=1&fm=0.4&mfb=0.1&mfm=0.2&mmf=0.05&mmb=0.95\
                &an=0.5";
    let opened = open(link);
    assert_eq!(opened.left_out, [""; 0]);
    assert_eq!(write(&opened.scene), link);
    let recipe = &opened.scene.recipe;
    assert_eq!((recipe.clock, recipe.anisotropy), (Clock::Exponential, 0.5));
    assert_eq!(recipe.adhesion[2][0], 0.4);
    assert_eq!(recipe.mutation[0][1..], [0.1, 0.2]);
    assert_eq!(recipe.mutation[2][..2], [0.05, 0.95]);
    assert_eq!(recipe.initial_probability[2], 0.6);
    let told = open("fruit?v=1&pm=0.2&an=0.5&ck=0.5").left_out;
    assert_eq!(
        told,
        [
            "“pm=0.2” was left out: this plant has no use for it.",
            "“ck=0.5” was left out: it must be a whole number.",
            "“an=0.5” was left out: this plant has no use for it.",
        ]
    );
}

#[test]
fn what_is_shown_comes_back_where_the_plant_has_it() {
    for plant in crate::plants::all() {
        for show in Show::offered(plant) {
            let scene = Scene { show, ..Scene::preset(plant, 2) };
            let link = write(&scene);
            assert_eq!(link.contains("show="), show != Show::Cells, "{link}");
            let opened = read(&link, crate::plants::all());
            assert_eq!((opened.scene.show, opened.left_out), (show, Vec::new()), "{link}");
        }
    }
    for pair in ["show=field-x", "show=bones", "show="] {
        let opened = read(&format!("croton?v=1&{pair}"), crate::plants::all());
        assert_eq!(opened.scene.show, Show::Cells);
        let told = "was left out: this plant has nothing of that name to show.";
        assert_eq!(opened.left_out, [format!("“{pair}” {told}")]);
    }
}

#[test]
fn bad_links_load_what_they_can() {
    let opened = open("#leaf?v=1&s=17&d=99&df=0.2&zz=3&db=abc&bb=0.9&s=4&view=1,2");
    assert_eq!(opened.scene.individual, 17);
    assert_eq!(opened.scene.day, opened.scene.recipe.days);
    assert_eq!(opened.scene.recipe.adhesion[1][1], 0.9);
    let told = opened.left_out.join("\n");
    for part in [
        "“df=0.2” was left out: it must be from 1.5 to 200 days.",
        "“zz=3” was left out: unknown to this playground.",
        "“db=abc” was left out: “abc” is not a number.",
        "“s=4” was left out: of each word the first counts.",
        "“view=1,2” was left out: a view has three or five numbers.",
        "Day 99 is past the last one: day 6 is shown in its place.",
    ] {
        assert!(told.contains(part), "{part} is not in\n{told}");
    }
    assert_eq!(opened.left_out.len(), 6);
}

#[test]
fn foreign_links_are_told_and_replaced() {
    let opened = open("#section-2?utm=x");
    assert_eq!(opened.scene.plant.key, "leaf");
    assert_eq!(opened.left_out.len(), 2);
    assert!(opened.left_out[0].contains("the leaf stands in"));
    assert_eq!(open("#leaf?v=7").left_out.len(), 1);
    // Never a panic, whatever comes.
    for text in ["#%", "#%zz?%f", "#?&&==&", "#leaf?s=-1&d=1e9&n=NaN&view=,,", "#…?…=…"] {
        open(text);
    }
}

#[test]
fn links_of_earlier_rules_mean_the_plants_of_then() {
    let plants = crate::plants::all();
    for plant in plants.iter().filter(|plant| plant.rules == Rules::Second) {
        let of = |query: &str| {
            let opened = read(&format!("{}?s=3{query}", plant.key), plants);
            assert_eq!(opened.left_out, [""; 0]);
            opened.scene
        };
        let (newest, first, second) = (of(""), of("&v=1"), of("&v=2"));
        assert_eq!([&newest, &first, &second].map(|scene| scene.plant.rules as u32), [2, 1, 2]);
        assert!(newest == second && newest != first);
        assert_eq!(first.recipe, plant.under(1).unwrap().recipe);
        for (scene, version) in [(&first, "v=1"), (&second, "v=2")] {
            let link = write(scene);
            assert!(link.starts_with(&format!("{}?{version}&s=3&d=", plant.key)), "{link}");
            assert!(read(&link, plants).scene == *scene);
        }
        let alike = Scene { recipe: first.recipe.clone(), ..second };
        assert!(!alike.grows_like(&first), "rules are others");
    }
    for (version, why) in [
        ("3", "this plant has links up to version 2"),
        ("0", "this plant has links up to version 2"),
        ("x", "it must be a whole number from 0 to 4294967295"),
    ] {
        let told = read(&format!("croton?v={version}"), plants).left_out;
        assert_eq!(told, [format!("“v={version}” was left out: {why}.")]);
    }
}

#[test]
fn messengers_may_mangle() {
    let opened = open("#leaf%3Fv=1&amp;s=5&view=30%2C20%2C2");
    assert_eq!(opened.left_out, [""; 0]);
    assert_eq!(opened.scene.individual, 5);
    assert_eq!(opened.scene.orbit.zoom, 2.0);
}

#[test]
fn what_a_sentence_hangs_on_a_link_is_no_part_of_it() {
    for end in [".", ")", ",", "\"", ">", "”.", "%3E", "!)", " ", "…"] {
        for link in ["leaf?v=1&s=5&d=2", "leaf?v=1&s=1&d=3&rs=2&view=30,20,2", "leaf"] {
            let opened = open(&format!("#{link}{end}"));
            assert_eq!(opened.left_out, [""; 0], "{link}{end}");
            assert_eq!(write(&opened.scene), write(&open(link).scene), "{link}{end}");
        }
    }
}

#[test]
fn of_shares_that_are_more_than_one_together_the_second_counts_in_any_order() {
    for [one, other] in [["pf", "pm"], ["mfb", "mfm"], ["mbf", "mbm"], ["mmf", "mmb"]] {
        for [a, b] in [[one, other], [other, one]] {
            let opened = open(&format!("leaf?v=1&{a}=0.7&{b}=0.7"));
            let told = format!("“{one}=0.7” was left out: with {other} it is more than 1.");
            assert_eq!(opened.left_out, [told]);
            let value = |word| Parameter::of_key(word).unwrap().get(&opened.scene);
            assert!((value(one) - 0.3).abs() < 1e-9 && value(other) == 0.7);
            let opened = open(&format!("leaf?v=1&{a}=0.7&{b}=0.3"));
            assert_eq!(opened.left_out, [""; 0]);
        }
    }
    assert_eq!(open("leaf?v=1&pm=0.7").scene.recipe.initial_probability[2], 0.7);
}

#[test]
fn whole_numbers_have_no_fraction() {
    for word in ["n", "ri", "rd", "days", "s", "d"] {
        let left_out = open(&format!("leaf?v=1&{word}=2.9")).left_out;
        assert!(left_out[0].contains("whole number") && left_out.len() == 1, "{left_out:?}");
    }
}

#[test]
fn what_a_link_says_is_what_is_grown() {
    // More digits than a link has.
    let opened = open("leaf?v=1&rs=1.23456789&ff=0.123456789&rep=0.1000000149");
    assert_eq!(open(&write(&opened.scene)).scene.recipe, opened.scene.recipe);
}

#[test]
fn messages_are_few_short_and_without_control_characters() {
    let long = "x".repeat(1_000_000);
    let unknown: String = (0..300).map(|k| format!("&z{k}={long}")).take(3).collect();
    let hundreds: String = (0..300).map(|k| format!("&y{k}=1&s=%1b[31m")).collect();
    let left_out = open(&format!("{long}%0a?v={long}&n=%00{unknown}{hundreds}")).left_out;
    assert!(left_out.len() < 7, "{left_out:?}");
    for told in &left_out {
        assert!(told.len() < 400 && !told.contains(char::is_control), "{told}");
    }
    assert!(left_out.iter().any(|told| told.contains(" and 302 more were left out")));
}

#[test]
fn preset_individual_and_day_stay_short() {
    for plant in PLANTS.iter().chain(crate::plants::all()) {
        assert!(write(&Scene::preset(plant, u32::MAX)).len() < 100);
    }
}

#[test]
fn what_machines_are_told_of_links_is_so() {
    let told = include_str!("../../../www/llms.txt");
    let examples: Vec<&str> = told.lines().filter_map(|line| line.strip_prefix("- #")).collect();
    assert!(examples.len() >= 5);
    for example in examples {
        let opened = read(example, crate::plants::all());
        assert_eq!(opened.left_out, [""; 0], "{example}");
        let beside = example.split_once('~').map_or("", |(_, beside)| beside);
        let class = crate::play::classroom::Class::read(beside.trim_start_matches("class/"));
        assert!(["", "present", "simple"].contains(&beside) || class.1.is_empty(), "{example}");
    }
    for plant in crate::plants::all() {
        assert!(told.contains(plant.key), "{}", plant.key);
    }
    assert!(told.len() < 2048);
}
