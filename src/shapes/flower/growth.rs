//! How far a flower has opened on a day (Song et al., *Sketch-Based Modeling and Animation of Floral Blossom*,
//! Journal of Software 18, 2007): slowly at first and at last, fastest in the middle.

/// `G(t; g, T)` from a least value, with a growth of `change`.
#[derive(Clone, Copy, Debug)]
pub struct Growth {
    pub least: f64,
    pub change: f64,
    pub g: f64,
    /// `T`.
    pub days: f64,
}

impl Growth {
    /// A value that goes from 0 to 1 while one passes, for `g` = 6.
    pub fn share(g: f64) -> Growth {
        Growth { least: 0.0, change: 1.0, g, days: 1.0 }
    }

    /// `-g change t^3 / (3 T^3) + g change t^2 / (2 T^2) + least`: it ends in `least + g change / 6`. Before day 0 and
    /// after day `T` nothing grows.
    pub fn at(&self, day: f64) -> f64 {
        let t = (day / self.days).clamp(0.0, 1.0);
        // Of whole numbers for whole ends.
        self.least + self.g / 6.0 * self.change * (t * t * (3.0 - 2.0 * t))
    }
}
