//! One step of the plan for all branches: its roots, and how they are spread over the branches of the next loop.

use super::loops::Layout;
use super::writer::BatchedWriter;
use crate::chain::Scalar;
use crate::planner::BatchedRoots;
use crate::program::{BatchedSolve, Node, What};
use crate::render::code::body::{Body, Dialect};
use crate::render::code::steps::argument;

/// The names that the loops give to the roots of a step. A length (over the length scale) takes the place of both cosine and sine.
struct StepNames {
    /// Which step.
    step: usize,
    /// The joint value of the first root, and of the second.
    values: [String; 2],
    /// What later steps call cosine and sine.
    names: [String; 2],
    /// Cosine and sine of the first root.
    first: [String; 2],
    /// The same of the second one, where there is one.
    second: [String; 2],
    /// Whether the unknown is an angle.
    is_angle: bool,
    /// Whether the second root is the opposite of the first.
    opposite: bool,
    /// Where they are kept.
    layout: Layout,
    /// Branches of the next loop.
    spread: usize,
}

impl StepNames {
    /// Expression of the joint value of the first root.
    fn first_angle(&self) -> String {
        self.angle(&self.first)
    }

    /// Expression of the joint value of the second root, from that of the first where it can be.
    fn second_angle(&self) -> String {
        if self.opposite {
            format!("::dh_robot::runtime::batched::opposite({})", self.values[0])
        } else {
            self.angle(&self.second)
        }
    }

    fn angle(&self, [x, y]: &[String; 2]) -> String {
        if self.is_angle {
            format!("::dh_robot::runtime::batched::angle({y}, {x})")
        } else {
            format!("{x} * Self::LENGTH_SCALE")
        }
    }

    /// The names to spread: cosine and sine, or the length once; with their place in the pair.
    fn parts(&self) -> impl Iterator<Item = (usize, &String)> {
        self.names.iter().enumerate().take(if self.is_angle { 2 } else { 1 })
    }
}

