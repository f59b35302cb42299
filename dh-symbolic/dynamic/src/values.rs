//! The numbers of an arm's parameters, and of formulas in them.

use dh_symbolic::algebra::{AngleVar, LinearAngle, Point, Poly, Symbol};
use dh_symbolic::chain::{Chain, Handle};
use dh_symbolic::program::{Graph, Node};

/// Values of a chain's parameters, in their order: table units and radians.
#[derive(Clone, Copy)]
pub(crate) struct Values<'a> {
    pub(crate) chain: &'a Chain,
    pub(crate) list: &'a [f64],
    /// What lengths are multiplied by: 1, or 1 over the length scale.
    pub(crate) per_length: f64,
}

impl<'a> Values<'a> {
    /// The same with another factor of all lengths.
    pub(crate) fn scaled(self, per_length: f64) -> Values<'a> {
        Values { per_length, ..self }
    }

    fn of(&self, handle: Handle) -> f64 {
        let place = self.chain.parameters.iter().position(|p| p.handle == handle);
        place.and_then(|i| self.list.get(i)).copied().unwrap_or(f64::NAN)
    }

    /// A length.
    pub(crate) fn length(&self, s: Symbol) -> f64 {
        self.of(Handle::Length(s)) * self.per_length
    }

    /// An angle.
    pub(crate) fn angle(&self, v: AngleVar) -> f64 {
        self.of(Handle::Angle(v))
    }

    /// A formula in parameters.
    pub(crate) fn formula(&self, p: &Poly) -> f64 {
        p.evaluate(&Point { symbol: &|s| self.length(s), angle: &|v| self.angle(v) })
    }

    /// The constant part of the angle of joint `i` that formulas leave out.
    pub(crate) fn shift(&self, joint: usize) -> f64 {
        let Some(joint) = self.chain.joints.get(joint) else { return 0.0 };
        let named = joint.shift.symbols.iter();
        let named = named.map(|(p, k)| f64::from(*k) * self.list.get(*p).copied().unwrap_or(f64::NAN));
        named.sum::<f64>() + joint.shift.radians()
    }
}

/// Whether a symbol is a parameter.
pub(crate) fn is_parameter(chain: &Chain, handle: Handle) -> bool {
    chain.parameters.iter().any(|p| p.handle == handle)
}

/// Whether an angle sum holds parameters alone.
pub(crate) fn is_constant_angle(chain: &Chain, angle: &LinearAngle) -> bool {
    angle.terms.iter().all(|(v, _)| is_parameter(chain, Handle::Angle(*v)))
}

/// Which nodes of a graph follow from parameters alone.
pub(crate) fn fixed_nodes(chain: &Chain, graph: &Graph) -> Vec<bool> {
    let mut fixed: Vec<bool> = Vec::with_capacity(graph.nodes().len());
    for node in graph.nodes() {
        fixed.push(match *node {
            Node::Constant(_) => true,
            Node::Symbol(s) => is_parameter(chain, Handle::Length(s)),
            Node::Cos(i) | Node::Sin(i) => is_constant_angle(chain, &graph.angle_sums()[i as usize]),
            Node::Add(a, b) => fixed[a.node as usize] && fixed[b.node as usize],
            Node::Mul(a, b) => fixed[a as usize] && fixed[b as usize],
        });
    }
    fixed
}

/// The numbers of nodes that follow from parameters alone; the others are 0.
pub(crate) fn fixed_numbers(graph: &Graph, fixed: &[bool], values: &Values<'_>) -> Vec<f64> {
    let mut all: Vec<f64> = Vec::with_capacity(fixed.len());
    for (node, fixed) in graph.nodes().iter().zip(fixed) {
        let sum = |i: u32| {
            let angle = &graph.angle_sums()[i as usize];
            angle.terms.iter().map(|(v, k)| f64::from(*k) * values.angle(*v)).sum::<f64>() + angle.constant.radians()
        };
        let x = match *node {
            _ if !fixed => 0.0,
            Node::Constant(i) => values.formula(&graph.constants()[i as usize]),
            Node::Symbol(s) => values.length(s),
            Node::Cos(i) => sum(i).cos(),
            Node::Sin(i) => sum(i).sin(),
            Node::Add(a, b) => all[a.node as usize] + if b.negative { -1.0 } else { 1.0 } * all[b.node as usize],
            Node::Mul(a, b) => all[a as usize] * all[b as usize],
        };
        all.push(x);
    }
    all
}
