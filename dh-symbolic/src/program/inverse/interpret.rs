//! Runs the program of an inverse with the kernels that generated code calls: for the self-check while the macro runs, and for worked
//! examples.

use super::{Instruction, Inverse, Loop, Report, Sequence, Solve};
use crate::algebra::{AngleVar, Point, Symbol};
use crate::chain::{Chain, Handle};
use crate::planner::{Argument, KernelRoots, Unknown};
use crate::program::Value;
use crate::program::interpret::Floats;
use dh_kernels as ik;
use ik::{Pose, Status};

/// One candidate of the inverse.
#[derive(Clone, Debug)]
pub struct InterpretedSolution {
    /// Joint coordinates; lengths over the length scale.
    pub x: Vec<f64>,
    /// Which root each step took.
    pub branch: Vec<usize>,
    /// Known combinations that were free.
    pub free: Vec<usize>,
}

/// How a run of the program ended.
#[derive(Clone, Debug, Default)]
pub struct InterpretedRun {
    /// What it found.
    pub candidates: Vec<InterpretedSolution>,
    /// What may be missing.
    pub status: Status,
    /// The step that came nearest to a root and had none.
    pub shortfall: Option<Shortfall>,
}

/// A step without a root: its equation asks for more (or less) than the arm has.
#[derive(Clone, Debug, PartialEq)]
pub struct Shortfall {
    /// Which step of the plan.
    pub step: usize,
    /// Its unknowns, as people write them.
    pub unknowns: String,
    /// What is asked for, and the limit that it passes: distances over the length scale, or the two sides of the equation.
    pub needs: f64,
    /// The limit.
    pub has: f64,
    /// Whether these are distances.
    pub is_distance: bool,
}

impl Shortfall {
    /// The one of two that is the smaller; distances and other numbers are not compared.
    fn or_nearer(self, other: Shortfall) -> Shortfall {
        let nearer =
            self.is_distance == other.is_distance && (other.needs - other.has).abs() < (self.needs - self.has).abs();
        if nearer { other } else { self }
    }
}

/// The value that a step takes for a free unknown: as an angle, and as a length.
type Sample<'a> = &'a dyn Fn(usize) -> (Unknown, f64);

/// Zero for whatever is free.
const ZERO: fn(usize) -> (Unknown, f64) = |_| ([1.0, 0.0], 0.0);

/// Absolute size (lengths over the length scale) below which a computed coefficient counts as zero.
pub const TOLERANCE: f64 = 1e-11;

/// Arms on which the cuts of the general elimination are tried.
const TRIALS: usize = 5;

impl Inverse {
    /// Takes the best cuts for the general elimination, by trial on samples of the arm; what is given varies from sample to sample.
    pub(super) fn choose_cuts(&mut self, chain: &Chain) {
        let solves = self.body.solves();
        let Some((solve, prismatic)) = solves.iter().find_map(|s| Some((*s, prismatic(s)?))) else { return };
        let step = &self.plan.steps[solve.step];
        let samples: Vec<(ik::NumericChain<6>, [f64; 6])> = crate::planner::joint_vectors(&self.plan.axes, TRIALS, 0)
            .into_iter()
            .map(|x| {
                let machine = Machine { inverse: self, chain, target: &ik::pose::IDENTITY, sample: &ZERO };
                let known: Vec<Unknown> =
                    self.plan.knowledge.known[..step.before].iter().map(|k| k.value(&x)).collect();
                let mut values = vec![0.0; self.graph.nodes().len()];
                // Nodes are in order, so those that need more than what is known can be computed as well: nobody asks for them.
                let all: Vec<u32> = (0..values.len() as u32).collect();
                machine.compute(&all, &known, &mut values);
                let pose = |r: usize| -> Pose {
                    let row = solve.equations.get(r).map_or(&[][..], Vec::as_slice);
                    std::array::from_fn(|i| {
                        std::array::from_fn(|j| row.get(3 * j + i).map_or(0.0, |v| number(*v, &values)))
                    })
                };
                let open = step.unknown.iter().map(|f| f.iter().position(|k| *k != 0).map_or(0.0, |k| x[k]));
                let mut q = [0.0; 6];
                for (q, x) in q.iter_mut().zip(open) {
                    *q = x;
                }
                (ik::NumericChain { links: std::array::from_fn(pose), prismatic }, q)
            })
            .collect();
        let ranked = ik::general::rank::<3>(&samples);
        let best = |i: usize| ranked.as_slice().get(i).or(ranked.as_slice().first()).map_or(0, |r| r.choice.number());
        let number = solve.step;
        for argument in self.body.solve_mut(number).map(|s| s.call.arguments.as_mut_slice()).unwrap_or_default() {
            if let Argument::Elimination { cuts, .. } = argument {
                *cuts = [best(0), best(1), best(2)];
            }
        }
    }

