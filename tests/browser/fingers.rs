//! Fingers: a swipe scrolls and changes nothing, a pull changes what it pulls.

use crate::engines::Graphics;
use crate::page::{Page, keys};
use serde_json::{Value, json};

/// A plant and a day that are there soon, on a phone.
fn on_a_phone(link: &str, width: u32, height: u32) -> Option<Page> {
    let page = Page::start(Graphics::WebGpu)?;
    page.devtools(
        "Emulation.setDeviceMetricsOverride",
        json!({ "width": width, "height": height, "deviceScaleFactor": 1, "mobile": true }),
    );
    page.devtools("Emulation.setTouchEmulationEnabled", json!({ "enabled": true }));
    page.visit(link);
    page.ready();
    Some(page)
}

/// Puts a finger down and takes it along a straight way, as fast as a finger is.
fn swipe(page: &Page, from: [f64; 2], by: [f64; 2]) {
    let touch = |kind: &str, points: Value| {
        page.devtools("Input.dispatchTouchEvent", json!({ "type": kind, "touchPoints": points }));
        std::thread::sleep(std::time::Duration::from_millis(16));
    };
    touch("touchStart", json!([{ "x": from[0], "y": from[1] }]));
    for k in 1..=10 {
        let at = |axis: usize| from[axis] + by[axis] * f64::from(k) / 10.0;
        touch("touchMove", json!([{ "x": at(0), "y": at(1) }]));
    }
    touch("touchEnd", json!([]));
}

/// Puts a finger down and lifts it until something has come of it: where the machine is slow, it may have
/// been down so long that it was no tap.
fn tap(page: &Page, css: &str, right_px: f64, has_come: &str) {
    for _ in 0..5 {
        let [x, y] = middle(page, css);
        let finger = json!([{ "x": x + right_px, "y": y }]);
        for (kind, points) in [("touchStart", finger), ("touchEnd", json!([]))] {
            let touch = json!({ "type": kind, "touchPoints": points });
            page.devtools("Input.dispatchTouchEvent", touch);
        }
        for _ in 0..40 {
            if page.run(has_come) == true {
                return;
            }
            std::thread::sleep(std::time::Duration::from_millis(50));
        }
    }
    panic!("nothing comes of a tap on {css}");
}

/// The middle of what a selector finds, which is brought into sight and lies still.
fn middle(page: &Page, css: &str) -> [f64; 2] {
    page.wait_for(
        "the sheet to lie still",
        "return document.getElementById('panel').getAnimations().length === 0",
    );
    let script = format!(
        "const e = document.querySelector('{css}');
         if (e.closest('.panel, .figures')) e.scrollIntoView({{block: 'center', behavior: 'instant'}});
         const b = e.getBoundingClientRect();
         return [b.left + b.width / 2, b.top + b.height / 2]"
    );
    serde_json::from_value(page.run(&script)).expect("two numbers")
}

#[test]
fn a_swipe_over_the_recipe_scrolls_and_changes_nothing() {
    let link = "#watermelon?v=1&s=1&d=2";
    let Some(page) = on_a_phone(link, 390, 844) else { return };
    page.run("document.querySelector('details.recipe').open = true; document.getElementById('sheet').click()");
    let heard = "window.heard = 0;
        document.getElementById('parameter-df').addEventListener('input', () => window.heard += 1)";
    page.run(heard);
    let from = middle(&page, "#parameter-df");
    let scrolled =
        || page.run("return document.getElementById('panel').scrollTop").as_i64().unwrap();
    let before = scrolled();
    // Far from the slider's hand, where the browser would set it at once.
    swipe(&page, [from[0] + 60.0, from[1]], [4.0, -120.0]);
    page.wait_for(
        "the sheet to scroll",
        &format!("return document.getElementById('panel').scrollTop > {before} + 40"),
    );
    let value = || page.run("return document.getElementById('parameter-df').value");
    let rest = value();
    assert_eq!(page.run("return window.heard"), json!(0), "nobody has heard of it");
    assert_eq!(page.link(), link.trim_start_matches('#'));

    // Along it and with a tap it is set.
    let from = middle(&page, "#parameter-df");
    swipe(&page, from, [70.0, 3.0]);
    page.wait_for("the slider to be pulled", "return location.hash.includes('df=')");
    assert_ne!(value(), rest);
    let pulled = page.link();
    tap(&page, "#parameter-db", 50.0, "return location.hash.includes('db=')");
    assert!(page.link().contains(pulled.split("df=").nth(1).unwrap().split('&').next().unwrap()));
}

