//! Bodies by rule in the studio: their numbers answer at once, their pattern grows, and their link makes them again.

use crate::engines::Graphics;
use crate::page::Page;
use crate::studio::downloads;
use clonal_mosaic::import::Made;
use clonal_mosaic::plants;
use clonal_mosaic::play::link;
use clonal_mosaic::shapes::leaf::LeafNumbers;
use clonal_mosaic::tissue::Progress;
use std::sync::Arc;
use std::time::Duration;

/// The fingerprint of a link's day on a body by rule, grown natively.
fn native(words: &str, link: &str) -> (String, String) {
    let own = Made::of_words(words).unwrap().own().unwrap();
    let plant = plants::bring(&own.text).unwrap();
    let scene = link::read(link, plants::all()).scene;
    assert_eq!(scene.plant.key, plant.key, "{link}");
    let mesh = Arc::new(plant.grow_body(&own.text).unwrap().surface);
    let mut growth = plant.sow(mesh, scene.recipe, scene.individual).unwrap();
    while growth.step() != Progress::Day(scene.day) {}
    (own.key, growth.diary.fingerprint(scene.day as usize))
}

/// Waits until the body is drawn as the words say.
fn drawn(page: &Page, words: &str) {
    let drawn = "return document.getElementById('shape-dialog')?.dataset.drawn";
    page.wait_for(words, &format!("{drawn} === '{words}'"));
}

fn set(page: &Page, key: &str, value: &str) {
    page.run(&format!(
        "const kind = document.querySelector('#shape-dialog .kind').value;
         const field = document.querySelector(`[data-kind=${{kind}}] [data-key=\"{key}\"]`);
         field.value = '{value}';
         field.dispatchEvent(new Event('input', {{bubbles: true}}))"
    ));
}

fn choose_kind(page: &Page, kind: &str) {
    page.run(&format!(
        "const field = document.querySelector('#shape-dialog .kind');
         field.value = '{kind}';
         field.dispatchEvent(new Event('input', {{bubbles: true}}))"
    ));
}

/// Pixels of the body on which something is seen.
fn seen(page: &Page) -> f64 {
    let seen = "const canvas = document.querySelector('#shape-dialog canvas');
                const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
                let seen = 0;
                for (let k = 3; k < data.length; k += 4) seen += data[k] === 255;
                return seen";
    page.run(seen).as_f64().unwrap()
}

/// Has the pattern grow, and tells the key of the plant, which is a hash over all that makes it, body and recipe.
fn grow(page: &Page, words: &str) -> String {
    page.run("document.querySelector('#shape-dialog .grow').click()");
    page.wait_for("the link", &format!("return location.hash.endsWith('~{words}')"));
    page.link().split('?').next().unwrap().to_string()
}

/// The same, made natively.
fn key_of(words: &str) -> String {
    Made::of_words(words).unwrap().own().unwrap().key
}

/// The dialog over a lungwort, with a leaf in it.
fn open_dialog() -> Option<Page> {
    let page = Page::open(Graphics::WebGpu, "#lungwort?v=1&s=2&d=1")?;
    page.on_day(1);
    page.click("shape");
    drawn(&page, "leaf=");
    Some(page)
}

