//! Writes the loops over lanes: each step, the values that follow from it, and in the end confirmation and motors.

use std::collections::BTreeSet;

use super::super::body::Body;
use super::super::literal;
use super::super::steps::identifier;
use super::branches;
use super::loops::{KINDS, Layout, Loops, joined};
use super::motors::Motor;
use super::ranges::into_range;
use super::segments::{Item, What, needs, segments};
use super::twin::Twin;
use crate::algebra::Poly;
use crate::chain::{Chain, Scalar};
use crate::planner::StepKind;
use crate::program::{Inverse, Node, Solver, Value};

/// What has been written, and what is needed where.
pub(super) struct Writer<'a> {
    inverse: &'a Inverse,
    confirmation: Vec<(usize, Value)>,
    pub(super) depths: Vec<usize>,
    live: Vec<bool>,
    twin: Option<Twin>,
    /// Lanes once so many combinations are known; a twin does not count.
    all: Vec<usize>,
    pub(super) items: Vec<Item>,
    /// The last segment that uses each node.
    wanted: Vec<usize>,
    pub(super) loops: Loops,
    motors: Vec<Motor>,
    /// Motors whose values have been written.
    pub(super) written: BTreeSet<usize>,
}

impl<'a> Writer<'a> {
    pub(super) fn new(
        inverse: &'a Inverse,
        motors: Vec<Motor>,
        confirmation: Vec<(usize, Value)>,
        live: Vec<bool>,
    ) -> Self {
        let depths = inverse.depths();
        let given = inverse.plan.given;
        let lanes = |known: usize| -> usize {
            inverse.plan.steps[..known.saturating_sub(given)].iter().map(|s| s.roots).product()
        };
        let twin = Twin::of(inverse, &depths, &live, &confirmation)
            .filter(|t| lanes(needs(&inverse.solvers[t.step], &depths)) == lanes(t.step + given));
        let (all, items) = segments(inverse, &depths, twin.as_ref().map(|t| t.step));
        let mut w = Self {
            inverse,
            confirmation,
            depths,
            live,
            twin,
            all,
            items,
            wanted: Vec::new(),
            loops: Loops::default(),
            motors,
            written: BTreeSet::new(),
        };
        w.wanted = vec![0; w.depths.len()];
        for item in w.items.clone() {
            for node in w.uses(item.what) {
                w.wanted[node] = w.wanted[node].max(item.segment);
            }
        }
        w
    }

