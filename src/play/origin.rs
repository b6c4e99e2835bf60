//! What a plant of the visitor's own is made of, where words can say that: a body by rule, or strokes on another plant.
//! The words stand behind the `~` of its link, which opens anywhere with them: `own-k3f7a2?v=2&d=20~leaf=lobes:7`.

use super::{Scene, link};
use std::cell::RefCell;

/// How words of strokes begin.
pub const PAINTED: &str = "painted/";

/// How such words begin.
const KINDS: [&str; 4] = ["leaf=", "tree=", "flower=", PAINTED];

thread_local! {
    /// The words of plants, by their keys.
    static KNOWN: RefCell<Vec<(String, String)>> = const { RefCell::new(Vec::new()) };
}

/// Of what stands behind a link what the plant is made of, and all else, both with their `~`.
pub fn parts(beside: &str) -> [String; 2] {
    let mut parts = [String::new(), String::new()];
    for part in beside.split('~').filter(|part| !part.is_empty()) {
        let is_other = !KINDS.iter().any(|kind| part.starts_with(kind));
        let part_of = &mut parts[usize::from(is_other)];
        *part_of = format!("{part_of}~{part}");
    }
    parts
}

/// Remembers what the plant of a key is made of, as long as the program runs.
pub fn know(key: &str, words: &str) {
    KNOWN.with_borrow_mut(|known| {
        known.retain(|(of, _)| of != key);
        known.push((key.to_string(), words.to_string()));
    });
}

/// What the plant of a link is made of, with its `~`; empty if that is not known, or no matter.
pub fn of_link(link: &str) -> String {
    KNOWN.with_borrow(|known| {
        let words = known.iter().find(|(key, _)| key == key_of(link)).map(|(_, words)| words);
        words.map_or(String::new(), |words| format!("~{words}"))
    })
}

/// The key of the plant that was made of words.
pub fn made_of(words: &str) -> Option<String> {
    KNOWN.with_borrow(|known| known.iter().find(|(_, of)| of == words).map(|(key, _)| key.clone()))
}

/// A link without what stands behind it, of which it remembers what the plant is made of.
pub fn learn(link: &str) -> &str {
    let Some((link, beside)) = link.split_once('~') else { return link };
    let [origin, _] = parts(beside);
    if let Some(words) = origin.strip_prefix('~') {
        know(key_of(link), words);
    }
    link
}

/// The link of a scene, with what its plant is made of.
pub fn whole_link(scene: &Scene) -> String {
    let link = link::write(scene);
    let origin = of_link(&link);
    link + &origin
}

fn key_of(link: &str) -> &str {
    link.trim_start_matches('#').split(['?', '~']).next().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_link_says_what_its_plant_is_made_of_once_that_is_known() {
        let (link, words) = ("own-origin?v=2&s=1&d=3", "painted/croton/2/f.500.w.k00");
        assert_eq!(of_link(link), "");
        assert_eq!(learn(link), link);
        assert_eq!(learn(&format!("{link}~present~{words}")), link);
        assert_eq!(of_link(&format!("#{link}")), format!("~{words}"));
        assert_eq!(of_link("own-other?v=2&s=1&d=3"), "");
        assert_eq!(made_of(words).as_deref(), Some("own-origin"));
        know("own-origin", "leaf=lobes:7");
        assert_eq!((of_link("own-origin"), made_of(words)), ("~leaf=lobes:7".to_string(), None));
    }

    #[test]
    fn what_stands_behind_a_link_is_told_apart() {
        let both = parts("~class/take~leaf=lobes:7,size:2~ui=play");
        assert_eq!(both, ["~leaf=lobes:7,size:2", "~class/take~ui=play"]);
        assert_eq!(parts(""), ["", ""]);
    }
}
