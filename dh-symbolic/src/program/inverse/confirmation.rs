//! The pose computed from the joint combinations found, which is compared with the target to confirm a branch.

use super::super::fold::Arithmetic;
use super::super::forward;
use super::super::graph::{Value, ZERO};
use super::lower::Lower;
use crate::algebra::{LinearAngle, Poly, Symbol};
use crate::chain::Chain;

impl Lower<'_> {
    /// The cheapest program of the pose, with sines and cosines made of known ones.
    pub(super) fn confirmation(&mut self, chain: &Chain) -> Vec<Value> {
        let pose = forward::pose(chain, &crate::kinematics::blocks(chain));
        let before = self.plan.knowledge.known.len();
        pose.graph.fold(&pose.outputs, &mut FromKnown { lower: self, before })
    }

    /// Cosine and sine of an angle sum of the chain: joints from what is known, the rest as it is.
    fn angle_sum(&mut self, angle_sum: &LinearAngle, before: usize) -> (Value, Value) {
        let mut form = vec![0i8; self.plan.axes.count()];
        let mut rest = angle_sum.clone();
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

/// Values made of what is known.
struct FromKnown<'a, 'b> {
    lower: &'a mut Lower<'b>,
    /// So many combinations are known.
    before: usize,
}

impl Arithmetic for FromKnown<'_, '_> {
    type Number = Value;

    fn zero(&mut self) -> Value {
        ZERO
    }

    fn constant(&mut self, p: &Poly) -> Value {
        self.lower.g.constant(p.clone())
    }

    fn symbol(&mut self, s: Symbol) -> Value {
        self.lower.g.symbol(s)
    }

    fn harmonic(&mut self, _: usize, angle: &LinearAngle, sine: bool) -> Value {
        let (c, s) = self.lower.angle_sum(angle, self.before);
        if sine { s } else { c }
    }

    fn negative(&mut self, a: Value) -> Value {
        -a
    }

    fn add(&mut self, a: Value, b: Value) -> Value {
        self.lower.g.add(a, b)
    }

    fn multiply(&mut self, a: Value, b: Value) -> Value {
        self.lower.g.mul(a, b)
    }
}
