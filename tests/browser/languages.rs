//! The page in other languages: chosen by address, control or browser, and no text of it left in English.

use crate::engines::Graphics;
use crate::page::Page;
use serde_json::json;
use std::collections::BTreeSet;

/// Opens what has texts, one after the other, and gives all that stands in the document then: texts and what is
/// read of attributes, but for what says itself that it is no text of the page.
const TEXTS: &str = "
    const foreign = 'script, style, noscript, code, textarea, kbd, [translate=no], body [lang], [hidden]';
    const texts = [];
    const walk = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT | NodeFilter.SHOW_ELEMENT);
    for (let node = walk.nextNode(); node; node = walk.nextNode()) {
        const element = node.nodeType === 1 ? node : node.parentElement;
        if (element.closest(foreign)) continue;
        const told = node.nodeType === 1
            ? ['aria-label', 'title', 'placeholder', 'aria-valuetext'].map(name => node.getAttribute(name))
            : [node.data];
        texts.push(...told.filter(text => text && /[a-z]{2}/.test(text)).map(text => text.trim()));
    }
    return texts";

/// What may read the same in two languages: names, units, formats, keys.
fn may_be_the_same(text: &str) -> bool {
    let words = text.split(|c: char| !c.is_alphabetic()).filter(|word| word.len() > 1);
    words.clone().count() <= 1 || text.contains("://") || text.contains("Clonal Mosaic")
}

fn texts(page: &Page) -> BTreeSet<String> {
    let texts = page.run(TEXTS);
    let texts = texts.as_array().expect("texts").iter();
    texts.map(|text| text.as_str().unwrap_or_default().to_string()).collect()
}

/// All that is read on a walk through the page.
fn walked(language: &str) -> Option<BTreeSet<String>> {
    let page = Page::start(Graphics::Neither)?;
    let spoken = || {
        page.wait_for(
            "the language",
            &format!(
                "const root = document.documentElement;
                 return root.lang === '{language}' && ('{language}' === 'en' || root.dataset.language === '{language}')"
            ),
        );
    };
    let mut read = BTreeSet::new();
    page.visit(&format!("?lang={language}#croton?v=2&s=7&d=2&days=4"));
    page.on_day(2);
    spoken();
    page.run("document.querySelectorAll('details').forEach(d => d.open = true)");
    read.append(&mut texts(&page));
    for (door, there) in [
        ("take-away", "#take-away-dialog[open]"),
        ("bring-in", "#bring-in-dialog[open]"),
        ("series", "#series-dialog[open]"),
        ("fit", "#fit-dialog[open]"),
        ("class", "#class-dialog[open]"),
        ("charts", "#charts-view .chart"),
    ] {
        page.run(&format!("document.getElementById('{door}').click()"));
        page.wait_for(there, &format!("return document.querySelector('{there}') !== null"));
        read.append(&mut texts(&page));
        page.run("document.querySelectorAll('dialog[open]').forEach(d => d.close())");
    }
    page.run("location.hash = 'croton?v=2&s=7&d=2~simple'");
    page.wait_for("sliders", "return document.querySelector('.dial') !== null");
    read.append(&mut texts(&page));
    page.run("location.hash = 'croton-shrub?v=1&s=1&d=0&n=100&df=5&db=5&rs=0.6~lesson/doubling/3'");
    page.wait_for(
        "a question",
        "return document.querySelector('.guess:not([hidden]) input') !== null",
    );
    read.append(&mut texts(&page));
    page.run("location.hash = 'figures'");
    page.wait_for("figures", "return document.querySelectorAll('.figure').length > 5");
    read.append(&mut texts(&page));
    assert_eq!(page.complaints(), [""; 0]);
    Some(read)
}

#[test]
fn no_text_stays_english() {
    let Some(english) = walked("en") else { return };
    assert!(english.len() > 400, "{} texts are read", english.len());
    for language in ["pt", "es", "zh"] {
        let Some(told) = walked(language) else { return };
        let left: Vec<&String> =
            told.intersection(&english).filter(|text| !may_be_the_same(text)).collect();
        assert_eq!(left, [""; 0], "{language}");
    }
}

#[test]
fn a_language_is_chosen_and_stays_chosen() {
    let Some(page) = Page::open(Graphics::Neither, "#watermelon?v=1&s=1&d=4&lang=es") else {
        return;
    };
    let state = page.on_day(4);
    let name = |name: &str| {
        page.wait_for(
            name,
            &format!("return document.getElementById('name').textContent === '{name}'"),
        );
    };
    name("Sandía");
    assert!(!page.messages().contains("lang"), "{}", page.messages());
    // As the language writes numbers, and its plurals.
    let cells: u32 = state.cells.parse().unwrap();
    let grouped = page
        .run(&format!("return new Intl.NumberFormat('es', {{useGrouping: true}}).format({cells})"));
    assert_eq!(json!(page.text("fact-cells")), grouped);
    let choose = |language: &str| {
        page.run(&format!(
            "const select = document.getElementById('language');
             select.value = '{language}';
             select.dispatchEvent(new Event('change'))"
        ));
    };
    choose("zh");
    name("西瓜");
    assert_eq!(page.state().fingerprint, state.fingerprint, "the same cells in all languages");
    // What the page writes from then on, too, and what it has written is not written again.
    page.click("on");
    page.on_day(5);
    page.wait_for(
        "the day",
        "return document.title.includes('5') && !document.title.includes('day')",
    );
    choose("en");
    name("Watermelon");
    page.wait_for(
        "English",
        "return document.getElementById('copy-link').textContent === 'Copy link'",
    );
    choose("pt");
    name("Melancia");
    page.run("location.reload()");
    page.on_day(5);
    name("Melancia");
    assert_eq!(page.run("return document.documentElement.lang"), json!("pt"));
    assert_eq!(page.complaints(), [""; 0]);
}
