//! A weeping fig: a small tree in a pot. How its branches meet is drawn from a ramification matrix, and each end
//! bears a leaf; leaves in the half that looks away are spots.

use super::blade::pot;
use super::sketch::Sketch;
use crate::shapes::branching::{
    Law, Limb, Matrix, Ramification, Tree, TreeNumbers, Width, skeleton, wood,
};
use crate::shapes::crossing::pierces;
use crate::surface::PolygonMesh;
use glam::{DVec3, Quat, Vec2, Vec3};

/// The one, of those tried, that fills its crown the most evenly.
const INDIVIDUAL: u32 = 9;
/// Leaves on twigs alone: a branch sends off branches of the next two orders, if any, and forks nearly every
/// second time.
const ROWS: [&[f64]; 5] = [
    &[0.55, 0.45],
    &[0.1, 0.45, 0.45],
    &[0.0, 0.15, 0.4, 0.45],
    &[0.0, 0.0, 0.2, 0.35, 0.45],
    &[0.0, 0.0, 0.0, 0.2, 0.35, 0.45],
];
const POT_CM: f32 = 13.0;
/// The size of spots in the place of leaves, so that their triangles are about as large.
const FAR: f32 = 0.82;
/// Where the trunk leaves the soil.
const FOOT: Vec3 = Vec3::new(0.0, 11.5, 0.0);

pub fn numbers() -> TreeNumbers {
    TreeNumbers {
        matrix: Matrix::Rows(ROWS.map(|row| row.to_vec()).to_vec()),
        order: 6,
        fork_deg: 36.0,
        side_deg: 75.0,
        main_deg: 14.0,
        length: Law::Exponential { first_cm: 1.8, factor: 1.32 },
        rise: 0.12,
        width: Width::Murray { tip_cm: 0.12, exponent: 2.2 },
        sides: 4,
        ..TreeNumbers::default()
    }
}

pub fn tree() -> Tree {
    let numbers = numbers();
    let matrix: Ramification = numbers.matrix.ramification().expect("a matrix that has a name");
    Tree::draw(&matrix, numbers.order, INDIVIDUAL).expect("an order that has a row")
}

pub fn grow() -> PolygonMesh {
    let (tree, numbers) = (tree(), numbers());
    let limbs = skeleton(&tree, &numbers);
    let ends = limbs.iter().filter(|limb| limb.order == 1);
    let mut blades: Vec<Blade> = Vec::new();
    for (number, limb) in (0..).zip(ends) {
        // The first way to hang that no other leaf is in the way of.
        let mut ways = (0..24).map(|way| Blade::new(number, limb, way));
        let free = ways.clone().find(|blade| !blades.iter().any(|other| blade.cuts(other)));
        blades.extend(free.or_else(|| ways.next()));
    }
    let mut sketch = Sketch::default();
    for (part, is_near) in [("leaves", true), ("far leaves", false)] {
        sketch.group(part, "blade");
        blades.iter().filter(|blade| blade.is_near() == is_near).for_each(|b| b.lay(&mut sketch));
    }
    // In the place of twigs stand leaves.
    lay(&mut sketch, &wood(&tree, &numbers, &|node| tree.nodes[node].order == 1));
    pot(&mut sketch, POT_CM, 8.0);
    sketch.mesh
}

/// Lays wood where the trunk leaves the soil; corners are numbered as its faces come to them.
fn lay(sketch: &mut Sketch, wood: &PolygonMesh) {
    sketch.group("wood", "bare:bark");
    let mut numbers = vec![None; wood.positions.len()];
    for face in &wood.faces {
        let vertices = face.vertices.iter().map(|&v| {
            *numbers[v as usize]
                .get_or_insert_with(|| sketch.vertex(wood.positions[v as usize] + FOOT))
        });
        let vertices: Vec<u32> = vertices.collect();
        sketch.face(&vertices);
    }
}

/// A leaf at the end of a branch.
struct Blade {
    base: Vec3,
    /// Of the midrib, of the right half and of the upper side.
    along: Vec3,
    side: Vec3,
    up: Vec3,
    length_cm: f32,
}

impl Blade {
    fn new(number: u32, limb: &Limb, way: u32) -> Blade {
        let [from, to] = [limb.from, limb.to].map(|p: DVec3| p.as_vec3() + FOOT);
        let shaken = |purpose| super::sketch::jitter(number, purpose + 8 * way);
        let out = (to - from).normalize();
        // Leaves of a weeping fig hang, the more the longer one looks for room.
        let along = (out - Vec3::Y * (0.55 + 0.25 * shaken(1))
            + 0.06 * way as f32 * shaken(2) * Vec3::X)
            .normalize_or(Vec3::NEG_Y);
        let outward = Vec3::new(from.x, 0.0, from.z).normalize_or(Vec3::Z);
        let up = Vec3::Y + 0.7 * outward;
        let side = along.cross(up).normalize_or(Vec3::X);
        let roll = Quat::from_axis_angle(along, (0.3 + 0.05 * way as f32) * shaken(3));
        let side = roll * side;
        let length_cm = 6.2 + 0.7 * shaken(4) - 0.05 * way as f32;
        let mut blade = Blade { base: from, along, side, up: side.cross(along), length_cm };
        if !blade.is_near() {
            blade.length_cm *= FAR;
        }
        blade
    }

    /// Whether it looks at who sees the tree first.
    fn is_near(&self) -> bool {
        self.base.z > -1.0
    }

    /// Its corners counter-clockwise, each with its place in the leaf: from the left over the foot of the midrib
    /// to the right and the tip, or of a spot from the foot to the right, the tip and the left.
    fn corners(&self) -> [(Vec3, Vec2); 4] {
        let Blade { base, along, side, up, length_cm } = *self;
        let rule = if self.is_near() {
            [
                (-0.42, 0.1, [-1.0, 0.0]),
                (0.0, -0.1, [0.0, 0.0]),
                (0.42, 0.1, [1.0, 0.0]),
                (0.0, 1.3, [0.0, 1.0]),
            ]
        } else {
            [
                (0.0, 0.0, [0.0, 0.0]),
                (0.36, 0.5, [1.0, 0.5]),
                (0.0, 1.2, [0.0, 1.0]),
                (-0.36, 0.5, [-1.0, 0.5]),
            ]
        };
        rule.map(|(across, share, leaf): (f32, f32, [f32; 2])| {
            // Halves rise from the midrib, and the tip bends down.
            let height = 0.2 * across.abs() - 0.2 * share * share;
            let at = along * share + side * across + up * height;
            (base + at * length_cm, Vec2::from(leaf))
        })
    }

    fn lay(&self, sketch: &mut Sketch) {
        let [a, b, c, d] = self.corners().map(|(at, leaf)| sketch.blade_vertex(at, leaf));
        if self.is_near() {
            sketch.face(&[a, b, d]);
            sketch.face(&[b, c, d]);
        } else {
            sketch.face(&[a, b, c, d]);
        }
    }

    fn triangles(&self) -> [[Vec3; 3]; 2] {
        let [a, b, c, d] = self.corners().map(|(at, _)| at);
        if self.is_near() { [[a, b, d], [b, c, d]] } else { [[a, b, c], [a, c, d]] }
    }

    fn cuts(&self, other: &Blade) -> bool {
        if self.base.distance(other.base) > 14.0 {
            return false;
        }
        let crosses = |one: &Blade, other: &Blade| {
            one.triangles().iter().any(|t| {
                (0..3)
                    .any(|k| other.triangles().iter().any(|&of| pierces(t[k], t[(k + 1) % 3], of)))
            })
        };
        crosses(self, other) || crosses(other, self)
    }
}
