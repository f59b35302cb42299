//! Measures the errors of the batched kernels against a reference with twice the digits, and bounds them.
//!
//! `cargo test -p dh-robot` takes some 10^5 points. The numbers that the documentation states are from
//! `DH_ROBOT_POINTS=20000000 cargo test -p dh-robot --release --test accuracy -- --nocapture`, which prints the largest errors.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use dh_robot::atan2::atan2_batch;
use dh_robot::sincos::{LIMIT, sincos_batch};

mod reference;

use reference::{Double, angle_error, sin_cos};

/// Random points per range of arguments.
fn points() -> u64 {
    std::env::var("DH_ROBOT_POINTS").ok().and_then(|n| n.parse().ok()).unwrap_or(40_000)
}

/// A generator of 64-bit words (xorshift, Marsaglia 2003): the same points in every run.
struct Random(u64);

impl Random {
    fn word(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    /// Uniform in [-1, 1).
    fn uniform(&mut self) -> f64 {
        (self.word() >> 11) as f64 * (2.0_f64).powi(-52) - 1.0
    }
}

/// The largest error so far, and where.
#[derive(Default)]
struct Worst {
    ulps: f64,
    at: [f64; 2],
}

impl Worst {
    fn see(&mut self, ulps: f64, at: [f64; 2]) {
        if ulps > self.ulps || ulps.is_nan() {
            *self = Self { ulps, at };
        }
    }
}

/// The error of `got` in units in the last place of the exact value.
fn ulps(got: f64, exact: Double) -> f64 {
    let size = exact.high.abs();
    let ulp = f64::from_bits(size.to_bits() & 0x7ff0_0000_0000_0000) * f64::EPSILON;
    (((got - exact.high) - exact.low) / ulp).abs()
}

fn ulps_single(got: f32, exact: Double) -> f64 {
    let size = exact.high.abs();
    let ulp = f64::from_bits(size.to_bits() & 0x7ff0_0000_0000_0000) * f64::from(f32::EPSILON);
    (((f64::from(got) - exact.high) - exact.low) / ulp).abs()
}

/// Largest errors of sine and cosine over batches of eight.
fn measure(name: &str, mut next: impl FnMut(u64) -> f64, count: u64) -> [f64; 2] {
    let (mut sine, mut cosine) = (Worst::default(), Worst::default());
    for batch in 0..count.div_ceil(8) {
        let angles: [f64; 8] = core::array::from_fn(|i| next(8 * batch + i as u64));
        let (s, c) = sincos_batch(&angles);
        for i in 0..8 {
            let (exact_s, exact_c) = sin_cos(angles[i]);
            sine.see(ulps(s[i], exact_s), [angles[i], s[i]]);
            cosine.see(ulps(c[i], exact_c), [angles[i], c[i]]);
        }
    }
    eprintln!(
        "{name:34} sin {:.3} ulp at {:e}   cos {:.3} ulp at {:e}",
        sine.ulps, sine.at[0], cosine.ulps, cosine.at[0]
    );
    [sine.ulps, cosine.ulps]
}

#[test]
fn sines_and_cosines_of_random_angles() {
    let mut random = Random(88_172_645_463_325_252);
    for (name, size) in
        [("|x| < pi/4", FRAC_PI_4), ("|x| < 2 pi", 2.0 * PI), ("|x| < 100", 100.0), ("|x| < 1e5", LIMIT)]
    {
        for error in measure(name, |_| random.uniform() * size, points()) {
            assert!(error < SINCOS_BOUND, "{name}: {error}");
        }
    }
    // All sizes alike: 2^-40 to 2^16.
    for error in
        measure("|x| from 1e-12 to 1e5", |_| random.uniform() * (28.0 * random.uniform() - 12.0).exp2(), points())
    {
        assert!(error < SINCOS_BOUND, "{error}");
    }
}

/// What the documentation of `sincos_batch` promises, in ulp.
const SINCOS_BOUND: f64 = 1.1;

#[test]
fn sines_and_cosines_next_to_multiples_of_a_quarter_turn() {
    // Every multiple up to the limit: the nearest double, its neighbours, and a few somewhat farther away.
    let offsets = [0_i64, 1, -1, 2, -2, 1 << 20, -(1 << 20), 1 << 40];
    let all = (LIMIT / FRAC_PI_2) as u64;
    let step = if points() > 1_000_000 { 1 } else { 16 };
    let multiple = |i: u64| {
        let n = (i / 8 * step + 1) as f64;
        let near = n * FRAC_PI_2;
        let shifted = f64::from_bits((near.to_bits() as i64 + offsets[i as usize % 8]) as u64);
        if (i / 8).is_multiple_of(2) { shifted } else { -shifted }
    };
    for error in measure("next to k pi/2", multiple, 8 * (all / step - 1)) {
        assert!(error < SINCOS_BOUND, "{error}");
    }
    for error in measure("next to (k + 1/2) pi/2", |i| multiple(i) + FRAC_PI_4, 8 * (all / step - 2)) {
        assert!(error < SINCOS_BOUND, "{error}");
    }
}

#[test]
fn angles_of_random_vectors() {
    let mut random = Random(3_141_592_653_589_793);
    for (name, spread) in
        [("vectors of like coordinates", 0.0), ("vectors of all slopes", 30.0), ("of extreme slopes", 900.0)]
    {
        let mut worst = Worst::default();
        for _ in 0..points().div_ceil(8) {
            let mut coordinate = || random.uniform() * (spread * random.uniform()).exp2();
            let y: [f64; 8] = core::array::from_fn(|_| coordinate());
            let x: [f64; 8] = core::array::from_fn(|_| coordinate());
            let angles = atan2_batch(&y, &x);
            for i in 0..8 {
                if angles[i].abs() > f64::MIN_POSITIVE / f64::EPSILON {
                    worst.see(angle_error(angles[i], y[i], x[i]), [y[i], x[i]]);
                }
            }
        }
        eprintln!("atan2, {name:28} {:.3} ulp at {:e}, {:e}", worst.ulps, worst.at[0], worst.at[1]);
        assert!(worst.ulps < ATAN2_BOUND, "{name}: {}", worst.ulps);
    }
}

#[test]
fn angles_next_to_the_axes_and_diagonals_are_rounded_once() {
    let mut random = Random(161_803_398_874_989);
    let mut worst = Worst::default();
    for _ in 0..points().div_ceil(80) {
        let tilt = random.uniform() * 1e-4;
        for (y, x) in [(1.0, tilt), (tilt, -1.0), (-1.0, tilt), (1.0 + tilt, 1.0), (1.0, -1.0 - tilt)] {
            let [angle] = atan2_batch(&[y], &[x]);
            worst.see(angle_error(angle, y, x), [y, x]);
        }
    }
    eprintln!("atan2 next to axes and diagonals   {:.3} ulp at {:e}, {:e}", worst.ulps, worst.at[0], worst.at[1]);
    assert!(worst.ulps < 0.51, "{}", worst.ulps);
}

/// What the documentation of `atan2_batch` promises, in ulp.
const ATAN2_BOUND: f64 = 2.0;

#[test]
fn single_precision_is_correctly_rounded_but_for_ties() {
    let mut random = Random(2_718_281_828_459_045);
    let mut worst = [0.0_f64; 3];
    for size in [0.8_f32, 7.0, 1e5] {
        for _ in 0..points().div_ceil(8) {
            let angles: [f32; 8] = core::array::from_fn(|_| random.uniform() as f32 * size);
            let others: [f32; 8] = core::array::from_fn(|_| random.uniform() as f32);
            let (s, c) = sincos_batch(&angles);
            let turns = atan2_batch(&angles, &others);
            for i in 0..8 {
                let (exact_s, exact_c) = sin_cos(f64::from(angles[i]));
                worst[0] = worst[0].max(ulps_single(s[i], exact_s));
                worst[1] = worst[1].max(ulps_single(c[i], exact_c));
                let exact = Double { high: f64::from(angles[i]).atan2(f64::from(others[i])), low: 0.0 };
                worst[2] = worst[2].max(ulps_single(turns[i], exact));
            }
        }
    }
    eprintln!("f32: sin {:.4} cos {:.4} atan2 {:.4} ulp", worst[0], worst[1], worst[2]);
    assert!(worst.iter().all(|ulps| *ulps < 0.51), "{worst:?}");
}
