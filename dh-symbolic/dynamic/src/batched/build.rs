//! From the batched form of a plan to flat operations: values depth by depth, steps with their roots, and what confirms a branch.

use dh_symbolic::planner::{Argument, BatchedRoots};
use dh_symbolic::program::{Batched, Inverse, Value};

use super::operation::{Operation, rows};
use crate::tape::{Operand, Registers};

/// Turns the batched form of a plan into operations.
pub(super) struct Builder<'a> {
    pub(super) inverse: &'a Inverse,
    pub(super) batched: &'a Batched,
    pub(super) registers: Registers,
    pub(super) operations: Vec<Operation>,
    pub(super) target: [Operand; 12],
    /// Margins, validities, misses.
    pub(super) judged: [Vec<Operand>; 3],
    pub(super) found: Vec<Operand>,
}

impl Builder<'_> {
    /// A value as an operand; its negative is computed where it is asked for.
    fn operand(&mut self, v: Value) -> Operand {
        let signed = self.registers.value(v);
        if !signed.negative {
            return signed.at;
        }
        let to = self.registers.rows(rows(signed.at));
        self.operations.push(Operation::Negate { to, of: signed.at });
        to
    }

    /// What needs this number of known combinations, and how far it is from the target.
    pub(super) fn values(&mut self, depth: usize) {
        let width = self.batched.widths[depth];
        let here: Vec<usize> =
            self.registers.computed().map(|(n, _)| n).filter(|n| self.batched.depths[*n] == depth).collect();
        let list = here.into_iter().filter_map(|node| self.registers.instruction(node, width)).collect();
        self.operations.push(Operation::Arithmetic(list));
        let mut sum: Option<Operand> = None;
        for residual in &self.batched.confirmation {
            if self.batched.depths[residual.value.node as usize] != depth {
                continue;
            }
            let of = self.operand(residual.value);
            let first = sum.is_none();
            let to = *sum.get_or_insert_with(|| self.registers.rows(width));
            let place = if residual.column < 3 { 3 * residual.row + residual.column } else { 9 + residual.row };
            self.operations.push(Operation::Miss { to, of, entry: self.target[place], first });
        }
        self.judged[2].extend(sum);
    }

    /// A step: its roots, their values, and where they are kept.
    pub(super) fn step(&mut self, i: usize) -> Option<()> {
        let solve = &self.batched.solves[i];
        let (p, known) = (self.batched.widths[self.batched.depth_of(i)], solve.known);
        let before = self.batched.widths[i + self.inverse.plan.given];
        let is_angle = self.inverse.plan.knowledge.known[known].is_angle;
        let numbers = |a: &Argument<Value>| a.numbers().into_iter().copied().collect::<Vec<Value>>();
        let all: Vec<Value> = solve.arguments.iter().flat_map(numbers).collect();
        let arguments: Vec<Operand> = all.into_iter().map(|v| self.operand(v)).collect();
        let (root, margin) = ([self.registers.rows(p), self.registers.rows(p)], self.registers.rows(p));
        let mut second = None;
        match (solve.kernel.name, arguments.as_slice()) {
            ("sincos", &[a, b, c]) => {
                let (other, valid) = ([self.registers.rows(p), self.registers.rows(p)], self.registers.rows(p));
                let roots = [root[0], root[1], other[0], other[1]];
                self.operations.push(Operation::SinCos { equation: [a, b, c], roots, valid, margin });
                self.judged[1].push(valid);
                second = Some(other);
            }
            ("half_turn", list) => {
                let equations = list.chunks(2).filter_map(|c| c.try_into().ok()).collect();
                self.operations.push(Operation::HalfTurn { equations, root, margin });
            }
            ("pair", list) => {
                let equations = list.try_into().ok()?;
                self.operations.push(Operation::Pair { equations, root, margin });
            }
            ("unit", &[a, b]) => self.operations.push(Operation::Unit { of: [a, b], root }),
            ("linear", &[a, b]) => {
                self.operations.push(Operation::Linear { equation: [a, b], root: root[0], margin });
            }
            _ => return None,
        }
        if solve.kernel.has_margin {
            self.judged[0].push(margin);
        }
        let first_value = self.value_of(root, is_angle);
        let opposite = solve.kernel.roots == BatchedRoots::Opposite;
        let other = match second {
            Some(other) => Some((other, self.value_of(other, is_angle))),
            None if opposite => {
                let other = root.map(|of| {
                    let to = self.registers.rows(p);
                    self.operations.push(Operation::Negate { to, of });
                    to
                });
                let to = self.registers.rows(p);
                self.operations.push(Operation::Opposite { to, of: first_value });
                Some((other, to))
            }
            None => None,
        };
        // Of mirrored halves the second is not computed; where there is one root it is in all branches.
        let (others, other_value) = other.unwrap_or((root, first_value));
        let symbols = self.inverse.plan.knowledge.known[known].symbols;
        for k in 0..2 {
            let Some(node) = self.registers.node_of(symbols[k]) else { continue };
            let to = self.registers.place(node, 1);
            let k = if is_angle { k } else { 0 };
            self.operations.push(Operation::Spread { to, roots: [root[k], others[k]], before });
        }
        let to = self.found[known];
        self.operations.push(Operation::Spread { to, roots: [first_value, other_value], before });
        Some(())
    }

    /// The joint value of a root.
    fn value_of(&mut self, root: [Operand; 2], is_angle: bool) -> Operand {
        let to = self.registers.rows(rows(root[0]));
        let scale = self.inverse.plan.axes.length_scale;
        self.operations.push(match is_angle {
            true => Operation::Angle { to, pair: root },
            false => Operation::Length { to, of: root[0], scale },
        });
        to
    }

    /// Margins, validities and misses of all branches.
    pub(super) fn judgement(&mut self, width: usize) -> [Operand; 3] {
        let judged = std::mem::take(&mut self.judged);
        let [one, zero] = [1.0, 0.0].map(|number| {
            let to = self.registers.rows(1);
            self.operations.push(Operation::Constant { to, number });
            to
        });
        let mut joined = [one, one, zero];
        for (kind, list) in judged.into_iter().enumerate() {
            for (place, of) in list.into_iter().enumerate() {
                if place == 0 {
                    joined[kind] = of;
                    continue;
                }
                let (to, of) = (self.registers.rows(width), [joined[kind], of]);
                self.operations.push(match kind {
                    0 => Operation::Lesser { to, of },
                    1 => Operation::Product { to, of },
                    _ => Operation::Sum { to, of },
                });
                joined[kind] = to;
            }
        }
        joined
    }
}
