//! An angle from a trigonometric polynomial of second degree: up to four values.

use super::kernel::{Argument, Call, Coefficient, Kernel, KernelRoots, Representative, plus};
use super::recognise::{Offer, Rank, SingleUnknown};
use super::{Kind, Slot, StepKind, Words};
use crate::planner::known::Basis;
use dh_kernels::solve_second_harmonic;

/// a + b cos u + c sin u + d cos 2u + e sin 2u = 0.
static SECOND_HARMONIC: Kernel = Kernel {
    rust: "solve_second_harmonic",
    javascript: Some("solveSecondHarmonic"),
    takes_tolerance: true,
    free: Representative::Chosen,
    is_sine_equation: false,
    unknowns: 1,
    run: |x, _, _, tolerance| {
        let &[a, b, d, c, e] = x else { return KernelRoots::none() };
        KernelRoots::of(&solve_second_harmonic(a, [b, d], [c, e], tolerance), |u| vec![u])
    },
};

pub(super) struct SecondHarmonic;

impl Kind for SecondHarmonic {
    fn for_one_unknown(&self, at: &SingleUnknown<'_>) -> Vec<Offer> {
        let rows = at.rows.iter().filter(|r| at.is_angle && r.degree() == 2);
        rows.map(|r| at.offer(Rank::SecondHarmonic, StepKind::SecondHarmonic, 4, &[r])).collect()
    }

    fn columns(&self) -> Vec<Vec<Basis>> {
        [Basis::One, Basis::Cos(1), Basis::Sin(1), Basis::Cos(2), Basis::Sin(2)].map(|p| vec![p]).to_vec()
    }

    fn call(&self, _: usize, _: bool) -> Call<Coefficient> {
        let pair = |a, b| Argument::Array(vec![plus(0, a), plus(0, b)]);
        Call { kernel: &SECOND_HARMONIC, arguments: vec![plus(0, 0), pair(1, 3), pair(2, 4)] }
    }

    fn words(&self, _: bool) -> Words {
        let equation = "a + b cos + c sin + d cos 2 + e sin 2 = 0, up to four values";
        Words::new("a trigonometric polynomial of degree two", "二次三角多项式", equation).solved_by(
            "With {} this is a polynomial of degree 4, whose real roots are found.",
            "令 {}，得到 4 次多项式，求其实根。",
            &[Slot::NamedHalfTangent],
        )
    }
}
