//! The limb of a leaf: the union of its lobes.

use super::LeafPlan;
use super::plan::area;
use glam::DVec2;
use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay::IntOverlayOptions;
use i_overlay::core::simplify::Simplify;
use i_overlay::i_float::int::point::IntPoint;

/// Coordinates of the union are whole numbers up to this one, so that it is the same on every machine: the
/// grid of a leaf of 10 cm is finer than a millionth of a millimetre.
const LARGEST: f64 = (1u32 << 28) as f64;

/// The outlines of a limb, each counter-clockwise: one, or several where lobes meet in the leafstalk alone.
#[derive(Clone, Debug, PartialEq)]
pub struct Limb {
    pub outlines: Vec<Vec<DVec2>>,
}

impl Limb {
    /// With its sides curved as the border says.
    pub fn new(plan: &LeafPlan) -> Limb {
        match &plan.lobes[..] {
            // Nothing to unite; curves may cross each other where teeth are close and long.
            [lobe] if lobe.sides == lobe.corners => Limb::straight(plan),
            lobes => union(&lobes.iter().map(|lobe| lobe.outline(&lobe.sides)).collect::<Vec<_>>()),
        }
    }

    /// With straight sides between the corners of the lobes.
    pub fn straight(plan: &LeafPlan) -> Limb {
        let outlines: Vec<Vec<DVec2>> =
            plan.lobes.iter().map(|lobe| lobe.outline(&lobe.corners)).collect();
        if outlines.len() == 1 { Limb { outlines } } else { union(&outlines) }
    }

    /// In square centimetres.
    pub fn area(&self) -> f64 {
        self.outlines.iter().map(|outline| area(outline)).sum()
    }

    /// How many corners the border has.
    pub fn corners(&self) -> usize {
        self.outlines.iter().map(Vec::len).sum()
    }
}

/// What lies in any of the polygons. Holes between lobes that meet again farther out are filled: a blade has
/// none.
fn union(polygons: &[Vec<DVec2>]) -> Limb {
    let coordinates = polygons.iter().flatten().flat_map(|p| [p.x.abs(), p.y.abs()]);
    let most = coordinates.fold(0.0, f64::max);
    // A power of two: to and fro without rounding.
    let mut scale = 1.0;
    while most * scale * 2.0 <= LARGEST {
        scale *= 2.0;
    }
    let whole =
        |p: &DVec2| IntPoint::new((p.x * scale).round() as i32, (p.y * scale).round() as i32);
    let contours: Vec<Vec<IntPoint<i32>>> =
        polygons.iter().map(|polygon| polygon.iter().map(whole).collect()).collect();
    let shapes = contours.simplify(FillRule::NonZero, IntOverlayOptions::keep_output_points());
    let outline = |contour: &Vec<IntPoint<i32>>| -> Vec<DVec2> {
        contour.iter().map(|p| DVec2::new(f64::from(p.x), f64::from(p.y)) / scale).collect()
    };
    let outlines = shapes.iter().filter_map(|shape| shape.first()).map(outline).collect();
    Limb { outlines }
}
