//! Which actuator drives which row: the numbering of variables, and coupled drives.
//!
//! With N moving rows the variables are q1 to qN. In a table without coupling (each moving cell holds one variable with the
//! coefficient 1) the k-th moving row holds qk; fixed rows do not count. As soon as one cell holds anything else (a sum of variables,
//! a factor, a minus), the table is coupled, and any invertible map will do.

use crate::algebra::Rational;
use crate::chain::{Drive, LengthCell};
use crate::diagnostic::{Error, Errors, Place};

use super::range::Measure;
use super::scope::Scope;

/// A moving row: its number (from 1, as counted in the table), its cell and its drive, where that could be read.
pub(super) struct Moving {
    pub(super) row: usize,
    pub(super) place: Place,
    pub(super) drive: Option<Drive>,
}

/// The only variable of a cell, with the coefficient 1.
pub(super) fn plain(drive: &Drive) -> Option<usize> {
    match drive.terms.as_slice() {
        [(v, k)] if *k == LengthCell::number(Rational::ONE) => Some(*v),
        _ => None,
    }
}

/// What the variable of the row of joint `joint` (from 0) measures. The unit of an actuator behind a declared coefficient, or in a
/// sliding cell behind any, is not known.
pub(super) fn measure(drive: &Drive, joint: usize) -> Measure {
    let numeric = |k: &LengthCell| k.terms.iter().all(|t| t.1.is_empty());
    match drive.terms.iter().find(|t| t.0 == joint) {
        Some((_, k)) if drive.revolute && numeric(k) => Measure::Angle,
        _ if !drive.revolute && plain(drive) == Some(joint) => Measure::Length,
        // One wrong variable is an error; its range is not another one.
        _ => Measure::Either,
    }
}

/// Checks numbering and invertibility. `readable`: all rows could be read.
pub(super) fn check(moving: &[Moving], readable: bool, scope: &Scope, errors: &mut Errors) {
    let n = moving.len();
    let coupled = moving.iter().any(|m| m.drive.as_ref().is_some_and(|d| plain(d).is_none()));
    if !coupled {
        for (k, m) in moving.iter().enumerate() {
            let Some(v) = m.drive.as_ref().and_then(plain).filter(|v| *v != k) else { continue };
            let error = Error::new(m.place, format!("the variable of row {} is `q{}`, not `q{}`", m.row, k + 1, v + 1));
            errors.push(if m.row == k + 1 {
                error.help("variables are numbered in the order of the rows")
            } else {
                error.help(format!(
                    "row {} is moving row number {}: rows without a variable are fixed and do not count",
                    m.row,
                    k + 1
                ))
            });
        }
        return;
    }
    let uses = |v: usize| moving.iter().find(|m| m.drive.as_ref().is_some_and(|d| d.terms.iter().any(|t| t.0 == v)));
    let mut fine = readable;
    for m in moving {
        let terms = m.drive.as_ref().map_or(&[][..], |d| d.terms.as_slice());
        if let Some((v, _)) = terms.iter().find(|(v, _)| *v >= n) {
            let text = format!("there is no variable `q{}`: {n} rows move, so there are `q1` to `q{n}`", v + 1);
            errors.push(Error::new(m.place, text));
            fine = false;
        }
    }
    if !fine {
        return;
    }
    for v in 0..n {
        if uses(v).is_none() {
            let text = format!("`q{}` drives nothing: {n} rows move, so there are `q1` to `q{n}`", v + 1);
            let error = Error::new(moving.get(v).map_or_else(Place::call_site, |m| m.place), text);
            errors.push(error.help(format!(
                "a row that a linkage moves without a motor of its own adds one that stays at 0: `q{0} - q2 - q3`, for example, \
                 with the range `0deg..=0deg`",
                v + 1
            )));
            fine = false;
        }
    }
    if !fine {
        return;
    }
    let Some(first) = moving.iter().find(|m| m.drive.as_ref().is_some_and(|d| plain(d).is_none())) else { return };
    let last = moving.iter().rev().find(|m| m.drive.as_ref().is_some_and(|d| plain(d).is_none())).unwrap_or(first);
    let place = first.place.to(last.place);
    // The determinant is a polynomial in the fields. Not zero at one point: it is not the zero polynomial, so the map can be
    // inverted. Zero at several unrelated points: it is (a polynomial of this degree that is not would hit zero at all of them
    // with a chance below 1e-12).
    let regular = (1..=4u64).any(|seed| !singular(moving, &|i| stand_in(i, seed)));
    if !regular {
        let text = "this coupling is singular: some motion of the motors moves no joint, so it cannot be inverted";
        errors.push(Error::new(place, text));
        return;
    }
    // A field without a nominal value is left at its stand-in: then the map may well be regular.
    let nominal = |i: usize| scope.names.get(i).and_then(|d| d.number()).unwrap_or_else(|| stand_in(i, 1));
    if singular(moving, &nominal) {
        errors.push(Error::new(place, "this coupling is singular at the nominal values of its fields"));
    }
}

/// A number for field `i`: scattered, the same in each run.
fn stand_in(i: usize, seed: u64) -> Rational {
    let mut x = (i as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ seed.wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x ^= x >> 31;
    x = x.wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^= x >> 29;
    Rational::int((x >> 40) as i64 + 1)
}

/// Whether the matrix of the map is singular at these values of the fields, by exact Gaussian elimination.
fn singular(moving: &[Moving], value: &dyn Fn(usize) -> Rational) -> bool {
    let n = moving.len();
    let coefficient = |cell: &LengthCell| {
        cell.terms.iter().fold(Rational::ZERO, |sum, (factor, names)| {
            let product = names.iter().fold(factor.clone(), |p, i| &p * &value(*i));
            &sum + &product
        })
    };
    let mut rows: Vec<Vec<Rational>> = moving
        .iter()
        .map(|m| {
            let mut line = vec![Rational::ZERO; n];
            for (v, k) in m.drive.as_ref().map_or(&[][..], |d| d.terms.as_slice()) {
                if let Some(entry) = line.get_mut(*v) {
                    *entry = coefficient(k);
                }
            }
            line
        })
        .collect();
    for column in 0..n {
        let Some(pivot) = rows.iter().position(|r| !r[column].is_zero()) else { return true };
        let pivot = rows.swap_remove(pivot);
        let Some(inverse) = pivot[column].recip() else { return true };
        for row in rows.iter_mut().filter(|r| !r[column].is_zero()) {
            let factor = &row[column] * &inverse;
            for (x, p) in row.iter_mut().zip(&pivot).skip(column) {
                *x = &*x - &(&factor * p);
            }
        }
    }
    false
}
