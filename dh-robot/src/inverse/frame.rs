//! Targets as the plan wants them: a frame in `f64` with lengths over the reach.

use crate::ik::{Pose, pose};
use crate::{Real, Why};

/// A target pose in `f64` with lengths over the reach; orthonormal, if it was rounded.
///
/// # Errors
/// Numbers that are not finite, a matrix that is no rotation.
pub fn frame_of<T: Real>(target: &nalgebra::IsometryMatrix3<T>, reach: f64) -> Result<Pose, Why<T>> {
    let r = target.rotation.matrix();
    let deviation = crate::pose::rotation_deviation(r);
    // What is not a number fails the comparison too; `check` says what is wrong.
    let position = target.translation.vector.iter().all(|x| x.is_finite());
    if !(position && deviation <= T::ROTATION_TOLERANCE) {
        crate::pose::check(target)?;
    }
    let mut wide = crate::pose::from_entries(
        core::array::from_fn(|i| core::array::from_fn(|j| r[(i, j)].to_f64())),
        core::array::from_fn(|i| target.translation.vector[i].to_f64()),
    );
    // The entries of a narrower scalar are rounded, even where its own arithmetic sees nothing of that.
    if T::EPSILON > T::of(1e-10) || deviation > T::of(1e-14) {
        wide = crate::pose::orthonormalized(&wide);
    }
    let r = wide.rotation.matrix();
    Ok(core::array::from_fn(|i| {
        core::array::from_fn(|j| if j < 3 { r[(i, j)] } else { wide.translation.vector[i] / reach })
    }))
}

/// The same pose with lengths in table units: what the task compares with.
#[must_use]
pub fn in_units(frame: &Pose, reach: f64) -> Pose {
    core::array::from_fn(|i| core::array::from_fn(|j| if j < 3 { frame[i][j] } else { frame[i][3] * reach }))
}

/// A pose of generated forward kinematics as the kernels want it.
#[must_use]
#[inline]
pub fn to_pose(t: &nalgebra::IsometryMatrix3<f64>) -> Pose {
    let (r, p) = (t.rotation.matrix(), &t.translation.vector);
    core::array::from_fn(|i| core::array::from_fn(|j| if j < 3 { r[(i, j)] } else { p[i] }))
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
