//! Elementary functions of both scalars, from the standard library or from libm, and the wrapping of angles.
//!
//! With the feature `std` these are the functions of the standard library, else (feature `libm`) those of the libm
//! crate. Generated code and kernels call them by these names, so that they need not know which.

use crate::Real;

/// Square root; NaN below zero.
#[inline(always)]
pub fn sqrt<T: Real>(x: T) -> T {
    x.root()
}

/// Cube root, of the argument's sign.
#[inline(always)]
pub fn cbrt<T: Real>(x: T) -> T {
    x.cube_root()
}

/// `sqrt(x^2 + y^2)`, without guarding against overflow: for lengths between 1e-150 and 1e150 (`f32`: 1e-18 and 1e18).
#[inline(always)]
pub fn hypot<T: Real>(x: T, y: T) -> T {
    sqrt(x * x + y * y)
}

/// Sine and cosine of one angle in radians.
#[inline(always)]
pub fn sin_cos<T: Real>(angle: T) -> (T, T) {
    angle.sine_cosine()
}

/// The angle of the vector `(x, y)`, in `(-pi, pi]`; zero for the zero vector.
///
/// Unlike the standard library's function it never answers -pi: an angle has one name. (A negative zero `y` counts as zero.)
#[inline(always)]
pub fn atan2<T: Real>(y: T, x: T) -> T {
    let angle = y.angle_above(x);
    if x == T::zero() && y == T::zero() {
        T::zero()
    } else if angle <= -T::PI {
        T::PI
    } else {
        angle
    }
}

/// Inverse cosine; NaN outside `[-1, 1]`.
#[inline(always)]
pub fn acos<T: Real>(x: T) -> T {
    x.arc_cosine()
}

/// The largest whole number that is not above `x`.
#[inline(always)]
pub fn floor<T: Real>(x: T) -> T {
    x.rounded_down()
}

/// The smallest whole number that is not below `x`.
#[inline(always)]
pub fn ceil<T: Real>(x: T) -> T {
    x.rounded_up()
}

/// The whole number nearest to `x`; halves go away from zero.
#[inline(always)]
pub fn round<T: Real>(x: T) -> T {
    x.rounded()
}

/// `a * b + c`, rounded once where the target has an instruction for that and twice where it has not.
#[inline(always)]
pub(crate) fn mul_add(a: f64, b: f64, c: f64) -> f64 {
    #[cfg(all(feature = "std", target_feature = "fma"))]
    return a.mul_add(b, c);
    #[cfg(not(all(feature = "std", target_feature = "fma")))]
    return a * b + c;
}

/// The remainder of `x / modulus` in `[0, modulus)`, for a positive modulus.
#[inline]
pub fn rem<T: Real>(x: T, modulus: T) -> T {
    let rest = x - modulus * floor(x / modulus);
    // Rounding can put the rest on either end: a tiny negative x gives the modulus itself.
    if rest >= modulus || rest < T::zero() { T::zero() } else { rest }
}

/// The angle in `(-pi, pi]` that differs from `angle` by whole turns.
///
/// Angles already there come back unchanged, bit for bit, and others are reduced exactly by the scalar's own `TAU`. NaN and
/// infinity give NaN.
///
/// ```
/// use core::f64::consts::{PI, TAU};
/// use dh_robot::math::wrap_angle;
///
/// assert_eq!(wrap_angle(-PI), PI);
/// assert!((wrap_angle(1.0 - 3.0 * TAU) - 1.0).abs() < 1e-14);
/// ```
#[inline]
pub fn wrap_angle<T: Real>(angle: T) -> T {
    if angle > -T::PI && angle <= T::PI {
        return angle;
    }
    // Sums of a few angles need one turn: exact, since the operands are within a factor of two of each other.
    let once = if angle > T::zero() { angle - T::TAU } else { angle + T::TAU };
    if once > -T::PI && once <= T::PI {
        return once;
    }
    let rest = angle % T::TAU;
    if rest > T::PI {
        rest - T::TAU
    } else if rest <= -T::PI {
        rest + T::TAU
    } else {
        rest
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{PI, TAU};

    use super::*;

    #[test]
    fn wrapped_angles_stay_in_the_half_open_turn() {
        for k in -2000..=2000_i32 {
            let angle = f64::from(k) * 0.03125 * PI;
            let wrapped = wrap_angle(angle);
            assert!(wrapped > -PI && wrapped <= PI, "{angle} gave {wrapped}");
            assert!(((angle - wrapped) / TAU - ((angle - wrapped) / TAU).round()).abs() < 1e-12);
        }
    }

    #[test]
    fn neighbours_of_half_a_turn_wrap() {
        assert_eq!(wrap_angle(PI), PI);
        assert_eq!(wrap_angle(-PI), PI);
        assert!(wrap_angle(PI.next_up()) < 0.0);
        assert_eq!(wrap_angle((-PI).next_up()), (-PI).next_up());
        assert!(wrap_angle((-PI).next_down()) > 0.0);
        assert_eq!(wrap_angle(-core::f32::consts::PI), core::f32::consts::PI);
    }

    #[test]
    fn not_finite_angles_become_nan() {
        assert!(wrap_angle(f64::NAN).is_nan());
        assert!(wrap_angle(f64::INFINITY).is_nan());
        assert!(wrap_angle(1e300_f64).abs() <= PI);
    }

    #[test]
    fn atan2_never_answers_minus_pi() {
        assert_eq!(atan2(-0.0, -1.0), PI);
        assert_eq!(atan2(-1e-300, -1.0), PI);
        assert_eq!(atan2(0.0, 0.0), 0.0);
        assert_eq!(atan2(-0.0, -0.0), 0.0);
        assert_eq!(atan2(-1.0, 0.0), -PI / 2.0);
        assert_eq!(atan2(-0.0_f32, -1.0), core::f32::consts::PI);
    }

    #[test]
    fn remainders_are_never_negative() {
        assert_eq!(rem(-1.0, 3.0), 2.0);
        assert_eq!(rem(7.5, 3.0), 1.5);
        assert_eq!(rem(-1e-20, 3.0), 0.0);
    }

    #[test]
    fn lengths_and_roots() {
        assert_eq!(hypot(3.0, -4.0), 5.0);
        assert_eq!(cbrt(-27.0), -3.0);
        assert_eq!(floor(-1.5_f32), -2.0);
        assert_eq!(ceil(-1.5), -1.0);
        assert_eq!(acos(-1.0), PI);
        assert_eq!(sin_cos(0.0), (0.0, 1.0));
    }
}
