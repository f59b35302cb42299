//! A redundant arm with the joint that the caller chooses at one value, as an arm of which everything is asked for.

use dh_robot::nalgebra::SMatrix;
use dh_robot::{ForwardKinematics, InverseKinematics, Jacobian, Joint, Robot};

use crate::Pose;

/// The arm and the value.
pub struct Locked<R, const N: usize> {
    robot: R,
    value: f64,
    joints: &'static [Joint; N],
}

impl<R: Robot<N>, const N: usize> Locked<R, N> {
    /// Locks joint `k`, counted from 0. (Its range, one value, tells the targets.)
    pub fn new(robot: R, k: usize, value: f64) -> Self {
        let mut joints = *robot.joints();
        joints[k] = joints[k].with_range(value, value);
        Self { robot, value, joints: Box::leak(Box::new(joints)) }
    }
}

impl<R, const N: usize> Robot<N> for Locked<R, N> {
    fn joints(&self) -> &'static [Joint; N] {
        self.joints
    }
}

impl<R: ForwardKinematics<N>, const N: usize> ForwardKinematics<N> for Locked<R, N> {
    fn forward(&self, q: &[f64; N]) -> Pose {
        self.robot.forward(q)
    }

    fn frames(&self, q: &[f64; N]) -> [Pose; N] {
        self.robot.frames(q)
    }
}

impl<R: Jacobian<N>, const N: usize> Jacobian<N> for Locked<R, N> {
    fn jacobian(&self, q: &[f64; N]) -> SMatrix<f64, 6, N> {
        self.robot.jacobian(q)
    }

    fn forward_and_jacobian(&self, q: &[f64; N]) -> (Pose, SMatrix<f64, 6, N>) {
        self.robot.forward_and_jacobian(q)
    }
}

impl<R, const N: usize> InverseKinematics<N> for Locked<R, N>
where
    R: InverseKinematics<N, Target = (Pose, f64)>,
{
    type Target = Pose;
    type Solutions = R::Solutions;

    fn inverse(&self, target: &Pose) -> R::Solutions {
        self.robot.inverse(&(*target, self.value))
    }
}
