//! A joint that is free at every pose (the arm is singular everywhere): a value is chosen for it.

use super::kernel::{BatchedKernel, BatchedRoots, Call, Coefficient, zero};
use super::quadratic::QUADRATIC;
use super::recognise::Scene;
use super::sin_cos::SIN_COS;
use super::{Kind, StepKind, Words};
use crate::planner::known::Basis;
use crate::planner::step::Step;

pub(super) struct Choose;

impl Kind for Choose {
    /// One coordinate of those that move the tool in the same way.
    fn fallback(&self, at: &Scene<'_>) -> Option<Step> {
        let unknown = vec![at.unit(at.always_free()?)];
        let before = at.knowledge.known.len();
        Some(Step { kind: StepKind::Choose, unknown, equations: vec![], collected: vec![], roots: 1, before })
    }

    fn columns(&self) -> Vec<Vec<Basis>> {
        Vec::new()
    }

    /// An equation that says nothing.
    fn call(&self, _: usize, is_angle: bool) -> Call<Coefficient> {
        Call { kernel: if is_angle { &SIN_COS } else { &QUADRATIC }, arguments: vec![zero(), zero(), zero()] }
    }

    /// Zero for every branch.
    fn batched(&self, _: usize, is_angle: bool, _: &dyn Fn(usize, usize) -> Option<i8>) -> Option<BatchedKernel> {
        let name = if is_angle { "chosen_angle" } else { "chosen_length" };
        let (arguments, roots) = (Vec::new(), BatchedRoots::One);
        Some(BatchedKernel { name, single_precision: None, arguments, roots, has_margin: false, equations: 0 })
    }

    fn words(&self, _: bool) -> Words {
        Words::new("a free choice", "任取", "free at every pose: 0 is taken").solved_by(
            "This combination is free at every pose; a value is chosen.",
            "该组合在任何位姿下都可任取；选定一个值。",
            &[],
        )
    }
}
