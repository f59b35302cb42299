//! Inverses in corners: coupled drives, lengths that become zero at run time, bad input, tasks of fewer dimensions, single precision.

use std::f64::consts::PI;

use dh_robot::nalgebra::{IsometryMatrix3, Matrix3, Point3, Rotation3, Translation3, UnitVector3};
use dh_robot::{ForwardKinematics, InverseKinematics, Solutions, Why, dh_robot};
use dh_tests::sample::Random;

type Target = IsometryMatrix3<f64>;

dh_robot! {
    /// A wrist behind a parallelogram: the third motor turns the forearm against the base.
    struct Parallelogram;

    convention = standard;

    | theta   | d    | a    | alpha  |
    | q1      | 0.4  | 0.1  | -90deg |
    | q2      | 0    | 0.5  |   0    |
    | q3 - q2 | 0    | 0.05 | -90deg |
    | q4      | 0.45 | 0    |  90deg |
    | q5      | 0    | 0    | -90deg |
    | q6 + q5 | 0.1  | 0    |   0    |
}

dh_robot! {
    /// Seven axes; the motor that the caller chooses turns its joint backwards, by gears, and pulls at the next one.
    struct Geared;

    convention = modified;
    redundant = q3;

    | alpha  | a | d   | theta            |
    |   0    | 0 | 0.3 | q1               |
    | -90deg | 0 | 0   | -q2              |
    |  90deg | 0 | 0.4 | -2*q3 + 37.2deg  |
    |  90deg | 0 | 0   | q4 - q3 - 0.5deg |
    | -90deg | 0 | 0.4 | q5               |
    | -90deg | 0 | 0   | q6               |
    |  90deg | 0 | 0.1 | q7               |
}

dh_robot! {
    /// A hollow wrist whose axes have no common point, straight at home: a root of high order.
    struct Hollow;

    convention = modified;

    | alpha  | a    | d    | theta      |
    |   0    | 0    | 0.8  | q1         |
    | -90deg | 0.4  | 0    | q2 - 90deg |
    |   0    | 1.2  | 0    | q3 - 90deg |
    | -90deg | 0.25 | 1.4  | q4 + 90deg |
    |  60deg | 0    | 0.15 | q5         |
    | -60deg | 0    | 0.15 | q6 + 90deg |
}

dh_robot! {
    /// Every length is a field.
    struct Fields;

    convention = standard;
    let d1: length;
    let a1: length;
    let b2: length;
    let a2: length;
    let a3: length;
    let d4: length;
    let d6: length;

    | theta | d  | a  | alpha  |
    | q1    | d1 | a1 | -90deg |
    | q2    | b2 | a2 |   0    |
    | q3    | 0  | a3 | -90deg |
    | q4    | d4 | 0  |  90deg |
    | q5    | 0  | 0  | -90deg |
    | q6    | d6 | 0  |   0    |
}

dh_robot! {
    /// What `Fields` is with three lengths at zero.
    struct Zeros;

    convention = standard;

    | theta | d   | a   | alpha  |
    | q1    | 0.3 | 0   | -90deg |
    | q2    | 0   | 0.4 |   0    |
    | q3    | 0   | 0   | -90deg |
    | q4    | 0.5 | 0   |  90deg |
    | q5    | 0   | 0   | -90deg |
    | q6    | 0.1 | 0   |   0    |
}

dh_robot! {
    struct Single;

    convention = standard;
    scalar = f32;

    | theta | d    | a   | alpha  |
    | q1    | 0.3  | 0.1 | -90deg |
    | q2    | 0    | 0.4 |   0    |
    | q3    | 0    | 0   | -90deg |
    | q4    | 0.5  | 0   |  90deg |
    | q5    | 0    | 0   | -90deg |
    | q6    | 0.1  | 0   |   0    |
}

dh_robot! {
    struct Scara;

    convention = standard;

    | theta | d   | a   | alpha  |
    | q1    | 0.4 | 0.3 |   0    |
    | q2    | 0   | 0.2 | 180deg |
    | 0     | q3  | 0   |   0    |
    | q4    | 0.1 | 0   |   0    |
}

dh_robot! {
    /// Three joints that bring a point anywhere.
    struct Reacher;

    convention = standard;
    task = position;

    | theta | d   | a   | alpha |
    | q1    | 0.4 | 0.1 | 90deg |
    | q2    | 0   | 0.3 |   0   |
    | q3    | 0   | 0.2 |   0   |
}

