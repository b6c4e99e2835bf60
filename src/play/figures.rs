//! The figures of the thesis (R. L. Binsfeld, *Aplicabilidade do Modelo MClone na Síntese de Padrões
//! Visuais do Reino Vegetal*, UFRGS 2013, Table 4.1), picture by picture, as links of the
//! playground.

use super::{Scene, link};

/// A figure of the thesis: one row of its Table 4.1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Figure {
    /// `4.8`
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
    /// The scene, as `link::write` writes it.
    pub link: &'static str,
}

const fn picture(label: &'static str, link: &'static str) -> Picture {
    Picture { label, link }
}

/// All figures in the order of their numbers.
pub const FIGURES: &[Figure] = &[
    Figure {
        number: "4.1",
        title: "Gold dust on a croton",
        caption: "Half of the first cells are yellow, half are green, and both divide at the same \
                  pace. Their families mingle, and the leaves look dusted with gold.",
        pictures: &[picture("day 35", "croton-shrub?v=1&s=1&d=35")],
    },
    Figure {
        number: "4.2",
        title: "Three crotons of one kind",
        caption: "One recipe and three individuals. Chance alone decides where the first cells \
                  fall: each has its own flecks, and still they are of one kind.",
        pictures: &[
            picture("individual 1", "croton-shrub?v=1&s=1&d=30"),
            picture("individual 2", "croton-shrub?v=1&s=2&d=30"),
            picture("individual 3", "croton-shrub?v=1&s=3&d=30"),
        ],
    },
    Figure {
        number: "4.3",
        title: "A croton grows old",
        caption: "One shrub on four days. Yellow cells divide twice as often as green ones, so a \
                  green plant grows more and more yellow without a single cell changing its \
                  colour.",
        pictures: &[
            picture("day 5", "croton?v=1&s=1&d=5"),
            picture("day 15", "croton?v=1&s=1&d=15"),
            picture("day 20", "croton?v=1&s=1&d=20"),
            picture("day 30", "croton?v=1&s=1&d=30"),
        ],
    },
    Figure {
        number: "4.4",
        title: "Between yellow and green",
        caption: "From picture to picture fewer first cells are yellow, from nine in ten to one in \
                  ten. Both colours divide at the same pace, so the last day has the mixture of \
                  the first.",
        pictures: &[
            picture("yellow share p_F 0.9", "croton-shrub?v=1&s=1&d=30&pf=0.9"),
            picture("yellow share p_F 0.7", "croton-shrub?v=1&s=1&d=30&pf=0.7"),
            picture("yellow share p_F 0.5", "croton-shrub?v=1&s=1&d=30"),
            picture("yellow share p_F 0.2", "croton-shrub?v=1&s=1&d=30&pf=0.2"),
            picture("yellow share p_F 0.1", "croton-shrub?v=1&s=1&d=30&pf=0.1"),
        ],
    },
    Figure {
        number: "4.5",
        title: "Clones and noise",
        caption: "The same shrub with as many yellow cells each day: on the right they are chosen by \
                  Perlin noise that changes with time. Pull the days: clones grow, and noise forgets \
                  where it was.",
        pictures: &[
            picture("clones", "croton?v=1&s=1&d=30"),
            picture("Perlin noise", "croton?v=1&s=1&d=30&noise=1"),
        ],
    },
    Figure {
        number: "4.8",
        title: "Blotches of a cactus",
        caption: "Each yellow blotch is the family of one first cell. The more first cells are \
                  yellow, from one to three in a thousand, the more blotches there are, and some \
                  run together.",
        pictures: &[
            picture("yellow share p_F 0.1%", "cactus?v=1&s=1&d=25&pf=0.001"),
            picture("yellow share p_F 0.2%", "cactus?v=1&s=1&d=25&pf=0.002"),
            picture("yellow share p_F 0.3%", "cactus?v=1&s=1&d=25"),
        ],
    },
    Figure {
        number: "4.9",
        title: "Rounder blotches",
        caption: "The same cactus, but its yellow cells cling together more: they push each other \
                  less, and the blotches draw in and become rounder.",
        pictures: &[picture("adhesion α_FF 0.7", "cactus?v=1&s=1&d=25&ff=0.7")],
    },
    Figure {
        number: "4.10",
        title: "A philodendron unfolds its blaze",
        caption: "First cells are lime only along the middle of each leaf, and a direction field \
                  leads them out to the rim: the older the leaf, the longer the strokes. Leaves of \
                  one shoot have unfolded one after another.",
        pictures: &[
            picture("day 20", "philodendron?v=1&s=1&d=20"),
            picture("day 23", "philodendron?v=1&s=1&d=23"),
            picture("day 25", "philodendron?v=1&s=1&d=25"),
            picture("day 27", "philodendron?v=1&s=1&d=27"),
            picture("day 30", "philodendron?v=1&s=1&d=30"),
            picture("day 32", "philodendron?v=1&s=1&d=32"),
            picture("one shoot", "philodendron-shoot?v=1&s=1&d=32"),
        ],
    },
    Figure {
        number: "4.12",
        title: "Philodendron leaves of three ages",
        caption: "Leaves of one plant are of different ages: the same recipe, stopped on three days, \
                  gives a young leaf, one in between, and an old one.",
        pictures: &[
            picture("day 23", "philodendron?v=1&s=1&d=23"),
            picture("day 27", "philodendron?v=1&s=1&d=27"),
            picture("day 30", "philodendron?v=1&s=1&d=30"),
        ],
    },
    Figure {
        number: "4.13",
        title: "A cactus with belts",
        caption: "A control image lets first cells be yellow in belts round the columns. Yellow \
                  cells cling together closely, and the belts stay whole.",
        pictures: &[picture("day 25", "banded-cactus?v=1&s=1&d=25")],
    },
    Figure {
        number: "4.14",
        title: "A ragged fly agaric",
        caption: "Red cells divide six times as often as white ones. What the control image left \
                  of the white veil is squeezed into ragged warts.",
        pictures: &[picture("day 30", "amanita?v=1&s=1&d=30")],
    },
    Figure {
        number: "4.15",
        title: "Three fly agarics",
        caption: "Only the pace of the red cells differs. When they divide every 6 days they crowd \
                  the white warts, at 8 days both keep pace, and at 20 days white spreads.",
        pictures: &[
            picture("red divides: D_F 6 days", "mushroom?v=1&s=1&d=20&df=6"),
            picture("red divides: D_F 8 days", "mushroom?v=1&s=1&d=20"),
            picture("red divides: D_F 20 days", "mushroom?v=1&s=1&d=20&df=20"),
        ],
    },
    Figure {
        number: "4.16",
        title: "Stripes that widen",
        caption: "From picture to picture cells feel each other farther off: once, twice and three \
                  times their spacing. The farther, the more room the crowded dark cells win, and \
                  the stripes widen.",
        pictures: &[
            picture("reach ω_r 1", "long-watermelon?v=1&s=1&d=20"),
            picture("reach ω_r 2", "long-watermelon?v=1&s=1&d=20&rs=2"),
            picture("reach ω_r 3", "long-watermelon?v=1&s=1&d=20&rs=3"),
        ],
    },
    Figure {
        number: "4.17",
        title: "A round watermelon",
        caption: "A striped control image tells which first cells may be dark green. Light ones \
                  among them make the flecks, and divisions fray the borders of the stripes.",
        pictures: &[picture("day 20", "watermelon?v=1&s=1&d=20")],
    },
    Figure {
        number: "4.18",
        title: "A square watermelon",
        caption: "The recipe of the round fruit on another body: the stripes run from the stem \
                  over the edges of the cube and down its sides.",
        pictures: &[picture("day 20", "square-watermelon?v=1&s=1&d=20")],
    },
    Figure {
        number: "4.19",
        title: "A snake plant",
        caption: "Yellow cells begin at the rims alone and divide often; they press on the banded \
                  middle, whose cells hardly divide, and the margins widen.",
        pictures: &[picture("day 15", "sansevieria?v=1&s=1&d=15")],
    },
];

