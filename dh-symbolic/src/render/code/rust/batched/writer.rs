//! Writes the loops over branches: the values that follow from each step, and in the end confirmation and actuators.

use std::collections::{BTreeMap, BTreeSet};

use super::actuators::Actuator;
use super::loops::{KINDS, Loops, joined};
use super::ranges::into_range;
use crate::chain::Chain;
use crate::program::{Batched, Inverse, Mirror, Node, What};
use crate::render::code::body::Body;
use crate::render::code::steps::Variables;

/// What has been written, and what is needed where.
pub(super) struct BatchedWriter<'a> {
    pub(super) chain: &'a Chain,
    pub(super) inverse: &'a Inverse,
    pub(super) batched: &'a Batched,
    pub(super) variables: Variables,
    pub(super) loops: Loops,
    /// Names of nodes that later loops load.
    stored: BTreeMap<usize, String>,
    actuators: Vec<Actuator>,
    /// Actuators whose values have been written.
    pub(super) written: BTreeSet<usize>,
}

impl<'a> BatchedWriter<'a> {
    pub(super) fn new(
        chain: &'a Chain,
        inverse: &'a Inverse,
        batched: &'a Batched,
        variables: Variables,
        actuators: Vec<Actuator>,
    ) -> Self {
        let (loops, stored, written) = (Loops::default(), BTreeMap::new(), BTreeSet::new());
        Self { chain, inverse, batched, variables, loops, stored, actuators, written }
    }

    /// Name of a node in loops that didn't compute it, if it has one.
    pub(super) fn name(&self, node: usize) -> Option<String> {
        match self.inverse.graph.nodes()[node] {
            Node::Symbol(s) => Some(self.variables.name(s)),
            _ => self.stored.get(&node).cloned(),
        }
    }

    /// Loads what an item uses.
    pub(super) fn load_nodes(&mut self, body: &mut Body<'_>, what: What) {
        for node in self.batched.uses(self.inverse, what) {
            let Some(name) = self.name(node) else { continue };
            if !self.loops.knows(&name) && self.loops.load(&name) {
                body.rename(node, &name);
            }
        }
    }

    /// The joint value of a step, under a name of its own; also the value of an actuator, where it is one.
    pub(super) fn joint_value_of(&mut self, step: usize, text: &str) {
        let value = self.value_name(step);
        self.loops.inner.push_str(&format!("let {value} = {text};\n"));
        self.loops.define(&value);
        if self.loops.width > 1 && !self.loops.last {
            let n = self.loops.width;
            self.loops.store(&value, &value);
            self.actuator(step, &[value], n);
        }
    }

    /// Name of the joint value that a step finds.
    fn value_name(&self, step: usize) -> String {
        self.variables.known[self.batched.solves[step].known].value.clone()
    }

    /// The actuator that a step alone gives.
    pub(super) fn alone(&self, step: usize) -> Option<usize> {
        let known = self.batched.solves[step].known;
        self.actuators
            .iter()
            .position(|actuator| actuator.form.iter().enumerate().all(|(k, x)| (*x != 0) == (k == known)))
    }

    /// The values of what is known, where only one counts.
    pub(super) fn only(&self, step: usize, text: String) -> Vec<String> {
        let mut values = vec![String::new(); self.variables.known.len()];
        values[self.batched.solves[step].known] = text;
        values
    }

    /// Writes the actuator that a step alone gives, whose roots change after `p` branches.
    pub(super) fn actuator(&mut self, step: usize, roots: &[String], p: usize) {
        let Some(k) = self.alone(step) else { return };
        for (r, root) in roots.iter().enumerate() {
            let name = format!("{root}_in_range");
            let value = self.motor_value(k, &self.only(step, root.clone()));
            self.loops.inner.push_str(&format!("let {name} = {value};\n"));
            for start in (r * p..self.batched.branches).step_by(roots.len() * p) {
                let at = if start == 0 { "branch".to_string() } else { format!("branch + {start}") };
                self.loops.inner.push_str(&format!("q[{k}][{at}] = {name};\n"));
            }
        }
        self.written.insert(k);
    }

    /// The value of an actuator, in its range, from the values of the steps.
    pub(super) fn motor_value(&self, k: usize, values: &[String]) -> String {
        let actuator = &self.actuators[k];
        let value = actuator.value(values);
        if !self.inverse.plan.axes.is_revolute(k) {
            return value;
        }
        let value = match actuator.half_turns {
            // Sums of three angles at most, then of five; a field can be any angle.
            Some(1) => value,
            Some(2 | 3) => format!("::dh_robot::runtime::batched::wrap({value})"),
            Some(4 | 5) => format!("::dh_robot::runtime::batched::wrap(::dh_robot::runtime::batched::wrap({value}))"),
            _ => format!("::dh_robot::Joint::revolute(\"\").normalize({value})"),
        };
        into_range(self.chain, k, value)
    }

