//! Runs an inverse program with the kernels that generated code calls: for the self-check while the macro runs, and for worked
//! examples.

use super::{Inverse, Node, Solver};
use crate::algebra::{Point, Symbol};
use crate::chain::{Chain, Handle};
use crate::planner::StepKind;
use dh_kernels as ik;
use ik::Pose;

/// One candidate of the inverse.
#[derive(Clone, Debug)]
pub struct Candidate {
    /// Joint coordinates; lengths over the reach.
    pub x: Vec<f64>,
    /// Which root each step took.
    pub branch: Vec<usize>,
    /// Known combinations that were free.
    pub free: Vec<usize>,
}

/// How a run of the plan ended.
#[derive(Clone, Debug, Default)]
pub struct Attempt {
    /// What it found.
    pub candidates: Vec<Candidate>,
    /// Did some step leave its unknown free?
    pub degenerate: bool,
    /// Did a chosen value lead to nothing, or a step without a root come after a double one or just miss it?
    pub lost: bool,
    /// Did a step have a double root, or nearly?
    pub grazed: bool,
    /// Did a step end without a root in a way that may hide one?
    pub doubt: bool,
}

/// The value that a step takes for a free unknown.
type Pick<'a> = &'a dyn Fn(usize) -> (Pair, f64);

/// Zero for whatever is free.
const ZERO: fn(usize) -> (Pair, f64) = |_| ([1.0, 0.0], 0.0);

/// Absolute size (lengths over the reach) below which a computed coefficient counts as zero.
pub const NOISE: f64 = 1e-11;

/// Cosine and sine, or a length twice.
type Pair = [f64; 2];

impl Inverse {
    /// The best cuts for the general elimination, by trial on samples of the arm; what is given varies from sample to sample.
    pub(super) fn best_choices(&self, chain: &Chain) -> [u8; 3] {
        let Some(i) = self.solvers.iter().position(|s| s.kind == StepKind::General) else { return [0; 3] };
        let (solver, step) = (&self.solvers[i], &self.plan.steps[i]);
        let samples: Vec<(ik::Chain<6>, [f64; 6])> = crate::planner::joint_vectors(&self.plan.axes, TRIALS, 0)
            .into_iter()
            .map(|x| {
                let mut run = Run::new(self, chain, &ik::pose::IDENTITY, &ZERO);
                let mut values = vec![0.0; run.depths.len()];
                run.evaluate(&mut values, 0);
                for k in 0..step.before {
                    run.known.push(self.plan.knowledge.known[k].value(&x));
                    run.evaluate(&mut values, k + 1);
                }
                let rows = numbers(solver, &values);
                let links = std::array::from_fn(|r| pose_of(&rows[r]));
                let open = step.unknown.iter().map(|f| f.iter().position(|k| *k != 0).map_or(0.0, |k| x[k]));
                let mut q = [0.0; 6];
                for (q, x) in q.iter_mut().zip(open) {
                    *q = x;
                }
                (ik::Chain { links, slides: self.slides }, q)
            })
            .collect();
        let ranked = ik::general::rank::<3>(&samples);
        let number = |i: usize| ranked.as_slice().get(i).or(ranked.as_slice().first()).map_or(0, |r| r.choice.number());
        [number(0), number(1), number(2)]
    }

    /// All candidates for a target (lengths over the reach) and given values of the known combinations.
    pub fn solve(&self, chain: &Chain, target: &Pose, given: &[f64]) -> Vec<Candidate> {
        self.attempt(chain, target, given, &ZERO).candidates
    }

    /// The same, with a choice of values for what steps leave free: step to `[cos, sin]` and length over the reach.
    pub fn attempt(&self, chain: &Chain, target: &Pose, given: &[f64], pick: Pick<'_>) -> Attempt {
        let mut run = Run::new(self, chain, target, pick);
        let mut values = vec![0.0; run.depths.len()];
        run.evaluate(&mut values, 0);
        for (i, x) in given.iter().enumerate() {
            let pair = if self.plan.knowledge.known[i].turns { [x.cos(), x.sin()] } else { [*x, *x] };
            run.known.push(pair);
            run.evaluate(&mut values, i + 1);
        }
        run.step(0, &values);
        run.found
    }

