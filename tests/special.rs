//! Special poses of the example robots: what `inverse` computes there is bounded and complete, and `inverse_near` goes on without a jump.

use dh_robot::nalgebra::{DMatrix, IsometryMatrix3};
use dh_robot::{FreeJoints, InverseKinematics, Stop, Why, Work, follow};
use dh_tests::sample::Random;
use generated_examples::{kuka_kr6_r700::KukaKr6R700, panda::Panda, puma560::Puma560, stanford::Stanford, ur5::Ur5};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

type Pose = IsometryMatrix3<f64>;

/// An arm as closures over vectors.
struct Case {
    name: &'static str,
    n: usize,
    /// The joint that the caller gives.
    given: Option<usize>,
    /// Joints and the values at which the arm is singular.
    singular: &'static [(usize, f64)],
    most: Work,
    forward: fn(&[f64]) -> Pose,
    jacobian: fn(&[f64]) -> DMatrix<f64>,
    inverse: fn(&Pose, &[f64]) -> (List, Work),
    exhaustive: fn(&Pose, &[f64]) -> List,
    near: Near,
}

type List = Vec<(Vec<f64>, FreeJoints)>;
/// Target, what is given and present joints to the joints of `inverse_near`.
type Near = fn(&Pose, &[f64], &[f64]) -> Option<Vec<f64>>;

fn array<const N: usize>(q: &[f64]) -> [f64; N] {
    std::array::from_fn(|k| q[k])
}

macro_rules! case {
    ($name:literal, $robot:ty, $n:literal, $given:expr, $singular:expr, |$q:ident| ($($value:expr)?)) => {
        Case {
            name: $name,
            n: $n,
            given: $given,
            singular: $singular,
            most: <$robot>::MAX_WORK,
            forward: |q| <$robot>::default().forward(&array::<$n>(q)),
            jacobian: |q| {
                let j = <$robot>::default().jacobian(&array::<$n>(q));
                DMatrix::from_fn(6, $n, |i, k| j[(i, k)])
            },
            inverse: |t, $q| {
                let _ = $q;
                let (list, work) = <$robot>::default().inverse_with_work(t $(, $value)?);
                (list.iter().map(|s| (s.q.to_vec(), s.free)).collect(), work)
            },
            exhaustive: |t, $q| {
                let _ = $q;
                <$robot>::default().inverse_exhaustive(t $(, $value)?).iter().map(|s| (s.q.to_vec(), s.free)).collect()
            },
            near: |t, $q, from| {
                let _ = $q;
                let found = <$robot>::default().inverse_near(t $(, $value)?, &array::<$n>(from));
                found.ok().map(|s| s.q.to_vec())
            },
        }
    };
}

fn cases() -> [Case; 5] {
    [
        case!("PUMA", Puma560, 6, None, &[(4, 0.0), (2, -1.523_818_410_446_813_6)], |q| ()),
        case!("KR 6", KukaKr6R700, 6, None, &[(4, 0.0), (2, -1.475_198_208_131_056_2)], |q| ()),
        case!("UR5", Ur5, 6, None, &[(4, 0.0), (2, 0.0)], |q| ()),
        case!("Stanford", Stanford, 6, None, &[(4, 0.0)], |q| ()),
        case!("Panda", Panda, 7, Some(6), &[], |q| (q[6])),
    ]
}

fn wrapped(x: f64) -> f64 {
    x - TAU * (x / TAU).round()
}

fn apart(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| wrapped(x - y).abs()).fold(0.0, f64::max)
}

/// Does a solution stand for these joint values: all but its free joints agree?
fn stands_for((s, free): &(Vec<f64>, FreeJoints), q: &[f64]) -> bool {
    (0..q.len()).all(|k| free.contains(k) || wrapped(s[k] - q[k]).abs() < 1e-4)
}

