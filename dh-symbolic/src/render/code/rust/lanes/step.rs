//! One step of the plan for all lanes: its roots, and how they are spread over the lanes of the next depth.

use super::kernel;
use super::loops::Layout;
use super::segments::What;
use super::writer::Writer;
use crate::chain::{Chain, Scalar};
use crate::planner::{BatchedKernel, BatchedRoots, Coefficient};
use crate::program::{Node, Solve};
use crate::render::code::body::{Body, Dialect};
use crate::render::code::literal;
use crate::render::code::steps::argument;

/// The roots of a step, as the loops name them. A slide has its length over the reach for cosine and sine both.
struct Roots {
    /// Which step.
    step: usize,
    /// What later steps call cosine and sine.
    names: [String; 2],
    /// Cosine and sine of the first root.
    first: [String; 2],
    /// The same of the second one, where there is one.
    second: [String; 2],
    /// Does the unknown turn?
    turns: bool,
    /// Is the second root the opposite of the first?
    opposite: bool,
    /// Length of the arm, as code.
    reach: String,
    /// Where they are kept.
    layout: Layout,
    /// Lanes of the next depth.
    spread: usize,
}

impl Roots {
    /// Expression of the joint value of the first root.
    fn first_angle(&self) -> String {
        self.angle(&self.first)
    }

    /// Expression of the joint value of the second root; that of the first has the name g.
    fn second_angle(&self) -> String {
        if self.opposite {
            format!("::dh_robot::runtime::lanes::opposite(g{})", self.step)
        } else {
            self.angle(&self.second)
        }
    }

    fn angle(&self, [x, y]: &[String; 2]) -> String {
        if self.turns {
            format!("::dh_robot::runtime::lanes::angle({y}, {x})")
        } else {
            format!("{x} * {}", self.reach)
        }
    }
}

