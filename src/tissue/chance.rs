//! Chance: every random number is a hash of the seed, the cell's lineage and its purpose, so that
//! no draw depends on the order in which cells are visited.

/// What a number is drawn for; each purpose has its own stream.
#[derive(Clone, Copy, Debug)]
#[repr(u64)]
pub enum Purpose {
    Triangle = 1,
    PlaceAlong = 2,
    PlaceAcross = 3,
    /// Of a first cell, and of the child of a division: two streams, or a founder's first child
    /// would take after it more often than its mutation row says.
    FirstType = 9,
    Type = 4,
    Clock = 5,
    ChildRadius = 6,
    ChildAngle = 7,
    Child = 8,
}

/// The finaliser of SplitMix64 (Steele, Lea, Flood, Fast Splittable Pseudorandom Number
/// Generators, OOPSLA 2014): each input bit changes every output bit with chance one half.
pub fn mix(mut z: u64) -> u64 {
    z = z.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// The key of a first cell.
pub fn founder_key(seed: u32, founder: u32) -> u64 {
    mix(mix(u64::from(seed)) ^ u64::from(founder))
}

/// 64 random bits for the `turn`-th draw of a cell for a purpose.
pub fn draw(key: u64, turn: u32, purpose: Purpose) -> u64 {
    mix(mix(key ^ (purpose as u64) << 56) ^ u64::from(turn))
}

/// A uniform number in `0..1` with 53 bits.
pub fn uniform(key: u64, turn: u32, purpose: Purpose) -> f64 {
    (draw(key, turn, purpose) >> 11) as f64 * (1.0 / (1u64 << 53) as f64)
}

/// An index drawn with the probabilities of a row that sums to 1.
pub fn pick(row: &[f64; 3], u: f64) -> usize {
    if u < row[0] {
        0
    } else if u < row[0] + row[1] || row[2] == 0.0 {
        1
    } else {
        2
    }
}

/// Poisson distributions. Of our own and no library's sampler: its draws may never change, or old links
/// would lie.
#[derive(Clone, Debug, Default)]
pub struct Poisson {
    /// Of the distribution drawn from last, over 0 and at most 500 (where `exp(-mean)` is still far above
    /// the smallest f64).
    mean: f64,
    /// The chances of each number from 0 on and of all up to it, as far as they have been needed.
    chances: Vec<[f64; 2]>,
}

impl Poisson {
    /// The whole number whose share of `0..1` holds `u`.
    pub fn draw(&mut self, mean: f64, u: f64) -> u32 {
        if mean != self.mean {
            self.mean = mean;
            self.chances.clear();
            self.chances.push([libm::exp(-mean); 2]);
        }
        // Beyond this they no longer change the sum.
        let last = (mean + 12.0 * libm::sqrt(mean) + 30.0) as usize;
        while let Some(&[chance, up_to]) = self.chances.last()
            && up_to <= u
            && self.chances.len() <= last
        {
            let chance = chance * (mean / self.chances.len() as f64);
            self.chances.push([chance, up_to + chance]);
        }
        self.chances.partition_point(|&[_, up_to]| up_to <= u) as u32
    }
}

/// The time of an exponential distribution before which a share `u` of `0..1` falls.
pub fn exponential(mean: f64, u: f64) -> f64 {
    -mean * libm::log(1.0 - u)
}

/// A running hash of 64-bit words.
pub struct Hash(u64);

impl Hash {
    pub fn new() -> Hash {
        Hash(0)
    }

    pub fn add(&mut self, word: u64) {
        self.0 = mix(self.0.rotate_left(5) ^ word);
    }

    pub fn finish(&self) -> u64 {
        mix(self.0)
    }
}

/// Six characters for words: the same words have the same, and others have others, but for one in a thousand million.
pub fn name_of(words: impl Iterator<Item = u64>) -> String {
    let mut hash = Hash::new();
    words.for_each(|word| hash.add(word));
    let bits = hash.finish();
    const DIGITS: &[u8; 32] = b"0123456789abcdefghjkmnpqrstvwxyz";
    (0..6).map(|k| DIGITS[(bits >> (59 - 5 * k)) as usize & 31] as char).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_mixed_as_splitmix64_does() {
        // The first three numbers from state 0 of the reference implementation (S. Vigna, splitmix64.c).
        const STEP: u64 = 0x9e37_79b9_7f4a_7c15;
        let mixed = [0, STEP, STEP.wrapping_mul(2)].map(mix);
        assert_eq!(mixed, [0xe220_a839_7b1d_cdaf, 0x6e78_9e6a_a1b9_65f4, 0x06c4_5d18_8009_454f]);
    }

    #[test]
    fn draws_hold_their_shares_whatever_was_drawn_before() {
        let mut poisson = Poisson::default();
        for turn in 0..2000 {
            let mean = [3.0, 10.0, 60.0, 500.0][turn as usize % 4];
            let u = uniform(7, turn, Purpose::Clock);
            let number = poisson.draw(mean, u);
            // The sum of the chances up to a number, from the logarithms of its terms.
            let up_to = |number: u32| {
                let chance = |n: u32| {
                    let n = f64::from(n);
                    libm::exp(n * libm::log(mean) - mean - libm::lgamma(n + 1.0))
                };
                (0..number).map(chance).sum::<f64>()
            };
            assert!(up_to(number) <= u + 1e-9, "{number} of mean {mean} for {u}");
            assert!(u <= up_to(number + 1) + 1e-9, "{number} of mean {mean} for {u}");
        }
        let mut fresh = Poisson::default();
        let ends = [0.0, 1.0 - f64::EPSILON].map(|u| (poisson.draw(3.0, u), fresh.draw(3.0, u)));
        assert!(ends.iter().all(|(one, other)| one == other) && ends[0].0 == 0);
    }
}
