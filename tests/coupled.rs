//! Coupled drives end to end: gears, motors that turn and lift together, parallelograms, their coefficients as fields, ranges of motors.

use std::f64::consts::{PI, TAU};

use dh_robot::nalgebra::IsometryMatrix3;
use dh_robot::{ForwardKinematics, InverseKinematics, Jacobian, SolutionList, dh_robot};
use dh_tests::sample::Random;

type Target = IsometryMatrix3<f64>;

dh_robot! {
    /// Gears in the wrist: whole turns of its rows are no whole turns of its motors.
    struct Gears;

    convention = standard;
    let g: length = 0.75;

    | theta               | d    | a    | alpha  | range            |
    | q1                  | 0.4  | 0.1  | -90deg | 200deg..=560deg  |
    | 0.5*q2              | 0    | 0.5  |   0    | 0deg..=720deg    |
    | q3 - 0.5*q2 - 30deg | 0    | 0.05 | -90deg | -180deg..=180deg |
    | 2*q4                | 0.45 | 0    |  90deg | 100deg..=280deg  |
    | q5 - 2*q4           | 0    | 0    | -90deg | -200deg..=200deg |
    | q6 + g*q5           | 0.1  | 0    |   0    | -900deg..=-500deg |
}

dh_robot! {
    /// A nut and a spline on one spindle: the motors turn and lift together.
    struct Spindle;

    convention = standard;
    let p: length;

    | theta   | d           | a   | alpha | range        |
    | q1      | 0.3         | 0.4 | 0     | -            |
    | q2 + q3 | 0           | 0.3 | 0     | -            |
    | 0       | p*(q3 - q2) | 0   | 0     | 20.0..=24.0 |
    | q4 + q2 | 0           | 0   | 0     | -            |
}

dh_robot! {
    /// A SCARA with a ball screw and a spline: the last motor lifts while it turns.
    struct Screw;

    convention = standard;

    | theta | d               | a    | alpha  |
    | q1    | 0               | 0.25 |   0    |
    | q2    | 0               | 0.3  | 180deg |
    | 0     | q3 + 0.00398*q4 | 0    |   0    |
    | q4    | 0               | 0    |   0    |
}

#[test]
fn rows_without_ranges_turn_by_less_than_a_turn() {
    // A whole turn of the last motor is a stroke of the third: of all these solutions it is the one without whole turns.
    for q in vectors(&Screw, 60) {
        let found = Screw.inverse(&Screw.forward(&q));
        let own = found.iter().any(|s| s.q.iter().zip(&q).all(|(a, b)| (a - b).abs() < 1e-7));
        let edge = q.iter().any(|x| PI - x.abs() < 1e-9);
        assert!(own || edge || found.iter().any(|s| !s.free.is_empty()), "{q:?} is not among {found}");
        assert!(found.iter().all(|s| s.q[3].abs() < PI + 1e-9), "{found}");
    }
}

/// What rows of the tables above turn or slide by, without offsets: (turns, coefficients).
type Rows<const N: usize> = [(bool, [f64; N]); N];

fn gears(g: f64) -> Rows<6> {
    [
        (true, [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]),
        (true, [0.0, 0.5, 0.0, 0.0, 0.0, 0.0]),
        (true, [0.0, -0.5, 1.0, 0.0, 0.0, 0.0]),
        (true, [0.0, 0.0, 0.0, 2.0, 0.0, 0.0]),
        (true, [0.0, 0.0, 0.0, -2.0, 1.0, 0.0]),
        (true, [0.0, 0.0, 0.0, 0.0, g, 1.0]),
    ]
}

fn spindle(p: f64) -> Rows<4> {
    [
        (true, [1.0, 0.0, 0.0, 0.0]),
        (true, [0.0, 1.0, 1.0, 0.0]),
        (false, [0.0, -p, p, 0.0]),
        (true, [0.0, 1.0, 0.0, 1.0]),
    ]
}

/// The greatest difference of two joint vectors, by their rows and without whole turns of them.
fn apart<const N: usize>(rows: &Rows<N>, a: &[f64; N], b: &[f64; N]) -> f64 {
    let one = |(turns, k): &(bool, [f64; N])| {
        let x: f64 = (0..N).map(|j| k[j] * (b[j] - a[j])).sum();
        if *turns { (x - TAU * (x / TAU).round()).abs() } else { x.abs() }
    };
    rows.iter().map(one).fold(0.0, f64::max)
}

