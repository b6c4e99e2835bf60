//! A chart as SVG (W3C, Scalable Vector Graphics 1.1): lines and bands over days, or steps over sizes.

use std::fmt::Write;

/// A chart. Its lines have as many values as there are places along it; places where nothing is known are NaN.
#[derive(Clone, Debug, Default)]
pub struct Chart {
    /// What is drawn: `Share of the yellow`.
    pub title: String,
    /// What the places along it are called, such as `day`, and each by itself.
    pub along: &'static str,
    pub places: Vec<String>,
    pub lines: Vec<Line>,
    /// The lower and the upper end of what is to be expected.
    pub band: Option<Band>,
    /// Whether the values are shares, 0 to 1.
    pub is_share: bool,
    /// The value at the foot of the frame.
    pub foot: f64,
}

#[derive(Clone, Debug)]
pub struct Line {
    pub name: String,
    /// As SVG has it; `currentColor` is that of the text.
    pub colour: String,
    pub is_dashed: bool,
    /// Whether each value stands by itself.
    pub is_dots: bool,
    pub values: Vec<f64>,
}

#[derive(Clone, Debug)]
pub struct Band {
    pub name: String,
    pub ends: Vec<[f64; 2]>,
}

/// The size of the picture, and what its frame leaves free, in its own units: left, top, right, bottom.
const SIZE: [f64; 2] = [420.0, 190.0];
const MARGIN: [f64; 4] = [52.0, 10.0, 10.0, 26.0];
/// As many marks along an axis, more or less.
const MARKS: f64 = 4.0;

