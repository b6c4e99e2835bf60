//! Files from and to the visitor's machine.

use super::bring_in;
use super::subject::{self, link_of};
use super::wish::OPEN;
use super::with;
use super::work::{Said, Work};
use crate::browser::dom::{document, find, on, set_flag, window};
use js_sys::{Array, Uint8Array};
use wasm_bindgen::JsCast;
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{Blob, BlobPropertyBag, DragEvent, Element, File, HtmlAnchorElement, Url};

/// Hands bytes to the visitor as a file.
pub fn save(name: &str, bytes: &Uint8Array) {
    let kind = BlobPropertyBag::new();
    kind.set_type("application/octet-stream");
    let blob = Blob::new_with_u8_array_sequence_and_options(&Array::of1(bytes), &kind);
    let address = blob.and_then(|blob| Url::create_object_url_with_blob(&blob));
    let link =
        document().create_element("a").ok().and_then(|a| a.dyn_into::<HtmlAnchorElement>().ok());
    if let (Ok(address), Some(link)) = (address, link) {
        link.set_href(&address);
        link.set_download(name);
        link.click();
        // The browser reads it in its own time; a minute is ample for any disk.
        let forget = wasm_bindgen::closure::Closure::once_into_js(move || {
            let _ = Url::revoke_object_url(&address);
        });
        let forget = forget.unchecked_ref();
        let _ = window().set_timeout_with_callback_and_timeout_and_arguments_0(forget, 60_000);
    }
}

/// Opens files that are dropped on the page.
pub fn take_what_is_dropped() {
    let listener = on(&document(), "drop", |event: DragEvent| {
        event.prevent_default();
        let files = event.data_transfer().and_then(|data| data.files());
        if let Some(file) = files.and_then(|files| files.get(0)) {
            open(file);
        }
    });
    std::mem::forget(listener);
}

/// Shows the plant of a file on the page, or says why not.
pub fn open(file: File) {
    spawn_local(async move {
        let name = file.name();
        let is_picture = file.type_().starts_with("image/") && !file.type_().contains("svg");
        let Ok(buffer) = JsFuture::from(file.array_buffer()).await else {
            return tell(&format!("{name} cannot be read."));
        };
        let hear = move |said: Said| {
            match said {
                Said::Day(_) => {}
                // A picture of anything else.
                Said::Refused(_) if is_picture => bring_in::look(file.clone()),
                Said::Refused(why) => tell(&format!("{name}: {why}")),
                Said::Done(answer) => subject::show(&answer.get(0).as_string().unwrap_or_default()),
            }
            with(|studio| studio.opening = None);
        };
        let now = subject::address();
        let work = Work::start([OPEN, link_of(&now), ""], Uint8Array::new(&buffer), hear);
        match work {
            Ok(work) => with(|studio| studio.opening = Some(work)),
            Err(why) => tell(&why),
        }
    });
}

/// Says it among the messages of the page, until it is dismissed.
pub fn tell(text: &str) {
    let Ok(item) = document().create_element("li") else { return };
    item.set_text_content(Some(text));
    let list: Element = find("message-list");
    list.set_text_content(None);
    let _ = list.append_child(&item);
    set_flag(&find::<Element>("messages"), "hidden", false);
}
