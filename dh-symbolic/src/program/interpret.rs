//! Runs a program on f64: the second opinion in tests, and the numbers of worked examples.

use super::{Node, Program};
use crate::algebra::Point;

/// Values of the inputs.
pub type Inputs<'a> = Point<'a>;

impl Program {
    /// The outputs at a point.
    pub fn run(&self, at: &Inputs<'_>) -> Vec<f64> {
        let mut x: Vec<f64> = Vec::with_capacity(self.graph.nodes().len());
        let angle = |w: u32| {
            let wave = &self.graph.waves()[w as usize];
            wave.terms.iter().map(|(v, k)| f64::from(*k) * (at.angle)(*v)).sum::<f64>() + wave.constant.radians()
        };
        for node in self.graph.nodes() {
            let value = match *node {
                Node::Constant(i) => self.graph.constants()[i as usize].evaluate(at),
                Node::Symbol(s) => (at.symbol)(s),
                Node::Cos(w) => angle(w).cos(),
                Node::Sin(w) => angle(w).sin(),
                Node::Add(a, b) => {
                    let (l, r) = (x[a.node as usize], x[b.node as usize]);
                    if b.negative { l - r } else { l + r }
                }
                Node::Mul(a, b) => x[a as usize] * x[b as usize],
            };
            x.push(value);
        }
        self.outputs.iter().map(|v| if v.negative { -x[v.node as usize] } else { x[v.node as usize] }).collect()
    }
}
