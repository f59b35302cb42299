//! The program of an inverse: a tree of instructions that printers print node by node and the interpreter runs.
//!
//! Straight-line values live in the [`Graph`](crate::program::Graph) beside it; the tree says where they are computed, where equations are solved, over which
//! roots to loop, what the roots bind, where a branch ends without a solution, and what a finished branch yields.

use crate::planner::{Argument, Call};
use crate::program::Value;

/// Instructions, one after the other.
#[derive(Clone, Debug, Default)]
pub struct Sequence(pub Vec<Instruction>);

/// One instruction.
#[derive(Clone, Debug)]
pub enum Instruction {
    /// Combination number `known` is given by the caller: binds its value, and its cosine and sine (or its length over the length scale).
    Given {
        /// Index into the plan's knowledge.
        known: usize,
    },
    /// Computes the nodes that need as many known combinations, in order.
    Compute {
        /// So many combinations are known.
        known: usize,
        /// The nodes of the graph.
        nodes: Vec<u32>,
    },
    /// Solves the equations of a step.
    Solve(Solve),
    /// Where the last solve was not regular: notes why the branch ends here, or that roots touch.
    Reject(Report),
    /// Runs the body for every root of the last solve.
    ForEachRoot(Loop),
    /// A candidate: joint values, and which branch they are of.
    Yield(Yield),
}

/// The equations of one step, and the call that solves them.
#[derive(Clone, Debug)]
pub struct Solve {
    /// Which step of the plan.
    pub step: usize,
    /// Coefficients, one row per equation, in the order of [`StepKind::columns`](crate::planner::StepKind::columns).
    pub equations: Vec<Vec<Value>>,
    /// The kernel and its arguments.
    pub call: Call<Value>,
    /// The combinations that it finds: indices into the plan's knowledge.
    pub finds: Vec<usize>,
    /// What a textbook calls it.
    pub name: &'static str,
}

impl Solve {
    /// a, b and c, if it solves the one equation a cos u + b sin u = c.
    pub fn sine_equation(&self) -> Option<[Value; 3]> {
        match self.call.arguments.as_slice() {
            [Argument::Number(a), Argument::Number(b), Argument::Number(c)]
                if self.call.kernel.is_sine_equation && !self.equations.is_empty() =>
            {
                Some([*a, *b, *c])
            }
            _ => None,
        }
    }
}

/// The part of an arm that a step with two roots decides, after Lee and Ziegler (1984).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Indicator {
    /// Left or right.
    Shoulder,
    /// Up or down.
    Elbow,
    /// Not flipped, or flipped.
    Wrist,
}

/// The report of a step without a root.
#[derive(Clone, Debug)]
pub struct Report {
    /// Which step of the plan.
    pub step: usize,
    /// The part that it decides.
    pub indicator: Option<Indicator>,
    /// The unknowns, as people write them.
    pub unknowns: String,
    /// Whether the numbers of the equation measure a length (over the length scale); otherwise they are pure numbers.
    pub is_length: bool,
    /// For a law of cosines: how to compute the distance.
    pub distance: Option<Distance>,
}

impl Report {
    /// What it is called: `elbow q3`.
    pub fn name(&self) -> String {
        let part = match self.indicator {
            Some(Indicator::Shoulder) => "shoulder ",
            Some(Indicator::Elbow) => "elbow ",
            Some(Indicator::Wrist) => "wrist ",
            None => "",
        };
        format!("{part}{}", self.unknowns)
    }
}

/// A law of cosines: the squared distance is `base + rest`.
#[derive(Clone, Copy, Debug)]
pub struct Distance {
    /// What is added to the side of the equation without the unknown.
    pub base: Value,
    /// That side.
    pub rest: Value,
    /// Whether the amplitude of the other side grows with the distance.
    pub grows: bool,
}

/// A loop over the roots of a step.
#[derive(Clone, Debug)]
pub struct Loop {
    /// Which step.
    pub step: usize,
    /// The combinations that a root binds, in its order: cosine and sine, and the angle; or the length.
    pub binds: Vec<usize>,
    /// The joints that are free where the equations leave the unknowns free.
    pub free_joints: Vec<usize>,
    /// What is done for each root.
    pub body: Sequence,
}

/// A finished branch.
#[derive(Clone, Debug)]
pub struct Yield {
    /// Each real joint coordinate as a combination of the known ones.
    pub joints: Vec<Vec<i8>>,
    /// The steps with more than one root, in order.
    pub branch: Vec<Choice>,
}

/// A step that has more than one root.
#[derive(Clone, Copy, Debug)]
pub struct Choice {
    /// Which step.
    pub step: usize,
    /// What its roots are called.
    pub name: Option<Naming>,
}

/// How the two roots of a step are called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Naming {
    /// What they decide.
    pub indicator: Indicator,
    /// Which root has the first name (left, up, no flip); for an elbow with `flipped_by` the one it has where the shoulder takes its first
    /// root.
    pub first: usize,
    /// The step of the shoulder, whose second root turns the names round: what was above is then below.
    pub flipped_by: Option<usize>,
}

impl Sequence {
    /// The solves in it, outermost first.
    pub fn solves(&self) -> Vec<&Solve> {
        let mut all = Vec::new();
        for instruction in &self.0 {
            match instruction {
                Instruction::Solve(solve) => all.push(solve),
                Instruction::ForEachRoot(over) => all.extend(over.body.solves()),
                _ => {}
            }
        }
        all
    }

    /// The reports of steps without roots, outermost first.
    pub fn reports(&self) -> Vec<&Report> {
        let mut all = Vec::new();
        for instruction in &self.0 {
            match instruction {
                Instruction::Reject(report) => all.push(report),
                Instruction::ForEachRoot(over) => all.extend(over.body.reports()),
                _ => {}
            }
        }
        all
    }

    /// What the innermost block yields.
    pub fn result(&self) -> Option<&Yield> {
        self.0.iter().find_map(|instruction| match instruction {
            Instruction::Yield(result) => Some(result),
            Instruction::ForEachRoot(over) => over.body.result(),
            _ => None,
        })
    }

    /// The same, to be changed.
    pub(super) fn result_mut(&mut self) -> Option<&mut Yield> {
        self.0.iter_mut().find_map(|instruction| match instruction {
            Instruction::Yield(result) => Some(result),
            Instruction::ForEachRoot(over) => over.body.result_mut(),
            _ => None,
        })
    }

    /// A step's solve, to be changed.
    pub(super) fn solve_mut(&mut self, step: usize) -> Option<&mut Solve> {
        self.0.iter_mut().find_map(|instruction| match instruction {
            Instruction::Solve(solve) => Some(solve).filter(|s| s.step == step),
            Instruction::ForEachRoot(over) => over.body.solve_mut(step),
            _ => None,
        })
    }
}

impl Report {
    /// The values that it needs beside those of its step.
    pub fn values(&self) -> impl Iterator<Item = Value> {
        self.distance.map(|d| d.base).into_iter()
    }
}
