//! From the coordinates of the table to the motors: the drive, inverted.

use super::shift_expression;
use crate::algebra::{Poly, determinant};
use crate::chain::{Chain, Scalar};

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
