//! The charts of the growth, beside the plant, on the page's own clock.

use super::files::save;
use super::wish::NUMBERS;
use super::work::{Said, Work};
use super::{subject, with};
use crate::browser::address::fragment;
use crate::browser::dom::{
    Listener, document, find, on, set_attribute, set_flag, set_text, within,
};
use crate::export::{Chart, DayNumbers, sizes_of_clans, the_course};
use crate::plants;
use crate::play::{Scene, link};
use js_sys::{Float64Array, Uint8Array};
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::spawn_local;
use web_sys::{
    Element, Event, HtmlElement, HtmlInputElement, KeyboardEvent, MouseEvent, MutationObserver,
    MutationObserverInit,
};

pub struct ChartView {
    view: HtmlElement,
    list: Element,
    /// What was grown, or is being grown, for the charts; its day is its last one.
    scene: Option<Scene>,
    days: Vec<DayNumbers>,
    work: Option<Work>,
    cards: Vec<Card>,
    _listeners: Vec<Listener>,
}

/// A chart on the page.
struct Card {
    chart: Chart,
    plot: HtmlElement,
    read: Element,
    table: Element,
    /// The place that the mouse is over.
    over: Option<usize>,
    _listeners: Vec<Listener>,
}

impl ChartView {
    pub fn new() -> ChartView {
        let view: HtmlElement = find("charts-view");
        let close: HtmlElement = within(&view, ".close");
        let listeners = vec![
            on(&close, "click", |_: Event| with(|studio| studio.charts.close())),
            on(&view, "keydown", |event: KeyboardEvent| {
                if event.key() == "Escape" {
                    with(|studio| studio.charts.close());
                }
            }),
        ];
        let changed = Closure::<dyn FnMut()>::new(|| with(|studio| studio.charts.follow()));
        if let Ok(observer) = MutationObserver::new(changed.as_ref().unchecked_ref()) {
            let root = document().document_element().expect("a document has a root");
            let which = MutationObserverInit::new();
            which.set_attributes(true);
            let names = ["data-day", "data-state", "data-plant", "data-individual"];
            which.set_attribute_filter(
                &names.into_iter().map(JsValue::from).collect::<js_sys::Array>(),
            );
            let _ = observer.observe_with_options(&root, &which);
        }
        // It looks as long as the page is there.
        changed.forget();
        let list = within(&view, ".list");
        ChartView {
            view,
            list,
            scene: None,
            days: Vec::new(),
            work: None,
            cards: Vec::new(),
            _listeners: listeners,
        }
    }

    pub fn toggle(&mut self) {
        if !self.view.hidden() {
            return self.close();
        }
        self.view.set_hidden(false);
        let _ = self.view.focus();
        self.follow();
    }

    fn close(&mut self) {
        self.view.set_hidden(true);
        let _ = find::<HtmlElement>("charts").focus();
    }

    /// Agrees with what the page shows: grows anew if another plant is there, and marks its day.
    fn follow(&mut self) {
        if self.view.hidden() {
            return;
        }
        let mut scene = link::read(&fragment(), plants::all()).scene;
        scene.day = scene.recipe.days;
        if self.scene.as_ref().is_some_and(|old| old.grows_like(&scene)) {
            return self.show();
        }
        // Those of another plant are none of this one.
        self.work = None;
        self.days.clear();
        self.cards.clear();
        self.list.set_text_content(None);
        self.say("Growing the plant for its numbers …");
        self.scene = Some(scene.clone());
        spawn_local(async move {
            let mesh = subject::mesh_of(&scene).await;
            with(|studio| studio.charts.start(&scene, mesh));
        });
    }

    fn start(&mut self, scene: &Scene, mesh: Result<String, String>) {
        if self.scene.as_ref() != Some(scene) {
            return;
        }
        let hear = |said| with(|studio| studio.charts.hear(said));
        let started = mesh
            .map_err(|why| format!("The plant's body did not come: {why}."))
            .and_then(|mesh| Work::start([NUMBERS, &link::write(scene), &mesh], "", hear));
        match started {
            Ok(work) => self.work = Some(work),
            Err(why) => self.say(&why),
        }
    }

    fn hear(&mut self, said: Said) {
        match said {
            Said::Day(_) => {}
            Said::Refused(why) => {
                self.work = None;
                self.say(&why);
            }
            Said::Done(answer) => match answer.get(0).dyn_into::<Float64Array>() {
                Ok(row) => {
                    self.days.extend(DayNumbers::of_row(&row.to_vec()));
                    self.show();
                }
                Err(_) => {
                    self.work = None;
                    self.say("");
                    self.show();
                }
            },
        }
    }

    fn say(&self, text: &str) {
        set_text(&within(&self.view, ".said"), text);
    }