impl Writer<'_> {
    /// One step for all lanes that its coefficients need; cosine and sine are then spread over the lanes of the next depth.
    pub(super) fn step(&mut self, body: &mut Body<'_>, chain: &Chain, i: usize) {
        self.load_nodes(body, What::Step(i));
        let solves = self.inverse.body.solves();
        let (Some(solve), Some(kernel)) = (solves.get(i), solves.get(i).and_then(|s| kernel(self.inverse, s))) else {
            return;
        };
        let known = &self.inverse.plan.knowledge.known[solve.finds[0]];
        let known_before = i + self.inverse.plan.given;
        let (p, before, spread) = (self.loops.lanes, self.all[known_before], self.all[known_before + 1]);
        let layout = Layout { before, roots: spread / before, p };
        let names = known.symbols.map(|x| self.variables.name(x));
        // One root in every lane of the depth needs no spreading.
        let direct = layout.roots == 1 && p == before;
        let first = if direct { names.clone() } else { [format!("x{i}"), format!("y{i}")] };
        let opposite = kernel.roots == BatchedRoots::Opposite;
        let second = if opposite { first.clone().map(|x| format!("-{x}")) } else { [format!("z{i}"), format!("w{i}")] };
        let reach = literal(self.inverse.plan.axes.reach, Scalar::F64);
        let roots = Roots { step: i, names, first, second, turns: known.turns, opposite, reach, layout, spread };
        self.loops.inner.push_str(&format!("// {}\n", known.name));
        self.solve(body, chain, solve, &kernel, &roots);
        if direct {
            self.keep(chain, &roots);
        } else if p == 1 {
            self.spread_one(chain, &roots);
        } else {
            self.spread_lanes(chain, &roots);
        }
    }

    /// The roots, whatever becomes of them, and how well they are determined.
    fn solve(&mut self, body: &Body<'_>, chain: &Chain, solve: &Solve, kernel: &BatchedKernel, roots: &Roots) {
        let (i, [x, y], [z, w]) = (roots.step, &roots.first, &roots.second);
        let number = |c: &Coefficient| {
            let at = |row: &usize, place: &usize| solve.equations.get(*row).and_then(|r| r.get(*place)).copied();
            match c {
                Coefficient::Plus(row, place) => at(row, place).map_or("0.0".into(), |v| body.value(v)),
                Coefficient::Minus(row, place) => at(row, place).map_or("0.0".into(), |v| body.value(-v)),
                Coefficient::Zero => "0.0".into(),
            }
        };
        let arguments: Vec<String> = kernel.arguments.iter().map(|a| argument(Dialect::Rust, a, &number, "")).collect();
        let name = kernel.single_precision.filter(|_| chain.scalar == Scalar::F32).unwrap_or(kernel.name);
        let call = format!("::dh_robot::runtime::lanes::{name}({})", arguments.join(", "));
        let two = kernel.roots == BatchedRoots::Two;
        let found = match (two, roots.turns) {
            (true, _) => format!("[{x}, {y}, {z}, {w}]"),
            (false, true) => format!("[{x}, {y}]"),
            (false, false) => x.clone(),
        };
        let valid = if two { format!(", e{i}") } else { String::new() };
        let pattern = if kernel.has_margin { format!("({found}{valid}, m{i})") } else { found };
        self.loops.inner.push_str(&format!("let {pattern} = {call};\n"));
        if !roots.turns {
            self.loops.inner.push_str(&format!("let {y} = {x};\n"));
        }
        if kernel.has_margin {
            self.loops.judge(0, format!("m{i}"));
        }
        if two {
            self.loops.judge(1, format!("e{i}"));
        }
    }

    /// One root in every lane: it has its name already, and is stored where a later loop needs it.
    fn keep(&mut self, chain: &Chain, roots: &Roots) {
        for name in &roots.names {
            let later = (0..self.depths.len()).any(|k| {
                let symbol = matches!(self.inverse.graph.nodes()[k], Node::Symbol(_));
                symbol && self.wanted[k] > self.loops.segment && self.name(k) == *name
            });
            self.loops.define(name);
            if later && roots.layout.p > 1 {
                self.loops.store(name, name);
            }
        }
        self.angle(chain, roots.step, &roots.first_angle());
    }

    /// A step that is solved once: its roots are written out for the lanes.
    fn spread_one(&mut self, chain: &Chain, roots: &Roots) {
        let (i, [x, y], [z, w]) = (roots.step, &roots.first, &roots.second);
        for (name, (first, second)) in roots.names.iter().zip([(x, z), (y, w)]) {
            let lanes = (0..roots.spread).map(|k| if k < roots.layout.before { first.as_str() } else { second });
            self.loops.inner.push_str(&format!("let {name}_ = [{}];\n", lanes.collect::<Vec<_>>().join(", ")));
            self.loops.arrays.insert(name.clone(), Layout::plain(roots.spread));
        }
        if roots.layout.roots == 1 {
            self.angle(chain, i, &roots.first_angle());
            return;
        }
        let angles = if roots.turns {
            format!("::dh_robot::runtime::lanes::angles(&[{y}, {w}], &[{x}, {z}])")
        } else {
            format!("[{}, {}]", roots.first_angle(), roots.second_angle())
        };
        self.loops.inner.push_str(&format!("let g{i}_ = {angles};\n"));
        self.loops.arrays.insert(format!("g{i}"), roots.layout);
    }

    /// A step that is solved in a loop: its roots go into arrays, the second one behind the first.
    fn spread_lanes(&mut self, chain: &Chain, roots: &Roots) {
        let Layout { before, roots: count, p } = roots.layout;
        let (i, [x, y], [z, w], many) = (roots.step, &roots.first, &roots.second, p * count);
        self.loops.before.push_str(&format!("let mut f{i} = [[0.0; {many}]; 2];\n"));
        self.loops.inner.push_str(&format!("f{i}[0][l] = {x};\nf{i}[1][l] = {y};\n"));
        if count > 1 {
            self.loops.inner.push_str(&format!("f{i}[0][l + {p}] = {z};\nf{i}[1][l + {p}] = {w};\n"));
        }
        if roots.turns && p < 4 {
            // Such a short loop is unrolled: the angles are better taken together.
            self.loops
                .after
                .push_str(&format!("let g{i}_ = ::dh_robot::runtime::lanes::angles(&f{i}[1], &f{i}[0]);\n"));
            if let Some(k) = self.alone(i) {
                let value = self.joint_value(chain, k, &self.only(i, format!("g{i}_[{}]", roots.layout.index())));
                self.loops.after.push_str(&format!("q[{k}] = ::core::array::from_fn(|l| {value});\n"));
                self.written.insert(k);
            }
        } else {
            self.loops.before.push_str(&format!("let mut g{i}_ = [0.0; {many}];\n"));
            self.loops.inner.push_str(&format!("let g{i} = {};\ng{i}_[l] = g{i};\n", roots.first_angle()));
            if count > 1 {
                self.loops.inner.push_str(&format!("let h{i} = {};\ng{i}_[l + {p}] = h{i};\n", roots.second_angle()));
                if p == before {
                    self.joint(chain, i, &[format!("g{i}"), format!("h{i}")], p);
                }
            }
        }
        self.loops.arrays.insert(format!("g{i}"), roots.layout);
        for (k, name) in roots.names.iter().enumerate() {
            let text = if p == before {
                format!("f{i}[{k}]")
            } else {
                let (spread, index) = (roots.spread, roots.layout.index());
                format!("::core::array::from_fn::<f64, {spread}, _>(|l| f{i}[{k}][{index}])")
            };
            self.loops.after.push_str(&format!("let {name}_ = {text};\n"));
            self.loops.arrays.insert(name.clone(), Layout::plain(roots.spread));
        }
    }
}
