//! The bridge to the solvers of `dh-robot`: an interpreted arm with the number of joints and of solutions in its type.
//!
//! What a generated arm does in its own functions (`candidates`, `all_branches`, forward kinematics) the programs do here; the search at singular
//! poses, the verification and the choice of the nearest solution are the same functions that generated arms call.

use std::cell::RefCell;

use dh_kernels::{Drive, Kinematics, Pose};
use dh_robot::runtime::{Path, Sample, Setting, nearest, solve_bounded, solve_near};
use dh_robot::{Branch, FreeJoints, Joint, Solution, SolutionView, Solutions, Why, Work};
use dh_symbolic::chain::Task;

use crate::Target;
use crate::model::{InverseModel, Model, Numbers};

/// Poses that the fast path takes side by side.
const LANES: usize = 8;

/// An inverse whose number of joints is known to its type alone.
pub(crate) trait Solve: Send + Sync {
    /// Every solution, each once, and why there is none.
    fn inverse(
        &self,
        arm: Interpreted<'_>,
        target: &Target,
        given: &[f64],
        found: &mut dyn FnMut(SolutionView<'_, f64>),
    ) -> Why;

    /// The solution that continues from `q`, in whose place it is written.
    fn near(
        &self,
        arm: Interpreted<'_>,
        target: &Target,
        given: &[f64],
        q: &mut [f64],
    ) -> Result<(Branch, FreeJoints), Why>;

    /// The solutions of some targets side by side, as [`Solve::inverse`] hands them over: `found` is also told the number of the target, and
    /// `refused` why a target has none.
    fn batch(
        &self,
        arm: Interpreted<'_>,
        targets: &[(Target, &[f64])],
        found: &mut dyn FnMut(usize, SolutionView<'_, f64>),
        refused: &mut dyn FnMut(usize, Why),
    );
}

/// An arm with its numbers.
#[derive(Clone, Copy)]
pub(crate) struct Interpreted<'a> {
    pub(crate) model: &'a Model,
    pub(crate) inverse: &'a InverseModel,
    pub(crate) numbers: &'a Numbers,
}

/// The solver of arms with `N` joints and at most `M` solutions.
struct Solver<const N: usize, const M: usize> {
    joints: &'static [Joint; N],
}

/// The solver for some joints and that many solutions; `None` for more joints than there is a solver for.
pub(crate) fn solver(joints: &'static [Joint], most: usize) -> Option<Box<dyn Solve>> {
    macro_rules! sizes {
        ($($n:literal: $($m:literal)*;)*) => {
            match joints.len() {
                $($n => {
                    let joints: &'static [Joint; $n] = joints.try_into().ok()?;
                    $(if most <= $m { return Some(Box::new(Solver::<$n, $m> { joints })); })*
                    None
                })*
                _ => None,
            }
        };
    }
    sizes! {
        1: 1 2 16;
        2: 2 4 16;
        3: 2 4 8 16;
        4: 2 4 8 16;
        5: 2 4 8 16;
        6: 4 8 16;
        7: 8 16;
        8: 8 16;
        9: 16;
        10: 16;
    }
}

/// Forward kinematics and Jacobian for the solvers, with registers that are used again and again.
struct View<'a> {
    arm: Interpreted<'a>,
    pose: RefCell<Vec<[f64; 1]>>,
    jacobian: RefCell<Vec<[f64; 1]>>,
}

impl<'a> View<'a> {
    fn new(arm: Interpreted<'a>) -> View<'a> {
        let pose = RefCell::new(arm.model.pose.space(&arm.numbers.pose));
        View { arm, pose, jacobian: RefCell::new(Vec::new()) }
    }
}

impl<const N: usize> Kinematics<N> for View<'_> {
    fn forward(&self, q: &[f64; N]) -> Pose {
        let (program, numbers) = (&self.arm.model.pose, self.arm.numbers);
        let mut x = self.pose.borrow_mut();
        program.run(&numbers.pose, &numbers.coordinates.at(&q.map(|q| [q])), &mut x);
        std::array::from_fn(|i| std::array::from_fn(|j| program.output(3 * j + i, &x)[0]))
    }

