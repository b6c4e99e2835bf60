//! Control images that scale numbers of the recipe from place to place.

use crate::forces::{SIDE_CM, points, pushes, short_way, undivided};
use crate::meshes::{flat_torus, icosphere};
use clonal_mosaic::mosaic::{neighbours, polygons};
use clonal_mosaic::surface::{Charts, ControlImage, Cylinder, Mesh, Wrap};
use clonal_mosaic::tissue::CellType::{self, Background as B, Foreground as F, Middle as M};
use clonal_mosaic::tissue::{Control, Day, Diary, Growth, Progress, Recipe, Scaled, Use};
use glam::{Vec2, Vec3};
use std::sync::Arc;

fn grow(mesh: &Arc<Mesh>, recipe: &Recipe, controls: &[Control], seed: u32) -> Diary {
    let mut growth = Growth::new(mesh.clone(), recipe.clone(), controls, seed).unwrap();
    while growth.step() != Progress::Done {}
    growth.diary
}

/// An image on the plane of the torus, upright: one rule in the right half and one in the left, each
/// from the grey at a quarter of the height evenly to that at three quarters.
fn halves(right: [u8; 2], left: [u8; 2]) -> (Wrap, ControlImage) {
    let cylinder = Cylinder {
        base: Vec3::new(0.5 * SIDE_CM, 0.0, 0.0),
        axis: Vec3::Y,
        zero: Vec3::X,
        height: SIDE_CM,
    };
    // The plane is at 0 and at half a turn: at the seam and in the middle of the image.
    let row = |k: usize| [right[k], left[k], left[k], right[k]];
    let grey = [row(0), row(1)].concat();
    (Wrap::Cylinder(cylinder), ControlImage { width: 4, height: 2, grey })
}

/// An image with its use, and the factor that it must have at a point.
struct Rule {
    number: Scaled,
    factors: [f64; 2],
    right: [u8; 2],
    left: [u8; 2],
}

impl Rule {
    fn control(&self) -> Control {
        let (wrap, image) = halves(self.right, self.left);
        let [black, white] = self.factors;
        Control { wrap, image, use_as: Use::Scale { number: self.number, black, white } }
    }

    fn factor(&self, point: Vec3) -> f32 {
        let [lower, upper] = if point.x > 0.5 * SIDE_CM { self.right } else { self.left };
        let up = (2.0 * f64::from(point.y / SIDE_CM) - 0.5).clamp(0.0, 1.0);
        let grey = (f64::from(lower) * (1.0 - up) + f64::from(upper) * up) / 255.0;
        (self.factors[0] + (self.factors[1] - self.factors[0]) * grey) as f32
    }
}

const RULES: [Rule; 5] = [
    Rule { number: Scaled::RadiusScale, factors: [0.4, 2.5], right: [0, 255], left: [140, 60] },
    Rule { number: Scaled::Repulsion, factors: [1.6, 0.3], right: [30, 200], left: [255, 0] },
    Rule { number: Scaled::Adhesion(F, F), factors: [0.0, 2.0], right: [0, 90], left: [255, 10] },
    Rule { number: Scaled::Adhesion(M, F), factors: [0.5, 3.0], right: [255, 0], left: [0, 0] },
    // A second one for a number: the factors multiply.
    Rule { number: Scaled::Repulsion, factors: [1.0, 0.5], right: [0, 0], left: [255, 255] },
];

fn product(number: Scaled, point: Vec3) -> f32 {
    RULES.iter().filter(|rule| rule.number == number).map(|rule| rule.factor(point)).product()
}

