//! The arm itself: forward kinematics, Jacobian and inverse of a table that was read while the program runs.

use std::sync::Arc;

use dh_robot::nalgebra::IsometryMatrix3;
use dh_robot::{Arm, Branch, FreeJoints, Joint, SolutionView, Why, WrongLength};
use dh_symbolic::chain::Task;
use dh_symbolic::{Robot, TableError};

use crate::Target;
use crate::model::{InverseModel, Model, Numbers, field};
use crate::solver::{Interpreted, Solve, part_of, solver};

/// An arm whose table was read while the program runs.
///
/// Cloning is cheap; arms can be sent to other threads and used by several at once. Joint values are slices as long as [`joints`](Self::joints).
#[derive(Clone)]
pub struct DynamicArm {
    pub(crate) model: Arc<Model>,
    pub(crate) solver: Option<Arc<dyn Solve>>,
    values: Vec<f64>,
    pub(crate) numbers: Arc<Numbers>,
}

/// A field of the table: a length or an angle that the caller may set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter<'a> {
    /// Its name in the table.
    pub name: &'a str,
    /// Table units, or radians; not a number where it has no value yet.
    pub value: f64,
    /// Whether it is a length.
    pub is_length: bool,
}

impl DynamicArm {
    /// Reads a table: what stands between the braces of `dh_robot!`.
    ///
    /// # Errors
    /// Everything that is wrong with it, drawn.
    pub fn parse(text: &str) -> Result<DynamicArm, TableError> {
        DynamicArm::new(&Robot::parse(text)?)
    }

    /// The arm of a table that has been read. An arm without an inverse in closed form has all the rest: see [`refusal`](Self::refusal).
    ///
    /// # Errors
    /// A program that differs from the product of the link transforms: a defect of the compiler.
    pub fn new(robot: &Robot) -> Result<DynamicArm, TableError> {
        let chain = robot.chain();
        let model = Model::new(chain.clone(), &robot.forward_programs()?, robot.inverse_program());
        let most = model.inverse().map(|i| i.inverse.plan.max_solutions);
        let solver = most.and_then(|most| solver(model.joints, most)).map(Arc::from);
        let values = model.nominal();
        let numbers = Arc::new(model.numbers(&values));
        Ok(DynamicArm { model: Arc::new(model), solver, values, numbers })
    }

    /// Name, kind and range of every joint variable.
    pub fn joints(&self) -> &'static [Joint] {
        self.model.joints
    }

    /// How many joint variables there are.
    pub fn dof(&self) -> usize {
        self.model.joints.len()
    }

    /// What the inverse is asked for: `pose`, `position`, `planar` or `axis`.
    pub fn task(&self) -> &'static str {
        match self.model.task() {
            Task::Pose => "pose",
            Task::Position => "position",
            Task::Planar => "planar",
            Task::Axis => "axis",
        }
    }

    /// The unit of all lengths: `m`.
    pub fn unit(&self) -> &'static str {
        self.model.chain.settings.unit.name
    }

    /// The joints whose values the caller of the inverse gives, in that order.
    pub fn redundant(&self) -> &[usize] {
        &self.model.chain.settings.redundant
    }

    /// The most solutions that a target can have; 0 where there is no inverse.
    pub fn max_solutions(&self) -> usize {
        self.inverse_model().map_or(0, |i| i.inverse.plan.max_solutions)
    }

    /// Why there is no inverse in closed form; `None` where there is one, or where the table asks for none.
    pub fn refusal(&self) -> Option<&TableError> {
        self.model.inverse.as_ref().err()
    }

    /// The fields of the table with their values.
    pub fn parameters(&self) -> impl Iterator<Item = Parameter<'_>> {
        let all = self.model.chain.parameters.iter().zip(&self.values);
        all.filter_map(|(p, value)| Some(Parameter { name: &p.name, value: *value, is_length: field(p)? }))
    }

    /// The same arm with other values of fields: table units and radians.
    ///
    /// # Errors
    /// The first name that is no field.
    pub fn with_parameters<'n>(&self, given: &[(&'n str, f64)]) -> Result<DynamicArm, &'n str> {
        let mut values = self.values.clone();
        for (name, value) in given {
            let parameters = &self.model.chain.parameters;
            let place = parameters.iter().position(|p| p.name == *name && field(p).is_some()).ok_or(*name)?;
            values[place] = *value;
        }
        let numbers = Arc::new(self.model.numbers(&values));
        Ok(DynamicArm { values, numbers, ..self.clone() })
    }

    /// The part of a pose that the arm's task looks at.
    pub fn target(&self, pose: &IsometryMatrix3<f64>) -> Target {
        part_of(self.model.task(), pose)
    }

    /// Hands every solution for a target to `found`, each once; returns [`Why::Solved`], or why there is none. `given` are the values of the
    /// [`redundant`](Self::redundant) joints.
    pub fn solutions(&self, target: &Target, given: &[f64], found: &mut dyn FnMut(SolutionView<'_, f64>)) -> Why {
        match self.solving() {
            Some((arm, solver)) => solver.inverse(arm, target, given, found),
            None => Why::NoSolution,
        }
    }

    /// The solution that continues from the joint values `q`, in whose place it is written: the one of least travel, and on a self-motion (at
    /// a singular pose) the point of it nearest to `q`. Returns its branch and the joints that are free there.
    ///
    /// # Errors
    /// The reason why no joint values reach the target; `q` stays then.
    pub fn inverse_near(&self, target: &Target, given: &[f64], q: &mut [f64]) -> Result<(Branch, FreeJoints), Why> {
        match self.solving() {
            Some((arm, solver)) if q.len() == self.dof() => solver.near(arm, target, given, q),
            _ => Err(Why::NoSolution),
        }
    }

    /// Whether the inverse can be called: it can not where the table asks for none, where there is no closed form, or where the arm has more
    /// joints than there are solvers for (10).
    pub fn has_inverse(&self) -> bool {
        self.solving().is_some()
    }

    pub(crate) fn inverse_model(&self) -> Option<&InverseModel> {
        self.model.inverse()
    }

    pub(crate) fn solving(&self) -> Option<(Interpreted<'_>, &dyn Solve)> {
        let arm = Interpreted { model: &self.model, inverse: self.inverse_model()?, numbers: &self.numbers };
        Some((arm, self.solver.as_deref()?))
    }

    fn check(&self, given: usize) -> Result<(), WrongLength> {
        if given == self.dof() { Ok(()) } else { Err(WrongLength { joints: self.dof(), given }) }
    }
}

