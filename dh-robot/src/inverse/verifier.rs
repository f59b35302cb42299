//! Verifies candidates by forward kinematics and keeps those that reach the target: each solution and each self-motion once.

use super::Setting;
use crate::{Branch, FreeJoints, Real, Solution, Solutions};
use dh_kernels::{Drive, Kinematics, TaskTarget, polish, polish_to, same_solution};

/// Residual (position over the length scale, rotation in rad) up to which a candidate is taken as it is: rounding of a chain of seven links.
const EXACT: f64 = 1e-13;
/// Residual up to which a polished candidate is a solution.
const REACHED: f64 = 1e-10;
/// The same for arms with fewer joints than the task has dimensions: rounding moves their targets out of the reachable set.
const REACHED_FEW: f64 = 1e-9;
/// The same for `f32`, whose targets are rounded to 6e-8.
const REACHED_SINGLE: f64 = 2e-6;
/// A polished candidate that misses by no more than this may be on its way to a root of high order.
const CREEPS: f64 = 1e-7;
/// Newton steps allowed for such a candidate.
const CREEPING: usize = 600;
/// A candidate that misses by less and yet is not brought onto the target may be near a root of high order.
const ROUGH: f64 = 1e-3;
/// Regular solutions nearer than this in every joint may be one root of high order, seen twice.
const CLOSE: f64 = 1e-3;
/// Joint vectors nearer than this in every joint are one solution (rad, or table units over the length scale).
pub(super) const SAME: f64 = 1e-6;
/// Damped Newton steps for a candidate of the plan, which is near a solution if it belongs to one.
const STEPS: usize = 12;

/// Verifies candidates and keeps those that reach the target.
pub(super) struct Verifier<'a, A, T: 'static, const N: usize, const M: usize> {
    pub(super) arm: &'a A,
    pub(super) setting: Setting<T, N>,
    pub(super) task: &'a TaskTarget,
    /// The coupled drive, where whole turns of rows are not whole turns of actuators.
    pub(super) drive: Option<Drive<N>>,
    /// Residual up to which a joint vector is a solution.
    pub(super) tolerance: f64,
    pub(super) out: Solutions<T, N, M>,
    /// The smallest miss so far.
    pub(super) nearest: f64,
    /// The joint vector with the smallest miss.
    pub(super) best: [f64; N],
    /// Other solutions may be missing: a chosen value led to no solution, or to one where nothing is free, or there is a self-motion
    /// for which one chosen value is not enough.
    pub(super) lost: bool,
    /// A new solution was found.
    pub(super) news: bool,
}

impl<'a, A: Kinematics<N>, T: Real, const N: usize, const M: usize> Verifier<'a, A, T, N, M> {
    pub(super) fn new(arm: &'a A, setting: Setting<T, N>, task: &'a TaskTarget) -> Self {
        let tolerance = if T::EPSILON > T::of(1e-10) {
            REACHED_SINGLE
        } else if setting.rank_deficient {
            REACHED_FEW
        } else {
            REACHED
        };
        let out = Solutions::new(setting.joints);
        let drive = arm.drive();
        let (nearest, best) = (f64::INFINITY, [0.0; N]);
        Verifier { arm, setting, task, drive, tolerance, out, nearest, best, lost: false, news: false }
    }

    /// By how much a joint vector misses the target.
    #[inline]
    pub(super) fn miss(&self, q: &[f64; N]) -> f64 {
        let error = self.task.error(&self.arm.forward(q), self.setting.length_scale);
        error.iter().fold(0.0_f64, |m, x| if x.abs() <= m { m } else { x.abs() })
    }

    /// Residual up to which a point reached from a solution counts as a solution too: about the residual of the solution itself. A thousand
    /// times less than the tolerance for rounded targets: 1e-9 beside a singular pose there are isolated solutions. (A target in `f32` does not
    /// tell them from a self-motion.)
    pub(super) fn level(&self, q: &[f64; N]) -> f64 {
        let least = if self.tolerance < REACHED_SINGLE { 1e-3 * self.tolerance } else { self.tolerance };
        (4.0 * self.miss(q)).clamp(least, self.tolerance)
    }

    /// Polishes; returns whether the target is reached.
    pub(super) fn polish(&mut self, q: &mut [f64; N], steps: usize) -> bool {
        let polished = polish(self.arm, q, self.task, self.setting.length_scale, steps);
        let miss = polished.position.max(polished.rotation);
        if miss < self.nearest {
            (self.nearest, self.best) = (miss, *q);
        }
        polished.reaches(self.tolerance)
    }

