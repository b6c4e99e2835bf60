//! A line that was drawn by hand, as one of the lines of a petal: which one it is, and in few points.

/// Points of a line that is drawn anew.
const DRAWN_POINTS: usize = 7;

/// Which of some lines lies nearest to what was drawn, in the mean over its points; none of none.
pub fn line_meant(drawn: &[[f64; 2]], lines: &[Vec<[f64; 2]>]) -> Option<usize> {
    let mean = |line: &Vec<[f64; 2]>| {
        let near = |p: &[f64; 2]| {
            let pieces = line.windows(2).map(|ends| distance(*p, ends[0], ends[1]));
            pieces.fold(f64::MAX, f64::min)
        };
        drawn.iter().map(near).sum::<f64>()
    };
    (0..lines.len()).min_by(|&a, &b| mean(&lines[a]).total_cmp(&mean(&lines[b])))
}

/// What was drawn in a few points, evenly apart along it, in the direction of the line in whose place it comes;
/// nothing of what is shorter than `least`.
pub fn in_few_points(drawn: &[[f64; 2]], line: &[[f64; 2]], least: f64) -> Option<Vec<[f64; 2]>> {
    let mut drawn = drawn.to_vec();
    let (first, last) = (*line.first()?, *line.last()?);
    let (start, end) = (*drawn.first()?, *drawn.last()?);
    if apart(start, last) + apart(end, first) < apart(start, first) + apart(end, last) {
        drawn.reverse();
    }
    let mut ways = vec![0.0];
    for ends in drawn.windows(2) {
        ways.push(ways[ways.len() - 1] + apart(ends[0], ends[1]));
    }
    let whole = ways[ways.len() - 1];
    if whole < least {
        return None;
    }
    let at = |k: usize| {
        let way = whole * k as f64 / (DRAWN_POINTS - 1) as f64;
        let next = ways.partition_point(|&other| other < way).clamp(1, ways.len() - 1);
        let piece = ways[next] - ways[next - 1];
        let share = if piece > 0.0 { (way - ways[next - 1]) / piece } else { 0.0 };
        [0, 1].map(|axis| drawn[next - 1][axis] * (1.0 - share) + drawn[next][axis] * share)
    };
    Some((0..DRAWN_POINTS).map(at).collect())
}

fn apart([x, y]: [f64; 2], [u, v]: [f64; 2]) -> f64 {
    ((x - u) * (x - u) + (y - v) * (y - v)).sqrt()
}

/// From a point to a straight piece.
fn distance(p: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let [way, to] = [[b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]];
    let square = way[0] * way[0] + way[1] * way[1];
    let share = match square > 0.0 {
        true => ((to[0] * way[0] + to[1] * way[1]) / square).clamp(0.0, 1.0),
        false => 0.0,
    };
    apart(p, [0, 1].map(|axis| a[axis] + share * way[axis]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_drawn_line_is_the_nearest_one_in_even_points_from_foot_to_tip() {
        let edge = |side: f64| vec![[0.3 * side, 0.0], [1.8 * side, 6.0], [0.0, 11.0]];
        let lines = [edge(-1.0), vec![[0.0, 0.0], [0.0, 11.0]], edge(1.0)];
        // From the tip down on the right, as a quick hand draws it: few points where it is fast.
        let drawn = [[0.1, 12.0], [2.0, 12.0], [2.1, 6.0], [2.0, 0.0], [1.0, 0.0]];
        assert_eq!(line_meant(&drawn, &lines), Some(2));
        let few = in_few_points(&drawn, &lines[2], 1.0).unwrap();
        assert_eq!(few.len(), DRAWN_POINTS);
        assert_eq!((few[0], few[6]), ([1.0, 0.0], [0.1, 12.0]));
        let ways: Vec<f64> = few.windows(2).map(|ends| apart(ends[0], ends[1])).collect();
        assert!(ways[1..5].windows(2).all(|pair| (pair[0] - pair[1]).abs() < 0.2), "{ways:?}");
        assert_eq!(line_meant(&[[-1.0, 3.0], [-1.5, 5.0]], &lines), Some(0));
        assert_eq!(line_meant(&[[0.1, 3.0], [-0.1, 8.0]], &lines), Some(1));
        // A click is no line.
        assert_eq!(in_few_points(&[[1.0, 1.0], [1.0, 1.1]], &lines[1], 1.0), None);
        assert_eq!(in_few_points(&[], &lines[1], 0.0), None);
        assert_eq!(line_meant(&drawn, &[]), None);
    }
}
