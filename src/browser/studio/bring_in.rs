//! The dialog in which something is brought in: the colours of a photograph, or a file that was taken away.

use super::subject::{self, link_of};
use super::wish::PHOTO;
use super::work::{Said, Work};
use super::{files, own, with};
use crate::browser::dom::{
    Listener, document, find, offer, on, set_flag, set_style, set_text, window, within,
};
use crate::import::{Part, coloured, matched, patterned, types};
use crate::play::parameters::Parameter;
use crate::play::{Scene, link, words};
use crate::tissue::CellType;
use js_sys::Float64Array;
use wasm_bindgen::JsCast;
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{
    CanvasRenderingContext2d, ClipboardEvent, Element, Event, File, HtmlCanvasElement,
    HtmlDialogElement, HtmlElement, HtmlInputElement, HtmlSelectElement, ImageBitmap,
};

/// Pixels of the longer side of a photograph that are looked at: more would be slower and not better.
const MOST_PX: f64 = 256.0;

pub struct BringIn {
    dialog: HtmlDialogElement,
    /// What looks at a photograph.
    work: Option<Work>,
    /// What was found in one.
    found: Option<Found>,
    _listeners: Vec<Listener>,
}

struct Found {
    colours: Vec<Part>,
    /// The type that each is given to.
    kinds: Vec<CellType>,
    first_cells: f64,
    rows: Vec<(HtmlSelectElement, Listener)>,
}

impl BringIn {
    pub fn new() -> BringIn {
        let dialog: HtmlDialogElement = find("bring-in-dialog");
        let mut listeners = Vec::from(
            [(".photo", look as fn(File)), (".own", open_file), (".open", open_file)].map(
                |(selector, take)| {
                    let input: HtmlInputElement = within(&dialog, selector);
                    let chosen = input.clone();
                    on(&input, "change", move |_: Event| {
                        if let Some(file) = chosen.files().and_then(|files| files.get(0)) {
                            // The same file may be chosen again.
                            take(file);
                            chosen.set_value("");
                        }
                    })
                },
            ),
        );
        listeners.push(on(&within::<Element>(&dialog, ".with-numbers"), "change", |_: Event| {
            with(|studio| studio.bring_in.show_proposal());
        }));
        listeners.push(on(&within::<HtmlElement>(&dialog, ".forget"), "click", |_: Event| {
            own::forget();
            with(|studio| studio.bring_in.say("Nothing is kept any more."));
        }));
        listeners.push(on(&within::<HtmlElement>(&dialog, ".give"), "click", |_: Event| {
            with(|studio| studio.bring_in.give());
        }));
        listeners.push(on(&document(), "paste", |event: ClipboardEvent| {
            let files = event.clipboard_data().and_then(|data| data.files());
            if let Some(file) = files.and_then(|files| files.get(0)) {
                event.prevent_default();
                files::open(file);
            }
        }));
        listeners.push(on(&dialog, "close", |_: Event| {
            with(|studio| studio.bring_in.work = None);
        }));
        BringIn { dialog, work: None, found: None, _listeners: listeners }
    }

    pub fn open(&mut self) {
        self.forget();
        if !self.dialog.open() {
            let _ = self.dialog.show_modal();
        }
    }

    fn forget(&mut self) {
        (self.found, self.work) = (None, None);
        set_flag(&self.part(".found"), "hidden", true);
        self.say("");
    }

    /// Shows the photograph, small, and has the workshop look at it.
    fn look_at(&mut self, name: &str, picture: &ImageBitmap, mesh: Result<String, String>) {
        let canvas: HtmlCanvasElement = within(&self.dialog, ".preview");
        let [width, height] = [picture.width(), picture.height()].map(f64::from);
        let scale = (MOST_PX / width.max(height)).min(1.0);
        let [width, height] = [width, height].map(|side| (side * scale).round().max(1.0));
        canvas.set_width(width as u32);
        canvas.set_height(height as u32);
        let pen = canvas.get_context("2d").ok().flatten();
        let pen = pen.and_then(|pen| pen.dyn_into::<CanvasRenderingContext2d>().ok());
        let pixels = pen.and_then(|pen| {
            pen.draw_image_with_image_bitmap_and_dw_and_dh(picture, 0.0, 0.0, width, height)
                .ok()?;
            pen.get_image_data(0.0, 0.0, width, height).ok()
        });
        let started = match (pixels, mesh) {
            (Some(pixels), Ok(mesh)) => {
                let hear = |said| with(|studio| studio.bring_in.hear(said));
                Work::start([PHOTO, link_of(&subject::address()), &mesh], pixels, hear)
            }
            (None, _) => Err(format!("{name} cannot be shown here.")),
            (_, Err(why)) => Err(format!("The plant's body did not come: {why}.")),
        };
        match started {
            Ok(work) => {
                self.work = Some(work);
                self.say("Looking for colours …");
            }
            Err(why) => self.say(&why),
        }
    }

