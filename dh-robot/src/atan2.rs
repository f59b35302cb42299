//! Angles of several vectors at once, without branches.
//!
//! The counterpart of [`sincos`](crate::sincos) for the way back: an inverse takes an atan2 per joint and solution, and the
//! solutions are computed side by side.
//!
//! # Method
//!
//! 1. By symmetry to the first octant: `t = min(|x|, |y|) / max(|x|, |y|)`, in [0, 1].
//! 2. Where `t > 1/2` it becomes `(t - 1) / (t + 1)`, whose angle is less by pi/4: computed from the minimum and the
//!    maximum, where the difference is exact. Now `|t| <= 1/2`.
//! 3. A polynomial for `atan t`, minimax in the relative error: 2^-57.8.
//! 4. Back to the octant: the angle is `k * pi/4 + atan t` or `k * pi/4 - atan t` with `k` in 0..=4, and pi/4 in two parts,
//!    so that this is rounded once.

use crate::Real;
use crate::math::mul_add;

/// As in [`sincos`](crate::sincos).
const LANES: usize = 8;

/// The angles of the vectors `(x, y)`, in `(-pi, pi]`; zero for the zero vector.
///
/// Unlike the standard library's function it never answers -pi: a negative zero `y` counts as zero, and an angle that would
/// be rounded to -pi is pi. Any finite arguments will do, up to a quarter of the largest number; a vector with a NaN, or
/// with two infinities, gives NaN, for its lane only.
///
/// For `f64` each result is within 2 ulp: the worst of 6*10^7 vectors was 1.91. For `f32` the arithmetic is `f64` inside,
/// and each result is within 0.51 ulp, that is, nearly always the correctly rounded one. How this is measured stands in
/// `dh-robot/tests/accuracy.rs`.
///
/// ```
/// use core::f64::consts::{FRAC_PI_2, PI};
/// use dh_robot::atan2::atan2_batch;
///
/// assert_eq!(atan2_batch(&[0.0, 1.0, -0.0, 0.0], &[0.0, 0.0, -1.0, 2.0]), [0.0, FRAC_PI_2, PI, 0.0]);
/// ```
#[inline(always)]
pub fn atan2_batch<T: Real, const N: usize>(y: &[T; N], x: &[T; N]) -> [T; N] {
    let mut angles = [T::zero(); N];
    for start in (0..N).step_by(LANES) {
        let (to, y, x) = (&mut angles[start..], &y[start..], &x[start..]);
        // Decided while compiling. Wide vectors take few vectors and many alike; with two lanes every pair costs.
        match to.len() {
            _ if cfg!(target_feature = "avx") => chunk::<T, LANES>(to, y, x),
            1 => chunk::<T, 1>(to, y, x),
            2..=4 => chunk::<T, 4>(to, y, x),
            5..=6 => chunk::<T, 6>(to, y, x),
            _ => chunk::<T, LANES>(to, y, x),
        }
    }
    angles
}

/// The first `L` angles, or as many as there are.
#[inline(always)]
fn chunk<T: Real, const L: usize>(to: &mut [T], y: &[T], x: &[T]) {
    let (mut ys, mut xs, mut angles) = ([T::zero(); L], [T::zero(); L], [T::zero(); L]);
    for (lane, value) in ys.iter_mut().zip(y) {
        *lane = *value;
    }
    for (lane, value) in xs.iter_mut().zip(x) {
        *lane = *value;
    }
    for i in 0..L {
        angles[i] = T::atan2_lane(ys[i], xs[i]);
    }
    for (to, angle) in to.iter_mut().zip(angles) {
        *to = angle;
    }
}

// pi/4 in two parts. The first ends in three zero bits, so that small multiples of it are exact.
const PI_4_FIRST: f64 = core::f64::consts::FRAC_PI_4;
const PI_4_SECOND: f64 = 3.061_616_997_868_383e-17;

