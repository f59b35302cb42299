//! How far two results are apart, and how far they may be.

use crate::engine::Engine;
use crate::naive::{Column, Matrix};

/// Errors of forward kinematics, relative to the arm's reach: rounding of a dozen products, and of the sums of angles.
pub const ROUNDING: f64 = 1e-14;

/// The greatest difference of two poses: of rotation entries, and of positions divided by the reach.
#[must_use]
pub fn poses(a: &Matrix, b: &Matrix, reach: f64) -> f64 {
    let entry = |(i, j): (usize, usize)| (a[i][j] - b[i][j]).abs() / if j == 3 && i < 3 { reach } else { 1.0 };
    greatest((0..4).flat_map(|i| (0..4).map(move |j| (i, j))).map(entry))
}

/// The greatest difference of two Jacobians: of linear entries divided by the reach (if it is longer than 1), and of angular ones.
#[must_use]
pub fn jacobians(a: &[Column], b: &[Column], reach: f64) -> f64 {
    if a.len() != b.len() {
        return f64::INFINITY;
    }
    let column = |(a, b): (&Column, &Column)| {
        greatest((0..6).map(|i| (a[i] - b[i]).abs() / if i < 3 { reach.max(1.0) } else { 1.0 }))
    };
    greatest(a.iter().zip(b).map(column))
}

/// The greatest; infinite if one is not a number.
pub fn greatest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, |m, x| if x.is_nan() { f64::INFINITY } else { f64::max(m, x) })
}

/// Checks all functions of an engine against another at some joint values.
///
/// # Panics
/// Where they differ by more than `tolerance`.
pub fn engines(got: &Engine, want: &Engine, robot: &str, q: &[f64], reach: f64, tolerance: f64) {
    let check = |what: &str, error: f64| {
        assert!(error <= tolerance, "{robot}: {what} of {} is {error:.1e} off {} at {q:?}", got.name, want.name);
    };
    assert_eq!((got.dof, q.len()), (want.dof, want.dof), "{robot}: joints");
    check("pose", poses(&(got.pose)(q), &(want.pose)(q), reach));
    let (a, b) = ((got.frames)(q), (want.frames)(q));
    assert_eq!(a.len(), b.len(), "{robot}: frames");
    check("frames", greatest(a.iter().zip(&b).map(|(a, b)| poses(a, b, reach))));
    check("Jacobian", jacobians(&(got.jacobian)(q), &(want.jacobian)(q), reach));
    let (a, b) = ((got.both)(q), (want.both)(q));
    check("pose beside the Jacobian", poses(&a.0, &b.0, reach));
    check("Jacobian beside the pose", jacobians(&a.1, &b.1, reach));
}
