//! Pieces of a surface side by side in a square.

use glam::DVec2;

/// Around each piece, filled with its rim, so that smaller copies of a picture have no seam.
pub(super) const GAP_PX: usize = 8;
/// Steps of the search for the scale.
const STEPS: usize = 30;

/// Pixels to a unit of some sizes, as many as fit, and the upper left corner of each; no pixels where not even the gaps
/// fit.
pub(super) fn pack(sizes: &[DVec2], side_px: usize) -> (f64, Vec<[usize; 2]>) {
    let largest = sizes.iter().map(|size| size.max_element()).fold(f64::MIN_POSITIVE, f64::max);
    let (mut fits, mut too_large) = (0.0, side_px as f64 / largest);
    let mut corners = vec![[GAP_PX; 2]; sizes.len()];
    for _ in 0..STEPS {
        let scale = 0.5 * (fits + too_large);
        match places(sizes, scale, side_px) {
            Some(found) => (fits, corners) = (scale, found),
            None => too_large = scale,
        }
    }
    (fits, corners)
}

/// The upper left corners of pieces of some sizes in rows, the longest first; None if they do not fit.
fn places(sizes: &[DVec2], px_per_unit: f64, side_px: usize) -> Option<Vec<[usize; 2]>> {
    let size_px =
        |k: usize| (sizes[k] * px_per_unit).to_array().map(|x| x.ceil() as usize + 2 * GAP_PX);
    let mut order: Vec<usize> = (0..sizes.len()).collect();
    order.sort_by_key(|&k| std::cmp::Reverse(size_px(k)[1]));
    let mut corners = vec![[0; 2]; sizes.len()];
    let (mut next, mut row_px) = ([0, 0], 0);
    for k in order {
        let [width, height] = size_px(k);
        if next[0] + width > side_px {
            next = [0, next[1] + row_px];
            row_px = 0;
        }
        row_px = row_px.max(height);
        if next[0] + width > side_px || next[1] + row_px > side_px {
            return None;
        }
        corners[k] = next.map(|px| px + GAP_PX);
        next[0] += width;
    }
    Some(corners)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_lie_apart() {
        let sizes: Vec<DVec2> =
            (1..40).map(|k| DVec2::new(f64::from(k % 7 + 2), f64::from(k))).collect();
        let corners = places(&sizes, 9.0, 2048).unwrap();
        for (k, a) in corners.iter().enumerate() {
            for (j, b) in corners.iter().enumerate().filter(|(j, _)| *j != k) {
                let px = |k: usize| (sizes[k] * 9.0).to_array().map(|x| x.ceil() as usize);
                let apart = (0..2)
                    .any(|n| a[n] + px(k)[n] + GAP_PX <= b[n] || b[n] + px(j)[n] + GAP_PX <= a[n]);
                assert!(apart, "{k} and {j}");
            }
            assert!((0..2).all(|n| a[n] >= GAP_PX));
        }
        assert!(places(&sizes, 100.0, 2048).is_none());
        assert!(pack(&sizes, 2048).0 >= 9.0);
        assert_eq!(pack(&sizes, 64).0, 0.0, "not even the gaps fit");
    }
}
