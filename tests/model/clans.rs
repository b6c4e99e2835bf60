//! The family map against a second method: which clans touch, by the polygons of spade, and whether those
//! that do have unlike colours.

use crate::meshes::{cube, flat, icosphere, sheet};
use clonal_mosaic::mosaic::{
    CLAN_COLOURS, ClanColours, SiteFinder, SiteLists, neighbours, polygons, touching,
};
use clonal_mosaic::plants;
use clonal_mosaic::surface::{Charts, Mesh};
use clonal_mosaic::tissue::{Diary, Growth, Pedigree, Progress, Recipe};
use std::sync::Arc;

fn pedigree(diary: &Diary) -> Pedigree {
    let mut pedigree = Pedigree::default();
    (0..diary.days.len()).for_each(|day| pedigree.add(&Pedigree::news(diary, day)));
    pedigree
}

/// The clans that touch as the lists of a day say.
fn by_lists(
    mesh: &Mesh,
    (lists, cell_of): (&SiteLists, &[u32]),
    pedigree: &Pedigree,
) -> Vec<[u32; 2]> {
    touching(mesh, lists, |site| pedigree.founders()[cell_of[site] as usize], |_, _| true)
}

/// The same by the polygons of the day's cells.
fn by_polygons(mesh: &Mesh, diary: &Diary, day: usize, pedigree: &Pedigree) -> Vec<[u32; 2]> {
    let pieces = polygons(mesh, &mut Charts::new(mesh), &diary.days[day].places);
    let clans = |pair: [u32; 2]| pair.map(|cell| pedigree.founders()[cell as usize]);
    let mut pairs: Vec<_> = neighbours(&pieces)
        .into_iter()
        .map(clans)
        .filter(|[a, b]| a != b)
        .map(|[a, b]| [a.min(b), a.max(b)])
        .collect();
    pairs.sort_unstable();
    pairs.dedup();
    pairs
}

#[test]
fn clans_touch_where_their_polygons_do() {
    for mesh in [sheet(6, 4.0, flat), icosphere(2, 2.0), cube(4, 3.0)] {
        let recipe = Recipe { initial_cells: 150, days: 8, ..Recipe::default() };
        let recipe = Recipe { division_days: [3.0; 3], ..recipe };
        let diary = crate::grow(&Arc::new(mesh.clone()), &recipe, 3);
        let pedigree = pedigree(&diary);
        let mut finder = SiteFinder::new(&mesh);
        for day in [0, 3, 8] {
            let lists = finder.find(&mesh, &diary, day);
            let found = by_lists(&mesh, (&lists, &finder.cell_of), &pedigree);
            let expected = by_polygons(&mesh, &diary, day, &pedigree);
            let odd = found.iter().filter(|pair| !expected.contains(pair)).count()
                + expected.iter().filter(|pair| !found.contains(pair)).count();
            // Places in lists have twelve bits, so borders shorter than that may be missed or made up.
            assert!(odd * 100 < expected.len(), "day {day}: {odd} of {}", expected.len());
        }
    }
}

#[test]
fn no_two_clans_that_touch_share_a_colour_on_any_day_of_any_plant() {
    for plant in plants::all() {
        let mesh = Arc::new(plant.embedded_body().surface);
        // More days only make more cells of the same clans.
        let recipe = Recipe { days: plant.recipe.days.min(8), ..plant.recipe.clone() };
        let mut growth: Growth = plant.sow(mesh.clone(), recipe, 1).unwrap();
        while !matches!(growth.step(), Progress::Done | Progress::Full) {}
        let pedigree = pedigree(&growth.diary);
        let (mut finder, mut map) = (SiteFinder::new(&mesh), ClanColours::default());
        let (mut changed, mut kept) = (0, 0);
        for day in 0..growth.diary.days.len() {
            let lists = finder.find(&mesh, &growth.diary, day);
            let pairs = by_lists(&mesh, (&lists, &finder.cell_of), &pedigree);
            assert!(pairs.len() as u32 > pedigree.clans(), "{}: {}", plant.key, pairs.len());
            map.add(pedigree.clans(), |is_wanted| {
                pairs.iter().copied().filter(|&[a, b]| is_wanted(a, b)).collect()
            });
            let colours = map.of(day);
            assert!(colours.iter().all(|&colour| u32::from(colour) < CLAN_COLOURS));
            let alike = pairs.iter().filter(|[a, b]| colours[*a as usize] == colours[*b as usize]);
            assert_eq!(alike.count(), 0, "{}, day {day}", plant.key);
            if day > 0 {
                let before = map.of(day - 1);
                let changes = before.iter().zip(colours).filter(|(a, b)| a != b).count();
                changed += changes;
                kept += colours.len() - changes;
            }
        }
        assert!(changed * 10 < kept, "{}: {changed} changes, {kept} kept", plant.key);
    }
}