dh_robot! {
    /// Five joints that lay an axis through a point.
    struct Driller;

    convention = standard;
    task = axis;

    | theta     | d   | a    | alpha  |
    | q1        | 0.2 | 0.05 |  90deg |
    | q2        | 0   | 0.3  |   0    |
    | q3        | 0   | 0.25 |   0    |
    | q4 + 90deg| 0   | 0    |  90deg |
    | q5        | 0.2 | 0    |   0    |
}

dh_robot! {
    struct Plane;

    convention = standard;
    task = planar;

    | theta | d | a   | alpha |
    | q1    | 0 | 0.5 |   0   |
    | q2    | 0 | 0.4 |   0   |
    | q3    | 0 | 0.2 |   0   |
}

fn vectors<const N: usize>(seed: u64, count: usize) -> impl Iterator<Item = [f64; N]> {
    let mut random = Random::new(seed);
    (0..count).map(move |_| std::array::from_fn(|_| random.signed() * PI))
}

fn apart<const N: usize>(arm: &impl ForwardKinematics<N>, a: &[f64; N], b: &[f64; N]) -> f64 {
    let pairs = arm.joints().iter().zip(a.iter().zip(b));
    pairs.map(|(joint, (a, b))| joint.difference(*a, *b)).fold(0.0, f64::max)
}

fn off(a: &Target, b: &Target) -> f64 {
    (a.to_homogeneous() - b.to_homogeneous()).abs().max()
}

/// Everything reaches the pose, and `q` is there (unless joints are free).
fn closes<const N: usize, const M: usize>(
    arm: &impl ForwardKinematics<N>,
    q: &[f64; N],
    found: &Solutions<f64, N, M>,
    miss: impl Fn(&Target) -> f64,
) {
    for s in found {
        let error = miss(&arm.forward(&s.q));
        assert!(error < 1e-9, "{s} misses by {error:.1e}");
    }
    let there = found.iter().any(|s| !s.free.is_empty() || apart(arm, &s.q, q) < 1e-6);
    assert!(there, "{q:?} is not among {found} ({})", found.why());
}

#[test]
fn coupled_drives_are_solved_for_the_motors() {
    for q in vectors::<6>(1, 200) {
        let target = Parallelogram.forward(&q);
        closes(&Parallelogram, &q, &Parallelogram.inverse(&target), |pose| off(pose, &target));
    }
    // The wrist singularity as well.
    for mut q in vectors::<6>(2, 5) {
        q[4] = 0.0;
        let target = Parallelogram.forward(&q);
        closes(&Parallelogram, &q, &Parallelogram.inverse(&target), |pose| off(pose, &target));
    }
}

#[test]
fn the_motor_that_the_caller_chooses_may_be_geared() {
    for q in vectors::<7>(9, 100) {
        let target = Geared.forward(&q);
        let found = Geared.inverse(&target, q[2]);
        closes(&Geared, &q, &found, |pose| off(pose, &target));
        assert!(found.iter().all(|s| (s.q[2] - q[2]).abs() < 1e-12 && s.free.is_empty()), "{q:?}: {found}");
    }
}

#[test]
fn a_root_of_high_order_is_crept_up_to() {
    for q in [[0.0; 6], [PI, 0.0, 0.0, 0.0, 0.0, 0.0], [0.7, 0.0, 0.0, 0.0, 0.0, 0.0]] {
        let target = Hollow.forward(&q);
        let found = Hollow.inverse(&target);
        assert!(!found.is_empty(), "{q:?}: {}", found.why());
        assert!(found.iter().all(|s| off(&Hollow.forward(&s.q), &target) < 1e-8), "{q:?}: {found}");
    }
}

#[test]
fn lengths_may_become_zero_while_the_program_runs() {
    let arm = Fields { d1: 0.3, a1: 0.0, b2: 0.0, a2: 0.4, a3: 0.0, d4: 0.5, d6: 0.1 };
    for q in vectors::<6>(3, 200) {
        let target = Zeros.forward(&q);
        let (fields, zeros) = (arm.inverse(&target), Zeros.inverse(&target));
        closes(&arm, &q, &fields, |pose| off(pose, &target));
        assert_eq!(fields.len(), zeros.len(), "{q:?}: {fields}\n{zeros}");
        for s in &zeros {
            assert!(fields.iter().any(|f| apart(&arm, &f.q, &s.q) < 1e-8), "{q:?}: {s} is not among {fields}");
        }
    }
    // One after the other.
    for k in 0..7 {
        let mut l = [0.3, 0.05, 0.07, 0.4, 0.06, 0.5, 0.1];
        l[k] = 0.0;
        let arm = Fields { d1: l[0], a1: l[1], b2: l[2], a2: l[3], a3: l[4], d4: l[5], d6: l[6] };
        for q in vectors::<6>(4, 30) {
            let target = arm.forward(&q);
            closes(&arm, &q, &arm.inverse(&target), |pose| off(pose, &target));
        }
    }
}

