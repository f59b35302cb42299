//! Parameter values, and joint coordinates as functions of the actuators, as they are printed beside the formulas.

use super::grouping::Order;
use super::math::{Math, Sign};
use super::notation::Notation;
use super::typeset::{decimal, number};
use crate::algebra::{Angle, Poly, Rational, Transform};
use crate::chain::{AngleCell, Chain, Coordinate, Handle, Parameter, Role, Value};

/// The same robot with every joint angle that is not a quarter turn away from its variable under a name of its own: c1 is
/// then the cosine of theta1 = q1 + 30 degrees, and no formula is full of square roots. `None` where there is no such joint.
pub(in crate::render) fn named_offsets(chain: &Chain) -> Option<Chain> {
    let odd = |row: usize| {
        let link = chain.links.get(row)?;
        let quarter = link.theta.constant.steps_of_15_degrees().is_some_and(|n| n % 6 == 0);
        (!quarter).then(|| link.theta.constant.clone())
    };
    let mut out: Option<Chain> = None;
    for (k, joint) in chain.joints.iter().enumerate() {
        let turns = matches!(joint.coordinate, Coordinate::Angle(_));
        let Some(offset) = odd(joint.row).filter(|_| turns && joint.shift.is_zero()) else { continue };
        let copy = out.get_or_insert_with(|| chain.clone());
        if let (Some(joint), Some(link)) = (copy.joints.get_mut(k), copy.links.get_mut(joint.row)) {
            joint.shift.half_turns = Some(offset.factor().clone());
            link.theta.constant = Angle::ZERO;
        }
    }
    out
}

/// A parameter's name as typeset.
pub(in crate::render) fn parameter(notation: &Notation, p: &Parameter) -> Math {
    match p.handle {
        Handle::Length(s) => notation.symbol(s),
        Handle::Angle(v) => notation.angle(v),
    }
}

/// Values of the constants in a pose that are no fields: numbers of the table, declared constants.
pub(in crate::render) fn constants(chain: &Chain, notation: &Notation, pose: &Transform) -> Vec<Math> {
    let entries = || pose.r.iter().flatten().chain(&pose.p);
    let occurs = |p: &&Parameter| match p.handle {
        Handle::Length(s) => entries().any(|e| e.has_symbol(s)),
        Handle::Angle(v) => entries().any(|e| e.has_angle(v)),
    };
    let constants = chain.parameters.iter().filter(|p| matches!(p.role, Role::Constant(_)));
    constants.filter(occurs).filter_map(|p| Some(Math::equation(parameter(notation, p), value(notation, p)?))).collect()
}

/// Joint coordinates as functions of the motors, where they are not the same.
pub(in crate::render) fn relations(chain: &Chain, notation: &Notation, order: &Order) -> Vec<(Math, Math)> {
    let mut ring = chain.ring.clone();
    let motors: Vec<Poly> = (1..=chain.dof()).map(|k| Poly::symbol(ring.symbol(&format!("q{k}")))).collect();
    let code = Notation::of_ring(&ring);
    let mut list = Vec::new();
    for (k, (joint, line)) in chain.joints.iter().zip(&chain.drive).enumerate() {
        let direct = line.iter().enumerate().all(|(j, p)| if j == k { p.is_one() } else { p.is_zero() });
        if direct && joint.shift.is_zero() {
            continue;
        }
        let left = match joint.coordinate {
            Coordinate::Angle(v) => notation.angle(v),
            Coordinate::Length(s) => notation.symbol(s),
        };
        let moving: Poly = line.iter().zip(&motors).map(|(p, q)| p * q).sum();
        let mut row = vec![code.typeset(&order.group(&moving))];
        shift(&joint.shift, chain, notation, &mut row);
        list.push((left, Math::Row(row)));
    }
    list
}

fn push_sign(row: &mut Vec<Math>, negative: bool) {
    match (row.is_empty(), negative) {
        (true, true) => row.push(Math::Sign(Sign::Negative)),
        (true, false) => {}
        (false, true) => row.push(Math::Sign(Sign::Minus)),
        (false, false) => row.push(Math::Sign(Sign::Plus)),
    }
}

/// Appends the constant of a joint angle.
fn shift(cell: &AngleCell, chain: &Chain, notation: &Notation, row: &mut Vec<Math>) {
    for (i, k) in &cell.symbols {
        if let Some(p) = chain.parameters.get(*i) {
            push_sign(row, *k < 0);
            if k.unsigned_abs() != 1 {
                row.push(Math::number(k.unsigned_abs()));
            }
            row.push(parameter(notation, p));
        }
    }
    let number = AngleCell { symbols: Vec::new(), ..cell.clone() };
    if !number.is_zero() {
        let (negative, value) = constant_angle(notation, &number);
        push_sign(row, negative);
        row.push(value);
    }
}

/// A length or angle with its sign, as typeset.
pub(in crate::render) fn value(notation: &Notation, p: &Parameter) -> Option<Math> {
    let value = match &p.role {
        Role::Field(v) => v.as_ref()?,
        Role::Constant(v) => v,
    };
    let (negative, m) = match value {
        Value::Length(x) => (x.is_negative(), length(&x.abs())),
        Value::Angle(cell) => constant_angle(notation, cell),
    };
    Some(if negative { Math::Row(vec![Math::Sign(Sign::Negative), m]) } else { m })
}

/// Sign and magnitude of an angle without declared angles: degrees where it is exact, else radians.
fn constant_angle(notation: &Notation, cell: &AngleCell) -> (bool, Math) {
    match &cell.approx {
        None => notation.exact_angle(cell.exact().factor()),
        Some(x) if cell.exact().is_zero() => radians(x),
        Some(_) => {
            let x = cell.radians();
            (x < 0.0, Math::Row(vec![Math::number(x.abs()), Math::Sign(Sign::Thin), Math::word("rad")]))
        }
    }
}

/// Digits, where the number has finitely many.
pub(in crate::render) fn length(x: &Rational) -> Math {
    decimal(x).map_or_else(|| number(x), Math::Number)
}

pub(in crate::render) fn radians(x: &Rational) -> (bool, Math) {
    let digits = decimal(&x.abs()).map_or_else(|| number(&x.abs()), Math::Number);
    (x.is_negative(), Math::Row(vec![digits, Math::Sign(Sign::Thin), Math::word("rad")]))
}
