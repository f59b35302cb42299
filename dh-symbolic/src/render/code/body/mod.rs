//! Instructions as statements: sines and cosines in one batch, then `let` lines; values used once are written where they are used.

mod angles;
mod code;

pub(in crate::render) use code::Code;

use super::names::CodeNames;
use super::steps::Variables;
use super::{field, literal, scaled_constant};
use crate::algebra::{Factor, Poly, Symbol};
use crate::chain::{Chain, Coordinate, Handle, Role, Scalar};
use crate::program::{Graph, Inverse, Node, Program, Value};

/// Longest expression that is not given a name.
const INLINE: usize = 56;

/// The language of the statements. Expressions read the same in both: `self` is the arm here and its parameters there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::render) enum Dialect {
    /// Sines and cosines in one batch.
    Rust,
    /// Sines and cosines by `Math`.
    JavaScript,
}

/// Writes the statements of a graph and the expressions of its outputs.
pub(in crate::render) struct Body<'a> {
    dialect: Dialect,
    /// Whether a variable is a number for each of several poses. Fields and constants are plain numbers even so.
    packed: bool,
    chain: &'a Chain,
    graph: &'a Graph,
    outputs: Vec<Value>,
    names: CodeNames,
    /// Number type of the code.
    scalar: Scalar,
    /// Factor of every length: 1, or 1 over the length scale.
    scale: f64,
    /// Input symbols that are neither fields nor joints.
    inputs: Vec<(Symbol, Code)>,
    /// Each node, once known.
    code: Vec<Option<Code>>,
    /// Whether that is a name.
    is_name: Vec<bool>,
    /// The statements.
    pub(in crate::render) lines: Vec<String>,
}

