//! Forward kinematics and Jacobians of several poses at once, one pose in each lane of a vector register.
//!
//! Generated code describes a robot once more with [`Packed`] numbers ([`PackedKinematics`]); the batch functions run that description with
//! the widest registers that the processor at hand has. Without the feature `simd` they go through the poses one by one.
//!
//! What needs a decision (an angle beyond [`LIMIT`](crate::sincos::LIMIT), or one that is not finite) is left to the single call, so that a
//! batch answers what single calls answer. Last bits can differ: where a processor multiplies and adds with one rounding, sines and cosines
//! are computed so.

mod number;
#[cfg(feature = "simd")]
mod registers;
mod sines;

pub use number::{IntoPacked, Packed, Register};
pub use sines::Sines;

use nalgebra::{IsometryMatrix3, SMatrix};

use crate::{ForwardKinematics, Jacobian};

/// A robot's formulas for packed numbers, as generated code states them.
pub trait PackedKinematics<const N: usize>: ForwardKinematics<N> + Jacobian<N> {
    /// The entries of the pose: the rotation row by row, then the position.
    fn pose<R: Register>(&self, q: &[Packed<R>; N], sines: &mut Sines<R>) -> [Packed<R>; 12];

    /// The columns of the Jacobian.
    fn columns<R: Register>(&self, q: &[Packed<R>; N], sines: &mut Sines<R>) -> [[Packed<R>; 6]; N];
}

/// Poses of many joint vectors, as many as the shorter slice holds.
#[inline]
pub fn forward_batch<A: PackedKinematics<N>, const N: usize>(
    arm: &A,
    q: &[[f64; N]],
    poses: &mut [IsometryMatrix3<f64>],
) {
    #[cfg(feature = "simd")]
    let done = registers::forward(arm, q, poses);
    #[cfg(not(feature = "simd"))]
    let done = 0;
    for (q, to) in q.iter().zip(poses).skip(done) {
        *to = arm.forward(q);
    }
}

/// Jacobians of many joint vectors, as many as the shorter slice holds.
#[inline]
pub fn jacobian_batch<A: PackedKinematics<N>, const N: usize>(
    arm: &A,
    q: &[[f64; N]],
    jacobians: &mut [SMatrix<f64, 6, N>],
) {
    #[cfg(feature = "simd")]
    let done = registers::jacobians(arm, q, jacobians);
    #[cfg(not(feature = "simd"))]
    let done = 0;
    for (q, to) in q.iter().zip(jacobians).skip(done) {
        *to = arm.jacobian(q);
    }
}
