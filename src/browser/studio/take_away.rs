//! The dialog in which a plant is taken away.

use super::darkroom::{self, Print};
use super::files::save;
use super::subject::{self, address, whole_link_of};
use super::wish::{DOCUMENT, PICTURE};
use super::work::{Said, Work};
use super::{picture, with};
use crate::browser::dom::{Listener, find, on, set_attribute, set_flag, set_text, window, within};
use crate::export::Kind;
use crate::plants;
use crate::play::{Scene, link, words};
use js_sys::Uint8Array;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{Element, Event, HtmlDialogElement, HtmlElement, HtmlTextAreaElement, ShareData};

pub struct TakeAway {
    dialog: HtmlDialogElement,
    /// What is being made, and who makes it.
    making: Option<Making>,
    work: Option<Work>,
    _listeners: Vec<Listener>,
}

/// What is being made: its file, and what it is called while it is made.
struct Making {
    file: String,
    what: &'static str,
    last_day: u32,
    /// Frames of a film or tiles of a picture, which are drawn when the days have grown.
    steps: u32,
}

impl TakeAway {
    pub fn new() -> TakeAway {
        let dialog: HtmlDialogElement = find("take-away-dialog");
        let mut listeners = vec![on(&dialog, "click", |event: Event| {
            let target = event.target().and_then(|target| target.dyn_into::<Element>().ok());
            if let Some(wanted) = target.and_then(|target| target.get_attribute("data-take")) {
                with(|studio| studio.take_away.take(&wanted));
            }
        })];
        let stop: HtmlElement = within(&dialog, ".stop");
        listeners
            .push(on(&stop, "click", |_: Event| with(|studio| studio.take_away.stop("Stopped."))));
        let share: HtmlElement = within(&dialog, ".share-sheet");
        let shares = js_sys::Reflect::has(&window().navigator(), &"share".into()).unwrap_or(false);
        set_flag(&share, "hidden", !shares);
        listeners.push(on(&share, "click", |_: Event| spawn_local(share_link())));
        listeners.push(on(&dialog, "change", |_: Event| with(|studio| studio.take_away.tell())));
        listeners.push(on(&dialog, "close", |_: Event| with(|studio| studio.take_away.stop(""))));
        TakeAway { dialog, making: None, work: None, _listeners: listeners }
    }

    /// Opens the dialog on what the page shows.
    pub fn open(&mut self) {
        let address = address();
        let scene = scene_of(&address);
        let told =
            format!("{}, individual {}, day {}", scene.plant.name, scene.individual, scene.day);
        set_text(&self.part(".subject"), &told);
        let fingerprint = subject::fingerprint();
        let embed = format!(
            "<iframe src=\"{}\" title=\"{}\" width=\"800\" height=\"600\"></iframe>",
            address.replace('&', "&amp;"),
            scene.plant.name
        );
        let citation = format!(
            "{told}. Clonal Mosaic {}, link version {}, fingerprint {fingerprint}. {address}",
            env!("CARGO_PKG_VERSION"),
            scene.plant.rules as u32
        );
        for (part, text) in [(".link", &address), (".embed", &embed), (".citation", &citation)] {
            let area: HtmlTextAreaElement = within(&self.dialog, part);
            area.set_value(text);
        }
        picture::show_qr(&self.part(".qr"), &address);
        self.say("");
        self.tell();
        let dialog = self.dialog.clone();
        spawn_local(async move {
            darkroom::offer_mp4(dialog.into()).await;
            with(|studio| studio.take_away.tell());
        });
        if !self.dialog.open() {
            let _ = self.dialog.show_modal();
        }
    }

    /// Says how large a film and a large picture will be.
    fn tell(&self) {
        let link: HtmlTextAreaElement = within(&self.dialog, ".link");
        darkroom::tell(&self.dialog, &link.value());
    }