#[test]
fn the_elbow_solutions_of_a_nearly_stretched_arm_stay_two() {
    let (arm, zero) = (generated_examples::puma560::Puma560::default(), (0.0203_f64 / 0.4318).atan() - PI / 2.0);
    for bend in [3e-6, -1e-5, 1e-4] {
        for q in vectors::<6>(8, 60) {
            let q = [q[0], q[1], zero + bend, q[3], q[4], q[5]];
            let found = arm.inverse(&arm.forward(&q));
            assert_eq!(found.len(), 8, "{q:?}: {found}");
        }
    }
}

/// The target of some joint values, spoiled.
fn spoiled(change: impl Fn(&mut Matrix3<f64>, &mut Translation3<f64>)) -> Target {
    let pose = Zeros.forward(&[0.3, -0.8, 0.4, 1.0, 0.7, -0.2]);
    let (mut r, mut p) = (*pose.rotation.matrix(), pose.translation);
    change(&mut r, &mut p);
    Target::from_parts(p, Rotation3::from_matrix_unchecked(r))
}

#[test]
fn bad_targets_are_refused_and_say_why() {
    let why = |target: &Target| {
        let found = Zeros.inverse(target);
        assert!(found.is_empty(), "{found}");
        found.why()
    };
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(why(&spoiled(|_, p| p.x = bad)), Why::NotFinite);
        assert_eq!(why(&spoiled(|r, _| r[(1, 2)] = bad)), Why::NotFinite);
    }
    assert!(matches!(why(&spoiled(|r, _| *r *= 1.01)), Why::NotARotation { .. }));
    assert!(matches!(why(&spoiled(|r, _| r.swap_columns(0, 1))), Why::NotARotation { .. }));
    assert!(matches!(why(&spoiled(|r, _| r[(0, 0)] += 1e-3)), Why::NotARotation { .. }));
    assert!(matches!(why(&spoiled(|_, p| p.x += 3.0)), Why::OutOfReach { .. }));
    // Rounding is forgiven.
    assert!(!Zeros.inverse(&spoiled(|r, _| *r = r.map(|x| (x * 1e7).round() * 1e-7))).is_empty());
}

#[test]
fn a_pose_off_what_few_joints_can_do_is_refused() {
    for q in vectors::<4>(5, 50) {
        let target = Scara.forward(&q);
        closes(&Scara, &q, &Scara.inverse(&target), |pose| off(pose, &target));
        let tilted = target * Rotation3::from_euler_angles(0.01, 0.0, 0.0);
        let found = Scara.inverse(&tilted);
        assert!(found.is_empty() && found.why() != Why::Solved, "{found}");
        assert!(found.why().to_string().len() > 10, "{}", found.why());
    }
}

#[test]
fn a_point_an_axis_and_a_plane_are_reached() {
    for q in vectors::<3>(6, 100) {
        let point = Point3::from(Reacher.forward(&q).translation.vector);
        closes(&Reacher, &q, &Reacher.inverse(&point), |pose| (pose.translation.vector - point.coords).norm());
        let pose = Plane.forward(&q);
        let (p, r) = (pose.translation.vector, pose.rotation.matrix());
        let found = Plane.inverse((p.x, p.y, r[(1, 0)].atan2(r[(0, 0)])));
        closes(&Plane, &q, &found, |reached| off(reached, &pose));
    }
    for q in vectors::<5>(7, 100) {
        let pose = Driller.forward(&q);
        let (point, axis) = (Point3::from(pose.translation.vector), pose.rotation.matrix().column(2).into_owned());
        let found = Driller.inverse((point, UnitVector3::new_normalize(axis)));
        assert!(!found.is_empty(), "{q:?}: {}", found.why());
        for s in &found {
            let reached = Driller.forward(&s.q);
            let error = (reached.translation.vector - point.coords).norm()
                + (reached.rotation.matrix().column(2) - axis).norm();
            assert!(error < 1e-9, "{q:?}: {s} misses by {error:.1e}");
        }
    }
    assert!(Reacher.inverse(&Point3::new(5.0, 0.0, 0.0)).is_empty());
    assert_eq!(Reacher.inverse(&Point3::new(f64::NAN, 0.0, 0.0)).why(), Why::NotFinite);
    assert!(Plane.inverse((3.0, 0.0, 0.0)).is_empty());
}

