//! From the coordinates of the table to the motors: the drive, inverted, and what whole turns of rows are to the motors.

use super::shift_expression;
use super::steps::combination;
use crate::algebra::{Poly, determinant};
use crate::chain::{AngleCell, Chain, Coordinate, Role, Scalar};
use crate::planner::Form;

/// Expression of the joint coordinate that the motor `given` moves.
pub(in crate::render) fn chosen(chain: &Chain) -> String {
    let Some((joint, factor)) = chain.chosen() else { return "given".into() };
    let moved = match factor.is_one() {
        true => "given".into(),
        false => format!("({}) * given", super::body::field_polynomial(chain, &factor)),
    };
    let shift = chain.joints.get(joint).and_then(|j| shift_expression(chain, &j.shift, Scalar::F64));
    shift.map_or(moved.clone(), |s| format!("{moved} + ({s})"))
}

/// Expression of each joint variable from the coordinates x.
pub(in crate::render) fn motors(chain: &Chain, x: &[String]) -> Vec<String> {
    let shifted: Vec<String> = chain
        .joints
        .iter()
        .zip(x)
        .map(|(j, x)| match shift_expression(chain, &j.shift, Scalar::F64) {
            Some(s) => format!("{x} - ({s})"),
            None => x.clone(),
        })
        .collect();
    if chain.is_direct() {
        return shifted;
    }
    // Cramer's rule, exact: q = adj(D) x / det(D).
    let (adjugate, det) = adjugate(&chain.drive);
    let value = |p: &Poly| super::body::field_polynomial(chain, p);
    let det = value(&det);
    adjugate
        .iter()
        .map(|row| {
            let parts: Vec<String> = row
                .iter()
                .zip(&shifted)
                .filter(|(k, _)| !k.is_zero())
                .map(|(k, x)| format!("({}) * ({x})", value(k)))
                .collect();
            format!("({}) / ({det})", if parts.is_empty() { "0.0".into() } else { parts.join(" + ") })
        })
        .collect()
}

/// How motors move rows, where whole turns of rows are not whole turns of motors.
pub(super) fn drive(chain: &Chain) -> String {
    if !chain.is_geared() {
        return String::new();
    }
    let n = chain.dof();
    let (adjugate, det) = adjugate(&chain.drive);
    let value = |p: &Poly| super::body::field_polynomial(chain, p);
    let matrix = |m: &[Vec<Poly>], over: &str| {
        let entry = |p: &Poly| if p.is_zero() { "0.0".into() } else { format!("({}){over}", value(p)) };
        let rows: Vec<String> =
            m.iter().map(|row| format!("[{}]", row.iter().map(entry).collect::<Vec<_>>().join(", "))).collect();
        format!("[{}]", rows.join(", "))
    };
    let turns: Vec<String> =
        chain.joints.iter().map(|j| matches!(j.coordinate, Coordinate::Angle(_)).to_string()).collect();
    format!(
        "fn drive(&self) -> ::core::option::Option<::dh_robot::ik::Drive<{n}>> {{\nlet det = {};\n\
         ::core::option::Option::Some(::dh_robot::ik::Drive {{ rows: {}, motors: {}, turns: [{}] }})\n}}\n",
        value(&det),
        matrix(&chain.drive, ""),
        matrix(&adjugate, " / det"),
        turns.join(", ")
    )
}

/// A motor as a sum of angles (or a length) that a plan finds.
pub(super) struct Motor {
    /// The factor of each.
    pub(super) form: Form,
    /// What is taken off: an expression, with a factor.
    shifts: Vec<(i8, String)>,
    /// The greatest absolute value in half turns, if each angle is at most half a turn; `None` where a field says.
    pub(super) half_turns: Option<u8>,
}

impl Motor {
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

/// The motors from the rows' combinations of what is found, where all factors of the drive are whole numbers both ways and no slide is
/// coupled: then whole turns of rows are whole turns of motors.
pub(super) fn whole_motors(chain: &Chain, rows: &[Form]) -> Option<Vec<Motor>> {
    let whole = |p: &Poly| p.as_rational().and_then(|x| x.to_i64()).and_then(|x| i8::try_from(x).ok());
    let turns = |i: usize| chain.joints.get(i).is_some_and(|j| matches!(j.coordinate, Coordinate::Angle(_)));
    for (i, row) in chain.drive.iter().enumerate() {
        for (j, p) in row.iter().enumerate() {
            let alone = if i == j { p.is_one() } else { p.is_zero() };
            if whole(p).is_none() || !(alone || turns(i) && turns(j)) {
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
    let motor = |factors: &Vec<i8>| {
        let mut motor = Motor { form: vec![0; rows.first()?.len()], shifts: Vec::new(), half_turns: None };
        let mut half_turns = 0.0;
        for (factor, (row, joint)) in factors.iter().zip(rows.iter().zip(&chain.joints)).filter(|(k, _)| **k != 0) {
            for (sum, k) in motor.form.iter_mut().zip(row) {
                *sum = sum.checked_add(k.checked_mul(*factor)?)?;
            }
            let shift = shift_expression(chain, &joint.shift, Scalar::F64);
            motor.shifts.extend(shift.map(|shift| (*factor, shift)));
            let field = joint.shift.symbols.iter().any(|(i, _)| is_field(chain, *i));
            half_turns += if field { f64::INFINITY } else { f64::from(*factor).abs() * nominal(chain, &joint.shift) };
        }
        // An angle alone is in (-pi, pi] as it is found; its negative need not be.
        let one = motor.form.iter().all(|k| *k >= 0) && motor.form.iter().sum::<i8>() == 1;
        let sum = motor.form.iter().map(|k| f64::from(k.unsigned_abs())).sum::<f64>();
        let most = if one && half_turns == 0.0 { 1.0 } else { (sum + half_turns).ceil().max(2.0) };
        motor.half_turns = (most <= 5.0).then_some(most as u8);
        Some(motor)
    };
    inverse.iter().map(motor).collect()
}

/// Is a parameter a field of the robot?
fn is_field(chain: &Chain, parameter: usize) -> bool {
    chain.parameters.get(parameter).is_some_and(|p| matches!(p.role, Role::Field(_)))
}

/// The absolute value of an offset, without fields, in half turns.
fn nominal(chain: &Chain, shift: &AngleCell) -> f64 {
    let constants =
        shift.symbols.iter().filter_map(|(i, k)| Some(f64::from(*k) * chain.nominal(chain.parameters.get(*i)?.handle)));
    (shift.radians() + constants.sum::<f64>()).abs() / core::f64::consts::PI
}

/// Adjugate and determinant of a small matrix of formulas.
fn adjugate(m: &[Vec<Poly>]) -> (Vec<Vec<Poly>>, Poly) {
    let n = m.len();
    let minor = |skip_row: usize, skip_column: usize| -> Poly {
        let rows: Vec<Vec<Poly>> = (0..n)
            .filter(|i| *i != skip_row)
            .map(|i| (0..n).filter(|j| *j != skip_column).map(|j| m[i][j].clone()).collect())
            .collect();
        determinant(&rows, usize::MAX).unwrap_or_default()
    };
    let signed = |p: Poly, odd: bool| if odd { -&p } else { p };
    let adjugate = (0..n).map(|i| (0..n).map(|j| signed(minor(j, i), (i + j) % 2 == 1)).collect()).collect();
    (adjugate, determinant(m, usize::MAX).unwrap_or_default())
}
