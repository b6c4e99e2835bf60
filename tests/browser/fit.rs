//! Numbers that make what is wanted, looked for in the page.

use crate::engines::Graphics;
use crate::page::Page;
use clonal_mosaic::plants;
use clonal_mosaic::play::link;

#[test]
fn a_share_that_is_wanted_is_what_the_page_shows() {
    let before = "croton-shrub?v=1&s=2&d=3&n=400";
    let Some(page) = Page::open(Graphics::Neither, &format!("#{before}")) else { return };
    page.on_day(3);
    page.click("fit");
    page.wait_for(
        "the dialog",
        "const d = document.getElementById('fit-dialog'); return !!(d && d.open)",
    );
    page.run("document.querySelector('#fit-dialog .begin').click()");
    let said = "return document.querySelector('#fit-dialog .said').textContent";
    assert_eq!(page.run(said), "Say how much: a number from 0 to 100.");
    page.run(
        "const dialog = document.getElementById('fit-dialog');
         dialog.querySelector('.measure').value = 'share F';
         dialog.querySelector('.value').value = '27';
         dialog.querySelector('.begin').click()",
    );
    page.wait_for(
        "the end of the search",
        "return document.querySelector('#fit-dialog .said').textContent.startsWith('No step helps')",
    );
    let way = page.run(
        "return [...document.querySelectorAll('#fit-dialog .way li')].map(li => li.textContent)",
    );
    let way: Vec<String> = serde_json::from_value(way).unwrap();
    assert!(way.len() > 1 && way.iter().all(|line| line.ends_with(" in 100")), "{way:?}");
    page.run("document.querySelector('#fit-dialog .best').click()");
    page.wait_for("the best", "return location.hash.includes('pf=')");
    page.on_day(3);
    let best = link::read(&page.link(), plants::all());
    assert_eq!((best.left_out.len(), best.scene.recipe.initial_cells), (0, 400));
    let share = page.text("fact-share");
    let percent: f64 = share.split('%').next().unwrap().parse().expect(&share);
    assert!((percent - 27.0).abs() <= 1.0, "{share} after {way:?}");
    page.click("undo");
    page.wait_for("what was before", &format!("return location.hash === '#{before}'"));
    assert_eq!(page.complaints(), [""; 0]);
}
