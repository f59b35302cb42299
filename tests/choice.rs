//! Choosing among solutions: names of branches, ranges of every kind, the nearest solution.

use std::f64::consts::{PI, TAU};

use dh_robot::nalgebra::{IsometryMatrix3, Vector3};
use dh_robot::{
    Branch, Elbow, ForwardKinematics, InverseKinematics, Shoulder, Solution, SolutionList, Wrist, dh_robot,
};
use dh_tests::sample::Random;
use generated_examples::cup_arm::CupArm;
use generated_examples::kuka_kr6_r700::KukaKr6R700;
use generated_examples::panda::Panda;
use generated_examples::puma560::Puma560;
use generated_examples::six_axis_chain::SixAxisChain;
use generated_examples::stanford::Stanford;
use generated_examples::ur5::Ur5;

type Target = IsometryMatrix3<f64>;

dh_robot! {
    /// A wrist behind two parallel axes, with ranges of every kind.
    struct Ranges;

    convention = standard;

    | theta | d    | a    | alpha  | range            |
    | q1    | 0.4  | 0.1  | -90deg | 200deg..=560deg  |
    | q2    | 0    | 0.5  |   0    | -500deg..=-190deg|
    | q3    | 0    | 0.05 | -90deg | -400deg..=400deg |
    | q4    | 0.45 | 0    |  90deg | 0deg..=350deg    |
    | q5    | 0    | 0    | -90deg | -360deg..=0deg   |
    | q6    | 0.1  | 0    |   0    | 700deg..=900deg  |
}

dh_robot! {
    /// The same kinds of ranges, and one that slides, without a wrist.
    struct Mixed;

    convention = standard;

    | theta | d   | a   | alpha  | range           |
    | q1    | 0.4 | 0.3 |   0    | 170deg..=500deg |
    | q2    | 0   | 0.2 | 180deg | -                |
    | 0     | q3  | 0   |   0    | -0.9..=-0.2      |
    | q4    | 0.1 | 0   |   0    | -190deg..=170deg |
}

fn same<const N: usize>(arm: &impl ForwardKinematics<N>, a: &[f64; N], b: &[f64; N], tolerance: f64) -> bool {
    arm.joints().iter().zip(a.iter().zip(b)).all(|(joint, (a, b))| joint.difference(*a, *b) < tolerance)
}

/// Names that a controller asks for, without the numbers of roots.
fn names(branch: Branch) -> Branch {
    let mut named = Branch::ANY;
    if let Some(x) = branch.shoulder() {
        named = named.with_shoulder(x);
    }
    if let Some(x) = branch.elbow() {
        named = named.with_elbow(x);
    }
    if let Some(x) = branch.wrist() {
        named = named.with_wrist(x);
    }
    named
}

/// Every solution of a pose can be asked for by its names alone, and keeps them while the arm moves a little.
fn named<const N: usize>(arm: &(impl ForwardKinematics<N> + InverseKinematics<N, Target = Target>)) {
    let mut random = Random::new(17);
    let mut moved = 0;
    for _ in 0..60 {
        let q = arm.joints().each_ref().map(|j| random.signed() * if j.is_revolute() { PI } else { 0.5 });
        let found = arm.inverse(&arm.forward(&q));
        for (i, solution) in found.iter().enumerate() {
            let wanted = names(solution.branch);
            assert!(!found[..i].iter().any(|s| names(s.branch) == wanted), "{q:?}: {wanted} twice in\n{found}");
            assert_eq!(found.with_branch(wanted), Some(solution), "{q:?}");
            // Another pose near by: the neighbour has the same names, unless a branch ends between.
            let near = solution.q.map(|x| x + 1e-6);
            let then = arm.inverse(&arm.forward(&near));
            let neighbour = then.iter().find(|s| same(arm, &s.q, &near, 1e-7));
            assert!(neighbour.is_some(), "{near:?}: not among\n{then}");
            moved += usize::from(neighbour.is_some_and(|s: &Solution<f64, N>| names(s.branch) == wanted));
        }
        if found.len() == arm.max_solutions() {
            continue;
        }
        assert!(!found.is_empty(), "{q:?}: {}", found.why());
    }
    assert!(moved >= 60, "{moved}");
}

