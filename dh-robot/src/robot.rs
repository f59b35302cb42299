//! Traits for programs that are generic over robots.
//!
//! The macro implements them beside inherent functions of the same names, so that one robot needs no trait in scope. All of
//! them can be used as trait objects too: `&dyn ForwardKinematics<6>` is any six-axis arm. [`Arm`](crate::Arm) is any arm at all.

use core::fmt;
use core::ops::Deref;

use nalgebra::{IsometryMatrix3, SMatrix};

use crate::{Branch, Joint, Real, Solution, Solutions, Why};

/// A robot with `N` joint variables of scalar type `T`.
pub trait Robot<const N: usize, T: Real = f64> {
    /// Name, kind and range of every joint variable, in the order of `q`.
    fn joints(&self) -> &'static [Joint<T>; N];

    /// How many joint variables there are: `N`.
    fn dof(&self) -> usize {
        N
    }
}

/// From joint values to poses.
pub trait ForwardKinematics<const N: usize, T: Real = f64>: Robot<N, T> {
    /// The pose of the last frame, or of the tool if the table has one, in the base.
    fn forward(&self, q: &[T; N]) -> IsometryMatrix3<T>;

    /// The pose of every joint's link frame in the base.
    fn frames(&self, q: &[T; N]) -> [IsometryMatrix3<T>; N];
}

/// From joint speeds to the speed of the tool.
pub trait Jacobian<const N: usize, T: Real = f64>: Robot<N, T> {
    /// The geometric Jacobian: rows 0..3 linear, 3..6 angular velocity per joint speed, in base axes, at the origin of the
    /// last frame (or tool).
    fn jacobian(&self, q: &[T; N]) -> SMatrix<T, 6, N>;

    /// The pose of the last frame (or tool) in the base, and the Jacobian, for little more than one of them.
    fn forward_and_jacobian(&self, q: &[T; N]) -> (IsometryMatrix3<T>, SMatrix<T, 6, N>);
}

/// From a target to joint values: all of them.
pub trait InverseKinematics<const N: usize, T: Real = f64>: Robot<N, T> {
    /// What is to be reached: `IsometryMatrix3<T>` for `task = pose`, `Point3<T>` for `position`, `(T, T, T)` for `planar`,
    /// `(Point3<T>, UnitVector3<T>)` for `axis`; with `redundant` the pair of that and the value
    /// of the chosen joint (an array, where there are several).
    type Target;

    /// The list that is returned: [`Solutions<T, N, M>`](Solutions), where `M` is the most solutions that the arm can have.
    type Solutions: SolutionList<N, T>;

    /// Every solution, each once.
    fn inverse(&self, target: &Self::Target) -> Self::Solutions;

    /// The solution that continues from `q`: on generated robots the one of least travel, and at a singular pose the nearest point of its
    /// self-motion.
    ///
    /// # Errors
    ///
    /// The reason why there is no solution.
    fn inverse_near(&self, target: &Self::Target, q: &[T; N]) -> Result<Solution<T, N>, Why<T>> {
        let list = self.inverse(target);
        let why = || if list.is_empty() { list.why() } else { Why::NotFinite };
        list.toward(q).ok_or_else(why)
    }

    /// The most solutions that there can be.
    fn max_solutions(&self) -> usize {
        Self::Solutions::MOST
    }
}

/// [`Solutions`] of any capacity, for programs that are generic over robots; all of it is described there.
pub trait SolutionList<const N: usize, T: Real = f64>:
    Deref<Target = [Solution<T, N>]> + IntoIterator<Item = Solution<T, N>> + Copy + fmt::Debug + fmt::Display
{
    /// The most solutions that there can be.
    const MOST: usize;

    /// [`Why::Solved`] if there are solutions, else the reason why not.
    fn why(&self) -> Why<T>;

    /// The solutions that keep every joint in its range.
    #[must_use]
    fn within_range(&self) -> Self;

    /// The nearest solution, with the whole turns that bring it nearest.
    fn toward(&self, q: &[T; N]) -> Option<Solution<T, N>>;

    /// The nearest solution, whole turns apart.
    fn closest_to(&self, q: &[T; N]) -> Option<&Solution<T, N>>;

    /// The first solution of a branch.
    fn with_branch(&self, wanted: Branch) -> Option<&Solution<T, N>>;
}