// (atan t / t - 1) / t^2 as a polynomial in t^2 on [0, 1/4], by the Remez exchange.
const ATAN: [f64; 12] = [
    -0.333_333_333_333_329_8,
    0.199_999_999_999_030_7,
    -0.142_857_142_763_821_1,
    0.111_111_106_594_564_12,
    -0.090_908_962_398_652_18,
    0.076_920_738_313_810_38,
    -0.066_638_097_457_308_46,
    0.058_582_927_787_202_93,
    -0.051_219_775_900_107_55,
    0.041_864_229_411_471_006,
    -0.027_433_611_394_700_12,
    0.010_115_891_069_686_961,
];

/// One lane in double precision.
#[inline(always)]
pub(crate) fn lane(y: f64, x: f64) -> f64 {
    let octant = Octant::of(y, x);
    let t = octant.tangent;
    let z = t * t;
    let zz = z * z;
    let z4 = zz * zz;
    let low = mul_add(zz, mul_add(z, ATAN[3], ATAN[2]), mul_add(z, ATAN[1], ATAN[0]));
    let middle = mul_add(zz, mul_add(z, ATAN[7], ATAN[6]), mul_add(z, ATAN[5], ATAN[4]));
    let high = mul_add(zz, mul_add(z, ATAN[11], ATAN[10]), mul_add(z, ATAN[9], ATAN[8]));
    octant.angle(mul_add(z * t, mul_add(z4, mul_add(z4, high, middle), low), t))
}

// The same for a result in single precision: relative error 2^-31.9.
const ATAN_SHORT: [f64; 6] = [
    -0.333_333_269_222_293_67,
    0.199_994_896_401_688_52,
    -0.142_720_742_824_680_97,
    0.109_409_434_947_320_35,
    -0.079_839_060_310_914_3,
    0.038_720_915_401_482_96,
];

/// One lane in single precision, computed in double precision.
#[inline(always)]
pub(crate) fn lane_short(y: f32, x: f32) -> f32 {
    let octant = Octant::of(f64::from(y), f64::from(x));
    let t = octant.tangent;
    let z = t * t;
    let zz = z * z;
    let low = mul_add(zz, mul_add(z, ATAN_SHORT[3], ATAN_SHORT[2]), mul_add(z, ATAN_SHORT[1], ATAN_SHORT[0]));
    let p = mul_add(zz * zz, mul_add(z, ATAN_SHORT[5], ATAN_SHORT[4]), low);
    let angle = octant.angle(mul_add(z * t, p, t)) as f32;
    // Rounding to single precision can reach -pi again.
    if angle <= -core::f32::consts::PI { core::f32::consts::PI } else { angle }
}

/// Where a vector is: its angle is `eighths * pi/4` plus or minus the arc tangent of `tangent`.
struct Octant {
    tangent: f64,
    eighths: f64,
    /// The sign bit where the arc tangent counts down, else zero.
    down: u64,
    below: bool,
}

const SIGN: u64 = 1 << 63;

impl Octant {
    #[inline(always)]
    fn of(y: f64, x: f64) -> Self {
        let (ax, ay) = (x.abs(), y.abs());
        let steep = ax < ay;
        let (least, greatest) = if steep { (ax, ay) } else { (ay, ax) };
        let wide = least > 0.5 * greatest;
        let numerator = if wide { least - greatest } else { least };
        let denominator = if wide { least + greatest } else { greatest };
        // The zero vector has the angle zero.
        let denominator = if denominator == 0.0 { 1.0 } else { denominator };
        // Each reflection (at the diagonal, at the y axis) takes the eighths from 2 or 4, and exchanges up and down.
        let eighths = if wide { 1.0_f64 } else { 0.0 };
        let eighths = (if steep { 2.0 } else { 0.0 } - eighths).abs();
        let backwards = x < 0.0;
        let eighths = (if backwards { 4.0 } else { 0.0 } - eighths).abs();
        let down = if steep { SIGN } else { 0 } ^ if backwards { SIGN } else { 0 };
        Self { tangent: numerator / denominator, eighths, down, below: y < 0.0 }
    }

