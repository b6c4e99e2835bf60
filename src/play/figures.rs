//! The figures: those of the thesis (R. L. Binsfeld, *Aplicabilidade do Modelo MClone na Síntese de Padrões
//! Visuais do Reino Vegetal*, UFRGS 2013), row by row of its Table 4.1, and some of other sources, picture by picture
//! as links of the playground. They stand in `www/figures.txt`, which the page fetches when somebody wants to see them;
//! `docs/figures.md` says how it is written.

use super::{Scene, link};
use crate::plants::{OWN, brought};
use std::sync::OnceLock;

/// A row of pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Figure {
    /// `4.8` of the thesis, else whose it is: `Song-7`.
    pub number: &'static str,
    pub title: &'static str,
    /// What is to be seen, in a sentence or two.
    pub caption: &'static str,
    pub pictures: &'static [Picture],
}

impl Figure {
    /// The name of a picture's still: `figure-4.8-2` of the second.
    pub fn poster(&self, picture: usize) -> String {
        format!("figure-{}-{}", self.number, picture + 1)
    }
}

/// A picture of a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Picture {
    /// What tells it from its neighbours: `day 5`, `individual 2`, `yellow share p_F 0.1%`.
    pub label: &'static str,
    /// The scene, as `link::write` writes it, and perhaps a `~` with what is beside it.
    pub link: &'static str,
}

impl Picture {
    /// The plant of a file of its own that it shows, by its key, unless that is known.
    pub fn unknown(&self) -> Option<&'static str> {
        let key = self.link.split('?').next()?;
        (key.starts_with(OWN) && brought(key).is_none()).then_some(key)
    }

    /// What stands behind its link, with the `~`; empty without it.
    pub fn beside(&self) -> &'static str {
        self.link.find('~').map_or("", |at| &self.link[at..])
    }
}

static ALL: OnceLock<Vec<Figure>> = OnceLock::new();

/// All figures in their order; on the page none before their text has come.
pub fn all() -> &'static [Figure] {
    #[cfg(not(target_arch = "wasm32"))]
    ALL.get_or_init(|| read(include_str!("../../www/figures.txt")));
    ALL.get().map_or(&[], |figures| figures)
}

/// Takes the text of the figures, once.
pub fn take(text: String) {
    ALL.get_or_init(|| read(text.leak()));
}

/// The figures of a text: of each its number and title in one line, the caption in the next one, and then a line for
/// each picture, its link and its label. Figures are parted by an empty line.
fn read(text: &'static str) -> Vec<Figure> {
    let mut lines = text.lines();
    let mut figures = Vec::new();
    while let (Some(head), Some(caption)) = (lines.next(), lines.next()) {
        let (number, title) = head.split_once(' ').unwrap_or_default();
        let pictures = lines.by_ref().map_while(|line| line.split_once(' '));
        let pictures = pictures.map(|(link, label)| Picture { label, link }).collect::<Vec<_>>();
        figures.push(Figure { number, title, caption, pictures: pictures.leak() });
    }
    figures
}

/// The figure of a number.
pub fn find(number: &str) -> Option<&'static Figure> {
    all().iter().find(|figure| figure.number == number)
}

/// The pictures of the thesis whose numbers are not those of their plants, a line each with the number of the figure:
/// `4.9 cactus?v=1&s=1&d=25&ff=0.7`. The build takes them out of the text of all figures.
const CHANGED: &str = include_str!(concat!(env!("OUT_DIR"), "/changed.txt"));

