//! Which steps and values of a plan share a loop over lanes.

use crate::program::{Inverse, Solve};

/// What is computed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum What {
    /// A step of the plan.
    Step(usize),
    /// The values that need so many known combinations.
    Depth(usize),
    /// Confirmation and joint values.
    Finish,
}

/// Something to compute, for how many lanes, in which loop.
#[derive(Clone, Copy, Debug)]
pub(super) struct Item {
    pub(super) what: What,
    pub(super) lanes: usize,
    pub(super) segment: usize,
}

/// Lanes once so many combinations are known, and everything in its order; neighbours with equally many lanes share a loop. The roots of
/// the step `twin` count as one.
pub(super) fn segments(inverse: &Inverse, depths: &[usize], twin: Option<usize>) -> (Vec<usize>, Vec<Item>) {
    let given = inverse.plan.given;
    let mut all = vec![1_usize; given + 1];
    for (i, step) in inverse.plan.steps.iter().enumerate() {
        all.push(all[i + given] * if twin == Some(i) { 1 } else { step.roots });
    }
    let mut whole: Vec<(What, usize)> = Vec::new();
    let solves = inverse.body.solves();
    for (i, solve) in solves.iter().enumerate() {
        whole.push((What::Step(i), all[needs(solve, depths)]));
        whole.push((What::Depth(given + i + 1), all[given + i + 1]));
    }
    whole.push((What::Finish, all[given + solves.len()]));
    let mut items: Vec<Item> = Vec::new();
    for (what, lanes) in whole {
        let segment = items.last().map_or(0, |last| if last.lanes == lanes { last.segment } else { last.segment + 1 });
        items.push(Item { what, lanes, segment });
    }
    (all, items)
}

/// How many known combinations the coefficients of a step need.
pub(super) fn needs(solve: &Solve, depths: &[usize]) -> usize {
    solve.equations.concat().iter().map(|v| depths[v.node as usize]).max().unwrap_or(0)
}
