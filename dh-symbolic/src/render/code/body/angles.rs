//! Angles of a program: from the actuators to the batch of sines and cosines.

use super::super::names::subscript;
use super::super::shift_expression;
use super::{Body, Code, Dialect};
use crate::algebra::{LinearAngle, Poly, Rational};
use crate::chain::{Coordinate, Handle};
use crate::program::Node;

/// A linear combination of the actuators' positions plus a constant.
pub(super) struct Linear {
    /// Coefficient expressions per actuator; `None`: not in it.
    pub(super) actuators: Vec<Option<Poly>>,
    shift: Option<Code>,
}

impl Body<'_> {
    /// The coordinate of joint `i` in terms of q.
    pub(super) fn coordinate(&self, i: usize) -> Linear {
        let actuators = self.chain.drive[i].iter().map(|k| (!k.is_zero()).then(|| k.clone())).collect();
        let shift = shift_expression(self.chain, &self.chain.joints[i].shift, self.scalar);
        Linear { actuators, shift }
    }

    /// The argument of a sine.
    fn angle(&self, angle_sum: &LinearAngle) -> Code {
        let mut actuators: Vec<Poly> = vec![Poly::zero(); self.chain.dof()];
        let mut rest: Vec<Code> = Vec::new();
        for (v, k) in &angle_sum.terms {
            let factor = Rational::int(i64::from(*k));
            let joint = self.chain.joints.iter().position(|j| j.coordinate == Coordinate::Angle(*v));
            match joint {
                Some(i) => {
                    let x = self.coordinate(i);
                    for (sum, part) in actuators.iter_mut().zip(x.actuators) {
                        *sum = &*sum + &part.unwrap_or_default().scale(&factor);
                    }
                    rest.extend(x.shift.map(|shift| self.multiple(*k, &shift)));
                }
                None if self.is_field(Handle::Angle(*v)) => {
                    rest.push(self.multiple(*k, &self.field(self.chain.ring.angle_name(*v))));
                }
                None => {
                    let x = self.chain.nominal(Handle::Angle(*v)) * f64::from(*k);
                    rest.push(self.number(x));
                }
            }
        }
        let mut parts: Vec<Code> = actuators
            .iter()
            .enumerate()
            .filter(|(_, k)| !k.is_zero())
            .map(|(j, k)| self.scaled(k, &format!("q[{j}]")))
            .collect();
        parts.extend(rest);
        if !angle_sum.constant.is_zero() {
            parts.push(self.number(angle_sum.constant.radians()));
        }
        if parts.is_empty() { self.number(0.0) } else { Code::sum(&parts) }
    }

    fn multiple(&self, k: i8, code: &Code) -> Code {
        match k {
            1 => code.clone(),
            -1 => code.negated(),
            _ => self.number(f64::from(k)).times_whole(code),
        }
    }

    /// The batch of sines and cosines.
    pub(super) fn trigonometry(&mut self) {
        let live = self.graph.live(&self.outputs);
        let mut used: Vec<u32> = Vec::new();
        for (node, _) in self.graph.nodes().iter().zip(&live).filter(|(_, l)| **l) {
            if let Node::Cos(w) | Node::Sin(w) = node
                && !used.contains(w)
            {
                used.push(*w);
            }
        }
        used.sort_unstable();
        if used.is_empty() {
            return;
        }
        let (mut sines, mut cosines, mut angles) = (Vec::new(), Vec::new(), Vec::new());
        let mut plain = Vec::new();
        for w in &used {
            let angle_sum = &self.graph.angle_sums()[*w as usize];
            let tail = subscript(&self.chain.ring, angle_sum);
            let (s, c) = (self.names.take(&format!("s{tail}")), self.names.take(&format!("c{tail}")));
            angles.push(self.result(self.angle(angle_sum).text()));
            for (i, node) in self.graph.nodes().iter().enumerate() {
                match node {
                    Node::Cos(x) if x == w => self.code[i] = Some(Code::trigonometric(c.clone())),
                    Node::Sin(x) if x == w => self.code[i] = Some(Code::trigonometric(s.clone())),
                    _ => {}
                }
            }
            let unused = |sine: bool| {
                let is = |n: &Node| if sine { *n == Node::Sin(*w) } else { *n == Node::Cos(*w) };
                !self.graph.nodes().iter().zip(&live).any(|(n, l)| *l && is(n))
            };
            for (name, function, left_out) in [(&s, "sin", unused(true)), (&c, "cos", unused(false))] {
                if !left_out {
                    plain.push(format!("let {name} = Math.{function}({});", angles.last().map_or("0", String::as_str)));
                }
            }
            sines.push(if unused(true) { "_".to_string() } else { s });
            cosines.push(if unused(false) { "_".to_string() } else { c });
        }
        if self.dialect == Dialect::JavaScript {
            self.lines.extend(plain);
            return;
        }
        self.lines.push(format!("let angles = [{}];", angles.join(", ")));
        let batch = if self.packed { "sines.of" } else { "::dh_robot::runtime::sincos_batch" };
        self.lines.push(format!("let ([{}], [{}]) = {batch}(&angles);", sines.join(", "), cosines.join(", ")));
    }
}
