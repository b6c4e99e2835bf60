//! What an address asks to see side by side: the figures, or a series of pictures made from links
//! that give several values to a number: `nursery/croton?v=1&s=1..12`, `steps/croton?v=1&pf=0.1,0.5&s=1..3`,
//! `compare/croton?v=1/cactus?v=1`.

use super::figures::{self, Figure, Picture};
use super::parameters::{PARAMETERS, Parameter};
use super::{Scene, link};
use crate::plants;
use crate::surface::holds;

/// Pictures of a series at most. Of a nursery of so many the days are thinned out; see `gallery::Row`.
pub const MOST_PICTURES: usize = 60;

/// A way to look at several plants.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct View {
    /// Its word in addresses.
    pub key: &'static str,
    pub title: &'static str,
    caption: &'static str,
}

const VIEWS: [View; 4] = [
    View { key: "figures", title: "Figures", caption: "" },
    View {
        key: "nursery",
        title: "Nursery",
        caption: "One recipe, many individuals: chance alone tells them apart. Drag one to turn all.",
    },
    View {
        key: "steps",
        title: "In steps",
        caption: "Below each picture stands what tells it from the others. Drag one to turn all.",
    },
    View {
        key: "compare",
        title: "Side by side",
        caption: "Below each plant stands what tells it from the others. Drag one to turn all.",
    },
];

/// The view that the fragment of an address asks for, and what of it, empty for all; None if it asks for a plant.
pub fn asked_view(fragment: &str) -> Option<(&'static View, &str)> {
    let fragment = fragment.trim_start_matches('#');
    let (key, rest) = fragment.split_once('/').unwrap_or((fragment, ""));
    Some((VIEWS.iter().find(|view| view.key == key)?, rest))
}

