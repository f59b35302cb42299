//! A table's inverse without compiling it: the plan in the interpreter, the candidates through the driver of generated code.

use dh_robot::ik::{Kinematics, Pose, Task as Goal};
use dh_robot::inverse::{Attempt, Setting, frame_of_axis, frame_of_plane, in_units, solve};
use dh_robot::{Branch, FreeJoints, Joint, Solutions};
use dh_symbolic::chain::{Chain, ChainSpec, Task};
use dh_symbolic::planner;
use dh_symbolic::program::Inverse;
use dh_tests::engine::spec;
use dh_tests::naive::{Arm, Matrix};

/// An arm with its plan.
pub(super) struct Compiled {
    pub(super) spec: ChainSpec,
    pub(super) arm: Arm,
    pub(super) inverse: Inverse,
    pub(super) slides: Vec<bool>,
    chain: Chain,
    shifts: Vec<f64>,
}

/// What the inverse gives back.
pub(super) struct Found {
    pub(super) q: Vec<Vec<f64>>,
    pub(super) free: Vec<FreeJoints>,
    pub(super) why: String,
}

/// Forward kinematics for the driver: the plain product.
struct Model<'a>(&'a Arm, Option<usize>);

fn pose(m: &Matrix) -> Pose {
    [m[0], m[1], m[2]]
}

impl<const N: usize> Kinematics<N> for Model<'_> {
    fn forward(&self, q: &[f64; N]) -> Pose {
        pose(&self.0.pose(q))
    }

    fn forward_and_jacobian(&self, q: &[f64; N]) -> (Pose, [[f64; N]; 6]) {
        let columns = self.0.jacobian_from_axes(q);
        let entry = |i: usize, j: usize| if self.1 == Some(j) { 0.0 } else { columns[j][i] };
        (pose(&self.0.pose(q)), std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j))))
    }
}

impl Compiled {
    /// Plans a table without fields and without coupled drives.
    pub(super) fn new(table: &str) -> Result<Compiled, planner::Refusal> {
        let spec = spec(table);
        let chain = Chain::new(spec.clone());
        let inverse = Inverse::derive(&chain, planner::search(&chain)?);
        let arm = Arm::new(&spec, &|_| 0.0);
        let shifts = chain.joints.iter().map(|j| j.shift.radians()).collect();
        let slides = spec.rows.iter().filter_map(|r| r.moves.as_ref().map(|m| !m.turns)).collect();
        Ok(Compiled { spec, arm, inverse, slides, chain, shifts })
    }

    /// All solutions for a pose; `q` made it.
    pub(super) fn invert(&self, target: &Matrix, q: &[f64]) -> Found {
        match q.len() {
            2 => self.invert_as::<2>(target, q),
            3 => self.invert_as::<3>(target, q),
            4 => self.invert_as::<4>(target, q),
            5 => self.invert_as::<5>(target, q),
            6 => self.invert_as::<6>(target, q),
            7 => self.invert_as::<7>(target, q),
            n => unreachable!("{n} joints"),
        }
    }

    fn invert_as<const N: usize>(&self, target: &Matrix, q: &[f64]) -> Found {
        match self.inverse.plan.max_solutions {
            1 => found(self.run::<N, 1>(target, q)),
            2 => found(self.run::<N, 2>(target, q)),
            4 => found(self.run::<N, 4>(target, q)),
            8 => found(self.run::<N, 8>(target, q)),
            16 => found(self.run::<N, 16>(target, q)),
            m => unreachable!("a bound of {m}"),
        }
    }

    /// As `render::rust::inverse` writes it.
    fn run<const N: usize, const M: usize>(&self, target: &Matrix, q: &[f64]) -> Solutions<f64, N, M> {
        let joint = |k: usize| if self.slides[k] { Joint::prismatic("q") } else { Joint::revolute("q") };
        let joints: &'static [Joint; N] = Box::leak(Box::new(std::array::from_fn(joint)));
        let plan = &self.inverse.plan;
        let (reach, redundant) = (plan.axes.reach, self.spec.redundant);
        let given: Option<(usize, f64)> = redundant.map(|k| (k, q[k]));
        let setting = Setting { joints, reach, few: plan.few, given };
        let t = pose(target);
        let mut frame = t.map(|r| [r[0], r[1], r[2], r[3] / reach]);
        let (p, z) = (frame.map(|r| r[3]), t.map(|r| r[2]));
        let goal = match self.spec.task {
            Task::Pose => Goal::Pose(in_units(&frame, reach)),
            Task::Position => {
                frame = frame_of_axis(p, [0.0, 0.0, 1.0]);
                Goal::Position(t.map(|r| r[3]))
            }
            Task::Axis => {
                frame = frame_of_axis(p, z);
                Goal::Axis(t.map(|r| r[3]), z)
            }
            Task::Planar => {
                let phi = t[1][0].atan2(t[0][0]);
                let zero = pose(&self.arm.pose(&[0.0; N])).map(|r| [r[0], r[1], r[2]]);
                frame = frame_of_plane([p[0], p[1]], phi, zero);
                Goal::Planar(t[0][3], t[1][3], phi)
            }
        };
        let scaled = |k: usize, x: f64| if self.slides[k] { x / reach } else { x + self.shifts[k] };
        let given: Vec<f64> = given.iter().map(|(k, x)| scaled(*k, *x)).collect();
        let candidates = |frame: &Pose,
                          pick: dh_robot::inverse::Pick,
                          take: &mut dyn FnMut([f64; N], Branch, FreeJoints)| {
            let run = self.inverse.attempt(&self.chain, frame, &given, &|i| (pick.angle(i), pick.length(i)));
            for c in &run.candidates {
                let value = |k: usize| if self.slides[k] { c.x[k] * reach } else { c.x[k] - self.shifts[k] };
                let forms = c.free.iter().map(|f| &plan.knowledge.known[*f].form);
                let free = forms.flat_map(|f| (0..N).filter(|k| f[*k] != 0)).fold(FreeJoints::NONE, FreeJoints::with);
                let steps = c.branch.iter().enumerate();
                let branch = steps.fold(Branch::ANY, |b, (i, root)| b.with_step(i, *root));
                take(std::array::from_fn(value), branch, free);
            }
            let mut attempt = Attempt::new();
            (attempt.degenerate, attempt.lost, attempt.doubt) = (run.degenerate, run.lost, run.doubt);
            attempt
        };
        solve(&Model(&self.arm, redundant), setting, &goal, &frame, candidates)
    }
}

fn found<const N: usize, const M: usize>(solutions: Solutions<f64, N, M>) -> Found {
    Found {
        q: solutions.iter().map(|s| s.q.to_vec()).collect(),
        free: solutions.iter().map(|s| s.free).collect(),
        why: solutions.why().to_string(),
    }
}
