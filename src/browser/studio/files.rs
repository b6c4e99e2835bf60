//! Files from and to the visitor's machine.

use super::subject::{self, link_of};
use super::wish::OPEN;
use super::with;
use super::work::{Said, Work};
use super::{bring_in, own};
use crate::browser::dom::{document, find, member, on, set_flag, window};
use js_sys::{Array, Uint8Array};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::{JsFuture, spawn_local};
use web_sys::{Blob, BlobPropertyBag, DragEvent, Element, File, FileList, HtmlAnchorElement, Url};

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

/// Opens files that are dropped on the page, and what the page has kept of those that came before.
pub fn take_what_is_dropped() {
    if let Some(file) =
        member(&document(), "files").dyn_into::<FileList>().ok().and_then(|files| files.get(0))
    {
        open(file);
    }
    let listener = on(&document(), "drop", |event: DragEvent| {
        event.prevent_default();
        let files = event.data_transfer().and_then(|data| data.files());
        if let Some(file) = files.and_then(|files| files.get(0)) {
            open(file);
        }
    });
    std::mem::forget(listener);
}

/// Endings of files that are taken for bodies: what of them cannot be read is told by the name of its format.
const BODIES: [&str; 8] = ["obj", "ply", "glb", "gltf", "stl", "fbx", "blend", "off"];

/// Shows the plant of a file on the page, or says why not.
pub fn open(file: File) {
    spawn_local(async move {
        let name = file.name();
        let Ok(buffer) = JsFuture::from(file.array_buffer()).await else {
            return tell(&format!("{name} cannot be read."));
        };
        let bytes = Uint8Array::new(&buffer);
        let wish = bytes.clone();
        let hear = move |said: Said| match said {
            Said::Day(_) => {}
            Said::Refused(why) => {
                let end = name.rsplit_once('.').map_or("", |(_, end)| end).to_ascii_lowercase();
                let is_picture = file.type_().starts_with("image/") && end != "svg";
                match () {
                    // A picture of anything else.
                    () if is_picture => bring_in::look(file.clone()),
                    () if end == "json" || BODIES.contains(&&*end) => own::make(&name, &bytes),
                    () => tell(&format!("{name}: {why}")),
                }
            }
            Said::Done(answer) => subject::show(&answer.get(0).as_string().unwrap_or_default()),
        };
        begin([OPEN, link_of(&subject::address()), &subject::own()], wish, hear);
    });
}

/// Has the workshop read what was brought, in the place of what it still may read.
pub fn begin(wish: [&str; 3], more: impl Into<JsValue>, hear: impl Fn(Said) + Clone + 'static) {
    let hear = move |said: Said| {
        let is_done = !matches!(said, Said::Day(_));
        hear(said);
        if is_done {
            with(|studio| studio.opening = None);
        }
    };
    match Work::start(wish, more, hear) {
        Ok(work) => with(|studio| studio.opening = Some(work)),
        Err(why) => tell(&why),
    }
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
