//! Where the files of the playground come from: from its host, or, in the edition of one file, from
//! elements of the page that hold them, whose ids are the paths of the files.

use super::dom::{document, set_attribute, window};
use crate::play::protocol::BUILD;
use js_sys::Array;
use wasm_bindgen::JsCast;
use wasm_bindgen_futures::JsFuture;
use web_sys::{Blob, BlobPropertyBag, Response, Url, Worker, WorkerOptions, WorkerType};

/// The address of a file, given its path beside the page; a query counts for a host only.
pub fn address(path: &str) -> String {
    let name = path.split_once('?').map_or(path, |(name, _)| name);
    let Some(holder) = document().get_element_by_id(name) else { return path.to_string() };
    // Pictures have an address that holds them; other files get one when they are first asked for.
    holder.get_attribute("href").unwrap_or_else(|| {
        let address = address_of_text(&holder.text_content().unwrap_or_default());
        set_attribute(&holder, "href", &address);
        address
    })
}

/// What stands in a file that the page holds, given its path.
pub fn held(path: &str) -> Option<String> {
    document().get_element_by_id(path)?.text_content()
}

/// Has the page hold the text of a file from now on.
pub fn hold(path: &str, text: &str) {
    if document().get_element_by_id(path).is_none()
        && let Ok(holder) = document().create_element("script")
    {
        set_attribute(&holder, "type", "text/plain");
        set_attribute(&holder, "id", path);
        holder.set_text_content(Some(text));
        let _ = document().head().expect("a page has a head").append_child(&holder);
    }
}

/// The path of a mesh file, or of the plant of a file of its own by its key.
pub fn mesh(name: &str) -> String {
    format!("meshes/{}.txt", name.strip_suffix(".obj").unwrap_or(name))
}

/// The text of a mesh file, packed or plain; in an error, why it cannot be had.
pub async fn read_mesh(name: &str) -> Result<String, String> {
    read(&mesh(name)).await
}

/// The text of a file of this build; in an error, why it cannot be had.
pub async fn read(path: &str) -> Result<String, String> {
    match held(path) {
        Some(text) => Ok(text),
        None => read_text(&address(&format!("{path}?build={BUILD}"))).await,
    }
}

/// The address of a file in the folder of bundles, whose name tells builds apart.
pub fn in_bundles(file: &str) -> String {
    let root = document().document_element();
    let folder = root.and_then(|root| root.get_attribute("data-bundles"));
    address(&[&folder.unwrap_or_default(), "/", file].concat())
}

/// Whether this is the edition of one file.
#[cfg(feature = "draw")]
pub fn are_in_the_page() -> bool {
    document().get_element_by_id("posters/croton.avif").is_some()
}

/// Whether an address leads to what the page itself holds.
pub fn is_held(address: &str) -> bool {
    address.starts_with("blob:")
}

/// Starts a bundle as a worker; None where the browser starts none.
pub fn start_worker(bundle: &str) -> Option<Worker> {
    let address = in_bundles(&format!("{bundle}.js"));
    if is_held(&address) {
        return Worker::new(&address).ok();
    }
    // In a locked frame the page is a stranger to its own host, and may start only what it made.
    if window().origin() == "null" {
        let base = document().base_uri().ok().flatten().unwrap_or_default();
        let address = Url::new_with_base(&address, &base).ok()?.href();
        return Worker::new(&address_of_text(&format!("import(\"{address}\")"))).ok();
    }
    let options = WorkerOptions::new();
    options.set_type(WorkerType::Module);
    Worker::new_with_options(&address, &options).ok()
}

/// What stands in a text file; in an error, why it cannot be had.
pub async fn read_text(address: &str) -> Result<String, String> {
    let answer = JsFuture::from(window().fetch_with_str(address)).await;
    let answer: Response = answer.map_err(|_| "no connection")?.unchecked_into();
    if !answer.ok() {
        return Err(format!("the server answers {}", answer.status()));
    }
    let text = JsFuture::from(answer.text().map_err(|_| "no text")?).await;
    text.ok().and_then(|text| text.as_string()).ok_or_else(|| "the connection broke".to_string())
}

/// An address, within this page, of a text: scripts must say what they are, others may say the same.
fn address_of_text(text: &str) -> String {
    let kind = BlobPropertyBag::new();
    kind.set_type("text/javascript");
    let blob = Blob::new_with_str_sequence_and_options(&Array::of1(&text.into()), &kind);
    blob.and_then(|blob| Url::create_object_url_with_blob(&blob)).unwrap_or_default()
}
