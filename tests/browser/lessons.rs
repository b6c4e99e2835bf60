//! Lessons: every one from its first step to its last, with predictions that stand, and one from a file.

use crate::engines::Graphics;
use crate::page::{Page, keys};
use clonal_mosaic::play::lesson::{Guess, Kind, LESSONS, Lesson, read};
use std::path::Path;

fn text_of(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("www/lessons");
    std::fs::read_to_string(folder.join(format!("{name}.txt"))).unwrap()
}

fn lesson(name: &str) -> Lesson {
    read(&text_of(name)).unwrap()
}

/// What an element of the lesson says.
fn told(page: &Page, css: &str) -> String {
    let script = format!("return document.querySelector('#lesson-view {css}').innerText");
    page.run(&script).as_str().unwrap_or_default().to_string()
}

fn on_step(page: &Page, lesson: &Lesson, step: usize) {
    let title = serde_json::to_string(&lesson.steps[step].title).unwrap();
    page.wait_for(
        &format!("step {} of {}", step + 1, lesson.title),
        &format!(
            "const view = document.getElementById('lesson-view');
             return !!view && !view.hidden && location.hash.endsWith('/{}')
                 && document.getElementById('lesson-title').textContent === {title}",
            step + 1
        ),
    );
}

fn press_next(page: &Page) {
    page.run("document.querySelector('#lesson-view .next').click()");
}

fn may_go_on(page: &Page) -> bool {
    page.run("return !document.querySelector('#lesson-view .next').disabled") == true
}

fn has_grown(page: &Page) {
    let grown = "return document.documentElement.dataset.state === 'ready'
                     && !!document.querySelector('#lesson-view .result dl')";
    page.wait_for("what has grown", grown);
}

/// Says something by the keyboard alone: the title has the focus.
fn predict(page: &Page, guess: &Guess) -> String {
    assert!(!may_go_on(page), "nothing is said yet");
    match guess {
        Guess::Choice { choices, .. } => {
            page.press(&[keys::TAB, keys::SPACE, keys::DOWN, keys::TAB, keys::ENTER]);
            choices[1].clone()
        }
        Guess::Bar { .. } => {
            let steps = [keys::RIGHT; 5];
            page.press(&[keys::TAB, keys::HOME]);
            page.press(&steps);
            page.press(&[keys::TAB, keys::ENTER]);
            "5 in 100".to_string()
        }
        Guess::Sketch { days, .. } => {
            for _ in days {
                page.press(&[keys::TAB, keys::HOME, keys::UP, keys::UP]);
            }
            page.press(&[keys::TAB, keys::ENTER]);
            let points = days.iter().map(|day| format!("2 on day {day}"));
            points.collect::<Vec<_>>().join(", ").replacen("2", "2 in 100", 1)
        }
        Guess::Number { of } => {
            page.press(&[keys::TAB, "1", "2", "0", "0", keys::ENTER]);
            format!("1,200 {of}")
        }
    }
}

/// Goes through a lesson from its first step to its last.
fn go_through(page: &Page, name: &str) {
    let lesson = lesson(name);
    let mut said = String::new();
    for (k, step) in lesson.steps.iter().enumerate() {
        on_step(page, &lesson, k);
        match &step.kind {
            Kind::Predict { guess, .. } => {
                said = predict(page, guess);
                page.wait_for(
                    "what was said",
                    "return !document.querySelector('#lesson-view .next').disabled",
                );
                assert!(told(page, ".guess .said").contains(&said), "{said}");
                let input = "return [...document.querySelectorAll('.ways input')].every(i => i.matches(':disabled'))";
                assert!(page.run(input) == true, "what was said stands");
            }
            Kind::Grow(growing) => {
                has_grown(page);
                let result = told(page, ".result");
                assert!(said.is_empty() || result.contains(&said), "{said}: {result}");
                assert_eq!(growing.measure.is_some(), result.contains("Grown"), "{result}");
            }
            Kind::Explain { students } => {
                let count =
                    page.run("return document.querySelectorAll('.students details').length");
                assert_eq!(count, students.len());
            }
            Kind::Look | Kind::Play => {}
        }
        if k + 1 < lesson.steps.len() {
            press_next(page);
        }
    }
}

