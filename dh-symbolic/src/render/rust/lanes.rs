//! The fast way of `inverse`: every step for all branches at once, in loops over arrays (see `dh_robot::lanes`).

use super::body::Body;
use super::inverse::{branch, combination, identifier, inputs, motors};
use super::{bound, literal, scalar_name};
use crate::algebra::Poly;
use crate::chain::{Chain, Scalar, Task};
use crate::planner::StepKind;
use crate::program::{Graph, Inverse, Node, Solver, Value};

/// Most branches side by side.
const MOST: usize = 16;

/// Can the plan go the fast way? All steps have one or two roots by formula, and the whole pose confirms a branch.
pub(super) fn fits(chain: &Chain, inverse: &Inverse) -> bool {
    let simple = |s: &Solver| match s.kind {
        StepKind::Linear | StepKind::HalfTurn | StepKind::SinCos => true,
        StepKind::AtanPair => true, // its first two rows fix the angle at every regular pose
        _ => false,
    };
    chain.task == Task::Pose
        && chain.redundant.is_none()
        && chain.is_direct()
        && inverse.plan.axes.count() == chain.dof()
        && inverse.solvers.iter().all(simple)
        && inverse.plan.max_solutions <= MOST
}

/// The function `lanes`.
pub(super) fn lanes(chain: &Chain, inverse: &Inverse) -> String {
    let plan = &inverse.plan;
    let (n, f, m) = (chain.dof(), scalar_name(chain.scalar), plan.max_solutions);
    let mut outputs: Vec<Value> = inverse.solvers.iter().flat_map(|s| s.rows.concat()).collect();
    let confirmation = confirmation(inverse, &outputs);
    outputs.extend(confirmation.iter().map(|(_, v)| *v));
    let depths = inverse.depths();
    let live = inverse.graph.live(&outputs);
    let wanted = needed_depths(inverse, &depths, &live);
    let mut body = Body::staged(chain, &inverse.graph, outputs, Scalar::F64, 1.0 / plan.axes.reach, inputs(inverse));
    // Lanes at each depth: the roots of the steps so far.
    let mut all = vec![1_usize];
    for step in &plan.steps {
        let last = all[all.len() - 1];
        all.push(last * step.roots);
    }
    let total = all[all.len() - 1];
    let mut w = Writer {
        inverse,
        confirmation: &confirmation,
        depths: &depths,
        live: &live,
        wanted: &wanted,
        all: &all,
        out: String::new(),
    };
    w.out.push_str(&format!(
        "/// The plan for all branches at once; false where the robust way has to decide.\n#[inline]\n\
         fn lanes(&self, t: &::dh_robot::ik::Pose, solutions: &mut ::dh_robot::Solutions<{f}, {n}, {m}>) -> bool {{\n"
    ));
    w.depth(&mut body, 0);
    let mut valid = Vec::new();
    let mut margins = Vec::new();
    for (i, solver) in inverse.solvers.iter().enumerate() {
        let at = solver.rows.concat().iter().map(|v| depths[v.node as usize]).max().unwrap_or(0);
        w.step(&mut body, i, solver, at, &mut valid, &mut margins);
        w.depth(&mut body, i + 1);
    }
    w.finish(&mut body, chain, total, &valid, &margins);
    w.out.push_str("}\n");
    w.out
}

/// The entries of the pose that confirm a branch, with their places: two columns of the rotation fix the third, so the one that costs
/// most is left out.
fn confirmation(inverse: &Inverse, rows: &[Value]) -> Vec<(usize, Value)> {
    let without = |column: usize| -> Vec<(usize, Value)> {
        inverse.confirmation.iter().copied().enumerate().filter(|(k, _)| k / 3 != column).collect()
    };
    let cost = |column: &usize| {
        let outputs: Vec<Value> = rows.iter().copied().chain(without(*column).iter().map(|(_, v)| *v)).collect();
        inverse.graph.live(&outputs).iter().filter(|live| **live).count()
    };
    without((0..3).min_by_key(cost).unwrap_or(0))
}

