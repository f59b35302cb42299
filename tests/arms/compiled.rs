//! A table's inverse without compiling it: the plan in the interpreter, the candidates through the driver of generated code.

use dh_robot::runtime::{Attempt, Path, Setting, frame_of_axis, frame_of_plane, in_units, solve};
use dh_robot::runtime::{Drive, Kinematics, Pose, TaskTarget as Goal};
use dh_robot::{Branch, FreeJoints, Joint, Solutions};
use dh_symbolic::algebra::Rational;
use dh_symbolic::chain::{AngleCell, Chain, ChainSpec, Handle, Nominal, Role, Task};
use dh_symbolic::planner;
use dh_symbolic::program::Inverse;
use dh_tests::engine::spec;
use dh_tests::naive::{Arm, Matrix};

/// An arm with its plan.
pub(super) struct Compiled {
    pub(super) spec: ChainSpec,
    pub(super) arm: Arm,
    pub(super) inverse: Inverse,
    /// Motors of which a whole turn is not nothing.
    pub(super) slides: Vec<bool>,
    joints: &'static [Joint],
    chain: Chain,
    /// The same with the values of fields.
    valued: Chain,
    pub(super) shifts: Vec<f64>,
    /// Motors to joint coordinates.
    drive: Vec<Vec<f64>>,
    /// The tool's rotation with all joints at zero, for planar tasks.
    zero: Matrix,
}

/// What the inverse gives back.
pub(super) struct Found {
    pub(super) q: Vec<Vec<f64>>,
    pub(super) free: Vec<FreeJoints>,
    pub(super) why: String,
}

/// Forward kinematics for the driver: the plain product.
struct Model<'a>(&'a Compiled);

fn pose(m: &Matrix) -> Pose {
    [m[0], m[1], m[2]]
}

impl<const N: usize> Kinematics<N> for Model<'_> {
    fn forward(&self, q: &[f64; N]) -> Pose {
        pose(&self.0.arm.pose(q))
    }

    fn forward_and_jacobian(&self, q: &[f64; N]) -> (Pose, [[f64; N]; 6]) {
        let columns = self.0.arm.jacobian_from_axes(q);
        let entry = |i: usize, j: usize| if self.0.spec.settings.redundant.contains(&j) { 0.0 } else { columns[j][i] };
        (pose(&self.0.arm.pose(q)), std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j))))
    }

    fn drive(&self) -> Option<Drive<N>> {
        let unit = |i: usize| -> Vec<f64> { (0..N).map(|k| f64::from(u8::from(k == i))).collect() };
        let columns: Vec<Vec<f64>> = (0..N).map(|i| self.0.inverse_drive(unit(i))).collect();
        self.0.chain.is_geared().then(|| Drive {
            rows: std::array::from_fn(|i| std::array::from_fn(|k| self.0.drive[i][k])),
            actuators: std::array::from_fn(|k| std::array::from_fn(|i| columns[i][k])),
            revolute: std::array::from_fn(|i| self.0.inverse.plan.axes.is_revolute(i)),
        })
    }
}

impl Compiled {
    /// Plans a table; fields take their nominal values.
    pub(super) fn new(table: &str) -> Result<Compiled, planner::Refusal> {
        let spec = spec(table);
        let chain = Chain::new(spec.clone());
        let inverse = Inverse::derive(&chain, planner::search(&chain)?);
        let arm = Arm::new(&spec, &|_| f64::NAN);
        let slides: Vec<bool> = (0..chain.dof()).map(|k| !chain.is_periodic(k)).collect();
        let joint = |s: &bool| if *s { Joint::prismatic("q") } else { Joint::revolute("q") };
        let joints = Box::leak(slides.iter().map(joint).collect::<Vec<_>>().into_boxed_slice());
        let (valued, shifts, drive, zero) = (chain.clone(), Vec::new(), Vec::new(), [[0.0; 4]; 4]);
        let mut compiled = Compiled { spec, arm, inverse, slides, joints, chain, valued, shifts, drive, zero };
        let nominal: Vec<(String, f64)> =
            compiled.chain.parameters.iter().map(|p| (p.name.clone(), compiled.chain.nominal(p.handle))).collect();
        compiled.set(&|name| nominal.iter().find(|n| n.0 == name).map_or(f64::NAN, |n| n.1));
        Ok(compiled)
    }

