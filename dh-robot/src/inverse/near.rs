//! The inverse that continues from given joint values: the nearest point of a self-motion, elsewhere the solution of least travel.

use super::attempt::STEPS;
use super::fallback::{RUN, Search};
use super::newton::length;
use super::path::Path;
use super::verifier::Verifier;
use super::work::Work;
use super::{Attempt, Sample, Setting};
use crate::{Branch, FreeJoints, Joint, Real, Solution, Solutions, Why};
use dh_kernels::{Blank, Kinematics, List, Pose, TaskTarget};

/// Residual that is let pass where a smaller one would need a jump: beside a singular pose (position over the length scale, and radians).
const LET_PASS: f64 = 1e-9;
/// Travel (rad, or lengths over the length scale) up to which a solution continues from given joints, so that limits of ranges do not stop it.
pub(super) const CONTINUES: f64 = 0.2;
/// A miss beyond which Newton steps from the given joints are not tried first.
const FAR: f64 = 0.3;
/// Newton steps from there.
const TRIES: usize = 10;
/// Steps along a self-motion towards the given joints, the longest of them, and the length of one that changes nothing.
const SLIDES: usize = 8;
const LONGEST: f64 = 0.6;
const SHORTEST: f64 = 1e-8;

/// Collects the solution of least travel.
struct Nearest<'a, T: 'static, const N: usize> {
    joints: &'static [Joint<T>; N],
    q: &'a [T; N],
    length_scale: f64,
    /// Whether it continues, is in range or neither; the travel; the solution.
    best: Option<(u8, f64, Solution<T, N>)>,
}

impl<T: Real, const N: usize> Nearest<'_, T, N> {
    fn offer(&mut self, mut solution: Solution<T, N>) {
        let (mut travel, mut short, mut most, mut inside) = (0.0, 0.0, 0.0_f64, true);
        for ((joint, value), reference) in self.joints.iter().zip(&mut solution.q).zip(self.q) {
            *value = joint.nearest_to(*reference, *value);
            inside &= joint.contains(*value);
            let unit = if joint.is_revolute() { 1.0 } else { self.length_scale };
            let way = (*value - *reference).to_f64() / unit;
            travel += way * way;
            let way = joint.difference(*value, *reference).to_f64() / unit;
            short += way * way;
            most = most.max(way);
        }
        // What continues goes first, but for whole turns; then what is in range.
        let rank = if most <= CONTINUES { 0 } else { 1 + u8::from(!inside) };
        let travel = if rank == 0 { short } else { travel };
        let better = |(other, least, _): &(u8, f64, _)| (rank, travel) < (*other, *least);
        // What is not a number is never better, and never taken.
        if travel < f64::INFINITY && self.best.as_ref().is_none_or(better) {
            self.best = Some((rank, travel, solution));
        }
    }
}

/// The solution of a list that continues from `q`, whole turns apart; where none does, the one of least travel in range, or else of least
/// travel. Whole turns bring it into the ranges.
///
/// # Errors
/// The reason why the list is empty; joint values that are not finite.
pub fn nearest<T: Real, const N: usize, const M: usize>(
    list: &Solutions<T, N, M>,
    q: &[T; N],
    length_scale: f64,
) -> Result<Solution<T, N>, Why<T>> {
    if !q.iter().all(|x| x.is_finite()) {
        return Err(Why::NotFinite);
    }
    let mut nearest = Nearest { joints: list.joints(), q, length_scale, best: None };
    for solution in list {
        nearest.offer(*solution);
    }
    nearest.best.map(|b| b.2).ok_or(list.why())
}

