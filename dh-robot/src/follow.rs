//! Joint values along a path of targets, until the arm cannot follow.

use core::fmt;

use crate::{InverseKinematics, Joint, Real, Why};

/// Why an arm cannot follow its path.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Stop<T = f64> {
    /// The target has no solution, for this reason.
    Unreachable(Why<T>),
    /// The solution that continues leaves the range of a joint (counted from 0).
    OutOfRange {
        /// The joint.
        joint: usize,
        /// The value that it would have.
        value: T,
    },
    /// The nearest solution is farther than the largest step: the branch ends in a fold here (an elbow stretched out, say), the path comes too
    /// near to a singular pose, or its targets are too far apart.
    Jump {
        /// The joint that would move farthest, counted from 0.
        joint: usize,
        /// How far.
        by: T,
    },
}

impl<T: Real> fmt::Display for Stop<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unreachable(why) => why.fmt(f),
            Self::OutOfRange { joint, value } => write!(f, "joint {} leaves its range at {value:.4}", joint + 1),
            Self::Jump { joint, by } => write!(f, "joint {} would jump by {by:.4}", joint + 1),
        }
    }
}

impl<T: Real> core::error::Error for Stop<T> {}

/// An iterator over joint values along targets; made by [`follow`].
#[derive(Clone, Debug)]
pub struct Follow<'a, R, I, T, const N: usize> {
    robot: &'a R,
    targets: I,
    q: [T; N],
    step: T,
    stopped: bool,
}

/// Follows `targets` from the joint values `start`, each by [`InverseKinematics::inverse_near`] from the one before. No joint moves by more than
/// `step` (radians, or the table's unit of length) from one target to the next.
///
/// Every item is the joint values for a target, or why the path cannot be followed there; after that the iterator ends. Ask
/// `enumerate` for the place.
pub fn follow<'a, R, I, T, const N: usize>(
    robot: &'a R,
    targets: I,
    start: [T; N],
    step: T,
) -> Follow<'a, R, I::IntoIter, T, N>
where
    T: Real,
    R: InverseKinematics<N, T>,
    I: IntoIterator<Item = R::Target>,
{
    Follow { robot, targets: targets.into_iter(), q: start, step, stopped: false }
}

impl<R, I, T, const N: usize> Iterator for Follow<'_, R, I, T, N>
where
    T: Real,
    R: InverseKinematics<N, T>,
    I: Iterator<Item = R::Target>,
{
    type Item = Result<[T; N], Stop<T>>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.stopped {
            return None;
        }
        let target = self.targets.next()?;
        let next = self.robot.inverse_near(&target, &self.q).map_err(Stop::Unreachable);
        let next = next.and_then(|solution| self.check(&solution.q).map(|()| solution.q));
        match next {
            Ok(q) => self.q = q,
            Err(_) => self.stopped = true,
        }
        Some(next)
    }
}

impl<R: InverseKinematics<N, T>, I, T: Real, const N: usize> Follow<'_, R, I, T, N> {
    fn check(&self, q: &[T; N]) -> Result<(), Stop<T>> {
        let joints: &[Joint<T>; N] = self.robot.joints();
        let mut far = (0, T::zero());
        for (joint, (a, b)) in self.q.iter().zip(q).enumerate() {
            let by = (*b - *a).abs();
            if by > far.1 {
                far = (joint, by);
            }
        }
        // What continues but for a whole turn has come to the end of its range.
        let outside = |k: &usize| {
            !joints[*k].contains(q[*k]) || joints[*k].difference(self.q[*k], q[*k]) < (q[*k] - self.q[*k]).abs()
        };
        match (0..N).find(outside) {
            Some(joint) => Err(Stop::OutOfRange { joint, value: q[joint] }),
            None if far.1 > self.step => Err(Stop::Jump { joint: far.0, by: far.1 }),
            None => Ok(()),
        }
    }
}
