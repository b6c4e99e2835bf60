//! The page as a data plugin of CODAP, where the address ends with `~codap`: days and individuals become cases of tables
//! there. What is shown is kept with the document of CODAP.

mod phone;

use super::series::pictures;
use super::wish::NUMBERS;
use super::work::{Said, Work};
use super::{subject, with};
use crate::browser::address::fragment;
use crate::browser::dom::{find, on, set_text, window, within};
use crate::export::{
    CODAP_DAYS, CODAP_INDIVIDUALS, CodapTable, DayNumbers, day_case, individual_case, json_text,
};
use crate::plants;
use crate::play::series::asked_view;
use crate::play::{Scene, link};
use js_sys::Float64Array;
use phone::Phone;
use std::rc::Rc;
use wasm_bindgen::JsCast;
use wasm_bindgen_futures::spawn_local;
use web_sys::{Element, Event, HtmlElement};

/// What stands in the address.
pub const VIEW: &str = "codap";

/// What is said first: who this is, and how large it wants to be, in pixels.
const FRAME: &str = r#"{"action":"update","resource":"interactiveFrame","values":{"name":"Clonal Mosaic","title":"Clonal Mosaic","version":"1","dimensions":{"width":760,"height":640}}}"#;
const ASK_FRAME: &str = r#"{"action":"get","resource":"interactiveFrame"}"#;

#[derive(Default)]
pub struct Codap {
    phone: Option<Rc<Phone>>,
    is_open: bool,
    work: Option<Work>,
    /// The links of the cases that were sent, so that none is sent twice.
    sent: Vec<String>,
    /// The names of the tables that are known to be there.
    tables: Vec<&'static str>,
}

impl Codap {
    /// Agrees with the address: the bar is there while it is wished, and in CODAP for good.
    pub fn follow(&mut self, is_wanted: bool) {
        if is_wanted && !std::mem::replace(&mut self.is_open, true) {
            self.open();
        }
        if self.is_open {
            find::<HtmlElement>("codap").set_hidden(!is_wanted && self.phone.is_none());
        }
    }

    /// Opens the line, which stays as long as the page does.
    fn open(&mut self) {
        let stage = crate::browser::dom::document().body().expect("a page has a body");
        let _ = stage.insert_adjacent_html("beforeend", include_str!("codap.html"));
        let view: HtmlElement = find("codap");
        for (button, days) in [(".this", "1"), (".all", "")] {
            std::mem::forget(on(&within::<Element>(&view, button), "click", move |_: Event| {
                with(|studio| studio.codap.send(days));
            }));
        }
        self.phone = Phone::ring(|resource| {
            let link = || json_text(subject::link_of(&subject::address()));
            (resource == "interactiveState").then(|| format!(r#"{{"link":{}}}"#, link()))
        });
        let Some(phone) = self.phone.clone() else {
            return say("This address is for CODAP: open it there as a plugin.");
        };
        say("Waiting for CODAP …");
        spawn_local(async move {
            let met = phone.clone().ask(FRAME.to_string()).await;
            match met {
                Ok(_) => say("Connected to CODAP."),
                Err(why) => return say(&why),
            }
            // A document that is opened again shows what it showed.
            if let Ok(frame) = phone.ask(ASK_FRAME.to_string()).await {
                let state = crate::browser::dom::member(&frame, "savedState");
                let kept = crate::browser::dom::member(&state, "link").as_string();
                if let Some(kept) = kept.filter(|kept| !kept.is_empty()) {
                    subject::show(&kept);
                }
            }
        });
    }

    /// Sends the day on the screen, or all days, or the pictures of a series.
    fn send(&mut self, days: &'static str) {
        if asked_view(&fragment()).is_some() {
            return self.send_pictures();
        }
        let mut scene = link::read(subject::link_of(&subject::address()), plants::all()).scene;
        if days.is_empty() {
            scene.day = scene.recipe.days;
        }
        say("Growing the plant for its numbers …");
        self.work = None;
        spawn_local(async move {
            let mesh = subject::mesh_of(&scene).await;
            with(|studio| studio.codap.grow(scene, days, mesh));
        });
    }

    fn grow(&mut self, scene: Scene, days: &str, mesh: Result<String, String>) {
        let link = link::write(&scene);
        let hear = move |said: Said| with(|studio| studio.codap.hear(&scene, said));
        let started = mesh
            .map_err(|why| format!("The plant's body did not come: {why}."))
            .and_then(|mesh| Work::start([NUMBERS, &link, &mesh], days, hear));
        match started {
            Ok(work) => self.work = Some(work),
            Err(why) => say(&why),
        }
    }

    fn hear(&mut self, scene: &Scene, said: Said) {
        match said {
            Said::Day(_) => {}
            Said::Refused(why) => {
                self.work = None;
                say(&why);
            }
            Said::Done(answer) => {
                let Ok(row) = answer.get(0).dyn_into::<Float64Array>() else {
                    self.work = None;
                    return;
                };
                let Some(now) = DayNumbers::of_row(&row.to_vec()) else { return };
                let fingerprint = answer.get(1).as_string().unwrap_or_default();
                let link = link::write(&Scene { day: now.day, ..scene.clone() });
                let case = day_case(scene, &now, &fingerprint, &address());
                self.add(&CODAP_DAYS, vec![(link, case)]);
            }
        }
    }

    fn send_pictures(&mut self) {
        let address = address();
        let cases = pictures().into_iter().map(|(grown, label)| {
            let case = individual_case(&grown, &label, &address);
            (link::write(&grown.scene), case)
        });
        self.add(&CODAP_INDIVIDUALS, cases.collect());
    }

    /// Adds cases to a table, each once, which is made first if it has to be.
    fn add(&mut self, table: &'static CodapTable, cases: Vec<(String, String)>) {
        let Some(phone) = self.phone.clone() else { return };
        let fresh: Vec<(String, String)> =
            cases.into_iter().filter(|(link, _)| !self.sent.contains(link)).collect();
        if fresh.is_empty() {
            return say("CODAP has that already.");
        }
        self.sent.extend(fresh.iter().map(|(link, _)| link.clone()));
        let is_known = self.tables.contains(&table.name);
        self.tables.push(table.name);
        spawn_local(async move {
            let (links, cases): (Vec<String>, Vec<String>) = fresh.into_iter().unzip();
            match send(phone, table, is_known, &cases).await {
                Ok(()) => with(|studio| {
                    let count = studio.codap.sent.len();
                    say(&format!("{count} cases are in CODAP."));
                }),
                Err(why) => with(|studio| {
                    studio.codap.sent.retain(|link| !links.contains(link));
                    studio.codap.tables.retain(|name| *name != table.name);
                    say(&why);
                }),
            }
        });
    }
}

async fn send(
    phone: Rc<Phone>,
    table: &CodapTable,
    is_known: bool,
    cases: &[String],
) -> Result<(), String> {
    if !is_known {
        if phone.clone().ask(table.ask()).await.is_err() {
            phone.clone().ask(table.make()).await?;
        }
        phone.clone().ask(table.show()).await?;
    }
    phone.ask(table.add(cases)).await.map(|_| ())
}

/// The address of the playground, up to its `#`.
fn address() -> String {
    let href = window().location().href().unwrap_or_default();
    href.split('#').next().unwrap_or_default().to_string()
}

fn say(text: &str) {
    set_text(&within(&find::<Element>("codap"), ".told"), text);
}
