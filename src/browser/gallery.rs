//! The figures and series: rows of pictures. The row that the reader looks at grows and is
//! drawn on the page's one stage, picture by picture, and copied from there; the other rows keep
//! their last pictures.

use super::address::{fragment, with_fragment};
use super::app;
use super::dom::{
    Listener, copy_of_template, document, find, mark_when_missing, on, set_attribute, set_flag,
    set_style, set_text, window, within,
};
use super::files;
use super::mail::Mail;
use super::stage::Stage;
use super::turning;
use super::typing::set_value;
use crate::draw::DrawError;
use crate::plants;
use crate::play::figures::{Figure, Picture};
use crate::play::gallery::{self, Days, Event, Row};
use crate::play::page::{Effect, State};
use crate::play::series::View;
use crate::play::{Scene, link, words};
use crate::tissue::{DayCount, Recipe};
use wasm_bindgen::JsCast;
use web_sys::{
    CanvasRenderingContext2d, Element, HtmlCanvasElement, HtmlElement, HtmlInputElement,
};

/// Workers at most: each holds a body, and more than a row has growths are of no use.
const MOST_WORKERS: usize = 4;
/// The side of each of two pictures; those of more are as the document has them.
const LARGE_PX: u32 = 960;
/// Milliseconds that the scroll must rest before the row in the middle grows: rows that fly by do not.
const REST_MS: f64 = 250.0;
/// Milliseconds of drawing in a frame, after which the other pictures wait for the next one.
const DRAW_MS: f64 = 8.0;

/// The open figures; they end when this is dropped.
pub struct Gallery {
    brain: gallery::Gallery,
    /// By their numbers.
    workers: Vec<Option<Mail>>,
    root: HtmlElement,
    rows: Vec<RowView>,
    /// Until when the scroll must rest.
    rests_ms: Option<f64>,
    state: State,
    /// The number of the figure that the address asks for; empty without it.
    asked: &'static str,
    _listeners: [Listener; 2],
}

/// Where a reader of the figures was.
#[derive(Clone, Debug, Default)]
pub struct Bookmark {
    days: Days,
    asked: &'static str,
    scroll_px: i32,
}

struct RowView {
    figure: &'static Figure,
    element: HtmlElement,
    pictures: Vec<PictureView>,
    day: HtmlInputElement,
    told_day: Element,
    trouble: Element,
    _listeners: Vec<Listener>,
}

struct PictureView {
    element: Element,
    pen: CanvasRenderingContext2d,
    label: Element,
    told: Element,
    /// The generation and day that are drawn.
    drawn: Option<(u32, u32)>,
}

impl Gallery {
    /// Opens a view at what is asked for of it, or where the reader has been. `back` is the link of the plant
    /// to go back to.
    pub fn open(view: &View, asked_for: &str, back: &str, bookmark: &Bookmark) -> Gallery {
        let cores = window().navigator().hardware_concurrency() as usize;
        let root: HtmlElement = find("figures");
        let list: HtmlElement = find("figure-list");
        list.set_text_content(None);
        let of_figures = view.is_of_figures();
        let rows = view.rows(asked_for.to_string().leak());
        let rows: Vec<RowView> =
            rows.into_iter().map(|figure| RowView::new(&list, figure, of_figures)).collect();
        set_text(&find("figures-title"), view.title);
        set_attribute(&find::<Element>("from-figures"), "href", with_fragment(back));
        set_flag(&root, "hidden", false);
        set_flag(&trouble(), "hidden", true);
        show_view(view.key);
        // One core is for the page.
        let count = cores.saturating_sub(1).clamp(1, MOST_WORKERS);
        let workers = (0..count).map(|_| None).collect();
        let asked = rows.iter().find(|row| row.figure.number == asked_for);
        let comes_back = asked.is_none() || asked_for == bookmark.asked;
        // Scrolled by hand: to scroll a row into view would scroll the page around it, too.
        root.set_scroll_top(match asked {
            Some(row) if of_figures && !comes_back => row.element.offset_top(),
            _ if of_figures => bookmark.scroll_px,
            _ => 0,
        });
        // The keys that scroll are to work at once.
        let _ = root.focus();
        let scroll = on(&root, "scroll", |_: web_sys::Event| app::figures_scrolled());
        let again: Element = within(&trouble(), "button");
        let again = on(&again, "click", |_: web_sys::Event| app::open_link(&fragment()));
        let brain = gallery::Gallery::new(plants::all(), count, bookmark.days.clone());
        for row in &rows {
            if let Some(day) = brain.day_of(row.figure) {
                row.tell_day(day);
            }
        }
        document().set_title(&format!("{} · Clonal Mosaic", view.title));
        let asked = asked.map_or("", |row| row.figure.number);
        let (rests_ms, state, _listeners) = (Some(0.0), State::Loading, [scroll, again]);
        Gallery { brain, workers, root, rows, rests_ms, state, asked, _listeners }
    }