impl<'a> Body<'a> {
    /// All statements of a program.
    pub(super) fn new(chain: &'a Chain, program: &'a Program, scalar: Scalar) -> Body<'a> {
        Body::whole(Dialect::Rust, chain, program, scalar)
    }

    /// The same in Rust for the numbers of several poses.
    pub(super) fn packed(chain: &'a Chain, program: &'a Program) -> Body<'a> {
        let body = Body { packed: true, ..Body::empty(Dialect::Rust, chain, &program.graph, Scalar::F64) };
        body.filled(program)
    }

    /// The same in any language.
    pub(in crate::render) fn whole(
        dialect: Dialect,
        chain: &'a Chain,
        program: &'a Program,
        scalar: Scalar,
    ) -> Body<'a> {
        Body::empty(dialect, chain, &program.graph, scalar).filled(program)
    }

    /// With all statements of the program.
    fn filled(mut self, program: &Program) -> Body<'a> {
        self.outputs.clone_from(&program.outputs);
        self.trigonometry();
        let depths = vec![0; program.graph.nodes().len()];
        self.statements(&depths, 0);
        self
    }

    /// The values of an inverse, whose statements are asked for depth by depth, see [`Body::statements`]; lengths over the length scale.
    pub(in crate::render) fn of_inverse(
        dialect: Dialect,
        chain: &'a Chain,
        inverse: &'a Inverse,
        outputs: Vec<Value>,
        variables: &Variables,
    ) -> Body<'a> {
        let mut body = Body::empty(dialect, chain, &inverse.graph, Scalar::F64);
        (body.outputs, body.inputs, body.scale) = (outputs, variables.inputs(), 1.0 / inverse.plan.axes.length_scale);
        for name in variables.taken() {
            body.names.reserve(name);
        }
        body.trigonometry();
        body
    }

    /// Nothing is asked for yet.
    fn empty(dialect: Dialect, chain: &'a Chain, graph: &'a Graph, scalar: Scalar) -> Body<'a> {
        let names = CodeNames::new(&["q", "s", "c", "self", "t", "angles"]);
        let (code, is_name) = (vec![None; graph.nodes().len()], vec![false; graph.nodes().len()]);
        let (outputs, inputs, lines) = (Vec::new(), Vec::new(), Vec::new());
        Body { dialect, packed: false, chain, graph, outputs, names, scalar, scale: 1.0, inputs, code, is_name, lines }
    }

    fn number(&self, x: f64) -> Code {
        Code::number(x.is_sign_negative(), literal(x.abs(), self.scalar))
    }

    /// One coefficient times a variable.
    fn scaled(&self, k: &Poly, x: &str) -> Code {
        let x = Code::atom(x);
        match k.as_rational() {
            Some(r) if r.is_one() => x,
            Some(r) if (-&r).is_one() => x.negated(),
            _ => self.polynomial(k).whole_times(&x),
        }
    }

    /// A polynomial in constants and fields.
    fn polynomial(&self, p: &Poly) -> Code {
        let field = |f: &Factor| match f {
            Factor::Power(s, _) => self.is_field(Handle::Length(*s)),
            _ => false,
        };
        let parts: Vec<Code> = p
            .collect(field)
            .into_iter()
            .map(|(m, k)| {
                let k = scaled_constant(self.chain, &k, 1.0);
                let mut factors: Vec<Code> = Vec::new();
                if k != 1.0 || m.is_one() {
                    factors.push(self.number(k));
                }
                for f in m.factors() {
                    if let Factor::Power(s, n) = f {
                        factors.extend((0..n).map(|_| self.field(self.chain.ring.symbol_name(s))));
                    }
                }
                let product = factors.into_iter().reduce(|a, b| a.times(&b));
                product.unwrap_or_else(|| self.number(1.0))
            })
            .collect();
        if parts.is_empty() { self.number(0.0) } else { Code::sum(&parts) }
    }

    /// A field as a number of the code's type.
    fn field(&self, name: &str) -> Code {
        field(self.chain, name, self.scalar)
    }

    fn is_field(&self, handle: Handle) -> bool {
        self.chain.parameters.iter().any(|p| p.handle == handle && matches!(p.role, Role::Field(_)))
    }

    /// Appends the statements of one depth: nodes whose inputs are known there.
    pub(in crate::render) fn statements(&mut self, depths: &[usize], depth: usize) {
        let live = self.graph.live(&self.outputs);
        let users = self.users(&live, depths);
        for (i, node) in self.graph.nodes().iter().enumerate() {
            if !live[i] || depths[i] != depth || self.code[i].is_some() {
                continue;
            }
            let code = match *node {
                Node::Constant(k) => {
                    self.number(scaled_constant(self.chain, &self.graph.constants()[k as usize], self.scale))
                }
                Node::Symbol(s) => self.symbol(s),
                Node::Cos(_) | Node::Sin(_) => continue,
                Node::Add(a, b) => Code::sum(&[self.signed(a), self.signed(b)]),
                Node::Mul(a, b) => self.node(a).times(&self.node(b)),
            };
            let leaf = !matches!(node, Node::Add(..) | Node::Mul(..)) && code.is_atom();
            let once_here = users[i].0 <= 1 && users[i].1 == depth;
            if leaf || (once_here && code.len() <= INLINE) {
                self.code[i] = Some(code);
            } else {
                let name = self.name(node);
                self.lines.push(format!("let {} = {};", name.text(), code.text()));
                self.code[i] = Some(name);
                self.is_name[i] = true;
            }
        }
    }

    /// An input.
    fn symbol(&self, s: Symbol) -> Code {
        if let Some((_, code)) = self.inputs.iter().find(|x| x.0 == s) {
            return code.clone();
        }
        match self.chain.joints.iter().position(|j| j.coordinate == Coordinate::Length(s)) {
            Some(j) => {
                let x = self.coordinate(j);
                let actuators = x.actuators.iter().enumerate();
                let parts: Vec<Code> =
                    actuators.filter_map(|(m, k)| k.as_ref().map(|k| self.scaled(k, &format!("q[{m}]")))).collect();
                Code::sum(&parts)
            }
            None => {
                let field = self.field(self.chain.ring.symbol_name(s));
                if self.scale == 1.0 { field } else { field.times(&self.per_length()) }
            }
        }
    }

    /// A name for a node: `c4s5` for a product of named sines and cosines, else `t`.
    fn name(&mut self, node: &Node) -> Code {
        let short = |node: u32| {
            let name = self.code[node as usize].as_ref().and_then(Code::trigonometric_name);
            name.filter(|n| n.len() <= 8 && !n.contains('_'))
        };
        let wish = match node {
            Node::Mul(a, b) => short(*a).zip(short(*b)).map(|(a, b)| format!("{a}{b}")),
            _ => None,
        };
        match wish {
            Some(wish) => Code::trigonometric(self.names.take(&wish)),
            None => Code::atom(self.names.take("t")),
        }
    }

    /// Per node: how often it is used, and the depth of its user (the greatest).
    fn users(&self, live: &[bool], depths: &[usize]) -> Vec<(usize, usize)> {
        let mut users: Vec<(usize, usize)> = vec![(0, 0); live.len()];
        let mut note = |node: u32, depth: usize| {
            let u = &mut users[node as usize];
            *u = (u.0 + 1, u.1.max(depth));
        };
        for (i, node) in self.graph.nodes().iter().enumerate().filter(|(i, _)| live[*i]) {
            match node {
                Node::Add(a, b) => {
                    note(a.node, depths[i]);
                    note(b.node, depths[i]);
                }
                Node::Mul(a, b) => {
                    note(*a, depths[i]);
                    note(*b, depths[i]);
                }
                _ => {}
            }
        }
        for v in &self.outputs {
            let depth = depths[v.node as usize];
            note(v.node, depth);
        }
        users
    }

    fn node(&self, node: u32) -> Code {
        self.code[node as usize].clone().unwrap_or_else(|| self.number(0.0))
    }

    fn signed(&self, v: Value) -> Code {
        let code = self.node(v.node);
        if v.negative { code.negated() } else { code }
    }

    /// The expression of output `i`.
    pub(in crate::render) fn output(&self, i: usize) -> String {
        self.result(self.outputs.get(i).map_or_else(|| self.number(0.0), |v| self.signed(*v)).text())
    }

    /// An expression that goes into an array: packed, where the others are.
    fn result(&self, text: String) -> String {
        if self.packed { format!("q[0].of({text})") } else { text }
    }

    /// The expression of a value.
    pub(in crate::render) fn value(&self, v: Value) -> String {
        self.signed(v).text()
    }

    /// What a length is multiplied by.
    fn per_length(&self) -> Code {
        match self.dialect {
            Dialect::Rust => Code::atom("Self::PER_LENGTH"),
            Dialect::JavaScript => self.number(self.scale),
        }
    }

    /// The name of a node that has been written; one that has none gets one by a statement.
    pub(super) fn named(&mut self, node: usize) -> String {
        let text = self.node(node as u32).text();
        if self.is_name[node] {
            return text;
        }
        let name = self.names.take("t");
        self.lines.push(format!("let {name} = {text};"));
        self.rename(node, &name);
        name
    }

    /// Replaces the text of a node from here on.
    pub(super) fn rename(&mut self, node: usize, text: &str) {
        let input =
            |s: &Symbol| self.inputs.iter().find(|x| x.0 == *s).is_some_and(|x| x.1.trigonometric_name().is_some());
        let trigonometric = match &self.graph.nodes()[node] {
            Node::Symbol(s) => input(s),
            _ => self.code[node].as_ref().is_some_and(|c| c.trigonometric_name().is_some()),
        };
        self.code[node] = Some(if trigonometric { Code::trigonometric(text) } else { Code::atom(text) });
        self.is_name[node] = true;
    }

    /// Takes the statements written so far, as text.
    pub(in crate::render) fn take_text(&mut self) -> String {
        self.take_lines().iter().fold(String::new(), |text, line| text + line + "\n")
    }

    /// Takes the statements written so far.
    fn take_lines(&mut self) -> Vec<String> {
        std::mem::take(&mut self.lines)
    }
}

/// A polynomial in constants and fields as an `f64` expression.
pub(super) fn field_polynomial(chain: &Chain, p: &Poly) -> String {
    let graph = Graph::new(chain);
    Body::empty(Dialect::Rust, chain, &graph, Scalar::F64).polynomial(p).text()
}
