//! Programs as flat lists of instructions over numbered registers, so that running one costs little more than its arithmetic.
//!
//! A register is a row of lanes: one lane for a single pose, several for a batch. A value that differs between branches of an inverse has
//! consecutive rows, as many as there are branches (a power of two); an operand with fewer rows is repeated.

use dh_symbolic::chain::Chain;
use dh_symbolic::program::{Graph, Node, Value};

use crate::values::{Values, fixed_nodes, fixed_numbers};

/// Where a value stands: its first row, and its number of rows less one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Operand {
    pub(crate) at: u32,
    pub(crate) mask: u32,
}

impl Operand {
    /// The row of a branch.
    #[inline]
    pub(crate) fn row(self, branch: usize) -> usize {
        self.at as usize + (branch & self.mask as usize)
    }
}

/// What an instruction does.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Operation {
    Add,
    Subtract,
    Multiply,
}

/// One instruction, for all rows of its result.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Instruction {
    operation: Operation,
    to: u32,
    rows: u32,
    a: Operand,
    b: Operand,
}

/// Runs instructions on registers.
#[inline]
pub(crate) fn run<const L: usize>(instructions: &[Instruction], x: &mut [[f64; L]]) {
    for i in instructions {
        for row in 0..i.rows as usize {
            let (a, b) = (x[i.a.row(row)], x[i.b.row(row)]);
            let to = &mut x[i.to as usize + row];
            match i.operation {
                Operation::Add => (0..L).for_each(|l| to[l] = a[l] + b[l]),
                Operation::Subtract => (0..L).for_each(|l| to[l] = a[l] - b[l]),
                Operation::Multiply => (0..L).for_each(|l| to[l] = a[l] * b[l]),
            }
        }
    }
}

/// A value of a graph as a register, and whether its negative is meant.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Signed {
    pub(crate) at: Operand,
    pub(crate) negative: bool,
}

impl Signed {
    /// The number, in one lane.
    #[inline]
    pub(crate) fn number(self, x: &[[f64; 1]]) -> f64 {
        let [value] = x[self.at.at as usize];
        if self.negative { -value } else { value }
    }

    /// The lanes.
    #[inline]
    pub(crate) fn lanes<const L: usize>(self, x: &[[f64; L]]) -> [f64; L] {
        let value = x[self.at.at as usize];
        if self.negative { value.map(|x| -x) } else { value }
    }
}

/// Registers for the nodes of a graph. Those that follow from parameters alone come first.
pub(crate) struct Registers {
    graph: Graph,
    /// Which nodes follow from parameters alone.
    fixed: Vec<bool>,
    /// Which nodes are needed.
    pub(crate) live: Vec<bool>,
    /// The register of each node, once it has one.
    place: Vec<Option<Operand>>,
    /// How many registers there are, and how many of them the parameters fill.
    pub(crate) count: u32,
    pub(crate) prefix: u32,
}

impl Registers {
    /// Registers for what some outputs need.
    pub(crate) fn new(chain: &Chain, graph: &Graph, outputs: &[Value]) -> Registers {
        let (fixed, live) = (fixed_nodes(chain, graph), graph.live(outputs));
        let mut registers =
            Registers { place: vec![None; live.len()], graph: graph.clone(), fixed, live, count: 0, prefix: 0 };
        for node in 0..registers.live.len() {
            if registers.live[node] && registers.fixed[node] {
                registers.place[node] = Some(registers.rows(1));
            }
        }
        registers.prefix = registers.count;
        registers
    }

    /// What the parameters fill the first registers with.
    pub(crate) fn prefix(&self, values: &Values<'_>) -> Vec<f64> {
        let all = fixed_numbers(&self.graph, &self.fixed, values);
        let needed = all.into_iter().enumerate().filter(|(node, _)| self.live[*node] && self.fixed[*node]);
        needed.map(|(_, x)| x).collect()
    }

    /// New registers.
    pub(crate) fn rows(&mut self, rows: usize) -> Operand {
        let at = self.count;
        self.count += rows as u32;
        Operand { at, mask: rows as u32 - 1 }
    }

    /// The register of a node; a new one if it has none yet.
    pub(crate) fn place(&mut self, node: usize, rows: usize) -> Operand {
        match self.place[node] {
            Some(place) => place,
            None => {
                let place = self.rows(rows);
                self.place[node] = Some(place);
                place
            }
        }
    }

    /// The register of a value that has one; the first where it has none, which no proven program asks for.
    pub(crate) fn value(&self, v: Value) -> Signed {
        let at = self.place[v.node as usize].unwrap_or(Operand { at: 0, mask: 0 });
        Signed { at, negative: v.negative }
    }

    /// The node of a symbol, if it is needed.
    pub(crate) fn node_of(&self, symbol: dh_symbolic::algebra::Symbol) -> Option<usize> {
        let nodes = self.graph.nodes().iter().enumerate();
        nodes.filter(|(i, _)| self.live[*i]).find(|(_, n)| **n == Node::Symbol(symbol)).map(|(i, _)| i)
    }

    /// The needed nodes that are neither inputs nor fixed, with what they are.
    pub(crate) fn computed(&self) -> impl Iterator<Item = (usize, Node)> + '_ {
        let nodes = self.graph.nodes().iter().copied().enumerate();
        nodes.filter(|(i, n)| self.live[*i] && !self.fixed[*i] && matches!(n, Node::Add(..) | Node::Mul(..)))
    }

    /// The instruction of a sum or a product.
    pub(crate) fn instruction(&mut self, node: usize, rows: usize) -> Option<Instruction> {
        let (operation, a, b) = match self.graph.nodes()[node] {
            Node::Add(a, b) => {
                let operation = if b.negative { Operation::Subtract } else { Operation::Add };
                (operation, a.node, b.node)
            }
            Node::Mul(a, b) => (Operation::Multiply, a, b),
            _ => return None,
        };
        let [a, b] = [a, b].map(|node| self.value(Value { node, negative: false }).at);
        let to = self.place(node, rows).at;
        Some(Instruction { operation, to, rows: rows as u32, a, b })
    }
}
