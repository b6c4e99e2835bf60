//! A clone in hand, from the click to the words.

use super::*;

/// All that a leaf's page says of the clone in hand.
fn told(all: &Together) -> crate::play::clone::Told {
    all.page.told_of_clone().expect("a clone is in hand")
}

fn leaf(link: &str) -> Together {
    let mut all = Together::open(link);
    all.finish();
    all
}

/// The last of the cells, and its founder.
fn last_cell(all: &Together) -> (u32, u32) {
    let pedigree = &all.page.run().pedigree;
    let last = pedigree.cells() - 1;
    (last, pedigree.founders()[last as usize])
}

#[test]
fn a_clone_is_taken_told_and_let_go() {
    let mut all = leaf("#leaf?v=1&s=1&d=6");
    let (cell, founder) = last_cell(&all);
    assert!(all.page.told_of_clone().is_none());
    all.hear(Event::Take { cell, clan: false });
    all.rest();
    assert_eq!(*all.links.last().unwrap(), format!("leaf?v=1&s=1&d=6&cell={cell}"));
    let clone = told(&all);
    assert_eq!(clone.title, format!("Clone of cell {cell}"));
    assert!(clone.story.contains("born on day 6 of cell "), "{}", clone.story);
    assert!(clone.story.ends_with(&format!("back to first cell {founder}.")), "{}", clone.story);
    assert_eq!(clone.size, "Day 6: 1 cell, 1% of all.");
    assert_eq!(clone.days, [(6, 1)]);
    assert!(all.said.last().unwrap().contains(&clone.in_words()), "{:?}", all.said);

    all.hear(Event::Seek(2));
    all.rest();
    assert!(told(&all).size.starts_with("Day 2: not born yet; cell "), "{}", told(&all).size);
    all.hear(Event::Take { cell, clan: false });
    assert!(all.page.told_of_clone().is_none(), "the same once more lets it go");
    all.rest();
    assert_eq!(all.links.last().unwrap(), "leaf?v=1&s=1&d=2");
    all.hear(Event::Undo);
    all.rest();
    assert_eq!(all.page.scene().cell, Some(cell));
    all.hear(Event::PutDown);
    assert_eq!(all.page.scene().cell, None);
    assert_eq!(all.wishes, 1, "nothing grew again");
}

#[test]
fn mothers_and_clans_are_walked_through() {
    let mut all = leaf("#leaf?v=1&s=1&d=6");
    let (cell, founder) = last_cell(&all);
    all.hear(Event::Take { cell, clan: false });
    let mut steps = 0;
    while told(&all).has_mother {
        all.hear(Event::TakeMother);
        steps += 1;
    }
    assert_eq!(all.page.scene().cell, Some(founder));
    assert_eq!(steps, all.page.run().pedigree.mothers(cell).count());
    all.hear(Event::Take { cell, clan: false });
    all.hear(Event::TakeClan);
    let clan = told(&all);
    assert_eq!(clan.title, format!("Clan of first cell {founder}"));
    assert!(clan.story.ends_with("one of the 100 first cells."), "{}", clan.story);
    let sizes: Vec<u32> = clan.days.iter().map(|(_, cells)| *cells).collect();
    assert_eq!((sizes.len(), sizes[0]), (7, 1));
    assert!(sizes.is_sorted() && sizes[6] > 1, "{sizes:?}");
    // All clans, once around, are all cells.
    let mut whole = 0;
    for _ in 0..100 {
        all.hear(Event::StepClans(1));
        whole += told(&all).days[6].1;
    }
    assert_eq!(all.page.scene().cell, Some(founder));
    assert_eq!(whole, all.page.run().facts(6).unwrap().count.cells);
    all.hear(Event::PutDown);
    all.hear(Event::StepClans(-1));
    assert_eq!(all.page.scene().cell, Some(99), "backwards from nothing: the last one");
    all.hear(Event::PutDown);
    all.hear(Event::StepClans(1));
    assert_eq!(all.page.scene().cell, Some(0));
}

#[test]
fn a_link_brings_its_clone_and_waits_for_its_birth() {
    let (cell, _) = last_cell(&leaf("#leaf?v=1&s=1&d=6"));
    let mut all = Together::open(&format!("#leaf?v=1&s=1&d=6&cell={cell}"));
    all.work_until_grown(2);
    assert!(told(&all).story.starts_with("Not born on the days"), "{}", told(&all).story);
    all.finish();
    assert_eq!(told(&all).days, [(6, 1)]);
    assert_eq!(all.told, [""; 0]);

    let mut all = leaf(&format!("#leaf?v=1&s=1&d=6&cell={}", cell + 1));
    assert_eq!(all.page.scene().cell, None);
    assert!(all.told[0].contains("is not born here"), "{:?}", all.told);
    all.rest();
    assert_eq!(all.links.last().unwrap(), "leaf?v=1&s=1&d=6");
}

#[test]
fn another_growth_lets_go_and_other_colours_do_not() {
    let take = Event::Take { cell: 7, clan: false };
    let change = |key, value| Event::Change { key, value };
    for (event, stays) in [
        (change("bo", 0.5), true),
        (Event::Show(Show::Clans), true),
        (Event::Seek(2), true),
        (change("df", 4.0), false),
        (Event::Individual(2.0), false),
        (Event::Noise(true), false),
        (Event::ChoosePlant("fruit".to_string()), false),
    ] {
        let mut all = leaf("#leaf?v=1&s=1&d=6");
        all.hear(take.clone());
        all.hear(event.clone());
        assert_eq!(all.page.scene().cell.is_some(), stays, "{event:?}");
    }
    // In the place of a drawing a clone would not be seen.
    let mut all = leaf("#leaf?v=1&s=1&d=6");
    all.hear(Event::Show(Show::FieldX));
    all.hear(take);
    assert_eq!(all.page.scene().show, Show::Cells);
    // A cell that is not there is none to take.
    all.hear(Event::Take { cell: u32::MAX, clan: true });
    assert_eq!(all.page.scene().cell, Some(7));
}