#[test]
fn each_cell_is_pushed_as_the_middle_of_its_triangle_has_it() {
    let mut adhesion = [[0.2; 3]; 3];
    (adhesion[0][0], adhesion[0][2], adhesion[2][0]) = (0.5, 0.3, 0.3);
    let controls: Vec<Control> = RULES.iter().map(Rule::control).collect();
    for (triangles_a_side, radius_scale) in [(24, 1.0), (48, 1.4), (8, 0.8)] {
        let mesh = Arc::new(flat_torus(triangles_a_side, SIDE_CM));
        let recipe = Recipe { adhesion, radius_scale, repulsion: 0.05, ..undivided() };
        let spacing = SIDE_CM / (recipe.initial_cells as f32).sqrt();
        let check = |before: &Diary, after: &Day, weight: &dyn Fn(Vec3, [usize; 2]) -> f32| {
            let old = before.days.last().unwrap();
            let (from, to) = (points(&mesh, old), points(&mesh, after));
            let middle = |i: usize| mesh.centroid(old.places[i].triangle);
            let kind = |i: usize| before.lineage[i].kind as usize;
            let expected = pushes(
                &from,
                |i| radius_scale * product(Scaled::RadiusScale, middle(i)) * spacing,
                |i| recipe.repulsion * product(Scaled::Repulsion, middle(i)),
                |i, j| weight(middle(i), [kind(i), kind(j)]),
            );
            let mut longest = 0.0f32;
            for (i, push) in expected.iter().enumerate() {
                let moved = short_way(to[i] - from[i]);
                assert!((moved - *push).length() < 3e-5, "cell {i} moved {moved} and not {push}");
                longest = longest.max(push.length());
            }
            assert!(longest > 0.02, "somebody moved");
        };
        let until = |days, initial_relaxations| {
            grow(&mesh, &Recipe { days, initial_relaxations, ..recipe.clone() }, &controls, 21)
        };
        let ff = |at| 1.0 - 0.5 * product(Scaled::Adhesion(F, F), at);
        check(&until(0, 3), &until(1, 3).days[1], &|at, types| match types {
            [0, 0] => ff(at),
            [0, 2] | [2, 0] => 1.0 - 0.3 * product(Scaled::Adhesion(M, F), at),
            _ => 0.8,
        });
        // Before day 0 every pair repels as two F cells do, there.
        check(&until(0, 0), &until(0, 1).days[0], &|at, _| ff(at));
    }
}

#[test]
fn an_image_of_one_factor_is_the_recipe_with_its_number_scaled() {
    let mesh = Arc::new(icosphere(3, 10.0));
    let recipe = Recipe {
        initial_cells: 900,
        initial_probability: [0.4, 0.4, 0.2],
        division_days: [4.0, 6.0, 9.0],
        mutation: [[0.9, 0.1, 0.0], [0.0, 0.9, 0.1], [0.1, 0.0, 0.9]],
        adhesion: [[0.5, 0.1, 0.2], [0.1, 0.6, 0.3], [0.2, 0.3, 0.7]],
        initial_relaxations: 4,
        relaxations_per_day: 4,
        days: 8,
        ..Recipe::default()
    };
    const FACTOR: f32 = 1.3;
    let by_hand = |number| {
        let mut recipe = recipe.clone();
        match number {
            Scaled::RadiusScale => recipe.radius_scale *= FACTOR,
            Scaled::Repulsion => recipe.repulsion *= FACTOR,
            Scaled::DivisionDays(of) => recipe.division_days[of as usize] *= f64::from(FACTOR),
            Scaled::Adhesion(a, b) => {
                let scaled = recipe.adhesion[a as usize][b as usize] * FACTOR;
                recipe.adhesion[a as usize][b as usize] = scaled;
                recipe.adhesion[b as usize][a as usize] = scaled;
            }
        }
        recipe
    };
    let plain = grow(&mesh, &recipe, &[], 4);
    for number in [
        Scaled::RadiusScale,
        Scaled::Repulsion,
        Scaled::DivisionDays(B),
        Scaled::Adhesion(F, F),
        Scaled::Adhesion(M, B),
    ] {
        // Black and white have the same factor, so that the greys between do not matter.
        let grey = (0..35u32).map(|k| (k * k * 89) as u8).collect();
        let image = ControlImage { width: 7, height: 5, grey };
        let (wrap, _) = halves([0; 2], [0; 2]);
        let factor = f64::from(FACTOR);
        let use_as = Use::Scale { number, black: factor, white: factor };
        let under = grow(&mesh, &recipe, &[Control { wrap, image, use_as }], 4);
        let scaled = grow(&mesh, &by_hand(number), &[], 4);
        assert_eq!(under.lineage, scaled.lineage, "{number:?}");
        assert_ne!(scaled.fingerprint(8), plain.fingerprint(8), "{number:?} matters");
        for day in 0..=8 {
            let [a, b] = [&under, &scaled].map(|diary| diary.fingerprint(day));
            assert_eq!(a, b, "{number:?}, day {day}");
        }
    }
}

