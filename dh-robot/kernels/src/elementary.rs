//! The elementary functions behind the kernels: the standard library's, or libm's where there is none.
//!
//! `f64::abs`, `copysign`, `min`, `max` and `clamp` are part of `core` and used directly.

#[cfg(feature = "std")]
mod backend {
    #[inline(always)]
    pub(in super::super) fn sqrt(x: f64) -> f64 {
        x.sqrt()
    }
    #[inline(always)]
    pub(in super::super) fn sin_cos(x: f64) -> (f64, f64) {
        x.sin_cos()
    }
    #[inline(always)]
    pub(in super::super) fn floor(x: f64) -> f64 {
        x.floor()
    }
    #[inline(always)]
    pub(in super::super) fn atan2(y: f64, x: f64) -> f64 {
        y.atan2(x)
    }
}

#[cfg(all(not(feature = "std"), feature = "libm"))]
mod backend {
    pub(in super::super) fn sqrt(x: f64) -> f64 {
        libm::sqrt(x)
    }
    pub(in super::super) fn sin_cos(x: f64) -> (f64, f64) {
        libm::sincos(x)
    }
    pub(in super::super) fn floor(x: f64) -> f64 {
        libm::floor(x)
    }
    pub(in super::super) fn atan2(y: f64, x: f64) -> f64 {
        libm::atan2(y, x)
    }
}

/// Without elementary functions there is one error, and it says what to do.
#[cfg(not(any(feature = "std", feature = "libm")))]
mod backend {
    compile_error!(
        "dh-robot needs elementary functions: turn on its feature `std` (on by default), \
         or for `no_std` its feature `libm`: dh-robot = { version = \"0.1\", default-features = false, features = [\"libm\"] }"
    );
    pub(in super::super) fn sqrt(_: f64) -> f64 {
        f64::NAN
    }
    pub(in super::super) fn sin_cos(_: f64) -> (f64, f64) {
        (f64::NAN, f64::NAN)
    }
    pub(in super::super) fn floor(_: f64) -> f64 {
        f64::NAN
    }
    pub(in super::super) fn atan2(_: f64, _: f64) -> f64 {
        f64::NAN
    }
}

pub(super) use backend::{atan2, floor, sin_cos, sqrt};

/// The angle in (-pi, pi] that differs by whole turns.
pub(super) fn wrapped(angle: f64) -> f64 {
    use core::f64::consts::{PI, TAU};
    if angle > -PI && angle <= PI {
        return angle;
    }
    let rest = angle - TAU * floor(0.5 + angle / TAU);
    if rest <= -PI { rest + TAU } else { rest }
}
