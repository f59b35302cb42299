//! The inverse at special poses, with a bound on its work: the plan root by root, at as many values of a free unknown as its later steps ask for.
//!
//! Where a step leaves its unknown free, the solutions are self-motions of the arm. The unknown parametrises them; its circle is cut where a
//! later step loses its roots or is free too (`cells`), and each piece is sampled once. Pieces that meet at a cut are one self-motion, of
//! which one point is kept (`sheets`). Candidates that miss by rounding, behind a double root, are brought onto the target by a few Newton
//! steps. Nothing here loops without a bound: `Work` counts.

use super::cells::{Cells, Cut, Event, common_zeros};
use super::path::{Equation, Path};
use super::sheets::{Node, Sheets};
use super::verifier::{SAME, Verifier};
use super::work::Work;
use super::{Attempt, Sample, Setting, newton};
use crate::{Branch, FreeJoints, Real, Solution, Solutions, Why};
use dh_kernels::{Kinematics, List, Pose, Task};

/// Residual up to which a candidate is taken as it is.
const EXACT: f64 = 1e-12;
/// Newton steps for a candidate that misses by rounding, and for one that only leads to a solution.
const FEW: usize = 4;
const MANY: usize = 14;
/// What counts as zero behind a double root, which is good to the square root of rounding.
const BLUNT: f64 = 1e-6;
/// The same for targets in `f32`.
const SINGLE: f64 = 1e-5;
/// Angles at which the equations behind a free unknown are seen: three fix waves, the fourth checks.
const ANGLES: [f64; 4] = [0.0, 2.1, -2.1, 0.9];
/// Further angles where that is not enough.
const MORE: [f64; 5] = [-0.8, 1.5, 2.8, -1.5, 3.3];
/// Length of the trial step along a motion that is not straight (rad, or reach).
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

/// All solutions for a target, by a bounded number of plan runs and Newton steps.
pub fn solve<T: Real, const N: usize, const M: usize>(
    arm: &impl Kinematics<N>,
    setting: Setting<T, N>,
    task: &Task,
    frame: &Pose,
    most: Work,
    candidates: impl Fn(&Pose, &Sample, &mut dyn FnMut([f64; N], Branch, Path)) -> Attempt,
) -> Solutions<T, N, M> {
    let mut search = Search::new(arm, setting, task, most);
    let why = search.all(frame, &candidates);
    search.verifier.keep_in_ranges();
    if search.verifier.out.is_empty() {
        let why = search.reason(why);
        search.verifier.out.refuse(super::convert(why));
    }
    search.verifier.out
}

/// The search for the solutions of one target.
pub(super) struct Search<'a, A, T: 'static, const N: usize, const M: usize> {
    pub(super) verifier: Verifier<'a, A, T, N, M>,
    pub(super) work: Work,
    /// A candidate behind a free unknown missed the target, or is a solution that stands alone: other values lead to others.
    alone: bool,
    /// A candidate missed the target, or more than one motion leaves it alone: what vanishes there may be as large as the error of a double root.
    blurred: bool,
}

impl<'a, A: Kinematics<N>, T: Real, const N: usize, const M: usize> Search<'a, A, T, N, M> {
    pub(super) fn new(arm: &'a A, setting: Setting<T, N>, task: &'a Task, most: Work) -> Self {
        Search { verifier: Verifier::new(arm, setting, task), work: Work::new(most), alone: false, blurred: false }
    }

    /// Newton steps from `q`; gives back by how much it misses then.
    pub(super) fn newton(&mut self, q: &mut [f64; N], steps: usize) -> f64 {
        let v = &self.verifier;
        newton::newton(v.arm, v.task, v.setting.reach, q, steps, EXACT, &mut self.work)
    }

