//! Traits for programs that are generic over robots.
//!
//! The macro implements them beside inherent functions of the same names, so that one robot needs no trait in scope. All of
//! them can be used as trait objects too: `&dyn ForwardKinematics<6>` is any six-axis arm.

use nalgebra::{IsometryMatrix3, SMatrix};

use crate::{Joint, Real, Solutions};

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
}

/// From a target to joint values: all of them, at most `M`.
pub trait InverseKinematics<const N: usize, const M: usize, T: Real = f64>: Robot<N, T> {
    /// What is to be reached: `IsometryMatrix3<T>` for `task = pose`, `Point3<T>` for `position`, `(T, T, T)` for `planar`,
    /// `(Point3<T>, UnitVector3<T>)` for `axis`; with `redundant` the pair of that and the value of the chosen joint.
    type Target;

    /// Every solution, each once.
    fn inverse(&self, target: &Self::Target) -> Solutions<T, N, M>;

    /// The most solutions that there can be: `M`.
    fn max_solutions(&self) -> usize {
        M
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Point3;

    use super::*;
    use crate::math::{acos, sin_cos};
    use crate::{Branch, Solution, Why};

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
    }

    impl InverseKinematics<1, 2> for Crank {
        type Target = Point3<f64>;

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

    fn follows<const N: usize, const M: usize, R>(robot: &R, q: &[f64; N]) -> bool
    where
        R: ForwardKinematics<N> + InverseKinematics<N, M, Target = Point3<f64>>,
    {
        let target = robot.forward(q).translation.vector.into();
        robot.inverse(&target).iter().any(|s| s.q.iter().zip(q).all(|(a, b)| (a - b).abs() < 1e-7))
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
        let inverse: &dyn InverseKinematics<1, 2, Target = Point3<f64>> = &Crank;
        let why = inverse.inverse(&Point3::new(3.0, 0.0, 0.0)).why();
        assert_eq!(why.to_string(), "crank: distance 3.000 m exceeds 2.000 m");
    }
}
