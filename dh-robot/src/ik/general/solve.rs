//! From the determinant of a loop to the joint vectors of the arm.

use super::super::arcs::square;
use super::super::math::{atan2, sin_cos, wrapped};
use super::super::pose::{Chain, IDENTITY, Pose, compose, inverse, slide, turn};
use super::super::tolerance::{NEAR, REACHED};
use super::super::{
    Found, Kinematics, List, Outcome, Task, polish, same_solution, solve_from_everywhere, solve_nearby,
};
use super::choice::{Choice, best_conditioned};
use super::closure::Closure;
use super::determinant::{Determinant, Root, crossing};
use super::dialytic::{Dialytic, Refined};

/// Steps of polishing.
pub(super) const STEPS: usize = 12;
/// Mean work of a bisection.
const BISECTION: usize = 20;
/// Starting points of the very last resort.
const STARTS: usize = 64;
/// Steps of the eigenvalue iteration.
const REFINEMENTS: usize = 6;
/// Where a root is degenerate, solutions are looked for at these distances (rad) too.
pub(super) const NEIGHBOURS: [f64; 4] = [1e-4, -1e-4, 1e-2, -1e-2];

/// A six-joint arm without usable structure.
#[derive(Clone, Copy, Debug)]
pub struct General6R {
    /// With lengths over the reach.
    arm: Chain<6>,
    reach: f64,
    choices: [Choice; 3],
}

/// All solutions of a pose.
#[derive(Clone, Copy, Debug)]
pub struct Solved {
    /// Joint vectors, angles in (-pi, pi].
    pub solutions: List<[f64; 6], 16>,
    /// Did the last elimination account for each of its roots? If not, the pose is singular or nearly so: a fold, or a continuum.
    pub clean: bool,
}

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
pub(super) struct Attempt {
    /// What became of the roots of the determinant.
    pub(super) account: Account,
    /// Roughly the number of factorisations of a 12 x 12 matrix that it took.
    pub(super) work: usize,
    /// Does the determinant vanish at every angle, so that nothing could be learnt?
    pub(super) vanishes: bool,
}

impl General6R {
    /// The arm `Rz(q1) C1 ... Rz(q6) C6` with the constant transforms `links`. `choices` are the best of
    /// [`rank`](super::rank); the second and third one are only used where the first one meets a degenerate root.
    pub fn new(links: &[Pose; 6], choices: [Choice; 3]) -> Self {
        Self::with_slides(links, &[false; 6], choices)
    }

    /// The same with `Tz(q)` instead of `Rz(q)` where `slides`: one joint, or two neighbours in the closed loop (1 and 6 are neighbours
    /// too). Other arms have no usable choice.
    pub fn with_slides(links: &[Pose; 6], slides: &[bool; 6], choices: [Choice; 3]) -> Self {
        let mut arm = Chain { links: shortened(links), slides: *slides };
        let reach = arm.reach();
        for link in &mut arm.links {
            *link = shrunk(link, reach);
        }
        Self { arm, reach, choices }
    }

    /// The arm with lengths over its reach.
    pub(super) fn scaled_arm(&self) -> &Chain<6> {
        &self.arm
    }

    /// A joint vector with lengths over the reach.
    pub(super) fn scaled(&self, q: &[f64; 6]) -> [f64; 6] {
        core::array::from_fn(|j| if self.arm.slides[j] { q[j] / self.reach } else { q[j] })
    }

    /// A target with lengths over the reach.
    pub(super) fn scaled_target(&self, target: &Pose) -> Pose {
        shrunk(target, self.reach)
    }

    /// All real solutions for a target pose.
    pub fn solve(&self, target: &Pose) -> Solved {
        let target = self.scaled_target(target);
        let mut solved = Solved { solutions: List::new(), clean: false };
        if !target.iter().flatten().all(|x| x.is_finite()) {
            return solved;
        }
        let mut useful = self.eliminate(&target, &self.choices, &mut solved);
        if !solved.clean && useful.is_none() {
            // The choices were made for an arm of these links, but with other values of what varies (a locked joint, a length): for some
            // values the arm has more structure, which makes them useless.
            let others = best_conditioned::<3>(&self.arm);
            useful = self.eliminate(&target, others.as_slice(), &mut solved);
        }
        if !solved.clean {
            self.rescue(&target, useful.unwrap_or(self.choices[0]), &mut solved.solutions);
        }
        for q in solved.solutions.as_mut_slice() {
            for (q, slides) in q.iter_mut().zip(self.arm.slides) {
                *q = if slides { *q * self.reach } else { wrapped(*q) };
            }
        }
        solved
    }

