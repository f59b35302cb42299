//! A length from one quadratic equation: a d^2 + b d + c = 0.

use super::kernel::{Call, Coefficient, Kernel, KernelRoots, Representative, row};
use super::recognise::{Offer, Rank, SingleUnknown};
use super::{Kind, StepKind, Words};
use crate::planner::known::Basis;
use dh_kernels::solve_quadratic;

/// Two lengths, or one where the equation is linear.
pub(super) static QUADRATIC: Kernel = Kernel {
    rust: "solve_quadratic",
    javascript: Some("solveQuadratic"),
    takes_tolerance: true,
    free: Representative::Chosen,
    is_sine_equation: false,
    unknowns: 1,
    run: |x, _, _, tolerance| {
        let &[a, b, c] = x else { return KernelRoots::none() };
        KernelRoots::of(&solve_quadratic(a, b, c, tolerance), |d| vec![[d, d]])
    },
};

pub(super) struct Quadratic;

impl Kind for Quadratic {
    fn for_one_unknown(&self, at: &SingleUnknown<'_>) -> Vec<Offer> {
        let rows = at.rows.iter().filter(|r| !at.is_angle && r.degree() == 2);
        rows.map(|r| at.offer(Rank::Quadratic, StepKind::Quadratic, 2, &[r])).collect()
    }

    fn columns(&self) -> Vec<Vec<Basis>> {
        vec![vec![Basis::Power(2)], vec![Basis::Power(1)], vec![Basis::One]]
    }

    fn call(&self, _: usize, _: bool) -> Call<Coefficient> {
        Call { kernel: &QUADRATIC, arguments: row(0, 0..3) }
    }

    fn words(&self, _: bool) -> Words {
        Words::new("a quadratic equation", "二次方程", "a d^2 + b d + c = 0, two values")
            .because("Why: the formula for quadratic equations.", "理由：二次方程求根公式。")
    }
}
