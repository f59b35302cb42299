//! All remaining joints at once by the elimination of the general six-axis arm (Raghavan and Roth 1990), where no equation has fewer unknowns.

use super::kernel::{Argument, Call, Coefficient, Kernel, KernelRoots, Representative, plus};
use super::recognise::Scene;
use super::{Kind, StepKind, Words};
use crate::planner::known::Basis;
use crate::planner::step::Step;
use crate::planner::subspace::JointCombination;
use dh_kernels::{Budget, Pose, solve_general};

/// Six constant transforms and the target.
static GENERAL: Kernel = Kernel {
    rust: "solve_general",
    javascript: None,
    takes_tolerance: false,
    free: Representative::Zero,
    is_sine_equation: false,
    unknowns: 6,
    run: |x, arguments, _, _| {
        let (poses, []) = x.as_chunks::<12>() else { return KernelRoots::none() };
        let pose = |k: usize| -> Pose {
            let p = poses.get(k).copied().unwrap_or_default();
            std::array::from_fn(|i| std::array::from_fn(|j| p[4 * i + j]))
        };
        let Some(Argument::Elimination { prismatic, cuts }) = arguments.last() else { return KernelRoots::none() };
        KernelRoots::of(&solve_general(&std::array::from_fn(pose), &pose(6), prismatic, *cuts, Budget::BOUNDED), |r| {
            r.to_vec()
        })
    },
};

pub(super) struct General;

impl Kind for General {
    /// It takes what is open at once: up to six coordinates, of which one may slide, or two that are neighbours in the loop. Fewer than six
    /// are filled up with joints that have to come out as zero.
    fn fallback(&self, at: &Scene<'_>) -> Option<Step> {
        let open: Vec<usize> = (0..at.axes.count()).filter(|k| !at.knowledge.has(at.axes, *k)).collect();
        let prismatic: Vec<usize> = (0..open.len()).filter(|i| !at.axes.is_revolute(open[*i])).collect();
        let fits = match prismatic.as_slice() {
            [] | [_] => true,
            [i, j] => j - i == 1 || (*i == 0 && *j == 5),
            _ => false,
        };
        if open.is_empty() || open.len() > 6 || !fits || at.always_free().is_some() {
            return None;
        }
        let unknown: Vec<JointCombination> = open.iter().map(|k| at.unit(*k)).collect();
        let before = at.knowledge.known.len();
        Some(Step { kind: StepKind::General, unknown, equations: vec![], collected: vec![], roots: 16, before })
    }

    fn columns(&self) -> Vec<Vec<Basis>> {
        Vec::new()
    }

    /// Seven "equations" of twelve numbers, poses by columns: the constant transforms behind joints 1 to 6, then the target.
    fn call(&self, _: usize, _: bool) -> Call<Coefficient> {
        let pose = |r: usize| -> Vec<Argument<Coefficient>> {
            (0..3).map(|i| Argument::Array((0..4).map(|j| plus(r, 3 * j + i)).collect())).collect()
        };
        let links = Argument::Reference((0..6).map(|r| Argument::Array(pose(r))).collect());
        let elimination = Argument::Elimination { prismatic: [false; 6], cuts: [0; 3] };
        Call { kernel: &GENERAL, arguments: vec![links, Argument::Reference(pose(6)), elimination] }
    }

    fn measures_length(&self, _: &Step) -> bool {
        false
    }

    fn words(&self, _: bool) -> Words {
        let equation = "a polynomial of degree 16";
        Words::new("the general elimination (Raghavan and Roth)", "一般消元法（Raghavan 与 Roth）", equation).solved_by(
            "No equation holds fewer than all six joints. The elimination of Raghavan and Roth (1990) leaves a polynomial of degree 16 in the tangent of half an angle; its real roots give all solutions.",
            "没有方程只含少数关节。按 Raghavan 与 Roth（1990）的消元法得到半角正切的 16 次多项式，其实根给出所有解。",
            &[],
        )
    }
}