#[test]
fn a_leaf_answers_to_its_numbers_grows_and_comes_again_by_its_link() {
    let Some(page) = Page::open(Graphics::WebGpu, "#lungwort?v=1&s=2&d=1") else { return };
    page.on_day(1);
    let folder = downloads(&page, "shapes");
    page.click("shape");
    drawn(&page, "leaf=");
    let maple = seen(&page);
    assert!(maple > 20_000.0, "{maple} pixels of a maple's leaf");
    set(&page, "lobes", "1");
    drawn(&page, "leaf=lobes:1");
    assert!(seen(&page) < 0.8 * maple, "a leaf of one lobe is narrower");
    let took = ["4", "5", "7", "9", "6"].map(|nodes| {
        set(&page, "nodes", nodes);
        drawn(&page, &format!("leaf=lobes:1,nodes:{nodes}"));
        let took = page.run("return document.getElementById('shape-dialog')?.dataset.drawnMs");
        took.as_str().unwrap().parse::<f64>().unwrap()
    });
    println!("a bare leaf stands there after {took:?} ms");
    assert!(took.into_iter().fold(f64::MAX, f64::min) <= 100.0, "{took:?} ms");
    page.run("document.querySelector('#shape-dialog .back').click()");
    drawn(&page, "leaf=lobes:1");
    set(&page, "border", "smooth");
    set(&page, "on", "lungwort.1");
    let words = "leaf=lobes:1,border:smooth,on:lungwort.1";
    drawn(&page, words);

    // The numbers as a file are those of the same leaf.
    page.run("document.querySelector('#shape-dialog .numbers-file').click()");
    let file = folder.join("leaf.json");
    let json = (0..200).find_map(|_| {
        std::thread::sleep(Duration::from_millis(50));
        std::fs::read_to_string(&file).ok().filter(|json| json.ends_with("}\n"))
    });
    let made = Made::of_words(words).unwrap();
    let numbers = LeafNumbers::from_json(&json.expect("a file")).unwrap();
    let rule = clonal_mosaic::shapes::Rule {
        numbers: clonal_mosaic::shapes::Numbers::Leaf(numbers),
        individual: 1,
    };
    assert_eq!(rule.mesh().unwrap(), made.mesh().unwrap());

    grow(&page, words);
    let own = page.wait("its cells", |s| s.plant.starts_with("own-") && s.state == "ready");
    let address = page.link();
    let (key, fingerprint) = native(words, address.split('~').next().unwrap());
    assert_eq!((own.plant, own.fingerprint), (key.clone(), fingerprint.clone()));
    let text = page.run(&format!("return document.getElementById('meshes/{key}.txt').textContent"));
    assert_eq!(text, made.own().unwrap().text, "letter by letter what a shell makes");

    // On another machine, which has never seen it.
    page.visit("#cactus?v=1&s=1&d=0");
    page.on_day(0);
    assert!(page.run("return !document.getElementById('shape-dialog')") == true);
    page.run(&format!("location.hash = '#{address}'"));
    let again = page.wait("the same body", |s| s.plant == key && s.state == "ready");
    assert_eq!((again.fingerprint, page.link()), (fingerprint, address));
    page.click("shape");
    drawn(&page, words);
    page.run("document.getElementById('shape-dialog').close()");
    page.choose("cactus");
    page.wait("another plant", |s| s.plant == "cactus");
    page.wait_for("its link", "return !location.hash.includes('~')");
    assert_eq!(page.complaints(), [""; 0]);
}

#[test]
fn a_tree_has_a_matrix_of_ones_own_and_a_flower_strokes_that_are_drawn() {
    let Some(page) = open_dialog() else { return };
    choose_kind(&page, "tree");
    drawn(&page, "tree=");
    set(&page, "order", "3");
    page.run(
        "const rows = document.querySelector('textarea[data-key=matrix]');
         rows.value = '0.5 0.5\\n0.25 0.25 0.5'",
    );
    page.run(
        "const matrix = document.querySelector('select[data-key=matrix]');
         matrix.value = 'typed';
         matrix.dispatchEvent(new Event('input', {bubbles: true}))",
    );
    let words = "tree=matrix:0.5_0.5;0.25_0.25_0.5,order:3";
    drawn(&page, words);
    assert_eq!(grow(&page, words), key_of(words));

    page.click("shape");
    drawn(&page, words);
    choose_kind(&page, "flower");
    drawn(&page, "flower=");
    set(&page, "growth", "5");
    drawn(&page, "flower=growth:5");
    let open = seen(&page);
    // The tip of the open vein, by the mouse and then by the keys.
    page.run("document.querySelector('#shape-dialog svg[data-strokes~=\"petals.open_cm\"]').scrollIntoView()");
    page.drag("#shape-dialog circle[data-of=\"petals.open_cm\"][data-at=\"6\"]", -30, 0);
    let stroke = "return document.querySelector('input[data-key=\"petals.open_cm\"]').value";
    let dragged = page.run(stroke).as_str().unwrap().to_string();
    assert!(dragged.starts_with("0.6_0;0.7_1.6;") && !dragged.ends_with(";8_4.5"), "{dragged}");
    drawn(&page, &format!("flower=growth:5,petals.open_cm:{dragged}"));
    assert!(seen(&page) != open, "the flower follows");
    page.run("document.querySelector('#shape-dialog .back').click()");
    drawn(&page, "flower=growth:5");
    page.run(
        "document.querySelector('#shape-dialog circle[data-of=\"petals.left_cm\"][data-at=\"3\"]')
             .dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowLeft', bubbles: true}))",
    );
    let edge = |side: &str, sign: &str| {
        format!(
            "petals.{side}_cm:{sign}0.28_0;{sign}0.36_1.6;{sign}0.9_4;{sign}1.9_6.6;{sign}1.6_9.2;{sign}0.6_10.6;0_11.2"
        )
    };
    let words = format!("flower=growth:5,{},{}", edge("left", "-"), edge("right", ""));
    drawn(&page, &words);
    assert_eq!(grow(&page, &words), key_of(&words));
    page.wait("its first cells", |s| s.plant == key_of(&words) && s.cells != "0");
    assert_eq!(page.complaints(), [""; 0]);
}

