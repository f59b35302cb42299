//! One step of the plan for all lanes: its roots, and how they are spread over the lanes of the next depth.

use super::loops::Layout;
use super::segments::What;
use super::writer::Writer;
use crate::algebra::Poly;
use crate::chain::{Chain, Scalar};
use crate::planner::StepKind;
use crate::program::{Node, Solver};
use crate::render::code::body::Body;
use crate::render::code::literal;
use crate::render::code::steps::identifier;

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
        let solver = &self.inverse.solvers[i];
        let known = &self.inverse.plan.knowledge.known[solver.finds[0]];
        let known_before = i + self.inverse.plan.given;
        let (p, before, spread) = (self.loops.lanes, self.all[known_before], self.all[known_before + 1]);
        let layout = Layout { before, roots: spread / before, p };
        let names = known.symbols.map(|x| identifier(self.inverse.plan.knowledge.ring.symbol_name(x)));
        // One root in every lane of the depth needs no spreading.
        let direct = layout.roots == 1 && p == before;
        let first = if direct { names.clone() } else { [format!("x{i}"), format!("y{i}")] };
        let second = match solver.kind {
            StepKind::HalfTurn => [format!("-{}", first[0]), format!("-{}", first[1])],
            _ => [format!("z{i}"), format!("w{i}")],
        };
        let opposite = solver.kind == StepKind::HalfTurn;
        let reach = literal(self.inverse.plan.axes.reach, Scalar::F64);
        let roots = Roots { step: i, names, first, second, turns: known.turns, opposite, reach, layout, spread };
        self.loops.inner.push_str(&format!("// {}\n", known.name));
        self.solve(body, chain, solver, &roots);
        if direct {
            self.keep(chain, &roots);
        } else if p == 1 {
            self.spread_one(chain, &roots);
        } else {
            self.spread_lanes(chain, &roots);
        }
    }

    /// The roots, whatever becomes of them, and how well they are determined.
    fn solve(&mut self, body: &Body<'_>, chain: &Chain, solver: &Solver, roots: &Roots) {
        let (i, [x, y], [z, w]) = (roots.step, &roots.first, &roots.second);
        let v = |r: usize, k: usize| body.value(solver.rows[r][k]);
        let minus = |r: usize, k: usize| body.negative(solver.rows[r][k]);
        let unit = self.unit(body, solver);
        let text = match (solver.kind, &unit) {
            (StepKind::HalfTurn, _) => {
                let rows: Vec<String> = (0..solver.rows.len()).map(|r| format!("[{}, {}]", v(r, 0), v(r, 1))).collect();
                format!("let ([{x}, {y}], m{i}) = ::dh_robot::runtime::lanes::half_turn([{}]);\n", rows.join(", "))
            }
            (StepKind::SinCos, _) => {
                let (a, b, c) = (v(0, 0), v(0, 1), minus(0, 2));
                let kernel = if chain.scalar == Scalar::F32 { "sincos_single" } else { "sincos" };
                format!(
                    "let ([{x}, {y}, {z}, {w}], e{i}, m{i}) = ::dh_robot::runtime::lanes::{kernel}({a}, {b}, {c});\n"
                )
            }
            (_, Some((a, b))) => format!("let [{x}, {y}] = ::dh_robot::runtime::lanes::unit({a}, {b});\n"),
            (StepKind::AtanPair, None) => {
                let all: Vec<String> = (0..2).flat_map(|r| [v(r, 0), v(r, 1), minus(r, 2)]).collect();
                format!("let ([{x}, {y}], m{i}) = ::dh_robot::runtime::lanes::pair({});\n", all.join(", "))
            }
            _ => format!(
                "let ({x}, m{i}) = ::dh_robot::runtime::lanes::linear({}, {});\nlet {y} = {x};\n",
                v(0, 0),
                v(0, 1)
            ),
        };
        self.loops.inner.push_str(&text);
        if unit.is_none() {
            self.loops.judge(0, format!("m{i}"));
        }
        if solver.kind == StepKind::SinCos {
            self.loops.judge(1, format!("e{i}"));
        }
    }

    /// Cosine and sine of a pair of equations whose coefficients are 1, -1 and 0: each equation is one of them.
    fn unit(&self, body: &Body<'_>, solver: &Solver) -> Option<(String, String)> {
        if solver.kind != StepKind::AtanPair {
            return None;
        }
        let whole = |r: usize, k: usize| {
            let p = self.inverse.graph.as_constant(solver.rows[r][k])?;
            [(0, Poly::zero()), (1, Poly::one()), (-1, -&Poly::one())]
                .into_iter()
                .find(|(_, n)| p == *n)
                .map(|(n, _)| n)
        };
        // a x + c = 0 with a = 1 or -1.
        let root = |r: usize, a: i64| {
            let c = solver.rows[r][2];
            if a > 0 { body.negative(c) } else { body.value(c) }
        };
        match [whole(0, 0)?, whole(0, 1)?, whole(1, 0)?, whole(1, 1)?] {
            [a, 0, 0, b] if a * b != 0 => Some((root(0, a), root(1, b))),
            [0, a, b, 0] if a * b != 0 => Some((root(1, b), root(0, a))),
            _ => None,
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