    /// All candidates for a target (lengths over the length scale) and given values of the known combinations.
    pub fn solve(&self, chain: &Chain, target: &Pose, given: &[f64]) -> Vec<InterpretedSolution> {
        self.attempt(chain, target, given, &ZERO).candidates
    }

    /// The same, with a choice of values for what steps leave free: step to `[cos, sin]` and length over the length scale.
    pub fn attempt(&self, chain: &Chain, target: &Pose, given: &[f64], sample: Sample<'_>) -> InterpretedRun {
        let machine = Machine { inverse: self, chain, target, sample };
        let mut attempt = InterpretedRun::default();
        let values = vec![0.0; self.graph.nodes().len()];
        machine.run(&self.body, State { values, given, ..State::default() }, &mut attempt);
        attempt
    }

    /// Checks the plan on sample poses: every joint vector that made a pose is found again.
    ///
    /// # Errors
    /// The number of samples that were not found, of how many.
    pub fn check(&self, chain: &Chain, samples: usize) -> Result<(), (usize, usize)> {
        let axes = &self.plan.axes;
        let solves = self.body.solves();
        let mut missed = 0;
        let vectors = crate::planner::joint_vectors(axes, samples, 0);
        for x in &vectors {
            let frames = axes.frames_number(x);
            let Some(last) = frames.last() else { continue };
            let constant = |t| crate::planner::numeric(chain, t, axes.length_scale);
            let target = ik::pose::compose(&ik::pose::compose(&constant(&axes.start), last), &constant(&axes.end));
            let known = &self.plan.knowledge.known;
            let given: Vec<f64> = known[..self.plan.given].iter().map(|k| k.at(x)).collect();
            // What the plan chooses is chosen as in the generating joint vector, so that it must come back.
            let sample = |step: usize| {
                let value = solves.get(step).and_then(|s| s.finds.first()).map_or(0.0, |k| known[*k].at(x));
                ([value.cos(), value.sin()], value)
            };
            let found = self.attempt(chain, &target, &given, &sample).candidates.iter().any(|c| {
                (0..axes.real).all(|k| {
                    let d = c.x[k] - x[k];
                    if axes.is_revolute(k) { (1.0 - d.cos()) < 1e-7 } else { d.abs() < 1e-4 }
                })
            });
            missed += usize::from(!found);
        }
        if missed == 0 { Ok(()) } else { Err((missed, vectors.len())) }
    }
}

/// What does not change during a run.
struct Machine<'a> {
    inverse: &'a Inverse,
    chain: &'a Chain,
    target: &'a Pose,
    sample: Sample<'a>,
}

/// What is known in a branch.
#[derive(Clone, Default)]
struct State<'a> {
    values: Vec<f64>,
    given: &'a [f64],
    known: Vec<Unknown>,
    branch: Vec<usize>,
    free: Vec<usize>,
}

