//! Twins: where the last pair of roots leads to solutions that differ by signs only, the second half of the branches needs no computing.
//!
//! A wrist that flips is the case: with `c4, s4` negated, every later equation stays as it is or changes its sign as a whole, if some of the
//! later sines and cosines are negated too. That is decided on the program: each value is even or odd in the change.

use crate::planner::StepKind;
use crate::program::{Inverse, Node, Solver, Value};

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
        let solver = inverse.solvers.get(step)?;
        let zero = |v: Value| inverse.graph.as_constant(v).is_some_and(|p| p.is_zero());
        let first = match (solver.kind, solver.rows.first()?.as_slice()) {
            (StepKind::HalfTurn, _) => [true, true],
            (StepKind::SinCos, [_, b, _]) if zero(*b) => [false, true],
            (StepKind::SinCos, [a, _, _]) if zero(*a) => [true, false],
            _ => return None,
        };
        let given = inverse.plan.given;
        let mut flips = vec![[false; 2]; step];
        flips.push(first);
        // Odd, or neither.
        let mut odd: Vec<Option<bool>> = depths.iter().map(|d| (*d <= given + step).then_some(false)).collect();
        for i in step..inverse.solvers.len() {
            let depth = given + i + 1;
            if let Some(solver) = inverse.solvers.get(i).filter(|_| i > step) {
                flips.push(flip(solver, &|v| odd[v.node as usize], &zero)?);
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

/// Which signs of a step's one root change: those with which every row of its equations is even or odd.
fn flip(solver: &Solver, odd: &impl Fn(Value) -> Option<bool>, zero: &impl Fn(Value) -> bool) -> Option<[bool; 2]> {
    let rows = match solver.kind {
        StepKind::Linear => solver.rows.get(..1)?,
        StepKind::AtanPair => solver.rows.get(..2)?,
        _ => return None,
    };
    let fits = |flip: &[bool; 2]| {
        rows.iter().all(|row| {
            // a x + b y + c, or a x + b.
            let signs = if row.len() == 2 { [flip[0], false, false] } else { [flip[0], flip[1], false] };
            let mut terms = row.iter().zip(signs).filter(|(v, _)| !zero(**v)).map(|(v, s)| odd(*v).map(|odd| odd != s));
            let Some(first) = terms.next() else { return true };
            first.is_some() && terms.all(|x| x == first)
        })
    };
    [[false, false], [false, true], [true, false], [true, true]]
        .into_iter()
        .filter(|f| solver.kind != StepKind::Linear || f[0] == f[1])
        .find(fits)
}
