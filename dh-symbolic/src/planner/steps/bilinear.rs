//! Two angles from two equations, each linear in the sine and cosine of either angle: Pieper's method.

use super::kernel::{Argument, Call, Coefficient, Kernel, KernelRoots, Representative, row};
use super::recognise::{Offer, TwoUnknowns};
use super::{Kind, Slot, StepKind, Words};
use crate::planner::known::{Basis, Collected};
use dh_kernels::solve_bilinear_choosing;

/// The sums of e[3 i + j] U_i V_j = 0, U = (1, cos u, sin u) and V = (1, cos v, sin v).
static BILINEAR: Kernel = Kernel {
    rust: "solve_bilinear_choosing",
    javascript: Some("solveBilinear"),
    takes_tolerance: true,
    free: Representative::Passed,
    is_sine_equation: false,
    unknowns: 2,
    run: |x, _, free, tolerance| {
        let (&[first, second], &[u, v]) = (x.as_chunks::<9>().0, free) else { return KernelRoots::none() };
        KernelRoots::of(&solve_bilinear_choosing(&first, &second, [u, v], tolerance), |r| r.to_vec())
    },
};

pub(super) struct Bilinear;

impl Kind for Bilinear {
    fn for_two_unknowns(&self, at: &TwoUnknowns<'_>) -> Option<Offer> {
        let [first, second] = at.rows;
        (!at.prismatic).then(|| at.offer(StepKind::Bilinear, roots(&first.collected, &second.collected)))
    }

    fn columns(&self) -> Vec<Vec<Basis>> {
        let parts = [Basis::One, Basis::Cos(1), Basis::Sin(1)];
        parts.iter().flat_map(|u| parts.map(|v| vec![*u, v])).collect()
    }

    fn call(&self, _: usize, _: bool) -> Call<Coefficient> {
        let rows = [row(0, 0..9), row(1, 0..9)].map(Argument::Reference);
        Call { kernel: &BILINEAR, arguments: rows.into_iter().chain([Argument::Representatives]).collect() }
    }

    fn words(&self, _: bool) -> Words {
        let equation = "two equations, each linear in the sine and cosine of either angle";
        Words::new("two equations in two angles (Pieper's method)", "两角两方程（Pieper 方法）", equation).solved_by(
            "The two equations are linear in sine and cosine of either angle. Eliminating {} leaves a polynomial of degree {} in {}; each of its real roots gives one {}.",
            "两个方程对每个角的正弦和余弦都是线性的。消去 {} 得到次数为 {} 的关于 {} 的多项式；每个实根给出一个 {}。",
            &[Slot::Second, Slot::Roots, Slot::HalfTangent, Slot::Second],
        )
    }
}

/// Bound of the solutions of a bilinear pair: 8; 4 where both coefficient pairs of one angle are turned into each other by a
/// quarter turn (then its elimination is a square sum with a common factor, Pieper's quartic), or where one equation lacks an
/// angle's products.
fn roots(a: &Collected, b: &Collected) -> usize {
    let get = |c: &Collected, u: Basis, v: Basis| c.get(&vec![u, v]).cloned().unwrap_or_default();
    let parts = [Basis::One, Basis::Cos(1), Basis::Sin(1)];
    for swap in [false, true] {
        let at = |c: &Collected, u: Basis, v: Basis| if swap { get(c, v, u) } else { get(c, u, v) };
        let row = |c: &Collected, u: Basis| parts.map(|v| at(c, u, v));
        let (ca, sa, cb, sb) =
            (row(a, Basis::Cos(1)), row(a, Basis::Sin(1)), row(b, Basis::Cos(1)), row(b, Basis::Sin(1)));
        // cb = k sa, sb = -k ca: all cross products vanish.
        let proportional = (0..3).all(|i| (0..3).all(|j| &cb[i] * &ca[j] == -&(&sb[j] * &sa[i])));
        if proportional {
            return 4;
        }
        let plain = |c: &Collected| parts[1..].iter().all(|u| parts[1..].iter().all(|v| at(c, *u, *v).is_zero()));
        if plain(a) && plain(b) {
            return 4;
        }
    }
    8
}
