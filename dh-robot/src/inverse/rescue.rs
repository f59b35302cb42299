//! Recovers solutions where the closed form degenerates: other values for free unknowns, nearby poses, and at last a multistart search.

use super::verifier::Verifier;
use super::{Attempt, Path, Sample};
use crate::{Branch, Real};
use dh_kernels::{Kinematics, Pose, pose};

/// Most damped Newton steps that bring a rough candidate onto the target.
const STEPS: usize = 60;
/// Starts of the search for an arm whose plan chooses a value that no closed form can judge.
const STARTS: usize = 60;

/// Prismatic values beyond this (over the length scale) come from a division by nearly zero.
const FAR: f64 = 20.0;

/// The first values for free unknowns, far from each other.
const FIRST_ROUND: usize = 11;
/// Further values for free unknowns that are always tried.
const PROBES: usize = 2;

/// Small motions in directions of no special kind.
const MOTIONS: [[f64; 6]; 6] = [
    [0.31, -0.77, 0.52, 0.63, 0.29, -0.71],
    [-0.83, 0.21, 0.47, -0.37, 0.88, 0.24],
    [0.59, 0.67, -0.43, 0.19, -0.53, 0.79],
    [-0.27, -0.61, -0.73, -0.91, -0.17, -0.41],
    [0.91, -0.13, 0.37, 0.43, 0.71, 0.57],
    [-0.49, 0.83, -0.23, 0.77, -0.67, 0.11],
];

/// Looks for the solutions that the first run of the plan did not give.
#[cold]
pub(super) fn rescue<A: Kinematics<N>, T: Real, const N: usize, const M: usize>(
    verifier: &mut Verifier<'_, A, T, N, M>,
    frame: &Pose,
    first: &Attempt,
    candidates: &impl Fn(&Pose, &Sample, &mut dyn FnMut([f64; N], Branch, Path)) -> Attempt,
) {
    rescue_by_candidates(verifier, frame, first, candidates);
    verifier.take_intersections();
    verifier.forget_copies();
}

/// Other values, nearby poses, a search.
fn rescue_by_candidates<A: Kinematics<N>, T: Real, const N: usize, const M: usize>(
    verifier: &mut Verifier<'_, A, T, N, M>,
    frame: &Pose,
    first: &Attempt,
    candidates: &impl Fn(&Pose, &Sample, &mut dyn FnMut([f64; N], Branch, Path)) -> Attempt,
) {
    let mut lost = verifier.lost || first.status.lost || verifier.out.is_empty();
    if first.status.degenerate {
        for (i, sample) in Sample::others().enumerate() {
            // Zero may be a special value: another one or two show whether it stands for all of them.
            if i >= PROBES && !lost {
                break;
            }
            verifier.news = false;
            let run = candidates(frame, &sample, &mut |q, branch, _| verifier.take_rough(q, branch, i >= FIRST_ROUND));
            lost |= verifier.news || run.status.lost;
        }
    }
    if !lost {
        return;
    }
    let mut doubt = first.status.degenerate || first.status.doubt;
    // Few joints cannot follow a motion of the target, but the equations of the plan hold well enough after a small one.
    for size in if verifier.setting.rank_deficient { [1e-6, 1e-4] } else { [1e-4, 1e-2] } {
        for (motion, nth) in MOTIONS.iter().zip(0..) {
            // A double root has two neighbours on one side and none on the other.
            for side in [1.0, -1.0] {
                let near = moved(frame, motion, side * size);
                let mut any = false;
                let run = candidates(&near, &Sample::nth(nth).thorough(), &mut |q, branch, _| {
                    any = true;
                    verifier.take_rough(q, branch, side < 0.0);
                });
                doubt |= any || run.status.degenerate;
            }
        }
    }
    if verifier.out.is_empty() && doubt || verifier.setting.rank_deficient && first.status.degenerate {
        search(verifier);
    }
    if verifier.out.is_empty() && doubt {
        verifier.take_nearest();
    }
}

impl<A: Kinematics<N>, T: Real, const N: usize, const M: usize> Verifier<'_, A, T, N, M> {
    /// Joint values all over the joint space: number `n` of a sequence.
    pub(super) fn start(&self, n: usize) -> [f64; N] {
        // Additive recurrence with the powers of the root of x^(N+1) = x + 1 for N = 6: evenly spread in six dimensions.
        const RATIOS: [f64; 7] = [0.898_654, 0.807_579, 0.725_734, 0.652_184, 0.586_087, 0.526_690, 0.473_312];
        core::array::from_fn(|k| {
            if let Some(value) = self.setting.given[k] {
                return value;
            }
            let x = n as f64 * RATIOS[k % 7];
            let x = 2.0 * (x - crate::math::floor(x)) - 1.0;
            if self.setting.joints[k].is_revolute() { x * core::f64::consts::PI } else { x * self.setting.length_scale }
        })
    }

    /// A candidate that need not be near a solution.
    ///
    /// `further`: others of its kind were taken before, and one that may lie on a known self-motion is skipped.
    fn take_rough(&mut self, mut q: [f64; N], branch: Branch, further: bool) {
        let far = FAR * self.setting.length_scale;
        if self.setting.joints.iter().zip(&q).any(|(joint, x)| !joint.is_revolute() && !(x.abs() <= far)) {
            return;
        }
        if self.is_in_known_self_motion(q, further) || !self.polish(&mut q, STEPS) {
            return;
        }
        // What stops short of the target is on its way to a root of high order.
        if self.is_regular(&q) && self.miss(&q) <= 0.01 * self.tolerance {
            self.insert(q, branch);
        } else if !(further && self.may_hold(&q)) {
            self.take_singular(q, branch);
        }
    }

    /// Whether a rough candidate belongs to a known self-motion. Most do where there is one, and next to a singular pose the last digits
    /// take longer than all others.
    fn is_in_known_self_motion(&mut self, mut q: [f64; N], further: bool) -> bool {
        self.out.iter().any(|s| !s.free.is_empty())
            && self.brought_back(&mut q, STEPS, self.tolerance)
            && !self.is_regular(&q)
            && (further && self.may_hold(&q) || self.known_self_motion(&q).is_some())
    }
}

/// Damped Newton steps from starts all over the joint space.
fn search<A: Kinematics<N>, T: Real, const N: usize, const M: usize>(verifier: &mut Verifier<'_, A, T, N, M>) {
    for start in 1..=STARTS {
        let q = verifier.start(start);
        verifier.take_rough(q, Branch::ANY, true);
    }
}

/// A pose after a small motion.
fn moved(frame: &Pose, motion: &[f64; 6], size: f64) -> Pose {
    let mut t = pose::IDENTITY;
    for axis in 0..3 {
        let angle = motion[axis] * size;
        let (s, c) = (angle, 1.0 - 0.5 * angle * angle);
        let h = 1.0 / crate::math::sqrt(s * s + c * c);
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        let mut r = pose::IDENTITY;
        r[j][j] = c * h;
        r[k][k] = c * h;
        r[j][k] = -s * h;
        r[k][j] = s * h;
        t = pose::compose(&t, &r);
    }
    let mut out = pose::compose(frame, &t);
    for i in 0..3 {
        out[i][3] = frame[i][3] + motion[3 + i] * size;
    }
    out
}
