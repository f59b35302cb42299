//! Converts targets to the form the plan uses: a frame in `f64` with lengths over the length scale.

use crate::{Real, Why};
use dh_kernels::{Pose, pose};

/// A target pose in `f64` with lengths over the length scale; orthonormal, if it was rounded.
///
/// # Errors
/// Numbers that are not finite, a matrix that is no rotation.
#[inline(always)]
pub fn frame_of<T: Real>(target: &nalgebra::IsometryMatrix3<T>, length_scale: f64) -> Result<Pose, Why<T>> {
    // Nearly every target: written into the caller, so that it never goes through memory.
    let wide = T::EPSILON <= T::of(1e-10);
    if wide && is_exact(target) { Ok(over_reach(target, length_scale)) } else { rounded(target, length_scale) }
}

/// Whether it is a rotation within rounding, with a finite position.
#[inline(always)]
fn is_exact<T: Real>(target: &nalgebra::IsometryMatrix3<T>) -> bool {
    let r = target.rotation.matrix();
    let column = |j: usize| [r[(0, j)].to_f64(), r[(1, j)].to_f64(), r[(2, j)].to_f64()];
    let (x, y, z) = (column(0), column(1), column(2));
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let lengths = (dot(x, x) - 1.0).abs() + (dot(y, y) - 1.0).abs() + (dot(z, z) - 1.0).abs();
    let angles = dot(x, y).abs() + dot(y, z).abs() + dot(z, x).abs();
    let volume = dot(pose::cross(x, y), z);
    let p = &target.translation.vector;
    let size = p[0].to_f64().abs() + p[1].to_f64().abs() + p[2].to_f64().abs();
    // What is not a number fails the comparisons.
    (lengths + angles <= 1e-14) & (volume > 0.0) & (size <= f64::MAX)
}

/// The numbers as they are.
#[inline(always)]
fn over_reach<T: Real>(target: &nalgebra::IsometryMatrix3<T>, length_scale: f64) -> Pose {
    let (r, p) = (target.rotation.matrix(), &target.translation.vector);
    core::array::from_fn(|i| {
        core::array::from_fn(|j| if j < 3 { r[(i, j)].to_f64() } else { p[i].to_f64() / length_scale })
    })
}

/// A target that has to be looked at.
#[cold]
#[inline(never)]
fn rounded<T: Real>(target: &nalgebra::IsometryMatrix3<T>, length_scale: f64) -> Result<Pose, Why<T>> {
    let r = target.rotation.matrix();
    let deviation = crate::pose::rotation_deviation(r);
    crate::pose::check(target)?;
    let mut wide = crate::pose::from_entries(
        core::array::from_fn(|i| core::array::from_fn(|j| r[(i, j)].to_f64())),
        core::array::from_fn(|i| target.translation.vector[i].to_f64()),
    );
    // The entries of a narrower scalar are rounded, even where its own arithmetic sees nothing of that.
    if T::EPSILON > T::of(1e-10) || deviation > T::of(1e-14) {
        wide = crate::pose::orthonormalized(&wide);
    }
    Ok(over_reach(&wide, length_scale))
}

/// The same pose with lengths in table units: what the task compares with.
#[must_use]
pub fn in_units(frame: &Pose, length_scale: f64) -> Pose {
    core::array::from_fn(|i| core::array::from_fn(|j| if j < 3 { frame[i][j] } else { frame[i][3] * length_scale }))
}

/// A pose of generated forward kinematics as the kernels want it.
#[must_use]
#[inline]
pub fn to_pose(t: &nalgebra::IsometryMatrix3<f64>) -> Pose {
    let (r, p) = (t.rotation.matrix(), &t.translation.vector);
    core::array::from_fn(|i| core::array::from_fn(|j| if j < 3 { r[(i, j)] } else { p[i] }))
}

/// A target's direction as a unit vector, whose digits may be rounded as those of a rotation.
///
/// # Errors
/// Numbers that are not finite, a vector of another length.
pub fn direction<T: Real>(z: [f64; 3]) -> Result<[f64; 3], Why<T>> {
    let square = pose::dot(z, z);
    let deviation = T::of((square - 1.0).abs());
    if deviation <= T::ROTATION_TOLERANCE {
        let h = 1.0 / crate::math::sqrt(square);
        return Ok(z.map(|x| x * h));
    }
    // What is not a number fails the comparison.
    Err(if z.iter().all(|x| x.is_finite()) { Why::NotAUnitVector { deviation } } else { Why::NotFinite })
}

/// A frame at a point with a given z axis; x is any perpendicular direction.
#[must_use]
pub fn frame_of_axis(p: [f64; 3], z: [f64; 3]) -> Pose {
    // The coordinate axis that is farthest from z.
    let k = (0..3).fold(0, |b, i| if z[i].abs() < z[b].abs() { i } else { b });
    let mut e = [0.0; 3];
    e[k] = 1.0;
    let y = pose::cross(z, e);
    let h = 1.0 / crate::math::sqrt(pose::dot(y, y));
    let y = y.map(|v| v * h);
    let x = pose::cross(y, z);
    core::array::from_fn(|i| [x[i], y[i], z[i], p[i]])
}

/// The frame of a planar arm's tool at (x, y) with its x axis at the angle `phi`: the rotation at zero, `zero`, turned about z. The
/// height is left to the plan.
#[must_use]
pub fn frame_of_plane(p: [f64; 2], phi: f64, zero: [[f64; 3]; 3]) -> Pose {
    let (s, c) = crate::math::sin_cos(phi - crate::math::atan2(zero[1][0], zero[0][0]));
    core::array::from_fn(|i| {
        core::array::from_fn(|j| match (i, j) {
            (0, 0..3) => c * zero[0][j] - s * zero[1][j],
            (1, 0..3) => s * zero[0][j] + c * zero[1][j],
            (2, 0..3) => zero[2][j],
            (0 | 1, _) => p[i],
            _ => 0.0,
        })
    })
}
