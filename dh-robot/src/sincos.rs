//! Sines and cosines of all joint angles at once, without branches.
//!
//! Nearly all the time of a forward kinematics goes into sines and cosines. A mathematics library computes them one by
//! one and asks about the size of each angle; [`sincos_batch`] computes them in lanes, with the same instructions for every
//! angle, which the compiler turns into vector instructions: two lanes with plain SSE2, four with AVX2.
//!
//! # Method
//!
//! 1. `n` is the whole number nearest to `x / (pi/2)`: adding and taking off `3 * 2^51` rounds, and leaves `n` in the
//!    lowest bits of the sum, from where the quadrant is read.
//! 2. `r = x - n * pi/2` with pi/2 in three parts (Cody and Waite): the first two have 37 and 35 bits, so that their
//!    products with `n < 2^16` are exact, and so is the first difference; the parts together hold 125 bits. So the
//!    *relative* error of `r` stays below one ulp even where `x` is the number nearest to a multiple of pi/2.
//! 3. Polynomials for `sin r` and `cos r`, minimax in the relative error: 2^-57.9 and 2^-63.9.
//! 4. Odd quadrants exchange the two, and the quadrant gives the signs, by masks.
//!
//! Above [`LIMIT`] (also NaN and infinity) the whole batch goes to the functions of [`math`].

use crate::Real;
use crate::math::{self, mul_add};

/// The largest angle, in radians, that the batch computes by itself.
pub const LIMIT: f64 = 1e5;

/// Lanes of one round. Eight, so that every vector width divides it; and a loop of eight is long enough that the compiler
/// vectorises it before it could unroll it (four lanes are unrolled and then stay scalar). Lanes without an angle cost
/// little: where a whole vector of them is unused the compiler drops it.
const LANES: usize = 8;

/// Sines and cosines of all angles (in radians): `(sines, cosines)`.
///
/// For `f64` each result is within 1.1 ulp: the worst of 10^8 points was 1.03, multiples of pi/2 and their neighbours
/// included. For `f32` the arithmetic is `f64` inside, and each result is within 0.51 ulp, that is, nearly always the
/// correctly rounded one. NaN and infinity give NaN, for their lane only. How this is measured stands in
/// `dh-robot/tests/accuracy.rs`. With the target feature `fma` some intermediate roundings are left out, so that last bits
/// can differ between builds.
///
/// ```
/// use dh_robot::sincos::sincos_batch;
///
/// let ([s1, s2], [c1, c2]) = sincos_batch(&[0.5_f64, -2.0]);
/// assert!((s1 - 0.5_f64.sin()).abs() < 1e-15 && (c1 - 0.5_f64.cos()).abs() < 1e-15);
/// assert!((s2 + 2.0_f64.sin()).abs() < 1e-15 && (c2 - 2.0_f64.cos()).abs() < 1e-15);
/// ```
#[inline(always)]
pub fn sincos_batch<T: Real, const N: usize>(angles: &[T; N]) -> ([T; N], [T; N]) {
    let mut sines = [T::zero(); N];
    let mut cosines = [T::zero(); N];
    let mut beyond = 0;
    for start in (0..N).step_by(LANES) {
        let mut lanes = [T::zero(); LANES];
        for (lane, angle) in lanes.iter_mut().zip(&angles[start..]) {
            *lane = *angle;
        }
        let mut s = [T::zero(); LANES];
        let mut c = [T::zero(); LANES];
        for i in 0..LANES {
            (s[i], c[i]) = T::sincos_lane(lanes[i]);
            beyond |= T::is_beyond(lanes[i]);
        }
        for (to, from) in sines[start..].iter_mut().zip(s) {
            *to = from;
        }
        for (to, from) in cosines[start..].iter_mut().zip(c) {
            *to = from;
        }
    }
    if beyond != 0 {
        // A copy: were the angles themselves lent, they would be written to memory in every case, one by one, and loaded from there
        // as vectors, which makes the processor wait (15 ns of 38 for a PUMA 560).
        let lent = *angles;
        one_by_one(&lent, &mut sines, &mut cosines);
    }
    (sines, cosines)
}

