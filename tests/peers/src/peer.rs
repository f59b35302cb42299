//! The other crates behind one trait: each gets its targets in its own form before the clock starts.

use std::hint::black_box;

use cpu_time::ProcessTime;
use dh_robot::ForwardKinematics;
use rs_opw_kinematics::glam::{DMat3, DQuat, DVec3};
use rs_opw_kinematics::kinematic_traits::{Kinematics, Pose as OpwPose};
use rs_opw_kinematics::kinematics_impl::OPWKinematics;
use rs_opw_kinematics::parameters::opw_kinematics::Parameters;

use crate::{Pose, Random};

/// An answer of a solver.
pub struct Answer<const N: usize> {
    /// Joint values.
    pub q: [f64; N],
    /// Does the solver say that it is a solution (and not the nearest thing to one)?
    pub claimed: bool,
}

/// A solver of one arm.
pub trait Peer<const N: usize> {
    /// Name and version.
    fn name(&self) -> String;
    /// Seconds of CPU time to solve these targets, without the change of their form.
    fn pass(&self, targets: &[Pose]) -> f64;
    /// The answers for one target.
    fn answers(&self, target: &Pose) -> Vec<Answer<N>>;
}

/// rs-opw-kinematics, for arms with a spherical wrist and parallel second and third axes.
pub struct Opw {
    arm: OPWKinematics,
    /// From our last frame to theirs.
    flange: Pose,
}

impl Opw {
    /// Finds the constant difference of the last frames, and checks that the two arms are the same one.
    pub fn new(robot: &impl ForwardKinematics<6>, parameters: Parameters) -> Self {
        let arm = OPWKinematics::new(parameters);
        let zero = robot.forward(&[0.0; 6]);
        let flange = zero.inverse() * from_opw(&arm.forward(&[0.0; 6]));
        let mut random = Random(3);
        for _ in 0..100 {
            let q = random.joints(robot);
            let difference = (robot.forward(&q) * flange).inverse() * from_opw(&arm.forward(&q));
            let off = (difference.to_homogeneous() - Pose::identity().to_homogeneous()).abs().max();
            assert!(off < 1e-12, "not the same arm: {off}");
        }
        Self { arm, flange }
    }

    fn target(&self, target: &Pose) -> OpwPose {
        let pose = target * self.flange;
        let r = DMat3::from_cols_slice(pose.rotation.matrix().as_slice());
        let p = pose.translation.vector;
        OpwPose::from_parts(DVec3::new(p.x, p.y, p.z), DQuat::from_mat3(&r).normalize())
    }
}

fn from_opw(pose: &OpwPose) -> Pose {
    let r = DMat3::from_quat(pose.rotation).transpose().to_cols_array_2d();
    dh_robot::pose::from_entries(r, pose.translation.to_array())
}

impl Peer<6> for Opw {
    fn name(&self) -> String {
        "rs-opw-kinematics 3.0.0".into()
    }

    fn pass(&self, targets: &[Pose]) -> f64 {
        let targets: Vec<OpwPose> = targets.iter().map(|target| self.target(target)).collect();
        let start = ProcessTime::now();
        for target in &targets {
            black_box(&self.arm.inverse(black_box(target)));
        }
        start.elapsed().as_secs_f64()
    }

    fn answers(&self, target: &Pose) -> Vec<Answer<6>> {
        self.arm.inverse(&self.target(target)).into_iter().map(|q| Answer { q, claimed: true }).collect()
    }
}
