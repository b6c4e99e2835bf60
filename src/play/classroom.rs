//! What a teacher leaves to a class, as it stands behind the `~` of an address:
//! `class/only=individual,simple,hide=pf,df`.

use super::Scene;
use super::link;
use super::parameters::{PARAMETERS, Parameter};

/// A part of the page that may be left out.
pub struct Part {
    /// Its word in addresses.
    pub word: &'static str,
    pub name: &'static str,
}

/// All parts, in the order in which they are offered and written.
pub const PARTS: [Part; 8] = [
    Part { word: "plants", name: "the choice of plants" },
    Part { word: "individual", name: "the individual" },
    Part { word: "show", name: "what is shown: cells, families, what leads them" },
    Part { word: "recipe", name: "the recipe with all its numbers" },
    Part { word: "simple", name: "four simple sliders" },
    Part { word: "charts", name: "charts" },
    Part { word: "take", name: "taking it away, and its link" },
    Part { word: "figures", name: "the figures" },
];

/// The part that is there only when it is named: the page has it in no other way.
pub const SIMPLE: &str = "simple";

const ANSWERS: &str = "answers";

/// What a class gets.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Class {
    /// The parts of the page that are there; None: all that it has by itself.
    pub only: Option<Vec<&'static str>>,
    /// The keys of the numbers that are to be found out.
    pub hide: Vec<&'static str>,
    /// Whether they are shown all the same.
    pub answers: bool,
}

impl Class {
    /// Whether a part of the page is there.
    pub fn has(&self, part: &str) -> bool {
        match &self.only {
            Some(only) => only.contains(&part),
            None => part != SIMPLE,
        }
    }

    /// The numbers that are hidden now.
    pub fn secrets(&self) -> &[&'static str] {
        if self.answers { &[] } else { &self.hide }
    }

    /// Writes it as it stands behind `~class/`; empty if it leaves everything as it is.
    pub fn write(&self) -> String {
        let mut words = Vec::new();
        if let Some(only) = &self.only {
            words.push(format!("only={}", only.join(",")));
        }
        if !self.hide.is_empty() {
            words.push(format!("hide={}", self.hide.join(",")));
            words.extend(self.answers.then(|| ANSWERS.to_string()));
        }
        words.join(",")
    }

    /// Reads it, and what was left out because nobody here knows it. A word goes with the list before it:
    /// `only=` and `hide=` begin one.
    pub fn read(text: &str) -> (Class, Vec<String>) {
        let (mut class, mut left_out) = (Class::default(), Vec::new());
        let mut list = "";
        let text = link::decode(text);
        for said in text.split([',', '&']) {
            let (begins, word) = said.split_once('=').unwrap_or((list, said));
            list = begins;
            if list == "only" {
                class.only.get_or_insert_default();
            }
            let part = PARTS.iter().find(|part| part.word == word);
            match (list, word) {
                (_, "") => {}
                (_, ANSWERS) => class.answers = true,
                ("only", _) if part.is_some() => {
                    let only = class.only.get_or_insert_default();
                    only.extend(part.map(|part| part.word));
                }
                ("hide", _) if Parameter::of_key(word).is_some() => {
                    class.hide.extend(Parameter::of_key(word).map(|number| number.key));
                }
                _ => left_out.push(said.to_string()),
            }
        }
        (class, left_out)
    }

    /// What the hidden numbers are, of those that the plant has: `First cells that are yellow (pf): 0.3`.
    pub fn told(&self, scene: &Scene) -> Vec<String> {
        self.hidden(scene)
            .map(|number| {
                let value = number.said(number.get(scene));
                format!("{} ({}): {value}", number.label(scene.plant), number.key)
            })
            .collect()
    }

    /// What the hidden numbers are called, of those that the plant has.
    pub fn names(&self, scene: &Scene) -> Vec<String> {
        self.hidden(scene).map(|number| number.label(scene.plant)).collect()
    }

    fn hidden(&self, scene: &Scene) -> impl Iterator<Item = &'static Parameter> {
        PARAMETERS.iter().filter(|p| self.hide.contains(&p.key) && p.is_for(scene.plant))
    }
}

/// The numbers of a scene that are not its plant's own.
pub fn changed(scene: &Scene) -> Vec<&'static str> {
    let numbers = PARAMETERS.iter().filter(|p| p.get(scene) != p.preset(scene.plant));
    numbers.map(|number| number.key).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants;

    #[test]
    fn what_is_written_is_read() {
        for class in [
            Class::default(),
            Class { only: Some(vec![]), ..Class::default() },
            Class { only: Some(vec!["plants", "simple"]), hide: vec!["pf"], answers: false },
            Class { only: None, hide: vec!["pf", "pm", "rs"], answers: true },
        ] {
            assert_eq!(Class::read(&class.write()), (class.clone(), vec![]), "{}", class.write());
        }
        assert_eq!(Class::default().write(), "");
        let class =
            Class { only: Some(vec!["individual"]), hide: vec!["pf", "pm"], answers: false };
        assert_eq!(class.write(), "only=individual,hide=pf,pm");
    }

    #[test]
    fn what_messengers_do_to_it_is_undone_and_the_unknown_is_told() {
        let (class, left_out) = Class::read("only%3Dplants%2Csofa,hide=df,xx,answers");
        assert_eq!(class.only, Some(vec!["plants"]));
        assert_eq!((class.hide, class.answers), (vec!["df"], true));
        assert_eq!(left_out, ["sofa", "xx"]);
        assert_eq!(Class::read("pf").1, ["pf"]);
    }

    #[test]
    fn without_a_list_all_is_there_that_the_page_has_by_itself() {
        let all = Class::default();
        assert!(all.has("plants") && all.has("recipe") && !all.has(SIMPLE));
        let few = Class::read("only=simple,individual").0;
        assert!(few.has(SIMPLE) && few.has("individual") && !few.has("plants"));
    }

    #[test]
    fn answers_name_the_numbers_and_show_nothing_hidden() {
        let scene = link::read("croton?v=1&s=1&d=9&pf=0.3&ck=1", plants::all()).scene;
        assert_eq!(changed(&scene), ["pf", "ck"]);
        let (class, _) = Class::read("hide=ck,pf,pm");
        // The croton has no cells of the middle type.
        assert_eq!(
            class.told(&scene),
            [
                "First cells that are yellow (pf): 0.3 share",
                "Time between divisions (ck): at any time (exponential)"
            ]
        );
        assert_eq!(class.secrets(), ["ck", "pf", "pm"]);
        assert!(Class { answers: true, ..class }.secrets().is_empty());
    }
}