    /// Eliminates with one choice after another until all roots are accounted for. The first one with a determinant at all.
    fn eliminate(&self, target: &Pose, choices: &[Choice], solved: &mut Solved) -> Option<Choice> {
        let mut useful = None;
        for (i, &choice) in choices.iter().enumerate() {
            let before = solved.solutions.len();
            let attempt = self.attempt(target, choice, &mut solved.solutions);
            if !attempt.vanishes {
                useful = useful.or(Some(choice));
            }
            solved.clean = match attempt.account {
                Account::Full => true,
                // Two eliminations that agree.
                Account::WithPhantoms => i > 0 && solved.solutions.len() == before,
                Account::Open => false,
            };
            if solved.clean {
                break;
            }
        }
        useful
    }

    /// What can be found at a singular pose (scaled).
    fn rescue(&self, target: &Pose, first: Choice, solutions: &mut List<[f64; 6], 16>) {
        let neighbour = |pose: &Pose| {
            let mut solutions = List::new();
            self.attempt(pose, first, &mut solutions);
            solutions
        };
        solve_nearby(&self.arm, target, 1.0, neighbour, solutions);
        if solutions.is_empty() {
            let task = Task::Pose(*target);
            solve_from_everywhere(&self.arm, &self.arm.slides, &task, 1.0, STARTS, 1, solutions);
        }
    }

    /// The same as `[cos, sin]` (or `[d, d]` where a joint slides), the way the other kernels answer; [`Outcome::Free`] where nothing was found at a pose that
    /// is singular or nearly so, [`Outcome::NoRealRoot`] where there is nothing.
    pub fn find(&self, target: &Pose) -> Found<[[f64; 2]; 6], 16> {
        let solved = self.solve(target);
        let mut roots = List::new();
        for q in solved.solutions.as_slice() {
            roots.push(core::array::from_fn(|j| {
                let (s, c) = sin_cos(q[j]);
                if self.arm.slides[j] { [q[j]; 2] } else { [c, s] }
            }));
        }
        let outcome = match (roots.as_slice().is_empty(), solved.clean) {
            (false, _) => Outcome::Regular,
            (true, true) => Outcome::NoRealRoot,
            (true, false) => Outcome::Free,
        };
        Found { roots, outcome }
    }

    /// Adds the solutions that one elimination finds.
    pub(super) fn attempt(&self, target: &Pose, choice: Choice, solutions: &mut List<[f64; 6], 16>) -> Attempt {
        if choice.is_pairs() {
            return self.attempt_in_pairs(target, choice, solutions);
        }
        let closure = Closure::new(&self.arm, target, choice);
        let dialytic = Dialytic::new(&closure, choice);
        if choice.has_least_degree() && self.arm.slides == [false; 6] {
            let determinant = Determinant::<8, 17, 20>::new(&dialytic);
            self.solutions_of(&determinant, &dialytic, &closure, target, choice, solutions)
        } else {
            let determinant = Determinant::<12, 25, 28>::new(&dialytic);
            self.solutions_of(&determinant, &dialytic, &closure, target, choice, solutions)
        }
    }