/// What an arm looks like: the frames whose origins are waist (none: the base), shoulder, elbow and wrist, the one whose origin the arm faces,
/// the frame whose z axis is that of the shoulder, and which of shoulder, elbow and wrist the frames show.
struct Look {
    waist: Option<usize>,
    faces: usize,
    points: [usize; 3],
    across: usize,
    named: [bool; 3],
}

const ALL: [bool; 3] = [true; 3];

/// Looks whether names say what the frames show. `solve` are the solutions at the pose of some joint values, `middle` the angle of the middle
/// wrist joint as the table has it.
fn shown<const N: usize>(
    name: &str,
    solve: impl Fn(&[f64; N]) -> Vec<Solution<f64, N>>,
    frames: impl Fn(&[f64; N]) -> [Target; N],
    look: &Look,
    middle: impl Fn(&[f64; N]) -> f64,
) {
    let mut random = Random::new(8);
    let mut seen = 0;
    for _ in 0..60 {
        let q: [f64; N] = std::array::from_fn(|_| PI * random.signed());
        for solution in &solve(&q) {
            let frames = frames(&solution.q);
            let waist = look.waist.map_or(Vector3::zeros(), |k| frames[k].translation.vector);
            let [shoulder, elbow, wrist] = look.points.map(|k| frames[k].translation.vector - waist);
            let up = Vector3::z();
            let across = frames[look.across].rotation * Vector3::z();
            let level = across.cross(&up).normalize();
            let hand = frames[look.faces].translation.vector - waist;
            let facing = level * hand.dot(&level).signum();
            let left = up.cross(&facing);
            let aside = hand.dot(&left);
            // Without a shoulder offset: the wrist is ahead, where the first frame's x axis points.
            let first = frames[look.waist.unwrap_or(0)].rotation * Vector3::x();
            let is_left = if aside.abs() > 1e-9 { aside > 0.0 } else { hand.dot(&first) > 0.0 };
            let (e, w) = (elbow - shoulder, wrist - shoulder);
            let is_up = e.dot(&up) * w.dot(&facing) > e.dot(&facing) * w.dot(&up);
            let is_positive = middle(&solution.q).sin() > 0.0;
            let side = if is_left { Shoulder::Left } else { Shoulder::Right };
            let height = if is_up { Elbow::Up } else { Elbow::Down };
            let turn = if is_positive { Wrist::NoFlip } else { Wrist::Flip };
            let branch = solution.branch;
            let [s, e, w] = look.named;
            assert_eq!(
                (branch.shoulder().filter(|_| s), branch.elbow().filter(|_| e), branch.wrist().filter(|_| w)),
                (s.then_some(side), e.then_some(height), w.then_some(turn)),
                "{name}: {solution}"
            );
            seen += 1;
        }
    }
    assert!(seen > 100, "{seen}");
}

dh_robot! {
    /// The KUKA KR 6 as its maker's frames have it: the first axis points down.
    struct Flipped;

    convention = modified;
    base = tx(0.3) * rz(40deg);

    | alpha  | a     | d      | theta      |
    | 180deg | 0     | -0.4   | q1         |
    |  90deg | 0.025 | 0      | q2         |
    |   0    | 0.315 | 0      | q3 - 90deg |
    |  90deg | 0.035 | -0.365 | q4         |
    | -90deg | 0     | 0      | q5         |
    |  90deg | 0     | -0.08  | q6 + 180deg |
}