/// The number of the figure of the thesis of whose pictures one has the recipe and the look of a scene, which are not
/// those of its plant.
pub fn showing(scene: &Scene) -> Option<&'static str> {
    let plants = std::slice::from_ref(scene.plant);
    let is_shown = |link: &str| {
        let of_plant = link.split('?').next() == Some(scene.plant.key);
        of_plant && {
            let other = link::read(link, plants).scene;
            other.plant.rules == scene.plant.rules
                && other.recipe == scene.recipe
                && other.look == scene.look
                && other.noise == scene.noise
        }
    };
    let mut pictures = CHANGED.lines().filter_map(|line| line.split_once(' '));
    pictures.find(|(_, link)| is_shown(link)).map(|(number, _)| number)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants;
    use crate::tissue::Recipe;

    /// The scene of a picture, whose plant may have a file of its own.
    fn scene(picture: &Picture) -> Scene {
        if let Some(key) = picture.unknown() {
            let file = format!("{}/meshes/{key}.txt", env!("CARGO_MANIFEST_DIR"));
            let plant = plants::bring(&std::fs::read_to_string(file).unwrap()).unwrap();
            assert_eq!((plant.key, picture.unknown()), (key, None));
        }
        let opened = link::read(picture.link, plants::all());
        assert_eq!(opened.left_out, [""; 0], "{}", picture.link);
        opened.scene
    }

    #[test]
    fn every_picture_is_a_link_as_we_write_it() {
        for figure in all() {
            assert!(!figure.pictures.is_empty());
            for (k, picture) in figure.pictures.iter().enumerate() {
                let link = link::write(&scene(picture));
                assert_eq!(link.clone() + picture.beside(), picture.link);
                // They stand in tables whose columns are parted by commas.
                assert!(!picture.label.contains([',', '"']) && !link.contains([',', '"']));
                let before = &figure.pictures[..k];
                assert!(before.iter().all(|p| p.label != picture.label), "{}", picture.label);
                assert!(before.iter().all(|p| p.link != picture.link), "{}", picture.link);
            }
        }
    }

    #[test]
    fn the_text_is_read_whole() {
        let mut text = String::new();
        for figure in all() {
            let Figure { number, title, caption, .. } = figure;
            text += &format!("{number} {title}\n{caption}\n");
            for Picture { label, link } in figure.pictures {
                text += &format!("{link} {label}\n");
            }
            text += "\n";
        }
        assert_eq!(text.trim_end(), include_str!("../../www/figures.txt").trim_end());
    }

    #[test]
    fn figures_stand_in_order_and_are_found() {
        // Those of the thesis by chapter and number, then the others by their names.
        let place = |figure: &Figure| {
            let numbers = figure.number.split('.').map(|number| number.parse::<u32>().ok());
            let numbers: Option<Vec<u32>> = numbers.collect();
            (numbers.is_none(), numbers, figure.number)
        };
        assert!(all().windows(2).all(|pair| place(&pair[0]) < place(&pair[1])));
        for figure in all() {
            assert_eq!(find(figure.number), Some(figure));
            // An address, the name of an element and that of a file.
            let is_plain = |c: char| c.is_ascii_alphanumeric() || "-.".contains(c);
            assert!(!figure.number.is_empty() && figure.number.chars().all(is_plain));
            assert!(!figure.title.is_empty() && !figure.title.ends_with('.'), "{}", figure.title);
            let sentences = figure.caption.split(". ").count();
            assert!(figure.caption.ends_with('.') && sentences <= 4, "{}", figure.caption);
        }
        assert_eq!(find("4.6"), None);
    }

    #[test]
    fn what_is_not_as_the_plant_has_it_is_known_without_the_text() {
        let of_thesis = all().iter().filter(|f| f.number.starts_with(|c: char| c.is_ascii_digit()));
        let mut changed = String::new();
        for figure in of_thesis {
            for picture in figure.pictures {
                let scene = scene(picture);
                let preset = Scene::preset(scene.plant, scene.individual);
                let is_changed = scene.recipe != preset.recipe || scene.noise;
                if is_changed {
                    changed += &format!("{} {}\n", figure.number, link::write(&scene));
                }
                assert_eq!(showing(&scene).is_some(), is_changed, "{}", picture.link);
            }
        }
        assert_eq!(changed, CHANGED);
    }

    /// The rows of Table 4.1 stand in this chapter.
    const CHAPTER: &str = "4.";

    /// The figures of Figs. 4.5 to 4.7, which have no row in the table.
    const NOISE: [&str; 2] = ["4.5", "4.7"];

    /// A row of Table 4.1: days, then `radius_scale`, `initial_cells`, adhesion FF and BB, and the
    /// days between divisions of F and B.
    type Row = (&'static str, &'static [u32], &'static [f32], u32, [f32; 2], &'static [f64], f64);

    #[rustfmt::skip]
    const TABLE_4_1: &[Row] = &[
        ("4.1", &[35], &[1.0], 2_000, [0.5, 0.8], &[10.0], 10.0),
        ("4.2", &[30], &[1.0], 2_000, [0.5, 0.8], &[10.0], 10.0),
        ("4.3", &[5, 15, 20, 30], &[1.0], 10_000, [0.5, 0.8], &[5.0], 10.0),
        ("4.4", &[30], &[1.0], 2_000, [0.5, 0.8], &[10.0], 10.0),
        ("4.8", &[25], &[4.0], 5_000, [0.5, 0.9], &[3.0], 60.0),
        ("4.9", &[25], &[4.0], 5_000, [0.7, 0.9], &[3.0], 60.0),
        ("4.10", &[20, 23, 25, 27, 30, 32], &[2.0], 10_000, [0.5, 0.7], &[30.0], 120.0),
        ("4.12", &[23, 27, 30], &[2.0], 10_000, [0.5, 0.7], &[30.0], 120.0),
        ("4.13", &[25], &[3.0], 5_000, [0.9, 0.9], &[15.0], 60.0),
        ("4.14", &[30], &[1.0], 3_000, [0.7, 0.9], &[5.0], 30.0),
        ("4.15", &[20], &[3.0], 6_000, [0.7, 0.9], &[6.0, 8.0, 20.0], 8.0),
        ("4.16", &[20], &[1.0, 2.0, 3.0], 10_000, [0.5, 0.9], &[5.0], 10.0),
        ("4.17", &[20], &[0.5], 10_000, [0.5, 0.9], &[5.0], 10.0),
        ("4.18", &[20], &[0.5], 10_000, [0.5, 0.9], &[5.0], 10.0),
        ("4.19", &[15], &[0.7], 15_000, [0.7, 0.7], &[5.0], 70.0),
    ];

    /// The values of a row's pictures, in order, each once.
    fn values<T: PartialEq>(scenes: &[Scene], value: impl Fn(&Scene) -> T) -> Vec<T> {
        let mut all: Vec<T> = scenes.iter().map(value).collect();
        all.dedup();
        all
    }

    #[test]
    fn the_parameters_are_those_of_table_4_1() {
        let is_of_table = |f: &&Figure| f.number.starts_with(CHAPTER) && !NOISE.contains(&f.number);
        let rows = || all().iter().filter(is_of_table);
        let numbers: Vec<&str> = rows().map(|figure| figure.number).collect();
        assert_eq!(numbers, TABLE_4_1.iter().map(|row| row.0).collect::<Vec<_>>());
        for figure in rows() {
            let row = TABLE_4_1.iter().find(|row| row.0 == figure.number).expect(figure.number);
            let &(_, days, radius_scales, cells, [ff, bb], days_f, days_b) = row;
            let scenes: Vec<Scene> = figure.pictures.iter().map(scene).collect();
            let of = |value: fn(&Recipe) -> f64| values(&scenes, |s| value(&s.recipe));
            assert_eq!(values(&scenes, |s| s.day), days, "{}", figure.number);
            assert_eq!(values(&scenes, |s| s.recipe.radius_scale), radius_scales);
            assert_eq!(values(&scenes, |s| s.recipe.initial_cells), [cells]);
            assert_eq!(values(&scenes, |s| s.recipe.adhesion[0][0]), [ff], "{}", figure.number);
            assert_eq!(values(&scenes, |s| s.recipe.adhesion[1][1]), [bb], "{}", figure.number);
            assert_eq!(of(|r| r.division_days[0]), days_f, "{}", figure.number);
            assert_eq!(of(|r| r.division_days[1]), [days_b], "{}", figure.number);
            let individuals = values(&scenes, |s| s.individual).len();
            assert_eq!(individuals, if figure.number == "4.2" { 3 } else { 1 });
        }
        let chances = |number| {
            let scenes: Vec<Scene> = find(number).unwrap().pictures.iter().map(scene).collect();
            values(&scenes, |s| s.recipe.initial_probability[0])
        };
        assert_eq!(chances("4.4"), [0.9, 0.7, 0.5, 0.2, 0.1]);
        assert_eq!(chances("4.8"), [0.001, 0.002, 0.003]);
    }

    #[test]
    fn there_is_a_figure_for_every_plant_of_one() {
        for plant in plants::all().iter().filter(|plant| plant.source.contains("Fig.")) {
            let shown =
                |figure: &&Figure| figure.pictures.iter().any(|p| scene(p).plant.key == plant.key);
            assert!(all().iter().any(|f| shown(&f)), "{}", plant.key);
        }
    }
}