impl Chart {
    /// The chart as an SVG element that stands alone, with a mark at one of its places. Who cannot see it has its
    /// title and the values there.
    pub fn to_svg(&self, marked: Option<usize>) -> String {
        let [width, height] = SIZE;
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" role=\"img\" \
             font-family=\"sans-serif\" font-size=\"11\" fill=\"none\" stroke=\"none\" color=\"#444\">\
             <title>{}{}</title>",
            escaped(&self.title),
            marked.map(|k| format!(". {}", escaped(&self.told(k)))).unwrap_or_default()
        );
        let top = self.top();
        self.draw_axes(top, &mut svg);
        if let Some(Band { ends, .. }) = &self.band {
            let there: Vec<usize> = (0..ends.len()).filter(|&k| ends[k][0].is_finite()).collect();
            let upper = there.iter().map(|&k| self.point(k, ends[k][1], top));
            let lower = there.iter().rev().map(|&k| self.point(k, ends[k][0], top));
            let corners: Vec<String> =
                upper.chain(lower).map(|[x, y]| format!("{x:.1},{y:.1}")).collect();
            let _ = write!(
                svg,
                "<polygon points=\"{}\" fill=\"currentColor\" fill-opacity=\".16\"/>",
                corners.join(" ")
            );
        }
        for line in &self.lines {
            let there = (0..line.values.len()).filter(|&k| line.values[k].is_finite());
            let points: Vec<String> = there
                .map(|k| self.point(k, line.values[k], top))
                .map(|[x, y]| format!("{x:.1},{y:.1}"))
                .collect();
            if line.is_dots {
                for point in &points {
                    let (x, y) = point.split_once(',').unwrap_or_default();
                    let _ = write!(
                        svg,
                        "<circle cx=\"{x}\" cy=\"{y}\" r=\"3.5\" fill=\"{}\" stroke=\"currentColor\"/>",
                        line.colour
                    );
                }
                continue;
            }
            let dashes = if line.is_dashed { " stroke-dasharray=\"5 4\"" } else { "" };
            // A dark rim: pale colours are seen on pale paper too.
            for (colour, width) in [("currentColor", 3.5), (&*line.colour, 2.0)] {
                let _ = write!(
                    svg,
                    "<polyline points=\"{}\" stroke=\"{colour}\" stroke-width=\"{width}\" \
                     stroke-linejoin=\"round\"{dashes}/>",
                    points.join(" "),
                );
            }
        }
        if let Some(k) = marked.filter(|&k| k < self.places.len()) {
            let ([x, foot], [_, head]) = (self.point(k, self.foot, top), self.point(k, top, top));
            let _ = write!(
                svg,
                "<path d=\"M{x:.1} {head:.1}V{foot:.1}\" stroke=\"currentColor\" stroke-width=\"1\"/>"
            );
            for line in &self.lines {
                if let Some(value) = line.values.get(k).filter(|value| value.is_finite()) {
                    let [x, y] = self.point(k, *value, top);
                    let _ = write!(
                        svg,
                        "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"3.5\" fill=\"{}\" stroke=\"currentColor\"/>",
                        line.colour
                    );
                }
            }
        }
        svg + "</svg>"
    }

    /// All values as CSV: a row for each place, a column for each line and for both ends of the band.
    pub fn to_csv(&self) -> String {
        let mut heading = vec![self.along.to_string()];
        heading.extend(self.lines.iter().map(|line| line.name.clone()));
        if let Some(band) = &self.band {
            heading.extend(["from", "to"].map(|end| format!("{} {end}", band.name)));
        }
        let mut table = heading.join(",") + "\n";
        for k in 0..self.places.len() {
            let known =
                |value: f64| if value.is_finite() { value.to_string() } else { String::new() };
            let mut row = vec![self.places[k].clone()];
            row.extend(self.lines.iter().map(|line| known(line.values[k])));
            if let Some(band) = &self.band {
                row.extend(band.ends[k].map(known));
            }
            table += &(row.join(",") + "\n");
        }
        table
    }

    /// What is told of a place: `day 12: by number 38.2 %, by area 31.9 %`.
    pub fn told(&self, k: usize) -> String {
        let Some(place) = self.places.get(k) else { return String::new() };
        let mut parts: Vec<String> = self
            .lines
            .iter()
            .filter(|line| line.values[k].is_finite())
            .map(|line| format!("{} {}", line.name, self.number(line.values[k])))
            .collect();
        if let Some(Band { name, ends }) = &self.band
            && ends[k][0].is_finite()
        {
            parts.push(format!(
                "{name} {} to {}",
                self.number(ends[k][0]),
                self.number(ends[k][1])
            ));
        }
        format!("{} {place}: {}", self.along, parts.join(", "))
    }

    /// The place that is nearest to a point across the picture, 0 at its left and 1 at its right end.
    pub fn nearest(&self, across: f64) -> usize {
        let [left, _, right, _] = MARGIN;
        let along = (across * SIZE[0] - left) / (SIZE[0] - left - right);
        let last = self.places.len().saturating_sub(1);
        (along * last as f64).round().clamp(0.0, last as f64) as usize
    }

    /// The value at the top of the frame.
    fn top(&self) -> f64 {
        let values = self.lines.iter().flat_map(|line| line.values.iter().copied());
        let ends = self.band.iter().flat_map(|band| band.ends.iter().map(|ends| ends[1]));
        let most = values.chain(ends).filter(|value| value.is_finite()).fold(0.0, f64::max);
        let step = step(most - self.foot);
        self.foot + ((most - self.foot) / step).ceil().max(1.0) * step
    }

    fn draw_axes(&self, top: f64, svg: &mut String) {
        let step = step(top - self.foot);
        let (left, right) = (MARGIN[0], SIZE[0] - MARGIN[2]);
        for mark in 0..=((top - self.foot) / step).round() as usize {
            let value = self.foot + mark as f64 * step;
            let [_, y] = self.point(0, value, top);
            let _ = write!(
                svg,
                "<path d=\"M{left} {y:.1}H{right}\" stroke=\"currentColor\" stroke-opacity=\".25\"/>\
                 <text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\" fill=\"currentColor\">{}</text>",
                left - 6.0,
                y + 4.0,
                self.number(value)
            );
        }
        let every = self.places.len().div_ceil(8).max(1);
        for (k, place) in self.places.iter().enumerate().step_by(every) {
            let [x, foot] = self.point(k, self.foot, top);
            let _ = write!(
                svg,
                "<text x=\"{x:.1}\" y=\"{:.1}\" text-anchor=\"middle\" fill=\"currentColor\">{}</text>",
                foot + 17.0,
                escaped(place)
            );
        }
    }

    fn point(&self, k: usize, value: f64, top: f64) -> [f64; 2] {
        let [left, above, right, below] = MARGIN;
        let last = self.places.len().saturating_sub(1).max(1);
        let x = left + (SIZE[0] - left - right) * k as f64 / last as f64;
        let y =
            SIZE[1] - below - (SIZE[1] - above - below) * (value - self.foot) / (top - self.foot);
        [x, y]
    }

    /// A value in as many digits as are read off a chart.
    fn number(&self, value: f64) -> String {
        match value {
            _ if self.is_share => format!("{} %", trimmed(100.0 * value, 1)),
            _ if value.abs() >= 100.0 || value == value.round() => trimmed(value, 0),
            _ => trimmed(value, 1),
        }
    }
}

