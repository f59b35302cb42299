//! The fast path of generated inverses against the fallback path, which generated code has beside it: both must find the same solutions, at
//! random poses, in and near singular ones, and out of reach.

mod arms;

use std::f64::consts::{FRAC_PI_2, PI};

use dh_robot::nalgebra::{IsometryMatrix3, Translation3};
use dh_robot::{ForwardKinematics, Jacobian, Solutions};
use dh_tests::sample::Random;

type Target = IsometryMatrix3<f64>;

/// Random poses of each arm.
const POSES: usize = 150;
/// How far from a singular value a joint is.
const OFFSETS: [f64; 5] = [0.0, 1e-9, -1e-6, 1e-4, -1e-3];

/// A generated robot.
trait Arm<const N: usize>: ForwardKinematics<N> + Jacobian<N> {}

impl<const N: usize, A: ForwardKinematics<N> + Jacobian<N>> Arm<N> for A {}

/// Runs all sets of poses of an arm. `both` finds the solutions of a pose, the fast path and the fallback path; joints that the caller of a
/// redundant arm chooses stand as in the configuration.
fn check<const N: usize, const M: usize>(
    name: &str,
    arm: &impl Arm<N>,
    both: impl Fn(&Target, &[f64; N]) -> [Solutions<f64, N, M>; 2],
) {
    let mut random = Random::new(5);
    let mut joints = || arm.joints().each_ref().map(|j| random.signed() * if j.is_revolute() { PI } else { 0.5 });
    // The two ways list the branches in different orders.
    let (mut told_apart, mut fast_ones) = (0, 0);
    for _ in 0..POSES {
        let q = joints();
        let target = arm.forward(&q);
        let [fast, slow] = both(&target, &q);
        compare(name, arm, &q, &target, [&fast, &slow], 1e-9);
        let there = fast.iter().any(|s| apart(arm, &s.q, &q) < 1e-8);
        assert!(there, "{name}: {q:?} is not among {fast}");
        if fast.len() == M && M > 2 {
            told_apart += 1;
            fast_ones += usize::from(fast.iter().zip(&slow).any(|(a, b)| apart(arm, &a.q, &b.q) > 1e-3));
        }
    }
    assert!(10 * fast_ones >= 9 * told_apart, "{name}: the fast path decides {fast_ones} poses of {told_apart}");
    for q in special(arm, &mut joints) {
        let target = arm.forward(&q);
        let [fast, slow] = both(&target, &q);
        assert!(!fast.is_empty(), "{name}: nothing at {q:?} ({})", fast.why());
        compare(name, arm, &q, &target, [&fast, &slow], 1e-4);
    }
    // Far away nothing is reached, unless something slides there.
    for _ in 0..20 {
        let q = joints();
        let pose = arm.forward(&q);
        for factor in [1.05, 1.5, 20.0] {
            let target = Target::from_parts(Translation3::from(pose.translation.vector * factor), pose.rotation);
            let [fast, slow] = both(&target, &q);
            compare(name, arm, &q, &target, [&fast, &slow], 1e-6);
        }
    }
}

/// Joint values in and near singular configurations: every joint at a quarter turn; and where the Jacobian's determinant vanishes as one
/// joint turns (wrist, elbow, shoulder, whatever they are).
fn special<const N: usize>(arm: &impl Arm<N>, joints: &mut impl FnMut() -> [f64; N]) -> Vec<[f64; N]> {
    let mut all = Vec::new();
    for k in (0..N).filter(|k| arm.joints()[*k].is_revolute()) {
        for value in [0.0, FRAC_PI_2, -FRAC_PI_2, PI] {
            for offset in OFFSETS {
                let mut q = joints();
                q[k] = value + offset;
                all.push(q);
            }
        }
        let q = joints();
        let at = |x: f64| {
            let mut q = q;
            q[k] = x;
            q
        };
        let det = |x: f64| {
            let j = arm.jacobian(&at(x));
            if N == 6 { j.fixed_resize::<6, 6>(0.0).determinant() } else { 1.0 }
        };
        for i in 0..24 {
            let (mut low, mut high) = ((f64::from(i) - 12.0) * PI / 12.0, (f64::from(i) - 11.0) * PI / 12.0);
            if det(low).abs() < 1e-12 || (det(low) < 0.0) == (det(high) < 0.0) {
                continue;
            }
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if (det(middle) < 0.0) == (det(low) < 0.0) { low = middle } else { high = middle }
            }
            all.extend(OFFSETS.map(|offset| at(low + offset)));
        }
    }
    all
}

/// The greatest difference of two joint vectors, whole turns apart.
fn apart<const N: usize>(arm: &impl ForwardKinematics<N>, a: &[f64; N], b: &[f64; N]) -> f64 {
    let pairs = arm.joints().iter().zip(a.iter().zip(b));
    pairs.map(|(joint, (a, b))| joint.difference(*a, *b)).fold(0.0, f64::max)
}

/// Everything reaches the target, nothing stands twice, and both have the same (but for rounding, which near a singular pose is large).
fn compare<const N: usize, const M: usize>(
    name: &str,
    arm: &impl Arm<N>,
    q: &[f64; N],
    target: &Target,
    [fast, slow]: [&Solutions<f64, N, M>; 2],
    near: f64,
) {
    let free = fast.iter().chain(slow).any(|s| !s.free.is_empty());
    if free {
        assert_eq!(fast.is_empty(), slow.is_empty(), "{name} at {q:?}: {fast}; {slow}");
    } else {
        assert_eq!(fast.len(), slow.len(), "{name} at {q:?}: {fast}\n{slow}");
    }
    if fast.is_empty() {
        assert_eq!(fast.why(), slow.why(), "{name} at {q:?}");
    }
    for (i, solution) in fast.iter().enumerate() {
        for other in &fast[..i] {
            assert!(apart(arm, &solution.q, &other.q) > 1e-7, "{name} at {q:?}: twice {solution}");
        }
        let known = slow.iter().any(|s| apart(arm, &s.q, &solution.q) < near && s.branch == solution.branch);
        assert!(known || free, "{name} at {q:?}: only fast {solution}, branch {:?}; slow {slow}", solution.branch);
        for (joint, value) in arm.joints().iter().zip(&solution.q) {
            assert_eq!(joint.normalize(*value), *value, "{name}: {solution} is not where {joint:?} wants it");
        }
    }
    for solution in fast.iter().chain(slow) {
        let reached = arm.forward(&solution.q);
        let turned = (reached.rotation.matrix() - target.rotation.matrix()).abs().max();
        let moved = (reached.translation.vector - target.translation.vector).norm();
        assert!(turned < 1e-9 && moved < 1e-9, "{name} at {q:?}: {solution} misses by {turned:.1e}, {moved:.1e}");
    }
}
