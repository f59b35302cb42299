//! An angle from one equation in its sine and cosine: a cos u + b sin u + c = 0, two values. Where the equation says how far two points
//! are apart it is the law of cosines.

use super::kernel::{BatchedKernel, BatchedRoots, Call, Coefficient, Kernel, KernelRoots, Representative, minus, plus};
use super::recognise::{Offer, Rank, SingleUnknown};
use super::{Kind, StepKind, Words};
use crate::algebra::{Poly, dot};
use crate::planner::known::{Basis, Knowledge};
use crate::planner::scalar::{Equation, FrameScalar};
use crate::planner::step::{Plan, Step};
use dh_kernels::solve_sincos;

/// a cos u + b sin u = c.
pub(super) static SIN_COS: Kernel = Kernel {
    rust: "solve_sincos",
    javascript: Some("solveSinCos"),
    takes_tolerance: true,
    free: Representative::Chosen,
    is_sine_equation: true,
    unknowns: 1,
    run: |x, _, _, tolerance| {
        let &[a, b, c] = x else { return KernelRoots::none() };
        KernelRoots::of(&solve_sincos(a, b, c, tolerance), |u| vec![u])
    },
};

pub(super) struct SinCos;

impl Kind for SinCos {
    fn for_one_unknown(&self, at: &SingleUnknown<'_>) -> Vec<Offer> {
        let rows = at.first_harmonics().filter(|r| r.has_constant());
        rows.map(|r| at.offer(Rank::SinCos, StepKind::SinCos, 2, &[r])).collect()
    }

    fn columns(&self) -> Vec<Vec<Basis>> {
        vec![vec![Basis::Cos(1)], vec![Basis::Sin(1)], vec![Basis::One]]
    }

    fn call(&self, _: usize, _: bool) -> Call<Coefficient> {
        Call { kernel: &SIN_COS, arguments: vec![plus(0, 0), plus(0, 1), minus(0, 2)] }
    }

    fn batched(&self, _: usize, _: bool, _: &dyn Fn(usize, usize) -> Option<i8>) -> Option<BatchedKernel> {
        Some(BatchedKernel {
            name: "sincos",
            single_precision: Some("sincos_single"),
            arguments: vec![plus(0, 0), plus(0, 1), minus(0, 2)],
            roots: BatchedRoots::Two,
            has_margin: true,
            equations: 1,
        })
    }

    fn reach_limit(&self, plan: &Plan, step: &Step) -> Option<ReachLimit> {
        reach_limit(plan, step)
    }

    fn words(&self, is_distance: bool) -> Words {
        let equation = "a cos + b sin = c, two values";
        let words = if is_distance {
            Words::new("the law of cosines", "余弦定理", equation)
        } else {
            Words::new("an equation in sine and cosine", "正弦余弦方程", equation)
        };
        words.because(
            "Why: in polar form the two terms with the unknown are one cosine of the unknown less a known angle. The cosine gives this difference up to its sign. (Where the sine or the cosine occurs alone, it is known at once, and the other one up to its sign.)",
            "理由：把含未知角的两项写成极坐标形式，合为“未知角减去一已知角”的余弦；由余弦得该差，正负两值。（若只出现正弦或余弦，则它直接可得，另一个相差正负号。）",
        )
    }
}

/// Recovers the distance behind a law-of-cosines step, for error reports where the arm does not reach as far.
///
/// The equation is |p(a, b)|^2 along the arm = |p(a, b)|^2 from the target. Where the unknown turns on the arm's side, the other one is the
/// squared distance; where it turns on the target's side, about a point of the arm, the distance is that from this point.
#[derive(Clone, Debug)]
pub struct ReachLimit {
    /// What to add to the side of the equation without the unknown to get the squared distance: of lengths, and of what is known by then.
    pub base: Poly,
    /// Whether the amplitude of the other side grows with the distance.
    pub grows: bool,
}

fn reach_limit(plan: &Plan, step: &Step) -> Option<ReachLimit> {
    let ([Equation { a, b, scalar: FrameScalar::Distance }], [form]) =
        (step.equations.as_slice(), step.unknown.as_slice())
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
        let constant = parts.get(&vec![Basis::One]).cloned().unwrap_or_default();
        Some((constant, parts.keys().all(|k| *k == [Basis::One])))
    };
    let (direct, still) = squared(*a, *b)?;
    if !still {
        return Some(ReachLimit { base: direct, grows: false });
    }
    let mut unknown = (0..axes.count()).filter(|k| form[*k] != 0);
    let (Some(joint), None) = (unknown.next(), unknown.next()) else { return None };
    let link = axes.links.iter().position(|h| h.joint == Some(joint))?;
    let (arm, still) = if link < *a { squared(link + 1, *a) } else { squared(*b, link + 1) }?;
    still.then(|| ReachLimit { base: &direct - &arm, grows: true })
}
