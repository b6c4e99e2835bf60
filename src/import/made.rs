//! A plant of the visitor's own on a body by rule: a leaf, a tree or a flower with the recipe and the colours of a
//! plant of the catalogue.

use super::Own;
use super::own::MOST_TRIANGLES;
use crate::plants::paint::Paint;
use crate::plants::{self, Growths, Look, Motion, Plant, Shape, Skin, View, to_text};
use crate::shapes::{Numbers, Rule};
use crate::surface::{Group, PolygonMesh, Wrap, quoted};
use crate::tissue::Recipe;
use std::sync::Arc;

/// A body by rule, and the plant whose recipe is to grow on it.
#[derive(Clone, Debug, PartialEq)]
pub struct Made {
    rule: Rule,
    base: &'static Plant,
}

/// The word that names that plant and the version of its rules, so that links keep it: `on:red-croton.2`.
const ON: &str = "on:";

/// Plants of the catalogue have a dozen leaves or more, and a leaf of theirs the share of all first cells.
const LEAVES: u32 = 12;
/// Fewer cells are no pattern.
const LEAST_CELLS: u32 = 200;

/// Bark that comes off in plates, as a plane's: what it uncovers, itself, and what was uncovered before.
const BARK: [(&str, [f32; 3]); 3] =
    [("cream", [0.8, 0.75, 0.6]), ("brown", [0.42, 0.36, 0.29]), ("olive", [0.55, 0.54, 0.4])];

/// Colours and gloss of what a leaf by rule has beside its blade, where the look has none.
const OF_LEAF: [(&str, [f32; 3], f32); 3] = [
    ("vein", [0.55, 0.6, 0.32], 0.2),
    ("petiole", [0.42, 0.47, 0.2], 0.3),
    ("underside", [0.45, 0.55, 0.36], 0.1),
];

/// The same of the wood of a tree with leaves.
const OF_TREE: [(&str, [f32; 3], f32); 2] =
    [("bark", [0.42, 0.36, 0.29], 0.1), ("petiole", [0.42, 0.47, 0.2], 0.3)];

/// The same of sepals.
const OF_FLOWER: [(&str, [f32; 3], f32); 1] = [("sepal", [0.36, 0.5, 0.22], 0.2)];

impl Made {
    /// Reads what links have behind their `~`: `leaf=on:croton.2,lobes:7`. What is left out is as usual.
    ///
    /// # Errors
    /// In plain words, what is wrong.
    pub fn of_words(words: &str) -> Result<Made, String> {
        let (kind, words) = words.split_once('=').unwrap_or((words, ""));
        let (on, numbers): (Vec<&str>, Vec<&str>) =
            words.split(',').partition(|word| word.starts_with(ON));
        let rule = Rule::of_words(kind, &numbers.join(",")).map_err(|why| why.to_string())?;
        let usual = match rule.numbers {
            Numbers::Leaf(_) => "croton.2",
            Numbers::Tree(_) => "ficus.1",
            Numbers::Flower(_) => "lily.1",
        };
        let base = on.last().map_or(usual, |word| &word[ON.len()..]);
        let (key, version) = base.split_once('.').unwrap_or((base, ""));
        let newest = plants::find(key)
            .ok_or_else(|| format!("there is no plant {} whose recipe could grow", quoted(key)))?;
        let base = version.parse().ok().and_then(|version| newest.under(version));
        Ok(Made { rule, base: base.unwrap_or(newest) })
    }

    /// The numbers of the body as `mosaic shape --numbers` reads them.
    pub fn to_json(&self) -> String {
        self.rule.to_json()
    }

    /// The body in centimetres.
    ///
    /// # Errors
    /// In plain words, why there is none.
    pub fn mesh(&self) -> Result<PolygonMesh, String> {
        self.rule.mesh().map_err(|why| why.to_string())
    }

    /// The body as it is seen: that of a flower is a coarse one.
    ///
    /// # Errors
    /// In plain words, why there is none.
    pub fn seen(&self) -> Result<PolygonMesh, String> {
        let mesh = self.mesh()?;
        let plant = self.plant();
        let but = plant.body.but;
        Ok(mesh.refined_by(
            &|group: &Group| match but.iter().find(|but| but.group == group.material) {
                Some(but) => but.levels.min(1),
                None => plant.body.levels.min(1),
            },
        ))
    }