/// Chooses one of several in the dialog.
fn choose(page: &Page, key: &str, value: &str) {
    page.run(&format!(
        "const field = document.querySelector('#shape-dialog select[data-key=\"{key}\"]');
         field.value = '{value}';
         field.dispatchEvent(new Event('input', {{bubbles: true}}))"
    ));
}

/// The words that the dialog has drawn.
fn words(page: &Page) -> String {
    let drawn = page.run("return document.getElementById('shape-dialog').dataset.drawn");
    drawn.as_str().unwrap_or_default().to_string()
}

#[test]
fn a_flower_has_sepals_and_a_tree_the_leaf_that_was_made_last() {
    let Some(page) = open_dialog() else { return };
    set(&page, "lobes", "3");
    set(&page, "size", "2");
    drawn(&page, "leaf=lobes:3,size:2");

    choose_kind(&page, "flower");
    drawn(&page, "flower=");
    let bare = seen(&page);
    set(&page, "sepals.count", "5");
    drawn(&page, "flower=sepals.count:5");
    assert!(seen(&page) != bare, "sepals are seen");
    let flower = "flower=sepals.count:5,sepals.open_deg:90";
    set(&page, "sepals.open_deg", "90");
    drawn(&page, flower);
    assert_eq!(grow(&page, flower), key_of(flower));

    page.click("shape");
    drawn(&page, flower);
    choose_kind(&page, "tree");
    drawn(&page, "tree=");
    set(&page, "order", "4");
    drawn(&page, "tree=order:4");
    choose(&page, "leaf", "typed");
    page.wait_for(
        "leaves on the tree",
        "return document.getElementById('shape-dialog').dataset.drawn.includes('leaf.lobes:5')",
    );
    page.run("document.querySelector('#shape-dialog .hang').click()");
    page.wait_for(
        "the leaf that was made",
        "return document.getElementById('shape-dialog').dataset.drawn.includes('leaf.lobes:3')",
    );
    let leafy = words(&page);
    assert!(leafy.contains("order:4") && !leafy.contains("size:2"), "{leafy}");
    assert_eq!(grow(&page, &leafy), key_of(&leafy));
    page.wait("its first cells", |s| s.plant == key_of(&leafy) && s.cells != "0");

    // The dialog comes back with the leaf, and without it the tree is bare.
    page.click("shape");
    drawn(&page, &leafy);
    choose(&page, "leaf", "");
    drawn(&page, "tree=order:4");
    assert_eq!(page.complaints(), [""; 0]);
}

