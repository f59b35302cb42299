//! The pass from the program of an inverse to its batched form: every step for all branches side by side, for vector instructions.
//!
//! A tree of loops over roots becomes a list of loops over branches. Steps and values with the same number of branches share one loop:
//! long loops are what compilers turn into vector instructions well; short ones they unroll first, and find less in what they then see.

mod mirror;

pub use mirror::Mirror;

use super::{Inverse, Solve};
use crate::algebra::Poly;
use crate::chain::Task;
use crate::planner::{Argument, BatchedKernel, Coefficient, StepKind};
use crate::program::Node;
use crate::program::graph::{Value, ZERO};
use std::fmt;

/// Most branches side by side.
const MOST: usize = 16;

/// What is computed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum What {
    /// A step of the plan.
    Step(usize),
    /// The values that need this number of known combinations.
    Values(usize),
    /// Confirmation and joint values.
    Finish,
}

/// Something to compute, for how many branches, in which loop.
#[derive(Clone, Copy, Debug)]
pub struct Item {
    /// What.
    pub what: What,
    /// Branches that differ there.
    pub width: usize,
    /// Number of the loop; neighbours with the same width share one.
    pub in_loop: usize,
}

/// A step with its batched kernel.
#[derive(Clone, Debug)]
pub struct BatchedSolve {
    /// The combination that it finds: an index into the plan's knowledge.
    pub known: usize,
    /// The kernel.
    pub kernel: BatchedKernel,
    /// Its arguments.
    pub arguments: Vec<Argument<Value>>,
    /// The coefficients that decide where it can be computed.
    pub needs: Vec<Value>,
}

/// An entry of the pose that a branch must have.
#[derive(Clone, Copy, Debug)]
pub struct Residual {
    /// Row of the entry.
    pub row: usize,
    /// Column; 3 is the position.
    pub column: usize,
    /// What the known combinations make of it.
    pub value: Value,
}

/// An inverse for all branches at once.
#[derive(Clone, Debug)]
pub struct Batched {
    /// How many there are.
    pub branches: usize,
    /// The steps.
    pub solves: Vec<BatchedSolve>,
    /// The number of different branches once this number of combinations is known; the two halves of a mirror symmetry count as one.
    pub widths: Vec<usize>,
    /// What is computed, in order.
    pub items: Vec<Item>,
    /// The step whose two roots give mirrored halves.
    pub mirror: Option<Mirror>,
    /// What confirms a branch: two columns of the rotation fix the third, so the one that costs most is left out.
    pub confirmation: Vec<Residual>,
    /// How many known combinations each node needs.
    pub depths: Vec<usize>,
    /// The nodes that are computed.
    pub live: Vec<bool>,
    /// The last loop that uses each node.
    pub last_use: Vec<usize>,
    /// The joints for which any value does: nothing that is asked for depends on them.
    pub free: Vec<usize>,
}

impl Inverse {
    /// The batched form for a task, if every step has one or two roots by a formula, branches are few, and nothing depends on what is
    /// chosen.
    pub fn batched(&self, task: Task) -> Option<Batched> {
        let plan = &self.plan;
        let solves: Vec<BatchedSolve> =
            self.body.solves().into_iter().map(|s| self.batched_solve(s)).collect::<Option<_>>()?;
        let branches: usize = plan.steps.iter().map(|s| s.roots).product();
        if branches > MOST {
            return None;
        }
        let depths = self.depths();
        let mut outputs: Vec<Value> = solves.iter().flat_map(|s| s.needs.clone()).collect();
        let confirmation = self.residuals(task, &outputs);
        outputs.extend(confirmation.iter().map(|r| r.value));
        let live = self.graph.live(&outputs);
        let free = self.free_joints(&live)?;
        let (widths, items, mirror) = (Vec::new(), Vec::new(), None);
        let last_use = vec![0; depths.len()];
        let mut batched =
            Batched { branches, solves, widths, items, mirror, confirmation, depths, live, last_use, free };
        let all = batched.loops(self);
        // Mirrored halves share everything behind their step, if it is solved for all branches that differ there.
        let step = Mirror::of(self, &batched).filter(|m| all[batched.depth_of(m.step)] == all[plan.given + m.step]);
        batched.mirror = step;
        batched.loops(self);
        for item in batched.items.clone() {
            for node in batched.uses(self, item.what) {
                batched.last_use[node] = batched.last_use[node].max(item.in_loop);
            }
        }
        Some(batched)
    }

    fn batched_solve(&self, solve: &Solve) -> Option<BatchedSolve> {
        let at = |row: usize, place: usize| solve.equations.get(row).and_then(|r| r.get(place)).copied();
        let constant = |row: usize, place: usize| -> Option<i8> {
            let p = self.graph.as_constant(at(row, place)?)?;
            [(0, Poly::zero()), (1, Poly::one()), (-1, -&Poly::one())]
                .into_iter()
                .find(|(_, n)| p == *n)
                .map(|(n, _)| n)
        };
        let is_angle = self.plan.knowledge.known.get(*solve.finds.first()?)?.is_angle;
        let kernel = self.plan.steps.get(solve.step)?.kind.batched(solve.equations.len(), is_angle, &constant)?;
        let value = |c: &Coefficient| match *c {
            Coefficient::Plus(row, place) => at(row, place).unwrap_or(ZERO),
            Coefficient::Minus(row, place) => -at(row, place).unwrap_or(ZERO),
            Coefficient::Zero => ZERO,
        };
        let arguments = kernel.arguments.iter().map(|a| a.map(&value)).collect();
        Some(BatchedSolve { known: *solve.finds.first()?, kernel, arguments, needs: solve.equations.concat() })
    }

