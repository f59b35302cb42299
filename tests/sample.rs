//! Joint vectors to test at: seeded random ones, and the nasty ones.

use std::f64::consts::{FRAC_PI_2, PI};

use dh_symbolic::chain::ChainSpec;

/// A small generator of random numbers, the same in every run (xorshift, Marsaglia 2003).
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// Starts at a seed.
    #[must_use]
    pub fn new(seed: u64) -> Random {
        Random(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    /// Uniform in [-1, 1).
    pub fn signed(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 * (2.0_f64).powi(-52) - 1.0
    }
}

/// Joint vectors for a table: zeros, quarter and half turns, the ends of ranges, and `random` random ones (angles within half a
/// turn, sliding joints within a unit of length).
#[must_use]
pub fn joint_vectors(spec: &ChainSpec, random: usize) -> Vec<Vec<f64>> {
    let turns: Vec<bool> = spec.rows.iter().filter_map(|row| row.moves.as_ref().map(|m| m.revolute)).collect();
    let n = turns.len();
    let mut all = vec![vec![0.0; n]];
    for special in [FRAC_PI_2, -FRAC_PI_2, PI, -PI] {
        all.push(vec![special; n]);
        for j in 0..n {
            let mut q = vec![0.3; n];
            q[j] = special;
            all.push(q);
        }
    }
    let mut source = Random::new(2026);
    for _ in 0..random {
        all.push(turns.iter().map(|turns| source.signed() * if *turns { PI } else { 1.0 }).collect());
    }
    all
}
