//! Several plants side by side: a nursery, a number in steps, two plants.

use crate::engines::Graphics;
use crate::page::Page;
use clonal_mosaic::export::{Grown, nursery};
use clonal_mosaic::plants;
use clonal_mosaic::play::{link, words};
use clonal_mosaic::tissue::Progress;
use std::sync::Arc;

/// A picture of a series as it grows natively.
fn natively(link: &str) -> Grown {
    let scene = link::read(link, plants::all()).scene;
    let mesh = Arc::new(scene.plant.embedded_body().surface);
    let mut growth = scene.plant.sow(mesh, scene.recipe.clone(), scene.individual).unwrap();
    while growth.step() != Progress::Day(scene.day) {}
    let count = growth.diary.count(scene.day as usize);
    Grown { scene, count }
}

/// The texts of an element of each picture.
fn texts(page: &Page, what: &str) -> Vec<String> {
    let script = format!(
        "return [...document.querySelectorAll('#figure-list .picture {what}')].map(e => e.textContent)"
    );
    serde_json::from_value(page.run(&script)).expect("texts")
}

fn wait_for_pictures(page: &Page, count: usize) {
    page.wait_for(
        "the pictures",
        &format!(
            "return document.querySelectorAll('#figure-list .picture[data-live]').length === {count}
                 && document.documentElement.dataset.state === 'ready'"
        ),
    );
}

#[test]
fn a_nursery_grows_its_individuals_and_tells_what_they_come_to() {
    let Some(page) = Page::open(Graphics::Neither, "#mushroom?v=1&d=1") else { return };
    page.run("location.hash = '#nursery/mushroom?v=1&d=2&s=3..6'");
    page.wait_for(
        "the view",
        "return document.documentElement.dataset.view === 'nursery' && document.title.startsWith('Nursery')",
    );
    let links = [3, 4, 5, 6].map(|n| format!("mushroom?v=1&s={n}&d=2"));
    let all: Vec<Grown> = links.iter().map(|link| natively(link)).collect();
    let (_, told) = nursery(&all).expect("a chart");
    page.wait_for(
        "the sum",
        &format!(
            "return document.querySelector('.summary .told')?.textContent === {}",
            serde_json::to_string(&told).unwrap()
        ),
    );
    let expected = all.iter().map(|grown| {
        let shares = words::shares(grown.scene.plant, grown.count);
        format!("{} cells, {shares}", words::grouped(grown.count.cells))
    });
    assert_eq!(texts(&page, ".told"), expected.collect::<Vec<_>>());
    assert_eq!(texts(&page, ".label"), [3, 4, 5, 6].map(|n| format!("individual {n}")));
    assert_eq!(page.run("return document.querySelectorAll('.summary circle').length"), 4);
    assert_eq!(page.run("return document.querySelectorAll('.summary table tr').length"), 5);

    // All pictures have one clock, and each leads to its plant.
    page.run(
        "const day = document.querySelector('.days input');
         day.value = 0;
         day.dispatchEvent(new Event('input', {bubbles: true}))",
    );
    page.wait_for(
        "day 0",
        "return document.querySelector('.summary .told').textContent.includes('on day 0')",
    );
    // What turns one of them turns all, and the address, too: it opens with the same turn.
    page.run(
        "document.querySelector('#figure-list .picture').dispatchEvent(
             new KeyboardEvent('keydown', {key: 'ArrowLeft', bubbles: true}))",
    );
    let views = "return [...document.querySelectorAll('#figure-list .picture')].map(e =>
                     new URL(e.href).hash.split('view=')[1])";
    page.wait_for(
        "the address",
        "return /^#nursery\\/mushroom\\?v=1&d=2&s=3\\.\\.6&view=[^&]+$/.test(location.hash)",
    );
    let turned = page.run(views);
    assert_eq!(turned[0], turned[3]);
    let link = page.link();
    page.visit(&format!("#{link}"));
    page.wait_for(
        "the pictures",
        "return document.querySelectorAll('#figure-list .picture[data-count]').length === 4",
    );
    assert_eq!(page.run(views), turned);
    assert_eq!(page.link(), link);
    page.run("document.querySelectorAll('#figure-list .picture')[2].click()");
    let state = page.ready();
    assert_eq!((state.plant.as_str(), state.day.as_str()), ("mushroom", "2"));
    assert!(page.link().starts_with("mushroom?v=1&s=5&d=2&view="), "{}", page.link());
}