/// The greatest depth at which each node is used.
fn needed_depths(inverse: &Inverse, depths: &[usize], live: &[bool]) -> Vec<usize> {
    let mut wanted = depths.to_vec();
    for (i, node) in inverse.graph.nodes().iter().enumerate().filter(|(i, _)| live[*i]) {
        let mut note = |n: u32| wanted[n as usize] = wanted[n as usize].max(depths[i]);
        match *node {
            Node::Add(a, b) => {
                note(a.node);
                note(b.node);
            }
            Node::Mul(a, b) => {
                note(a);
                note(b);
            }
            _ => {}
        }
    }
    wanted
}

struct Writer<'a> {
    inverse: &'a Inverse,
    confirmation: &'a [(usize, Value)],
    depths: &'a [usize],
    live: &'a [bool],
    wanted: &'a [usize],
    /// Lanes once so many combinations are known.
    all: &'a [usize],
    out: String,
}

impl Writer<'_> {
    fn graph(&self) -> &Graph {
        &self.inverse.graph
    }

    /// Nodes of lower depth that the nodes of a depth use, and that differ from lane to lane.
    fn used_at(&self, depth: usize) -> Vec<usize> {
        let mut used: Vec<usize> = Vec::new();
        let mut note = |n: u32| {
            let n = n as usize;
            if self.depths[n] > 0 && self.depths[n] < depth {
                used.push(n);
            }
        };
        for (i, node) in self.graph().nodes().iter().enumerate() {
            if self.live[i] && self.depths[i] == depth {
                match *node {
                    Node::Add(a, b) => {
                        note(a.node);
                        note(b.node);
                    }
                    Node::Mul(a, b) => {
                        note(a);
                        note(b);
                    }
                    _ => {}
                }
            }
        }
        used.sort_unstable();
        used.dedup();
        used
    }

    /// The statements of one depth, in a loop over its lanes; results that deeper loops or steps need are kept in arrays.
    fn depth(&mut self, body: &mut Body<'_>, depth: usize) {
        let lanes = self.all[depth];
        if depth == 0 {
            body.statements(self.depths, 0, &[]);
            for line in body.take_lines() {
                self.out.push_str(&line);
                self.out.push('\n');
            }
            return;
        }
        // Sines and cosines of this depth stand in arrays already; everything else of this depth is computed here.
        let here: Vec<usize> = (0..self.graph().nodes().len())
            .filter(|i| {
                self.live[*i] && self.depths[*i] == depth && !matches!(self.graph().nodes()[*i], Node::Symbol(_))
            })
            .collect();
        if here.is_empty() {
            return;
        }
        let symbols: Vec<usize> = (0..self.graph().nodes().len())
            .filter(|i| {
                self.live[*i] && self.depths[*i] == depth && matches!(self.graph().nodes()[*i], Node::Symbol(_))
            })
            .collect();
        let mut loads: Vec<usize> = self.used_at(depth);
        loads.extend(symbols);
        let before: Vec<(usize, String)> = loads.iter().map(|i| (*i, self.array(body, *i))).collect();
        let mut inner = String::new();
        for (i, array) in &before {
            let from = self.all[self.depths[*i]];
            let at = if from == lanes { "l".to_string() } else { format!("l % {from}") };
            inner.push_str(&format!("let {array} = {array}_[{at}];\n"));
            body.rename(*i, array);
        }
        body.statements(self.depths, depth, &[]);
        for line in body.take_lines() {
            inner.push_str(&line);
            inner.push('\n');
        }
        let step_rows: Vec<usize> = self
            .inverse
            .solvers
            .iter()
            .flat_map(|s| s.rows.concat())
            .chain(self.confirmation.iter().map(|(_, v)| *v))
            .map(|v| v.node as usize)
            .collect();
        let kept: Vec<usize> = here.into_iter().filter(|i| self.wanted[*i] > depth || step_rows.contains(i)).collect();
        for i in kept {
            let text = body.known(i).unwrap_or("0.0").to_string();
            let name = format!("v{i}");
            self.out.push_str(&format!("let mut {name}_ = [0.0; {lanes}];\n"));
            inner.push_str(&format!("{name}_[l] = {text};\n"));
            body.rename(i, &name);
        }
        self.out.push_str(&format!("for l in 0..{lanes} {{\n{inner}}}\n"));
    }

    /// Name of the array of a node.
    fn array(&self, body: &Body<'_>, node: usize) -> String {
        match self.graph().nodes()[node] {
            Node::Symbol(s) => identifier(self.inverse.plan.knowledge.ring.symbol_name(s)),
            _ => body.known(node).unwrap_or("0.0").to_string(),
        }
    }

    /// Cosine and sine of a pair of equations whose coefficients are 1, -1 and 0: each equation is one of them.
    fn unit(&self, body: &Body<'_>, solver: &Solver) -> Option<(String, String)> {
        if solver.kind != StepKind::AtanPair {
            return None;
        }
        let whole = |r: usize, k: usize| {
            let p = self.graph().as_constant(solver.rows[r][k])?;
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

    /// One step for all lanes of the depth that its coefficients need; cosine and sine are then spread over all lanes.
    fn step(
        &mut self,
        body: &mut Body<'_>,
        i: usize,
        solver: &Solver,
        at: usize,
        valid: &mut Vec<(String, usize, usize)>,
        margins: &mut Vec<(String, usize, usize)>,
    ) {
        let known = &self.inverse.plan.knowledge.known[solver.finds[0]];
        let [c, s] = known.symbols.map(|x| identifier(self.inverse.plan.knowledge.ring.symbol_name(x)));
        let (p, before, roots) = (self.all[at], self.all[i], self.inverse.plan.steps[i].roots);
        // Load what the coefficients need.
        let mut inner = String::new();
        let mut loaded: Vec<usize> = Vec::new();
        for v in solver.rows.concat() {
            let node = v.node as usize;
            if self.depths[node] > 0 && !loaded.contains(&node) {
                loaded.push(node);
                let array = self.array(body, node);
                let from = self.all[self.depths[node]];
                let index = if from == p { "l".to_string() } else { format!("l % {from}") };
                inner.push_str(&format!("let {array} = {array}_[{index}];\n"));
                body.rename(node, &array);
            }
        }
        let v = |r: usize, k: usize| body.value(solver.rows[r][k]);
        let minus = |r: usize, k: usize| body.negative(solver.rows[r][k]);
        let unit = self.unit(body, solver);
        let q = p * roots;
        let turns = known.turns;
        self.out.push_str(&format!("// {}\nlet mut f{i} = [[0.0; {q}]; 2];\n", known.name));
        if unit.is_none() {
            self.out.push_str(&format!("let mut m{i} = [0.0; {p}];\n"));
            margins.push((format!("m{i}"), p, before));
        }
        match solver.kind {
            StepKind::HalfTurn => inner.push_str(&format!(
                "let ([x, y], m) = ::dh_robot::lanes::half_turn({}, {});\nf{i}[0][l] = x;\nf{i}[1][l] = y;\nf{i}[0][l + {p}] = -x;\nf{i}[1][l + {p}] = -y;\nm{i}[l] = m;\n",
                v(0, 0), v(0, 1)
            )),
            StepKind::SinCos => {
                self.out.push_str(&format!("let mut e{i} = [0.0; {p}];\n"));
                inner.push_str(&format!(
                    "let ([x, y, z, w], e, m) = ::dh_robot::lanes::sincos({}, {}, {});\nf{i}[0][l] = x;\nf{i}[1][l] = y;\nf{i}[0][l + {p}] = z;\nf{i}[1][l + {p}] = w;\nm{i}[l] = m;\ne{i}[l] = e;\n",
                    v(0, 0), v(0, 1), minus(0, 2)
                ));
                valid.push((format!("e{i}"), p, before));
            }
            StepKind::AtanPair if unit.is_some() => {
                let (x, y) = unit.unwrap_or_default();
                inner.push_str(&format!(
                    "let [x, y] = ::dh_robot::lanes::unit({x}, {y});\nf{i}[0][l] = x;\nf{i}[1][l] = y;\n"
                ));
            }
            StepKind::AtanPair => inner.push_str(&format!(
                "let ([x, y], m) = ::dh_robot::lanes::pair({}, {}, {}, {}, {}, {});\nf{i}[0][l] = x;\nf{i}[1][l] = y;\nm{i}[l] = m;\n",
                v(0, 0), v(0, 1), minus(0, 2), v(1, 0), v(1, 1), minus(1, 2)
            )),
            _ => inner.push_str(&format!(
                "let (x, m) = ::dh_robot::lanes::linear({}, {});\nf{i}[0][l] = x;\nf{i}[1][l] = x;\nm{i}[l] = m;\n",
                v(0, 0), v(0, 1)
            )),
        }
        self.out.push_str(&format!("for l in 0..{p} {{\n{inner}}}\n"));
        // Lane k of the new depth: root k / before of lane k % before.
        let lanes = before * roots;
        let index = if p == before { "k".to_string() } else { format!("k / {before} * {p} + k % {p}") };
        let spread = |j: usize| {
            if p == before {
                format!("f{i}[{j}]")
            } else {
                format!("::core::array::from_fn::<f64, {lanes}, _>(|k| f{i}[{j}][{index}])")
            }
        };
        self.out.push_str(&format!("let {c}_ = {};\n", spread(0)));
        if turns {
            self.out.push_str(&format!("let {s}_ = {};\n", spread(1)));
            // One arc tangent per pair of opposite roots.
            let angle = if solver.kind == StepKind::HalfTurn {
                format!(
                    "let half: [f64; {p}] = ::dh_robot::atan2_batch(&::core::array::from_fn(|l| f{i}[1][l]), &::core::array::from_fn(|l| f{i}[0][l]));\n\
                     let g{i}: [f64; {q}] = ::core::array::from_fn(|k| if k < {p} {{ half[k] }} else if half[k - {p}] > 0.0 {{ half[k - {p}] - ::core::f64::consts::PI }} else {{ half[k - {p}] + ::core::f64::consts::PI }});\n"
                )
            } else {
                format!("let g{i}: [f64; {q}] = ::dh_robot::atan2_batch(&f{i}[1], &f{i}[0]);\n")
            };
            self.out.push_str(&angle);
        } else {
            let reach = literal(self.inverse.plan.axes.reach, Scalar::F64);
            self.out.push_str(&format!("let g{i}: [f64; {q}] = f{i}[0].map(|d| d * {reach});\n"));
        }
    }

    /// Confirmation, joint values and the solutions.
    fn finish(
        &mut self,
        body: &mut Body<'_>,
        chain: &Chain,
        total: usize,
        valid: &[(String, usize, usize)],
        margins: &[(String, usize, usize)],
    ) {
        let plan = &self.inverse.plan;
        self.out.push_str(&format!("let mut error = [0.0; {total}];\nfor l in 0..{total} {{\n"));
        let mut loaded: Vec<usize> = Vec::new();
        for (_, v) in self.confirmation {
            let node = v.node as usize;
            if self.depths[node] > 0 && !loaded.contains(&node) {
                loaded.push(node);
                let array = self.array(body, node);
                let from = self.all[self.depths[node]];
                let index = if from == total { "l".to_string() } else { format!("l % {from}") };
                self.out.push_str(&format!("let {array} = {array}_[{index}];\n"));
                body.rename(node, &array);
            }
        }
        let mut terms = Vec::new();
        for (k, v) in self.confirmation {
            let (row, column) = (k % 3, k / 3);
            terms.push(format!("({} - t[{row}][{column}]).abs()", body.value(*v)));
        }
        self.out.push_str(&format!("error[l] = {};\n}}\n", terms.join(" + ")));
        // A value of step i for lane k of all lanes.
        let product = |list: &[(String, usize, usize)], join: &str, start: &str| {
            list.iter().fold(start.to_string(), |t, (name, p, before)| {
                let x = format!("{name}[l % {before} % {p}]");
                if join == "*" { format!("{t} * {x}") } else { format!("{t}.min({x})") }
            })
        };
        self.out.push_str(&format!(
            "let valid: [f64; {total}] = ::core::array::from_fn(|l| {});\nlet margin: [f64; {total}] = ::core::array::from_fn(|l| {});\n",
            product(valid, "*", "1.0"),
            product(margins, "min", "1.0_f64")
        ));
        // The angle of known combination i at lane l.
        let mut angles = Vec::new();
        for (i, solver) in self.inverse.solvers.iter().enumerate() {
            let at = solver.rows.concat().iter().map(|v| self.depths[v.node as usize]).max().unwrap_or(0);
            let (p, before, roots) = (self.all[at], self.all[i], plan.steps[i].roots);
            angles.push(if roots == 1 {
                format!("g{i}[l % {p}]")
            } else {
                format!("g{i}[l / {before} % {roots} * {p} + l % {p}]")
            });
        }
        let x: Vec<String> = self.inverse.joints.iter().map(|form| combination(form, &angles)).collect();
        let plain = |form: &Vec<i8>| form.iter().filter(|k| **k != 0).count() == 1;
        let q: Vec<String> = motors(chain, &x)
            .into_iter()
            .zip(&self.inverse.joints)
            .enumerate()
            .map(|(k, (q, form))| {
                let shifted = !chain.joints[k].shift.is_zero();
                let wraps = plan.axes.turns(k) && (shifted || !plain(form));
                let value = if wraps { format!("::dh_robot::lanes::wrap({q})") } else { q };
                let value = if plan.axes.turns(k) { into_range(chain, k, value) } else { value };
                format!("::core::array::from_fn(|l| {value})")
            })
            .collect();
        self.out.push_str(&format!("let q: [[f64; {total}]; {}] = [{}];\n", chain.dof(), q.join(",\n")));
        let mut roots = String::new();
        for (i, step) in plan.steps.iter().enumerate().filter(|(_, s)| s.roots > 1) {
            roots.push_str(&format!("let i{i} = l / {} % {};\n", self.all[i], step.roots));
        }
        self.out.push_str(&format!(
            "const BRANCHES: [::dh_robot::Branch; {total}] = {{\nlet mut all = [::dh_robot::Branch::ANY; {total}];\nlet mut l = 0;\n\
             while l < {total} {{\n{roots}all[l] = {};\nl += 1;\n}}\nall\n}};\n\
             ::dh_robot::lanes::collect(&valid, &margin, &error, &q, &BRANCHES, solutions)\n",
            branch(self.inverse)
        ));
    }
}

/// The angle brought into the joint's range by a turn, where one can: what can be decided now is.
fn into_range(chain: &Chain, k: usize, angle: String) -> String {
    use core::f64::consts::PI;
    let Some((least, greatest)) = &chain.joints[k].range else { return angle };
    let (least, greatest) = (bound(least), bound(greatest));
    if (least <= -PI && greatest >= PI) || (least > -PI + 1e-3 && greatest < PI - 1e-3) {
        // Every angle is in range, or no turn brings one in.
        angle
    } else if least <= PI && greatest >= -PI {
        let (least, greatest) = (literal(least, Scalar::F64), literal(greatest, Scalar::F64));
        format!("::dh_robot::lanes::into_range({angle}, {least}, {greatest})")
    } else {
        let (least, greatest) = (literal(least, Scalar::F64), literal(greatest, Scalar::F64));
        format!("::dh_robot::Joint::revolute(\"\").with_range({least}, {greatest}).normalize({angle})")
    }
}