    /// The joints whose values are chosen, if nothing that is computed depends on them.
    fn free_joints(&self, live: &[bool]) -> Option<Vec<usize>> {
        let mut free = Vec::new();
        for (i, step) in self.plan.steps.iter().enumerate().filter(|(_, s)| s.kind == StepKind::Choose) {
            let symbols = self.plan.knowledge.known.get(self.plan.given + i)?.symbols;
            let mut nodes = self.graph.nodes().iter().zip(live);
            if nodes.any(|(n, live)| *live && matches!(n, Node::Symbol(s) if symbols.contains(s))) {
                return None;
            }
            free.push(step.unknown.first()?.iter().position(|k| *k != 0)?);
        }
        Some(free)
    }

    /// The entries of the pose that confirm a branch, beside what the steps compute anyway: those that the task asks for.
    fn residuals(&self, task: Task, computed: &[Value]) -> Vec<Residual> {
        let all = || {
            let entries = self.confirmation.iter().copied().enumerate();
            entries.map(|(k, value)| Residual { row: k % 3, column: k / 3, value })
        };
        match task {
            Task::Pose => {}
            Task::Position => return all().filter(|r| r.column == 3).collect(),
            Task::Axis => return all().filter(|r| r.column >= 2).collect(),
            Task::Planar => return all().filter(|r| r.row < 2 && (r.column == 0 || r.column == 3)).collect(),
        }
        let without = |column: usize| -> Vec<Residual> { all().filter(|r| r.column != column).collect() };
        let cost = |column: &usize| {
            let outputs: Vec<Value> =
                computed.iter().copied().chain(without(*column).iter().map(|r| r.value)).collect();
            self.graph.live(&outputs).iter().filter(|live| **live).count()
        };
        without((0..3).min_by_key(cost).unwrap_or(0))
    }
}

impl Batched {
    /// How many known combinations the coefficients of a step need.
    pub fn depth_of(&self, step: usize) -> usize {
        self.solves[step].needs.iter().map(|v| self.depths[v.node as usize]).max().unwrap_or(0)
    }

    /// Puts everything in its order and into loops; returns the widths.
    fn loops(&mut self, inverse: &Inverse) -> Vec<usize> {
        let given = inverse.plan.given;
        let mirrored = self.mirror.as_ref().map(|m| m.step);
        self.widths = vec![1_usize; given + 1];
        for (i, step) in inverse.plan.steps.iter().enumerate() {
            self.widths.push(self.widths[i + given] * if mirrored == Some(i) { 1 } else { step.roots });
        }
        let mut whole: Vec<(What, usize)> = Vec::new();
        for i in 0..self.solves.len() {
            whole.push((What::Step(i), self.widths[self.depth_of(i)]));
            whole.push((What::Values(given + i + 1), self.widths[given + i + 1]));
        }
        whole.push((What::Finish, self.widths[given + self.solves.len()]));
        self.items.clear();
        for (what, width) in whole {
            let in_loop = self.items.last().map_or(0, |last| last.in_loop + usize::from(last.width != width));
            self.items.push(Item { what, width, in_loop });
        }
        self.widths.clone()
    }

    /// The nodes that an item uses and that differ between branches.
    pub fn uses(&self, inverse: &Inverse, what: What) -> Vec<usize> {
        let mut used: Vec<usize> = match what {
            What::Step(i) => self.solves[i].needs.iter().map(|v| v.node as usize).collect(),
            What::Finish => Vec::new(),
            What::Values(depth) => {
                let nodes = inverse.graph.nodes().iter().enumerate();
                let here = nodes.filter(|(i, _)| self.live[*i] && self.depths[*i] == depth);
                here.flat_map(|(i, node)| match *node {
                    Node::Add(a, b) => vec![a.node as usize, b.node as usize],
                    Node::Mul(a, b) => vec![a as usize, b as usize],
                    // It stands for itself, where it confirms.
                    _ => vec![i],
                })
                .collect()
            }
        };
        used.retain(|i| self.depths[*i] > inverse.plan.given);
        used.sort_unstable();
        used.dedup();
        used
    }
}

impl fmt::Display for Batched {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{} branches", self.branches)?;
        let mut last = usize::MAX;
        for item in &self.items {
            if item.in_loop != last {
                writeln!(f, "loop over {}", item.width)?;
            }
            last = item.in_loop;
            match item.what {
                What::Step(i) => writeln!(f, "  step {}: {}", i + 1, self.solves[i].kernel.name)?,
                What::Values(known) => {
                    let confirmed =
                        self.confirmation.iter().filter(|r| self.depths[r.value.node as usize] == known).count();
                    writeln!(f, "  values of {known} combinations, {confirmed} entries of the pose")?;
                }
                What::Finish => writeln!(f, "  confirmation and joint values")?,
            }
        }
        match &self.mirror {
            Some(mirror) => writeln!(f, "mirrored halves behind step {}: {:?}", mirror.step + 1, mirror.flips),
            None => writeln!(f, "no mirrored halves"),
        }
    }
}
