//! All solutions for a target: eliminations with several choices of joints, and the numeric search at singular poses.

use super::super::chain::NumericChain;
use super::super::elementary::{sin_cos, wrapped};
use super::super::pose::Pose;
use super::super::tolerance::{NEAR, REACHED};
use super::super::{
    Kinematics, List, Outcome, Roots, TaskTarget, beside, polish, same_solution, solve_from_everywhere, solve_nearby,
};
use super::arm::General6R;
use super::attempt::{Account, ELSEWHERE};
use super::budget::Budget;
use super::choice::Choice;
use super::ranking::best_conditioned;

/// Steps of polishing from a neighbour.
const PATIENT_STEPS: usize = 40;
/// A pivot of the Jacobian that is smaller belongs to a singular pose, or to one that can't be told from it.
const SINGULAR: f64 = 1e-4;
/// Steps of the same where the budget is bounded.
const FEW_STEPS: usize = 14;
/// Distance (rad, and over the length scale) of the two poses that are asked beside a singular one.
const ASIDE: f64 = 1e-3;
/// Starting points of the very last resort.
const STARTS: usize = 64;

/// All solutions of a pose.
#[derive(Clone, Copy, Debug)]
pub struct Solved {
    /// Joint vectors, angles in (-pi, pi].
    pub solutions: List<[f64; 6], 16>,
    /// Whether the last elimination accounted for each of its roots. If not, the pose is singular or nearly so: a fold, or a self-motion.
    pub clean: bool,
}

impl General6R {
    /// All real solutions for a target pose, by a thorough search.
    pub fn solve(&self, target: &Pose) -> Solved {
        self.solve_within(target, Budget::THOROUGH)
    }

    /// The real solutions for a target pose that a bounded search finds: all, unless the pose is singular or nearly so.
    pub fn solve_within(&self, target: &Pose, mut budget: Budget) -> Solved {
        let target = self.scaled_target(target);
        let mut solved = Solved { solutions: List::new(), clean: false };
        if !target.iter().flatten().all(|x| x.is_finite()) {
            return solved;
        }
        self.eliminate(&target, &self.choices, &mut budget, &mut solved);
        if !solved.clean && !budget.thorough {
            self.ask_neighbours(&target, &mut budget, &mut solved.solutions);
        } else if !solved.clean {
            let mut choices = self.fitting();
            if choices.len() < self.choices.len() {
                // They were made for an arm of these links, but with other values of what varies (a locked joint, a length): for some values the
                // arm has more structure, which makes some of them useless.
                let mut others = List::<Choice, 3>::new();
                for &choice in &best_conditioned::<3>(&self.arm) {
                    if !choices.contains(&choice) && choices.push(choice) {
                        others.push(choice);
                    }
                }
                self.eliminate(&target, &others, &mut budget, &mut solved);
            }
            if !solved.clean {
                self.rescue(&target, choices.as_slice(), &mut solved.solutions);
            }
        }
        for q in solved.solutions.as_mut_slice() {
            for (q, prismatic) in q.iter_mut().zip(self.arm.prismatic) {
                *q = if prismatic { *q * self.length_scale } else { wrapped(*q) };
            }
        }
        solved
    }

    /// The choices whose determinant has enough digits at a pose that has nothing special.
    fn fitting(&self) -> List<Choice, 3> {
        let mut fitting = List::new();
        let elsewhere = self.arm.forward(&ELSEWHERE);
        for &choice in &self.choices {
            if !self.is_blurred(&elsewhere, choice) {
                fitting.push(choice);
            }
        }
        fitting
    }

    /// Eliminates with one choice after another until all roots are accounted for.
    fn eliminate(&self, target: &Pose, choices: &[Choice], budget: &mut Budget, solved: &mut Solved) {
        for (i, &choice) in choices.iter().enumerate() {
            if !budget.eliminate() {
                break;
            }
            let before = solved.solutions.len();
            let attempt = self.attempt(target, choice, budget, &mut solved.solutions);
            solved.clean = match attempt.account {
                Account::Full => true,
                // Two eliminations that agree.
                Account::WithPhantoms => i > 0 && solved.solutions.len() == before,
                Account::Open => false,
            };
            // Where time is short, an open account is settled by neighbours.
            let open = attempt.account == Account::Open && !budget.thorough && !solved.solutions.is_empty();
            if solved.clean || open {
                break;
            }
        }
    }

    /// Brings the solutions of the poses on both sides of a singular one (scaled) onto it: a regular solution has a neighbour on each side, a
    /// double one two on one of them.
    fn ask_neighbours(&self, target: &Pose, budget: &mut Budget, solutions: &mut List<[f64; 6], 16>) {
        for distance in [ASIDE, -ASIDE] {
            let mut solved = Solved { solutions: List::new(), clean: false };
            self.eliminate(&beside(target, 1.0, distance), &self.choices, budget, &mut solved);
            for &q in &solved.solutions {
                let mut q = q;
                if self.bring(target, &mut q, FEW_STEPS, budget).0 {
                    self.add(target, solutions, self.wrapped(q));
                }
            }
        }
    }

