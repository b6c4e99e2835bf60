//! The course of a step: as far as the recipe's anisotropy says, it follows the direction field
//! (Thesis 3.2.4).

use crate::surface::{DirectionField, Mesh, length};
use glam::Vec2;

/// A direction field and the weight that it has.
pub struct Course {
    /// On the body as it was made.
    rest: DirectionField,
    field: DirectionField,
    /// 0: steps go where the cells are pushed; 1: they follow the field.
    anisotropy: f32,
}

impl Course {
    pub fn new(field: DirectionField, anisotropy: f32) -> Course {
        Course { rest: field.clone(), field, anisotropy }
    }

    /// Takes the field along with a body that moves: `rest` as it was made, `mesh` as it stands now.
    pub fn lead(&mut self, rest: &Mesh, mesh: &Mesh) {
        self.field = self.rest.carried(rest, mesh);
    }

    /// Turns the step of a cell, in the frame of its triangle: `(1 - w) d + w |d| v`. Where the
    /// field has no direction the step stays as it is.
    #[inline]
    pub fn turn(&self, triangle: usize, step: Vec2) -> Vec2 {
        let direction = self.field.at(triangle as u32);
        if direction == Vec2::ZERO {
            return step;
        }
        step * (1.0 - self.anisotropy) + direction * (self.anisotropy * length(step))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::Guide;
    use glam::Vec3;

    #[test]
    fn a_step_turns_from_the_push_to_the_field_and_keeps_its_length_at_both() {
        let square = vec![Vec3::ZERO, Vec3::X, Vec3::new(1.0, 1.0, 0.0), Vec3::Y];
        let mesh = Mesh::new(square, Vec::new(), vec![[0, 1, 2], [0, 2, 3]]).unwrap();
        let guide = Guide { triangle: 0, direction: Vec3::new(2.0, 1.0, 5.0) };
        let field = DirectionField::new(&mesh, &[guide], 1.0).unwrap();
        let along = Vec3::new(2.0, 1.0, 0.0).normalize();
        for triangle in [0, 1] {
            let [x, y] = mesh.axes(triangle);
            let direction = field.at(triangle);
            assert!((x * direction.x + y * direction.y - along).length() < 1e-6);
            for step in [Vec2::new(0.3, -0.4), Vec2::new(-2.0, 0.1), Vec2::ZERO] {
                let turned = |w| Course::new(field.clone(), w).turn(triangle as usize, step);
                assert_eq!(turned(0.0), step, "not a bit is changed");
                assert!((turned(1.0) - direction * step.length()).length() < 1e-6);
                assert!((turned(1.0).length() - step.length()).abs() < 1e-6);
                assert!((turned(0.25) - (0.75 * step + 0.25 * turned(1.0))).length() < 1e-6);
            }
        }
        // A part that no control vector leads.
        let nowhere = DirectionField::new(&mesh, &[], 1.0).unwrap();
        assert_eq!(Course::new(nowhere, 1.0).turn(0, Vec2::X), Vec2::X);
    }
}
