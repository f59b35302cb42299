//! A length from one linear equation: a d + b = 0.

use super::kernel::{Argument, BatchedKernel, BatchedRoots, Call, Coefficient, plus, row, zero};
use super::quadratic::QUADRATIC;
use super::recognise::{Offer, Rank, SingleUnknown};
use super::{Kind, StepKind, Words};
use crate::planner::known::Basis;

pub(super) struct Linear;

impl Kind for Linear {
    fn for_one_unknown(&self, at: &SingleUnknown<'_>) -> Vec<Offer> {
        let linear = at.rows.iter().filter(|r| !at.is_angle && r.degree() == 1);
        linear
            .map(|r| {
                let firm = r.collected.get(&vec![Basis::Power(1)]).is_some_and(|p| at.scene.is_constant(p));
                at.offer(if firm { Rank::FirmLength } else { Rank::Length }, StepKind::Linear, 1, &[r])
            })
            .collect()
    }

    fn columns(&self) -> Vec<Vec<Basis>> {
        vec![vec![Basis::Power(1)], vec![Basis::One]]
    }

    fn call(&self, _: usize, _: bool) -> Call<Coefficient> {
        Call { kernel: &QUADRATIC, arguments: vec![zero(), plus(0, 0), plus(0, 1)] }
    }

    fn batched(&self, _: usize, _: bool, _: &dyn Fn(usize, usize) -> Option<i8>) -> Option<BatchedKernel> {
        let arguments: Vec<Argument<Coefficient>> = row(0, 0..2);
        let roots = BatchedRoots::One;
        Some(BatchedKernel { name: "linear", single_precision: None, arguments, roots, has_margin: true, equations: 1 })
    }

    fn words(&self, _: bool) -> Words {
        Words::new("a linear equation", "线性方程", "a d + b = 0, one value")
            .because("Why: the unknown occurs once and is not in a sine.", "理由：未知量只出现一次，且不在正弦之中。")
    }
}
