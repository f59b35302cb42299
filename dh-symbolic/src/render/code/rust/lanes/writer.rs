//! Writes the loops over lanes: the values that follow from each step, and in the end confirmation and motors.

use std::collections::BTreeSet;

use super::branches;
use super::loops::{KINDS, Loops, joined};
use super::motors::Motor;
use super::ranges::into_range;
use super::segments::{Item, What, needs, segments};
use super::twin::Twin;
use crate::chain::Chain;
use crate::program::{Inverse, Node, Value};
use crate::render::code::body::Body;
use crate::render::code::steps::Variables;

/// What has been written, and what is needed where.
pub(super) struct Writer<'a> {
    pub(super) inverse: &'a Inverse,
    pub(super) variables: Variables,
    confirmation: Vec<(usize, Value)>,
    pub(super) depths: Vec<usize>,
    live: Vec<bool>,
    twin: Option<Twin>,
    /// Lanes once so many combinations are known; a twin does not count.
    pub(super) all: Vec<usize>,
    pub(super) items: Vec<Item>,
    /// The last segment that uses each node.
    pub(super) wanted: Vec<usize>,
    pub(super) loops: Loops,
    motors: Vec<Motor>,
    /// Motors whose values have been written.
    pub(super) written: BTreeSet<usize>,
}

impl<'a> Writer<'a> {
    pub(super) fn new(
        inverse: &'a Inverse,
        variables: Variables,
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
            .filter(|t| lanes(needs(inverse.body.solves()[t.step], &depths)) == lanes(t.step + given));
        let (all, items) = segments(inverse, &depths, twin.as_ref().map(|t| t.step));
        let mut w = Self {
            inverse,
            variables,
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
            What::Step(i) => self.inverse.body.solves()[i].equations.concat().iter().map(|v| v.node as usize).collect(),
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
    pub(super) fn name(&self, node: usize) -> String {
        match self.inverse.graph.nodes()[node] {
            Node::Symbol(s) => self.variables.name(s),
            _ => format!("v{node}"),
        }
    }

    /// Loads what an item uses.
    pub(super) fn load_nodes(&mut self, body: &mut Body<'_>, what: What) {
        for node in self.uses(what) {
            let name = self.name(node);
            if !self.loops.knows(&name) && self.loops.load(&name) {
                body.rename(node, &name);
            }
        }
    }

    /// The joint value of a step, under a name of its own; also the value of a joint, where it is one.
    pub(super) fn angle(&mut self, chain: &Chain, i: usize, text: &str) {
        self.loops.inner.push_str(&format!("let g{i} = {text};\n"));
        self.loops.define(&format!("g{i}"));
        if self.loops.lanes > 1 && !self.loops.last {
            let n = self.loops.lanes;
            self.loops.store(&format!("g{i}"), &format!("g{i}"));
            self.joint(chain, i, &[format!("g{i}")], n);
        }
    }

    /// The joint that step `i` alone gives.
    pub(super) fn alone(&self, i: usize) -> Option<usize> {
        let known = i + self.inverse.plan.given;
        self.motors.iter().position(|motor| motor.form.iter().enumerate().all(|(k, x)| (*x != 0) == (k == known)))
    }

    /// The values of the steps, where only one counts.
    pub(super) fn only(&self, i: usize, text: String) -> Vec<String> {
        let mut angles = vec![String::new(); self.inverse.plan.given + self.inverse.plan.steps.len()];
        angles[i + self.inverse.plan.given] = text;
        angles
    }

    /// Writes the joint that step `i` alone gives, whose roots change after `p` lanes.
    pub(super) fn joint(&mut self, chain: &Chain, i: usize, roots: &[String], p: usize) {
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
    pub(super) fn joint_value(&self, chain: &Chain, k: usize, angles: &[String]) -> String {
        let motor = &self.motors[k];
        let value = motor.value(angles);
        if !self.inverse.plan.axes.turns(k) {
            return value;
        }
        let value = match motor.half_turns {
            // Sums of three angles at most, then of five; a field can be any angle.
            Some(1) => value,
            Some(2 | 3) => format!("::dh_robot::runtime::lanes::wrap({value})"),
            Some(4 | 5) => format!("::dh_robot::runtime::lanes::wrap(::dh_robot::runtime::lanes::wrap({value}))"),
            _ => format!("::dh_robot::Joint::revolute(\"\").normalize({value})"),
        };
        into_range(chain, k, value)
    }

    /// The values of one depth.
    pub(super) fn depth(&mut self, body: &mut Body<'_>, depth: usize) {
        self.load_nodes(body, What::Depth(depth));
        body.statements(&self.depths, depth);
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

    /// Confirmation and joint values.
    pub(super) fn finish(&mut self, chain: &Chain, total: usize) {
        self.loops.flush();
        let (inverse, lanes) = (self.inverse, self.loops.lanes);
        let open: Vec<usize> = (0..self.motors.len()).filter(|k| !self.written.contains(k)).collect();
        let given = inverse.plan.given;
        let used = |known: usize| open.iter().any(|k| self.motors[*k].form[known] != 0);
        let found = (0..inverse.plan.steps.len()).map(|i| format!("g{i}"));
        let first: Vec<String> = self.variables.known[..given].iter().map(|v| v.value.clone()).chain(found).collect();
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