/// The slow way, for batches with an angle beyond [`LIMIT`].
///
/// It writes over the results instead of returning others: a choice between two sets of results makes the compiler
/// gather them in wide registers, which costs more than all the sines (measured with AVX-512).
#[cold]
#[inline(never)]
fn one_by_one<T: Real>(angles: &[T], sines: &mut [T], cosines: &mut [T]) {
    for ((angle, sine), cosine) in angles.iter().zip(sines).zip(cosines) {
        (*sine, *cosine) = math::sin_cos(*angle);
    }
}

/// Whether a lane is out of the kernel's reach, as 0 or 1.
#[inline(always)]
#[expect(clippy::neg_cmp_op_on_partial_ord, reason = "NaN is beyond too")]
pub(crate) fn is_beyond(x: f64) -> u64 {
    u64::from(!(x.abs() <= LIMIT))
}

/// `3 * 2^51`: numbers up to 2^50 added to it are rounded to whole numbers, which are its lowest bits.
pub(crate) const ROUND: f64 = 6_755_399_441_055_744.0;

// pi/2 in three parts of 37, 35 and 53 bits.
pub(crate) const PI_2_FIRST: f64 = 1.570_796_326_792_333_3;
pub(crate) const PI_2_SECOND: f64 = 2.563_344_151_583_955_8e-12;
pub(crate) const PI_2_THIRD: f64 = 1.056_299_906_698_742_8e-23;

// (sin r / r - 1) / r^2 and (cos r - 1 + r^2/2) / r^4 as polynomials in r^2 on [0, (pi/4)^2], by the Remez exchange.
pub(crate) const SIN: [f64; 6] = [
    -0.166_666_666_666_666_3,
    0.008_333_333_333_322_108,
    -0.000_198_412_698_295_805_75,
    2.755_731_361_814_619_4e-6,
    -2.505_074_723_690_122e-8,
    1.589_619_864_913_022_8e-10,
];
pub(crate) const COS: [f64; 6] = [
    0.041_666_666_666_666_595,
    -0.001_388_888_888_887_304,
    2.480_158_728_884_170_5e-5,
    -2.755_731_417_631_839e-7,
    2.087_570_042_565_557_6e-9,
    -1.135_851_440_003_109e-11,
];

/// One lane in double precision.
#[inline(always)]
pub(crate) fn lane(x: f64) -> (f64, f64) {
    let rounded = mul_add(x, core::f64::consts::FRAC_2_PI, ROUND);
    let n = rounded - ROUND;
    let first = mul_add(-n, PI_2_FIRST, x);
    let r = mul_add(-n, PI_2_SECOND, first);
    // What the rounding of r lost, and the third part: together with r they are the angle to well beyond 53 bits.
    let rest = mul_add(-n, PI_2_THIRD, mul_add(-n, PI_2_SECOND, first - r));
    let z = r * r;
    let zz = z * z;
    let sin_low = mul_add(z, SIN[1], SIN[0]);
    let sin_high = mul_add(zz, mul_add(z, SIN[5], SIN[4]), mul_add(z, SIN[3], SIN[2]));
    let cos_low = mul_add(z, COS[1], COS[0]);
    let cos_high = mul_add(zz, mul_add(z, COS[5], COS[4]), mul_add(z, COS[3], COS[2]));
    let sine = r + mul_add(z * r, mul_add(zz, sin_high, sin_low), rest);
    let cosine = 1.0 - mul_add(0.5, z, mul_add(r, rest, -(zz * mul_add(zz, cos_high, cos_low))));
    turn(rounded, sine, cosine)
}

// The same for a result in single precision: relative errors 2^-37.5 and 2^-33.0.
const SIN_SHORT: [f64; 4] =
    [-0.166_666_666_407_768_45, 0.008_333_329_302_483_775, -0.000_198_393_115_033_048_62, 2.718_114_256_824_194e-6];
const COS_SHORT: [f64; 3] = [0.041_666_645_669_984_94, -0.001_388_731_560_824_165, 2.443_308_165_996_762_5e-5];

/// One lane in single precision, computed in double precision.
#[inline(always)]
pub(crate) fn lane_short(x: f32) -> (f32, f32) {
    let x = f64::from(x);
    let rounded = mul_add(x, core::f64::consts::FRAC_2_PI, ROUND);
    let n = rounded - ROUND;
    let r = mul_add(-n, PI_2_SECOND, mul_add(-n, PI_2_FIRST, x));
    let z = r * r;
    let zz = z * z;
    let p = mul_add(zz, mul_add(z, SIN_SHORT[3], SIN_SHORT[2]), mul_add(z, SIN_SHORT[1], SIN_SHORT[0]));
    let q = mul_add(z, mul_add(z, COS_SHORT[2], COS_SHORT[1]), COS_SHORT[0]);
    let (s, c) = turn(rounded, mul_add(z * r, p, r), 1.0 - mul_add(0.5, z, -(zz * q)));
    (s as f32, c as f32)
}

