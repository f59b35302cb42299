//! Parameter values, and joint coordinates as functions of the actuators, as they are printed beside the formulas.

use super::grouping::Order;
use super::math::{Math, Sign};
use super::notation::Notation;
use super::typeset::{decimal, number};
use crate::algebra::{Angle, LinearAngle, Poly, Rational, Transform};
use crate::chain::{AngleCell, Chain, Convention, Coordinate, Elementary, Handle, Nominal, Parameter, Role};

/// The same robot with the names that stand in documents. `None` where they are the same.
///
/// * A joint angle that is not a quarter turn away from its variable, or that a drive moves, has a name of its own: c1 is then the cosine
///   of theta1 = q1 + 30 degrees, the table's angle, and no formula is full of square roots.
/// * A number of the table that stands there with a minus sign is the cell with its sign: a2 = -0.425, where the code has -a2.
pub(in crate::render) fn named_offsets(chain: &Chain) -> Option<Chain> {
    with_names(chain, false)
}

/// The same with a name for every joint angle that is not its variable: all angles are those of the table.
#[cfg(feature = "documents")]
pub(in crate::render) fn named_table_angles(chain: &Chain) -> Option<Chain> {
    with_names(chain, true)
}

fn with_names(chain: &Chain, all: bool) -> Option<Chain> {
    let odd = |k: usize, joint: &crate::chain::Joint| {
        let link = chain.links.get(joint.row)?;
        let quarter = link.theta.constant.steps_of_15_degrees().is_some_and(|n| n % 6 == 0);
        let line = chain.drive.get(k)?;
        let direct = line.iter().enumerate().all(|(j, p)| if j == k { p.is_one() } else { p.is_zero() });
        let named = !quarter || (all || !direct) && !link.theta.constant.is_zero();
        named.then(|| link.theta.constant.clone())
    };
    let mut out: Option<Chain> = None;
    for (k, joint) in chain.joints.iter().enumerate() {
        let revolute = matches!(joint.coordinate, Coordinate::Angle(_));
        let Some(offset) = odd(k, joint).filter(|_| revolute && joint.shift.is_zero()) else { continue };
        let copy = out.get_or_insert_with(|| chain.clone());
        if let (Some(joint), Some(link)) = (copy.joints.get_mut(k), copy.links.get_mut(joint.row)) {
            joint.shift.half_turns = Some(offset.factor().clone());
            link.theta.constant = Angle::ZERO;
        }
    }
    for i in 0..chain.parameters.len() {
        if out.as_ref().unwrap_or(chain).own_cell_is_negative(i) {
            out.get_or_insert_with(|| chain.clone()).turn_sign(i);
        }
    }
    out
}

impl Chain {
    /// Does the cell that gave a number its name hold it with a minus sign?
    fn own_cell_is_negative(&self, parameter: usize) -> bool {
        let Some(p) = self.parameters.get(parameter).filter(|p| !p.declared) else { return false };
        let stem = p.name.trim_end_matches(|c: char| c.is_ascii_digit());
        let ahead = usize::from(self.convention == Convention::Modified && matches!(stem, "a" | "alpha"));
        let row =
            p.name.get(stem.len()..).and_then(|n| n.parse::<usize>().ok()).and_then(|n| (n + ahead).checked_sub(1));
        let Some(link) = row.and_then(|r| self.links.get(r)) else { return false };
        match (p.handle, stem) {
            (Handle::Length(s), "a") => link.a == -&Poly::symbol(s),
            (Handle::Length(s), "d") => link.d == -&Poly::symbol(s),
            (Handle::Angle(v), "alpha") => link.alpha.terms == [(v, -1)] && link.alpha.constant.is_zero(),
            (Handle::Angle(v), "theta") => link.theta.terms == [(v, -1)] && link.theta.constant.is_zero(),
            _ => false,
        }
    }

    /// A number of the table with the other sign, in its value and wherever it stands.
    fn turn_sign(&mut self, parameter: usize) {
        let Some(p) = self.parameters.get_mut(parameter) else { return };
        let minus = |x: &mut Rational| *x = &*x * &Rational::int(-1);
        match &mut p.role {
            Role::Constant(Nominal::Length(x)) => minus(x),
            Role::Constant(Nominal::Angle(cell)) => cell.half_turns.iter_mut().chain(&mut cell.approx).for_each(minus),
            Role::Field(_) => return,
        }
        let handle = p.handle;
        let length = |p: &mut Poly| {
            if let Handle::Length(s) = handle
                && p.has_symbol(s)
            {
                *p = p.substitute_symbols(|t| (t == s).then(|| -&Poly::symbol(s)));
            }
        };
        let angle = |a: &mut LinearAngle| {
            a.terms.iter_mut().filter(|(v, _)| Handle::Angle(*v) == handle).for_each(|(_, k)| *k = -*k);
        };
        for link in &mut self.links {
            [&mut link.a, &mut link.d].into_iter().for_each(length);
            [&mut link.alpha, &mut link.theta].into_iter().for_each(angle);
        }
        for e in self.base.iter_mut().chain(&mut self.tool) {
            match e {
                Elementary::Translate(_, p) => length(p),
                Elementary::Rotate(_, a) => angle(a),
            }
        }
        self.drive.iter_mut().flatten().for_each(length);
        let shifts = self.joints.iter_mut().flat_map(|j| &mut j.shift.symbols);
        shifts.filter(|(i, _)| *i == parameter).for_each(|(_, k)| *k = -*k);
    }
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

/// Joint coordinates as functions of the actuators, where they are not the same.
pub(in crate::render) fn relations(chain: &Chain, notation: &Notation, order: &Order) -> Vec<(Math, Math)> {
    let mut ring = chain.ring.clone();
    let actuators: Vec<Poly> = (1..=chain.dof()).map(|k| Poly::symbol(ring.symbol(&format!("q{k}")))).collect();
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
        let moving: Poly = line.iter().zip(&actuators).map(|(p, q)| p * q).sum();
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
        Nominal::Length(x) => (x.is_negative(), length(&x.abs())),
        Nominal::Angle(cell) => constant_angle(notation, cell),
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
