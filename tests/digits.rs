//! Targets that lost digits, and targets that are off what an arm can do: what is answered, and what is said of the others.

use std::f64::consts::PI;

use dh_robot::nalgebra::{IsometryMatrix3, Matrix3, Point3, Rotation3, Translation3, UnitVector3, Vector3};
use dh_robot::{InverseKinematics, SolutionList, Why, dh_robot, pose};
use dh_tests::sample::Random;
use generated_examples::crx10ia::Crx10ia;
use generated_examples::kuka_kr6_r700::KukaKr6R700;
use generated_examples::ur5::Ur5;

type Target = IsometryMatrix3<f64>;

dh_robot! {
    struct Scara;

    convention = standard;
    unit = mm;

    | theta | d   | a   | alpha  |
    | q1    | 400 | 300 |   0    |
    | q2    | 0   | 200 | 180deg |
    | 0     | q3  | 0   |   0    |
    | q4    | 100 | 0   |   0    |
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

dh_robot! {
    /// Five joints that lay an axis through a point: the last one moves it.
    struct Driller;

    convention = standard;
    task = axis;

    | theta | d   | a   | alpha  |
    | q1    | 0.3 | 0.1 |  90deg |
    | q2    | 0   | 0.4 |   0    |
    | q3    | 0   | 0.1 |  90deg |
    | q4    | 0.4 | 0   | -90deg |
    | q5    | 0   | 0   |  90deg |
}

fn vectors<const N: usize>(seed: u64, count: usize) -> impl Iterator<Item = [f64; N]> {
    let mut random = Random::new(seed);
    (0..count).map(move |_| std::array::from_fn(|_| random.signed() * PI))
}

/// A pose as a text file holds it.
fn written(target: &Target, digits: i32) -> Target {
    let scale = 10_f64.powi(digits);
    let round = |x: f64| (x * scale).round() / scale;
    let matrix: Matrix3<f64> = target.rotation.matrix().map(round);
    Target::from_parts(
        Translation3::from(target.translation.vector.map(round)),
        Rotation3::from_matrix_unchecked(matrix),
    )
}

/// A pose with six decimals has the solutions of the pose, and each reaches the rotation that is meant.
fn all_are_answered(arm: &impl InverseKinematics<6, Target = Target>, of: impl Fn(&[f64; 6]) -> Target) {
    for q in vectors::<6>(3, 40) {
        let exact = of(&q);
        let found = arm.inverse(&exact);
        // Where two solutions meet, rounding may bring them together, or do away with both.
        let near = |a: &[f64; 6], b: &[f64; 6]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 0.02);
        if found.iter().enumerate().any(|(i, s)| found[..i].iter().any(|t| near(&s.q, &t.q))) {
            continue;
        }
        for digits in [6, 7, 9, 12] {
            let target = written(&exact, digits);
            let rounded = arm.inverse(&target);
            assert!(rounded.len() == found.len(), "{q:?}, {digits} digits: {rounded} ({})\n{found}", rounded.why());
            let meant = pose::orthonormalized(&target);
            for s in rounded.iter() {
                let (apart, turned) = pose::distance(&of(&s.q), &meant);
                assert!(
                    apart < 1e-9 && turned < 1e-9,
                    "{q:?}, {digits} digits: {s} misses by {apart:.1e}, {turned:.1e}"
                );
            }
        }
    }
}

#[test]
fn six_joints_answer_a_rounded_pose_with_all_solutions() {
    all_are_answered(&KukaKr6R700, |q| KukaKr6R700.forward(q));
    all_are_answered(&Ur5, |q| Ur5.forward(q));
    all_are_answered(&Crx10ia, |q| Crx10ia.forward(q));
}

/// The target after a small turn about an axis of the base.
fn turned(target: &Target, axis: Vector3<f64>, angle: f64) -> Target {
    Target::from_parts(target.translation, Rotation3::new(axis * angle) * target.rotation)
}

