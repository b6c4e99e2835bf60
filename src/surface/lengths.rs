//! Lengths for inner loops: those of glam go through a square root in software in wasm, std's is one
//! instruction everywhere and gives the same bits.

use glam::Vec2;

#[inline]
pub fn length(v: Vec2) -> f32 {
    v.length_squared().sqrt()
}

#[inline]
pub fn distance(a: Vec2, b: Vec2) -> f32 {
    length(a - b)
}

#[inline]
pub fn normalized(v: Vec2) -> Vec2 {
    v * (1.0 / length(v))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_are_the_lengths_of_glam_bit_for_bit() {
        for k in 1..1000 {
            let (a, b) = (Vec2::new(0.37 * k as f32, 1.0 / k as f32), Vec2::new(-0.1, 7.3));
            assert_eq!(length(a), a.length());
            assert_eq!(distance(a, b), a.distance(b));
            assert_eq!(normalized(a), a.normalize());
        }
    }
}
