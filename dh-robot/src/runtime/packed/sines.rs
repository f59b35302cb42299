//! Sines and cosines of packed angles, by the method of [`sincos`](crate::sincos).

use core::f64::consts::FRAC_2_PI;

use super::number::{Packed, Register};
use crate::sincos::{COS, LIMIT, PI_2_FIRST, PI_2_SECOND, PI_2_THIRD, ROUND, SIN};

/// Computes sines and cosines, and remembers whether an angle was too large for that.
#[derive(Clone, Copy, Debug)]
pub struct Sines<R: Register> {
    register: R,
    beyond: R::Mask,
}

impl<R: Register> Sines<R> {
    #[cfg(feature = "simd")]
    #[inline(always)]
    pub(super) fn new(register: R) -> Self {
        Sines { register, beyond: register.nowhere() }
    }

    /// Whether some angle was beyond the limit, or not a number.
    #[cfg(feature = "simd")]
    #[inline(always)]
    pub(super) fn beyond(&self) -> bool {
        self.register.is_anywhere(self.beyond)
    }

    /// Sines and cosines of all angles, in radians.
    #[inline(always)]
    pub fn of<const M: usize>(&mut self, angles: &[Packed<R>; M]) -> ([Packed<R>; M], [Packed<R>; M]) {
        let (mut sines, mut cosines) = (*angles, *angles);
        for ((sine, cosine), angle) in sines.iter_mut().zip(&mut cosines).zip(angles) {
            self.beyond = self.register.or_beyond(self.beyond, angle.numbers, LIMIT);
            (*sine, *cosine) = sine_and_cosine(*angle);
        }
        (sines, cosines)
    }
}

/// As [`sincos::lane`](crate::sincos) does it.
#[inline(always)]
fn sine_and_cosine<R: Register>(x: Packed<R>) -> (Packed<R>, Packed<R>) {
    let k = |number: f64| x.all(number);
    let rounded = x.mul_add(k(FRAC_2_PI), k(ROUND));
    let minus_n = k(ROUND) - rounded;
    let first = minus_n.mul_add(k(PI_2_FIRST), x);
    let r = minus_n.mul_add(k(PI_2_SECOND), first);
    let rest = minus_n.mul_add(k(PI_2_THIRD), minus_n.mul_add(k(PI_2_SECOND), first - r));
    let z = r * r;
    let zz = z * z;
    let sin_low = z.mul_add(k(SIN[1]), k(SIN[0]));
    let sin_high = zz.mul_add(z.mul_add(k(SIN[5]), k(SIN[4])), z.mul_add(k(SIN[3]), k(SIN[2])));
    let cos_low = z.mul_add(k(COS[1]), k(COS[0]));
    let cos_high = zz.mul_add(z.mul_add(k(COS[5]), k(COS[4])), z.mul_add(k(COS[3]), k(COS[2])));
    let sine = r + (z * r).mul_add(zz.mul_add(sin_high, sin_low), rest);
    let cosine = k(1.0) - k(0.5).mul_add(z, r.mul_add(rest, -(zz * zz.mul_add(cos_high, cos_low))));
    let (s, c) = x.register.turn(rounded.numbers, sine.numbers, cosine.numbers);
    (Packed { numbers: s, ..x }, Packed { numbers: c, ..x })
}
