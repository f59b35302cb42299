//! The plan of an inverse, run root by root with the kernels that generated code calls: what `candidates` of a generated arm does.

use dh_kernels::{Outcome, Pose};
use dh_robot::runtime::{Attempt, Path, Sample};
use dh_robot::{Branch, Elbow, FreeJoints, Shoulder, Wrist};
use dh_symbolic::algebra::Symbol;
use dh_symbolic::chain::Chain;
use dh_symbolic::planner::{Call, JointCombination, Unknown};
use dh_symbolic::program::{Choice, Indicator, Instruction as Node, Inverse, Report, Sequence};

use crate::actuators::Actuators;
use crate::intern;
use crate::tape::{Instruction, Registers, Signed, run};
use crate::values::Values;

/// Most steps of a plan.
const STEPS: usize = 16;

/// A combination of joints that is given or found.
struct Known {
    /// Registers of its cosine and sine (or of its length, twice) where they are needed.
    places: [Option<usize>; 2],
    is_angle: bool,
    /// What is computed once it is known.
    then: Vec<Instruction>,
}

/// One step: a kernel with its coefficients.
struct Step {
    /// The kernel, with places for its numbers.
    call: Call<f64>,
    numbers: Vec<Signed>,
    /// The combinations that it finds.
    finds: Vec<usize>,
    roots: usize,
    /// What it is called in reports, the factor and the unit of its numbers.
    name: &'static str,
    unit: (f64, &'static str),
    /// For a law of cosines: the two parts of the squared distance, and whether the amplitude grows with it.
    distance: Option<(Signed, Signed, bool)>,
    /// a, b, c of a cos u + b sin u = c.
    sine_equation: Option<[Signed; 3]>,
    /// The joints that its free unknowns move.
    free_joints: FreeJoints,
}

/// A plan as flat instructions.
pub(crate) struct FlatPlan {
    registers: Registers,
    /// Registers of the target's entries.
    target: Vec<(usize, usize)>,
    /// What follows from the target.
    first: Vec<Instruction>,
    known: Vec<Known>,
    given: usize,
    steps: Vec<Step>,
    joints: Vec<JointCombination>,
    branch: Vec<Choice>,
    pub(crate) length_scale: f64,
}

/// The state of a run: registers, joint values of what is known, the root that each step took.
pub(crate) struct Run<'a> {
    plan: &'a FlatPlan,
    actuators: &'a Actuators,
    sample: &'a Sample,
    x: &'a mut [[f64; 1]],
    values: Vec<f64>,
    roots: [usize; STEPS],
    attempt: Attempt,
}

impl FlatPlan {
    /// The flat form of an inverse.
    pub(crate) fn new(chain: &Chain, inverse: &Inverse) -> FlatPlan {
        let outputs = inverse.values();
        let mut registers = Registers::new(chain, &inverse.graph, &outputs);
        let target: Vec<(usize, usize)> = (0..12)
            .filter_map(|k| Some((registers.node_of(inverse.target[k])?, k)))
            .collect::<Vec<_>>()
            .into_iter()
            .map(|(node, k)| (registers.place(node, 1).at as usize, k))
            .collect();
        let knowledge = &inverse.plan.knowledge;
        let symbol = |registers: &mut Registers, s: Symbol| {
            let node = registers.node_of(s)?;
            Some(registers.place(node, 1).at as usize)
        };
        let mut known: Vec<Known> = knowledge
            .known
            .iter()
            .map(|k| Known {
                places: k.symbols.map(|s| symbol(&mut registers, s)),
                is_angle: k.is_angle,
                then: Vec::new(),
            })
            .collect();
        let depths = inverse.depths();
        let mut first = Vec::new();
        for (node, _) in registers.computed().collect::<Vec<_>>() {
            let Some(instruction) = registers.instruction(node, 1) else { continue };
            match depths[node].checked_sub(1).and_then(|k| known.get_mut(k)) {
                Some(known) => known.then.push(instruction),
                None => first.push(instruction),
            }
        }
        let length_scale = inverse.plan.axes.length_scale;
        let reports = inverse.body.reports();
        let steps = inverse.body.solves().into_iter().map(|solve| {
            let report = reports.iter().find(|r| r.step == solve.step);
            let is_length = |r: &&&Report| r.is_length || r.distance.is_some();
            let unit =
                if report.filter(is_length).is_some() { (length_scale, chain.settings.unit.name) } else { (1.0, "") };
            Step {
                call: solve.call.map(&|_| 0.0),
                numbers: solve.call.numbers().into_iter().map(|v| registers.value(*v)).collect(),
                finds: solve.finds.clone(),
                roots: inverse.plan.steps[solve.step].roots,
                name: report.map_or("", |r| intern::name(&r.name())),
                unit,
                distance: report
                    .and_then(|r| r.distance)
                    .map(|d| (registers.value(d.base), registers.value(d.rest), d.grows)),
                sine_equation: solve.sine_equation().map(|e| e.map(|v| registers.value(v))),
                free_joints: free_joints(&inverse.body, solve.step),
            }
        });
        let steps = steps.collect();
        let result = inverse.body.result();
        FlatPlan {
            target,
            first,
            known,
            given: inverse.plan.given,
            steps,
            joints: result.map(|r| r.joints.clone()).unwrap_or_default(),
            branch: result.map(|r| r.branch.clone()).unwrap_or_default(),
            length_scale,
            registers,
        }
    }