    /// Moves a joint vector onto the target, no nearer than needed; returns whether that is near enough.
    pub(super) fn brought_back(&self, q: &mut [f64; N], steps: usize, level: f64) -> bool {
        polish_to(self.arm, q, self.task, self.setting.length_scale, steps, 0.5 * level).reaches(level)
    }

    /// Where nothing reached the target and something nearly did: a root of high order, to which polishing creeps. It may take its time,
    /// and ends where rounding hides the rest.
    #[cold]
    pub(super) fn take_nearest(&mut self) {
        if self.nearest > CREEPS {
            return;
        }
        let mut q = self.best;
        let polished = polish(self.arm, &mut q, self.task, self.setting.length_scale, CREEPING);
        if polished.reaches(self.tolerance.max(REACHED_FEW)) {
            self.take_singular(q, Branch::ANY);
        }
    }

    /// A candidate of the first run, with the joints for which values were chosen.
    #[inline]
    pub(super) fn take(&mut self, mut q: [f64; N], branch: Branch, chosen: FreeJoints) {
        let miss = self.miss(&q);
        if !(miss <= EXACT) {
            if miss < self.nearest {
                (self.nearest, self.best) = (miss, q);
            }
            if !(miss < 0.5) || !self.polish(&mut q, STEPS) {
                self.lost |= !chosen.is_empty() || miss < ROUGH;
                return;
            }
        }
        if self.is_regular(&q) {
            self.lost |= !chosen.is_empty();
            self.insert(q, branch);
        } else {
            let free = self.take_singular(q, branch);
            self.lost |= free.is_empty() != chosen.is_empty();
        }
    }

    /// A singular solution: on a self-motion, or an isolated double one. Returns the joints that are free.
    #[cold]
    pub(super) fn take_singular(&mut self, q: [f64; N], branch: Branch) -> FreeJoints {
        let near = |p: &[f64; N], _| same_solution(self.arm, self.task, self.setting.length_scale, p, &q);
        if let Some(i) = self.find(near) {
            self.improve(i, &q);
            return self.out[i].free;
        }
        if let Some(free) = self.known_self_motion(&q) {
            return free;
        }
        let freedom = self.freedom(&q);
        self.lost |= !freedom.straight;
        let free = freedom.joints;
        if free.is_empty() {
            self.push(Solution::new(q.map(T::of), branch));
            return free;
        }
        let walk = |p: &[f64; N], free: FreeJoints| !free.is_empty() && self.are_joined(&q, p);
        if let Some(i) = self.find(walk) {
            return self.free_at(i, free);
        }
        if !self.push(Solution::new(q.map(T::of), branch).with_free(free)) {
            // Several crossing curves may be more than the list has room for: they count as one where the joints that move tell.
            let intersecting = |p: &[f64; N], known: FreeJoints| {
                let way = self.apart(p, &q);
                let moves = known.union(free);
                !known.is_empty() && (0..N).all(|k| moves.contains(k) || way[k].abs() < 1e-4)
            };
            if let Some(i) = self.find(intersecting) {
                self.free_at(i, free);
            }
        }
        free
    }

    /// The free joints of the known self-motion that a joint vector lies on.
    pub(super) fn known_self_motion(&mut self, q: &[f64; N]) -> Option<FreeJoints> {
        if let Some((i, way)) = self.find_map(|p, free| self.along(p, free, q)) {
            let moved = (0..N).filter(|k| way[*k].abs() > 1e-6).fold(FreeJoints::NONE, FreeJoints::with);
            return Some(self.free_at(i, moved));
        }
        // The nearest one first: a walk that fails has been a long one.
        let distance = |p: &[f64; N]| self.apart(p, q).iter().map(|x| x * x).sum::<f64>();
        let nearest = self.find_least(|p, free| self.holds(p, free, q).then(|| distance(p)))?;
        let joined = |i: usize| self.are_joined(q, &self.out[i].q.map(T::to_f64));
        if joined(nearest) {
            return Some(self.out[nearest].free);
        }
        let mut others = (0..self.out.len()).filter(|i| *i != nearest);
        let holds = |i: &usize| self.holds(&self.out[*i].q.map(T::to_f64), self.out[*i].free, q);
        others.find(|i| holds(i) && joined(*i)).map(|i| self.out[i].free)
    }

    /// The solution with the least value, of those that have one.
    fn find_least(&self, value: impl Fn(&[f64; N], FreeJoints) -> Option<f64>) -> Option<usize> {
        let mut least = None;
        for (i, s) in self.out.iter().enumerate() {
            if let Some(x) = value(&s.q.map(T::to_f64), s.free).filter(|x| least.is_none_or(|(_, y)| *x < y)) {
                least = Some((i, x));
            }
        }
        least.map(|found| found.0)
    }

