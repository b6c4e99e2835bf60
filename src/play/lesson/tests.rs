use super::*;
use crate::plants;
use crate::play::link;
use crate::play::phrasebook::PHRASEBOOKS;
use std::path::Path;

const SHORT: &str = "\u{feff}title: A lesson\r\nage: 12\r\nminutes: 5\r\n# nobody's\r\n\r\n[look] Here\r\nlink: \
                     https://example.org/x/#croton?v=1&d=3~lesson\r\nOne\r\ntwo: that.\r\n\r\nThree: four.\r\n";

/// What is wrong with a lesson of which this is the rest.
fn told(rest: &str) -> String {
    read(&format!("title: T\n{rest}")).expect_err(rest).to_string()
}

fn shipped(name: &str) -> Lesson {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("www/lessons").join(name);
    let text = std::fs::read_to_string(file.with_extension("txt")).expect("a lesson is there");
    read(&text).unwrap_or_else(|why| panic!("{name}: {why}"))
}

#[test]
fn a_lesson_is_read_from_plain_text() {
    let lesson = read(SHORT).unwrap();
    assert_eq!((lesson.title.as_str(), lesson.age.as_str(), lesson.minutes), ("A lesson", "12", 5));
    let step = &lesson.steps[0];
    assert_eq!(step.link.as_deref(), Some("croton?v=1&d=3"));
    assert_eq!(step.text, ["One two: that.", "Three: four."]);
}

#[test]
fn an_indented_line_goes_on_with_the_one_above() {
    let lesson =
        read("title: A\n  long one\n[explain] E\nstudent: I\n  say\nreply: You\n\tsay\n  too\n");
    let lesson = lesson.unwrap();
    assert_eq!(lesson.title, "A long one");
    let students = vec![Student { says: "I say".into(), reply: "You say too".into() }];
    assert_eq!(lesson.steps[0].kind, Kind::Explain { students });
}

#[test]
fn what_is_wrong_is_told_with_its_line() {
    for (rest, line) in [
        ("", "Line 1: there is no step yet: a step begins with a line such as [look]."),
        ("[sing] A", "Line 2: there is no step \"sing\", but look, play, predict, grow, explain."),
        ("[look]\nlink: croton", "Line 2: the step needs a title behind [look]."),
        ("[look A", "Line 2: a step's line needs a ] behind its word, such as [look]."),
        ("[look] A", "Line 2: [look] needs a link:, which the page copies for you."),
        (
            "[look] A\n\nlink: rose?v=1",
            "Line 4: There is no plant called “rose” here: the croton stands in its place.",
        ),
        ("[look] A\nlonk: croton", "Line 3: \"lonk\" is unknown here; there are link alone."),
        ("minutes: soon\n[play] A", "Line 2: minutes is a whole number from 1 to 600."),
        ("Once\n[play] A", "Line 2: text belongs into a step, behind a line such as [look]."),
        ("[predict] A\nask: B\nbar: c", "Line 4: after [predict] comes [grow], which answers it."),
        (
            "[predict] A\nask: B\nbar: c\n[play] D",
            "Line 5: after [predict] comes [grow], which answers it.",
        ),
        ("[predict] A\nbar: c", "Line 2: a prediction needs a question, ask:."),
        (
            "[predict] A\nask: B",
            "Line 2: a prediction has one of choice: lines, bar:, number: or sketch:.",
        ),
        (
            "[predict] A\nbar: B\nright: c",
            "Line 4: a prediction has one of choice: lines, bar:, number: or sketch:.",
        ),
        ("[predict] A\nask: B\nright: c", "Line 2: one choice is none: two at least."),
        (
            "[predict] A\nask: B\nchoice: c\nchoice: d",
            "Line 2: one of the choices is written right: in place of choice:.",
        ),
        ("[predict] A\nask: B\nright: c\nright: d", "Line 5: one choice alone can be right:."),
        (
            "[predict] A\nask: B\nsketch: c",
            "Line 2: a sketch: needs its days:, such as days: 0, 10, 20.",
        ),
        ("[predict] A\nask: B\nbar: c\ndays: 0, 1", "Line 2: days: belong to a sketch:."),
        (
            "[predict] A\nask: B\nsketch: c\ndays: 5, 5",
            "Line 5: days: are from two to eight whole numbers, each greater than the one before.",
        ),
        (
            "[predict] A\nask: B\nsketch: c\ndays: 0, 5\n[grow] D\nlink: croton\nmeasure: cells",
            "Line 6: a sketch: is answered by one individual and a measure: in 100, such as share F.",
        ),
        (
            "[predict] A\nask: B\nsketch: c\ndays: 0, 50\n[grow] D\nlink: croton\nmeasure: share F",
            "Line 6: its plant grows for 30 days, and the sketch: asks for day 50.",
        ),
        (
            "[grow] A\nlink: croton\nindividuals: 0",
            "Line 4: individuals is a whole number from 1 to 60.",
        ),
        ("[explain] A\nreply: B", "Line 3: a reply: stands below its student:."),
        ("[explain] A\nstudent: B", "Line 2: \"B\" has no reply:."),
        ("[explain] A\nstudent:", "Line 3: nothing stands behind student:."),
        ("[play] A\n\u{7}", "Line 3: there is a character that is no text."),
    ] {
        assert_eq!(told(rest), line);
    }
    assert_eq!(
        read("[play] A").unwrap_err().to_string(),
        "Line 1: the lesson has no title yet: a line such as title: Doubling."
    );
    let long = "x".repeat(300_000);
    assert!(read(&long).is_err());
}