    fn hear(&mut self, said: Said) {
        match said {
            Said::Day(_) => {}
            Said::Refused(why) => {
                self.forget();
                self.say(&why);
            }
            Said::Done(answer) => {
                self.work = None;
                self.say("");
                let row = answer.get(0).unchecked_into::<Float64Array>().to_vec();
                let scene = subject::scene();
                let part = |of: &[f64]| Part {
                    colour: [of[0], of[1], of[2]].map(|part| part as f32),
                    share: of[3],
                };
                let colours: Vec<Part> = row[1..].chunks_exact(4).map(part).collect();
                let kinds = matched(&scene, &colours);
                let rows = self.rows(&scene, &colours);
                self.found = Some(Found { colours, kinds, first_cells: row[0], rows });
                set_flag(&self.part(".found"), "hidden", false);
                self.show_proposal();
            }
        }
    }

    /// A row for each colour: how it looks, how much there is, and the type that gets it.
    fn rows(&self, scene: &Scene, colours: &[Part]) -> Vec<(HtmlSelectElement, Listener)> {
        let list = self.part(".colours");
        list.set_text_content(None);
        let row = |(k, part): (usize, &Part)| {
            let percent = words::share((part.share * 1e4) as u32, 10_000);
            let item = document().create_element("li").ok()?;
            item.set_inner_html(&format!(
                "<label><span class=swatch></span> {percent} for <select></select></label>"
            ));
            let css = part.colour.map(|c| (c * 255.0).round());
            let swatch: HtmlElement = within(&item, ".swatch");
            set_style(&swatch, "background", &format!("rgb({} {} {})", css[0], css[1], css[2]));
            let select: HtmlSelectElement = within(&item, "select");
            for kind in types(scene) {
                let name = scene.plant.colour_names[kind as usize];
                offer(&select, &kind.letter().to_string(), name);
            }
            let _ = list.append_child(&item);
            let chosen = select.clone();
            let listener = on(&select, "change", move |_: Event| {
                let to = chosen.selected_index() as usize;
                with(|studio| studio.bring_in.swap(k, to));
            });
            Some((select, listener))
        };
        colours.iter().enumerate().filter_map(row).collect()
    }

    /// Gives a colour to another type, whose own then goes to the one that it had.
    fn swap(&mut self, colour: usize, to: usize) {
        let Some(found) = &mut self.found else { return };
        let Some(kind) = types(&subject::scene()).nth(to) else { return };
        if let Some(other) = found.kinds.iter().position(|&other| other == kind) {
            found.kinds.swap(colour, other);
        }
        self.show_proposal();
    }

    fn made(&self, found: &Found) -> Scene {
        let scene = subject::scene();
        let made = coloured(&scene, &found.colours, &found.kinds);
        match within::<HtmlInputElement>(&self.dialog, ".with-numbers").checked() {
            true => patterned(&made, &found.colours, &found.kinds, found.first_cells),
            false => made,
        }
    }

    /// Says what the numbers would be.
    fn show_proposal(&self) {
        let Some(found) = &self.found else { return };
        let (now, made) = (subject::scene(), self.made(found));
        let types: Vec<CellType> = types(&now).collect();
        for ((select, _), kind) in found.rows.iter().zip(&found.kinds) {
            let place = types.iter().position(|other| other == kind);
            select.set_selected_index(place.map_or(-1, |place| place as i32));
        }
        let numbers = ["n", "pf", "pm"].into_iter().filter_map(Parameter::of_key);
        let changed = numbers.filter(|number| number.get(&made) != number.get(&now));
        let told: Vec<String> = changed
            .map(|number| {
                let [was, is] = [&now, &made].map(|scene| number.said(number.get(scene)));
                format!("{}: {is} in the place of {was}", number.label(made.plant))
            })
            .collect();
        set_text(&self.part(".proposed"), &told.join(". "));
    }

    /// Gives the plant what was found.
    fn give(&mut self) {
        let Some(found) = &self.found else { return };
        subject::show(&link::write(&self.made(found)));
        self.dialog.close();
    }

    fn say(&self, text: &str) {
        set_text(&self.part(".said"), text);
    }

    fn part(&self, selector: &str) -> Element {
        within(&self.dialog, selector)
    }
}

/// Opens what was taken away; the page shows it.
fn open_file(file: File) {
    with(|studio| studio.bring_in.dialog.close());
    files::open(file);
}

/// Looks for the colours of a photograph.
pub fn look(file: File) {
    spawn_local(async move {
        let name = file.name();
        let picture = match window().create_image_bitmap_with_blob(&file) {
            Ok(picture) => JsFuture::from(picture).await.ok(),
            Err(_) => None,
        };
        let mesh = subject::mesh_of(&subject::scene()).await;
        with(|studio| {
            let bring_in = &mut studio.bring_in;
            bring_in.open();
            match picture {
                Some(picture) => bring_in.look_at(&name, &picture.unchecked_into(), mesh),
                None => bring_in.say(&format!("{name} is no picture that this browser knows.")),
            }
        });
    });
}
