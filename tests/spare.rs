//! Several joints that the caller gives, and tasks that need fewer joints than the arm has.

use dh_robot::nalgebra::{IsometryMatrix3, Point3};
use dh_robot::{Arm, InverseKinematics, dh_robot};
use dh_tests::sample::Random;

dh_robot! {
    /// A KUKA iiwa 7 on a rail: the rail and the third joint of the arm are given, in this order.
    pub struct Rail;
    convention = standard;
    redundant = q4, q1;
    base = rx(-90deg);
    | theta | d    | a | alpha  |
    |-------|------|---|--------|
    | 0     | q1   | 0 | 90deg  |
    | q2    | 0.34 | 0 | -90deg |
    | q3    | 0    | 0 | 90deg  |
    | q4    | 0.4  | 0 | 90deg  |
    | q5    | 0    | 0 | -90deg |
    | q6    | 0.4  | 0 | -90deg |
    | q7    | 0    | 0 | 90deg  |
    | q8    | 0.126| 0 | 0      |
}

dh_robot! {
    /// A planar arm that is asked for a point.
    pub struct Planar;
    convention = modified;
    task = position;
    redundant = q3;
    tool = tx(0.2);
    | alpha | a   | d | theta |
    |-------|-----|---|-------|
    | 0     | 0   | 0 | q1    |
    | 0     | 0.4 | 0 | q2    |
    | 0     | 0.3 | 0 | q3    |
}

dh_robot! {
    /// A PUMA that is asked for a point: the wrist is given.
    pub struct Wrist;
    convention = modified;
    task = position;
    redundant = q4, q5, q6;
    scalar = f32;
    tool = tx(0.05) * tz(0.1);
    | alpha  | a      | d       | theta |
    |--------|--------|---------|-------|
    | 0      | 0      | 0       | q1    |
    | -90deg | 0      | 0       | q2    |
    | 0      | 0.4318 | 0.15005 | q3    |
    | -90deg | 0.0203 | 0.4318  | q4    |
    | 90deg  | 0      | 0       | q5    |
    | -90deg | 0      | 0       | q6    |
}

dh_robot! {
    /// Five parallel joints in the plane, two of them given; one moves with another.
    pub struct Snake;
    convention = modified;
    task = planar;
    redundant = q5, q2;
    tool = tx(0.1);
    | alpha | a   | d | theta   |
    |-------|-----|---|---------|
    | 0     | 0   | 0 | q1      |
    | 0     | 0.4 | 0 | q2      |
    | 0     | 0.3 | 0 | q3 - q2 |
    | 0     | 0.3 | 0 | q4      |
    | 0     | 0.2 | 0 | q5      |
}

/// Every solution reaches the target and keeps what was given, and the joint values that made the target are among them.
#[track_caller]
fn check<const N: usize>(
    q: [f64; N],
    found: &[[f64; N]],
    given: &[usize],
    miss: impl Fn(&[f64; N]) -> f64,
    tolerance: f64,
) {
    let turn = |x: f64| x.sin().atan2(x.cos()).abs();
    assert!(found.iter().any(|s| s.iter().zip(&q).all(|(a, b)| turn(a - b) < 100.0 * tolerance)), "{q:?}: {found:?}");
    for s in found {
        assert!(miss(s) < tolerance, "{q:?}: {s:?} misses by {:e}", miss(s));
        assert!(given.iter().all(|k| turn(s[*k] - q[*k]) < tolerance), "{q:?}: {s:?}");
    }
}

fn distance(a: &IsometryMatrix3<f64>, b: &IsometryMatrix3<f64>) -> f64 {
    (a.to_homogeneous() - b.to_homogeneous()).abs().max()
}

#[test]
fn a_seven_axis_arm_on_a_rail() {
    let (arm, mut random) = (Rail, Random::new(8));
    let mut most = 0;
    for _ in 0..20 {
        let q: [f64; 8] = std::array::from_fn(|_| 1.5 * random.signed());
        let target = arm.forward(&q);
        let solutions = arm.inverse(&target, [q[3], q[0]]);
        let found: Vec<[f64; 8]> = solutions.iter().map(|s| s.q).collect();
        check(q, &found, &[3, 0], |s| distance(&arm.forward(s), &target), 1e-9);
        most = most.max(found.len());
        let by_trait = InverseKinematics::inverse(&arm, &(target, [q[3], q[0]]));
        assert_eq!(by_trait.len(), found.len());
        let mut count = 0;
        (&arm as &dyn Arm).inverse(&target, &[q[3], q[0]], &mut |_| count += 1);
        assert_eq!(count, found.len());
    }
    assert_eq!(most, 8);
    assert!(arm.inverse(&arm.forward(&[0.3; 8]), [f64::NAN, 0.0]).is_empty());
}

#[test]
fn a_planar_arm_asked_for_a_point() {
    let (arm, mut random) = (Planar, Random::new(3));
    for _ in 0..20 {
        let q: [f64; 3] = std::array::from_fn(|_| 3.0 * random.signed());
        let target = Point3::from(arm.forward(&q).translation.vector);
        let solutions = arm.inverse(&target, q[2]);
        let found: Vec<[f64; 3]> = solutions.iter().map(|s| s.q).collect();
        check(q, &found, &[2], |s| (arm.forward(s).translation.vector - target.coords).norm(), 1e-9);
        assert_eq!(found.len(), 2, "{q:?}");
    }
}

#[test]
fn six_joints_asked_for_a_point() {
    let (arm, mut random) = (Wrist, Random::new(6));
    for _ in 0..20 {
        let q: [f32; 6] = std::array::from_fn(|_| 1.5 * random.signed() as f32);
        let target = Point3::from(arm.forward(&q).translation.vector);
        let solutions = arm.inverse(&target, [q[3], q[4], q[5]]);
        let found: Vec<[f64; 6]> = solutions.iter().map(|s| s.q.map(f64::from)).collect();
        let miss =
            |s: &[f64; 6]| f64::from((arm.forward(&s.map(|x| x as f32)).translation.vector - target.coords).norm());
        check(q.map(f64::from), &found, &[3, 4, 5], miss, 1e-4);
    }
}

#[test]
fn parallel_joints_with_a_coupling() {
    let (arm, mut random) = (Snake, Random::new(5));
    for _ in 0..20 {
        let q: [f64; 5] = std::array::from_fn(|_| 1.5 * random.signed());
        let target = |q: &[f64; 5]| {
            let pose = arm.forward(q);
            let (p, r) = (pose.translation.vector, pose.rotation);
            (p.x, p.y, r[(1, 0)].atan2(r[(0, 0)]))
        };
        let goal = target(&q);
        let solutions = arm.inverse(goal, [q[4], q[1]]);
        let found: Vec<[f64; 5]> = solutions.iter().map(|s| s.q).collect();
        let miss = |s: &[f64; 5]| {
            let (x, y, phi) = target(s);
            (x - goal.0).abs() + (y - goal.1).abs() + (phi - goal.2).sin().abs()
        };
        check(q, &found, &[4, 1], miss, 1e-9);
    }
}
