//! What is kept of the page for when there is no network, and when it is taken from there.
//!
//! What is kept is one build and all of it, so that no page is ever put together from two.

use super::protocol::BUILD;

/// The address of the page, relative to the folder in which it lies.
pub const PAGE: &str = "./";

/// One build in the keeping of a browser.
pub struct Kept {
    addresses: Vec<String>,
}

/// How a request is answered.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Answer {
    /// By the network as ever: nothing of ours.
    AsEver,
    /// With what is kept at an address, which never changes.
    Kept(String),
    /// By the network, so that a new build is seen at once; without one, with what is kept.
    NetworkFirst(String),
}

impl Kept {
    /// Of the files of a build, in one line, what is kept.
    pub fn new(files: &str, with_webgl2: bool) -> Kept {
        let is_wanted = |name: &&str| with_webgl2 || !name.contains("/page_gl");
        Kept { addresses: files.split_whitespace().filter(is_wanted).map(address).collect() }
    }

    /// The addresses that are kept, relative to the folder of the page.
    pub fn addresses(&self) -> impl Iterator<Item = &str> {
        self.addresses.iter().map(String::as_str)
    }

    /// How a request of our host is answered, by its address within the folder of the page.
    pub fn answer(&self, within: &str, is_navigation: bool) -> Answer {
        let within = within.split('#').next().unwrap_or_default();
        let path = within.split('?').next().unwrap_or_default();
        if is_navigation {
            let is_page = matches!(path, "" | "index.html");
            return if is_page { Answer::NetworkFirst(PAGE.into()) } else { Answer::AsEver };
        }
        match self.addresses().find(|&kept| kept == within) {
            None => Answer::AsEver,
            Some(kept) if never_changes(kept) => Answer::Kept(kept.to_string()),
            Some(kept) => Answer::NetworkFirst(kept.to_string()),
        }
    }
}

/// Whether an address has the same content in every build that has it: it is named by its content, or
/// asks for one build.
pub fn never_changes(address: &str) -> bool {
    let stem = address.split(['.', '_']).next().unwrap_or_default();
    let hash = stem.rsplit('-').next().unwrap_or_default();
    let is_hashed = hash.len() == 16 && hash.bytes().all(|b| b.is_ascii_hexdigit());
    is_hashed || address.starts_with("bundles-") || address.contains("?build=")
}

/// Where the page asks for a file of a build.
fn address(file: &str) -> String {
    match file {
        "index.html" => PAGE.to_string(),
        of_build
            if ["figures.txt", "meshes/", "words/"].iter().any(|way| of_build.starts_with(way)) =>
        {
            format!("{of_build}?build={BUILD}")
        }
        other => other.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILES: &str = "boot-647a205ab64d1fe6.js boot-647a205ab64d1fe6_bg.wasm \
        bundles-44054/page.js bundles-44054/page_bg.wasm bundles-44054/page_gl_bg.wasm index.html \
        meshes/cap.obj posters/square-watermelon.avif style-242baa513e61be72.css ";

    #[test]
    fn one_build_is_kept_whole() {
        let kept: Vec<String> = Kept::new(FILES, true).addresses().map(String::from).collect();
        assert_eq!(kept.len(), 9);
        assert!(kept.contains(&"./".to_string()) && !kept.contains(&"index.html".to_string()));
        assert!(kept.contains(&format!("meshes/cap.obj?build={BUILD}")));
        let without = Kept::new(FILES, false);
        assert_eq!(without.addresses().count(), 8);
        assert!(without.addresses().all(|address| !address.contains("page_gl")));
    }

    #[test]
    fn pages_are_fresh_and_what_never_changes_is_at_hand() {
        let kept = Kept::new(FILES, false);
        for page in ["", "#croton?v=1&s=1", "?from=mail", "index.html"] {
            assert_eq!(kept.answer(page, true), Answer::NetworkFirst("./".into()), "{page}");
        }
        let mesh = format!("meshes/cap.obj?build={BUILD}");
        for file in ["boot-647a205ab64d1fe6_bg.wasm", "bundles-44054/page.js", &mesh] {
            assert_eq!(kept.answer(file, false), Answer::Kept(file.into()));
        }
        let poster = "posters/square-watermelon.avif";
        assert_eq!(kept.answer(poster, false), Answer::NetworkFirst(poster.into()));
    }

    #[test]
    fn what_is_not_of_this_build_is_not_touched() {
        let kept = Kept::new(FILES, false);
        for other in [
            "meshes/cap.obj?build=0",
            "meshes/cap.obj",
            "bundles-1/page.js",
            "bundles-44054/page_gl_bg.wasm",
            "offline.js",
        ] {
            assert_eq!(kept.answer(other, false), Answer::AsEver, "{other}");
        }
        // Another page that happens to lie below ours.
        assert_eq!(kept.answer("other/", true), Answer::AsEver);
    }
}
