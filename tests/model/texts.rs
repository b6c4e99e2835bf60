//! Whatever text comes, a recipe and a link are read or refused; and what was written is read back.

use clonal_mosaic::plants;
use clonal_mosaic::play::parameters::PARAMETERS;
use clonal_mosaic::play::{Scene, link};
use clonal_mosaic::tissue::{Clock, Recipe};
use proptest::prelude::*;

/// Three shares with the sum 1.
fn shares() -> impl Strategy<Value = [f64; 3]> {
    (0.0..=1.0, 0.0..=1.0).prop_map(|(first, of_rest): (f64, f64)| {
        let second = (1.0 - first) * of_rest;
        [first, second, (1.0 - first - second).max(0.0)]
    })
}

fn recipe() -> impl Strategy<Value = Recipe> {
    let counts =
        (1..=2_000_000u32, 0..=10_000u32, 0..=1000u32, 0..=1000u32, 2_000_000..=Recipe::MOST_CELLS);
    let pushes = (1e-6..=10.0f32, 0.0..=2.0f32, 0.0..=1.0f32, prop::array::uniform6(0.0..=1.0f32));
    let days = prop::array::uniform3(1.001..=500.0);
    (counts, pushes, days, any::<bool>(), shares(), [shares(), shares(), shares()]).prop_map(
        |(counts, pushes, division_days, is_poisson, initial_probability, mutation)| {
            let (radius_scale, repulsion, anisotropy, [ff, bb, mm, fb, fm, bm]) = pushes;
            Recipe {
                initial_cells: counts.0,
                initial_relaxations: counts.1,
                relaxations_per_day: counts.2,
                days: counts.3,
                max_cells: counts.4,
                initial_probability,
                division_days,
                clock: if is_poisson { Clock::Poisson } else { Clock::Exponential },
                mutation,
                adhesion: [[ff, fb, fm], [fb, bb, bm], [fm, bm, mm]],
                radius_scale,
                repulsion,
                anisotropy,
            }
        },
    )
}

/// A parameter's word with a value that it may have, or not.
fn pair() -> impl Strategy<Value = (&'static str, f64)> {
    (0..PARAMETERS.len(), -0.2..=1.2f64, any::<bool>()).prop_map(|(k, share, rounded)| {
        let parameter = &PARAMETERS[k];
        let [least, greatest] = parameter.range;
        // Colours are written so that they cannot be out of their range.
        let share = if parameter.is_colour { share.clamp(0.0, 1.0) } else { share };
        let value = least + share * (greatest - least);
        let steps = (value / parameter.step).round();
        (
            parameter.key,
            if rounded || parameter.is_whole() { steps * parameter.step } else { value },
        )
    })
}

/// A word and its value as links say them.
fn said(word: &str, value: f64) -> String {
    let parameter = PARAMETERS.iter().find(|p| p.key == word).unwrap();
    format!("{word}={}", parameter.written(value))
}

/// Pieces of links and of what is none.
fn piece() -> impl Strategy<Value = String> {
    prop_oneof![
        "[a-z]{0,3}=[-+0-9.e,]{0,8}",
        ".{0,12}",
        pair().prop_map(|(word, value)| said(word, value)),
        Just("view=1,2,3".to_string()),
        Just("%F0%9".to_string()),
        Just("show=field".to_string()),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_text_is_a_recipe_or_refused_in_a_line(text in ".*", recipe in recipe(), cut in 0..900usize) {
        let json = recipe.to_json();
        let start: String = json.chars().take(cut).collect();
        let broken = format!("{start}{text}{}", &json[start.len()..]);
        for text in [text, start, broken] {
            if let Err(refused) = Recipe::from_json(&text) {
                let told = refused.to_string();
                prop_assert!(!told.contains(char::is_control) && told.len() < 1000, "{told}");
            }
        }
    }

    #[test]
    fn a_recipe_that_was_written_is_read_back_bit_for_bit(recipe in recipe()) {
        prop_assert_eq!(recipe.check(), Ok(()));
        let read = Recipe::from_json(&recipe.to_json()).unwrap();
        prop_assert_eq!(format!("{read:?}"), format!("{recipe:?}"));
    }

    #[test]
    fn any_text_is_a_link(name in "croton|fruit|.{0,9}", pieces in prop::collection::vec(piece(), 0..9)) {
        let opened = link::read(&format!("{name}?{}", pieces.join("&")), plants::all());
        let written = link::write(&opened.scene);
        let again = link::read(&written, plants::all());
        prop_assert!(again.left_out.is_empty(), "{written}: {:?}", again.left_out);
        prop_assert_eq!(link::write(&again.scene), written);
        prop_assert_eq!(format!("{:?}", again.scene.recipe), format!("{:?}", opened.scene.recipe));
    }

    #[test]
    fn a_scene_that_was_written_is_read_back(
        plant in 0..plants::all().len(), individual in any::<u32>(), day in 0..=60u32,
        noise in any::<bool>(), pairs in prop::collection::vec(pair(), 0..12),
    ) {
        let mut scene = Scene::preset(&plants::all()[plant], individual);
        for (word, value) in pairs {
            let parameter = PARAMETERS.iter().find(|p| p.key == word).unwrap();
            let _ = parameter.set(&mut scene, value);
        }
        (scene.day, scene.noise) = (day.min(scene.recipe.days), noise);
        let opened = link::read(&link::write(&scene), plants::all());
        prop_assert!(opened.left_out.is_empty(), "{:?}", opened.left_out);
        // All that decides the cells, to the last digit. But what a share leaves, where it was set to what
        // the preset has, is there as it was written and not as it is reckoned.
        let said = |scene: Scene| {
            let Scene { mut recipe, individual, day, noise, .. } = scene;
            let rows = recipe.mutation.iter_mut().chain([&mut recipe.initial_probability]);
            rows.flatten().for_each(|share| *share = (*share * 1e12).round() / 1e12);
            format!("{:?}", (recipe, individual, day, noise))
        };
        prop_assert_eq!(said(opened.scene), said(scene));
    }

    #[test]
    fn the_order_of_a_links_words_does_not_matter(
        pairs in prop::collection::btree_map(0..PARAMETERS.len(), pair(), 2..9),
        turn in 1..9usize,
    ) {
        // Each word once.
        let mut words: Vec<(&str, f64)> = pairs.into_values().collect();
        words.sort_by_key(|(word, _)| *word);
        words.dedup_by_key(|(word, _)| *word);
        let read = |words: &[(&str, f64)]| {
            let text: String = words.iter().map(|&(word, value)| format!("&{}", said(word, value))).collect();
            let mut opened = link::read(&format!("red-croton?v=1{text}"), plants::all());
            opened.left_out.sort();
            (link::write(&opened.scene), format!("{:?}", opened.scene.recipe), opened.left_out)
        };
        let first = read(&words);
        words.reverse();
        prop_assert_eq!(&first, &read(&words));
        let turn = turn % words.len();
        words.rotate_left(turn);
        prop_assert_eq!(&first, &read(&words));
    }
}

#[test]
fn positions_are_those_that_the_standard_library_reads_as_f32() {
    for plant in clonal_mosaic::plants::all() {
        let words = plant.body.mesh.text.split_whitespace();
        for word in words.filter(|word| word.contains('.')) {
            if let Ok(number) = word.parse::<f32>() {
                assert_eq!(clonal_mosaic::surface::decimal(word).unwrap() as f32, number, "{word}");
            }
        }
    }
}
