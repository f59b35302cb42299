//! The fast path of an inverse: all branches of the plan side by side, for one pose or for several at once.
//!
//! The same equations, margins and confirmation as `all_branches` of a generated arm (see `dh_robot::runtime::batched`), as a flat list of
//! instructions: a value has a row of lanes (poses) for each branch that differs there.

mod build;
mod operation;

use dh_kernels::Pose;
use dh_robot::runtime::batched as kernels;
use dh_robot::{Branch, Joint};
use dh_symbolic::algebra::{Poly, adjugate};
use dh_symbolic::chain::{Chain, Task};
use dh_symbolic::program::{Inverse, Mirror, Value, What};

use build::Builder;
use operation::Operation;

use crate::actuators::{Actuators, is_whole};
use crate::plan::{FlatPlan, combination};
use crate::solver::Interpreted;
use crate::tape::{Operand, Registers};
use crate::values::Values;

/// A joint value as a sum of what is found, with whole factors, less constants.
struct Actuator {
    form: Vec<i8>,
    shifts: Vec<(i8, usize)>,
    is_revolute: bool,
}

/// The batched form of an inverse as flat operations.
pub(crate) struct FastPath {
    registers: Registers,
    target: [Operand; 12],
    given: Vec<[Option<Operand>; 2]>,
    is_angle: Vec<bool>,
    operations: Vec<Operation>,
    /// Values of what is known.
    found: Vec<Operand>,
    actuators: Vec<Actuator>,
    margin: Operand,
    valid: Operand,
    miss: Operand,
    /// Branches that are computed: mirrored halves count once.
    width: usize,
    mirror: Option<Mirror>,
    steps_given: usize,
    branches: Vec<Branch>,
    length_scale: f64,
}

impl FastPath {
    /// The fast path of a plan, where there is one.
    pub(crate) fn new(chain: &Chain, inverse: &Inverse, plan: &FlatPlan) -> Option<FastPath> {
        let fits = chain.settings.task == Task::Pose
            && (chain.settings.redundant.is_empty() || chain.settings.redundant.len() == 1 && chain.is_direct());
        let batched = inverse.batched(chain.settings.task).filter(|b| fits && b.free.is_empty() && is_whole(chain))?;
        let actuators = actuators(chain, inverse)?;
        let outputs: Vec<Value> = batched
            .solves
            .iter()
            .flat_map(|s| s.needs.iter().copied())
            .chain(batched.confirmation.iter().map(|r| r.value))
            .collect();
        let mut registers = Registers::new(chain, &inverse.graph, &outputs);
        let target = std::array::from_fn(|k| match registers.node_of(inverse.target[k]) {
            Some(node) => registers.place(node, 1),
            None => registers.rows(1),
        });
        let known = &inverse.plan.knowledge.known;
        let given_count = inverse.plan.given;
        let (operations, judged) = (Vec::new(), [const { Vec::new() }; 3]);
        let mut b = Builder { inverse, batched: &batched, registers, operations, target, judged, found: Vec::new() };
        let mut given = Vec::new();
        for (k, known) in known.iter().enumerate() {
            let width = *batched.widths.get(k + 1)?;
            let places = known.symbols.map(|s| Some(b.registers.node_of(s)?).map(|n| b.registers.place(n, width)));
            if k < given_count {
                given.push(places);
            }
            let found = b.registers.rows(width);
            b.found.push(found);
        }
        for depth in 0..=given_count {
            b.values(depth);
        }
        for item in &batched.items {
            match item.what {
                What::Step(i) => b.step(i)?,
                What::Values(depth) => b.values(depth),
                What::Finish => {}
            }
        }
        let width = *batched.widths.last()?;
        let [margin, valid, miss] = b.judgement(width);
        let branches = (0..batched.branches).map(|branch| {
            let (mut before, mut roots) = (1, Vec::new());
            for step in &inverse.plan.steps {
                roots.push(if step.roots > 1 { branch / before % step.roots } else { 0 });
                before *= step.roots;
            }
            plan.branch_of(&roots)
        });
        Some(FastPath {
            target,
            given,
            is_angle: known.iter().map(|k| k.is_angle).collect(),
            found: b.found,
            operations: b.operations,
            registers: b.registers,
            actuators,
            margin,
            valid,
            miss,
            width,
            mirror: batched.mirror.clone(),
            steps_given: given_count,
            branches: branches.collect(),
            length_scale: inverse.plan.axes.length_scale,
        })
    }

    /// What the parameters fill the first registers with.
    pub(crate) fn numbers(&self, values: &Values<'_>) -> Vec<f64> {
        self.registers.prefix(&values.scaled(1.0 / self.length_scale))
    }

    /// Registers to run it in.
    pub(crate) fn space<const L: usize>(&self, numbers: &[f64]) -> Vec<[f64; L]> {
        let mut x = vec![[0.0; L]; self.registers.count as usize];
        for (to, from) in x.iter_mut().zip(numbers) {
            *to = [*from; L];
        }
        x
    }

