//! What every generated inverse shares: candidates in, verified solutions out.
//!
//! A candidate is put through forward kinematics; one that misses the target by more than rounding is polished; one that still
//! misses is dropped. Where the closed form degenerates at a pose, `rescue` looks for what it lost.

#![allow(clippy::neg_cmp_op_on_partial_ord)] // `!(x <= y)` is how NaN ends on the safe side

mod attempt;
mod frame;
mod motion;
mod rescue;

pub use attempt::{Attempt, Pick};
pub use frame::{frame_of, frame_of_axis, frame_of_plane, in_units, to_pose};

use crate::ik::{Kinematics, Pose, Task, polish};
use crate::{Branch, FreeJoints, Joint, Real, Solution, Solutions, Why};

/// Residual (position over reach, rotation in rad) up to which a candidate is taken as it is: rounding of a chain of seven links.
const EXACT: f64 = 1e-13;
/// Residual up to which a polished candidate is a solution.
const REACHED: f64 = 1e-10;
/// The same for arms with fewer joints than the task has dimensions: their targets are rounded off what the arm can do.
const REACHED_FEW: f64 = 1e-9;
/// The same for `f32`, whose targets are rounded to 6e-8.
const REACHED_SINGLE: f64 = 2e-6;
/// Joint vectors nearer than this in every joint are one solution (rad, or table units over reach).
const SAME: f64 = 1e-6;

/// What a generated inverse knows of its arm.
#[derive(Clone, Copy, Debug)]
pub struct Setting<T: 'static, const N: usize> {
    /// The joints.
    pub joints: &'static [Joint<T>; N],
    /// Sum of the link lengths, in table units.
    pub reach: f64,
    /// Fewer joints than the task has dimensions?
    pub few: bool,
    /// The joint whose value the caller gives, and the value.
    pub given: Option<(usize, f64)>,
}

/// Runs the closed form on a target and verifies what it finds.
///
/// `frame` is the target with lengths over the reach, `task` what of it counts. `candidates` runs the plan with a choice of values for
/// free unknowns, and calls its last argument with every candidate: joint values in table units, branch, joints left free.
pub fn solve<T: Real, const N: usize, const M: usize>(
    arm: &impl Kinematics<N>,
    setting: Setting<T, N>,
    task: &Task,
    frame: &Pose,
    candidates: impl Fn(&Pose, Pick, &mut dyn FnMut([f64; N], Branch, FreeJoints)) -> Attempt,
) -> Solutions<T, N, M> {
    let mut verifier = Verifier::new(arm, setting, task);
    let attempt = candidates(frame, Pick::FIRST, &mut |q, branch, free| verifier.take(q, branch, free));
    if verifier.out.is_empty() || verifier.lost || attempt.lost {
        rescue::rescue(&mut verifier, frame, &attempt, &candidates);
    }
    let mut out = verifier.out;
    if out.is_empty() {
        out.refuse(convert(attempt.why));
        if verifier.nearest.is_finite() {
            let by = T::of(verifier.nearest);
            out.refuse(if setting.few {
                Why::NotOnTask { what: "the arm's joints", by, unit: "" }
            } else {
                Why::NotVerified { error: by }
            });
        }
    }
    out
}

fn convert<T: Real>(why: Why<f64>) -> Why<T> {
    match why {
        Why::OutOfReach { step, needs, has, unit } => {
            Why::OutOfReach { step, needs: T::of(needs), has: T::of(has), unit }
        }
        Why::NoRealRoot { step } => Why::NoRealRoot { step },
        _ => Why::NoSolution,
    }
}

/// Takes candidates, keeps what reaches the target.
struct Verifier<'a, A, T: 'static, const N: usize, const M: usize> {
    arm: &'a A,
    setting: Setting<T, N>,
    task: &'a Task,
    tolerance: f64,
    out: Solutions<T, N, M>,
    /// The smallest miss so far.
    nearest: f64,
    /// A candidate with a chosen value was no solution, or one where nothing is free: other solutions may be missing.
    lost: bool,
}

impl<'a, A: Kinematics<N>, T: Real, const N: usize, const M: usize> Verifier<'a, A, T, N, M> {
    fn new(arm: &'a A, setting: Setting<T, N>, task: &'a Task) -> Self {
        let tolerance = if T::EPSILON > T::of(1e-10) {
            REACHED_SINGLE
        } else if setting.few {
            REACHED_FEW
        } else {
            REACHED
        };
        let out = Solutions::new(setting.joints);
        Verifier { arm, setting, task, tolerance, out, nearest: f64::INFINITY, lost: false }
    }

    /// By how much a joint vector misses the target.
    #[inline]
    fn miss(&self, q: &[f64; N]) -> f64 {
        let error = self.task.error(&self.arm.forward(q), self.setting.reach);
        error.iter().fold(0.0_f64, |m, x| if x.abs() <= m { m } else { x.abs() })
    }

    /// Polishes; says whether the target is reached.
    fn polish(&mut self, q: &mut [f64; N], steps: usize) -> bool {
        let polished = polish(self.arm, q, self.task, self.setting.reach, steps);
        self.nearest = self.nearest.min(polished.position.max(polished.rotation));
        polished.reaches(self.tolerance)
    }

    /// A candidate of the first run.
    #[inline]
    fn take(&mut self, mut q: [f64; N], branch: Branch, free: FreeJoints) {
        let miss = self.miss(&q);
        if !free.is_empty() {
            self.take_chosen(q, miss, branch);
            return;
        }
        if !(miss <= EXACT) {
            self.nearest = self.nearest.min(miss);
            if !(miss < 0.5) || !self.polish(&mut q, 12) {
                return;
            }
        }
        self.out.insert(Solution::new(q.map(T::of), branch), T::of(SAME));
    }

    /// A candidate of the first run for which values were chosen.
    #[cold]
    fn take_chosen(&mut self, mut q: [f64; N], miss: f64, branch: Branch) {
        let exact = miss <= EXACT;
        if !(exact || miss < 0.5 && self.polish(&mut q, 12)) {
            self.nearest = self.nearest.min(miss);
            self.lost = true;
            return;
        }
        let free = self.free_joints(&q, exact);
        self.lost |= free.is_empty();
        self.insert(q, branch, free, 0);
    }

    /// Adds a solution, unless it is another representative of a continuum that has one: of the same branch, or among the
    /// `earlier` first solutions.
    fn insert(&mut self, q: [f64; N], branch: Branch, free: FreeJoints, earlier: usize) {
        let solution = Solution::new(q.map(T::of), branch).with_free(free);
        let known = self.out.iter().enumerate().any(|(i, s)| {
            let fixed = |k: usize| !s.free.contains(k) && !free.contains(k);
            (i < earlier || s.branch == branch)
                && !free.is_empty()
                && !s.free.is_empty()
                && self.setting.joints.iter().enumerate().filter(|(k, _)| fixed(*k)).all(|(k, joint)| {
                    joint.difference(s.q.get(k).copied().unwrap_or(T::zero()), solution.q[k]) <= T::of(1e-5)
                })
        });
        if !known {
            self.out.insert(solution, T::of(SAME));
        }
    }
}