#[test]
fn few_joints_say_by_how_much_a_pose_is_off() {
    for q in vectors::<4>(5, 20) {
        let target = Scara.forward(&q);
        for by in [1e-8, 1e-6, 1e-3, 0.03] {
            let found = Scara.inverse(&turned(&target, Vector3::x(), by));
            match found.why() {
                Why::NotOnTask { what: "its orientation", by: said, unit: "rad" } => {
                    assert!((said / by - 1.0).abs() < 1e-3, "{q:?}: off by {said:e}, not {by:e}");
                }
                why => panic!("{q:?}, {by:e}: {why}"),
            }
        }
        assert!(!Scara.inverse(&turned(&target, Vector3::x(), 1e-12)).is_empty());
    }
    // Sideways out of the plane of the arm: the arm may turn after it, and then its tool points the wrong way.
    for q in vectors::<5>(6, 20) {
        let target = FiveAxes.forward(&q);
        let sideways = Rotation3::from_axis_angle(&Vector3::z_axis(), q[0]) * Vector3::y();
        for by in [1e-7, 1e-4, 1e-2] {
            let moved = Translation3::from(sideways * by) * target;
            let why = FiveAxes.inverse(&moved).why();
            let said = match why {
                Why::NotOnTask { what: "its position", by, unit: "m" } => by,
                Why::NotOnTask { what: "its orientation", by, unit: "rad" } => by,
                why => panic!("{q:?}, {by:e}: {why}"),
            };
            assert!(said < 20.0 * by && said > 1e-4 * by, "{q:?}: {why}, moved by {by:e}");
        }
    }
}

#[test]
fn a_direction_may_lose_digits_and_must_be_a_unit_vector() {
    for q in vectors::<5>(7, 40) {
        let at = Driller.forward(&q);
        let point = Point3::from(at.translation.vector);
        let axis: Vector3<f64> = at.rotation.matrix().column(2).into_owned();
        let rounded = UnitVector3::new_unchecked(axis.map(|x| (x * 1e6).round() * 1e-6));
        let (exact, found) =
            (Driller.inverse((point, UnitVector3::new_normalize(axis))), Driller.inverse((point, rounded)));
        assert_eq!(found.len(), exact.len(), "{q:?}: {}", found.why());
        for s in &found {
            let reached = Driller.forward(&s.q);
            let miss = (reached.rotation.matrix().column(2) - rounded.normalize()).norm();
            assert!(
                miss < 1e-9 && (reached.translation.vector - point.coords).norm() < 1e-9,
                "{q:?}: {s} misses by {miss:e}"
            );
        }
        for (scale, deviation) in [(2.0, 3.0), (0.0, 1.0)] {
            match Driller.inverse((point, UnitVector3::new_unchecked(axis * scale))).why() {
                Why::NotAUnitVector { deviation: said } => assert!((said - deviation).abs() < 1e-12),
                why => panic!("{why}"),
            }
        }
        let nothing = UnitVector3::new_unchecked(axis * f64::NAN);
        assert_eq!(Driller.inverse((point, nothing)).why(), Why::NotFinite);
    }
}

/// What is said of a target straight ahead, too far away: the limit.
fn limit(arm: &impl InverseKinematics<6, Target = Target>, target: &Target) -> f64 {
    match arm.inverse(target).why() {
        Why::OutOfReach { needs, has, unit: "m", .. } => {
            assert!(needs > has);
            has
        }
        why => panic!("{why}"),
    }
}

dh_robot! {
    /// The same wrist without any offset at the shoulder: the planner begins with another joint.
    struct Straight;

    convention = standard;

    | theta | d     | a    | alpha  |
    | q1    | 0.29  | 0    | -90deg |
    | q2    | 0     | 0.27 |   0    |
    | q3    | 0     | 0.07 | -90deg |
    | q4    | 0.302 | 0    |  90deg |
    | q5    | 0     | 0    | -90deg |
    | q6    | 0.072 | 0    |   0    |
}

#[test]
fn the_limit_of_the_reach_is_that_of_the_arm_however_far_the_target() {
    let ahead = |x: f64| Target::translation(x, 0.0, 0.6);
    for far in [1.3, 3.0, 40.0] {
        let links = 0.315 + 0.035_f64.hypot(0.365);
        let said = limit(&KukaKr6R700, &ahead(far));
        assert!((said - links).abs() < 1e-9, "{far}: {said}, not {links}");
        let links = 0.27 + 0.07_f64.hypot(0.302);
        let said = limit(&Straight, &ahead(far));
        assert!((said - links).abs() < 1e-9, "{far}: {said}, not {links}");
    }
}
