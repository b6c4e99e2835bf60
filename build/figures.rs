//! The figures of `www/figures.txt`: the texts that visitors read, and the pictures that the page is to know before it
//! has fetched them.

/// A line of that text.
enum Line<'a> {
    /// The number of a figure and its title.
    Head(&'a str, &'a str),
    Caption(&'a str),
    /// A picture's link and its label.
    Picture(&'a str, &'a str),
}

fn lines(text: &str) -> impl Iterator<Item = Line<'_>> {
    let figures = text.split("\n\n").flat_map(|figure| figure.lines().enumerate());
    figures.map(|(k, line)| {
        let (first, rest) = line.split_once(' ').unwrap_or((line, ""));
        match k {
            0 => Line::Head(first, rest),
            1 => Line::Caption(line),
            _ => Line::Picture(first, rest),
        }
    })
}

/// Titles, captions and labels.
pub fn texts(text: &str) -> impl Iterator<Item = &str> {
    lines(text).map(|line| match line {
        Line::Head(_, text) | Line::Caption(text) | Line::Picture(_, text) => text,
    })
}

/// The pictures of the thesis, whose figures have numbers, that say more than plant, version, individual and day: a
/// line for each, its figure's number and its link.
pub fn changed(text: &str) -> String {
    let (mut changed, mut number) = (String::new(), "");
    for line in lines(text) {
        match line {
            Line::Head(of_figure, _) => number = of_figure,
            Line::Picture(link, _) => {
                // What is beside it is of no account for its cells.
                let link = link.split('~').next().unwrap_or_default();
                let mut words = link.split(['?', '&']).skip(1);
                let is_changed = words
                    .any(|word| !["v=", "s=", "d="].iter().any(|usual| word.starts_with(usual)));
                if is_changed && number.starts_with(|c: char| c.is_ascii_digit()) {
                    changed += &format!("{number} {link}\n");
                }
            }
            Line::Caption(_) => {}
        }
    }
    changed
}