    /// Makes what was wanted, and hands it to the visitor.
    fn take(&mut self, wanted: &str) {
        // To ask the page for it makes it draw, and only the picture is to be drawn.
        let link: HtmlTextAreaElement = within(&self.dialog, ".link");
        let address = if wanted == PICTURE { address() } else { link.value() };
        let link = whole_link_of(&address).to_string();
        let scene = scene_of(&address);
        let name = format!("{}-{}-day-{}", scene.plant.key, scene.individual, scene.day);
        match Kind::of_word(wanted) {
            Some(kind) => {
                let end = if kind == Kind::Obj { "zip" } else { kind.extension() };
                let file = format!("{name}.{end}");
                let (what, last_day) = (kind.word(), scene.day);
                self.begin(Making { file: file.clone(), what, last_day, steps: 0 });
                spawn_local(async move {
                    let mesh = subject::mesh_of(&scene).await;
                    with(|studio| {
                        studio.take_away.grow(&file, "workshop", [what, &link], mesh, &*name);
                    });
                });
            }
            None if darkroom::is_for(wanted) => {
                let print = Print::chosen(wanted, &self.dialog, &scene, &address);
                let (file, word) = (print.file.clone(), wanted.to_string());
                let Print { what, days: last_day, steps, .. } = print;
                self.begin(Making { file: file.clone(), what, last_day, steps });
                spawn_local(async move {
                    let mesh = subject::mesh_of(&scene).await;
                    let more = print.wish().await;
                    with(|studio| match more {
                        Ok(more) => {
                            studio.take_away.grow(&file, "darkroom", [&word, &link], mesh, more);
                        }
                        Err(why) => studio.take_away.stop(&why),
                    });
                });
            }
            None if wanted == PICTURE => {
                let Some(pixels) = picture::pixels() else {
                    return self
                        .say("Nothing is drawn on this machine, so there is no picture to take.");
                };
                let file = format!("{name}.png");
                self.begin(Making { file, what: "the picture", last_day: 0, steps: 0 });
                self.start([PICTURE, &link, ""], pixels);
            }
            None => {
                let file = format!("{name}.mosaic.json");
                self.begin(Making { file, what: "the document", last_day: 0, steps: 0 });
                self.start([DOCUMENT, &link, &subject::own()], "");
            }
        }
    }

    /// Says that something is being made.
    fn begin(&mut self, making: Making) {
        self.stop("");
        let doing = if making.last_day == 0 { "Writing" } else { "Growing the plant for" };
        self.say(&format!("{doing} {} …", making.what));
        self.show_progress(Some((0, making.last_day + making.steps)));
        self.making = Some(making);
    }

    /// Has a bundle make what a word says of a mesh that has come, unless the visitor wants something else by now.
    fn grow(
        &mut self,
        file: &str,
        bundle: &str,
        [word, link]: [&str; 2],
        mesh: Result<String, String>,
        more: impl Into<JsValue>,
    ) {
        if self.making.as_ref().is_none_or(|making| making.file != file) {
            return;
        }
        match mesh {
            Ok(mesh) => self.start_in(bundle, [word, link, &mesh], more),
            Err(why) => self.stop(&format!("The plant's body did not come: {why}.")),
        }
    }

    fn start(&mut self, wish: [&str; 3], more: impl Into<JsValue>) {
        self.start_in("workshop", wish, more);
    }

    fn start_in(&mut self, bundle: &str, wish: [&str; 3], more: impl Into<JsValue>) {
        let hear = |said| with(|studio| studio.take_away.hear(said));
        match Work::start_in(bundle, wish, more, hear) {
            Ok(work) => self.work = Some(work),
            Err(why) => self.stop(&why),
        }
    }

    fn hear(&mut self, said: Said) {
        let Some(making) = &self.making else { return };
        match said {
            Said::Day(step) => {
                let Making { last_day, steps, .. } = *making;
                let what = match step.checked_sub(last_day) {
                    None => format!("Day {step} of {last_day} …"),
                    // It is read aloud: a tenth at a time.
                    Some(step) if step < steps => {
                        format!("{} of {steps} drawn …", step - step % steps.div_ceil(10))
                    }
                    Some(_) => "Writing …".into(),
                };
                self.say(&what);
                self.show_progress(Some((step, last_day + steps)));
            }
            Said::Refused(why) => self.stop(&why),
            Said::Done(answer) => {
                let file = making.file.clone();
                self.stop("");
                self.hand_over(&file, &answer.get(1).unchecked_into());
            }
        }
    }

    /// Gives the visitor a file.
    fn hand_over(&self, file: &str, bytes: &Uint8Array) {
        save(file, bytes);
        self.say(&format!(
            "{file}, {} KB, is among your downloads.",
            words::grouped(bytes.length().div_ceil(1024))
        ));
    }

    /// Ends what is being made, and says so.
    fn stop(&mut self, why: &str) {
        self.work = None;
        self.making = None;
        self.show_progress(None);
        self.say(why);
    }

    fn show_progress(&self, days: Option<(u32, u32)>) {
        let progress = self.part("progress");
        set_flag(&progress, "hidden", days.is_none());
        set_flag(&self.part(".stop"), "hidden", days.is_none());
        if let Some((day, last)) = days {
            set_attribute(&progress, "max", last.max(1).to_string());
            set_attribute(&progress, "value", day.to_string());
        }
    }

    fn say(&self, text: &str) {
        set_text(&self.part(".said"), text);
    }

    fn part(&self, selector: &str) -> Element {
        within(&self.dialog, selector)
    }
}

fn scene_of(address: &str) -> Scene {
    link::read(whole_link_of(address), plants::all()).scene
}

/// Shows the system's own sheet to share a link.
async fn share_link() {
    let data = ShareData::new();
    data.set_url(&address());
    data.set_title("Clonal Mosaic");
    // The visitor may think better of it.
    let _: Result<JsValue, JsValue> =
        JsFuture::from(window().navigator().share_with_data(&data)).await;
}