    /// What can be found at a singular pose (scaled).
    fn rescue(&self, target: &Pose, choices: &[Choice], solutions: &mut List<[f64; 6], 16>) {
        let task = TaskTarget::Pose(*target);
        let solve = |pose: &Pose| {
            let mut solved = Solved { solutions: List::new(), clean: false };
            self.eliminate(pose, choices, &mut { Budget::THOROUGH }, &mut solved);
            (solved.solutions, solved.clean)
        };
        solve_nearby(target, 1.0, solve, |mut q| {
            if polish(&self.arm, &mut q, &task, 1.0, PATIENT_STEPS).reaches(REACHED) {
                self.add(target, solutions, self.wrapped(q));
            }
        });
        if solutions.is_empty() {
            solve_from_everywhere(&self.arm, &self.arm.prismatic, &task, 1.0, STARTS, 1, solutions);
        }
    }

    /// The same as `[cos, sin]` (or `[d, d]` where a joint slides), the way the other kernels answer; [`Outcome::Free`] where nothing was found at a pose that
    /// is singular or nearly so, [`Outcome::NoRealRoot`] where there is nothing.
    pub fn find(&self, target: &Pose, budget: Budget) -> Roots<[[f64; 2]; 6], 16> {
        let solved = self.solve_within(target, budget);
        let mut roots = List::new();
        for q in solved.solutions.as_slice() {
            roots.push(core::array::from_fn(|j| {
                let (s, c) = sin_cos(q[j]);
                if self.arm.prismatic[j] { [q[j]; 2] } else { [c, s] }
            }));
        }
        let outcome = match (roots.as_slice().is_empty(), solved.clean) {
            (false, _) => Outcome::Regular,
            (true, true) => Outcome::NoRealRoot,
            (true, false) => Outcome::Free,
        };
        Roots { roots, outcome }
    }

    /// Adds a solution if it is new.
    pub(super) fn add(&self, target: &Pose, solutions: &mut List<[f64; 6], 16>, q: [f64; 6]) -> bool {
        self.place(target, solutions, q).1
    }

    /// The place of a solution in the list, where it is added if it is new.
    pub(super) fn place(&self, target: &Pose, solutions: &mut List<[f64; 6], 16>, q: [f64; 6]) -> (usize, bool) {
        let task = TaskTarget::Pose(*target);
        let known =
            solutions.iter().position(|p| self.may_be_same(p, &q) && same_solution(&self.arm, &task, 1.0, p, &q));
        if let Some(place) = known {
            return (place, false);
        }
        if solutions.push(q) {
            return (solutions.len() - 1, true);
        }
        // Full of points of a self-motion, one of which makes room.
        let full = solutions.as_mut_slice();
        let room = full.iter().position(|p| is_singular(&self.arm, p)).filter(|_| !is_singular(&self.arm, &q));
        if let Some(p) = room.and_then(|place| full.get_mut(place)) {
            *p = q;
        }
        (room.unwrap_or(full.len()), room.is_some())
    }

    /// A cheap look before [`same_solution`]; angles in (-pi, pi].
    fn may_be_same(&self, p: &[f64; 6], q: &[f64; 6]) -> bool {
        let turn = 2.0 * core::f64::consts::PI;
        p.iter().zip(q).zip(self.arm.prismatic).all(|((p, q), prismatic)| {
            let apart = (p - q).abs();
            prismatic || apart.min(turn - apart) < 2.0 * NEAR
        })
    }
}

/// Whether some motion of the arm hardly moves the tool.
pub(super) fn is_singular(arm: &NumericChain<6>, q: &[f64; 6]) -> bool {
    let mut m = arm.forward_and_jacobian(q).1;
    for k in 0..6 {
        let (mut row, mut column) = (k, k);
        for r in k..6 {
            for c in k..6 {
                if m[r][c].abs() > m[row][column].abs() {
                    (row, column) = (r, c);
                }
            }
        }
        if !(m[row][column].abs() > SINGULAR) {
            return true;
        }
        m.swap(k, row);
        for r in &mut m {
            r.swap(k, column);
        }
        let top = m[k];
        for r in &mut m[k + 1..] {
            let factor = r[k] / top[k];
            for c in k..6 {
                r[c] -= factor * top[c];
            }
        }
    }
    false
}

/// All joint vectors, as `[cos, sin]` (or `[d, d]` where a joint slides), that bring an arm to a target. `links` are the constant transforms
/// behind its joints, `prismatic` says which of these slide, `cuts` are the numbers of the [`Choice`]s that are tried in turn, `budget` bounds the
/// work.
pub fn solve_general(
    links: &[Pose; 6],
    target: &Pose,
    prismatic: &[bool; 6],
    cuts: [u8; 3],
    budget: Budget,
) -> Roots<[[f64; 2]; 6], 16> {
    General6R::with_prismatic(links, prismatic, cuts.map(Choice::new)).find(target, budget)
}