#[test]
fn the_dialog_makes_steps_and_compares() {
    let Some(page) = Page::open(Graphics::WebGpu, "#cactus?v=1&s=2&d=1&df=20") else { return };
    page.ready();
    page.click("series");
    page.wait_for("the dialog", "return document.getElementById('series-dialog')?.open === true");
    page.run(
        "const dialog = document.getElementById('series-dialog');
         const number = dialog.querySelector('.number');
         number.value = 'pf';
         number.dispatchEvent(new Event('change'));
         dialog.querySelector('.from').value = '0,1';
         dialog.querySelector('.to').value = '7';
         dialog.querySelector('[data-grow=steps]').click()",
    );
    let refused = page.run("return document.querySelector('#series-dialog .refusal').textContent");
    assert!(refused.as_str().unwrap().contains("from 0 to 1"), "{refused}");
    page.run(
        "const dialog = document.getElementById('series-dialog');
         dialog.querySelector('.to').value = '0.5';
         dialog.querySelector('[data-grow=steps]').click()",
    );
    wait_for_pictures(&page, 5);
    assert_eq!(
        page.run("return location.hash"),
        "#steps/cactus?v=1&s=2&d=1&df=20&pf=0.1,0.2,0.3,0.4,0.5"
    );
    page.wait_for("the curve", "return document.querySelectorAll('.summary circle').length === 5");

    page.run("history.back()");
    page.ready();
    page.click("series");
    page.run("document.querySelector('#series-dialog [data-grow=compare]').click()");
    wait_for_pictures(&page, 2);
    let hash = page.run("return location.hash");
    assert!(hash.as_str().unwrap().starts_with("#compare/cactus?v=1&s=2&d=1&df=20/cactus?v=1"));
    let labels = texts(&page, ".label");
    assert!(labels[0].ends_with("20") && labels[0] != labels[1], "{labels:?}");
}

#[test]
fn two_numbers_make_a_map_that_leads_closer() {
    let Some(page) = Page::open(Graphics::Neither, "#mushroom?v=1&s=2&d=1") else { return };
    page.ready();
    // All pictures have grown, and stand in rows and columns.
    let has_grown =
        "return document.querySelectorAll('#figure-list .picture[data-count]').length === 9
        && !!document.querySelector('#figure-list .axes')";
    page.click("series");
    page.wait_for("the dialog", "return document.getElementById('series-dialog')?.open === true");
    page.run(
        "const dialog = document.getElementById('series-dialog');
         const choose = (field, value) => {
             const element = dialog.querySelector(field);
             element.value = value;
             element.dispatchEvent(new Event('change', {bubbles: true}));
         };
         choose('.number', 'pf');
         choose('.and .number', 'df');
         choose('.from', '0.2'); choose('.to', '0.6');
         choose('.and .from', '4'); choose('.and .to', '12'); choose('.and .count', '9');
         dialog.querySelector('.each').value = '3';
         dialog.querySelector('[data-grow=steps]').click()",
    );
    let refused = page.run("return document.querySelector('#series-dialog .refusal').textContent");
    assert!(refused.as_str().unwrap().contains("These are 135 pictures"), "{refused}");
    // A smaller one than the dialog makes is sooner there.
    let map = "#steps/mushroom?v=1&s=2&d=1&pf=0.2,0.4,0.6&df=4,7,10";
    page.visit(map);

    // Three rows of three, the first number across and the second one down.
    page.wait_for("the map", has_grown);
    let places = "const all = [...document.querySelectorAll('#figure-list .picture')];
        const box = k => all[k].getBoundingClientRect();
        return [box(0).top === box(2).top, box(3).top > box(2).bottom - 1, box(3).left === box(0).left,
            all[1].href.includes('pf=0.4'), all[3].href.includes('df=7')]";
    assert_eq!(page.run(places), serde_json::json!([true, true, true, true, true]));
    let axes = page.run("return document.querySelector('#figure-list .axes').textContent");
    assert!(axes.as_str().unwrap().contains("0.2 to 0.6. Down: "), "{axes}");
    page.wait_for(
        "the curves",
        "return document.querySelectorAll('.summary table tr').length === 4",
    );
    let told = page.run("return document.querySelector('.summary .told').textContent");
    assert!(told.as_str().unwrap().contains("cells are fewest"), "{told}");

    // By the keyboard: the button, then a picture.
    page.run("document.querySelector('#figure-list .closer').focus()");
    page.press(&[" "]);
    let pressed =
        "return document.querySelector('#figure-list .closer').getAttribute('aria-pressed')";
    assert_eq!(page.run(pressed), "true");
    page.run("document.querySelectorAll('#figure-list .picture')[4].focus()");
    page.press(&["\u{e007}"]);
    page.wait_for("the values around it", "return location.hash.includes('pf=0.3,0.4,0.5')");
    assert!(page.link().ends_with("df=5.5,7,8.5"), "{}", page.link());
    page.wait_for("the map", has_grown);
    page.run("document.querySelector('#figure-list .wider').click()");
    page.wait_for("what was before", &format!("return location.hash === '{map}'"));
    page.wait_for("the map", has_grown);

    // Without the button a picture leads to its plant.
    page.run("document.querySelector('#figure-list .closer').click()");
    page.run("document.querySelectorAll('#figure-list .picture')[0].click()");
    let state = page.ready();
    assert_eq!(state.plant, "mushroom");
    assert_eq!(page.link(), "mushroom?v=1&s=2&d=1&pf=0.2&df=4");
    assert_eq!(page.complaints(), [""; 0]);
}

