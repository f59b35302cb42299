//! An angle from the ratio of its sine and cosine: a cos u + b sin u = 0, two values half a turn apart. A second such equation decides
//! where the first one vanishes.

use super::kernel::{Argument, BatchedKernel, BatchedRoots, Call, Coefficient, Kernel, KernelRoots, Representative};
use super::kernel::{plus, row, zero};
use super::recognise::{Offer, Rank, Row, SingleUnknown};
use super::sin_cos::SIN_COS;
use super::{Kind, StepKind, Words};
use crate::planner::known::Basis;
use crate::planner::sample::Sample;
use dh_kernels::solve_half_turn;

/// The better one of two such equations.
static HALF_TURN: Kernel = Kernel {
    rust: "solve_half_turn",
    javascript: Some("solveHalfTurn"),
    takes_tolerance: true,
    free: Representative::Chosen,
    is_sine_equation: false,
    unknowns: 1,
    run: |x, _, _, tolerance| {
        let &[a, b, c, d] = x else { return KernelRoots::none() };
        KernelRoots::of(&solve_half_turn([a, b], [c, d], tolerance), |u| vec![u])
    },
};

pub(super) struct HalfTurn;

impl Kind for HalfTurn {
    fn for_one_unknown(&self, at: &SingleUnknown<'_>) -> Vec<Offer> {
        let ratios: Vec<&Row> = at.first_harmonics().filter(|r| !r.has_constant()).collect();
        let special = if ratios.len() > 1 { at.scene.samples(0, 32) } else { Vec::new() };
        ratios
            .iter()
            .map(|first| {
                let rows: Vec<&Row> = [*first].into_iter().chain(second(at, first, &ratios, &special)).collect();
                Offer { size: at.scene.size(first), ..at.offer(Rank::HalfTurn, StepKind::HalfTurn, 2, &rows) }
            })
            .collect()
    }

    fn columns(&self) -> Vec<Vec<Basis>> {
        vec![vec![Basis::Cos(1)], vec![Basis::Sin(1)]]
    }

    fn call(&self, equations: usize, _: bool) -> Call<Coefficient> {
        if equations == 2 {
            let arguments = vec![Argument::Array(row(0, 0..2)), Argument::Array(row(1, 0..2))];
            return Call { kernel: &HALF_TURN, arguments };
        }
        Call { kernel: &SIN_COS, arguments: vec![plus(0, 0), plus(0, 1), zero()] }
    }

    fn batched(&self, equations: usize, _: bool, _: &dyn Fn(usize, usize) -> Option<i8>) -> Option<BatchedKernel> {
        let roots = BatchedRoots::Opposite;
        let rows = (0..equations).map(|r| Argument::Array(row(r, 0..2)));
        let arguments = vec![Argument::Array(rows.collect())];
        Some(BatchedKernel {
            name: "half_turn",
            single_precision: None,
            arguments,
            roots,
            has_margin: true,
            equations: 1,
        })
    }

    fn words(&self, _: bool) -> Words {
        let equation = "a cos + b sin = 0, two values half a turn apart";
        Words::new("a ratio of sine and cosine", "正弦与余弦之比", equation).because(
            "Why: the equation fixes the ratio of sine and cosine, and with it the angle up to half a turn.",
            "理由：该方程确定正弦与余弦之比，从而确定角，只差半周。",
        )
    }
}

/// The shortest other equation without a constant term that still fixes the angle where this one vanishes, at some special pose.
fn second<'r>(at: &SingleUnknown<'_>, first: &Row, rows: &[&'r Row], special: &[Sample<'_>]) -> Option<&'r Row> {
    let slope = |row: &Row, s: &Sample<'_>| row.at(Basis::Cos(1), s).hypot(row.at(Basis::Sin(1), s));
    let empty: Vec<&Sample<'_>> = special.iter().filter(|s| slope(first, s) < 1e-9).collect();
    let mut others = rows.to_vec();
    others.retain(|r| r.collected != first.collected && empty.iter().any(|s| slope(r, s) > 1e-3));
    others.into_iter().min_by_key(|r| at.scene.size(r))
}
