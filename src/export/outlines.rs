//! Where a set of triangles ends.

/// The outlines of a set of triangles: the sides that only one of them has, end to end.
pub fn outlines(triangles: impl Iterator<Item = [u32; 3]>) -> impl Iterator<Item = Vec<u32>> {
    let sides = triangles.flat_map(|t| [0, 1, 2].map(|k| (t[k], t[(k + 1) % 3])));
    let mut sides: Vec<(u32, u32)> = sides.collect();
    sides.sort_unstable_by_key(|&(a, b)| (a.min(b), a.max(b), a));
    let mut open: Vec<(u32, u32)> = Vec::new();
    for both in sides.chunk_by(|s, t| (s.0.min(s.1), s.0.max(s.1)) == (t.0.min(t.1), t.0.max(t.1)))
    {
        let forth = both.iter().filter(|(a, b)| a < b).count();
        let back = both.len() - forth;
        // One way so many times more often than the other.
        open.extend(both.iter().filter(|(a, b)| a < b).take(forth.saturating_sub(back)));
        open.extend(both.iter().filter(|(a, b)| a > b).take(back.saturating_sub(forth)));
    }
    open.sort_unstable();
    let mut is_used = vec![false; open.len()];
    let mut outlines = Vec::new();
    for first in 0..open.len() {
        let mut outline = Vec::new();
        let mut next = Some(first);
        while let Some(side) = next.filter(|&side| !is_used[side]) {
            is_used[side] = true;
            outline.push(open[side].0);
            let to = open[side].1;
            let from = open.partition_point(|&(a, _)| a < to);
            next = (from..open.len()).take_while(|&k| open[k].0 == to).find(|&k| !is_used[k]);
        }
        if outline.len() > 2 {
            outlines.push(outline);
        }
    }
    outlines.into_iter()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn triangles_side_by_side_have_one_outline_and_a_hole_another() {
        let square = outlines([[0, 1, 2], [0, 2, 3]].into_iter());
        assert_eq!(square.collect::<Vec<_>>(), [[0, 1, 2, 3]]);
        // A frame of eight triangles between two squares.
        let ring = (0..4).flat_map(|k| {
            let (a, b) = (k, (k + 1) % 4);
            [[a, b, b + 4], [a, b + 4, a + 4]]
        });
        assert_eq!(outlines(ring).collect::<Vec<_>>(), [[0, 1, 2, 3], [4, 7, 6, 5]]);
    }
}