#[test]
fn a_swipe_over_the_time_line_leaves_the_day() {
    let Some(page) = on_a_phone("#watermelon?v=1&s=1&d=4", 390, 844) else { return };
    let from = middle(&page, "#day");
    swipe(&page, [from[0] + 80.0, from[1]], [3.0, -90.0]);
    std::thread::sleep(std::time::Duration::from_millis(300));
    assert_eq!((page.ready().day.as_str(), page.link().as_str()), ("4", "watermelon?v=1&s=1&d=4"));
    swipe(&page, from, [60.0, 2.0]);
    page.wait("another day", |s| s.state == "ready" && s.day != "4");
}

#[test]
fn the_sheet_is_pulled_up_and_down() {
    let Some(page) = on_a_phone("#watermelon?v=1&s=1&d=2", 390, 844) else { return };
    let is_open = "return document.getElementById('panel').hasAttribute('data-open')";
    let handle = || middle(&page, "#sheet");
    assert_eq!(page.run(is_open), false);
    assert!(page.text("sheet").contains("recipe"), "it says what it holds");
    swipe(&page, handle(), [0.0, -150.0]);
    page.wait_for("the sheet to open", is_open);
    for fact in ["fact-cells", "fact-share", "fact-area"] {
        let seen = format!("return document.getElementById('{fact}').checkVisibility()");
        assert_eq!(page.run(&seen), true, "#{fact} stays in sight");
    }
    page.run("document.getElementById('panel').scrollTop = 300");
    swipe(&page, handle(), [0.0, 150.0]);
    page.wait_for(
        "the sheet to close",
        "return !document.getElementById('panel').hasAttribute('data-open')",
    );
    assert_eq!(page.run("return document.getElementById('panel').scrollTop"), 0);
    tap(&page, "#sheet", 0.0, is_open);
    // A pull is not taken for the key's click that comes after it.
    swipe(&page, handle(), [0.0, 150.0]);
    page.wait_for(
        "the sheet to close once more",
        "return !document.getElementById('panel').hasAttribute('data-open')",
    );
    page.run("document.getElementById('sheet').focus()");
    page.press(&[keys::ENTER]);
    page.wait_for("a key to open it", is_open);
}

#[test]
fn fingers_have_44_pixels_and_the_plant_has_room() {
    for (width, height) in [(390, 844), (700, 457), (844, 390), (600, 560)] {
        let Some(page) = on_a_phone("#watermelon?v=1&s=1&d=2", width, height) else { return };
        let stage = page.run("return document.getElementById('stage').clientHeight");
        assert!(stage.as_f64().unwrap() >= 150.0, "{stage} px at {width} by {height}");
        let small = page.run(
            "return [...document.querySelectorAll('.masthead :is(button, a), .timeline :is(button, input, select), #sheet, #another, #individual')]
                .filter(e => e.checkVisibility() && e.type !== 'checkbox')
                .filter(e => { const b = e.getBoundingClientRect(); return b.height < 43.5 || b.width < 43.5 })
                .map(e => e.id + ' ' + e.getBoundingClientRect().width + ' by ' + e.getBoundingClientRect().height)",
        );
        assert_eq!(small, json!([]), "at {width} by {height}");
        let widest = page.run("return document.documentElement.scrollWidth").as_i64().unwrap();
        assert!(widest <= i64::from(width), "{widest} of {width}");
    }
}