/// A pose from 12 numbers, columns first.
fn isometry(entry: impl Fn(usize) -> f64) -> IsometryMatrix3<f64> {
    let rows = std::array::from_fn(|i| std::array::from_fn(|j| entry(3 * j + i)));
    dh_robot::pose::from_entries(rows, std::array::from_fn(|i| entry(9 + i)))
}

impl Arm for DynamicArm {
    fn joints(&self) -> &'static [Joint] {
        self.model.joints
    }

    fn max_solutions(&self) -> usize {
        DynamicArm::max_solutions(self)
    }

    fn forward(&self, q: &[f64]) -> Result<IsometryMatrix3<f64>, WrongLength> {
        self.check(q.len())?;
        let (program, numbers) = (&self.model.pose, &self.numbers.pose);
        let mut x = program.space::<1>(numbers);
        let q: Vec<[f64; 1]> = q.iter().map(|q| [*q]).collect();
        program.run(numbers, &self.numbers.coordinates.at(&q), &mut x);
        Ok(isometry(|k| program.output(k, &x)[0]))
    }

    fn frames(&self, q: &[f64], frames: &mut [IsometryMatrix3<f64>]) -> Result<(), WrongLength> {
        self.check(q.len())?;
        self.check(frames.len())?;
        let (program, numbers) = (&self.model.frames, &self.numbers.frames);
        let mut x = program.space::<1>(numbers);
        let q: Vec<[f64; 1]> = q.iter().map(|q| [*q]).collect();
        program.run(numbers, &self.numbers.coordinates.at(&q), &mut x);
        for (to, joint) in frames.iter_mut().zip(&self.model.chain.joints) {
            *to = isometry(|k| program.output(12 * joint.row + k, &x)[0]);
        }
        Ok(())
    }

    fn forward_and_jacobian(&self, q: &[f64], columns: &mut [[f64; 6]]) -> Result<IsometryMatrix3<f64>, WrongLength> {
        self.check(q.len())?;
        self.check(columns.len())?;
        let (program, numbers) = (&self.model.jacobian, &self.numbers.jacobian);
        let mut x = program.space::<1>(numbers);
        let q: Vec<[f64; 1]> = q.iter().map(|q| [*q]).collect();
        program.run(numbers, &self.numbers.coordinates.at(&q), &mut x);
        for (k, column) in columns.iter_mut().enumerate() {
            *column = std::array::from_fn(|i| program.output(12 + 6 * k + i, &x)[0]);
        }
        Ok(isometry(|k| program.output(k, &x)[0]))
    }

    fn inverse(
        &self,
        target: &IsometryMatrix3<f64>,
        redundant: &[f64],
        found: &mut dyn FnMut(SolutionView<'_, f64>),
    ) -> Why {
        let given: Vec<f64> = (0..self.redundant().len()).map(|i| redundant.get(i).copied().unwrap_or(0.0)).collect();
        self.solutions(&self.target(target), &given, found)
    }

    fn toward(&self, target: &IsometryMatrix3<f64>, redundant: &[f64], q: &mut [f64]) -> Result<Why, WrongLength> {
        self.check(q.len())?;
        let joints = self.joints();
        let mut best: Option<(f64, Vec<f64>)> = None;
        let (mut outside, finite) = (0, q.iter().all(|x| x.is_finite()));
        let why = self.inverse(target, redundant, &mut |solution| {
            if !joints.iter().zip(solution.q).all(|(joint, x)| joint.contains(*x)) {
                outside += 1;
                return;
            }
            let shifted = joints.iter().zip(solution.q).zip(&*q).map(|((j, x), from)| j.nearest_to(*from, *x));
            let shifted: Vec<f64> = shifted.collect();
            let travel = shifted.iter().zip(&*q).map(|(a, b)| (a - b) * (a - b)).sum::<f64>();
            if finite && best.as_ref().is_none_or(|(least, _)| travel < *least) {
                best = Some((travel, shifted));
            }
        });
        match best {
            Some((_, nearest)) => q.copy_from_slice(&nearest),
            None if why.is_solved() && finite => return Ok(Why::OutOfRange { solutions: outside }),
            None => {}
        }
        Ok(why)
    }
}