    fn solutions_of<const D: usize, const C: usize, const K: usize>(
        &self,
        determinant: &Determinant<D, C, K>,
        dialytic: &Dialytic,
        closure: &Closure,
        target: &Pose,
        choice: Choice,
        solutions: &mut List<[f64; 6], 16>,
    ) -> Attempt {
        let mut attempt = Attempt { account: Account::Open, work: K, vanishes: false };
        if !determinant.means_something() {
            attempt.vanishes = true;
            return attempt;
        }
        let (mut clean, mut phantoms) = (true, false);
        let (mut roots, mut found, mut extra, mut work, mut bisections) = (0, 0, 0, 0, 0);
        let effort = determinant.each_root(dialytic, |root, kind| {
            let mut try_from = |refined: &Refined| {
                let mut q = self.joints(closure, choice, target, refined);
                let done = polish(&self.arm, &mut q, &Task::Pose(*target), 1.0, STEPS);
                work += 1 + done.steps;
                let reached = done.reaches(REACHED);
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
            for by in NEIGHBOURS {
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

    /// The number of null vectors at a hidden angle for a pose that has nothing to do with the target.
    fn usual_nullity(&self, choice: Choice, hidden: [f64; 2]) -> usize {
        let elsewhere = self.arm.forward(&[0.7, -1.1, 1.9, -0.4, 1.3, -2.1]);
        Dialytic::new(&Closure::new(&self.arm, &elsewhere, choice), choice).nullity(hidden)
    }

    /// Adds a solution if it is new.
    fn add(&self, target: &Pose, solutions: &mut List<[f64; 6], 16>, q: [f64; 6]) -> bool {
        self.place(target, solutions, q).1
    }

    /// The place of a solution in the list, where it is added if it is new.
    pub(super) fn place(&self, target: &Pose, solutions: &mut List<[f64; 6], 16>, q: [f64; 6]) -> (usize, bool) {
        let task = Task::Pose(*target);
        let known =
            solutions.iter().position(|p| self.may_be_same(p, &q) && same_solution(&self.arm, &task, 1.0, p, &q));
        known.map_or_else(|| (solutions.len(), solutions.push(q)), |place| (place, false))
    }

    /// A cheap look before [`same_solution`]; angles in (-pi, pi].
    fn may_be_same(&self, p: &[f64; 6], q: &[f64; 6]) -> bool {
        let turn = 2.0 * core::f64::consts::PI;
        p.iter().zip(q).zip(self.arm.slides).all(|((p, q), slides)| {
            let apart = (p - q).abs();
            slides || apart.min(turn - apart) < 2.0 * NEAR
        })
    }

    /// The same joint vector with angles in (-pi, pi].
    pub(super) fn wrapped(&self, q: [f64; 6]) -> [f64; 6] {
        core::array::from_fn(|j| if self.arm.slides[j] { q[j] } else { wrapped(q[j]) })
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
            values[j] = match (choice.reversed(), self.arm.slides[j]) {
                (false, _) => [x, y],
                (true, false) => [x, -y],
                (true, true) => [-x, y],
            };
        }
        // The joint that dropped out: what is missing from the product of the joints before and after it.
        let moved = |pose: &Pose, j: usize| {
            let joint = if self.arm.slides[j] { slide(pose, values[j][0]) } else { turn(pose, values[j]) };
            compose(&joint, &self.arm.links[j])
        };
        let drop = joints[5];
        let before = (0..drop).fold(IDENTITY, |t, j| moved(&t, j));
        let after = (drop + 1..6).fold(self.arm.links[drop], |t, j| moved(&t, j));
        let rest = compose(&compose(&inverse(&before), target), &inverse(&after));
        values[drop] = [rest[0][0] + rest[1][1], rest[1][0] - rest[0][1]];
        core::array::from_fn(|j| if self.arm.slides[j] { values[j][0] } else { atan2(values[j][1], values[j][0]) })
    }
}

/// Is an angle between two half-angle vectors, less than half a turn apart?
fn inside(ends: &[[f64; 2]; 2], at: [f64; 2]) -> bool {
    let [from, to] = ends.map(square);
    let (above, below) = (from[0] * at[1] - from[1] * at[0], at[0] * to[1] - at[1] * to[0]);
    above >= 0.0 && below >= 0.0 && from[0] * at[0] + from[1] * at[1] > 0.0
}

/// The same links with every frame moved along its own axis to where the frame before is nearest.
///
/// Axes that are parallel but for a ten-thousandth of a radian (calibrated arms) have their common normal a hundred metres away, and a table
/// goes there and back. No joint sees the difference.
fn shortened(links: &[Pose; 6]) -> [Pose; 6] {
    let mut out = *links;
    for i in 1..6 {
        let [before, after] = [out[i - 1], out[i]];
        let by = -(before[0][2] * before[0][3] + before[1][2] * before[1][3] + before[2][2] * before[2][3]);
        out[i - 1] = slide(&before, by);
        out[i] = after;
        out[i][2][3] -= by;
    }
    out
}

/// A pose with lengths over `reach`.
fn shrunk(pose: &Pose, reach: f64) -> Pose {
    pose.map(|[a, b, c, d]| [a, b, c, d / reach])
}