/// The figure of a number.
pub fn find(number: &str) -> Option<&'static Figure> {
    FIGURES.iter().find(|figure| figure.number == number)
}

/// The figure of whose pictures one has the recipe and the look of a scene.
pub fn showing(scene: &Scene) -> Option<&'static Figure> {
    let plants = std::slice::from_ref(scene.plant);
    let is_shown = |picture: &Picture| {
        let of_plant = picture.link.split('?').next() == Some(scene.plant.key);
        of_plant && {
            let other = link::read(picture.link, plants).scene;
            other.plant.rules == scene.plant.rules
                && other.recipe == scene.recipe
                && other.look == scene.look
                && other.noise == scene.noise
        }
    };
    FIGURES.iter().find(|figure| figure.pictures.iter().any(is_shown))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants;
    use crate::tissue::Recipe;

    fn scene(picture: &Picture) -> Scene {
        let opened = link::read(picture.link, plants::all());
        assert_eq!(opened.left_out, [""; 0], "{}", picture.link);
        opened.scene
    }

    #[test]
    fn every_picture_is_a_link_as_we_write_it() {
        for figure in FIGURES {
            assert!(!figure.pictures.is_empty());
            for (k, picture) in figure.pictures.iter().enumerate() {
                assert_eq!(link::write(&scene(picture)), picture.link);
                // They stand in tables whose columns are parted by commas.
                assert!(!picture.label.contains([',', '"']) && !picture.link.contains([',', '"']));
                let before = &figure.pictures[..k];
                assert!(before.iter().all(|p| p.label != picture.label), "{}", picture.label);
                assert!(before.iter().all(|p| p.link != picture.link), "{}", picture.link);
            }
        }
    }

    #[test]
    fn figures_stand_in_order_and_are_found() {
        let place = |figure: &Figure| figure.number[2..].parse::<u32>().unwrap();
        assert!(FIGURES.windows(2).all(|pair| place(&pair[0]) < place(&pair[1])));
        for figure in FIGURES {
            assert_eq!(find(figure.number), Some(figure));
            let sentences = figure.caption.matches(['.', '?']).count();
            assert!(figure.caption.ends_with('.') && sentences <= 3, "{}", figure.caption);
        }
        assert_eq!(find("4.6"), None);
    }

    /// The figure of Figs. 4.5 to 4.7, which have no row in the table.
    const NOISE: &str = "4.5";

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
        let rows = || FIGURES.iter().filter(|figure| figure.number != NOISE);
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
            assert!(FIGURES.iter().any(|f| shown(&f)), "{}", plant.key);
        }
    }
}
