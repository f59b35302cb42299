//! One elimination for one choice of joints: from the roots of its determinant to joint vectors, each root accounted for.

use super::super::elementary::{atan2, sin_cos};
use super::super::pose::{IDENTITY, Pose, compose, inverse, slide, turn};
use super::super::root_isolation::square;
use super::super::tolerance::{POLISHED, REACHED};
use super::super::{Kinematics, List, TaskTarget, newton, polish};
use super::arm::General6R;
use super::budget::Budget;
use super::choice::Choice;
use super::closure::Closure;
use super::determinant::{Determinant, Root, crossing};
use super::dialytic::{Dialytic, Refined};
use super::pairs::Pairs;

/// Steps of polishing.
pub(super) const STEPS: usize = 12;
/// Mean work of a bisection.
const BISECTION: usize = 20;
/// Steps of the eigenvalue iteration.
const REFINEMENTS: usize = 6;
/// Where a root is degenerate, solutions are looked for at these distances (rad) too.
pub(super) const NEIGHBOURS: [f64; 4] = [1e-4, -1e-4, 1e-2, -1e-2];
/// A joint vector that has nothing special.
pub(super) const ELSEWHERE: [f64; 6] = [0.7, -1.1, 1.9, -0.4, 1.3, -2.1];

/// What became of the roots of a determinant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Account {
    /// Each belongs to a solution.
    Full,
    /// Each belongs to a solution or to the complex null vectors that are there at every pose; but a solution next to such a
    /// root of high order is hard to see.
    WithPhantoms,
    /// Not all of them could be explained.
    Open,
}

/// How one elimination went.
pub(super) struct Elimination {
    /// What became of the roots of the determinant.
    pub(super) account: Account,
    /// Roughly the number of factorisations of a 12 x 12 matrix that it took.
    pub(super) work: usize,
}

impl General6R {
    /// Adds the solutions that one elimination finds.
    pub(super) fn attempt(
        &self,
        target: &Pose,
        choice: Choice,
        budget: &mut Budget,
        solutions: &mut List<[f64; 6], 16>,
    ) -> Elimination {
        if choice.is_pairs() {
            return self.attempt_in_pairs(target, choice, budget, solutions);
        }
        let closure = Closure::new(self.scaled_arm(), target, choice);
        let dialytic = Dialytic::new(&closure, choice);
        if choice.has_least_degree() && self.scaled_arm().prismatic == [false; 6] {
            let determinant = Determinant::<8, 17, 20>::new(&dialytic);
            self.solutions_of(&determinant, &dialytic, &closure, target, choice, budget, solutions)
        } else {
            let determinant = Determinant::<12, 25, 28>::new(&dialytic);
            self.solutions_of(&determinant, &dialytic, &closure, target, choice, budget, solutions)
        }
    }

    /// Whether the determinant of this choice has too few digits at a pose.
    pub(super) fn is_blurred(&self, target: &Pose, choice: Choice) -> bool {
        if choice.is_pairs() {
            return Pairs::new(self.scaled_arm(), target, choice)
                .is_none_or(|p| Determinant::<8, 17, 20>::new(&p).is_blurred());
        }
        let dialytic = Dialytic::new(&Closure::new(self.scaled_arm(), target, choice), choice);
        Determinant::<12, 25, 28>::new(&dialytic).is_blurred()
    }

