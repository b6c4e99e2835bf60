//! Straight walks over the surface.

/// Stub of a step.
pub struct Step;
/// Stub of a walk.
pub fn walk() {}