#[test]
fn where_the_factor_of_repulsion_is_0_nobody_moves() {
    let mesh = Arc::new(flat_torus(24, SIDE_CM));
    let rule =
        Rule { number: Scaled::Repulsion, factors: [0.0, 1.0], right: [255; 2], left: [0; 2] };
    let recipe = Recipe { relaxations_per_day: 5, ..undivided() };
    let diary = grow(&mesh, &recipe, &[rule.control()], 3);
    let [before, after] = [0, 1].map(|day| &diary.days[day].places);
    let mut moved = 0;
    for (from, to) in before.iter().zip(after) {
        match mesh.centroid(from.triangle).x > 0.5 * SIDE_CM {
            true => moved += usize::from(from != to),
            false => assert_eq!(from, to),
        }
    }
    assert!(moved > 350, "{moved} cells on the other half moved");
}

/// Share of unlike pairs among the neighbours in the right and in the left half, away from where
/// they meet.
fn unlike(mesh: &Mesh, diary: &Diary, day: usize) -> [f64; 2] {
    let places = &diary.days[day].places;
    let pairs = neighbours(&polygons(mesh, &mut Charts::new(mesh), places));
    let kind = |cell: u32| -> CellType { diary.lineage[cell as usize].kind };
    let (mut pairs_of, mut unlike) = ([0.0; 2], [0.0; 2]);
    for [a, b] in pairs {
        let at: Vec2 = mesh.point(places[a as usize]).truncate();
        let from_middle = at.x / SIDE_CM - 0.5;
        if (0.1..0.4).contains(&from_middle.abs()) {
            let half = usize::from(from_middle < 0.0);
            pairs_of[half] += 1.0;
            unlike[half] += f64::from(u8::from(kind(a) != kind(b)));
        }
    }
    [0, 1].map(|half| unlike[half] / pairs_of[half])
}

#[test]
fn each_half_has_the_pattern_of_its_own_recipe() {
    let mesh = Arc::new(flat_torus(24, SIDE_CM));
    let clinging = Recipe {
        initial_probability: [0.5, 0.5, 0.0],
        adhesion: [[0.9, 0.9, 0.0], [0.9, 0.9, 0.0], [0.0; 3]],
        initial_cells: 500,
        division_days: [5.0; 3],
        days: 12,
        ..Recipe::default()
    };
    // To the right unlike cells push each other and colours part, to the left like ones and they mix.
    let parting =
        Recipe { adhesion: [[0.9, 0.0, 0.0], [0.0, 0.9, 0.0], [0.0; 3]], ..clinging.clone() };
    let mixing =
        Recipe { adhesion: [[0.0, 0.9, 0.0], [0.9, 0.0, 0.0], [0.0; 3]], ..clinging.clone() };
    let rule = |number, right: u8, left: u8| Rule {
        number,
        factors: [0.0, 1.0],
        right: [right; 2],
        left: [left; 2],
    };
    let controls = [
        rule(Scaled::Adhesion(F, F), 255, 0).control(),
        rule(Scaled::Adhesion(B, B), 255, 0).control(),
        rule(Scaled::Adhesion(F, B), 0, 255).control(),
    ];
    for seed in 1..=3 {
        let of = |recipe: &Recipe, controls: &[Control]| {
            unlike(&mesh, &grow(&mesh, recipe, controls, seed), 12)
        };
        let [right, left] = of(&clinging, &controls);
        let (parted, mixed) = (of(&parting, &[])[0], of(&mixing, &[])[1]);
        assert!(mixed - parted > 0.08, "{mixed} and {parted} of the neighbours are unlike");
        assert!((right - parted).abs() < 0.03, "to the right {right} and not {parted}");
        assert!((left - mixed).abs() < 0.03, "to the left {left} and not {mixed}");
    }
}
