//! Targets of special kinds: positions whose solutions are families, rotations with few decimals, positions out of hand, several given joints.

use dh_robot::{Why, dh_robot, pose};
use dh_tests::sample::Random;
use generated_examples::{kuka_kr6_r700::KukaKr6R700, puma560::Puma560, youbot::Youbot};
use std::f64::consts::{PI, TAU};

dh_robot! {
    /// The point of a tool on a PUMA: its joints leave three dimensions of freedom, and have ranges.
    struct Pointer;

    convention = modified;
    task = position;
    tool = tz(0.2);

    | alpha  | a      | d       | theta | range            |
    |--------|--------|---------|-------|------------------|
    |   0    | 0      | 0       | q1    | -160deg..=160deg |
    | -90deg | 0      | 0       | q2    | -225deg..= 45deg |
    |   0    | 0.4318 | 0.15005 | q3    |  -45deg..=225deg |
    | -90deg | 0.0203 | 0.4318  | q4    | -110deg..=170deg |
    |  90deg | 0      | 0       | q5    | -100deg..=100deg |
    | -90deg | 0      | 0       | q6    | -266deg..=266deg |
}

dh_robot! {
    /// A seven-axis arm on a rail: the caller gives the rail and a joint of the elbow's.
    struct OnRail;

    convention = modified;
    redundant = q1, q4;
    base = rx(90deg);

    | alpha  | a | d     | theta |
    |--------|---|-------|-------|
    |   0    | 0 | q1    | 0     |
    | -90deg | 0 | 0.34  | q2    |
    | -90deg | 0 | 0     | q3    |
    |  90deg | 0 | 0.4   | q4    |
    |  90deg | 0 | 0     | q5    |
    | -90deg | 0 | 0.4   | q6    |
    | -90deg | 0 | 0     | q7    |
    |  90deg | 0 | 0.126 | q8    |
}

dh_robot! {
    /// Five joints in single precision.
    struct Five;

    convention = modified;
    scalar = f32;

    | alpha  | a   | d   | theta |
    |--------|-----|-----|-------|
    |   0    | 0   | 0.3 | q1    |
    |  90deg | 0   | 0   | q2    |
    |   0    | 0.4 | 0   | q3    |
    |   0    | 0.3 | 0   | q4    |
    |  90deg | 0   | 0.2 | q5    |
}

/// The difference of two angles, or of two lengths that are nearer than half a turn.
fn apart(a: f64, b: f64) -> f64 {
    let x = a - b;
    (x - TAU * (x / TAU).round()).abs()
}

/// Joint values within their ranges.
fn inside<const N: usize>(joints: &[dh_robot::Joint; N], r: &mut Random) -> [f64; N] {
    std::array::from_fn(|k| {
        let (least, greatest) = joints[k].range.unwrap_or((-PI, PI));
        least + (greatest - least) * 0.5 * (1.0 + r.signed())
    })
}

#[test]
fn a_family_of_solutions_has_a_member_in_range() {
    let mut r = Random::new(17);
    let mut lost = 0;
    for _ in 0..300 {
        let q = inside(&Pointer::JOINTS, &mut r);
        let point = Pointer.forward(&q).translation.vector;
        let list = Pointer.inverse(&point.into()).within_range();
        lost += usize::from(list.is_empty());
        for s in &list {
            let there = Pointer.forward(&s.q).translation.vector;
            assert!((there - point).norm() < 1e-8, "{s:?}");
        }
    }
    assert!(lost <= LOST, "{lost} of 300 points are reached within the ranges, but no solution is in range");
}

/// Of the points, those for which the bounded search may find no way into the ranges.
const LOST: usize = 3;

#[test]
fn a_point_and_a_direction_are_reached_with_any_turn_about_it() {
    let robot = Youbot;
    let mut r = Random::new(5);
    for _ in 0..200 {
        let q = inside(&Youbot::JOINTS, &mut r);
        let pose = robot.forward(&q);
        let axis = dh_robot::nalgebra::Unit::new_normalize(pose.rotation.matrix().column(2).into_owned());
        let list = robot.inverse((pose.translation.vector.into(), axis));
        let found = list.iter().find(|s| (0..5).all(|k| s.free.contains(k) || apart(s.q[k], q[k]) < 1e-7));
        let s = found.unwrap_or_else(|| panic!("{q:?} is not among {list:?}"));
        assert!(s.free.contains(4) && s.free.len() == 1, "{s:?}");
        assert!(robot.self_motion(s).is_some());
        let near = robot.inverse_near((pose.translation.vector.into(), axis), &q).expect("it is there");
        assert!(near.q.iter().zip(&q).all(|(a, b)| (a - b).abs() < 1e-7), "{near:?} instead of {q:?}");
    }
}

