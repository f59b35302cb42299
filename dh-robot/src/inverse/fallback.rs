//! The inverse at singular and nearly singular poses, with bounded work: the plan is run at as many values of a free unknown as later steps need.
//!
//! Where a step leaves its unknown free, the solutions are self-motions of the arm. The unknown parametrises them; its circle is cut where a
//! later step loses its roots or is free too (`cells`), and each piece is sampled once. Pieces that meet at a cut are one self-motion, of
//! which one point is kept (`sheets`). Candidates that miss by rounding, behind a double root, are brought onto the target by a few Newton
//! steps. Nothing here loops without a bound: `Work` counts.

use super::path::Path;
use super::sheets::Node;
use super::verifier::{SAME, Verifier};
use super::work::Work;
use super::{Attempt, Sample, Setting, newton};
use crate::{Branch, FreeJoints, Real, Solution, Solutions, Why};
use dh_kernels::{Kinematics, List, Pose, TaskTarget};

/// Residual up to which a candidate is taken as it is.
const EXACT: f64 = 1e-12;
/// Newton steps for a candidate that misses by rounding, and for one that only leads to a solution.
pub(super) const FEW: usize = 4;
pub(super) const MANY: usize = 14;
/// Starts of the search for the pose of a rank-deficient arm that is nearest to a target, and the miss at which one is found.
const STARTS: usize = 4;
const NEAR: f64 = 0.02;
/// Starts of the search for solutions that the plan's equations do not tell apart, and the steps from each.
const ALL_OVER: usize = 28;
const ROUGHLY: usize = 12;
/// What counts as zero behind a double root, which is good to the square root of rounding.
pub(super) const BLUNT: f64 = 1e-6;
/// The same for targets in `f32`.
const SINGLE: f64 = 1e-5;
/// Length of the trial step along a motion that is not straight (rad, or length scales).
const STRIDE: f64 = 0.05;

/// Residual beyond which a step along a motion that is not straight has left the self-motion.
const SHARP: f64 = 1e-12;

/// Candidates of one run of the plan.
pub(super) const RUN: usize = 16;

/// What runs the plan: the frame, the sample, and what is called with every candidate.
pub(super) trait Plan<const N: usize>:
    Fn(&Pose, &Sample, &mut dyn FnMut([f64; N], Branch, Path)) -> Attempt
{
}
impl<F, const N: usize> Plan<N> for F where F: Fn(&Pose, &Sample, &mut dyn FnMut([f64; N], Branch, Path)) -> Attempt {}

/// All solutions for a target, by a bounded number of plan runs and Newton steps, and how many they were.
pub fn solve<T: Real, const N: usize, const M: usize>(
    arm: &impl Kinematics<N>,
    setting: Setting<T, N>,
    task: &TaskTarget,
    frame: &Pose,
    most: Work,
    candidates: impl Fn(&Pose, &Sample, &mut dyn FnMut([f64; N], Branch, Path)) -> Attempt,
) -> (Solutions<T, N, M>, Work) {
    let mut search = Search::new(arm, setting, task, most);
    if let Some(why) = super::too_far(arm, setting.length_scale, frame) {
        search.verifier.out.refuse(why);
        return (search.verifier.out, search.work);
    }
    let why = search.all(frame, &candidates);
    search.keep_in_ranges();
    if search.verifier.out.is_empty() {
        let why = search.reason(why);
        search.verifier.out.refuse(super::convert(why));
    }
    (search.verifier.out, search.work)
}

/// The search for the solutions of one target.
pub(super) struct Search<'a, A, T: 'static, const N: usize, const M: usize> {
    pub(super) verifier: Verifier<'a, A, T, N, M>,
    pub(super) work: Work,
    /// A candidate behind a free unknown missed the target, or is an isolated solution: other values lead to others.
    pub(super) alone: bool,
    /// A candidate missed the target, or more than one motion leaves it alone: what vanishes there may be as large as the error of a double root.
    blurred: bool,
}