    /// Runs the plan for poses side by side (lengths over the length scale), with the values of the joints that the caller gives, one list of
    /// lanes per joint.
    pub(crate) fn run<const L: usize>(
        &self,
        actuators: &Actuators,
        poses: &[Pose; L],
        given: &[[f64; L]],
        x: &mut [[f64; L]],
    ) {
        for (k, place) in self.target.iter().enumerate() {
            let (i, j) = if k < 9 { (k / 3, k % 3) } else { (k - 9, 3) };
            x[place.at as usize] = std::array::from_fn(|l| poses[l][i][j]);
        }
        for (k, (places, values)) in self.given.iter().zip(given).enumerate() {
            let coordinates = values.map(|value| actuators.chosen(k, value));
            let pairs = coordinates.map(|coordinate| {
                let (s, c) = dh_robot::math::sin_cos(coordinate);
                if self.is_angle[k] { [c, s] } else { [coordinate / self.length_scale; 2] }
            });
            for (part, place) in places.iter().enumerate() {
                if let Some(place) = place {
                    x[place.at as usize] = pairs.map(|pair| pair[part]);
                }
            }
            x[self.found[k].at as usize] = coordinates;
        }
        for operation in &self.operations {
            operation.run(x);
        }
    }

    /// Whether the fast path answers the pose of a lane: there is a branch that counts, and each such branch is clear of degenerate ones and
    /// confirmed.
    pub(crate) fn is_sure<const L: usize>(&self, x: &[[f64; L]], lane: usize) -> bool {
        let (mut doubt, mut any) = (0.0, 0.0);
        for branch in 0..self.width {
            let [margin, valid, miss] = [self.margin, self.valid, self.miss].map(|o| x[o.row(branch)][lane]);
            let fine = (margin > 0.0) & (miss <= kernels::CONFIRMED);
            doubt += if fine { 0.0 } else { valid };
            any += valid;
        }
        doubt == 0.0 && any > 0.0
    }

    /// Calls `found` with the joint values of every branch that is real at the pose of a lane; the caller gave `given`.
    pub(crate) fn branches_of<const L: usize, const N: usize>(
        &self,
        x: &[[f64; L]],
        lane: usize,
        arm: Interpreted<'_>,
        given: &[f64],
        mut found: impl FnMut([f64; N], Branch),
    ) {
        let (joints, redundant) = (arm.model.joints, &arm.model.chain.settings.redundant);
        for (branch, name) in self.branches.iter().enumerate() {
            if x[self.valid.row(branch)][lane] > 0.0 {
                let mut q = [0.0; N];
                self.joint_values(x, (lane, branch), &arm.numbers.actuators.shifts, joints, &mut q);
                for (k, value) in redundant.iter().zip(given) {
                    q[*k] = joints[*k].normalize(*value);
                }
                found(q, *name);
            }
        }
    }

    /// The joint values of a branch.
    fn joint_values<const L: usize>(
        &self,
        x: &[[f64; L]],
        (lane, branch): (usize, usize),
        shifts: &[f64],
        joints: &[Joint],
        q: &mut [f64],
    ) {
        let second = self.mirror.as_ref().filter(|_| branch >= self.branches.len() / 2);
        let value = |known: usize| {
            let first = x[self.found[known].row(branch)][lane];
            let step = known.checked_sub(self.steps_given);
            match second.zip(step).and_then(|(mirror, step)| mirror.flips.get(step)) {
                None | Some([false, false]) => first,
                Some([true, _]) if !self.is_angle[known] => -first,
                Some([true, true]) => kernels::opposite(first),
                Some([false, true]) => kernels::negative(first),
                Some([true, false]) => kernels::supplement(first),
            }
        };
        for ((actuator, joint), to) in self.actuators.iter().zip(joints).zip(q) {
            let mut sum = combination(&actuator.form, value);
            for (k, i) in &actuator.shifts {
                sum -= f64::from(*k) * shifts[*i];
            }
            *to = if actuator.is_revolute { joint.normalize(sum) } else { sum };
        }
    }
}

/// The joint values as sums of what a plan finds, where whole turns of joints are whole turns of actuators.
fn actuators(chain: &Chain, inverse: &Inverse) -> Option<Vec<Actuator>> {
    let joints = &inverse.body.result()?.joints;
    let whole = |p: &Poly| p.as_rational().and_then(|x| x.to_i64()).and_then(|x| i8::try_from(x).ok());
    let factors: Vec<Vec<i8>> = if chain.is_direct() {
        (0..chain.dof()).map(|i| (0..chain.dof()).map(|j| i8::from(i == j)).collect()).collect()
    } else {
        let (adjugate, det) = adjugate(&chain.drive);
        let sign = whole(&det)?;
        let row = |row: &Vec<Poly>| row.iter().map(|p| whole(p)?.checked_mul(sign)).collect::<Option<Vec<i8>>>();
        adjugate.iter().map(row).collect::<Option<_>>()?
    };
    let one = |(i, factors): (usize, &Vec<i8>)| {
        let mut form = vec![0_i8; joints.first()?.len()];
        for (factor, row) in factors.iter().zip(joints) {
            for (sum, k) in form.iter_mut().zip(row) {
                *sum = sum.checked_add(k.checked_mul(*factor)?)?;
            }
        }
        let shifts = factors.iter().enumerate().filter(|(i, k)| **k != 0 && !chain.joints[*i].shift.is_zero());
        let shifts = shifts.map(|(i, k)| (*k, i)).collect();
        Some(Actuator { form, shifts, is_revolute: inverse.plan.axes.is_revolute(i) })
    };
    factors.iter().enumerate().map(one).collect()
}
