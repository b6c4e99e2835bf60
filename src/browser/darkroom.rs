//! The studio's darkroom: a worker that grows a plant once more and draws what is larger than the screen or longer
//! than a moment. It is a bundle of its own, with a renderer that draws with WebGL2 on a canvas that nobody sees, so
//! that the page goes on as it was. Each frame is drawn for its own moment: no clock has a part in it.

mod easel;
mod encoder;
mod film;
mod paper;
mod sheet;

use super::studio::wish;
use crate::plants;
use crate::play::{link, origin};
use crate::surface::unpack;
use js_sys::{Array, Function, Promise, Uint8Array};
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{DedicatedWorkerGlobalScope, MessageEvent};

/// Listens for its one wish, which `studio/wish.rs` describes with its answers, and says hello before.
pub fn listen() {
    let hear = Closure::<dyn FnMut(MessageEvent)>::new(|message: MessageEvent| {
        let wish: Array = message.data().unchecked_into();
        spawn_local(async move {
            match develop(&wish).await {
                Ok(bytes) => post(&Array::of2(&"".into(), &Uint8Array::from(&bytes[..]))),
                Err(why) => post(&why.into()),
            }
        });
    });
    scope().set_onmessage(Some(hear.as_ref().unchecked_ref()));
    hear.forget();
    post(&JsValue::NULL);
}

async fn develop(wish: &Array) -> Result<Vec<u8>, String> {
    let [wanted, link, mesh] = [0, 1, 2].map(|k| text(wish, k));
    let more: Array = wish.get(3).unchecked_into();
    // The mesh of a plant of the visitor's own says it.
    plants::bring(&mesh);
    let mesh = unpack(&mesh);
    let scene = link::read(origin::learn(&link), plants::all()).scene;
    match &*wanted {
        wish::FILM => film::film(&scene, &mesh, &more).await,
        _ => sheet::sheet(&scene, &mesh, &more).await,
    }
}

fn text(array: &Array, k: u32) -> String {
    array.get(k).as_string().unwrap_or_default()
}

/// Tells how many steps are done.
fn tell(step: u32) {
    post(&step.into());
}

/// Lets the browser do what waits: encode, and tell of a graphics card that is lost.
async fn a_moment() {
    let mut wait = |done: Function, _: Function| {
        // Fails for no function.
        let _ = scope().set_timeout_with_callback_and_timeout_and_arguments_0(&done, 0);
    };
    let _ = JsFuture::from(Promise::new(&mut wait)).await;
}

fn post(answer: &JsValue) {
    scope().post_message(answer).expect("texts and bytes can be sent");
}

fn scope() -> DedicatedWorkerGlobalScope {
    js_sys::global().unchecked_into()
}
