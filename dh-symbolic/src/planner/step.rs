//! The plan of an inverse as data: its steps, their equations and unknowns.

use super::axes::Axes;
use super::known::{Collected, Knowledge};
use super::scalar::Equation;
use super::steps::StepKind;
use super::subspace::JointCombination;

/// One step.
#[derive(Clone, Debug)]
pub struct Step {
    /// The kind of equations.
    pub kind: StepKind,
    /// The unknown combinations (one or two; all for the general elimination).
    pub unknown: Vec<JointCombination>,
    /// The pool's equations used.
    pub equations: Vec<Equation>,
    /// The same, exact, by powers of the unknowns.
    pub collected: Vec<Collected>,
    /// Most solutions of this step.
    pub roots: usize,
    /// Number of known combinations before this step: indices into the plan's knowledge.
    pub before: usize,
}

/// A plan of the inverse kinematics of an arm.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The arm as the planner saw it.
    pub axes: Axes,
    /// Everything known at the end, in order.
    pub knowledge: Knowledge,
    /// Combinations that the caller gives.
    pub given: usize,
    /// The steps in order.
    pub steps: Vec<Step>,
    /// An upper bound on the number of solutions.
    pub max_solutions: usize,
    /// Whether the task has directions in which the arm cannot move the tool at all: its targets then lie in the reachable set up to rounding only.
    pub rank_deficient: bool,
    /// Whether it reaches some poses from several sides, where sheets of the reachable set cross.
    pub has_crossings: bool,
}