#[test]
fn two_plants_have_one_camera_and_get_a_third_beside_them() {
    let Some(page) = Page::open(Graphics::WebGpu, "#mushroom?v=1&s=2&d=1") else { return };
    page.ready();
    page.run(
        "const field = document.querySelector('.parameter:has(#parameter-df) [inputmode]');
         field.value = '9';
         field.dispatchEvent(new Event('change', {bubbles: true}))",
    );
    page.wait_for("the change", "return location.hash.includes('df=9')");
    page.ready();
    page.click("turn-left");
    page.wait_for("the turn", "return location.hash.includes('view=')");
    page.click("series");
    page.wait_for("the dialog", "return document.getElementById('series-dialog')?.open === true");
    page.run(
        "const dialog = document.getElementById('series-dialog');
         dialog.querySelector('.other').value = 'before';
         dialog.querySelector('[data-grow=compare]').click()",
    );
    wait_for_pictures(&page, 2);
    let links = || -> Vec<String> {
        let script = "return [...document.querySelectorAll('#figure-list .picture')].map(e => e.href.split('#')[1])";
        serde_json::from_value(page.run(script)).expect("links")
    };
    let view = |link: &str| link.split("view=").nth(1).unwrap_or_default().to_string();
    let before = links();
    assert!(before[0].contains("df=9") && !before[1].contains("df="), "{before:?}");
    assert_eq!(view(&before[0]), view(&before[1]));

    // A hand on one of them turns both, and leads nowhere.
    page.drag("#figure-list .picture:last-child canvas", 120, 20);
    wait_for_pictures(&page, 2);
    page.wait_for(
        "the links",
        &format!("return !document.querySelector('.picture').href.endsWith('{}')", before[0]),
    );
    let turned = links();
    assert_eq!(view(&turned[0]), view(&turned[1]));
    assert_ne!(view(&turned[0]), view(&before[0]));
    assert!(page.link().starts_with("compare/"), "{}", page.link());
    // So does a button, for who cannot drag.
    page.wait_for("the buttons", "return !!document.querySelector('.looks [data-key=ArrowLeft]')");
    page.run("document.querySelector('.looks [data-key=ArrowLeft]').click()");
    page.wait_for(
        "a turn",
        &format!("return !document.querySelector('.picture').href.endsWith('{}')", turned[0]),
    );

    page.run(
        "const form = document.querySelector('.one-more');
         form.querySelector('.number').value = 'n';
         form.querySelector('.value').value = 'x';
         form.requestSubmit()",
    );
    let told = page.run("return document.querySelector('.one-more .refusal').textContent");
    assert!(told.as_str().unwrap().ends_with("that is no number."), "{told}");
    page.run("const form = document.querySelector('.one-more'); form.querySelector('.value').value = '4000'; form.requestSubmit()");
    wait_for_pictures(&page, 3);
    let three = links();
    assert!(three[2].contains("n=4000") && !three[1].contains("n="), "{three:?}");
    assert_eq!(page.complaints(), [""; 0]);
}

#[test]
fn a_figure_opens_as_plants_that_can_be_compared() {
    let Some(page) = Page::open(Graphics::Neither, "#figures/4.15") else { return };
    page.wait_for("the row", "return !!document.querySelector('[id=\"figure-4.15\"] .more')");
    page.run("document.querySelector('[id=\"figure-4.15\"] .more').click()");
    page.wait_for("its plants", "return document.documentElement.dataset.view === 'compare'");
    let count = page.run("return document.querySelectorAll('#figure-list .picture').length");
    let figure = clonal_mosaic::play::figures::find("4.15").unwrap();
    assert_eq!(count, figure.pictures.len());
    page.wait_for("one more", "return !!document.querySelector('.one-more')");
}