    /// The plant that grows on it.
    pub fn plant(&self) -> Plant {
        let base = self.base;
        let mut look = base.look.clone();
        let is_leafy = matches!(&self.rule.numbers, Numbers::Tree(tree) if tree.leaf.is_some());
        let kept: fn(&Wrap) -> bool = match self.rule.numbers {
            Numbers::Leaf(_) => |wrap| !matches!(wrap, Wrap::Cylinder(_)),
            // Bark has no coordinates of a leaf.
            Numbers::Tree(_) if !is_leafy => |_| false,
            Numbers::Tree(_) | Numbers::Flower(_) => |wrap| matches!(wrap, Wrap::Leaf),
        };
        let paint: Vec<Paint> =
            base.paint.iter().filter(|paint| kept(&paint.wrap)).copied().collect();
        let (name, view, levels, but) = match self.rule.numbers {
            Numbers::Leaf(_) => {
                ("Leaf", View { azimuth_deg: 0.0, elevation_deg: 8.0, zoom: 1.0 }, 0, &[][..])
            }
            Numbers::Tree(_) => {
                ("Tree", View { azimuth_deg: 0.0, elevation_deg: 6.0, zoom: 1.0 }, 0, &[][..])
            }
            Numbers::Flower(_) => ("Flower", base.view, base.body.levels, base.body.but),
        };
        look.veins = false;
        let mut names = base.colour_names;
        let mut recipe = base.recipe.clone();
        match &self.rule.numbers {
            Numbers::Leaf(_) => {
                recipe.initial_cells = (recipe.initial_cells / LEAVES).max(LEAST_CELLS);
                look.bare = with_missing(base, &OF_LEAF);
            }
            Numbers::Tree(_) if is_leafy => look.bare = with_missing(base, &OF_TREE),
            Numbers::Tree(_) => {
                look =
                    Look { cells: BARK.map(|(_, colour)| colour), gloss: 0.1, tinted: &[], ..look };
                look.skin = Skin { through: 0.0, ..look.skin };
                for (name, (of_bark, _)) in names.iter_mut().zip(BARK) {
                    if !name.is_empty() {
                        *name = of_bark;
                    }
                }
            }
            Numbers::Flower(numbers) => {
                if numbers.sepals.is_some() {
                    look.bare = with_missing(base, &OF_FLOWER);
                }
            }
        }
        Plant {
            name,
            latin: "",
            source: format!("Recipe of the {}", base.name.to_ascii_lowercase()).leak(),
            body: Shape { levels, but, growths: Growths::Nothing, ..base.body },
            colour_names: names,
            paint: paint.leak(),
            guides: None,
            recipe: Recipe { anisotropy: 0.0, ..recipe },
            motion: Motion::STILL,
            look,
            view,
            ..base.clone()
        }
    }

    /// The plant with its body, as the page takes plants of a visitor's own.
    ///
    /// # Errors
    /// In plain words, why cells cannot grow on it.
    pub fn own(&self) -> Result<Own, String> {
        let plant = self.plant();
        let obj = self.mesh()?.to_obj();
        let surface = plant.grow_body(&obj).map_err(|why| why.to_string())?.surface;
        let triangles = surface.triangles.len();
        if triangles > MOST_TRIANGLES {
            return Err(format!(
                "this body has {triangles} triangles, and up to {MOST_TRIANGLES} grow here: make it simpler"
            ));
        }
        plant.check_on(&Arc::new(surface)).map_err(|why| why.to_string())?;
        let (key, text) = to_text(&plant, &obj);
        Ok(Own { key, text, told: vec![format!("{triangles} triangles")] })
    }
}