/// Turns sine and cosine by the quadrant that stands in the lowest bits of `rounded`.
#[inline(always)]
fn turn(rounded: f64, sine: f64, cosine: f64) -> (f64, f64) {
    let quadrant = rounded.to_bits();
    let exchange = 0_u64.wrapping_sub(quadrant & 1);
    let (s, c) = (sine.to_bits(), cosine.to_bits());
    let difference = (s ^ c) & exchange;
    let sine_sign = (quadrant & 2) << 62;
    let cosine_sign = (quadrant.wrapping_add(1) & 2) << 62;
    (f64::from_bits(s ^ difference ^ sine_sign), f64::from_bits(c ^ difference ^ cosine_sign))
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_PI_2, PI};

    use super::*;

    #[test]
    fn zero_and_its_sign_are_exact() {
        let (s, c) = sincos_batch(&[0.0_f64, -0.0]);
        assert_eq!((s, c), ([0.0, 0.0], [1.0, 1.0]));
        let (s, c) = sincos_batch(&[0.0_f32]);
        assert_eq!((s, c), ([0.0], [1.0]));
    }

    #[test]
    fn tiny_angles_are_their_own_sines() {
        let tiny = [1e-8, -1e-100, 1e-300, 5e-324];
        let (s, c) = sincos_batch(&tiny);
        assert_eq!((s, c), (tiny, [1.0; 4]));
    }

    #[test]
    fn quadrants_have_their_signs() {
        let (s, c) = sincos_batch(&core::array::from_fn::<f64, 17, _>(|k| (k as f64 - 8.0) * FRAC_PI_2 + 0.25));
        for (k, (s, c)) in s.into_iter().zip(c).enumerate() {
            let (sine, cosine) = (0.25_f64.sin(), 0.25_f64.cos());
            let expected = [(sine, cosine), (cosine, -sine), (-sine, -cosine), (-cosine, sine)][k % 4];
            assert!((s - expected.0).abs() < 1e-15 && (c - expected.1).abs() < 1e-15, "{k}: {s} {c}");
        }
    }

    #[test]
    fn sizes_of_batches_make_no_difference() {
        fn check<const N: usize>() {
            let angles: [f64; N] = core::array::from_fn(|i| 0.7 * i as f64 - 3.0);
            let (s, c) = sincos_batch(&angles);
            for i in 0..N {
                assert_eq!(sincos_batch(&[angles[i]]), ([s[i]], [c[i]]), "{i} of {N}");
            }
        }
        check::<0>();
        check::<1>();
        check::<5>();
        check::<8>();
        check::<9>();
        check::<20>();
    }

    #[test]
    fn one_large_angle_sends_the_batch_the_slow_way() {
        for large in [LIMIT.next_up(), -1e6, 1e22, f64::MAX] {
            let (s, c) = sincos_batch(&[0.5, large, 2.0]);
            assert_eq!((s[1], c[1]), math::sin_cos(large));
            assert_eq!((s[0], c[2]), (math::sin_cos(0.5).0, math::sin_cos(2.0).1));
        }
        let (s, c) = sincos_batch(&[LIMIT, -LIMIT]);
        let (sine, cosine) = math::sin_cos(LIMIT);
        assert!((s[0] - sine).abs() < 1e-15 && (c[1] - cosine).abs() < 1e-15 && s[0] == -s[1]);
        let (s, _) = sincos_batch(&[1e30_f32]);
        assert_eq!(s[0], math::sin_cos(1e30_f32).0);
    }

    #[test]
    fn what_is_no_number_stays_in_its_lane() {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let (s, c) = sincos_batch(&[0.0, bad, PI]);
            assert!(s[1].is_nan() && c[1].is_nan());
            assert_eq!((s[0], c[0], c[2]), (0.0, 1.0, -1.0));
        }
        assert!(sincos_batch(&[f32::NAN]).0[0].is_nan());
    }
}