    /// The angle, from the arc tangent.
    #[inline(always)]
    fn angle(self, arc: f64) -> f64 {
        let arc = f64::from_bits(arc.to_bits() ^ self.down);
        let angle = mul_add(self.eighths, PI_4_FIRST, mul_add(self.eighths, PI_4_SECOND, arc));
        // An angle has one name: pi, not -pi.
        let negate = self.below & (angle < core::f64::consts::PI);
        f64::from_bits(angle.to_bits() ^ if negate { SIGN } else { 0 })
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

    use super::*;

    #[test]
    fn axes_and_diagonals_are_exact() {
        let y = [0.0, 1.0, 1.0, 1.0, 0.0, -1.0, -1.0, -1.0];
        let x = [1.0, 1.0, 0.0, -1.0, -1.0, -1.0, 0.0, 1.0];
        let expected = [0.0, 1.0, 2.0, 3.0, 4.0, -3.0, -2.0, -1.0].map(|eighths| eighths * FRAC_PI_4);
        assert_eq!(atan2_batch(&y, &x), expected);
        assert_eq!(atan2_batch(&y.map(|y| y as f32), &x.map(|x| x as f32)), expected.map(|angle| angle as f32));
    }

    #[test]
    fn the_zero_vector_has_the_angle_zero() {
        assert_eq!(atan2_batch(&[0.0, 0.0, -0.0, -0.0], &[0.0, -0.0, 0.0, -0.0]), [0.0; 4]);
        assert_eq!(atan2_batch(&[0.0_f32], &[-0.0]), [0.0]);
    }

    #[test]
    fn minus_pi_is_pi() {
        assert_eq!(atan2_batch(&[-0.0, -1e-17, -1e-300], &[-1.0, -1.0, -1e10]), [PI; 3]);
        assert_eq!(atan2_batch(&[-0.0_f32, -1e-9], &[-1.0, -1.0]), [core::f32::consts::PI; 2]);
        let [below] = atan2_batch(&[-1e-15], &[-1.0]);
        assert!(below < -3.0 && below > -PI);
    }

    #[test]
    fn extreme_sizes_keep_their_angle() {
        for size in [1e-300, 1e-150, 1e150, 4e307] {
            assert_eq!(atan2_batch(&[size, size, 0.0], &[size, -size, size]), [FRAC_PI_4, 3.0 * FRAC_PI_4, 0.0]);
            assert_eq!(atan2_batch(&[size], &[0.0]), [FRAC_PI_2]);
        }
        assert_eq!(atan2_batch(&[1e-150], &[1e150]), [1e-300]);
        assert_eq!(atan2_batch(&[1e150], &[-1e-150]), [FRAC_PI_2]);
    }

    #[test]
    fn what_is_no_number_stays_in_its_lane() {
        let nan = f64::NAN;
        let angles =
            atan2_batch(&[nan, 1.0, nan, f64::INFINITY, 1.0, 1.0], &[1.0, nan, nan, f64::INFINITY, f64::INFINITY, 1.0]);
        assert!(angles[..4].iter().all(|angle| angle.is_nan()), "{angles:?}");
        assert_eq!(angles[4..], [0.0, FRAC_PI_4]);
    }

    #[test]
    fn sizes_of_batches_make_no_difference() {
        fn check<const N: usize>() {
            let y: [f64; N] = core::array::from_fn(|i| 0.7 * i as f64 - 3.0);
            let x: [f64; N] = core::array::from_fn(|i| 2.0 - 0.9 * i as f64);
            let angles = atan2_batch(&y, &x);
            for i in 0..N {
                assert_eq!(atan2_batch(&[y[i]], &[x[i]]), [angles[i]], "{i} of {N}");
                assert!((angles[i] - y[i].atan2(x[i])).abs() < 1e-15);
            }
        }
        check::<0>();
        check::<1>();
        check::<2>();
        check::<3>();
        check::<6>();
        check::<8>();
        check::<9>();
        check::<12>();
        check::<21>();
    }
}