impl Machine<'_> {
    /// Runs a block in a state of its own.
    fn run(&self, block: &Sequence, mut state: State<'_>, attempt: &mut InterpretedRun) {
        let mut last: Option<KernelRoots> = None;
        for instruction in &block.0 {
            match instruction {
                Instruction::Given { known } => {
                    let x = state.given.get(*known).copied().unwrap_or(0.0);
                    let is_angle = self.inverse.plan.knowledge.known[*known].is_angle;
                    state.known.push(if is_angle { [x.cos(), x.sin()] } else { [x, x] });
                }
                Instruction::Compute { nodes, .. } => self.compute(nodes, &state.known, &mut state.values),
                Instruction::Solve(solve) => last = Some(self.solve(solve, &state)),
                Instruction::Reject(report) => {
                    if let Some(found) = &last {
                        attempt.status.note(found.outcome, !state.free.is_empty());
                        if let Some(new) = shortfall(report, found.outcome, &state.values) {
                            attempt.shortfall = Some(match attempt.shortfall.take() {
                                Some(known) => known.or_nearer(new),
                                None => new,
                            });
                        }
                    }
                }
                Instruction::ForEachRoot(over) => {
                    if let Some(found) = last.take() {
                        self.each_root(over, &found, &state, attempt);
                    }
                }
                Instruction::Yield(result) => attempt.candidates.push(self.candidate(&result.joints, &state)),
            }
        }
    }

    fn each_root(&self, over: &Loop, found: &KernelRoots, state: &State<'_>, attempt: &mut InterpretedRun) {
        for (number, root) in found.roots.iter().enumerate() {
            let mut inner = state.clone();
            inner.branch.push(number);
            inner.known.extend(root.iter().take(over.binds.len()));
            if found.outcome == ik::Outcome::Free {
                inner.free.extend(&over.binds);
            }
            self.run(&over.body, inner, attempt);
        }
    }

    fn solve(&self, solve: &Solve, state: &State<'_>) -> KernelRoots {
        let known = &self.inverse.plan.knowledge.known;
        let free: Vec<Unknown> = solve
            .finds
            .iter()
            .enumerate()
            .map(|(i, k)| {
                let (angle, length) = (self.sample)(solve.step + i);
                if known[*k].is_angle { angle } else { [length; 2] }
            })
            .collect();
        solve.call.map(&|v| number(*v, &state.values)).run(&free, TOLERANCE)
    }

    /// Computes nodes from what is known.
    fn compute(&self, nodes: &[u32], known: &[Unknown], x: &mut [f64]) {
        let (inverse, length_scale) = (self.inverse, self.inverse.plan.axes.length_scale);
        let symbol = |s: Symbol| -> f64 {
            if let Some(i) = inverse.target.iter().position(|t| *t == s) {
                return if i < 9 { self.target[i / 3][i % 3] } else { self.target[i - 9][3] };
            }
            for (known, value) in inverse.plan.knowledge.known.iter().zip(known) {
                if let Some(i) = known.symbols.iter().position(|t| *t == s) {
                    return value[i];
                }
            }
            crate::planner::generic_parameter(self.chain, Handle::Length(s)) / length_scale
        };
        let angle = |v: AngleVar| crate::planner::generic_parameter(self.chain, Handle::Angle(v));
        let at = Point { symbol: &symbol, angle: &angle };
        for &i in nodes {
            x[i as usize] = inverse.graph.carry_out(i as usize, x, &mut Floats(&at));
        }
    }

    fn candidate(&self, joints: &[Vec<i8>], state: &State<'_>) -> InterpretedSolution {
        let known = &self.inverse.plan.knowledge.known;
        let value = |i: usize| {
            let [x, y] = state.known[i];
            if known[i].is_angle { y.atan2(x) } else { x }
        };
        let joint = |form: &Vec<i8>| -> f64 {
            form.iter().enumerate().filter(|(_, k)| **k != 0).map(|(i, k)| f64::from(*k) * value(i)).sum()
        };
        let x = joints.iter().map(joint).collect();
        InterpretedSolution { x, branch: state.branch.clone(), free: state.free.clone() }
    }
}

/// What a step without a root says of the target.
fn shortfall(report: &Report, outcome: ik::Outcome, values: &[f64]) -> Option<Shortfall> {
    let ik::Outcome::OutOfReach { needed, available } = outcome else { return None };
    let squares = report.distance.map(|d| outcome.distances([number(d.base, values), number(d.rest, values)], d.grows));
    let ([needs, has], is_distance) = match squares.flatten() {
        Some(distances) => (distances, true),
        None => ([needed, available], report.is_length),
    };
    Some(Shortfall { step: report.step, unknowns: report.unknowns.clone(), needs, has, is_distance })
}

/// The number of a value.
fn number(v: Value, values: &[f64]) -> f64 {
    if v.negative { -values[v.node as usize] } else { values[v.node as usize] }
}

/// For the general elimination: which joints are prismatic.
fn prismatic(solve: &Solve) -> Option<[bool; 6]> {
    solve.call.arguments.iter().find_map(|a| match a {
        Argument::Elimination { prismatic, .. } => Some(*prismatic),
        _ => None,
    })
}