    /// Gives the fields values (with 50 binary places); the plan stays.
    pub(super) fn set(&mut self, field: &dyn Fn(&str) -> f64) {
        let exact = |name: &str| {
            Rational::new((field(name) * 2.0_f64.powi(50)).round() as i64, 1 << 50).unwrap_or(Rational::ZERO)
        };
        let mut spec = self.spec.clone();
        for p in &mut spec.parameters {
            if matches!(p.role, Role::Field(_)) {
                let x = exact(&p.name);
                p.role = Role::Constant(match p.quantity {
                    dh_symbolic::chain::Quantity::Length => Nominal::Length(x),
                    dh_symbolic::chain::Quantity::Angle => {
                        Nominal::Angle(AngleCell { approx: Some(x), ..AngleCell::default() })
                    }
                });
            }
        }
        self.arm = Arm::new(&spec, &|_| f64::NAN);
        self.valued = self.chain.clone();
        for (p, given) in self.valued.parameters.iter_mut().zip(&spec.parameters) {
            p.role = given.role.clone();
        }
        let valued = &self.valued;
        let lengths = dh_symbolic::algebra::Point {
            symbol: &|s| valued.nominal(Handle::Length(s)),
            angle: &|v| valued.nominal(Handle::Angle(v)),
        };
        self.drive = valued.drive.iter().map(|row| row.iter().map(|k| k.evaluate(&lengths)).collect()).collect();
        let named = |s: &AngleCell| -> f64 {
            s.symbols.iter().map(|(p, k)| f64::from(*k) * valued.nominal(valued.parameters[*p].handle)).sum()
        };
        self.shifts = valued.joints.iter().map(|j| j.shift.radians() + named(&j.shift)).collect();
        self.zero = self.arm.pose(&vec![0.0; self.spec.rows.len()]);
    }

    /// Motor values of joint coordinates.
    pub(super) fn motors(&self, x: &[f64]) -> Vec<f64> {
        self.inverse_drive(x.iter().zip(&self.shifts).map(|(x, shift)| x - shift).collect())
    }

    /// Solves the coupling by elimination.
    fn inverse_drive(&self, x: Vec<f64>) -> Vec<f64> {
        let n = x.len();
        let mut m: Vec<Vec<f64>> = (0..n).map(|i| self.drive[i].iter().copied().chain([x[i]]).collect()).collect();
        for k in 0..n {
            let best = (k..n).max_by(|a, b| m[*a][k].abs().total_cmp(&m[*b][k].abs())).unwrap_or(k);
            m.swap(k, best);
            for i in 0..n {
                let f = m[i][k] / m[k][k];
                if i != k && f != 0.0 {
                    for j in k..=n {
                        m[i][j] -= f * m[k][j];
                    }
                }
            }
        }
        (0..n).map(|k| m[k][n] / m[k][k]).collect()
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
        let joints: &'static [Joint; N] = self.joints.try_into().expect("as many joints as the arm has");
        let plan = &self.inverse.plan;
        let (reach, redundant) = (plan.axes.length_scale, &self.spec.settings.redundant);
        let given: [Option<f64>; N] = std::array::from_fn(|k| redundant.contains(&k).then(|| q[k]));
        let setting = Setting { joints, length_scale: reach, rank_deficient: plan.rank_deficient, given };
        let t = pose(target);
        let mut frame = t.map(|r| [r[0], r[1], r[2], r[3] / reach]);
        let (p, z) = (frame.map(|r| r[3]), t.map(|r| r[2]));
        let goal = match self.spec.settings.task {
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
                let zero = pose(&self.zero).map(|r| [r[0], r[1], r[2]]);
                frame = frame_of_plane([p[0], p[1]], phi, zero);
                Goal::Planar(t[0][3], t[1][3], phi)
            }
        };
        let scaled = |k: usize, x: f64| if self.slides[k] { x / reach } else { x + self.shifts[k] };
        let given: Vec<f64> = redundant.iter().map(|k| scaled(*k, q[*k])).collect();
        let candidates = |frame: &Pose,
                          sample: &dh_robot::runtime::Sample,
                          take: &mut dyn FnMut([f64; N], Branch, Path)| {
            let run = self.inverse.attempt(&self.valued, frame, &given, &|i| (sample.angle(i), sample.length(i)));
            for c in &run.candidates {
                let axes = &plan.axes;
                let x: Vec<f64> = (0..N).map(|k| if axes.is_revolute(k) { c.x[k] } else { c.x[k] * reach }).collect();
                let q = self.motors(&x);
                let forms = c.free.iter().map(|f| &plan.knowledge.known[*f].form);
                let free = forms.flat_map(|f| (0..N).filter(|k| f[*k] != 0)).fold(FreeJoints::NONE, FreeJoints::with);
                let steps = c.branch.iter().enumerate();
                let branch = steps.fold(Branch::ANY, |b, (i, root)| b.with_step(i, *root));
                // Which step was free does not matter to the thorough search.
                let path = if c.free.is_empty() { Path::START } else { Path::START.choose(0, free) };
                take(std::array::from_fn(|k| q[k]), branch, path);
            }
            let mut attempt = Attempt::new();
            attempt.status = run.status;
            attempt
        };
        solve(&Model(self), setting, &goal, &frame, candidates)
    }
}

fn found<const N: usize, const M: usize>(solutions: Solutions<f64, N, M>) -> Found {
    Found {
        q: solutions.iter().map(|s| s.q.to_vec()).collect(),
        free: solutions.iter().map(|s| s.free).collect(),
        why: solutions.why().to_string(),
    }
}