    fn show(&mut self) {
        let Some(scene) = self.scene.as_ref().filter(|_| !self.days.is_empty()) else { return };
        let progress: Element = within(&self.view, "progress");
        set_flag(&progress, "hidden", self.work.is_none());
        set_attribute(&progress, "max", scene.recipe.days.max(1).to_string());
        set_attribute(&progress, "value", (self.days.len() - 1).to_string());
        let root = document().document_element().expect("a document has a root");
        let day: Option<usize> = root.get_attribute("data-day").and_then(|day| day.parse().ok());
        let on_screen = day.map(|day| day.min(self.days.len() - 1));
        let mut charts = the_course(scene.plant, &scene.look, &self.days);
        charts.push(sizes_of_clans(&self.days[on_screen.unwrap_or(0)]));
        let last = charts.len() - 1;
        for (k, chart) in charts.into_iter().enumerate() {
            if k == self.cards.len() {
                self.cards.push(Card::new(k, &self.list));
            }
            let card = &mut self.cards[k];
            card.chart = chart;
            // Sizes have no day.
            card.show(if k == last { None } else { on_screen });
        }
    }

    /// The mouse is over a place of a chart, or over none any more.
    fn look(&mut self, k: usize, across: Option<f64>) {
        let card = &mut self.cards[k];
        card.over = across.map(|across| card.chart.nearest(across));
        self.show();
    }

    /// Goes to a day of the page.
    fn go(&self, k: usize, across: f64) {
        let chart = &self.cards[k].chart;
        if chart.along != "day" {
            return;
        }
        let slider: HtmlInputElement = find("day");
        slider.set_value(&chart.nearest(across).to_string());
        if let Ok(event) = Event::new("input") {
            let _ = slider.dispatch_event(&event);
        }
    }

    fn save(&self, k: usize, as_table: bool) {
        let (Some(scene), chart) = (&self.scene, &self.cards[k].chart) else { return };
        let what = ["cells", "shares", "patches", "largest-patch", "clans"][k];
        let (content, end) =
            if as_table { (chart.to_csv(), "csv") } else { (chart.to_svg(None), "svg") };
        let name = format!("{}-{}-{what}.{end}", scene.plant.key, scene.individual);
        save(&name, &Uint8Array::from(content.as_bytes()));
    }
}

impl Card {
    fn new(k: usize, list: &Element) -> Card {
        let html = "<figure class=chart><figcaption></figcaption><div class=plot></div><p class=read></p>\
                    <div class=row><button type=button data-end=csv>CSV</button>\
                    <button type=button data-end=svg>SVG</button>\
                    <details><summary>Table</summary><table></table></details></div></figure>";
        let _ = list.insert_adjacent_html("beforeend", html);
        let figure = list.last_element_child().expect("it was put there");
        let plot: HtmlElement = within(&figure, ".plot");
        let across = |event: &MouseEvent| {
            let target = event.current_target().and_then(|t| t.dyn_into::<Element>().ok());
            let width = target.map_or(1.0, |t| t.get_bounding_client_rect().width());
            f64::from(event.offset_x()) / width.max(1.0)
        };
        let listeners = vec![
            on(&plot, "mousemove", move |event: MouseEvent| {
                with(|studio| studio.charts.look(k, Some(across(&event))));
            }),
            on(&plot, "mouseleave", move |_: MouseEvent| {
                with(|studio| studio.charts.look(k, None))
            }),
            on(&plot, "click", move |event: MouseEvent| {
                // The page answers at once, and the studio follows it.
                let across = across(&event);
                let go = Closure::once_into_js(move || with(|studio| studio.charts.go(k, across)));
                let window = crate::browser::dom::window();
                let _ = window
                    .set_timeout_with_callback_and_timeout_and_arguments_0(go.unchecked_ref(), 0);
            }),
            on(&figure, "click", move |event: Event| {
                let target = event.target().and_then(|t| t.dyn_into::<Element>().ok());
                if let Some(end) = target.and_then(|t| t.get_attribute("data-end")) {
                    with(|studio| studio.charts.save(k, end == "csv"));
                }
            }),
        ];
        Card {
            chart: Chart::default(),
            plot,
            read: within(&figure, ".read"),
            table: within(&figure, "table"),
            over: None,
            _listeners: listeners,
        }
    }

    fn show(&self, on_screen: Option<usize>) {
        let marked = self.over.or(on_screen);
        let figure = self.plot.parent_element().expect("it stands in a figure");
        set_text(&within(&figure, "figcaption"), &self.chart.title);
        self.plot.set_inner_html(&self.chart.to_svg(marked));
        let told = match marked {
            Some(k) => self.chart.told(k),
            None => {
                let all: Vec<String> =
                    (0..self.chart.places.len()).map(|k| self.chart.told(k)).collect();
                all.join("; ")
            }
        };
        set_text(&self.read, &told);
        self.table.set_inner_html(&table_of(&self.chart));
    }
}

/// The rows of a chart's table, as HTML.
pub fn table_of(chart: &Chart) -> String {
    let row = |(row, line): (usize, &str)| {
        let tag = if row == 0 { "th" } else { "td" };
        let columns: String =
            line.split(',').map(|word| format!("<{tag}>{word}</{tag}>")).collect();
        format!("<tr>{columns}</tr>")
    };
    chart.to_csv().lines().enumerate().map(row).collect()
}
