//! The line to CODAP, which has this page in a frame: the protocol of its `iframe-phone`. Both sides say hello; then each may
//! call the other, and is answered by the number of its call.

use crate::browser::dom::{member, on, window};
use crate::browser::studio::presenter::after;
use crate::export::json_text;
use js_sys::{Function, JSON, Promise};
use std::cell::{Cell, RefCell};
use std::collections::HashMap;
use std::rc::Rc;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::JsFuture;
use web_sys::{MessageEvent, Window};

/// What data plugins and CODAP call each other by.
const KIND: &str = "data-interactive";
/// Milliseconds between two hellos, and how often they are said.
const HELLO_MS: i32 = 300;
const MOST_HELLOS: u32 = 200;
/// Milliseconds that an answer may take.
const PATIENCE_MS: i32 = 20_000;

pub struct Phone {
    codap: Window,
    is_there: Cell<bool>,
    /// What is to be sent when it is there.
    waiting: RefCell<Vec<String>>,
    calls: Cell<u32>,
    /// Who waits for an answer, by the number of the call.
    asked: RefCell<HashMap<String, Function>>,
}

impl Phone {
    /// Rings; None where there is no page around this one. `answer` tells CODAP, in JSON, what it asks for by a resource.
    pub fn ring(answer: impl Fn(&str) -> Option<String> + 'static) -> Option<Rc<Phone>> {
        let own = window();
        let codap = own.parent().ok().flatten().filter(|parent| *parent != own)?;
        let phone = Rc::new(Phone {
            codap: codap.clone(),
            is_there: Cell::default(),
            waiting: RefCell::default(),
            calls: Cell::default(),
            asked: RefCell::default(),
        });
        let hears = phone.clone();
        // It is there as long as the page is.
        std::mem::forget(on(&own, "message", move |message: MessageEvent| {
            if message.source().is_some_and(|source| source == *codap.unchecked_ref()) {
                hears.hear(&message.data(), &answer);
            }
        }));
        phone.say_hello(MOST_HELLOS);
        Some(phone)
    }

    /// Asks CODAP for something, in JSON.
    ///
    /// # Errors
    /// In plain words, what CODAP says of it, or that it says nothing.
    pub async fn ask(self: Rc<Self>, request: String) -> Result<JsValue, String> {
        let number = format!("mosaic-{}", self.calls.replace(self.calls.get() + 1));
        let answer = Promise::new(&mut |resolve, _| {
            self.asked.borrow_mut().insert(number.clone(), resolve);
        });
        self.post(format!(
            r#"{{"type":"{KIND}","content":{{"messageType":"call","uuid":"{number}","value":{request}}}}}"#
        ));
        let gives_up = self.clone();
        after(PATIENCE_MS, move || gives_up.answer(&number, &JsValue::UNDEFINED));
        let answer = JsFuture::from(answer).await.unwrap_or_default();
        if answer.is_undefined() {
            return Err("CODAP does not answer.".to_string());
        }
        match member(&answer, "success").as_bool() {
            Some(true) => Ok(member(&answer, "values")),
            _ => {
                let why = member(&member(&answer, "values"), "error").as_string();
                let why = why.unwrap_or_else(|| "it does not say why".to_string());
                Err(format!("CODAP refuses: {why}."))
            }
        }
    }

    fn say_hello(self: &Rc<Self>, more: u32) {
        if self.is_there.get() || more == 0 {
            return;
        }
        self.send(r#"{"type":"hello"}"#);
        let again = self.clone();
        after(HELLO_MS, move || again.say_hello(more - 1));
    }

    fn post(&self, message: String) {
        match self.is_there.get() {
            true => self.send(&message),
            false => self.waiting.borrow_mut().push(message),
        }
    }

    fn send(&self, message: &str) {
        if let Ok(message) = JSON::parse(message) {
            // Who frames the page may know what it shows.
            let _ = self.codap.post_message(&message, "*");
        }
    }

    fn hear(&self, said: &JsValue, answer: &impl Fn(&str) -> Option<String>) {
        // Old browsers had texts only.
        let said = match said.as_string() {
            Some(text) => JSON::parse(&text).unwrap_or_default(),
            None => said.clone(),
        };
        let content = member(&said, "content");
        let text = |of: &JsValue, name: &str| member(of, name).as_string().unwrap_or_default();
        match (&*text(&said, "type"), &*text(&content, "messageType")) {
            ("hello", _) if !self.is_there.replace(true) => {
                self.waiting.take().iter().for_each(|message| self.send(message));
            }
            (KIND, "returnValue") => {
                self.answer(&text(&content, "uuid"), &member(&content, "value"));
            }
            (KIND, "call") => {
                let values = answer(&text(&member(&content, "value"), "resource"));
                let values =
                    values.map_or(String::new(), |values| format!(r#","values":{values}"#));
                self.send(&format!(
                    r#"{{"type":"{KIND}","content":{{"messageType":"returnValue","uuid":{},"value":{{"success":true{values}}}}}}}"#,
                    json_text(&text(&content, "uuid"))
                ));
            }
            _ => {}
        }
    }

    fn answer(&self, number: &str, value: &JsValue) {
        let resolve = self.asked.borrow_mut().remove(number);
        if let Some(resolve) = resolve {
            let _ = resolve.call1(&JsValue::NULL, value);
        }
    }
}
