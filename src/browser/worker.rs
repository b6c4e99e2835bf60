//! The worker's thread: wishes in, days out, and time slices between.

use crate::plants;
use crate::play::protocol::{ToPage, ToWorker};
use crate::play::worker::Worker;
use js_sys::Uint32Array;
use std::cell::RefCell;
use wasm_bindgen::prelude::*;
use web_sys::{DedicatedWorkerGlobalScope, MessageChannel, MessageEvent, MessagePort};

/// Milliseconds of growing between two looks at the mailbox. Shorter wastes time on looking, longer
/// lets a new wish wait.
const SLICE_MS: f64 = 12.0;

thread_local! {
    static WORKER: RefCell<Worker> = RefCell::new(Worker::new(plants::all()));
}

/// Starts to listen, and then says hello: what is sent before is lost.
pub fn start_worker() {
    let next_slice = NextSlice::new();
    let hear = Closure::<dyn FnMut(MessageEvent)>::new(move |message: MessageEvent| {
        let words = message.data().dyn_into::<Uint32Array>().map(|w| w.to_vec());
        let wish = words.ok().and_then(|w| ToWorker::from_words(&w).ok());
        let Some(wish) = wish else { return };
        let was_busy = WORKER.with_borrow(Worker::is_busy);
        if let Some(answer) = WORKER.with_borrow_mut(|worker| worker.hear(wish)) {
            post(&answer);
        } else if !was_busy {
            next_slice.ask();
        }
    });
    scope().set_onmessage(Some(hear.as_ref().unchecked_ref()));
    // The worker listens as long as it lives.
    hear.forget();
    post(&Worker::hello());
}

fn slice() -> bool {
    let clock = scope().performance().expect("a worker has a clock");
    let end = clock.now() + SLICE_MS;
    WORKER.with_borrow_mut(|worker| {
        worker.work(|| clock.now() >= end, |answer| post(&answer));
        worker.is_busy()
    })
}

/// A message to oneself: it comes after those that wait in the mailbox, and, unlike a timer, without
/// delay.
#[derive(Clone)]
struct NextSlice(MessagePort);

impl NextSlice {
    fn new() -> NextSlice {
        let channel = MessageChannel::new().expect("a worker can make channels");
        let again = NextSlice(channel.port2());
        let asked = again.clone();
        let work = Closure::<dyn FnMut()>::new(move || {
            if slice() {
                again.ask();
            }
        });
        channel.port1().set_onmessage(Some(work.as_ref().unchecked_ref()));
        work.forget();
        asked
    }

    fn ask(&self) {
        self.0.post_message(&JsValue::NULL).expect("an empty message can be sent");
    }
}

fn post(answer: &ToPage) {
    let words = Uint32Array::from(answer.to_words().as_slice());
    let transfer = js_sys::Array::of1(&words.buffer());
    scope().post_message_with_transfer(&words, &transfer).expect("words can be sent");
}

fn scope() -> DedicatedWorkerGlobalScope {
    js_sys::global().unchecked_into()
}
