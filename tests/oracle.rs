//! rs-opw-kinematics as an oracle: on arms with a spherical wrist and parallel axes 2 and 3 both find the same solutions.

use std::f64::consts::{FRAC_PI_2, PI};

use dh_robot::nalgebra::IsometryMatrix3;
use dh_robot::{ForwardKinematics, InverseKinematics, dh_robot};
use dh_tests::sample::Random;
use rs_opw_kinematics::glam::{DMat3, DQuat, DVec3};
use rs_opw_kinematics::kinematic_traits::{Kinematics, Pose};
use rs_opw_kinematics::kinematics_impl::OPWKinematics;
use rs_opw_kinematics::parameters::opw_kinematics::Parameters;

dh_robot! {
    /// Offsets everywhere; the parameters below are the same arm.
    struct Offsets;

    convention = standard;

    | theta     | d     | a      | alpha  |
    | q1        | 0.412 |  0.061 | -90deg |
    | q2 - pi/2 | 0.037 |  0.353 |   0    |
    | q3        | 0     | -0.048 | -90deg |
    | q4        | 0.391 |  0     |  90deg |
    | q5        | 0     |  0     | -90deg |
    | q6        | 0.083 |  0     |   0    |
}

dh_robot! {
    /// No offsets at all: the wrist can come over the shoulder axis.
    struct Plain;

    convention = standard;

    | theta     | d     | a     | alpha  |
    | q1        | 0.3   | 0     | -90deg |
    | q2 - pi/2 | 0     | 0.4   |   0    |
    | q3        | 0     | 0     | -90deg |
    | q4        | 0.35  | 0     |  90deg |
    | q5        | 0     | 0     | -90deg |
    | q6        | 0.1   | 0     |   0    |
}

/// The numbers that rs-opw-kinematics wants: `[a1, a2, b, c1, c2, c3, c4]`.
fn parameters([a1, a2, b, c1, c2, c3, c4]: [f64; 7]) -> Parameters {
    Parameters {
        a1,
        a2,
        b,
        c1,
        c2,
        c3,
        c4,
        offsets: [0.0, 0.0, -FRAC_PI_2, 0.0, 0.0, 0.0],
        sign_corrections: [1; 6],
        dof: 6,
    }
}

fn from_opw(pose: &Pose) -> IsometryMatrix3<f64> {
    let r = DMat3::from_quat(pose.rotation).transpose().to_cols_array_2d();
    dh_robot::pose::from_entries(r, pose.translation.to_array())
}

fn to_opw(pose: &IsometryMatrix3<f64>) -> Pose {
    let p = pose.translation.vector;
    let r = DMat3::from_cols_slice(pose.rotation.matrix().as_slice());
    Pose::from_parts(DVec3::new(p.x, p.y, p.z), DQuat::from_mat3(&r).normalize())
}

fn distance(a: &IsometryMatrix3<f64>, b: &IsometryMatrix3<f64>) -> f64 {
    (a.to_homogeneous() - b.to_homogeneous()).abs().max()
}

/// Are two joint vectors the same but for whole turns?
fn same(a: &[f64; 6], b: &[f64; 6], near: f64) -> bool {
    a.iter().zip(b).all(|(a, b)| ((a - b) / (2.0 * PI) - ((a - b) / (2.0 * PI)).round()).abs() * 2.0 * PI < near)
}

fn agree<R>(robot: &R, numbers: [f64; 7])
where
    R: ForwardKinematics<6> + InverseKinematics<6, Target = IsometryMatrix3<f64>>,
{
    let oracle = OPWKinematics::new(parameters(numbers));
    // Their last frame is turned against ours by a constant.
    let flange = robot.forward(&[0.0; 6]).inverse() * from_opw(&oracle.forward(&[0.0; 6]));
    let mut random = Random::new(12);
    for round in 0..400 {
        let mut q: [f64; 6] = std::array::from_fn(|_| random.signed() * PI);
        // In some rounds near the wrist's singularity, or with the elbow nearly straight.
        match round % 8 {
            6 => q[4] = 2e-3,
            7 => q[2] = (-numbers[1]).atan2(numbers[5]) - FRAC_PI_2 + 2e-3,
            _ => {}
        }
        let target = robot.forward(&q);
        let off = distance(&(target * flange), &from_opw(&oracle.forward(&q)));
        assert!(off < 1e-12, "not the same arm: {off:.1e}");
        let ours = robot.inverse(&target);
        let theirs: Vec<[f64; 6]> = oracle.inverse(&to_opw(&(target * flange)));
        assert!(!theirs.is_empty());
        // They accept what is 1e-6 off.
        for s in theirs.iter().filter(|s| distance(&robot.forward(s), &target) < 1e-9) {
            assert!(ours.iter().any(|o| same(&o.q, s, 1e-5)), "{q:?}: only theirs: {s:?}; ours {ours}");
        }
        for o in ours.iter() {
            assert!(theirs.iter().any(|s| same(&o.q, s, 1e-5)), "{q:?}: only ours: {o}; theirs {theirs:?}");
        }
    }
}

#[test]
fn an_arm_with_all_offsets() {
    agree(&Offsets, [0.061, 0.048, 0.037, 0.412, 0.353, 0.391, 0.083]);
}

#[test]
fn an_arm_without_offsets() {
    agree(&Plain, [0.0, 0.0, 0.0, 0.3, 0.4, 0.35, 0.1]);
}
