//! The walk over a graph's instructions, with numbers of any kind: `f64`, elements of a field, polynomials, values of another graph.

use super::graph::{Graph, Node, Value};
use crate::algebra::{LinearAngle, Poly, Symbol};

/// A kind of numbers that instructions can be carried out in.
pub(super) trait Arithmetic {
    /// A number.
    type Number: Clone;
    /// Zero, also in the place of what nobody needs.
    fn zero(&mut self) -> Self::Number;
    /// A constant.
    fn constant(&mut self, p: &Poly) -> Self::Number;
    /// An input.
    fn symbol(&mut self, s: Symbol) -> Self::Number;
    /// Cosine of angle sum number `index`, or its sine.
    fn harmonic(&mut self, index: usize, angle: &LinearAngle, sine: bool) -> Self::Number;
    /// The negative.
    fn negative(&mut self, a: Self::Number) -> Self::Number;
    /// a + b.
    fn add(&mut self, a: Self::Number, b: Self::Number) -> Self::Number;
    /// a b.
    fn multiply(&mut self, a: Self::Number, b: Self::Number) -> Self::Number;
}

impl Graph {
    /// Carries out one instruction, given the numbers of those before it.
    pub(super) fn carry_out<A: Arithmetic>(&self, node: usize, before: &[A::Number], by: &mut A) -> A::Number {
        let number = |k: u32| before[k as usize].clone();
        match self.nodes()[node] {
            Node::Constant(i) => by.constant(&self.constants()[i as usize]),
            Node::Symbol(s) => by.symbol(s),
            Node::Cos(i) => by.harmonic(i as usize, &self.angle_sums()[i as usize], false),
            Node::Sin(i) => by.harmonic(i as usize, &self.angle_sums()[i as usize], true),
            Node::Add(a, b) => {
                let (a, b) = (signed(a, before, by), signed(b, before, by));
                by.add(a, b)
            }
            Node::Mul(a, b) => by.multiply(number(a), number(b)),
        }
    }

    /// Carries out what some outputs need; gives back their numbers.
    pub(super) fn fold<A: Arithmetic>(&self, outputs: &[Value], by: &mut A) -> Vec<A::Number> {
        let all = self.fold_nodes(outputs, by);
        outputs.iter().map(|v| signed(*v, &all, by)).collect()
    }

    /// The same; gives back the numbers of all nodes, zero for those that are not needed.
    pub(super) fn fold_nodes<A: Arithmetic>(&self, outputs: &[Value], by: &mut A) -> Vec<A::Number> {
        let mut all: Vec<A::Number> = Vec::with_capacity(self.nodes().len());
        for (node, live) in self.live(outputs).into_iter().enumerate() {
            let number = if live { self.carry_out(node, &all, by) } else { by.zero() };
            all.push(number);
        }
        all
    }
}

/// The number of a value.
fn signed<A: Arithmetic>(v: Value, all: &[A::Number], by: &mut A) -> A::Number {
    let number = all[v.node as usize].clone();
    if v.negative { by.negative(number) } else { number }
}
