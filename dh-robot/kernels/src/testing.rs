//! Test helpers of the kernels: a seeded generator of numbers.

use core::f64::consts::PI;

use super::TrigPoly;
use super::chain::NumericChain;
use super::pose::{IDENTITY, Pose, compose, turn};

/// SplitMix64 (Steele, Lea, Flood, 2014): the same numbers on every machine.
pub(crate) struct Rng(u64);

impl Rng {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in [0, 1).
    pub(crate) fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Uniform in [-1, 1).
    pub(crate) fn symmetric(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }

    /// Uniform in (-pi, pi].
    pub(crate) fn angle(&mut self) -> f64 {
        -PI * self.symmetric()
    }
}

/// A rigid transform with a random rotation, and a random offset in the unit cube.
pub(crate) fn random_pose(rng: &mut Rng) -> Pose {
    let mut t = IDENTITY;
    for k in 0..3 {
        t[k][3] = rng.symmetric();
    }
    for _ in 0..2 {
        let (s, c) = rng.angle().sin_cos();
        t = turn(&t, [c, s]);
        let (s, c) = rng.angle().sin_cos();
        t = compose(&t, &[[1.0, 0.0, 0.0, 0.0], [0.0, c, -s, 0.0], [0.0, s, c, 0.0]]);
    }
    t
}

/// The constant transform after a joint in the standard convention: Tz(d) Tx(a) Rx(alpha), alpha in degrees.
pub(crate) fn link(d: f64, a: f64, alpha: f64) -> Pose {
    let (s, c) = match alpha {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        -90.0 => (-1.0, 0.0),
        180.0 => (0.0, -1.0),
        _ => alpha.to_radians().sin_cos(),
    };
    [[1.0, 0.0, 0.0, a], [0.0, c, -s, 0.0], [0.0, s, c, d]]
}

/// An arm without any structure.
pub(crate) fn general_6r() -> NumericChain<6> {
    NumericChain {
        links: [
            link(0.1, 0.3, 40.0),
            link(0.2, 0.5, -70.0),
            link(-0.15, 0.25, 110.0),
            link(0.45, 0.1, 55.0),
            link(0.05, 0.2, -85.0),
            link(0.3, 0.15, 25.0),
        ],
        prismatic: [false; 6],
    }
}

/// A trigonometric polynomial with uniform coefficients.
pub(crate) fn random_trig_poly<const D: usize>(rng: &mut Rng) -> TrigPoly<D> {
    let constant = rng.symmetric();
    TrigPoly { constant, cos: [(); D].map(|()| rng.symmetric()), sin: [(); D].map(|()| rng.symmetric()) }
}