#[test]
fn measures_have_words() {
    for words in [
        "cells",
        "count M",
        "share F",
        "area B",
        "patches M",
        "largest F",
        "mixed",
        "spots",
        "single spots",
        "clans",
        "largest clan",
    ] {
        assert_eq!(Measure::of_words(words).unwrap().words(), words);
    }
    for words in ["", "share", "share X", "cell", "F"] {
        assert_eq!(Measure::of_words(words), None);
    }
    assert_eq!(Measure::Cells.told(17_831.4), "17,831");
    assert_eq!(Measure::Mixed.told(4.26), "4.3 in 100");
    assert_eq!(Measure::Mixed.told(27.4), "27 in 100");
}

#[test]
fn every_lesson_is_there_and_no_other() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("www/lessons");
    let mut files: Vec<String> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    files.sort();
    // The folders of other languages stand beside them.
    let names = LESSONS.iter().map(|name| format!("{name}.txt"));
    let mut names: Vec<String> = names.chain(PHRASEBOOKS.map(String::from)).collect();
    names.sort();
    assert_eq!(files, names);
}

#[test]
fn every_lesson_asks_grows_and_ends_with_what_others_say() {
    for name in LESSONS {
        let lesson = shipped(name);
        assert!((5..=15).contains(&lesson.minutes), "{name}");
        assert!(!lesson.age.is_empty() && !lesson.about.is_empty() && !lesson.sources.is_empty());
        // More steps lose a class.
        assert!((5..=9).contains(&lesson.steps.len()), "{name}: {} steps", lesson.steps.len());
        assert!(lesson.steps[0].link.is_some(), "{name} begins with a plant");
        let asked = lesson.steps.iter().filter(|s| matches!(s.kind, Kind::Predict { .. })).count();
        assert!(asked >= 1, "{name} asks nothing");
        let Some(Step { kind: Kind::Explain { students }, .. }) = lesson.steps.last() else {
            panic!("{name} ends with something else");
        };
        assert!(students.len() >= 3, "{name}");
        for (k, step) in lesson.steps.iter().enumerate() {
            let words: usize = step.text.iter().map(|text| text.split(' ').count()).sum();
            assert!(words <= 90, "{name}, step {}: {words} words", k + 1);
            if let Some(link) = &step.link {
                assert_eq!(link::read(link, plants::all()).left_out, [""; 0], "{name}: {link}");
            }
        }
    }
}

#[test]
fn every_growth_is_one_that_a_class_can_wait_for() {
    for name in LESSONS {
        for step in shipped(name).steps {
            let Kind::Grow(growing) = &step.kind else { continue };
            let scene = link::read(step.link.as_deref().unwrap(), plants::all()).scene;
            let is_fast = growing.measure.is_none_or(|measure| measure.is_of_lineage(&scene));
            assert!(is_fast || growing.individuals == 1, "{name}, {}", step.title);
            // A step that has a prediction before it says something beside it.
            assert!(
                growing.measure.is_some()
                    || !growing.expected.is_empty()
                    || name == "clones-or-signals"
            );
        }
    }
}

fn asked(guess: Guess, measure: &str) -> Lesson {
    let grow =
        format!("title: T\n[play] P\n[grow] G\nlink: croton-shrub?v=1&d=5\nmeasure: {measure}\n");
    let mut lesson = read(&grow).unwrap();
    lesson.steps[0].kind = Kind::Predict { ask: "=How, \"many\"?".into(), guess };
    lesson
}

