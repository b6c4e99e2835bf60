//! Exact mean populations, to test the growth against.

/// Mean number of descendants, itself included, of one cell of age 0 when the divisions up to each
/// day `0..=days` are done, for Poisson clocks of mean `division_days` and no mutation:
/// `m(t) = [1 - sum_{k<=t} q_k + 2 sum_{1<=k<=t} q_k m(t-k)] / (1 - 2 q_0)`. A run of `d` days ends
/// with `m(d - 1)` times its first cells in the mean.
pub fn mean_descendants(division_days: f64, days: usize) -> Vec<f64> {
    let mut q = vec![libm::exp(-division_days)];
    for k in 1..=days {
        q.push(q[k - 1] * division_days / k as f64);
    }
    let mut m: Vec<f64> = Vec::with_capacity(days + 1);
    for t in 0..=days {
        let waiting = 1.0 - q[..=t].iter().sum::<f64>();
        let divided: f64 = (1..=t).map(|k| q[k] * m[t - k]).sum();
        m.push((waiting + 2.0 * divided) / (1.0 - 2.0 * q[0]));
    }
    m
}
