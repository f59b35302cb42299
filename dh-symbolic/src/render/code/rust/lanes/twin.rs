//! Twins: where the last pair of roots leads to solutions that differ by signs only, the second half of the branches needs no computing.
//!
//! A wrist that flips is the case: with `c4, s4` negated, every later equation stays as it is or changes its sign as a whole, if some of the
//! later sines and cosines are negated too. That is decided on the program: each value is even or odd in the change.

use super::kernel;
use crate::planner::Part;
use crate::program::{Inverse, Node, Solve, Value};

/// The last step with two roots, and what changes from its first root to its second.
pub(super) struct Twin {
    /// The step.
    pub(super) step: usize,
    /// For every step: are the cosine and the sine (or the length, twice) negated?
    pub(super) flips: Vec<[bool; 2]>,
}

impl Twin {
    /// The twin of a plan, if all that follows the last pair of roots is even or odd, and the pose that confirms a branch is even.
    pub(super) fn of(
        inverse: &Inverse,
        depths: &[usize],
        live: &[bool],
        confirmation: &[(usize, Value)],
    ) -> Option<Self> {
        let step = inverse.plan.steps.iter().rposition(|s| s.roots == 2)?;
        let solves = inverse.body.solves();
        let zero = |v: Value| inverse.graph.as_constant(v).is_some_and(|p| p.is_zero());
        let even = |_: Value| Some(false);
        let all = [[true, true], [false, true], [true, false]];
        let first = all.into_iter().find(|f| keeps(inverse, solves[step], *f, &even, &zero))?;
        let given = inverse.plan.given;
        let mut flips = vec![[false; 2]; step];
        flips.push(first);
        // Odd, or neither.
        let mut odd: Vec<Option<bool>> = depths.iter().map(|d| (*d <= given + step).then_some(false)).collect();
        for i in step..solves.len() {
            let depth = given + i + 1;
            if i > step {
                let all = [[false, false], [false, true], [true, false], [true, true]];
                let odd = |v: Value| odd[v.node as usize];
                flips.push(all.into_iter().find(|f| keeps(inverse, solves[i], *f, &odd, &zero))?);
            }
            for (k, node) in inverse.graph.nodes().iter().enumerate().filter(|(k, _)| live[*k] && depths[*k] == depth) {
                odd[k] = match *node {
                    Node::Symbol(s) => {
                        let known = &inverse.plan.knowledge.known[depth - 1];
                        Some(flips[i][usize::from(known.symbols[0] != s)])
                    }
                    Node::Add(a, b) => odd[a.node as usize].filter(|x| odd[b.node as usize] == Some(*x)),
                    Node::Mul(a, b) => odd[a as usize].zip(odd[b as usize]).map(|(a, b)| a != b),
                    _ => None,
                };
            }
        }
        confirmation.iter().all(|(_, v)| odd[v.node as usize] == Some(false)).then_some(Self { step, flips })
    }

    /// The joint value of the second root from that of the first.
    pub(super) fn angle(&self, step: usize, turns: bool, first: &str) -> String {
        match (self.flips[step], turns) {
            ([false, false], _) => first.to_string(),
            ([true, _], false) => format!("-{first}"),
            ([true, true], _) => format!("::dh_robot::runtime::lanes::opposite({first})"),
            ([false, true], _) => format!("::dh_robot::runtime::lanes::negative({first})"),
            ([true, false], _) => format!("::dh_robot::runtime::lanes::supplement({first})"),
        }
    }
}

/// Is every row of a step's equations even or odd, where the signs of cosine and sine (or of a length, both) change, and what is known
/// before is odd or not?
fn keeps(
    inverse: &Inverse,
    solve: &Solve,
    flip: [bool; 2],
    odd: &impl Fn(Value) -> Option<bool>,
    zero: &impl Fn(Value) -> bool,
) -> bool {
    let (Some(kernel), Some(step)) = (kernel(inverse, solve), inverse.plan.steps.get(solve.step)) else { return false };
    let signs: Vec<bool> = step
        .kind
        .columns()
        .iter()
        .map(|c| match c.as_slice() {
            [Part::Cos(k)] => flip[0] && k % 2 == 1,
            [Part::Sin(k)] if k % 2 == 0 => flip[0] != flip[1],
            [Part::Sin(_)] => flip[1],
            [Part::Power(k)] => flip[0] && k % 2 == 1,
            _ => false,
        })
        .collect();
    let turns = solve.finds.first().is_some_and(|k| inverse.plan.knowledge.known[*k].turns);
    let rows = solve.equations.iter().take(kernel.equations);
    let fits = |row: &Vec<Value>| {
        let mut terms = row.iter().zip(&signs).filter(|(v, _)| !zero(**v)).map(|(v, s)| odd(*v).map(|odd| odd != *s));
        let Some(first) = terms.next() else { return true };
        first.is_some() && terms.all(|x| x == first)
    };
    (turns || flip[0] == flip[1]) && rows.into_iter().all(fits)
}
