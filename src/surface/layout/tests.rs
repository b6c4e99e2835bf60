//! Patches in the plane.

use super::*;
use glam::Vec3;

#[test]
fn a_patch_is_flat_as_long_as_its_edges_and_those_within_reach_keep_their_lengths() {
    const REACH: f32 = 1.5;
    let mesh = crate::surface::icosphere(4, 10.0);
    let mut layout = Layout::new(&mesh, REACH, false);
    let (mut flat, mut bent) = (0, 0);
    for rim_rad in (30..75).map(|k| 0.01 * k as f32) {
        let is_own = |&t: &u32| {
            let centroid = mesh.corners(t).iter().sum::<Vec3>() / 3.0;
            centroid.z > 10.0 * libm::cosf(rim_rad)
        };
        let own: Vec<u32> = (0..mesh.triangles.len() as u32).filter(is_own).collect();
        let fit = layout.lay_out(&own, false);
        let mut stretches = Vec::new();
        for (number, image) in layout.images.iter().enumerate() {
            let (laid, shape) = (image.laid.corners(), mesh.corners(image.triangle));
            for (from, to) in [(0, 1), (1, 2), (2, 0)] {
                // As far as fitting may have shifted what is within reach.
                let reach = REACH * (1.0 + FLAT.most);
                if number < own.len() || layout.outline.is_within(reach, &[laid[from], laid[to]]) {
                    let was = f64::from(shape[from].distance(shape[to]));
                    stretches.push((f64::from(laid[from].distance(laid[to])) / was - 1.0).abs());
                }
            }
        }
        let mean = stretches.iter().sum::<f64>() / stretches.len() as f64;
        let most = stretches.iter().copied().fold(0.0, f64::max);
        let is_flat = mean <= f64::from(FLAT.mean) && most <= f64::from(FLAT.most);
        let expected = if is_flat { Fit::Flat } else { Fit::Bent };
        assert_eq!(fit, expected, "{rim_rad}: stretched by {mean} in the mean, {most} at most");
        (flat, bent) = (flat + u32::from(is_flat), bent + u32::from(!is_flat));
    }
    assert!(flat > 5 && bent > 5, "{flat} flat, {bent} bent");
}

#[test]
fn triangles_that_would_fold_are_left_as_they_were_unfolded() {
    // A closed surface cannot be laid flat, and in so wide a reach no gap is too wide.
    let mesh = crate::surface::icosphere(1, 1.0);
    let all: Vec<u32> = (0..mesh.triangles.len() as u32).collect();
    let mut layout = Layout::new(&mesh, 100.0, false);
    assert_eq!((layout.lay_out(&all, true), layout.is_torn), (Fit::Torn, false));
    for image in &layout.images {
        let (laid, shape) = (image.laid.corners(), mesh.corners(image.triangle));
        for (a, b) in [(0, 1), (1, 2), (2, 0)] {
            assert!((laid[a].distance(laid[b]) - shape[a].distance(shape[b])).abs() < 1e-4);
        }
    }
}

#[test]
fn a_triangle_may_keep_three_tenths_of_its_area_and_lie_three_tenths_of_the_reach_apart() {
    let mesh = crate::surface::icosphere(0, 1.0);
    let mut layout = Layout::new(&mesh, 5.0, true);
    assert_eq!(layout.longest_way, 10.0);
    let corners = mesh.frames[0].corners();
    for (share, is_up) in [(1.0, true), (0.32, true), (0.28, false), (-1.0, false)] {
        layout.images = vec![image(0, 0.0, corners.map(|c| c * Vec2::new(1.0, share)))];
        assert_eq!(layout.all_face_up(), is_up, "{share}");
    }
    layout.images.clear();
    layout.place(0, corners);
    for (gap, is_torn) in [(0.29, false), (0.31, true)] {
        let shift = Vec2::X * gap * layout.reach;
        for (left, right) in [(shift, Vec2::ZERO), (Vec2::ZERO, shift)] {
            layout.is_torn = false;
            let (left, right) = (corners[1] + left, corners[2] + right);
            assert!(layout.meets_known(&Portal { twin: 0, left, right, way: 0.0 }));
            assert_eq!(layout.is_torn, is_torn, "{gap}");
        }
    }
}

#[test]
fn an_edge_that_is_a_twentieth_longer_is_a_sixtieth_in_the_mean() {
    let mesh = crate::surface::icosphere(0, 1.0);
    let mut layout = Layout::new(&mesh, 1.0, false);
    let (sin, cos) = libm::sincosf(2.0 * libm::asinf(0.525));
    let [a, b, _] = mesh.frames[0].corners();
    layout.images = vec![image(0, 0.0, [a, b, b.x * Vec2::new(cos, sin)])];
    assert!(layout.is_flat(1));
}
