//! The distance that a law of cosines measures, for the reason that is given where an arm does not reach as far.
//!
//! The equation is |p(a, b)|^2 along the arm = |p(a, b)|^2 from the target. Where the unknown turns on the arm's side, the other one is the
//! squared distance; where it turns on the target's side, about a point of the arm, the distance is that from this point.

use crate::algebra::{Poly, dot};
use crate::planner::{Equation, Knowledge, Part, Plan, Scalar, Step, StepKind};

/// What to add to the side of the equation without the unknown to get the squared distance.
#[derive(Clone, Debug)]
pub(super) struct Law {
    /// What to add: of lengths, and of what is known by then.
    pub(super) base: Poly,
    /// Does the amplitude of the other side grow with the distance?
    pub(super) grows: bool,
}

/// The law of cosines that a step solves, if it is one.
pub(super) fn law(plan: &Plan, step: &Step) -> Option<Law> {
    let (StepKind::SinCos, [Equation { a, b, scalar: Scalar::Distance }], [form]) =
        (step.kind, step.equations.as_slice(), step.unknown.as_slice())
    else {
        return None;
    };
    let axes = &plan.axes;
    let known = plan.knowledge.known.get(..step.before)?.to_vec();
    let before = Knowledge { known, ..plan.knowledge.clone() };
    // The squared distance of two frames: what is known of it, and whether that is all.
    let squared = |a: usize, b: usize| {
        let p = &axes.between(a, b).p;
        let parts = before.collect(axes, &dot(p, p), &step.unknown)?;
        let constant = parts.get(&vec![Part::One]).cloned().unwrap_or_default();
        Some((constant, parts.keys().all(|k| *k == [Part::One])))
    };
    let (direct, still) = squared(*a, *b)?;
    if !still {
        return Some(Law { base: direct, grows: false });
    }
    let mut unknown = (0..axes.count()).filter(|k| form[*k] != 0);
    let (Some(joint), None) = (unknown.next(), unknown.next()) else { return None };
    let hop = axes.hops.iter().position(|h| h.joint == Some(joint))?;
    let (arm, still) = if hop < *a { squared(hop + 1, *a) } else { squared(*b, hop + 1) }?;
    still.then(|| Law { base: &direct - &arm, grows: true })
}
