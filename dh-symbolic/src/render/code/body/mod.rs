//! Instructions as statements: sines and cosines in one batch, then `let` lines; values used once stand where they are used.

mod angles;

use super::names::Names;
use super::steps::Variables;
use super::{literal, scaled_constant};
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
    chain: &'a Chain,
    graph: &'a Graph,
    outputs: Vec<Value>,
    names: Names,
    /// Number type of the code.
    scalar: Scalar,
    /// Factor of every length: 1, or 1 over the reach.
    scale: f64,
    /// Names of input symbols that are neither fields nor joints.
    inputs: Vec<(Symbol, String)>,
    /// Text of each node, once known, and whether it is a sum (needs parentheses in a product).
    text: Vec<Option<(String, bool)>>,
    /// Is that text a name?
    is_name: Vec<bool>,
    /// The statements.
    pub(in crate::render) lines: Vec<String>,
}

impl<'a> Body<'a> {
    /// All statements of a program.
    pub(super) fn new(chain: &'a Chain, program: &'a Program, scalar: Scalar) -> Body<'a> {
        Body::whole(Dialect::Rust, chain, program, scalar)
    }

    /// The same in any language.
    pub(in crate::render) fn whole(
        dialect: Dialect,
        chain: &'a Chain,
        program: &'a Program,
        scalar: Scalar,
    ) -> Body<'a> {
        let outputs = program.outputs.clone();
        let mut body = Body::empty(dialect, chain, &program.graph, scalar);
        body.outputs = outputs;
        body.trigonometry();
        let depths = vec![0; program.graph.nodes().len()];
        body.statements(&depths, 0);
        body
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
        (body.outputs, body.inputs, body.scale) = (outputs, variables.inputs(), 1.0 / inverse.plan.axes.reach);
        for name in variables.taken() {
            body.names.reserve(name);
        }
        body.trigonometry();
        body
    }

    /// Nothing is asked for yet.
    fn empty(dialect: Dialect, chain: &'a Chain, graph: &'a Graph, scalar: Scalar) -> Body<'a> {
        let names = Names::new(&["q", "s", "c", "self", "t", "angles"]);
        let (text, is_name) = (vec![None; graph.nodes().len()], vec![false; graph.nodes().len()]);
        let (outputs, inputs, lines) = (Vec::new(), Vec::new(), Vec::new());
        Body { dialect, chain, graph, outputs, names, scalar, scale: 1.0, inputs, text, is_name, lines }
    }

    fn literal(&self, x: f64) -> String {
        literal(x, self.scalar)
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
                let k = scaled_constant(self.chain, &k, 1.0);
                let mut factors: Vec<String> = Vec::new();
                if k != 1.0 || m.is_one() {
                    factors.push(self.literal(k));
                }
                for f in m.factors() {
                    if let Factor::Power(s, n) = f {
                        factors.extend((0..n).map(|_| self.field(self.chain.ring.symbol_name(s))));
                    }
                }
                factors.join(" * ")
            })
            .collect();
        if parts.is_empty() { self.literal(0.0) } else { sum(&parts) }
    }

    /// A field as a number of the code's type.
    fn field(&self, name: &str) -> String {
        match (self.chain.scalar, self.scalar) {
            (Scalar::F32, Scalar::F64) => format!("f64::from(self.{name})"),
            _ => format!("self.{name}"),
        }
    }

    fn is_field(&self, handle: Handle) -> bool {
        self.chain.parameters.iter().any(|p| p.handle == handle && matches!(p.role, Role::Field(_)))
    }

    /// Appends the statements of one depth: nodes whose inputs are known there.
    pub(in crate::render) fn statements(&mut self, depths: &[usize], depth: usize) {
        let live = self.graph.live(&self.outputs);
        let users = self.users(&live, depths);
        for (i, node) in self.graph.nodes().iter().enumerate() {
            if !live[i] || depths[i] != depth || self.text[i].is_some() {
                continue;
            }
            let (text, is_sum) = match *node {
                Node::Constant(k) => {
                    let x = scaled_constant(self.chain, &self.graph.constants()[k as usize], self.scale);
                    (self.literal(x), false)
                }
                Node::Symbol(s) => self.symbol(s),
                Node::Cos(_) | Node::Sin(_) => continue,
                Node::Add(a, b) => (sum(&[self.signed(a), self.signed(b)]), true),
                Node::Mul(a, b) => (format!("{} * {}", self.factor(a), self.factor(b)), false),
            };
            let leaf = !matches!(node, Node::Add(..) | Node::Mul(..)) && !text.contains(' ');
            let once_here = users[i].0 <= 1 && users[i].1 == depth;
            if leaf || (once_here && text.len() <= INLINE) {
                self.text[i] = Some((text, is_sum));
            } else {
                let name = self.name(node);
                self.lines.push(format!("let {name} = {text};"));
                self.text[i] = Some((name, false));
                self.is_name[i] = true;
            }
        }
    }

    /// An input, and whether it is written as a sum.
    fn symbol(&self, s: Symbol) -> (String, bool) {
        if let Some((_, name)) = self.inputs.iter().find(|x| x.0 == s) {
            return (name.clone(), false);
        }
        match self.chain.joints.iter().position(|j| j.coordinate == Coordinate::Length(s)) {
            Some(j) => {
                let x = self.coordinate(j);
                let motors = x.motors.iter().enumerate();
                let parts: Vec<String> =
                    motors.filter_map(|(m, k)| k.as_ref().map(|k| self.scaled(k, &format!("q[{m}]")))).collect();
                (sum(&parts), parts.len() > 1)
            }
            None => {
                let field = self.field(self.chain.ring.symbol_name(s));
                if self.scale == 1.0 { (field, false) } else { (format!("{field} * {}", self.per_length()), false) }
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
    pub(in crate::render) fn output(&self, i: usize) -> String {
        self.outputs.get(i).map_or_else(|| self.literal(0.0), |v| self.signed(*v))
    }

    /// The expression of a value.
    pub(in crate::render) fn value(&self, v: Value) -> String {
        self.signed(v)
    }

    /// What a length is multiplied by.
    fn per_length(&self) -> String {
        match self.dialect {
            Dialect::Rust => "Self::PER_LENGTH".into(),
            Dialect::JavaScript => self.literal(self.scale),
        }
    }

    /// The name of a node that has been written; one that has none gets one by a statement.
    pub(super) fn named(&mut self, node: usize) -> String {
        let (text, _) = self.text[node].clone().unwrap_or_else(|| (self.literal(0.0), false));
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
        self.text[node] = Some((text.to_string(), false));
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
    Body::empty(Dialect::Rust, chain, &graph, Scalar::F64).polynomial(p)
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