    /// The first solution of which this is true.
    fn find(&self, same: impl Fn(&[f64; N], FreeJoints) -> bool) -> Option<usize> {
        self.find_map(|p, free| same(p, free).then_some(())).map(|found| found.0)
    }

    /// The first solution for which there is a value, and the value.
    fn find_map<X>(&self, value: impl Fn(&[f64; N], FreeJoints) -> Option<X>) -> Option<(usize, X)> {
        self.out.iter().enumerate().find_map(|(i, s)| Some((i, value(&s.q.map(T::to_f64), s.free)?)))
    }

    /// The straight path from a known solution along its self-motion to `q`.
    fn along(&self, p: &[f64; N], free: FreeJoints, q: &[f64; N]) -> Option<[f64; N]> {
        if free.is_empty() { None } else { self.straight_way(p, q) }
    }

    /// Forgets solutions without free joints that lie on a self-motion, or so near that they are copies of its points: they were found before it.
    #[cold]
    pub(super) fn forget_copies(&mut self) {
        let mut kept = Solutions::new(self.setting.joints);
        for s in &self.out {
            let q = s.q.map(T::to_f64);
            if !s.free.is_empty() || self.find_map(|p, free| self.along(p, free, &q)).is_none() {
                kept.push(*s);
            }
        }
        self.out = kept;
    }

    /// Whether a known self-motion agrees with `q` in all joints that do not move along it.
    pub(super) fn may_hold(&self, q: &[f64; N]) -> bool {
        self.find(|p, free| self.holds(p, free, q)).is_some()
    }

    /// Whether a self-motion with these free joints agrees in all others.
    fn holds(&self, p: &[f64; N], free: FreeJoints, q: &[f64; N]) -> bool {
        let way = self.apart(p, q);
        !free.is_empty() && (0..N).all(|k| free.contains(k) || way[k].abs() <= SAME)
    }

    /// Notes free joints of a known solution; gives back all of them.
    fn free_at(&mut self, i: usize, free: FreeJoints) -> FreeJoints {
        let Some(known) = self.out.get_mut(i) else { return free };
        known.free = known.free.union(free);
        known.free
    }

    /// Adds a regular solution.
    pub(super) fn insert(&mut self, q: [f64; N], branch: Branch) {
        // Two ends of the way to a root of high order, seen as regular from both.
        let one = |p: &[f64; N], _| {
            self.apart(p, &q).iter().all(|x| x.abs() <= CLOSE)
                && same_solution(self.arm, self.task, self.setting.length_scale, p, &q)
        };
        match self.find(one) {
            Some(i) => self.improve(i, &q),
            None => _ = self.push(Solution::new(q.map(T::of), branch)),
        }
    }

    /// Of two ends of the way to a root of high order the one that misses by less is kept.
    fn improve(&mut self, i: usize, q: &[f64; N]) {
        let miss = self.miss(q);
        let better = self.out.get(i).is_some_and(|s| miss < 0.5 * self.miss(&s.q.map(T::to_f64)));
        if let Some(known) = self.out.get_mut(i).filter(|_| better) {
            for ((x, joint), known) in q.iter().zip(self.setting.joints).zip(&mut known.q) {
                *known = joint.normalize(T::of(*x));
            }
        }
    }

    pub(super) fn push(&mut self, mut solution: Solution<T, N>) -> bool {
        if let Some(drive) = self.drive
            && self.is_another_turn(&drive, &mut solution)
        {
            return false;
        }
        if self.out.len() == M {
            self.forget_copies();
        }
        let new = self.out.insert(solution, T::of(SAME));
        self.news |= new;
        new
    }

    /// Brings rows to less than a turn, and actuators into their ranges by whole turns of the rows; returns whether the solution is known then.
    #[cold]
    fn is_another_turn(&mut self, drive: &Drive<N>, solution: &mut Solution<T, N>) -> bool {
        let mut q = drive.principal(solution.q.map(T::to_f64), &self.setting.given);
        let ranges = self.setting.joints.each_ref().map(|j| j.range.map(|(l, g)| (l.to_f64(), g.to_f64())));
        drive.into_ranges(&ranges, &mut q);
        solution.q = q.map(T::of);
        let same = |p: &[f64; N], _| self.apart(p, &q).iter().all(|x| x.abs() <= SAME);
        let known = self.find(same);
        if let Some(i) = known {
            self.free_at(i, solution.free);
        }
        known.is_some()
    }
}
