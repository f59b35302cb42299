//! Mirror symmetry: where the last pair of roots leads to solutions that differ in signs only, the second half of the branches needs no
//! computing.
//!
//! A wrist that flips is the case: with `c4, s4` negated, every later equation stays as it is or changes its sign as a whole, if some of the
//! later sines and cosines are negated too. That is decided on the program: each value is even or odd in the change.

use super::Batched;
use crate::planner::Basis;
use crate::program::{Inverse, Node, Solve, Value};

/// The last step with two roots, and what changes from its first root to its second.
#[derive(Clone, Debug)]
pub struct Mirror {
    /// The step.
    pub step: usize,
    /// For every step: whether the cosine and the sine (or the length, twice) are negated.
    pub flips: Vec<[bool; 2]>,
}

/// Which signs may change: none, those of the sine (u to -u), of the cosine (to pi - u), of both (to pi + u).
const NONE: [bool; 2] = [false, false];
const CHANGES: [[bool; 2]; 3] = [[true, true], [false, true], [true, false]];

impl Mirror {
    /// The symmetry of a plan, if all that follows the last pair of roots is even or odd, and the pose that confirms a branch is even.
    pub(super) fn of(inverse: &Inverse, batched: &Batched) -> Option<Self> {
        let (plan, solves) = (&inverse.plan, inverse.body.solves());
        let step = plan.steps.iter().rposition(|s| s.roots == 2)?;
        let keeps = |i: usize, flip: [bool; 2], odd: &dyn Fn(Value) -> Option<bool>| {
            keeps(inverse, solves[i], batched.solves[i].kernel.equations, flip, odd)
        };
        let first = CHANGES.into_iter().find(|f| keeps(step, *f, &|_| Some(false)))?;
        let mut flips = vec![NONE; step];
        flips.push(first);
        // Odd, or neither.
        let before = |depth: &usize| (*depth <= plan.given + step).then_some(false);
        let mut odd: Vec<Option<bool>> = batched.depths.iter().map(before).collect();
        for i in step..solves.len() {
            let depth = plan.given + i + 1;
            if i > step {
                let is_odd = |v: Value| odd[v.node as usize];
                let all = [NONE, CHANGES[1], CHANGES[2], CHANGES[0]];
                flips.push(all.into_iter().find(|f| keeps(i, *f, &is_odd))?);
            }
            let here = |k: &usize| batched.live[*k] && batched.depths[*k] == depth;
            for (k, node) in inverse.graph.nodes().iter().enumerate().filter(|(k, _)| here(k)) {
                odd[k] = match *node {
                    Node::Symbol(s) => {
                        let known = &plan.knowledge.known[depth - 1];
                        Some(flips[i][usize::from(known.symbols[0] != s)])
                    }
                    Node::Add(a, b) => odd[a.node as usize].filter(|x| odd[b.node as usize] == Some(*x)),
                    Node::Mul(a, b) => odd[a as usize].zip(odd[b as usize]).map(|(a, b)| a != b),
                    _ => None,
                };
            }
        }
        let even = |v: Value| odd[v.node as usize] == Some(false);
        batched.confirmation.iter().all(|r| even(r.value)).then_some(Self { step, flips })
    }
}

/// Is every row of a step's equations even or odd, where the signs of cosine and sine (or of a length, both) change, and what is known
/// before is odd or not?
fn keeps(
    inverse: &Inverse,
    solve: &Solve,
    equations: usize,
    flip: [bool; 2],
    odd: &dyn Fn(Value) -> Option<bool>,
) -> bool {
    let Some(step) = inverse.plan.steps.get(solve.step) else { return false };
    let signs: Vec<bool> = step
        .kind
        .columns()
        .iter()
        .map(|c| match c.as_slice() {
            [Basis::Cos(k) | Basis::Power(k)] => flip[0] && k % 2 == 1,
            [Basis::Sin(k)] if k % 2 == 0 => flip[0] != flip[1],
            [Basis::Sin(_)] => flip[1],
            _ => false,
        })
        .collect();
    let zero = |v: Value| inverse.graph.as_constant(v).is_some_and(|p| p.is_zero());
    let fits = |row: &Vec<Value>| {
        let mut terms = row.iter().zip(&signs).filter(|(v, _)| !zero(**v)).map(|(v, s)| odd(*v).map(|odd| odd != *s));
        let Some(first) = terms.next() else { return true };
        first.is_some() && terms.all(|x| x == first)
    };
    let is_angle = solve.finds.first().is_some_and(|k| inverse.plan.knowledge.known[*k].is_angle);
    (is_angle || flip[0] == flip[1]) && solve.equations.iter().take(equations).all(fits)
}
