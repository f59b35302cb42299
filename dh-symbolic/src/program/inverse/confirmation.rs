//! The pose that the known combinations give: what a branch is confirmed by.

use super::super::graph::{Value, ZERO};
use super::super::{Node, forward};
use super::lower::Lower;
use crate::algebra::LinearAngle;
use crate::chain::Chain;

impl Lower<'_> {
    /// The cheapest program of the pose, with sines and cosines made of known ones.
    pub(super) fn confirmation(&mut self, chain: &Chain) -> Vec<Value> {
        let pose = forward::pose(chain, &crate::kinematics::blocks(chain));
        let before = self.plan.knowledge.known.len();
        let mut values: Vec<Value> = Vec::with_capacity(pose.graph.nodes().len());
        let live = pose.graph.live(&pose.outputs);
        for (node, live) in pose.graph.nodes().iter().zip(live) {
            let signed =
                |v: Value, all: &[Value]| if v.negative { -all[v.node as usize] } else { all[v.node as usize] };
            let value = match *node {
                _ if !live => ZERO,
                Node::Constant(i) => self.g.constant(pose.graph.constants()[i as usize].clone()),
                Node::Symbol(s) => self.g.symbol(s),
                Node::Cos(w) => self.wave(&pose.graph.waves()[w as usize], before).0,
                Node::Sin(w) => self.wave(&pose.graph.waves()[w as usize], before).1,
                Node::Add(a, b) => self.g.add(signed(a, &values), signed(b, &values)),
                Node::Mul(a, b) => self.g.mul(values[a as usize], values[b as usize]),
            };
            values.push(value);
        }
        pose.outputs
            .iter()
            .map(|v| if v.negative { -values[v.node as usize] } else { values[v.node as usize] })
            .collect()
    }

    /// Cosine and sine of an angle sum of the chain: joints from what is known, the rest as it is.
    fn wave(&mut self, wave: &LinearAngle, before: usize) -> (Value, Value) {
        let mut form = vec![0i8; self.plan.axes.count()];
        let mut rest = wave.clone();
        rest.terms.retain(|(v, k)| match self.plan.axes.index_of_angle(*v) {
            Some(i) => {
                form[i] = *k;
                false
            }
            None => true,
        });
        let (c, s) = self.cos_sin(&form, before);
        let (rc, rs) = self.g.cos_sin(&rest);
        let turned = self.g.turn(2, (rc, rs), [c, s, ZERO]);
        (turned[0], turned[1])
    }
}
