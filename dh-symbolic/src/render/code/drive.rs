//! Coupled drives: expressions for actuator positions in terms of the table's joint coordinates, for the fallback path.

use super::shift_expression;
use crate::algebra::{Poly, adjugate};
use crate::chain::{Chain, Coordinate, Scalar};

/// Expression of the joint coordinate that an actuator moves whose position is the expression `given`: the one numbered `index` among
/// those that the caller chooses.
pub(in crate::render) fn chosen(chain: &Chain, index: usize, given: &str) -> String {
    let Some((joint, factor)) = chain.chosen().into_iter().nth(index) else { return given.into() };
    let moved = match factor.is_one() {
        true => given.into(),
        false => format!("({}) * {given}", super::body::field_polynomial(chain, &factor)),
    };
    let shift = chain.joints.get(joint).and_then(|j| shift_expression(chain, &j.shift, Scalar::F64));
    shift.map_or(moved.clone(), |s| format!("{moved} + ({})", s.text()))
}

/// Expression of each joint variable from the coordinates x.
pub(in crate::render) fn actuators(chain: &Chain, x: &[String]) -> Vec<String> {
    let shifted: Vec<String> = chain
        .joints
        .iter()
        .zip(x)
        .map(|(j, x)| match shift_expression(chain, &j.shift, Scalar::F64) {
            Some(s) => format!("{x} - ({})", s.text()),
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

/// Expression of each coordinate of the table from the actuators' values `q`, in parentheses where it is a sum.
pub(in crate::render) fn coordinates(chain: &Chain) -> Vec<String> {
    let shifted = |moved: String, i: usize| {
        let shift = chain.joints.get(i).and_then(|j| shift_expression(chain, &j.shift, Scalar::F64));
        shift.map_or(moved.clone(), |s| format!("({moved} + ({}))", s.text()))
    };
    let row = |row: &Vec<Poly>| {
        let value = |(k, p): (usize, &Poly)| match p.is_one() {
            true => format!("q[{k}]"),
            false => format!("({}) * q[{k}]", super::body::field_polynomial(chain, p)),
        };
        let parts: Vec<String> = row.iter().enumerate().filter(|(_, p)| !p.is_zero()).map(value).collect();
        if parts.len() == 1 { parts.concat() } else { format!("({})", parts.join(" + ")) }
    };
    chain.drive.iter().enumerate().map(|(i, r)| shifted(row(r), i)).collect()
}

/// How actuators move rows, as expressions.
pub(in crate::render) struct Matrices {
    /// The determinant, which the second matrix calls `det`.
    pub(in crate::render) det: String,
    /// From actuators to rows.
    pub(in crate::render) rows: String,
    /// From rows to actuators.
    pub(in crate::render) actuators: String,
    /// Which rows turn.
    pub(in crate::render) revolute: String,
}

/// How actuators move rows, where drives are coupled.
pub(in crate::render) fn matrices(chain: &Chain) -> Option<Matrices> {
    if chain.is_direct() {
        return None;
    }
    let (adjugate, det) = adjugate(&chain.drive);
    let value = |p: &Poly| super::body::field_polynomial(chain, p);
    let matrix = |m: &[Vec<Poly>], over: &str| {
        let entry = |p: &Poly| if p.is_zero() { "0.0".into() } else { format!("({}){over}", value(p)) };
        let rows: Vec<String> =
            m.iter().map(|row| format!("[{}]", row.iter().map(entry).collect::<Vec<_>>().join(", "))).collect();
        format!("[{}]", rows.join(", "))
    };
    let revolute: Vec<String> =
        chain.joints.iter().map(|j| matches!(j.coordinate, Coordinate::Angle(_)).to_string()).collect();
    Some(Matrices {
        det: value(&det),
        rows: matrix(&chain.drive, ""),
        actuators: matrix(&adjugate, " / det"),
        revolute: format!("[{}]", revolute.join(", ")),
    })
}

/// The function that says so, where whole turns of rows are not whole turns of actuators.
pub(super) fn drive(chain: &Chain) -> String {
    if !chain.is_geared() {
        return String::new();
    }
    let Some(Matrices { det, rows, actuators, revolute }) = matrices(chain) else { return String::new() };
    let n = chain.dof();
    format!(
        "fn drive(&self) -> ::core::option::Option<::dh_robot::runtime::Drive<{n}>> {{\nlet det = {det};\n\
         ::core::option::Option::Some(::dh_robot::runtime::Drive {{ rows: {rows}, actuators: {actuators}, revolute: {revolute} }})\n}}\n"
    )
}