#[test]
fn lessons_are_gone_through_by_the_keyboard() {
    let Some(page) = Page::open(Graphics::Neither, "#croton-shrub?v=1&d=1&n=100") else { return };
    page.ready();
    page.click("lessons");
    page.wait_for(
        "the list",
        &format!(
            "return document.querySelectorAll('#lesson-view .lessons li').length === {}",
            LESSONS.len()
        ),
    );
    assert_eq!(page.run("return document.documentElement.dataset.view"), "lesson");
    // A number, a curve, and choices.
    page.run("document.querySelector('[data-lesson-name=doubling]').click()");
    go_through(&page, "doubling");
    assert!(told(&page, ".take").contains("Copy my answers"));
    // What was said before still stands.
    page.run("location.hash = location.hash.replace(/[0-9]+$/, 3)");
    on_step(&page, &lesson("doubling"), 2);
    assert!(told(&page, ".guess .said").contains("1,200 cells"));
    assert!(may_go_on(&page));
    // On paper stand the steps, what was said, and no controls.
    let sheet = page.run("return document.getElementById('lesson-sheet').textContent");
    assert!(sheet.as_str().unwrap().contains("I said 1,200 cells."), "{sheet}");
    page.devtools("Emulation.setEmulatedMedia", serde_json::json!({ "media": "print" }));
    let seen = "const seen = id => document.getElementById(id).checkVisibility();
                return [seen('lesson-sheet'), seen('lesson-view'), seen('panel')]";
    assert_eq!(page.run(seen), serde_json::json!([true, false, false]));
    page.devtools("Emulation.setEmulatedMedia", serde_json::json!({ "media": "" }));
    for name in ["who-wins", "families"] {
        page.run(&format!("location.hash = 'croton-shrub?v=1&d=0~lesson/{name}/1'"));
        on_step(&page, &lesson(name), 0);
        page.run("document.getElementById('lesson-title').focus()");
        go_through(&page, name);
    }
    page.run("document.querySelector('#lesson-view .close').click()");
    page.wait_for("the plant", "return document.documentElement.dataset.view === 'plant'");
    assert!(!page.link().contains('~'), "{}", page.link());
    assert_eq!(page.run("return document.activeElement.id"), "lessons");
    assert_eq!(page.complaints(), [""; 0]);
}

#[test]
fn every_lesson_opens_and_all_its_steps_do() {
    let Some(page) = Page::open(Graphics::Neither, "#~lesson/chance") else { return };
    // An address without a plant shows that of the step.
    on_step(&page, &lesson("chance"), 0);
    page.wait("the plant of the step", |s| s.plant == "croton-shrub" && s.day == "25");
    for name in LESSONS {
        let lesson = lesson(name);
        for step in 0..lesson.steps.len() {
            page.run(&format!(
                "location.hash = 'croton-shrub?v=1&d=0&n=50&rs=0.5~lesson/{name}/{}'",
                step + 1
            ));
            on_step(&page, &lesson, step);
            assert_eq!(
                told(&page, ".where"),
                format!("{} · step {} of {}", lesson.title, step + 1, lesson.steps.len())
            );
            assert_eq!(may_go_on(&page), !matches!(lesson.steps[step].kind, Kind::Predict { .. }));
        }
    }
    page.run("location.hash = '~lesson/no-such'");
    page.wait_for(
        "a word",
        "return document.querySelector('#lesson-view .own .refusal').textContent !== ''",
    );
    assert!(!page.messages().contains("left out"), "{}", page.messages());
    assert_eq!(page.complaints(), [""; 0]);
}

#[test]
fn a_lesson_is_opened_from_a_file_or_refused_in_words() {
    let Some(page) = Page::open(Graphics::Neither, "#croton-shrub?v=1&d=1&n=100~lesson") else {
        return;
    };
    page.wait_for(
        "the list",
        "return !!document.querySelector('#lesson-view:not([hidden]) .own input')",
    );
    let choose = |text: &str| {
        let text = serde_json::to_string(text).unwrap();
        page.run(&format!(
            "const data = new DataTransfer();
             data.items.add(new File([{text}], 'mine.txt'));
             const input = document.querySelector('#lesson-view .own input');
             input.files = data.files;
             input.dispatchEvent(new Event('change', {{bubbles: true}}))"
        ));
    };
    choose("title: Mine\n[look] Here\nlonk: croton\n");
    page.wait_for("a word", "return document.querySelector('.own .refusal').textContent !== ''");
    assert_eq!(
        told(&page, ".own .refusal"),
        "mine.txt: Line 3: \"lonk\" is unknown here; there are link alone."
    );
    let mine = "title: <b>Mine</b>\n[look] Here & now\nlink: watermelon?v=1&d=0\nA <i>text</i>.\n";
    choose(mine);
    on_step(&page, &read(mine).unwrap(), 0);
    assert_eq!(told(&page, ".text p:last-child"), "A <i>text</i>.");
    page.wait("its plant", |s| s.plant == "watermelon" && s.state == "ready");
    assert_eq!(page.complaints(), [""; 0]);
}