fn off(a: &Target, b: &Target) -> f64 {
    (a.to_homogeneous() - b.to_homogeneous()).abs().max()
}

/// Everything reaches the target, each solution stands once, and `q`, which is in range, is among those in range.
fn judge<const N: usize, A>(arm: &A, rows: &Rows<N>, q: &[f64; N]) -> A::Solutions
where
    A: ForwardKinematics<N> + InverseKinematics<N, Target = Target>,
{
    let target = arm.forward(q);
    let found = arm.inverse(&target);
    for (i, s) in found.iter().enumerate() {
        assert!(off(&arm.forward(&s.q), &target) < 1e-9, "{q:?}: {s} misses");
        let twice = found[..i].iter().any(|other| apart(rows, &s.q, &other.q) < 1e-4);
        assert!(!twice, "{q:?}: twice {s} in\n{found}");
    }
    let kept = found.within_range();
    // A double solution (the arm stretched or folded) is known to the square root of rounding only.
    let there = kept.iter().any(|s| apart(rows, &s.q, q) < 1e-5 || !s.free.is_empty());
    assert!(there, "{q:?} is not among\n{kept}\nof\n{found}");
    found
}

/// Joint values within the ranges; every other one puts the rows at quarter turns.
fn vectors<const N: usize>(arm: &impl ForwardKinematics<N>, count: usize) -> impl Iterator<Item = [f64; N]> {
    let ranges = arm.joints().each_ref().map(|j| j.range.unwrap_or((-PI, PI)));
    let mut random = Random::new(31);
    (0..count).map(move |i| {
        ranges.map(|(least, greatest)| {
            let x = least + 0.5 * (random.signed() + 1.0) * (greatest - least);
            let quarter = (x / (0.5 * PI)).round() * 0.5 * PI;
            if i % 2 == 0 || !(least..=greatest).contains(&quarter) { x } else { quarter }
        })
    })
}

#[test]
fn geared_motors_come_into_their_ranges_and_solutions_stand_once() {
    for g in [0.75, -1.3, 0.0] {
        let arm = Gears { g };
        let mut most = 0;
        for q in vectors(&arm, 150) {
            most = most.max(judge(&arm, &gears(g), &q).len());
        }
        assert_eq!(most, Gears::MAX_SOLUTIONS);
    }
}

#[test]
fn motors_that_turn_and_lift_together_keep_their_range() {
    for p in [0.02, -0.05] {
        let arm = Spindle { p };
        for q in vectors(&arm, 100) {
            judge(&arm, &spindle(p), &q);
        }
    }
    // A coupling that some value makes singular: no inverse, and nothing breaks.
    let stuck = Spindle { p: 0.0 };
    let found = stuck.inverse(&stuck.forward(&[0.1, 0.2, 0.3, 0.4]));
    assert!(found.is_empty() && found.why() != dh_robot::Why::Solved, "{found}");
}

#[test]
fn jacobians_of_coupled_drives_are_slopes_of_the_pose() {
    fn check<const N: usize>(arm: &(impl ForwardKinematics<N> + Jacobian<N>)) {
        for q in vectors(arm, 20) {
            let (pose, jacobian) = (arm.forward(&q), arm.jacobian(&q));
            for k in 0..N {
                let moved = |h: f64| arm.forward(&std::array::from_fn(|i| q[i] + if i == k { h } else { 0.0 }));
                let (a, b) = (moved(1e-5), moved(-1e-5));
                let linear = (a.translation.vector - b.translation.vector) / 2e-5;
                let w = (a.rotation.matrix() - b.rotation.matrix()) / 2e-5 * pose.rotation.matrix().transpose();
                let slopes = [linear.x, linear.y, linear.z, w[(2, 1)], w[(0, 2)], w[(1, 0)]];
                for (i, slope) in slopes.iter().enumerate() {
                    assert!((jacobian[(i, k)] - slope).abs() < 1e-7, "{q:?}: entry {i}, {k}");
                }
            }
        }
    }
    check(&Gears { g: -0.4 });
    check(&Spindle { p: 0.07 });
}
