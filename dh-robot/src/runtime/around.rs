//! Robots with poses that the program sets: the arm that formulas solve, and what stands around it at run time.

#![allow(clippy::neg_cmp_op_on_partial_ord)] // `!(x <= y)` is how NaN ends on the safe side

use nalgebra::{IsometryMatrix3, Point3, Rotation3, SMatrix, Unit, UnitVector3, Vector3};

use crate::math::{atan2, sin_cos, sqrt};
use crate::{Real, Why, pose};

/// The motion along axis 0, 1 or 2 by a length.
#[inline]
#[must_use]
pub fn translation<T: Real>(axis: usize, length: f64) -> IsometryMatrix3<T> {
    let mut by = Vector3::zeros();
    if let Some(x) = by.get_mut(axis) {
        *x = T::of(length);
    }
    IsometryMatrix3::from_parts(by.into(), Rotation3::identity())
}

/// The rotation about axis 0, 1 or 2 by an angle.
#[inline]
#[must_use]
pub fn rotation<T: Real>(axis: usize, angle: f64) -> IsometryMatrix3<T> {
    let (s, c) = sin_cos(angle);
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut rows = [[T::zero(); 3]; 3];
    rows[axis % 3][axis % 3] = T::one();
    (rows[i][i], rows[i][j], rows[j][i], rows[j][j]) = (T::of(c), T::of(-s), T::of(s), T::of(c));
    pose::from_entries(rows, [T::zero(); 3])
}

/// The value of a field as an exact rigid motion: one that lost digits is made orthonormal, as targets are.
///
/// # Errors
/// The field is not finite, or no rotation.
#[inline]
pub fn rigid<T: Real>(value: &IsometryMatrix3<T>, of: &'static str) -> Result<IsometryMatrix3<T>, Why<T>> {
    match pose::check(value) {
        Ok(()) => Ok(pose::orthonormalized(value)),
        Err(Why::NotFinite) => Err(Why::UnfitPose { of, what: "holds a number that is not finite" }),
        Err(_) => Err(Why::UnfitPose { of, what: "is no rigid motion: its matrix is not a rotation" }),
    }
}

/// What stands before and after the arm of the formulas.
#[derive(Clone, Copy, Debug)]
pub struct Around<T> {
    /// From the base to the arm.
    pub before: Option<IsometryMatrix3<T>>,
    /// From the arm to the tool.
    pub after: Option<IsometryMatrix3<T>>,
}

impl<T: Real> Around<T> {
    /// The tool's pose.
    #[inline]
    #[must_use]
    pub fn forward(&self, arm: &IsometryMatrix3<T>) -> IsometryMatrix3<T> {
        let tool = self.after.map_or(*arm, |after| arm * after);
        self.before.map_or(tool, |before| before * tool)
    }

    /// A link frame of the arm.
    #[inline]
    #[must_use]
    pub fn frame(&self, frame: &IsometryMatrix3<T>) -> IsometryMatrix3<T> {
        self.before.map_or(*frame, |before| before * frame)
    }

    /// The tool's pose, and the Jacobian at its origin.
    #[inline]
    #[must_use]
    pub fn velocity<const N: usize>(
        &self,
        (arm, jacobian): (IsometryMatrix3<T>, SMatrix<T, 6, N>),
    ) -> (IsometryMatrix3<T>, SMatrix<T, 6, N>) {
        let mut out = jacobian;
        if let Some(after) = &self.after {
            let way = arm.rotation * after.translation.vector;
            for mut column in out.column_iter_mut() {
                let w = Vector3::new(column[3], column[4], column[5]);
                let more = w.cross(&way);
                for k in 0..3 {
                    column[k] += more[k];
                }
            }
        }
        if let Some(before) = &self.before {
            for mut column in out.column_iter_mut() {
                let v = before.rotation * Vector3::new(column[0], column[1], column[2]);
                let w = before.rotation * Vector3::new(column[3], column[4], column[5]);
                for k in 0..3 {
                    (column[k], column[3 + k]) = (v[k], w[k]);
                }
            }
        }
        (self.forward(&arm), out)
    }

    /// The origin of the tool, seen from the end of the arm.
    #[inline]
    #[must_use]
    pub fn point(&self) -> [T; 3] {
        self.after.map_or([T::zero(); 3], |after| after.translation.vector.into())
    }

    /// The same around an arm that ends at the tool's point.
    #[inline]
    #[must_use]
    pub fn at_point(&self) -> Self {
        let turned = |after: IsometryMatrix3<T>| IsometryMatrix3::from_parts(Vector3::zeros().into(), after.rotation);
        Self { after: self.after.map(turned), ..*self }
    }

