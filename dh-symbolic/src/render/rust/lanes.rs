//! The fast way of `inverse`: every step for all branches at once, in loops over arrays (see `dh_robot::lanes`).

use super::body::Body;
use super::inverse::{branch, combination, identifier, inputs, motors};
use super::{literal, scalar_name};
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
    outputs.extend(&inverse.confirmation);
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
    let mut w = Writer { inverse, depths: &depths, live: &live, wanted: &wanted, all: &all, out: String::new() };
    w.out.push_str(&format!(
        "/// The plan for all branches at once; `None` where the robust way has to decide.\n#[inline]\n\
         fn lanes(&self, t: &::dh_robot::ik::Pose) -> Option<::dh_robot::Solutions<{f}, {n}, {m}>> {{\n"
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
            .chain(self.inverse.confirmation.iter().copied())
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
        let q = p * roots;
        let turns = known.turns;
        self.out.push_str(&format!("// {}\nlet mut m{i} = [0.0; {p}];\nlet mut f{i} = [[0.0; {q}]; 2];\n", known.name));
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
            StepKind::AtanPair => inner.push_str(&format!(
                "let ([x, y], m) = ::dh_robot::lanes::pair({}, {}, {}, {}, {}, {});\nf{i}[0][l] = x;\nf{i}[1][l] = y;\nm{i}[l] = m;\n",
                v(0, 0), v(0, 1), minus(0, 2), v(1, 0), v(1, 1), minus(1, 2)
            )),
            _ => inner.push_str(&format!(
                "let (x, m) = ::dh_robot::lanes::linear({}, {});\nf{i}[0][l] = x;\nf{i}[1][l] = x;\nm{i}[l] = m;\n",
                v(0, 0), v(0, 1)
            )),
        }
        margins.push((format!("m{i}"), p, before));
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
        for v in &self.inverse.confirmation {
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
        for (k, v) in self.inverse.confirmation.iter().enumerate() {
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
                format!("::core::array::from_fn(|l| {value})")
            })
            .collect();
        self.out.push_str(&format!("let q: [[f64; {total}]; {}] = [{}];\n", chain.dof(), q.join(",\n")));
        let mut roots = String::new();
        for (i, step) in plan.steps.iter().enumerate().filter(|(_, s)| s.roots > 1) {
            roots.push_str(&format!("let i{i} = l / {} % {};\n", self.all[i], step.roots));
        }
        self.out.push_str(&format!(
            "::dh_robot::lanes::collect(&Self::JOINTS, &valid, &margin, &error, &q, |l| {{\n{roots}{}\n}})\n",
            branch(self.inverse)
        ));
    }
}
