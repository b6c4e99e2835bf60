//! Chance: every random number is a hash of a key and its purpose. A key is a hash of the seed and of
//! the way from the root, so that no draw depends on the order in which parts are visited.

/// What a number is drawn for; each purpose has its own stream.
#[derive(Clone, Copy, Debug)]
#[repr(u64)]
pub enum Purpose {
    Biorder = 1,
    Side = 2,
    Angle = 3,
    Length = 4,
    Turn = 5,
    Width = 6,
}

/// The key of the root of a body.
pub fn root_key(seed: u32) -> u64 {
    // Apart from the keys of cells, which are hashes of small numbers alone.
    mix(u64::from(seed) ^ 0x7368_6170_6573_0000)
}

/// The key of the `number`-th part that grows on a part.
pub fn part_key(key: u64, number: u32) -> u64 {
    mix(key ^ mix(u64::from(number) + 1))
}

/// A uniform number in `0..1` with 53 bits.
pub fn uniform(key: u64, purpose: Purpose) -> f64 {
    let bits = mix(key ^ (purpose as u64) << 56);
    (bits >> 11) as f64 * (1.0 / (1u64 << 53) as f64)
}

/// A uniform number in `-1..1`.
pub fn either_way(key: u64, purpose: Purpose) -> f64 {
    2.0 * uniform(key, purpose) - 1.0
}

/// The finaliser of SplitMix64 (Steele, Lea, Flood, Fast Splittable Pseudorandom Number
/// Generators, OOPSLA 2014): each input bit changes every output bit with chance one half.
fn mix(mut z: u64) -> u64 {
    z = z.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}