    /// The nodes of lanes that an item uses.
    fn uses(&self, what: What) -> Vec<usize> {
        let mut used: Vec<usize> = match what {
            What::Step(i) => self.inverse.solvers[i].rows.concat().iter().map(|v| v.node as usize).collect(),
            What::Finish => Vec::new(),
            What::Depth(depth) => {
                let nodes = self.inverse.graph.nodes().iter().enumerate();
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
        used.retain(|i| self.depths[*i] > self.inverse.plan.given);
        used.sort_unstable();
        used.dedup();
        used
    }

    /// Name of a node in loops that didn't compute it.
    fn name(&self, node: usize) -> String {
        match self.inverse.graph.nodes()[node] {
            Node::Symbol(s) => identifier(self.inverse.plan.knowledge.ring.symbol_name(s)),
            _ => format!("v{node}"),
        }
    }

    /// Loads what an item uses.
    fn load_nodes(&mut self, body: &mut Body<'_>, what: What) {
        for node in self.uses(what) {
            let name = self.name(node);
            if !self.loops.knows(&name) && self.loops.load(&name) {
                body.rename(node, &name);
            }
        }
    }

    /// The joint value of a step, under a name of its own; also the value of a joint, where it is one.
    fn angle(&mut self, chain: &Chain, i: usize, text: &str) {
        self.loops.inner.push_str(&format!("let g{i} = {text};\n"));
        self.loops.define(&format!("g{i}"));
        if self.loops.lanes > 1 && !self.loops.last {
            let n = self.loops.lanes;
            self.loops.store(&format!("g{i}"), &format!("g{i}"));
            self.joint(chain, i, &[format!("g{i}")], n);
        }
    }

    /// The joint that step `i` alone gives.
    fn alone(&self, i: usize) -> Option<usize> {
        let known = i + self.inverse.plan.given;
        self.motors.iter().position(|motor| motor.form.iter().enumerate().all(|(k, x)| (*x != 0) == (k == known)))
    }

    /// The values of the steps, where only one counts.
    fn only(&self, i: usize, text: String) -> Vec<String> {
        let mut angles = vec![String::new(); self.inverse.plan.given + self.inverse.solvers.len()];
        angles[i + self.inverse.plan.given] = text;
        angles
    }

    /// Writes the joint that step `i` alone gives, whose roots change after `p` lanes.
    fn joint(&mut self, chain: &Chain, i: usize, roots: &[String], p: usize) {
        let Some(k) = self.alone(i) else { return };
        let total = branches(self.inverse);
        for (r, root) in roots.iter().enumerate() {
            let name = format!("j{k}{}", if r == 0 { "a" } else { "b" });
            let value = self.joint_value(chain, k, &self.only(i, root.clone()));
            self.loops.inner.push_str(&format!("let {name} = {value};\n"));
            for start in (r * p..total).step_by(roots.len() * p) {
                let at = if start == 0 { "l".to_string() } else { format!("l + {start}") };
                self.loops.inner.push_str(&format!("q[{k}][{at}] = {name};\n"));
            }
        }
        self.written.insert(k);
    }

    /// The value of a motor, in its range, from the values of the steps.
    fn joint_value(&self, chain: &Chain, k: usize, angles: &[String]) -> String {
        let motor = &self.motors[k];
        let value = motor.value(angles);
        if !self.inverse.plan.axes.turns(k) {
            return value;
        }
        let value = match motor.half_turns {
            // Sums of three angles at most, then of five; a field can be any angle.
            Some(1) => value,
            Some(2 | 3) => format!("::dh_robot::lanes::wrap({value})"),
            Some(4 | 5) => format!("::dh_robot::lanes::wrap(::dh_robot::lanes::wrap({value}))"),
            _ => format!("::dh_robot::Joint::revolute(\"\").normalize({value})"),
        };
        into_range(chain, k, value)
    }

    /// The values of one depth.
    pub(super) fn depth(&mut self, body: &mut Body<'_>, depth: usize) {
        self.load_nodes(body, What::Depth(depth));
        body.statements(&self.depths, depth, &[]);
        self.loops.inner.push_str(&body.take_text());
        for (i, node) in self.inverse.graph.nodes().iter().enumerate() {
            let here = self.live[i] && self.depths[i] == depth && !matches!(node, Node::Symbol(_));
            if here && self.wanted[i] > self.loops.segment && self.loops.lanes > 1 {
                let text = body.known(i).unwrap_or("0.0").to_string();
                self.loops.store(&format!("v{i}"), &text);
            }
        }
        self.tell(body, depth);
    }

    /// What a depth says about the pose, to the confirmation.
    pub(super) fn tell(&mut self, body: &Body<'_>, depth: usize) {
        let terms: Vec<String> = self
            .confirmation
            .iter()
            .filter(|(_, v)| self.depths[v.node as usize] == depth)
            .map(|(k, v)| format!("({} - t[{}][{}]).abs()", body.value(*v), k % 3, k / 3))
            .collect();
        if !terms.is_empty() {
            self.loops.inner.push_str(&format!("let r{depth} = {};\n", terms.join(" + ")));
            self.loops.judge(2, format!("r{depth}"));
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

    /// One step for all lanes that its coefficients need; cosine and sine are then spread over the lanes of the next depth.
    pub(super) fn step(&mut self, body: &mut Body<'_>, chain: &Chain, i: usize) {
        self.load_nodes(body, What::Step(i));
        let solver = &self.inverse.solvers[i];
        let known = &self.inverse.plan.knowledge.known[solver.finds[0]];
        let known_before = i + self.inverse.plan.given;
        let (p, before, spread) = (self.loops.lanes, self.all[known_before], self.all[known_before + 1]);
        let roots = spread / before;
        let [c, s] = known.symbols.map(|x| identifier(self.inverse.plan.knowledge.ring.symbol_name(x)));
        let v = |r: usize, k: usize| body.value(solver.rows[r][k]);
        let minus = |r: usize, k: usize| body.negative(solver.rows[r][k]);
        self.loops.inner.push_str(&format!("// {}\n", known.name));
        // The first root, whatever becomes of it.
        let direct = roots == 1 && p == before;
        let [x, y] = if direct { [c.clone(), s.clone()] } else { [format!("x{i}"), format!("y{i}")] };
        let (mut second, mut judged) = ([String::new(), String::new()], true);
        let text = match solver.kind {
            StepKind::HalfTurn => {
                second = [format!("-{x}"), format!("-{y}")];
                let rows: Vec<String> = (0..solver.rows.len()).map(|r| format!("[{}, {}]", v(r, 0), v(r, 1))).collect();
                format!("let ([{x}, {y}], m{i}) = ::dh_robot::lanes::half_turn([{}]);\n", rows.join(", "))
            }
            StepKind::SinCos => {
                second = [format!("z{i}"), format!("w{i}")];
                let [z, w] = &second;
                let (a, b, c) = (v(0, 0), v(0, 1), minus(0, 2));
                format!("let ([{x}, {y}, {z}, {w}], e{i}, m{i}) = ::dh_robot::lanes::sincos({a}, {b}, {c});\n")
            }
            StepKind::AtanPair => match self.unit(body, solver) {
                Some((a, b)) => {
                    judged = false;
                    format!("let [{x}, {y}] = ::dh_robot::lanes::unit({a}, {b});\n")
                }
                None => {
                    let all: Vec<String> = (0..2).flat_map(|r| [v(r, 0), v(r, 1), minus(r, 2)]).collect();
                    format!("let ([{x}, {y}], m{i}) = ::dh_robot::lanes::pair({});\n", all.join(", "))
                }
            },
            _ => format!("let ({x}, m{i}) = ::dh_robot::lanes::linear({}, {});\nlet {y} = {x};\n", v(0, 0), v(0, 1)),
        };
        self.loops.inner.push_str(&text);
        if judged {
            self.loops.judge(0, format!("m{i}"));
        }
        if solver.kind == StepKind::SinCos {
            self.loops.judge(1, format!("e{i}"));
        }
        let angle = |x: &str, y: &str| {
            if known.turns {
                format!("::dh_robot::lanes::angle({y}, {x})")
            } else {
                format!("{x} * {}", literal(self.inverse.plan.axes.reach, Scalar::F64))
            }
        };
        let other = if solver.kind == StepKind::HalfTurn {
            format!("::dh_robot::lanes::opposite(g{i})")
        } else {
            angle(&second[0], &second[1])
        };
        let first = angle(&x, &y);
        if direct {
            for name in [c, s] {
                let later = (0..self.depths.len()).any(|k| {
                    let symbol = matches!(self.inverse.graph.nodes()[k], Node::Symbol(_));
                    symbol && self.wanted[k] > self.loops.segment && self.name(k) == name
                });
                self.loops.define(&name);
                if later && p > 1 {
                    self.loops.store(&name, &name);
                }
            }
            self.angle(chain, i, &first);
            return;
        }
        self.loops.arrays.insert(c.clone(), Layout::plain(spread));
        self.loops.arrays.insert(s.clone(), Layout::plain(spread));
        let layout = Layout { before, roots, p };
        if p == 1 {
            let list = |first: &str, second: &str| {
                let lanes = (0..spread).map(|k| if k < before { first } else { second });
                format!("[{}]", lanes.collect::<Vec<_>>().join(", "))
            };
            self.loops.inner.push_str(&format!(
                "let {c}_ = {};\nlet {s}_ = {};\n",
                list(&x, &second[0]),
                list(&y, &second[1])
            ));
            if roots == 1 {
                self.angle(chain, i, &first);
            } else if known.turns {
                let [z, w] = &second;
                self.loops
                    .inner
                    .push_str(&format!("let g{i}_ = ::dh_robot::lanes::angles(&[{y}, {w}], &[{x}, {z}]);\n"));
                self.loops.arrays.insert(format!("g{i}"), layout);
            } else {
                self.loops.inner.push_str(&format!("let g{i}_ = [{first}, {other}];\n"));
                self.loops.arrays.insert(format!("g{i}"), layout);
            }
            return;
        }
        let many = p * roots;
        self.loops.before.push_str(&format!("let mut f{i} = [[0.0; {many}]; 2];\n"));
        let mut writes = vec![format!("f{i}[0][l] = {x};\nf{i}[1][l] = {y};\n")];
        if roots > 1 {
            let [z, w] = &second;
            writes.push(format!("f{i}[0][l + {p}] = {z};\nf{i}[1][l + {p}] = {w};\n"));
        }
        self.loops.inner.push_str(&writes.concat());
        if known.turns && p < 4 {
            // Such a short loop is unrolled: the angles are better taken together.
            self.loops.after.push_str(&format!("let g{i}_ = ::dh_robot::lanes::angles(&f{i}[1], &f{i}[0]);\n"));
            if let Some(k) = self.alone(i) {
                let value = self.joint_value(chain, k, &self.only(i, format!("g{i}_[{}]", layout.index())));
                self.loops.after.push_str(&format!("q[{k}] = ::core::array::from_fn(|l| {value});\n"));
                self.written.insert(k);
            }
        } else {
            self.loops.before.push_str(&format!("let mut g{i}_ = [0.0; {many}];\n"));
            self.loops.inner.push_str(&format!("let g{i} = {first};\ng{i}_[l] = g{i};\n"));
            if roots > 1 {
                self.loops.inner.push_str(&format!("let h{i} = {other};\ng{i}_[l + {p}] = h{i};\n"));
                if p == before {
                    self.joint(chain, i, &[format!("g{i}"), format!("h{i}")], p);
                }
            }
        }
        self.loops.arrays.insert(format!("g{i}"), layout);
        for (k, name) in [c, s].iter().enumerate() {
            let text = if p == before {
                format!("f{i}[{k}]")
            } else {
                format!("::core::array::from_fn::<f64, {spread}, _>(|l| f{i}[{k}][{}])", layout.index())
            };
            self.loops.after.push_str(&format!("let {name}_ = {text};\n"));
        }
    }

    /// Confirmation and joint values.
    pub(super) fn finish(&mut self, chain: &Chain, total: usize) {
        self.loops.flush();
        let (inverse, lanes) = (self.inverse, self.loops.lanes);
        let open: Vec<usize> = (0..self.motors.len()).filter(|k| !self.written.contains(k)).collect();
        let given = inverse.plan.given;
        let used = |known: usize| open.iter().any(|k| self.motors[*k].form[known] != 0);
        let found = (0..inverse.solvers.len()).map(|i| format!("g{i}"));
        let first: Vec<String> = (0..given).map(|i| format!("a{i}")).chain(found).collect();
        for (_, name) in first.iter().enumerate().skip(given).filter(|(known, _)| used(*known)) {
            self.loops.load(name);
        }
        let judged = std::mem::take(&mut self.loops.judged);
        for (kind, names) in judged.iter().enumerate() {
            for name in names {
                self.loops.load(name);
            }
            self.loops.before.push_str(&format!("let mut {}_ = [0.0; {lanes}];\n", KINDS[kind]));
        }
        if lanes == 1 {
            self.loops.inner.push_str("let l = 0;\n");
        }
        for (kind, names) in judged.iter().enumerate() {
            self.loops.inner.push_str(&format!("{}_[l] = {};\n", KINDS[kind], joined(kind, names)));
        }
        let mut sets = vec![first.clone()];
        if let Some(twin) = &self.twin {
            let mut second = first;
            for (known, name) in second.iter_mut().enumerate().skip(given + twin.step).filter(|(known, _)| used(*known))
            {
                let (i, turns) = (known - given, inverse.plan.knowledge.known[known].turns);
                self.loops.inner.push_str(&format!("let h{i} = {};\n", twin.angle(i, turns, name)));
                *name = format!("h{i}");
            }
            sets.push(second);
        }
        for (half, angles) in sets.iter().enumerate() {
            let at = if half == 0 { "l".to_string() } else { format!("l + {}", total / 2) };
            for k in &open {
                let value = self.joint_value(chain, *k, angles);
                self.loops.inner.push_str(&format!("q[{k}][{at}] = {value};\n"));
            }
        }
    }
}