dh_robot! {
    /// The same kind of arm on a track whose place the program chooses.
    struct OnTrack;

    convention = modified;
    redundant = q1;

    | alpha  | a     | d     | theta |
    |  90deg | 0     | q1    | 0     |
    | -90deg | 0     | 0.4   | q2    |
    | -90deg | 0.025 | 0     | q3    |
    |   0    | 0.455 | 0     | q4    |
    | -90deg | 0.035 | 0.42  | q5    |
    |  90deg | 0     | 0     | q6    |
    | -90deg | 0     | 0.08  | q7    |
}

dh_robot! {
    /// A painting robot's hollow wrist: its axes meet at 60 degrees. The shoulder is behind the waist.
    struct Painter;

    convention = standard;

    | theta | d   | a    | alpha  |
    | q1    | 0.7 | -0.2 | -90deg |
    | q2    | 0.1 | 0.9  |   0    |
    | q3    | 0   | 0.1  | -90deg |
    | q4    | 1.1 | 0    |  60deg |
    | q5 + 30deg | 0 | 0 | -60deg |
    | q6    | 0.1 | 0    |   0    |
}

dh_robot! {
    /// Seven axes; the program chooses how the elbow turns.
    struct Seven;

    convention = standard;
    redundant = q3;

    | theta | d    | a | alpha  |
    | q1    | 0.36 | 0 | -90deg |
    | q2    | 0    | 0 |  90deg |
    | q3    | 0.42 | 0 |  90deg |
    | q4    | 0    | 0 | -90deg |
    | q5    | 0.4  | 0 | -90deg |
    | q6    | 0    | 0 |  90deg |
    | q7    | 0.12 | 0 |   0    |
}

/// `shown` for an arm whose inverse takes a pose alone.
macro_rules! shown {
    ($arm:expr, $look:expr, $middle:expr) => {{
        let arm = $arm;
        shown(stringify!($arm), |q| arm.inverse(&arm.forward(q)).to_vec(), |q| arm.frames(q), &$look, $middle);
    }};
}

#[test]
fn names_of_branches_say_what_the_frames_show() {
    let craig = Look { waist: None, faces: 3, points: [1, 2, 3], across: 1, named: ALL };
    let standard = Look { waist: None, faces: 3, points: [0, 1, 3], across: 0, named: ALL };
    shown!(Puma560::default(), craig, |q| q[4]);
    shown!(KukaKr6R700, standard, |q| q[4]);
    shown!(Ur5, Look { faces: 4, ..standard }, |q| q[4]);
    shown!(Painter, standard, |q| q[4] + PI / 6.0);
    shown!(Stanford, Look { points: [0, 0, 3], named: [true, false, true], ..standard }, |q| q[4]);
    shown!(Flipped, Look { waist: Some(0), ..craig }, |q| q[4]);
    let track = Look { waist: Some(1), faces: 4, points: [2, 3, 4], across: 2, named: ALL };
    shown("OnTrack", |q| OnTrack.inverse(&OnTrack.forward(q), q[0]).to_vec(), |q| OnTrack.frames(q), &track, |q| q[5]);
}

/// Names alone tell the solutions apart, also where a joint is given.
#[test]
fn names_of_branches_tell_solutions_apart_where_a_joint_is_given() {
    let mut random = Random::new(18);
    for _ in 0..40 {
        let q: [f64; 7] = std::array::from_fn(|_| PI * random.signed());
        for found in [
            Seven.inverse(&Seven.forward(&q), q[2]),
            OnTrack.inverse(&OnTrack.forward(&q), q[0]),
            Panda.inverse(&Panda.forward(&q), q[6]),
        ] {
            for (i, solution) in found.iter().enumerate() {
                let wanted = names(solution.branch);
                assert!(!found[..i].iter().any(|s| names(s.branch) == wanted), "{q:?}: {wanted} twice in\n{found}");
                let wrist = if solution.q[5].sin() > 0.0 { Wrist::NoFlip } else { Wrist::Flip };
                let is_panda = found.joints() == &Panda::JOINTS;
                assert!(is_panda || solution.branch.wrist() == Some(wrist), "{solution}");
            }
        }
    }
}