    fn forward_and_jacobian(&self, q: &[f64; N]) -> (Pose, [[f64; N]; 6]) {
        let (model, numbers) = (self.arm.model, self.arm.numbers);
        let program = &model.jacobian;
        let mut x = self.jacobian.borrow_mut();
        if x.is_empty() {
            *x = program.space(&numbers.jacobian);
        }
        program.run(&numbers.jacobian, &numbers.coordinates.at(&q.map(|q| [q])), &mut x);
        let pose = std::array::from_fn(|i| std::array::from_fn(|j| program.output(3 * j + i, &x)[0]));
        let entry = |i: usize, j: usize| {
            // A joint that the caller chooses does not move.
            if model.chain.settings.redundant.contains(&j) { 0.0 } else { program.output(12 + 6 * j + i, &x)[0] }
        };
        (pose, std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j))))
    }

    fn unit(&self) -> &'static str {
        if self.arm.inverse.inverse.plan.rank_deficient { self.arm.model.chain.settings.unit.name } else { "" }
    }

    fn drive(&self) -> Option<Drive<N>> {
        self.arm.numbers.actuators.drive()
    }
}

impl<const N: usize, const M: usize> Solver<N, M> {
    /// The target, and what the solvers know of the arm.
    fn prepare(
        &self,
        arm: Interpreted<'_>,
        target: &Target,
        given: &[f64],
    ) -> Result<(Pose, dh_kernels::TaskTarget, Setting<f64, N>), Why> {
        if !given.iter().all(|x| x.is_finite()) {
            return Err(Why::NotFinite);
        }
        let plan = &arm.inverse.inverse.plan;
        let length_scale = plan.axes.length_scale;
        let (frame, task) = target.frame(length_scale, || {
            let zero: Pose = View::new(arm).forward(&[0.0; N]);
            zero.map(|[x, y, z, _]| [x, y, z])
        })?;
        let redundant = &arm.model.chain.settings.redundant;
        let fixed = |k: usize| redundant.iter().position(|r| *r == k).and_then(|i| given.get(i)).copied();
        let setting = Setting {
            joints: self.joints,
            length_scale,
            rank_deficient: plan.rank_deficient,
            given: std::array::from_fn(fixed),
        };
        Ok((frame, task, setting))
    }

    /// The list of the fast path, where that decides.
    fn fast(&self, arm: Interpreted<'_>, frame: &Pose, given: &[f64]) -> Option<Solutions<f64, N, M>> {
        let fast = arm.inverse.fast.as_ref()?;
        let mut x = fast.space::<1>(&arm.numbers.fast);
        let values: Vec<[f64; 1]> = given.iter().map(|x| [*x]).collect();
        fast.run(&arm.numbers.actuators, &[*frame], &values, &mut x);
        if !fast.is_sure(&x, 0) {
            return None;
        }
        let mut list = Solutions::new(self.joints);
        fast.branches_of(&x, 0, arm, given, |q: [f64; N], branch| _ = list.push(Solution::new(q, branch)));
        Some(list)
    }
}

/// The bounds of the work of one call.
fn work(arm: Interpreted<'_>) -> Work {
    match arm.inverse.eliminates {
        true => Work::ELIMINATION,
        false if arm.inverse.inverse.plan.has_crossings => Work::CROSSING_SHEETS,
        false => Work::CLOSED_FORM,
    }
}

