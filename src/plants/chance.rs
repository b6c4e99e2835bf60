//! Irregularity that belongs to a plant, or to one individual of it.

/// Numbers that look like chance and are always the same for the same place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Chance {
    salt: u32,
}

impl Chance {
    /// The same for all individuals.
    pub const PLANT: Chance = Chance { salt: 0 };

    /// An individual's own.
    pub fn of(individual: u32) -> Chance {
        Chance { salt: mixed(individual) }
    }

    /// A number from 0 to 1.
    pub(super) fn scatter(self, item: u32, purpose: u32) -> f32 {
        let place = item.wrapping_mul(0x9e37_79b9) ^ purpose.wrapping_mul(0x85eb_ca6b);
        // 24 bits are what an f32 between 0 and 1 holds.
        (mixed(place ^ self.salt) >> 8) as f32 / (1 << 24) as f32
    }

    /// A number from -1 to 1.
    pub(super) fn shaken(self, item: u32, purpose: u32) -> f32 {
        2.0 * self.scatter(item, purpose) - 1.0
    }

    /// Noise from -1 to 1 along a line: straight from one random value at a whole number to the next.
    pub(super) fn rough(self, at: f32, item: u32, purpose: u32) -> f32 {
        let whole = libm::floorf(at);
        let value = |k: f32| self.shaken(item + 64 * k as u32, purpose);
        let t = at - whole;
        value(whole) * (1.0 - t) + value(whole + 1.0) * t
    }
}

/// The finaliser of MurmurHash3 (Appleby 2011).
fn mixed(bits: u32) -> u32 {
    let bits = (bits ^ (bits >> 16)).wrapping_mul(0x85eb_ca6b);
    let bits = (bits ^ (bits >> 13)).wrapping_mul(0xc2b2_ae35);
    bits ^ (bits >> 16)
}