impl Case {
    fn random(&self, r: &mut Random) -> Vec<f64> {
        let slides = |k: usize| self.name == "Stanford" && k == 2;
        (0..self.n).map(|k| if slides(k) { 0.6 + 0.3 * r.signed() } else { PI * r.signed() }).collect()
    }

    /// Joint values at quarter turns.
    fn quarters(&self, r: &mut Random) -> Vec<f64> {
        let quarter = |x: f64| FRAC_PI_2 * (2.0 * x).round();
        let mut q: Vec<f64> = (0..self.n).map(|_| quarter(r.signed())).collect();
        if self.name == "Stanford" {
            q[2] = 0.5;
        }
        q
    }

    /// Joint values with one singular joint, then beside that by `size`.
    fn singular(&self, r: &mut Random, size: f64) -> Option<Vec<f64>> {
        let mut q = self.random(r);
        let (k, value) = *self.singular.get((10.0 * r.signed().abs()) as usize % self.singular.len().max(1))?;
        q[k] = value;
        for (k, x) in q.iter_mut().enumerate().filter(|(k, _)| self.given != Some(*k)) {
            *x += size * (1.0 + 0.1 * k as f64) * r.signed();
        }
        Some(q)
    }

    /// The least singular value of the Jacobian's columns that move.
    fn sigma(&self, q: &[f64]) -> f64 {
        let columns: Vec<usize> = (0..self.n).filter(|k| self.given != Some(*k)).collect();
        let j = (self.jacobian)(q);
        let m = DMatrix::from_fn(6, columns.len(), |i, k| j[(i, columns[k])]);
        m.svd(false, false).singular_values.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// Poses of every kind: random ones, quarter turns, singular ones and beside these.
    fn poses(&self, count: usize, seed: u64) -> Vec<Vec<f64>> {
        let mut r = Random::new(seed);
        let mut all = Vec::new();
        for i in 0..count {
            all.push(self.random(&mut r));
            all.push(self.quarters(&mut r));
            all.extend(self.singular(&mut r, 0.0));
            all.extend(self.singular(&mut r, 10_f64.powi(-3 - (i % 10) as i32)));
        }
        all
    }
}

#[test]
fn the_inverse_is_bounded_at_every_pose() {
    for case in cases() {
        let mut seen = Work::NONE;
        for q in case.poses(60, 3) {
            let target = (case.forward)(&q);
            for shift in [0.0, 1e-9, 1e-5, 1e-2, 0.3] {
                let mut beyond = target;
                beyond.translation.vector *= 1.0 + shift;
                let (_, work) = (case.inverse)(&beyond, &q);
                seen = seen.or_more(work);
                let within = work.runs <= case.most.runs && work.steps <= case.most.steps;
                assert!(within && work.evaluations <= case.most.evaluations, "{} {q:?}: {work:?}", case.name);
            }
        }
        assert!(seen.runs > 1 && seen.steps > 0, "{}: nothing special was met", case.name);
    }
}

#[test]
fn regular_solutions_are_those_of_the_exhaustive_search_and_the_own_joints_are_among_them() {
    for case in cases() {
        for q in case.poses(12, 5) {
            let target = (case.forward)(&q);
            let (found, _) = (case.inverse)(&target, &q);
            assert!(found.iter().any(|s| stands_for(s, &q)), "{}: {q:?} is not among {found:?}", case.name);
            for known in (case.exhaustive)(&target, &q).iter().filter(|s| s.1.is_empty()) {
                if case.sigma(&known.0) > 1e-5 {
                    let again = found.iter().any(|s| stands_for(s, &known.0));
                    assert!(again, "{} at {q:?}: {known:?} is not among {found:?}", case.name);
                }
            }
        }
    }
}

#[test]
fn joints_nearby_are_gone_back_to_from_everywhere() {
    for case in cases() {
        let mut r = Random::new(7);
        for q in case.poses(80, 9) {
            let away = |(k, x): (usize, &f64)| if case.given == Some(k) { *x } else { x + 1e-3 * r.signed() };
            let from: Vec<f64> = q.iter().enumerate().map(away).collect();
            let found = (case.near)(&(case.forward)(&q), &q, &from);
            let near = found.as_ref().is_some_and(|x| apart(x, &q) < 0.1);
            assert!(near, "{}: from {from:?} to {found:?} instead of {q:?}", case.name);
        }
    }
}

#[test]
fn paths_through_singular_poses_do_not_jump() {
    for case in cases() {
        let mut r = Random::new(11);
        for _ in 0..40 {
            let Some(q) = case.singular(&mut r, 0.0) else { continue };
            let speed: Vec<f64> = q.iter().map(|_| r.signed()).collect();
            let at = |t: f64| -> Vec<f64> { q.iter().zip(&speed).map(|(a, b)| a + t * b).collect() };
            let mut joints = at(-0.1);
            for k in -19..=20 {
                let x = at(0.005 * f64::from(k));
                let next = (case.near)(&(case.forward)(&x), &x, &joints);
                let next = next.unwrap_or_else(|| panic!("{} is lost at {x:?}", case.name));
                assert!(apart(&next, &joints) < 0.1, "{} jumps from {joints:?} to {next:?} through {q:?}", case.name);
                joints = next;
            }
        }
    }
}

#[test]
fn self_motions_leave_the_tool_where_it_is() {
    let robot = Puma560::default();
    let target = robot.forward(&[0.3, -0.8, 0.4, 0.9, 0.0, -0.5]);
    let list = robot.inverse(&target);
    let straight = list.iter().find(|s| !s.free.is_empty()).expect("the wrist is straight");
    let along = robot.self_motion(straight).expect("it can turn");
    let moved = std::array::from_fn(|k| straight.q[k] + 0.7 * along[k]);
    let pose = robot.forward(&moved);
    assert!((pose.to_homogeneous() - target.to_homogeneous()).abs().max() < 1e-12);
    assert_eq!(robot.self_motion(list.iter().find(|s| s.free.is_empty()).expect("others are regular")), None);
}

#[test]
fn a_path_is_followed_to_where_the_arm_ends() {
    let robot = Puma560::default();
    let start = [0.1, -0.6, 0.5, 0.2, 0.4, -0.3];
    let from = robot.forward(&start);
    let line = |k: i32| {
        let mut pose = from;
        pose.translation.vector *= 1.0 + 0.002 * f64::from(k);
        pose
    };
    let mut steps = 0;
    let mut end = None;
    for item in follow(&robot, (0..1000).map(line), start, 0.2) {
        match item {
            Ok(_) => steps += 1,
            Err(stop) => end = Some(stop),
        }
    }
    assert!(steps > 20, "{steps} {end:?}");
    assert!(
        matches!(end, Some(Stop::Unreachable(Why::OutOfReach { unit: "m", .. }) | Stop::OutOfRange { .. })),
        "{end:?}"
    );
}

#[test]
fn joint_values_that_are_no_numbers_are_refused() {
    let (puma, panda) = (Puma560::default(), Panda);
    let q = [0.1, -0.6, 0.5, 0.2, 0.4, -0.3];
    let target = puma.forward(&q);
    for bad in [f64::NAN, f64::INFINITY] {
        assert_eq!(puma.inverse_near(&target, &[bad; 6]).map(|s| s.q), Err(Why::NotFinite));
        assert_eq!(panda.inverse(&target, bad).why(), Why::NotFinite);
        assert_eq!(panda.inverse_near(&target, bad, &[0.0; 7]).map(|s| s.q), Err(Why::NotFinite));
        assert_eq!(puma.inverse(&target).toward(&[bad; 6]), None);
    }
    let far = InverseKinematics::inverse_near(&puma, &target, &[1e15; 6]);
    assert!(far.is_ok_and(|s| s.q.iter().all(|x| x.is_finite())));
}