#[test]
fn what_was_said_stands_and_is_told_beside_what_grew() {
    let lesson = asked(Guess::Bar { of: "yellow".into() }, "share F");
    let mut answers = Answers::default();
    assert_eq!(answers.beside(&lesson, 1), []);
    answers.say(0, Said::Number(60.0));
    answers.say(0, Said::Number(50.0));
    let usual = Usual { mean: 50.0, ends: [47.3, 52.7] };
    answers.grow(1, Grown { values: vec![48.2], usual: Some(usual) });
    assert_eq!(
        answers.beside(&lesson, 1),
        [
            ("You said", "60 in 100".to_string()),
            ("Grown", "48 in 100".to_string()),
            (
                "Expected",
                "50 in 100 in the mean; 95 in 100 individuals lie between 47 and 53".to_string()
            ),
        ]
    );
    answers.grow(1, Grown { values: vec![40.0, 60.0, 53.0], usual: None });
    assert_eq!(
        answers.beside(&lesson, 1)[1].1,
        "3 individuals: 51 in 100 in the mean, from 40 to 60"
    );
    assert_eq!(Answers::measured(&lesson, 1), "yellow cells, of 100 cells");
    assert_eq!(
        answers.to_csv(&lesson),
        "lesson,step,kind,question,said,grown,expected\n\
         \"T\",1,predict,\"'=How, \"\"many\"\"?\",\"60 in 100\",\"\",\"\"\n\
         \"T\",2,grow,\"yellow cells, of 100 cells\",\"\",\"3 individuals: 51 in 100 in the mean, from 40 to 60\",\"\"\n"
    );
    assert!(answers.to_text(&lesson).starts_with("T\n\n1. =How, \"many\"?\nYou said: 60 in 100\n"));
}

#[test]
fn a_choice_is_told_with_what_turns_out() {
    let choices = vec!["more".to_string(), "fewer".to_string()];
    let lesson = asked(Guess::Choice { choices, right: 1 }, "cells");
    let mut answers = Answers::default();
    answers.say(0, Said::Choice(0));
    answers.grow(1, Grown { values: vec![1234.0], usual: None });
    let beside = answers.beside(&lesson, 1);
    assert_eq!(beside[0], ("You said", "more".to_string()));
    assert_eq!(beside[1], ("It turns out", "fewer".to_string()));
    assert_eq!(beside[2], ("Grown", "1,234".to_string()));
}

#[test]
fn a_curve_is_told_day_by_day_beside_the_one_that_grew() {
    let guess = Guess::Sketch { of: "yellow".into(), days: vec![0, 5] };
    let lesson = asked(guess, "share F");
    assert_eq!(lesson.sketched_before(1), Some(&[0, 5][..]));
    let mut answers = Answers::default();
    answers.say(0, Said::Curve(vec![50.0, 80.0]));
    let usual = Usual { mean: 50.0, ends: [47.3, 52.7] };
    answers.grow(1, Grown { values: vec![49.6, 52.1], usual: Some(usual) });
    assert_eq!(
        answers.beside(&lesson, 1),
        [
            ("You said", "50 in 100 on day 0, 80 on day 5".to_string()),
            ("Grown", "50 in 100 on day 0, 52 on day 5".to_string()),
        ]
    );
    assert_eq!(asked(Guess::Bar { of: "a".into() }, "share F").sketched_before(1), None);
}

#[test]
fn the_example_of_the_documentation_is_a_lesson() {
    let page = include_str!("../../../docs/lessons.md");
    let first = page.split("\n## ").next().unwrap();
    let example: Vec<&str> = first
        .lines()
        .skip_while(|line| !line.starts_with("    title:"))
        .map(|line| line.strip_prefix("    ").unwrap_or(line))
        .collect();
    let lesson = read(&example.join("\n")).unwrap();
    let words: Vec<&str> = lesson.steps.iter().map(Step::word).collect();
    assert_eq!(words, ["look", "predict", "grow", "explain"]);
    // Each measure that it explains is one.
    let table = page.split("| measure | what it is |").nth(1).unwrap();
    for line in table.lines().skip(2).take_while(|line| line.starts_with('|')) {
        let word = line.trim_start_matches("| `").split('`').next().unwrap();
        assert!(Measure::of_words(word).is_some(), "{word}");
    }
}
