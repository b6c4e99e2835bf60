//! Numbers that make what is wanted, found by trying.

use crate::{mosaic, succeed};
use clonal_mosaic::{plants, play::link};

const PLANT: [&str; 4] = ["fit", "--link", "croton-shrub?v=1&s=2&d=4&n=400", "--want"];

/// The tries that are printed: by how much they are off, and their links.
fn tries(told: &str) -> Vec<(f64, &str)> {
    told.lines()
        .map(|line| {
            let (rest, link) = line.rsplit_once("; ").expect("a link");
            let off = rest.rsplit_once("off by ").expect("how much").1.trim_end_matches(" %");
            (off.parse().expect("a number"), link)
        })
        .collect()
}

#[test]
fn a_share_is_found_and_each_line_is_better() {
    let told = succeed(&[&PLANT[..], &["share=0.3"]].concat());
    let tries = tries(&told);
    assert!(tries.len() > 2 && tries.is_sorted_by(|a, b| a.0 > b.0), "{told}");
    let (off, best) = tries.last().unwrap();
    assert!(*off < 4.0, "{told}");
    let opened = link::read(best, plants::all());
    assert_eq!(opened.left_out, [""; 0]);
    // Both types divide alike: what there is at first stays, but for chance.
    assert!((opened.scene.recipe.initial_probability[0] - 0.3).abs() < 0.06, "{told}");
    assert_eq!(told, succeed(&[&PLANT[..], &["share=0.3"]].concat()), "the same way again");
}

#[test]
fn patches_and_the_numbers_to_vary_can_be_named() {
    let more = ["patches=60,share-B=0.7", "--vary", "n,pf", "--individuals", "1", "--tries", "12"];
    let told = succeed(&[&PLANT[..], &more].concat());
    let last = told.lines().last().unwrap();
    assert!(
        last.contains("n=") && last.contains("pf=") && last.contains("yellow patches"),
        "{told}"
    );
    let number: u32 =
        last.strip_prefix("try ").unwrap().split(':').next().unwrap().parse().unwrap();
    assert!(number <= 12, "{told}");
}

#[test]
fn what_cannot_be_wanted_is_refused_in_a_line() {
    for (want, more, why) in [
        ("share", &[][..], "it says no value"),
        ("beauty=1", &[], "there are cells, count F"),
        ("share=40", &[], "a share is from 0 to 1"),
        ("share=x", &[], "it must be a number from 0 on"),
        ("share-M=0.1", &[], "no cells of that type"),
        ("share=0.4", &["--vary", "cf"], "there is no number \"cf\" to vary"),
    ] {
        let output = mosaic(&[&PLANT[..], &[want], more].concat());
        let complaint = String::from_utf8(output.stderr).unwrap();
        assert_eq!((output.status.code(), complaint.lines().count()), (Some(2), 1), "{complaint}");
        assert!(complaint.contains(why), "{complaint}");
    }
}
