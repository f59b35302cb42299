//! There and back: every solution of the inverse reaches its target, and the joint values that made the target are among them.

use dh_robot::nalgebra::{IsometryMatrix3, Point3, UnitVector3};
use dh_robot::{InverseKinematics, Real, Solutions};
use dh_symbolic::chain::{ChainSpec, Task};
use dh_tests::engine::{invented, spec};
use dh_tests::sample::Random;

use crate::robots::robot;

/// What a robot is asked for, taken from a pose.
trait FromPose {
    fn from_pose(pose: &IsometryMatrix3<f64>) -> Self;
}

impl FromPose for IsometryMatrix3<f64> {
    fn from_pose(pose: &IsometryMatrix3<f64>) -> Self {
        *pose
    }
}

impl FromPose for Point3<f64> {
    fn from_pose(pose: &IsometryMatrix3<f64>) -> Self {
        pose.translation.vector.into()
    }
}

impl FromPose for (f64, f64, f64) {
    fn from_pose(pose: &IsometryMatrix3<f64>) -> Self {
        let (p, r) = (pose.translation.vector, pose.rotation.matrix());
        (p.x, p.y, r[(1, 0)].atan2(r[(0, 0)]))
    }
}

impl FromPose for (Point3<f64>, UnitVector3<f64>) {
    fn from_pose(pose: &IsometryMatrix3<f64>) -> Self {
        let z = pose.rotation.matrix().column(2).into_owned();
        (Point3::from_pose(pose), UnitVector3::new_normalize(z))
    }
}

/// How far a pose is from what was asked for.
pub(crate) fn miss(task: Task, pose: &IsometryMatrix3<f64>, target: &IsometryMatrix3<f64>, reach: f64) -> f64 {
    let apart = (pose.translation.vector - target.translation.vector).norm() / reach;
    let (a, b) = (pose.rotation.matrix(), target.rotation.matrix());
    apart
        + match task {
            Task::Position => 0.0,
            Task::Pose => (a - b).abs().max(),
            Task::Axis => (a.column(2) - b.column(2)).norm(),
            Task::Planar => (a.column(0) - b.column(0)).norm(),
        }
}

/// Joint values of all solutions, and which of them leave a joint free.
pub(crate) struct Found {
    pub(crate) q: Vec<Vec<f64>>,
    pub(crate) free: Vec<bool>,
    why: String,
    most: usize,
}

fn found<const N: usize, const M: usize>(solutions: &Solutions<f64, N, M>) -> Found {
    Found {
        q: solutions.iter().map(|s| s.q.to_vec()).collect(),
        free: solutions.iter().map(|s| !s.free.is_empty()).collect(),
        why: solutions.why().to_string(),
        most: M,
    }
}

/// Forward kinematics of some robot.
pub(crate) type ForwardFn = Box<dyn Fn(&[f64]) -> IsometryMatrix3<f64>>;
/// Its inverse, with the joints that made the target (for the one that the caller chooses).
pub(crate) type InverseFn = Box<dyn Fn(&IsometryMatrix3<f64>, &[f64]) -> Found>;

/// A robot's forward and inverse; the inverse also gets the joint values that made the pose, for the redundant joint.
pub(crate) struct Arm {
    pub(crate) module: &'static str,
    pub(crate) forward: ForwardFn,
    pub(crate) inverse: InverseFn,
}

macro_rules! inverse {
    (panda, $robot:ident) => {
        Box::new(move |pose, q| found(&$robot.inverse(pose, q[6])))
    };
    ($module:ident, $robot:ident) => {
        Box::new(move |pose, _| found(&InverseKinematics::inverse(&$robot, &FromPose::from_pose(pose))))
    };
}

macro_rules! arms {
    ($($module:ident $name:ident $dof:literal)*) => {
        pub(crate) fn arms() -> Vec<Arm> {
            vec![$({
                let arm = robot!($module, generated_examples::$module::$name);
                Arm {
                    module: stringify!($module),
                    forward: Box::new(move |q| arm.forward(q.try_into().expect("as many values as joints"))),
                    inverse: inverse!($module, arm),
                }
            }),*]
        }
    };
}

generated_examples::for_every_robot!(arms);

/// Joint values within half a turn; the ones of sliding joints within half a unit of length.
pub(crate) fn random_joints(spec: &ChainSpec, source: &mut Random) -> Vec<f64> {
    let moves = spec.rows.iter().filter_map(|row| row.moves.as_ref());
    moves.map(|m| source.signed() * if m.revolute { f64::PI } else { 0.5 }).collect()
}

/// Are these the same joint values, but for whole turns?
fn same(spec: &ChainSpec, a: &[f64], b: &[f64], reach: f64) -> bool {
    let moves = spec.rows.iter().filter_map(|row| row.moves.as_ref());
    moves.zip(a.iter().zip(b)).all(|(m, (a, b))| {
        let apart = a - b;
        let apart = if m.revolute { apart - f64::TAU * (apart / f64::TAU).round() } else { apart / reach };
        apart.abs() < 1e-6
    })
}

#[test]
fn solutions_reach_their_targets_and_none_is_missing() {
    let sources = generated_examples::source::all().expect("the examples can be read");
    for (arm, source) in arms().iter().zip(&sources) {
        assert_eq!(arm.module, source.module);
        let spec = spec(&source.body);
        let mut random = Random::new(7);
        for _ in 0..300 {
            let q = random_joints(&spec, &mut random);
            let target = (arm.forward)(&q);
            let reach = target.translation.vector.norm().max(0.1);
            let found = (arm.inverse)(&target, &q);
            let name = format!("{} at {q:?}", arm.module);
            assert!(found.q.len() <= found.most, "{name}: {} solutions of {}", found.q.len(), found.most);
            for (i, solution) in found.q.iter().enumerate() {
                let error = miss(spec.settings.task, &(arm.forward)(solution), &target, reach);
                assert!(error < 1e-9, "{name}: {solution:?} misses by {error:.1e}");
                let twice = found.q[..i].iter().any(|other| same(&spec, solution, other, reach));
                assert!(!twice, "{name}: {solution:?} twice");
            }
            let there = found.q.iter().any(|solution| same(&spec, solution, &q, reach));
            let free = found.free.iter().any(|free| *free);
            assert!(there || free, "{name}: not among {:?} ({})", found.q, found.why);
        }
    }
}

/// A pose out of reach has no solution, and the reason is a sentence. (Arms that slide reach everything in some direction.)
#[test]
fn targets_out_of_reach_are_refused_with_a_reason() {
    let sources = generated_examples::source::all().expect("the examples can be read");
    let turns = |body: &str| spec(body).rows.iter().all(|row| row.moves.as_ref().is_none_or(|m| m.revolute));
    for (arm, _) in arms().iter().zip(&sources).filter(|(_, source)| turns(&source.body)) {
        let found = (arm.inverse)(&IsometryMatrix3::translation(1e4, 2e4, 0.0), &[0.1; 8]);
        assert!(found.q.is_empty(), "{}: {:?}", arm.module, found.q);
        assert!(found.why.len() > 10, "{}: {}", arm.module, found.why);
    }
}

/// What is not a number, and what is not a rotation, has no solution either.
#[test]
fn bad_targets_are_refused() {
    for arm in arms() {
        let mut bad = IsometryMatrix3::translation(0.1, 0.2, 0.3);
        bad.translation.x = f64::NAN;
        let found = (arm.inverse)(&bad, &[0.1; 8]);
        assert!(found.q.is_empty() && !found.why.is_empty(), "{}: {:?}", arm.module, found.q);
    }
}