impl<const N: usize, const M: usize> Solve for Solver<N, M> {
    fn inverse(
        &self,
        arm: Interpreted<'_>,
        target: &Target,
        given: &[f64],
        found: &mut dyn FnMut(SolutionView<'_, f64>),
    ) -> Why {
        let (frame, task, setting) = match self.prepare(arm, target, given) {
            Ok(prepared) => prepared,
            Err(why) => return why,
        };
        let list = self.fast(arm, &frame, given).unwrap_or_else(|| {
            let plan = &arm.inverse.plan;
            let registers = RefCell::new(plan.space(&arm.numbers.plan));
            let run = |frame: &Pose, sample: &Sample, found: &mut dyn FnMut([f64; N], Branch, Path)| {
                plan.candidates(&arm.numbers.actuators, given, &mut registers.borrow_mut(), frame, sample, found)
            };
            let (list, _): (Solutions<f64, N, M>, Work) =
                solve_bounded(&View::new(arm), setting, &task, &frame, work(arm), run);
            list
        });
        for solution in list.iter().take(arm.inverse.inverse.plan.max_solutions) {
            found(SolutionView { q: &solution.q, branch: solution.branch, free: solution.free });
        }
        list.why()
    }

    fn near(
        &self,
        arm: Interpreted<'_>,
        target: &Target,
        given: &[f64],
        q: &mut [f64],
    ) -> Result<(Branch, FreeJoints), Why> {
        let (frame, task, setting) = self.prepare(arm, target, given)?;
        let Ok(q): Result<&mut [f64; N], _> = q.try_into() else { return Err(Why::NoSolution) };
        let solution = match self.fast(arm, &frame, given) {
            Some(list) => nearest(&list, q, setting.length_scale)?,
            None => {
                let plan = &arm.inverse.plan;
                let coordinates = arm.numbers.coordinates.at(&q.map(|q| [q]));
                let unknowns = plan.unknowns(&arm.inverse.inverse, &coordinates);
                let registers = RefCell::new(plan.space(&arm.numbers.plan));
                let run = |frame: &Pose, sample: &Sample, found: &mut dyn FnMut([f64; N], Branch, Path)| {
                    plan.candidates(&arm.numbers.actuators, given, &mut registers.borrow_mut(), frame, sample, found)
                };
                solve_near::<f64, N, M>(&View::new(arm), setting, &task, &frame, work(arm), q, unknowns, run)?
            }
        };
        *q = solution.q;
        Ok((solution.branch, solution.free))
    }

    fn batch(
        &self,
        arm: Interpreted<'_>,
        targets: &[(Target, &[f64])],
        found: &mut dyn FnMut(usize, SolutionView<'_, f64>),
        refused: &mut dyn FnMut(usize, Why),
    ) {
        let mut alone = |i: usize, found: &mut dyn FnMut(usize, SolutionView<'_, f64>)| {
            let (target, given) = &targets[i];
            let why = self.inverse(arm, target, given, &mut |solution| found(i, solution));
            if !why.is_solved() {
                refused(i, why);
            }
        };
        let Some(fast) = arm.inverse.fast.as_ref() else {
            return (0..targets.len()).for_each(|i| alone(i, found));
        };
        let mut x = fast.space::<LANES>(&arm.numbers.fast);
        for start in (0..targets.len()).step_by(LANES) {
            let lanes = LANES.min(targets.len() - start);
            let mut frames = [dh_kernels::pose::IDENTITY; LANES];
            let mut given = vec![[0.0; LANES]; arm.model.chain.settings.redundant.len()];
            let mut sure = [false; LANES];
            for lane in 0..lanes {
                let (target, values) = &targets[start + lane];
                let Ok((frame, ..)) = self.prepare(arm, target, values) else { continue };
                (frames[lane], sure[lane]) = (frame, true);
                for (to, value) in given.iter_mut().zip(*values) {
                    to[lane] = *value;
                }
            }
            fast.run(&arm.numbers.actuators, &frames, &given, &mut x);
            for lane in 0..lanes {
                let i = start + lane;
                if sure[lane] && fast.is_sure(&x, lane) {
                    fast.branches_of(&x, lane, arm, targets[i].1, |q: [f64; N], branch| {
                        found(i, SolutionView { q: &q, branch, free: FreeJoints::NONE });
                    });
                } else {
                    alone(i, found);
                }
            }
        }
    }
}

/// Which part of a pose a task looks at.
pub(crate) fn part_of(task: Task, pose: &dh_robot::nalgebra::IsometryMatrix3<f64>) -> Target {
    let (p, r) = (&pose.translation.vector, pose.rotation.matrix());
    let position = [p[0], p[1], p[2]];
    match task {
        Task::Pose => Target::Pose(*pose),
        Task::Position => Target::Position(position),
        Task::Planar => Target::Planar(p[0], p[1], dh_robot::math::atan2(r[(1, 0)], r[(0, 0)])),
        Task::Axis => Target::Axis(position, [r[(0, 2)], r[(1, 2)], r[(2, 2)]]),
    }
}
