//! A length and an angle from two equations: up to the square of the length, linear in the angle's sine and cosine.

use super::kernel::{Argument, Call, Coefficient, Kernel, KernelRoots, Representative, row};
use super::recognise::{Offer, TwoUnknowns};
use super::{Kind, Slot, StepKind, Words};
use crate::planner::known::Basis;
use dh_kernels::solve_length_squared_and_angle_choosing;

/// The sums of e[3 i + j] D_i V_j = 0, D = (1, d, d^2) and V = (1, cos v, sin v).
static LENGTH_AND_ANGLE: Kernel = Kernel {
    rust: "solve_length_squared_and_angle_choosing",
    javascript: Some("solveLengthAndAngle"),
    takes_tolerance: true,
    free: Representative::Passed,
    is_sine_equation: false,
    unknowns: 2,
    run: |x, _, free, tolerance| {
        let (&[first, second], &[[d, _], v]) = (x.as_chunks::<9>().0, free) else { return KernelRoots::none() };
        let found = solve_length_squared_and_angle_choosing(&first, &second, (d, v), tolerance);
        KernelRoots::of(&found, |(d, v)| vec![[d, d], v])
    },
};

pub(super) struct LengthAndAngle;

impl Kind for LengthAndAngle {
    fn for_two_unknowns(&self, at: &TwoUnknowns<'_>) -> Option<Offer> {
        at.prismatic.then(|| at.offer(StepKind::LengthAndAngle, 8))
    }

    fn columns(&self) -> Vec<Vec<Basis>> {
        let (lengths, angles) =
            ([Basis::One, Basis::Power(1), Basis::Power(2)], [Basis::One, Basis::Cos(1), Basis::Sin(1)]);
        lengths.iter().flat_map(|d| angles.map(|v| vec![*d, v])).collect()
    }

    fn call(&self, _: usize, _: bool) -> Call<Coefficient> {
        let rows = [row(0, 0..9), row(1, 0..9)].map(Argument::Reference);
        Call { kernel: &LENGTH_AND_ANGLE, arguments: rows.into_iter().chain([Argument::Representatives]).collect() }
    }

    fn words(&self, _: bool) -> Words {
        let equation = "two equations, linear in the angle's sine and cosine";
        Words::new("two equations in a length and an angle", "一个长度与一个角的两个方程", equation).solved_by(
            "Eliminating {} leaves a polynomial in {}.",
            "消去 {} 得到关于 {} 的多项式。",
            &[Slot::Second, Slot::First],
        )
    }
}