    /// What the parameters fill the first registers with.
    pub(crate) fn numbers(&self, values: &Values<'_>) -> Vec<f64> {
        self.registers.prefix(&values.scaled(1.0 / self.length_scale))
    }

    /// Registers to run it in.
    pub(crate) fn space(&self, numbers: &[f64]) -> Vec<[f64; 1]> {
        let mut x = vec![[0.0]; self.registers.count as usize];
        for (to, from) in x.iter_mut().zip(numbers) {
            *to = [*from];
        }
        x
    }

    /// Runs the plan: calls `found` with every candidate.
    pub(crate) fn candidates<const N: usize>(
        &self,
        actuators: &Actuators,
        given: &[f64],
        x: &mut [[f64; 1]],
        target: &Pose,
        sample: &Sample,
        found: &mut dyn FnMut([f64; N], Branch, Path),
    ) -> Attempt {
        for (place, k) in &self.target {
            x[*place] = [if *k < 9 { target[k / 3][k % 3] } else { target[k - 9][3] }];
        }
        run(&self.first, x);
        let values = vec![0.0; self.known.len()];
        let (roots, attempt) = ([0; STEPS], Attempt::new());
        let mut state = Run { plan: self, actuators, sample, x, values, roots, attempt };
        for (k, value) in given.iter().enumerate().take(self.given) {
            let coordinate = actuators.chosen(k, *value);
            let pair = if self.known[k].is_angle {
                let (s, c) = dh_robot::math::sin_cos(coordinate);
                [c, s]
            } else {
                [coordinate / self.length_scale; 2]
            };
            state.bind(k, coordinate, pair);
        }
        state.step(0, Path::START, found);
        state.attempt
    }

    /// The plan's unknowns at joint coordinates.
    pub(crate) fn unknowns(&self, inverse: &Inverse, coordinates: &[[f64; 1]]) -> [f64; 8] {
        let axes = &inverse.plan.axes;
        let mut out = [0.0; 8];
        for (to, step) in out.iter_mut().zip(&inverse.plan.steps) {
            let Some(form) = step.unknown.first() else { continue };
            if form.iter().skip(axes.real).any(|k| *k != 0) {
                continue;
            }
            let sum: f64 = form.iter().zip(coordinates).map(|(k, [x])| f64::from(*k) * x).sum();
            let slides = form.iter().position(|k| *k != 0).is_some_and(|k| !axes.is_revolute(k));
            *to = if slides { sum / self.length_scale } else { sum };
        }
        out
    }

