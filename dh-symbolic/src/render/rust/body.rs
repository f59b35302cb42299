//! A program as statements: sines and cosines in one batch, then `let` lines; values used once stand where they are used.

use super::names::{Names, subscript};
use super::{constant, literal, shift_expression};
use crate::algebra::{Factor, LinearAngle, Poly};
use crate::chain::{Chain, Coordinate, Handle, Role};
use crate::program::{Node, Program, Value};

/// Longest expression that is not given a name.
const INLINE: usize = 56;

/// Writes the statements of a program and the expressions of its outputs.
pub(super) struct Body<'a> {
    chain: &'a Chain,
    program: &'a Program,
    names: Names,
    /// Text of each node, once known, and whether it is a sum (needs parentheses in a product).
    text: Vec<Option<(String, bool)>>,
    /// The statements.
    pub(super) lines: Vec<String>,
}

/// A linear combination of the motors' positions plus a constant.
struct Linear {
    /// Coefficient expressions per motor; `None`: not in it.
    motors: Vec<Option<Poly>>,
    shift: Vec<String>,
}

impl<'a> Body<'a> {
    pub(super) fn new(chain: &'a Chain, program: &'a Program) -> Body<'a> {
        let names = Names::new(&["q", "s", "c", "self"]);
        let mut body = Body { chain, program, names, text: vec![None; program.graph.nodes().len()], lines: Vec::new() };
        body.trigonometry();
        body.statements();
        body
    }

    fn literal(&self, x: f64) -> String {
        literal(x, self.chain.scalar)
    }

    /// One coefficient times a variable.
    fn scaled(&self, k: &Poly, x: &str) -> String {
        match k.as_rational() {
            Some(r) if r.is_one() => x.to_string(),
            Some(r) if (-&r).is_one() => format!("-{x}"),
            _ => {
                let k = self.polynomial(k);
                if k.contains(' ') { format!("({k}) * {x}") } else { format!("{k} * {x}") }
            }
        }
    }

    /// A polynomial in constants and fields.
    fn polynomial(&self, p: &Poly) -> String {
        let field = |f: &Factor| match f {
            Factor::Power(s, _) => self.is_field(Handle::Length(*s)),
            _ => false,
        };
        let parts: Vec<String> = p
            .collect(field)
            .into_iter()
            .map(|(m, k)| {
                let k = constant(self.chain, &k);
                let mut factors: Vec<String> = Vec::new();
                if k != 1.0 || m.is_one() {
                    factors.push(self.literal(k));
                }
                for f in m.factors() {
                    if let Factor::Power(s, n) = f {
                        factors.extend((0..n).map(|_| format!("self.{}", self.chain.ring.symbol_name(s))));
                    }
                }
                factors.join(" * ")
            })
            .collect();
        if parts.is_empty() { self.literal(0.0) } else { sum(&parts) }
    }

    fn is_field(&self, handle: Handle) -> bool {
        self.chain.parameters.iter().any(|p| p.handle == handle && matches!(p.role, Role::Field(_)))
    }

    /// The coordinate of joint `i` in terms of q.
    fn coordinate(&self, i: usize) -> Linear {
        let motors = self.chain.drive[i].iter().map(|k| (!k.is_zero()).then(|| k.clone())).collect();
        let shift = shift_expression(self.chain, &self.chain.joints[i].shift);
        Linear { motors, shift: shift.into_iter().collect() }
    }

    /// The argument of a sine.
    fn angle(&self, wave: &LinearAngle) -> String {
        let mut motors: Vec<Poly> = vec![Poly::zero(); self.chain.dof()];
        let mut rest: Vec<String> = Vec::new();
        for (v, k) in &wave.terms {
            let factor = crate::algebra::Rational::int(i64::from(*k));
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
                    rest.push(self.multiple(*k, &format!("self.{}", self.chain.ring.angle_name(*v))));
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
    fn trigonometry(&mut self) {
        let live = self.program.graph.live(&self.program.outputs);
        let mut used: Vec<u32> = Vec::new();
        for (node, _) in self.program.graph.nodes().iter().zip(&live).filter(|(_, l)| **l) {
            if let Node::Cos(w) | Node::Sin(w) = node {
                if !used.contains(w) {
                    used.push(*w);
                }
            }
        }
        used.sort_unstable();
        if used.is_empty() {
            return;
        }
        let (mut sines, mut cosines, mut angles) = (Vec::new(), Vec::new(), Vec::new());
        for w in &used {
            let wave = &self.program.graph.waves()[*w as usize];
            let tail = subscript(&self.chain.ring, wave);
            let (s, c) = (self.names.take(&format!("s{tail}")), self.names.take(&format!("c{tail}")));
            angles.push(self.angle(wave));
            for (i, node) in self.program.graph.nodes().iter().enumerate() {
                match node {
                    Node::Cos(x) if x == w => self.text[i] = Some((c.clone(), false)),
                    Node::Sin(x) if x == w => self.text[i] = Some((s.clone(), false)),
                    _ => {}
                }
            }
            let unused = |sine: bool| {
                let is = |n: &Node| if sine { *n == Node::Sin(*w) } else { *n == Node::Cos(*w) };
                !self.program.graph.nodes().iter().zip(&live).any(|(n, l)| *l && is(n))
            };
            sines.push(if unused(true) { "_".to_string() } else { s });
            cosines.push(if unused(false) { "_".to_string() } else { c });
        }
        self.lines.push(format!("let angles = [{}];", angles.join(", ")));
        self.lines.push(format!(
            "let ([{}], [{}]) = ::dh_robot::sincos::sincos_batch(&angles);",
            sines.join(", "),
            cosines.join(", ")
        ));
    }

    fn statements(&mut self) {
        let live = self.program.graph.live(&self.program.outputs);
        let uses = self.uses(&live);
        for (i, node) in self.program.graph.nodes().iter().enumerate() {
            if !live[i] || self.text[i].is_some() {
                continue;
            }
            let (text, is_sum) = match *node {
                Node::Constant(k) => {
                    (self.literal(constant(self.chain, &self.program.graph.constants()[k as usize])), false)
                }
                Node::Symbol(s) => {
                    let joint = self.chain.joints.iter().position(|j| j.coordinate == Coordinate::Length(s));
                    match joint {
                        Some(j) => {
                            let x = self.coordinate(j);
                            let parts: Vec<String> = x
                                .motors
                                .iter()
                                .enumerate()
                                .filter_map(|(m, k)| k.as_ref().map(|k| self.scaled(k, &format!("q[{m}]"))))
                                .collect();
                            (sum(&parts), parts.len() > 1)
                        }
                        None => (format!("self.{}", self.chain.ring.symbol_name(s)), false),
                    }
                }
                Node::Cos(_) | Node::Sin(_) => continue,
                Node::Add(a, b) => (sum(&[self.signed(a), self.signed(b)]), true),
                Node::Mul(a, b) => (format!("{} * {}", self.factor(a), self.factor(b)), false),
            };
            let leaf = !matches!(node, Node::Add(..) | Node::Mul(..)) && !text.contains(' ');
            if leaf || (uses[i] <= 1 && text.len() <= INLINE) {
                self.text[i] = Some((text, is_sum));
            } else {
                let name = self.name(node);
                self.lines.push(format!("let {name} = {text};"));
                self.text[i] = Some((name, false));
            }
        }
    }

    /// `c4s5` for a product of named sines and cosines, else `t`.
    fn name(&mut self, node: &Node) -> String {
        let plain = |s: &str| s.len() <= 8 && s.starts_with(['c', 's']) && s.chars().all(|c| c.is_ascii_alphanumeric());
        let wish = match node {
            Node::Mul(a, b) => match (&self.text[*a as usize], &self.text[*b as usize]) {
                (Some((a, false)), Some((b, false))) if plain(a) && plain(b) => format!("{a}{b}"),
                _ => "t".into(),
            },
            _ => "t".into(),
        };
        self.names.take(&wish)
    }

    fn uses(&self, live: &[bool]) -> Vec<usize> {
        let mut uses = vec![0; live.len()];
        for (node, _) in self.program.graph.nodes().iter().zip(live).filter(|(_, l)| **l) {
            match node {
                Node::Add(a, b) => {
                    uses[a.node as usize] += 1;
                    uses[b.node as usize] += 1;
                }
                Node::Mul(a, b) => {
                    uses[*a as usize] += 1;
                    uses[*b as usize] += 1;
                }
                _ => {}
            }
        }
        for v in &self.program.outputs {
            uses[v.node as usize] += 1;
        }
        uses
    }

    fn factor(&self, node: u32) -> String {
        match &self.text[node as usize] {
            Some((text, true)) => format!("({text})"),
            Some((text, false)) => text.clone(),
            None => self.literal(0.0),
        }
    }

    fn signed(&self, v: Value) -> String {
        match (&self.text[v.node as usize], v.negative) {
            (Some((text, _)), false) => text.clone(),
            (Some((text, true)), true) => format!("-({text})"),
            (Some((text, false)), true) => format!("-{text}"),
            (None, _) => self.literal(0.0),
        }
    }

    /// The expression of output `i`.
    pub(super) fn output(&self, i: usize) -> String {
        self.program.outputs.get(i).map_or_else(|| self.literal(0.0), |v| self.signed(*v))
    }
}

/// a + b - c, with signs pulled into the operators.
fn sum(parts: &[String]) -> String {
    let mut out = String::new();
    for p in parts {
        match (out.is_empty(), p.strip_prefix('-')) {
            (true, _) => out.push_str(p),
            (false, Some(rest)) => {
                out.push_str(" - ");
                out.push_str(rest);
            }
            (false, None) => {
                out.push_str(" + ");
                out.push_str(p);
            }
        }
    }
    out
}
