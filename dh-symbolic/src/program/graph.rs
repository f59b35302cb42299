//! Hash-consed instructions. A value is a node with a sign, so that negation costs nothing and is shared.
//!
//! Invariants: an instruction stands after its operands; no instruction has a constant result that is not a constant; equal
//! instructions are one.

use crate::algebra::{AngleVar, LinearAngle, Poly, Symbol};
use crate::chain::{Chain, Handle, Role};
use std::collections::HashMap;

/// A node, or its negative.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Value {
    /// Index of the node.
    pub node: u32,
    /// Whether it is negated.
    pub negative: bool,
}

impl std::ops::Neg for Value {
    type Output = Value;
    fn neg(self) -> Value {
        // Zero has one sign: else code would say -0.0.
        Value { node: self.node, negative: !self.negative && self.node != ZERO.node }
    }
}

/// An instruction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Node {
    /// A constant: index into the graph's constants.
    Constant(u32),
    /// A field of the robot, or a sliding joint's coordinate, or another input.
    Symbol(Symbol),
    /// Cosine of an angle sum: index into the graph's angle_sums.
    Cos(u32),
    /// Sine of one.
    Sin(u32),
    /// Sum; the first operand is positive.
    Add(Value, Value),
    /// Product of two nodes.
    Mul(u32, u32),
}

/// A growing set of instructions.
#[derive(Clone, Debug)]
pub struct Graph {
    nodes: Vec<Node>,
    index: HashMap<Node, u32>,
    constants: Vec<Poly>,
    angle_sums: Vec<LinearAngle>,
    /// Symbols and angles whose values are known when the code is generated.
    fixed_symbols: Vec<Symbol>,
    fixed_angles: Vec<AngleVar>,
    /// Symbols that stand for values computed earlier.
    bound: Vec<(Symbol, Value)>,
}

/// The value 0; every graph begins with it.
pub(super) const ZERO: Value = Value { node: 0, negative: false };
/// The value 1.
pub(super) const ONE: Value = Value { node: 1, negative: false };

impl Graph {
    /// An empty graph for a chain: its constants are folded, its fields are inputs.
    pub fn new(chain: &Chain) -> Graph {
        let fixed = |p: &&crate::chain::Parameter| matches!(p.role, Role::Constant(_));
        let mut graph = Graph {
            nodes: Vec::new(),
            index: HashMap::new(),
            constants: Vec::new(),
            angle_sums: Vec::new(),
            fixed_symbols: Vec::new(),
            fixed_angles: Vec::new(),
            bound: Vec::new(),
        };
        for p in chain.parameters.iter().filter(fixed) {
            match p.handle {
                Handle::Length(s) => graph.fixed_symbols.push(s),
                Handle::Angle(v) => graph.fixed_angles.push(v),
            }
        }
        graph.constant(Poly::zero());
        graph.constant(Poly::one());
        graph
    }

    /// All nodes in order.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// A node.
    pub fn node(&self, v: Value) -> Node {
        self.nodes[v.node as usize]
    }

    /// The constants.
    pub fn constants(&self) -> &[Poly] {
        &self.constants
    }

    /// The angle sums of which sine or cosine are taken.
    pub fn angle_sums(&self) -> &[LinearAngle] {
        &self.angle_sums
    }

    /// A graph without instructions but 0 and 1, with the same constants and the same knowledge.
    pub(super) fn emptied(&self) -> Graph {
        let mut graph = Graph { nodes: Vec::new(), index: HashMap::new(), angle_sums: Vec::new(), ..self.clone() };
        graph.constant(Poly::zero());
        graph.constant(Poly::one());
        graph
    }

    pub(super) fn push(&mut self, node: Node) -> Value {
        let next = self.nodes.len() as u32;
        let id = *self.index.entry(node).or_insert(next);
        if id == next {
            self.nodes.push(node);
        }
        Value { node: id, negative: false }
    }

    /// A constant.
    pub fn constant(&mut self, p: Poly) -> Value {
        let negative = p.terms().first().is_some_and(|(_, c)| c.is_negative());
        let p = if negative { -&p } else { p };
        let i = match self.constants.iter().position(|x| *x == p) {
            Some(i) => i,
            None => {
                self.constants.push(p);
                self.constants.len() - 1
            }
        };
        let v = self.push(Node::Constant(i as u32));
        if negative { -v } else { v }
    }

    /// The constant behind a value, with its sign.
    pub fn as_constant(&self, v: Value) -> Option<Poly> {
        match self.node(v) {
            Node::Constant(i) => {
                let p = &self.constants[i as usize];
                Some(if v.negative { -p } else { p.clone() })
            }
            _ => None,
        }
    }

    /// Lets a symbol stand for a value.
    pub fn bind(&mut self, s: Symbol, v: Value) {
        self.bound.push((s, v));
    }

    /// What a symbol stands for.
    pub fn bound_to(&self, s: Symbol) -> Option<Value> {
        self.bound.iter().find(|b| b.0 == s).map(|b| b.1)
    }

    /// A symbol: what it is bound to, a constant where its value is known, else an input.
    pub fn symbol(&mut self, s: Symbol) -> Value {
        if let Some((_, v)) = self.bound.iter().find(|b| b.0 == s) {
            return *v;
        }
        if self.fixed_symbols.contains(&s) { self.constant(Poly::symbol(s)) } else { self.push(Node::Symbol(s)) }
    }

