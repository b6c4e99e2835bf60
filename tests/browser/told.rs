//! What is told of the days: the strip under the time line, and words for who hears the page.

use crate::engines::Graphics;
use crate::page::Page;
use clonal_mosaic::export::{DayNumbers, Kind, Order, pattern_in_words};
use clonal_mosaic::plants;
use clonal_mosaic::play::link;
use clonal_mosaic::surface::Charts;
use clonal_mosaic::tissue::Progress;

#[test]
fn the_strip_shows_the_days_that_have_grown_and_marks_one() {
    let Some(page) = Page::open(Graphics::Neither, "#goeppertia?v=1&s=1&d=2&days=4") else {
        return;
    };
    page.on_day(2);
    let marked = |day: u32| {
        page.wait_for(
            "the mark",
            &format!(
                "return document.querySelector('#strip .now')?.getAttribute('d') === 'M{day} 0V1000'"
            ),
        );
    };
    marked(2);
    let whole = "const last = document.querySelector('#strip .number');
                 return last?.getAttribute('d').includes('L4 ')
                     && document.getElementById('strip').getAttribute('viewBox') === '0 0 4 1000'";
    page.wait_for("all days", whole);
    // Three colours, and two lines by number and by area.
    for (what, count) in [("[fill]", 3), (".number", 2), (".area:not(.rim)", 2)] {
        let script = format!("return document.querySelectorAll('#strip {what}').length");
        assert_eq!(page.run(&script), count, "{what}");
    }
    page.click("on");
    page.on_day(3);
    marked(3);
    // Its days stand below those of the slider.
    let apart = page.run(
        "const [line, strip] = ['grown', 'strip'].map(id => document.getElementById(id).getBoundingClientRect());
         return Math.abs(line.left - strip.left) + Math.abs(line.right - strip.right)",
    );
    assert!(apart.as_f64().unwrap() < 1.0, "{apart}");
    assert_eq!(page.complaints(), [""; 0]);
}

#[test]
fn each_act_is_told_by_what_it_changed() {
    let Some(page) = Page::open(Graphics::Neither, "#watermelon?v=1&s=1&d=4") else { return };
    page.on_day(4);
    let live = |begins: &str, has: &str| {
        page.wait_for(
            begins,
            &format!(
                "const told = document.getElementById('live').textContent;
                 return told.startsWith('{begins}') && told.includes('{has}')"
            ),
        );
    };
    live("Watermelon, individual 1, day 4: ", " families, the largest of ");
    assert_eq!(page.text("summary"), page.text("live"));
    page.click("on");
    live("Day 5: ", " than on day 4 (");
    assert!(page.text("summary").starts_with("Watermelon, individual 1, day 5: "));
    assert_eq!(
        page.run("return document.title"),
        "Watermelon, individual 1, day 5 · Clonal Mosaic"
    );
    page.fill_in("individual", "2");
    live("Individual 2, day 5: ", " green");
    page.click("turn-left");
    live("Seen from ", " degrees around");
    page.run("document.getElementById('undo').click(); document.getElementById('undo').click()");
    live("Individual 1, day 5: ", " cells");
}

/// The days of a link in numbers, natively.
fn numbers(link: &str) -> Vec<DayNumbers> {
    let scene = link::read(link, plants::all()).scene;
    let (order, mut growth) = Order::new(Kind::Days, &scene, scene.plant.embedded_body()).unwrap();
    while growth.step() != Progress::Done {}
    let mut charts = Charts::new(order.mesh());
    let days = 0..growth.diary.days.len();
    days.map(|day| order.numbers(&mut charts, &growth.diary, day)).collect()
}

#[test]
fn the_pattern_is_told_in_words_with_its_patches() {
    let Some(page) = Page::open(Graphics::Neither, "#mushroom?v=1&s=2&d=2") else { return };
    page.on_day(2);
    let days = numbers("mushroom?v=1&s=2&d=3");
    let plant = plants::find("mushroom").unwrap();
    let told = |day: usize, before: usize| {
        let text = pattern_in_words(plant, 0, &days[day], Some((&days[before], true)));
        page.wait_for(
            &text,
            &format!("return document.getElementById('in-words-told')?.textContent === {text:?}"),
        );
    };
    // The key, as it is said at the plant.
    page.run("document.getElementById('stage').focus()");
    page.press(&["s"]);
    told(2, 1);
    let described = "return document.getElementById('stage').getAttribute('aria-describedby')";
    assert_eq!(page.run(described), "summary in-words-told stage-keys");
    page.click("on");
    told(3, 2);
    // Said once more: taken away, and there again.
    page.run(
        "window.said = [];
         new MutationObserver(() => said.push(document.getElementById('in-words-told').textContent))
             .observe(document.getElementById('in-words-told'), {childList: true});
         document.querySelector('#words-view .again').click()",
    );
    page.wait_for("it once more", "return said.length === 2 && said[0] === '' && said[1] !== ''");
    page.run("document.querySelector('#words-view .close').click()");
    assert_eq!(page.run(described), "summary stage-keys");
    assert_eq!(page.complaints(), [""; 0]);
}