    /// Whether there are no rows: those of the figures are yet to come.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// The figures cannot be had, and why.
    pub fn fail(&mut self, why: &str) {
        self.state = State::Error;
        let trouble = trouble();
        set_text(&within(&trouble, "span"), &format!("The figures could not be loaded ({why})."));
        set_flag(&trouble, "hidden", false);
    }

    /// Where the reader is.
    pub fn bookmark(&self) -> Bookmark {
        let days = self.brain.days().clone();
        Bookmark { days, asked: self.asked, scroll_px: self.root.scroll_top() }
    }

    /// Takes an event; what the page must do is returned.
    pub fn hear(&mut self, event: Event) -> Vec<Effect> {
        if matches!(event, Event::Look { .. }) {
            self.forget_drawn();
        }
        let mut others = Vec::new();
        for (number, effect) in self.brain.hear(event) {
            let worker = &mut self.workers[number];
            match effect {
                Effect::StartWorker => {
                    if let Err(why) = start_worker(number).map(|mail| *worker = Some(mail)) {
                        others.extend(self.hear(Event::WorkerLost(number, why)));
                    }
                }
                Effect::EndWorker => *worker = None,
                Effect::Post(wish) => {
                    if let Some(worker) = worker {
                        worker.post(&wish);
                    }
                }
                other => others.push(other),
            }
        }
        others
    }

    /// Whether a figure is the one that grows.
    pub fn grows(&self, figure: &Figure) -> bool {
        self.brain.row().is_some_and(|row| row.figure == figure)
    }

    /// How far the row that grows has come.
    pub fn state(&self) -> State {
        self.state
    }

    /// The reader scrolls: what comes into sight waits for the end of that.
    pub fn scrolled(&mut self) {
        self.rests_ms = Some(now_ms() + REST_MS);
    }

    /// Draws everything again: the device is a new one, or it got dark.
    pub fn forget_drawn(&mut self) {
        for picture in self.rows.iter_mut().flat_map(|row| &mut row.pictures) {
            picture.drawn = None;
        }
    }

    /// The row that is to grow now that the scroll rests.
    pub fn next_row(&mut self) -> Option<&'static Figure> {
        self.rests_ms.take_if(|rests_ms| now_ms() >= *rests_ms)?;
        let middle = self.root.get_bounding_client_rect();
        let middle = middle.top() + 0.5 * middle.height();
        let from_middle = |row: &RowView| {
            let rect = row.element.get_bounding_client_rect();
            (rect.top() + 0.5 * rect.height() - middle).abs()
        };
        let near = |a: &&RowView, b: &&RowView| from_middle(a).total_cmp(&from_middle(b));
        let figure = self.rows.iter().min_by(near)?.figure;
        (!self.grows(figure)).then_some(figure)
    }

    /// Brings the row that grows up to date. True if another frame is needed.
    pub fn show(&mut self, stage: &mut Stage, dark: bool) -> Result<bool, DrawError> {
        let waits = self.rests_ms.is_some();
        let Some(row) = self.brain.row() else { return Ok(waits) };
        let Some(view) = self.rows.iter_mut().find(|view| view.figure == row.figure) else {
            return Ok(waits);
        };
        view.tell(row);
        let until_ms = now_ms() + DRAW_MS;
        // None of a row whose plants are yet to come.
        for (k, picture) in view.pictures.iter_mut().enumerate().take(row.pictures.len()) {
            set_attribute(&picture.element, "href", with_fragment(&row.link(k)));
            let Some(shown) = row.shown(k) else { continue };
            if picture.drawn == Some((shown.generation, shown.day)) {
                continue;
            }
            if now_ms() >= until_ms {
                self.state = State::Growing;
                return Ok(true);
            }
            let mesh = self.brain.mesh(shown.scene.plant.body.mesh.name);
            // What is too large is not drawn: the still stands in for it.
            let (done, too_large) = match stage.copy(&shown, mesh, dark, &picture.pen) {
                Err(DrawError::TooLarge { .. }) => (true, true),
                drawn => (drawn?, false),
            };
            if done {
                picture.drawn = Some((shown.generation, shown.day));
                set_flag(&picture.element, "data-live", !too_large);
            }
            set_text(&picture.label, &row.label(k));
            let mut told = row.told(k).unwrap_or_default();
            if too_large {
                told += ". This graphics card cannot hold so many: a still picture.";
            }
            set_text(&picture.told, &told);
            let DayCount { cells, by_type: [f, b, m] } = shown.facts.count;
            set_attribute(
                &picture.element,
                "data-count",
                format!("{} {cells} {f} {b} {m}", shown.day),
            );
        }
        self.state = row.state(|shown, k| {
            stage.is_still() || view.pictures[k].drawn == Some((shown.generation, shown.day))
        });
        Ok(waits)
    }
}

impl Drop for Gallery {
    fn drop(&mut self) {
        set_flag(&self.root, "hidden", true);
        show_view("plant");
        // Until the plant is there and says what it is.
        document().set_title("Clonal Mosaic");
        // The next key goes on from where the visitor came from.
        let _ = find::<HtmlElement>("to-figures").focus();
    }
}

