//! From the polynomial of two parallel and two meeting axes to the joint vectors of the arm.

use super::super::List;
use super::super::elementary::{atan2, sin_cos};
use super::super::pose::Pose;
use super::arm::General6R;
use super::attempt::{Account, Elimination, NEIGHBOURS, STEPS};
use super::budget::Budget;
use super::choice::Choice;
use super::determinant::{Determinant, Root, crossing};
use super::pairs::{PairCandidate, Pairs};

/// A root whose best candidate misses by more is computed anew from the function itself.
const SLOPPY: f64 = 1e-8;

/// A loop that closes as well as this (in lengths over the length scale and radians) needs no polishing.
const CLOSED: f64 = 1e-13;

impl General6R {
    /// Adds the solutions that follow from the structure of `pairs.rs`, if the arm has it.
    pub(super) fn attempt_in_pairs(
        &self,
        target: &Pose,
        choice: Choice,
        budget: &mut Budget,
        solutions: &mut List<[f64; 6], 16>,
    ) -> Elimination {
        match Pairs::new(self.scaled_arm(), target, choice) {
            None => Elimination { account: Account::Open, work: 0 },
            Some(pairs) if pairs.symmetric => self.solutions_in_pairs(
                &Determinant::<4, 9, 12>::new(&pairs),
                &pairs,
                target,
                choice,
                budget,
                solutions,
            ),
            Some(pairs) => self.solutions_in_pairs(
                &Determinant::<8, 17, 20>::new(&pairs),
                &pairs,
                target,
                choice,
                budget,
                solutions,
            ),
        }
    }

    #[allow(clippy::too_many_arguments)] // two parts of one elimination, and what it is for
    fn solutions_in_pairs<const D: usize, const C: usize, const K: usize>(
        &self,
        polynomial: &Determinant<D, C, K>,
        pairs: &Pairs,
        target: &Pose,
        choice: Choice,
        budget: &mut Budget,
        solutions: &mut List<[f64; 6], 16>,
    ) -> Elimination {
        let mut attempt = Elimination { account: Account::Open, work: 1 };
        if !polynomial.means_something() {
            return attempt;
        }
        let thorough = budget.thorough;
        // One root, two directions of the parallel axes.
        let copies = if pairs.symmetric { 2 } else { 1 };
        let (mut clean, mut roots, mut found, mut extra) = (true, 0, 0, 0);
        let effort = polynomial.each_root(pairs, |root, kind| {
            // Different solutions that candidates lead to, and how many of them are new.
            let mut try_all = |at: [f64; 2], candidates: &[PairCandidate]| {
                let (mut reached, mut new) = ([false; 16], 0);
                for candidate in candidates {
                    let mut q = [0.0; 6];
                    let (angles, gap) = pairs.angles(at, candidate);
                    for (&joint, [c, s]) in choice.joints().iter().zip(angles) {
                        q[joint] = atan2(if choice.reversed() { -s } else { s }, c);
                    }
                    let closed = gap < CLOSED || {
                        let (reached, steps) = self.bring(target, &mut q, STEPS, budget);
                        attempt.work += 1 + steps;
                        reached
                    };
                    if closed {
                        let (place, fresh) = self.place(target, solutions, self.wrapped(q));
                        new += usize::from(fresh);
                        if let Some(reached) = reached.get_mut(place) {
                            *reached = true;
                        }
                    }
                }
                (reached.iter().filter(|r| **r).count(), new)
            };
            let crossing_ends = match kind {
                Root::Crossing(ends) => Some(ends),
                Root::Doubtful | Root::NearMiss => None,
            };
            let mut at = root;
            let mut order = 1;
            if polynomial.is_flat(at) {
                order = polynomial.order(pairs, at);
            }
            let mut candidates = pairs.candidates(at, order > 1);
            if let Some(ends) = crossing_ends
                && !candidates.first().is_some_and(|c| c.misses < SLOPPY)
            {
                at = crossing(pairs, &ends);
                candidates = pairs.candidates(at, order > 1);
            }
            if order > 1
                && let Some((on_axis, all)) = pairs.candidates_on_axis(at)
            {
                let (reached, new) = try_all(at, on_axis.as_slice());
                roots += reached;
                found += new;
                // The distance from the axis, to the power that the polynomial has as a factor; more is a root of what is left.
                clean &= all && reached == on_axis.len() && order == if pairs.symmetric { 2 } else { 4 };
                return;
            }
            let (reached, new) = try_all(at, candidates.as_slice());
            if reached >= order * copies {
                // Where the sign changes, an even order is that of two roots side by side, both of which are found from each of them.
                let shared = crossing_ends.is_some() && order.is_multiple_of(2);
                roots += if shared { new } else { new.max(order * copies) };
                found += new;
                return;
            }
            extra += new;
            if candidates.is_empty() && crossing_ends.is_none() {
                // Neither directions nor solutions that are real, or nearly so.
                return;
            }
            clean &= matches!(kind, Root::NearMiss);
            for by in NEIGHBOURS.into_iter().filter(|_| thorough) {
                let (s, c) = sin_cos(by);
                let at = [root[0] * c - root[1] * s, root[0] * s + root[1] * c];
                extra += try_all(at, pairs.candidates(at, false).as_slice()).1;
            }
        });
        if clean && !effort.exhausted && (found == roots || solutions.len() == roots + extra) {
            attempt.account = Account::Full;
        }
        attempt
    }
}
