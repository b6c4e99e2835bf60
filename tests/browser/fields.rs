//! What is typed, and keys where the focus is: nothing is taken for something else in silence.

use crate::engines::Graphics;
use crate::page::{Page, keys};

const SOON: &str = "#watermelon?v=1&s=1&d=4";

/// The field of a number of the recipe, given an id.
fn field(page: &Page, key: &str) -> String {
    page.run(&format!(
        "document.querySelector('details.recipe').open = true;
         const row = document.getElementById('parameter-{key}').closest('.parameter');
         row.querySelector('input[inputmode]').id = 'typed-{key}';
         row.querySelector('.refusal').id = 'refused-{key}';
         row.querySelector('.remark').id = 'remark-{key}'"
    ));
    format!("typed-{key}")
}

fn value(page: &Page, id: &str) -> String {
    let value = page.run(&format!("return document.getElementById('{id}').value"));
    value.as_str().unwrap_or_default().to_string()
}

#[test]
fn a_decimal_comma_is_understood_and_what_is_refused_stays() {
    let Some(page) = Page::open(Graphics::Neither, SOON) else { return };
    page.on_day(4);
    let days = field(&page, "df");
    page.fill_in(&days, "6,5");
    page.wait_for("six and a half", "return location.hash.endsWith('df=6.5')");
    assert_eq!(value(&page, &days), "6.5");
    page.fill_in(&days, "6,5,1");
    assert!(page.text("refused-df").starts_with("Not taken"), "{}", page.text("refused-df"));
    assert_eq!(value(&page, &days), "6,5,1", "to be corrected");
    page.fill_in(&days, "6");
    page.wait_for("six", "return location.hash.endsWith('df=6')");
    assert_eq!((value(&page, &days).as_str(), page.text("refused-df").as_str()), ("6", ""));

    for text in ["99", "-5", "7.5"] {
        page.fill_in("day-number", text);
        let told = page.text("day-refusal");
        assert!(told.ends_with("a whole number from 0 to 20."), "{text}: {told}");
        assert_eq!(value(&page, "day-number"), text);
        assert!(page.link().contains("d=4"), "{}", page.link());
    }
    page.fill_in("day-number", "7");
    page.on_day(7);
    assert_eq!(page.text("day-refusal"), "");
}

#[test]
fn undo_in_a_field_is_that_of_the_page_once_the_number_counts() {
    let Some(page) = Page::open(Graphics::Neither, SOON) else { return };
    page.on_day(4);
    page.fill_in("individual", "7");
    page.wait("the typed one", |s| s.individual == "7" && s.state == "ready");
    let undo = "const e = new KeyboardEvent('keydown', {key: 'z', ctrlKey: true, bubbles: true, cancelable: true});
                return !document.activeElement.dispatchEvent(e)";
    assert_eq!(page.run("return document.activeElement.id"), "individual");
    assert_eq!(page.run(undo), true, "the browser's own is kept out");
    page.wait("the one before", |s| s.individual == "1" && s.state == "ready");
    assert_eq!(value(&page, "individual"), "1");
    // While something is being typed, it is the browser's.
    page.press(&["5"]);
    assert_eq!(page.run(undo), false);
    assert_eq!(page.ready().individual, "1");
}

#[test]
fn keys_work_after_the_time_line_was_dragged() {
    let Some(page) = Page::open(Graphics::Neither, SOON) else { return };
    page.on_day(4);
    page.run("document.getElementById('day').focus()");
    page.press(&[keys::SPACE]);
    page.wait_for("play", "return document.getElementById('play').hasAttribute('data-playing')");
    page.press(&[keys::SPACE]);
    let day: u32 = page.ready().day.parse().unwrap();
    page.press(&["."]);
    page.on_day(day + 1);
    page.press(&["n"]);
    page.wait("another individual", |s| s.individual != "1" && s.state == "ready");
    page.press(&[keys::LEFT]);
    page.on_day(day);
}

#[test]
fn days_between_divisions_lie_by_ratio_and_a_moved_number_says_so() {
    let Some(page) = Page::open(Graphics::Neither, "#red-croton?v=1&s=1&d=1") else { return };
    page.on_day(1);
    field(&page, "pf");
    field(&page, "pm");
    let slider = "document.getElementById('parameter-df')";
    assert_eq!(page.run(&format!("return {slider}.ariaValueText")), "5 days");
    page.run(&format!("{slider}.focus()"));
    page.press(&[keys::RIGHT]);
    page.wait_for("the next round value", "return location.hash.includes('df=5.2')");
    assert_eq!(page.run(&format!("return {slider}.ariaValueText")), "5.2 days");
    let place = page.run(&format!("return {slider}.value / {slider}.max")).as_f64().unwrap();
    assert!((0.2..0.3).contains(&place), "{place}");

    page.fill_in("typed-pm", "0.7");
    page.fill_in("typed-pf", "0.7");
    page.wait_for("the change", "return location.hash.includes('pf=0.7')");
    assert!(page.text("remark-pf").contains("from 0.7 to 0.3"), "{}", page.text("remark-pf"));
    assert!(page.text("remark-pm").starts_with("Was 0.7"), "{}", page.text("remark-pm"));
    assert_eq!(page.text("source"), "after Thesis, 3.2.1.2, 3 changes");
}