impl<T: Real, const N: usize, const M: usize> SolutionList<N, T> for Solutions<T, N, M> {
    const MOST: usize = M;

    fn why(&self) -> Why<T> {
        self.why()
    }

    fn within_range(&self) -> Self {
        self.within_range()
    }

    fn toward(&self, q: &[T; N]) -> Option<Solution<T, N>> {
        self.toward(q)
    }

    fn closest_to(&self, q: &[T; N]) -> Option<&Solution<T, N>> {
        self.closest_to(q)
    }

    fn with_branch(&self, wanted: Branch) -> Option<&Solution<T, N>> {
        self.with_branch(wanted)
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Point3;

    use super::*;
    use crate::math::{acos, sin_cos};

    /// A crank of length 2 that turns about z.
    struct Crank;

    static JOINTS: [Joint; 1] = [Joint::revolute("q1")];

    impl Robot<1> for Crank {
        fn joints(&self) -> &'static [Joint; 1] {
            &JOINTS
        }
    }

    impl ForwardKinematics<1> for Crank {
        fn forward(&self, q: &[f64; 1]) -> IsometryMatrix3<f64> {
            let turn = IsometryMatrix3::rotation(nalgebra::Vector3::z() * q[0]);
            turn * IsometryMatrix3::translation(2.0, 0.0, 0.0)
        }

        fn frames(&self, q: &[f64; 1]) -> [IsometryMatrix3<f64>; 1] {
            [self.forward(q)]
        }
    }

    impl Jacobian<1> for Crank {
        fn jacobian(&self, q: &[f64; 1]) -> SMatrix<f64, 6, 1> {
            let (s, c) = sin_cos(q[0]);
            SMatrix::<f64, 6, 1>::new(-2.0 * s, 2.0 * c, 0.0, 0.0, 0.0, 1.0)
        }

        fn forward_and_jacobian(&self, q: &[f64; 1]) -> (IsometryMatrix3<f64>, SMatrix<f64, 6, 1>) {
            (self.forward(q), self.jacobian(q))
        }
    }

    impl InverseKinematics<1> for Crank {
        type Target = Point3<f64>;
        type Solutions = Solutions<f64, 1, 2>;

        fn inverse(&self, target: &Point3<f64>) -> Solutions<f64, 1, 2> {
            let mut solutions = Solutions::new(&JOINTS);
            let cosine = target.x / 2.0;
            if cosine.abs() > 1.0 {
                solutions.refuse(Why::OutOfReach { step: "crank", needs: target.x, has: 2.0, unit: "m" });
                return solutions;
            }
            for (side, angle) in [acos(cosine), -acos(cosine)].into_iter().enumerate() {
                solutions.insert(Solution::new([angle], Branch::ANY.with_step(0, side)), 1e-9);
            }
            solutions
        }
    }

    fn follows<const N: usize, R>(robot: &R, q: &[f64; N]) -> bool
    where
        R: ForwardKinematics<N> + InverseKinematics<N, Target = Point3<f64>>,
    {
        let target = robot.forward(q).translation.vector.into();
        let solutions = robot.inverse(&target).within_range();
        solutions.toward(q).is_some() && solutions.iter().any(|s| s.q.iter().zip(q).all(|(a, b)| (a - b).abs() < 1e-7))
    }

    #[test]
    fn programs_are_generic_over_robots() {
        assert!(follows(&Crank, &[0.5]) && follows(&Crank, &[-2.0]));
        assert_eq!(Crank.inverse(&Point3::new(2.0, 0.0, 0.0)).len(), 1);
        assert_eq!((Crank.dof(), Crank.max_solutions()), (1, 2));
    }

    #[test]
    fn robots_are_trait_objects() {
        let robots: [&dyn Jacobian<1>; 2] = [&Crank, &Crank];
        assert_eq!(robots.map(|r| r.jacobian(&[0.0])[(1, 0)]), [2.0; 2]);
        let inverse: &dyn InverseKinematics<1, Target = Point3<f64>, Solutions = Solutions<f64, 1, 2>> = &Crank;
        let why = inverse.inverse(&Point3::new(3.0, 0.0, 0.0)).why();
        assert_eq!(why.to_string(), "crank: distance 3.000 m exceeds 2.000 m");
    }
}
