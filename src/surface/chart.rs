//! The triangles around a triangle, unfolded into its plane (Turk91).

/// Stub of the charts.
pub struct Charts;
/// Stub of an image.
pub struct Image;
