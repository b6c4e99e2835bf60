//! The studio: what a visitor does with a plant once it stands there. It is a bundle of its own, which the
//! page loads when it is first wanted, and has no private door into the page: a scene comes in as the link that
//! the page would print, a file goes out, and a scene goes back as the address.

mod atlas;
mod bring_in;
mod brushes;
mod charts;
mod class;
mod codap;
mod darkroom;
mod drawing;
mod field;
mod files;
mod fit;
mod in_words;
mod leaflet;
mod lessons;
mod own;
mod paint;
mod painted;
mod picture;
mod pictures;
mod presenter;
mod pupils;
mod series;
mod shape;
mod simple;
mod sound;
mod strokes;
mod subject;
mod take_away;
mod tour;
pub mod wish;
mod work;

use super::address::fragment;
use super::dom::{document, find, on, set_attribute, window};
use crate::play::series::asked_view;
use bring_in::BringIn;
use charts::ChartView;
use class::ClassDialog;
use codap::Codap;
use fit::FitView;
use in_words::InWords;
use lessons::LessonView;
use paint::Paint;
use presenter::Presenter;
use pupils::Pupils;
use series::Series;
use shape::ShapeView;
use simple::SimpleView;
use sound::Sound;
use std::cell::RefCell;
use take_away::TakeAway;
use tour::Tour;
use wasm_bindgen::JsCast;
use web_sys::{Element, Event};
use work::Work;

thread_local! {
    static STUDIO: RefCell<Option<Studio>> = const { RefCell::new(None) };
}

struct Studio {
    take_away: TakeAway,
    bring_in: BringIn,
    /// What opens the file that was brought last.
    opening: Option<Work>,
    /// What is to be told of it when the page shows it.
    to_tell: Option<String>,
    charts: ChartView,
    series: Series,
    fit: FitView,
    shape: ShapeView,
    class: ClassDialog,
    presenter: Presenter,
    pupils: Pupils,
    simple: SimpleView,
    lessons: LessonView,
    sound: Sound,
    in_words: InWords,
    codap: Codap,
    tour: Tour,
    paint: Paint,
}

/// Puts the studio into the page, and opens what was wanted when it was loaded.
pub fn start() {
    wear(include_str!("studio/studio.css"));
    wear(include_str!("studio/class.css"));
    wear(include_str!("studio/lessons.css"));
    wear(include_str!("studio/paint.css"));
    wear(include_str!("studio/shape.css"));
    let body = document().body().expect("a page has a body");
    let _ = body.insert_adjacent_html("beforeend", include_str!("studio/take_away.html"));
    let _ = body.insert_adjacent_html("beforeend", include_str!("studio/bring_in.html"));
    let _ = body.insert_adjacent_html("beforeend", include_str!("studio/series.html"));
    let _ = body.insert_adjacent_html("beforeend", include_str!("studio/fit.html"));
    let _ = body.insert_adjacent_html("beforeend", include_str!("studio/shape.html"));
    let panel: Element = find("panel");
    let _ = panel.insert_adjacent_html("afterend", include_str!("studio/charts.html"));
    if let Ok(Some(floor)) = document().query_selector(".floor") {
        let _ = floor.insert_adjacent_html("beforeend", include_str!("studio/in_words.html"));
    }
    let _ = panel.insert_adjacent_html("afterend", include_str!("studio/lessons.html"));
    let sheet = "<div id=lesson-sheet class=worksheet></div>";
    let _ = body.insert_adjacent_html("beforeend", sheet);
    STUDIO.set(Some(Studio {
        take_away: TakeAway::new(),
        bring_in: BringIn::new(),
        opening: None,
        to_tell: None,
        charts: ChartView::new(),
        series: Series::new(),
        fit: FitView::new(),
        shape: ShapeView::new(),
        class: ClassDialog::new(),
        presenter: Presenter::new(),
        pupils: Pupils::new(),
        simple: SimpleView::new(),
        lessons: LessonView::new(),
        sound: Sound::new(),
        in_words: InWords::new(),
        codap: Codap::default(),
        tour: Tour::new(),
        paint: Paint::new(),
    }));
    // They are there as long as the page is.
    std::mem::forget(on(&find::<Element>("studio"), "click", |event: Event| {
        if let Some(door) = event.target() {
            open(&door.unchecked_into::<Element>().id());
        }
    }));
    std::mem::forget(on(&window(), "hashchange", |_: Event| {
        follow();
        // The page has heard of it before, and has taken away what it told of the plant before.
        let told = STUDIO.with_borrow_mut(|studio| studio.as_mut()?.to_tell.take());
        told.iter().for_each(|text| files::tell(text));
    }));
    files::take_what_is_dropped();
    leaflet::print_code();
    pictures::listen();
    subject::on_change(|| {
        // What hears of a new address may not all have heard yet.
        presenter::after(0, || {
            subject::mend();
            with(|studio| studio.paint.follow());
        });
    });
    pictures::follow_turns();
    let root = document().document_element().expect("a document has a root");
    if let Some(wanted) = root.get_attribute("data-studio") {
        open(&wanted);
    }
    set_attribute(&root, "data-studio", "here");
    follow();
    // Pictures that were there before.
    with(|studio| studio.series.sum_up());
}