impl View {
    /// The rows of what is asked for. Those of a series are there for as long as the page is: a few kilobytes.
    pub fn rows(&self, rest: &'static str) -> Vec<&'static Figure> {
        if self.is_of_figures() {
            return figures::all().iter().collect();
        }
        let links: Vec<String> = rest.split('/').flat_map(several).take(MOST_PICTURES).collect();
        let mut caption = self.caption.to_string();
        let mut scenes: Vec<Scene> = Vec::new();
        for opened in links.iter().map(|link| link::read(link, plants::all())) {
            for told in opened.left_out {
                // Most links of a series say the same.
                if !holds(&caption, &told) {
                    caption += " ";
                    caption += &told;
                }
            }
            scenes.push(opened.scene);
        }
        let pictures = scenes.iter().map(|scene| Picture {
            label: label(scene, &scenes).leak(),
            link: link::write(scene).leak(),
        });
        let pictures = pictures.collect::<Vec<_>>().leak();
        let (title, caption) = (self.title, caption.leak());
        vec![Box::leak(Box::new(Figure { number: rest, title, caption, pictures }))]
    }

    pub fn is_of_figures(&self) -> bool {
        self.key == "figures"
    }
}

/// What is asked of a view once its pictures, of these links, have been turned or zoomed: each link says from where its
/// first picture is seen now.
pub fn turned(asked: &str, pictures: &[String]) -> String {
    let mut first = 0;
    let links = asked.split('/').map(|link| {
        let picture = pictures.get(first).map_or("", |picture| picture);
        first += several(link).len();
        let is_view = |word: &&str| word.starts_with("view=");
        let (plant, query) = link.split_once('?').unwrap_or((link, ""));
        let kept = query.split('&').filter(|word| !is_view(word) && !word.is_empty());
        let words: Vec<&str> = kept.chain(picture.split(['?', '&']).filter(is_view)).collect();
        if words.is_empty() { plant.to_string() } else { format!("{plant}?{}", words.join("&")) }
    });
    links.collect::<Vec<_>>().join("/")
}

/// The links that a link stands for in which words have several values, `1..12` or `0.1,0.5`. Views have commas
/// of their own.
fn several(link: &str) -> Vec<String> {
    let (plant, query) = link.split_once('?').unwrap_or((link, ""));
    let mut links = vec![format!("{plant}?")];
    for word in query.split('&') {
        let (key, value) = word.split_once('=').unwrap_or((word, ""));
        let range = value.split_once('.').and_then(|(first, last)| {
            let [first, last] = [first, last.strip_prefix('.')?].map(|end| end.parse::<u32>().ok());
            Some(first?..=last?)
        });
        let values: Vec<String> = match range {
            Some(range) => range.take(MOST_PICTURES).map(|n| n.to_string()).collect(),
            None if key == "view" => vec![value.to_string()],
            None => value.split(',').map(str::to_string).collect(),
        };
        let with = |value| links.iter().map(move |link| format!("{link}&{key}={value}"));
        links = values.iter().flat_map(with).take(MOST_PICTURES).collect();
    }
    links
}

/// What tells a scene from the others of its series.
fn label(scene: &Scene, all: &[Scene]) -> String {
    let plant = scene.plant;
    let differs = |tell: &dyn Fn(&Scene) -> f64| all.iter().any(|s| tell(s) != tell(scene));
    let mut parts = Vec::new();
    if all.iter().any(|other| other.plant.key != plant.key) {
        parts.push(plant.name.to_string());
    }
    // Another plant has all numbers of its own: its name says them.
    let of_plant = |s: &&Scene| s.plant.key == plant.key;
    let varies = |p: &Parameter| all.iter().filter(of_plant).any(|s| p.get(s) != p.get(scene));
    let numbers = PARAMETERS.iter().filter(|p| p.is_for(plant) && varies(p));
    parts.extend(numbers.map(|p| format!("{} {}", p.label(plant), p.written(p.get(scene)))));
    if differs(&|s| s.noise.into()) {
        parts.push(if scene.noise { "Perlin noise" } else { "clones" }.to_string());
    }
    if differs(&|s| s.individual.into()) {
        parts.push(format!("individual {}", scene.individual));
    }
    if differs(&|s| s.day.into()) || parts.is_empty() {
        parts.push(format!("day {}", scene.day));
    }
    parts.join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pictures(fragment: &'static str) -> Vec<(&'static str, &'static str)> {
        let (view, rest) = asked_view(fragment).expect("a view");
        let [row] = view.rows(rest)[..] else { panic!("one row") };
        row.pictures.iter().map(|picture| (picture.label, picture.link)).collect()
    }

    #[test]
    fn an_address_asks_for_a_view_or_a_plant() {
        let asked = |fragment| asked_view(fragment).map(|(view, rest)| (view.key, rest));
        assert_eq!(asked("#figures"), Some(("figures", "")));
        assert_eq!(asked("figures/4.8"), Some(("figures", "4.8")));
        assert_eq!(asked("#nursery/croton?s=1..3"), Some(("nursery", "croton?s=1..3")));
        assert_eq!(["#", "#croton?v=1", "#figuresque", "nurseries/croton"].map(asked), [None; 4]);
    }

    #[test]
    fn ranges_and_lists_make_pictures_that_say_what_differs() {
        assert_eq!(
            pictures("nursery/croton?v=1&s=4..6&d=12"),
            [4, 5, 6].map(|n| {
                let label: &str = format!("individual {n}").leak();
                (label, &*format!("croton?v=1&s={n}&d=12").leak())
            })
        );
        let steps = pictures("steps/cactus?v=1&s=1,7&d=9&df=5,20&view=10,20,1.5");
        assert_eq!(steps.len(), 4);
        assert!(steps.iter().all(|(_, link)| link.contains("view=10,20,1.5")), "{steps:?}");
        assert!(steps[3].1.contains("s=7") && steps[3].1.contains("df=20"), "{steps:?}");
        assert!(steps[3].0.ends_with("20, individual 7"), "{steps:?}");
    }

    #[test]
    fn two_plants_side_by_side_are_told_apart() {
        let two = pictures("compare/croton?v=1&d=10/croton?v=1&d=10&noise=1");
        assert_eq!([two[0].0, two[1].0], ["clones", "Perlin noise"]);
        let two = pictures("compare/croton?v=1&d=30/mushroom?v=1&d=20");
        assert!(two[0].0.starts_with("Croton, ") && two[1].0.ends_with("day 20"), "{two:?}");
        let alike = pictures("compare/croton?v=1&d=3/croton?v=1&d=3");
        assert_eq!([alike[0].0, alike[1].0], ["day 3", "day 3"]);
    }

    #[test]
    fn what_is_asked_for_follows_the_hand_that_turns_it() {
        let pictures = [
            "mushroom?v=1&s=1&d=2&view=5,6,2",
            "mushroom?v=1&s=2&d=2&view=5,6,2",
            "croton?v=1&s=1&d=9",
        ];
        let pictures = pictures.map(str::to_string);
        let asked = "mushroom?v=1&d=2&view=1,2,1&s=1..2/croton?d=9&view=3,4,1/cactus";
        let turned = turned(asked, &pictures);
        assert_eq!(turned, "mushroom?v=1&d=2&s=1..2&view=5,6,2/croton?d=9/cactus");
        assert_eq!(super::turned("croton", &pictures[..1]), "croton?view=5,6,2");
    }

    #[test]
    fn what_is_left_out_is_told_once() {
        let (view, rest) = asked_view("nursery/tulip?v=1&s=1..3").expect("a view");
        let [row] = view.rows(rest)[..] else { panic!("one row") };
        assert_eq!(row.caption.matches("There is no plant called").count(), 1, "{}", row.caption);
    }

    #[test]
    fn a_series_is_never_longer_than_can_be_grown() {
        for fragment in [
            "nursery/croton?s=1..4000000000",
            "steps/croton?s=1..60&df=1,2,3&db=1,2,3",
            "nursery/croton?s=9..3",
            "nursery/",
            "compare/////",
        ] {
            assert!(pictures(fragment).len() <= MOST_PICTURES, "{fragment}");
        }
    }
}