    /// A pose of the tool as a target of the arm.
    ///
    /// # Errors
    /// None; the arm itself looks at what is no rotation.
    #[inline]
    pub fn pose(&self, target: &IsometryMatrix3<T>) -> Result<IsometryMatrix3<T>, Why<T>> {
        // A target that lost digits would lose more of them in the products.
        let mut target = *target;
        if !(pose::rotation_deviation(target.rotation.matrix()) <= T::of(8.0) * T::EPSILON) {
            pose::check(&target)?;
            target = pose::orthonormalized(&target);
        }
        let seen = self.before.map_or(target, |before| before.inverse() * target);
        Ok(self.after.map_or(seen, |after| seen * after.inverse()))
    }

    /// A point, as a target of an arm that ends at the tool's point.
    ///
    /// # Errors
    /// None.
    #[inline]
    pub fn position(&self, target: &Point3<T>) -> Result<Point3<T>, Why<T>> {
        Ok(self.before.map_or(*target, |before| before.inverse() * target))
    }

    /// A point and a direction as a target of the arm.
    ///
    /// # Errors
    /// The tool's axis is not the arm's.
    pub fn axis(&self, target: (Point3<T>, UnitVector3<T>)) -> Result<(Point3<T>, UnitVector3<T>), Why<T>> {
        let (mut point, mut axis) = target;
        if let Some(before) = &self.before {
            let back = before.inverse();
            (point, axis) = (back * point, Unit::new_unchecked(back * axis.into_inner()));
        }
        if let Some(after) = &self.after {
            let (r, p) = (after.rotation.matrix(), after.translation.vector);
            let off = r[(0, 2)].abs().max(r[(1, 2)].abs()).max(p.x.abs()).max(p.y.abs());
            if !(off <= T::RANGE_TOLERANCE && r[(2, 2)] > T::zero()) {
                let what = "moves the tool off the arm's last z axis, which `task = axis` does not allow";
                return Err(Why::UnfitPose { of: "tool", what });
            }
            point -= axis.into_inner() * p.z;
        }
        Ok((point, axis))
    }

    /// A place in the plane as a target of the arm, whose pose with all joints at zero is `zero`.
    ///
    /// # Errors
    /// The poses tilt the plane, or turn the tool's x axis out of it.
    pub fn planar(&self, target: (T, T, T), zero: &IsometryMatrix3<T>) -> Result<(T, T, T), Why<T>> {
        let (mut x, mut y, mut phi) = target;
        if let Some(before) = &self.before {
            let (r, p) = (before.rotation.matrix(), before.translation.vector);
            if !(r[(2, 0)].abs().max(r[(2, 1)].abs()) <= T::RANGE_TOLERANCE && r[(2, 2)] > T::zero()) {
                return Err(Why::UnfitPose { of: "base", what: "tilts the plane of the arm" });
            }
            let (dx, dy) = (x - p.x, y - p.y);
            (x, y) = (r[(0, 0)] * dx + r[(1, 0)] * dy, r[(0, 1)] * dx + r[(1, 1)] * dy);
            phi -= atan2(r[(1, 0)], r[(0, 0)]);
        }
        if let Some(after) = &self.after {
            let (arm, tool) = (zero.rotation.matrix(), zero.rotation * after.rotation);
            let tool = tool.matrix();
            if !(sqrt(tool[(0, 0)] * tool[(0, 0)] + tool[(1, 0)] * tool[(1, 0)]) > T::RANGE_TOLERANCE) {
                return Err(Why::UnfitPose { of: "tool", what: "turns the tool's x axis out of the plane" });
            }
            let own = atan2(arm[(1, 0)], arm[(0, 0)]);
            phi -= atan2(tool[(1, 0)], tool[(0, 0)]) - own;
            let way = zero.rotation * after.translation.vector;
            let (s, c) = sin_cos(phi - own);
            x -= c * way.x - s * way.y;
            y -= s * way.x + c * way.y;
        }
        Ok((x, y, phi))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn motions_are_those_of_nalgebra() {
        for axis in 0..3 {
            let mut by = Vector3::zeros();
            by[axis] = 0.3;
            let (turned, moved) = (IsometryMatrix3::rotation(by), IsometryMatrix3::translation(by.x, by.y, by.z));
            assert!((rotation::<f64>(axis, 0.3).to_homogeneous() - turned.to_homogeneous()).norm() < 1e-15);
            assert_eq!(translation::<f64>(axis, 0.3), moved);
        }
    }

    #[test]
    fn what_is_no_rigid_motion_is_named() {
        let mut value = IsometryMatrix3::<f64>::identity();
        assert_eq!(rigid(&value, "gripper"), Ok(value));
        value.translation.x = f64::INFINITY;
        assert!(rigid(&value, "gripper").is_err_and(|why| why.to_string().contains("`gripper` holds a number")));
        let mirror = pose::from_entries([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]], [0.0; 3]);
        assert!(rigid(&mirror, "gripper").is_err_and(|why| why.to_string().contains("no rigid motion")));
    }
}