#[test]
fn single_precision_finds_as_many_solutions() {
    for q in vectors::<6>(8, 200) {
        let short = q.map(|x| x as f32);
        let target = Single.forward(&short);
        let found = InverseKinematics::inverse(&Single, &target);
        for s in &found {
            let reached = Single.forward(&s.q);
            let error = (reached.to_homogeneous() - target.to_homogeneous()).abs().max();
            assert!(error < 1e-5, "{q:?}: {s} misses by {error:.1e}");
        }
        let there = |s: &[f32; 6]| s.iter().zip(&short).all(|(a, b)| dh_robot::math::wrap_angle(a - b).abs() < 1e-2);
        assert!(found.iter().any(|s| there(&s.q)), "{q:?} is not among {found} ({})", found.why());
    }
}

dh_robot! {
    /// Five axes, three of them parallel.
    struct FiveAxes;

    convention = standard;

    | theta      | d     | a     | alpha  |
    | q1         | 0.349 | 0.016 | -90deg |
    | q2         | 0     | 0.221 |   0    |
    | q3         | 0     | 0.221 |   0    |
    | q4 + 90deg | 0     | 0     |  90deg |
    | q5         | 0.145 | 0     |   0    |
}

#[test]
fn a_tool_that_points_straight_down_does_not_leave_the_first_axis_open() {
    // The direction of the tool says nothing about the first joint then: its position does. Stretched one way, regular the other.
    let target = FiveAxes.forward(&[0.0, PI, 0.0, 0.5 * PI, 0.5 * PI]);
    let solutions = FiveAxes.inverse(&target);
    let turned = solutions.iter().filter(|s| s.q[0].abs() > 3.0).count();
    assert_eq!((solutions.len(), turned), (3, 2), "{solutions}");
}

dh_robot! {
    /// A planar arm whose tool is tilted by angles that the program chooses.
    struct Tilted;

    convention = standard;
    task = planar;
    let t0: angle;
    let t1: angle = 20deg;
    tool = rz(t0) * ry(t0);

    | theta | d   | a   | alpha |
    | q1    | 0   | 0.5 |   0   |
    | t1    | 0.1 | 0   |   0   |
    | q2    | 0   | 0.4 |   0   |
    | q3    | 0   | 0.2 |  t1   |
}

#[test]
fn a_planar_arm_keeps_its_word_when_its_tool_is_tilted_at_run_time() {
    for (t0, t1) in [(0.0, 0.0), (0.3, 0.5 * PI), (-0.7, 1.1), (0.0, PI)] {
        let arm = Tilted { t0, t1 };
        for q in vectors::<3>(9, 30) {
            let pose = arm.forward(&q);
            let (p, r) = (pose.translation.vector, pose.rotation.matrix());
            let found = arm.inverse((p.x, p.y, r[(1, 0)].atan2(r[(0, 0)])));
            closes(&arm, &q, &found, |reached| off(reached, &pose));
        }
    }
}

dh_robot! {
    /// Five joints, one of which slides. Its plan has one step with two roots; what the arm reaches crosses itself.
    struct Crossing;

    convention = modified;

    | alpha  | a    | d   | theta |
    |   0    | 0    | 0.3 | q1    |
    |  90deg | 0.1  | 0   | q2    |
    |  90deg | 0.05 | q3  | 0     |
    |  90deg | 0    | 0.1 | q4    |
    | -90deg | 0.05 | 0   | q5    |
}

#[test]
fn a_special_pose_may_have_more_solutions_than_the_steps_have_roots() {
    let q = [0.0, 0.5 * PI, -0.4, 0.5 * PI, 2.779_496_254_322_763_7];
    let found = Crossing.inverse(&Crossing.forward(&q));
    assert_eq!(found.len(), 4, "{found}");
    closes(&Crossing, &q, &found, |pose| off(pose, &Crossing.forward(&q)));
}