impl Studio {
    /// The simple sliders as what the page shows has them.
    fn show_simple(&self) {
        self.simple.show(|key| self.pupils.hide(key));
    }
}

/// Opens what a button of the page is for.
fn open(door: &str) {
    with(|studio| match door {
        "take-away" => studio.take_away.open(),
        "bring-in" => studio.bring_in.open(),
        "charts" => studio.charts.toggle(),
        "series" => studio.series.open(),
        "fit" => studio.fit.open(),
        "paint" => studio.paint.open(),
        "shape" => studio.shape.open(),
        "class" => studio.class.open(),
        "lessons" => studio.lessons.open(),
        "in-words" => studio.in_words.say_again(),
        "tour" => presenter::after(0, tour::open),
        // What was dropped is heard of by itself.
        _ => {}
    });
}

/// Opens the plant of the visitor's own that the address has asked for in vain, if it was kept.
fn follow_own() {
    let root = document().document_element().expect("a document has a root");
    if let Some(asked) = root.get_attribute("data-own") {
        let _ = root.remove_attribute("data-own");
        match subject::origin() {
            _ if own::fetch_of_figures(&asked) => {}
            words if words.is_empty() => own::make_what_was_kept(asked),
            words => own::make_anew(asked, words),
        }
    }
}

/// Agrees with the address: what stands behind its `~`, a view and, behind a `/`, what of it.
fn follow() {
    follow_own();
    let wanted = subject::view();
    with(|studio| studio.codap.follow(wanted == codap::VIEW));
    // Where several plants stand there is none that anything could be done with.
    let wanted = if asked_view(&fragment()).is_some() { "" } else { &wanted };
    let (view, of_it) = wanted.split_once('/').unwrap_or((wanted, ""));
    with(|studio| {
        studio.pupils.follow((view == pupils::VIEW).then_some(of_it));
        let stays = studio.pupils.has_simple();
        studio.simple.follow(view == simple::VIEW || stays, stays);
        studio.show_simple();
        studio.presenter.follow(view == presenter::VIEW, view);
        match view {
            "lesson" => studio.lessons.follow(of_it),
            _ => studio.lessons.leave(),
        }
    });
    name_view();
}

/// Names what of ours is open on the `<html>` element, unless the figures are there.
fn name_view() {
    let root = document().document_element().expect("a document has a root");
    let now = root.get_attribute("data-view").unwrap_or_default();
    let ours = ["presenter", "class", "simple"];
    if now.is_empty() || now == "plant" || ours.contains(&now.as_str()) {
        with(|studio| {
            let view = match () {
                () if studio.presenter.is_open() => "presenter",
                () if studio.pupils.are_there() => "class",
                () if studio.simple.is_open() => "simple",
                () => "plant",
            };
            set_attribute(&root, "data-view", view);
        });
    }
}

fn with(f: impl FnOnce(&mut Studio)) {
    STUDIO.with_borrow_mut(|studio| studio.as_mut().map(f));
}

/// Adds a style of ours. The policy of the page lets none stand in the document, but sheets that scripts make.
fn wear(css: &str) {
    let Ok(sheet) = web_sys::CssStyleSheet::new() else { return };
    let _ = sheet.replace_sync(css);
    let sheets = js_sys::Reflect::get(&document(), &"adoptedStyleSheets".into());
    if let Ok(sheets) = sheets.and_then(|sheets| sheets.dyn_into::<js_sys::Object>()) {
        let push = js_sys::Reflect::get(&sheets, &"push".into());
        if let Ok(push) = push.and_then(|push| push.dyn_into::<js_sys::Function>()) {
            let _ = push.call1(&sheets, &sheet);
        }
    }
}
