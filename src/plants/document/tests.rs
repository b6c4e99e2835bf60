use super::super::all;
use super::*;
use std::sync::Arc;

#[test]
fn every_plant_comes_back_bit_for_bit() {
    for plant in all() {
        let json = plant.to_json();
        let again = Plant::from_json(&json).unwrap_or_else(|e| panic!("{}: {e}", plant.key));
        assert_eq!(again, *plant);
        assert_eq!(again.to_json(), json);
        let surface = Arc::new(plant.embedded_body().surface);
        assert_eq!(again.check_on(&surface), Ok(()), "{}", plant.key);
    }
}

#[test]
fn what_is_wrong_is_told_with_its_place() {
    let croton = crate::plants::find("croton").unwrap().to_json();
    for (from, to, told) in [
        ("\"mosaic_plant\": 1", "\"mosaic_plant\": 7", "mosaic_plant is 7"),
        ("\"rules\": 2", "\"rules\": 3", "rules: there are no rules of version 3"),
        ("\"key\": \"croton\"", "\"key\": \"My croton\"", "names: key is \"My croton\""),
        ("\"croton.obj\"", "\"nettle.obj\"", "body.mesh: there is no mesh \"nettle.obj\""),
        ("\"levels\": 2", "\"levels\": 9", "body: levels is 9"),
        (
            "\"black_at_the_top\": 0.65",
            "\"black_at_the_top\": 65",
            "paint[0]: black_at_the_top is 65",
        ),
        ("\"axis\": [0.0, 1.0, 0.0]", "\"axis\": [0.0, 2.0, 0.0]", "paint[0]: axis and zero"),
        ("\"width\": 256", "\"width\": 2560000", "paint[0]: the image is 2560000 times"),
        (
            "\"gloss\": 0.65",
            "\"gloss\": \"much\"",
            "look.gloss: not what is needed here: string \"much\", a number is needed",
        ),
        (
            "\"first_day\": 8",
            "\"first_day\": 31",
            "first_day: it is 31, but the recipe ends at day 30",
        ),
        ("\"first_day\": 8", "\"first_day\": 8, \"smell\": 1", "unknown field `smell`"),
        ("\"days\": 30", "\"days\": 30, \"days\": 31", "\"days\" stands in it twice"),
        ("\"zoom\": 0.95", "\"zoom\": 1e9", "view: zoom is 1000000000"),
        ("\"zoom\": 0.95", "\"zoom\": 0,95", "the plant is no JSON"),
    ] {
        assert!(croton.contains(from), "{from}");
        let why = Plant::from_json(&croton.replacen(from, to, 1)).unwrap_err().to_string();
        assert!(why.contains(told), "{to}: {why}");
    }
}

#[test]
fn ones_own_pixels_are_seen_as_they_are_written() {
    let json = crate::plants::find("croton").unwrap().to_json();
    let start = json.find("\"grain\"").unwrap();
    let end = start + json[start..].find('}').unwrap() + 1;
    let pixels = "\"pixels\": {\"rows\": [\"0f\", \"80\"]}";
    let json = (json[..start].to_string() + pixels + &json[end..])
        .replace("\"width\": 256", "\"width\": 2")
        .replace("\"height\": 128", "\"height\": 2");
    let plant = Plant::from_json(&json).unwrap();
    let image = &plant.controls(1)[0].image;
    assert_eq!(image.grey, [0x88, 0, 0, 0xff]);
    let why = Plant::from_json(&json.replace("\"80\"", "\"8x\"")).unwrap_err().to_string();
    assert!(why.contains("row 2 of rows has \"x\""), "{why}");
}