/// The bare materials of a plant's look, and those of others that it has not.
fn with_missing(
    plant: &Plant,
    others: &[(&'static str, [f32; 3], f32)],
) -> &'static [(&'static str, [f32; 3], f32)] {
    let missing = others.iter().filter(|(name, ..)| !plant.has_bare(name));
    plant.look.bare.iter().chain(missing).copied().collect::<Vec<_>>().leak()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plants::bring;
    use crate::play::{FIRST_INDIVIDUAL, Scene, link};
    use crate::shapes::branching::{Census, Tree};
    use crate::shapes::flower::FlowerNumbers;
    use crate::shapes::leaf::LeafNumbers;
    use crate::surface::unpack;
    use crate::tissue::Progress;

    /// Grows two days and tells the cells.
    fn fingerprint(own: &Own) -> String {
        let plant = bring(&own.text).expect("a plant");
        let mut scene = Scene::preset(plant, FIRST_INDIVIDUAL);
        scene.recipe.days = 2;
        scene.recipe.initial_cells = 200;
        assert_eq!(link::read(&link::write(&scene), plants::all()).scene.plant, plant);
        let body = plant.grow_body(&unpack(&own.text)).unwrap();
        let mut growth = scene.sow(Arc::new(body.surface)).unwrap().0;
        while !matches!(growth.step(), Progress::Done | Progress::Full) {}
        growth.diary.fingerprint(2)
    }

    #[test]
    fn bodies_of_all_kinds_grow_and_words_make_the_same_ones_again() {
        for words in [
            "leaf=lobes:3,on:red-croton.2",
            "leaf=on:coleus.2,individual:2,border:smooth",
            "tree=order:3,matrix:perfect",
            "tree=order:4,leaf.lobes:3,leaf.nodes:4",
            "tree=order:4,leaf.lobes:1,leaf_spots:0,on:croton.2",
            "flower=open_day:2.0",
            "flower=sepals.count:5,sepals.length:0.6",
        ] {
            let made = Made::of_words(words).unwrap();
            let own = made.own().unwrap();
            assert_eq!(Made::of_words(words).unwrap().own().unwrap(), own);
            assert!(own.text.ends_with(&made.mesh().unwrap().to_obj()), "as a shell writes it");
            assert_eq!(made.plant().check(), Ok(()), "{words}");
            assert_eq!(fingerprint(&own), fingerprint(&own));
        }
    }

    #[test]
    fn every_plant_of_leaves_grows_on_a_leaf() {
        let bases = plants::all().iter().filter(|plant| plant.look.skin.through > 0.0);
        for base in bases {
            let own = Made::of_words(&format!("leaf=on:{}", base.key)).unwrap().own();
            assert!(own.is_ok(), "{}: {own:?}", base.key);
        }
    }

    #[test]
    fn the_dialog_begins_with_the_examples_and_what_is_usual() {
        let html = include_str!("../browser/studio/shape.html");
        let examples = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
        let json = |name: &str| std::fs::read_to_string(examples.join(name)).unwrap();
        let words = |numbers| Rule { numbers, individual: 1 }.to_words();
        let mut all = Vec::new();
        for leaf in
            ["beech", "chestnut", "holly", "ivy", "lady_mantle", "nasturtium", "plane", "willow"]
        {
            let numbers = LeafNumbers::from_json(&json(&format!("leaves/{leaf}.json"))).unwrap();
            all.push(words(Numbers::Leaf(numbers)));
        }
        for flower in ["tiger_lily", "lotus"] {
            let numbers =
                FlowerNumbers::from_json(&json(&format!("flowers/{flower}.json"))).unwrap();
            all.push(words(Numbers::Flower(numbers.into())));
        }
        for words in &all {
            assert!(html.contains(&format!("value=\"{words}\"")), "{words}");
        }
        // The value of each slider is the usual one: told, it changes nothing.
        let mut kind = "";
        let attribute = |line: &'static str, name: &str| {
            let (_, rest) = line.split_once(&format!(" {name}=\""))?;
            rest.split('"').next()
        };
        let mut count = 0;
        for line in html.lines() {
            kind = attribute(line, "data-kind").unwrap_or(kind);
            let (Some(key), Some(value)) = (attribute(line, "data-key"), attribute(line, "value"))
            else {
                continue;
            };
            if line.contains("<input") && !key.contains("arrangement") {
                let told = Rule::of_words(kind, &format!("{key}:{value}")).unwrap();
                // The usual leaf on a tree is a leaf.
                let usual = if key.starts_with("leaf.") { "leaf.lobes:5" } else { "" };
                let usual = Rule::of_words(kind, usual).unwrap();
                assert_eq!(told, usual, "{kind}: {key} is not {value}");
                count += 1;
            }
        }
        assert!(count > 40, "{count} numbers");
    }

    #[test]
    fn leaves_on_a_tree_carry_the_cells_and_its_wood_is_bare() {
        let made = Made::of_words("tree=order:5,leaf.lobes:5,leaf.nodes:4,leaf_spots:0.5").unwrap();
        let body = made.plant().grow_body(&made.mesh().unwrap().to_obj()).unwrap();
        let Numbers::Tree(numbers) = &made.rule.numbers else { unreachable!() };
        let matrix = numbers.matrix.ramification().unwrap();
        let tree = Tree::draw(&matrix, numbers.order, 1).unwrap();
        let ends = Census::new(&tree).leaves as usize;
        assert_eq!(body.surface.part_count(), ends, "a part for each end");
        let bare = |name: &str| made.plant().has_bare(name);
        assert!(bare("bark") && bare("petiole"));
        assert_eq!(made.plant().look.cells, plants::find("ficus").unwrap().look.cells);
        // A bare tree has the colours of bark.
        let bare = Made::of_words("tree=order:5").unwrap();
        assert_eq!(bare.plant().look.cells[0], BARK[0].1);
    }

    #[test]
    fn wrong_words_are_told() {
        for (words, told) in [
            ("moss=", "a leaf, a tree or a flower"),
            ("leaf=on:nothing", "there is no plant"),
            ("leaf=lobes:2", "odd number"),
        ] {
            let why = Made::of_words(words).unwrap_err();
            assert!(why.contains(told), "{why}");
        }
        let large = Made::of_words("leaf=triangles:50000,fine.closed:true,thickness_cm:1").unwrap();
        assert!(large.mesh().is_ok());
        let why = Made::of_words("tree=order:9").unwrap().own().unwrap_err();
        assert!(why.contains("make it simpler"), "{why}");
    }
}
