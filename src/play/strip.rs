//! The strip under the time line: of which colours the plant is, day by day as far as it has grown.

use super::Run;

/// The whole of a day, from bottom to top. A day is one wide.
const WHOLE: u32 = 1000;

/// A colour as style sheets and SVG write it.
pub fn rgb(colour: [f32; 3]) -> String {
    let [r, g, b] = colour.map(|x| (x * 255.0).round() as u8);
    format!("rgb({r} {g} {b})")
}

/// What the strip shows of a growth, as the inside of an SVG element of `last_day` by 1000: fields in the colours of
/// F, M and B, as high as these types have cells; where they would end by area, dashed; and a line at a day.
pub fn strip(run: &Run, colours: &[[f32; 3]; 3], marked: u32) -> String {
    let Some(newest) = run.newest() else { return String::new() };
    let [f, b, m] = colours.map(rgb);
    // From below: F, and on it M; B is what they leave.
    let f_by_number = line(run, newest, false, false);
    let m_by_number = line(run, newest, true, false);
    let mut svg = format!("<path fill=\"{b}\" d=\"M0 0H{newest}V{WHOLE}H0z\"/>");
    let mut lines = vec![(f_by_number.clone(), line(run, newest, false, true))];
    if m_by_number != f_by_number {
        svg += &format!("<path fill=\"{m}\" d=\"M0 {WHOLE}{m_by_number}V{WHOLE}z\"/>");
        lines.push((m_by_number, line(run, newest, true, true)));
    }
    svg += &format!("<path fill=\"{f}\" d=\"M0 {WHOLE}{f_by_number}V{WHOLE}z\"/>");
    let mut draw = |class: &str, way: &str| {
        let way = way.trim_start_matches('L');
        svg += &format!("<path class=\"{class}\" d=\"M{way}\"/>");
    };
    for (number, area) in lines {
        // A way begins as a line to its first point. White on black is seen on all colours.
        draw("number", &number);
        draw("area rim", &area);
        draw("area", &area);
    }
    let mark = format!("{marked} 0V{WHOLE}");
    draw("now rim", &mark);
    draw("now", &mark);
    svg
}

/// Lines from day to day at the share of F, or of F and M, by number or by area.
// Once: bytes count.
#[inline(never)]
fn line(run: &Run, newest: u32, with_m: bool, by_area: bool) -> String {
    let mut way = String::new();
    for day in 0..=newest {
        if let Some(facts) = run.facts(day) {
            let parts = if by_area { facts.areas } else { facts.count.by_type };
            way += &format!("L{day} {}", WHOLE - below(parts, with_m));
        }
    }
    way
}

/// The share of F, or of F and M, in `WHOLE`.
fn below([f, b, m]: [u32; 3], with_m: bool) -> u32 {
    let part = u64::from(f) + if with_m { u64::from(m) } else { 0 };
    let whole = u64::from(f) + u64::from(b) + u64::from(m);
    (part * u64::from(WHOLE) / whole.max(1)) as u32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mosaic::SiteLists;
    use crate::play::protocol::DayNews;
    use crate::play::testing::PLANTS;
    use crate::play::{DayFacts, Scene};
    use crate::tissue::DayCount;

    fn run(days: &[([u32; 3], [u32; 3])]) -> Run {
        let mut run = Run::without_clones(1, Scene::preset(&PLANTS[0], 1));
        for (day, &(by_type, areas)) in (0..).zip(days) {
            let count = DayCount { cells: by_type.iter().sum(), by_type };
            let facts = DayFacts { count, areas, fingerprint: String::new() };
            let lists = SiteLists::default();
            run.add(DayNews { generation: 1, day, facts, lists, cell_of: vec![] });
        }
        run
    }

    const COLOURS: [[f32; 3]; 3] = [[1.0, 1.0, 0.0], [0.0, 0.5, 0.0], [1.0, 0.0, 0.0]];

    #[test]
    fn colours_stand_on_each_other_as_far_as_it_has_grown() {
        assert_eq!(strip(&run(&[]), &COLOURS, 0), "");
        let two = run(&[([1, 3, 0], [5000, 5000, 0]), ([3, 1, 0], [6000, 4000, 0])]);
        assert_eq!(
            strip(&two, &COLOURS, 1),
            "<path fill=\"rgb(0 128 0)\" d=\"M0 0H1V1000H0z\"/>\
             <path fill=\"rgb(255 255 0)\" d=\"M0 1000L0 750L1 250V1000z\"/>\
             <path class=\"number\" d=\"M0 750L1 250\"/>\
             <path class=\"area rim\" d=\"M0 500L1 400\"/><path class=\"area\" d=\"M0 500L1 400\"/>\
             <path class=\"now rim\" d=\"M1 0V1000\"/><path class=\"now\" d=\"M1 0V1000\"/>"
        );
        let three = strip(&run(&[([1, 2, 1], [1, 1, 2])]), &COLOURS, 0);
        assert!(three.contains("<path fill=\"rgb(255 0 0)\" d=\"M0 1000L0 500V1000z\"/>"));
        assert_eq!(three.matches("class=\"area\"").count(), 2);
    }
}