    /// The branch of some roots.
    pub(crate) fn branch_of(&self, roots: &[usize]) -> Branch {
        let root = |step: usize| roots.get(step).copied().unwrap_or(0);
        let mut branch = Branch::ANY;
        for (place, choice) in self.branch.iter().enumerate() {
            branch = branch.with_step(place, root(choice.step));
            let Some(name) = choice.name else { continue };
            let taken = root(choice.step) == name.first;
            let first = name.flipped_by.map_or(taken, |shoulder| taken == (root(shoulder) == 0));
            branch = match name.indicator {
                Indicator::Shoulder => branch.with_shoulder(if first { Shoulder::Left } else { Shoulder::Right }),
                Indicator::Elbow => branch.with_elbow(if first { Elbow::Up } else { Elbow::Down }),
                Indicator::Wrist => branch.with_wrist(if first { Wrist::NoFlip } else { Wrist::Flip }),
            };
        }
        branch
    }
}

impl Run<'_> {
    /// Notes what a combination is, and computes what follows.
    fn bind(&mut self, known: usize, value: f64, pair: Unknown) {
        let plan = self.plan;
        self.values[known] = value;
        for (place, x) in plan.known[known].places.iter().zip(pair) {
            if let Some(place) = place {
                self.x[*place] = [x];
            }
        }
        run(&plan.known[known].then, self.x);
    }

    /// Takes step `i` and all that follow.
    fn step<const N: usize>(&mut self, i: usize, path: Path, found: &mut dyn FnMut([f64; N], Branch, Path)) {
        let plan = self.plan;
        let Some(step) = plan.steps.get(i) else { return self.finish(path, found) };
        let sample = self.sample;
        let free: Vec<Unknown> = step
            .finds
            .iter()
            .enumerate()
            .map(|(k, known)| match plan.known[*known].is_angle {
                true => sample.angle(i + k),
                false => [sample.length(i + k); 2],
            })
            .collect();
        let numbers: Vec<f64> = step.numbers.iter().map(|v| v.number(self.x)).collect();
        let roots = step.call.run_with(&numbers, &free, sample.tolerance);
        if roots.outcome != Outcome::Regular {
            let (scale, unit) = step.unit;
            match step.distance {
                Some((base, rest, grows)) => {
                    let parts = [base.number(self.x), rest.number(self.x)];
                    self.attempt.note_law(roots.outcome, &path, step.name, parts, grows, scale, unit);
                }
                None => self.attempt.note(roots.outcome, &path, step.name, scale, unit),
            }
        }
        if let Some(equation) = step.sine_equation.filter(|_| i > 0 && path.is_chosen()) {
            self.attempt.see(i, &path, equation.map(|v| v.number(self.x)));
        }
        let path = match roots.outcome {
            Outcome::Free => self.attempt.choose(i, &path, step.free_joints),
            _ => path,
        };
        for (number, root) in roots.roots.iter().enumerate() {
            let path = if step.roots > 1 { path.root(i, number) } else { path };
            if let Some(place) = self.roots.get_mut(i) {
                *place = number;
            }
            for (known, pair) in step.finds.iter().zip(root) {
                let value = match plan.known[*known].is_angle {
                    true => dh_robot::math::atan2(pair[1], pair[0]),
                    false => pair[0] * plan.length_scale,
                };
                self.bind(*known, value, *pair);
            }
            self.step(i + 1, path, found);
        }
    }

    /// A candidate.
    fn finish<const N: usize>(&mut self, path: Path, found: &mut dyn FnMut([f64; N], Branch, Path)) {
        let x: [f64; N] = std::array::from_fn(|i| combination(&self.plan.joints[i], |k| self.values[k]));
        found(self.actuators.of(&x), self.plan.branch_of(&self.roots), path);
    }
}

/// A sum of known values with whole factors.
pub(crate) fn combination(form: &[i8], value: impl Fn(usize) -> f64) -> f64 {
    form.iter().enumerate().filter(|(_, k)| **k != 0).map(|(i, k)| f64::from(*k) * value(i)).sum()
}

/// The joints that a step leaves free where its equations say nothing.
fn free_joints(body: &Sequence, step: usize) -> FreeJoints {
    body.0.iter().fold(FreeJoints::NONE, |all, node| match node {
        Node::ForEachRoot(over) if over.step == step => all.union(FreeJoints::of(&over.free_joints)),
        Node::ForEachRoot(over) => all.union(free_joints(&over.body, step)),
        _ => all,
    })
}