    #[allow(clippy::too_many_arguments)] // three parts of one elimination, and what it is for
    fn solutions_of<const D: usize, const C: usize, const K: usize>(
        &self,
        determinant: &Determinant<D, C, K>,
        dialytic: &Dialytic,
        closure: &Closure,
        target: &Pose,
        choice: Choice,
        budget: &mut Budget,
        solutions: &mut List<[f64; 6], 16>,
    ) -> Elimination {
        let mut attempt = Elimination { account: Account::Open, work: K };
        if !determinant.means_something() {
            return attempt;
        }
        let thorough = budget.thorough;
        let (mut clean, mut phantoms) = (true, false);
        let (mut roots, mut found, mut extra, mut work, mut bisections) = (0, 0, 0, 0, 0);
        let effort = determinant.each_root(dialytic, |root, kind| {
            let mut try_from = |refined: &Refined| {
                let mut q = self.joints(closure, choice, target, refined);
                let (reached, steps) = self.bring(target, &mut q, STEPS, budget);
                work += 1 + steps;
                (reached, reached && self.add(target, solutions, self.wrapped(q)))
            };
            let mut refined = dialytic.refined(root, REFINEMENTS);
            if let Root::Crossing(ends) = kind {
                if !(refined.settled() && inside(&ends, refined.hidden)) {
                    // Drawn away by a neighbour.
                    refined = dialytic.refined(crossing(dialytic, &ends), 0);
                    bisections += 1;
                }
                if refined.settled() && refined.fits() {
                    let (reached, new) = try_from(&refined);
                    roots += 1;
                    found += usize::from(new);
                    clean &= reached;
                    return;
                }
            }
            let nullity = if refined.settled() { dialytic.nullity(refined.hidden) } else { 1 };
            if nullity == 2 && dialytic.vanishes_to(refined.hidden, 2) {
                // Two solutions may share the hidden angle.
                let pair = dialytic.pair(refined.hidden);
                if pair.iter().all(Refined::fits) && !pair.is_empty() {
                    roots += pair.len();
                    for refined in &pair {
                        let (reached, new) = try_from(refined);
                        found += usize::from(new);
                        clean &= reached;
                    }
                    return;
                }
            }
            if nullity >= 2
                && nullity == self.usual_nullity(choice, refined.hidden)
                && dialytic.vanishes_to(refined.hidden, nullity)
            {
                // The null vectors are complex, and there at every pose.
                phantoms = true;
                return;
            }
            // A target that is out of reach by rounding only misses its double root nearly: worth a try, but nothing is missing otherwise.
            clean &= matches!(kind, Root::NearMiss);
            extra += usize::from(try_from(&refined).1);
            for by in NEIGHBOURS.into_iter().filter(|_| thorough) {
                let (s, c) = sin_cos(by);
                let root = [root[0] * c - root[1] * s, root[0] * s + root[1] * c];
                extra += usize::from(try_from(&dialytic.refined(root, REFINEMENTS)).1);
            }
        });
        attempt.work += effort.determinants + work + BISECTION * bisections;
        // Later eliminations may only confirm what is known.
        if clean && !effort.exhausted && (found == roots || solutions.len() == roots + extra) {
            attempt.account = if phantoms { Account::WithPhantoms } else { Account::Full };
        }
        attempt
    }

    /// Brings a joint vector onto the target; returns whether it is a solution then, and the steps taken.
    pub(super) fn bring(&self, target: &Pose, q: &mut [f64; 6], steps: usize, budget: &mut Budget) -> (bool, usize) {
        let task = TaskTarget::Pose(*target);
        if budget.thorough {
            let done = polish(self.scaled_arm(), q, &task, 1.0, steps);
            return (done.reaches(REACHED), done.steps);
        }
        let (miss, taken) = newton(self.scaled_arm(), &task, 1.0, q, steps.min(budget.steps as usize), POLISHED);
        budget.steps = budget.steps.saturating_sub(taken as u32);
        (miss <= REACHED, taken)
    }

    /// The number of null vectors at a hidden angle for a pose that has nothing to do with the target.
    fn usual_nullity(&self, choice: Choice, hidden: [f64; 2]) -> usize {
        let elsewhere = self.scaled_arm().forward(&ELSEWHERE);
        Dialytic::new(&Closure::new(self.scaled_arm(), &elsewhere, choice), choice).nullity(hidden)
    }

    /// All joint values from the three middle ones.
    fn joints(&self, closure: &Closure, choice: Choice, target: &Pose, root: &Refined) -> [f64; 6] {
        let mut middle = [[1.0, 0.0]; 3];
        let [h, d, s] = choice.middle();
        (middle[h], middle[d], middle[s]) = (root.hidden, root.others[0], root.others[1]);
        let linear = closure.linear_values(&middle);
        let joints = choice.joints();
        let mut values = [[1.0, 0.0]; 6];
        for (part, &[x, y]) in linear.iter().chain(&middle).enumerate() {
            let j = joints[part];
            values[j] = match (choice.reversed(), self.scaled_arm().prismatic[j]) {
                (false, _) => [x, y],
                (true, false) => [x, -y],
                (true, true) => [-x, y],
            };
        }
        // The joint that dropped out: what is missing from the product of the joints before and after it.
        let moved = |pose: &Pose, j: usize| {
            let joint = if self.scaled_arm().prismatic[j] { slide(pose, values[j][0]) } else { turn(pose, values[j]) };
            compose(&joint, &self.scaled_arm().links[j])
        };
        let drop = joints[5];
        let before = (0..drop).fold(IDENTITY, |t, j| moved(&t, j));
        let after = (drop + 1..6).fold(self.scaled_arm().links[drop], |t, j| moved(&t, j));
        let rest = compose(&compose(&inverse(&before), target), &inverse(&after));
        values[drop] = [rest[0][0] + rest[1][1], rest[1][0] - rest[0][1]];
        core::array::from_fn(|j| {
            if self.scaled_arm().prismatic[j] { values[j][0] } else { atan2(values[j][1], values[j][0]) }
        })
    }
}

/// Whether an angle lies between two half-angle vectors less than half a turn apart.
fn inside(ends: &[[f64; 2]; 2], at: [f64; 2]) -> bool {
    let [from, to] = ends.map(square);
    let (above, below) = (from[0] * at[1] - from[1] * at[0], at[0] * to[1] - at[1] * to[0]);
    above >= 0.0 && below >= 0.0 && from[0] * at[0] + from[1] * at[1] > 0.0
}