#[test]
fn names_of_branches_tell_all_solutions_apart_and_stay() {
    named(&Puma560::default());
    named(&KukaKr6R700);
    named(&CupArm);
    named(&Stanford);
    named(&Ur5);
    named(&SixAxisChain::default());
}

/// What is in range is found there, and everything stands where its range wants it.
fn ranged<const N: usize>(arm: &(impl ForwardKinematics<N> + InverseKinematics<N, Target = Target>)) {
    let mut random = Random::new(23);
    let joints = arm.joints();
    for i in 0..300 {
        let q = joints.each_ref().map(|j| {
            let (least, greatest) = j.range.unwrap_or((-PI, PI));
            let x = least + 0.5 * (random.signed() + 1.0) * (greatest - least);
            match (i % 3, j.is_revolute()) {
                (0, _) | (_, false) => x,
                // Quarter turns, and limits.
                (1, _) => ((x / (0.5 * PI)).round() * 0.5 * PI).clamp(least, greatest),
                _ => {
                    if random.signed() > 0.0 {
                        least
                    } else {
                        greatest
                    }
                }
            }
        });
        let found = arm.inverse(&arm.forward(&q));
        for s in found.iter() {
            for (joint, x) in joints.iter().zip(&s.q) {
                assert!((joint.normalize(*x) - x).abs() < 1e-9, "{q:?}: {x} of {joint:?}");
            }
        }
        let kept = found.within_range();
        for s in kept.iter() {
            assert!(joints.iter().zip(&s.q).all(|(j, x)| j.range.is_none_or(|(l, g)| l <= *x && *x <= g)), "{s}");
        }
        // One solution represents a self-motion, which may be out of range.
        let own = kept.iter().any(|s| same(arm, &s.q, &q, 1e-5)) || found.iter().any(|s| !s.free.is_empty());
        assert!(own, "{q:?} is not among\n{kept}\nof\n{found}");
        // Where the arm is, it stays; a small motion goes the short way where the range allows it.
        if i % 3 == 0 {
            let from = q.map(|x| x + 1e-3);
            let (near, to) = (found.closest_to(&from).unwrap(), found.toward(&from).unwrap());
            assert!(same(arm, &near.q, &q, 1e-6), "{q:?}: the nearest is {near}");
            assert!(q.iter().zip(&to.q).all(|(a, b)| (a - b).abs() < 1e-6), "{q:?}: the way leads to {to}");
        }
    }
}

#[test]
fn a_continuum_is_represented_within_the_ranges_where_it_passes_through_them() {
    let mut random = Random::new(29);
    for _ in 0..60 {
        let mut q = Ranges::JOINTS.each_ref().map(|j| {
            let (least, greatest) = j.range.unwrap_or((-PI, PI));
            // A little inside.
            0.5 * (least + greatest) + 0.49 * random.signed() * (greatest - least)
        });
        // The wrist is stretched: axes 4 and 6 turn against each other.
        q[4] = 0.0;
        let found = Ranges.inverse(&Ranges.forward(&q));
        let kept = found.within_range();
        let same = |k: usize, a: f64| Ranges::JOINTS[k].difference(a, q[k]) < 1e-6;
        let own = kept.iter().any(|s| !s.free.is_empty() && (0..3).all(|k| same(k, s.q[k])));
        assert!(own, "{q:?} is not among\n{kept}\nof\n{found}");
    }
}

#[test]
fn ranges_of_every_kind_are_kept() {
    ranged(&Ranges);
    ranged(&Mixed);
    // A whole turn leads out of the first range and into the second.
    let arm = Ranges;
    let inside = arm.inverse(&arm.forward(&[4.0, -4.0, 0.5, 1.0, -1.0, 13.0]));
    assert!(inside.within_range().iter().all(|s| s.q[0] > 3.49 && s.q[1] < -3.31 && s.q[5] > 2.0 * TAU - 0.4));
}
