//! Arms of different kinds in one list: a trait over slices, without a number of joints or of solutions in its type.

use core::fmt;

use nalgebra::IsometryMatrix3;

use crate::runtime::{HasJoints, OverSlices};
use crate::{Branch, FreeJoints, Joint, Real, Why};

/// Any arm that has an inverse, whatever its number of joints, its task and its number of solutions.
///
/// Joint values are slices as long as [`joints`](Arm::joints). The macro makes every arm with an inverse an `Arm`, so that
/// `Vec<Box<dyn Arm>>` or `[&dyn Arm; 3]` holds whatever stands in a cell. The trait itself needs no heap.
///
/// ```
/// use dh_robot::{Arm, Real, WrongLength};
///
/// /// How many solutions within the ranges each arm has for the pose at some joint values (all joints at the same one).
/// fn choices(arms: &[&dyn Arm], value: f64) -> Result<usize, WrongLength> {
///     let mut count = 0;
///     for arm in arms {
///         let q = [value; 16];
///         let target = arm.forward(&q[..arm.dof()])?;
///         arm.inverse(&target, &[], &mut |solution| {
///             let inside = arm.joints().iter().zip(solution.q).all(|(joint, q)| joint.contains(*q));
///             count += usize::from(inside);
///         });
///     }
///     Ok(count)
/// }
/// ```
pub trait Arm<T: Real = f64> {
    /// Name, kind and range of every joint variable, in the order of the joint values.
    fn joints(&self) -> &'static [Joint<T>];

    /// How many joint variables there are.
    fn dof(&self) -> usize {
        self.joints().len()
    }

    /// The most solutions that a target can have.
    fn max_solutions(&self) -> usize;

    /// The pose of the last frame, or of the tool if the table has one, in the base.
    ///
    /// # Errors
    ///
    /// [`WrongLength`] if `q` does not hold one value per joint.
    fn forward(&self, q: &[T]) -> Result<IsometryMatrix3<T>, WrongLength>;

    /// The pose of every joint's link frame in the base, into one place per joint.
    ///
    /// # Errors
    ///
    /// [`WrongLength`] if `q` or `frames` is not as long as there are joints.
    fn frames(&self, q: &[T], frames: &mut [IsometryMatrix3<T>]) -> Result<(), WrongLength>;

    /// The pose, and the geometric Jacobian into one column per joint: three linear, then three angular velocities per joint speed, in
    /// base axes, at the origin of the last frame (or tool).
    ///
    /// # Errors
    ///
    /// [`WrongLength`] if `q` or `columns` is not as long as there are joints.
    fn forward_and_jacobian(&self, q: &[T], columns: &mut [[T; 6]]) -> Result<IsometryMatrix3<T>, WrongLength>;

    /// The geometric Jacobian alone; see [`forward_and_jacobian`](Arm::forward_and_jacobian).
    ///
    /// # Errors
    ///
    /// As there.
    fn jacobian(&self, q: &[T], columns: &mut [[T; 6]]) -> Result<(), WrongLength> {
        self.forward_and_jacobian(q, columns).map(|_| ())
    }

    /// Hands every solution for a target to `found`, each once; returns [`Why::Solved`], or why there is none.
    ///
    /// Of the target an arm takes what its task asks for: all of it, its position, its position and z axis, or x, y and the angle about z.
    /// `redundant` are the values of the joints that the caller chooses, in the order of the table's setting (zero where there is no value);
    /// they mean nothing to other arms.
    fn inverse(
        &self,
        target: &IsometryMatrix3<T>,
        redundant: &[T],
        found: &mut dyn FnMut(SolutionView<'_, T>),
    ) -> Why<T>;

    /// Moves `q` to the nearest solution within the ranges of the joints, as
    /// [`toward`](crate::Solutions::toward) does; where there is none `q` stays and the reason is returned.
    ///
    /// # Errors
    ///
    /// [`WrongLength`] if `q` does not hold one value per joint.
    fn toward(&self, target: &IsometryMatrix3<T>, redundant: &[T], q: &mut [T]) -> Result<Why<T>, WrongLength>;
}

/// A [`Solution`](crate::Solution) whose joint values are a slice.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolutionView<'a, T> {
    /// The joint values: radians, or the table's unit of length for sliding joints.
    pub q: &'a [T],
    /// Which alternatives were taken: shoulder, elbow, wrist.
    pub branch: Branch,
    /// The joints that are free at this pose, which is singular then.
    pub free: FreeJoints,
}

/// A slice does not hold one entry per joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WrongLength {
    /// The number of joints.
    pub joints: usize,
    /// The length of the slice.
    pub given: usize,
}

impl fmt::Display for WrongLength {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the arm has {} joints, the slice {} entries", self.joints, self.given)
    }
}

impl core::error::Error for WrongLength {}

impl<T: Real, R: HasJoints<T>> Arm<T> for R {
    fn joints(&self) -> &'static [Joint<T>] {
        R::Joints::joints(self)
    }

    fn max_solutions(&self) -> usize {
        R::Joints::max_solutions(self)
    }

    fn forward(&self, q: &[T]) -> Result<IsometryMatrix3<T>, WrongLength> {
        R::Joints::forward(self, q)
    }

    fn frames(&self, q: &[T], frames: &mut [IsometryMatrix3<T>]) -> Result<(), WrongLength> {
        R::Joints::frames(self, q, frames)
    }

    fn forward_and_jacobian(&self, q: &[T], columns: &mut [[T; 6]]) -> Result<IsometryMatrix3<T>, WrongLength> {
        R::Joints::forward_and_jacobian(self, q, columns)
    }

    fn inverse(
        &self,
        target: &IsometryMatrix3<T>,
        redundant: &[T],
        found: &mut dyn FnMut(SolutionView<'_, T>),
    ) -> Why<T> {
        R::Joints::inverse(self, target, redundant, found)
    }

    fn toward(&self, target: &IsometryMatrix3<T>, redundant: &[T], q: &mut [T]) -> Result<Why<T>, WrongLength> {
        R::Joints::toward(self, target, redundant, q)
    }
}