/// The solution that goes on from `q`, at any pose. `unknowns` are the values that the plan's unknowns have at `q`.
///
/// # Errors
/// Why no joint values reach the target.
#[allow(clippy::too_many_arguments)] // one call of generated code
pub fn solve_near<T: Real, const N: usize, const M: usize>(
    arm: &impl Kinematics<N>,
    setting: Setting<T, N>,
    task: &TaskTarget,
    frame: &Pose,
    most: Work,
    q: &[T; N],
    unknowns: [f64; STEPS],
    candidates: impl Fn(&Pose, &Sample, &mut dyn FnMut([f64; N], Branch, Path)) -> Attempt,
) -> Result<Solution<T, N>, Why<T>> {
    let mut from = q.map(T::to_f64);
    if !from.iter().chain(&unknowns).all(|x| x.is_finite()) {
        return Err(Why::NotFinite);
    }
    if let Some(why) = super::too_far(arm, setting.length_scale, frame) {
        return Err(why);
    }
    for (x, given) in from.iter_mut().zip(setting.given) {
        *x = given.unwrap_or(*x);
    }
    let mut search: Search<'_, _, T, N, M> = Search::new(arm, setting, task, most);
    let mut nearest = Nearest { joints: setting.joints, q, length_scale: setting.length_scale, best: None };
    if search.verifier.miss(&from) < FAR {
        let mut x = from;
        let miss = search.newton(&mut x, TRIES);
        if miss <= search.verifier.tolerance.max(LET_PASS) {
            let (x, free) = search.slide(x, &from);
            nearest.offer(Solution::new(x.map(T::of), Branch::ANY).with_free(free));
            let travel = search.verifier.apart(&from, &x);
            let continues = travel.iter().all(|d| d.abs() < CONTINUES) && search.verifier.drive.is_none();
            if let Some((_, _, solution)) = nearest.best.filter(|_| continues) {
                return Ok(solution);
            }
        }
    }
    let mut list: List<Candidate<N>, RUN> = List::new();
    search.work.runs += 1;
    let run = candidates(
        frame,
        &Sample::of(unknowns).with_tolerance(search.verifier.first_sample().tolerance),
        &mut |q, branch, path| _ = list.push(Candidate(q, branch, path)),
    );
    let mut missed = run.status.grazed || run.status.lost;
    for Candidate(x, branch, path) in &list {
        let mut x = *x;
        if search.settle(&mut x, TRIES) {
            let (x, free) = search.slide(x, &from);
            nearest.offer(Solution::new(x.map(T::of), *branch).with_free(free));
        } else {
            missed |= path.is_chosen();
        }
    }
    let mut why = run.why;
    if missed || nearest.best.is_none() {
        why = search.all(frame, &candidates);
        let found = search.verifier.out;
        for solution in &found {
            if solution.free.is_empty() {
                nearest.offer(*solution);
            } else {
                let (x, free) = search.slide(solution.q.map(T::to_f64), &from);
                nearest.offer(Solution { q: x.map(T::of), free: solution.free.union(free), ..*solution });
            }
        }
    }
    match nearest.best {
        Some((_, _, solution)) => Ok(solution),
        None => Err(super::convert(search.reason(why))),
    }
}

/// A candidate of the plan.
#[derive(Clone, Copy)]
struct Candidate<const N: usize>([f64; N], Branch, Path);

impl<const N: usize> Blank for Candidate<N> {
    const BLANK: Self = Candidate([0.0; N], Branch::ANY, Path::START);
}

impl<A: Kinematics<N>, T: Real, const N: usize, const M: usize> Search<'_, A, T, N, M> {
    /// Follows the self-motion through `x`, if there is one, to the point nearest to `q`; returns the joints that take part.
    fn slide(&mut self, x: [f64; N], q: &[f64; N]) -> ([f64; N], FreeJoints) {
        let (mut x, mut free) = (x, FreeJoints::NONE);
        let level = self.verifier.tolerance.max(LET_PASS);
        let distance = |v: &Verifier<'_, A, T, N, M>, x: &[f64; N]| length(&v.apart(x, q));
        let mut left = distance(&self.verifier, &x);
        for _ in 0..SLIDES {
            self.work.evaluations += 1;
            let motions = self.verifier.motions(&x);
            if motions.len == 0 || self.work.is_used_up() {
                break;
            }
            let way = self.verifier.within(motions, &self.verifier.apart(&x, q));
            let size = length(&way);
            if size < SHORTEST {
                break;
            }
            let mut next = self.verifier.moved_by(&x, &way, (LONGEST / size).min(1.0));
            let miss = self.newton(&mut next, 3);
            let then = distance(&self.verifier, &next);
            if !(miss <= level && then < left) {
                break;
            }
            let moved = self.verifier.apart(&x, &next);
            free = (0..N).filter(|k| moved[*k].abs() > 1e-3 * size).fold(free, FreeJoints::with);
            (x, left) = (next, then);
        }
        (x, free)
    }
}