#[test]
fn a_line_that_is_drawn_anew_is_a_stroke_of_the_petal_and_undone_by_the_keys() {
    let Some(page) = open_dialog() else { return };
    choose_kind(&page, "flower");
    drawn(&page, "flower=");
    let petal = "#shape-dialog svg[data-strokes~=\"petals.vein_cm\"]";
    page.run(&format!("document.querySelector('{petal}').scrollIntoView({{block: 'center'}})"));
    // Up from the middle, along the vein.
    page.drag(petal, 3, -50);
    let value = "return document.querySelector('input[data-key=\"petals.vein_cm\"]').value";
    page.wait_for("a vein of more points", &format!("{} !== '0_0;0_11.2'", value));
    let vein = page.run(value).as_str().unwrap().to_string();
    assert_eq!(vein.split(';').count(), 7, "{vein}");
    drawn(&page, &format!("flower=petals.vein_cm:{vein}"));
    page.run(
        "document.querySelector('#shape-dialog .kind').dispatchEvent(
             new KeyboardEvent('keydown', {key: 'z', ctrlKey: true, bubbles: true, cancelable: true}))",
    );
    drawn(&page, "flower=");
    assert_eq!(page.complaints(), [""; 0]);
}

#[test]
fn a_file_of_numbers_makes_its_body_again_and_what_is_wrong_is_told_in_words() {
    let Some(page) = Page::open(Graphics::WebGpu, "#lungwort?v=1&s=2&d=1") else { return };
    page.on_day(1);
    let made = Made::of_words("leaf=border:smooth,lobes:1,nodes:6").unwrap();
    page.drop("leaf.json", "application/json", made.to_json().as_bytes());
    let again = "leaf=border:smooth,lobes:1,nodes:6";
    page.wait_for("its link", &format!("return location.hash.endsWith('~{again}')"));
    page.wait("its body", |s| s.plant == key_of(again) && s.state == "ready");
    page.click("shape");
    drawn(&page, "leaf=lobes:1,nodes:6,border:smooth");
    page.run("document.getElementById('shape-dialog').close()");

    page.drop("leaf.json", "application/json", b"{\"lobess\": 3, \"nodes\": 4}");
    let told = "there is no number \\\"lobess\\\": the nearest one is \\\"lobes\\\"";
    page.wait_for(
        "what is wrong with the file",
        &format!("return document.getElementById('message-list').textContent.includes(\"{told}\")"),
    );
    page.run("location.hash = '#own-leaf~leaf=lobess:3'");
    page.wait_for(
        "what is wrong with the link",
        &format!(
            "const told = document.getElementById('message-list').textContent;
             return told.includes('of this link') && told.includes(\"{told}\")"
        ),
    );
}

#[test]
fn the_sliders_beside_the_body_are_seen_in_a_low_window() {
    let Some(page) = Page::open(Graphics::WebGpu, "#lungwort?v=1&s=2&d=1") else { return };
    page.on_day(1);
    page.devtools(
        "Emulation.setDeviceMetricsOverride",
        serde_json::json!({"width": 1280, "height": 600, "deviceScaleFactor": 1, "mobile": false}),
    );
    page.click("shape");
    drawn(&page, "leaf=");
    choose_kind(&page, "flower");
    drawn(&page, "flower=");
    for slider in ["around", "above", "time"] {
        let is_seen = format!(
            "const slider = document.querySelector('#shape-dialog .{slider}');
             const {{left, right, top, bottom}} = slider.getBoundingClientRect();
             return document.elementFromPoint((left + right) / 2, (top + bottom) / 2) === slider"
        );
        assert_eq!(page.run(&is_seen), true, "{slider} lies under something or outside");
    }
}

#[test]
fn a_workshop_that_ends_is_told_of_and_another_one_answers_the_next_slider() {
    let Some(page) = Page::start(Graphics::Neither) else { return };
    page.before_pages(
        "window.workers = [];
         window.Worker = class extends Worker {
             constructor(...all) { super(...all); window.workers.push(this) }
         }",
    );
    page.visit("#lungwort?v=1&s=2&d=1");
    page.on_day(1);
    page.click("shape");
    drawn(&page, "leaf=");
    page.run(
        "const last = window.workers.at(-1);
         last.terminate();
         last.dispatchEvent(new ErrorEvent('error', {cancelable: true}))",
    );
    let told = "const told = [...document.querySelectorAll('#shape-dialog [role=status]')];
                return told.some(e => e.textContent === 'It ended before it was done, most likely for want of memory.')";
    page.wait_for("why nothing is answered", told);
    set(&page, "lobes", "7");
    drawn(&page, "leaf=lobes:7");
}
