//! The scalar types of the API: `f64` and `f32`.

use core::fmt::{Display, LowerExp};

use nalgebra::RealField;

use crate::elementary::Elementary;
use crate::{atan2, sincos};

mod sealed {
    /// Keeps [`Real`](super::Real) to the scalars that the kernels are written and measured for.
    pub trait Sealed: super::Elementary {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

/// A scalar of the API: `f64` or `f32`.
///
/// The trait is sealed: tolerances and numeric kernels are chosen and measured for these two types.
pub trait Real: RealField + Copy + Default + Display + LowerExp + sealed::Sealed {
    /// Half a turn.
    const PI: Self;
    /// A whole turn.
    const TAU: Self;
    /// The distance from 1 to the next number.
    const EPSILON: Self;
    /// How far a matrix may be from a rotation and still be taken for one: the largest entry of `R^T R - 1`.
    ///
    /// Poses that went through a text file with six decimals (which leave 2 sqrt(3) 5e-7 = 1.8e-6), or through a long product, pass;
    /// a matrix with a
    /// scale, a typing error or a wrong transposition does not.
    const ROTATION_TOLERANCE: Self;
    /// How far a joint value may be beyond its range by round-off: such a value is put on the limit.
    const RANGE_TOLERANCE: Self;

    /// The nearest scalar to a constant.
    fn of(value: f64) -> Self;

    /// The value as `f64`, exactly.
    fn to_f64(self) -> f64;

    /// Sine and cosine as the lanes of [`sincos_batch`](crate::sincos::sincos_batch) compute them.
    #[doc(hidden)]
    fn sincos_lane(angle: Self) -> (Self, Self);

    /// 1 where [`Real::sincos_lane`] is out of its depth, else 0.
    #[doc(hidden)]
    fn is_beyond(angle: Self) -> u64;

    /// The angle of a vector as the lanes of [`atan2_batch`](crate::atan2::atan2_batch) compute it.
    #[doc(hidden)]
    fn atan2_lane(y: Self, x: Self) -> Self;
}

impl Real for f64 {
    const PI: Self = core::f64::consts::PI;
    const TAU: Self = core::f64::consts::TAU;
    const EPSILON: Self = f64::EPSILON;
    const ROTATION_TOLERANCE: Self = 2e-6;
    const RANGE_TOLERANCE: Self = 1e-9;

    #[inline(always)]
    fn of(value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn to_f64(self) -> f64 {
        self
    }

    #[inline(always)]
    fn sincos_lane(angle: Self) -> (Self, Self) {
        sincos::lane(angle)
    }

    #[inline(always)]
    fn is_beyond(angle: Self) -> u64 {
        sincos::is_beyond(angle)
    }

    #[inline(always)]
    fn atan2_lane(y: Self, x: Self) -> Self {
        atan2::lane(y, x)
    }
}

impl Real for f32 {
    const PI: Self = core::f32::consts::PI;
    const TAU: Self = core::f32::consts::TAU;
    const EPSILON: Self = f32::EPSILON;
    const ROTATION_TOLERANCE: Self = 1e-4;
    const RANGE_TOLERANCE: Self = 1e-5;

    #[inline(always)]
    fn of(value: f64) -> Self {
        value as f32
    }

    #[inline(always)]
    fn to_f64(self) -> f64 {
        f64::from(self)
    }

    #[inline(always)]
    fn sincos_lane(angle: Self) -> (Self, Self) {
        sincos::lane_short(angle)
    }

    #[inline(always)]
    fn is_beyond(angle: Self) -> u64 {
        sincos::is_beyond(f64::from(angle))
    }

    #[inline(always)]
    fn atan2_lane(y: Self, x: Self) -> Self {
        atan2::lane_short(y, x)
    }
}
