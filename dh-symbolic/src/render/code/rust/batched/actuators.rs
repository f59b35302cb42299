//! Actuator positions as sums of the angles that the fast path finds, where whole turns of joints are whole turns of actuators.

use crate::algebra::{Poly, adjugate};
use crate::chain::{AngleCell, Chain, Coordinate, Role, Scalar};
use crate::planner::JointCombination;
use crate::render::code::shift_expression;
use crate::render::code::steps::combination;

/// An actuator as a sum of angles (or a length) that a plan finds.
pub(super) struct Actuator {
    /// The factor of each.
    pub(super) form: JointCombination,
    /// What is subtracted: an expression, with a factor.
    shifts: Vec<(i8, String)>,
    /// The greatest absolute value in half turns, if each angle is at most half a turn; `None` where a field says.
    pub(super) half_turns: Option<u8>,
}

impl Actuator {
    /// The value, from the values of what is found.
    pub(super) fn value(&self, found: &[String]) -> String {
        let mut out = combination(&self.form, found);
        for (k, shift) in &self.shifts {
            match k {
                1 => out.push_str(&format!(" - ({shift})")),
                -1 => out.push_str(&format!(" + ({shift})")),
                _ => out.push_str(&format!(" - {:?} * ({shift})", f64::from(*k))),
            }
        }
        out
    }
}

/// The actuators from the rows' combinations of what is found, where all factors of the drive are whole numbers both ways and no slide is
/// coupled: then whole turns of rows are whole turns of actuators.
pub(super) fn whole_actuators(chain: &Chain, rows: &[JointCombination]) -> Option<Vec<Actuator>> {
    let whole = |p: &Poly| p.as_rational().and_then(|x| x.to_i64()).and_then(|x| i8::try_from(x).ok());
    let revolute = |i: usize| chain.joints.get(i).is_some_and(|j| matches!(j.coordinate, Coordinate::Angle(_)));
    for (i, row) in chain.drive.iter().enumerate() {
        for (j, p) in row.iter().enumerate() {
            let alone = if i == j { p.is_one() } else { p.is_zero() };
            if whole(p).is_none() || !(alone || revolute(i) && revolute(j)) {
                return None;
            }
        }
    }
    let inverse: Vec<Vec<i8>> = if chain.is_direct() {
        (0..chain.dof()).map(|i| (0..chain.dof()).map(|j| i8::from(i == j)).collect()).collect()
    } else {
        let (adjugate, det) = adjugate(&chain.drive);
        let sign = whole(&det).filter(|x| x.abs() == 1)?;
        let factors = |row: &Vec<Poly>| row.iter().map(|p| whole(p)?.checked_mul(sign)).collect();
        adjugate.iter().map(factors).collect::<Option<_>>()?
    };
    let actuator = |factors: &Vec<i8>| {
        let mut actuator = Actuator { form: vec![0; rows.first()?.len()], shifts: Vec::new(), half_turns: None };
        let mut half_turns = 0.0;
        for (factor, (row, joint)) in factors.iter().zip(rows.iter().zip(&chain.joints)).filter(|(k, _)| **k != 0) {
            for (sum, k) in actuator.form.iter_mut().zip(row) {
                *sum = sum.checked_add(k.checked_mul(*factor)?)?;
            }
            let shift = shift_expression(chain, &joint.shift, Scalar::F64);
            actuator.shifts.extend(shift.map(|shift| (*factor, shift.text())));
            let field = joint.shift.symbols.iter().any(|(i, _)| is_field(chain, *i));
            half_turns += if field { f64::INFINITY } else { f64::from(*factor).abs() * nominal(chain, &joint.shift) };
        }
        // An angle alone is in (-pi, pi] as it is found; its negative need not be.
        let one = actuator.form.iter().all(|k| *k >= 0) && actuator.form.iter().sum::<i8>() == 1;
        let sum = actuator.form.iter().map(|k| f64::from(k.unsigned_abs())).sum::<f64>();
        let most = if one && half_turns == 0.0 { 1.0 } else { (sum + half_turns).ceil().max(2.0) };
        actuator.half_turns = (most <= 5.0).then_some(most as u8);
        Some(actuator)
    };
    inverse.iter().map(actuator).collect()
}

/// Whether a parameter is a field of the robot.
fn is_field(chain: &Chain, parameter: usize) -> bool {
    chain.parameters.get(parameter).is_some_and(|p| matches!(p.role, Role::Field(_)))
}

/// The absolute value of an offset, without fields, in half turns.
fn nominal(chain: &Chain, shift: &AngleCell) -> f64 {
    let constants =
        shift.symbols.iter().filter_map(|(i, k)| Some(f64::from(*k) * chain.nominal(chain.parameters.get(*i)?.handle)));
    (shift.radians() + constants.sum::<f64>()).abs() / core::f64::consts::PI
}
