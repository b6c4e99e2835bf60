//! Every view by the rules of axe-core (Deque, WCAG 2.2 A and AA), which finds nothing.

use crate::engines::{Graphics, is_left_out};
use crate::page::{Page, skip};
use std::path::Path;

/// What axe says of what is seen now: a line for each rule that is broken.
fn broken(page: &Page) -> Vec<String> {
    let told = page.run(
        "return axe.run(document, {runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice']})
             .then(found => found.violations.map(rule =>
                 rule.id + ': ' + rule.help + ': ' + rule.nodes.map(node => node.html.slice(0, 120)).join(' | ')))",
    );
    serde_json::from_value(told).expect("lines")
}

#[test]
fn no_view_breaks_a_rule() {
    let axe = Path::new(env!("CARGO_MANIFEST_DIR")).join(".tools/node_modules/axe-core/axe.min.js");
    let script = match std::fs::read_to_string(&axe) {
        Ok(script) => script,
        Err(_) if is_left_out("axe-core") => return skip("axe-core could not be installed here"),
        Err(_) if std::env::var("BROWSER_TESTS").is_ok_and(|wanted| wanted == "required") => {
            panic!("{} is missing: ./playground test installs it", axe.display())
        }
        Err(_) => return skip("axe-core is not installed: ./playground test does it"),
    };
    let Some(page) = Page::start(Graphics::Neither) else { return };
    page.before_pages(&script);
    let all_rules = |view: &str| {
        let broken = broken(&page);
        assert!(broken.is_empty(), "{view}:\n{}", broken.join("\n"));
    };
    page.visit("#watermelon?v=1&s=2&d=3");
    page.on_day(3);
    all_rules("the plant");
    page.run("document.querySelectorAll('details').forEach(details => { details.open = true })");
    all_rules("the recipe");
    page.click("help");
    all_rules("the keys");
    page.run("document.getElementById('tour').click()");
    page.wait_for("the tour", "return !!document.querySelector('#tour-card:not([hidden])')");
    all_rules("the tour");
    page.run("document.querySelector('#tour-card [data-by=\"0\"]').click()");
    page.click("charts");
    page.wait_for(
        "the charts",
        "return document.querySelectorAll('#charts-view .chart').length === 5",
    );
    all_rules("the charts");
    page.run("document.querySelector('#charts-view .close').click()");
    page.click("take-away");
    page.wait_for("the studio", "return document.getElementById('take-away-dialog').open");
    all_rules("what is taken away");
    page.run("document.getElementById('take-away-dialog').close()");
    page.click("bring-in");
    page.wait_for("the dialog", "return document.getElementById('bring-in-dialog').open");
    page.run("document.querySelector('#bring-in-dialog .found').hidden = false");
    all_rules("what is brought in");
    page.run("document.getElementById('bring-in-dialog').close()");
    page.click("fit");
    page.wait_for("the dialog", "return document.getElementById('fit-dialog').open");
    page.run("document.querySelectorAll('#fit-dialog [hidden]').forEach(part => { part.hidden = false })");
    all_rules("what numbers are looked for");
    page.run("document.getElementById('fit-dialog').close()");
    page.click("shape");
    page.wait_for("the dialog", "return document.getElementById('shape-dialog').open");
    page.run("document.querySelectorAll('#shape-dialog [hidden]').forEach(part => { part.hidden = false })");
    page.run(
        "document.querySelectorAll('#shape-dialog details').forEach(part => { part.open = true })",
    );
    all_rules("bodies by rule");
    page.run("document.getElementById('shape-dialog').close()");
    page.click("series");
    page.wait_for("the dialog", "return document.getElementById('series-dialog').open");
    all_rules("what is asked side by side");
    page.run("document.getElementById('series-dialog').close()");
    for view in ["nursery/mushroom?v=1&d=1&s=1..3", "compare/mushroom?v=1&d=1/cactus?v=1&d=1"] {
        page.run(&format!("location.hash = '#{view}'"));
        let key = view.split('/').next().unwrap();
        page.wait_for(key, &format!("return document.documentElement.dataset.view === '{key}'"));
        all_rules(key);
    }
    page.run("location.hash = '#watermelon?v=1&s=2&d=3'");
    page.wait_for("the plant", "return document.documentElement.dataset.view === 'plant'");
    page.click("class");
    page.run("document.querySelector('#class-dialog details').open = true");
    all_rules("what is for a class");
    page.run("document.getElementById('class-dialog').close()");
    for (beside, view) in [
        ("present", "presenter"),
        ("simple", "simple"),
        ("class/only=simple,recipe,hide=pf", "class"),
    ] {
        page.run(&format!("location.hash = '#watermelon?v=1&s=2&d=3~{beside}'"));
        page.wait_for(view, &format!("return document.documentElement.dataset.view === '{view}'"));
        all_rules(view);
    }
    page.run("location.hash = 'watermelon?v=1&s=2&d=3~lesson'");
    page.wait_for(
        "the lessons",
        "return document.querySelectorAll('#lesson-view .lessons li').length === 8",
    );
    all_rules("the lessons");
    for step in 1..=7 {
        page.run(&format!("location.hash = 'watermelon?v=1&s=2&d=3~lesson/who-wins/{step}'"));
        page.wait_for(
            "a step",
            &format!("return document.querySelector('#lesson-view .where').textContent.includes('step {step} ')"),
        );
        all_rules("a step of a lesson");
    }
    page.run("location.hash = '#figures/4.8'");
    page.wait_for("the figures", "return document.querySelector('.figure') !== null");
    all_rules("the figures");
}