    /// Brings a candidate onto the target; is it a solution?
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
    fn run(&mut self, frame: &Pose, sample: &Sample, plan: &impl Plan<N>, kept: &mut List<Node<N>, RUN>) -> Attempt {
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
        for node in first.iter().filter(|n| !n.path.is_chosen()) {
            let mut q = node.q;
            if self.settle(&mut q, MANY) {
                self.take(q, node.branch);
            } else {
                self.blurred = true;
            }
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
        run.why
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

    /// Does a self-motion at constant rates lead from a known solution to this one?
    fn is_known(&mut self, q: &[f64; N]) -> bool {
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
    fn moved_along(&mut self, q: &[f64; N], v: &[f64; N], level: f64) -> FreeJoints {
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

    /// The self-motions, from a run in which a step was free.
    fn self_motions(
        &mut self,
        frame: &Pose,
        first: &List<Node<N>, RUN>,
        run: &Attempt,
        sample: Sample,
        plan: &impl Plan<N>,
    ) {
        let free = first.iter().filter_map(|n| n.path.first_free()).chain(run.first_free()).min();
        let Some(step) = free else { return };
        // Solutions that stand alone beside a self-motion: the candidates miss.
        let mut kept: List<Node<N>, RUN> = List::new();
        let (mut crossed, mut wide) = (false, false);
        for node in first.iter().filter(|n| n.path.is_chosen()) {
            let mut node = *node;
            self.alone |= !self.keep(&mut node);
            crossed |= self.verifier.motions(&node.q).len > 1;
            wide |= node.path.free.count_ones() > 1;
            kept.push(node);
        }
        wide = wide && self.surfaces(frame, run, plan);
        let is_curve = |n: &Node<N>| n.path.is_chosen() && !(wide && n.path.free.count_ones() > 1);
        if !run.status.lost && !kept.iter().any(is_curve) {
            return;
        }
        let plain = run.equations.is_empty() && !run.status.lost && !self.alone && !crossed;
        let mut sheets: Sheets<N> = Sheets::new();
        if plain {
            for node in kept.iter().filter(|n| is_curve(n)) {
                sheets.push(*node);
            }
            return self.take_sheets(&sheets, &Cells::of(&[], &[]));
        }
        let at = |angle: f64| sample.with(step, angle);
        let mut runs: [List<Node<N>, RUN>; 3] = [List::new(); 3];
        let mut equations: [List<Equation, 24>; 4] = [run.equations, List::new(), List::new(), List::new()];
        for (k, angle) in ANGLES.iter().enumerate().skip(1) {
            equations[k] = self.run(frame, &at(*angle), plan, &mut runs[k - 1]).equations;
        }
        if self.alone {
            self.take_alone(frame, &at, [&kept, &runs[0], &runs[1], &runs[2]], plan);
        }
        let cells = Cells::of(&ANGLES, &equations.each_ref().map(|l| l.as_slice()));
        let mut sampled = 0_u32;
        let (drive, setting) = (self.verifier.drive, self.verifier.setting);
        let differ = |p: &[f64; N], q: &[f64; N]| {
            let way = super::component::apart(&drive, &setting, p, q);
            (0..N).filter(|k| way[*k].abs() > 1e-6).fold(FreeJoints::NONE, FreeJoints::with)
        };
        let mut add = |sheets: &mut Sheets<N>, list: &List<Node<N>, RUN>, angle: f64| {
            let cell = cells.cell(angle);
            let new = cell.is_none_or(|c| sampled >> c & 1 == 0) || cells.rough;
            for node in list.iter().filter(|n| is_curve(n)) {
                let node = Node { cell, angle, ..*node };
                if new {
                    sheets.push(node);
                } else {
                    sheets.compare(&node, &differ);
                }
            }
            if let Some(c) = cell {
                sampled |= 1 << c;
            }
        };
        add(&mut sheets, &kept, 0.0);
        for (list, angle) in runs.iter().zip(&ANGLES[1..]) {
            add(&mut sheets, list, *angle);
        }
        for cell in 0..cells.len() {
            let middle = cells.middle(cell);
            if cells.len() > 1 && !sheets.covers(cell) && !self.work.is_used_up() {
                let mut list = List::new();
                self.run(frame, &at(middle), plan, &mut list);
                add(&mut sheets, &list, middle);
            }
        }
        for cut in cells.cuts.iter().filter(|c| c.event != Event::Fold) {
            if !self.work.is_used_up() {
                let mut list = List::new();
                self.run(frame, &at(cut.angle).with_tolerance(BLUNT), plan, &mut list);
                for node in list.iter().filter(|n| n.path.is_chosen()) {
                    sheets.push(Node { cell: None, angle: cut.angle, ..*node });
                }
            }
        }
        if cells.rough || run.status.lost && sheets.is_empty() {
            for angle in MORE {
                if !self.work.is_used_up() {
                    let mut list = List::new();
                    self.run(frame, &at(angle), plan, &mut list);
                    add(&mut sheets, &list, angle);
                }
            }
        }
        self.take_sheets(&sheets, &cells);
    }

    /// Self-motions of two dimensions, where two steps are free at values of no special kind: one point of each stands for it. Paths that differ
    /// in the half turns of later steps meet where those are free too. Are there such?
    fn surfaces(&mut self, frame: &Pose, run: &Attempt, plan: &impl Plan<N>) -> bool {
        let mut lists: [List<Node<N>, RUN>; 2] = [List::new(); 2];
        for (k, list) in lists.iter_mut().enumerate() {
            let sample = self.verifier.first_sample();
            self.run(frame, &Sample::nth(k as u8 + 1).with_tolerance(sample.tolerance), plan, list);
        }
        let half_turn = |step: usize| run.equations.iter().filter(|e| e.step == step).all(|e| e.coefficients[2] == 0.0);
        let mut taken: List<Path, RUN> = List::new();
        for node in lists[0].iter().filter(|n| n.path.free.count_ones() > 1) {
            let path = (0..16).filter(|k| half_turn(*k)).fold(node.path, Path::without);
            let mut node = *node;
            if taken.iter().any(|p| *p == path) || !self.keep(&mut node) {
                continue;
            }
            let motions = self.verifier.motions(&node.q);
            let basis = motions.list.iter().take(motions.len).flatten();
            let mut free = FreeJoints::NONE;
            for (k, x) in basis.enumerate() {
                free = if x.abs() > 1e-6 { free.with(k % N) } else { free };
            }
            let same = |n: &&Node<N>| (0..16).filter(|k| half_turn(*k)).fold(n.path, Path::without) == path;
            for other in lists.iter().flat_map(|l| l.iter()).filter(same) {
                let way = self.verifier.apart(&node.q, &other.q);
                free = (0..N).filter(|k| way[*k].abs() > 1e-6).fold(free, FreeJoints::with);
            }
            if motions.len > 1 && taken.push(path) {
                self.verifier.push(Solution::new(node.q.map(T::of), node.branch).with_free(free));
            }
        }
        !taken.is_empty()
    }

    /// Solutions that stand alone, where a step left free what other equations decide: what the candidates miss changes with the unknown like a
    /// wave, and where it vanishes is a solution.
    fn take_alone(
        &mut self,
        frame: &Pose,
        at: &impl Fn(f64) -> Sample,
        lists: [&List<Node<N>, RUN>; 4],
        plan: &impl Plan<N>,
    ) {
        for node in lists[0].iter() {
            if self.verifier.miss(&node.q) <= 1e-5 {
                continue;
            }
            let same = lists.map(|l| l.iter().find(|n| n.path == node.path));
            let mut angles: List<f64, 2> = List::new();
            if let [Some(a), Some(b), Some(c), Some(d)] = same {
                self.work.evaluations += 4;
                let v = &self.verifier;
                let values = [a, b, c, d].map(|n| v.task.difference(&v.arm.forward(&n.q), v.setting.reach));
                for root in &common_zeros(ANGLES, &values) {
                    angles.push(crate::math::atan2(root[1], root[0]));
                }
            }
            for angle in &angles {
                let mut list: List<Node<N>, RUN> = List::new();
                if !self.work.is_used_up() {
                    self.run(frame, &at(*angle), plan, &mut list);
                }
                for found in list.iter().filter(|n| n.path == node.path) {
                    let mut q = found.q;
                    if self.settle(&mut q, FEW) {
                        self.take(q, found.branch);
                    }
                }
            }
            for found in same.iter().flatten().filter(|_| angles.is_empty()) {
                let mut q = found.q;
                if self.newton(&mut q, MANY) <= self.verifier.tolerance {
                    self.take(q, found.branch);
                }
            }
        }
    }

    /// Brings a candidate behind a free unknown onto its target, if it misses by rounding only; does it?
    fn keep(&mut self, node: &mut Node<N>) -> bool {
        self.work.evaluations += 1;
        let miss = self.verifier.miss(&node.q);
        miss <= 0.1 * self.verifier.tolerance || miss < 1e-5 && self.newton(&mut node.q, FEW) <= self.verifier.tolerance
    }

    /// Takes one point of every self-motion.
    fn take_sheets(&mut self, sheets: &Sheets<N>, cells: &Cells) {
        let groups = sheets.joined(cells);
        for root in 0..sheets.len() {
            if groups[root] as usize != root {
                continue;
            }
            self.take_group(sheets, &groups, root);
        }
    }

    /// Takes one point of a self-motion: within the ranges, if one of those known is.
    fn take_group(&mut self, sheets: &Sheets<N>, groups: &[u8; super::sheets::NODES], root: usize) {
        let mut chosen: Option<([f64; N], Branch, FreeJoints)> = None;
        let mut moved = FreeJoints::NONE;
        for (node, _) in sheets.iter().zip(groups).filter(|(_, g)| **g as usize == root) {
            let inside = self.verifier.inside(&node.q);
            if let Some((q, _, free)) = &chosen {
                let way = self.verifier.apart(q, &node.q);
                moved = (0..N).filter(|k| way[*k].abs() > 1e-6).fold(moved, FreeJoints::with);
                let _ = free;
                if self.verifier.inside(q) || !inside {
                    continue;
                }
            }
            let mut node = *node;
            if self.keep(&mut node) {
                self.work.evaluations += 1;
                let motions = self.verifier.motions(&node.q);
                if motions.len == 0 {
                    self.verifier.insert(node.q, node.branch);
                    continue;
                }
                let mut free = node.moved;
                for v in motions.list.iter().take(motions.len) {
                    let moves = (0..N).filter(|k| v[*k].abs() > 1e-6).fold(FreeJoints::NONE, FreeJoints::with);
                    if motions.len == 1 && moves.intersects(node.path.joints) {
                        free = free.union(moves);
                    } else if free.is_empty() || node.path.free.count_ones() > 1 {
                        free = free.union(self.moved_along(&node.q, v, self.verifier.tolerance));
                    }
                }
                chosen = Some((node.q, node.branch, free));
            }
        }
        if let Some((q, branch, free)) = chosen {
            if !self.is_known(&q) {
                self.verifier.push(Solution::new(q.map(T::of), branch).with_free(free.union(moved)));
            }
        }
    }

    /// Why there is no solution.
    pub(super) fn reason(&mut self, why: Why<f64>) -> Why<f64> {
        if self.verifier.setting.few && !matches!(why, Why::OutOfReach { unit, .. } if !unit.is_empty()) {
            if !self.verifier.nearest.is_finite() {
                let mut q = self.verifier.start(1);
                let miss = self.newton(&mut q, MANY);
                (self.verifier.nearest, self.verifier.best) = (miss, q);
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

impl Cut {
    /// Does a node lie on a path through this cut's step?
    pub(super) fn is_on(&self, path: &Path) -> bool {
        path.before(self.step) == self.path.before(self.step)
    }
}