/// A step of 1, 2 or 5 times a power of ten that goes a few times into a number.
pub(super) fn step(most: f64) -> f64 {
    let rough = if most > 0.0 { most / MARKS } else { 1.0 };
    let power = libm::pow(10.0, libm::log10(rough).floor());
    [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .map(|k| k * power)
        .find(|&step| step >= rough)
        .unwrap_or(rough)
}

/// With so many decimals at most, and digits in groups of three.
fn trimmed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let (whole, rest) = text.split_once('.').unwrap_or((&text, ""));
    let mut grouped = String::new();
    for (k, digit) in whole.chars().enumerate() {
        if k > 0 && (whole.len() - k).is_multiple_of(3) && digit.is_ascii_digit() {
            grouped.push(',');
        }
        grouped.push(digit);
    }
    match rest.trim_end_matches('0') {
        "" => grouped,
        rest => format!("{grouped}.{rest}"),
    }
}

/// A text as the content of an element.
pub(super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chart() -> Chart {
        Chart {
            title: "Cells & more".into(),
            along: "day",
            places: (0..=20).map(|day| day.to_string()).collect(),
            lines: vec![Line {
                name: "all".into(),
                colour: "currentColor".into(),
                is_dashed: false,
                is_dots: false,
                values: (0..=20).map(|day| 100.0 * f64::from(day)).collect(),
            }],
            band: Some(Band {
                name: "expected".into(),
                ends: (0..=20)
                    .map(|day| if day == 0 { [f64::NAN; 2] } else { [50.0, 2310.0] })
                    .collect(),
            }),
            is_share: false,
            foot: 0.0,
        }
    }

    #[test]
    fn a_chart_is_an_svg_with_a_point_for_each_known_value() {
        let svg = chart().to_svg(Some(7));
        let document = roxmltree::Document::parse(&svg).unwrap();
        let points = |tag: &str| {
            let node = document.descendants().find(|node| node.has_tag_name(tag)).unwrap();
            node.attribute("points").unwrap().split(' ').count()
        };
        assert_eq!((points("polyline"), points("polygon")), (21, 40));
        let title = document.descendants().find(|node| node.has_tag_name("title")).unwrap();
        assert_eq!(title.text().unwrap(), "Cells & more. day 7: all 700, expected 50 to 2,310");
        // The top of the frame is the first mark over all values.
        let marks: Vec<_> = document.descendants().filter_map(|node| node.text()).collect();
        assert!(marks.contains(&"3,000") && !marks.contains(&"4,000"), "{marks:?}");
    }

    #[test]
    fn places_are_found_again_where_they_are_drawn() {
        let chart = chart();
        for k in 0..=20 {
            let [x, _] = chart.point(k, 0.0, 1.0);
            assert_eq!(chart.nearest(x / SIZE[0]), k);
        }
        assert_eq!((chart.nearest(-1.0), chart.nearest(2.0)), (0, 20));
        assert_eq!(Chart::default().nearest(0.5), 0);
    }

    #[test]
    fn tables_leave_out_what_is_not_known() {
        let table = chart().to_csv();
        let rows: Vec<_> = table.lines().take(3).collect();
        assert_eq!(rows, ["day,all,expected from,expected to", "0,0,,", "1,100,50,2310"]);
    }

    #[test]
    fn numbers_have_as_many_digits_as_are_read() {
        let share = Chart { is_share: true, ..Chart::default() };
        assert_eq!([0.5, 0.123_45, 0.0].map(|x| share.number(x)), ["50 %", "12.3 %", "0 %"]);
        let plain = Chart::default();
        assert_eq!(
            [1_234_567.0, 12.34, 999.6].map(|x| plain.number(x)),
            ["1,234,567", "12.3", "1,000"]
        );
    }
}
