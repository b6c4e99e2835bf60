//! The list of the lessons, and where their texts come from.

use super::{FROM_A_FILE, LessonView, root};
use crate::browser::dom::{Listener, document, on, set_attribute, set_flag, set_text};
use crate::browser::files;
use crate::browser::studio::with;
use crate::plants;
use crate::play::lesson::{LESSONS, Lesson};
use crate::play::phrasebook::PHRASEBOOKS;
use crate::play::{FIRST_INDIVIDUAL, Scene, link};
use wasm_bindgen::JsCast;
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{Element, Event, File, HtmlElement, HtmlInputElement};

/// The text of one of our lessons; in an error, why it cannot be had.
pub async fn fetch(name: &str) -> Result<String, String> {
    if !LESSONS.contains(&name) {
        return Err("There is no such lesson here.".to_string());
    }
    let folder = match language() {
        language if PHRASEBOOKS.contains(&language.as_str()) => format!("{language}/"),
        _ => String::new(),
    };
    let text = files::read_text(&files::address(&format!("lessons/{folder}{name}.txt"))).await;
    text.map_err(|why| format!("The lesson did not come: {why}."))
}

/// The language of the page.
pub fn language() -> String {
    root().get_attribute("lang").unwrap_or_default()
}

/// Whether an address shows what the page shows where none is named.
pub fn names_no_plant(fragment: &str) -> bool {
    let first = Scene::preset(&plants::all()[0], FIRST_INDIVIDUAL);
    link::read(fragment, plants::all()).scene == first
}

/// Opens a lesson from the visitor's disk when one is chosen.
pub fn watch_file(input: HtmlInputElement) -> Listener {
    let chosen = input.clone();
    on(&input, "change", move |_: Event| {
        if let Some(file) = chosen.files().and_then(|files| files.get(0)) {
            // The same file may be chosen again, once it is mended.
            chosen.set_value("");
            spawn_local(open(file));
        }
    })
}

async fn open(file: File) {
    let name = file.name();
    let text = JsFuture::from(file.text()).await.ok().and_then(|text| text.as_string());
    with(|studio| {
        let lessons = &mut studio.lessons;
        let kept = match text {
            Some(text) => lessons.keep(FROM_A_FILE, text),
            None => Err("it cannot be read.".to_string()),
        };
        match kept {
            Ok(()) => {
                // Another lesson has other answers.
                lessons.answers.remove(FROM_A_FILE);
                lessons.go(FROM_A_FILE, 0);
            }
            Err(why) => set_text(&lessons.part(".own .refusal"), &format!("{name}: {why}")),
        }
    });
}

impl LessonView {
    /// Shows the list in the place of a step, and why if it was not wished.
    pub(super) fn show_list(&mut self, why: &str) {
        self.place = None;
        self.growth = None;
        set_flag(&root(), "data-lesson", false);
        self.clear();
        set_text(&self.part(".where"), "");
        set_text(&self.part("#lesson-title"), "Lessons");
        let list: Element = self.part(".lessons");
        for (name, hidden) in [
            (".lessons", false),
            (".own", false),
            (".take", true),
            ("footer", true),
            (".list", true),
        ] {
            set_flag(&self.part(name), "hidden", hidden);
        }
        set_text(&self.part(".own .refusal"), why);
        if list.child_element_count() as usize != LESSONS.len() {
            spawn_local(fetch_all());
        }
        self.begin();
    }

    fn offer(&mut self, name: &str) {
        let list: Element = self.part(".lessons");
        let there = list.query_selector(&format!("[data-lesson-name={name}]"));
        let (Some((lesson, _)), Ok(None)) = (self.read.get(name), there) else { return };
        let html = "<li><button type=button><strong></strong><span class=hint></span><span></span></button></li>";
        let _ = list.insert_adjacent_html("beforeend", html);
        let Some(button) = list.last_element_child().and_then(|item| item.first_element_child())
        else {
            return;
        };
        set_attribute(&button, "data-lesson-name", name);
        let told = [&lesson.title, &when(lesson), &lesson.about];
        for (k, text) in told.into_iter().enumerate() {
            if let Some(part) = button.children().item(k as u32) {
                set_text(&part, text);
            }
        }
    }

    /// Begins at the top, and where a button led here, with the focus on the title.
    pub(super) fn begin(&mut self) {
        self.part::<Element>(".page").set_scroll_top(0);
        if std::mem::take(&mut self.goes) {
            let _ = self.part::<HtmlElement>("#lesson-title").focus();
        }
    }
}

/// For whom it is and how long it takes.
pub fn when(lesson: &Lesson) -> String {
    let age = Some(&lesson.age).filter(|age| !age.is_empty()).map(|age| format!("age {age}"));
    let minutes = Some(lesson.minutes).filter(|&m| m > 0).map(|m| format!("{m} minutes"));
    age.into_iter().chain(minutes).collect::<Vec<_>>().join(" · ")
}

async fn fetch_all() {
    for name in LESSONS {
        let mut text = Ok(String::new());
        let mut is_read = false;
        with(|studio| is_read = studio.lessons.read.contains_key(name));
        if !is_read {
            text = fetch(name).await;
        }
        with(|studio| {
            let lessons = &mut studio.lessons;
            let kept = match text {
                _ if is_read => Ok(()),
                Ok(text) => lessons.keep(name, text),
                Err(why) => Err(why),
            };
            match kept {
                Ok(()) => lessons.offer(name),
                Err(why) => set_text(&lessons.part(".own .refusal"), &why),
            }
        });
    }
}

/// An element at the end of another.
pub fn add(parent: &Element, tag: &str, class: &str, text: &str) -> Element {
    let element = document().create_element(tag).expect("a name that HTML knows");
    if !class.is_empty() {
        element.set_class_name(class);
    }
    if !text.is_empty() {
        element.set_text_content(Some(text));
    }
    let _ = parent.append_child(element.unchecked_ref());
    element
}
