//! Angles of unit vectors at once: no jumps, no division, and half the work of an atan2.
//!
//! # Method
//!
//! 1. By symmetry to the first octant: the lesser of `|x|` and `|y|` is the sine of the angle there.
//! 2. Above pi/8 the vector is turned back by pi/4, which takes a subtraction and a multiplication: the sine is now at most sin(pi/8).
//! 3. A polynomial for `asin`, minimax in the relative error: 2^-57.3.
//! 4. Back to the octant, quadrant and half plane.

use crate::math::mul_add;

/// Elements per chunk where the compiler takes them all at once.
const LANES: usize = 8;

/// The angles of the unit vectors `(x, y)` in `(-pi, pi]`, within 3e-16 for a vector that is a unit vector within rounding; for others (also
/// infinite ones or such with a NaN) whatever comes out.
#[inline(always)]
#[must_use]
pub fn angles<const N: usize>(y: &[f64; N], x: &[f64; N]) -> [f64; N] {
    let mut angles = [0.0; N];
    for start in (0..N).step_by(LANES) {
        let (to, y, x) = (&mut angles[start..], &y[start..], &x[start..]);
        // Decided while compiling, as in `atan2_batch`.
        match to.len() {
            _ if cfg!(target_feature = "avx") => chunk::<LANES>(to, y, x),
            1 => chunk::<1>(to, y, x),
            2 => chunk::<2>(to, y, x),
            3..=4 => chunk::<4>(to, y, x),
            5..=6 => chunk::<6>(to, y, x),
            _ => chunk::<LANES>(to, y, x),
        }
    }
    angles
}

/// The first `L` angles, or as many as there are.
#[inline(always)]
fn chunk<const L: usize>(to: &mut [f64], y: &[f64], x: &[f64]) {
    let (mut ys, mut xs, mut angles) = ([0.0; L], [0.0; L], [0.0; L]);
    for (lane, value) in ys.iter_mut().zip(y) {
        *lane = *value;
    }
    for (lane, value) in xs.iter_mut().zip(x) {
        *lane = *value;
    }
    for i in 0..L {
        angles[i] = angle(ys[i], xs[i]);
    }
    for (to, angle) in to.iter_mut().zip(angles) {
        *to = angle;
    }
}

/// sin(pi/8).
const SIN_PI_8: f64 = 0.382_683_432_365_089_8;

// (asin m / m - 1) / m^2 as a polynomial in m^2 on [0, sin(pi/8)^2], by the Remez exchange.
const ASIN: [f64; 10] = [
    0.166_666_666_666_660_97,
    0.075_000_000_001_871_83,
    0.044_642_856_930_223_38,
    0.030_381_956_380_251_148,
    0.022_371_775_297_456_13,
    0.017_360_361_709_037_996,
    0.013_869_422_751_869_413,
    0.012_309_527_866_217_406,
    0.006_128_264_310_771_112,
    0.017_589_606_305_022_702,
];

/// The angle of one unit vector, see [`angles`].
#[inline(always)]
#[must_use]
pub fn angle(y: f64, x: f64) -> f64 {
    use core::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, FRAC_PI_4, PI};
    let (ax, ay) = (x.abs(), y.abs());
    let steep = ax < ay;
    let (least, greatest) = if steep { (ax, ay) } else { (ay, ax) };
    let wide = least > SIN_PI_8;
    let m = if wide { (least - greatest) * FRAC_1_SQRT_2 } else { least };
    let z = m * m;
    let zz = z * z;
    let z4 = zz * zz;
    let low = mul_add(zz, mul_add(z, ASIN[3], ASIN[2]), mul_add(z, ASIN[1], ASIN[0]));
    let middle = mul_add(zz, mul_add(z, ASIN[7], ASIN[6]), mul_add(z, ASIN[5], ASIN[4]));
    let high = mul_add(z, ASIN[9], ASIN[8]);
    let arc = mul_add(z * m, mul_add(z4, mul_add(z4, high, middle), low), m);
    let octant = arc + if wide { FRAC_PI_4 } else { 0.0 };
    let quadrant = flip(octant, steep) + if steep { FRAC_PI_2 } else { 0.0 };
    let backwards = x < 0.0;
    let half = flip(quadrant, backwards) + if backwards { PI } else { 0.0 };
    // An angle has one name: pi, not -pi.
    flip(half, (y < 0.0) & (half < PI))
}

/// The number, or its negative.
#[inline(always)]
fn flip(x: f64, negate: bool) -> f64 {
    f64::from_bits(x.to_bits() ^ if negate { 1 << 63 } else { 0 })
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

    use super::*;

    #[test]
    fn axes_are_exact_and_half_a_turn_is_positive() {
        let y = [0.0, 1.0, 0.0, -1.0, -0.0, -0.0, -1e-300, -5e-17, 1e-300];
        let x = [1.0, 0.0, -1.0, 0.0, 1.0, -1.0, -1.0, -1.0, 1.0];
        assert_eq!(angles(&y, &x), [0.0, FRAC_PI_2, PI, -FRAC_PI_2, 0.0, PI, PI, PI, 1e-300]);
        let h = core::f64::consts::FRAC_1_SQRT_2;
        assert_eq!(angles(&[h, h, -h, -h], &[h, -h, -h, h]), [1.0, 3.0, -3.0, -1.0].map(|k| k * FRAC_PI_4));
    }

    #[test]
    fn every_size_agrees_with_the_angle_that_made_the_vector() {
        fn check<const N: usize>() {
            for k in 0..20_000 / N {
                let a: [f64; N] = core::array::from_fn(|i| (k * N + i) as f64 * (PI / 10_000.0) - PI + 1e-9);
                let (y, x) = (a.map(|a| crate::math::sin_cos(a).0), a.map(|a| crate::math::sin_cos(a).1));
                for (got, a) in angles(&y, &x).into_iter().zip(a) {
                    assert!((got - a).abs() <= 3e-16_f64.max(4e-16 * a.abs()), "{a}: {got}");
                }
            }
        }
        check::<1>();
        check::<2>();
        check::<3>();
        check::<4>();
        check::<6>();
        check::<8>();
        check::<12>();
        check::<16>();
    }

    #[test]
    fn small_angles_keep_their_relative_accuracy() {
        for a in [1e-3_f64, 1e-6, 1e-12, 1e-200] {
            let (s, c) = crate::math::sin_cos(a);
            let got = angles(&[s], &[c])[0];
            assert!((got - a).abs() <= 2e-16 * a, "{a}: {got}");
        }
    }
}