    /// Checks the plan on sample poses: every joint vector that made a pose is found again.
    ///
    /// # Errors
    /// The number of samples that were not found, of how many.
    pub fn check(&self, chain: &Chain, samples: usize) -> Result<(), (usize, usize)> {
        let axes = &self.plan.axes;
        let mut missed = 0;
        let vectors = crate::planner::joint_vectors(axes, samples, 0);
        for x in &vectors {
            let frames = axes.frames_number(x);
            let Some(last) = frames.last() else { continue };
            let constant = |t| crate::planner::numeric(chain, t, axes.reach);
            let target = ik::pose::compose(&ik::pose::compose(&constant(&axes.start), last), &constant(&axes.end));
            let given: Vec<f64> = self.plan.knowledge.known[..self.plan.given]
                .iter()
                .map(|k| k.form.iter().zip(x).map(|(k, x)| f64::from(*k) * x).sum())
                .collect();
            // What the plan chooses is chosen as in the generating joint vector, so that it must come back.
            let pick = |step: usize| {
                let known =
                    self.solvers.get(step).and_then(|s| s.finds.first()).map(|k| &self.plan.knowledge.known[*k]);
                let value = known.map_or(0.0, |k| k.form.iter().zip(x).map(|(k, x)| f64::from(*k) * x).sum::<f64>());
                ([value.cos(), value.sin()], value)
            };
            let found = self.attempt(chain, &target, &given, &pick).candidates.iter().any(|c| {
                (0..axes.real).all(|k| {
                    let d = c.x[k] - x[k];
                    if axes.turns(k) { (1.0 - d.cos()) < 1e-7 } else { d.abs() < 1e-4 }
                })
            });
            missed += usize::from(!found);
        }
        if missed == 0 { Ok(()) } else { Err((missed, vectors.len())) }
    }
}

struct Run<'a> {
    inverse: &'a Inverse,
    chain: &'a Chain,
    target: &'a Pose,
    depths: Vec<usize>,
    live: Vec<bool>,
    known: Vec<Pair>,
    branch: Vec<usize>,
    free: Vec<usize>,
    pick: Pick<'a>,
    found: Attempt,
}

impl<'a> Run<'a> {
    fn new(inverse: &'a Inverse, chain: &'a Chain, target: &'a Pose, pick: Pick<'a>) -> Run<'a> {
        let depths = inverse.depths();
        let mut live = vec![false; depths.len()];
        for s in &inverse.solvers {
            for (i, l) in inverse.graph.live(&s.rows.concat()).into_iter().enumerate() {
                live[i] |= l;
            }
        }
        let (known, branch, free, found) = (Vec::new(), Vec::new(), Vec::new(), Attempt::default());
        Run { inverse, chain, target, depths, live, known, branch, free, pick, found }
    }

    /// Computes the nodes of one depth.
    fn evaluate(&self, x: &mut [f64], depth: usize) {
        let reach = self.inverse.plan.axes.reach;
        let symbol = |s: Symbol| -> f64 {
            if let Some(i) = self.inverse.target.iter().position(|t| *t == s) {
                return if i < 9 { self.target[i / 3][i % 3] } else { self.target[i - 9][3] };
            }
            for (known, value) in self.inverse.plan.knowledge.known.iter().zip(&self.known) {
                if let Some(i) = known.symbols.iter().position(|t| *t == s) {
                    return value[i];
                }
            }
            crate::planner::generic_parameter(self.chain, Handle::Length(s)) / reach
        };
        let angle = |v| crate::planner::generic_parameter(self.chain, Handle::Angle(v));
        let at = Point { symbol: &symbol, angle: &angle };
        for (i, node) in self.inverse.graph.nodes().iter().enumerate() {
            if self.depths[i] != depth || !self.live[i] {
                continue;
            }
            let wave = |w: u32| {
                let wave = &self.inverse.graph.waves()[w as usize];
                wave.terms.iter().map(|(v, k)| f64::from(*k) * angle(*v)).sum::<f64>() + wave.constant.radians()
            };
            x[i] = match *node {
                Node::Constant(k) => self.inverse.graph.constants()[k as usize].evaluate(&at),
                Node::Symbol(s) => symbol(s),
                Node::Cos(w) => wave(w).cos(),
                Node::Sin(w) => wave(w).sin(),
                Node::Add(a, b) => {
                    let (l, r) = (x[a.node as usize], x[b.node as usize]);
                    if b.negative { l - r } else { l + r }
                }
                Node::Mul(a, b) => x[a as usize] * x[b as usize],
            };
        }
    }

    fn step(&mut self, i: usize, values: &[f64]) {
        let inverse = self.inverse;
        let Some(solver) = inverse.solvers.get(i) else {
            self.finish();
            return;
        };
        let rows = numbers(solver, values);
        let turns = solver.finds.first().is_some_and(|k| inverse.plan.knowledge.known[*k].turns);
        let (roots, outcome) = solve_step((i, turns, solver), &rows, inverse, self.pick);
        let is_free = outcome == ik::Outcome::Free;
        self.found.degenerate |= is_free;
        self.found.grazed |= outcome == ik::Outcome::Touching;
        self.found.lost |=
            roots.is_empty() && (!self.free.is_empty() || self.found.grazed || outcome.just_misses_a_root());
        self.found.doubt |= roots.is_empty() && outcome.may_hide_a_root();
        for (r, root) in roots.into_iter().enumerate() {
            let mut next = values.to_vec();
            self.branch.push(r);
            let free = self.free.len();
            for (k, pair) in root.iter().enumerate() {
                self.known.push(*pair);
                if is_free {
                    self.free.push(solver.finds[k]);
                }
                self.evaluate(&mut next, self.known.len());
            }
            self.step(i + 1, &next);
            self.known.truncate(self.known.len() - root.len());
            self.branch.pop();
            self.free.truncate(free);
        }
    }

    fn finish(&mut self) {
        let plan = &self.inverse.plan;
        let value = |i: usize| {
            if plan.knowledge.known[i].turns { self.known[i][1].atan2(self.known[i][0]) } else { self.known[i][0] }
        };
        let x = self
            .inverse
            .joints
            .iter()
            .map(|form| form.iter().enumerate().filter(|(_, k)| **k != 0).map(|(i, k)| f64::from(*k) * value(i)).sum())
            .collect();
        self.found.candidates.push(Candidate { x, branch: self.branch.clone(), free: self.free.clone() });
    }
}