impl<'a, A: Kinematics<N>, T: Real, const N: usize, const M: usize> Search<'a, A, T, N, M> {
    pub(super) fn new(arm: &'a A, setting: Setting<T, N>, task: &'a TaskTarget, most: Work) -> Self {
        Search { verifier: Verifier::new(arm, setting, task), work: Work::new(most), alone: false, blurred: false }
    }

    /// Newton steps from `q`; gives back by how much it misses then.
    pub(super) fn newton(&mut self, q: &mut [f64; N], steps: usize) -> f64 {
        let v = &self.verifier;
        newton::newton(v.arm, v.task, v.setting.length_scale, q, steps, EXACT, &mut self.work)
    }

    /// Brings a candidate onto the target; returns whether it is a solution.
    pub(super) fn settle(&mut self, q: &mut [f64; N], steps: usize) -> bool {
        self.work.evaluations += 1;
        let miss = self.verifier.miss(q);
        if miss <= EXACT {
            return true;
        }
        if !(miss < 0.5) {
            return false;
        }
        let miss = self.newton(q, if miss < BLUNT { FEW } else { steps });
        if miss < self.verifier.nearest {
            (self.verifier.nearest, self.verifier.best) = (miss, *q);
        }
        miss <= self.verifier.tolerance
    }

    /// Runs the plan and keeps the candidates.
    pub(super) fn run(
        &mut self,
        frame: &Pose,
        sample: &Sample,
        plan: &impl Plan<N>,
        kept: &mut List<Node<N>, RUN>,
    ) -> Attempt {
        self.work.runs += 1;
        let angle = sample.value();
        plan(frame, sample, &mut |q, branch, path| {
            _ = kept.push(Node { q, branch, path, angle, cell: None, moved: FreeJoints::NONE })
        })
    }

    /// Finds all solutions; gives back why the plan found none.
    pub(super) fn all(&mut self, frame: &Pose, plan: &impl Plan<N>) -> Why<f64> {
        let mut first: List<Node<N>, RUN> = List::new();
        let sample = self.verifier.first_sample();
        let run = self.run(frame, &sample, plan, &mut first);
        // An elimination takes no samples.
        let sampled = !self.work.is_elimination();
        for node in first.iter().filter(|n| !(sampled && n.path.is_chosen())) {
            let mut q = node.q;
            if self.settle(&mut q, MANY) {
                self.take(q, node.branch);
            } else {
                self.blurred = true;
            }
        }
        if !sampled {
            return run.why;
        }
        if run.status.degenerate {
            self.self_motions(frame, &first, &run, sample, plan);
        }
        if sample == Sample::FIRST && (run.status.grazed && self.blurred || run.status.lost && !run.status.degenerate) {
            // Behind a double root what vanishes is as large as its error.
            let blunt = Sample::FIRST.with_tolerance(BLUNT);
            let mut second: List<Node<N>, RUN> = List::new();
            let again = self.run(frame, &blunt, plan, &mut second);
            let empty = self.verifier.out.is_empty();
            for node in second.iter().filter(|n| empty && !n.path.is_chosen()) {
                let mut q = node.q;
                if self.settle(&mut q, MANY) {
                    self.take(q, node.branch);
                }
            }
            if again.status.degenerate && !run.status.degenerate {
                self.self_motions(frame, &second, &again, blunt, plan);
            }
        }
        if self.work.has_crossing_sheets() && (run.status.degenerate || run.status.lost) {
            self.take_from_everywhere();
        }
        run.why
    }

    /// Takes the regular solutions that Newton steps from joint values all over lead to.
    fn take_from_everywhere(&mut self) {
        for start in 1..=ALL_OVER {
            let mut q = self.verifier.start(start);
            if self.newton(&mut q, ROUGHLY) <= self.verifier.tolerance {
                self.work.evaluations += 1;
                if self.verifier.motions(&q).len == 0 {
                    self.verifier.insert(q, Branch::ANY);
                }
            }
        }
    }

