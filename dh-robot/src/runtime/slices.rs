//! Makes a robot with a fixed number of joints an [`Arm`](crate::Arm), whose joint values are slices.
//!
//! Generated code says the number of joints by a type, [`HasJoints`], since no implementation can be generic over a number that only its
//! bounds name. Everything else follows from the traits that the robot has anyway.

use nalgebra::{IsometryMatrix3, Point3, UnitVector3};

use crate::math::atan2;
use crate::{
    ForwardKinematics, InverseKinematics, Jacobian, Joint, Real, SolutionList, SolutionView, Why, WrongLength,
};

/// A robot that says how many joints it has, by a type.
pub trait HasJoints<T: Real>: Sized {
    /// [`Joints<N>`](Joints).
    type Joints: OverSlices<Self, T>;
}

/// A number of joints, as a type.
pub struct Joints<const N: usize>;

/// What an [`Arm`](crate::Arm) does, for a robot `R`; the functions are described there.
#[allow(missing_docs)]
pub trait OverSlices<R, T: Real> {
    fn joints(robot: &R) -> &'static [Joint<T>];
    fn max_solutions(robot: &R) -> usize;
    fn forward(robot: &R, q: &[T]) -> Result<IsometryMatrix3<T>, WrongLength>;
    fn frames(robot: &R, q: &[T], frames: &mut [IsometryMatrix3<T>]) -> Result<(), WrongLength>;
    fn forward_and_jacobian(robot: &R, q: &[T], columns: &mut [[T; 6]]) -> Result<IsometryMatrix3<T>, WrongLength>;
    fn inverse(
        robot: &R,
        target: &IsometryMatrix3<T>,
        redundant: &[T],
        found: &mut dyn FnMut(SolutionView<'_, T>),
    ) -> Why<T>;
    fn toward(robot: &R, target: &IsometryMatrix3<T>, redundant: &[T], q: &mut [T]) -> Result<Why<T>, WrongLength>;
}

/// The slice as an array of one entry per joint.
fn array<T, const N: usize>(slice: &[T]) -> Result<&[T; N], WrongLength> {
    slice.try_into().map_err(|_| WrongLength { joints: N, given: slice.len() })
}

/// The same for a slice to write to.
fn array_mut<T, const N: usize>(slice: &mut [T]) -> Result<&mut [T; N], WrongLength> {
    let given = slice.len();
    slice.try_into().map_err(|_| WrongLength { joints: N, given })
}

impl<R, T: Real, const N: usize> OverSlices<R, T> for Joints<N>
where
    R: ForwardKinematics<N, T> + Jacobian<N, T> + InverseKinematics<N, T, Target: PartOfPose<T>>,
{
    fn joints(robot: &R) -> &'static [Joint<T>] {
        robot.joints()
    }

    fn max_solutions(robot: &R) -> usize {
        robot.max_solutions()
    }

    fn forward(robot: &R, q: &[T]) -> Result<IsometryMatrix3<T>, WrongLength> {
        Ok(robot.forward(array(q)?))
    }

    fn frames(robot: &R, q: &[T], frames: &mut [IsometryMatrix3<T>]) -> Result<(), WrongLength> {
        *array_mut(frames)? = robot.frames(array(q)?);
        Ok(())
    }

    fn forward_and_jacobian(robot: &R, q: &[T], columns: &mut [[T; 6]]) -> Result<IsometryMatrix3<T>, WrongLength> {
        let columns: &mut [[T; 6]; N] = array_mut(columns)?;
        let (pose, jacobian) = robot.forward_and_jacobian(array(q)?);
        *columns = jacobian.data.0;
        Ok(pose)
    }

    fn inverse(
        robot: &R,
        target: &IsometryMatrix3<T>,
        redundant: &[T],
        found: &mut dyn FnMut(SolutionView<'_, T>),
    ) -> Why<T> {
        let solutions = robot.inverse(&R::Target::of(target, redundant));
        for solution in solutions.iter() {
            found(SolutionView { q: &solution.q, branch: solution.branch, free: solution.free });
        }
        solutions.why()
    }

    fn toward(robot: &R, target: &IsometryMatrix3<T>, redundant: &[T], q: &mut [T]) -> Result<Why<T>, WrongLength> {
        let q: &mut [T; N] = array_mut(q)?;
        let solutions = robot.inverse(&R::Target::of(target, redundant)).within_range();
        if let Some(solution) = solutions.toward(q) {
            *q = solution.q;
        }
        Ok(solutions.why())
    }
}

/// What an inverse is given, as a part of a pose.
pub trait PartOfPose<T: Real> {
    /// The part of `pose`, and the values of the joints that the caller chooses where the arm has such joints.
    fn of(pose: &IsometryMatrix3<T>, redundant: &[T]) -> Self;
}

impl<T: Real> PartOfPose<T> for IsometryMatrix3<T> {
    fn of(pose: &Self, _: &[T]) -> Self {
        *pose
    }
}

impl<T: Real> PartOfPose<T> for Point3<T> {
    fn of(pose: &IsometryMatrix3<T>, _: &[T]) -> Self {
        pose.translation.vector.into()
    }
}

impl<T: Real> PartOfPose<T> for (T, T, T) {
    fn of(pose: &IsometryMatrix3<T>, _: &[T]) -> Self {
        let (p, r) = (&pose.translation.vector, pose.rotation.matrix());
        (p.x, p.y, atan2(r[(1, 0)], r[(0, 0)]))
    }
}

impl<T: Real> PartOfPose<T> for (Point3<T>, UnitVector3<T>) {
    fn of(pose: &IsometryMatrix3<T>, _: &[T]) -> Self {
        let z = pose.rotation.matrix().column(2).into_owned();
        (pose.translation.vector.into(), UnitVector3::new_unchecked(z))
    }
}

impl<T: Real, K: PartOfPose<T>> PartOfPose<T> for (K, T) {
    fn of(pose: &IsometryMatrix3<T>, redundant: &[T]) -> Self {
        (K::of(pose, redundant), redundant.first().copied().unwrap_or(T::zero()))
    }
}

impl<T: Real, K: PartOfPose<T>, const G: usize> PartOfPose<T> for (K, [T; G]) {
    fn of(pose: &IsometryMatrix3<T>, redundant: &[T]) -> Self {
        (K::of(pose, redundant), core::array::from_fn(|i| redundant.get(i).copied().unwrap_or(T::zero())))
    }
}