/// Arms on which the cuts of the general elimination are tried.
const TRIALS: usize = 5;

/// The coefficients of a step.
fn numbers(solver: &Solver, values: &[f64]) -> Vec<Vec<f64>> {
    let signed = |v: &super::Value| if v.negative { -values[v.node as usize] } else { values[v.node as usize] };
    solver.rows.iter().map(|row| row.iter().map(signed).collect()).collect()
}

/// A pose from its columns.
fn pose_of(row: &[f64]) -> Pose {
    std::array::from_fn(|i| std::array::from_fn(|j| row.get(3 * j + i).copied().unwrap_or(0.0)))
}

fn nine(row: &[f64]) -> [f64; 9] {
    std::array::from_fn(|i| row.get(i).copied().unwrap_or(0.0))
}

/// The roots of one step, and why there are as many.
fn solve_step(
    (step, turns, solver): (usize, bool, &Solver),
    rows: &[Vec<f64>],
    inverse: &Inverse,
    pick: Pick<'_>,
) -> (Vec<Vec<Pair>>, ik::Outcome) {
    let (angle, length) = pick(step);
    let second = pick(step + 1).0;
    let angles = |found: ik::Angles<2>| {
        let outcome = found.outcome;
        (found.or_if_free(angle).iter().map(|r| vec![*r]).collect(), outcome)
    };
    match solver.kind {
        StepKind::Linear => {
            let (a, b) = (rows[0][0], rows[0][1]);
            let found = ik::solve_quadratic(0.0, a, b, NOISE);
            let outcome = found.outcome;
            (found.or_if_free(length).iter().map(|d| vec![[*d, *d]]).collect(), outcome)
        }
        StepKind::Quadratic => {
            let found = ik::solve_quadratic(rows[0][0], rows[0][1], rows[0][2], NOISE);
            let outcome = found.outcome;
            (found.or_if_free(length).iter().map(|d| vec![[*d, *d]]).collect(), outcome)
        }
        StepKind::HalfTurn => angles(match rows {
            [p, q, ..] => ik::solve_half_turn([p[0], p[1]], [q[0], q[1]], NOISE),
            _ => ik::solve_sincos(rows[0][0], rows[0][1], 0.0, NOISE),
        }),
        StepKind::SinCos => angles(ik::solve_sincos(rows[0][0], rows[0][1], -rows[0][2], NOISE)),
        StepKind::AtanPair => {
            let r = |i: usize| rows.get(i).map_or([0.0; 3], |r| [r[0], r[1], -r[2]]);
            angles(match rows.len() {
                2 => ik::solve_pair(r(0)[0], r(0)[1], r(0)[2], r(1)[0], r(1)[1], r(1)[2], NOISE),
                3 => ik::solve_many(&[r(0), r(1), r(2)], NOISE),
                _ => ik::solve_many(&[r(0), r(1), r(2), r(3)], NOISE),
            })
        }
        StepKind::SecondHarmonic => {
            let r = &rows[0];
            let p = ik::TrigPoly::<2> { constant: r[0], cos: [r[1], r[3]], sin: [r[2], r[4]] };
            let found = p.roots::<4>(NOISE);
            let outcome = found.outcome;
            (found.or_if_free(angle).iter().map(|r| vec![*r]).collect(), outcome)
        }
        StepKind::Bilinear => {
            let found = ik::solve_bilinear_choosing(&nine(&rows[0]), &nine(&rows[1]), [angle, second], NOISE);
            let outcome = found.outcome;
            (found.iter().map(|r| r.to_vec()).collect(), outcome)
        }
        StepKind::SlideAndTurn => {
            let (e1, e2) = (nine(&rows[0]), nine(&rows[1]));
            let found = ik::solve_length_squared_and_angle_choosing(&e1, &e2, (length, second), NOISE);
            let outcome = found.outcome;
            (found.iter().map(|r| vec![[r.0, r.0], r.1]).collect(), outcome)
        }
        StepKind::Choose => (vec![vec![if turns { angle } else { [length, length] }]], ik::Outcome::Free),
        StepKind::General => {
            let links = std::array::from_fn(|r| pose_of(&rows[r]));
            let cuts = inverse.choices.map(ik::general::Choice::new);
            let arm = ik::general::General6R::with_slides(&links, &inverse.slides, cuts);
            let count = solver.finds.len();
            let found = arm.find(&pose_of(&rows[6]));
            (found.iter().map(|r| r[..count].to_vec()).collect(), found.outcome)
        }
    }
}