    /// Takes a solution for which no value was chosen.
    pub(super) fn take(&mut self, q: [f64; N], branch: Branch) {
        self.work.evaluations += 1;
        let motions = self.verifier.motions(&q);
        if motions.len == 0 {
            return self.verifier.insert(q, branch);
        }
        let mut free = FreeJoints::NONE;
        let level = self.verifier.level(&q);
        self.blurred |= motions.len > 1;
        for (i, v) in motions.directions().enumerate() {
            if i < motions.len || free.is_empty() {
                free = free.union(self.moved_along(&q, &v, level));
            }
        }
        if !free.is_empty() && self.is_known(&q) {
            return;
        }
        self.verifier.push(Solution::new(q.map(T::of), branch).with_free(free));
    }

    /// Whether a self-motion at constant rates leads from a known solution to this one.
    pub(super) fn is_known(&mut self, q: &[f64; N]) -> bool {
        let v = &self.verifier;
        let level = (4.0 * v.miss(q)).clamp(v.level(q), v.tolerance);
        let mut evaluations = 1;
        let known = v.out.iter().filter(|s| !s.free.is_empty()).any(|s| {
            let p = s.q.map(T::to_f64);
            let way = v.apart(&p, q);
            if !(0..N).all(|k| s.free.contains(k) || way[k].abs() <= SAME) {
                return false;
            }
            evaluations += 2;
            let reached = |t: f64| v.miss(&v.moved_by(&p, &way, t)) <= level.max(v.level(&p));
            reached(0.5) && reached(0.3)
        });
        self.work.evaluations += evaluations;
        known
    }

    /// The joints that move along a motion that keeps the target reached within `level`; none where it is left, to second order.
    pub(super) fn moved_along(&mut self, q: &[f64; N], v: &[f64; N], level: f64) -> FreeJoints {
        let moved = |v: &[f64; N]| (0..N).filter(|k| v[*k].abs() > 1e-6).fold(FreeJoints::NONE, FreeJoints::with);
        self.work.evaluations += 2;
        let far = self.verifier.miss(&self.verifier.moved_by(q, v, 1.7));
        if far <= level && self.verifier.miss(&self.verifier.moved_by(q, v, 0.9)) <= level {
            return moved(v);
        }
        let mut x = self.verifier.moved_by(q, v, STRIDE);
        let before = self.verifier.miss(&x);
        let after = self.newton(&mut x, 1);
        if !(after < 0.2 * before) || self.newton(&mut x, FEW) > level.min(SHARP) {
            return FreeJoints::NONE;
        }
        let way = self.verifier.apart(q, &x);
        if way.iter().any(|d| d.abs() > 0.4 * STRIDE) { moved(&way) } else { FreeJoints::NONE }
    }

    /// The reason if there is no solution.
    pub(super) fn reason(&mut self, why: Why<f64>) -> Why<f64> {
        // What a step lacks, over the length scale: the reason unless some joint vector comes nearer to the target.
        let gap = match why {
            Why::OutOfReach { needs, has, unit, .. } if !unit.is_empty() => {
                (needs - has).abs() / self.verifier.setting.length_scale
            }
            _ => f64::INFINITY,
        };
        if self.verifier.setting.rank_deficient && (gap.is_infinite() || self.verifier.nearest < gap) {
            for start in 1..=STARTS {
                if self.verifier.nearest <= NEAR || self.work.is_used_up() {
                    break;
                }
                let mut q = self.verifier.start(start);
                let miss = self.newton(&mut q, MANY);
                if miss < self.verifier.nearest {
                    (self.verifier.nearest, self.verifier.best) = (miss, q);
                }
            }
            if let Some(why) = self.verifier.miss_of_best() {
                return why;
            }
        }
        let nearest = self.verifier.nearest;
        match why {
            Why::NoSolution | Why::NoRealRoot { .. } if nearest.is_finite() => Why::NotVerified { error: nearest },
            why => why,
        }
    }
}

impl<A: Kinematics<N>, T: Real, const N: usize, const M: usize> Verifier<'_, A, T, N, M> {
    /// The first sample: for a target in `f32`, whose rounding turns a double root into two, with what counts as zero behind one.
    pub(super) fn first_sample(&self) -> Sample {
        if T::EPSILON > T::of(1e-10) { Sample::FIRST.with_tolerance(SINGLE) } else { Sample::FIRST }
    }
}