impl BatchedWriter<'_> {
    /// One step for all branches that its coefficients need; cosine and sine are then spread over the branches of the next loop.
    pub(super) fn step(&mut self, body: &mut Body<'_>, i: usize) {
        self.load_nodes(body, What::Step(i));
        let solve = &self.batched.solves[i];
        let before_it = i + self.inverse.plan.given;
        let (p, before, spread) =
            (self.loops.width, self.batched.widths[before_it], self.batched.widths[before_it + 1]);
        let layout = Layout { before, roots: spread / before, p };
        let variable = self.variables.known[solve.known].clone();
        let (names, is_angle) = (variable.pair, variable.is_angle);
        // One root in every branch of the loop needs no spreading.
        let direct = layout.roots == 1 && p == before;
        let of_root = |root: &str| names.clone().map(|n| format!("{n}_{root}"));
        let first = if direct { names.clone() } else { of_root("first") };
        let opposite = solve.kernel.roots == BatchedRoots::Opposite;
        let second = if opposite { first.clone().map(|x| format!("-{x}")) } else { of_root("second") };
        let values = [variable.value.clone(), format!("{}_second", variable.value)];
        let roots = StepNames { step: i, values, names, first, second, is_angle, opposite, layout, spread };
        let name = self.inverse.plan.steps[i].words().name.english;
        let unknown = &self.inverse.plan.knowledge.known[solve.known].name;
        self.loops.inner.push_str(&format!("// Step {}: {unknown} from {name}.\n", i + 1));
        self.solve(body, solve, &roots);
        if direct {
            self.keep(&roots);
        } else if p == 1 {
            self.spread_one(&roots);
        } else {
            self.spread_branches(&roots);
        }
    }

    /// The roots, whatever becomes of them, and how well they are determined.
    fn solve(&mut self, body: &Body<'_>, solve: &BatchedSolve, roots: &StepNames) {
        let (value, [x, y], [z, w]) = (&roots.values[0], &roots.first, &roots.second);
        let kernel = &solve.kernel;
        let arguments: Vec<String> =
            solve.arguments.iter().map(|a| argument(Dialect::Rust, a, &|v| body.value(*v), "")).collect();
        let name = kernel.single_precision.filter(|_| self.chain.settings.scalar == Scalar::F32).unwrap_or(kernel.name);
        let call = format!("::dh_robot::runtime::batched::{name}({})", arguments.join(", "));
        let two = kernel.roots == BatchedRoots::Two;
        let found = match (two, roots.is_angle) {
            (true, _) => format!("[{x}, {y}, {z}, {w}]"),
            (false, true) => format!("[{x}, {y}]"),
            (false, false) => x.clone(),
        };
        let valid = if two { format!(", {value}_valid") } else { String::new() };
        let pattern = if kernel.has_margin { format!("({found}{valid}, {value}_margin)") } else { found };
        self.loops.inner.push_str(&format!("let {pattern} = {call};\n"));
        if kernel.has_margin {
            self.loops.judge(0, format!("{value}_margin"));
        }
        if two {
            self.loops.judge(1, format!("{value}_valid"));
        }
    }

    /// One root in every branch: it has its name already, and is stored where a later loop needs it.
    fn keep(&mut self, roots: &StepNames) {
        for (_, name) in roots.parts() {
            let later = (0..self.batched.depths.len()).any(|k| {
                let symbol = matches!(self.inverse.graph.nodes()[k], Node::Symbol(_));
                symbol && self.batched.last_use[k] > self.loops.number && self.name(k).as_ref() == Some(name)
            });
            self.loops.define(name);
            if later && roots.layout.p > 1 {
                self.loops.store(name, name);
            }
        }
        self.joint_value_of(roots.step, &roots.first_angle());
    }

    /// A step that is solved once: its roots are written out for the branches.
    fn spread_one(&mut self, roots: &StepNames) {
        let (value, [x, y], [z, w]) = (&roots.values[0], &roots.first, &roots.second);
        for (k, name) in roots.parts() {
            let (first, second) = (&roots.first[k], &roots.second[k]);
            let branches = (0..roots.spread).map(|b| if b < roots.layout.before { first.as_str() } else { second });
            self.loops.inner.push_str(&format!("let all_{name} = [{}];\n", branches.collect::<Vec<_>>().join(", ")));
            self.loops.arrays.insert(name.clone(), Layout::plain(roots.spread));
        }
        if roots.layout.roots == 1 {
            self.joint_value_of(roots.step, &roots.first_angle());
            return;
        }
        let angles = if roots.is_angle {
            format!("::dh_robot::runtime::batched::angles(&[{y}, {w}], &[{x}, {z}])")
        } else {
            format!("[{}, {}]", roots.first_angle(), roots.second_angle())
        };
        self.loops.inner.push_str(&format!("let all_{value} = {angles};\n"));
        self.loops.arrays.insert(value.clone(), roots.layout);
    }

    /// A step that is solved in a loop: its roots go into arrays, the second one behind the first.
    fn spread_branches(&mut self, roots: &StepNames) {
        let Layout { before, roots: count, p } = roots.layout;
        let (step, many, [value, other]) = (roots.step, p * count, &roots.values);
        let array = format!("{value}_pairs");
        self.loops.before.push_str(&format!("let mut {array} = [[0.0; {many}]; 2];\n"));
        for (k, _) in roots.parts() {
            self.loops.inner.push_str(&format!("{array}[{k}][branch] = {};\n", roots.first[k]));
        }
        if count > 1 {
            for (k, _) in roots.parts() {
                self.loops.inner.push_str(&format!("{array}[{k}][branch + {p}] = {};\n", roots.second[k]));
            }
        }
        if roots.is_angle && p < 4 {
            // Such a short loop is unrolled: the angles are better taken together.
            self.loops.after.push_str(&format!(
                "let all_{value} = ::dh_robot::runtime::batched::angles(&{array}[1], &{array}[0]);\n"
            ));
            if let Some(k) = self.alone(step) {
                let text = self.motor_value(k, &self.only(step, format!("all_{value}[{}]", roots.layout.index())));
                self.loops.after.push_str(&format!("q[{k}] = ::core::array::from_fn(|branch| {text});\n"));
                self.written.insert(k);
            }
        } else {
            self.loops.before.push_str(&format!("let mut all_{value} = [0.0; {many}];\n"));
            self.loops
                .inner
                .push_str(&format!("let {value} = {};\nall_{value}[branch] = {value};\n", roots.first_angle()));
            if count > 1 {
                self.loops.inner.push_str(&format!(
                    "let {other} = {};\nall_{value}[branch + {p}] = {other};\n",
                    roots.second_angle()
                ));
                if p == before {
                    self.actuator(step, &roots.values, p);
                }
            }
        }
        self.loops.arrays.insert(value.clone(), roots.layout);
        for (k, name) in roots.parts() {
            let text = if p == before {
                format!("{array}[{k}]")
            } else {
                let (spread, index) = (roots.spread, roots.layout.index());
                format!("::core::array::from_fn::<f64, {spread}, _>(|branch| {array}[{k}][{index}])")
            };
            self.loops.after.push_str(&format!("let all_{name} = {text};\n"));
            self.loops.arrays.insert(name.clone(), Layout::plain(roots.spread));
        }
    }
}
