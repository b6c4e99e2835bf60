//! The page without a network: asking the browser to keep it, and the service worker that does so.
//! What is kept, and when it is taken from there, is decided in `play`.

#[cfg(feature = "draw")]
use super::{dom, files};
use crate::play::offline::{Answer, Kept, never_changes};
#[cfg(feature = "draw")]
use std::cell::Cell;
use std::rc::Rc;
use wasm_bindgen::convert::FromWasmAbi;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::{JsFuture, future_to_promise};
use web_sys::{
    Cache, ExtendableEvent, FetchEvent, Request, RequestCache, RequestInit, RequestMode,
    ServiceWorkerGlobalScope,
};

/// The script of the service worker, in the folder of the page.
const SCRIPT: &str = "offline.js";

/// The same where WebGL2 is drawn with, whose large bundle is kept only then.
const SCRIPT_WITH_WEBGL2: &str = "offline.js?webgl2";

#[cfg(feature = "draw")]
#[wasm_bindgen]
extern "C" {
    // web-sys would not catch what a frame without an origin throws, nor that there is none at all; nor
    // would an import that is `async`.
    #[wasm_bindgen(catch, js_namespace = ["navigator", "serviceWorker"], js_name = register)]
    fn register_script(address: &str) -> Result<js_sys::Promise, JsValue>;
}

#[cfg(feature = "draw")]
thread_local! {
    static IS_ASKED: Cell<bool> = const { Cell::new(false) };
}

/// Asks the browser, once, to keep the page, and offers to install it: what that takes is not asked for
/// before. Where it does not, the page lives as well: nobody is told.
#[cfg(feature = "draw")]
pub fn keep_page() {
    if IS_ASKED.replace(true) || files::are_in_the_page() {
        return;
    }
    let manifest = dom::find::<web_sys::Element>("manifest");
    dom::set_attribute(&manifest, "href", "install/manifest.webmanifest");
    let address = if super::backend::IS_WEBGL_BUNDLE { SCRIPT_WITH_WEBGL2 } else { SCRIPT };
    if let Ok(asked) = register_script(address) {
        wasm_bindgen_futures::spawn_local(async {
            let _ = JsFuture::from(asked).await;
        });
    }
}

/// Runs as the service worker that keeps a build, of which all files are named.
///
/// It must listen when its script has run once, so this is called at once. A new build waits until no tab
/// has a page of the old one: that one stays whole as long.
pub fn keep(build: &str, files: &str) {
    let script = scope().location().href();
    let kept = Rc::new(Kept::new(files, script.ends_with(SCRIPT_WITH_WEBGL2)));
    // Other pages of this host have caches, too.
    let name: Rc<str> = format!("{script} {build}").into();

    let (list, cache) = (kept.clone(), name.clone());
    on("install", move |event: ExtendableEvent| {
        let (list, cache) = (list.clone(), cache.clone());
        let _ = event.wait_until(&future_to_promise(async move { fill(&cache, &list).await }));
    });
    let cache = name.clone();
    on("activate", move |event: ExtendableEvent| {
        let cache = cache.clone();
        let _ = event.wait_until(&future_to_promise(async move { clear_but(&cache).await }));
    });
    on("fetch", move |event: FetchEvent| {
        let request = event.request();
        let address = request.url();
        let Some(within) = address.strip_prefix(&*folder()) else { return };
        let is_navigation = request.mode() == RequestMode::Navigate;
        let answer = match request.method().as_str() {
            "GET" => kept.answer(within, is_navigation),
            _ => Answer::AsEver,
        };
        let cache = name.clone();
        let answered = match answer {
            Answer::AsEver => return,
            Answer::Kept(address) => future_to_promise(async move {
                let held = held(&cache, &address).await?;
                if held.is_undefined() { fetch(&request).await } else { Ok(held) }
            }),
            Answer::NetworkFirst(address) => future_to_promise(async move {
                match fetch(&request).await {
                    Ok(answer) => Ok(answer),
                    Err(_) => held(&cache, &address).await,
                }
            }),
        };
        let _ = event.respond_with(&answered);
    });
}

/// Fetches all that is kept, or nothing: half a page is none.
async fn fill(cache: &str, kept: &Kept) -> Result<JsValue, JsValue> {
    let requests = js_sys::Array::new();
    for address in kept.addresses() {
        let how = RequestInit::new();
        if !never_changes(address) {
            // An old copy in the browser's other cache would not fit to the rest.
            how.set_cache(RequestCache::NoCache);
        }
        let request = Request::new_with_str_and_init(address, &how)?;
        requests.push(&request);
    }
    JsFuture::from(open(cache).await?.add_all_with_request_sequence(&requests)).await
}

/// Forgets the builds before this one.
async fn clear_but(cache: &str) -> Result<JsValue, JsValue> {
    let caches = scope().caches()?;
    let ours = format!("{}{SCRIPT}", folder());
    let names: js_sys::Array = JsFuture::from(caches.keys()).await?.unchecked_into();
    for name in names.iter().filter_map(|name| name.as_string()) {
        if name.starts_with(&ours) && name != cache {
            JsFuture::from(caches.delete(&name)).await?;
        }
    }
    Ok(JsValue::UNDEFINED)
}

async fn held(cache: &str, address: &str) -> Result<JsValue, JsValue> {
    JsFuture::from(open(cache).await?.match_with_str(address)).await
}

async fn open(cache: &str) -> Result<Cache, JsValue> {
    Ok(JsFuture::from(scope().caches()?.open(cache)).await?.unchecked_into())
}

async fn fetch(request: &Request) -> Result<JsValue, JsValue> {
    JsFuture::from(scope().fetch_with_request(request)).await
}

/// The address of the folder in which the page lies.
fn folder() -> String {
    let script = scope().location().href();
    script.split_once(SCRIPT).map_or(script.clone(), |(folder, _)| folder.to_string())
}

/// Listens as long as the service worker lives.
fn on<E: FromWasmAbi + 'static>(kind: &str, hear: impl FnMut(E) + 'static) {
    let hear = Closure::<dyn FnMut(E)>::new(hear).into_js_value();
    let _ = scope().add_event_listener_with_callback(kind, hear.unchecked_ref());
}

fn scope() -> ServiceWorkerGlobalScope {
    js_sys::global().unchecked_into()
}