impl RowView {
    fn new(list: &Element, figure: &'static Figure, of_figures: bool) -> RowView {
        let element = copy_of_template("figure-template");
        let number: Element = within(&element, ".number");
        if of_figures {
            set_attribute(&element, "id", format!("figure-{}", figure.number));
            set_text(&number, figure.number);
            set_attribute(&number, "href", with_fragment(&format!("figures/{}", figure.number)));
        } else {
            number.remove();
        }
        set_text(&within(&element, ".title"), figure.title);
        set_text(&within(&element, ".figure-caption"), figure.caption);
        let row: HtmlElement = within(&element, ".pictures");
        set_style(&row, "--count", &figure.pictures.len().to_string());
        let mut listeners = Vec::new();
        let pictures = figure.pictures.iter().enumerate().map(|(k, picture)| {
            let tile = copy_of_template("picture-template");
            set_attribute(&tile, "href", with_fragment(picture.link));
            let label: Element = within(&tile, ".label");
            set_text(&label, picture.label);
            let still: Element = within(&tile, "img");
            if of_figures {
                listeners.push(mark_when_missing(&still));
                let path = format!("posters/{}.avif", figure.poster(k));
                set_attribute(&still, "src", files::address(&path));
            } else {
                still.remove();
            }
            let canvas: HtmlCanvasElement = within(&tile, "canvas");
            if figure.pictures.len() == 2 {
                canvas.set_width(LARGE_PX);
                canvas.set_height(LARGE_PX);
            }
            let _ = row.append_child(&tile);
            let pen = canvas.get_context("2d").ok().flatten().expect("browsers draw in 2D");
            let told = within(&tile, ".told");
            PictureView {
                element: tile.into(),
                pen: pen.unchecked_into(),
                label,
                told,
                drawn: None,
            }
        });
        let pictures: Vec<PictureView> = pictures.collect();
        let more: Element = within(&element, ".more");
        if of_figures {
            let link = |p: &Picture| &p.link[..p.link.len() - p.beside().len()];
            let links: Vec<&str> = figure.pictures.iter().map(link).collect();
            set_attribute(&more, "href", with_fragment(&format!("compare/{}", links.join("/"))));
        } else {
            more.remove();
            listeners.extend(turning::listen(&row));
        }
        let scenes = figure.pictures.iter().map(|p| link::read(p.link, plants::all()).scene);
        let scenes: Vec<Scene> = scenes.collect();
        let last_day = scenes.iter().map(|scene| scene.day).max().unwrap_or(0);
        let day: HtmlInputElement = within(&element, ".days input");
        let field = day.clone();
        listeners.push(on(&day, "input", move |_: web_sys::Event| {
            app::open_figure(figure);
            app::send_to_figures(Event::Day(field.value_as_number() as u32));
        }));
        let _ = list.append_child(&element);
        let told_day = within(&element, ".days output");
        let trouble = within(&element, ".trouble");
        set_attribute(&day, "max", last_day.to_string());
        let view =
            RowView { figure, element, pictures, day, told_day, trouble, _listeners: listeners };
        view.tell_day(last_day);
        if figure.pictures.iter().all(|picture| picture.unknown().is_none()) {
            view.tell_plants(&scenes);
        }
        view
    }

    fn tell_day(&self, day: u32) {
        set_value(&self.day, &day.to_string());
        set_text(&self.told_day, &format!("Day {day}"));
    }

    /// What plants these are and the numbers of them, where all are of one kind.
    fn tell_plants(&self, scenes: &[Scene]) {
        let plant = scenes[0].plant;
        if scenes.iter().any(|scene| scene.plant.latin != plant.latin) {
            return;
        }
        set_text(&within(&self.element, ".latin"), plant.latin);
        let recipes: Vec<Recipe> = scenes.iter().map(|scene| scene.recipe.clone()).collect();
        set_text(&within(&self.element, ".numbers"), &words::numbers(plant, &recipes));
    }

    fn tell(&self, row: &Row) {
        if !row.pictures.is_empty() {
            self.tell_day(row.day);
            self.tell_plants(&row.pictures);
        }
        set_text(&self.trouble, row.trouble.as_deref().unwrap_or_default());
    }
}

fn start_worker(number: usize) -> Result<Mail, String> {
    Mail::start(move |said| {
        app::send_to_figures(match said {
            Ok(answer) => Event::FromWorker(number, answer),
            Err(why) => Event::WorkerLost(number, why),
        });
    })
}

/// What says that the figures cannot be had.
fn trouble() -> Element {
    find("figures-trouble")
}

/// Shows a view in the place of the plant, or the other way round.
fn show_view(key: &str) {
    if let Some(root) = document().document_element() {
        set_attribute(&root, "data-view", key);
    }
    set_flag(&find::<Element>("playground"), "inert", key != "plant");
}

fn now_ms() -> f64 {
    window().performance().map_or(0.0, |clock| clock.now())
}