#[test]
fn two_joints_are_given() {
    let mut r = Random::new(6);
    for _ in 0..200 {
        let q: [f64; 8] = std::array::from_fn(|k| if k == 0 { r.signed() } else { PI * r.signed() });
        let target = OnRail.forward(&q);
        let list = OnRail.inverse(&target, [q[0], q[3]]);
        let own = list.iter().any(|s| s.q[0] == q[0] && s.q.iter().zip(&q).all(|(a, b)| apart(*a, *b) < 1e-7));
        assert!(own && list.len() == 8, "{q:?}: {list:?}");
        let again = OnRail.inverse_exhaustive(&target, [q[0], q[3]]);
        assert_eq!(list.len(), again.len(), "{q:?}");
        let near = OnRail.inverse_near(&target, [q[0], q[3]], &q).expect("it is there");
        assert!(near.q.iter().zip(&q).all(|(a, b)| (a - b).abs() < 1e-7));
    }
}

#[test]
fn five_joints_in_single_precision_take_their_own_poses() {
    let turns = [0.0, 0.5, 1.0, -0.5].map(|x: f32| x * std::f32::consts::PI);
    let mut empty = 0;
    for mut k in 0..1024_usize {
        let q = std::array::from_fn(|_| {
            let x = turns[k % 4];
            k /= 4;
            x
        });
        empty += usize::from(Five.inverse(&Five.forward(&q)).is_empty());
    }
    assert_eq!(empty, 0);
}

#[test]
fn rotations_with_few_decimals_become_the_nearest_ones() {
    let robot = KukaKr6R700;
    let mut r = Random::new(8);
    for _ in 0..100 {
        let q: [f64; 6] = std::array::from_fn(|_| 0.3 + 0.5 * (1.0 + r.signed()));
        let target = robot.forward(&q);
        for (decimals, most) in [(3, 3e-3), (4, 3e-4), (5, 3e-5)] {
            let unit = 10_f64.powi(decimals);
            let rows = std::array::from_fn(|i| {
                std::array::from_fn(|j| (target.rotation.matrix()[(i, j)] * unit).round() / unit)
            });
            let rounded = pose::from_entries(rows, target.translation.vector.into());
            let refused = robot.inverse(&rounded).why();
            if let Why::NotARotation { .. } = refused {
                assert!(refused.to_string().contains("inverse_nearest_rotation"), "{refused}");
            }
            let (list, deviation) = robot.inverse_nearest_rotation(&rounded);
            assert!(deviation < most, "{decimals}: {deviation}");
            let near = list.iter().any(|s| s.q.iter().zip(&q).all(|(a, b)| apart(*a, *b) < 20.0 * most));
            assert!(near, "{decimals} decimals: {q:?} is not near {list:?}");
        }
    }
    let skewed = pose::from_entries([[1.0, 0.1, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [0.4, 0.0, 0.5]);
    let (list, deviation) = robot.inverse_nearest_rotation(&skewed);
    assert!(list.is_empty() && (deviation - 0.1).abs() < 1e-12, "{deviation}");
    assert!(!list.why().to_string().contains("inverse_nearest_rotation"), "{}", list.why());
}

#[test]
fn positions_out_of_hand_are_refused_with_a_finite_reason() {
    let robot = Puma560::default();
    let from = [0.1, -0.6, 0.5, 0.2, 0.4, -0.3];
    for size in [1e13, 1e160, 1e300, -1e300] {
        let mut target = robot.forward(&from);
        target.translation.vector.x = size;
        let reasons = [
            robot.inverse(&target).why(),
            robot.inverse_exhaustive(&target).why(),
            robot.inverse_near(&target, &from).expect_err("it is far away"),
        ];
        for why in reasons {
            let Why::OutOfReach { needs, has, .. } = why else { panic!("{size}: {why}") };
            assert!(needs.is_finite() && has.is_finite() && needs > has, "{why}");
            assert!(why.to_string().len() < 80, "{why}");
        }
    }
}
