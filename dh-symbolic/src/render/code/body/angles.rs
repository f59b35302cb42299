//! Angles of a program: from the motors to the batch of sines and cosines.

use super::super::names::subscript;
use super::super::shift_expression;
use super::{Body, Dialect, sum};
use crate::algebra::{LinearAngle, Poly, Rational};
use crate::chain::{Coordinate, Handle};
use crate::program::Node;

/// A linear combination of the motors' positions plus a constant.
pub(super) struct Linear {
    /// Coefficient expressions per motor; `None`: not in it.
    pub(super) motors: Vec<Option<Poly>>,
    shift: Vec<String>,
}

impl Body<'_> {
    /// The coordinate of joint `i` in terms of q.
    pub(super) fn coordinate(&self, i: usize) -> Linear {
        let motors = self.chain.drive[i].iter().map(|k| (!k.is_zero()).then(|| k.clone())).collect();
        let shift = shift_expression(self.chain, &self.chain.joints[i].shift, self.scalar);
        Linear { motors, shift: shift.into_iter().collect() }
    }

    /// The argument of a sine.
    fn angle(&self, wave: &LinearAngle) -> String {
        let mut motors: Vec<Poly> = vec![Poly::zero(); self.chain.dof()];
        let mut rest: Vec<String> = Vec::new();
        for (v, k) in &wave.terms {
            let factor = Rational::int(i64::from(*k));
            let joint = self.chain.joints.iter().position(|j| j.coordinate == Coordinate::Angle(*v));
            match joint {
                Some(i) => {
                    let x = self.coordinate(i);
                    for (sum, part) in motors.iter_mut().zip(x.motors) {
                        *sum = &*sum + &part.unwrap_or_default().scale(&factor);
                    }
                    for text in x.shift {
                        rest.push(self.multiple(*k, &text));
                    }
                }
                None if self.is_field(Handle::Angle(*v)) => {
                    rest.push(self.multiple(*k, &self.field(self.chain.ring.angle_name(*v))));
                }
                None => {
                    let x = self.chain.nominal(Handle::Angle(*v)) * f64::from(*k);
                    rest.push(self.literal(x));
                }
            }
        }
        let mut parts: Vec<String> = motors
            .iter()
            .enumerate()
            .filter(|(_, k)| !k.is_zero())
            .map(|(j, k)| self.scaled(k, &format!("q[{j}]")))
            .collect();
        parts.extend(rest);
        if !wave.constant.is_zero() {
            parts.push(self.literal(wave.constant.radians()));
        }
        if parts.is_empty() { self.literal(0.0) } else { sum(&parts) }
    }

    fn multiple(&self, k: i8, text: &str) -> String {
        let inner = if text.contains(' ') { format!("({text})") } else { text.to_string() };
        match k {
            1 => text.to_string(),
            -1 => match text.strip_prefix('-') {
                Some(rest) if !rest.contains(' ') => rest.to_string(),
                _ => format!("-{inner}"),
            },
            _ => format!("{} * {inner}", self.literal(f64::from(k))),
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
            let wave = &self.graph.waves()[*w as usize];
            let tail = subscript(&self.chain.ring, wave);
            let (s, c) = (self.names.take(&format!("s{tail}")), self.names.take(&format!("c{tail}")));
            angles.push(self.angle(wave));
            for (i, node) in self.graph.nodes().iter().enumerate() {
                match node {
                    Node::Cos(x) if x == w => self.text[i] = Some((c.clone(), false)),
                    Node::Sin(x) if x == w => self.text[i] = Some((s.clone(), false)),
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
        self.lines.push(format!(
            "let ([{}], [{}]) = ::dh_robot::runtime::sincos_batch(&angles);",
            sines.join(", "),
            cosines.join(", ")
        ));
    }
}