    /// The values that need this number of known combinations.
    pub(super) fn values(&mut self, body: &mut Body<'_>, depth: usize) {
        self.load_nodes(body, What::Values(depth));
        body.statements(&self.batched.depths, depth);
        self.loops.inner.push_str(&body.take_text());
        for (i, node) in self.inverse.graph.nodes().iter().enumerate() {
            let here = self.batched.live[i] && self.batched.depths[i] == depth && !matches!(node, Node::Symbol(_));
            if here && self.batched.last_use[i] > self.loops.number && self.loops.width > 1 {
                let name = body.named(i);
                self.loops.inner.push_str(&body.take_text());
                self.loops.store(&name, &name);
                self.stored.insert(i, name);
            }
        }
        self.confirm(body, depth);
    }

    /// The parts of the pose that this number of known combinations determines, for the confirmation.
    pub(super) fn confirm(&mut self, body: &Body<'_>, depth: usize) {
        let here = self.batched.confirmation.iter().filter(|r| self.batched.depths[r.value.node as usize] == depth);
        let terms: Vec<String> =
            here.map(|r| format!("({} - t[{}][{}]).abs()", body.value(r.value), r.row, r.column)).collect();
        if !terms.is_empty() {
            let name = match depth.checked_sub(1).and_then(|k| self.variables.known.get(k)) {
                Some(known) => format!("{}_error", known.value),
                None => "constant_error".into(),
            };
            self.loops.inner.push_str(&format!("let {name} = {};\n", terms.join(" + ")));
            self.loops.judge(2, name);
        }
    }

    /// Confirmation and actuators.
    pub(super) fn finish(&mut self) {
        self.loops.flush();
        let (inverse, width, total) = (self.inverse, self.loops.width, self.batched.branches);
        let open: Vec<usize> = (0..self.actuators.len()).filter(|k| !self.written.contains(k)).collect();
        let given = inverse.plan.given;
        let used = |known: usize| open.iter().any(|k| self.actuators[*k].form[known] != 0);
        let first = self.variables.values();
        for (_, name) in first.iter().enumerate().skip(given).filter(|(known, _)| used(*known)) {
            self.loops.load(name);
        }
        let judged = std::mem::take(&mut self.loops.judged);
        for (kind, names) in judged.iter().enumerate() {
            for name in names {
                self.loops.load(name);
            }
            self.loops.before.push_str(&format!("let mut all_{} = [0.0; {width}];\n", KINDS[kind]));
        }
        if width == 1 {
            self.loops.inner.push_str("let branch = 0;\n");
        }
        self.loops.inner.push_str("// How far the branch is from the target.\n");
        for (kind, names) in judged.iter().enumerate() {
            self.loops.inner.push_str(&format!("all_{}[branch] = {};\n", KINDS[kind], joined(kind, names)));
        }
        let mut sets = vec![first.clone()];
        if let Some(mirror) = &self.batched.mirror {
            self.loops.inner.push_str("// The mirrored half differs by signs.\n");
            let mut second = first;
            for (known, name) in second.iter_mut().enumerate().skip(given + mirror.step).filter(|(k, _)| used(*k)) {
                let text = mirrored(mirror, known - given, self.variables.known[known].is_angle, name);
                *name = format!("{name}_second");
                self.loops.inner.push_str(&format!("let {name} = {text};\n"));
            }
            sets.push(second);
        }
        for (half, values) in sets.iter().enumerate() {
            let at = if half == 0 { "branch".to_string() } else { format!("branch + {}", total / 2) };
            for k in &open {
                let value = self.motor_value(*k, values);
                self.loops.inner.push_str(&format!("q[{k}][{at}] = {value};\n"));
            }
        }
    }
}

/// The joint value of a step in the mirrored half.
fn mirrored(mirror: &Mirror, step: usize, is_angle: bool, first: &str) -> String {
    match (mirror.flips[step], is_angle) {
        ([false, false], _) => first.to_string(),
        ([true, _], false) => format!("-{first}"),
        ([true, true], _) => format!("::dh_robot::runtime::batched::opposite({first})"),
        ([false, true], _) => format!("::dh_robot::runtime::batched::negative({first})"),
        ([true, false], _) => format!("::dh_robot::runtime::batched::supplement({first})"),
    }
}
