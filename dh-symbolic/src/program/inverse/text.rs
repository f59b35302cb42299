//! The program of an inverse as text: what its snapshots show.

use super::{Instruction, Inverse, Sequence, Solve, Yield};
use crate::planner::{Argument, Call};
use crate::program::{Node, Value};
use std::fmt::{self, Display, Write};

impl Display for Inverse {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.block(&self.body, 0))
    }
}

impl Inverse {
    fn block(&self, block: &Sequence, level: usize) -> String {
        let mut out = String::new();
        let indent = "  ".repeat(level);
        for instruction in &block.0 {
            let _ = match instruction {
                Instruction::Given { known } => writeln!(out, "{indent}given {}", self.bound(&[*known])),
                Instruction::Compute { nodes, .. } => {
                    for node in nodes.iter().filter(|n| !self.is_leaf(**n)) {
                        let _ = writeln!(out, "{indent}v{node} = {}", self.node(*node));
                    }
                    Ok(())
                }
                Instruction::Solve(solve) => writeln!(out, "{indent}{}", self.solve_text(solve)),
                Instruction::Reject(report) => {
                    let unit = if report.is_length { "length" } else { "number" };
                    let distance = report.distance.map_or(String::new(), |d| {
                        let grows = if d.grows { ", amplitude grows with it" } else { "" };
                        format!(", distance^2 = {} + {}{grows}", self.value(d.base), self.value(d.rest))
                    });
                    writeln!(out, "{indent}reject `{}` ({unit}{distance})", report.name())
                }
                Instruction::ForEachRoot(over) => {
                    let joints: Vec<String> = over.free_joints.iter().map(|k| (k + 1).to_string()).collect();
                    let free = format!("joints free where degenerate: {}", joints.join(", "));
                    let _ = writeln!(out, "{indent}for each root of step {} ({free})", over.step + 1);
                    let _ = writeln!(out, "{indent}  bind {}", self.bound(&over.binds));
                    write!(out, "{}", self.block(&over.body, level + 1))
                }
                Instruction::Yield(result) => writeln!(out, "{indent}{}", self.yield_text(result)),
            };
        }
        out
    }

    /// The names of combinations, with the symbols of their cosine and sine (or of their length).
    fn bound(&self, list: &[usize]) -> String {
        let one = |k: &usize| {
            let known = &self.plan.knowledge.known[*k];
            let [c, s] = known.symbols.map(|s| self.plan.knowledge.ring.symbol_name(s));
            if known.is_angle { format!("{} ({c}, {s})", known.name) } else { format!("{} ({c})", known.name) }
        };
        list.iter().map(one).collect::<Vec<_>>().join(", ")
    }

    fn solve_text(&self, solve: &Solve) -> String {
        let Call { kernel, arguments } = &solve.call;
        let arguments: Vec<String> = arguments.iter().map(|a| self.argument(a)).collect();
        format!("solve step {}, {}: {}({})", solve.step + 1, solve.name, kernel.rust, arguments.join(", "))
    }

    fn argument(&self, argument: &Argument<Value>) -> String {
        let list = |l: &[Argument<Value>]| l.iter().map(|a| self.argument(a)).collect::<Vec<_>>().join(", ");
        match argument {
            Argument::Number(v) => self.value(*v),
            Argument::Array(l) => format!("[{}]", list(l)),
            Argument::Reference(l) => format!("&[{}]", list(l)),
            Argument::Representatives => "representatives".into(),
            Argument::Elimination { prismatic, cuts } => format!("prismatic {prismatic:?}, cuts {cuts:?}"),
        }
    }

    fn yield_text(&self, result: &Yield) -> String {
        let known = &self.plan.knowledge.known;
        let names: Vec<&str> = known.iter().map(|k| k.name.as_str()).collect();
        let joint = |form: &Vec<i8>| {
            let parts: Vec<String> =
                form.iter().zip(&names).filter(|(k, _)| **k != 0).map(|(k, n)| format!("{k:+}({n})")).collect();
            parts.join(" ")
        };
        let joints: Vec<String> = result.joints.iter().map(joint).collect();
        let branch: Vec<String> = result
            .branch
            .iter()
            .map(|c| {
                let name = c.name.map_or(String::new(), |n| {
                    let flipped = n.flipped_by.map_or(String::new(), |k| format!(", flipped by step {}", k + 1));
                    format!(" {:?} (first: root {}{flipped})", n.indicator, n.first + 1)
                });
                format!("step {}{name}", c.step + 1)
            })
            .collect();
        format!("yield [{}], branch: {}", joints.join(", "), branch.join("; "))
    }

    fn is_leaf(&self, node: u32) -> bool {
        !matches!(self.graph.nodes()[node as usize], Node::Add(..) | Node::Mul(..))
    }

    fn value(&self, v: Value) -> String {
        let sign = if v.negative { "-" } else { "" };
        if self.is_leaf(v.node) { format!("{sign}{}", self.node(v.node)) } else { format!("{sign}v{}", v.node) }
    }

    fn node(&self, node: u32) -> String {
        let ring = &self.plan.knowledge.ring;
        let plain = |node: u32| self.value(Value { node, negative: false });
        match self.graph.nodes()[node as usize] {
            Node::Constant(i) => {
                let p = &self.graph.constants()[i as usize];
                if p.terms().len() > 1 { format!("({})", ring.text(p)) } else { ring.text(p) }
            }
            Node::Symbol(s) => ring.symbol_name(s).to_string(),
            Node::Cos(i) => format!("cos#{i}"),
            Node::Sin(i) => format!("sin#{i}"),
            Node::Add(a, b) if b.negative => format!("{} - {}", self.value(a), self.value(-b)),
            Node::Add(a, b) => format!("{} + {}", self.value(a), self.value(b)),
            Node::Mul(a, b) => format!("{} * {}", plain(a), plain(b)),
        }
    }
}