    /// (cosine, sine) of an angle sum. Whole quarter turns are taken out, so that cos(q - 90deg) is sin q.
    pub fn cos_sin(&mut self, angle: &LinearAngle) -> (Value, Value) {
        let known = angle.terms.iter().all(|(v, _)| self.fixed_angles.contains(v));
        if known && let Some((c, s)) = angle.cos_sin() {
            return (self.constant(c), self.constant(s));
        }
        let mut rest = angle.clone();
        rest.terms.sort_unstable();
        let flip = rest.terms.first().is_some_and(|t| t.1 < 0);
        if flip {
            for t in &mut rest.terms {
                t.1 = -t.1;
            }
            rest.constant = rest.constant.times(&crate::algebra::Rational::int(-1));
        }
        let quarter = rest.constant.steps_of_15_degrees().filter(|n| n % 6 == 0).map(|n| n / 6);
        if quarter.is_some() {
            rest.constant = crate::algebra::Angle::ZERO;
        }
        let i = match self.angle_sums.iter().position(|w| *w == rest) {
            Some(i) => i,
            None => {
                self.angle_sums.push(rest);
                self.angle_sums.len() - 1
            }
        } as u32;
        let (c, s) = (self.push(Node::Cos(i)), self.push(Node::Sin(i)));
        let (c, s) = match quarter.unwrap_or(0) {
            1 => (-s, c),
            2 => (-c, -s),
            3 => (s, -c),
            _ => (c, s),
        };
        (c, if flip { -s } else { s })
    }

    /// a + b.
    pub fn add(&mut self, a: Value, b: Value) -> Value {
        if a == ZERO {
            return b;
        }
        if b == ZERO {
            return a;
        }
        if a == -b {
            return ZERO;
        }
        if let (Some(x), Some(y)) = (self.as_constant(a), self.as_constant(b)) {
            return self.constant(&x + &y);
        }
        let (a, b) = if a.node <= b.node { (a, b) } else { (b, a) };
        // Keep the first operand positive, so that a - b and b - a are one node.
        if a.negative { -self.push(Node::Add(-a, -b)) } else { self.push(Node::Add(a, b)) }
    }

    /// a - b.
    pub fn sub(&mut self, a: Value, b: Value) -> Value {
        self.add(a, -b)
    }

    /// a * b.
    pub fn mul(&mut self, a: Value, b: Value) -> Value {
        if a.node == ZERO.node || b.node == ZERO.node {
            return ZERO;
        }
        let negative = a.negative != b.negative;
        let product = if a.node == ONE.node {
            Value { node: b.node, negative: false }
        } else if b.node == ONE.node {
            Value { node: a.node, negative: false }
        } else if let (Node::Constant(x), Node::Constant(y)) = (self.node(a), self.node(b)) {
            let p = &self.constants[x as usize] * &self.constants[y as usize];
            self.constant(p)
        } else {
            self.push(Node::Mul(a.node.min(b.node), a.node.max(b.node)))
        };
        if negative { -product } else { product }
    }

    /// A polynomial, term by term: for parameters of links (`a2 + 10mm`), where there is nothing to factor.
    pub fn polynomial(&mut self, p: &Poly) -> Value {
        use crate::algebra::{Factor, Monomial};
        let (symbols, angles) = (self.fixed_symbols.clone(), self.fixed_angles.clone());
        let known = |f: &Factor| match f {
            Factor::Root(_) => true,
            Factor::Power(s, _) => symbols.contains(s),
            Factor::Cos(t) | Factor::Sin(t) => t.iter().all(|(v, _)| angles.contains(v)),
        };
        let mut sum = ZERO;
        for (inputs, coefficient) in p.collect(|f| !known(f)) {
            let mut product = self.constant(coefficient);
            if inputs == Monomial::one() {
                sum = self.add(sum, product);
                continue;
            }
            for f in inputs.factors() {
                product = match f {
                    Factor::Power(s, n) => {
                        let x = self.symbol(s);
                        (0..n).fold(product, |y, _| self.mul(y, x))
                    }
                    Factor::Cos(terms) => {
                        let (c, _) = self.cos_sin(&LinearAngle { terms, constant: crate::algebra::Angle::ZERO });
                        self.mul(product, c)
                    }
                    Factor::Sin(terms) => {
                        let (_, s) = self.cos_sin(&LinearAngle { terms, constant: crate::algebra::Angle::ZERO });
                        self.mul(product, s)
                    }
                    Factor::Root(_) => product,
                };
            }
            sum = self.add(sum, product);
        }
        sum
    }

    /// Which nodes the outputs need.
    pub fn live(&self, outputs: &[Value]) -> Vec<bool> {
        let mut live = vec![false; self.nodes.len()];
        for v in outputs {
            live[v.node as usize] = true;
        }
        for i in (0..self.nodes.len()).rev() {
            if live[i] {
                match self.nodes[i] {
                    Node::Add(a, b) => {
                        live[a.node as usize] = true;
                        live[b.node as usize] = true;
                    }
                    Node::Mul(a, b) => {
                        live[a as usize] = true;
                        live[b as usize] = true;
                    }
                    _ => {}
                }
            }
        }
        live
    }
}
